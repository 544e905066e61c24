//! The steady motion of a body without a spring that a constant force, or friction by direction, moves on for ever.

use crate::args::{MachineArgs, StartArgs, SteadyArgs};
use crate::failure::{Failure, Outcome};
use crate::system::steady_motion;
use crate::{input, interrupt, output};
use std::io::Write;
use stickslip_front::inputs::units::Reader;
use stickslip_front::inputs::{Driven, Given, Input};
use stickslip_front::system::{Answer, OneBody};

/// The inputs, if they are those of one body that drifts.
pub(crate) fn asked(machine: &MachineArgs, reader: &Reader) -> Result<Option<Given<f64>>, Failure> {
    if machine.text(Input::Stiffness).is_none() {
        return Ok(None);
    }
    let given = input::read::<f64>(machine, reader)?;
    Ok(given.drifts().is_some().then_some(given))
}

/// Those of `stickslip steady`, whose bounds have no drift.
pub(crate) fn of_steady(args: &SteadyArgs) -> Result<Option<Given<f64>>, Failure> {
    if args.enclose {
        return Ok(None);
    }
    asked(&args.machine, &args.output.units.reader())
}

/// Refuses more bits than those of a double, and many machines.
pub(crate) fn check(given: &Given<f64>, bits: Option<u32>, is_one: bool) -> Outcome {
    if is_one && bits.is_none_or(|bits| bits <= f64::MANTISSA_DIGITS) {
        return Ok(());
    }
    let text = given.drifts().map(|input| given.label(input)).unwrap_or_default();
    Err(format!("{text}: a drift is answered at 53 bits and for one machine").into())
}

/// The answer: that of a system of this one body.
pub(crate) fn run(args: &SteadyArgs, given: &Given<f64>, out: &mut impl Write) -> Outcome {
    check(given, args.output.bits, args.output.points.is_none())?;
    let given = input::with_any_mass(given);
    let (one, _) = one_body(&given, &args.start, 0.0, &args.output.units.reader())?;
    let found = one.steady().map_err(Failure::from)?;
    if args.output.is_json()? {
        return output::json(&Answer::steady(&one.system.described, &found), out);
    }
    steady_motion(&one.system, &found, None, out)
}

/// [`OneBody::drifting`] from the typed start, which an interruption ends.
pub(crate) fn one_body(
    given: &Given<f64>,
    start: &StartArgs,
    phase: f64,
    reader: &Reader,
) -> Result<(OneBody, Driven<f64>), Failure> {
    let start = input::start_in_units::<f64>(reader, [Input::X0, Input::V0].map(|input| start.text(input)))?;
    let (one, machine) = OneBody::drifting(given, start, phase)?;
    Ok((one.while_allowed(interrupt::keep_going), machine))
}
