//! `eˣ` and `eˣ − 1` by the operations that every number type has: what a type without functions of its own
//! runs on.

use super::Float;

/// `eˣ − 1` by its series at `x/2ⁿ`, doubled n times: `e²ʸ − 1 = (eʸ − 1)(eʸ − 1 + 2)`.
///
/// Relative accuracy: a few roundings for |x| ≤ 1, |x| times as many beyond.
pub(super) fn exp_m1<F: Float>(x: F) -> F {
    let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
    // Beyond it e⁻ˣ has no digit left near 1, and doubling would only lose what is there.
    let bits = i32::try_from(F::PRECISION).unwrap_or(i32::MAX);
    if x < -F::int(bits) {
        return -one;
    }
    let mut y = x;
    let mut doublings = 0u32;
    while y.abs() > F::ratio(1, 8) && y.is_finite() {
        y = y / two;
        doublings = doublings.saturating_add(1);
    }
    // Σ yⁿ/n!, each term from the last.
    let (mut term, mut sum) = (y, y);
    for n in 2..=bits.saturating_add(2) {
        term = term * y / F::int(n);
        if sum + term == sum || term == zero {
            break;
        }
        sum = sum + term;
    }
    for _ in 0..doublings {
        sum = sum * (sum + two);
    }
    sum
}

/// `eˣ`, from `e|x| − 1`.
pub(super) fn exp<F: Float>(x: F) -> F {
    let one = F::int(1);
    if x < F::int(0) { one / (one + exp_m1(-x)) } else { one + exp_m1(x) }
}

#[cfg(test)]
mod tests {
    use crate::float::Float;

    #[test]
    fn the_series_is_the_function() {
        for x in [0.0, 1e-300, 1e-9, -1e-9, 0.124, 0.126, -0.7, 1.0, 3.0, -3.0, 20.0, -30.0, 700.0] {
            let close = |found: f64, exact: f64, size: f64| {
                assert!((found - exact).abs() <= size * f64::EPSILON * exact.abs(), "{x}: {found} {exact}");
            };
            close(super::exp_m1(x), x.exp_m1(), 4.0 + x.abs());
            close(super::exp(x), x.exp(), 4.0 + x.abs());
            close(Float::exp_m1(x), x.exp_m1(), 1.0);
            close(Float::exp(x), x.exp(), 1.0);
        }
        assert_eq!((super::exp_m1(-1e4), super::exp(-1e4), super::exp(1e4)), (-1.0, 0.0, f64::INFINITY));
    }
}
