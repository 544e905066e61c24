//! The friction and the damping of a body whose stiffness is known.

use super::explained::is_unexplained;
use super::model;
use super::outliers::Judged;
use super::outliers::is_larger;
use super::outliers::judge;
use super::reading::{AmplitudeKind, Identified, Measurement, PhaseKind, Reading, Residual};
use super::search::CurveFit;
use super::search::MeasuredPoint;
use super::search::RANGE;
use super::search::ResponseCurve;
use super::search::Rule;
use super::search::StartGrid;
use super::search::kept;
use super::valleys::lowest;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Excitation, Oscillator, critical_damping};
use crate::machine::ratios::{Ratios, finite, positive};
use crate::motion::{State, Trajectory};
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use core::iter::zip;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The body of a curve.
#[derive(Debug, Clone, Copy)]
pub(super) enum Spring {
    /// On a spring.
    Of(Oscillator<f64>),
    /// Of this mass without a spring. Its ζ of the search is c/(2 m ω₁), with ω₁ the lowest frequency of the curve.
    None { mass: f64, lowest: f64 },
}

impl Spring {
    /// The damping constant for each unit of the ζ of the search.
    fn critical_damping(&self) -> f64 {
        match *self {
            Self::Of(body) => critical_damping(body.mass(), body.stiffness()),
            Self::None { mass, lowest } => 2.0 * mass * lowest,
        }
    }

    /// The body at a frequency, and its damping ratio for each unit of that of the search.
    fn at(&self, frequency: f64) -> Result<(Oscillator<f64>, f64), Error> {
        match *self {
            Self::Of(body) => Ok((body, 1.0)),
            // ζ = c/(2 m ω_n) of a spring that is too soft to be seen at this frequency.
            Self::None { mass, lowest } => {
                let body = Oscillator::without_spring(mass, 1.0, frequency)?;
                Ok((body, lowest / body.natural_frequency()))
            }
        }
    }
}

/// The fit with mass, stiffness and force known.
pub(super) fn identified(
    body: &Spring,
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
        critical_damping: body.critical_damping(),
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
pub(super) const SAMPLE: usize = 200;

/// Evenly chosen measurements.
pub(super) fn sample<T: Copy>(points: &[T]) -> Vec<T> {
    let every = points.len().div_ceil(SAMPLE).max(1);
    points.iter().copied().step_by(every).collect()
}

/// A measurement in ratios.
pub(super) fn in_ratios(body: &Spring, force: f64, measured: &Measurement) -> Result<MeasuredPoint, Error> {
    let drive = Drive::new(Excitation::Force, force, measured.angular_frequency)?;
    let (body, damping) = body.at(measured.angular_frequency)?;
    let ratios = Ratios::new(drive.angular_frequency() / body.natural_frequency(), 2.0)?;
    if ratios.omega() >= model::SLOW {
        // The exact motion has a range of frequencies of its own.
        let _ = Trajectory::new(ratios, State::default())?;
    }
    let length = positive(Quantity::MaxDisplacement, measured.amplitude)?;
    let amplitude = length * body.stiffness() / force;
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
    Ok(MeasuredPoint { omega: ratios.omega(), amplitude, measured: length, damping, phase })
}

impl<'a> ResponseCurve<'a> {
    pub(super) fn of(points: &'a [MeasuredPoint], amplitude: AmplitudeKind, phase: PhaseKind) -> Self {
        let scale = if amplitude == AmplitudeKind::PeakToPeak { 0.5 } else { 1.0 };
        Self { points, amplitude, phase, scale }
    }
}

/// The kind of the phases with its fit, and other kinds of phase and of amplitude if they fit better.
pub(super) struct ChosenReading {
    pub(super) phase: PhaseKind,
    pub(super) better_phase: Option<PhaseKind>,
    pub(super) judged: Judged,
    pub(super) better: Option<(AmplitudeKind, f64)>,
    /// The grid of starts for this reading.
    pub(super) grid: StartGrid,
}

/// One reading of the phases with its fits.
pub(super) struct Read<'a> {
    pub(super) curve: ResponseCurve<'a>,
    pub(super) trimmed: CurveFit,
    pub(super) judged: Judged,
}

/// The root mean square of the residuals of a trimmed fit below which no other kind of amplitude is tried.
/// The root mean square of all residuals is about twice as large.
pub(super) const EXPLAINED: f64 = 0.01;

/// The numbers of starts of the reading asked for, and of the others.
pub(super) const STARTS: [usize; 2] = [4, 2];

/// By how much a reading must explain a curve better, as a logarithm of likelihoods: 1 in 1,000.
pub(super) const BETTER: f64 = 7.0;

pub(super) fn chosen(points: &[MeasuredPoint], reading: Reading) -> Result<ChosenReading, Error> {
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
pub(super) fn is_better(curve: &ResponseCurve<'_>, fit: &CurveFit, other: &CurveFit) -> bool {
    let count: usize = curve.counts().into_iter().map(kept).sum();
    let degrees_of_freedom = count.saturating_sub(2) as f64;
    is_larger(fit.sum / other.sum, [degrees_of_freedom; 2])
}

/// The residuals, by measurement.
pub(super) fn residuals(curve: &ResponseCurve<'_>, found: &Judged) -> Result<Vec<Residual>, Error> {
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
