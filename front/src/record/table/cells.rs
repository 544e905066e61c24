//! The cells of a row, and the numbers in them.

use super::super::text;
use super::clock;
use crate::inputs::units::{Reader, split};
use std::borrow::Cow;

/// The sign between the cells of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delimiter {
    Sign(char),
    Blanks,
}

impl Delimiter {
    pub(super) fn of(row: &str) -> Self {
        let sign = [';', '\t', ','].into_iter().find(|sign| row.contains(*sign));
        sign.map_or(Self::Blanks, Self::Sign)
    }

    /// Splits a row into its cells.
    pub(super) fn cells<'a>(self, row: &'a str, cells: &mut Vec<&'a str>) {
        cells.clear();
        match self {
            Self::Blanks => cells.extend(row.split_whitespace()),
            Self::Sign(sign) if row.contains('"') => {
                let mut quoted = false;
                cells.extend(row.split(|c: char| {
                    quoted ^= c == '"';
                    c == sign && !quoted
                }));
            }
            Self::Sign(sign) => cells.extend(row.split(sign)),
        }
        for cell in cells.iter_mut() {
            *cell = cell.trim().trim_matches('"').trim();
        }
    }

    /// Leaves out the empty cell behind a sign at the end of a row.
    pub(super) fn without_last(cells: &mut Vec<&str>) {
        if cells.len() > 1 && cells.last() == Some(&"") {
            cells.pop();
        }
    }

    /// The names in a header, of as many columns as a row has.
    pub(super) fn names(header: &str, columns: usize) -> Vec<String> {
        let own = |delimiter: Self| {
            let mut cells = Vec::new();
            delimiter.cells(header, &mut cells);
            Self::without_last(&mut cells);
            cells.into_iter().map(str::to_owned).collect::<Vec<_>>()
        };
        let delimiter = Self::of(header);
        if delimiter != Self::Blanks {
            return own(delimiter);
        }
        // “Time (s)   Acc (m/s^2)”: a unit belongs to the name before it.
        let mut names: Vec<String> = Vec::new();
        for word in header.split_whitespace() {
            match names.last_mut() {
                Some(name) if word.starts_with(['(', '[']) && !name.starts_with(['(', '[']) => {
                    name.push(' ');
                    name.push_str(word);
                }
                _ => names.push(word.to_owned()),
            }
        }
        if names.len() != columns {
            let wide: Vec<String> = header
                .split("  ")
                .map(str::trim)
                .filter(|name| !name.is_empty())
                .map(str::to_owned)
                .collect();
            if wide.len() == columns {
                return wide;
            }
        }
        names
    }
}

/// The text of a comment, where a line is one.
pub(super) fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    ["#", "%", "!", "//", "*", "|"].into_iter().find_map(|mark| line.strip_prefix(mark))
}

/// The number in a cell with a decimal point, which may be a comma where another sign separates the cells.
pub(super) fn decimal(cell: &str, delimiter: Delimiter) -> Cow<'_, str> {
    let has_comma =
        delimiter != Delimiter::Sign(',') && !cell.contains('.') && cell.matches(',').count() == 1;
    if has_comma { Cow::Owned(cell.replace(',', ".")) } else { Cow::Borrowed(cell) }
}

/// Whether a cell is a number.
pub(super) fn is_number(cell: &str, delimiter: Delimiter) -> bool {
    text::number::<f64>(&decimal(cell, delimiter)).is_some()
}

/// The number of cells of a line.
pub(in crate::record) fn width(line: &str) -> usize {
    let mut cells = Vec::new();
    Delimiter::of(line).cells(line, &mut cells);
    Delimiter::without_last(&mut cells);
    cells.len()
}

/// What begins a row: numbers or the time of a clock, a word above numbers, or no number at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::record) enum Row {
    Numbers,
    Labelled,
    Title,
}

/// What a row is. A number may have a unit.
pub(in crate::record) fn row(line: &str) -> Row {
    let delimiter = Delimiter::of(line);
    let mut cells = Vec::new();
    delimiter.cells(line, &mut cells);
    let is_value = |cell: &&str| {
        let (digits, unit) = split(cell);
        is_number(cell, delimiter)
            || (text::number::<f64>(digits).is_some() && Reader::is_unit(unit))
            || cell.eq_ignore_ascii_case("nan")
    };
    match cells.iter().any(is_value) {
        false => Row::Title,
        true if cells.first().is_some_and(|first| is_value(first) || clock::instant(first).is_some()) => {
            Row::Numbers
        }
        true => Row::Labelled,
    }
}
