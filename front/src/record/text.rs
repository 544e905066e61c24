//! Numbers, words and units in the text of a file.

use crate::inputs::units::Reader;
use std::str::FromStr;
use stickslip::Float;

/// A finite number, as Fortran writes it, too: `.5`, `5.`, `+1.0`, `-.12D-02`.
pub(super) fn number<F: Float + FromStr>(text: &str) -> Option<F> {
    let text = text.strip_prefix('+').unwrap_or(text);
    // Neither “nan” nor “infinity” is a sample.
    if !text.trim_start_matches('-').starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    let read = |text: &str| text.parse().ok().filter(|value: &F| value.is_finite());
    if text.contains(['d', 'D']) { read(&text.replace(['d', 'D'], "E")) } else { read(text) }
}

/// The parts of a word in which numbers touch each other, as in `-.1234567E-02-.2345678E-02`: a sign after a digit or
/// a point begins a number.
pub(super) fn parts(word: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(word);
    std::iter::from_fn(move || {
        let word = rest.take().filter(|word| !word.is_empty())?;
        let after = word.as_bytes().iter().zip(word.as_bytes().iter().skip(1)).position(|(before, at)| {
            matches!(at, b'+' | b'-') && (before.is_ascii_digit() || *before == b'.')
        });
        let (part, left) =
            after.and_then(|place| word.split_at_checked(place.saturating_add(1))).unwrap_or((word, ""));
        rest = Some(left);
        Some(part)
    })
}

/// What is found in a line.
pub(super) enum Step<'a> {
    /// A part that should be a number.
    Number(&'a str),
    /// The parts before this one are void: the line is read once more.
    Again,
}

/// Acts on the numbers of a line, separated by blanks and commas or touching each other; `act` returns whether a part is a
/// number. If one of them is none and the layout has fields of a known width, they are those of the fields. Returns the
/// part that is no number.
pub(super) fn each(
    text: &str,
    width: Option<usize>,
    act: &mut dyn FnMut(Step<'_>) -> Result<bool, String>,
) -> Result<Option<String>, String> {
    let words = text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
    let mut wrong = None;
    for part in words.flat_map(parts) {
        if !act(Step::Number(part))? {
            wrong = Some(part.to_owned());
            break;
        }
    }
    let fields = width.filter(|_| text.is_ascii()).map(|width| text.as_bytes().chunks(width.max(1)));
    let (Some(wrong), Some(fields)) = (&wrong, fields) else { return Ok(wrong) };
    act(Step::Again)?;
    for field in fields {
        let field = std::str::from_utf8(field).unwrap_or_default().trim();
        if !field.is_empty() && !act(Step::Number(field))? {
            return Ok(Some(wrong.clone()));
        }
    }
    Ok(None)
}

/// The numbers of a line of a header.
pub(super) fn numbers(text: &str, width: Option<usize>) -> Result<Vec<String>, String> {
    // A longer line is none of a header, and has samples.
    if text.len() > 1 << 14 {
        return Err("a long line".to_owned());
    }
    let mut all = Vec::new();
    let wrong = each(text, width, &mut |step| {
        match step {
            Step::Number(part) if number::<f64>(part).is_some() => all.push(part.to_owned()),
            Step::Number(_) => return Ok(false),
            Step::Again => all.clear(),
        }
        Ok(true)
    })?;
    wrong.map_or(Ok(all), Err)
}

/// The width of the fields of a Fortran format, such as 10 in `(8F10.4)`.
pub(super) fn width(format: &str) -> Option<usize> {
    let after = format.trim_start_matches(|c: char| !c.is_ascii_digit());
    let after = after.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = after.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    digits.get(..end)?.parse().ok().filter(|width| (1..=64).contains(width))
}

/// The first word of a text.
pub(super) fn word(text: &str) -> &str {
    text.split_whitespace().next().unwrap_or_default()
}

/// A positive number of samples.
pub(super) fn count(text: &str) -> Option<usize> {
    let value = number::<f64>(text)?;
    (1.0..1e9).contains(&value).then_some(value.round() as usize)
}

/// Whether a line begins with a number.
pub(super) fn begins_with_number(text: &str) -> bool {
    let first = text.split(|c: char| c.is_whitespace() || c == ',').find(|word| !word.is_empty());
    first.and_then(|word| parts(word).next()).is_some_and(|part| number::<f64>(part).is_some())
}

/// The text after a word, without the signs between them.
pub(super) fn after<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let place = text.to_ascii_uppercase().find(&word.to_ascii_uppercase())?;
    let rest = text.get(place.checked_add(word.len())?..)?;
    Some(rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '=' | ':')))
}

/// The value of a header line such as `Sampling Freq(Hz) 100Hz` or `NDATA: 400`.
pub(super) fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    Some(text.strip_prefix(key)?.trim_start_matches(|c: char| c.is_whitespace() || c == ':').trim_end())
}

/// A unit of a header in the spelling of the table of units: `G` is `g`, `cm/sec2` is `cm/s^2`.
pub(super) fn unit(stated: &str) -> String {
    let stated = stated.trim().trim_end_matches(['.', ',', ';', ':']).replace("**", "^");
    let inner = stated.strip_prefix(['(', '[']).and_then(|text| text.strip_suffix([')', ']']));
    let stated = inner.unwrap_or(&stated).trim().to_owned();
    if Reader::is_unit(&stated) {
        return stated;
    }
    // “m*s^-2” and “m·s⁻²” are m/s^2.
    let small = stated.to_lowercase().replace(' ', "");
    let per_square = ["s^-2", "s⁻²", "s^(-2)", "s-2"].into_iter().find_map(|end| small.strip_suffix(end));
    let small = match per_square {
        Some(length) => format!("{}/s^2", length.trim_end_matches(['*', '·', '⋅', '.'])),
        None => small,
    };
    let known = match small.as_str() {
        "gals" => "gal",
        "g's" | "gs" | "gravity" => "g",
        "sec." | "second" | "seconds" => "s",
        "inch/sec/sec" | "in/sec/sec" => "in/s^2",
        other => other,
    };
    if Reader::is_unit(known) { known.to_owned() } else { stated }
}

/// A unit as it is shown: `cm/s²` for `cm/sec2`, `cm/s/s` and `gal`.
pub(super) fn shown(unit: &str) -> String {
    let plain = unit.replace("sec", "s").replace("^2", "²").replace("s/s", "s²").replace("s2", "s²");
    if plain.eq_ignore_ascii_case("gal") { "cm/s²".to_owned() } else { plain }
}

#[cfg(test)]
mod tests {
    use super::{number, numbers, parts, shown, unit, width};

    #[test]
    fn the_width_of_a_format() {
        for (format, found) in
            [("(8F10.4)", Some(10)), ("(1E15.6)", Some(15)), ("(10I8)", Some(8)), ("()", None)]
        {
            assert_eq!(width(format), found, "{format}");
        }
    }

    #[test]
    fn numbers_that_touch_are_told_apart() {
        let split = |text| parts(text).collect::<Vec<_>>();
        assert_eq!(split("-.1234567E-02-.2345678E-02"), ["-.1234567E-02", "-.2345678E-02"]);
        assert_eq!(split("1.5+2.5-3"), ["1.5", "+2.5", "-3"]);
        assert_eq!(split("1e-5"), ["1e-5"]);
        assert_eq!(split(""), [""; 0]);
        numbers(" 1234.567 234.5678-234.5671234.567", Some(8)).unwrap_err();
        let all = numbers("1234.567 234.567-234.5671234.567", Some(8)).unwrap();
        assert_eq!(all, ["1234.567", "234.567", "-234.567", "1234.567"]);
        assert_eq!(numbers("1.0 x", None), Err("x".to_owned()));
        let all = numbers("1.5D-02,+.5,", None).unwrap();
        assert_eq!(all.iter().map(|text| number::<f64>(text)).collect::<Vec<_>>(), [Some(0.015), Some(0.5)]);
        for wrong in ["NaN", "inf", "1e999", "*****", "0x10", "-", "1.2.3"] {
            numbers(wrong, None).unwrap_err();
        }
    }

    #[test]
    fn units_of_headers_are_those_of_the_table() {
        for (stated, spelt, seen) in [
            ("G.", "g", "g"),
            ("GAL", "gal", "cm/s²"),
            ("cm/sec2", "cm/sec2", "cm/s²"),
            ("CM/SEC/SEC", "cm/sec/sec", "cm/s²"),
            ("m/s**2", "m/s^2", "m/s²"),
            ("(m/s/s)", "m/s/s", "m/s²"),
            ("mm/s²", "mm/s²", "mm/s²"),
            ("m*s^-2", "m/s^2", "m/s²"),
            ("[m·s⁻²]", "m/s^2", "m/s²"),
            ("cm s-2", "cm/s^2", "cm/s²"),
            ("in/sec^2", "in/sec^2", "in/s²"),
            ("IN/S^2", "in/s^2", "in/s²"),
            ("counts", "counts", "counts"),
        ] {
            assert_eq!((unit(stated).as_str(), shown(&unit(stated)).as_str()), (spelt, seen), "{stated}");
        }
    }
}
