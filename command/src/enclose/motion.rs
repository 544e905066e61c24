//! `steady --enclose`: a motion that is proved to exist.

use super::typed::TypedRatios;
use crate::failure::Outcome;
use crate::output;
use crate::style;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::enclosed::{self, Enclosure, Steady, Unproved};
use stickslip::inputs::Input;

/// The typed ratios and the motion, or the reason why it is not proved.
struct EnclosedMotionAnswer<'a> {
    typed: TypedRatios<'a>,
    found: Result<Steady, Unproved>,
}

pub(super) fn steady(typed: TypedRatios<'_>, out: &mut impl Write) -> Outcome {
    let known = |input| typed.known(input);
    let [omega, alpha] = [known(Input::Omega)?, known(Input::Alpha)?];
    let [zeta, eta] = [known(Input::DampingRatio)?, known(Input::StaticFrictionRatio)?];
    let found = enclosed::steady(&omega, &alpha, &zeta, &eta, typed.bits).map_err(|e| typed.fault(&e))?;
    let answer = EnclosedMotionAnswer { typed, found };
    if answer.typed.output.is_json()? { output::json(&answer, out) } else { answer.text(out) }
}

impl EnclosedMotionAnswer<'_> {
    fn text(&self, out: &mut impl Write) -> Outcome {
        let found = match &self.found {
            Ok(found) => found,
            Err(why) => return Ok(writeln!(out, "{}", style::verdict(&format!("Not proved: {why}.")))?),
        };
        let stops = match found.sticks_per_cycle {
            0 => "without a stop".to_owned(),
            1 => "with one stop a cycle".to_owned(),
            n => format!("with {n} stops a cycle"),
        };
        writeln!(out, "{}\n", style::verdict(&format!("Proved: a periodic motion {stops} exists.")))?;
        if found.turns_per_cycle > 1 {
            writeln!(out, "  turns_per_cycle       {}", found.turns_per_cycle)?;
        }
        writeln!(out, "  max_displacement      {} B", found.max_displacement)?;
        if !found.is_symmetric {
            writeln!(out, "  min_displacement      {} B", found.min_displacement)?;
        }
        writeln!(out, "  max_velocity          {} B ω_d", found.max_velocity)?;
        if !found.is_symmetric {
            writeln!(out, "  min_velocity          {} B ω_d", found.min_velocity)?;
        }
        writeln!(out, "  stick_fraction        {}", found.stick_fraction)?;
        for (n, (re, im)) in (1..).zip(&found.multipliers) {
            writeln!(out, "  multiplier {n}          {re}, {im} i")?;
        }
        let begins = if found.sticks_per_cycle > 0 { "a release" } else { "a reversal" };
        writeln!(out, "  {begins:<22}at {} rad", found.start.0)?;
        writeln!(out, "                        at {} B", found.start.1)?;
        writeln!(
            out,
            "\nEach value lies within ± of the number printed. Within {:e} B of that place there is no other {}\n\
             motion of this kind. Computed at {} bits.",
            found.only_within.1.mid.to_f64(),
            if found.is_symmetric { "symmetric" } else { "periodic" },
            found.bits
        )?;
        Ok(())
    }
}

impl Serialize for EnclosedMotionAnswer<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        self.typed.serialize(&mut map)?;
        let found = self.found.as_ref().ok();
        let value = |of: fn(&Steady) -> &Enclosure| found.map(of);
        map.serialize_entry("proved", &found.is_some())?;
        map.serialize_entry("reason", &self.found.as_ref().err().map(Unproved::to_string))?;
        map.serialize_entry("symmetric", &found.map(|found| found.is_symmetric))?;
        map.serialize_entry("turns_per_cycle", &found.map(|found| found.turns_per_cycle))?;
        map.serialize_entry("max_displacement", &value(|found| &found.max_displacement))?;
        map.serialize_entry("min_displacement", &value(|found| &found.min_displacement))?;
        map.serialize_entry("max_velocity", &value(|found| &found.max_velocity))?;
        map.serialize_entry("min_velocity", &value(|found| &found.min_velocity))?;
        map.serialize_entry("sticks_per_cycle", &found.map(|found| found.sticks_per_cycle))?;
        map.serialize_entry("velocity_zeros_per_cycle", &found.map(|found| found.velocity_zeros_per_cycle))?;
        map.serialize_entry("stick_fraction", &value(|found| &found.stick_fraction))?;
        map.serialize_entry("multipliers", &found.map(|found| &found.multipliers))?;
        map.serialize_entry("start_phase", &value(|found| &found.start.0))?;
        map.serialize_entry("start_displacement", &value(|found| &found.start.1))?;
        map.serialize_entry("only_within", &found.map(|found| found.only_within.1.mid.to_f64()))?;
        map.serialize_entry("bits", &found.map(|found| found.bits))?;
        map.end()
    }
}
