//! `y cot y` as a compensated pair, by Lambert's continued fraction.
//!
//! ```text
//! y cot y = 1 − g,   g = z/(3 − t),   t = z/(5 − z/(7 − z/(9 − …))),   z = y² ≤ (π/4)²
//! ```
//!
//! Every difference is of a large and a small number. Since t < 0.13, an error of t is reduced 25 times in g
//! and more than 90 times in `y cot y`. Hence z and the two outer levels are compensated, while t is not. Up
//! to f64's precision t is one quotient of polynomials with integer coefficients, the convergent of level 17;
//! at higher precision the levels are evaluated one by one.

use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// `g = 1 − y cot y` to full relative accuracy of the pair as y → 0; `square` is y².
#[inline(always)]
pub(super) fn cotangent_defect<F: Float>(square: Pair<F>) -> Pair<F> {
    square / Pair::fast_two_sum(F::int(3), -tail(square.hi))
}

/// `y cot y`, accurate except for the rounding errors of t: a thirtieth of a unit in the last place at |y| =
/// π/4, decreasing as y⁴.
#[inline(always)]
pub(super) fn y_cot_y<F: Float>(y: Pair<F>) -> Pair<F> {
    Pair::exact(F::int(1)) - cotangent_defect(y.square())
}

/// t from z.
#[inline(always)]
fn tail<F: Float>(z: F) -> F {
    if const { F::PRECISION > f64::MANTISSA_DIGITS } {
        return tail_by_levels(z);
    }
    let n = F::int;
    let numerator = (n(858) - z).mul_add(z, -n(96_525)).mul_add(z, n(2_297_295));
    let denominator = (-n(44)).mul_add(z, n(12_870)).mul_add(z, -n(810_810)).mul_add(z, n(11_486_475));
    z * numerator / denominator
}

/// t from the level at which it has converged: each level removes at least five bits of the error, and many
/// more for a small z.
#[cold]
fn tail_by_levels<F: Float>(z: F) -> F {
    let last = 3 + F::precision() as i32 / 5;
    (2..=last).rev().fold(F::int(0), |t, level| z / (F::int(2 * level + 1) - t))
}

#[cfg(test)]
mod tests {
    use super::{tail, tail_by_levels, y_cot_y};
    use crate::float::Field;
    use crate::float::pair::Pair;

    #[test]
    fn the_convergent_is_the_continued_fraction() {
        for i in 0..=617 {
            let z = f64::from(i) / 1000.0;
            let (quotient, levels) = (tail(z), tail_by_levels(z));
            assert!((quotient - levels).abs() <= 4.0 * f64::EPSILON * levels, "{z}: {quotient} {levels}");
        }
    }

    #[cfg(feature = "mp")]
    #[test]
    fn more_digits_than_the_type_has() {
        use crate::float::Float;
        use crate::float::mp::Mp;
        for i in 1..=785 {
            let y = f64::from(i) / 1000.0;
            let found = y_cot_y(Pair::exact(y));
            let exact = Mp::<4>::from(y) / Mp::from(y).tan();
            let error = (Mp::from(found.hi) + Mp::from(found.lo) - exact) / exact;
            assert!(error.abs() < Mp::exp2i(-57) * Mp::from(y * y), "{y}: {error}");
            let defect = super::cotangent_defect(Pair::exact(y).square());
            let exact = Mp::of_int(1) - exact;
            let error = (Mp::from(defect.hi) + Mp::from(defect.lo) - exact) / exact;
            // An error of t is reduced more than twenty times, and t has a few roundings.
            assert!(error.abs() < Mp::exp2i(-55), "{y}: {error}");
        }
    }

    #[test]
    fn smooth_through_zero() {
        assert_eq!(y_cot_y(Pair::exact(0.0)).value(), 1.0);
        let tiny = 1e-9f64;
        let third = Pair::two_prod(tiny, tiny) / 3.0;
        assert_eq!(super::cotangent_defect(Pair::exact(tiny).square()).value(), third.value());
    }
}
