//! `--enclose`: each output as certain digits, then ±.

#[cfg(feature = "mp")]
mod found;
#[cfg(feature = "mp")]
mod motion;

use crate::args::{MachineArgs, OutputArgs};
use crate::failure::{Failure, Outcome};
use std::io::Write;

/// The typed ratio, or an error if it is missing.
fn typed<'a>(option: &str, text: &'a Option<String>) -> Result<&'a str, Failure> {
    text.as_deref().ok_or_else(|| Failure::Input(format!("{option} is missing")))
}

/// `response --enclose`.
pub(crate) fn response(
    machine: &MachineArgs,
    alpha: &Option<String>,
    output: &OutputArgs,
    out: &mut impl Write,
) -> Outcome {
    let ratios = (typed("--omega", &machine.omega)?, typed("--alpha", alpha)?);
    enclosed_response(ratios, others(machine), output, out)
}

/// `border --enclose`.
pub(crate) fn border(machine: &MachineArgs, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    enclosed_border(typed("--omega", &machine.omega)?, others(machine), output, out)
}

/// `steady --enclose`.
pub(crate) fn steady(
    machine: &MachineArgs,
    alpha: &Option<String>,
    output: &OutputArgs,
    out: &mut impl Write,
) -> Outcome {
    let ratios = (typed("--omega", &machine.omega)?, typed("--alpha", alpha)?);
    enclosed_steady(ratios, others(machine), output, out)
}

/// The damping ratio and the static friction ratio as typed.
type Others<'a> = (Option<&'a str>, Option<&'a str>);

fn others(machine: &MachineArgs) -> Others<'_> {
    (machine.damping_ratio.as_deref(), machine.static_friction_ratio.as_deref())
}

#[cfg(feature = "mp")]
pub(crate) use found::BITS;
#[cfg(feature = "mp")]
use found::{border as enclosed_border, response as enclosed_response};
#[cfg(feature = "mp")]
use motion::steady as enclosed_steady;

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
pub(crate) fn no_balls() -> Failure {
    Failure::Input("--enclose: needs a build with the feature mp".to_owned())
}
