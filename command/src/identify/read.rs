//! The files of measurements, and the estimates of an answer.

use crate::args::IdentifyArgs;
use crate::bits::digits;
use crate::columns::Column;
use crate::failure::{Failure, Outcome};
use crate::rows::{Ahead, Bounded};
use crate::{input, rows};
use csv::StringRecord;
use serde::Serialize;
use std::io::{Read, Write};
use std::iter::zip;
use std::path::Path;
use stickslip::Error;
use stickslip::uncertainty::Estimate;
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::names::{is_misspelt, name_and_unit};

/// The note of a mass without a unit, where only columns of the file have units.
pub(super) fn note_mass_beside_columns(args: &IdentifyArgs, reader: &Reader) {
    if args.machine.iter().all(|(_, text)| !Reader::has_unit(text)) {
        input::note_bare_mass(&args.machine, reader);
    }
}

/// The columns of a header that are read, and the names of the others.
pub(super) fn columns<const N: usize>(
    header: &StringRecord,
    file: &str,
    reader: &Reader,
    known: [(&'static str, Kind); N],
) -> Result<([Option<Column>; N], Vec<String>), Failure> {
    let (mut found, mut others) = ([const { None }; N], Vec::new());
    for (place, text) in header.iter().enumerate() {
        let (own, unit) = name_and_unit(text);
        let refused = |what: &str| Err(format!("{file}: column {own} {what}").into());
        let named = zip(&mut found, known).find(|(_, (name, _))| own.eq_ignore_ascii_case(name));
        let Some((column, (name, kind))) = named else {
            // A misspelt column must not be ignored silently.
            if let Some((name, _)) = known.iter().find(|(name, _)| is_misspelt(own, name)) {
                return refused(&format!("is unknown. Spell it {name}, or rename it"));
            }
            others.push(own.to_owned());
            continue;
        };
        if column.is_some() {
            return refused("must be there once only");
        }
        *column = Some(Column::new(file, (place, name, unit), kind, reader)?);
    }
    Ok((found, others))
}

/// A file of measurements, of which no line may be endless.
pub(super) type Table<'a> = csv::Reader<Bounded<'a, Box<dyn Read>>>;

/// The file and its header.
pub(super) fn opened<'a>(
    file: &Path,
    name: &str,
    ahead: &'a Ahead,
) -> Result<(Table<'a>, StringRecord), Failure> {
    rows::table(Bounded { source: rows::open(file, name)?, ahead }, name)
}

/// Takes each row with its place in words, up to a number of things, and returns the lines of the rows.
pub(super) fn each_row(
    table: &mut Table<'_>,
    name: &str,
    ahead: &Ahead,
    (most, things): (usize, &str),
    mut take: impl FnMut(&StringRecord, &str) -> Outcome,
) -> Result<Vec<u64>, Failure> {
    let mut lines = Vec::new();
    rows::each(table, name, ahead, |row, line| {
        let at = format!("{name} line {line}");
        if lines.len() == most {
            return Err(format!("{at}: the number of {things} must be ≤ {most}").into());
        }
        lines.push(line);
        take(row, &at)
    })?;
    Ok(lines)
}

/// The error of a measurement with its line.
pub(super) fn in_line(error: Error, name: &str, lines: &[u64]) -> String {
    if let Error::InMeasurement { index, error } = error {
        return format!("{name} line {}: {error}", lines.get(index).copied().unwrap_or_default());
    }
    format!("{name}: {error}")
}

/// An estimate in JSON.
#[derive(Serialize)]
pub(super) struct EstimateRecord {
    pub(super) value: f64,
    pub(super) standard_error: f64,
    pub(super) interval_95: (f64, f64),
    pub(super) unit: String,
}

impl EstimateRecord {
    pub(super) fn of(estimate: &Estimate, scale: f64, unit: String) -> Self {
        let (low, high) = estimate.interval();
        Self {
            value: estimate.value * scale,
            standard_error: estimate.standard_error * scale,
            interval_95: (low * scale, high * scale),
            unit,
        }
    }
}

/// An estimate with its interval.
pub(super) fn estimate_line(name: &str, found: &EstimateRecord, out: &mut impl Write) -> Outcome {
    let unit = if found.unit == "1" { String::new() } else { format!(" {}", found.unit) };
    let (low, high) = found.interval_95;
    let (value, low, high) = (digits(found.value), digits(low), digits(high));
    Ok(writeln!(out, "  {name:<19} {value}{unit}  (95 %: {low} to {high}{unit})")?)
}
