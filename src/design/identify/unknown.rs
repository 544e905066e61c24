//! The fit with the natural frequency or the amplitude of the force unknown, too.
//!
//! Either one, θ its logarithm, scales the measurements: Ω and the amplitudes in p₀/k. At each θ friction and damping are those
//! of the fit of all other curves (`outliers`), and θ is the one with the least misfit. It is found by the steps of Gauss and
//! Newton in (κ, ζ, θ), from a number of starts.

use super::fit::Spring;
use super::model::Parameters;
use super::outliers::{Judged, judge};
use super::search::{MeasuredPoint, ResponseCurve, Rule, StartGrid, descend, reduced};
use super::valleys::{Levels, ROUNDS, STEP, searched};
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

    /// The friction, ζ, and the natural frequency or the force, with their derivatives by (κ, ζ, θ).
    fn quantities(&self, [kappa, zeta, theta]: [f64; 3]) -> [(f64, [f64; 3]); 3] {
        let value = theta.exp();
        let friction = match *self {
            Self::Natural { force, .. } => (kappa * force, [force, 0.0, 0.0]),
            Self::Force { .. } => (kappa * value, [value, 0.0, kappa * value]),
        };
        [friction, (zeta, [0.0, 1.0, 0.0]), (value, [0.0, 0.0, value])]
    }

    fn points(&self, curve: &[Measurement], theta: f64) -> Result<Vec<MeasuredPoint>, Error> {
        let (body, force) = self.at(theta)?;
        let body = Spring::Of(body);
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

impl At {
    fn place(&self) -> [f64; 3] {
        let [kappa, zeta] = self.judged.fit.at;
        [kappa, zeta, self.theta]
    }

    /// The number of values that count.
    fn counted(&self) -> f64 {
        self.judged.suspect.iter().filter(|is_suspect| !**is_suspect).count() as f64
    }

    fn degrees_of_freedom(&self) -> f64 {
        (self.counted() - 3.0).max(1.0)
    }

    /// The variance in units of the noise, which was estimated with two parameters fitted.
    fn inflated(&self) -> f64 {
        (self.counted() - 2.0).max(1.0) / self.degrees_of_freedom()
    }
}

/// The fits at other θ.
struct Profile {
    /// Of friction, ζ and the unknown, at the fit.
    covariance: [[f64; 3]; 3],
    /// The least and the greatest of them with a sum that is alike.
    hull: [(f64, f64); 3],
    /// Places with sums below that of the fit.
    lower: Vec<(f64, Parameters)>,
    /// Whether the search came to its end.
    is_whole: bool,
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
        let slopes = curve.slopes(at.judged.fit.at, &at.judged.fit.residuals)?;
        let shifted = |theta: f64| {
            let points = self.scaled.points(self.curve, theta).ok()?;
            ResponseCurve::of(&points, self.reading.amplitude, self.phase).residuals_at(at.judged.fit.at)
        };
        let (ahead, behind) = (shifted(at.theta + STEP)?, shifted(at.theta - STEP)?);
        let counts = curve.counts();
        let (mut gradient, mut matrix) = ([0.0; 3], vec![vec![0.0; 3]; 3]);
        let rows = zip(zip(&at.judged.fit.residuals, &at.judged.suspect), zip(slopes, zip(ahead, behind)));
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

    /// The covariance of friction, ζ and the unknown at a fit.
    fn covariance(&self, at: &At) -> Option<[[f64; 3]; 3]> {
        let (_, matrix) = self.normal(at)?;
        let inverse = inverse(&matrix)?;
        let slopes = self.scaled.quantities(at.place()).map(|(_, slopes)| slopes);
        let product = |a: &[f64], b: &[f64]| zip(a, b).map(|(a, b)| a * b).sum::<f64>();
        let times =
            slopes.map(|slopes| -> Vec<f64> { inverse.iter().map(|row| product(row, &slopes)).collect() });
        Some(slopes.map(|a| times.each_ref().map(|b| at.inflated() * product(&a, b))))
    }

    /// The best fit found from one on: where a profile over θ shows a lower one, from there.
    fn lowest(&self, mut at: At) -> Option<(At, Profile)> {
        for round in 1.. {
            let profile = self.profile(&at)?;
            let lower = profile.lower.iter().filter_map(|(theta, start)| self.fit(*theta, Some(*start)).ok());
            let best = lower.map(|there| self.refined(there)).min_by(|a, b| a.misfit.total_cmp(&b.misfit));
            match best.filter(|there| there.misfit < at.misfit - LOWER) {
                Some(lower) if round < ROUNDS => at = lower,
                lower => {
                    return Some((at, Profile { is_whole: profile.is_whole && lower.is_none(), ..profile }));
                }
            }
        }
        None
    }

    /// The least sums of squares at other θ, of the values that count at a fit and with their weights, in small steps as far as
    /// they are followed.
    fn profile(&self, at: &At) -> Option<Profile> {
        let covariance = self.covariance(at)?;
        let [.., (_, [.., slope])] = self.scaled.quantities(at.place());
        let error = covariance[2][2].sqrt() / slope;
        let variance = at.inflated() * at.judged.noise[0].powi(2);
        let levels = Levels::above(at.judged.fit.sum, variance, at.degrees_of_freedom());
        let hull = self.scaled.quantities(at.place()).map(|(value, _)| (value, value));
        let mut profile = Profile { covariance, hull, lower: Vec::new(), is_whole: error.is_finite() };
        for side in [-error, error] {
            let (mut theta, mut step) = (at.theta, STEP);
            let mut judged = at.judged.clone();
            let mut count = 0_u32;
            while step >= SMALLEST {
                let next = theta + step * side;
                let there = self.beside(&judged, next, levels, &mut profile);
                match there.filter(|judged| judged.fit.sum <= levels.followed) {
                    Some(there) if count < MOST => {
                        (theta, judged) = (next, there);
                        count = count.saturating_add(1);
                    }
                    Some(_) => {
                        profile.is_whole = false;
                        break;
                    }
                    None => step *= 0.5,
                }
            }
        }
        Some(profile)
    }

    /// The least sum of squares at θ from a fit near it, whose region is added to the profile.
    fn beside(&self, near: &Judged, theta: f64, levels: Levels, profile: &mut Profile) -> Option<Judged> {
        let points = self.scaled.points(self.curve, theta).ok()?;
        let curve = ResponseCurve::of(&points, self.reading.amplitude, self.phase);
        let fit = descend(&curve, Rule::Weighted(&near.fit.weights), near.fit.at).ok()?;
        let found = near.moved(&curve, fit)?;
        let (lower, region) = searched(&curve, &found, Vec::new(), levels)?;
        profile.is_whole &= region.is_whole;
        if let Some([kappa, zeta]) = region.hull {
            for place in [[kappa.0, zeta.0, theta], [kappa.1, zeta.1, theta]] {
                for ((low, high), (value, _)) in zip(&mut profile.hull, self.scaled.quantities(place)) {
                    (*low, *high) = (low.min(value), high.max(value));
                }
            }
        }
        let found = lower.and_then(|lower| near.moved(&curve, lower)).unwrap_or(found);
        if found.fit.sum < levels.least {
            profile.lower.push((theta, found.fit.at));
        }
        Some(found)
    }

    /// The least misfit from a fit on.
    fn refined(&self, mut at: At) -> At {
        for _ in 0..STEPS {
            let Some((gradient, mut matrix)) = self.normal(&at) else { break };
            // A parameter at the end of its range stays there.
            let [kappa, zeta] = at.judged.fit.at;
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
                    .fit(at.theta + step, Some(at.judged.fit.at))
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

/// The smallest step with which the end of a profile is found, in standard errors, and the greatest number of steps on a side.
const SMALLEST: f64 = 0.05;
const MOST: u32 = 64;
/// The decrease of the misfit that counts.
const LOWER: f64 = 1e-9;
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
        whole.refined(whole.fit(best.theta, Some(best.judged.fit.at))?)
    };
    let (best, profile) = whole.lowest(best).ok_or(Error::NotIdentified)?;
    let (body, force) = scaled.at(best.theta)?;
    let mut identified = identified(&Spring::Of(body), force, curve, reading)?;
    let greatest = if matches!(scaled, Scaled::Force { .. }) { f64::INFINITY } else { force };
    let ranges = [greatest, f64::INFINITY, f64::INFINITY];
    let values = zip(zip(scaled.quantities(best.place()), profile.hull), zip(profile.covariance, ranges));
    let mut estimates = values.enumerate().map(|(i, (((value, _), hull), (row, greatest)))| Estimate {
        value,
        standard_error: row.get(i).map_or(f64::NAN, |variance| variance.max(0.0).sqrt()),
        degrees_of_freedom: best.degrees_of_freedom(),
        range: (0.0, greatest),
        alike: Some(hull),
    });
    let mut next = || estimates.next().ok_or(Error::NotIdentified);
    identified.friction_bound = next()?;
    identified.damping_ratio = next()?;
    match scaled {
        Scaled::Natural { .. } => identified.natural_frequency = Some(next()?),
        Scaled::Force { .. } => identified.force = Some(next()?),
    }
    identified.search_is_complete &= profile.is_whole;
    Ok(identified)
}
