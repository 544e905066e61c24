//! The motion under records.

use crate::machine::{Machines, each_given, given};
use crate::points::{self, Values};
use crate::refused;
use crate::table::Table;
use interrupt::{interruptible, left_behind};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::fs::File;
use std::io::{BufReader, Read};
use stickslip::motion::record::{After, Body, Entry, FloorResponse, Record, RecordAnswer, follow_each_while};
use stickslip::{Error, Excitation};
use stickslip_front::inputs::units::{InputError, Kind, Reader, System};
use stickslip_front::inputs::{Given, Role};
use stickslip_front::record::{self as front, Options, Words};

/// Mass, stiffness, damping constant, friction against forward and against backward motion, static friction ratio,
/// constant force, and whether the body moves one way.
type Sliding = (f64, f64, f64, f64, f64, f64, f64, bool);

/// The bodies whose answers are in memory beside the columns.
const AT_ONCE: usize = 1024;

fn body(
    (mass, stiffness, damping, forward, backward, ratio, mean_force, one_way): Sliding,
) -> Result<Body<f64>, Error> {
    let body = Body::new(mass, forward)?
        .with_directional_friction(forward, backward)?
        .with_stiffness(stiffness)?
        .with_damping(damping)?
        .with_static_friction_ratio(ratio)?
        .with_mean_force(mean_force)?;
    Ok(if one_way { body.one_way() } else { body })
}

/// The samples up to which a motion takes no longer than a thousandth of a second.
const SHORT: usize = 1 << 14;

/// The record of these samples, at these times, or at equal steps from 0 if there is one time, the step, and with this load
/// after it, or the default one.
pub(crate) fn load(of: &str, times: &[f64], samples: &[f64], after: Option<&str>) -> PyResult<Record<f64>> {
    let excitation = match of {
        "force" => Excitation::Force,
        "base_acceleration" => Excitation::SurfaceAcceleration,
        "foot_displacement" => Excitation::FootMotion,
        "damped_foot_displacement" => Excitation::DampedFootMotion,
        _ => {
            return Err(refused(format!(
                "of = {of}: must be base_acceleration, force, foot_displacement or damped_foot_displacement"
            )));
        }
    };
    let record = match times {
        [step] => Record::new(excitation, *step, samples.to_vec()),
        times => Record::at_times(excitation, times.to_vec(), samples.to_vec()),
    };
    let record = record.map_err(refused)?;
    let after = match after {
        None => record.after(),
        Some(name) => [After::Zero, After::Hold, After::Free]
            .into_iter()
            .find(|after| after.name() == name)
            .ok_or_else(|| refused(format!("after = {name}: must be zero, hold or free")))?,
    };
    Ok(record.followed_by(after))
}

/// What was read of a file: of what, its times or its step, its samples in SI units, and their unit; then the fields of
/// the summary.
type FileRead<'py> = ((&'static str, Vec<f64>, Vec<f64>, &'static str), Bound<'py, PyDict>);

/// A file whose first failure is kept, because the reader of records tells it in words.
struct Watched {
    file: File,
    failed: Option<std::io::Error>,
}

impl Read for Watched {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        self.file.read(into).inspect_err(|e| {
            let same = || e.raw_os_error().map_or_else(|| e.kind().into(), std::io::Error::from_raw_os_error);
            self.failed.get_or_insert_with(same);
        })
    }
}

/// The error of the operating system as Python has it, with its number and its text.
fn of_system(error: std::io::Error) -> PyErr {
    PyOSError::new_err((error.raw_os_error(), in_words(&error.to_string())))
}

/// A message without the number of an error of the operating system.
pub(crate) fn in_words(text: &str) -> String {
    text.split(" (os error").next().unwrap_or_default().to_owned()
}

/// Reads a record from a file of this name, or from bytes. `wanted` is the column of the time, the sensitivity, the mean that
/// is taken off and the new step.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the arguments of Record.read")]
fn record_read<'py>(
    py: Python<'py>,
    name: &str,
    bytes: Option<Vec<u8>>,
    time_step: Option<f64>,
    column: Option<&str>,
    skip: u64,
    record_units: Option<&str>,
    wanted: [Option<String>; 4],
) -> PyResult<FileRead<'py>> {
    let file = if bytes.is_none() { Some(File::open(name).map_err(of_system)?) } else { None };
    let [time_column, scale, remove_mean, resample] = wanted;
    // The shortest decimal is read as the same number.
    let time_step = time_step.map(|step| format!("{step:e} s"));
    let found = py.detach(|| {
        let reader = Reader::new(Some(&System::default()), "units");
        let options = Options {
            time_step: time_step.as_deref(),
            column,
            skip,
            units: record_units,
            time_column: time_column.as_deref(),
            scale: scale.as_deref(),
            remove_mean: remove_mean.as_deref(),
            resample: resample.as_deref(),
            ..Options::new(name, &reader, Words::PYTHON)
        };
        let Some(file) = file else {
            return Ok(front::read(bytes.unwrap_or_default().as_slice(), &options));
        };
        let mut file = BufReader::new(Watched { file, failed: None });
        let found = front::read(&mut file, &options);
        file.get_mut().failed.take().map_or(Ok(found), Err)
    });
    let found = found.map_err(of_system)?.map_err(refused)?;
    let (record, summary) = (&found.record, &found.summary);
    let (of, unit) = match record.excitation() {
        Excitation::Force => ("force", "N"),
        Excitation::FootMotion => ("foot_displacement", "m"),
        Excitation::DampedFootMotion => ("damped_foot_displacement", "m"),
        _ => ("base_acceleration", "m/s^2"),
    };
    let times = match record.step() {
        Some(step) if record.time(0) == 0.0 => vec![step],
        _ => (0..record.samples().len()).map(|index| record.time(index)).collect(),
    };
    let fields = PyDict::new(py);
    fields.set_item("kind", summary.kind)?;
    fields.set_item("channel", summary.channel.as_deref())?;
    fields.set_item("quantity", summary.quantity)?;
    fields.set_item("samples", summary.samples)?;
    fields.set_item("time_step", summary.time_step)?;
    fields.set_item("duration", summary.duration)?;
    fields.set_item("peak", summary.peak)?;
    fields.set_item("peak_at", summary.peak_at)?;
    fields.set_item("mean", summary.mean)?;
    fields.set_item("unit", &summary.unit)?;
    fields.set_item("notes", &summary.notes)?;
    Ok(((of, times, record.samples().to_vec(), unit), fields))
}

/// The load after a record. Fails where the samples make none.
#[pyfunction]
fn record_check(
    of: &str,
    times: PyReadonlyArray1<'_, f64>,
    samples: PyReadonlyArray1<'_, f64>,
    after: Option<&str>,
) -> PyResult<&'static str> {
    load(of, times.as_slice()?, samples.as_slice()?, after).map(|record| record.after().name())
}

/// The frequency in Hz of the greatest Fourier amplitude, and the beginnings and the ends of gaps in s.
#[pyfunction]
fn record_described(
    of: &str,
    times: PyReadonlyArray1<'_, f64>,
    samples: PyReadonlyArray1<'_, f64>,
) -> PyResult<(Option<f64>, Vec<[f64; 2]>)> {
    let record = load(of, times.as_slice()?, samples.as_slice()?, None)?;
    Ok((front::peak_frequency(&record), front::gaps(&record)))
}

/// The places of the samples within two times: the first, and the one after the last.
#[pyfunction]
fn record_between(
    of: &str,
    times: PyReadonlyArray1<'_, f64>,
    samples: PyReadonlyArray1<'_, f64>,
    within: (f64, f64),
) -> PyResult<(usize, usize)> {
    let record = load(of, times.as_slice()?, samples.as_slice()?, None)?;
    let kept = record.places_between(within.0, within.1).map_err(refused)?;
    Ok((kept.start, kept.end))
}

/// The numbers of a block of the given values on a surface that falls by `slope`.
fn of_block(given: &Given<f64>, slope: Option<f64>) -> Result<[f64; 7], InputError> {
    let body = given.body(slope)?;
    let (forward, backward) = body.directional_friction();
    let ratio = body.static_friction_ratio();
    Ok([body.mass(), 0.0, body.damping(), forward, backward, ratio, body.mean_force()])
}

/// The slope of a surface.
fn slope_of(text: Option<&str>, units: Option<&str>) -> PyResult<Option<f64>> {
    let reader = crate::machine::reader(units)?;
    text.map(|text| reader.value("slope", text, Kind::Angle)).transpose().map_err(refused)
}

/// The body of the given values on a surface that falls by `slope`, and its system of units.
#[pyfunction]
fn block(
    values: Vec<(String, String)>,
    units: Option<&str>,
    slope: Option<&str>,
    one_way: bool,
) -> PyResult<(Sliding, Option<String>)> {
    let ((given, system), slope) = (given(values, units)?, slope_of(slope, units)?);
    if given.has_role(Role::Spring) {
        return Err(refused("a block has no spring: see Machine"));
    }
    let [mass, stiffness, damping, forward, backward, ratio, mean_force] =
        of_block(&given, slope).map_err(refused)?;
    Ok(((mass, stiffness, damping, forward, backward, ratio, mean_force, one_way), system))
}

/// Blocks as columns, of values as texts and, in place of some of these, of columns of bare numbers.
#[pyfunction]
fn blocks<'py>(
    py: Python<'py>,
    values: Vec<(String, String)>,
    columns: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    n: usize,
    units: Option<&str>,
    slope: Option<&str>,
) -> PyResult<Machines<'py>> {
    let ((given, system), slope) = (given(values, units)?, slope_of(slope, units)?);
    if given.has_role(Role::Spring) {
        return Err(refused("a block has no spring: see Machine"));
    }
    let (found, failed) = each_given(given, &columns, n, |given| of_block(given, slope))?;
    let names = [
        "mass",
        "stiffness",
        "damping",
        "friction",
        "friction_backward",
        "static_friction_ratio",
        "mean_force",
    ];
    let mut table = Table::default();
    for (name, column) in names.into_iter().zip(found) {
        table.number(name, column);
    }
    Ok((table.into_dict(py)?, failed, system))
}

/// The answers of bodies in columns.
#[derive(Default)]
struct Answers(Vec<(&'static str, Vec<f64>, Vec<i64>)>);

impl Answers {
    /// Adds the answers of a body, one of `n`.
    fn push(&mut self, answer: &RecordAnswer<f64>, n: usize) {
        if self.0.is_empty() {
            let empty = |(name, _, entry)| match entry {
                Entry::Value(_) => (name, Vec::with_capacity(n), Vec::new()),
                Entry::Count(_) => (name, Vec::new(), Vec::with_capacity(n)),
            };
            self.0 = answer.entries().map(empty).into();
        }
        for ((_, values, counts), (.., entry)) in self.0.iter_mut().zip(answer.entries()) {
            match entry {
                Entry::Value(value) => values.push(value.copied().unwrap_or(f64::NAN)),
                Entry::Count(count) => counts.push(i64::try_from(count).unwrap_or(i64::MAX)),
            }
        }
    }

    fn into_table(self) -> Table {
        let mut table = Table::default();
        for (name, values, counts) in self.0 {
            if counts.is_empty() { table.number(name, values) } else { table.count(name, counts) }
        }
        table
    }
}

fn table(answer: &RecordAnswer<f64>) -> Table {
    let mut answers = Answers::default();
    answers.push(answer, 1);
    answers.into_table()
}

/// The answers of one body from a start, as arrays of one number.
#[pyfunction]
fn record_follow<'py>(
    py: Python<'py>,
    of: Sliding,
    kind: &str,
    times: PyReadonlyArray1<'py, f64>,
    samples: PyReadonlyArray1<'py, f64>,
    after: &str,
    start: (f64, f64),
) -> PyResult<Bound<'py, PyDict>> {
    let body = body(of).map_err(refused)?;
    let record = load(kind, times.as_slice()?, samples.as_slice()?, Some(after))?;
    let answer = if samples.as_slice()?.len() > SHORT {
        left_behind(py, move || body.follow_from(&record, start.0, start.1))?
    } else {
        py.detach(|| body.follow_from(&record, start.0, start.1))
    };
    let answer = answer.map_err(refused)?;
    table(&answer).into_dict(py)
}

/// The answers, the states and the events of one body from a start.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "those of the Python function")]
fn record_motion<'py>(
    py: Python<'py>,
    of: Sliding,
    kind: &str,
    times: PyReadonlyArray1<'py, f64>,
    samples: PyReadonlyArray1<'py, f64>,
    after: &str,
    start: (f64, f64),
    interval: f64,
) -> PyResult<[Bound<'py, PyDict>; 3]> {
    let body = body(of).map_err(refused)?;
    let record = load(kind, times.as_slice()?, samples.as_slice()?, Some(after))?;
    let interval = if interval.is_nan() { record.longest_step() } else { interval };
    let motion =
        left_behind(py, move || body.motion(&record, start.0, start.1, interval))?.map_err(refused)?;
    let mut states = Table::default();
    let of = |value: fn(&stickslip::motion::record::RecordState<f64>) -> f64| {
        motion.states.iter().map(value).collect::<Vec<f64>>()
    };
    states.number("time", of(|state| state.time));
    states.number("displacement", of(|state| state.displacement));
    states.number("velocity", of(|state| state.velocity));
    states.number("acceleration", of(|state| state.acceleration));
    states.number("absolute_acceleration", of(|state| state.absolute_acceleration));
    states.number("friction", of(|state| state.friction));
    states.number("transmitted_force", of(|state| state.transmitted_force));
    states.number("load", of(|state| state.load));
    states.count("direction", motion.states.iter().map(|state| i64::from(state.direction)).collect());
    let mut events = Table::default();
    events.number("time", motion.events.iter().map(|event| event.time).collect());
    events.number("displacement", motion.events.iter().map(|event| event.displacement).collect());
    events.count("direction", motion.events.iter().map(|event| i64::from(event.direction)).collect());
    Ok([table(&motion.answer).into_dict(py)?, states.into_dict(py)?, events.into_dict(py)?])
}

/// The greatest responses of oscillators with these periods and a damping ratio that stand on one body.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "Python names them")]
fn record_floor_spectrum<'py>(
    py: Python<'py>,
    of: Sliding,
    kind: &str,
    times: PyReadonlyArray1<'py, f64>,
    samples: PyReadonlyArray1<'py, f64>,
    after: &str,
    start: (f64, f64),
    periods: PyReadonlyArray1<'py, f64>,
    damping_ratio: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let body = body(of).map_err(refused)?;
    let record = load(kind, times.as_slice()?, samples.as_slice()?, Some(after))?;
    let periods = periods.as_slice()?.to_vec();
    let found =
        left_behind(py, move || body.floor_spectrum(&record, start.0, start.1, &periods, damping_ratio))?;
    let found = found.map_err(refused)?;
    let of = |value: fn(&FloorResponse<f64>) -> f64| found.iter().map(value).collect::<Vec<f64>>();
    let mut table = Table::default();
    table.number("period", of(|response| response.period));
    table.number("max_displacement", of(|response| response.max_displacement));
    table.number("pseudo_acceleration", of(|response| response.pseudo_acceleration));
    table.number("max_absolute_acceleration", of(|response| response.max_absolute_acceleration));
    table.into_dict(py)
}

/// The answers of bodies in columns, and the places that have none there with the reasons.
type Each<'py> = (Bound<'py, PyDict>, Vec<(usize, String)>);

/// The answers of `n` bodies from starts: their mass, stiffness, damping constant, friction against forward and against
/// backward motion, static friction ratio and constant force, and the displacement and the velocity of each start.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the bodies, the record and the starts")]
fn record_follow_each<'py>(
    py: Python<'py>,
    columns: [points::Given<'py>; 7],
    one_way: bool,
    kind: &str,
    times: PyReadonlyArray1<'py, f64>,
    samples: PyReadonlyArray1<'py, f64>,
    after: &str,
    starts: [points::Given<'py>; 2],
    n: usize,
) -> PyResult<Each<'py>> {
    let record = load(kind, times.as_slice()?, samples.as_slice()?, Some(after))?;
    let columns = columns.iter().map(Values::of).collect::<PyResult<Vec<_>>>()?;
    let starts = starts.iter().map(Values::of).collect::<PyResult<Vec<_>>>()?;
    let is_at_rest = starts.iter().all(|values| matches!(values, Values::One(0.0, _)));
    let at = |values: &[Values<'_>], column: usize, place: usize| {
        values.get(column).and_then(|values| values.at(place)).unwrap_or(f64::NAN)
    };
    let body_at = |place: usize| {
        let [mass, stiffness, damping, forward, backward, ratio, mean] =
            [0, 1, 2, 3, 4, 5, 6].map(|column| at(&columns, column, place));
        // Friction backward that is no number is that forward, as long as the body is one.
        let backward = if backward.is_nan() { forward } else { backward };
        body((mass, stiffness, damping, forward, backward, ratio, mean, one_way))
    };
    let found = interruptible(py, |stop| -> Result<_, Error> {
        let (mut answers, mut failed) = (Answers::default(), Vec::new());
        for first in (0..n).step_by(AT_ONCE) {
            let bodies: Vec<_> = (first..n.min(first.saturating_add(AT_ONCE))).map(body_at).collect();
            let found: Vec<_> = if is_at_rest {
                let some: Vec<_> = bodies.iter().filter_map(|body| body.clone().ok()).collect();
                let mut found = follow_each_while(&some, &record, &|| stop.asked()).into_iter();
                let each = |body| match body {
                    Ok(_) => found.next().unwrap_or(Err(Error::Interrupted)),
                    Err(error) => Err(error),
                };
                bodies.into_iter().map(each).collect()
            } else {
                let follow = |(own, body): (usize, Result<Body<f64>, Error>)| {
                    let place = first.saturating_add(own);
                    if stop.asked().is_break() {
                        return Err(Error::Interrupted);
                    }
                    body?.follow_from(&record, at(&starts, 0, place), at(&starts, 1, place))
                };
                bodies.into_par_iter().enumerate().map(follow).collect()
            };
            for (own, answer) in found.into_iter().enumerate() {
                match answer {
                    Ok(answer) => answers.push(&answer, n),
                    Err(Error::Interrupted) => return Ok((answers, failed)),
                    Err(error) => failed.push((first.saturating_add(own), error.to_string())),
                }
            }
        }
        Ok((answers, failed))
    })?;
    let (answers, failed) = found.map_err(refused)?;
    Ok((answers.into_table().into_dict(py)?, failed))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(block, module)?)?;
    module.add_function(wrap_pyfunction!(blocks, module)?)?;
    module.add_function(wrap_pyfunction!(record_between, module)?)?;
    module.add_function(wrap_pyfunction!(record_check, module)?)?;
    module.add_function(wrap_pyfunction!(record_read, module)?)?;
    module.add_function(wrap_pyfunction!(record_described, module)?)?;
    module.add_function(wrap_pyfunction!(record_follow, module)?)?;
    module.add_function(wrap_pyfunction!(record_motion, module)?)?;
    module.add_function(wrap_pyfunction!(record_floor_spectrum, module)?)?;
    module.add_function(wrap_pyfunction!(record_follow_each, module)?)
}
