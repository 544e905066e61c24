//! `--enclose`: each output as digits that are certain, then ±.

#[cfg(feature = "mp")]
mod found;
#[cfg(feature = "mp")]
mod motion;

use crate::args::{MachineArgs, OutputArgs};
use crate::failure::{Failure, Outcome};
use std::io::Write;

/// The ratio that was typed, or a complaint that it is missing.
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
    undamped(machine)?;
    enclosed_response(typed("--omega", &machine.omega)?, typed("--alpha", alpha)?, output, out)
}

/// `border --enclose`.
pub(crate) fn border(machine: &MachineArgs, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    undamped(machine)?;
    enclosed_border(typed("--omega", &machine.omega)?, output, out)
}

/// `steady --enclose`.
pub(crate) fn steady(
    machine: &MachineArgs,
    alpha: &Option<String>,
    output: &OutputArgs,
    out: &mut impl Write,
) -> Outcome {
    let ratios = (typed("--omega", &machine.omega)?, typed("--alpha", alpha)?);
    let others = (machine.damping_ratio.as_deref(), machine.static_friction_ratio.as_deref());
    enclosed_steady(ratios, others, output, out)
}

/// The closed forms with damping or static friction have no enclosures.
fn undamped(machine: &MachineArgs) -> Outcome {
    if let Some(eta) = &machine.static_friction_ratio {
        return Err(Failure::Input(format!(
            "--static-friction-ratio {eta}: --enclose has closed forms for static friction as large as kinetic"
        )));
    }
    let Some(zeta) = &machine.damping_ratio else { return Ok(()) };
    Err(Failure::Input(format!("--damping-ratio {zeta}: --enclose is for closed forms without damping")))
}

#[cfg(feature = "mp")]
pub(crate) use found::BITS;
#[cfg(feature = "mp")]
use found::{border as enclosed_border, response as enclosed_response};
#[cfg(feature = "mp")]
use motion::steady as enclosed_steady;

#[cfg(not(feature = "mp"))]
fn enclosed_response(_: &str, _: &str, _: &OutputArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
fn enclosed_border(_: &str, _: &OutputArgs, _: &mut impl Write) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
fn enclosed_steady(
    _: (&str, &str),
    _: (Option<&str>, Option<&str>),
    _: &OutputArgs,
    _: &mut impl Write,
) -> Outcome {
    Err(no_balls())
}

#[cfg(not(feature = "mp"))]
pub(crate) fn no_balls() -> Failure {
    Failure::Input("--enclose: this build has no enclosures; they need the feature mp".to_owned())
}
