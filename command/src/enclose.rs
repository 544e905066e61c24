//! `--enclose`: each output as certain digits, then ±.

#[cfg(all(feature = "mp", not(test)))]
mod found;
#[cfg(all(feature = "mp", not(test)))]
mod record;

#[cfg(any(not(feature = "mp"), test))]
use crate::args::RecordArgs;
use crate::args::{OutputArgs, Swept, Typed};
#[cfg(any(not(feature = "mp"), test))]
use crate::failure::Failure;
use crate::failure::Outcome;
#[cfg(all(feature = "mp", not(test)))]
pub(crate) use found::BITS;
#[cfg(all(feature = "mp", not(test)))]
pub(crate) use record::record;
use std::io::Write;

/// `response`, `border` or `steady` with `--enclose`.
#[cfg(all(feature = "mp", not(test)))]
pub(crate) fn answer<const PARTS: u8>(
    question: Swept,
    machine: &Typed<PARTS>,
    output: &OutputArgs,
    out: &mut impl Write,
) -> Outcome {
    let typed = found::TypedRatios::of(machine, output);
    match question {
        Swept::Response => found::response(typed, out),
        Swept::Border => found::border(typed, out),
        Swept::Steady => found::steady(typed, out),
    }
}

#[cfg(any(not(feature = "mp"), test))]
pub(crate) fn answer<const PARTS: u8>(
    _: Swept,
    _: &Typed<PARTS>,
    _: &OutputArgs,
    _: &mut impl Write,
) -> Outcome {
    Err(no_balls())
}

#[cfg(any(not(feature = "mp"), test))]
pub(crate) fn record(_: &RecordArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(any(not(feature = "mp"), test))]
pub(crate) fn no_balls() -> Failure {
    Failure::Input("--enclose: needs a build with the feature mp".to_owned())
}
