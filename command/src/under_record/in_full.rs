//! The motion under a record that repeats itself, with all digits of a precision.

use crate::args::RecordArgs;
use crate::bits::in_one_copy;
use crate::failure::Outcome;
use crate::measured;
use crate::shaken::Shaken;
use crate::system::wide;
use crate::{interrupt, output};
use std::io::Write;
use stickslip::float::Widest;
use stickslip_front::system::{Answer, Described, steady_of_body};

/// Answers in numbers of at least so many bits, about the system whose names and units are those of doubles.
pub(super) fn repeated(args: &RecordArgs, bits: u32, described: &Described, out: &mut impl Write) -> Outcome {
    in_one_copy(bits, || {
        let Shaken { given, body, record, summary, start, .. } = Shaken::<Widest>::read(args)?;
        let found = steady_of_body(&body, given.system, start, &record, interrupt::keep_going);
        let found = found.map_err(|e| format!("{}: {e}", args.file.display()))??;
        if args.answer.format.is_json("record")? {
            let texts = wide::steady_texts(&found);
            let answer = Answer::steady(described, &texts);
            return output::json(&measured::Described::repeated(&answer, &summary), out);
        }
        writeln!(out, "{}\nIt repeats itself.\n", measured::line(&summary))?;
        wide::steady_motion(&found, described, out)
    })
}
