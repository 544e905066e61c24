//! The numbers of an error.

use crate::float::Float;
use alloc::boxed::Box;
use alloc::format;
use alloc::string::ToString;
use core::fmt::{self, Display, Formatter};

/// A number in an error. It is printed with all the digits that identify it; its text is created on demand,
/// except for a type other than f64.
#[derive(Debug, Clone)]
pub struct Number {
    nearest: f64,
    /// All digits, for a type other than f64.
    digits: Option<Box<str>>,
}

impl Number {
    /// The number as an f64: the value itself, or the nearest one to it.
    #[must_use]
    pub const fn to_f64(&self) -> f64 {
        self.nearest
    }

    /// A number with a text of its own.
    pub(crate) fn spelled(nearest: f64, digits: &str) -> Self {
        Self { nearest, digits: Some(digits.into()) }
    }
}

/// Prints a power of ten where the number would need many zeros.
impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.digits {
            Some(digits) => f.pad(digits),
            None if is_plain(self.nearest) => Display::fmt(&self.nearest, f),
            None => fmt::LowerExp::fmt(&self.nearest, f),
        }
    }
}

/// Compares the digits; NaN equals NaN here, so that errors can be compared.
impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.digits == other.digits && self.nearest.to_bits() == other.nearest.to_bits()
    }
}

impl Eq for Number {}

impl core::hash::Hash for Number {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        (&self.digits, self.nearest.to_bits()).hash(state);
    }
}

impl<F: Float> From<F> for Number {
    fn from(x: F) -> Self {
        written(x)
    }
}

/// The number x, for an error.
pub(crate) fn written<F: Float>(x: F) -> Number {
    let nearest = x.to_f64();
    let digits = (F::PRECISION != f64::MANTISSA_DIGITS)
        .then(|| if is_plain(nearest) { x.to_string() } else { format!("{x:e}") }.into());
    Number { nearest, digits }
}

/// Whether the number needs few zeros.
fn is_plain(x: f64) -> bool {
    let size = x.abs();
    (1e-5..1e16).contains(&size) || size == 0.0 || !size.is_finite()
}
