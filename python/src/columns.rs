//! The outputs of an answer as columns, written straight into arrays.

use crate::points::Points;
use crate::refused;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, Int64Array, StringArray};
use interrupt::Stop;
use numpy::PyReadwriteArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use stickslip::internal::Value;
use stickslip::{Definition, Error};

/// Words by their codes; the last is for points outside the domain.
type Words = &'static [&'static str];

/// The kind of the values of a column.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Number,
    Count,
    Flag,
    Text(Words),
    /// Two complex numbers.
    Pairs,
}

impl Kind {
    /// The kind of a value, whose words are these if it is a text.
    pub(crate) const fn of(value: &Value<f64>, words: Words) -> Self {
        match value {
            Value::Number(_) => Self::Number,
            Value::Count(_) => Self::Count,
            Value::Flag(_) => Self::Flag,
            Value::Text(_) => Self::Text(words),
            Value::Pairs(_) => Self::Pairs,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Count => "count",
            Self::Flag => "flag",
            Self::Text(_) => "text",
            Self::Pairs => "pairs",
        }
    }

    /// The numbers that a value takes in an array.
    const fn width(self) -> usize {
        if matches!(self, Self::Pairs) { 4 } else { 1 }
    }
}

/// A row of the table of an answer's outputs.
#[derive(Clone, Copy)]
pub(crate) struct Row<C> {
    pub(crate) definition: &'static Definition,
    pub(crate) kind: Kind,
    pub(crate) column: C,
}

/// A row for Python: name, kind, unit in ratios, meaning, and whether the output needs a search of its own.
type Told = (&'static str, &'static str, &'static str, String, bool);

pub(crate) fn told<C>(rows: &[Row<C>]) -> Vec<Told> {
    let row = |row: &Row<C>| {
        let of = row.definition;
        (of.name, row.kind.name(), of.measure.unit(), of.text(), of.is_searched)
    };
    rows.iter().map(row).collect()
}

/// The rows of these names.
pub(crate) fn named<C: Copy>(rows: &[Row<C>], names: &[String]) -> PyResult<Vec<Row<C>>> {
    let find = |name: &String| {
        let found = rows.iter().find(|row| row.definition.name == name).copied();
        found.ok_or_else(|| refused(format!("output {name}: is unknown")))
    };
    names.iter().map(find).collect()
}

/// Adds a value to an answer at one point.
pub(crate) fn set(dict: &Bound<'_, PyDict>, name: &str, value: Value<f64>) -> PyResult<()> {
    match value {
        Value::Number(number) => dict.set_item(name, number.unwrap_or(f64::NAN)),
        Value::Count(Some(count)) => dict.set_item(name, count),
        Value::Flag(Some(flag)) => dict.set_item(name, flag),
        Value::Count(None) | Value::Flag(None) => dict.set_item(name, f64::NAN),
        Value::Text(text) => dict.set_item(name, text),
        Value::Pairs(pairs) => dict.set_item(name, parts(pairs).to_vec()),
    }
}

/// The real and imaginary parts of two complex numbers.
fn parts(pairs: Option<[(f64, f64); 2]>) -> [f64; 4] {
    pairs.map_or([f64::NAN; 4], |[(a, b), (c, d)]| [a, b, c, d])
}

/// An array of Python that receives a column.
#[derive(FromPyObject)]
pub(crate) enum Target<'py> {
    Numbers(PyReadwriteArray1<'py, f64>),
    Codes(PyReadwriteArray1<'py, u8>),
}

/// The part of a column that receives the values of some points.
pub(crate) enum Slot<'a> {
    Numbers(&'a mut [f64]),
    Codes(&'a mut [u8]),
}

impl<'a> Slot<'a> {
    fn of(target: &'a mut Target<'_>) -> PyResult<Self> {
        Ok(match target {
            Target::Numbers(array) => Self::Numbers(array.as_slice_mut()?),
            Target::Codes(array) => Self::Codes(array.as_slice_mut()?),
        })
    }

    const fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Codes(codes) => codes.len(),
        }
    }

    fn split_at(self, place: usize) -> (Self, Self) {
        match self {
            Self::Numbers(values) => {
                let (low, high) = values.split_at_mut(place);
                (Self::Numbers(low), Self::Numbers(high))
            }
            Self::Codes(codes) => {
                let (low, high) = codes.split_at_mut(place);
                (Self::Codes(low), Self::Codes(high))
            }
        }
    }
}

/// Columns and the slots that receive their values.
pub(crate) struct Places<'a, C>(pub(crate) Vec<(Row<C>, Slot<'a>)>);

impl<'a, C: Copy> Places<'a, C> {
    /// The places of `n` points in arrays of Python.
    pub(crate) fn of(rows: Vec<Row<C>>, targets: &'a mut [Target<'_>], n: usize) -> PyResult<Self> {
        let mut places = Vec::with_capacity(rows.len());
        for (row, target) in rows.into_iter().zip(targets) {
            let slot = Slot::of(target)?;
            let is_text = matches!(row.kind, Kind::Text(_));
            if slot.len() != n.saturating_mul(row.kind.width()) || is_text != matches!(slot, Slot::Codes(_)) {
                return Err(refused(format!("array {}: has another length or type", row.definition.name)));
            }
            places.push((row, slot));
        }
        Ok(Self(places))
    }

    fn split_at(self, place: usize) -> (Self, Self) {
        let mut parts = (Vec::with_capacity(self.0.len()), Vec::with_capacity(self.0.len()));
        for (row, slot) in self.0 {
            let (low, high) = slot.split_at(place.saturating_mul(row.kind.width()));
            parts.0.push((row, low));
            parts.1.push((row, high));
        }
        (Self(parts.0), Self(parts.1))
    }

    /// Writes the values of the point at a place; without an answer it is outside the domain.
    pub(crate) fn put(&mut self, place: usize, value: impl Fn(C) -> Option<Value<f64>>) {
        for (row, slot) in &mut self.0 {
            put(row.kind, slot, place, value(row.column));
        }
    }
}

/// Writes a value to its place in a slot.
pub(crate) fn put(kind: Kind, slot: &mut Slot<'_>, place: usize, value: Option<Value<f64>>) {
    match (slot, kind) {
        (Slot::Codes(codes), Kind::Text(words)) => {
            let last = words.len().saturating_sub(1);
            let code = match value {
                Some(Value::Text(text)) => words.iter().position(|word| *word == text).unwrap_or(last),
                _ => last,
            };
            if let Some(own) = codes.get_mut(place) {
                *own = u8::try_from(code).unwrap_or(u8::MAX);
            }
        }
        (Slot::Numbers(values), Kind::Pairs) => {
            let pairs = if let Some(Value::Pairs(pairs)) = value { pairs } else { None };
            let start = place.saturating_mul(kind.width());
            for (own, part) in values.iter_mut().skip(start).zip(parts(pairs)) {
                *own = part;
            }
        }
        (Slot::Numbers(values), _) => {
            let number = match value {
                Some(Value::Number(number)) => number,
                Some(Value::Count(count)) => count.map(|count| count as f64),
                Some(Value::Flag(flag)) => flag.map(f64::from),
                Some(Value::Text(_) | Value::Pairs(_)) | None => None,
            };
            if let Some(own) = values.get_mut(place) {
                *own = number.unwrap_or(f64::NAN);
            }
        }
        (Slot::Codes(_), _) => {}
    }
}

/// Halves the points recursively until at most `task` are left, and distributes these tasks over the available
/// threads, until `stop` is set.
pub(crate) fn halves<'a, C: Copy + Send + Sync>(
    points: Points<'_>,
    places: Places<'a, C>,
    task: usize,
    stop: &Stop,
    fill: &(impl Fn(Points<'_>, Places<'a, C>) -> Result<(), Error> + Sync),
) -> Result<(), Error> {
    if stop.asked().is_break() {
        return Ok(());
    }
    if points.n <= task {
        return fill(points, places);
    }
    let half = (points.n / 2).next_multiple_of(task);
    let (low, high) = (points.split_at(half), places.split_at(half));
    let (low, high) =
        rayon::join(|| halves(low.0, high.0, task, stop, fill), || halves(low.1, high.1, task, stop, fill));
    low.and(high)
}

/// Columns in memory of their own, for Arrow.
pub(crate) struct Store<C>(Vec<(Row<C>, Stored)>);

enum Stored {
    Numbers(Vec<f64>),
    Codes(Vec<u8>),
}

impl<C: Copy> Store<C> {
    pub(crate) fn new(rows: Vec<Row<C>>, n: usize) -> Self {
        let store = |row: Row<C>| {
            let stored = match row.kind {
                Kind::Text(_) => Stored::Codes(vec![0; n]),
                kind => Stored::Numbers(vec![0.0; n.saturating_mul(kind.width())]),
            };
            (row, stored)
        };
        Self(rows.into_iter().map(store).collect())
    }

    pub(crate) fn places(&mut self) -> Places<'_, C> {
        let mut places = Vec::with_capacity(self.0.len());
        for (row, stored) in &mut self.0 {
            let slot = match stored {
                Stored::Numbers(values) => Slot::Numbers(values),
                Stored::Codes(codes) => Slot::Codes(codes),
            };
            places.push((*row, slot));
        }
        Places(places)
    }

    /// The columns by name, with nulls for values that do not exist. Complex numbers become four columns.
    pub(crate) fn into_arrays(self) -> Vec<(String, ArrayRef)> {
        let mut arrays: Vec<(String, ArrayRef)> = Vec::with_capacity(self.0.len());
        for (row, stored) in self.0 {
            let name = row.definition.name.to_owned();
            let array: ArrayRef = match (stored, row.kind) {
                (Stored::Codes(codes), Kind::Text(words)) => {
                    let last = words.len().saturating_sub(1);
                    let word = |&code: &u8| {
                        words.get(usize::from(code)).copied().filter(|_| usize::from(code) < last)
                    };
                    Arc::new(codes.iter().map(word).collect::<StringArray>())
                }
                (Stored::Numbers(values), Kind::Count) => {
                    let count = |x: &f64| (!x.is_nan()).then_some(*x as i64);
                    Arc::new(values.iter().map(count).collect::<Int64Array>())
                }
                (Stored::Numbers(values), Kind::Flag) => {
                    let flag = |x: &f64| (!x.is_nan()).then_some(*x != 0.0);
                    Arc::new(values.iter().map(flag).collect::<BooleanArray>())
                }
                (Stored::Numbers(values), Kind::Pairs) => {
                    for (part, of) in ["1_re", "1_im", "2_re", "2_im"].into_iter().enumerate() {
                        let column = numbers(values.iter().skip(part).step_by(row.kind.width()));
                        arrays.push((format!("{name}_{of}"), column));
                    }
                    continue;
                }
                (Stored::Numbers(values), Kind::Number | Kind::Text(_)) => numbers(values.iter()),
                (Stored::Codes(_), _) => continue,
            };
            arrays.push((name, array));
        }
        arrays
    }
}

fn numbers<'a>(values: impl Iterator<Item = &'a f64>) -> ArrayRef {
    Arc::new(values.map(|x| (!x.is_nan()).then_some(*x)).collect::<Float64Array>())
}
