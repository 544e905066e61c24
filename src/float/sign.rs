//! Decisions that floats and balls make alike: the sign of a float is certain, that of a ball may not be.

use super::{Float, Real};

/// A number with a sign, which may be uncertain.
pub(crate) trait Signed: Real {
    /// Whether the number is above 0; `None` where that is uncertain, and for NaN.
    fn positive(self) -> Option<bool>;
    /// Whether the number is below 0.
    #[inline(always)]
    fn negative(self) -> Option<bool> {
        (-self).positive()
    }
    /// Whether this number is above another one.
    #[inline(always)]
    fn is_above(self, other: Self) -> Option<bool> {
        (self - other).positive()
    }
    /// The larger of two numbers.
    fn larger(self, other: Self) -> Self;
    /// The smaller of two numbers.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        -(-self).larger(-other)
    }
}

impl<F: Float> Signed for F {
    #[inline(always)]
    fn positive(self) -> Option<bool> {
        if self > F::int(0) { Some(true) } else { (self <= F::int(0)).then_some(false) }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.or_larger(other)
    }
}
