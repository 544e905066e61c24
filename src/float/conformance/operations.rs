//! Checks of the operations, the order and the range.

use super::{Both, Broken, hold, spread};
use crate::float::Float;
use alloc::format;
use alloc::string::String;
use alloc::string::ToString;
use alloc::vec::Vec;

pub(super) fn check<F: Float>() -> Result<(), Broken> {
    integers::<F>()?;
    order::<F>()?;
    precision::<F>()?;
    sums::<F>()?;
    products::<F>()?;
    quotients_and_roots::<F>()?;
    powers_of_two::<F>()?;
    parts::<F>()?;
    conversions::<F>()?;
    signs::<F>()
}

fn integers<F: Float>() -> Result<(), Broken> {
    let exactly = "is the integer exactly";
    for n in -300..300 {
        let is = F::int(n + 1) - F::int(n) == F::int(1);
        hold(is, "Field::int", format_args!("{n} and {}", n + 1), exactly)?;
    }
    for n in (1..31).map(|e| 1i32 << (e - 1)) {
        let is = F::int(n) + F::int(n) == F::int(n).times(2) && F::int(-n) == -F::int(n);
        hold(is, "Field::int", format_args!("±{n}"), exactly)?;
        if n < 1 << 30 {
            hold(F::int(2 * n) == F::int(n) + F::int(n), "Field::int", format_args!("{}", 2 * n), exactly)?;
        }
    }
    let square = F::int(4097) * F::int(4095);
    hold(square == F::int(4097 * 4095), "Field::int", format_args!("{}", 4097 * 4095), exactly)
}

fn order<F: Float>() -> Result<(), Broken> {
    let one = F::int(1);
    let far = (0..F::RATIO_EXPONENT.min(100)).fold(one, |far, _| far * F::int(2));
    let positive = [one / far, F::ratio(1, 3), F::ratio(1, 2), one, F::ratio(3, 2), F::int(7), far];
    let negative = positive.iter().rev().map(|&x| -x);
    let numbers: Vec<F> = negative.chain([F::int(0)]).chain(positive).collect();
    for (i, &a) in numbers.iter().enumerate() {
        for (j, &b) in numbers.iter().enumerate() {
            let is = a.partial_cmp(&b) == Some(i.cmp(&j))
                && (a < b, a <= b, a == b, a >= b, a > b) == (i < j, i <= j, i == j, i >= j, i > j);
            hold(is, "PartialOrd::partial_cmp", Both(a, b), "is the order of the numbers")?;
        }
    }
    let zero = F::int(0);
    hold(-zero == zero, "PartialEq::eq", Both(-zero, zero), "zeros are equal, whatever their sign")?;
    let nan = nan::<F>();
    let is = nan.partial_cmp(&nan).is_none() && nan.partial_cmp(&one).is_none() && is_nan(nan);
    hold(is, "PartialOrd::partial_cmp", Both(nan, one), "0/0 is NaN, which has no order")
}

/// 0/0
fn nan<F: Float>() -> F {
    F::int(0) / F::int(0)
}

#[allow(clippy::eq_op, reason = "NaN is what is not equal to itself")]
fn is_nan<F: Float>(x: F) -> bool {
    x != x
}

/// `2¹⁻ᵖ`, by repeated halving.
pub(super) fn unit<F: Float>() -> F {
    (1..F::PRECISION).fold(F::int(1), |unit, _| unit / F::int(2))
}

fn precision<F: Float>() -> Result<(), Broken> {
    let (one, two, unit) = (F::int(1), F::int(2), unit::<F>());
    let bits = one + unit - one == unit && one + unit / two == one;
    hold(bits, "Float::PRECISION", F::PRECISION, "is the bits of the significand")?;
    let distance = "is the distance from 1 to the next larger number, 2 to the power 1 − PRECISION";
    hold(F::epsilon() == unit, "Float::epsilon", format_args!("{:e}", F::epsilon()), distance)?;
    let even = one + unit / two == one && one + unit + unit / two == one + two * unit;
    hold(even, "Add::add", Both(one, unit / two), "is rounded to nearest, ties to even")
}

/// Checks sums of `1 + i 2⁻ᵖ⁺¹` and a few quarters of the unit.
fn sums<F: Float>() -> Result<(), Broken> {
    let (one, unit) = (F::int(1), unit::<F>());
    let nearest = "is the exact result rounded to nearest, ties to even";
    for n in spread().take(60) {
        for quarters in -7..8 {
            let i = 2 + (n & 0x3ff);
            let (a, b) = (one + F::int(i) * unit, F::int(quarters) * unit / F::int(4));
            let (whole, rest) = ((4 * i + quarters) / 4, (4 * i + quarters) % 4);
            let up = rest > 2 || (rest == 2 && whole % 2 == 1);
            let sum = one + F::int(whole + i32::from(up)) * unit;
            hold(a + b == sum && b + a == sum, "Add::add", Both(a, b), nearest)?;
            hold(a - (-b) == sum && -a - b == -sum, "Sub::sub", Both(a, -b), nearest)?;
        }
        let x = F::int(n) * unit;
        hold(x + (-x) == F::int(0) && -(-x) == x, "Neg::neg", x, "is exact")?;
    }
    Ok(())
}

fn products<F: Float>() -> Result<(), Broken> {
    let (one, unit) = (F::int(1), unit::<F>());
    let nearest = "is the exact result rounded to nearest";
    // i j 2⁻ᵖ⁺¹ < 1/2
    let most = (1i32 << (F::PRECISION.saturating_sub(4) / 2).min(14)) - 1;
    for (m, n) in spread().zip(spread().skip(7)).take(100) {
        let (i, j) = (m & most, n & most);
        let (a, b) = (one + F::int(i) * unit, one + F::int(j) * unit);
        let product = one + F::int(i + j) * unit;
        hold(a * b == product, "Mul::mul", Both(a, b), nearest)?;
        let rest = F::int(i * j) * unit * unit;
        let once = "is a b + c with one rounding";
        hold(a.mul_add(b, -product) == rest, "Real::mul_add", Both(a, b), once)?;
        // For any factors in [1, 2), the remainder is at most half a unit of the product.
        let (a, b) = (anywhere::<F>(m), anywhere::<F>(n));
        let product = a * b;
        let half = if product < F::int(2) { unit / F::int(2) } else { unit };
        hold(a.mul_add(b, -product).abs() <= half, "Mul::mul", Both(a, b), nearest)?;
        hold(a.square() == a * a, "Field::square", a, "is the product with itself")?;
    }
    Ok(())
}

/// A number of [1, 2) with digits up to the last place.
fn anywhere<F: Float>(n: i32) -> F {
    F::int(1) + (F::int(n) / F::int(1 << 30) + F::int(n & 0xff) * unit())
}

fn quotients_and_roots<F: Float>() -> Result<(), Broken> {
    let (zero, one, two, unit) = (F::int(0), F::int(1), F::int(2), unit::<F>());
    let nearest = "is the exact result rounded to nearest";
    for (m, n) in spread().zip(spread().skip(11)) {
        let (a, b) = (anywhere::<F>(m).times_sign_of(F::int(n & 2) - one), anywhere::<F>(n));
        let quotient = a / b;
        let last = if quotient.abs() < one { unit / two } else { unit };
        let is = quotient.mul_add(b, -a).abs() <= last / two * b && quotient * b * two > a;
        hold(is || quotient < zero, "Div::div", Both(a, b), nearest)?;
        hold(quotient == -(a / -b), "Div::div", Both(a, -b), "has the sign of the quotient")?;
        for square in [b, b * two] {
            let root = square.sqrt();
            hold(root.mul_add(root, -square).abs() <= unit * root, "Field::sqrt", square, nearest)?;
        }
    }
    hold(zero.sqrt() == zero, "Field::sqrt", zero, "is 0")?;
    let root = (-one).sqrt();
    hold(is_nan(root), "Field::sqrt", -one, "is NaN")?;
    let close = |a: F, b: F| (a - b).abs() <= F::int(2) * unit * b;
    hold(F::ratio(1, 3) == one / F::int(3), "Field::ratio", "(1, 3)", "is rounded once")?;
    hold(F::ratio(1, 3).times(3) == one, "Field::times", "1/3", "is the multiple")?;
    hold(close(F::int(3).hypot(-F::int(4)), F::int(5)), "Field::hypot", "(3, -4)", "is √(x² + y²)")?;
    hold(close(F::int(5).leg(F::int(3)), F::int(4)), "Field::leg", "(5, 3)", "is √(x² − y²)")
}

fn powers_of_two<F: Float>() -> Result<(), Broken> {
    let (one, two, far) = (F::int(1), F::int(2), F::RATIO_EXPONENT);
    let exact = "is the power of two exactly, for exponents up to RATIO_EXPONENT";
    hold(F::exp2i(0) == one && F::exp2i(1) == two, "Float::exp2i", "0, 1", exact)?;
    let mut e = 1;
    while e < far {
        let is = F::exp2i(e + 1) == two * F::exp2i(e) && F::exp2i(e) * F::exp2i(-e) == one;
        hold(is && F::exp2i(-e) < one, "Float::exp2i", e, exact)?;
        hold(F::exp2i(e / 2) * F::exp2i(e - e / 2) == F::exp2i(e), "Float::exp2i", e, exact)?;
        e += 1 + e / 16;
    }
    let (large, small) = (F::exp2i(far), F::exp2i(-far));
    let room = large.square() * large < one / F::int(0) && small.square() * small > F::int(0);
    hold(room, "Float::RATIO_EXPONENT", far, "three times the exponent is in the range of the type")
}

fn parts<F: Float>() -> Result<(), Broken> {
    for (p, q, floor, round) in [
        (7, 3, 2, 2),
        (-7, 3, -3, -2),
        (8, 3, 2, 3),
        (-8, 3, -3, -3),
        (1, 3, 0, 0),
        (-1, 3, -1, 0),
        (5, 1, 5, 5),
        (-5, 1, -5, -5),
    ] {
        let x = F::ratio(p, q);
        hold(x.floor() == F::int(floor), "Float::floor", x, "is the largest integer not above the number")?;
        hold(x.round() == F::int(round), "Float::round", x, "is the nearest integer")?;
    }
    let whole = F::int(1) / unit::<F>() + F::int(1);
    let itself = "of an integer is itself";
    hold(whole.floor() == whole, "Float::floor", whole, itself)?;
    hold(whole.round() == whole, "Float::round", whole, itself)?;
    let (one, zero) = (F::int(1), F::int(0));
    hold(one.is_finite() && zero.is_finite(), "Float::is_finite", one, "holds for numbers")?;
    for x in [one / zero, -one / zero, nan()] {
        hold(!x.is_finite(), "Float::is_finite", x, "does not hold for infinities and NaN")?;
    }
    Ok(())
}

fn conversions<F: Float>() -> Result<(), Broken> {
    let is_wide = F::PRECISION >= f64::MANTISSA_DIGITS;
    for n in spread().take(40) {
        let x = (f64::from(n) / 3.0 - 1e8) / 7e7;
        // x = (high + low 2⁻²⁷) 2⁻²⁵, two integers.
        let scaled = x * f64::from(1 << 25);
        let (high, low) = (scaled.floor(), ((scaled - scaled.floor()) * f64::from(1 << 27)).floor());
        let short = (high + low / f64::from(1 << 27)) / f64::from(1 << 25);
        let own = (F::int(high as i32) + F::int(low as i32) / F::int(1 << 27)) / F::int(1 << 25);
        let nearest = "is the nearest number, exact where the type has 53 bits";
        let is = if is_wide {
            F::from_f64(short) == own
        } else {
            (F::from_f64(short) - own).abs() <= F::int(2) * unit::<F>() * own.abs()
        };
        hold(is, "Float::from_f64", short, nearest)?;
        let off = (own.to_f64() - short).abs();
        let allowed =
            if is_wide { 0.0 } else { short.abs() * <f64 as Float>::exp2i(2 - F::PRECISION as i32) };
        hold(off <= allowed, "Float::to_f64", own, "is the nearest f64, to a unit in the last place")?;
        let text =
            |text: String| text.parse().is_ok_and(|read: f64| (read - short).abs() <= 1e-6 * short.abs());
        hold(text(own.to_string()), "Display::fmt", own, "is the number in decimal digits")?;
        hold(
            text(format!("{own:e}")),
            "LowerExp::fmt",
            format_args!("{own:e}"),
            "is the number in decimal digits",
        )?;
    }
    Ok(())
}

fn signs<F: Float>() -> Result<(), Broken> {
    let (two, three) = (F::int(2), F::int(3));
    for (a, b) in [(two, three), (-two, three), (two, -three), (-two, -three)] {
        hold(a.abs() == two, "Field::abs", a, "is the magnitude")?;
        let sign = if b < F::int(0) { -F::int(1) } else { F::int(1) };
        hold(
            a.times_sign_of(b) == a * sign,
            "Float::times_sign_of",
            Both(a, b),
            "is the number times the sign of the other",
        )?;
        hold(
            a.with_sign_of(b) == two * sign,
            "Float::with_sign_of",
            Both(a, b),
            "has the sign of the other",
        )?;
        hold(a.or_larger(b) == if a < b { b } else { a }, "Float::or_larger", Both(a, b), "is the larger")?;
        hold(a.wide().value() == a, "Float::wide", a, "is exact")?;
    }
    Ok(())
}
