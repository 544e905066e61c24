//! `stickslip design friction --target-amplitude`: every friction with which a machine has a stated amplitude.

use super::{AnswerRow, AskedDesign, NamedRow, searched_field, some};
use crate::bits::{Value, digits};
use crate::failure::{Failure, Outcome};
use crate::output;
use crate::row::{Cell, Number};
use serde::Serialize;
use std::io::Write;
use stickslip::Regime;
use stickslip::design::{TargetFriction, frictions_for_displacement};
use stickslip_front::inputs::units::Kind;

/// The answer as JSON.
#[derive(Serialize)]
struct Solutions {
    target_amplitude: Number,
    solutions: Vec<NamedRow>,
}

impl<F: Value> AskedDesign<'_, F> {
    pub(super) fn frictions_for(&self, target: &str, out: &mut impl Write) -> Outcome {
        if !self.physical {
            let text = "needs a machine in units, and --mass is missing";
            return Err(format!("--target-amplitude {target}: {text}").into());
        }
        let amplitude: F = self.reader.value("--target-amplitude", target, Kind::Length)?;
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let about = |e: stickslip::Error| match e.quantity() {
            Some(stickslip::Quantity::MaxDisplacement) => {
                Failure::Input(format!("--target-amplitude {target}: {e}"))
            }
            _ => self.fail(e),
        };
        let found = frictions_for_displacement(&body, &drive, amplitude).map_err(about)?;
        let gravity = self.given.gravity()?;
        let row = |found: &TargetFriction<F>| {
            let mut row: AnswerRow<F> = vec![
                ("friction", Kind::Force, some(found.friction)),
                ("friction_coefficient", Kind::Ratio, some(found.friction / (body.mass() * gravity))),
                ("max_displacement", Kind::Length, some(found.max_displacement)),
                ("regime", Kind::Ratio, Cell::Text(found.regime.name())),
            ];
            row.extend((found.regime != Regime::NonSticking).then(searched_field));
            row
        };
        let rows: Vec<_> = found.iter().map(row).collect();
        if self.args.answer.format.is_json("design")? {
            let solutions = rows.iter().map(|row| self.named(row)).collect();
            return output::json(&Solutions { target_amplitude: Number::of(amplitude), solutions }, out);
        }
        let (length, force) = (self.system().length(), self.system().force());
        match found.as_slice() {
            [] => writeln!(
                out,
                "No friction gives an amplitude of {} {length}: without friction it is less, or it jumps past this value.",
                digits(amplitude)
            )?,
            [one] => writeln!(
                out,
                "The amplitude is {} {length} with a friction force of {} {force}: {}.",
                digits(amplitude),
                digits(one.friction),
                words(one.regime)
            )?,
            several => {
                let count = several.len();
                writeln!(
                    out,
                    "The amplitude is {} {length} with {count} friction forces:",
                    digits(amplitude)
                )?;
                for one in several {
                    writeln!(out, "  {} {force}: {}", digits(one.friction), words(one.regime))?;
                }
            }
        }
        Ok(())
    }
}

/// The motion of a regime.
const fn words(regime: Regime) -> &'static str {
    match regime {
        Regime::NonSticking => "the body never stops",
        Regime::Stuck | Regime::Sticking | Regime::Unbounded | Regime::DependsOnStart => {
            "the body stops in each cycle"
        }
    }
}
