//! The fit with the natural frequency or the amplitude of the force unknown, too.
//!
//! Either one, θ its logarithm, scales the measurements: Ω and the amplitudes in p₀/k. At each θ friction and damping are those
//! of the fit of all other curves (`outliers`), and θ is the one with the least misfit. It is found by the steps of Gauss and
//! Newton in (κ, ζ, θ), from a number of starts.

use super::model::Parameters;
use super::outliers::{Judged, judge};
use super::search::{MeasuredPoint, ResponseCurve, Rule, StartGrid, reduced};
use super::{Identified, Measurement, PhaseKind, Reading, identified, in_ratios, sample};
use crate::design::least_squares::inverse;
use crate::machine::error::Error;
use crate::machine::oscillator::Oscillator;
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// What is known of the machine besides its friction and its damping.
#[derive(Debug, Clone, Copy)]
pub(super) enum Scaled {
    /// Mass and force; e^θ is ω_n.
    Natural { mass: f64, force: f64 },
    /// The body; e^θ is p₀.
    Force { body: Oscillator<f64> },
}

impl Scaled {
    /// The body and the force at θ.
    fn at(&self, theta: f64) -> Result<(Oscillator<f64>, f64), Error> {
        match *self {
            Self::Natural { mass, force } => {
                Ok((Oscillator::new(mass, mass * (2.0 * theta).exp(), 1.0)?, force))
            }
            Self::Force { body } => Ok((body, theta.exp())),
        }
    }

    fn points(&self, curve: &[Measurement], theta: f64) -> Result<Vec<MeasuredPoint>, Error> {
        let (body, force) = self.at(theta)?;
        let point = |(index, measured): (usize, &Measurement)| {
            in_ratios(&body, force, measured).map_err(|e| Error::InMeasurement { index, error: Box::new(e) })
        };
        curve.iter().enumerate().map(point).collect()
    }

    /// Starts: the natural frequency beside the greatest amplitude and beyond the ends of the curve; the force that gives the
    /// median amplitude without friction, and more.
    fn starts(&self, curve: &[Measurement]) -> Vec<f64> {
        match self {
            Self::Natural { .. } => {
                let peak = curve.iter().max_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
                let peak = peak.map_or(1.0, |peak| peak.angular_frequency);
                let least = curve.iter().map(|m| m.angular_frequency).fold(f64::INFINITY, f64::min);
                let most = curve.iter().map(|m| m.angular_frequency).fold(0.0, f64::max);
                let beside = [0.8, 0.9, 0.95, 0.98, 1.0, 1.02, 1.05, 1.1, 1.25].map(|share| peak * share);
                let beyond = [least / 2.0, least / 1.3, most * 1.3, most * 2.0];
                beside.into_iter().chain(beyond).map(f64::ln).collect()
            }
            Self::Force { body } => {
                let natural = body.natural_frequency();
                let of = |m: &Measurement| {
                    let omega = m.angular_frequency / natural;
                    m.amplitude * body.stiffness() * (1.0 - omega * omega).hypot(0.04 * omega)
                };
                let mut forces: Vec<f64> = curve.iter().map(of).collect();
                forces.sort_by(f64::total_cmp);
                let median = forces.get(forces.len() / 2).copied().unwrap_or(1.0);
                [0.8, 1.0, 1.15, 1.4, 1.8, 2.5, 4.0].map(|share| (median * share).ln()).to_vec()
            }
        }
    }
}

/// A fit at one θ.
struct At {
    theta: f64,
    judged: Judged,
    misfit: f64,
}

/// The search for θ over one reading of a curve.
struct ScaleSearch<'a> {
    scaled: Scaled,
    curve: &'a [Measurement],
    reading: Reading,
    phase: PhaseKind,
}

impl ScaleSearch<'_> {
    /// The fit at θ, from a start or from the grid of starts.
    fn fit(&self, theta: f64, start: Option<Parameters>) -> Result<At, Error> {
        let points = self.scaled.points(self.curve, theta)?;
        let curve = ResponseCurve::of(&points, self.reading.amplitude, self.phase);
        let judged = match start {
            Some(start) => judge(&curve, start, None)?,
            None => {
                let grid = StartGrid::of(&curve);
                let trimmed = grid.best(&curve, Rule::Trimmed, 2)?;
                judge(&curve, trimmed.at, Some(&grid))?
            }
        };
        let misfit = judged.misfit(curve.counts());
        Ok(At { theta, judged, misfit })
    }

    /// Gradient and matrix of the sum of squares by (κ, ζ, θ), in units of the noise, of the values that count.
    fn normal(&self, at: &At) -> Option<([f64; 3], Vec<Vec<f64>>)> {
        const STEP: f64 = 1e-5;
        let points = self.scaled.points(self.curve, at.theta).ok()?;
        let curve = ResponseCurve::of(&points, self.reading.amplitude, self.phase);
        let slopes = curve.slopes(at.judged.at, &at.judged.residuals)?;
        let shifted = |theta: f64| {
            let points = self.scaled.points(self.curve, theta).ok()?;
            ResponseCurve::of(&points, self.reading.amplitude, self.phase).residuals_at(at.judged.at)
        };
        let (ahead, behind) = (shifted(at.theta + STEP)?, shifted(at.theta - STEP)?);
        let counts = curve.counts();
        let (mut gradient, mut matrix) = ([0.0; 3], vec![vec![0.0; 3]; 3]);
        let rows = zip(zip(&at.judged.residuals, &at.judged.suspect), zip(slopes, zip(ahead, behind)));
        for (i, ((residual, is_suspect), ([by_kappa, by_zeta], (ahead, behind)))) in rows.enumerate() {
            if *is_suspect {
                continue;
            }
            let is_amplitude = i < counts[0];
            let change = if is_amplitude { ahead - behind } else { reduced(ahead - behind) };
            let [amplitude, phase] = at.judged.noise;
            let noise = if is_amplitude { amplitude } else { phase };
            let row = [by_kappa, by_zeta, change / (2.0 * STEP)].map(|slope| slope / noise);
            for ((sum, line), a) in zip(zip(&mut gradient, &mut matrix), row) {
                *sum += a * residual / noise;
                for (cell, b) in zip(line, row) {
                    *cell += a * b;
                }
            }
        }
        Some((gradient, matrix))
    }

    /// The least misfit from a fit on.
    fn refined(&self, mut at: At) -> At {
        for _ in 0..STEPS {
            let Some((gradient, mut matrix)) = self.normal(&at) else { break };
            // A parameter at the end of its range stays there.
            let [kappa, zeta] = at.judged.at;
            for (i, (x, end)) in [(kappa, 0.0), (zeta, 0.0)].into_iter().enumerate() {
                if x <= end {
                    for (j, line) in matrix.iter_mut().enumerate() {
                        for (k, cell) in line.iter_mut().enumerate() {
                            if i == j || i == k {
                                *cell = f64::from(u8::from(j == k));
                            }
                        }
                    }
                }
            }
            let Some(inverse) = inverse(&matrix) else { break };
            let Some(last) = inverse.last() else { break };
            let mut step = -zip(last, gradient).map(|(a, b)| a * b).sum::<f64>();
            step = step.clamp(-FARTHEST, FARTHEST);
            let mut better = None;
            while step.abs() > 1e-12 && better.is_none() {
                better = self
                    .fit(at.theta + step, Some(at.judged.at))
                    .ok()
                    .filter(|there| there.misfit < at.misfit - 1e-9);
                step /= 4.0;
            }
            match better {
                Some(there) => at = there,
                None => break,
            }
        }
        at
    }
}

/// The greatest number of steps.
const STEPS: usize = 40;
/// The greatest step of θ.
const FARTHEST: f64 = 0.05;
/// The number of starts from which the least misfit is sought.
const REFINED: usize = 3;

/// The fit with the unknown of `scaled`.
pub(super) fn fitted(scaled: Scaled, curve: &[Measurement], reading: Reading) -> Result<Identified, Error> {
    if curve.len() < 4 {
        return Err(Error::TooFewMeasurements { count: curve.len() });
    }
    let first = scaled.starts(curve).into_iter().next().unwrap_or(0.0);
    let _ = scaled.points(curve, first)?;
    let phase = reading.phase.unwrap_or(PhaseKind::Peak);
    let reading = Reading { phase: curve.iter().any(|m| m.phase.is_some()).then_some(phase), ..reading };
    let some = sample(curve);
    let search = ScaleSearch { scaled, curve: &some, reading, phase };
    let mut found: Vec<At> =
        scaled.starts(curve).into_iter().filter_map(|theta| search.fit(theta, None).ok()).collect();
    found.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
    let best = found.into_iter().take(REFINED).map(|at| search.refined(at));
    let best = best.min_by(|a, b| a.misfit.total_cmp(&b.misfit)).ok_or(Error::NotIdentified)?;
    let whole = ScaleSearch { curve, ..search };
    let best = if some.len() == curve.len() {
        best
    } else {
        whole.refined(whole.fit(best.theta, Some(best.judged.at))?)
    };
    let (body, force) = scaled.at(best.theta)?;
    let mut identified = identified(&body, force, curve, reading)?;
    let (_, matrix) = whole.normal(&best).ok_or(Error::NotIdentified)?;
    // The noise was estimated with two parameters fitted.
    let counted = best.judged.suspect.iter().filter(|is_suspect| !**is_suspect).count() as f64;
    let degrees_of_freedom = (counted - 3.0).max(1.0);
    let inflated = (counted - 2.0).max(1.0) / degrees_of_freedom;
    let covariance = inverse(&matrix).ok_or(Error::NotIdentified)?;
    let of =
        |i: usize, j: usize| covariance.get(i).and_then(|row| row.get(j)).map_or(f64::NAN, |x| x * inflated);
    let (of_kappa, of_zeta, of_theta, both) = (of(0, 0), of(1, 1), of(2, 2), of(0, 2));
    let [kappa, zeta] = best.judged.at;
    let of_friction = match scaled {
        Scaled::Natural { .. } => of_kappa,
        Scaled::Force { .. } => of_kappa + 2.0 * kappa * both + kappa * kappa * of_theta,
    };
    let estimate = |value: f64, variance: f64, range: (f64, f64)| Estimate {
        value,
        standard_error: variance.max(0.0).sqrt(),
        degrees_of_freedom,
        range,
    };
    let ranges = (identified.friction_bound.range, identified.damping_ratio.range);
    let greatest = if matches!(scaled, Scaled::Force { .. }) { f64::INFINITY } else { ranges.0.1 };
    identified.friction_bound = estimate(kappa * force, of_friction * force * force, (0.0, greatest));
    identified.damping_ratio = estimate(zeta, of_zeta, ranges.1);
    let value = best.theta.exp();
    let scale = Some(estimate(value, of_theta * value * value, (0.0, f64::INFINITY)));
    match scaled {
        Scaled::Natural { .. } => identified.natural_frequency = scale,
        Scaled::Force { .. } => identified.force = scale,
    }
    Ok(identified)
}
