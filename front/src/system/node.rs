//! A value of a file with its place, such as `springs[2].stiffness`, so that each mistake is one line that names both.

use crate::inputs::units::{Kind, Reader};
use crate::text::is_control;
use serde_json::{Map, Value};
use std::cell::RefCell;
use std::str::FromStr;
use stickslip::Float;

/// A number that a file is read into: a double, or one of more bits, which takes the decimals of the file as they are typed.
pub trait Number: Float + FromStr {}

impl<F: Float + FromStr> Number for F {}

/// Whether numbers have the digits of a double, which values of JSON have, too.
pub(super) const fn is_double<F: Number>() -> bool {
    F::PRECISION <= f64::MANTISSA_DIGITS
}

/// A value and its place in the file.
#[derive(Debug, Clone)]
pub(super) struct Node<'a> {
    place: String,
    value: &'a Value,
    reader: &'a Reader,
}

/// The fields of a table, each of which must be read, so that a misspelt one is not ignored.
pub(super) struct Fields<'a> {
    pub(super) node: Node<'a>,
    map: &'a Map<String, Value>,
    known: RefCell<Vec<&'static str>>,
}

impl<'a> Node<'a> {
    /// The whole file.
    pub(super) fn root(value: &'a Value, reader: &'a Reader) -> Self {
        Self { place: String::new(), value, reader }
    }

    pub(super) const fn value(&self) -> &'a Value {
        self.value
    }

    pub(super) const fn reader(&self) -> &'a Reader {
        self.reader
    }

    pub(super) fn place(&self) -> &str {
        if self.place.is_empty() { "the file" } else { &self.place }
    }

    /// The error that a value is not as it must be.
    pub(super) fn wrong(&self, must: &str) -> String {
        match self.value {
            Value::Object(_) | Value::Array(_) => format!("{}: {must}", self.place()),
            Value::String(text) => format!("{} {text}: {must}", self.place()),
            value @ (Value::Null | Value::Bool(_) | Value::Number(_)) => {
                format!("{} {value}: {must}", self.place())
            }
        }
    }

    fn inner(&self, name: &str, value: &'a Value) -> Self {
        let place = if self.place.is_empty() { name.to_owned() } else { format!("{}.{name}", self.place) };
        Self { place, value, reader: self.reader }
    }

    /// A table.
    pub(super) fn fields(&self) -> Result<Fields<'a>, String> {
        let map = self.value.as_object().ok_or_else(|| self.wrong("must be a table"))?;
        Ok(Fields { node: self.clone(), map, known: RefCell::default() })
    }

    /// The entries of a table whose keys are names.
    pub(super) fn entries(&self) -> Result<Vec<(&'a str, Self)>, String> {
        let map = self.value.as_object().ok_or_else(|| self.wrong("must be a table"))?;
        Ok(map.iter().map(|(name, value)| (name.as_str(), self.inner(name, value))).collect())
    }

    /// A list.
    pub(super) fn list(&self) -> Result<Vec<Self>, String> {
        let list = self.value.as_array().ok_or_else(|| self.wrong("must be a list"))?;
        let place = |i: usize| format!("{}[{}]", self.place, i.saturating_add(1));
        let items = list.iter().enumerate();
        Ok(items.map(|(i, value)| Self { place: place(i), value, reader: self.reader }).collect())
    }

    pub(super) fn text(&self) -> Result<&'a str, String> {
        self.value.as_str().ok_or_else(|| self.wrong("must be a text in quotation marks"))
    }

    /// A name, which is shown on terminals and drawings.
    pub(super) fn name(&self) -> Result<&'a str, String> {
        let name = self.text()?;
        check_name(name).map_err(|must| self.wrong(must))?;
        Ok(name)
    }

    /// A quantity: a number, or a text with a unit. A frequency with a unit is the same in all systems, and stands beside any
    /// numbers.
    pub(super) fn quantity<F: Number>(&self, kind: Kind) -> Result<F, String> {
        let text = match self.value {
            Value::String(text) => text.clone(),
            Value::Number(number) => number.to_string(),
            Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => {
                return Err(self.wrong("must be a number, or a text with a unit"));
            }
        };
        let alone = Reader::new(None, "");
        let is_alone = kind == Kind::Frequency && Reader::has_unit(&text);
        let reader = if is_alone { &alone } else { self.reader };
        let value: F = reader.value(self.place(), &text, kind).map_err(|e| e.to_string())?;
        if value.is_finite() { Ok(value) } else { Err(self.wrong("must be finite")) }
    }

    /// A quantity where a quantity over time may be, too: the name of a file is met by the table of a record.
    pub(super) fn constant<F: Number>(&self, kind: Kind) -> Result<F, String> {
        let is_name = |text: &&str| {
            text.contains('.') && !text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        };
        self.quantity(kind).map_err(|error| match self.value.as_str().map(str::trim).filter(is_name) {
            Some(file) => format!("{error}. A record is a table, {{ file = \"{file}\" }}"),
            None => error,
        })
    }

    /// The value of this place, if it is not below a number.
    pub(super) fn at_least<F: Number>(&self, value: F, least: i32) -> Result<F, String> {
        if value >= F::int(least) { Ok(value) } else { Err(self.wrong(&format!("must be ≥ {least}"))) }
    }

    /// A quantity ≥ 0.
    pub(super) fn not_negative<F: Number>(&self, kind: Kind) -> Result<F, String> {
        self.at_least(self.quantity(kind)?, 0)
    }

    /// A number without a unit.
    pub(super) fn number<F: Number>(&self) -> Result<F, String> {
        let found = match self.value {
            Value::Number(number) if is_double::<F>() => number.as_f64().map(F::from_f64),
            Value::Number(number) => number.to_string().parse().ok(),
            Value::String(text) => text.trim().parse().ok(),
            Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => None,
        };
        found.filter(|x: &F| x.is_finite()).ok_or_else(|| self.wrong("must be a finite number"))
    }

    /// Numbers. Those of JSON need no place of their own, as long as nothing is wrong with them.
    pub(super) fn numbers<F: Number>(&self) -> Result<Vec<F>, String> {
        let double = |value: &Value| value.as_f64().map(F::from_f64);
        let list = self.value.as_array().filter(|_| is_double::<F>());
        let plain = list.and_then(|list| list.iter().map(double).collect());
        plain.map_or_else(|| self.list()?.iter().map(Self::number).collect(), Ok)
    }

    /// So many numbers.
    pub(super) fn vector<F: Number>(&self, n: usize) -> Result<Vec<F>, String> {
        let found = self.numbers()?;
        if found.len() == n { Ok(found) } else { Err(self.of_length(found.len(), "numbers", n)) }
    }

    /// A square matrix by rows.
    pub(super) fn matrix<F: Number>(&self, n: usize) -> Result<Vec<Vec<F>>, String> {
        let rows = self.list()?;
        if rows.len() == n {
            rows.iter().map(|row| row.vector(n)).collect()
        } else {
            Err(self.of_length(rows.len(), "rows", n))
        }
    }

    fn of_length(&self, found: usize, what: &str, due: usize) -> String {
        self.wrong(&format!("has {found} {what}, must have {due}"))
    }
}

impl<'a> Fields<'a> {
    /// A field, if it is there.
    pub(super) fn get(&self, name: &'static str) -> Option<Node<'a>> {
        let mut known = self.known.borrow_mut();
        if !known.contains(&name) {
            known.push(name);
        }
        self.map.get(name).filter(|value| !value.is_null()).map(|value| self.node.inner(name, value))
    }

    /// A field that must be there.
    pub(super) fn required(&self, name: &'static str) -> Result<Node<'a>, String> {
        self.get(name).ok_or_else(|| {
            let place = &self.node.place;
            let whole = if place.is_empty() { name.to_owned() } else { format!("{place}.{name}") };
            format!("{whole} is missing")
        })
    }

    /// A quantity, or a number where it is missing.
    pub(super) fn quantity_or<F: Number>(
        &self,
        name: &'static str,
        kind: Kind,
        other: i32,
    ) -> Result<F, String> {
        self.get(name).map_or(Ok(F::int(other)), |node| node.quantity(kind))
    }

    /// Fails at a field that is none of those read or of these, with the name that is nearest to it.
    pub(super) fn end_with(&self, others: &[&'static str]) -> Result<(), String> {
        for name in others {
            let _ = self.get(name);
        }
        self.end()
    }

    /// Fails at a field that has not been read, with the known name that is nearest to it.
    pub(super) fn end(&self) -> Result<(), String> {
        let known = self.known.borrow();
        let Some(unknown) = self.map.keys().find(|name| !known.contains(&name.as_str())) else {
            return Ok(());
        };
        let place = if self.node.place.is_empty() { String::new() } else { format!("{}.", self.node.place) };
        Err(format!("{place}{unknown} is unknown. {}", nearest(unknown, known.iter().copied())))
    }
}

/// Fails for a name that cannot be shown.
pub(super) fn check_name(name: &str) -> Result<(), &'static str> {
    match name {
        "" => Err("a name must not be empty"),
        name if name.contains(is_control) => Err("a name must have no control characters"),
        _ => Ok(()),
    }
}

/// The nearest of several names, or all of them.
pub(super) fn nearest<'n>(wrong: &str, names: impl Iterator<Item = &'n str> + Clone) -> String {
    let near =
        names.clone().min_by_key(|name| strsim::osa_distance(&wrong.to_lowercase(), &name.to_lowercase()));
    match near {
        Some(near) if strsim::osa_distance(wrong, near) <= near.len().max(3) / 3 => {
            format!("Did you mean {near}?")
        }
        Some(_) => format!("Expected one of {}", names.collect::<Vec<_>>().join(", ")),
        None => "None is expected here".to_owned(),
    }
}
