//! Friction and damping from a measured response curve, by least squares on the closed forms.
//!
//! With known mass, stiffness and force amplitude, the maximum displacement at a frequency is, in the symbols
//! of `docs/theory/damping.md` and with κ = r_y/p₀,
//!
//! ```text
//! Δ₀ = (p₀/k) [√(1 − κ²K²)/q − κG],   ω_d t₂ = δ + atan2(√(1 − κ²K²), κK):
//! ```
//!
//! These are smooth in κ and in ζ (G, K, q and δ depend on ζ). κ and ζ are found by the method of Levenberg
//! and Marquardt, with derivatives by dual numbers. For two parameters the normal equations are 2 by 2, so
//! that no linear algebra is needed.
//!
//! Only cycles that do not stick follow these formulae. A measurement at which the body would stick with the
//! parameters found is omitted and the rest is fitted again, until the selection does not change.

use crate::error::{Error, Quantity};
use crate::float::Real;
use crate::float::{Field, dual::Dual};
use crate::nonsticking::damped;
use crate::oscillator::{Drive, Excitation, Oscillator};
use crate::ratios::{Ratios, finite, positive};
use crate::uncertainty::Estimate;

/// One point of a measured response curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Measurement {
    /// Angular frequency ω_d.
    pub angular_frequency: f64,
    /// Maximum displacement, half of peak to peak.
    pub amplitude: f64,
    /// Phase ω_d t₂ of the maximum displacement, if it was measured: radians behind that of the force at ω_d
    /// t = 0.
    pub phase: Option<f64>,
}

/// Friction and damping estimated from a measured response curve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
#[must_use]
pub struct Identified {
    /// The friction bound r_y.
    pub friction_bound: Estimate,
    /// The damping ratio ζ; `c = 2ζ√(k m)`.
    pub damping_ratio: Estimate,
    /// The standard error of one measurement, estimated from the residuals: relative for an amplitude, in
    /// radians for a phase.
    pub noise: f64,
    /// Measured minus computed amplitude, relative to the measured one; `None` if the body sticks and the
    /// measurement was omitted.
    pub residuals: Vec<Option<f64>>,
}

/// The friction bound and the damping ratio that fit a response curve of `body` under a force of amplitude
/// p₀.
///
/// Mass and stiffness are those of `body`; its own friction bound and damping play no part. Errors of the
/// amplitudes count as relative, errors of the phases in radians, both with the same standard deviation,
/// which the residuals give.
///
/// The answer is the least sum of squares found by a descent from the best point of a grid of κ and ζ. It is
/// not proved to be the global minimum.
///
/// # Errors
/// Where a measurement is not finite or not > 0, where fewer than three measurements are of a cycle that does
/// not stick ([`Error::TooFewMeasurements`]), and where the search does not settle
/// ([`Error::NotIdentified`]).
pub fn identify(body: &Oscillator<f64>, force: f64, curve: &[Measurement]) -> Result<Identified, Error> {
    body.with_one_friction()?;
    let (force, natural) = (positive(Quantity::ForceAmplitude, force)?, body.natural_frequency());
    let mut points = Vec::with_capacity(curve.len());
    for measured in curve {
        let drive = Drive::new(Excitation::Force, force, measured.angular_frequency)?;
        let omega = Ratios::new(drive.angular_frequency() / natural, 1.0)?.omega();
        let amplitude = positive(Quantity::MaxDisplacement, measured.amplitude)? * body.stiffness() / force;
        let phase = measured.phase.map(|phase| finite(Quantity::DrivePhase, phase)).transpose()?;
        points.push(Point { omega, amplitude, phase });
    }
    let mut parameters = best_of_grid(&points)?;
    let mut used: Vec<bool> = Vec::new();
    for _ in 0..ROUNDS {
        let slides: Vec<bool> = points.iter().map(|p| p.slides(parameters)).collect();
        let count = slides.iter().filter(|&&slides| slides).count();
        if count < 3 {
            return Err(Error::TooFewMeasurements { count, of: points.len() });
        }
        if slides == used {
            let [a, b, c] = normal(&points, &used, parameters).matrix;
            // At one frequency, many pairs of friction and damping give the same amplitude.
            if a * c - b * b <= LEAST_ANGLE * a * c {
                return Err(Error::NotIdentified);
            }
            return Ok(report(&points, &used, parameters, force));
        }
        used = slides;
        parameters = descend(&points, &used, parameters)?;
    }
    Err(Error::NotIdentified)
}

/// The greatest number of selections of measurements.
const ROUNDS: usize = 50;
/// The least sin² of the angle between the derivatives with respect to the two parameters; below it the
/// measurements cannot separate them.
const LEAST_ANGLE: f64 = 1e-12;
/// The greatest number of steps of a descent.
const STEPS: usize = 200;
/// The least damping ratio that is distinguished from zero.
const LEAST_DAMPING: f64 = 1e-9;

/// κ = r_y/p₀ and ζ.
type Parameters = [f64; 2];

/// One measurement in ratios: Ω, k Δ₀/p₀ and ω_d t₂.
#[derive(Debug, Clone, Copy)]
struct Point {
    omega: f64,
    amplitude: f64,
    phase: Option<f64>,
}

/// A residual and its derivatives with respect to κ and ζ.
type Residual = (f64, [f64; 2]);

impl Point {
    /// Whether the body slides throughout at this point with these parameters.
    fn slides(&self, [kappa, zeta]: Parameters) -> bool {
        let alpha = 1.0 / kappa;
        let Ok(ratios) = Ratios::new(self.omega, alpha).and_then(|r| r.with_damping_ratio(zeta)) else {
            return false;
        };
        alpha >= damped::border(&damped::half_period(&ratios)).min_force_ratio
    }

    /// The residuals of amplitude and phase, relative and in radians.
    fn residuals(&self, parameters: Parameters) -> [Option<Residual>; 2] {
        let [kappa, zeta] = Dual::parameters(parameters);
        let half = damped::half_period_at(Dual::of(self.omega), zeta);
        let (one, friction) = (Dual::of(1.0), kappa * half.k);
        // √(1 − κ²K²)
        let sine = ((one - friction) * (one + friction)).sqrt();
        let found = sine / half.stiffness - kappa * half.shift;
        let as_residual = |x: Dual<2>| (x.value(), x.derivatives());
        let of_phase = self.phase.map(|measured| {
            let difference = Dual::of(measured) - half.phase_lag() - sine.atan2(friction);
            // The same angle, reduced to half a turn.
            let (s, c) = difference.sin_cos();
            as_residual(s.atan2(c))
        });
        let of_amplitude = as_residual((Dual::of(self.amplitude) - found) / Dual::of(self.amplitude));
        [Some(of_amplitude), of_phase]
    }
}

/// Sum of squares, gradient and normal matrix (κκ, κζ, ζζ) of the chosen points, and the number of residuals.
struct Normal {
    sum: f64,
    gradient: [f64; 2],
    matrix: [f64; 3],
    count: usize,
}

fn normal(points: &[Point], used: &[bool], parameters: Parameters) -> Normal {
    let mut n = Normal { sum: 0.0, gradient: [0.0; 2], matrix: [0.0; 3], count: 0 };
    let chosen = points.iter().zip(used).filter(|(_, used)| **used);
    for (r, [by_kappa, by_zeta]) in chosen.flat_map(|(p, _)| p.residuals(parameters)).flatten() {
        n.sum += r * r;
        n.gradient = [n.gradient[0] + r * by_kappa, n.gradient[1] + r * by_zeta];
        let [a, b, c] = n.matrix;
        n.matrix = [a + by_kappa * by_kappa, b + by_kappa * by_zeta, c + by_zeta * by_zeta];
        n.count = n.count.saturating_add(1);
    }
    n
}

/// The best point of a grid, among those at which most measurements slide.
fn best_of_grid(points: &[Point]) -> Result<Parameters, Error> {
    let mut best: Option<(usize, f64, Parameters)> = None;
    for i in 0..10 {
        for j in 0..6 {
            // κ between 0.01 and 0.63, ζ between 1e-4 and 3.
            let parameters = [10f64.powf(-2.0 + 0.2 * f64::from(i)), 10f64.powf(-4.0 + 0.9 * f64::from(j))];
            let used: Vec<bool> = points.iter().map(|p| p.slides(parameters)).collect();
            let count = used.iter().filter(|&&slides| slides).count();
            let sum = normal(points, &used, parameters).sum;
            // An omitted point counts as one with an error of its whole amplitude.
            let penalised = sum + points.len().saturating_sub(count) as f64;
            let better = best.is_none_or(|(_, least, _)| penalised < least);
            if count >= 3 && better {
                best = Some((count, penalised, parameters));
            }
        }
    }
    let few = Error::TooFewMeasurements { count: 0, of: points.len() };
    best.map(|(_, _, parameters)| parameters).ok_or(few)
}

/// The method of Levenberg and Marquardt, in the logarithms of both parameters, which keeps them positive.
fn descend(points: &[Point], used: &[bool], start: Parameters) -> Result<Parameters, Error> {
    let (mut at, mut damping) = (start, 1e-3);
    let mut here = normal(points, used, at);
    for _ in 0..STEPS {
        let [kappa, zeta] = at;
        let [a, b, c] = here.matrix;
        let (a, b, c) = (a * kappa * kappa, b * kappa * zeta, c * zeta * zeta);
        let (g, h) = (here.gradient[0] * kappa, here.gradient[1] * zeta);
        let (p, q) = (a * (1.0 + damping), c * (1.0 + damping));
        let determinant = p * q - b * b;
        // At the end of the range there is no damper, and friction alone is fitted.
        let at_the_end = zeta <= LEAST_DAMPING && b * g <= p * h;
        let step = if at_the_end {
            [-g / p, 0.0]
        } else {
            [(b * h - q * g) / determinant, (b * g - p * h) / determinant]
        };
        if !step.iter().all(|s| s.is_finite()) {
            return Err(Error::NotIdentified);
        }
        // A step changes a parameter at most by a factor of e.
        let most = step[0].abs().max(step[1].abs()).max(1.0);
        let next =
            [kappa * (step[0] / most).exp(), (zeta * (step[1] / most).exp()).clamp(LEAST_DAMPING, 1e3)];
        let there = normal(points, used, next);
        if there.sum <= here.sum {
            let settled = step.iter().all(|s| s.abs() < 1e-11) || (next == at);
            (at, here, damping) = (next, there, (damping * 0.1).max(1e-15));
            if settled {
                return Ok(at);
            }
        } else if damping > 1e12 {
            // No smaller step descends: the minimum is reached to within rounding.
            return Ok(at);
        } else {
            damping *= 10.0;
        }
    }
    Err(Error::NotIdentified)
}

/// The estimates with their errors.
fn report(points: &[Point], used: &[bool], parameters: Parameters, force: f64) -> Identified {
    let n = normal(points, used, parameters);
    let degrees_of_freedom = n.count.saturating_sub(2) as f64;
    let variance = n.sum / degrees_of_freedom;
    let [a, b, c] = n.matrix;
    let determinant = a * c - b * b;
    let estimate =
        |value: f64, variance: f64| Estimate { value, standard_error: variance.sqrt(), degrees_of_freedom };
    let friction = parameters[0] * force;
    let residual = |(point, used): (&Point, &bool)| {
        let [of_amplitude, _] = point.residuals(parameters);
        of_amplitude.filter(|_| *used).map(|(r, _)| r)
    };
    Identified {
        friction_bound: estimate(friction, variance * c / determinant * force * force),
        damping_ratio: estimate(parameters[1], variance * a / determinant),
        noise: variance.sqrt(),
        residuals: points.iter().zip(used).map(residual).collect(),
    }
}

#[cfg(test)]
mod tests;
