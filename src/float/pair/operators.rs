//! Sums, products and quotients of pairs.

use super::Pair;
use crate::float::Float;
use core::ops::{Add, Div, Mul, Neg, Sub};

impl<F: Float> Neg for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

/// Where the leading parts cancel, the remainders can be as large as the sum of the leading parts; the sum is
/// therefore normalised to a pair.
impl<F: Float> Add for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = Self::two_sum(self.hi, other.hi);
        Self::fast_two_sum(sum.hi, sum.lo + (self.lo + other.lo))
    }
}

impl<F: Float> Sub for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<F: Float> Mul for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let Self { hi, lo } = Self::two_prod(self.hi, other.hi);
        Self { hi, lo: lo + self.hi.mul_add(other.lo, self.lo * other.hi) }
    }
}

impl<F: Float> Mul<F> for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: F) -> Self {
        let Self { hi, lo } = Self::two_prod(self.hi, other);
        Self { hi, lo: self.lo.mul_add(other, lo) }
    }
}

/// From one quotient, 1/y.
impl<F: Float> Div for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.over(other, F::int(1) / other.hi)
    }
}

/// The quotient of two pairs, the second of which is exact.
impl<F: Float> Div<F> for Pair<F> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: F) -> Self {
        let inverse = F::int(1) / other;
        let hi = self.hi * inverse;
        Self { hi, lo: (self.lo + (-hi).mul_add(other, self.hi)) * inverse }
    }
}
