//! The minimum of a sum of squares over friction and damping, from a grid of starts.

use super::model::{ModelMotion, Parameters, motion};
use super::{AmplitudeKind, PhaseKind};
use crate::design::least_squares::{self, Squares};
use crate::machine::error::Error;
use alloc::vec::Vec;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// One measurement in ratios: Ω, the amplitude in units of p₀/k, and the phase.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeasuredPoint {
    pub(super) omega: f64,
    pub(super) amplitude: f64,
    /// The amplitude as it was measured.
    pub(super) measured: f64,
    /// The damping ratio of this point for each unit of ζ of the search: 1 on a spring, whose ζ is that of all points.
    pub(super) damping: f64,
    pub(super) phase: Option<f64>,
}

/// A response curve and how its values are read.
#[derive(Debug, Clone, Copy)]
pub(super) struct ResponseCurve<'a> {
    pub(super) points: &'a [MeasuredPoint],
    pub(super) amplitude: AmplitudeKind,
    pub(super) phase: PhaseKind,
    /// The factor of the measured amplitudes.
    pub(super) scale: f64,
}

/// The least and the greatest κ and ζ of the search.
pub(super) const RANGE: [(f64, f64); 2] = [(0.0, 1.0), (0.0, 100.0)];
/// The frictions and the dampings from which the search begins.
const FRICTIONS: [f64; 15] =
    [0.001, 0.01, 0.03, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97];
const DAMPINGS: [f64; 9] = [0.0, 1e-3, 4e-3, 0.01, 0.025, 0.06, 0.15, 0.5, 2.0];

/// An angle reduced to half a turn.
pub(super) fn reduced(angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    sin.atan2(cos)
}

impl<'a> ResponseCurve<'a> {
    /// Whether the readings depend on the whole cycle.
    pub(super) fn needs_whole(&self) -> bool {
        let phases = self.phase != PhaseKind::Peak && self.points.iter().any(|p| p.phase.is_some());
        phases || self.amplitude == AmplitudeKind::RootMeanSquare
    }

    /// The number of amplitudes, and of phases.
    pub(super) fn counts(&self) -> [usize; 2] {
        [self.points.len(), self.points.iter().filter(|p| p.phase.is_some()).count()]
    }

    pub(super) fn motions(&self, parameters: Parameters) -> Option<Vec<ModelMotion>> {
        let whole = self.needs_whole();
        let [kappa, zeta] = parameters;
        self.points.iter().map(|p| motion(p.omega, [kappa, p.damping * zeta], whole)).collect()
    }

    /// Measured minus computed: of all amplitudes, relative to the measured ones, then of all phases.
    fn residuals(&self, motions: &[ModelMotion]) -> Vec<f64> {
        let of_amplitude = |(point, motion): (&MeasuredPoint, &ModelMotion)| {
            let computed = match self.amplitude {
                AmplitudeKind::Peak | AmplitudeKind::PeakToPeak => motion.peak,
                AmplitudeKind::RootMeanSquare => motion.whole.root_mean_square,
            };
            1.0 - computed / (self.scale * point.amplitude)
        };
        let of_phase = |(point, motion): (&MeasuredPoint, &ModelMotion)| {
            let computed = match self.phase {
                PhaseKind::Peak => motion.peak_phase,
                PhaseKind::Lag => motion.whole.lag,
                PhaseKind::TransferFunction => -motion.whole.lag,
            };
            point.phase.map(|measured| reduced(measured - computed))
        };
        let pairs = || zip(self.points, motions);
        pairs().map(of_amplitude).chain(pairs().filter_map(of_phase)).collect()
    }

    /// The weighted sum of squares, and which motions stop.
    pub(super) fn sum_at(&self, weights: &[f64], parameters: Parameters) -> Option<(f64, Vec<bool>)> {
        let motions = self.motions(parameters)?;
        let sum = zip(self.residuals(&motions), weights).map(|(r, w)| w * r * r).sum();
        Some((sum, motions.iter().map(|motion| motion.stops).collect()))
    }

    pub(super) fn residuals_at(&self, parameters: Parameters) -> Option<Vec<f64>> {
        self.motions(parameters).map(|motions| self.residuals(&motions))
    }

    /// The derivatives of each residual with respect to κ and ζ, by differences of second order.
    pub(super) fn slopes(&self, at: Parameters, residuals: &[f64]) -> Option<Vec<[f64; 2]>> {
        let [kappa, zeta] = at;
        let by = |value: f64, shifted: &dyn Fn(f64) -> Parameters| -> Option<Vec<f64>> {
            let h = 1e-5 * value.max(0.01);
            let amplitudes = self.points.len();
            let ahead = self.residuals_at(shifted(value + h))?;
            let difference = |i: usize, d: f64| if i < amplitudes { d } else { reduced(d) };
            if value >= h {
                let behind = self.residuals_at(shifted(value - h))?;
                // Where the two sides differ there is a kink or a jump between them, and the flatter side
                // counts.
                let central = |(i, ((a, b), r)): (usize, ((&f64, &f64), &f64))| {
                    let (right, left) = (difference(i, a - r), difference(i, r - b));
                    let is_smooth = (right - left).abs() <= 0.5 * (right + left).abs();
                    let flatter = if right.abs() < left.abs() { right } else { left };
                    (if is_smooth { 0.5 * (right + left) } else { flatter }) / h
                };
                return Some(zip(zip(&ahead, &behind), residuals).enumerate().map(central).collect());
            }
            // At the end of the range only one side exists.
            let further = self.residuals_at(shifted(value + 2.0 * h))?;
            let one_sided = |(i, ((a, b), r)): (usize, ((&f64, &f64), &f64))| {
                (4.0 * difference(i, a - r) - difference(i, b - r)) / (2.0 * h)
            };
            Some(zip(zip(&ahead, &further), residuals).enumerate().map(one_sided).collect())
        };
        let by_kappa = by(kappa, &|kappa| [kappa, zeta])?;
        let by_zeta = by(zeta, &|zeta| [kappa, zeta])?;
        Some(zip(by_kappa, by_zeta).map(|(a, b)| [a, b]).collect())
    }
}

/// The residuals that count, and how much.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rule<'a> {
    /// The smaller residuals of the amplitudes and of the phases; [`kept`] gives their numbers.
    Trimmed,
    /// Each residual with its weight.
    Weighted(&'a [f64]),
}

/// The number of n values that a trimmed sum keeps: all if there are few, and otherwise 7 of 10, so that the
/// rest do not move the fit.
pub(super) fn kept(n: usize) -> usize {
    if n <= 6 { n } else { (0.7 * n as f64).ceil() as usize }
}

impl Rule<'_> {
    fn weights(self, curve: &ResponseCurve<'_>, residuals: &[f64]) -> Vec<f64> {
        if let Rule::Weighted(weights) = self {
            return weights.to_vec();
        }
        let (amplitudes, phases) = residuals.split_at(curve.points.len().min(residuals.len()));
        let smaller = |group: &[f64]| -> Vec<f64> {
            let mut sizes: Vec<f64> = group.iter().map(|r| r.abs()).collect();
            sizes.sort_by(f64::total_cmp);
            let greatest = sizes.get(kept(group.len()).saturating_sub(1)).copied().unwrap_or(f64::INFINITY);
            group.iter().map(|r| f64::from(u8::from(r.abs() <= greatest))).collect()
        };
        [smaller(amplitudes), smaller(phases)].concat()
    }
}

/// A point of the search.
#[derive(Debug, Clone)]
pub(super) struct CurveFit {
    pub(super) at: Parameters,
    pub(super) residuals: Vec<f64>,
    pub(super) weights: Vec<f64>,
    /// The weighted sum of squares.
    pub(super) sum: f64,
}

impl CurveFit {
    fn of(curve: &ResponseCurve<'_>, rule: Rule<'_>, at: Parameters, residuals: Vec<f64>) -> Self {
        let weights = rule.weights(curve, &residuals);
        let sum = zip(&residuals, &weights).map(|(r, w)| w * r * r).sum();
        Self { at, residuals, weights, sum }
    }

    fn new(curve: &ResponseCurve<'_>, rule: Rule<'_>, at: Parameters) -> Option<Self> {
        curve.residuals_at(at).map(|residuals| Self::of(curve, rule, at, residuals))
    }

    /// The normal equations at this point.
    pub(super) fn normal(&self, slopes: &[[f64; 2]]) -> Normal {
        let mut n = Normal::default();
        for ((r, w), [by_kappa, by_zeta]) in zip(zip(&self.residuals, &self.weights), slopes) {
            let ([g, h], [a, b, c]) = (n.gradient, n.matrix);
            n.gradient = [g + w * r * by_kappa, h + w * r * by_zeta];
            n.matrix = [a + w * by_kappa * by_kappa, b + w * by_kappa * by_zeta, c + w * by_zeta * by_zeta];
        }
        n
    }
}

/// Half the gradient of the sum of squares, and the normal matrix (κκ, κζ, ζζ).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Normal {
    pub(super) gradient: [f64; 2],
    pub(super) matrix: [f64; 3],
}

impl Normal {
    /// The inverse of the matrix, if the derivatives with respect to the two parameters differ in direction.
    pub(super) fn inverse(&self) -> Option<[f64; 3]> {
        let [a, b, c] = self.matrix;
        let determinant = a * c - b * b;
        // The least sin² of the angle between the derivatives, above the rounding of differences.
        let is_regular = determinant > 1e-12 * a * c;
        is_regular.then(|| [c / determinant, -b / determinant, a / determinant])
    }

    /// The inverse for the parameters that are not at an end of their range.
    pub(super) fn inverse_within(&self, at: Parameters) -> Option<[f64; 3]> {
        let ([a, _, c], [kappa_is_free, zeta_is_free]) = (self.matrix, free(at, self.gradient));
        match (kappa_is_free, zeta_is_free) {
            (true, true) => self.inverse(),
            (true, false) => Some([1.0 / a, 0.0, 0.0]),
            (false, true) => Some([0.0, 0.0, 1.0 / c]),
            (false, false) => Some([0.0; 3]),
        }
    }

    /// The decrease of the sum that the linear model predicts from a point to another.
    fn gain(&self, from: Parameters, to: Parameters) -> f64 {
        let ([g, h], [a, b, c]) = (self.gradient, self.matrix);
        let (x, y) = (to[0] - from[0], to[1] - from[1]);
        -(2.0 * (g * x + h * y) + a * x * x + 2.0 * b * x * y + c * y * y)
    }

    /// The step of Levenberg and Marquardt from a point of the range, within the range to first order.
    fn step(&self, at: Parameters, damping: f64) -> Parameters {
        let ([g, h], [a, b, c]) = (self.gradient, self.matrix);
        let (p, q) = (a * (1.0 + damping), c * (1.0 + damping));
        let [kappa_is_free, zeta_is_free] = free(at, self.gradient);
        let alone = |gradient: f64, square: f64| if square > 0.0 { -gradient / square } else { 0.0 };
        match (kappa_is_free, zeta_is_free) {
            (true, true) => {
                let determinant = p * q - b * b;
                if determinant > 1e-14 * p * q {
                    return [(b * h - q * g) / determinant, (b * g - p * h) / determinant];
                }
                [alone(g, p), 0.0]
            }
            (true, false) => [alone(g, p), 0.0],
            (false, true) => [0.0, alone(h, q)],
            (false, false) => [0.0, 0.0],
        }
    }
}

/// Whether each parameter may move against the gradient.
fn free([kappa, zeta]: Parameters, [g, h]: [f64; 2]) -> [bool; 2] {
    let one = |x: f64, gradient: f64, (low, high): (f64, f64)| {
        !((x <= low && gradient >= 0.0) || (x >= high && gradient <= 0.0))
    };
    let [of_kappa, of_zeta] = RANGE;
    [one(kappa, g, of_kappa), one(zeta, h, of_zeta)]
}

/// The point after a step, within the range.
fn moved([kappa, zeta]: Parameters, [x, y]: [f64; 2]) -> Parameters {
    let [(least_kappa, most_kappa), (least_zeta, most_zeta)] = RANGE;
    [(kappa + x).clamp(least_kappa, most_kappa), (zeta + y).clamp(least_zeta, most_zeta)]
}

/// A curve and the residuals of it that count.
struct Counted<'a> {
    curve: &'a ResponseCurve<'a>,
    rule: Rule<'a>,
}

impl Squares for Counted<'_> {
    type Point = CurveFit;
    type Normal = Normal;

    fn sum(&self, fit: &CurveFit) -> f64 {
        fit.sum
    }

    fn normal(&self, fit: &CurveFit) -> Option<Normal> {
        Some(fit.normal(&self.curve.slopes(fit.at, &fit.residuals)?))
    }

    fn moved(&self, fit: &CurveFit, normal: &Normal, damping: f64) -> Option<CurveFit> {
        CurveFit::new(self.curve, self.rule, moved(fit.at, normal.step(fit.at, damping)))
    }

    fn gain(&self, normal: &Normal, from: &CurveFit, to: Option<&CurveFit>) -> f64 {
        match to {
            Some(to) => normal.gain(from.at, to.at),
            None => normal.gain([0.0; 2], normal.step(from.at, 0.0)),
        }
    }

    fn least_gain(&self, fit: &CurveFit) -> f64 {
        1e-13 * fit.sum + 1e-28 * fit.residuals.len() as f64
    }

    fn beside(&self, fit: &CurveFit, normal: &Normal) -> Option<CurveFit> {
        around(self.curve, self.rule, fit, normal)
    }
}

/// A minimum found from a start, with a search along eight directions where no step gains: at a kink. A motion
/// that begins to stop, and a trimmed sum that changes its selection, make kinks.
///
/// # Errors
/// [`Error::NotIdentified`] where the steps do not suffice.
pub(super) fn descend(
    curve: &ResponseCurve<'_>,
    rule: Rule<'_>,
    start: Parameters,
) -> Result<CurveFit, Error> {
    let start = CurveFit::new(curve, rule, start).ok_or(Error::NotIdentified)?;
    match least_squares::descend(&Counted { curve, rule }, start) {
        Some((fit, true)) => Ok(fit),
        Some((_, false)) | None => Err(Error::NotIdentified),
    }
}

/// A better point near one, along eight directions of the ellipse of equal sums, down to a ten-thousandth of
/// its size.
fn around(curve: &ResponseCurve<'_>, rule: Rule<'_>, here: &CurveFit, normal: &Normal) -> Option<CurveFit> {
    let [a, b, c] = normal.matrix;
    let rest = c - b * b / a;
    if !(a > 0.0 && rest > 0.0) {
        return None;
    }
    // The columns of the inverse root of the matrix, of the length of one standard error.
    let noise = (here.sum / here.residuals.len() as f64).sqrt();
    let (first, second) = (noise / a.sqrt(), noise / rest.sqrt());
    let mut size = 1.0;
    while size > 1e-4 {
        for (x, y) in [
            (1.0, 0.0),
            (-1.0, 0.0),
            (0.0, 1.0),
            (0.0, -1.0),
            (0.7, 0.7),
            (-0.7, 0.7),
            (0.7, -0.7),
            (-0.7, -0.7),
        ] {
            let step = [size * (x * first - y * second * b / a), size * y * second];
            let there = CurveFit::new(curve, rule, moved(here.at, step));
            if let Some(there) = there.filter(|there| there.sum < here.sum * (1.0 - 1e-9)) {
                return Some(there);
            }
        }
        size *= 0.25;
    }
    None
}

/// The motions over the grid of starts, by friction and by damping, which all readings of one curve share.
pub(super) struct StartGrid(Vec<Vec<Option<Vec<ModelMotion>>>>);

impl StartGrid {
    pub(super) fn of(curve: &ResponseCurve<'_>) -> Self {
        let row = |&kappa: &f64| DAMPINGS.iter().map(|&zeta| curve.motions([kappa, zeta])).collect();
        Self(FRICTIONS.iter().map(row).collect())
    }

    /// The minima found from a number of starts, the best of the grid.
    pub(super) fn minima(&self, curve: &ResponseCurve<'_>, rule: Rule<'_>, most: usize) -> Vec<CurveFit> {
        let sum = |motions: &Option<Vec<ModelMotion>>| {
            let of = |motions: &Vec<ModelMotion>| {
                CurveFit::of(curve, rule, [0.0; 2], curve.residuals(motions)).sum
            };
            motions.as_ref().map_or(f64::INFINITY, of)
        };
        let sums: Vec<Vec<f64>> = self.0.iter().map(|row| row.iter().map(sum).collect()).collect();
        let mut starts: Vec<(f64, Parameters)> = Vec::new();
        for (i, (row, kappa)) in zip(&sums, FRICTIONS).enumerate() {
            for (j, (&sum, zeta)) in zip(row, DAMPINGS).enumerate() {
                // No neighbour, of up to eight, is better.
                let neighbours = sums.iter().take(i.saturating_add(2)).skip(i.saturating_sub(1));
                let mut neighbours =
                    neighbours.flat_map(|row| row.iter().take(j.saturating_add(2)).skip(j.saturating_sub(1)));
                if sum.is_finite() && neighbours.all(|other| sum <= *other) {
                    starts.push((sum, [kappa, zeta]));
                }
            }
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.iter().take(most).filter_map(|(_, at)| descend(curve, rule, *at).ok()).collect()
    }

    /// The least of these minima.
    ///
    /// # Errors
    /// As for [`descend`], where none of the starts leads to a minimum.
    pub(super) fn best(
        &self,
        curve: &ResponseCurve<'_>,
        rule: Rule<'_>,
        most: usize,
    ) -> Result<CurveFit, Error> {
        let found = self.minima(curve, rule, most).into_iter();
        found.min_by(|a, b| a.sum.total_cmp(&b.sum)).ok_or(Error::NotIdentified)
    }
}
