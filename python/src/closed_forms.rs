//! Closed forms of the non-sticking cycle, and the border.

use crate::interrupt::{Stop, interruptible};
use crate::refused;
use crate::table::Table;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use stickslip::batch::{Batch, Cycles, Peaks, Triple};
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

/// The columns at points of one length, whose damping ratios are all 0 where they are not given.
pub(crate) fn table(
    omega: &[f64],
    alpha: &[f64],
    damping: Option<&[f64]>,
    columns: &[Column],
    regime: bool,
    stop: &Stop,
) -> Table {
    match damping {
        None => batched(omega, alpha, columns, regime, stop),
        Some(damping) => one_by_one(omega, alpha, damping, columns, regime, stop),
    }
}

/// Those that the vector loops of the library give, in their order.
const OF_LOOPS: [Output; 9] = [
    Output::MaxDisplacement,
    Output::MinForceRatio,
    Output::LoopSizeStiffness,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::DisplacementPhase,
    Output::Deviation,
    Output::Contraction,
    Output::LoopSizeInertia,
];

/// Without damping: the library's batches, and point by point what those do not have.
fn batched(omega: &[f64], alpha: &[f64], columns: &[Column], regime: bool, stop: &Stop) -> Table {
    let place = |column: &Column| match column {
        Column::Output(output) => OF_LOOPS.iter().position(|of_loop| of_loop == output),
        Column::Reversals => None,
    };
    // The least of the three sets of outputs that has all that are asked for.
    let most = columns.iter().filter_map(place).max();
    let kept = match (regime, most) {
        (false, None) => 0,
        (false, Some(0..=2)) => 3,
        (false, Some(0..=4)) => 5,
        _ => OF_LOOPS.len(),
    };
    let n = omega.len();
    let mut of_loops: Vec<Vec<f64>> = (0..kept).map(|_| vec![0.0; n]).collect();
    let mut regimes = vec![None; if regime { n } else { 0 }];
    let batch = Batch::new().on_threads();
    for start in (0..n).step_by(CHUNK) {
        if stop.asked().is_break() {
            break;
        }
        let part = start..n.min(start + CHUNK);
        let (Some(omega), Some(alpha)) = (omega.get(part.clone()), alpha.get(part.clone())) else { continue };
        let mut slices = of_loops.iter_mut().filter_map(|column| column.get_mut(part.clone()));
        let mut next = || slices.next().unwrap_or_default();
        // The slices have one length by construction, so that no batch is refused.
        let _ = match kept {
            0 => Ok(()),
            3 => batch.triple(
                omega,
                alpha,
                Triple { max_displacement: next(), min_force_ratio: next(), loop_size_stiffness: next() },
            ),
            5 => batch.peaks(
                omega,
                alpha,
                Peaks {
                    max_displacement: next(),
                    min_force_ratio: next(),
                    loop_size_stiffness: next(),
                    max_velocity: next(),
                    velocity_phase: next(),
                },
            ),
            _ => {
                let mut unused = vec![None; if regime { 0 } else { part.len() }];
                batch.cycles(
                    omega,
                    alpha,
                    Cycles {
                        regime: regimes.get_mut(part.clone()).unwrap_or(&mut unused),
                        max_displacement: next(),
                        min_force_ratio: next(),
                        loop_size_stiffness: next(),
                        max_velocity: next(),
                        velocity_phase: next(),
                        displacement_phase: next(),
                        deviation: next(),
                        contraction: next(),
                        loop_size_inertia: next(),
                    },
                )
            }
        };
    }
    let others: Vec<Column> = columns.iter().copied().filter(|column| place(column).is_none()).collect();
    let mut table = Table::default();
    if !others.is_empty() {
        table = one_by_one(omega, alpha, &[], &others, false, stop);
    }
    for column in columns {
        if let (Column::Output(output), Some(place)) = (column, place(column))
            && let Some(column) = of_loops.get_mut(place)
        {
            table.number(output.name(), std::mem::take(column));
        }
    }
    if regime {
        table.code("regime", regimes.into_par_iter().map(code).collect(), &REGIMES);
    }
    table
}

/// Any outputs, each point by itself; an empty slice of damping ratios is that of none.
fn one_by_one(
    omega: &[f64],
    alpha: &[f64],
    damping: &[f64],
    columns: &[Column],
    regime: bool,
    stop: &Stop,
) -> Table {
    let at = |i: usize| {
        let value = |column: &[f64]| column.get(i).copied().unwrap_or(f64::NAN);
        let damping = if damping.is_empty() { 0.0 } else { value(damping) };
        if stop.asked().is_break() {
            return None;
        }
        ratios(value(omega), value(alpha), damping).ok().map(Response::new)
    };
    let answers: Vec<Option<Response<f64>>> = (0..omega.len()).into_par_iter().map(at).collect();
    let mut table = Table::default();
    for column in columns {
        let numbers = |value: &(dyn Fn(&Response<f64>) -> Option<f64> + Sync)| {
            answers.par_iter().map(|a| a.as_ref().and_then(value).unwrap_or(f64::NAN)).collect()
        };
        match column {
            Column::Output(output) => table.number(output.name(), numbers(&|a| output.of(a))),
            Column::Reversals => {
                table.number("reversals_per_cycle", numbers(&|a| a.reversals_per_cycle().map(f64::from)));
            }
        }
    }
    if regime {
        let regime_of = |a: &Option<Response<f64>>| code(a.as_ref().map(Response::regime));
        table.code("regime", answers.par_iter().map(regime_of).collect(), &REGIMES);
    }
    table
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
    module.add_function(wrap_pyfunction!(no_stop, module)?)
}
