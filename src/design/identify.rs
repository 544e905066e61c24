//! Friction and damping from a measured response curve, by least squares that are robust to wrong values.
//!
//! With known mass, stiffness and force amplitude, the steady motion at a frequency depends on κ = r_y/p₀ and ζ
//! alone. Where the body slides throughout it is the closed form, in the symbols of `docs/development/theory/damping.md`
//!
//! ```text
//! Δ₀ = (p₀/k) [√(1 − κ²K²)/q − κG],   ω_d t₂ = δ + atan2(√(1 − κ²K²), κK),
//! ```
//!
//! and where it stops the exact motion (`model`). Both meet at the border, so that the sum of squares is
//! continuous in κ and ζ, and no measurement is left out because the body stops.
//!
//! | step | file |
//! |---|---|
//! | the best minima of a trimmed sum, the 7 smallest of 10 squares, over a grid of starts | `search` |
//! | the least squares over all values, or over those that this fit predicts where chance does not explain the others | `outliers` |
//! | whether the fit explains more than one amplitude for all frequencies does | `explained` |
//! | the same with each reading of the phases, of which the one that explains most is taken | here |
//! | the fit with other readings of amplitudes and phases, which may be better | here |
//! | lower valleys of the sum of squares, and the parameters that cannot be told apart | `valleys` |
//! | the fit with the natural frequency or the force unknown | `unknown` |

mod explained;
mod model;
mod outliers;
mod search;
mod unknown;
mod valleys;

use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Excitation, Oscillator};
use crate::machine::ratios::{Ratios, finite, positive};
use crate::motion::{State, Trajectory};
use crate::named::named;
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use core::iter::zip;
use explained::is_unexplained;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use outliers::{Judged, is_larger, judge};
use search::{CurveFit, MeasuredPoint, RANGE, ResponseCurve, Rule, StartGrid, kept};
use unknown::{Scaled, fitted};
use valleys::lowest;

/// One point of a measured response curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Measurement {
    /// Angular frequency ω_d.
    pub angular_frequency: f64,
    /// The amplitude of the displacement, as [`Reading::amplitude`] says.
    pub amplitude: f64,
    /// The phase in radians, as [`Reading::phase`] says, if it was measured; from −2π to 2π.
    pub phase: Option<f64>,
}

named! {
    /// The amplitude that was measured.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    pub enum AmplitudeKind [name] {
        /// The peak displacement, half of peak to peak.
        #[default]
        Peak = "peak",
        /// From the minimum to the peak displacement.
        PeakToPeak = "peak-to-peak",
        /// The root mean square of the displacement over a cycle.
        #[cfg_attr(feature = "serde", serde(rename = "rms"))]
        RootMeanSquare = "rms",
    }
}

named! {
    /// The phase that was measured, the force being p₀ sin ω_d t.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    pub enum PhaseKind [name] {
        /// ω_d t₂, at which the body arrives at its peak displacement: about π/2 far below
        /// resonance.
        Peak = "peak",
        /// The lag of the fundamental of the displacement behind the force: between 0 and π.
        Lag = "lag",
        /// The phase of the transfer function from force to displacement: the lag with a minus sign.
        TransferFunction = "transfer-function",
    }
}

/// How the values of a curve are read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reading {
    /// The kind of the amplitudes.
    pub amplitude: AmplitudeKind,
    /// The kind of the phases; `None` tries each and chooses the one that explains the curve best,
    /// [`PhaseKind::Peak`] unless another one does better by more than chance.
    pub phase: Option<PhaseKind>,
}

/// A measurement beside the motion computed with the parameters found.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Residual {
    /// Measured minus computed amplitude, relative to the measured one.
    pub amplitude: f64,
    /// Measured minus computed phase in radians, within half a turn.
    pub phase: Option<f64>,
    /// Whether the amplitude is so far from the computed one that it was left out.
    pub amplitude_is_suspect: bool,
    /// Whether the phase is so far from the computed one that it was left out.
    pub phase_is_suspect: bool,
    /// Whether the body stops in each cycle of the computed motion.
    pub stops: bool,
}

impl Residual {
    /// Whether the amplitude or the phase was left out.
    #[must_use]
    pub const fn is_suspect(&self) -> bool {
        self.amplitude_is_suspect || self.phase_is_suspect
    }
}

/// Friction and damping estimated from a measured response curve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Identified {
    /// The friction force r_y, between 0 and p₀.
    pub friction_bound: Estimate,
    /// The damping ratio ζ ≥ 0; `c = 2ζ√(k m)`.
    pub damping_ratio: Estimate,
    /// The natural angular frequency ω_n where the stiffness was not known.
    pub natural_frequency: Option<Estimate>,
    /// The amplitude p₀ of the force where it was not known.
    pub force: Option<Estimate>,
    /// The standard error of one amplitude, relative to it, estimated from the residuals.
    pub noise: f64,
    /// The standard error of one phase in radians, estimated from the residuals.
    pub phase_noise: Option<f64>,
    /// The residuals of each measurement, in their order.
    pub residuals: Vec<Residual>,
    /// The kind of phase that the curve was read with, if it has phases.
    pub phase: Option<PhaseKind>,
    /// Another kind of phase that explains the curve better by more than chance than the one asked for.
    pub better_phase: Option<PhaseKind>,
    /// Another kind of amplitude that fits better than expected by chance, with the standard error of an amplitude
    /// read so: the amplitudes were probably of that kind.
    pub better: Option<(AmplitudeKind, f64)>,
    /// Whether the search for other minima came to its end. Otherwise the least sum of squares within the bound on its work is
    /// answered.
    pub search_is_complete: bool,
}

/// The friction force and the damping ratio that fit a response curve of a body of this mass on a spring of this
/// stiffness, under a force of amplitude p₀, whose values are read as `reading` says: by default, amplitudes are peak
/// displacements.
///
/// Errors of the amplitudes count as relative, errors of the phases in radians, both with the same standard deviation unless
/// the residuals of the two differ by more than chance.
///
/// Values that the others contradict are left out: up to three of ten amplitudes, and as many phases. A model that
/// explains all values to within their noise keeps them all, so that in a curve without wrong values one is left out
/// once in 10⁵ curves. Fewer than seven values of a kind are all used.
///
/// The answer is the least sum of squares found from a grid of starts, and on both sides of each motion that begins to
/// stop near it. It is not proved to be the global minimum. The intervals hold all parameters found, in any valley of the sum,
/// that are no worse than their ends. Below Ω = 0.002 the amplitude of a body that stops is that under a slow force, to within 20Ω² p₀/k.
///
/// **With the stiffness or the force unknown**, `None`, the natural angular frequency or p₀ is fitted, too. The phases are
/// then those that `reading` names, and otherwise [`PhaseKind::Peak`], and the standard errors are those of three
/// parameters. A curve without the resonance may leave the natural frequency to chance: its interval says so. Far from
/// resonance and with friction alone, the force and friction are hardly apart.
///
/// # Errors
/// Where mass, stiffness or force is not > 0, [`Error::NotIdentified`] where both stiffness and force are unknown,
/// [`Error::InMeasurement`] where a measurement is not finite, not > 0 or out of range,
/// [`Error::TooFewMeasurements`] for fewer than three, or four with an unknown, [`Error::NotIdentified`] where the curve does not
/// separate friction from damping, [`Error::Unexplained`] where the best fit lies at the end of the range
/// searched, r_y = p₀ or ζ = 100, and [`Error::CurveUnexplained`] where the fit is no nearer to the amplitudes than one
/// amplitude for all frequencies, but for chance: white noise, for example.
pub fn identify(
    mass: f64,
    stiffness: Option<f64>,
    force: Option<f64>,
    curve: &[Measurement],
    reading: Reading,
) -> Result<Identified, Error> {
    let mass = positive(Quantity::Mass, mass)?;
    let force = force.map(|force| positive(Quantity::ForceAmplitude, force)).transpose()?;
    // A friction of any size: it plays no part.
    let body = stiffness.map(|stiffness| Oscillator::new(mass, stiffness, 1.0)).transpose()?;
    match (body, force) {
        (Some(body), Some(force)) => identified(&body, force, curve, reading),
        (None, Some(force)) => fitted(Scaled::Natural { mass, force }, curve, reading),
        (Some(body), None) => fitted(Scaled::Force { body }, curve, reading),
        (None, None) => Err(Error::NotIdentified),
    }
}

/// The fit with mass, stiffness and force known.
fn identified(
    body: &Oscillator<f64>,
    force: f64,
    curve: &[Measurement],
    reading: Reading,
) -> Result<Identified, Error> {
    let point = |(index, measured): (usize, &Measurement)| {
        in_ratios(body, force, measured).map_err(|e| Error::InMeasurement { index, error: Box::new(e) })
    };
    let points = curve.iter().enumerate().map(point).collect::<Result<Vec<_>, _>>()?;
    if points.len() < 3 {
        return Err(Error::TooFewMeasurements { count: points.len() });
    }
    let some = sample(&points);
    let ChosenReading { phase, better_phase, judged, better, grid } = chosen(&some, reading)?;
    let curve = |points| ResponseCurve::of(points, reading.amplitude, phase);
    let (mut found, mut region) = lowest(&curve(&some), judged, Some(&grid));
    let curve = curve(&points);
    if some.len() < points.len() {
        (found, region) = lowest(&curve, judge(&curve, found.fit.at, None)?, None);
    }
    let [kappa, zeta] = found.fit.at;
    for (x, (_, end), quantity) in
        [(kappa, RANGE[0], Quantity::FrictionBound), (zeta, RANGE[1], Quantity::DampingRatio)]
    {
        if x >= end {
            let value = if quantity == Quantity::FrictionBound { x * force } else { x };
            return Err(Error::Unexplained { quantity, value: written(value) });
        }
    }
    if better.is_none() && is_unexplained(&curve, &found) {
        return Err(Error::CurveUnexplained { noise: written((1e3 * found.noise[0]).round() / 1e3) });
    }
    let has_phases = curve.counts()[1] > 0;
    let estimate = |value: f64, variance: f64, range: (f64, f64), alike| Estimate {
        value,
        standard_error: variance.sqrt(),
        degrees_of_freedom: found.degrees_of_freedom,
        range,
        alike: Some(alike),
    };
    let region = region.ok_or(Error::NotIdentified)?;
    let [(low, high), of_zeta] = region.hull.ok_or(Error::NotIdentified)?;
    let [of_friction, _, of_damping] = found.covariance.ok_or(Error::NotIdentified)?;
    let [noise, phase_noise] = found.noise;
    Ok(Identified {
        friction_bound: estimate(
            kappa * force,
            of_friction * force * force,
            (0.0, force),
            (low * force, high * force),
        ),
        damping_ratio: estimate(zeta, of_damping, (0.0, f64::INFINITY), of_zeta),
        natural_frequency: None,
        force: None,
        noise,
        phase_noise: has_phases.then_some(phase_noise),
        residuals: residuals(&curve, &found)?,
        phase: has_phases.then_some(phase),
        better_phase,
        better,
        search_is_complete: region.is_whole,
    })
}

/// The greatest number of measurements from which the starts and the readings are found.
const SAMPLE: usize = 200;

/// Evenly chosen measurements.
fn sample<T: Copy>(points: &[T]) -> Vec<T> {
    let every = points.len().div_ceil(SAMPLE).max(1);
    points.iter().copied().step_by(every).collect()
}

/// A measurement in ratios.
fn in_ratios(body: &Oscillator<f64>, force: f64, measured: &Measurement) -> Result<MeasuredPoint, Error> {
    let drive = Drive::new(Excitation::Force, force, measured.angular_frequency)?;
    let ratios = Ratios::new(drive.angular_frequency() / body.natural_frequency(), 2.0)?;
    if ratios.omega() >= model::SLOW {
        // The exact motion has a range of frequencies of its own.
        let _ = Trajectory::new(ratios, State::default())?;
    }
    let amplitude = positive(Quantity::MaxDisplacement, measured.amplitude)? * body.stiffness() / force;
    let phase = measured.phase.map(|phase| finite(Quantity::DrivePhase, phase)).transpose()?;
    // 2π may have been rounded up.
    if let Some(phase) = phase.filter(|phase| phase.abs() > TAU + 1e-3) {
        return Err(Error::OutOfRange {
            quantity: Quantity::DrivePhase,
            value: written(phase),
            least: written(-TAU),
            greatest: written(TAU),
        });
    }
    Ok(MeasuredPoint { omega: ratios.omega(), amplitude, phase })
}

impl<'a> ResponseCurve<'a> {
    fn of(points: &'a [MeasuredPoint], amplitude: AmplitudeKind, phase: PhaseKind) -> Self {
        let scale = if amplitude == AmplitudeKind::PeakToPeak { 0.5 } else { 1.0 };
        Self { points, amplitude, phase, scale }
    }
}

/// The kind of the phases with its fit, and other kinds of phase and of amplitude if they fit better.
struct ChosenReading {
    phase: PhaseKind,
    better_phase: Option<PhaseKind>,
    judged: Judged,
    better: Option<(AmplitudeKind, f64)>,
    /// The grid of starts for this reading.
    grid: StartGrid,
}

/// One reading of the phases with its fits.
struct Read<'a> {
    curve: ResponseCurve<'a>,
    trimmed: CurveFit,
    judged: Judged,
}

/// The root mean square of the residuals of a trimmed fit below which no other kind of amplitude is tried.
/// The root mean square of all residuals is about twice as large.
const EXPLAINED: f64 = 0.01;
/// The numbers of starts of the reading asked for, and of the others.
const STARTS: [usize; 2] = [4, 2];

/// By how much a reading must explain a curve better, as a logarithm of likelihoods: 1 in 1,000.
const BETTER: f64 = 7.0;

fn chosen(points: &[MeasuredPoint], reading: Reading) -> Result<ChosenReading, Error> {
    let [many, few] = STARTS;
    let curve = |phase| ResponseCurve::of(points, reading.amplitude, phase);
    let read = |grid: &StartGrid, phase| -> Result<Read<'_>, Error> {
        let curve = curve(phase);
        let trimmed = grid.best(&curve, Rule::Trimmed, many)?;
        let judged = judge(&curve, trimmed.at, Some(grid))?;
        Ok(Read { curve, trimmed, judged })
    };
    let asked = reading.phase.unwrap_or(PhaseKind::Peak);
    let mut grid = StartGrid::of(&curve(asked));
    let first = read(&grid, asked);
    let counts = curve(asked).counts();
    let mut better_phase = None;
    let mut best = first;
    if counts[1] > 0 {
        // The quantities of the whole cycle serve both kinds of lag, and the peaks.
        let whole = StartGrid::of(&curve(PhaseKind::Lag));
        let kinds = [PhaseKind::Peak, PhaseKind::Lag, PhaseKind::TransferFunction];
        let misfit = |read: &Read<'_>| read.judged.misfit(counts);
        let others = kinds.into_iter().filter(|kind| *kind != asked);
        let other = others.filter_map(|kind| Some((kind, read(&whole, kind).ok()?)));
        let other = other.min_by(|a, b| misfit(&a.1).total_cmp(&misfit(&b.1)));
        let is_better =
            |other: &Read<'_>| best.as_ref().map_or(true, |best| misfit(other) < misfit(best) - BETTER);
        if let Some((kind, other)) = other.filter(|(_, other)| is_better(other)) {
            if reading.phase.is_some() {
                better_phase = Some(kind);
            } else {
                (best, grid) = (Ok(other), whole);
            }
        }
    }
    let Read { curve: best, trimmed: fit, judged } = best?;
    // A curve that the model explains gives no cause for suspicion.
    let is_explained = |fit: &CurveFit| fit.sum < EXPLAINED.powi(2) * fit.weights.iter().sum::<f64>();
    let kinds = [AmplitudeKind::Peak, AmplitudeKind::PeakToPeak, AmplitudeKind::RootMeanSquare];
    let others = kinds.into_iter().filter(|kind| *kind != reading.amplitude && !is_explained(&fit));
    let mut better: Option<(ResponseCurve<'_>, CurveFit)> = None;
    for kind in others {
        let other = ResponseCurve::of(points, kind, best.phase);
        // A root mean square is that of the whole cycle.
        let whole = (other.needs_whole() && !best.needs_whole()).then(|| StartGrid::of(&other));
        let Ok(found) = whole.as_ref().unwrap_or(&grid).best(&other, Rule::Trimmed, few) else { continue };
        if is_better(&best, &fit, &found) && better.as_ref().is_none_or(|(_, b)| found.sum < b.sum) {
            better = Some((other, found));
        }
    }
    let better = better.and_then(|(other, found)| {
        let noise = judge(&other, found.at, None).ok()?.noise[0];
        Some((other.amplitude, noise))
    });
    Ok(ChosenReading { phase: best.phase, better_phase, judged, better, grid })
}

/// Whether another trimmed fit of the same curve is better by more than chance.
fn is_better(curve: &ResponseCurve<'_>, fit: &CurveFit, other: &CurveFit) -> bool {
    let count: usize = curve.counts().into_iter().map(kept).sum();
    let degrees_of_freedom = count.saturating_sub(2) as f64;
    is_larger(fit.sum / other.sum, [degrees_of_freedom; 2])
}

/// The residuals, by measurement.
fn residuals(curve: &ResponseCurve<'_>, found: &Judged) -> Result<Vec<Residual>, Error> {
    let motions = curve.motions(found.fit.at).ok_or(Error::NotIdentified)?;
    let (amplitudes, phases) =
        found.fit.residuals.split_at(curve.points.len().min(found.fit.residuals.len()));
    let (suspect, suspect_phases) = found.suspect.split_at(amplitudes.len());
    let mut phases = zip(phases, suspect_phases);
    let of = |((point, motion), (amplitude, is_suspect)): (
        (&MeasuredPoint, &model::ModelMotion),
        (&f64, &bool),
    )| {
        let phase = point.phase.and_then(|_| phases.next());
        Residual {
            amplitude: *amplitude,
            phase: phase.map(|(r, _)| *r),
            amplitude_is_suspect: *is_suspect,
            phase_is_suspect: phase.is_some_and(|(_, is_suspect)| *is_suspect),
            stops: motion.stops,
        }
    };
    Ok(zip(zip(curve.points, &motions), zip(amplitudes, suspect)).map(of).collect())
}

#[cfg(test)]
mod tests;
