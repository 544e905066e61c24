//! Closed forms of the non-sticking cycle, and the border.

use crate::interrupt::{Stop, interruptible};
use crate::refused;
use crate::table::Table;
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use stickslip::batch::{Batch, Columns, LengthMismatch};
use stickslip::regime::no_stop_force_ratios;
use stickslip::{Output, Ratios, Regime, Response};

/// Points between two looks for a signal.
const CHUNK: usize = 1 << 16;

/// Names of the regimes by their codes; the last is for points outside the domain.
pub(crate) const REGIMES: [&str; 5] = [
    Regime::Stuck.name(),
    Regime::Sticking.name(),
    Regime::NonSticking.name(),
    Regime::Unbounded.name(),
    "invalid",
];

pub(crate) const fn code(regime: Option<Regime>) -> u8 {
    match regime {
        Some(Regime::Stuck) => 0,
        Some(Regime::Sticking) => 1,
        Some(Regime::NonSticking) => 2,
        Some(Regime::Unbounded) => 3,
        None => 4,
    }
}

pub(crate) fn ratios(omega: f64, alpha: f64, damping_ratio: f64) -> Result<Ratios<f64>, stickslip::Error> {
    let ratios = Ratios::new(omega, alpha)?;
    if damping_ratio == 0.0 { Ok(ratios) } else { ratios.with_damping_ratio(damping_ratio) }
}

/// All outputs at one point, `None` for what does not exist there.
#[pyfunction]
fn response_at<'py>(
    py: Python<'py>,
    omega: f64,
    alpha: f64,
    damping_ratio: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let answer = Response::new(ratios(omega, alpha, damping_ratio).map_err(refused)?);
    let dict = PyDict::new(py);
    dict.set_item("regime", answer.regime().name())?;
    dict.set_item("reversals_per_cycle", answer.reversals_per_cycle())?;
    dict.set_item("best_force_ratio_slides", answer.best_is_reached())?;
    for output in Output::ALL {
        dict.set_item(output.name(), output.of(&answer))?;
    }
    Ok(dict)
}

/// What a column is made by.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Column {
    Output(Output),
    Reversals,
}

/// The columns asked for by name, and whether the regime is among them.
pub(crate) fn columns(names: &[String]) -> PyResult<(Vec<Column>, bool)> {
    let mut found = Vec::new();
    let mut regime = false;
    for name in names {
        match (name.as_str(), Output::ALL.into_iter().find(|output| output.name() == name)) {
            ("regime", _) => regime = true,
            ("reversals_per_cycle", _) => found.push(Column::Reversals),
            (_, Some(output)) => found.push(Column::Output(output)),
            (_, None) => return Err(refused(format!("output {name}: is none; see stickslip.OUTPUTS"))),
        }
    }
    Ok((found, regime))
}

/// Columns of outputs at many points, NaN for what does not exist there.
#[pyfunction]
fn response_columns<'py>(
    py: Python<'py>,
    omega: PyReadonlyArray1<'py, f64>,
    alpha: PyReadonlyArray1<'py, f64>,
    damping_ratio: Option<PyReadonlyArray1<'py, f64>>,
    outputs: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let (columns, regime) = columns(&outputs)?;
    let (omega, alpha) = (omega.as_slice()?, alpha.as_slice()?);
    let damping = damping_ratio.as_ref().map(|d| d.as_slice()).transpose()?;
    if omega.len() != alpha.len() || damping.is_some_and(|d| d.len() != omega.len()) {
        return Err(refused("columns of different lengths"));
    }
    let work = |stop: &Stop| table(omega, alpha, damping, &columns, regime, stop);
    let table = if omega.len() < 512 { py.detach(|| work(&Stop::never())) } else { interruptible(py, work)? };
    table.into_dict(py)
}

/// Outputs at many points, written to arrays that are there.
#[pyfunction]
fn response_into<'py>(
    py: Python<'py>,
    omega: PyReadonlyArray1<'py, f64>,
    alpha: PyReadonlyArray1<'py, f64>,
    damping_ratio: Option<PyReadonlyArray1<'py, f64>>,
    outputs: Vec<String>,
    mut arrays: Vec<PyReadwriteArray1<'py, f64>>,
) -> PyResult<()> {
    let (columns, _) = columns(&outputs)?;
    let (omega, alpha) = (omega.as_slice()?, alpha.as_slice()?);
    let damping = damping_ratio.as_ref().map(|d| d.as_slice()).transpose()?;
    let mut numbers = Vec::new();
    for (column, array) in columns.iter().zip(&mut arrays) {
        if let Column::Output(output) = column {
            numbers.push((*output, array.as_slice_mut()?));
        }
    }
    interruptible(py, |stop| fill(omega, alpha, damping, &mut numbers, &mut [], stop))?
        .map_err(|mismatch| refused(mismatch.to_string()))
}

/// The columns at points of one length, whose damping ratios are all 0 where they are not given.
pub(crate) fn table(
    omega: &[f64],
    alpha: &[f64],
    damping: Option<&[f64]>,
    columns: &[Column],
    regime: bool,
    stop: &Stop,
) -> Table {
    let n = omega.len();
    let mut numbers: Vec<(Output, Vec<f64>)> = columns
        .iter()
        .filter_map(|column| match column {
            Column::Output(output) => Some((*output, vec![0.0; n])),
            Column::Reversals => None,
        })
        .collect();
    let mut regimes = vec![None; if regime { n } else { 0 }];
    let mut slices: Vec<_> = numbers.iter_mut().map(|(output, column)| (*output, &mut **column)).collect();
    // The slices have one length by construction, so that no batch is refused.
    let _ = fill(omega, alpha, damping, &mut slices, &mut regimes, stop);
    let mut table = Table::default();
    for (output, column) in numbers {
        table.number(output.name(), column);
    }
    if columns.contains(&Column::Reversals) {
        table.number("reversals_per_cycle", reversals(omega, alpha, damping, stop));
    }
    if regime {
        table.code("regime", regimes.into_par_iter().map(code).collect(), &REGIMES);
    }
    table
}

/// Fills the slices, until it is told to stop; the regimes where there is room for them.
fn fill(
    omega: &[f64],
    alpha: &[f64],
    damping: Option<&[f64]>,
    numbers: &mut [(Output, &mut [f64])],
    regimes: &mut [Option<Regime>],
    stop: &Stop,
) -> Result<(), LengthMismatch> {
    let batch = Batch::new().on_threads();
    for start in (0..omega.len()).step_by(CHUNK) {
        if stop.asked().is_break() {
            break;
        }
        let part = start..omega.len().min(start + CHUNK);
        let (Some(omega), Some(alpha)) = (omega.get(part.clone()), alpha.get(part.clone())) else { continue };
        let mut wanted = Columns::new();
        for (output, slice) in &mut *numbers {
            wanted = wanted.with(*output, slice.get_mut(part.clone()).unwrap_or_default());
        }
        if let Some(slots) = regimes.get_mut(part.clone()) {
            wanted = wanted.with_regime(slots);
        }
        match damping.and_then(|damping| damping.get(part)) {
            None => batch.run(omega, alpha, wanted)?,
            Some(damping) => batch.run_damped(omega, alpha, damping, wanted)?,
        }
    }
    Ok(())
}

/// Reversals in a cycle, point by point.
fn reversals(omega: &[f64], alpha: &[f64], damping: Option<&[f64]>, stop: &Stop) -> Vec<f64> {
    let at = |i: usize| {
        let damping = damping.map_or(Some(0.0), |damping| damping.get(i).copied());
        if stop.asked().is_break() {
            return None;
        }
        let ratios = ratios(*omega.get(i)?, *alpha.get(i)?, damping?).ok()?;
        Response::new(ratios).reversals_per_cycle().map(f64::from)
    };
    (0..omega.len()).into_par_iter().map(|i| at(i).unwrap_or(f64::NAN)).collect()
}

/// The intervals of the force ratio without any stop, (least, greatest); `None` where there is no greatest.
#[pyfunction]
fn no_stop(omega: f64) -> PyResult<Vec<(f64, Option<f64>)>> {
    Ok(no_stop_force_ratios(omega).map_err(refused)?.intervals().collect())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("OUTPUTS", Output::ALL.map(Output::name).to_vec())?;
    module.add("REGIMES", REGIMES.to_vec())?;
    module.add_function(wrap_pyfunction!(response_at, module)?)?;
    module.add_function(wrap_pyfunction!(response_columns, module)?)?;
    module.add_function(wrap_pyfunction!(response_into, module)?)?;
    module.add_function(wrap_pyfunction!(no_stop, module)?)
}
