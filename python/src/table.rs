//! Named columns of numbers, for NumPy or Arrow.

use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::ArrowError;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// A column of words, as indices into a list whose last entry stands for a missing value in Arrow.
type Codes = (&'static str, Vec<u8>, &'static [&'static str]);

/// Named columns; NaN and −1 stand for values that do not exist.
#[derive(Default)]
pub(crate) struct Table {
    numbers: Vec<(&'static str, Vec<f64>)>,
    codes: Vec<Codes>,
    counts: Vec<(&'static str, Vec<i64>)>,
}

impl Table {
    pub(crate) fn number(&mut self, name: &'static str, column: Vec<f64>) {
        self.numbers.push((name, column));
    }

    pub(crate) fn code(&mut self, name: &'static str, column: Vec<u8>, words: &'static [&'static str]) {
        self.codes.push((name, column, words));
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
        for (name, column, _) in self.codes {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        for (name, column) in self.counts {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        Ok(dict)
    }

    /// An Arrow batch, with nulls for values that do not exist.
    pub(crate) fn into_batch(self) -> Result<RecordBatch, ArrowError> {
        let mut columns: Vec<(&str, ArrayRef)> = Vec::new();
        for (name, column, words) in self.codes {
            let last = words.len().saturating_sub(1);
            let word =
                |&code: &u8| words.get(usize::from(code)).copied().filter(|_| usize::from(code) < last);
            columns.push((name, Arc::new(column.iter().map(word).collect::<StringArray>())));
        }
        for (name, column) in self.numbers {
            let values = column.iter().map(|x| (!x.is_nan()).then_some(*x));
            columns.push((name, Arc::new(values.collect::<Float64Array>())));
        }
        for (name, column) in self.counts {
            let values = column.iter().map(|&n| (n >= 0).then_some(n));
            columns.push((name, Arc::new(values.collect::<Int64Array>())));
        }
        RecordBatch::try_from_iter_with_nullable(
            columns.into_iter().map(|(name, column)| (name, column, true)),
        )
    }
}
