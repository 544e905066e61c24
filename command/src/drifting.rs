//! The steady motion of a body without a spring that a constant force, or friction by direction, moves on for ever.

use crate::args::SteadyArgs;
use crate::failure::{Failure, Outcome};
use crate::system::steady_motion;
use crate::{input, interrupt, output};
use serde_json::json;
use std::io::Write;
use std::path::Path;
use stickslip_front::inputs::units::Reader;
use stickslip_front::inputs::{Given, Input};
use stickslip_front::system::{Answer, NamedSystem};

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
    let described = system(&input::with_any_mass(given), args, &args.output.units.reader())?;
    let asked = NamedSystem::new(&described, [], Path::new(""), None).map_err(Failure::Input)?;
    let engine = asked.system.clone().while_allowed(interrupt::keep_going);
    let mut found = engine.steady(&asked.described.start).map_err(Failure::from)?;
    // The system has the mean of both frictions, and half their difference as a constant force: that force is the friction's.
    let offset = offset(given)?;
    for (element, drift) in found.motion.elements.iter_mut().zip(&found.drift) {
        element.work += offset * drift;
        found.motion.load_work += offset * drift;
    }
    if args.output.is_json()? {
        return output::json(&Answer::steady(&asked.described, &found), out);
    }
    steady_motion(&asked, &found, out)
}

/// Half the difference of the frictions against forward and against backward motion.
fn offset(given: &Given<f64>) -> Result<f64, Failure> {
    let friction = given.friction()?.unwrap_or(0.0);
    Ok(0.5 * (friction - given.get(Input::FrictionBackward).unwrap_or(friction)))
}

/// The system of one body in the form of a file, with bare numbers in the system of units of the inputs.
fn system(given: &Given<f64>, args: &SteadyArgs, reader: &Reader) -> Result<serde_json::Value, Failure> {
    let or_zero = |input: Input| given.get(input).unwrap_or(0.0);
    let friction = given.friction()?.unwrap_or(0.0);
    let backward = given.get(Input::FrictionBackward).unwrap_or(friction);
    let mut symmetric = given.clone();
    symmetric.take(Input::MeanForce);
    symmetric.replace_friction(0.5 * friction + 0.5 * backward);
    let machine = symmetric.driven()?;
    let (body, drive) = (&machine.oscillator, &machine.drive);
    body.with_directional_friction(friction, backward).map_err(|e| given.at_fault(&e))?;
    let constant = or_zero(Input::MeanForce) - offset(given)?;
    let [x0, v0] = [Input::X0, Input::V0].map(|input| args.start.text(input));
    let [x0, v0] = input::start_in_units::<f64>(reader, [x0, v0])?;
    let load = json!({
        "on": "body",
        "amplitude": drive.force_amplitude(body),
        "frequency": drive.angular_frequency(),
    });
    let mut springs = Vec::new();
    if body.damping() > 0.0 {
        springs.push(json!({ "between": ["ground", "body"], "damping": body.damping() }));
    }
    Ok(json!({
        "units": given.system.to_string(),
        "masses": { "body": { "mass": body.mass(), "start": x0, "velocity": v0 } },
        "springs": springs,
        "contacts": [{
            "name": "surface",
            "between": ["ground", "body"],
            "friction": body.friction_bound(),
            "static_ratio": body.static_friction_ratio(),
        }],
        "forces": [load, { "on": "body", "constant": constant }],
    }))
}
