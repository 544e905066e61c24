//! Free motions that are no decay of an oscillator with friction: without a spring, without friction, on a slope, one way.

use crate::args::DecayArgs;
use crate::bits::{Value, digits};
use crate::failure::{Failure, Outcome};
use crate::input::behind_all;
use crate::note::line;
use crate::output;
use crate::outputs::key;
use crate::physical::Physical;
use crate::row::{Cell, Cells};
use crate::shaken::Surface;
use std::io::Write;
use stickslip::Excitation;
use stickslip::motion::record::Record;
use stickslip_front::inputs::Given;
use stickslip_front::inputs::units::Kind;

pub(super) fn respond<F: Value>(
    args: &DecayArgs,
    mut given: Given<F>,
    surface: &Surface<F>,
    out: &mut impl Write,
) -> Outcome {
    let is_json = args.answer.format.is_json("decay")?;
    if args.out.is_some() {
        let text = "--out: must be left out without a spring or friction, on a slope, and one way. The motion is \
                    that of simulate --shape free --out FILE";
        return Err(text.into());
    }
    let reader = args.answer.units.reader();
    if args.x0.is_none() && args.v0.is_none() {
        return Err("--v0 is missing, or --x0".to_owned().into());
    }
    let [x0, v0] = surface.start(&reader, [args.x0.as_deref(), args.v0.as_deref()])?;
    given.cancel_mass();
    let body = surface.body(&given)?;
    let zero = F::int(0);
    // A record of no load, so short that the body hardly moves in it: the motion is that after it.
    let square = body.stiffness() / body.mass();
    let short = if square > zero { F::int(1) / square.sqrt() } else { F::int(1) } / F::int(1024);
    let fail = |e: stickslip::Error| behind_all(&given, Failure::from(e));
    let record = Record::new(Excitation::Force, short, vec![zero; 2]).map_err(fail)?;
    let motion = body.motion(&record, x0, v0, short).map_err(fail)?;
    let answer = &motion.answer;
    let rests = motion.events.last().is_none_or(|event| event.direction == 0);
    let ends = answer.cut_time.is_none();
    let time = rests.then(|| motion.events.last().map_or(zero, |event| event.time));
    // A body that is pulled from its rest and let go turns where it is let go; one that slides off by its weight turns later.
    let first = if v0 == zero && !surface.is_special(&given) {
        Some(x0)
    } else {
        let turns = motion.events.iter().find(|event| event.time > zero);
        turns.map_or(answer.residual_displacement, |event| Some(event.displacement))
    };
    // The path of a motion that never ends has no end, either.
    let path = ends.then_some(answer.path);
    let halves = rests.then_some(answer.slides);
    let system = given.system;
    let values = vec![
        ("first_turn", Kind::Length, Cell::Number(first)),
        ("rest_position", Kind::Length, Cell::Number(answer.residual_displacement)),
        ("path", Kind::Length, Cell::Number(path)),
        ("rest_time", Kind::Time, Cell::Number(time)),
    ];
    let mut physical = Physical::of(system);
    physical.values = values;
    let fields = vec![(key!("half_cycles"), Cell::Count(halves))];
    if is_json {
        let record = Cells::of(fields).with_physical(physical).shown().finite()?;
        return output::json(&record, out);
    }
    match (rests, ends) {
        (true, _) if answer.slides == 0 => writeln!(out, "At rest from the start.\n")?,
        (true, _) => writeln!(out, "The body slides and comes to rest.\n")?,
        (false, true) => writeln!(out, "The body moves for ever, towards a limit.\n")?,
        (false, false) if body.friction() == zero => {
            writeln!(out, "Without friction and a damper the body never comes to rest.\n")?;
        }
        (false, false) => {
            writeln!(out, "The slope is too steep for friction: the body never comes to rest.\n")?
        }
    }
    for (name, kind, cell) in &physical.values {
        if let Cell::Number(Some(value)) = cell {
            line(out, &name.replace('_', " "), format!("{} {}", digits(*value), system.name(*kind)))?;
        }
    }
    if square > zero && (surface.is_inclined() || given.is_shifted()) {
        writeln!(out, "\nDisplacements are measured from the relaxed spring.")?;
    }
    Ok(())
}
