//! Closed forms of the non-sticking cycle, and the border.

use crate::columns::{self, Kind, Places, Row, Slot, Store, Target, halves, named};
use crate::machine::excitation;
use crate::points::{Given, Point, Points, ratios};
use crate::refused;
use interrupt::{Stop, interruptible};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::LazyLock;
use stickslip::batch::Batch;
use stickslip::internal::definitions::REGIME;
use stickslip::internal::{ResponseAnswer, Value};
use stickslip::{Error, Excitation, NoStop, Output, Ratios, Regime, Response};

/// Points per task: enough work to justify a task, and little enough to check for signals between tasks.
const TASK: usize = 1 << 13;

/// Names of the regimes by their codes; the last is for points outside the domain.
pub(crate) const REGIMES: [&str; Regime::ALL.len() + 1] = {
    let [a, b, c, d, e] = Regime::ALL;
    [a.name(), b.name(), c.name(), d.name(), e.name(), "invalid"]
};

/// The source of a column.
#[derive(Clone, Copy)]
pub(crate) enum Column {
    Output(Output),
    /// Another column of the answer, by its place.
    Other(usize),
}

/// The answer of which a column is a value.
const fn answer(response: &Response<f64>) -> ResponseAnswer<'_, f64> {
    ResponseAnswer { response, peaks: true }
}

/// The value of the answer's column at a place.
fn at_place(answer: &ResponseAnswer<'_, f64>, place: usize) -> Option<Value<f64>> {
    ResponseAnswer::COLUMNS.get(place).map(|column| (column.of)(answer))
}

/// The place of a definition among the answer's columns.
fn place_of(name: &str) -> Option<usize> {
    ResponseAnswer::<f64>::COLUMNS.iter().position(|column| column.definition.name == name)
}

impl Column {
    /// The values under an excitation: the loops of plain points know none, and searched values depend on it.
    fn under(self, excitation: Option<Excitation>) -> Self {
        match self {
            Self::Output(output) if excitation.is_some() && output.definition().is_searched => {
                place_of(output.name()).map_or(self, Self::Other)
            }
            own => own,
        }
    }

    fn value(self, response: &Response<f64>) -> Option<Value<f64>> {
        match self {
            Self::Output(output) => Some(Value::Number(output.of(response))),
            Self::Other(place) => at_place(&answer(response), place),
        }
    }
}

/// The ratios under an excitation, if there is one.
pub(crate) fn under(ratios: Ratios<f64>, excitation: Option<Excitation>) -> Ratios<f64> {
    excitation.map_or(ratios, |excitation| ratios.with_excitation(excitation))
}

/// Every output of a response: those that are not an [`Output`], and then these.
static ROWS: LazyLock<Vec<Row<Column>>> = LazyLock::new(|| {
    let mut rows = Vec::new();
    let example = Ratios::new(1.5, 2.5).map(Response::new).ok();
    for (place, column) in ResponseAnswer::<f64>::COLUMNS.iter().enumerate() {
        let is_output = Output::ALL.iter().any(|output| output.name() == column.definition.name);
        let value = example.as_ref().and_then(|response| at_place(&answer(response), place));
        if let Some(value) = value.filter(|_| !is_output) {
            let kind = Kind::of(&value, &REGIMES);
            rows.push(Row { definition: column.definition, kind, column: Column::Other(place) });
        }
    }
    let output = |output: Output| Row {
        definition: output.definition(),
        kind: Kind::Number,
        column: Column::Output(output),
    };
    rows.extend(Output::ALL.map(output));
    rows
});

/// The outputs of these names.
pub(crate) fn rows(names: &[String]) -> PyResult<Vec<Row<Column>>> {
    named(&ROWS, names)
}

/// Chosen outputs at one point under an excitation.
#[pyfunction]
fn response_at<'py>(
    py: Python<'py>,
    point: Point,
    kind: Option<&str>,
    outputs: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let (rows, kind) = (rows(&outputs)?, kind.map(excitation).transpose()?);
    let response = Response::new(under(ratios(point).map_err(refused)?, kind));
    let dict = PyDict::new(py);
    for row in rows {
        if let Some(value) = row.column.value(&response) {
            columns::set(&dict, row.definition.name, value)?;
        }
    }
    Ok(dict)
}

/// Writes outputs at many points under an excitation to existing arrays.
#[pyfunction]
fn response_into<'py>(
    py: Python<'py>,
    points: [Given<'py>; 4],
    n: usize,
    kind: Option<&str>,
    outputs: Vec<String>,
    mut arrays: Vec<Target<'py>>,
) -> PyResult<()> {
    let kind = kind.map(excitation).transpose()?;
    let points = Points::of(&points, n)?;
    let places = Places::of(rows(&outputs)?, &mut arrays, n)?;
    // Work of less than about a millisecond is not worth handing to other threads.
    let worth = if points.is_plain() { TASK / 2 } else { 256 };
    let filled = if n < worth {
        py.detach(|| fill(points, places, kind, &Stop::never()))
    } else {
        interruptible(py, |stop| fill(points, places, kind, stop))?
    };
    filled.map_err(refused)
}

/// The outputs at the given points, in memory of their own.
pub(crate) fn stored(points: Points<'_>, rows: &[Row<Column>], stop: &Stop) -> Result<Store<Column>, Error> {
    let mut store = Store::new(rows.to_vec(), points.n);
    fill(points, store.places(), None, stop)?;
    Ok(store)
}

/// Fills the places, until `stop` is set.
fn fill(
    points: Points<'_>,
    mut places: Places<'_, Column>,
    excitation: Option<Excitation>,
    stop: &Stop,
) -> Result<(), Error> {
    for (row, _) in &mut places.0 {
        row.column = row.column.under(excitation);
    }
    let mut room = [Vec::new(), Vec::new()];
    let points = points.with_room(&mut room, points.n.min(TASK));
    // Points with damping or static friction are computed one by one, which takes longer.
    let task = if points.is_plain() { TASK } else { TASK / 32 };
    halves(points, places, task, stop, &|points, places| fill_task(points, places, excitation))
}

/// Fills the places of one task.
fn fill_task(
    points: Points<'_>,
    places: Places<'_, Column>,
    excitation: Option<Excitation>,
) -> Result<(), Error> {
    let mut batch = Batch::new();
    let mut regimes = Vec::new();
    let (mut codes, mut others) = (None, Vec::new());
    let at = |i: usize| ratios(points.at(i)?).ok().map(|ratios| under(ratios, excitation));
    for (row, slot) in places.0 {
        match (row.column, slot) {
            (Column::Output(output), Slot::Numbers(values)) => batch = batch.with(output, values),
            (Column::Other(_), Slot::Codes(own)) if row.definition.name == REGIME.name => codes = Some(own),
            (_, slot) => others.push((row, slot)),
        }
    }
    if codes.is_some() {
        regimes.resize(points.n, None);
        batch = batch.with_regime(&mut regimes);
    }
    let (omega, alpha) = points.slices();
    if points.is_plain() {
        batch.run(omega, alpha)?;
    } else {
        batch.run_each(points.n, at)?;
    }
    for (slot, regime) in codes.into_iter().flatten().zip(regimes) {
        *slot = code(regime);
    }
    if !others.is_empty() {
        let mut others = Places(others);
        for i in 0..points.n {
            let response = at(i).map(Response::new);
            others.put(i, |column| column.value(response.as_ref()?));
        }
    }
    Ok(())
}

/// The place of a regime among [`REGIMES`].
fn code(regime: Option<Regime>) -> u8 {
    let place = Regime::ALL.iter().position(|own| Some(*own) == regime).unwrap_or(Regime::ALL.len());
    place as u8
}

/// The intervals of the force ratio without any stop, as (least, greatest); the greatest is `None` if it does
/// not exist.
#[pyfunction]
fn no_stop(omega: f64, damping_ratio: f64) -> PyResult<Vec<(f64, Option<f64>)>> {
    let ratios = Ratios::new(omega, 1.0).and_then(|at| at.with_damping_ratio(damping_ratio));
    Ok(NoStop::of(&ratios.map_err(refused)?).intervals().collect())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("RESPONSE", columns::told(&ROWS))?;
    module.add("OUTPUTS", Output::ALL.map(Output::name).to_vec())?;
    module.add("REGIMES", REGIMES.to_vec())?;
    module.add_function(wrap_pyfunction!(response_at, module)?)?;
    module.add_function(wrap_pyfunction!(response_into, module)?)?;
    module.add_function(wrap_pyfunction!(no_stop, module)?)
}
