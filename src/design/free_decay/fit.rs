//! Fits of a model of a few parameters to values of one noise, from several starts.

use crate::design::least_squares::{Squares, descend, inverse};
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

/// A least-squares fit.
#[derive(Debug, Clone)]
pub(in crate::design) struct Fit {
    /// The parameters.
    pub(in crate::design) at: Vec<f64>,
    /// The covariance over the variance of one measurement, by rows.
    covariance: Vec<Vec<f64>>,
    /// The slopes of the values by each parameter.
    slopes: Vec<Vec<f64>>,
    pub(in crate::design) sum: f64,
    pub(in crate::design) residuals: Vec<f64>,
}

impl Fit {
    /// The best fit from several starts, if one of them leads to any.
    pub(super) fn best(
        measured: &[f64],
        model: &impl Fn(&[f64]) -> Vec<f64>,
        starts: &[Vec<f64>],
        scales: &[f64],
        ends: Ends,
    ) -> Option<Self> {
        Self::all(measured, model, starts, scales, ends).into_iter().next()
    }

    /// The fits from several starts, the best one first.
    pub(in crate::design) fn all(
        measured: &[f64],
        model: &impl Fn(&[f64]) -> Vec<f64>,
        starts: &[Vec<f64>],
        scales: &[f64],
        ends: Ends,
    ) -> Vec<Self> {
        let model = Model { measured, model, scales, ends };
        let fits = starts.iter().filter_map(|start| {
            let (Place { at, residuals, sum }, _) = descend(&model, model.place(start.clone()))?;
            let (matrix, slopes) = model.equations(&at);
            let covariance = inverse(&matrix)?;
            at.iter().all(|x| x.is_finite()).then_some(Self { covariance, slopes, at, sum, residuals })
        });
        let mut fits: Vec<Self> = fits.collect();
        fits.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        fits
    }

    /// The sum of squares up to which another fit explains the values as well but for chance: three standard errors of the least.
    pub(in crate::design) fn chance(&self) -> f64 {
        self.sum * (1.0 + 9.0 / self.degrees_of_freedom())
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

    /// How all parameters change with one, where the sum of squares rises least.
    pub(in crate::design) fn valley(&self, i: usize) -> Option<Vec<f64>> {
        let row = self.covariance.get(i)?;
        let own = *row.get(i)?;
        Some(row.iter().map(|covariance| covariance / own).collect())
    }

    /// By how much the parameters change where the model changes by these values.
    pub(in crate::design) fn moved_by(&self, change: &[f64]) -> Vec<f64> {
        let along: Vec<f64> = self.slopes.iter().map(|slope| product(slope, change)).collect();
        self.covariance.iter().map(|row| -product(row, &along)).collect()
    }

    /// An estimate that is not negative, of a value with a standard error.
    pub(super) fn estimate(&self, value: f64, standard_error: f64, greatest: f64) -> Estimate {
        let degrees_of_freedom = self.degrees_of_freedom();
        Estimate { value, standard_error, degrees_of_freedom, range: (0.0, greatest), alike: None }
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
        let enough = best.chance();
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

/// A model with the values that it is to explain, and the sizes of its parameters.
struct Model<'a, M> {
    measured: &'a [f64],
    model: &'a M,
    scales: &'a [f64],
    ends: Ends,
}

/// A point of a descent.
struct Place {
    at: Vec<f64>,
    residuals: Vec<f64>,
    sum: f64,
}

/// The matrix of the normal equations, and the products of its slopes with the residuals.
struct Normal {
    matrix: Vec<Vec<f64>>,
    gradient: Vec<f64>,
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl<M: Fn(&[f64]) -> Vec<f64>> Model<'_, M> {
    fn place(&self, at: Vec<f64>) -> Place {
        let residuals: Vec<f64> = self.measured.iter().zip((self.model)(&at)).map(|(m, c)| m - c).collect();
        Place { sum: product(&residuals, &residuals), at, residuals }
    }

    /// The matrix of the normal equations, and the slopes by each parameter, by central differences.
    fn equations(&self, at: &[f64]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let slopes: Vec<Vec<f64>> = self
            .scales
            .iter()
            .enumerate()
            .map(|(i, scale)| {
                let step = 1e-6 * scale;
                let moved = |by: f64| {
                    let mut at = at.to_vec();
                    at[i] += by;
                    (self.model)(&at)
                };
                moved(step).iter().zip(moved(-step)).map(|(a, b)| (a - b) / (2.0 * step)).collect()
            })
            .collect();
        (slopes.iter().map(|a| slopes.iter().map(|b| product(a, b)).collect()).collect(), slopes)
    }
}

impl Normal {
    fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let mut damped = self.matrix.clone();
        for (i, row) in damped.iter_mut().enumerate() {
            row[i] *= 1.0 + damping;
        }
        Some(inverse(&damped)?.iter().map(|row| product(row, &self.gradient)).collect())
    }
}

impl<M: Fn(&[f64]) -> Vec<f64>> Squares for Model<'_, M> {
    type Point = Place;
    type Normal = Normal;

    fn sum(&self, place: &Place) -> f64 {
        place.sum
    }

    fn normal(&self, place: &Place) -> Option<Normal> {
        let (matrix, slopes) = self.equations(&place.at);
        let gradient = slopes.iter().map(|slope| product(slope, &place.residuals)).collect();
        Some(Normal { matrix, gradient })
    }

    fn moved(&self, place: &Place, normal: &Normal, damping: f64) -> Option<Place> {
        let step = normal.step(damping)?;
        let mut next: Vec<f64> = place.at.iter().zip(&step).map(|(a, s)| a + s).collect();
        // ζ stays where κ is defined.
        next[1] = next[1].clamp(-0.9, 0.99);
        Some(self.place(next))
    }

    fn gain(&self, normal: &Normal, from: &Place, to: Option<&Place>) -> f64 {
        let step = match to {
            Some(to) => Some(to.at.iter().zip(&from.at).map(|(b, a)| b - a).collect()),
            None => normal.step(0.0),
        };
        let of = |step: Vec<f64>| {
            let curved: Vec<f64> = normal.matrix.iter().map(|row| product(row, &step)).collect();
            2.0 * product(&normal.gradient, &step) - product(&curved, &step)
        };
        step.map_or(f64::INFINITY, of)
    }

    fn least_gain(&self, place: &Place) -> f64 {
        self.ends.tolerance * place.sum
    }

    fn hopeless(&self) -> f64 {
        self.ends.hopeless
    }
}
