//! One value of a record, in each format.

use crate::bits::{self, Value};
use crate::failure::Outcome;
use serde::ser::{Serialize, Serializer};

/// A value of a record.
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

impl<F> From<stickslip::Value<F>> for Cell<F> {
    fn from(value: stickslip::Value<F>) -> Self {
        match value {
            stickslip::Value::Number(number) => Self::Number(number),
            stickslip::Value::Count(count) => Self::Count(count),
            stickslip::Value::Flag(flag) => Self::Flag(flag),
            stickslip::Value::Text(text) => Self::Text(text),
            stickslip::Value::Pairs(pairs) => Self::Pairs(pairs),
        }
    }
}

impl<F: Value> Cell<F> {
    /// This cell without its value.
    pub(crate) const fn absent(self) -> Self {
        match self {
            Self::Number(_) => Self::Number(None),
            Self::Count(_) => Self::Count(None),
            Self::Flag(_) => Self::Flag(None),
            Self::Text(_) | Self::Pairs(_) | Self::Intervals(_) => self,
        }
    }

    /// An error with that name if a number is infinite.
    pub(crate) fn finite(&self, name: &str) -> Outcome {
        let one = |x: F| {
            let text =
                || format!("{name} = {x} must be finite: it is beyond the largest number in these units");
            if x.is_finite() { Ok(()) } else { Err(text().into()) }
        };
        match self {
            Self::Number(number) => number.map_or(Ok(()), one),
            Self::Pairs(pairs) => {
                pairs.iter().flatten().try_for_each(|&(re, im)| one(re).and_then(|()| one(im)))
            }
            Self::Intervals(intervals) => intervals
                .iter()
                .flatten()
                .try_for_each(|&(low, high)| one(low).and_then(|()| high.map_or(Ok(()), one))),
            Self::Text(_) | Self::Count(_) | Self::Flag(_) => Ok(()),
        }
    }

    /// Text for a reader: seven digits at f64, and a dash for a missing value.
    pub(crate) fn text(&self) -> String {
        let dash = || "–".to_owned();
        match self {
            Self::Text(text) => (*text).to_owned(),
            Self::Number(number) => number.map_or_else(dash, bits::digits),
            Self::Count(count) => count.map_or_else(dash, |n| n.to_string()),
            Self::Flag(flag) => flag.map_or_else(dash, |flag| flag.to_string()),
            Self::Intervals(intervals) => {
                let text = |&(low, high): &(F, Option<F>)| match high {
                    Some(high) => format!("{} to {}", bits::digits(low), bits::digits(high)),
                    None => format!("{} and more", bits::digits(low)),
                };
                intervals.iter().flatten().map(text).collect::<Vec<_>>().join(", ")
            }
            Self::Pairs(pairs) => pairs.map_or_else(dash, |pairs| {
                pairs.map(|(re, im)| format!("{} {} i", bits::digits(re), bits::digits(im))).join(", ")
            }),
        }
    }
}

impl<F: Value> Cell<F> {
    /// The cells of one value each: four for a pair of complex numbers or two intervals.
    pub(super) fn parts(self) -> [Option<Self>; 4] {
        match self {
            Self::Pairs(pairs) => {
                let number = |part: fn([(F, F); 2]) -> F| Some(Self::Number(pairs.map(part)));
                [
                    number(|[(re, _), _]| re),
                    number(|[(_, im), _]| im),
                    number(|[_, (re, _)]| re),
                    number(|[_, (_, im)]| im),
                ]
            }
            Self::Intervals([first, second]) => {
                let ends = |interval: Option<(F, Option<F>)>| {
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

/// A number at f64; for a wider type a string with all digits, because a JSON reader would round the number.
impl<F: Value> Serialize for Cell<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => text.serialize(serializer),
            Self::Number(Some(number)) if F::PRECISION > f64::MANTISSA_DIGITS => {
                serializer.collect_str(number)
            }
            Self::Number(number) => number.map(F::to_f64).serialize(serializer),
            Self::Count(count) => count.serialize(serializer),
            Self::Flag(flag) => flag.serialize(serializer),
            Self::Intervals(intervals) => serializer.collect_seq(
                intervals.iter().flatten().map(|&(low, high)| [Some(low), high].map(Self::Number)),
            ),
            Self::Pairs(None) => serializer.serialize_none(),
            Self::Pairs(Some(pairs)) => {
                serializer.collect_seq(pairs.map(|(re, im)| [re, im].map(|x| Self::Number(Some(x)))))
            }
        }
    }
}
