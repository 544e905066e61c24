//! One value of a record, in each format.

use crate::bits::{self, Value};
use crate::failure::Outcome;
use serde::ser::{Serialize, Serializer};
use std::fmt::{self, Display, Formatter};

/// A number as it is written. Rows of it are compiled once, and not for each width.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Number {
    Double(f64),
    /// All digits of a wider number, and whether it is finite.
    Wide(Box<str>, bool),
}

impl Number {
    pub(crate) fn of<F: Value>(x: F) -> Self {
        if F::PRECISION > f64::MANTISSA_DIGITS {
            Self::Wide(x.to_string().into(), x.is_finite())
        } else {
            Self::Double(x.to_f64())
        }
    }

    /// This number as a text of its digits.
    pub(crate) fn into_text(self) -> Self {
        match self {
            Self::Double(x) => Self::Wide(x.to_string().into(), x.is_finite()),
            wide @ Self::Wide(..) => wide,
        }
    }

    const fn is_finite(&self) -> bool {
        match self {
            Self::Double(x) => x.is_finite(),
            Self::Wide(_, is_finite) => *is_finite,
        }
    }

    /// The number, if it is a double.
    pub(crate) const fn double(&self) -> Option<f64> {
        match self {
            Self::Double(x) => Some(*x),
            Self::Wide(..) => None,
        }
    }

    /// Seven digits of a double, all of a wider number.
    pub(crate) fn digits(&self) -> String {
        match self {
            Self::Double(x) => bits::digits(*x),
            Self::Wide(text, _) => text.to_string(),
        }
    }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Double(x) => x.fmt(f),
            Self::Wide(text, _) => text.fmt(f),
        }
    }
}

/// A number at f64; for a wider type a string with all digits, because a JSON reader would round the number.
impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Double(x) => serializer.serialize_f64(*x),
            Self::Wide(text, _) => serializer.serialize_str(text),
        }
    }
}

/// A value of a record: of a number type while it is computed, of [`Number`] where it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell<F> {
    Text(&'static str),
    /// A number; `None` where it does not exist.
    Number(Option<F>),
    /// An integer.
    Count(Option<u64>),
    /// A truth value; `None` where it does not exist.
    Flag(Option<bool>),
    /// At most two intervals; the last may have no greatest value.
    Intervals([Option<(F, Option<F>)>; 2]),
    /// Two complex numbers, each as its real and imaginary part.
    Pairs(Option<[(F, F); 2]>),
}

impl<F> Cell<F> {
    /// Whether it has no value.
    pub(crate) const fn is_absent(&self) -> bool {
        matches!(self, Self::Number(None) | Self::Count(None) | Self::Flag(None) | Self::Pairs(None))
    }

    /// A cell of this kind without a value.
    pub(crate) const fn blank(&self) -> Self {
        match self {
            Self::Text(_) => Self::Text(""),
            Self::Number(_) => Self::Number(None),
            Self::Count(_) => Self::Count(None),
            Self::Flag(_) => Self::Flag(None),
            Self::Intervals(_) => Self::Intervals([None, None]),
            Self::Pairs(_) => Self::Pairs(None),
        }
    }
}

impl<F> From<stickslip::internal::Value<F>> for Cell<F> {
    fn from(value: stickslip::internal::Value<F>) -> Self {
        match value {
            stickslip::internal::Value::Number(number) => Self::Number(number),
            stickslip::internal::Value::Count(count) => Self::Count(count),
            stickslip::internal::Value::Flag(flag) => Self::Flag(flag),
            stickslip::internal::Value::Text(text) => Self::Text(text),
            stickslip::internal::Value::Pairs(pairs) => Self::Pairs(pairs),
        }
    }
}

impl<F: Value> Cell<F> {
    /// This cell without its value.
    pub(crate) fn absent(self) -> Self {
        match self {
            Self::Number(_) => Self::Number(None),
            Self::Count(_) => Self::Count(None),
            Self::Flag(_) => Self::Flag(None),
            Self::Text(_) | Self::Pairs(_) | Self::Intervals(_) => self,
        }
    }

    /// The value as it is written.
    pub(crate) fn shown(self) -> Cell<Number> {
        let pair = |(re, im)| (Number::of(re), Number::of(im));
        match self {
            Self::Text(text) => Cell::Text(text),
            Self::Number(number) => Cell::Number(number.map(Number::of)),
            Self::Count(count) => Cell::Count(count),
            Self::Flag(flag) => Cell::Flag(flag),
            Self::Intervals(intervals) => Cell::Intervals(intervals.map(|interval| {
                interval.map(|(low, high): (F, Option<F>)| (Number::of(low), high.map(Number::of)))
            })),
            Self::Pairs(pairs) => Cell::Pairs(pairs.map(|pairs| pairs.map(pair))),
        }
    }
}

impl Cell<Number> {
    /// An error with that name if a number is infinite.
    pub(crate) fn finite(&self, name: &str) -> Outcome {
        let one = |x: &Number| {
            let text =
                || format!("{name} = {x} must be finite: it is beyond the largest number in these units");
            if x.is_finite() { Ok(()) } else { Err(text().into()) }
        };
        match self {
            Self::Number(number) => number.iter().try_for_each(one),
            Self::Pairs(pairs) => {
                pairs.iter().flatten().try_for_each(|(re, im)| one(re).and_then(|()| one(im)))
            }
            Self::Intervals(intervals) => intervals
                .iter()
                .flatten()
                .try_for_each(|(low, high)| one(low).and_then(|()| high.iter().try_for_each(one))),
            Self::Text(_) | Self::Count(_) | Self::Flag(_) => Ok(()),
        }
    }

    /// Text for a reader: seven digits at f64, and a dash for a missing value.
    pub(crate) fn text(&self) -> String {
        let dash = || "–".to_owned();
        match self {
            Self::Text(text) => (*text).to_owned(),
            Self::Number(number) => number.as_ref().map_or_else(dash, Number::digits),
            Self::Count(count) => count.map_or_else(dash, |n| n.to_string()),
            Self::Flag(flag) => flag.map_or_else(dash, |flag| flag.to_string()),
            Self::Intervals(intervals) => {
                let text = |(low, high): &(Number, Option<Number>)| match high {
                    Some(high) => format!("{} to {}", low.digits(), high.digits()),
                    None => format!("{} and more", low.digits()),
                };
                intervals.iter().flatten().map(text).collect::<Vec<_>>().join(", ")
            }
            Self::Pairs(pairs) => pairs.as_ref().map_or_else(dash, |pairs| {
                let text = |(re, im): &(Number, Number)| format!("{} {} i", re.digits(), im.digits());
                pairs.each_ref().map(text).join(", ")
            }),
        }
    }
}

impl Cell<Number> {
    /// The cells of one value each: four for a pair of complex numbers or two intervals.
    pub(super) fn parts(self) -> [Option<Self>; 4] {
        match self {
            Self::Pairs(pairs) => {
                let parts = pairs.map_or([const { None }; 4], |[(a, b), (c, d)]| [a, b, c, d].map(Some));
                parts.map(|part| Some(Self::Number(part)))
            }
            Self::Intervals([first, second]) => {
                let ends = |interval: Option<(Number, Option<Number>)>| {
                    let (low, high) = interval.map_or((None, None), |(low, high)| (Some(low), high));
                    (Some(Self::Number(low)), Some(Self::Number(high)))
                };
                let ((a, b), (c, d)) = (ends(first), ends(second));
                [a, b, c, d]
            }
            Self::Text(_) | Self::Number(_) | Self::Count(_) | Self::Flag(_) => {
                [Some(self), None, None, None]
            }
        }
    }

    /// The names of the cells of [`Cell::parts`].
    pub(crate) fn part_names(&self, name: &str) -> Vec<String> {
        let parts = match self {
            Self::Pairs(_) => ["_1_re", "_1_im", "_2_re", "_2_im"].as_slice(),
            Self::Intervals(_) => &["_1_low", "_1_high", "_2_low", "_2_high"],
            Self::Text(_) | Self::Number(_) | Self::Count(_) | Self::Flag(_) => &[""],
        };
        parts.iter().map(|part| format!("{name}{part}")).collect()
    }
}

impl Serialize for Cell<Number> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => text.serialize(serializer),
            Self::Number(number) => number.serialize(serializer),
            Self::Count(count) => count.serialize(serializer),
            Self::Flag(flag) => flag.serialize(serializer),
            Self::Intervals(intervals) => serializer
                .collect_seq(intervals.iter().flatten().map(|(low, high)| [Some(low), high.as_ref()])),
            Self::Pairs(pairs) => pairs.serialize(serializer),
        }
    }
}
