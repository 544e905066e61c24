//! `stickslip border`.

use crate::args::{BorderArgs, Format};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::record::Record;
use crate::response::single_format;
use crate::{input, note, points};
use std::io::Write;
use stickslip::{Border, Error, PhaseFunction};

/// The command with its arguments and where its answer goes.
struct Run<'a, W>(&'a BorderArgs, &'a mut W);

pub(crate) fn run(args: &BorderArgs, out: &mut impl Write) -> Outcome {
    bits::run(args.output.bits, Run(args, out))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        if let Some(file) = &args.output.points {
            input::refuse_single(&args.machine, None)?;
            return points::run::<F, 1>(file, args.output.format, ["omega"], out, |[omega]| {
                let p = PhaseFunction::new(omega)?;
                Ok::<_, Error>(Record::of_border(&p, &Border::at(&p)))
            });
        }
        let point = input::border_point::<F>(&args.machine)?;
        let p = PhaseFunction::new(point.omega).map_err(|e| Failure::Input(format!("--omega: {e}")))?;
        let border = Border::at(&p);
        match args.output.format.unwrap_or(Format::Text) {
            Format::Text => Ok(note::border(&p, &border, point.physical, &args.output.units, out)?),
            Format::Json => {
                let record = Record::of_border(&p, &border);
                match point.physical {
                    Some(scales) => record.with_border_scales(scales),
                    None => record,
                }
                .write_pretty(out)
            }
            Format::Jsonl | Format::Csv => Err(single_format()),
        }
    }
}
