//! Results at a chosen precision: decimal digits in, decimal digits out.

use crate::interrupt::{Stop, interruptible};
use crate::refused;
use core::fmt::{Debug, Display, LowerExp};
use core::str::FromStr;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::exact::{LongRun, State, SteadyState};
use stickslip::float::{Mp, ParseError};
use stickslip::{Float, Output, Ratios, Response};
use stickslip::{no_stop_force_ratios, observed};

/// A value on its way to Python.
enum Cell {
    Word(&'static str),
    Digits(Option<String>),
    Count(Option<u32>),
    Flag(Option<bool>),
    Pairs(Vec<(String, Option<String>)>),
}

type Cells = Vec<(&'static str, Cell)>;

/// The question at a point.
enum Question {
    Response,
    /// The steady state from a start, followed for at most `periods` periods.
    Steady {
        start: [String; 3],
        periods: u32,
    },
}

struct Task<'a> {
    ratios: [String; 4],
    question: Question,
    stop: &'a Stop,
}

fn number<F: FromStr<Err = ParseError>>(text: &str) -> Result<F, String> {
    text.parse().map_err(|error| format!("{text}: {error}"))
}

impl Task<'_> {
    /// Computes the cells at the smaller of two widths that holds the bits. There are only two, because each
    /// compiles the whole computation once more.
    fn at(self, bits: u32) -> Result<Cells, String> {
        match bits {
            ..=256 => self.run::<Mp<4>>(),
            257..=1024 => self.run::<Mp<16>>(),
            _ => Err(format!("bits = {bits} must be ≤ 1024 here; the command has 8192")),
        }
    }

    fn run<F>(self) -> Result<Cells, String>
    where
        F: Float + FromStr<Err = ParseError> + Display + LowerExp + Debug + Send + Sync + 'static,
    {
        let [omega, alpha, damping, static_friction] = &self.ratios;
        let (omega, damping) = (number::<F>(omega)?, number::<F>(damping)?);
        let static_friction = number::<F>(static_friction)?;
        let ratios = Ratios::new(omega, number(alpha)?)
            .and_then(|r| r.with_damping_ratio(damping)?.with_static_friction_ratio(static_friction));
        let ratios = ratios.map_err(|e| e.to_string())?;
        match self.question {
            Question::Response => Ok(response(ratios)),
            Question::Steady { start: [phase, x, v], periods } => {
                let start =
                    State::new(number(&phase)?, number(&x)?, number(&v)?).map_err(|e| e.to_string())?;
                steady(ratios, start, periods, self.stop).map_err(|e| e.to_string())
            }
        }
    }
}

fn digits<F: Display>(value: Option<F>) -> Cell {
    Cell::Digits(value.map(|x| x.to_string()))
}

fn response<F: Float>(ratios: Ratios<F>) -> Cells {
    let answer = Response::guarded(ratios);
    let mut cells = vec![
        ("regime", Cell::Word(answer.regime.name())),
        ("reversals_per_cycle", Cell::Count(answer.reversals_per_cycle())),
        ("motion_without_stop", Cell::Flag(Some(answer.has_motion_without_stop()))),
        ("moves_from_rest", Cell::Flag(Some(ratios.moves_from_rest()))),
    ];
    cells.extend(Output::ALL.map(|output| (output.name(), digits(output.of(&answer)))));
    if !ratios.has_higher_static_friction()
        && let Ok(no_stop) = no_stop_force_ratios(ratios.omega(), ratios.damping_ratio())
    {
        let ends = no_stop.intervals().map(|(low, high)| (low.to_string(), high.map(|x| x.to_string())));
        cells.push(("no_stop_force_ratios", Cell::Pairs(ends.collect())));
    }
    cells
}

fn steady<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    periods: u32,
    stop: &Stop,
) -> Result<Cells, stickslip::Error> {
    let limit = LongRun::within(ratios, start, periods, &mut || stop.asked())?;
    let seen = observed(ratios, &limit);
    let steady = limit.steady_state();
    let errors = steady.map(SteadyState::errors).transpose()?;
    let multipliers = steady.map(|s| s.multipliers);
    let pairs = multipliers.map(|m| m.map(|(re, im)| (re.to_string(), Some(im.to_string()))).to_vec());
    let mut cells = vec![
        ("regime", Cell::Word(seen.regime.name())),
        ("limit", Cell::Word(limit.name())),
        ("sticks_per_cycle", Cell::Count(seen.sticks)),
        ("velocity_zeros_per_cycle", Cell::Count(steady.map(|s| s.velocity_zeros_per_cycle))),
        ("reversals_per_cycle", Cell::Count(seen.reversals)),
        ("multipliers", pairs.map_or(Cell::Digits(None), Cell::Pairs)),
        ("rest_position", digits(limit.rest_position())),
        ("periods", digits(limit.periods())),
        ("error_1", digits(errors.map(|e| e.error_1))),
        ("error_2", digits(errors.map(|e| e.error_2))),
        ("error_3", digits(errors.map(|e| e.error_3))),
        ("error_4", digits(errors.map(|e| e.error_4))),
    ];
    cells.extend(SteadyState::OUTPUTS.map(|(name, value)| (name, digits(steady.map(value)))));
    if ratios.has_higher_static_friction() {
        let irregular = limit.irregular();
        let (least, most) = limit.extrema().unzip();
        cells.extend([
            ("max_displacement", digits(most)),
            ("min_displacement", digits(least)),
            ("turns_per_cycle", Cell::Count(steady.map(|s| s.turns_per_cycle))),
            ("symmetric", Cell::Flag(steady.map(|s| s.is_symmetric))),
            ("lyapunov_exponent", digits(irregular.map(|m| m.lyapunov_exponent))),
            ("lyapunov_exponent_error", digits(irregular.map(|m| m.lyapunov_exponent_error))),
        ]);
    }
    Ok(cells)
}

fn answer(py: Python<'_>, bits: u32, ratios: [String; 4], question: Question) -> PyResult<Bound<'_, PyDict>> {
    let found = interruptible(py, |stop| Task { ratios, question, stop }.at(bits))?;
    let cells = found.map_err(refused)?;
    let dict = PyDict::new(py);
    for (name, cell) in cells {
        match cell {
            Cell::Word(word) => dict.set_item(name, word)?,
            Cell::Digits(digits) => dict.set_item(name, digits)?,
            Cell::Count(count) => dict.set_item(name, count)?,
            Cell::Flag(flag) => dict.set_item(name, flag)?,
            Cell::Pairs(pairs) => dict.set_item(name, pairs)?,
        }
    }
    Ok(dict)
}

/// All outputs of the closed forms at a point, and the force ratios without a stop, as decimal digits.
#[pyfunction]
fn wide_response(py: Python<'_>, bits: u32, ratios: [String; 4]) -> PyResult<Bound<'_, PyDict>> {
    answer(py, bits, ratios, Question::Response)
}

/// The limit from a start, as decimal digits.
#[pyfunction]
fn wide_steady(
    py: Python<'_>,
    bits: u32,
    ratios: [String; 4],
    start: [String; 3],
    max_periods: u32,
) -> PyResult<Bound<'_, PyDict>> {
    answer(py, bits, ratios, Question::Steady { start, periods: max_periods })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(wide_response, module)?)?;
    module.add_function(wrap_pyfunction!(wide_steady, module)?)
}
