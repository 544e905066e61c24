//! The lines of a note, and what they are written from.

use crate::bits::{Value, digits};
use std::fmt::Display;
use std::io;
use std::io::Write;
use stickslip::{Excitation, Measure, Scales};
use stickslip_front::inputs::{Driven, Given, Input};
use stickslip_front::without::{is_of_friction, is_of_spring, without_friction};

/// A line of a note: a name and its value, below those of the lines before.
pub(crate) fn line(out: &mut impl Write, name: &str, value: impl Display) -> io::Result<()> {
    writeln!(out, "  {name:<24} {value}")
}

/// A number with its unit.
pub(super) fn with_unit<F: Value>(x: F, unit: &str) -> String {
    format!("{} {unit}", digits(x))
}

/// A number in its dimensionless unit and, if there is a machine, in the user's unit.
pub(crate) fn both<F: Value>(x: F, unit: &str, scale: Option<F>, name: &str) -> String {
    let own = with_unit(x, unit);
    match scale {
        Some(scale) => format!("{:<22} = {} {name}", own.trim_end(), digits(x * scale)),
        None => own.trim_end().to_owned(),
    }
}

/// A note on a machine, or on ratios alone.
pub(crate) struct Note<'a, F, W> {
    pub(crate) given: &'a Given<F>,
    pub(crate) machine: Option<&'a Driven<F>>,
    /// The sizes of the ratios, if there is a machine.
    pub(crate) scales: Option<&'a Scales<F>>,
    pub(crate) out: &'a mut W,
}

impl<'a, F: Value, W: Write> Note<'a, F, W> {
    pub(crate) fn of(given: &'a Given<F>, machine: Option<&'a Driven<F>>, out: &'a mut W) -> Self {
        Self { given, machine, scales: machine.map(|machine| &machine.scales), out }
    }

    /// A number in its unit and, if there is a machine, in that of the user.
    pub(crate) fn both(&self, measure: Measure, x: F) -> String {
        let scale = self.scales.map(|scales| measure.size(scales));
        if let (true, Some(scale)) = (self.is_without(measure), scale) {
            let x = if self.given.is_without_friction() { without_friction(measure, x) } else { x };
            let value = digits(x * scale);
            return format!("{value} {}", self.given.system.name(measure.kind()));
        }
        both(x, measure.unit(), scale, &self.given.system.name(measure.kind()))
    }

    /// Whether a quantity has no unit in ratios, because there is no friction or no spring.
    pub(super) fn is_without(&self, measure: Measure) -> bool {
        self.given.is_without_friction() && is_of_friction(measure)
            || self.given.is_without_spring() && is_of_spring(measure)
    }

    /// A line with a number.
    pub(crate) fn number(&mut self, name: &str, measure: Measure, x: F) -> io::Result<()> {
        let text = self.both(measure, x);
        self.line(name, text)
    }

    pub(crate) fn line(&mut self, name: &str, value: impl Display) -> io::Result<()> {
        line(self.out, name, value)
    }

    /// Whether the excitation is one of those.
    pub(crate) fn is_driven(&self, is_one: fn(Excitation) -> bool) -> bool {
        self.machine.is_some_and(|machine| is_one(machine.drive.excitation()))
    }
}

impl<F: Value, W: Write> Note<'_, F, W> {
    /// The greatest force in the spring.
    pub(crate) fn in_spring(&mut self, name: &str, force: F) -> io::Result<()> {
        if self.given.is_without_spring() {
            return Ok(());
        }
        self.number(name, Measure::Force, force)?;
        if self.given.is_shifted() {
            writeln!(
                self.out,
                "    (without k times the mean displacement, which the spring carries in addition)"
            )?;
        }
        Ok(())
    }

    /// The greatest force on the support.
    pub(crate) fn transmitted(&mut self, name: &str, force: F) -> io::Result<()> {
        self.number(name, Measure::Force, force)?;
        if self.given.has(Input::MeanForce) {
            writeln!(self.out, "    (without the mean force p̄, which the support carries in addition)")?;
        }
        Ok(())
    }
}

/// The displacement from which a shifted motion is measured, in a sentence.
pub(crate) fn measured_from<F: Value>(
    given: &Given<F>,
    machine: Option<&Driven<F>>,
    out: &mut impl Write,
) -> io::Result<()> {
    if given.is_without_spring() {
        return writeln!(out, "Displacements are measured from the middle of the motion.");
    }
    let Some(machine) = machine.filter(|_| given.is_shifted()) else { return Ok(()) };
    let (mean, unit) = (digits(machine.scales.mean_displacement), given.system.length());
    writeln!(out, "Displacements are measured from the mean displacement of {mean} {unit}.")
}
