//! The compiled part of the Python package: arrays in, arrays out. The public functions are in
//! `stickslip/*.py`.

mod arrow;
mod attractors;
mod closed_forms;
mod columns;
mod design;
mod machine;
mod motion;
mod points;
mod record;
mod system;
mod table;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    stickslip,
    Error,
    PyValueError,
    "An argument is outside the domain, or a question has no answer."
);

/// The library's message as a Python exception.
fn refused(error: impl std::fmt::Display) -> PyErr {
    Error::new_err(plain(&error.to_string()))
}

/// A message without the letters and signs that a stream of few characters cannot print: the ratios by the names of their
/// arguments.
#[pyfunction]
fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            'Ω' => plain.push_str("omega"),
            'α' => plain.push_str("alpha"),
            'ζ' => plain.push_str("damping_ratio"),
            'η' => plain.push_str("static_friction_ratio"),
            'ω' => plain.push('w'),
            'ε' => plain.push_str("eps"),
            'π' => plain.push_str("pi"),
            'Δ' => plain.push_str("Delta"),
            'µ' | 'μ' => plain.push('u'),
            '≥' => plain.push_str(">="),
            '≤' => plain.push_str("<="),
            '≠' => plain.push_str("!="),
            '±' => plain.push_str("+-"),
            '√' => plain.push_str("sqrt"),
            '∞' => plain.push_str("infinity"),
            '²' => plain.push_str("^2"),
            '³' => plain.push_str("^3"),
            '·' | '×' => plain.push('*'),
            '₀' => plain.push('0'),
            '₁' => plain.push('1'),
            '₂' => plain.push('2'),
            '₊' => plain.push('+'),
            '₋' | '−' | '–' => plain.push('-'),
            '′' | '’' => plain.push('\''),
            '″' | '“' | '”' => plain.push('"'),
            '°' => plain.push_str(" deg"),
            '…' => plain.push_str("..."),
            other => plain.push(other),
        }
    }
    plain
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("Error", module.py().get_type::<Error>())?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(plain, module)?)?;
    arrow::register(module)?;
    interrupt::register(module)?;
    closed_forms::register(module)?;
    motion::register(module)?;
    attractors::register(module)?;
    machine::register(module)?;
    record::register(module)?;
    system::register(module)?;
    design::register(module)
}
