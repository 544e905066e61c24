//! `eˣ` and `eˣ − 1` by the operations that every number type has, for types without functions of their own.

use super::Float;

/// `eˣ − 1` by its series at `x/2ⁿ`, doubled n times: `e²ʸ − 1 = (eʸ − 1)(eʸ − 1 + 2)`.
///
/// The relative error is a few roundings for |x| ≤ 1, and |x| times as many beyond.
pub(super) fn exp_m1<F: Float>(x: F) -> F {
    let (one, two) = (F::int(1), F::int(2));
    // Beyond this, e⁻ˣ is below the last digit of 1, and doubling would only lose digits.
    let bits = i32::try_from(F::precision()).unwrap_or(i32::MAX);
    if x < -F::int(bits) {
        return -one;
    }
    let mut y = x;
    let mut doublings = 0u32;
    while y.abs() > F::ratio(1, 8) && y.is_finite() {
        y = y / two;
        doublings = doublings.saturating_add(1);
    }
    // Σ yⁿ/n!, each term from the previous one.
    let (mut term, mut sum) = (y, y);
    for n in 2..=bits {
        term = term * y / F::int(n);
        if sum + term == sum {
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
        // A narrow type over its range, compared with a wide one.
        for i in -1000..=1000i16 {
            let x = f32::from(i).powi(3) * 8.7e-8;
            let (exact, units) = (f64::from(x), f64::from(4.0 * x.abs().max(1.0)) * f64::from(f32::EPSILON));
            let [rise, power] = [super::exp_m1(x), super::exp(x)].map(f64::from);
            assert!((rise - exact.exp_m1()).abs() <= units * exact.exp_m1().abs(), "{x}: {rise}");
            assert!((power - exact.exp()).abs() <= units * exact.exp(), "{x}: {power}");
        }
        // From −p on all digits are those of −1.
        for x in [-52.9f64, -53.0, -53.1, -60.0] {
            assert!((super::exp_m1(x) + 1.0).abs() <= 30.0 * f64::EPSILON, "{x}");
        }
        assert_eq!((super::exp_m1(-1e4), super::exp(-1e4), super::exp(1e4)), (-1.0, 0.0, f64::INFINITY));
    }
}
