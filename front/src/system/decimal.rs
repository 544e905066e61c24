//! Decimal texts that a double has.

/// The most digits that every double keeps.
const DIGITS: usize = 15;
/// The greatest power of ten that is a double, so that a number of so many digits is read with one rounding.
const POWER: i64 = 22;

/// Whether a number is the shortest text of the double that it is read to, or has the same value.
pub(super) fn is_of_a_double(text: &str) -> bool {
    let (number, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let digits = whole.trim_start_matches(['+', '-']).chars().chain(part.chars());
    let digits = digits.skip_while(|digit| *digit == '0').count();
    let power = exponent.parse::<i64>().ok().and_then(|power| power.checked_sub(part.len() as i64));
    digits == 0 || (digits <= DIGITS && power.is_some_and(|power| (-POWER..=POWER).contains(&power)))
}

#[cfg(test)]
mod tests {
    use super::is_of_a_double;

    /// Each number that stays one has the digits that were typed, and no others.
    #[test]
    fn numbers_that_stay_have_their_digits() {
        let kept = [
            "0.1",
            "-0.25",
            "1e22",
            "1e-22",
            "123456789012345",
            "0.000123456789012345",
            "0",
            "-0.0",
            "7.50",
            "1E3",
        ];
        for text in kept {
            assert!(is_of_a_double(text), "{text}");
            let read: serde_json::Number = serde_json::from_str(text).unwrap();
            let digits = |text: &str| {
                let x = text.parse::<f64>().unwrap();
                format!("{x:e}")
            };
            assert_eq!(digits(&read.to_string()), digits(text), "{text}");
        }
        for text in
            ["1e23", "1e-23", "1234567890123456", "0.1000000000000000", "1e-300", "1e99999999999999999999"]
        {
            assert!(!is_of_a_double(text), "{text}");
        }
    }
}
