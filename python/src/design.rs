//! Design of a machine, its identification from a measured curve, and figures.

use crate::machine::{Body, body, excitation};
use crate::refused;
use interrupt::left_behind;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::design::{
    self, Aim, AmplitudeKind, Edge, Measurement, OptimumKind, PhaseKind, Reading, TurningPoints,
};
use stickslip::uncertainty::Estimate;
use stickslip::{Drive, Error};
use stickslip_figures as figures;

/// The minimum amplitude of an excitation at which the body does not stick, at a given frequency.
#[pyfunction]
fn min_amplitude(of: Body, kind: &str, angular_frequency: f64) -> PyResult<f64> {
    let kind = excitation(kind)?;
    body(of).and_then(|body| design::min_amplitude(&body, kind, angular_frequency)).map_err(refused)
}

/// The force whose cycle has a given maximum displacement or velocity.
#[pyfunction]
fn force_for(of: Body, angular_frequency: f64, target: f64, is_velocity: bool) -> PyResult<f64> {
    let force = |body| {
        if is_velocity {
            design::force_for_velocity(&body, angular_frequency, target)
        } else {
            design::force_for_displacement(&body, angular_frequency, target)
        }
    };
    body(of).and_then(force).map_err(refused)
}

/// The drive of a body by kind, amplitude and angular frequency.
fn drive(kind: &str, amplitude: f64, angular_frequency: f64) -> PyResult<Drive<f64>> {
    Drive::new(excitation(kind)?, amplitude, angular_frequency).map_err(refused)
}

/// The maximum friction bound with which the body does not stick.
#[pyfunction]
fn max_friction(of: Body, kind: &str, amplitude: f64, angular_frequency: f64) -> PyResult<f64> {
    let drive = drive(kind, amplitude, angular_frequency)?;
    body(of).and_then(|body| design::max_friction(&body, &drive)).map_err(refused)
}

/// The friction bound that dissipates most, the energy of a cycle, and the kind of optimum.
#[pyfunction]
fn best_friction(
    of: Body,
    kind: &str,
    amplitude: f64,
    angular_frequency: f64,
) -> PyResult<(f64, f64, &'static str)> {
    let drive = drive(kind, amplitude, angular_frequency)?;
    let best = body(of).and_then(|body| design::most_dissipating_friction(&body, &drive)).map_err(refused)?;
    let why = if best.kind == OptimumKind::Interior { "interior" } else { "border" };
    Ok((best.at, best.value, why))
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
    let work = move || design::frequency_bands(&body, &drive, low, high)?.collect::<Result<Vec<_>, Error>>();
    let found = left_behind(py, work)?;
    let cut = |edge| edge == Edge::Range;
    Ok(found
        .map_err(refused)?
        .into_iter()
        .map(|b| (b.low, b.high, cut(b.low_edge), cut(b.high_edge)))
        .collect())
}

/// Friction, greatest amplitude, the ranges of frequency that have it, the kind of optimum, and the friction at rest.
type FoundFriction = (f64, f64, Vec<(f64, f64)>, &'static str, f64);

/// The friction bound with the least greatest amplitude over a band: friction, greatest amplitude, the frequencies that
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
    let work = move || design::best_friction_over_band(&body, &drive, low, high, aim);
    let found = left_behind(py, work)?.map_err(refused)?;
    Ok((found.friction, found.greatest, found.at, found.kind.name(), found.rest))
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

/// The kind of this name.
fn kind<K: Copy>(argument: &str, text: &str, kinds: &[K], name: impl Fn(K) -> &'static str) -> PyResult<K> {
    kinds.iter().copied().find(|&kind| name(kind) == text).ok_or_else(|| {
        let names: Vec<_> = kinds.iter().map(|&kind| name(kind)).collect();
        refused(format!("{argument} {text}: must be one of {}", names.join(", ")))
    })
}

/// Friction bound and damping ratio from a response curve, each with its standard error and 95 % interval.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "those of the Python function")]
fn identify<'py>(
    py: Python<'py>,
    of: Body,
    force: f64,
    angular_frequency: PyReadonlyArray1<'py, f64>,
    amplitude: PyReadonlyArray1<'py, f64>,
    phase: Option<PyReadonlyArray1<'py, f64>>,
    amplitude_kind: &str,
    phase_kind: Option<&str>,
) -> PyResult<Bound<'py, PyDict>> {
    let body = body(of).map_err(refused)?;
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
    let work = move || design::identify_as(&body, force, &curve, reading);
    let found = left_behind(py, work)?.map_err(refused)?;
    let dict = PyDict::new(py);
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
    dict.set_item("better_amplitude_kind", found.better.map(|better| better.amplitude.name()))?;
    Ok(dict)
}

/// Title, caption and drawing of a figure.
#[pyfunction]
fn figure(py: Python<'_>, name: &str) -> PyResult<(String, String, String)> {
    py.detach(|| {
        let figure = figures::figure(name).ok_or_else(|| {
            refused(format!("figure {name}: is none; there are {}", figures::NAMES.join(", ")))
        })?;
        let svg = figure.svg().map_err(refused)?;
        Ok((figure.title, figure.caption, svg))
    })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("FIGURES", figures::NAMES.to_vec())?;
    module.add_function(wrap_pyfunction!(min_amplitude, module)?)?;
    module.add_function(wrap_pyfunction!(max_friction, module)?)?;
    module.add_function(wrap_pyfunction!(best_friction, module)?)?;
    module.add_function(wrap_pyfunction!(force_for, module)?)?;
    module.add_function(wrap_pyfunction!(bands, module)?)?;
    module.add_function(wrap_pyfunction!(best_friction_over, module)?)?;
    module.add_function(wrap_pyfunction!(identify, module)?)?;
    module.add_function(wrap_pyfunction!(identify_decay, module)?)?;
    module.add_function(wrap_pyfunction!(figure, module)?)
}
