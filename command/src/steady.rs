//! `stickslip steady`.

mod note;

use crate::args::{SteadyArgs, Swept};
use crate::bits::{Value, at_bits};
use crate::enclose;
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::interrupt;
use crate::physical::Physical;
use crate::points::AskedPoints;
use crate::record::Record;
use std::io::Write;
use stickslip::inputs::units::Reader;
use stickslip::inputs::{Given, Point};
use stickslip::motion::{LongRun, State, SteadyAnswer};
use stickslip::{Error, Quantity};

use note::note;

pub(crate) fn run(args: &SteadyArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::answer(Swept::Steady, &args.machine, &args.output, out);
    }
    at_bits!(args.output.bits, respond(args: &SteadyArgs, out))
}

fn respond<F: Value>(args: &SteadyArgs, out: &mut impl Write) -> Outcome {
    input::periods(args.max_periods)?;
    let asked = AskedPoints { question: Swept::Steady, output: &args.output, start: Some(&args.start) };
    let answer = |given: &Given<F>, point: &Point<F>, reader: &Reader| {
        let start = input::start(&args.start, given, point.machine.as_ref(), reader)?;
        answer(given, point, start, args.max_periods, true)
    };
    asked.answered(&args.machine, out, answer, |point, limit, given, out| note(given, point, limit, out))
}

/// The steady state from a start, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    start: State<F>,
    max_periods: u32,
    peaks: bool,
) -> Result<(LongRun<F>, Record<F>), Failure> {
    let limit = LongRun::within(point.ratios, start, max_periods, &mut interrupt::keep_going)
        .map_err(|e| of_motion(given, e))?;
    let record = of_limit(given, point, &limit, peaks)?;
    Ok((limit, record))
}

/// A record of no motion, for the names of its values.
pub(crate) fn form<F: Value>(given: &Given<F>, point: &Point<F>, peaks: bool) -> Result<Record<F>, Failure> {
    of_limit(given, point, &LongRun::Unbounded { growth: F::int(0) }, peaks)
}

/// The record of a limit.
fn of_limit<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    limit: &LongRun<F>,
    peaks: bool,
) -> Result<Record<F>, Failure> {
    let found =
        SteadyAnswer::new(point.ratios, point.excitation(), limit, peaks).map_err(|e| given.at_fault(&e))?;
    let record = Record::of_answer(given, &point.ratios, &found, SteadyAnswer::COLUMNS);
    record.in_units(given, point, Physical::of_machine)
}

/// The failure, preceded by the argument for which the exact motion cannot be computed.
pub(crate) fn of_motion<F: Value>(given: &Given<F>, error: Error) -> Failure {
    if matches!(error.quantity(), Some(Quantity::DampingRatio | Quantity::StaticFrictionRatio)) {
        return given.at_fault(&error).into();
    }
    Failure::from(error).about("--omega or --frequency")
}
