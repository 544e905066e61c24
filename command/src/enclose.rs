//! `--enclose`: each output as certain digits, then ±.

#[cfg(feature = "mp")]
mod found;
#[cfg(feature = "mp")]
mod motion;
#[cfg(feature = "mp")]
mod record;

#[cfg(not(feature = "mp"))]
use crate::args::RecordArgs;
use crate::args::{BodyArgs, MachineArgs, OutputArgs, Typed};
use crate::failure::{Failure, Outcome};
use std::io::Write;
use stickslip::inputs::Input;

/// A ratio as typed, or an error if it is missing.
fn typed<const PARTS: u8>(machine: &Typed<PARTS>, input: Input) -> Result<&str, Failure> {
    machine.text(input).ok_or_else(|| Failure::Input(format!("{} is missing", input.option())))
}

/// `response --enclose`.
pub(crate) fn response(machine: &MachineArgs, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    let ratios = (typed(machine, Input::Omega)?, typed(machine, Input::Alpha)?);
    enclosed_response(ratios, others(machine), output, out)
}

/// `border --enclose`.
pub(crate) fn border(machine: &BodyArgs, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    enclosed_border(typed(machine, Input::Omega)?, others(machine), output, out)
}

/// `steady --enclose`.
pub(crate) fn steady(machine: &MachineArgs, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    let ratios = (typed(machine, Input::Omega)?, typed(machine, Input::Alpha)?);
    enclosed_steady(ratios, others(machine), output, out)
}

/// The damping ratio and the static friction ratio as typed.
type Others<'a> = (Option<&'a str>, Option<&'a str>);

fn others<const PARTS: u8>(machine: &Typed<PARTS>) -> Others<'_> {
    (machine.text(Input::DampingRatio), machine.text(Input::StaticFrictionRatio))
}

#[cfg(feature = "mp")]
pub(crate) use found::BITS;
#[cfg(feature = "mp")]
use found::{border as enclosed_border, response as enclosed_response};
#[cfg(feature = "mp")]
use motion::steady as enclosed_steady;
#[cfg(feature = "mp")]
pub(crate) use record::record;

#[cfg(not(feature = "mp"))]
fn enclosed_response(_: (&str, &str), _: Others<'_>, _: &OutputArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
fn enclosed_border(_: &str, _: Others<'_>, _: &OutputArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
fn enclosed_steady(_: (&str, &str), _: Others<'_>, _: &OutputArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
pub(crate) fn record(_: &RecordArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
pub(crate) fn no_balls() -> Failure {
    Failure::Input("--enclose: needs a build with the feature mp".to_owned())
}
