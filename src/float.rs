//! The number type every formula is written over.
//!
//! Two layers. [`Real`] is what a *formula* needs: the field operations, roots, circular functions,
//! small integers and ratios, π. [`Float`] is what a *decision* needs on top: order, precision, and a
//! way to and from `f64`. A formula asks for `Real` only, so that a value which cannot be compared (a
//! symbolic one) still runs through it; a choice of branch or a stopping rule asks for `Float`.
//!
//! Both are `Copy`: generic code reads like the page it came from. Constants are integers and ratios
//! of integers ([`Real::int`], [`Real::ratio`]), never decimal literals, so no formula carries the
//! rounding of a type narrower than its own.

use core::fmt::{Debug, Display, LowerExp};
use core::ops::Neg;
use num_traits::NumOps;

#[cfg(feature = "dual")]
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of duals over f64"))]
pub mod dual;
mod exponential;
#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of multiple-precision numbers; counts of limbs and of digits, which a format's u16 bounds"
    )
)]
pub mod mp;
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of pairs"))]
pub mod pair;
mod primitive;

/// What a formula needs of its numbers.
///
/// Domains and special values are those of IEEE 754 where the type has them: `sqrt(−1)` is NaN.
pub trait Real: Copy + Debug + NumOps + Neg<Output = Self> {
    /// The integer `n`, exactly.
    fn int(n: i32) -> Self;
    /// π, rounded once.
    fn pi() -> Self;
    /// `√self`.
    fn sqrt(self) -> Self;
    /// `|self|`.
    fn abs(self) -> Self;
    /// `(sin self, cos self)`, the argument in radians.
    fn sin_cos(self) -> (Self, Self);
    /// `tan self`, the argument in radians.
    fn tan(self) -> Self;
    /// The angle in `[−π, π]` of the point with ordinate `self` and abscissa `x`.
    fn atan2(self, x: Self) -> Self;
    /// `√(self² + other²)` without needless overflow or underflow.
    fn hypot(self, other: Self) -> Self;
    /// `self · a + b` with one rounding.
    fn mul_add(self, a: Self, b: Self) -> Self;

    /// The ratio `p/q`, rounded once.
    #[inline]
    fn ratio(p: i32, q: i32) -> Self {
        Self::int(p) / Self::int(q)
    }
    /// `sin self`.
    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// `cos self`.
    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// `self²`.
    #[inline]
    fn square(self) -> Self {
        self * self
    }
}

/// A task that the number type `F` hands to a narrower or wider one ([`Float::narrowed`], [`Float::guarded`]).
pub trait AtPrecision<F> {
    /// What it comes to.
    type Output;
    /// The task at the type `G`, with the ways there and back, each of which rounds once.
    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output;
}

/// What a decision needs of its numbers: order, precision, range.
pub trait Float: Real + PartialOrd + Display + LowerExp {
    /// Bits of the significand: 24 for `f32`, 53 for `f64`.
    const PRECISION: u32;
    /// Largest exponent `e` for which frequency ratios in `[2⁻ᵉ, 2ᵉ]` and force ratios up to `2ᵉ`
    /// keep every closed form of this crate free of overflow and underflow: about a quarter of the
    /// type's own exponent range.
    const RATIO_EXPONENT: i32;

    /// Whether [`Real::mul_add`] is one instruction: then the cheapest way to the rest of a product, otherwise [`Float::halves`] are.
    const IS_FUSED: bool = false;

    /// What is missing from [`Real::pi`]: the next two parts of π, each rounded once.
    fn pi_rest() -> (Self, Self);
    /// The distance from 1 to the next larger number.
    fn epsilon() -> Self;
    /// `2ᵉ`, for `|e|` up to [`Float::RATIO_EXPONENT`].
    fn exp2i(e: i32) -> Self;
    /// `2⁻ᵉ`, e = [`Float::RATIO_EXPONENT`]: the least frequency ratio.
    #[inline]
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

    /// `self · other − near` for a number near that product: what a rounded product or quotient lacks.
    ///
    /// Exact where the type has a fused operation of its own, otherwise to half the digits of the type: the error is
    /// `2⁻³ᵖᐟ²` of the product at most.
    #[inline]
    fn product_less(self, other: Self, near: Self) -> Self {
        self.mul_add(other, -near)
    }
    /// `self · factor + addend`: rounded once where that is one instruction, elsewhere twice.
    #[inline]
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    /// `(high, low)` with `high + low = self` exactly and the product of two such high parts exact; of a type that has no use for
    /// it, `(self, 0)`.
    #[inline]
    fn halves(self) -> (Self, Self) {
        (self, Self::int(0))
    }

    /// Runs a task at a lower precision, such as finding the start of an iteration: from a quarter of the bits
    /// on, one step that quadruples them is left to do. At `f64` unless the type knows better.
    #[inline]
    fn narrowed<T: AtPrecision<Self>>(task: T) -> T::Output {
        task.run::<f64>(Self::to_f64, Self::from_f64)
    }

    /// Runs a task with guard bits, where the type has a wider one at hand; at the type itself otherwise.
    #[inline]
    fn guarded<T: AtPrecision<Self>>(task: T) -> T::Output {
        task.run::<Self>(|x| x, |x| x)
    }

    /// `eˣ` of the number x; a type may have a better way than the series that this is.
    fn exp(self) -> Self {
        exponential::exp(self)
    }
    /// `eˣ − 1` of the number x, which keeps its digits for a small x; a type may have a better way than the series that this is.
    fn exp_m1(self) -> Self {
        exponential::exp_m1(self)
    }

    /// The value alone, without derivatives, in a type that carries some (`dual`); the number itself otherwise.
    #[inline]
    fn constant(self) -> Self {
        self
    }

    /// The same value with the derivatives of `like`, in a type that carries some. Otherwise the number itself, and `like` is not
    /// evaluated.
    ///
    /// For values whose own computation is a worse way to their derivatives: a quotient of two small numbers, a point found
    /// by iteration.
    #[inline]
    fn differentiated_as(self, like: impl FnOnce() -> Self) -> Self {
        let _ = like;
        self
    }

    /// A root x of `g(x, p) = 0` that was found by iteration, with the derivatives of the implicit function: `dx = −(∂g/∂p) dp/g′`.
    ///
    /// `residual` gives (g, g′) at a constant x, so that g carries its explicit dependence on the parameters alone: one step
    /// of Newton's method in the derivatives. What the iteration itself carried along is dropped: it lags behind by a step, and
    /// a bracket at f64 carries nothing at all.
    #[inline]
    fn implicit_root(self, residual: impl FnOnce(Self) -> (Self, Self)) -> Self {
        self.differentiated_as(|| {
            let (g, slope) = residual(self.constant());
            -(g / slope.constant())
        })
    }

    /// The larger of two numbers; `self` where they are unordered.
    #[inline]
    fn or_larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// `|self|` with the sign of `sign`; a zero of either sign counts as positive.
    #[inline]
    fn with_sign_of(self, sign: Self) -> Self {
        if sign < Self::int(0) { -self.abs() } else { self.abs() }
    }
}
