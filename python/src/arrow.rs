//! Tables of Arrow, in and out by the PyCapsule interface.

use crate::closed_forms;
use crate::interrupt::{Stop, interruptible};
use crate::motion::{self, Start};
use crate::refused;
use crate::table::Table;
use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, Float64Array, RecordBatch, RecordBatchReader};
use arrow_cast::cast;
use arrow_schema::{ArrowError, DataType, Schema};
use pyo3::prelude::*;
use pyo3_arrow::input::AnyRecordBatch;
use pyo3_arrow::{PyRecordBatch, PyTable};
use std::sync::Arc;

/// The ratios of a batch. Where one is null, so is every answer: NaN is outside of the domain.
struct Points {
    omega: Float64Array,
    alpha: Float64Array,
    damping: Option<Float64Array>,
}

impl Points {
    fn of(batch: &RecordBatch) -> PyResult<Self> {
        let column = |name: &str| batch.column_by_name(name).map(|column| numbers(name, column)).transpose();
        let due = |name: &str| column(name)?.ok_or_else(|| refused(format!("column {name}: is missing")));
        let damping = column("damping_ratio")?.filter(|d| d.values().iter().any(|&d| d != 0.0));
        Ok(Self { omega: due("omega")?, alpha: due("alpha")?, damping })
    }
}

/// A column as numbers: without a copy where it has no null and is of their type.
fn numbers(name: &str, column: &Arc<dyn Array>) -> PyResult<Float64Array> {
    if !column.data_type().is_numeric() && column.data_type() != &DataType::Null {
        return Err(refused(format!("column {name}: has the type {}, must be numbers", column.data_type())));
    }
    let numbers = cast(column, &DataType::Float64).map_err(refused)?;
    let numbers = numbers.as_primitive::<Float64Type>().clone();
    if numbers.null_count() == 0 {
        return Ok(numbers);
    }
    Ok(numbers.iter().map(|x| Some(x.unwrap_or(f64::NAN))).collect())
}

/// Each batch by itself, in order; a batch for a batch, a table for a stream.
fn mapped<'py>(
    py: Python<'py>,
    input: AnyRecordBatch,
    answer: impl Fn(&Points, &Stop) -> Result<Table, String> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let one = |py: Python<'py>, batch: &RecordBatch| -> PyResult<RecordBatch> {
        let points = Points::of(batch)?;
        let table = interruptible(py, |stop| answer(&points, stop))?.map_err(refused)?;
        table.into_batch().map_err(refused)
    };
    match input {
        AnyRecordBatch::RecordBatch(batch) => {
            Ok(PyRecordBatch::new(one(py, batch.as_ref())?).into_pyobject(py)?.into_any())
        }
        AnyRecordBatch::Stream(stream) => {
            let reader: Box<dyn RecordBatchReader + Send> = stream.into_reader()?;
            let empty = RecordBatch::new_empty(reader.schema());
            let schema: Arc<Schema> = one(py, &empty)?.schema();
            let found: PyResult<Vec<RecordBatch>> =
                reader.map(|batch: Result<_, ArrowError>| one(py, &batch.map_err(refused)?)).collect();
            Ok(PyTable::try_new(found?, schema)?.into_pyobject(py)?.into_any())
        }
    }
}

#[pyfunction]
fn arrow_response<'py>(
    py: Python<'py>,
    input: AnyRecordBatch,
    outputs: Vec<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let (columns, regime) = closed_forms::columns(&outputs)?;
    mapped(py, input, |points, stop| {
        let damping = points.damping.as_ref().map(|d| &d.values()[..]);
        Ok(closed_forms::table(points.omega.values(), points.alpha.values(), damping, &columns, regime, stop))
    })
}

#[pyfunction]
fn arrow_steady<'py>(
    py: Python<'py>,
    input: AnyRecordBatch,
    start: Start,
    max_periods: u32,
) -> PyResult<Bound<'py, PyAny>> {
    mapped(py, input, |points, stop| {
        let none = if points.damping.is_none() { vec![0.0; points.omega.len()] } else { Vec::new() };
        let damping = points.damping.as_ref().map_or(&none[..], |d| &d.values()[..]);
        motion::table(points.omega.values(), points.alpha.values(), damping, start, max_periods, stop)
            .map_err(|e| e.to_string())
    })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(arrow_response, module)?)?;
    module.add_function(wrap_pyfunction!(arrow_steady, module)?)
}
