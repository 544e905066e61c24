//! Results with error bounds: decimal numbers in, midpoint and radius out.

use crate::refused;
use interrupt::left_behind;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::enclosed::{self, Enclosure, Known, Regime, Response};
use stickslip::{Error, Output};

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
    dict(py, left_behind(py, move || enclosed::response(&omega, &alpha, &zeta, &eta, bits))?)
}

/// The border.
#[pyfunction]
fn enclosed_border<'py>(py: Python<'py>, ratios: [String; 3], bits: u32) -> PyResult<Bound<'py, PyDict>> {
    let [omega, zeta, eta] = &ratios;
    let (omega, zeta) = (known("omega", omega)?, known("damping_ratio", zeta)?);
    let eta = known("static_friction_ratio", eta)?;
    dict(py, left_behind(py, move || enclosed::border(&omega, &zeta, &eta, bits))?)
}

/// A steady motion that is proved to exist, or the reason why there is no proof.
#[pyfunction]
fn enclosed_steady<'py>(py: Python<'py>, ratios: [String; 4], bits: u32) -> PyResult<Bound<'py, PyDict>> {
    let [omega, alpha, zeta, eta] = four(&ratios)?;
    let found = left_behind(py, move || enclosed::steady(&omega, &alpha, &zeta, &eta, bits))?;
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

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(enclosed_response, module)?)?;
    module.add_function(wrap_pyfunction!(enclosed_border, module)?)?;
    module.add_function(wrap_pyfunction!(enclosed_steady, module)?)
}
