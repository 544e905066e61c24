//! Design of a machine, its identification from a measured curve, and figures.

use crate::machine::{Bodies, Body, body, excitation};
use crate::points::{Given, Values};
use crate::refused;
use interrupt::{interruptible, left_behind};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use stickslip::design::{
    self, Aim, AmplitudeKind, Edge, Holding, Measurement, OptimumKind, PhaseKind, Reading, TurningPoints,
};
use stickslip::uncertainty::Estimate;
use stickslip::{Drive, Error, Excitation, Oscillator};
use stickslip_figures as figures;
use stickslip_front::inputs;

/// A question of design about one body under one drive, with an answer in a few numbers.
#[derive(Clone, Copy)]
enum Question {
    MinAmplitude,
    MaxFriction,
    BestFriction,
    BestFrictionOfAll,
    ForceForDisplacement,
    ForceForVelocity,
    Holding,
}

impl Question {
    const ALL: [(&str, Self); 7] = [
        ("min_amplitude", Self::MinAmplitude),
        ("max_friction", Self::MaxFriction),
        ("best_friction", Self::BestFriction),
        ("best_friction_of_all", Self::BestFrictionOfAll),
        ("force_for_displacement", Self::ForceForDisplacement),
        ("force_for_velocity", Self::ForceForVelocity),
        ("hold", Self::Holding),
    ];

    /// The answer for a body of these values, of which a friction of 0 needs no force, and in other questions is one far below
    /// the rounding of the motion.
    fn answered(
        self,
        of: Body,
        kind: Excitation,
        target: f64,
        frequency: f64,
    ) -> Result<([f64; 3], u8), Error> {
        let (mass, stiffness, forward, backward, damping, ratio) = of;
        if forward != 0.0 || backward > 0.0 {
            return self.answer(&body(of)?, kind, target, frequency);
        }
        let nothing = inputs::Given::<f64>::nothing();
        let with = |friction: f64| body((mass, stiffness, friction, f64::NAN, damping, ratio));
        let friction = match self {
            Self::MinAmplitude | Self::Holding => 1.0,
            Self::ForceForDisplacement | Self::ForceForVelocity => (stiffness * target).abs() * nothing,
            _ => Drive::new(kind, target, frequency)?.force_amplitude(&with(1.0)?) * nothing,
        };
        let (mut numbers, word) = self.answer(&with(friction)?, kind, target, frequency)?;
        if let (Self::MinAmplitude | Self::Holding, [first, ..]) = (self, &mut numbers) {
            *first = 0.0;
        }
        Ok((numbers, word))
    }

    /// The answer: its numbers, and the number of a word.
    fn answer(
        self,
        body: &Oscillator<f64>,
        kind: Excitation,
        target: f64,
        frequency: f64,
    ) -> Result<([f64; 3], u8), Error> {
        let drive = || Drive::new(kind, target, frequency);
        let alone = |value| ([value, f64::NAN, f64::NAN], 0);
        let of_kind = |kind| match kind {
            OptimumKind::Interior => 0,
            OptimumKind::Border => 1,
            _ => 2,
        };
        Ok(match self {
            Self::MinAmplitude => alone(design::min_amplitude(body, kind, frequency)?),
            Self::MaxFriction => alone(design::max_friction(body, &drive()?)?),
            Self::BestFriction => {
                let best = design::most_dissipating_friction(body, &drive()?)?;
                ([best.at, best.value, f64::NAN], of_kind(best.kind))
            }
            Self::BestFrictionOfAll => {
                let best = design::most_dissipating_friction_of_all(body, &drive()?, 1e-6)?;
                ([best.at, best.value, best.bound], of_kind(best.kind))
            }
            Self::ForceForDisplacement => alone(design::force_for_displacement(body, frequency, target)?),
            Self::ForceForVelocity => alone(design::force_for_velocity(body, frequency, target)?),
            Self::Holding => match design::holding_frequency(body, &drive()?)? {
                Holding::UpTo(frequency) => alone(frequency),
                Holding::Always => alone(f64::INFINITY),
                _ => alone(0.0),
            },
        })
    }
}

/// Three columns of numbers and one of the numbers of words.
type Columns<'py> = ([Bound<'py, PyArray1<f64>>; 3], Bound<'py, PyArray1<u8>>);

/// The answers to a question of design at `n` places, each of a body, of an amplitude, a displacement or a velocity, and of an
/// angular frequency: three columns of numbers, and the number of a word. A place outside the domain has NaN if it is one of
/// `many`.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the question and where it is asked")]
fn design_each<'py>(
    py: Python<'py>,
    question: &str,
    of: [Given<'py>; 6],
    excited: &str,
    target: Given<'py>,
    frequency: Given<'py>,
    n: usize,
    many: bool,
) -> PyResult<Columns<'py>> {
    let (_, asked) = kind("question", question, &Question::ALL, |(name, _)| name)?;
    let (bodies, excited) = (Bodies::of(&of)?, excitation(excited)?);
    let (target, frequency) = (Values::of(&target)?, Values::of(&frequency)?);
    let found = interruptible(py, |stop| {
        (0..n)
            .into_par_iter()
            .map(|place| {
                let at = bodies.given_at(place).zip(target.at(place).zip(frequency.at(place)));
                let Some((body, (target, frequency))) = at else { return Err(Error::Interrupted) };
                if stop.asked().is_break() {
                    return Err(Error::Interrupted);
                }
                match asked.answered(body, excited, target, frequency) {
                    Err(_) if many => Ok(([f64::NAN; 3], u8::MAX)),
                    answer => answer,
                }
            })
            .collect::<Result<Vec<_>, Error>>()
    })?;
    let found = found.map_err(refused)?;
    let numbers = [0, 1, 2].map(|part: usize| {
        let column = found.iter().map(|(numbers, _)| numbers.get(part).copied().unwrap_or(f64::NAN));
        column.collect::<Vec<_>>().into_pyarray(py)
    });
    Ok((numbers, found.iter().map(|(_, word)| *word).collect::<Vec<_>>().into_pyarray(py)))
}

/// The stiffness in a range that dissipates most without sticking, the energy of a cycle, and the kind of optimum.
#[pyfunction]
fn best_stiffness(
    py: Python<'_>,
    of: Body,
    kind: &str,
    amplitude: f64,
    angular_frequency: f64,
    low: f64,
    high: f64,
) -> PyResult<(f64, f64, &'static str)> {
    let (drive, body) = (drive(kind, amplitude, angular_frequency)?, body(of).map_err(refused)?);
    let best = left_behind(py, move || design::most_dissipating_stiffness(&body, &drive, low..=high))?;
    let best = best.map_err(refused)?;
    let why = match best.kind {
        OptimumKind::Interior => "interior",
        OptimumKind::RangeEnd => "range-end",
        _ => "border",
    };
    Ok((best.at, best.value, why))
}

/// The friction forces with which the steady motion has a greatest displacement: bound, regime and displacement.
#[pyfunction]
fn frictions_for_displacement(
    py: Python<'_>,
    of: Body,
    kind: &str,
    amplitude: f64,
    angular_frequency: f64,
    target: f64,
) -> PyResult<Vec<(f64, &'static str, f64)>> {
    let (drive, body) = (drive(kind, amplitude, angular_frequency)?, body(of).map_err(refused)?);
    let found = left_behind(py, move || design::frictions_for_displacement(&body, &drive, target))?;
    let found = found.map_err(refused)?;
    Ok(found.into_iter().map(|own| (own.friction, own.regime.name(), own.max_displacement)).collect())
}

/// The drive of a body by kind, amplitude and angular frequency.
fn drive(kind: &str, amplitude: f64, angular_frequency: f64) -> PyResult<Drive<f64>> {
    Drive::new(excitation(kind)?, amplitude, angular_frequency).map_err(refused)
}

/// The bands of angular frequency without sticking: both ends, and whether each is an end of the requested
/// range.
#[pyfunction]
fn bands(
    py: Python<'_>,
    of: Body,
    kind: &str,
    amplitude: f64,
    low: f64,
    high: f64,
) -> PyResult<Vec<(f64, f64, bool, bool)>> {
    let (drive, body) = (drive(kind, amplitude, 1.0)?, body(of).map_err(refused)?);
    let work = move || design::frequency_bands(&body, &drive, low..=high)?.collect::<Result<Vec<_>, Error>>();
    let found = left_behind(py, work)?;
    let cut = |edge| edge == Edge::Range;
    Ok(found
        .map_err(refused)?
        .into_iter()
        .map(|b| (b.low, b.high, cut(b.low_edge), cut(b.high_edge)))
        .collect())
}

/// Friction, greatest amplitude, the ranges of frequency that have it, the kind of optimum, and the friction at rest.
type FoundFriction = (f64, f64, Vec<(f64, f64)>, &'static str, f64, Option<f64>);

/// The friction force with the least greatest amplitude over a band: friction, greatest amplitude, the frequencies that
/// have it, the kind, and the friction at which the body rests in the whole band.
#[pyfunction]
fn best_friction_over(
    py: Python<'_>,
    of: Body,
    excitation: &str,
    amplitude: f64,
    low: f64,
    high: f64,
    aim: &str,
) -> PyResult<FoundFriction> {
    let drive = drive(excitation, amplitude, 1.0)?;
    let aim = kind("of", aim, &Aim::ALL, Aim::name)?;
    let body = body(of).map_err(refused)?;
    let work = move || design::best_friction_over_band(&body, &drive, low..=high, aim);
    let found = left_behind(py, work)?.map_err(refused)?;
    Ok((found.friction, found.greatest, found.at, found.kind.name(), found.rest, found.up_to))
}

/// Friction displacement and damping ratio from a free decay: of samples, or of turning points in every cycle or half
/// cycle.
#[pyfunction]
fn identify_decay<'py>(
    py: Python<'py>,
    displacement: PyReadonlyArray1<'py, f64>,
    time: Option<PyReadonlyArray1<'py, f64>>,
    turns: Option<&str>,
) -> PyResult<Bound<'py, PyDict>> {
    let values = displacement.as_slice()?;
    let times = time.as_ref().map(|time| time.as_slice()).transpose()?;
    let points = [(TurningPoints::EveryCycle, "cycle"), (TurningPoints::EveryHalfCycle, "half-cycle")];
    let points = turns.map(|text| kind("every", text, &points, |(_, name)| name)).transpose()?;
    let (values, times) = (values.to_vec(), times.map(<[f64]>::to_vec));
    let found = left_behind(py, move || match points {
        Some((points, _)) => design::identify_turning_points(&values, times.as_deref(), points),
        None => design::identify_decay(times.as_deref().unwrap_or_default(), &values),
    })?;
    let found = found.map_err(refused)?;
    let dict = PyDict::new(py);
    let estimate = |e: Estimate| (e.value, e.standard_error, e.interval());
    dict.set_item("friction_displacement", estimate(found.friction_displacement))?;
    dict.set_item("damping_ratio", estimate(found.damping_ratio))?;
    dict.set_item("amplitude", estimate(found.amplitude))?;
    dict.set_item("natural_frequency", found.natural_frequency.map(estimate))?;
    dict.set_item("noise", found.noise)?;
    dict.set_item("turning_points", found.turning_points.iter().map(|point| point.1).collect::<Vec<_>>())?;
    let times: Vec<_> = found.turning_points.iter().map(|point| point.0.unwrap_or(f64::NAN)).collect();
    dict.set_item("times", times)?;
    dict.set_item("residuals", found.residuals)?;
    Ok(dict)
}

/// Friction, damping and the stiffness if it is not given, from a load and the displacements at the times of its samples.
#[pyfunction]
fn identify_motion<'py>(
    py: Python<'py>,
    mass: f64,
    stiffness: Option<f64>,
    load: (String, PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>),
    displacement: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let (of, times, samples) = &load;
    let record = crate::record::load(of, times.as_slice()?, samples.as_slice()?, None)?;
    let values = displacement.as_slice()?.to_vec();
    let work = move || design::identify_motion(mass, stiffness, &record, &values);
    let found = left_behind(py, work)?.map_err(refused)?;
    let dict = PyDict::new(py);
    let estimate = |e: Estimate| (e.value, e.standard_error, e.interval());
    for (name, own) in [
        ("friction", found.friction),
        ("damping_ratio", found.damping_ratio),
        ("damping", found.damping),
        ("friction_displacement", found.friction_displacement),
        ("offset", found.offset),
        ("start_displacement", found.start_displacement),
    ] {
        dict.set_item(name, estimate(own))?;
    }
    dict.set_item("start_velocity", found.start_velocity.map(estimate))?;
    dict.set_item("stiffness", found.stiffness.map(estimate))?;
    dict.set_item("noise", found.noise)?;
    dict.set_item("residuals", found.residuals)?;
    Ok(dict)
}

/// The kind of this name.
fn kind<K: Copy>(argument: &str, text: &str, kinds: &[K], name: impl Fn(K) -> &'static str) -> PyResult<K> {
    kinds.iter().copied().find(|&kind| name(kind) == text).ok_or_else(|| {
        let names: Vec<_> = kinds.iter().map(|&kind| name(kind)).collect();
        refused(format!("{argument} {text}: must be one of {}", names.join(", ")))
    })
}

/// Friction force and damping ratio from a response curve, each with its standard error and 95 % interval.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "those of the Python function")]
fn identify<'py>(
    py: Python<'py>,
    of: Body,
    force: Option<f64>,
    angular_frequency: PyReadonlyArray1<'py, f64>,
    amplitude: PyReadonlyArray1<'py, f64>,
    phase: Option<PyReadonlyArray1<'py, f64>>,
    amplitude_kind: &str,
    phase_kind: Option<&str>,
) -> PyResult<Bound<'py, PyDict>> {
    // Without a stiffness the natural frequency is fitted, too; without a force its amplitude.
    let mass = of.1.is_nan().then_some(of.0);
    let is_free = of.1 == 0.0;
    let any = (of.0, 1.0, of.2, of.3, of.4, of.5);
    let body = body(if mass.is_some() || is_free { any } else { of }).map_err(refused)?;
    let phase = phase.as_ref().map(|p| p.as_slice()).transpose()?;
    let points = angular_frequency.as_slice()?.iter().zip(amplitude.as_slice()?).enumerate();
    let curve: Vec<Measurement> = points
        .map(|(i, (&angular_frequency, &amplitude))| Measurement {
            angular_frequency,
            amplitude,
            phase: phase.and_then(|p| p.get(i).copied()).filter(|p| !p.is_nan()),
        })
        .collect();
    let amplitudes = [AmplitudeKind::Peak, AmplitudeKind::PeakToPeak, AmplitudeKind::RootMeanSquare];
    let phases = [PhaseKind::Peak, PhaseKind::Lag, PhaseKind::TransferFunction];
    let reading = Reading {
        amplitude: kind("amplitude_kind", amplitude_kind, &amplitudes, AmplitudeKind::name)?,
        phase: phase_kind.map(|text| kind("phase_kind", text, &phases, PhaseKind::name)).transpose()?,
    };
    let static_friction_ratio = body.static_friction_ratio();
    if static_friction_ratio > 1.0 {
        let static_friction_ratio = static_friction_ratio.into();
        return Err(refused(Error::StaticFriction { static_friction_ratio }));
    }
    let stiffness = mass.is_none().then(|| if is_free { 0.0 } else { body.stiffness() });
    // Neither is refused as a force that is no number.
    let force = if mass.is_some() { Some(force.unwrap_or(f64::NAN)) } else { force };
    let work = move || design::identify(body.mass(), stiffness, force, &curve, reading);
    let found = left_behind(py, work)?.map_err(refused)?;
    let dict = PyDict::new(py);
    for (name, fitted) in [("force", found.force), ("natural_angular_frequency", found.natural_frequency)] {
        let Some(estimate) = fitted else { continue };
        dict.set_item(name, (estimate.value, estimate.standard_error, estimate.interval()))?;
    }
    for (name, estimate) in [("friction", found.friction_bound), ("damping_ratio", found.damping_ratio)] {
        dict.set_item(name, (estimate.value, estimate.standard_error, estimate.interval()))?;
    }
    let residuals = &found.residuals;
    dict.set_item("noise", found.noise)?;
    dict.set_item("phase_noise", found.phase_noise)?;
    dict.set_item("residuals", residuals.iter().map(|r| r.amplitude).collect::<Vec<_>>())?;
    dict.set_item(
        "phase_residuals",
        residuals.iter().map(|r| r.phase.unwrap_or(f64::NAN)).collect::<Vec<_>>(),
    )?;
    dict.set_item("suspect", residuals.iter().map(|r| r.is_suspect()).collect::<Vec<_>>())?;
    dict.set_item("stops", residuals.iter().map(|r| r.stops).collect::<Vec<_>>())?;
    dict.set_item("phase_kind", found.phase.map(PhaseKind::name))?;
    dict.set_item("search_is_complete", found.search_is_complete)?;
    dict.set_item("better_amplitude_kind", found.better.map(|(kind, _)| kind.name()))?;
    Ok(dict)
}

/// Title, caption and drawing of a figure.
#[pyfunction]
fn figure(py: Python<'_>, name: &str) -> PyResult<(String, String, String)> {
    py.detach(|| {
        let figure = figures::figure(name)
            .ok_or_else(|| refused(format!("figure {name}: must be one of {}", figures::NAMES.join(", "))))?;
        let svg = figure.svg().map_err(refused)?;
        Ok((figure.title, figure.caption, svg))
    })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("FIGURES", figures::NAMES.to_vec())?;
    module.add_function(wrap_pyfunction!(design_each, module)?)?;
    module.add_function(wrap_pyfunction!(best_stiffness, module)?)?;
    module.add_function(wrap_pyfunction!(frictions_for_displacement, module)?)?;
    module.add_function(wrap_pyfunction!(bands, module)?)?;
    module.add_function(wrap_pyfunction!(best_friction_over, module)?)?;
    module.add_function(wrap_pyfunction!(identify, module)?)?;
    module.add_function(wrap_pyfunction!(identify_decay, module)?)?;
    module.add_function(wrap_pyfunction!(identify_motion, module)?)?;
    module.add_function(wrap_pyfunction!(figure, module)?)
}
