//! Named columns of numbers, for NumPy.

use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Named columns; NaN stands for a value that does not exist.
#[derive(Default)]
pub(crate) struct Table {
    numbers: Vec<(&'static str, Vec<f64>)>,
    codes: Vec<(&'static str, Vec<u8>)>,
    counts: Vec<(&'static str, Vec<i64>)>,
}

impl Table {
    pub(crate) fn number(&mut self, name: &'static str, column: Vec<f64>) {
        self.numbers.push((name, column));
    }

    /// A column of words, as indices into a list of Python.
    pub(crate) fn code(&mut self, name: &'static str, column: Vec<u8>) {
        self.codes.push((name, column));
    }

    pub(crate) fn count(&mut self, name: &'static str, column: Vec<i64>) {
        self.counts.push((name, column));
    }

    /// A dictionary of arrays, which take the columns over without a copy.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        for (name, column) in self.numbers {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        for (name, column) in self.codes {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        for (name, column) in self.counts {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        Ok(dict)
    }
}
