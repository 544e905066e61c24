//! The unit of samples.

use super::text;
use crate::inputs::units::{Factor, Kind, Reader};
use std::str::FromStr;
use stickslip::{Excitation, Float};

/// A quotient of two numbers as they are written in a file: 1/200 of “200 samples a second”, 1/10 of “g/10”.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Ratio {
    pub(super) above: String,
    pub(super) below: String,
}

impl Ratio {
    pub(super) fn new(above: &str, below: &str) -> Self {
        Self { above: above.to_owned(), below: below.to_owned() }
    }

    pub(super) fn one() -> Self {
        Self::new("1", "1")
    }

    pub(super) fn to_f64(&self) -> f64 {
        let number = |text: &str| text::number::<f64>(text).unwrap_or(f64::NAN);
        number(&self.above) / number(&self.below)
    }
}

/// The power of ten of a volt.
pub(super) fn volts(unit: &str) -> Option<i32> {
    match unit {
        "V" | "v" | "volt" | "volts" | "Volt" | "Volts" => Some(0),
        "mV" => Some(-3),
        "µV" | "μV" | "uV" => Some(-6),
        _ => None,
    }
}

/// The unit of samples.
#[derive(Debug, Clone)]
pub(super) struct Unit {
    pub(super) name: String,
    /// The factor to the consistent system of the reader; none where values have units of their own.
    pub(super) factor: Option<Factor>,
    pub(super) kind: Kind,
    /// The number of units for each number of the file.
    pub(super) scale: Ratio,
}

impl Unit {
    /// The unit of a text in a file: of this kind, or else of an acceleration, a force or a length.
    pub(super) fn new(at: &str, stated: &str, reader: &Reader, kind: Option<Kind>) -> Result<Self, String> {
        let spelt = text::unit(stated);
        let kinds = [Kind::Acceleration, Kind::Force, Kind::Length];
        let factor = |kind: Kind| reader.factor_of_column(at, &spelt, kind);
        let found = match kind {
            Some(kind) => factor(kind).map(|factor| (factor, kind)),
            None => {
                let first = factor(Kind::Acceleration).map(|factor| (factor, Kind::Acceleration));
                kinds.into_iter().skip(1).fold(first, |found, kind| {
                    found.or_else(|error| factor(kind).map(|factor| (factor, kind)).map_err(|_| error))
                })
            }
        };
        let (factor, kind) = found.map_err(|error| error.to_string())?;
        Ok(Self { name: text::shown(&spelt), factor: Some(factor), kind, scale: Ratio::one() })
    }

    /// The value in the system of the reader.
    pub(super) fn times<F: Float + FromStr>(&self, value: F) -> F {
        self.factor.map_or(value, |factor| factor.times(value))
    }

    /// The load of a unit without a name: the acceleration of the surface, a force, or the displacement of the support.
    pub(super) const fn excitation(&self) -> Excitation {
        match self.kind {
            Kind::Force => Excitation::Force,
            Kind::Length => Excitation::FootMotion,
            _ => Excitation::SurfaceAcceleration,
        }
    }
}
