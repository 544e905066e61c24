//! The typed inputs of a machine, read by the rules of the library.

use crate::bits::Value;
use crate::failure::Failure;
use crate::progress;
use stickslip::inputs::units::{Kind, Reader, System, split};
use stickslip::inputs::{Given, Input, Naming};
use stickslip::{Drive, Oscillator};

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

/// An input as on a picture: `r_y = 5 kN`, or the quantity in words where it has no symbol.
pub(crate) fn in_symbols(input: Input, text: &str, system: &System) -> String {
    let is_word = |part: &&str| part.len() > 1 && part.chars().all(|c| c.is_ascii_lowercase());
    let symbol: Vec<&str> = input.symbol().split(' ').skip_while(is_word).collect();
    let value = match split(text) {
        ("", _) => text.to_owned(),
        (number, "") if input.kind() == Kind::Ratio => number.to_owned(),
        (number, "") => format!("{number} {}", system.name(input.kind())),
        (number, unit @ ("%" | "°")) => format!("{number}{unit}"),
        (number, unit) => format!("{number} {}", unit.replace('*', "·")),
    };
    if input == Input::Frequency && !value.ends_with("rad/s") {
        // ω_d is in rad/s only.
        format!("f = {value}")
    } else if symbol.is_empty() {
        format!("{} {value}", input.symbol())
    } else {
        format!("{} = {value}", symbol.join(" "))
    }
}

/// The typed inputs that are shown on a picture, in a line.
pub(crate) fn line(typed: &[(Input, String)], shown: impl Fn(Input) -> bool, system: &System) -> String {
    let shown = typed.iter().filter(|(input, _)| shown(*input));
    shown.map(|(input, text)| in_symbols(*input, text, system)).collect::<Vec<_>>().join(", ")
}

/// The name of a displacement, which in a shifted motion is measured from the mean.
pub(crate) fn displacement<F: Value>(given: &Given<F>) -> &'static str {
    if given.is_shifted() { "displacement from the mean" } else { "displacement" }
}

/// The shift of the motion, which is the same under any drive.
pub(crate) fn mean_displacement<F: Value>(given: &Given<F>, body: &Oscillator<F>) -> Result<F, Failure> {
    Drive::force(body.friction_bound(), body.natural_frequency())
        .and_then(|drive| given.with_mean_force(drive))
        .and_then(|drive| stickslip::Scales::new(body, &drive))
        .map(|scales| scales.mean_displacement)
        .map_err(|e| given.at_fault(&e).into())
}
