//! `stickslip response`.

use crate::args::{ResponseArgs, Swept};
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::given::{self, behind_all};
use crate::note::Note;
use crate::record::Record;
use crate::{enclose, input, note, points};
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
    let reader = args.output.units.reader();
    let given = given::read::<F>(&args.machine, &reader)?;
    let asked = points::AskedPoints {
        command: "response",
        output: &args.output,
        reader: &reader,
        given,
        start: None,
    };
    let answer = |given: &Given<F>| {
        let point = input::point(given)?;
        let (response, record) = answer(given, &point, true)?;
        Ok(((point, response), record))
    };
    points::answered(asked, out, answer, |(point, response), given, out| {
        note::response(response, Note::of(given, point.machine.as_ref(), out))
    })
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
    let record = match &point.machine {
        Some(machine) => record.with_machine(given, machine).finite().map_err(|e| behind_all(given, e))?,
        None => record,
    };
    Ok((response, record))
}
