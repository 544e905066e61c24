//! The number types over which every formula is written.
//!
//! There are three layers. [`Field`] is enough for most *formulae*: the field operations, square roots,
//! magnitudes, small integers and ratios. [`Real`] adds π and the circular functions. [`Float`] adds the
//! needs of a *decision*: order, precision, range, and conversion to and from `f64`. A formula asks for the
//! least layer that it can. A value that cannot be compared (a symbol) or that has no circular functions (a
//! compensated pair) can therefore still run through it.
//!
//! [`pair::Pair`] is the *wide* arithmetic of every type: [`Float::wide`] converts exactly, and
//! [`Pair::value`](pair::Pair::value) rounds once on the way back. The steps that decide the number of
//! correct digits in an answer run in it, through the same functions.
//!
//! All number types are `Copy`, so that generic code reads like the page it came from. Constants are integers
//! and ratios of integers ([`Field::int`], [`Field::ratio`]), never decimal literals, so no formula carries
//! the rounding of a type narrower than its own.
//!
//! # The same bits everywhere
//!
//! At `f64` an operation gives the same bits on every processor and under every compiler flag. The four
//! operations, the square root and the fused multiply-add are rounded correctly by IEEE 754, and the circular
//! functions are those of the pinned crate `libm`. A fused operation occurs where the source says
//! [`Real::mul_add`], and nowhere else.

#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of balls; exponents of radii, which are bounded"
    )
)]
pub(crate) mod ball;
pub(crate) mod circular;
#[cfg_attr(
    not(test),
    allow(clippy::arithmetic_side_effects, reason = "small integers whose sums and products are known")
)]
mod conformance;
#[cfg(feature = "dual")]
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of duals over f64"))]
pub(crate) mod dual;
mod exponential;
mod field;
mod foreign;
mod fused;
#[cfg(test)]
mod libm_bits;
#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of multiple-precision numbers; counts of limbs and of digits, which a format's u16 bounds"
    )
)]
pub(crate) mod mp;
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of pairs"))]
#[doc(hidden)]
pub mod pair;
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "digits of 24 bits in integers of 64"))]
mod pi_digits;
mod primitive;
mod sign;
mod task;

use circular::TO_HALF_PI;
use core::fmt::{Display, LowerExp};
use pair::Pair;

pub use conformance::{Broken, conformance};
#[cfg(feature = "dual")]
pub use dual::Dual;
pub use field::{Field, Real};
pub use foreign::Foreign;
#[cfg(feature = "mp")]
pub(crate) use mp::words;
#[cfg(feature = "mp")]
pub use mp::{
    Mp, ParseError, PrecisionError, ThreadPrecision, WIDTHS, Widest, WithPrecision, with_bits, with_precision,
};
pub(crate) use sign::Signed;
#[doc(hidden)]
pub use task::{AtPrecision, Task};
pub(crate) use task::{at_precision, fused};

/// The operations that decisions need: order, precision, range.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number of this library",
    label = "write 50.0 in place of 50",
    note = "numbers are f32, f64, float::Mp and float::Dual, and your own types that implement Field, Real and Float"
)]
pub trait Float: Real + PartialOrd + Display + LowerExp {
    /// Bits of the significand: 24 for `f32`, 53 for `f64`.
    const PRECISION: u32;
    /// Bits of the significand of results now: [`Float::PRECISION`], or fewer inside
    #[cfg_attr(feature = "mp", doc = "[`with_precision`].")]
    #[cfg_attr(not(feature = "mp"), doc = "`with_precision`.")]
    #[inline]
    #[must_use]
    fn precision() -> u32 {
        Self::PRECISION
    }
    /// Largest exponent `e` for which frequency ratios in `[2⁻ᵉ, 2ᵉ]` and force ratios up to `2ᵉ`
    /// keep every closed form of this crate free of overflow and underflow: about a quarter of the
    /// type's own exponent range.
    const RATIO_EXPONENT: i32;

    /// The difference between π and [`Real::pi`]: the next two parts of π, each rounded once. The default
    /// computes them from the digits of π.
    #[doc(hidden)]
    #[must_use]
    fn pi_rest() -> (Self, Self) {
        pi_digits::rest(Self::pi())
    }
    /// The distance from 1 to the next larger number.
    fn epsilon() -> Self;
    /// `2ᵉ`, for `|e|` up to [`Float::RATIO_EXPONENT`].
    fn exp2i(e: i32) -> Self;
    /// `2ⁿ` of an integer n, for `|n|` up to [`Float::RATIO_EXPONENT`]; without a conversion where loops are vectorised.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn power_of_two(n: Self) -> Self {
        // The cast of a float to an integer saturates.
        Self::exp2i(n.to_f64() as i32)
    }
    /// `2⁻ᵉ`, e = [`Float::RATIO_EXPONENT`]: the least frequency ratio.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn least_ratio() -> Self {
        Self::exp2i(Self::RATIO_EXPONENT.saturating_neg())
    }
    /// The nearest `f64` (to within one unit in the last place).
    fn to_f64(self) -> f64;
    /// The number nearest to `x`; exact where the type is at least as wide as `f64`.
    fn from_f64(x: f64) -> Self;
    /// The largest integer not above `self`.
    fn floor(self) -> Self;
    /// The integer nearest to `self`.
    fn round(self) -> Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// This number in the wide arithmetic, without rounding.
    #[doc(hidden)]
    #[inline(always)]
    fn wide(self) -> Pair<Self> {
        Pair::exact(self)
    }

    /// Runs `task` with the processor's own fused multiply-add, where the processor has one and the program
    /// was not compiled for it.
    ///
    /// The results are the same. Code that is not inlined into `task` does not become faster.
    #[doc(hidden)]
    #[inline(always)]
    fn fused<T: Task>(task: T) -> T::Output {
        task.run()
    }

    /// The angle in `[0, π]` with this sine ≥ 0 and this cosine: [`Real::atan2`], or a faster algorithm that
    /// requires a point on the unit circle.
    #[doc(hidden)]
    #[inline(always)]
    fn angle_of(sine: Self, cosine: Self) -> Self {
        sine.atan2(cosine)
    }

    /// `(sin, cos)` of an angle in [−π/2, π/2] to more digits than the type has. The error is below a third
    /// of a unit in the last place up to π/3, and smaller still for smaller angles.
    #[doc(hidden)]
    #[inline(always)]
    fn sin_cos_acute(angle: Pair<Self>) -> (Pair<Self>, Pair<Self>) {
        if const { Self::PRECISION <= f64::MANTISSA_DIGITS } {
            TO_HALF_PI.of().wide(angle)
        } else {
            task::sin_cos_of_pair(angle)
        }
    }

    /// Runs a task at a lower precision, for example to find the start of an iteration. With a quarter of the
    /// bits or more, a single step that quadruples them completes the result. The default precision is that
    /// of `f64`.
    #[doc(hidden)]
    #[inline]
    fn narrowed<T: AtPrecision<Self>>(task: T) -> T::Output {
        task.run::<f64>(Self::to_f64, Self::from_f64)
    }

    /// Runs a task with guard bits where the type has a wider one available, and at the type itself
    /// otherwise.
    #[doc(hidden)]
    #[inline]
    fn guarded<T: AtPrecision<Self>>(task: T) -> T::Output {
        task.run::<Self>(|x| x, |x| x)
    }

    /// `eˣ`. The default sums the series; a type may provide a better algorithm.
    #[doc(hidden)]
    fn exp(self) -> Self {
        exponential::exp(self)
    }
    /// `eˣ − 1`, without loss of digits for a small x. The default sums the series; a type may provide a
    /// better algorithm.
    #[doc(hidden)]
    fn exp_m1(self) -> Self {
        exponential::exp_m1(self)
    }

    /// The value alone, without derivatives, in a type that carries them (`dual`); the number itself
    /// otherwise.
    #[doc(hidden)]
    #[inline]
    fn constant(self) -> Self {
        self
    }

    /// This value with the derivatives of `like`, in a type with derivatives. In any other type the result is
    /// the number itself, and `like` is not evaluated.
    ///
    /// It serves values whose own computation loses digits of the derivatives: a quotient of two small
    /// numbers, or a point found by iteration.
    #[doc(hidden)]
    #[inline]
    fn differentiated_as(self, like: impl FnOnce() -> Self) -> Self {
        let _ = like;
        self
    }

    /// A root x of `g(x, p) = 0` that was found by iteration, with the derivatives of the implicit function:
    /// `dx = −(∂g/∂p) dp/g′`.
    ///
    /// `residual` gives (g, g′) at a constant x, so that g carries only its explicit dependence on the
    /// parameters. This is one step of Newton's method in the derivatives. Derivatives carried along by the
    /// iteration are dropped: they lag behind by a step, and a bracket at f64 carries none.
    #[doc(hidden)]
    #[inline]
    fn implicit_root(self, residual: impl FnOnce(Self) -> (Self, Self)) -> Self {
        self.differentiated_as(|| {
            let (g, slope) = residual(self.constant());
            -(g / slope.constant())
        })
    }

    /// The larger of two numbers; `self` where they are unordered.
    #[doc(hidden)]
    #[inline]
    fn or_larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// `self` where `sign` ≥ 0, its negative where `sign` < 0; a zero `sign` may count as either.
    #[doc(hidden)]
    #[inline(always)]
    fn times_sign_of(self, sign: Self) -> Self {
        if sign < Self::int(0) { -self } else { self }
    }
    /// `|self|` with the sign of `sign`; a zero of either sign counts as positive.
    #[doc(hidden)]
    #[inline]
    fn with_sign_of(self, sign: Self) -> Self {
        if sign < Self::int(0) { -self.abs() } else { self.abs() }
    }
}
