//! `stickslip response`.

use crate::args::{ResponseArgs, Swept};
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::note::Note;
use crate::physical::Physical;
use crate::points::AskedPoints;
use crate::record::Record;
use crate::{enclose, note};
use std::io::Write;
use stickslip::inputs::{Given, Point};
use stickslip::{Response, ResponseAnswer};

pub(crate) fn run(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::answer(Swept::Response, &args.machine, &args.output, out);
    }
    at_bits!(args.output.bits, respond(args: &ResponseArgs, out))
}

fn respond<F: Value>(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    let asked = AskedPoints { question: Swept::Response, output: &args.output, start: None };
    asked.answered(
        &args.machine,
        out,
        |given: &Given<F>, point, _| answer(given, point, true),
        |point, response, given, out| note::response(response, Note::of(given, point.machine.as_ref(), out)),
    )
}

/// The response at a point, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    peaks: bool,
) -> Result<(Response<F>, Record<F>), Failure> {
    let response = Response::guarded(point.ratios);
    let found = ResponseAnswer { response: &response, excitation: point.excitation(), peaks };
    let record = Record::of_answer(given, &response.ratios, &found, ResponseAnswer::COLUMNS);
    let record = record.in_units(given, point, Physical::of_machine)?;
    Ok((response, record))
}
