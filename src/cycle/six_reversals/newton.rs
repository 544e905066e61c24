//! Newton's method on the matching problem of six reversals, and the linear equations of its steps.

use super::equations::Unknowns;
use crate::float::Float;

/// A solution from a start that is close to it; `None` where the steps do not come down to rounding.
///
/// Each step doubles the correct digits. The steps are judged by the changes of c and s, which determine α:
/// near a pole the upper edge has a short arc, which is less accurate and matters correspondingly less for α.
/// `residuals` gives the left sides minus the right sides of the five equations, and their derivatives.
#[inline]
pub(super) fn polished<F: Float>(
    omega: F,
    start: Unknowns<F>,
    residuals: impl Fn(&Unknowns<F>) -> ([F; 5], [[F; 5]; 5]),
) -> Option<Unknowns<F>> {
    let mut y = start;
    let mut last = None;
    for _ in 0..F::precision().ilog2() + 16 {
        let (values, rows) = residuals(&y);
        let step = solve(rows, values)?;
        let next = y.to_array().into_iter().zip(step).map(|(x, d)| x - d);
        let mut moved = y.to_array();
        moved.iter_mut().zip(next).for_each(|(x, new)| *x = new);
        let after = Unknowns::of_array(moved);
        let size = (after.sine - y.sine).hypot(after.cosine - y.cosine) / after.cosine.abs();
        let limit = omega + F::int(3);
        let inside = |x: F| x > F::int(0) && x < limit;
        if !(inside(after.before) && inside(after.after) && after.cosine > F::int(0)) {
            return None;
        }
        y = after;
        // Below the root of rounding the next step is below rounding; from there on a step that does not
        // shrink is noise.
        let is_noise = last.is_some_and(|last: F| last.square() < F::epsilon() && size * F::int(2) >= last);
        if size <= F::epsilon() || is_noise {
            return Some(y);
        }
        last = Some(size);
    }
    None
}

/// The solution x of `A x = b` by Gaussian elimination with partial pivoting; `None` where a pivot is zero or
/// not a number.
#[allow(clippy::indexing_slicing, reason = "every index is below N, the length of the arrays")]
pub(super) fn solve<F: Float, const N: usize>(mut a: [[F; N]; N], mut b: [F; N]) -> Option<[F; N]> {
    for column in 0..N {
        let mut pivot = column;
        for row in column + 1..N {
            if a[row][column].abs() > a[pivot][column].abs() {
                pivot = row;
            }
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let (leading, value) = (a[column], b[column]);
        if leading[column] == F::int(0) || !leading[column].is_finite() {
            return None;
        }
        for row in column + 1..N {
            let factor = a[row][column] / leading[column];
            for (entry, above) in a[row].iter_mut().zip(leading).skip(column) {
                *entry = *entry - factor * above;
            }
            b[row] = b[row] - factor * value;
        }
    }
    for row in (0..N).rev() {
        for column in row + 1..N {
            b[row] = b[row] - a[row][column] * b[column];
        }
        b[row] = b[row] / a[row][row];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}

#[cfg(test)]
mod linear_tests {
    use super::solve;

    #[test]
    fn three_equations() {
        let found = solve([[0.0, 2.0, 1.0], [1.0, -1.0, 0.0], [3.0, 0.0, -2.0]], [7.0, -1.0, -3.0]).unwrap();
        for (x, expected) in found.into_iter().zip([1.0f64, 2.0, 3.0]) {
            assert!((x - expected).abs() < 1e-15, "{found:?}");
        }
        assert_eq!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
        assert_eq!(solve([[f64::NAN, 2.0], [2.0, 4.0]], [1.0, 2.0]), None);
    }
}
