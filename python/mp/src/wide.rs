//! Results at a chosen precision: decimal digits in, decimal digits out.

use crate::refused;
use core::fmt::{Debug, Display, LowerExp};
use core::str::FromStr;
use interrupt::{Stop, interruptible};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::float::{Mp, ParseError};
use stickslip::internal::{ResponseAnswer, Value, observed};
use stickslip::motion::{LongRun, State, SteadyAnswer, SteadyOutput, SteadyState};
use stickslip::{Definition, Float, NoStop, Output, Ratios, Response};

/// A value on its way to Python.
enum Cell {
    Word(&'static str),
    Digits(Option<String>),
    Count(Option<u64>),
    Flag(Option<bool>),
    Pairs(Vec<(String, Option<String>)>),
}

impl<F: Display> From<Value<F>> for Cell {
    fn from(value: Value<F>) -> Self {
        match value {
            Value::Number(number) => digits(number),
            Value::Count(count) => Self::Count(count),
            Value::Flag(flag) => Self::Flag(flag),
            Value::Text(text) => Self::Word(text),
            Value::Pairs(None) => Self::Digits(None),
            Value::Pairs(Some(pairs)) => {
                Self::Pairs(pairs.map(|(re, im)| (re.to_string(), Some(im.to_string()))).to_vec())
            }
        }
    }
}

type Cells = Vec<(&'static str, Cell)>;

/// The question at a point.
enum WideQuestion {
    Response,
    /// The steady state from a start, followed for at most `periods` periods.
    Steady {
        start: [String; 3],
        periods: u32,
    },
}

struct WideTask<'a> {
    ratios: [String; 4],
    question: WideQuestion,
    stop: &'a Stop,
}

fn number<F: FromStr<Err = ParseError>>(text: &str) -> Result<F, String> {
    text.parse().map_err(|error| format!("{text}: {error}"))
}

impl WideTask<'_> {
    /// Computes the cells at the smaller of two widths that has enough bits. There are only two, because each
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
            WideQuestion::Response => Ok(response(ratios)),
            WideQuestion::Steady { start: [phase, x, v], periods } => {
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

fn response<F: Float + Display>(ratios: Ratios<F>) -> Cells {
    let response = Response::guarded(ratios);
    let answer = ResponseAnswer { response: &response, peaks: true };
    let is_output =
        |definition: &Definition| Output::ALL.iter().any(|output| output.definition() == definition);
    let others = ResponseAnswer::COLUMNS.iter().filter(|column| !is_output(column.definition));
    let mut cells: Cells = others.map(|c| (c.definition.name, (c.of)(&answer).into())).collect();
    cells.extend(Output::ALL.map(|output| (output.name(), digits(output.of(&response)))));
    if !ratios.has_higher_static_friction() {
        let no_stop = NoStop::of(&ratios);
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
    let peaks = limit.peaks_while(&ratios, &mut || stop.asked())?;
    let errors = limit.steady_state().map(SteadyState::errors).transpose()?;
    let answer = SteadyAnswer { ratios, limit: &limit, seen: observed(ratios, &limit), errors, peaks };
    let columns = SteadyAnswer::COLUMNS.iter();
    let mut cells: Cells = columns.map(|c| (c.definition.name, (c.of)(&answer).into())).collect();
    let contraction = SteadyOutput::Contraction;
    let value = limit.steady_state().map(|steady| contraction.of(steady));
    cells.push((contraction.definition().name, digits(value)));
    Ok(cells)
}

fn answer(
    py: Python<'_>,
    bits: u32,
    ratios: [String; 4],
    question: WideQuestion,
) -> PyResult<Bound<'_, PyDict>> {
    let found = interruptible(py, |stop| WideTask { ratios, question, stop }.at(bits))?;
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
    answer(py, bits, ratios, WideQuestion::Response)
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
    answer(py, bits, ratios, WideQuestion::Steady { start, periods: max_periods })
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(wide_response, module)?)?;
    module.add_function(wrap_pyfunction!(wide_steady, module)?)
}
