//! Results with error bounds: decimal numbers in, midpoint and radius out.

use crate::refused;
use interrupt::left_behind;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::enclosed::{self, Enclosure, Known, Regime, Response};
use stickslip::float::{Float, Mp};
use stickslip::motion::record::{After, Body, Entry, Record};
use stickslip::{Error, Excitation, Output};

fn known(name: &str, text: &str) -> PyResult<Known> {
    text.parse().map_err(|error| refused(format!("{name} = {text}: {error}")))
}

/// The regime, the bits and the outputs, `None` for those without an enclosure.
fn dict<'py>(py: Python<'py>, found: Result<Response, Error>) -> PyResult<Bound<'py, PyDict>> {
    let found = found.map_err(refused)?;
    let dict = PyDict::new(py);
    dict.set_item("regime", found.regime.map(Regime::name))?;
    dict.set_item("moves_from_rest", found.moves_from_rest)?;
    dict.set_item("bits", found.bits)?;
    for output in Output::ALL {
        dict.set_item(output.name(), found.get(output).map(Enclosure::decimal))?;
    }
    Ok(dict)
}

/// Ω, α, ζ and η, exactly as given.
fn four([omega, alpha, zeta, eta]: &[String; 4]) -> PyResult<[Known; 4]> {
    Ok([
        known("omega", omega)?,
        known("alpha", alpha)?,
        known("damping_ratio", zeta)?,
        known("static_friction_ratio", eta)?,
    ])
}

/// Every output of the closed forms, with its enclosure.
#[pyfunction]
fn enclosed_response<'py>(py: Python<'py>, ratios: [String; 4], bits: u32) -> PyResult<Bound<'py, PyDict>> {
    let [omega, alpha, zeta, eta] = four(&ratios)?;
    dict(
        py,
        left_behind(py, move || {
            enclosed::KnownRatios::new(&omega)
                .with_force_ratio(&alpha)
                .with_damping_ratio(&zeta)
                .with_static_friction_ratio(&eta)
                .response(bits)
        })?,
    )
}

/// The border.
#[pyfunction]
fn enclosed_border<'py>(py: Python<'py>, ratios: [String; 3], bits: u32) -> PyResult<Bound<'py, PyDict>> {
    let [omega, zeta, eta] = &ratios;
    let (omega, zeta) = (known("omega", omega)?, known("damping_ratio", zeta)?);
    let eta = known("static_friction_ratio", eta)?;
    dict(
        py,
        left_behind(py, move || {
            enclosed::KnownRatios::new(&omega)
                .with_damping_ratio(&zeta)
                .with_static_friction_ratio(&eta)
                .response(bits)
        })?,
    )
}

/// A steady motion that is proved to exist, or the reason why there is no proof.
#[pyfunction]
fn enclosed_steady<'py>(py: Python<'py>, ratios: [String; 4], bits: u32) -> PyResult<Bound<'py, PyDict>> {
    let [omega, alpha, zeta, eta] = four(&ratios)?;
    let found = left_behind(py, move || {
        enclosed::KnownRatios::new(&omega)
            .with_force_ratio(&alpha)
            .with_damping_ratio(&zeta)
            .with_static_friction_ratio(&eta)
            .steady(bits)
    })?;
    let dict = PyDict::new(py);
    let found = match found.map_err(refused)? {
        Ok(found) => found,
        Err(why) => {
            dict.set_item("reason", why.to_string())?;
            return Ok(dict);
        }
    };
    for (name, value) in [
        ("max_displacement", &found.max_displacement),
        ("min_displacement", &found.min_displacement),
        ("max_velocity", &found.max_velocity),
        ("min_velocity", &found.min_velocity),
        ("stick_fraction", &found.stick_fraction),
        ("start_phase", &found.start.0),
        ("start_displacement", &found.start.1),
    ] {
        dict.set_item(name, value.decimal())?;
    }
    dict.set_item("symmetric", found.is_symmetric)?;
    dict.set_item("turns_per_cycle", found.turns_per_cycle)?;
    dict.set_item("sticks_per_cycle", found.sticks_per_cycle)?;
    dict.set_item("velocity_zeros_per_cycle", found.velocity_zeros_per_cycle)?;
    let multipliers = found.multipliers.each_ref().map(|(re, im)| (re.decimal(), im.decimal()));
    dict.set_item("multipliers", multipliers.to_vec())?;
    dict.set_item("only_within", found.only_within.1.mid.to_f64())?;
    dict.set_item("bits", found.bits)?;
    Ok(dict)
}

/// The precision at which numbers are read, in words of 64 bits: that of the widest computation.
const WORDS: usize = 65;

/// What an answer of a record is in Python: its midpoint and radius, its number, or none.
#[derive(IntoPyObject)]
enum Answer {
    Value(Option<(String, String)>),
    Count(u64),
}

/// The motion of a body under a record, enclosed: mass, stiffness, damping constant, friction forward and backward, static
/// friction ratio and constant force, and the start.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the body, the record and the start")]
fn enclosed_record<'py>(
    py: Python<'py>,
    body: [f64; 7],
    one_way: bool,
    of: &str,
    times: Vec<f64>,
    samples: Vec<f64>,
    after: &str,
    start: [f64; 2],
    bits: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let number = |value: f64| <Mp<WORDS> as Float>::from_f64(value);
    let excitation = match of {
        "force" => Excitation::Force,
        "foot_displacement" => Excitation::FootMotion,
        "damped_foot_displacement" => Excitation::DampedFootMotion,
        _ => Excitation::SurfaceAcceleration,
    };
    let after = [After::Zero, After::Hold, After::Free].into_iter().find(|own| own.name() == after);
    let found = left_behind(py, move || -> Result<_, Error> {
        let samples: Vec<_> = samples.into_iter().map(number).collect();
        let record = match times.as_slice() {
            [step] => Record::new(excitation, number(*step), samples)?,
            times => Record::at_times(excitation, times.iter().copied().map(number).collect(), samples)?,
        };
        let after = after.unwrap_or_else(|| record.after());
        let record = record.followed_by(after);
        let [mass, stiffness, damping, forward, backward, ratio, mean_force] = body.map(number);
        let body = Body::new(mass, forward)?
            .with_directional_friction(forward, backward)?
            .with_stiffness(stiffness)?
            .with_damping(damping)?
            .with_static_friction_ratio(ratio)?
            .with_mean_force(mean_force)?;
        let body = if one_way { body.one_way() } else { body };
        let [x, v] = start.map(number);
        let found = enclosed::follow(&body, &record, x, v, bits)?;
        let answer = |(name, _, entry): (&'static str, _, Entry<'_, Enclosure>)| match entry {
            Entry::Value(value) => (name, Answer::Value(value.map(Enclosure::decimal))),
            Entry::Count(count) => (name, Answer::Count(count)),
        };
        Ok(found.entries().into_iter().map(answer).collect::<Vec<_>>())
    })?;
    let dict = PyDict::new(py);
    for (name, answer) in found.map_err(refused)? {
        dict.set_item(name, answer)?;
    }
    Ok(dict)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(enclosed_response, module)?)?;
    module.add_function(wrap_pyfunction!(enclosed_border, module)?)?;
    module.add_function(wrap_pyfunction!(enclosed_record, module)?)?;
    module.add_function(wrap_pyfunction!(enclosed_steady, module)?)
}
