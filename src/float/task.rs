//! Computations that a number type runs in its own way: with the fused operation, or at another precision.

use super::{Float, pair::Pair};

/// A computation to be compiled for the processor's fused operation ([`Float::fused`]).
///
/// This is a trait because a closure cannot be forced inline: `run`, and everything that it calls often, must
/// be `#[inline(always)]`.
#[doc(hidden)]
pub trait Task {
    /// The result.
    type Output;
    /// Runs the computation.
    fn run(self) -> Self::Output;
}

/// A task that the number type `F` hands to a narrower or wider one ([`Float::narrowed`],
/// [`Float::guarded`]).
#[doc(hidden)]
pub trait AtPrecision<F> {
    /// The result.
    type Output;
    /// Runs the task at the type `G`, given the conversions there and back, each of which rounds once.
    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output;
}

/// [`Float::sin_cos_acute`] with guard digits.
pub(super) struct SinCosOfPair<F>(pub(super) Pair<F>);

impl<F: Float> AtPrecision<F> for SinCosOfPair<F> {
    type Output = (Pair<F>, Pair<F>);

    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output {
        let (sine, cosine) = (there(self.0.hi) + there(self.0.lo)).sin_cos();
        let pair = |x: G| {
            let hi = back(x);
            Pair::new(hi, back(x - there(hi)))
        };
        (pair(sine), pair(cosine))
    }
}
