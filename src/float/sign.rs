//! Decisions that floats and balls make alike: the sign of a float is certain, that of a ball may not be.

use super::{Float, Real};

/// A number with a sign, which may be uncertain.
pub trait Signed: Real {
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
    /// `first` or `second`, as the choice says; a number that may be either, or `None`, where it is uncertain.
    fn chosen(is_first: Option<bool>, first: Self, second: Self) -> Option<Self>;
    /// A number of which nothing is known: NaN, or the whole line.
    #[inline(always)]
    fn unknown() -> Self {
        Self::int(0) / Self::int(0)
    }
    /// eˣ.
    fn exponential(self) -> Self;
    /// eˣ − 1.
    fn exponential_less_one(self) -> Self;
    /// `cosh √x` and `sinh √x/√x`, entire functions of x that are `cos √−x` and `sin √−x/√−x` below 0, where the sign of x is
    /// uncertain. Unknown for floats, among which it is for NaN alone.
    fn hyperbolic(self) -> [Self; 2];
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

    #[inline(always)]
    fn chosen(is_first: Option<bool>, first: Self, second: Self) -> Option<Self> {
        is_first.map(|is_first| if is_first { first } else { second })
    }

    #[inline(always)]
    fn exponential(self) -> Self {
        self.exp()
    }

    #[inline(always)]
    fn exponential_less_one(self) -> Self {
        self.exp_m1()
    }

    #[cold]
    fn hyperbolic(self) -> [Self; 2] {
        [Self::unknown(); 2]
    }
}
