//! The two lower layers of a number type: the field operations and the circular functions.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The operations that most formulae need: + − × ÷, √, magnitudes, small integers and ratios.
///
/// Domains and special values are those of IEEE 754 where the type has them: `sqrt(−1)` is NaN.
pub trait Field:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The integer `n`, exactly.
    fn int(n: i32) -> Self;
    /// `√self`.
    fn sqrt(self) -> Self;
    /// `|self|`.
    fn abs(self) -> Self;

    /// The ratio `p/q`, rounded once.
    #[inline(always)]
    #[must_use]
    fn ratio(p: i32, q: i32) -> Self {
        Self::int(p) / Self::int(q)
    }
    /// `self²`.
    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }
    /// `√(self² + other²)`; a type may avoid needless overflow and underflow.
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        (self.square() + other.square()).sqrt()
    }
    /// `√(self² − other²)`, |other| ≤ |self|: a leg of the right triangle with this hypotenuse and the
    /// `other` leg.
    ///
    /// The default multiplies the difference by the sum; a type may provide a better algorithm.
    #[doc(hidden)]
    #[inline(always)]
    fn leg(self, other: Self) -> Self {
        ((self - other) * (self + other)).sqrt()
    }
    /// `self + other`; a type of several parts may leave them unnormalised, for sums that are used as a whole and do not lose
    /// half of their digits.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn plus(self, other: Self) -> Self {
        self + other
    }
    /// `n self`.
    #[inline(always)]
    fn times(self, n: i32) -> Self {
        Self::int(n) * self
    }
}

/// The operations that formulae with angles need in addition: π and the circular functions.
pub trait Real: Field {
    /// π, rounded once. It is a function, because that of a precision which is chosen while the program runs is no constant; `f32` and
    /// `f64` have theirs in `core`.
    fn pi() -> Self;
    /// `(sin self, cos self)`, the argument in radians.
    fn sin_cos(self) -> (Self, Self);
    /// `tan self`, the argument in radians.
    fn tan(self) -> Self;
    /// The angle in `[−π, π]` of the point with ordinate `self` and abscissa `x`.
    fn atan2(self, x: Self) -> Self;
    /// `self · a + b` with one rounding.
    fn mul_add(self, a: Self, b: Self) -> Self;

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
}
