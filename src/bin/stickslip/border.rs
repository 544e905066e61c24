//! `stickslip border`.

use crate::args::{BorderArgs, Format};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
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

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        if let Some(file) = &args.output.points {
            return points::run::<F, 1>(file, args.output.format, ["omega"], out, |[omega]| {
                let record = Record::of_border(&at(omega)?);
                Ok(if args.no_stop { record.with_no_stop(&no_stop_force_ratios(omega)?) } else { record })
            });
        }
        let point = input::border_point::<F>(&args.machine)?;
        let answer = at(point.omega).map_err(|e| Failure::Input(format!("--omega: {e}")))?;
        let no_stop =
            no_stop_force_ratios(point.omega).map_err(|e| Failure::Input(format!("--omega: {e}")))?;
        let record = Record::of_border(&answer);
        let record = if args.no_stop { record.with_no_stop(&no_stop) } else { record };
        let record = match point.physical {
            Some(scales) => record
                .with_border_scales(scales)
                .finite()
                .map_err(|failure| failure.about(&input::typed(&args.machine, &input::NO_FORCE)))?,
            None => record,
        };
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note::border(&answer, &no_stop, point.physical, &args.output.units, out)?),
            Format::Json => record.write_pretty(out),
            Format::Jsonl | Format::Csv => Err(single_format()),
        }
    }
}
