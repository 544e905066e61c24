//! `stickslip response`.

use crate::args::{Format, ResponseArgs};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::record::Record;
use crate::{input, note, points};
use std::io::Write;
use stickslip::{Ratios, Response};

/// The command with its arguments and where its answer goes.
struct Run<'a, W>(&'a ResponseArgs, &'a mut W);

pub(crate) fn run(args: &ResponseArgs, out: &mut impl Write) -> Outcome {
    bits::run(args.output.bits, Run(args, out))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        if let Some(file) = &args.output.points {
            return points::run::<F, 2>(
                file,
                args.output.format,
                ["omega", "alpha"],
                out,
                |[omega, alpha]| Ok(Record::of_response(&Response::guarded(Ratios::new(omega, alpha)?))),
            );
        }
        let point = input::point::<F>(&args.machine, &args.force)?;
        let response = Response::guarded(point.ratios);
        let record = Record::of_response(&response);
        let record = match &point.machine {
            Some(machine) => record
                .with_machine(machine)
                .finite()
                .map_err(|failure| failure.about(&input::typed(&args.machine, &args.force)))?,
            None => record,
        };
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note::response(&response, point.machine.as_ref(), &args.output.units, out)?),
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(single_format()),
        }
    }
}

/// `jsonl` and `csv` are for streams.
pub(crate) fn single_format() -> Failure {
    Failure::Input("--format: jsonl and csv go with --points; a single answer is text or json".to_owned())
}
