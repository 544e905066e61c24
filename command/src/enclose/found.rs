//! `--enclose`: each output as certain digits, then ±.

use super::typed::TypedRatios;
use crate::failure::Outcome;
use crate::output;
use crate::style;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::Output;
use stickslip::enclosed::{self, Regime, Response};
use stickslip::inputs::Input;

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
                "Below the border: no cycle of two reversals goes without a stop. This is certain.".to_owned()
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
            None => format!("Undecided at {bits} bits: α is too close to a border."),
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
    let found = enclosed::response(&omega, &alpha, &zeta, &eta, typed.bits).map_err(|e| typed.fault(&e))?;
    EnclosedAnswer { typed, found, outputs: &Output::ALL, has_regime: true }.write(out)
}

/// `border --enclose`.
pub(super) fn border(typed: TypedRatios<'_>, out: &mut impl Write) -> Outcome {
    let known = |input| typed.known(input);
    let [omega, zeta] = [known(Input::Omega)?, known(Input::DampingRatio)?];
    let eta = known(Input::StaticFrictionRatio)?;
    let found = enclosed::border(&omega, &zeta, &eta, typed.bits).map_err(|e| typed.fault(&e))?;
    let outputs = &[
        Output::MinForceRatio,
        Output::TurningPointForceRatio,
        Output::LeastDisplacement,
        Output::TouchingPhase,
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
