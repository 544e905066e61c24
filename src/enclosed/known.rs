//! A ratio that is a rational number or lies between two of them.

use crate::float::ball::{Ball, Radius};
use crate::float::mp::{Mp, ParseError};
use crate::float::{Field, Float};
use crate::machine::error::{Error, Number, Quantity, written};
use crate::machine::ratios::{positive, within};
use core::str::FromStr;
use rug::ops::Pow;
use rug::{Integer, Rational};

/// The knowledge of a ratio: its exact value, or that it lies between two numbers.
///
/// Text is read exactly as written: `0.4` is four tenths, `1/3` is a third, and `0.695..0.705` is all numbers between
/// these two.
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use]
pub struct Known {
    low: Rational,
    high: Rational,
}

/// The greatest length of a decimal number, and the greatest exponent.
const LONGEST: usize = 20_000;

impl Known {
    /// A ratio that is exactly the number x.
    ///
    /// # Errors
    /// Where x is not finite.
    pub fn exactly<const LIMBS: usize>(x: Mp<LIMBS>) -> Result<Self, Error> {
        let quantity = Quantity::FrequencyRatio;
        let value = || Error::NotFinite { quantity, value: written(x) };
        let number = x.to_rational().ok_or_else(value)?;
        Ok(Self { low: number.clone(), high: number })
    }

    /// All numbers between two ends, of which the second is not below the first.
    pub(crate) fn of_ends(low: Rational, high: Rational) -> Self {
        Self { low, high }
    }

    /// All numbers from the low end of one to the high end of the other.
    ///
    /// # Errors
    /// [`Error::EmptyInterval`] where the ends are in the wrong order.
    pub fn between(low: &Self, high: &Self) -> Result<Self, Error> {
        if low.low <= high.high {
            Ok(Self { low: low.low.clone(), high: high.high.clone() })
        } else {
            let end = |x: &Rational| Number::spelled(x.to_f64(), &x.to_string());
            Err(Error::EmptyInterval { low: end(&low.low), high: end(&high.high) })
        }
    }

    /// Whether this is a single number.
    #[must_use]
    pub(crate) fn is_exact(&self) -> bool {
        self.low == self.high
    }

    pub(crate) fn low(&self) -> &Rational {
        &self.low
    }

    pub(crate) fn high(&self) -> &Rational {
        &self.high
    }

    /// The middle.
    pub(crate) fn middle(&self) -> Rational {
        Rational::from(&self.low + &self.high) / 2u32
    }

    /// The image of the numbers under a nondecreasing function.
    pub(crate) fn map(&self, f: impl Fn(&Rational) -> Rational) -> Self {
        Self { low: f(&self.low), high: f(&self.high) }
    }

    /// The ratio, if it lies in its domain of [`crate::Ratios`].
    pub(crate) fn within(&self, quantity: Quantity, is_bounded_below: bool) -> Result<&Self, Error> {
        let greatest = Mp::<2>::exp2i(<f64 as Float>::RATIO_EXPONENT);
        let least = if is_bounded_below { Mp::int(1) / greatest } else { Mp::int(0) };
        for end in [&self.low, &self.high] {
            let x = positive(quantity, Mp::<2>::from_rational(end))?;
            within(quantity, x, least, greatest)?;
        }
        Ok(self)
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl Known {
    /// A ratio that is exactly the number x.
    pub fn rational(x: Rational) -> Self {
        Self { low: x.clone(), high: x }
    }

    /// A ball that contains these numbers.
    #[must_use]
    pub fn ball<const W: usize>(&self) -> Ball<W> {
        let end = |x: &Rational| {
            let mid = Mp::from_rational(x);
            let rest = mid.to_rational().map(|mid| mid - x);
            match rest {
                Some(rest) if rest == 0 => Ball::exact(mid),
                Some(rest) => Ball::new(mid, Radius::above(Mp::<2>::from_rational(&rest)).scaled(1)),
                None => Ball::entire(),
            }
        };
        let low = end(&self.low);
        if self.is_exact() { low } else { low.hull(&end(&self.high)) }
    }
}

impl FromStr for Known {
    type Err = ParseError;

    /// Reads a decimal number as `f64` does, or two integers with `/` between them, exactly as written; and two of these
    /// with `..` between them.
    fn from_str(text: &str) -> Result<Self, ParseError> {
        if let Some((low, high)) = text.split_once("..") {
            let error = |_| ParseError { text: text.chars().take(80).collect() };
            return Self::between(&low.parse()?, &high.parse()?).map_err(error);
        }
        let error = || ParseError { text: text.chars().take(80).collect() };
        let number = match text.split_once('/') {
            Some((over, under)) => {
                let integer = |part: &str| {
                    let is_one =
                        !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit()) && part.len() <= LONGEST;
                    is_one.then(|| part.parse::<Integer>().ok()).flatten().ok_or_else(error)
                };
                let under = integer(under)?;
                if under == 0 {
                    return Err(error());
                }
                Rational::from((integer(over)?, under))
            }
            None => decimal(text).ok_or_else(error)?,
        };
        Ok(Self { low: number.clone(), high: number })
    }
}

/// The decimal number as written; `None` for text that is no number, infinite, or too long to be a ratio.
fn decimal(text: &str) -> Option<Rational> {
    // The grammar is that of `f64`.
    text.parse::<f64>().ok().filter(|_| text.len() <= LONGEST)?;
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().ok().filter(|e: &i32| e.unsigned_abs() as usize <= LONGEST)?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let integer: Integer = format!("{whole}{fraction}").trim_start_matches('+').parse().ok()?;
    let place = exponent - i32::try_from(fraction.len()).ok()?;
    Some(Rational::from(integer) * Rational::from(10).pow(place))
}
