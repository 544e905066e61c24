//! Closed forms of the non-sticking cycle, and the border.

use crate::interrupt::{Stop, interruptible};
use crate::points::{Given, Point, Points, Values, ratios};
use crate::refused;
use crate::table::Table;
use numpy::PyReadwriteArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::batch::{Batch, Columns, FixedOmega};
use stickslip::no_stop_force_ratios;
use stickslip::{Error, Output, Regime, Response};

/// Points per task: enough work to justify a task, and little enough to check for signals between tasks.
const TASK: usize = 1 << 13;

/// Names of the regimes by their codes; the last is for points outside the domain.
pub(crate) const REGIMES: [&str; 6] = [
    Regime::Stuck.name(),
    Regime::Sticking.name(),
    Regime::NonSticking.name(),
    Regime::Unbounded.name(),
    Regime::DependsOnStart.name(),
    "invalid",
];

pub(crate) const fn code(regime: Option<Regime>) -> u8 {
    match regime {
        Some(Regime::Stuck) => 0,
        Some(Regime::Sticking) => 1,
        Some(Regime::NonSticking) => 2,
        Some(Regime::Unbounded) => 3,
        Some(Regime::DependsOnStart) => 4,
        None => 5,
    }
}

/// All outputs at one point; an output that does not exist there is `None`.
#[pyfunction]
fn response_at(py: Python<'_>, point: Point) -> PyResult<Bound<'_, PyDict>> {
    let answer = Response::new(ratios(point).map_err(refused)?);
    let dict = PyDict::new(py);
    dict.set_item("regime", answer.regime.name())?;
    dict.set_item("reversals_per_cycle", answer.reversals_per_cycle())?;
    dict.set_item("motion_without_stop", answer.has_motion_without_stop())?;
    dict.set_item("moves_from_rest", answer.ratios.moves_from_rest())?;
    for output in Output::ALL {
        dict.set_item(output.name(), output.of(&answer))?;
    }
    Ok(dict)
}

/// The source of a column.
#[derive(Clone, Copy)]
pub(crate) enum Column {
    Output(Output),
    /// A count or a flag of the whole response, with its name.
    Whole(&'static str, fn(&Response<f64>) -> f64),
}

/// Counts and flags of the whole response as numbers; NaN where they do not exist.
const WHOLE: [Column; 3] = [
    Column::Whole("reversals_per_cycle", |answer| answer.reversals_per_cycle().map_or(f64::NAN, f64::from)),
    Column::Whole("motion_without_stop", |answer| f64::from(u8::from(answer.has_motion_without_stop()))),
    Column::Whole("moves_from_rest", |answer| f64::from(u8::from(answer.ratios.moves_from_rest()))),
];

impl Column {
    const fn name(&self) -> &'static str {
        match self {
            Self::Output(output) => output.name(),
            Self::Whole(name, _) => name,
        }
    }
}

/// The columns asked for by name, and whether the regime is among them.
pub(crate) fn columns(names: &[String]) -> PyResult<(Vec<Column>, bool)> {
    let mut found = Vec::new();
    let mut regime = false;
    for name in names {
        let mut known = WHOLE.into_iter().chain(Output::ALL.map(Column::Output));
        match known.find(|column| column.name() == name) {
            _ if name == "regime" => regime = true,
            Some(column) => found.push(column),
            None => return Err(refused(format!("output {name}: is unknown; see stickslip.OUTPUTS"))),
        }
    }
    Ok((found, regime))
}

/// The slices that receive the outputs, all of the same length.
struct OutputSlices<'a> {
    numbers: Vec<(Column, &'a mut [f64])>,
    regimes: Option<&'a mut [u8]>,
}

impl OutputSlices<'_> {
    fn split_at(self, place: usize) -> (Self, Self) {
        let (mut low, mut high) =
            (Vec::with_capacity(self.numbers.len()), Vec::with_capacity(self.numbers.len()));
        for (column, slice) in self.numbers {
            let (first, second) = slice.split_at_mut(place);
            low.push((column, first));
            high.push((column, second));
        }
        let (first, second) = self.regimes.map(|codes| codes.split_at_mut(place)).unzip();
        (Self { numbers: low, regimes: first }, Self { numbers: high, regimes: second })
    }
}

/// Writes outputs at many points to existing arrays, with NaN for values that do not exist. The regimes go to
/// a separate array, as codes.
#[pyfunction]
fn response_into<'py>(
    py: Python<'py>,
    points: [Given<'py>; 4],
    outputs: Vec<String>,
    mut arrays: Vec<PyReadwriteArray1<'py, f64>>,
    mut regimes: Option<PyReadwriteArray1<'py, u8>>,
) -> PyResult<()> {
    let (columns, _) = columns(&outputs)?;
    let mut places = OutputSlices { numbers: Vec::new(), regimes: None };
    for (column, array) in columns.into_iter().zip(&mut arrays) {
        places.numbers.push((column, array.as_slice_mut()?));
    }
    places.regimes = regimes.as_mut().map(|codes| codes.as_slice_mut()).transpose()?;
    let lengths = places.numbers.iter().map(|(_, slice)| slice.len());
    let n = lengths.chain(places.regimes.as_ref().map(|codes| codes.len())).next().unwrap_or(0);
    let points = Points::of(&points, n)?;
    // Work of less than about a millisecond is not worth handing to other threads.
    let worth = if points.is_plain() { TASK / 2 } else { 256 };
    let filled = if n < worth {
        py.detach(|| fill(points, places, &Stop::never()))
    } else {
        interruptible(py, |stop| fill(points, places, stop))?
    };
    filled.map_err(refused)
}

/// The columns at the given points.
pub(crate) fn table(
    points: Points<'_>,
    columns: &[Column],
    regime: bool,
    stop: &Stop,
) -> Result<Table, Error> {
    let mut numbers: Vec<_> = columns.iter().map(|column| (*column, vec![0.0; points.n])).collect();
    let mut codes = vec![0; if regime { points.n } else { 0 }];
    let places = OutputSlices {
        numbers: numbers.iter_mut().map(|(column, values)| (*column, &mut **values)).collect(),
        regimes: regime.then_some(&mut codes[..]),
    };
    fill(points, places, stop)?;
    let mut table = Table::default();
    for (column, values) in numbers {
        table.number(column.name(), values);
    }
    if regime {
        table.code("regime", codes, &REGIMES);
    }
    Ok(table)
}

/// Fills the places, until `stop` is set.
fn fill(points: Points<'_>, places: OutputSlices<'_>, stop: &Stop) -> Result<(), Error> {
    // A single Ω inside the domain is evaluated once for all points.
    let row = match points.omega {
        Values::One(omega, _) if points.is_plain() && points.n > 1 => FixedOmega::new(omega).ok(),
        Values::One(..) | Values::Many(_) => None,
    };
    let mut room = [Vec::new(), Vec::new()];
    let points = points.with_room(&mut room, points.n.min(TASK));
    halves(points, places, row.as_ref(), stop)
}

/// Halves the points recursively, and distributes the tasks over the available threads.
fn halves(
    points: Points<'_>,
    places: OutputSlices<'_>,
    row: Option<&FixedOmega>,
    stop: &Stop,
) -> Result<(), Error> {
    // Points with damping or static friction are computed one by one, which takes longer.
    let task = if points.is_plain() { TASK } else { TASK / 32 };
    if points.n <= task {
        return if stop.asked().is_break() { Ok(()) } else { fill_task(points, places, row) };
    }
    let half = (points.n / 2).next_multiple_of(task);
    let (low, high) = (points.split_at(half), places.split_at(half));
    let (low, high) = rayon::join(|| halves(low.0, high.0, row, stop), || halves(low.1, high.1, row, stop));
    low.and(high)
}

/// Fills the places of one task.
fn fill_task(
    points: Points<'_>,
    mut places: OutputSlices<'_>,
    row: Option<&FixedOmega>,
) -> Result<(), Error> {
    let mut wanted = Columns::new();
    let mut regimes = vec![None; places.regimes.as_ref().map_or(0, |codes| codes.len())];
    let at = |i: usize| ratios(points.at(i)?).ok();
    for (column, slice) in &mut places.numbers {
        match column {
            Column::Output(output) => wanted = wanted.with(*output, slice),
            Column::Whole(_, value) => {
                for (i, slot) in slice.iter_mut().enumerate() {
                    *slot = at(i).map_or(f64::NAN, |ratios| value(&Response::new(ratios)));
                }
            }
        }
    }
    if places.regimes.is_some() {
        wanted = wanted.with_regime(&mut regimes);
    }
    let batch = Batch::new();
    let (omega, alpha) = points.slices();
    match row {
        _ if !points.is_plain() => batch.run_each(points.n, at, wanted)?,
        Some(row) => batch.run_at(row, alpha, wanted)?,
        None => batch.run(omega, alpha, wanted)?,
    }
    for (slot, regime) in places.regimes.iter_mut().flat_map(|codes| codes.iter_mut()).zip(regimes) {
        *slot = code(regime);
    }
    Ok(())
}

/// The intervals of the force ratio without any stop, as (least, greatest); the greatest is `None` if it does
/// not exist.
#[pyfunction]
fn no_stop(omega: f64, damping_ratio: f64) -> PyResult<Vec<(f64, Option<f64>)>> {
    let found = no_stop_force_ratios(omega, damping_ratio).map_err(refused)?;
    Ok(found.intervals().collect())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("OUTPUTS", Output::ALL.map(Output::name).to_vec())?;
    module.add("REGIMES", REGIMES.to_vec())?;
    module.add_function(wrap_pyfunction!(response_at, module)?)?;
    module.add_function(wrap_pyfunction!(response_into, module)?)?;
    module.add_function(wrap_pyfunction!(no_stop, module)?)
}
