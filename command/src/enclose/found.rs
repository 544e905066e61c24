//! `--enclose`: each output as certain digits, then ±.

use super::Others;
use crate::args::{Format, OutputArgs};
use crate::failure::{Failure, Outcome};
use crate::style;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::enclosed::{self, Known, Regime, Response};
use stickslip::{Error, Output, Quantity};

/// The default number of bits of an enclosure.
pub(crate) const BITS: u32 = 64;

/// The typed ratios and the answer.
struct EnclosedAnswer<'a> {
    typed: Vec<(&'static str, &'a str)>,
    found: Response,
    outputs: Vec<Output>,
    has_regime: bool,
}

impl EnclosedAnswer<'_> {
    fn has_static_friction(&self) -> bool {
        self.typed.iter().any(|(name, _)| *name == "static_friction_ratio")
    }

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

/// The damping ratio and the static friction ratio; zero and one by default.
pub(super) fn known_others((zeta, eta): Others<'_>) -> Result<(Known, Known), Failure> {
    let zeta = known("--damping-ratio", zeta.unwrap_or("0"))?;
    Ok((zeta, known("--static-friction-ratio", eta.unwrap_or("1"))?))
}

/// The damping ratio and the static friction ratio that were typed, as options or as keys of JSON.
pub(super) fn typed_others<'a>((zeta, eta): Others<'a>) -> impl Iterator<Item = (&'static str, &'a str)> {
    let zeta = zeta.map(|zeta| ("damping_ratio", zeta));
    zeta.into_iter().chain(eta.map(|eta| ("static_friction_ratio", eta)))
}

/// The options as typed, for messages.
pub(super) fn options(typed: &[(&'static str, &str)]) -> String {
    let option = |(name, text): &(&str, &str)| format!("--{} {text}", name.replace('_', "-"));
    typed.iter().map(option).collect::<Vec<_>>().join(" ")
}

/// `response --enclose`.
pub(crate) fn response(
    (omega, alpha): (&str, &str),
    others: Others<'_>,
    output: &OutputArgs,
    out: &mut impl Write,
) -> Outcome {
    let ((zeta, eta), bits) = (known_others(others)?, bits(output));
    let typed: Vec<_> =
        [("omega", omega), ("alpha", alpha)].into_iter().chain(typed_others(others)).collect();
    let found = enclosed::response(&known("--omega", omega)?, &known("--alpha", alpha)?, &zeta, &eta, bits);
    let found = found.map_err(|e| fault(&options(&typed), output, &e))?;
    EnclosedAnswer { typed, found, outputs: Output::ALL.to_vec(), has_regime: true }.write(output, out)
}

/// `border --enclose`.
pub(crate) fn border(omega: &str, others: Others<'_>, output: &OutputArgs, out: &mut impl Write) -> Outcome {
    let ((zeta, eta), bits) = (known_others(others)?, bits(output));
    let typed: Vec<_> = [("omega", omega)].into_iter().chain(typed_others(others)).collect();
    let found = enclosed::border(&known("--omega", omega)?, &zeta, &eta, bits);
    let found = found.map_err(|e| fault(&options(&typed), output, &e))?;
    let of_border = [
        Output::MinForceRatio,
        Output::TurningPointForceRatio,
        Output::LeastDisplacement,
        Output::TouchingPhase,
        Output::BestForceRatio,
        Output::BestLoopSize,
    ];
    EnclosedAnswer { typed, found, outputs: of_border.to_vec(), has_regime: false }.write(output, out)
}

pub(super) fn bits(output: &OutputArgs) -> u32 {
    output.bits.unwrap_or(BITS)
}

/// The failure, which names its cause: the typed ratios, or the bits.
pub(super) fn fault(ratios: &str, output: &OutputArgs, error: &Error) -> Failure {
    match error.quantity() {
        Some(Quantity::Precision) => Failure::Input(format!("--bits {}: {error}", bits(output))),
        _ => Failure::Input(format!("{ratios}: {error}")),
    }
}

/// The ratio exactly as written.
pub(super) fn known(option: &str, text: &str) -> Result<Known, Failure> {
    text.parse().map_err(|e| Failure::Input(format!("{option} {text}: {e}")))
}

impl EnclosedAnswer<'_> {
    fn write(&self, output: &OutputArgs, out: &mut impl Write) -> Outcome {
        match output.format.unwrap_or(Format::Text) {
            Format::Text => self.text(out),
            Format::Json => {
                serde_json::to_writer_pretty(&mut *out, self)?;
                Ok(out.write_all(b"\n")?)
            }
            Format::Jsonl | Format::Csv => Err(Failure::single_format()),
        }
    }

    fn text(&self, out: &mut impl Write) -> Outcome {
        let bits = self.found.bits;
        if self.has_regime {
            writeln!(out, "{}", style::verdict(&self.verdict()))?;
            let is_higher =
                |(name, text): &(&str, &str)| *name == "static_friction_ratio" && text.parse() != Ok(1.0);
            if self.typed.iter().any(is_higher) && self.found.regime != Some(Regime::Stuck) {
                let rest = match self.found.moves_from_rest {
                    Some(true) => "A body at rest is released wherever it is.",
                    Some(false) => "A body at rest at x = 0 stays at rest.",
                    None => "Whether a body at rest is released is undecided.",
                };
                writeln!(out, "{rest}")?;
            }
            writeln!(out)?;
        }
        for &output in &self.outputs {
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
        for (name, text) in &self.typed {
            map.serialize_entry(name, text)?;
        }
        if self.has_regime {
            map.serialize_entry("regime", &self.found.regime.map(Regime::name))?;
            if self.has_static_friction() {
                map.serialize_entry("motion_without_stop", &self.has_motion_without_stop())?;
                map.serialize_entry("moves_from_rest", &self.found.moves_from_rest)?;
            }
        }
        for output in &self.outputs {
            map.serialize_entry(output.name(), &self.found.get(*output))?;
        }
        map.serialize_entry("bits", &self.found.bits)?;
        map.end()
    }
}
