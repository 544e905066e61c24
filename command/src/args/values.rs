//! Values whose unit was typed as a word of its own.

use crate::failure::Outcome;
use std::ffi::OsString;
use stickslip::inputs::units::Reader;

/// Fails at an option whose number is followed by a unit, as in `--force 30 N`.
pub(super) fn check(words: &[OsString]) -> Outcome {
    for three in words.windows(3) {
        if let [Some(option), Some(number), Some(unit)] = [0, 1, 2].map(|i| three.get(i)?.to_str())
            && option.starts_with("--")
            && number.parse::<f64>().is_ok()
            && Reader::is_unit(unit)
        {
            return Err(format!("{option} {number} {unit}: must be one word, {option} {number}{unit}").into());
        }
    }
    Ok(())
}
