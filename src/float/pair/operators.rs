//! Sums, products and quotients of pairs.

use super::Pair;
use crate::float::Float;
use core::ops::{Add, Div, Mul, Neg, Sub};

impl<F: Float> Neg for Pair<F> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

/// Accurate to the pair where the two do not cancel.
impl<F: Float> Add for Pair<F> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let sum = Self::sum(self.hi, other.hi);
        Self { hi: sum.hi, lo: sum.lo + (self.lo + other.lo) }
    }
}

/// As the sum.
impl<F: Float> Sub for Pair<F> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<F: Float> Mul for Pair<F> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let cross = self.hi.times_plus(other.lo, self.lo * other.hi);
        Self { hi, lo: self.hi.product_less(other.hi, hi) + cross }
    }
}

impl<F: Float> Mul<F> for Pair<F> {
    type Output = Self;
    #[inline]
    fn mul(self, other: F) -> Self {
        let hi = self.hi * other;
        Self { hi, lo: self.lo.times_plus(other, self.hi.product_less(other, hi)) }
    }
}

impl<F: Float> Div for Pair<F> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let hi = self.hi / other.hi;
        let rest = (-hi).times_plus(other.lo, self.lo) - hi.product_less(other.hi, self.hi);
        Self { hi, lo: rest / other.hi }
    }
}

impl<F: Float> Div<F> for Pair<F> {
    type Output = Self;
    #[inline]
    fn div(self, other: F) -> Self {
        let hi = self.hi / other;
        Self { hi, lo: (self.lo - hi.product_less(other, self.hi)) / other }
    }
}
