//! The exact motion: its limit, phases and samples, and free vibration.

use crate::closed_forms::{REGIMES, code};
use crate::interrupt::{Stop, interruptible, left_behind};
use crate::points::{Given, Point, Points, ratios};
use crate::refused;
use crate::table::Table;
use core::ops::ControlFlow;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use stickslip::Error;
use stickslip::motion::{
    DEFAULT_BUDGET, End, FreeDecay, Kind, LongRun, State, SteadyAnswer, SteadyOutput, SteadyState, Trajectory,
};
use stickslip::{Excitation, Observed, Value, observed};

/// The maximum number of rows of a simulation, which memory limits.
const MOST_ROWS: usize = 1 << 28;

/// Displacement and velocity at a phase of the drive.
pub(crate) type Start = (f64, f64, f64);

const NAMES: [&str; 6] = LongRun::<f64>::NAMES;
/// Kinds of limit by their codes; the last is for points outside the domain.
pub(crate) const LIMITS: [&str; 7] = {
    let [periodic, family, rest, irregular, none, not_converged] = NAMES;
    [periodic, family, rest, irregular, none, not_converged, "invalid"]
};

/// The code of a kind of limit.
pub(crate) fn limit_code(limit: Option<&LongRun<f64>>) -> u8 {
    let place = limit.and_then(|limit| LIMITS.iter().position(|name| *name == limit.name()));
    place.map_or(6, |place| place as u8)
}

/// A limit and its observed regime and counts.
struct FoundLimit {
    limit: LongRun<f64>,
    seen: Observed,
}

fn follow(
    point: Point,
    (phase, x, v): Start,
    periods: u32,
    keep_going: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<FoundLimit, Error> {
    let ratios = ratios(point)?;
    let limit = LongRun::within(ratios, State::new(phase, x, v)?, periods, keep_going)?;
    let seen = observed(ratios, &limit);
    Ok(FoundLimit { limit, seen })
}

/// A number of a limit, if it exists.
type Number = fn(&LongRun<f64>) -> Option<f64>;

/// The numbers of a limit in addition to those of its cycle.
const NUMBERS: [(&str, Number); 2] =
    [("periods", |limit| limit.periods()), ("rest_position", |limit| limit.rest_position())];

/// The numbers of a motion with a static friction above the kinetic one.
const OF_STATIC_FRICTION: [(&str, Number); 2] = [
    ("lyapunov_exponent", |limit| limit.irregular().map(|m| m.lyapunov_exponent)),
    ("lyapunov_exponent_error", |limit| limit.irregular().map(|m| m.lyapunov_exponent_error)),
];

/// A number of a cycle, or the extremes of an irregular motion.
fn number(limit: &LongRun<f64>, output: SteadyOutput) -> Option<f64> {
    match output {
        SteadyOutput::MaxDisplacement => limit.extrema().map(|(_, most)| most),
        SteadyOutput::MinDisplacement => limit.extrema().map(|(least, _)| least),
        _ => limit.steady_state().map(|steady| output.of(steady)),
    }
}

/// A drive is slow below this frequency ratio.
const SLOW: f64 = 1e-3;

/// All outputs of the limit from one start.
#[pyfunction]
fn steady_at<'py>(
    py: Python<'py>,
    point: Point,
    start: Start,
    max_periods: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let mut signal = None;
    let found = py.detach(|| {
        let mut slides = 0_u32;
        follow(point, start, max_periods, &mut || {
            slides = slides.wrapping_add(1);
            if slides.is_multiple_of(1 << 15) {
                signal = Python::attach(|py| py.check_signals().err());
            }
            if signal.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    });
    if let Some(signal) = signal {
        return Err(signal);
    }
    let found = found.map_err(refused)?;
    let (limit, seen) = (&found.limit, found.seen);
    let steady = limit.steady_state();
    // Under a slow drive a cycle has so many oscillations that the computation of its peaks takes seconds.
    let peaks = match steady.copied() {
        Some(steady) if point.0 < SLOW => left_behind(py, move || Some(steady.peaks()))?,
        steady => steady.map(|steady| steady.peaks()),
    };
    let peaks = peaks.transpose().map_err(refused)?;
    let errors = steady.map(SteadyState::errors).transpose().map_err(refused)?;
    let ratios = ratios(point).map_err(refused)?;
    let answer = SteadyAnswer { ratios, excitation: Excitation::Force, limit, seen, errors, peaks };
    let dict = PyDict::new(py);
    for column in SteadyAnswer::COLUMNS {
        let name = column.definition.name;
        match (column.of)(&answer) {
            Value::Number(number) => dict.set_item(name, number)?,
            Value::Count(count) => dict.set_item(name, count)?,
            Value::Flag(flag) => dict.set_item(name, flag)?,
            Value::Text(text) => dict.set_item(name, text)?,
            Value::Pairs(pairs) => dict.set_item(name, pairs.map(|pairs| pairs.to_vec()))?,
        }
    }
    let contraction = SteadyOutput::Contraction;
    dict.set_item(contraction.definition().name, number(limit, contraction))?;
    Ok(dict)
}

/// Columns of the limits at `n` points, all from one start. A value that does not exist is NaN, and such a
/// count is −1.
#[pyfunction]
fn steady_columns<'py>(
    py: Python<'py>,
    points: [Given<'py>; 4],
    n: usize,
    start: Start,
    max_periods: u32,
    with_peaks: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let points = Points::of(&points, n)?;
    // An invalid start is one error; it does not mark every point as invalid.
    State::new(start.0, start.1, start.2).map_err(refused)?;
    let work = |stop: &Stop| table(points, start, max_periods, with_peaks, stop);
    interruptible(py, work)?.map_err(refused)?.into_dict(py)
}

/// The outputs that need a search for the peaks of a cycle.
const OF_PEAKS: [&str; 5] = [
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
];

/// The columns at the given points, with those of [`OF_PEAKS`] where they are asked for.
pub(crate) fn table(
    points: Points<'_>,
    start: Start,
    max_periods: u32,
    with_peaks: bool,
    stop: &Stop,
) -> Result<Table, Error> {
    let nowhere = (f64::NAN, f64::NAN, f64::NAN, f64::NAN);
    let limit = |i: usize| follow(points.at(i).unwrap_or(nowhere), start, max_periods, &mut || stop.asked());
    let found: Vec<_> = (0..points.n).into_par_iter().with_min_len(16).map(limit).collect();
    let mut table = columns(&found, points.has_static_friction())?;
    if with_peaks {
        let of_peaks = |(i, found): (usize, &Result<FoundLimit, Error>)| {
            let nothing = [f64::NAN; OF_PEAKS.len()];
            if stop.asked().is_break() {
                return nothing;
            }
            let Ok(FoundLimit { limit, seen }) = found else { return nothing };
            let Ok(ratios) = ratios(points.at(i).unwrap_or(nowhere)) else { return nothing };
            let peaks = limit.steady_state().and_then(|steady| steady.peaks().ok());
            let excitation = Excitation::Force;
            let answer = SteadyAnswer { ratios, excitation, limit, seen: *seen, errors: None, peaks };
            OF_PEAKS.map(|name| {
                let column = SteadyAnswer::COLUMNS.iter().find(|column| column.definition.name == name);
                match column.map(|column| (column.of)(&answer)) {
                    Some(Value::Number(Some(number))) => number,
                    _ => f64::NAN,
                }
            })
        };
        let rows: Vec<_> = found.par_iter().enumerate().map(of_peaks).collect();
        for (place, name) in OF_PEAKS.into_iter().enumerate() {
            table.number(name, rows.iter().map(|row| row.get(place).copied().unwrap_or(f64::NAN)).collect());
        }
    }
    Ok(table)
}

/// The columns. A point outside the domain is marked as invalid; any other error is returned.
fn columns(found: &[Result<FoundLimit, Error>], with_static_friction: bool) -> Result<Table, Error> {
    let is_of_domain = |error: &Error| error.quantity().is_some();
    if let Some(Err(error)) = found.iter().find(|f| f.as_ref().is_err_and(|e| !is_of_domain(e))) {
        return Err(error.clone());
    }
    let found = || found.par_iter().map(|f| f.as_ref().ok());
    let numbers = |of: &(dyn Fn(&LongRun<f64>) -> Option<f64> + Sync)| {
        found().map(|f| f.and_then(|f| of(&f.limit)).unwrap_or(f64::NAN)).collect()
    };
    let counts = |of: &(dyn Fn(&FoundLimit) -> Option<u64> + Sync)| {
        found().map(|f| f.and_then(of).and_then(|n| i64::try_from(n).ok()).unwrap_or(-1)).collect()
    };
    let of_cycle = |value: fn(&SteadyState<f64>) -> u32| {
        counts(&move |f| f.limit.steady_state().map(|steady| u64::from(value(steady))))
    };
    let mut table = Table::default();
    table.code("regime", found().map(|f| code(f.map(|f| f.seen.regime))).collect(), &REGIMES);
    table.code("limit", found().map(|f| limit_code(f.map(|f| &f.limit))).collect(), &LIMITS);
    for output in SteadyOutput::ALL {
        table.number(output.definition().name, numbers(&|limit| number(limit, output)));
    }
    table.count("velocity_zeros_per_cycle", of_cycle(|s| s.velocity_zeros_per_cycle));
    table.count("sticks_per_cycle", counts(&|f| f.seen.sticks.map(u64::from)));
    table.count("reversals_per_cycle", counts(&|f| f.seen.reversals.map(u64::from)));
    for (name, value) in NUMBERS {
        table.number(name, numbers(&value));
    }
    if with_static_friction {
        for (name, value) in OF_STATIC_FRICTION {
            table.number(name, numbers(&value));
        }
        table.count("turns_per_cycle", of_cycle(|s| s.turns_per_cycle));
        table.count("symmetric", of_cycle(|steady| u32::from(steady.is_symmetric)));
        table.count("turns_observed", counts(&|f| f.limit.irregular().map(|m| m.turns)));
    }
    Ok(table)
}

/// The segments of a motion that begin within a number of drive cycles after its start; the last one is
/// complete.
#[pyfunction]
fn phases(py: Python<'_>, point: Point, start: Start, cycles: f64) -> PyResult<Bound<'_, PyDict>> {
    let until = last_phase(start.0, cycles)?;
    let motion = trajectory(point, start)?;
    let work = |stop: &Stop| -> Result<Table, String> {
        let mut kinds: Vec<u8> = Vec::new();
        let mut ends: Vec<u8> = Vec::new();
        let mut columns: [Vec<f64>; 6] = Default::default();
        for phase in motion {
            if stop.asked().is_break() {
                break;
            }
            let phase = phase.map_err(|e| e.to_string())?;
            let (from, to) = (phase.start(), phase.end());
            if total(from.phase) >= until {
                break;
            }
            if kinds.len() == MOST_ROWS {
                return Err(format!("cycles {cycles}: more than {MOST_ROWS} phases"));
            }
            kinds.push(match phase.kind {
                Kind::SlideForward => 0,
                Kind::SlideBackward => 1,
                Kind::Stick => 2,
            });
            ends.push(match phase.ends_by {
                End::Reversal => 0,
                End::Stop => 1,
                End::Grazing => 2,
                End::Release => 3,
                End::Never => 4,
            });
            let nan = f64::NAN;
            let row = [
                total(from.phase),
                to.map_or(nan, |e| total(e.phase)),
                phase.duration().unwrap_or(nan),
                from.x,
                from.v,
                to.map_or(nan, |e| e.x),
            ];
            for (column, value) in columns.iter_mut().zip(row) {
                column.push(value);
            }
        }
        let mut table = Table::default();
        table.code("kind", kinds, &[]);
        table.code("ends_by", ends, &[]);
        let names = [
            "start_phase",
            "end_phase",
            "duration",
            "start_displacement",
            "start_velocity",
            "end_displacement",
        ];
        for (name, column) in names.into_iter().zip(columns) {
            table.number(name, column);
        }
        Ok(table)
    };
    interruptible(py, work)?.map_err(refused)?.into_dict(py)
}

/// The motion at evenly spaced phases of the drive.
#[pyfunction]
fn samples(
    py: Python<'_>,
    point: Point,
    start: Start,
    cycles: f64,
    per_cycle: u32,
) -> PyResult<Bound<'_, PyDict>> {
    let until = last_phase(start.0, cycles)?;
    let mut motion = trajectory(point, start)?.samples(per_cycle).map_err(refused)?;
    if cycles * f64::from(per_cycle) > MOST_ROWS as f64 {
        return Err(refused(format!("cycles {cycles}, samples {per_cycle}: more than {MOST_ROWS} samples")));
    }
    let work = |stop: &Stop| -> Result<Table, String> {
        let mut columns: [Vec<f64>; 4] = Default::default();
        // A tolerance of half a step keeps the last sample of whole cycles in spite of rounding.
        let half_step = core::f64::consts::PI / f64::from(per_cycle);
        while let Some(instant) = motion.next_while(|| stop.asked()) {
            let instant = match instant {
                Ok(instant) => instant,
                Err(Error::Interrupted) => break,
                Err(error) => return Err(error.to_string()),
            };
            let phase = total(instant.state.phase);
            if phase > until + half_step || stop.asked().is_break() {
                break;
            }
            for (column, value) in
                columns.iter_mut().zip([phase, instant.state.x, instant.state.v, instant.friction])
            {
                column.push(value);
            }
        }
        let mut table = Table::default();
        for (name, column) in ["phase", "displacement", "velocity", "friction"].into_iter().zip(columns) {
            table.number(name, column);
        }
        Ok(table)
    };
    interruptible(py, work)?.map_err(refused)?.into_dict(py)
}

fn trajectory(point: Point, (phase, x, v): Start) -> PyResult<Trajectory<f64>> {
    let ratios = ratios(point).map_err(refused)?;
    Trajectory::new(ratios, State::new(phase, x, v).map_err(refused)?).map_err(refused)
}

/// The phase `cycles` drive cycles after the start.
fn last_phase(start: f64, cycles: f64) -> PyResult<f64> {
    if !(cycles.is_finite() && cycles > 0.0) {
        return Err(refused(format!("cycles = {cycles} must be > 0 and finite")));
    }
    Ok(start + cycles * core::f64::consts::TAU)
}

/// A phase of the drive as one number.
fn total(phase: stickslip::motion::DrivePhase<f64>) -> f64 {
    core::f64::consts::TAU * phase.cycles() as f64 + phase.reduced()
}

/// Free vibration to rest.
#[pyfunction]
fn decay_at(
    py: Python<'_>,
    displacement: f64,
    velocity: f64,
    damping_ratio: f64,
    static_friction_ratio: f64,
) -> PyResult<Bound<'_, PyDict>> {
    let decay =
        FreeDecay::new(displacement, velocity, damping_ratio, static_friction_ratio).map_err(refused)?;
    let dict = PyDict::new(py);
    dict.set_item("half_cycles", decay.half_cycles)?;
    dict.set_item("first_turn", decay.first_turn)?;
    dict.set_item("rest_position", decay.rest_position)?;
    dict.set_item("rest_time", Some(decay.rest_time).filter(|time| time.is_finite()))?;
    Ok(dict)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("LIMITS", LIMITS.to_vec())?;
    module.add("MAX_PERIODS", DEFAULT_BUDGET)?;
    module.add_function(wrap_pyfunction!(steady_at, module)?)?;
    module.add_function(wrap_pyfunction!(steady_columns, module)?)?;
    module.add_function(wrap_pyfunction!(phases, module)?)?;
    module.add_function(wrap_pyfunction!(samples, module)?)?;
    module.add_function(wrap_pyfunction!(decay_at, module)?)
}
