//! The columns of a file with their units, and the errors of its rows.

use csv::StringRecord;
use std::str::FromStr;
use stickslip::Float;
use stickslip_front::inputs::units::{Factor, InputError, Kind, Reader, number};

/// A column that is read.
pub(crate) struct Column {
    place: usize,
    name: String,
    kind: Kind,
    /// The factor of the unit in the header; without one, a value may have its own unit.
    pub(crate) factor: Option<Factor>,
}

impl Column {
    pub(crate) fn new(
        file: &str,
        (place, name, unit): (usize, &str, Option<&str>),
        kind: Kind,
        reader: &Reader,
    ) -> Result<Self, InputError> {
        let in_header = |unit| reader.factor_of_column(&format!("{file}: column {name}"), unit, kind);
        Ok(Self { place, name: name.to_owned(), kind, factor: unit.map(in_header).transpose()? })
    }

    pub(crate) fn text<'a>(&self, row: &'a StringRecord) -> &'a str {
        row.get(self.place).unwrap_or_default()
    }

    /// The value in a row at that place of the file.
    pub(crate) fn value<F: Float + FromStr>(
        &self,
        row: &StringRecord,
        at: &str,
        reader: &Reader,
    ) -> Result<F, InputError> {
        let (text, name) = (self.text(row), format!("{at}: {}", self.name));
        match self.factor {
            Some(factor) => Ok(factor.times(number(&name, text)?)),
            None => reader.value(&name, text, self.kind),
        }
    }
}

/// The error for input that the reader cannot parse as a row.
pub(crate) fn unreadable(name: &str, error: &csv::Error) -> String {
    let line = error.position().map_or(String::new(), |p| format!(" line {}", p.line()));
    let text = if let csv::ErrorKind::UnequalLengths { expected_len, len, .. } = error.kind() {
        let hint =
            if len > expected_len { ". A decimal needs a point, because commas separate fields" } else { "" };
        format!("{len} fields, must be {expected_len} as in the header{hint}")
    } else if let csv::ErrorKind::Utf8 { .. } = error.kind() {
        "must be text in UTF-8".to_owned()
    } else {
        error.to_string()
    };
    format!("{name}{line}: {text}")
}
