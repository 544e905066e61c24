//! Arrow tables, exchanged through the PyCapsule interface.

use crate::closed_forms;
use crate::motion::{self, Start};
use crate::points::{Points, Values};
use crate::refused;
use arrow_array::cast::AsArray;
use arrow_array::ffi::{FFI_ArrowArray, FFI_ArrowSchema};
use arrow_array::ffi_stream::{ArrowArrayStreamReader, FFI_ArrowArrayStream};
use arrow_array::types::*;
use arrow_array::{
    Array, ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, RecordBatchReader, StructArray,
};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use core::ffi::CStr;
use interrupt::{Stop, interruptible};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use std::sync::Arc;
use stickslip::Error;

/// The ratios of a batch; ζ and η are optional. A null becomes NaN, which is outside the domain, so that all
/// outputs of its row are null.
struct Columns {
    omega: Float64Array,
    alpha: Float64Array,
    damping: Option<Float64Array>,
    static_friction: Option<Float64Array>,
}

impl Columns {
    fn of(batch: &RecordBatch) -> PyResult<Self> {
        let column = |name: &str| batch.column_by_name(name).map(|column| numbers(name, column)).transpose();
        let due = |name: &str| column(name)?.ok_or_else(|| refused(format!("column {name}: is missing")));
        // A column of default values is dropped, so that the batch kernels apply.
        let or_none = |name: &str, none: f64| {
            Ok::<_, PyErr>(column(name)?.filter(|values| values.values().iter().any(|&x| x != none)))
        };
        Ok(Self {
            omega: due("omega")?,
            alpha: due("alpha")?,
            damping: or_none("damping_ratio", 0.0)?,
            static_friction: or_none("static_friction_ratio", 1.0)?,
        })
    }

    fn points(&self) -> Points<'_> {
        fn or(column: Option<&Float64Array>, none: f64) -> Values<'_> {
            column.map_or(Values::One(none, &[]), |column| Values::Many(column.values()))
        }
        Points {
            omega: Values::Many(self.omega.values()),
            alpha: Values::Many(self.alpha.values()),
            damping: or(self.damping.as_ref(), 0.0),
            static_friction: or(self.static_friction.as_ref(), 1.0),
            n: self.omega.len(),
            start: [Values::One(0.0, &[]); 3],
        }
    }
}

/// A column as 64-bit floats, with NaN for null. A column of 64-bit floats without nulls is not copied.
fn numbers(name: &str, column: &Arc<dyn Array>) -> PyResult<Float64Array> {
    /// `as` rounds every integer of these types to the nearest float.
    macro_rules! rounded {
        ($($kind:ident $of:ident),*) => {
            match column.data_type() {
                DataType::Float64 => column.as_primitive::<Float64Type>().clone(),
                $(DataType::$kind => column.as_primitive::<$of>().unary(|x| x as f64),)*
                // Literals in SQL have this type.
                DataType::Decimal128(_, places) => {
                    let unit = 10f64.powi(i32::from(*places));
                    column.as_primitive::<Decimal128Type>().unary(|x| x as f64 / unit)
                }
                DataType::Null => Float64Array::new_null(column.len()),
                other => return Err(refused(format!("column {name}: has the type {other}, must be numbers"))),
            }
        };
    }
    let numbers: Float64Array = rounded!(
        Float32 Float32Type, Int8 Int8Type, Int16 Int16Type, Int32 Int32Type, Int64 Int64Type,
        UInt8 UInt8Type, UInt16 UInt16Type, UInt32 UInt32Type, UInt64 UInt64Type
    );
    if numbers.null_count() == 0 {
        return Ok(numbers);
    }
    Ok(numbers.iter().map(|x| Some(x.unwrap_or(f64::NAN))).collect())
}

/// A batch of results, which any Arrow library takes over without a copy.
#[pyclass(frozen, module = "stickslip.arrow")]
struct Batch(RecordBatch);

#[pymethods]
impl Batch {
    /// The interface of Arrow: schema and array. A requested schema is ignored: the caller converts.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_array__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyCapsule>, Bound<'py, PyCapsule>)> {
        let _ = requested_schema;
        let array = FFI_ArrowArray::new(&StructArray::from(self.0.clone()).to_data());
        Ok((schema(py, self.0.schema_ref())?, PyCapsule::new_with_value(py, array, c"arrow_array")?))
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        schema(py, self.0.schema_ref())
    }

    fn __len__(&self) -> usize {
        self.0.num_rows()
    }

    fn __repr__(&self) -> String {
        format!("<stickslip.arrow.Batch of {} rows: {}>", self.0.num_rows(), names(self.0.schema_ref()))
    }
}

/// A table of results, which any Arrow library takes over without a copy.
#[pyclass(frozen, module = "stickslip.arrow", name = "Table")]
struct Batches {
    schema: Arc<Schema>,
    batches: Vec<RecordBatch>,
}

#[pymethods]
impl Batches {
    /// The interface of Arrow: a stream of arrays.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let _ = requested_schema;
        let batches = self.batches.clone().into_iter().map(Ok);
        let reader = RecordBatchIterator::new(batches, self.schema.clone());
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), c"arrow_array_stream")
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        schema(py, &self.schema)
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    fn __repr__(&self) -> String {
        format!("<stickslip.arrow.Table of {} rows: {}>", self.__len__(), names(&self.schema))
    }
}

fn schema<'py>(py: Python<'py>, schema: &Schema) -> PyResult<Bound<'py, PyCapsule>> {
    let schema = FFI_ArrowSchema::try_from(schema).map_err(refused)?;
    PyCapsule::new_with_value(py, schema, c"arrow_schema")
}

fn names(schema: &Schema) -> String {
    schema.fields().iter().map(|field| field.name().as_str()).collect::<Vec<_>>().join(", ")
}

/// A table as any library gives it through the PyCapsule interface.
enum Given {
    Batch(RecordBatch),
    Stream(ArrowArrayStreamReader),
}

/// Takes the structure out of a capsule by `take`, one of the functions `from_raw` of arrow-array, which leaves a released
/// structure behind.
fn taken<T>(capsule: &Bound<'_, PyAny>, name: &CStr, take: unsafe fn(*mut T) -> T) -> PyResult<T> {
    let pointer = capsule.cast::<PyCapsule>()?.pointer_checked(Some(name))?;
    // SAFETY: by the PyCapsule interface a capsule of this name holds a valid structure of this type until it is taken, and
    // the capsule outlives this call.
    Ok(unsafe { take(pointer.as_ptr().cast()) })
}

fn given(input: &Bound<'_, PyAny>) -> PyResult<Given> {
    if input.hasattr("__arrow_c_array__")? {
        let (schema, array): (Bound<'_, PyAny>, Bound<'_, PyAny>) =
            input.call_method0("__arrow_c_array__")?.extract()?;
        let schema = taken(&schema, c"arrow_schema", FFI_ArrowSchema::from_raw)?;
        let array = taken(&array, c"arrow_array", FFI_ArrowArray::from_raw)?;
        // SAFETY: the array and its schema come from one call, and are what the interface prescribes.
        let data = unsafe { arrow_array::ffi::from_ffi(array, &schema) }.map_err(refused)?;
        if !matches!(data.data_type(), DataType::Struct(_)) || data.null_count() > 0 {
            return Err(refused(format!(
                "table: has the type {}, must be a batch of rows",
                data.data_type()
            )));
        }
        return Ok(Given::Batch(RecordBatch::from(StructArray::from(data))));
    }
    if input.hasattr("__arrow_c_stream__")? {
        let stream = input.call_method0("__arrow_c_stream__")?;
        let stream = taken(&stream, c"arrow_array_stream", FFI_ArrowArrayStream::from_raw)?;
        return Ok(Given::Stream(ArrowArrayStreamReader::try_new(stream).map_err(refused)?));
    }
    let of = input.get_type().name()?;
    Err(PyTypeError::new_err(format!(
        "table: must have __arrow_c_array__ or __arrow_c_stream__, as tables of Arrow and polars have, not {of}"
    )))
}

/// Computes the answer to each batch in order, and puts it beside the columns of the batch. A batch gives a batch, and
/// a stream gives a table.
fn mapped<'py>(
    py: Python<'py>,
    input: &Bound<'py, PyAny>,
    answer: impl Fn(Points<'_>, &Stop) -> Result<Vec<(String, ArrayRef)>, Error> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let one = |py: Python<'py>, batch: &RecordBatch| -> PyResult<RecordBatch> {
        let columns = Columns::of(batch)?;
        let found = interruptible(py, |stop| answer(columns.points(), stop))?.map_err(refused)?;
        let (mut fields, mut arrays) = (batch.schema().fields().to_vec(), batch.columns().to_vec());
        for (name, array) in found {
            if batch.column_by_name(&name).is_some() {
                return Err(refused(format!(
                    "column {name}: is in the table, too. Rename it, or leave it out"
                )));
            }
            fields.push(Arc::new(Field::new(name, array.data_type().clone(), true)));
            arrays.push(array);
        }
        RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays).map_err(refused)
    };
    match given(input)? {
        Given::Batch(batch) => Ok(Batch(one(py, &batch)?).into_pyobject(py)?.into_any()),
        Given::Stream(reader) => {
            let empty = RecordBatch::new_empty(reader.schema());
            let schema: Arc<Schema> = one(py, &empty)?.schema();
            let found: PyResult<Vec<RecordBatch>> =
                reader.map(|batch: Result<_, ArrowError>| one(py, &batch.map_err(refused)?)).collect();
            Ok(Batches { schema, batches: found? }.into_pyobject(py)?.into_any())
        }
    }
}

#[pyfunction]
fn arrow_response<'py>(
    py: Python<'py>,
    input: &Bound<'py, PyAny>,
    outputs: Vec<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let rows = closed_forms::rows(&outputs)?;
    mapped(py, input, |points, stop| Ok(closed_forms::stored(points, &rows, stop)?.into_arrays()))
}

#[pyfunction]
fn arrow_steady<'py>(
    py: Python<'py>,
    input: &Bound<'py, PyAny>,
    outputs: Vec<String>,
    start: Start,
    max_periods: u32,
) -> PyResult<Bound<'py, PyAny>> {
    let rows = motion::rows(&outputs)?;
    mapped(py, input, |points, stop| {
        Ok(motion::stored(points, &rows, start, max_periods, stop)?.into_arrays())
    })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(arrow_response, module)?)?;
    module.add_function(wrap_pyfunction!(arrow_steady, module)?)
}
