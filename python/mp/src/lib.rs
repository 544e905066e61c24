//! High precision and enclosures for the package `stickslip`, in a package of their own, because they link GMP and MPFR,
//! whose licence is LGPL-3.0-or-later. The public functions are in `stickslip/*.py`.

mod enclosed;
mod wide;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    stickslip_mp,
    Error,
    PyValueError,
    "The library's message, raised as stickslip.Error."
);

/// The library's message as a Python exception.
fn refused(error: impl std::fmt::Display) -> PyErr {
    Error::new_err(error.to_string())
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("Error", module.py().get_type::<Error>())?;
    interrupt::register(module)?;
    enclosed::register(module)?;
    wide::register(module)
}
