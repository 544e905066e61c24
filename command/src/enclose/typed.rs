//! The ratios exactly as typed, and what an answer to them is made of.

use crate::args::{OutputArgs, Typed};
use crate::failure::Failure;
use serde::ser::SerializeMap;
use stickslip::enclosed::Known;
use stickslip::inputs::Input;
use stickslip::{Error, Quantity};

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

    /// A ratio exactly as written; without one ζ is 0 and η is 1.
    pub(super) fn known(&self, input: Input) -> Result<Known, Failure> {
        let option = input.option();
        let otherwise = match input {
            Input::DampingRatio => Some("0"),
            Input::StaticFrictionRatio => Some("1"),
            _ => None,
        };
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
