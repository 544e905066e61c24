//! Systems of several bodies: descriptions in, answers out as the JSON of the command, samples and grids as arrays.

use crate::record::{in_words, load};
use crate::{plain, refused};
use interrupt::{interruptible, left_behind};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::path::Path;
use std::sync::Arc;
use stickslip::motion::record::Record;
use stickslip::system::State;
use stickslip_front::inputs::units::{Kind, System as Units};
use stickslip_front::system::{
    Answer, Asked, Axis, Cell, Description, Grid, NamedSystem, OfBorder, Units as UnitsOf, Why, decoded,
    parsed,
};
use stickslip_front::text::Folder;

/// Rows that are computed before signals are asked for.
const AT_ONCE: u64 = 16;

/// A described system, and the value of its description, which grids change.
#[pyclass(frozen, module = "stickslip._native")]
struct NativeSystem {
    value: Arc<serde_json::Value>,
    folder: String,
    units: Option<Units>,
    named: Arc<NamedSystem>,
}

fn json(answer: &impl serde::Serialize) -> PyResult<String> {
    serde_json::to_string(answer).map_err(refused)
}

/// The system of a value; where a file that it names is not opened, the error is that of the operating system, too, with the whole message
/// as its attribute.
fn built(
    py: Python<'_>,
    value: &serde_json::Value,
    set: &[(&str, &str)],
    folder: &str,
    units: Option<&Units>,
    about: impl Fn(String) -> String,
) -> PyResult<NamedSystem> {
    let folder = Folder::new(Path::new(folder));
    NamedSystem::in_folder(value, set, &folder, units).map_err(|why| {
        let why = about(why);
        let Some((file, error)) = folder.unopened() else { return refused(why) };
        let what = in_words(&error.to_string());
        let error = PyOSError::new_err((error.raw_os_error(), what, file.into_os_string()));
        match error.value(py).setattr("message", in_words(&plain(&why))) {
            Ok(()) => error,
            Err(other) => other,
        }
    })
}

/// Names with the samples and the times of records.
type Records<'py> = Vec<(String, String, PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>)>;

/// Columns by name, the rows without an answer with their reasons, and the numbers of records and of values on each axis.
type Columns<'py> = (Bound<'py, PyDict>, Vec<(u64, String)>, Vec<usize>);

#[pymethods]
impl NativeSystem {
    /// The system of a text in JSON or TOML, with names of files relative to the folder.
    #[new]
    fn new(py: Python<'_>, text: &str, name: &str, folder: String, units: Option<&str>) -> PyResult<Self> {
        let of_units = |e| refused(format!("units {}: {e}", units.unwrap_or_default()));
        let units: Option<Units> = units.map(|text| text.parse().map_err(of_units)).transpose()?;
        let value = parsed(text, name).map_err(refused)?;
        let about = |e: String| if name.is_empty() { e } else { format!("{name}: {e}") };
        let named = built(py, &value, &[], &folder, units.as_ref(), about)?;
        Ok(Self { value: Arc::new(value), folder, units, named: Arc::new(named) })
    }

    /// The system with other values at some paths.
    fn with_values(&self, py: Python<'_>, set: Vec<(String, String)>) -> PyResult<Self> {
        let typed: Vec<_> = set.iter().map(|(path, new)| (path.as_str(), new.as_str())).collect();
        let named = built(py, &self.value, &typed, &self.folder, self.units.as_ref(), |e| e)?;
        let named = Arc::new(named);
        let mut value = serde_json::Value::clone(&self.value);
        for (path, new) in typed {
            NamedSystem::set(&mut value, path, new).map_err(refused)?;
        }
        Ok(Self { value: Arc::new(value), folder: self.folder.clone(), units: self.units, named })
    }

    /// The names of the coordinates and of the elements, and the system of units.
    fn names(&self) -> (Vec<String>, Vec<String>, Option<String>) {
        let described = &self.named.described;
        let elements = described.model.elements.iter().map(|element| element.name.clone()).collect();
        (described.coordinates.clone(), elements, described.units.map(|units| units.to_string()))
    }

    /// The value that describes the system, as JSON.
    fn value(&self) -> PyResult<String> {
        json(&*self.value)
    }

    /// The description in numbers, as JSON.
    fn describe(&self) -> PyResult<String> {
        json(&Description::new(&self.named))
    }

    /// The units of states by quantity, as JSON; null for matrices.
    fn units_of_states(&self) -> PyResult<String> {
        json(&UnitsOf::states(&self.named.described))
    }

    /// A time in seconds, or in the unit of time of matrices.
    fn time(&self, name: &str, text: &str) -> PyResult<f64> {
        self.named.reader().value(name, text, Kind::Time).map_err(refused)
    }

    /// The system under a record of the base's acceleration.
    fn with_record(
        &self,
        name: &str,
        of: &str,
        times: PyReadonlyArray1<'_, f64>,
        samples: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<Self> {
        let record = load(of, times.as_slice()?, samples.as_slice()?, None)?;
        let named = NamedSystem::clone(&self.named).with_record(&record, name).map_err(refused)?;
        let (value, folder) = (Arc::clone(&self.value), self.folder.clone());
        Ok(Self { value, folder, units: self.units, named: Arc::new(named) })
    }

    /// The end of the last record.
    fn end_of_records(&self) -> f64 {
        self.named.end_of_records()
    }

    fn steady(&self, py: Python<'_>) -> PyResult<String> {
        let named = Arc::clone(&self.named);
        let found = left_behind(py, move || named.steady(&named.described.start))?;
        let (found, digits) = found.map_err(refused)?;
        json(&Answer::steady(&self.named.described, &found).with_digits(digits.as_ref()))
    }

    fn simulate(&self, py: Python<'_>, until: f64) -> PyResult<String> {
        self.named.check_until(until, &format!("until = {until}")).map_err(refused)?;
        let named = Arc::clone(&self.named);
        let found = left_behind(py, move || named.simulate(&named.described.start, until))?;
        let (found, digits) = found.map_err(refused)?;
        json(&Answer::transient(&self.named.described, &found).with_digits(digits.as_ref()))
    }

    /// Displacements, velocities, forces and absolute accelerations at times, row by row, from the start or over a steady
    /// motion. A base that does not move leaves the last one out.
    fn states<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        is_steady: bool,
    ) -> PyResult<[Bound<'py, PyArray1<f64>>; 4]> {
        let times = times.as_slice()?.to_vec();
        if let Some(last) = times.last().filter(|last| **last > 0.0) {
            self.named.check_until(*last, &format!("times up to {last}")).map_err(refused)?;
        }
        let named = Arc::clone(&self.named);
        let work = move || -> Result<[Vec<f64>; 4], Why> {
            let start = match is_steady {
                true => named.steady(&named.described.start)?.0.start,
                false => named.described.start.clone(),
            };
            let states = named.states(&start, &times)?;
            let all = |of: fn(&State<f64>) -> &[f64]| states.iter().flat_map(of).copied().collect();
            let absolute: fn(&State<f64>) -> &[f64] = match named.described.base {
                Some(_) => |state| &state.absolute_acceleration,
                None => |_| &[],
            };
            Ok([
                all(|state| &state.displacement),
                all(|state| &state.velocity),
                all(|state| &state.force),
                all(absolute),
            ])
        };
        let found = left_behind(py, work)?.map_err(refused)?;
        Ok(found.map(|column| column.into_pyarray(py)))
    }

    fn border(&self, py: Python<'_>) -> PyResult<String> {
        let named = Arc::clone(&self.named);
        let (found, cycle) = left_behind(py, move || named.border())?.map_err(refused)?;
        json(&OfBorder::new(&found, cycle.as_ref()))
    }

    /// A row for each place of a grid: names, columns, and the rows without an answer with their reasons. The path of an
    /// axis is `None` for the frequency; the flag says whether it changes together with the axis before it.
    fn grid<'py>(
        &self,
        py: Python<'py>,
        axes: Vec<(Option<String>, Vec<String>, bool)>,
        records: Records<'py>,
        question: &str,
        until: Option<f64>,
    ) -> PyResult<Columns<'py>> {
        let axis = |(path, typed, is_beside): &(Option<String>, Vec<String>, bool)| {
            let found = match (path, typed.as_slice()) {
                // One text may be a range or a list.
                (Some(path), [one]) => Axis::of(path, one).map_err(refused)?,
                (None, [one]) => Axis::of_frequency("frequency", one).map_err(refused)?,
                (path, several) => Axis::of_each(path.as_deref(), several),
            };
            Ok(if *is_beside { found.beside() } else { found })
        };
        let axes = axes.iter().map(axis).collect::<PyResult<Vec<_>>>()?;
        let records = records
            .iter()
            .map(|(name, of, times, samples)| {
                Ok((name.clone(), load(of, times.as_slice()?, samples.as_slice()?, None)?))
            })
            .collect::<PyResult<Vec<(String, Record<f64>)>>>()?;
        let asked = match question {
            "steady" => Asked::Steady,
            "simulate" => Asked::Transient(until),
            "border" => Asked::Border,
            _ => return Err(refused(format!("question {question}: must be steady, simulate or border"))),
        };
        let folder = Path::new(&self.folder);
        let grid =
            Grid::new(&self.value, folder, self.units.as_ref(), axes, &records, asked).map_err(refused)?;
        let count = grid.len();
        let rows = interruptible(py, |stop| {
            let mut rows = Vec::new();
            let mut first = 0;
            while first < count && stop.asked().is_continue() {
                let end = count.min(first + AT_ONCE);
                let some: Vec<_> = (first..end).into_par_iter().map(|row| grid.answer(row)).collect();
                rows.extend(some);
                first = end;
            }
            rows
        })?;
        let mut failed = Vec::new();
        let mut cells: Vec<Vec<Cell<'_>>> = vec![Vec::new(); grid.names().len()];
        for (place, answer) in (0..).zip(rows) {
            let answer = answer.unwrap_or_else(|why| {
                failed.push((place, why));
                grid.blank().to_vec()
            });
            for (column, cell) in cells.iter_mut().zip(grid.given(place).into_iter().chain(answer)) {
                column.push(cell);
            }
        }
        let columns = PyDict::new(py);
        for (name, cells) in grid.names().iter().zip(cells) {
            if cells.iter().any(|cell| matches!(cell, Cell::Text(_))) {
                let text = |cell: &Cell<'_>| match *cell {
                    Cell::Text(text) => text.to_owned(),
                    Cell::Number(_) | Cell::Count(_) => String::new(),
                };
                columns.set_item(name, cells.iter().map(text).collect::<Vec<_>>())?;
                continue;
            }
            let number = |cell: &Cell<'_>| match *cell {
                Cell::Number(number) => number.unwrap_or(f64::NAN),
                Cell::Count(count) => count.map_or(f64::NAN, |count| count as f64),
                Cell::Text(_) => f64::NAN,
            };
            columns.set_item(name, cells.iter().map(number).collect::<Vec<_>>().into_pyarray(py))?;
        }
        Ok((columns, failed, grid.lengths()))
    }
}

/// The text of a file.
#[pyfunction]
fn system_text(bytes: Vec<u8>, name: &str) -> PyResult<String> {
    decoded(bytes, name).map_err(refused)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(system_text, module)?)?;
    module.add_class::<NativeSystem>()
}
