//! Arithmetic of dual numbers.

use super::Dual;
use core::ops::{Add, Div, Mul, Neg, Rem, Sub};

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chained(-self.value(), -1.0)
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.combined(self.value() + other.value(), 1.0, other, 1.0)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.combined(self.value() - other.value(), 1.0, other, -1.0)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.combined(self.value() * other.value(), other.value(), other, self.value())
    }
}

/// num-dual's own division multiplies by the reciprocal, which rounds twice.
impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.value() / other.value();
        let inverse = 1.0 / other.value();
        self.combined(quotient, inverse, other, -(quotient * inverse))
    }
}

impl<const N: usize> Rem for Dual<N> {
    type Output = Self;
    #[inline]
    fn rem(self, other: Self) -> Self {
        let quotient = (self.value() / other.value()).trunc();
        self.combined(self.value() % other.value(), 1.0, other, -quotient)
    }
}
