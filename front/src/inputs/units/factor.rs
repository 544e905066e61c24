//! The ratio of two units: a ratio of integers times a power of π.

use std::str::FromStr;
use stickslip::Float;

/// The ratio of two units: `numerator/denominator · πⁿ`, in lowest terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Factor {
    numerator: u128,
    denominator: u128,
    pi: i8,
}

impl Factor {
    pub(super) const ONE: Self = Self { numerator: 1, denominator: 1, pi: 0 };

    pub(super) const fn new(numerator: u128, denominator: u128, pi: i8) -> Self {
        let (numerator, denominator) = lowest(numerator, denominator);
        Self { numerator, denominator, pi }
    }

    const fn inverse(self) -> Self {
        Self { numerator: self.denominator, denominator: self.numerator, pi: -self.pi }
    }

    /// The product; `None` if it overflows 128-bit integers.
    pub(super) fn and(self, other: Self) -> Option<Self> {
        let (a, d) = lowest(self.numerator, other.denominator);
        let (c, b) = lowest(other.numerator, self.denominator);
        Some(Self::new(a.checked_mul(c)?, b.checked_mul(d)?, self.pi.checked_add(other.pi)?))
    }

    /// An integer power.
    pub(super) fn power(self, exponent: i8) -> Option<Self> {
        let base = if exponent < 0 { self.inverse() } else { self };
        (0..exponent.unsigned_abs()).try_fold(Self::ONE, |product, _| product.and(base))
    }

    /// The quotient. The factors of the table are small: an overflow counts as 1, which no unit here reaches.
    pub(super) fn over(self, other: Self) -> Self {
        self.and(other.inverse()).unwrap_or(Self::ONE)
    }

    /// The value in the other unit, with one rounding for each of the numbers that is not 1.
    pub fn times<F: Float + FromStr>(self, value: F) -> F {
        // The text of an integer is converted exactly, or with correct rounding, in any type.
        let whole = |n: u128| n.to_string().parse().unwrap_or_else(|_| F::from_f64(n as f64));
        let mut value = value;
        if self.numerator != 1 {
            value = value * whole(self.numerator);
        }
        if self.denominator != 1 {
            value = value / whole(self.denominator);
        }
        for _ in 0..self.pi.unsigned_abs() {
            value = if self.pi > 0 { value * F::pi() } else { value / F::pi() };
        }
        value
    }
}

/// Both numbers divided by their greatest common divisor.
const fn lowest(a: u128, b: u128) -> (u128, u128) {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    match (a.checked_div(x), b.checked_div(x)) {
        (Some(a), Some(b)) => (a, b),
        _ => (a, b),
    }
}
