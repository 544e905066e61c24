//! `stickslip border`.

use crate::args::{BorderArgs, Format};
use crate::failure::{Failure, Outcome};
use crate::record::Record;
use crate::response::single_format;
use crate::{input, note, points};
use std::io::Write;
use stickslip::{Border, Error, PhaseFunction};

pub(crate) fn run(args: &BorderArgs, out: &mut impl Write) -> Outcome {
    input::refuse_bits(&args.output)?;
    if let Some(file) = &args.output.points {
        input::refuse_single(&args.machine, None)?;
        return points::run(file, args.output.format, ["omega"], out, |[omega]| {
            let p = PhaseFunction::new(omega)?;
            Ok::<_, Error>(Record::of_border(&p, &Border::at(&p)))
        });
    }
    let point = input::border_point(&args.machine)?;
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
