//! A ball in decimal: its certain digits, then ±.
//!
//! Printing rounds the midpoint once more. The printed radius includes that rounding and is itself rounded
//! up, so that the interval of printed midpoint ∓ printed radius contains the ball. The arithmetic is
//! rational, without rounding.

use super::Ball;
use core::fmt;
use rug::{Float, Integer, Rational};

/// Midpoint and radius in decimal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Written {
    pub(crate) mid: String,
    pub(crate) rad: String,
}

/// A midpoint and a radius in decimal, with `more` digits beyond those that are certain to within one unit in
/// the last place.
pub(crate) fn written(mid: &Rational, rad: &Rational, more: u32) -> Written {
    // The place whose unit is at least twice the radius. An exact number gets all its digits, up to a limit.
    let place =
        if *rad == 0 { place_of_exact(mid) } else { place_above(&(rad.clone() * 2u32)) - i64::from(more) };
    let unit = power_of_ten(place);
    let last = Rational::from(mid / &unit).round().into_numer_denom().0;
    let error = (mid - unit * &last).abs() + rad;
    Written { mid: decimal(&last, place), rad: rounded_up(&error) }
}

/// The least p with `x ≤ 10ᵖ`, or one more.
fn place_above(x: &Rational) -> i64 {
    let logarithm = Float::with_val(64, x).log10().to_f64().ceil() as i64;
    if power_of_ten(logarithm) >= *x { logarithm } else { logarithm + 1 }
}

/// The place of the last digit of an exact number, limited to a hundred digits.
fn place_of_exact(x: &Rational) -> i64 {
    if *x == 0 {
        return 0;
    }
    let first = place_above(&x.clone().abs());
    (first - 100..=0).rev().find(|&place| *(x / power_of_ten(place)).denom() == 1).unwrap_or(first - 100)
}

/// `10ᵖ`.
fn power_of_ten(place: i64) -> Rational {
    let size = Integer::from(Integer::u_pow_u(10, u32::try_from(place.unsigned_abs()).unwrap_or(u32::MAX)));
    if place < 0 { Rational::from((Integer::from(1), size)) } else { Rational::from(size) }
}

/// `last · 10ᵖ`, with an exponent where the decimal point would be far from the digits.
fn decimal(last: &Integer, place: i64) -> String {
    let sign = if *last < 0 { "-" } else { "" };
    let digits = last.clone().abs().to_string();
    let count = digits.len() as i64;
    let exponent = count - 1 + place;
    if *last == 0 {
        return "0".to_owned();
    }
    if !(-5..=20).contains(&exponent) || place > 0 {
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{sign}{first}{point}{rest}e{exponent}");
    }
    if place == 0 {
        return format!("{sign}{digits}");
    }
    let padded = format!("{digits:0>width$}", width = (1 - place) as usize);
    let (whole, fraction) = padded.split_at(padded.len() - place.unsigned_abs() as usize);
    format!("{sign}{whole}.{fraction}")
}

/// A radius, rounded up to two digits.
fn rounded_up(x: &Rational) -> String {
    if *x == 0 {
        return "0".to_owned();
    }
    let place = place_above(x) - 2;
    let digits = (x / power_of_ten(place)).ceil().into_numer_denom().0.to_string();
    let (first, rest) = digits.split_at(1);
    let exponent = place + rest.len() as i64;
    let exponent = if exponent == 0 { String::new() } else { format!("e{exponent}") };
    match rest.trim_end_matches('0') {
        "" => format!("{first}{exponent}"),
        rest => format!("{first}.{rest}{exponent}"),
    }
}

impl<const LIMBS: usize> fmt::Display for Ball<LIMBS> {
    /// Prints the digits that are certain to within one unit in the last place, then ± and the radius.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.mid.to_rational(), self.rad.value::<1>().to_rational()) {
            (Some(mid), Some(rad)) if !self.is_entire() => {
                let Written { mid, rad } = written(&mid, &rad, 0);
                f.pad(&format!("{mid} ± {rad}"))
            }
            _ => f.pad("unknown"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Written, written};
    use crate::float::ball::Ball;
    use crate::float::mp::Mp;
    use rug::Rational;

    fn parsed(text: &str) -> Rational {
        let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let number: Rational = format!("{whole}{fraction}").parse().unwrap();
        number * super::power_of_ten(exponent.parse::<i64>().unwrap() - fraction.len() as i64)
    }

    #[test]
    fn what_is_printed_contains_the_ball() {
        for mid in
            ["1/3", "-2/3", "12345678901234567890123456789/7", "1/70000000000", "99999999/100000000", "0"]
        {
            for rad in ["0", "1/100", "1/1000000000000000000", "7", "49/10000000", "1/99999", "300000"] {
                for more in [0, 2] {
                    let (mid, rad): (Rational, Rational) = (mid.parse().unwrap(), rad.parse().unwrap());
                    let Written { mid: printed, rad: reach } = written(&mid, &rad, more);
                    let distance = (parsed(&printed) - &mid).abs();
                    let least = Rational::from(&distance + &rad);
                    assert!(parsed(&reach) >= least, "{mid} {rad}: {printed} ± {reach}");
                    assert!(
                        parsed(&reach) <= least * Rational::from((111, 100)),
                        "{mid} {rad}: {printed} ± {reach}"
                    );
                }
            }
        }
    }

    #[test]
    fn certain_digits_and_no_more() {
        let ball = |low: f64, high: f64| Ball::<2>::between(Mp::of_f64(low), Mp::of_f64(high)).to_string();
        assert_eq!(ball(1.23451, 1.2346), "1.2346 ± 9.1e-5");
        assert_eq!(ball(0.5, 0.5), "0.5 ± 0");
        assert_eq!(ball(-3e-9, -2.9e-9), "-3e-9 ± 1.1e-10");
        assert_eq!(ball(2e30, 2.0000001e30), "2.000000e30 ± 1.1e23");
        assert_eq!(ball(-1.0, 2.0), "0 ± 2");
        assert_eq!(Ball::<2>::entire().to_string(), "unknown");
    }
}
