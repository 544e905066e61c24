//! Least squares of a model of a few parameters, by Levenberg and Marquardt's descent from several starts.

use crate::uncertainty::Estimate;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The tolerance of an answer.
pub(super) const EXACT: Ends = Ends::at(1e-14);

/// Where a descent ends.
#[derive(Debug, Clone, Copy)]
pub(in crate::design) struct Ends {
    /// The part of the sum of squares that a step must gain.
    pub(in crate::design) tolerance: f64,
    /// The sum of squares above which a model explains nothing: a descent that hardly falls there is given up.
    pub(in crate::design) hopeless: f64,
}

impl Ends {
    /// Only where a step gains less than a part of the sum.
    pub(super) const fn at(tolerance: f64) -> Self {
        Self { tolerance, hopeless: f64::INFINITY }
    }
}

/// The part of the sum of squares that a step gains where it hardly falls, and the steps in a row that do.
const HARDLY: f64 = 0.01;
const IN_A_ROW: u32 = 6;

/// A least-squares fit.
#[derive(Debug, Clone)]
pub(in crate::design) struct Fit {
    /// The parameters.
    pub(in crate::design) at: Vec<f64>,
    /// The covariance over the variance of one measurement, by rows.
    covariance: Vec<Vec<f64>>,
    pub(in crate::design) sum: f64,
    pub(in crate::design) residuals: Vec<f64>,
}

impl Fit {
    /// The best fit from several starts, if one of them leads to any.
    pub(in crate::design) fn best(
        measured: &[f64],
        model: &impl Fn(&[f64]) -> Vec<f64>,
        starts: &[Vec<f64>],
        scales: &[f64],
        ends: Ends,
    ) -> Option<Self> {
        let fits = starts.iter().filter_map(|start| {
            let at = descend(measured, model, start.clone(), scales, ends)?;
            let residuals = residuals(measured, model, &at);
            let sum = squares(&residuals);
            Some(Self { covariance: inverse(&normal(model, &at, scales).0)?, at, sum, residuals })
        });
        fits.min_by(|a, b| a.sum.total_cmp(&b.sum))
    }

    pub(in crate::design) fn degrees_of_freedom(&self) -> f64 {
        self.residuals.len().saturating_sub(self.at.len()).max(1) as f64
    }

    /// The standard error of one measurement.
    pub(in crate::design) fn noise(&self) -> f64 {
        (self.sum / self.degrees_of_freedom()).sqrt()
    }

    /// The standard error of a parameter.
    pub(in crate::design) fn error(&self, i: usize) -> f64 {
        self.covariance.get(i).and_then(|row| row.get(i)).map_or(f64::NAN, |v| v.sqrt()) * self.noise()
    }

    /// The standard error of a function of the parameters with this gradient.
    pub(in crate::design) fn error_along(&self, gradient: &[f64]) -> f64 {
        let variance =
            self.covariance.iter().zip(gradient).map(|(row, a)| {
                row.iter().zip(gradient).map(|(covariance, b)| a * b * covariance).sum::<f64>()
            });
        variance.sum::<f64>().sqrt() * self.noise()
    }

    /// An estimate that is not negative, of a value with a standard error.
    pub(super) fn estimate(&self, value: f64, standard_error: f64, greatest: f64) -> Estimate {
        let degrees_of_freedom = self.degrees_of_freedom();
        Estimate { value, standard_error, degrees_of_freedom, range: (0.0, greatest) }
    }

    /// The correlation of neighbouring residuals, where it is above chance, and otherwise 0.
    pub(in crate::design) fn correlation(&self) -> f64 {
        let pairs = self.residuals.iter().zip(self.residuals.iter().skip(1));
        let found = pairs.map(|(a, b)| a * b).sum::<f64>() / self.sum;
        if found > 3.0 / (self.residuals.len() as f64).sqrt() { found } else { 0.0 }
    }
}

/// Fits with different numbers of half cycles that explain a measurement equally well but for chance; there is one at least.
pub(super) struct Alike {
    fits: Vec<(Option<usize>, Fit)>,
    /// The factor of the standard errors, above 1 where the residuals are not independent.
    wider: f64,
}

impl Alike {
    /// Those of a list whose sum of squares is within three standard errors of the least.
    pub(super) fn of(mut fits: Vec<(Option<usize>, Fit)>) -> Option<Self> {
        fits.sort_by(|a, b| a.1.sum.total_cmp(&b.1.sum));
        let best = &fits.first()?.1;
        let enough = best.sum * (1.0 + 9.0 / best.degrees_of_freedom());
        let correlation = best.correlation().min(0.98);
        fits.retain(|(_, fit)| fit.sum <= enough);
        // The mean of n numbers, of which neighbours have this correlation, varies as that of n/factor² independent ones.
        Some(Self { fits, wider: ((1.0 + correlation) / (1.0 - correlation)).sqrt() })
    }

    pub(in crate::design) fn best(&self) -> &Fit {
        &self.fits[0].1
    }

    /// The half cycles until rest of the best fit, if it comes to rest.
    pub(super) fn half_cycles(&self) -> Option<usize> {
        self.fits[0].0
    }

    /// Whether all fits come to rest; their half cycles and parameters.
    pub(super) fn at_rest(&self) -> Option<Vec<(usize, &[f64])>> {
        self.fits.iter().map(|(half_cycles, fit)| Some(((*half_cycles)?, fit.at.as_slice()))).collect()
    }

    /// The standard error of a parameter, so that its interval covers that of each fit.
    pub(super) fn error(&self, i: usize) -> f64 {
        let best = self.best();
        let off = |fit: &Fit| (fit.at[i] - best.at[i]).abs() / 2.0 + fit.error(i);
        self.wider * self.fits.iter().map(|(_, fit)| off(fit)).fold(0.0, f64::max)
    }
}

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

fn residuals(measured: &[f64], model: &impl Fn(&[f64]) -> Vec<f64>, at: &[f64]) -> Vec<f64> {
    measured.iter().zip(model(at)).map(|(m, c)| m - c).collect()
}

/// The slopes by each parameter, by central differences, and the matrix of the normal equations.
fn normal(model: &impl Fn(&[f64]) -> Vec<f64>, at: &[f64], scales: &[f64]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let slopes: Vec<Vec<f64>> = scales
        .iter()
        .enumerate()
        .map(|(i, scale)| {
            let step = 1e-6 * scale;
            let moved = |by: f64| {
                let mut at = at.to_vec();
                at[i] += by;
                model(&at)
            };
            moved(step).iter().zip(moved(-step)).map(|(a, b)| (a - b) / (2.0 * step)).collect()
        })
        .collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum();
    (slopes.iter().map(|a| slopes.iter().map(|b| product(a, b)).collect()).collect(), slopes)
}

/// Levenberg and Marquardt's descent.
fn descend(
    measured: &[f64],
    model: &impl Fn(&[f64]) -> Vec<f64>,
    mut at: Vec<f64>,
    scales: &[f64],
    ends: Ends,
) -> Option<Vec<f64>> {
    let mut rest = residuals(measured, model, &at);
    let mut sum = squares(&rest);
    let (mut damping, mut slow) = (1e-3, 0);
    for _ in 0..200 {
        let (matrix, slopes) = normal(model, &at, scales);
        let gradient: Vec<f64> =
            slopes.iter().map(|slope| slope.iter().zip(&rest).map(|(a, b)| a * b).sum()).collect();
        let mut is_moved = false;
        for _ in 0..30 {
            let mut damped = matrix.clone();
            for (i, row) in damped.iter_mut().enumerate() {
                row[i] *= 1.0 + damping;
            }
            let inverse = inverse(&damped)?;
            let along = |row: &Vec<f64>| -> f64 { row.iter().zip(&gradient).map(|(a, g)| a * g).sum() };
            let step: Vec<f64> = inverse.iter().map(along).collect();
            let mut next: Vec<f64> = at.iter().zip(&step).map(|(a, s)| a + s).collect();
            // ζ stays where κ is defined.
            next[1] = next[1].clamp(-0.9, 0.99);
            let trial = residuals(measured, model, &next);
            let smaller = squares(&trial);
            if smaller <= sum {
                let gain = sum - smaller;
                (at, rest, damping) = (next, trial, (damping / 10.0).max(1e-12));
                is_moved = gain > ends.tolerance * sum;
                slow = if gain > HARDLY * sum { 0 } else { slow + 1 };
                sum = smaller;
                break;
            }
            damping *= 10.0;
        }
        if !is_moved || sum > ends.hopeless && slow >= IN_A_ROW {
            break;
        }
    }
    at.iter().all(|x| x.is_finite()).then_some(at)
}

/// The inverse of a positive matrix, by elimination with the rows scaled by the diagonal.
pub(in crate::design) fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
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
