//! The exact motion: its limit, phases and samples, and free vibration.

use crate::closed_forms::{REGIMES, under};
use crate::columns::{self, Kind, Places, Row, Store, Target, halves, named};
use crate::machine::excitation;
use crate::points::{Given, Point, Points, Values, ratios};
use crate::refused;
use crate::table::Table;
use core::ops::ControlFlow;
use interrupt::{Stop, interruptible};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::sync::LazyLock;
use stickslip::internal::definitions::{ERROR_1, ERROR_2, ERROR_3, ERROR_4, LIMIT};
use stickslip::internal::{Observed, Value, observed};
use stickslip::motion::{
    self, DEFAULT_BUDGET, End, FreeDecay, LongRun, State, SteadyAnswer, SteadyOutput, SteadyState, Trajectory,
};
use stickslip::{Definition, Error, Excitation, Ratios};

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

/// A limit and its observed regime and counts.
struct FoundLimit {
    ratios: Ratios<f64>,
    limit: LongRun<f64>,
    seen: Observed,
}

type KeepGoing<'a> = &'a mut dyn FnMut() -> ControlFlow<()>;

fn follow(
    point: Point,
    excitation: Option<Excitation>,
    (phase, x, v): Start,
    periods: u32,
    keep_going: KeepGoing<'_>,
) -> Result<FoundLimit, Error> {
    let ratios = under(ratios(point)?, excitation);
    let limit = LongRun::within(ratios, State::new(phase, x, v)?, periods, keep_going)?;
    let seen = observed(ratios, &limit);
    Ok(FoundLimit { ratios, limit, seen })
}

impl FoundLimit {
    /// The answer, with the peaks and the measures of asymmetry where a column needs them.
    fn answer(&self, needs: Needs, keep_going: KeepGoing<'_>) -> Result<SteadyAnswer<'_, f64>, Error> {
        let peaks = if needs.peaks { self.limit.peaks_while(&self.ratios, keep_going)? } else { None };
        let errors =
            self.limit.steady_state().filter(|_| needs.errors).map(SteadyState::errors).transpose()?;
        let Self { ratios, limit, seen } = self;
        Ok(SteadyAnswer { ratios: *ratios, limit, seen: *seen, errors, peaks })
    }
}

/// The source of a column.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    /// A column of the answer, by its place.
    Place(usize),
    Contraction,
}

impl Column {
    fn value(self, answer: &SteadyAnswer<'_, f64>) -> Option<Value<f64>> {
        match self {
            Self::Place(place) => SteadyAnswer::COLUMNS.get(place).map(|column| (column.of)(answer)),
            Self::Contraction => {
                let of = |steady| SteadyOutput::Contraction.of(steady);
                Some(Value::Number(answer.limit.steady_state().map(of)))
            }
        }
    }
}

/// What an answer needs beside the limit, for the requested columns.
#[derive(Clone, Copy, Default)]
struct Needs {
    peaks: bool,
    errors: bool,
}

impl Needs {
    fn of<'a>(mut definitions: impl Iterator<Item = &'a Definition> + Clone) -> Self {
        let of_errors = [ERROR_1, ERROR_2, ERROR_3, ERROR_4];
        let errors = definitions.clone().any(|own| of_errors.contains(&own));
        Self { peaks: definitions.any(|own| own.is_searched), errors }
    }
}

/// Every output of a steady state.
static ROWS: LazyLock<Vec<Row<Column>>> = LazyLock::new(|| {
    let mut rows = Vec::new();
    let point = (1.5, 2.5, 0.0, 1.0);
    let example = follow(point, None, (0.0, 0.0, 0.0), DEFAULT_BUDGET, &mut || ControlFlow::Continue(()));
    let Ok(example) = example else { return rows };
    let answer = example.answer(Needs::default(), &mut || ControlFlow::Continue(()));
    let Ok(answer) = answer else { return rows };
    let places = SteadyAnswer::<f64>::COLUMNS.iter().enumerate();
    let places = places.map(|(place, column)| (column.definition, Column::Place(place)));
    for (definition, column) in places.chain([(SteadyOutput::Contraction.definition(), Column::Contraction)])
    {
        let words: &[&str] = if definition == LIMIT { &LIMITS } else { &REGIMES };
        if let Some(value) = column.value(&answer) {
            rows.push(Row { definition, kind: Kind::of(&value, words), column });
        }
    }
    rows
});

/// The outputs of these names.
pub(crate) fn rows(names: &[String]) -> PyResult<Vec<Row<Column>>> {
    named(&ROWS, names)
}

/// The steps of a motion between two looks at the interpreter's signals.
const STEPS: u32 = 1 << 13;

/// Chosen outputs of the limit from one start under an excitation.
#[pyfunction]
fn steady_at<'py>(
    py: Python<'py>,
    point: Point,
    kind: Option<&str>,
    outputs: Vec<String>,
    start: Start,
    max_periods: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let (rows, kind) = (rows(&outputs)?, kind.map(excitation).transpose()?);
    let mut signal = None;
    let mut steps = 0_u32;
    let mut keep_going = || {
        steps = steps.wrapping_add(1);
        if steps.is_multiple_of(STEPS) {
            signal = Python::attach(|py| py.check_signals().err());
        }
        if signal.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let needs = Needs::of(rows.iter().map(|row| row.definition));
    let values = py.detach(|| {
        let found = follow(point, kind, start, max_periods, &mut keep_going)?;
        let answer = found.answer(needs, &mut keep_going)?;
        Ok::<_, Error>(rows.iter().map(|row| row.column.value(&answer)).collect::<Vec<_>>())
    });
    if let Some(signal) = signal {
        return Err(signal);
    }
    let dict = PyDict::new(py);
    for (row, value) in rows.iter().zip(values.map_err(refused)?) {
        if let Some(value) = value {
            columns::set(&dict, row.definition.name, value)?;
        }
    }
    Ok(dict)
}

/// Writes outputs of the limits at `n` points, all from one start, to existing arrays.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the points, the question and the arrays")]
fn steady_into<'py>(
    py: Python<'py>,
    points: [Given<'py>; 4],
    n: usize,
    kind: Option<&str>,
    outputs: Vec<String>,
    mut arrays: Vec<Target<'py>>,
    start: [Given<'py>; 3],
    max_periods: u32,
) -> PyResult<()> {
    let kind = kind.map(excitation).transpose()?;
    let points = Points::of(&points, n)?.from(&start)?;
    let places = Places::of(rows(&outputs)?, &mut arrays, n)?;
    // An invalid start of all motions is one error; it does not mark every point as invalid.
    if let Some((phase, x, v)) = points.one_start() {
        State::new(phase, x, v).map_err(refused)?;
    }
    interruptible(py, |stop| fill(points, places, kind, max_periods, stop))?.map_err(refused)
}

/// The outputs at the given points, in memory of their own.
pub(crate) fn stored(
    points: Points<'_>,
    rows: &[Row<Column>],
    start: Start,
    max_periods: u32,
    stop: &Stop,
) -> Result<Store<Column>, Error> {
    let mut store = Store::new(rows.to_vec(), points.n);
    let (phase, x, v) = start;
    let points = Points { start: [phase, x, v].map(|value| Values::One(value, &[])), ..points };
    fill(points, store.places(), None, max_periods, stop)?;
    Ok(store)
}

/// Points per task.
const TASK: usize = 32;

/// Fills the places, until `stop` is set. A point outside the domain is marked as invalid; any other error is
/// returned.
fn fill(
    points: Points<'_>,
    places: Places<'_, Column>,
    kind: Option<Excitation>,
    max_periods: u32,
    stop: &Stop,
) -> Result<(), Error> {
    let needs = Needs::of(places.0.iter().map(|(row, _)| row.definition));
    let keep_going = || stop.asked();
    halves(points, places, TASK, stop, &|points, mut places| {
        for (i, point, start) in (0..points.n).filter_map(|i| Some((i, points.at(i)?, points.start_at(i)?))) {
            let found = match follow(point, kind, start, max_periods, &mut { keep_going }) {
                Ok(found) => found,
                Err(error) if error.quantity().is_some() => {
                    places.put(i, |_| None);
                    continue;
                }
                Err(Error::Interrupted) => return Ok(()),
                Err(error) => return Err(error),
            };
            // The peaks of a cycle that cannot be followed do not exist, but its other outputs do.
            let answer = found.answer(needs, &mut { keep_going });
            match answer.or_else(|_| found.answer(Needs::default(), &mut { keep_going })) {
                Ok(answer) => places.put(i, |column| column.value(&answer)),
                Err(error) => return Err(error),
            }
        }
        Ok(())
    })
}

/// The segments of a motion that begin within a number of drive cycles after its start; the last one is
/// complete.
#[pyfunction]
fn phases(py: Python<'_>, point: Point, start: Start, cycles: f64) -> PyResult<Bound<'_, PyDict>> {
    let until = last_phase(start.0, cycles).map_err(refused)?;
    let motion = trajectory(point, start).map_err(refused)?;
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
                return Err(format!("cycles {cycles:?}: more than {MOST_ROWS} phases"));
            }
            kinds.push(match phase.kind {
                motion::Kind::SlideForward => 0,
                motion::Kind::SlideBackward => 1,
                motion::Kind::Stick => 2,
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
        table.code("kind", kinds);
        table.code("ends_by", ends);
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

/// The motion at evenly spaced phases of the drive: from its start, or from the next whole turn of the drive, whose phase is
/// then 0.
#[pyfunction]
fn samples(
    py: Python<'_>,
    point: Point,
    start: Start,
    cycles: f64,
    per_cycle: u32,
    whole_turns: bool,
) -> PyResult<Bound<'_, PyDict>> {
    let work = |stop: &Stop| sampled(point, start, cycles, per_cycle, whole_turns, stop);
    let columns = interruptible(py, work)?.map_err(refused)?;
    tabled(columns).into_dict(py)
}

const SAMPLED: [&str; 4] = ["phase", "displacement", "velocity", "friction"];

fn tabled(columns: [Vec<f64>; 4]) -> Table {
    let mut table = Table::default();
    for (name, column) in SAMPLED.into_iter().zip(columns) {
        table.number(name, column);
    }
    table
}

/// The samples of the motions at `n` points, which start at one phase: a row for each point, and the phases of one row. A point outside the domain
/// has NaN.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the points, the start and the samples")]
fn samples_of_each<'py>(
    py: Python<'py>,
    points: [Given<'py>; 4],
    n: usize,
    phase: f64,
    start: [Given<'py>; 2],
    cycles: f64,
    per_cycle: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let points = Points::of(&points, n)?;
    let [x, v] = &start;
    let (x, v) = (Values::of(x)?, Values::of(v)?);
    let rows = (cycles * f64::from(per_cycle)).max(1.0);
    if rows * n as f64 > MOST_ROWS as f64 {
        return Err(refused(format!(
            "cycles {cycles:?}, samples {per_cycle}: more than {MOST_ROWS} samples"
        )));
    }
    let work = |stop: &Stop| -> Result<[Vec<f64>; 4], String> {
        // The phases of the samples are those of any motion.
        let [phases, ..] = sampled((1.0, 1.0, 0.0, 1.0), (phase, 0.0, 0.0), cycles, per_cycle, false, stop)?;
        let nothing = || Ok([(); 4].map(|()| vec![f64::NAN; phases.len()]));
        let row = |i: usize| {
            let Some(((point, x), v)) = points.at(i).zip(x.at(i)).zip(v.at(i)) else { return nothing() };
            let is_valid = ratios(point).is_ok() && State::new(phase, x, v).is_ok();
            if !is_valid || stop.asked().is_break() {
                return nothing();
            }
            sampled(point, (phase, x, v), cycles, per_cycle, false, stop)
        };
        let found: Vec<_> = (0..n).into_par_iter().map(row).collect::<Result<_, String>>()?;
        let column =
            |place: usize| found.iter().filter_map(|row| row.get(place)).flatten().copied().collect();
        let (x, v, friction) = (column(1), column(2), column(3));
        Ok([phases, x, v, friction])
    };
    tabled(interruptible(py, work)?.map_err(refused)?).into_dict(py)
}

/// The samples of a motion: phases, displacements, velocities and friction.
fn sampled(
    point: Point,
    start: Start,
    cycles: f64,
    per_cycle: u32,
    whole_turns: bool,
    stop: &Stop,
) -> Result<[Vec<f64>; 4], String> {
    use core::f64::consts::{PI, TAU};
    let first = if whole_turns { TAU * (start.0 / TAU).ceil() } else { start.0 };
    let until = last_phase(first, cycles)?;
    let motion = trajectory(point, start)?.samples(per_cycle).map_err(|e| e.to_string())?;
    // The start is the first sample, wherever it is.
    let mut motion = if whole_turns { motion } else { motion.from_start() };
    if cycles * f64::from(per_cycle) > MOST_ROWS as f64 {
        return Err(format!("cycles {cycles:?}, samples {per_cycle}: more than {MOST_ROWS} samples"));
    }
    let mut columns: [Vec<f64>; 4] = Default::default();
    // A tolerance of half a step keeps the first and the last sample of whole cycles in spite of rounding.
    let half_step = PI / f64::from(per_cycle);
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
        if phase < first - half_step {
            continue;
        }
        let phase = if whole_turns { phase - first } else { phase };
        for (column, value) in
            columns.iter_mut().zip([phase, instant.state.x, instant.state.v, instant.friction])
        {
            column.push(value);
        }
    }
    Ok(columns)
}

/// A state on the limit cycle that a start leads to, and the turns of the drive in a cycle; `None` where the motion tends to
/// no cycle.
#[pyfunction]
fn on_limit(
    py: Python<'_>,
    point: Point,
    kind: Option<&str>,
    start: Start,
    max_periods: u32,
) -> PyResult<Option<(Start, u32)>> {
    let kind = kind.map(excitation).transpose()?;
    let found = interruptible(py, |stop| follow(point, kind, start, max_periods, &mut || stop.asked()))?;
    let found = found.map_err(refused)?;
    let of = |steady: &SteadyState<f64>| {
        let State { phase, x, v, .. } = steady.state;
        ((phase.reduced(), x, v), steady.turns_per_cycle)
    };
    Ok(found.limit.steady_state().map(of))
}

fn trajectory(point: Point, (phase, x, v): Start) -> Result<Trajectory<f64>, String> {
    let start = ratios(point).and_then(|ratios| Ok((ratios, State::new(phase, x, v)?)));
    start.and_then(|(ratios, state)| Trajectory::new(ratios, state)).map_err(|e| e.to_string())
}

/// The phase `cycles` drive cycles after the start.
fn last_phase(start: f64, cycles: f64) -> Result<f64, String> {
    if !(cycles.is_finite() && cycles > 0.0) {
        return Err(format!("cycles = {cycles} must be > 0 and finite"));
    }
    Ok(start + cycles * core::f64::consts::TAU)
}

/// A phase of the drive as one number.
fn total(phase: stickslip::motion::DrivePhase<f64>) -> f64 {
    core::f64::consts::TAU * phase.cycles() as f64 + phase.reduced()
}

/// Free vibrations to rest from `n` starts: displacement, velocity, damping ratio and static friction ratio. A start outside the domain is an
/// error where it is the only one, and has NaN otherwise.
#[pyfunction]
fn decays<'py>(
    py: Python<'py>,
    starts: [Given<'py>; 4],
    n: usize,
    is_one: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let points = Points::of(&starts, n)?;
    let one = |i: usize| {
        let (x, v, damping_ratio, static_friction_ratio) = points.at(i)?;
        Some(FreeDecay::new(x, v, damping_ratio, static_friction_ratio))
    };
    if is_one && let Some(Err(error)) = one(0) {
        return Err(refused(error));
    }
    let found: Vec<[f64; 5]> = interruptible(py, |stop| {
        let row = |i: usize| match one(i).filter(|_| stop.asked().is_continue()) {
            Some(Ok(decay)) => {
                let time = Some(decay.rest_time).filter(|time| time.is_finite()).unwrap_or(f64::NAN);
                let path = decay.path();
                [decay.half_cycles as f64, decay.first_turn, decay.rest_position, path, time]
            }
            _ => [f64::NAN; 5],
        };
        (0..n).into_par_iter().map(row).collect()
    })?;
    let mut table = Table::default();
    let names = ["half_cycles", "first_turn", "rest_position", "path", "rest_time"];
    for (place, name) in names.into_iter().enumerate() {
        table.number(name, found.iter().filter_map(|row| row.get(place)).copied().collect());
    }
    table.into_dict(py)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("STEADY", columns::told(&ROWS))?;
    module.add("LIMITS", LIMITS.to_vec())?;
    module.add("MAX_PERIODS", DEFAULT_BUDGET)?;
    module.add_function(wrap_pyfunction!(steady_at, module)?)?;
    module.add_function(wrap_pyfunction!(steady_into, module)?)?;
    module.add_function(wrap_pyfunction!(phases, module)?)?;
    module.add_function(wrap_pyfunction!(samples, module)?)?;
    module.add_function(wrap_pyfunction!(samples_of_each, module)?)?;
    module.add_function(wrap_pyfunction!(on_limit, module)?)?;
    module.add_function(wrap_pyfunction!(decays, module)?)
}
