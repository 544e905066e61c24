//! Least squares by Levenberg and Marquardt's descent, whatever the parameters, their range and the weights.

use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The greatest number of steps from a start.
const STEPS: usize = 200;
/// The damping of the first step, and the least and the greatest one.
const DAMPING: (f64, f64, f64) = (1e-3, 1e-12, 1e8);
/// The part of the sum of squares that a step gains where it hardly falls, and the steps in a row that do.
const HARDLY: f64 = 0.01;
const IN_A_ROW: u32 = 6;

/// A sum of squares over a few parameters.
pub(super) trait Squares {
    /// A point with its residuals.
    type Point;
    /// The normal equations at a point.
    type Normal;

    /// The sum at a point.
    fn sum(&self, point: &Self::Point) -> f64;
    /// The normal equations at a point, if they exist.
    fn normal(&self, point: &Self::Point) -> Option<Self::Normal>;
    /// The point after the step whose diagonal is greater by the factor `1 + damping`, if the model has one.
    fn moved(&self, point: &Self::Point, normal: &Self::Normal, damping: f64) -> Option<Self::Point>;
    /// The decrease of the sum that the linear model predicts from a point to another, or to its own minimum.
    fn gain(&self, normal: &Self::Normal, from: &Self::Point, to: Option<&Self::Point>) -> f64;
    /// The gain below which the descent ends.
    fn least_gain(&self, point: &Self::Point) -> f64;
    /// The sum above which a descent that hardly falls is given up, because nothing explains the values.
    fn hopeless(&self) -> f64 {
        f64::INFINITY
    }
    /// A better point where no step gains, as at a kink.
    fn beside(&self, _point: &Self::Point, _normal: &Self::Normal) -> Option<Self::Point> {
        None
    }
}

/// The point where the descent from a start ends, and whether it has come to its end; `None` where the normal equations do not
/// exist. Steps are accepted by the sum of squares itself.
pub(super) fn descend<S: Squares>(squares: &S, start: S::Point) -> Option<(S::Point, bool)> {
    let (first, least, greatest) = DAMPING;
    let mut here = start;
    let (mut damping, mut slow) = (first, 0_u32);
    for _ in 0..STEPS {
        let normal = squares.normal(&here)?;
        // The remaining gain is below the rounding of the residuals.
        if squares.gain(&normal, &here, None) <= squares.least_gain(&here) {
            return Some((here, true));
        }
        let sum = squares.sum(&here);
        let next = loop {
            match squares.moved(&here, &normal, damping).filter(|there| squares.sum(there) < sum) {
                Some(there) => {
                    // The damping follows the ratio of the gain of the step to the predicted gain.
                    let part = (sum - squares.sum(&there)) / squares.gain(&normal, &here, Some(&there));
                    damping = if part < 0.25 {
                        4.0 * damping.max(0.1)
                    } else {
                        (damping * if part > 0.75 { 0.1 } else { 1.0 }).max(least)
                    };
                    break Some(there);
                }
                None if damping > greatest => break None,
                None => damping *= 10.0,
            }
        };
        match next {
            Some(there) => here = there,
            None => match squares.beside(&here, &normal) {
                Some(there) => (here, damping) = (there, first),
                None => return Some((here, true)),
            },
        }
        slow = if sum - squares.sum(&here) > HARDLY * sum { 0 } else { slow.saturating_add(1) };
        if squares.sum(&here) > squares.hopeless() && slow >= IN_A_ROW {
            return Some((here, false));
        }
    }
    Some((here, false))
}

/// The inverse of a positive matrix, by elimination with the rows scaled by the diagonal.
pub(super) fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let scale: Vec<f64> = (0..n).map(|i| matrix[i][i].sqrt()).collect();
    if scale.iter().any(|s| !(*s > 0.0 && s.is_finite())) {
        return None;
    }
    let mut left: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| matrix[i][j] / (scale[i] * scale[j])).collect()).collect();
    let mut right: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    for i in 0..n {
        let pivot = left[i][i];
        if pivot <= 1e-14 {
            return None;
        }
        for j in 0..n {
            left[i][j] /= pivot;
            right[i][j] /= pivot;
        }
        for k in 0..n {
            if k != i {
                let factor = left[k][i];
                for j in 0..n {
                    left[k][j] -= factor * left[i][j];
                    right[k][j] -= factor * right[i][j];
                }
            }
        }
    }
    Some((0..n).map(|i| (0..n).map(|j| right[i][j] / (scale[i] * scale[j])).collect()).collect())
}
