//! Arithmetic of symbols, by that of their rational functions.

use super::polynomial::Polynomial;
use super::scalar::{Symbol, inverse, stored};
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

impl From<Polynomial> for Symbol {
    fn from(polynomial: Polynomial) -> Self {
        stored(polynomial.into())
    }
}

impl Add for Symbol {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        stored(self.value().plus(&other.value()))
    }
}

impl Sub for Symbol {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        stored(self.value().minus(&other.value()))
    }
}

impl Mul for Symbol {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        stored(self.value().times(&other.value()))
    }
}

impl Div for Symbol {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        stored(self.value().times(&inverse(other)))
    }
}

impl Rem for Symbol {
    type Output = Self;
    fn rem(self, _: Self) -> Self {
        unimplemented!("no formula has a remainder")
    }
}

impl Neg for Symbol {
    type Output = Self;
    fn neg(self) -> Self {
        stored(self.value().negated())
    }
}
