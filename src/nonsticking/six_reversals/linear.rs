//! Linear equations with a few unknowns.

use crate::float::Float;

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
mod tests {
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
