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
    Error::new_err(error.to_string())
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("Error", module.py().get_type::<Error>())?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
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
