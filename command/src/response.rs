//! `stickslip response`.

use crate::args::{Format, ResponseArgs, used};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::given::{self, behind_all};
use crate::input::Point;
use crate::record::Record;
use crate::{enclose, input, note, points};
use std::io::Write;
use stickslip::machine::Given;
use stickslip::{Excitation, Response, ResponseAnswer};

/// The command with its arguments and its output.
struct Run<'a, W>(&'a ResponseArgs, &'a mut W);

pub(crate) fn run(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    if args.enclose {
        return enclose::response(&args.machine, &args.output, out);
    }
    bits::run(args.output.bits, Run(args, out))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        let reader = args.output.units.reader();
        let given = given::read::<F>(&args.machine, &reader)?;
        if let Some(file) = &args.output.points {
            let (output, reader) = (&args.output, &reader);
            let used = used::columns("response");
            let asked = points::Asked { file, output, reader, given, used, start: None };
            return points::run(asked, out, |given| {
                answer(given, &input::point(given)?, true).map(|(_, record)| record)
            });
        }
        let point = input::point(&given)?;
        let (response, record) = answer(&given, &point, true)?;
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note::response(&response, point.machine.as_ref(), &given.system, out)?),
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(Failure::single_format()),
        }
    }
}

/// The response at a point, and its record.
pub(crate) fn answer<F: Value>(
    given: &Given<F>,
    point: &Point<F>,
    peaks: bool,
) -> Result<(Response<F>, Record<F>), Failure> {
    let response = Response::guarded(point.ratios);
    let excitation = point.machine.as_ref().map_or(Excitation::Force, |machine| machine.drive.excitation());
    let found = ResponseAnswer { response: &response, excitation, peaks };
    let record = Record::of_answer(given, &response.ratios, &found, ResponseAnswer::COLUMNS);
    let record = match &point.machine {
        Some(machine) => record.with_machine(machine).finite().map_err(|e| behind_all(given, e))?,
        None => record,
    };
    Ok((response, record))
}
