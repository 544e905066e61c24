//! The text of a record: of the PEER database, or CSV with units in its header. It needs no file, so that the page in
//! the browser reads a record by it, too.

use crate::columns::{Column, is_misspelt, name_and_unit, unreadable};
use csv::{ReaderBuilder, StringRecord, Trim};
use std::str::FromStr;
use stickslip::inputs::units::{Kind, Reader, number};
use stickslip::motion::record::Record;
use stickslip::{Error, Excitation, Float};

/// The columns of a load: the name, the kind of its values, and the excitation.
const LOADS: [(&str, Kind, Excitation); 4] = [
    ("acceleration", Kind::Acceleration, Excitation::SurfaceAcceleration),
    ("force", Kind::Force, Excitation::Force),
    ("foot-displacement", Kind::Length, Excitation::FootMotion),
    ("damped-foot-displacement", Kind::Length, Excitation::DampedFootMotion),
];

/// The record of a text, and the names of the columns that are not used. A table without times has the `step` between
/// samples, with the text that gives it; `place_of_step` says where it is given, such as “by --time-step”.
pub(crate) fn read<F: Float + FromStr>(
    text: &str,
    name: &str,
    reader: &Reader,
    step: Option<(F, &str)>,
    place_of_step: &str,
) -> Result<(Record<F>, Vec<String>), String> {
    if peer(text).is_none() {
        return of_table(text, name, reader, step, place_of_step);
    }
    match step {
        Some((_, typed)) => Err(format!("{typed}: must be left out, because {name} states its own")),
        None => Ok((of_peer(text, name, reader)?, Vec::new())),
    }
}

/// The accelerations of a record of the PEER database, in g. Its fourth line has the number of samples and the step.
fn of_peer<F: Float + FromStr>(text: &str, name: &str, reader: &Reader) -> Result<Record<F>, String> {
    let bad = |line: usize, what: String| format!("{name} line {line}: {what}");
    let (count, step) = peer(text).flatten().ok_or_else(|| {
        bad(4, "must state the number of samples and the step: NPTS= 4000, DT= .005 SEC".to_owned())
    })?;
    let unit = reader.factor_of_column(name, "g", Kind::Acceleration)?;
    let second = reader.factor_of_column(name, "s", Kind::Time)?;
    let step = second.times(number::<F>(&format!("{name} line 4: DT"), step)?);
    let mut values = Vec::with_capacity(count.min(1 << 24));
    for (line, text) in (1..).zip(text.lines()).skip(4) {
        for word in text.split_whitespace() {
            let value = number::<F>(&format!("{name} line {line}"), word)?;
            values.push(unit.times(value));
        }
    }
    if values.len() != count {
        let found = values.len();
        return Err(bad(4, format!("NPTS = {count}, but the file has {found} samples")));
    }
    Record::new(Excitation::SurfaceAcceleration, step, values).map_err(|e| format!("{name}: {e}"))
}

/// The record of a table with a header, and the names of the columns that are not used.
fn of_table<F: Float + FromStr>(
    text: &str,
    name: &str,
    reader: &Reader,
    step: Option<(F, &str)>,
    place_of_step: &str,
) -> Result<(Record<F>, Vec<String>), String> {
    let bad = |what: String| format!("{name}: {what}");
    let first = text.lines().next().unwrap_or_default();
    let delimiter = [b',', b';', b'\t'].into_iter().find(|byte| first.as_bytes().contains(byte));
    let mut table = ReaderBuilder::new()
        .trim(Trim::All)
        .delimiter(delimiter.unwrap_or(b','))
        .from_reader(text.as_bytes());
    let header = table.headers().map_err(|e| unreadable(name, &e))?.clone();
    let ([time, load], unused) = columns(&header, name)?;
    let (place, index, unit) = load.ok_or_else(|| {
        let names = LOADS.map(|(name, ..)| name).join(", ");
        bad(format!("a column of the load is missing in the header “{first}”. Name one of {names}, such as acceleration[g]"))
    })?;
    let Some(&(column, kind, excitation)) = LOADS.get(index) else {
        return Err(bad("no load".to_owned()));
    };
    let load = Column::new(name, (place, column, unit), kind, reader)?;
    let time = time.map(|(place, _, unit)| Column::new(name, (place, "time", unit), Kind::Time, reader));
    let time = time.transpose()?;
    match (&time, step) {
        (None, None) => {
            return Err(bad(format!("has no column time. Give the time between samples {place_of_step}")));
        }
        (Some(_), Some((_, typed))) => {
            return Err(format!("{typed}: must be left out, because {name} has a column time"));
        }
        _ => {}
    }
    let (mut times, mut values, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let mut row = StringRecord::new();
    while table.read_record(&mut row).map_err(|e| unreadable(name, &e))? {
        let line = row.position().map_or(0, csv::Position::line);
        let at = format!("{name} line {line}");
        let value = |column: &Column, name: &str| {
            if column.text(&row).is_empty() {
                return Err(format!("{at}: {name}: is missing"));
            }
            Ok(column.value::<F>(&row, &at, reader)?)
        };
        values.push(value(&load, column)?);
        if let Some(time) = &time {
            times.push(value(time, "time")?);
        }
        lines.push(line);
    }
    let record = match (step, even(&times)) {
        (Some((step, _)), _) => Record::new(excitation, step, values),
        (None, Some((start, step))) => {
            Record::new(excitation, step, values).and_then(|record| record.beginning_at(start))
        }
        (None, None) => Record::at_times(excitation, times, values),
    };
    let record = record.map_err(|e| {
        if let Error::InSample { index, error } = &e
            && let Some(line) = lines.get(*index)
        {
            return format!("{name} line {line}: {error}");
        }
        bad(e.to_string())
    })?;
    Ok((record, unused))
}

/// A column: its place, its index among the loads, and its unit.
type Named<'a> = Option<(usize, usize, Option<&'a str>)>;

/// The columns of the time and of the load, and the names of the others.
fn columns<'a>(header: &'a StringRecord, name: &str) -> Result<([Named<'a>; 2], Vec<String>), String> {
    let (mut found, mut others) = ([None; 2], Vec::new());
    for (place, text) in header.iter().enumerate() {
        let (own, unit) = name_and_unit(text);
        let same = own.to_ascii_lowercase().replace('_', "-");
        let same = same.strip_prefix("base-").unwrap_or(&same);
        let index = LOADS.iter().position(|(name, ..)| *name == same);
        let refused = |what: &str| Err(format!("{name}: column {own} {what}"));
        let slot = match index {
            Some(_) => 1,
            None if same == "time" || same == "t" => 0,
            None => {
                let known = LOADS.iter().map(|(name, ..)| *name).chain(["time"]);
                if let Some(name) = known.into_iter().find(|name| is_misspelt(own, name)) {
                    return refused(&format!("is unknown. Spell it {name}, or rename it"));
                }
                others.push(own.to_owned());
                continue;
            }
        };
        let [time, load] = &mut found;
        let column: &mut Named<'a> = if slot == 0 { time } else { load };
        if column.replace((place, index.unwrap_or(0), unit)).is_some() {
            return refused("must be the only one of its kind. Rename the others");
        }
    }
    Ok((found, others))
}

/// The number of samples and the step of a record of the PEER database, if the text is one. The inner `None` says that
/// its fourth line does not state them.
fn peer(text: &str) -> Option<Option<(usize, &str)>> {
    let mut lines = text.lines().skip(2);
    let units = lines.next()?.to_ascii_uppercase();
    if !units.contains("TIME SERIES") || !units.contains("UNITS OF G") {
        return None;
    }
    let line = lines.next().unwrap_or_default();
    let split = |c: char| c.is_whitespace() || matches!(c, '=' | ',');
    let words: Vec<&str> = line.split(split).filter(|word| !word.is_empty()).collect();
    let after = |name: &str| {
        let place = words.iter().position(|word| word.eq_ignore_ascii_case(name))?;
        words.get(place + 1).copied().filter(|word| word.parse::<f64>().is_ok())
    };
    // Older files state the numbers first: 4000 0.005 NPTS, DT.
    let first = |place: usize| words.get(place).copied().filter(|word| word.parse::<f64>().is_ok());
    let count = after("NPTS").or_else(|| first(0)).and_then(|word| word.parse().ok());
    let step = after("DT").or_else(|| first(1));
    Some(count.zip(step))
}

/// The first time and the step, if the times are equally spaced but for the rounding of their text: no time is further
/// than a millionth of the step from its place.
fn even<F: Float + FromStr>(times: &[F]) -> Option<(F, F)> {
    let (&first, &last) = (times.first()?, times.last()?);
    let count = times.len().checked_sub(1).filter(|count| *count > 0)?;
    let step = (last - first) / F::from_f64(count as f64);
    let near = |(index, time): (usize, &F)| {
        let place = first + step * F::from_f64(index as f64);
        (*time - place).abs() <= step.abs() * F::ratio(1, 1_000_000)
    };
    (step > F::int(0) && times.iter().enumerate().all(near)).then_some((first, step))
}
