//! Decimal text is read at full precision. It is written with just the digits that distinguish a number from
//! its neighbours, or rounded once to the requested number of digits.

use super::Mp;
use core::fmt::{self, Debug, Display, Formatter, LowerExp};
use core::str::FromStr;
use rug::float::Round;
use rug::ops::Pow;
use rug::{Float, Rational};
use std::cmp::Ordering;

/// The error for text that is not a number.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` must be a number: decimal digits, with at most one point and an exponent after `e`")]
#[non_exhaustive]
pub struct ParseError {
    /// The rejected text.
    pub text: String,
}

impl<const LIMBS: usize> Mp<LIMBS> {
    /// The number nearest to the text in a radix of 2 to 36, digits and exponent in that radix.
    ///
    /// # Errors
    /// [`ParseError`] with the text, where it is no number or the radix is outside this range.
    pub(crate) fn parse_radix(text: &str, radix: u32) -> Result<Self, ParseError> {
        let error = || ParseError { text: text.to_owned() };
        let radix = i32::try_from(radix).ok().filter(|r| (2..=36).contains(r)).ok_or_else(error)?;
        let parsed = Float::parse_radix(text, radix).map_err(|_| error())?;
        Ok(Self::from_rug(&Float::with_val(Self::bits_now(), parsed)))
    }
}

/// Reads the nearest number from decimal text with or without a sign, a point and an exponent (`1.5`,
/// `-2e-3`), or from `inf`, `infinity` or `nan`. The grammar is that of `f64`: no white space, no
/// underscores, no other exponent mark.
impl<const LIMBS: usize> FromStr for Mp<LIMBS> {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        // Text that `f64` accepts is a number; the value of the `f64` matters only if the text has no digits.
        let double: f64 = text.parse().map_err(|_| ParseError { text: text.to_owned() })?;
        if text.bytes().any(|byte| byte.is_ascii_digit()) {
            return Self::parse_radix(text, 10);
        }
        Ok(<Self as crate::float::Float>::from_f64(double))
    }
}

/// `0.d₁d₂d₃… · 10^point`, d₁ ≠ 0.
struct Decimal {
    digits: String,
    point: i64,
}

impl Decimal {
    /// `x`, finite and not zero, rounded once to `count` ≥ 1 digits.
    fn rounded(x: &Float, count: usize) -> Self {
        let (_, digits, point) = x.to_sign_string_exp(10, Some(count));
        Self { digits, point: point.map_or(0, i64::from) }
    }

    /// `x`, finite and not zero, with the fewest digits that read back as the same number.
    ///
    /// A number read from at most `(bits − 1) log₁₀ 2` digits gives those digits back; three more always
    /// suffice.
    fn whole(x: &Float) -> Self {
        // A lower bound of log₁₀ 2, so that the search begins low enough.
        let least = ((u64::from(x.prec()) - 1) * 30_102 / 100_000).max(1) as usize;
        let same = |decimal: &Self| {
            let text = format!("0.{}e{}", decimal.digits, decimal.point);
            Float::parse(text).is_ok_and(|parsed| Float::with_val(x.prec(), parsed) == *x.as_abs())
        };
        let mut decimal = (least..least + 4)
            .map(|count| Self::rounded(x, count))
            .find(same)
            // If none suffices, use the number of digits that MPFR considers enough.
            .unwrap_or_else(|| Self::rounded(x, 0));
        decimal.digits.truncate(decimal.digits.trim_end_matches('0').len());
        decimal
    }

    /// `x` rounded once to `places` after the point, as the digits of an integer; empty for zero.
    fn to_places(x: &Float, places: usize) -> String {
        // Truncation gives the number's own exponent, not that of a neighbouring power of ten.
        let (_, _, point) = x.to_sign_string_exp_round(10, Some(1), Round::Zero);
        let point = point.map_or(0, i64::from);
        // A number below one unit of the last place rounds to one unit if it is above half of it, otherwise
        // to zero.
        let count = point.saturating_add(i64::try_from(places).unwrap_or(i64::MAX));
        if count > 0 {
            let count = usize::try_from(count).unwrap_or(usize::MAX);
            let rounded = Self::rounded(x, count);
            // Rounding 9.99… to 10.0… adds a digit, which is a zero.
            return if rounded.point > point { rounded.digits + "0" } else { rounded.digits };
        }
        let half_unit = || Rational::from(10).pow(-i32::try_from(places).unwrap_or(i32::MAX)) / 2u32;
        let above = count == 0 && x.clone().abs().partial_cmp(&half_unit()) == Some(Ordering::Greater);
        if above { "1".to_owned() } else { String::new() }
    }

    /// The number without an exponent.
    fn plain(&self) -> String {
        let Self { digits, point } = self;
        match usize::try_from(*point) {
            Err(_) | Ok(0) => format!("0.{}{digits}", "0".repeat(point.unsigned_abs() as usize)),
            Ok(whole) if whole >= digits.len() => format!("{digits}{}", "0".repeat(whole - digits.len())),
            Ok(whole) => {
                let (integer, fraction) = digits.split_at(whole);
                format!("{integer}.{fraction}")
            }
        }
    }

    /// The number with one digit before the point, and an exponent.
    fn scientific(&self) -> String {
        let (first, others) = self.digits.split_at(1.min(self.digits.len()));
        let point = if others.is_empty() { "" } else { "." };
        format!("{first}{point}{others}e{}", self.point.saturating_sub(1))
    }
}

/// The digits of an integer, with the decimal point before the last `places` of them.
fn with_point(digits: &str, places: usize) -> String {
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (integer, fraction) = padded.split_at(padded.len() - places);
    if places == 0 { integer.to_owned() } else { format!("{integer}.{fraction}") }
}

/// Writes the text of `|x|` with the sign of x and the padding of the formatter.
fn write<const LIMBS: usize>(x: Mp<LIMBS>, text: &str, f: &mut Formatter<'_>) -> fmt::Result {
    f.pad_integral(!x.is_sign_negative(), "", text)
}

/// The text of an infinity or NaN; `None` for other numbers.
fn special<const LIMBS: usize>(x: Mp<LIMBS>) -> Option<&'static str> {
    if x.is_nan() {
        Some("NaN")
    } else if x.is_finite() {
        None
    } else {
        Some("inf")
    }
}

/// Writes the fewest digits that read back as the same number, without an exponent between 1e-7 and 1e21.
/// With a precision (`{:.40}`), it writes that many digits after the point, rounded once.
impl<const LIMBS: usize> Display for Mp<LIMBS> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(text) = special(*self) {
            return write(*self, text, f);
        }
        let text = match (f.precision(), self.is_zero()) {
            (None, true) => "0".to_owned(),
            (Some(places), true) => with_point("", places),
            (Some(places), false) => with_point(&Decimal::to_places(&self.to_rug(), places), places),
            (None, false) => {
                let decimal = Decimal::whole(&self.to_rug());
                if (-6..=21).contains(&decimal.point) { decimal.plain() } else { decimal.scientific() }
            }
        };
        write(*self, &text, f)
    }
}

/// Writes an exponent with the same digits, or with the requested number of digits after the point, rounded
/// once.
impl<const LIMBS: usize> LowerExp for Mp<LIMBS> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(text) = special(*self) {
            return write(*self, text, f);
        }
        let count = f.precision().map(|places| places.saturating_add(1));
        let decimal = if self.is_zero() {
            Decimal { digits: "0".repeat(count.unwrap_or(1)), point: 1 }
        } else {
            count.map_or_else(
                || Decimal::whole(&self.to_rug()),
                |count| Decimal::rounded(&self.to_rug(), count),
            )
        };
        write(*self, &decimal.scientific(), f)
    }
}

/// Writes the same text as [`Display`].
impl<const LIMBS: usize> Debug for Mp<LIMBS> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}
