//! Values with units, such as `800kg`, `2Hz` or `12 kN/mm`.
//!
//! ```
//! use stickslip_front::inputs::units::{Kind, Reader};
//! let reader = Reader::new(None, "units");
//! let stiffness: f64 = reader.value("stiffness", "12 kN/mm", Kind::Stiffness)?;
//! assert_eq!(stiffness, 12e6);
//! let error = reader.value::<f64>("mass", "3 s", Kind::Mass).unwrap_err();
//! assert_eq!(error.to_string(), "mass 3 s: must be a mass (kg, g, t, lb), but “s” is a unit of time");
//! # Ok::<(), stickslip_front::inputs::units::InputError>(())
//! ```
//!
//! Every unit is a ratio of two integers times a power of π, in SI base units with the radian, so that a
//! conversion adds one or two roundings in any number type. The crate `uom` was tried: its factors are f64
//! constants, which would reduce a number of 1024 bits to 53, and its hertz and rad/s do not differ by 2π.

mod factor;
mod system;
mod table;

pub use factor::Factor;
pub use stickslip::internal::Kind;
pub use system::System;

use std::cell::RefCell;
use std::str::FromStr;
use stickslip::{Float, Number};
use table::Unit;

/// The error of an input: the argument, its text, and the condition that it violates.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct InputError(pub(crate) String);

impl From<InputError> for String {
    fn from(error: InputError) -> Self {
        error.0
    }
}

/// Reads values into one system of units.
///
/// Values with units are converted, and bare numbers are in that system. If no system was named, bare numbers
/// must not be mixed with units, because their system would be unclear. A bare frequency is in rad/s in any
/// system.
#[derive(Debug)]
pub struct Reader {
    system: System,
    named: bool,
    /// The option that names a system.
    option: &'static str,
    first_bare: RefCell<Option<String>>,
    first_with_unit: RefCell<Option<String>>,
}

impl Reader {
    /// A reader in a system that the user named, or in SI. `option` shows how to name one, such as `--units
    /// kN,m`.
    #[must_use]
    pub fn new(named: Option<&System>, option: &'static str) -> Self {
        Self {
            system: named.copied().unwrap_or_default(),
            named: named.is_some(),
            option,
            first_bare: RefCell::new(None),
            first_with_unit: RefCell::new(None),
        }
    }

    /// The system into which values are read.
    pub const fn system(&self) -> System {
        self.system
    }

    /// The value of the argument or column `name`, in the reader's system.
    ///
    /// # Errors
    /// Where the text is no number, its unit is unknown or of another kind, or bare numbers are mixed with
    /// units.
    pub fn value<F: Float + FromStr>(&self, name: &str, text: &str, kind: Kind) -> Result<F, InputError> {
        let (digits, unit) = split(text);
        if unit.is_empty() || digits.is_empty() || unit.starts_with(',') {
            let value: F = number_of(name, text, text)?;
            // 0 is 0 in every system, and what is not finite is refused for that.
            if value != F::int(0) && value.is_finite() {
                self.seen(name, text, kind, false)?;
            }
            return Ok(self.system.scale(kind).map_or(value, |factor| factor.times(value)));
        }
        let factor = self.factor(name, text, unit, kind)?;
        let value = number_of(name, text, digits)?;
        self.seen(name, text, kind, true)?;
        Ok(factor.times(value))
    }

    /// The factor for the values of a column, from the unit in its header, such as `frequency[Hz]`.
    ///
    /// # Errors
    /// As for [`Reader::value`].
    pub fn factor_of_column(&self, name: &str, unit: &str, kind: Kind) -> Result<Factor, InputError> {
        let factor = self.factor(name, &format!("[{unit}]"), unit, kind)?;
        self.seen(name, &format!("[{unit}]"), kind, true)?;
        Ok(factor)
    }

    /// Whether a text has a unit after its number.
    #[must_use]
    pub fn has_unit(text: &str) -> bool {
        let (digits, unit) = split(text);
        !digits.is_empty() && !unit.is_empty()
    }

    /// Whether any value had a unit.
    pub fn has_converted(&self) -> bool {
        self.first_with_unit.borrow().is_some()
    }

    fn factor(&self, name: &str, text: &str, unit: &str, kind: Kind) -> Result<Factor, InputError> {
        let read = table::parse(unit);
        let found = read.iter().find(|read| read.dimension == kind.dimension());
        match (found, read.first()) {
            (Some(unit), _) => Ok(unit.factor.over(self.system.factor(unit.dimension))),
            (None, other) => {
                let other = other.map(|Unit { dimension, .. }| Kind::of(*dimension));
                let is = match other {
                    None => "is not a known unit".to_owned(),
                    Some(None) => "is a unit of another quantity".to_owned(),
                    Some(Some(kind)) => format!("is a unit of {}", kind.name()),
                };
                Err(InputError(format!("{name} {text}: must be {}, but “{unit}” {is}", kind.expected())))
            }
        }
    }

    /// Whether a text is a unit, of whatever quantity.
    #[must_use]
    pub fn is_unit(text: &str) -> bool {
        !table::parse(text).is_empty()
    }

    fn seen(&self, name: &str, text: &str, kind: Kind, with_unit: bool) -> Result<(), InputError> {
        if kind.is_dimensionless() {
            return Ok(());
        }
        let (own, other) = if with_unit {
            (&self.first_with_unit, &self.first_bare)
        } else {
            (&self.first_bare, &self.first_with_unit)
        };
        own.borrow_mut().get_or_insert_with(|| format!("{name} {text}"));
        if self.named || other.borrow().is_none() {
            return Ok(());
        }
        let words = |cell: &RefCell<Option<String>>| cell.borrow().clone().unwrap_or_default();
        Err(InputError(format!(
            "{}: has no unit beside {}. Give every value a unit, or name the system of bare numbers by {}",
            words(&self.first_bare),
            words(&self.first_with_unit),
            self.option
        )))
    }
}

/// The number at the beginning of a text, and the rest of the text: its unit.
#[must_use]
pub fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let bytes = text.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let sign = |i: usize| usize::from(matches!(bytes.get(i), Some(b'+' | b'-')));
    let mut end = sign(0);
    while digit(end) || bytes.get(end) == Some(&b'.') {
        end += 1;
    }
    if end > sign(0) && matches!(bytes.get(end), Some(b'e' | b'E')) {
        let first = end + 1 + sign(end + 1);
        if digit(first) {
            end = (first..).find(|&i| !digit(i)).unwrap_or(first);
        }
    }
    if end == sign(0) {
        return ("", text);
    }
    let (digits, unit) = text.split_at(end);
    (digits, unit.trim())
}

/// A number without a unit.
///
/// # Errors
/// Where the text is no number, with a hint if it has a decimal comma.
pub fn number<F: FromStr>(name: &str, text: &str) -> Result<F, InputError> {
    number_of(name, text, text)
}

/// The number given by `digits`, a part of the text.
fn number_of<F: FromStr>(name: &str, text: &str, digits: &str) -> Result<F, InputError> {
    let digits = digits.trim();
    if digits.trim_start_matches(['+', '-']).eq_ignore_ascii_case("nan") {
        return Err(InputError(format!("{name} {text}: must be a finite number, and is NaN")));
    }
    digits.parse().map_err(|_| {
        if text.trim().is_empty() {
            return InputError(format!("{name}: must be a number, but is empty"));
        }
        let with_point = text.replacen(',', ".", 1);
        let has_decimal_comma = text.contains(',') && split(&with_point).0.parse::<F>().is_ok();
        if !has_decimal_comma {
            return InputError(format!("{name} {text}: must be a number"));
        }
        // A comma before three digits may be one of thousands or of decimals.
        let (before, after) = text.split_once(',').unwrap_or_default();
        let digits = after.chars().take_while(char::is_ascii_digit).count();
        let hint = if digits == 3 {
            let rest = after.get(digits..).unwrap_or_default();
            let after = after.get(..digits).unwrap_or_default();
            format!("; for thousands write {before}{after}{rest}, for decimals {before}.{after}{rest}")
        } else {
            ", with a decimal point in place of the comma".into()
        };
        InputError(format!("{name} {text}: must be a number{hint}"))
    })
}

/// The number at the beginning of a text times a factor, with the text's unit; `None` without a number.
#[must_use]
pub fn scaled(text: &str, factor: f64) -> Option<String> {
    let (digits, unit) = split(text);
    let value = digits.parse::<f64>().ok()? * factor;
    // Six digits are enough for a bound, which the caller has exactly.
    let rounded: f64 = format!("{value:.5e}").parse().ok()?;
    Some(format!("{} {unit}", Number::from(rounded)).trim_end().to_owned())
}

#[cfg(test)]
mod tests {
    use super::{Kind, Reader, split};
    #[cfg(feature = "mp")]
    use stickslip::Float;

    fn si(text: &str, kind: Kind) -> Result<f64, String> {
        Reader::new(None, "--units kN,m").value("--x", text, kind).map_err(|e| e.to_string())
    }

    #[test]
    fn a_number_ends_where_its_unit_begins() {
        for (text, parts) in [
            ("800kg", ("800", "kg")),
            ("-2.5e-3 mm", ("-2.5e-3", "mm")),
            ("1e3e", ("1e3", "e")),
            ("2.2", ("2.2", "")),
            (".15g", (".15", "g")),
            ("nan", ("", "nan")),
            ("3E+2lbf/in", ("3E+2", "lbf/in")),
        ] {
            assert_eq!(split(text), parts, "{text}");
        }
    }

    /// Literal values of the definitions: the international pound and inch, and standard gravity.
    #[test]
    fn units_are_what_they_are_defined_to_be() {
        use std::f64::consts::{PI, TAU};
        for (text, kind, value) in [
            ("800kg", Kind::Mass, 800.0),
            ("2t", Kind::Mass, 2000.0),
            ("3g", Kind::Mass, 0.003),
            ("1lb", Kind::Mass, 0.453_592_37),
            ("12kN", Kind::Force, 12e3),
            ("1lbf", Kind::Force, 4.448_221_615_260_5),
            ("1 kip", Kind::Force, 4_448.221_615_260_5),
            ("5mm", Kind::Length, 0.005),
            ("1in", Kind::Length, 0.0254),
            ("1ft", Kind::Length, 0.3048),
            ("7µm", Kind::Length, 7e-6),
            ("2Hz", Kind::Frequency, 2.0 * TAU),
            ("60rpm", Kind::Frequency, TAU),
            ("3rad/s", Kind::Frequency, 3.0),
            ("180deg/s", Kind::Frequency, PI),
            ("0.15g", Kind::Acceleration, 1.470_997_5),
            ("2m/s^2", Kind::Acceleration, 2.0),
            ("2 mm/s²", Kind::Acceleration, 0.002),
            ("4in/s2", Kind::Acceleration, 0.1016),
            ("150gal", Kind::Acceleration, 1.5),
            ("3kN/mm", Kind::Stiffness, 3e6),
            ("1 lbf/in", Kind::Stiffness, 175.126_835_246_476_4),
            ("2.2s", Kind::Time, 2.2),
            ("250ms", Kind::Time, 0.25),
            ("90°", Kind::Angle, PI / 2.0),
            ("5%", Kind::Ratio, 0.05),
            ("7J", Kind::Energy, 7.0),
            ("2N*s/m", Kind::Damping, 2.0),
            ("300Ns/m", Kind::Damping, 300.0),
            ("2 kNs/m", Kind::Damping, 2000.0),
            ("1.4hz", Kind::Frequency, 1.4 * TAU),
            ("84cpm", Kind::Frequency, 1.4 * TAU),
            ("3kNm", Kind::Energy, 3000.0),
            ("500kips", Kind::Force, 2_224_110.807_630_25),
            ("10lb", Kind::Force, 44.482_216_152_605),
            ("10lb", Kind::Mass, 4.535_923_7),
            ("1 lb/in", Kind::Stiffness, 175.126_835_246_476_4),
            ("2 kip/in", Kind::Stiffness, 350_253.670_492_952_8),
            ("1 lb*s/in", Kind::Damping, 175.126_835_246_476_4),
            ("3tf", Kind::Force, 29_419.95),
            ("16oz-in", Kind::Unbalance, 0.011_521_246_198),
            ("2N-m", Kind::Energy, 2.0),
        ] {
            let found = si(text, kind).unwrap();
            assert!((found - value).abs() <= 4.0 * f64::EPSILON * value, "{text}: {found} for {value}");
        }
    }

    #[test]
    fn a_wrong_unit_says_what_was_expected() {
        for (text, kind, parts) in [
            ("800N", Kind::Mass, ["“N” is a unit of force", "must be a mass (kg, g, t, lb)"]),
            ("2s", Kind::Frequency, ["“s” is a unit of time", "must be a frequency (Hz, rad/s, rpm, cpm)"]),
            ("2Hz", Kind::Ratio, ["“Hz” is a unit of frequency", "must be a plain number"]),
            ("3furlong", Kind::Length, ["“furlong” is not a known unit", "must be a length (m, mm, in)"]),
            ("3m/", Kind::Length, ["“m/” is not a known unit", "must be a length"]),
            ("1 5", Kind::Mass, ["“5” is not a known unit", "must be a mass"]),
            ("2m3", Kind::Length, ["“m3” is a unit of another quantity", "must be a length"]),
            ("1,5kN", Kind::Force, ["--x 1,5kN: must be a number", "decimal point in place of the comma"]),
            (
                "1,200 kN",
                Kind::Force,
                ["--x 1,200 kN: must be a number", "for thousands write 1200 kN, for decimals 1.200 kN"],
            ),
            (" ", Kind::Force, ["--x: must be a number", "but is empty"]),
        ] {
            let error = si(text, kind).unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{error}");
        }
    }

    #[test]
    fn bare_numbers_are_in_the_named_system_and_do_not_mix_without_one() {
        let reader = Reader::new(None, "--units kN,m");
        assert_eq!(reader.value::<f64>("--mass", "800kg", Kind::Mass).unwrap(), 800.0);
        let bare = Reader::new(None, "--units kN,m");
        assert_eq!(bare.value::<f64>("--mass", "800kg", Kind::Mass).unwrap(), 800.0);
        let error = bare.value::<f64>("--frequency", "2", Kind::Frequency).unwrap_err().to_string();
        assert!(error.starts_with("--frequency 2: has no unit beside --mass 800kg"), "{error}");
        assert_eq!(reader.value::<f64>("--omega", "2", Kind::Ratio).unwrap(), 2.0);
        let error = reader.value::<f64>("--force", "12", Kind::Force).unwrap_err().to_string();
        assert!(error.starts_with("--force 12: has no unit beside --mass 800kg"), "{error}");
        assert_eq!(reader.value::<f64>("--friction", "0", Kind::Force).unwrap(), 0.0);
        let error = reader.value::<f64>("--force", "nan", Kind::Force).unwrap_err().to_string();
        assert_eq!(error, "--force nan: must be a finite number, and is NaN");
        let named = Reader::new(Some(&"kN,mm".parse().unwrap()), "--units kN,m");
        assert_eq!(named.value::<f64>("--force", "12", Kind::Force).unwrap(), 12.0);
        assert_eq!(named.value::<f64>("--force", "12N", Kind::Force).unwrap(), 0.012);
        assert_eq!(named.value::<f64>("--stiffness", "3kN/mm", Kind::Stiffness).unwrap(), 3.0);
        // 1 kN s²/mm = 10⁶ kg
        assert_eq!(named.value::<f64>("--mass", "800kg", Kind::Mass).unwrap(), 8e-4);
    }

    #[test]
    fn a_text_is_scaled_in_its_own_unit() {
        let scaled = |text: &str, factor| super::scaled(text, factor);
        assert_eq!(scaled("1mm", 5.5).as_deref(), Some("5.5 mm"));
        assert_eq!(scaled("-2", 1.0 / 3.0).as_deref(), Some("-0.666667"));
        assert_eq!(scaled("x", 2.0), None);
    }

    #[cfg(feature = "mp")]
    #[test]
    fn a_unit_costs_no_digits_of_a_wide_number() {
        type Wide = stickslip::float::Mp<4>;
        let read =
            |text: &str, kind| Reader::new(None, "--units kN,m").value::<Wide>("--x", text, kind).unwrap();
        let (g, pound) = (read("0.15g", Kind::Acceleration), read("3lb", Kind::Mass));
        let close = |a: Wide, b: Wide| Float::to_f64((a - b) / b).abs() < 1e-75;
        assert!(close(g, "1.4709975".parse().unwrap()), "{g}");
        assert!(close(pound, "1.36077711".parse().unwrap()), "{pound}");
    }
}
