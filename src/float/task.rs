//! Computations that a number type runs in its own way: with the fused operation, or at another precision.

use super::Float;
use super::pair::Pair;

/// A computation to be compiled for the processor's fused operation ([`Float::fused`]).
///
/// This is a trait because a closure cannot be forced inline: `run`, and everything that it calls often, must
/// be `#[inline(always)]`.
pub trait Task {
    /// The result.
    type Output;
    /// Runs the computation.
    fn run(self) -> Self::Output;
}

/// A task that the number type `F` hands to a narrower or wider one ([`Float::narrowed`],
/// [`Float::guarded`]).
pub trait AtPrecision<F> {
    /// The result.
    type Output;
    /// Runs the task at the type `G`, given the conversions there and back, each of which rounds once.
    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output;
}

/// Compiles a block for the processor's fused operation, and runs it ([`Float::fused`]):
/// `fused!(<F>(omega: F) -> Border<F> { … })`, over the values of these names.
macro_rules! fused {
    (<$($life:lifetime,)? $float:ident>($($name:ident: $type:ty),+) -> $output:ty $code:block) => {{
        struct Block<$($life,)? $float>($($type),+);
        impl<$($life,)? $float: $crate::float::Float> $crate::float::Task for Block<$($life,)? $float> {
            type Output = $output;

            #[inline(always)]
            fn run(self) -> $output {
                let Self($($name),+) = self;
                $code
            }
        }
        <$float as $crate::float::Float>::fused(Block($($name),+))
    }};
}

/// Runs a block at another precision, [`Float::narrowed`] or [`Float::guarded`]:
/// `at_precision!(guarded, <F>(omega: F) -> F, |there, back: G| { … })`, where `there` converts to the type G, and
/// `back` from it.
macro_rules! at_precision {
    ($how:ident, <$($life:lifetime,)? $float:ident>($($name:ident: $type:ty),+) -> $output:ty,
     |$there:ident, $back:ident: $other:ident| $code:block) => {{
        struct Block<$($life,)? $float>($($type),+);
        impl<$($life,)? $float: $crate::float::Float> $crate::float::AtPrecision<$float>
            for Block<$($life,)? $float>
        {
            type Output = $output;

            fn run<$other: $crate::float::Float>(
                self,
                $there: impl Fn($float) -> $other,
                $back: impl Fn($other) -> $float,
            ) -> $output {
                let Self($($name),+) = self;
                $code
            }
        }
        <$float as $crate::float::Float>::$how(Block($($name),+))
    }};
}

pub(crate) use {at_precision, fused};

/// [`Float::sin_cos_acute`] with guard digits.
pub(super) fn sin_cos_of_pair<F: Float>(angle: Pair<F>) -> (Pair<F>, Pair<F>) {
    at_precision!(guarded, <F>(angle: Pair<F>) -> (Pair<F>, Pair<F>), |there, back: G| {
        let (sine, cosine) = (there(angle.hi) + there(angle.lo)).sin_cos();
        (Pair::rounded(sine, &there, &back), Pair::rounded(cosine, &there, &back))
    })
}
