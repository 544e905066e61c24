//! π to any number of digits, in integers: the reference for the π of a number type.
//!
//! Numbers here are in fixed point: `Σ dₖ 2⁻²⁴ᵏ`, k from 0, with signed digits dₖ.

use super::Float;
use alloc::vec;
use alloc::vec::Vec;

/// Bits of a digit.
const BITS: u32 = 24;
/// `2²⁴`.
const BASE: i64 = 1 << BITS;

/// The number of digits that hold `bits` bits after the point, and one more.
pub(super) const fn count(bits: u32) -> usize {
    (bits / BITS) as usize + 2
}

/// `π = 16 arctan(1/5) − 4 arctan(1/239)` (Machin 1706), to within a few units of the last of `count` digits.
pub(super) fn pi(count: usize) -> Vec<i64> {
    // One more digit absorbs the truncation of the divisions.
    let (mut sum, mut small) = (inverse_arctangent(5, count + 1), inverse_arctangent(239, count + 1));
    sum.iter_mut().for_each(|digit| *digit *= 16);
    small.iter_mut().for_each(|digit| *digit *= 4);
    let mut pi = less(&sum, &small);
    pi.truncate(count);
    pi
}

/// `arctan(1/n) = 1/n − 1/(3n³) + 1/(5n⁵) − …`.
fn inverse_arctangent(n: i64, count: usize) -> Vec<i64> {
    let mut power = vec![0; count];
    if let Some(first) = power.first_mut() {
        *first = 1;
    }
    divide(&mut power, n);
    let mut sum = power.clone();
    let mut k = 1;
    while power.iter().any(|&digit| digit != 0) {
        divide(&mut power, n * n);
        k += 2;
        let mut term = power.clone();
        divide(&mut term, if k % 4 == 1 { k } else { -k });
        sum.iter_mut().zip(&term).for_each(|(digit, term)| *digit += term);
    }
    balance(&mut sum);
    sum
}

/// Divides a number with digits of one sign by a small integer, towards zero.
fn divide(digits: &mut [i64], by: i64) {
    let mut rest = 0;
    for digit in digits {
        let whole = rest * BASE + *digit;
        (*digit, rest) = (whole / by, whole % by);
    }
}

/// The difference of two numbers, balanced.
pub(super) fn less(a: &[i64], b: &[i64]) -> Vec<i64> {
    let mut difference: Vec<i64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    balance(&mut difference);
    difference
}

/// Brings every digit but the first into `[−2²³, 2²³)`, so that the first that is not zero has the sign and
/// the size of the number.
fn balance(digits: &mut [i64]) {
    let mut carry = 0;
    for digit in digits.iter_mut().rev() {
        let sum = *digit + carry;
        carry = (sum + BASE / 2).div_euclid(BASE);
        *digit = sum - carry * BASE;
    }
    if let Some(first) = digits.first_mut() {
        *first += carry * BASE;
    }
}

/// The digits of a number, exact where `count` digits suffice. Each part is split off without rounding.
pub(super) fn digits_of<F: Float>(x: F, count: usize) -> Vec<i64> {
    let mut rest = x;
    let mut digits = Vec::with_capacity(count);
    for _ in 0..count {
        let whole = rest.round();
        digits.push(whole.to_f64() as i64);
        rest = (rest - whole) * F::int(1 << BITS);
    }
    digits
}

/// The number nearest to balanced digits, to within a rounding or two.
pub(super) fn number<F: Float>(digits: &[i64]) -> F {
    let base = F::int(1 << BITS);
    let digit = |d: i64| F::int(i32::try_from(d).unwrap_or(i32::MAX));
    let first = digits.first().copied().unwrap_or(0);
    digits.iter().skip(1).rev().fold(F::int(0), |sum, &d| (sum + digit(d)) / base) + digit(first)
}

/// The two parts of π that follow `leading`, the number nearest to π.
pub(super) fn rest<F: Float>(leading: F) -> (F, F) {
    let count = count(F::precision().saturating_mul(3));
    let left = less(&pi(count), &digits_of(leading, count));
    let second = number(&left);
    (second, number(&less(&left, &digits_of(second, count))))
}

#[cfg(test)]
mod tests {
    use super::{count, digits_of, number, pi, rest};
    use crate::float::{Float, Real};

    #[test]
    fn the_parts_are_those_that_the_types_have() {
        assert_eq!(number::<f64>(&pi(4)), std::f64::consts::PI);
        assert_eq!(rest::<f64>(Real::pi()), <f64 as Float>::pi_rest());
        assert_eq!(rest::<f32>(Real::pi()), <f32 as Float>::pi_rest());
        #[cfg(feature = "mp")]
        {
            use crate::float::mp::Mp;
            assert_eq!(rest::<Mp<1>>(Real::pi()), <Mp<1> as Float>::pi_rest());
            assert_eq!(rest::<Mp<4>>(Real::pi()), <Mp<4> as Float>::pi_rest());
        }
    }

    #[test]
    fn a_number_is_its_digits() {
        for x in [1.0, 0.375, -2.0 / 3.0, 1e-20, -1e5] {
            assert_eq!(number::<f64>(&digits_of(x, count(130))), x, "{x}");
        }
    }
}
