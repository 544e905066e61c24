//! `--enclose` for ratios: the closed forms, each output as certain digits, then ±, and a motion that is proved to exist.

use crate::args::{OutputArgs, Typed};
use crate::failure::{Failure, Outcome};
use crate::{output, style};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::enclosed::{self, Enclosure, Known, Regime, Response, Steady, Unproved};
use stickslip::{Error, Output, Quantity};
use stickslip_front::inputs::Input;

/// The default number of bits of an enclosure.
pub(crate) const BITS: u32 = 64;

/// The typed ratios, and the options of the answer.
pub(super) struct TypedRatios<'a> {
    typed: Vec<(Input, &'a str)>,
    pub(super) output: &'a OutputArgs,
    pub(super) bits: u32,
}

impl<'a> TypedRatios<'a> {
    pub(super) fn of<const PARTS: u8>(machine: &'a Typed<PARTS>, output: &'a OutputArgs) -> Self {
        let ratios = [Input::Omega, Input::Alpha, Input::DampingRatio, Input::StaticFrictionRatio];
        let typed = ratios.into_iter().filter_map(|input| Some((input, machine.text(input)?))).collect();
        Self { typed, output, bits: output.bits.unwrap_or(BITS) }
    }

    pub(super) fn text(&self, input: Input) -> Option<&'a str> {
        self.typed.iter().find(|(own, _)| *own == input).map(|(_, text)| *text)
    }

    /// Whether a ratio is an interval.
    fn has_interval(&self) -> bool {
        self.typed.iter().any(|(_, text)| text.contains(".."))
    }

    /// A ratio exactly as written; without one ζ is 0 and η is 1.
    pub(super) fn known(&self, input: Input) -> Result<Known, Failure> {
        let option = input.option();
        let otherwise = [(Input::DampingRatio, "0"), (Input::StaticFrictionRatio, "1")];
        let otherwise = otherwise.into_iter().find(|(own, _)| *own == input).map(|(_, text)| text);
        let missing = || Failure::Input(format!("{option} is missing"));
        let text = self.text(input).or(otherwise).ok_or_else(missing)?;
        text.parse().map_err(|e| Failure::Input(format!("{option} {text}: {e}")))
    }

    /// The failure, which names its cause: the typed ratios, or the bits.
    pub(super) fn fault(&self, error: &Error) -> Failure {
        if error.quantity() == Some(Quantity::Precision) {
            return Failure::Input(format!("--bits {}: {error}", self.bits));
        }
        let options = self.typed.iter().map(|(input, text)| format!("{} {text}", input.option()));
        Failure::Input(format!("{}: {error}", options.collect::<Vec<_>>().join(" ")))
    }

    /// The ratios as keys of JSON.
    pub(super) fn serialize<M: SerializeMap>(&self, map: &mut M) -> Result<(), M::Error> {
        self.typed.iter().try_for_each(|(input, text)| map.serialize_entry(&input.column(), text))
    }
}

/// The typed ratios and the answer.
struct EnclosedAnswer<'a> {
    typed: TypedRatios<'a>,
    found: Response,
    outputs: &'static [Output],
    has_regime: bool,
}

impl EnclosedAnswer<'_> {
    /// The certain regime as a sentence.
    fn verdict(&self) -> String {
        let bits = self.found.bits;
        match self.found.regime {
            Some(Regime::Stuck) => "Stuck: α ≤ 1, the body ends at rest for good. This is certain.".to_owned(),
            Some(Regime::BelowBorder) => {
                "Below the sticking threshold: no cycle of two reversals goes without a stop. This is certain.".to_owned()
            }
            Some(Regime::NonSticking) => "Non-sticking: the body never stops. This is certain.".to_owned(),
            Some(Regime::Unbounded) => {
                "Unbounded: the displacement grows in every cycle. This is certain.".to_owned()
            }
            Some(Regime::DependsOnStart) => {
                "Depends on the start: a motion without a stop exists and attracts its neighbourhood. This is \
                 certain. Other starts may lead to other motions."
                    .to_owned()
            }
            Some(other) => other.name().to_owned(),
            None if self.typed.has_interval() => {
                "Undecided: these intervals hold both sides of a threshold, or come too close to one.".to_owned()
            }
            None => format!("Undecided at {bits} bits: α is too close to a threshold."),
        }
    }

    /// Whether a motion without a stop certainly exists, or certainly does not. Motions of six reversals below
    /// the border are not enclosed.
    fn has_motion_without_stop(&self) -> Option<bool> {
        let regime = self.found.regime?;
        let exists = matches!(regime, Regime::NonSticking | Regime::Unbounded | Regime::DependsOnStart);
        (exists || regime == Regime::Stuck).then_some(exists)
    }
}

/// `response --enclose`.
pub(super) fn response(typed: TypedRatios<'_>, out: &mut impl Write) -> Outcome {
    let known = |input| typed.known(input);
    let [omega, alpha] = [known(Input::Omega)?, known(Input::Alpha)?];
    let [zeta, eta] = [known(Input::DampingRatio)?, known(Input::StaticFrictionRatio)?];
    let found = enclosed::KnownRatios::new(&omega)
        .with_force_ratio(&alpha)
        .with_damping_ratio(&zeta)
        .with_static_friction_ratio(&eta)
        .response(typed.bits)
        .map_err(|e| typed.fault(&e))?;
    EnclosedAnswer { typed, found, outputs: &Output::ALL, has_regime: true }.write(out)
}

/// `border --enclose`.
pub(super) fn border(typed: TypedRatios<'_>, out: &mut impl Write) -> Outcome {
    let known = |input| typed.known(input);
    let [omega, zeta] = [known(Input::Omega)?, known(Input::DampingRatio)?];
    let eta = known(Input::StaticFrictionRatio)?;
    let found = enclosed::KnownRatios::new(&omega)
        .with_damping_ratio(&zeta)
        .with_static_friction_ratio(&eta)
        .response(typed.bits)
        .map_err(|e| typed.fault(&e))?;
    let outputs = &[
        Output::MinForceRatio,
        Output::MinForceRatioTurningPoint,
        Output::LeastDisplacement,
        Output::BorderPhase,
        Output::BestForceRatio,
        Output::BestLoopSize,
    ];
    EnclosedAnswer { typed, found, outputs, has_regime: false }.write(out)
}

impl EnclosedAnswer<'_> {
    fn write(&self, out: &mut impl Write) -> Outcome {
        if self.typed.output.is_json()? { output::json(self, out) } else { self.text(out) }
    }

    fn text(&self, out: &mut impl Write) -> Outcome {
        let bits = self.found.bits;
        if self.has_regime {
            writeln!(out, "{}", style::verdict(&self.verdict()))?;
            let is_higher = |eta: &str| eta.parse() != Ok(1.0);
            if self.typed.text(Input::StaticFrictionRatio).is_some_and(is_higher)
                && self.found.regime != Some(Regime::Stuck)
            {
                let rest = match self.found.moves_from_rest {
                    Some(true) => "A body at rest is released wherever it is.",
                    Some(false) => "A body at rest at x = 0 stays at rest.",
                    None => "Whether a body at rest is released is undecided.",
                };
                writeln!(out, "{rest}")?;
            }
            writeln!(out)?;
        }
        for &output in self.outputs {
            if let Some(value) = self.found.get(output) {
                let unit = match output.definition().measure.unit() {
                    "1" => String::new(),
                    unit => format!(" {unit}"),
                };
                writeln!(out, "  {:<31}{value}{unit}", output.name())?;
            }
        }
        if self.outputs.iter().all(|&output| self.found.get(output).is_none()) {
            return Ok(writeln!(out, "No output has a finite enclosure at {bits} bits.")?);
        }
        Ok(writeln!(out, "\nEach value lies within ± of the number printed, computed at {bits} bits.")?)
    }
}

impl Serialize for EnclosedAnswer<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        self.typed.serialize(&mut map)?;
        if self.has_regime {
            map.serialize_entry("regime", &self.found.regime.map(Regime::name))?;
            if self.typed.text(Input::StaticFrictionRatio).is_some() {
                map.serialize_entry("motion_without_stop", &self.has_motion_without_stop())?;
                map.serialize_entry("moves_from_rest", &self.found.moves_from_rest)?;
            }
        }
        for output in self.outputs {
            map.serialize_entry(output.name(), &self.found.get(*output))?;
        }
        map.serialize_entry("bits", &self.found.bits)?;
        map.end()
    }
}

/// The typed ratios and the motion, or the reason why it is not proved.
struct EnclosedMotionAnswer<'a> {
    typed: TypedRatios<'a>,
    found: Result<Steady, Unproved>,
}

pub(super) fn steady(typed: TypedRatios<'_>, out: &mut impl Write) -> Outcome {
    let known = |input| typed.known(input);
    let [omega, alpha] = [known(Input::Omega)?, known(Input::Alpha)?];
    let [zeta, eta] = [known(Input::DampingRatio)?, known(Input::StaticFrictionRatio)?];
    let found = enclosed::KnownRatios::new(&omega)
        .with_force_ratio(&alpha)
        .with_damping_ratio(&zeta)
        .with_static_friction_ratio(&eta)
        .steady(typed.bits)
        .map_err(|e| typed.fault(&e))?;
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
