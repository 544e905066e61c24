//! From the arguments to the ratios and, if given, the machine.

use crate::args::{StartArgs, Swept};
use crate::bits::Value;
use crate::failure::Failure;
use stickslip::inputs::units::{self, Kind, Reader};
use stickslip::inputs::{Driven, Given, Input, Point};
use stickslip::motion::State;
use stickslip::{Error, Quantity, Ratios};

/// The ratios of `--omega` and `--alpha`, or the machine of the physical arguments.
pub(crate) fn point<F: Value>(given: &Given<F>) -> Result<Point<F>, Failure> {
    if given.is_empty() {
        let text = "--omega and --alpha are missing. Give both, or a machine: --mass, --stiffness (or --period), \
                    --friction (or --friction-coefficient), --frequency and --force";
        return Err(text.into());
    }
    Ok(given.point()?)
}

/// Ω of `--omega` at α = 1, or the machine under a force of r_y.
fn border_point<F: Value>(given: &Given<F>) -> Result<Point<F>, Failure> {
    let named = |e: Error| given.at_fault(&e);
    if given.is_empty() {
        let text = "--omega is missing. Give it, or a machine: --mass, --stiffness (or --period), --friction (or \
                    --friction-coefficient) and --frequency";
        return Err(text.into());
    }
    if !given.is_physical() {
        let ratios = Ratios::new(given.required(Input::Omega)?, F::int(1)).map_err(named)?;
        return Ok(Point { ratios: given.completed(ratios)?, machine: None });
    }
    let machine = given.on_border()?;
    Ok(Point { ratios: machine.ratios, machine: Some(machine) })
}

/// The problem of a question.
pub(crate) fn problem<F: Value>(question: Swept, given: &Given<F>) -> Result<Point<F>, Failure> {
    if question == Swept::Border { border_point(given) } else { point(given) }
}

/// The state at ω_d t = 0 given by `--x0` and `--v0`, or by a row of a file, in the units of the point.
pub(crate) fn start<F: Value>(
    start: &StartArgs,
    given: &Given<F>,
    machine: Option<&Driven<F>>,
    reader: &Reader,
) -> Result<State<F>, Failure> {
    let read = |input: Input| match (given.get(input), start.text(input)) {
        (Some(value), _) => Ok(value),
        // Without a machine there are only ratios.
        (None, Some(text)) => {
            let kind = if machine.is_some() { input.kind() } else { Kind::Ratio };
            reader.value(input.option(), text, kind)
        }
        (None, None) => Ok(F::int(0)),
    };
    let (x0, v0) = (read(Input::X0)?, read(Input::V0)?);
    let (x, v) = match machine {
        Some(Driven { scales, .. }) => (x0 / scales.length, v0 / scales.velocity),
        None => (x0, v0),
    };
    State::new(F::int(0), x, v).map_err(|e| {
        let input = if e.quantity() == Some(Quantity::Velocity) { Input::V0 } else { Input::X0 };
        let argument = match given.get(input) {
            Some(value) => format!("{} {value}", input.column()),
            None => format!("{} {}", input.option(), start.text(input).unwrap_or("0")),
        };
        Failure::Input(format!("{argument}: {e}"))
    })
}

/// The greatest number of periods of a motion.
pub(crate) fn periods(most: u32) -> Result<u32, Failure> {
    if most >= 1 { Ok(most) } else { Err("--max-periods 0: must be ≥ 1".into()) }
}

/// An integer of at least 1.
pub(crate) fn count(name: &str, text: &str, greatest: u64) -> Result<u64, Failure> {
    match text.trim().parse() {
        Ok(n) if (1..=greatest).contains(&n) => Ok(n),
        _ => Err(format!("{name} {text}: must be a whole number ≥ 1 and ≤ {greatest}").into()),
    }
}

/// A typed number.
pub(crate) fn number<F: Value>(name: &str, text: &str) -> Result<F, Failure> {
    Ok(units::number(name, text)?)
}
