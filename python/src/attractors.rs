//! All attractors to which a set of starts leads.

use crate::motion::Start;
use crate::points::{Point, ratios};
use crate::refused;
use interrupt::{Stop, interruptible};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use rayon::prelude::*;
use stickslip::motion::{Attractor, Attractors, LongRun, Starts, State};
use stickslip::{Error, Ratios};

/// The requested starts.
#[derive(FromPyObject)]
enum Asked {
    /// A number of starts, spread evenly.
    Count(u64),
    /// A list of starts.
    These(Vec<Start>),
}

/// The attractors of a number of starts within `reach`, or of a list of starts, each followed for at most
/// `max_periods` periods.
#[pyfunction]
fn attractors_at<'py>(
    py: Python<'py>,
    point: Point,
    starts: Asked,
    reach: Option<f64>,
    max_periods: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let ratios = ratios(point).map_err(refused)?;
    let (starts, reach) = states(ratios, starts, reach)?;
    let found = interruptible(py, |stop| limits(ratios, &starts, max_periods, stop))?.map_err(refused)?;
    let list = PyList::empty(py);
    for (place, limit) in found.limits.iter().enumerate() {
        list.append(row(py, &found, place, limit, &starts)?)?;
    }
    let of_start = found.of_start.iter().map(|n| n.and_then(|n| i64::try_from(n).ok()));
    let dict = PyDict::new(py);
    dict.set_item("starts", found.of_start.len())?;
    dict.set_item("reach", reach)?;
    dict.set_item("unsettled", found.unsettled())?;
    dict.set_item("of_start", of_start.map(|n| n.unwrap_or(-1)).collect::<Vec<i64>>().into_pyarray(py))?;
    dict.set_item("attractors", list)?;
    Ok(dict)
}

/// The starts, and the reach of spread starts.
fn states(ratios: Ratios<f64>, asked: Asked, reach: Option<f64>) -> PyResult<(Vec<State<f64>>, Option<f64>)> {
    match (asked, reach) {
        (Asked::Count(count), _) => {
            let spread = match reach {
                None => Starts::around(&ratios),
                Some(reach) => Starts::within(reach)
                    .ok_or_else(|| refused(format!("reach = {reach} must be > 0 and <= 2**40")))?,
            };
            if !(1..=10_000_000).contains(&count) {
                return Err(refused(format!("starts = {count} must be >= 1 and <= 10000000")));
            }
            Ok(((0..count).map(|number| spread.get(number)).collect(), Some(spread.reach())))
        }
        (Asked::These(_), Some(reach)) => {
            Err(refused(format!("reach = {reach}: applies only if starts is a number; leave it out")))
        }
        (Asked::These(starts), None) => {
            if starts.is_empty() {
                return Err(refused("starts: give one or more"));
            }
            let states = starts.into_iter().map(|(phase, x, v)| State::new(phase, x, v));
            Ok((states.collect::<Result<_, _>>().map_err(refused)?, None))
        }
    }
}

fn limits(
    ratios: Ratios<f64>,
    starts: &[State<f64>],
    max_periods: u32,
    stop: &Stop,
) -> Result<Attractors<f64>, Error> {
    let limit = |start: &State<f64>| LongRun::within(ratios, *start, max_periods, &mut || stop.asked());
    Attractors::of_limits(starts.par_iter().map(limit).collect::<Result<Vec<_>, _>>()?)
}

fn row<'py>(
    py: Python<'py>,
    all: &Attractors<f64>,
    place: usize,
    found: &Attractor<f64>,
    starts: &[State<f64>],
) -> PyResult<Bound<'py, PyDict>> {
    let limit = &found.limit;
    let irregular = if let LongRun::Irregular(motion) = limit { Some(motion) } else { None };
    let steady = limit.steady_state();
    let first = starts.get(found.first_start);
    let dict = PyDict::new(py);
    dict.set_item("attractor", place)?;
    dict.set_item("limit", limit.name())?;
    dict.set_item("share", found.starts as f64 / all.of_start.len() as f64)?;
    dict.set_item("starts", found.starts)?;
    dict.set_item("first_x", first.map(|start| start.x))?;
    dict.set_item("first_v", first.map(|start| start.v))?;
    dict.set_item("mirror", found.mirror)?;
    dict.set_item("symmetric", steady.map(|s| s.is_symmetric))?;
    dict.set_item("turns_per_cycle", steady.map(|s| s.turns_per_cycle))?;
    dict.set_item("max_displacement", limit.extrema().map(|(_, most)| most))?;
    dict.set_item("min_displacement", limit.extrema().map(|(least, _)| least))?;
    dict.set_item("sticks_per_cycle", steady.map(|s| s.sticks_per_cycle))?;
    dict.set_item("velocity_zeros_per_cycle", steady.map(|s| s.velocity_zeros_per_cycle))?;
    dict.set_item("stick_fraction", steady.map(|s| s.stick_fraction))?;
    dict.set_item("multipliers", steady.map(|s| s.multipliers.to_vec()))?;
    dict.set_item("lyapunov_exponent", irregular.map(|m| m.lyapunov_exponent))?;
    dict.set_item("lyapunov_exponent_error", irregular.map(|m| m.lyapunov_exponent_error))?;
    dict.set_item("rest_from", found.range.map(|(low, _)| low))?;
    dict.set_item("rest_to", found.range.map(|(_, high)| high))?;
    Ok(dict)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(attractors_at, module)?)
}
