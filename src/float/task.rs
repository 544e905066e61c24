//! Work that a number type runs in its own way: with the fused operation, or at another precision.

use super::{Float, pair::Pair};

/// Work to be compiled for the processor's fused operation ([`Float::fused`]).
///
/// A trait, because a closure cannot be told to be inlined: `run` has to be `#[inline(always)]`, down to what
/// it calls often.
#[doc(hidden)]
pub trait Task {
    /// What it comes to.
    type Output;
    /// The work.
    fn run(self) -> Self::Output;
}

/// A task that the number type `F` hands to a narrower or wider one ([`Float::narrowed`],
/// [`Float::guarded`]).
#[doc(hidden)]
pub trait AtPrecision<F> {
    /// What it comes to.
    type Output;
    /// The task at the type `G`, with the ways there and back, each of which rounds once.
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
