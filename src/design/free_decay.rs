//! Friction and damping from a measured free decay.
//!
//! In every half cycle the amplitude falls from y to `κ(y − B) − B`, κ = e^{−ζπ/d}, d = √(1 − ζ²), B = r_y/k (see
//! [`crate::motion::FreeDecay`]): the damper takes a part of it, friction an amount. Between two turning points, with
//! ω = dω_n and the sign s of the first,
//!
//! ```text
//! x = c + s [B + (y − B) e^{−ζω_nτ} (cos ωτ + (ζ/d) sin ωτ)],   y > B,
//! ```
//!
//! and after N half cycles the body rests at its last turning point, which static friction holds: `|y_N| ≤ r_s/k < y_{N−1}`.
//!
//! | step | file |
//! |---|---|
//! | the turning points of samples, by several smoothings, as guesses | `guess` |
//! | samples: first amplitude, B, ζ, the rest c of the spring, the time of the first turning point and ω, for each N | `samples` |
//! | turning points: first amplitude, B and ζ, for each N | `peaks` |
//! | the least squares | `fit` |
//!
//! N is not chosen where the measurement does not choose: the intervals cover the fits with each number of half cycles
//! that explains it. The fit does not know that B and ζ are not negative, so that its intervals contain the truth as often
//! as they say. An estimate below 0 by chance is given as 0, and one below 0 by more than chance is refused.

pub(super) mod fit;
mod guess;
mod peaks;
mod samples;

use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::{finite, positive};
use crate::uncertainty::{Estimate, student};
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::f64::consts::PI;
use fit::{Alike, Fit};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
pub use peaks::identify_turning_points;
pub use samples::identify_decay;

/// The turning points that were measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum TurningPoints {
    /// Those of both sides, one in every half cycle, with their signs or without.
    EveryHalfCycle,
    /// Those of one side, one in every cycle.
    EveryCycle,
}

/// Friction and damping estimated from a free decay.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct DecayIdentified {
    /// The friction displacement B = r_y/k, in the unit of the measurements.
    pub friction_displacement: Estimate,
    /// The damping ratio ζ.
    pub damping_ratio: Estimate,
    /// The first amplitude.
    pub amplitude: Estimate,
    /// The natural angular frequency ω_n, where times are known.
    pub natural_frequency: Option<Estimate>,
    /// The standard error of one measurement, estimated from the residuals.
    pub noise: f64,
    /// The half cycles until rest, where the body comes to rest within the measurement: of the best fit.
    pub half_cycles: Option<usize>,
    /// Bounds of the displacement r_s/k that static friction holds, from the turning point that it holds and the one
    /// before, which it does not; where the body comes to rest within the measurement.
    pub static_friction_displacement: Option<(f64, f64)>,
    /// The kind of the turning points by which they were read; `None` for samples.
    pub read_as: Option<TurningPoints>,
    /// The turning points, as measured or as found among the samples: the time, where it is known, and the displacement
    /// from the rest of the spring.
    pub turning_points: Vec<(Option<f64>, f64)>,
    /// Measured minus computed, of each turning point or each sample that was used.
    pub residuals: Vec<f64>,
}

/// The greatest displacement, whose square is far from overflow; the least turning point is its inverse.
const GREATEST: f64 = 1e75;

/// A displacement whose square is a number, and at least `least` in size.
fn measured(displacement: f64, least: f64) -> Result<f64, Error> {
    let size = finite(Quantity::Displacement, displacement)?.abs();
    if (least..=GREATEST).contains(&size) {
        return Ok(displacement);
    }
    Err(Error::OutOfRange {
        quantity: Quantity::Displacement,
        value: written(displacement),
        least: written(if displacement < 0.0 || least == 0.0 { -GREATEST } else { least }),
        greatest: written(if displacement < 0.0 { -least } else { GREATEST }),
    })
}

/// The places of the parameters that both fits have.
const AMPLITUDE: usize = 0;
const ZETA: usize = 1;
const FRICTION: usize = 2;

/// The answer from the fits that explain a measurement, the best one first, of the first amplitude, ζ and B, and of
/// further parameters or none.
///
/// # Errors
/// [`Error::NotADecay`] for a motion that grows, [`Error::NegativeFriction`] where friction or damping is negative by more
/// than chance.
fn identified(fits: &Alike) -> Result<DecayIdentified, Error> {
    let best = fits.best();
    let kinds =
        [(FRICTION, Quantity::FrictionDisplacement, best.at[AMPLITUDE]), (ZETA, Quantity::DampingRatio, 1.0)];
    for (i, quantity, scale) in kinds {
        let (value, error) = (best.at[i], fits.error(i));
        if value + student(CERTAIN, best.degrees_of_freedom()) * error < -ROUNDING * scale {
            // By how much both change an amplitude in half a cycle.
            let falls = (1.0 - ratio(best.at[ZETA])) * best.at[AMPLITUDE] + 2.0 * best.at[FRICTION];
            let value = written(value);
            return Err(if falls < 0.0 {
                Error::NotADecay
            } else {
                Error::NegativeFriction { quantity, value }
            });
        }
    }
    let of = |i: usize, greatest| best.estimate(best.at[i].max(0.0), fits.error(i), greatest);
    Ok(DecayIdentified {
        friction_displacement: of(FRICTION, f64::INFINITY),
        damping_ratio: of(ZETA, 1.0),
        amplitude: of(AMPLITUDE, f64::INFINITY),
        natural_frequency: None,
        noise: best.noise(),
        half_cycles: None,
        static_friction_displacement: None,
        read_as: None,
        turning_points: Vec::new(),
        residuals: best.residuals.clone(),
    })
}

/// The part of the first amplitude, and the damping ratio, that a fit without noise does not resolve.
const ROUNDING: f64 = 1e-7;
/// The quantile of the normal distribution beyond which a sign is no chance: 1 in 10⁵.
const CERTAIN: f64 = 4.4;

/// The amplitude of the turning point after one of the amplitude y.
fn next(y: f64, kappa: f64, friction: f64) -> f64 {
    kappa * (y - friction) - friction
}

/// The bounds of r_s/k from the turning point at which the body comes to rest.
fn held(at: &[f64], half_cycles: usize) -> (f64, f64) {
    let (mut before, mut last) = (at[AMPLITUDE], at[AMPLITUDE]);
    for _ in 0..half_cycles {
        (before, last) = (last, next(last, ratio(at[ZETA]), at[FRICTION]));
    }
    (last.abs().max(at[FRICTION]), before)
}

/// Whether friction lets the body go at each of the first turning points.
fn slides(at: &[f64], half_cycles: usize) -> bool {
    let mut y = at[AMPLITUDE];
    (0..half_cycles).all(|_| {
        let is_let_go = y > at[FRICTION];
        y = next(y, ratio(at[ZETA]), at[FRICTION]);
        is_let_go
    })
}

/// κ = e^{−ζπ/√(1 − ζ²)}, with a continuation below ζ = 0 for the fit.
fn ratio(zeta: f64) -> f64 {
    (-zeta * PI / swing(zeta)).exp()
}

/// √(1 − ζ²), above 0.
fn swing(zeta: f64) -> f64 {
    (1.0 - zeta * zeta).max(1e-12).sqrt()
}

/// Checks that times are finite and increase.
fn increasing(times: &[f64]) -> Result<(), Error> {
    let mut before = f64::NEG_INFINITY;
    for (index, &t) in times.iter().enumerate() {
        let wrong = |error| Error::InMeasurement { index, error: Box::new(error) };
        finite(Quantity::Time, t).map_err(wrong)?;
        if t <= before {
            positive(Quantity::TimeStep, t - before).map_err(wrong)?;
        }
        before = t;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
