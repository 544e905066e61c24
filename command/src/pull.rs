//! `stickslip pull`: a body pulled through its spring at a constant speed.

use crate::args::PullArgs;
use crate::bits::{Value, at_bits, digits};
use crate::design::{AnswerRow, NamedRow, shown};
use crate::failure::{Failure, Outcome};
use crate::note::line;
use crate::row::Cell;
use crate::{input, output};
use std::io::Write;
use stickslip::Quantity;
use stickslip::motion::Pull;
use stickslip_front::inputs::units::Kind;
use stickslip_front::inputs::{Given, Input, Role};

pub(crate) fn run(args: &PullArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.answer.bits, respond(args: &PullArgs, out))
}

fn respond<F: Value>(args: &PullArgs, out: &mut impl Write) -> Outcome {
    let reader = args.answer.units.reader();
    let given = input::read::<F>(&args.machine, &reader)?;
    let is_without_friction = given.is_without_friction();
    let given = without_friction(given);
    let body = given.oscillator()?;
    let speed: F = reader.value("--speed", &args.speed, Kind::Velocity)?;
    let pull = Pull::new(&body, speed).map_err(|e| match e.quantity() {
        Some(Quantity::Velocity | Quantity::Time | Quantity::Duration) => {
            Failure::Input(format!("--speed {}: {e}", args.speed))
        }
        _ => given.at_fault(&e).into(),
    })?;
    let row: AnswerRow<F> = vec![
        ("period", Kind::Time, Cell::Number(pull.period)),
        ("slip_time", Kind::Time, Cell::Number(pull.slip_time)),
        ("stick_time", Kind::Time, Cell::Number(pull.stick_time)),
        ("slip_distance", Kind::Length, Cell::Number(pull.slip_distance)),
        ("max_velocity", Kind::Velocity, Cell::Number(Some(pull.max_velocity))),
        ("smooth_above", Kind::Velocity, Cell::Number(pull.smooth_above)),
    ];
    let row = shown(&row);
    row.iter().try_for_each(|(name, _, cell)| cell.finite(name))?;
    if args.answer.format.is_json("pull")? {
        let system = Some(given.system);
        return output::json(&NamedRow { row, system, base_motion: None }, out);
    }
    let velocity = given.system.name(Kind::Velocity);
    match (pull.period, pull.smooth_above) {
        (Some(_), Some(least)) => writeln!(
            out,
            "Stick-slip: the body sticks and slips in turn. From {} {velocity} on it slides smoothly.\n",
            digits(least)
        )?,
        (Some(_), None) => writeln!(
            out,
            "Stick-slip: the body sticks and slips in turn, at every speed, since there is no damper.\n"
        )?,
        (None, _) if body.damping() == F::int(0) => {
            let why =
                if is_without_friction { " Without friction and a damper" } else { " Without a damper" };
            writeln!(
                out,
                "Smooth: the body never stops.{why} its speed swings between 0 and twice that of the pull.\n"
            )?;
        }
        (None, _) => writeln!(out, "Smooth: the body slides on, and its speed tends to that of the pull.\n")?,
    }
    for (name, kind, cell) in row.iter().filter(|(_, _, cell)| *cell != Cell::Number(None)) {
        line(out, &name.replace('_', " "), format!("{} {}", cell.text(), given.system.name(*kind)))?;
    }
    Ok(())
}

/// The inputs with a friction of 1 and no static friction in place of a friction of 0: a smooth pull does not depend on it.
fn without_friction<F: Value>(mut given: Given<F>) -> Given<F> {
    if given.is_without_friction() {
        Input::of_role(Role::StaticFriction).into_iter().for_each(|input| _ = given.take(input));
        given.replace_friction(F::int(1));
    }
    given
}
