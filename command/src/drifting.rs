//! The steady motion of a body without a spring that a constant force, or friction by direction, moves on for ever.

use crate::args::SteadyArgs;
use crate::failure::{Failure, Outcome};
use crate::system::steady_motion;
use crate::{input, interrupt, output};
use std::io::Write;
use stickslip::motion::record::Body;
use stickslip_front::inputs::units::Reader;
use stickslip_front::inputs::{Given, Input};
use stickslip_front::system::{Answer, OneBody, Repeated};

/// The inputs, if they are those of one body that drifts.
pub(crate) fn asked(args: &SteadyArgs) -> Result<Option<Given<f64>>, Failure> {
    if args.enclose || args.machine.text(Input::Stiffness).is_none() {
        return Ok(None);
    }
    let given = input::read::<f64>(&args.machine, &args.output.units.reader())?;
    Ok((given.is_without_spring() && given.drifts().is_some()).then_some(given))
}

/// The answer: that of a system of this one body.
pub(crate) fn run(args: &SteadyArgs, given: &Given<f64>, out: &mut impl Write) -> Outcome {
    if args.output.bits.is_some_and(|bits| bits > f64::MANTISSA_DIGITS) || args.output.points.is_some() {
        let text = given.drifts().map(|input| given.label(input)).unwrap_or_default();
        return Err(format!("{text}: a drift is answered at 53 bits and for one machine").into());
    }
    let (body, start, load) = asked_of(&input::with_any_mass(given), args, &args.output.units.reader())?;
    let one = OneBody::new(&body, given.system, start, load).map_err(Failure::Input)?;
    let one = one.while_allowed(interrupt::keep_going);
    let found = one.steady().map_err(Failure::from)?;
    if args.output.is_json()? {
        return output::json(&Answer::steady(&one.system.described, &found), out);
    }
    steady_motion(&one.system, &found, None, out)
}

/// The body, its start and its load.
fn asked_of(
    given: &Given<f64>,
    args: &SteadyArgs,
    reader: &Reader,
) -> Result<(Body<f64>, [f64; 2], Repeated<'static>), Failure> {
    let friction = given.friction()?.unwrap_or(0.0);
    let backward = given.get(Input::FrictionBackward).unwrap_or(friction);
    let mut symmetric = given.clone();
    symmetric.take(Input::MeanForce);
    symmetric.replace_friction(0.5 * friction + 0.5 * backward);
    let machine = symmetric.driven()?;
    let both = machine.oscillator.with_directional_friction(friction, backward);
    both.map_err(|e| given.at_fault(&e))?;
    let drive = &machine.drive;
    let load = Repeated::Sine {
        amplitude: drive.force_amplitude(&machine.oscillator),
        frequency: drive.angular_frequency(),
    };
    let [x0, v0] = [Input::X0, Input::V0].map(|input| args.start.text(input));
    Ok((given.body(None)?, input::start_in_units::<f64>(reader, [x0, v0])?, load))
}
