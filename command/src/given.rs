//! The typed inputs of a machine, read by the rules of the library.

use crate::bits::Value;
use crate::failure::Failure;
use crate::progress;
use stickslip::inputs::units::Reader;
use stickslip::inputs::{Given, Input, Naming};

/// The typed inputs, in the system of the reader.
pub(crate) fn read<F: Value>(typed: &[(Input, String)], reader: &Reader) -> Result<Given<F>, Failure> {
    let mut given = Given::empty(reader, Naming::Option);
    for (input, text) in typed {
        let value = given.read(*input, text, reader)?;
        note_percentage(*input, text, value);
    }
    Ok(given)
}

/// The failure, preceded by all typed inputs, if there are any.
pub(crate) fn behind_all<F: Value>(given: &Given<F>, failure: Failure) -> Failure {
    match given.all_typed() {
        inputs if inputs.is_empty() => failure,
        inputs => failure.about(&inputs),
    }
}

/// A note where a damping ratio without % is so large that a percentage was probably meant.
pub(crate) fn note_percentage<F: Value>(input: Input, text: &str, value: F) {
    if input == Input::DampingRatio && value >= F::int(1) && !text.contains('%') {
        let (option, percent) = (input.option(), crate::bits::digits(F::int(100) * value));
        progress::note(&format!(
            "{option} {text} is {percent} % of critical damping. A damping ratio of {text} percent is {option} {text}%"
        ));
    }
}
