//! `stickslip border`.

use crate::args::{BorderArgs, ForceArgs, Format};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter};
use crate::input::BorderPoint;
use crate::record::Record;
use crate::response::single_format;
use crate::{input, note, points};
use std::io::Write;
use stickslip::regime::no_stop_force_ratios;
use stickslip::{Error, Ratios, Response};

/// The command with its arguments and where its answer goes.
struct Run<'a, W>(&'a BorderArgs, &'a mut W);

pub(crate) fn run(args: &BorderArgs, out: &mut impl Write) -> Outcome {
    bits::run(args.output.bits, Run(args, out))
}

/// The answer at Ω; its border does not depend on the force, here r_y.
fn at<F: Value>(omega: F) -> Result<Response<F>, Error> {
    Ratios::new(omega, F::int(1)).map(Response::guarded)
}

/// The answer at a point, and its record.
fn record<F: Value>(
    given: &Given<F>,
    point: &BorderPoint<F>,
    with_no_stop: bool,
) -> Result<(Response<F>, Record<F>), Failure> {
    let answer = at(point.omega).map_err(|e| given.at_fault(e))?;
    let mut record = Record::of_border(&answer);
    if with_no_stop {
        record = record.with_no_stop(&no_stop_force_ratios(point.omega).map_err(|e| given.at_fault(e))?);
    }
    let record = match &point.physical {
        Some(scales) => record.with_border_scales(scales).finite().map_err(|e| given.behind_all(e))?,
        None => record,
    };
    Ok((answer, record))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        let reader = args.output.units.reader();
        let given = Given::<F>::of(&args.machine, &ForceArgs::default(), &reader)?;
        if let Some(file) = &args.output.points {
            let (used, ratios) = (&Parameter::BORDER, &[Parameter::Omega]);
            let asked = points::Asked { file, output: &args.output, reader: &reader, given, used, ratios };
            return points::run(asked, out, |given| {
                record(given, &input::border_point(given)?, args.no_stop).map(|(_, record)| record)
            });
        }
        let point = input::border_point(&given)?;
        let (answer, record) = record(&given, &point, args.no_stop)?;
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => {
                let no_stop = no_stop_force_ratios(point.omega).map_err(|e| given.at_fault(e))?;
                Ok(note::border(&answer, &no_stop, point.physical, &given.system, out)?)
            }
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(single_format()),
        }
    }
}
