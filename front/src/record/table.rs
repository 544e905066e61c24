//! Columns of numbers: separated by commas, semicolons, tabs or blanks, with or without names and units.

use super::lines::{Line, Lines};
use super::samples::{Samples, Times};
use super::{Options, Reading, Unit, text};
use crate::names::{is_misspelt, name_and_unit};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::inputs::units::{Kind, Reader, split};
use stickslip::{Excitation, Float};

/// The loads: the name of the column, its synonyms, the kind of its values, and the excitation.
const LOADS: [(&str, &[&str], Kind, Excitation); 4] = [
    (
        "acceleration",
        &[
            "acc",
            "accel",
            "accn",
            "a",
            "ag",
            "ground-acceleration",
            "base-acceleration",
            "surface-acceleration",
        ],
        Kind::Acceleration,
        Excitation::SurfaceAcceleration,
    ),
    ("force", &["f", "load"], Kind::Force, Excitation::Force),
    ("foot-displacement", &[], Kind::Length, Excitation::FootMotion),
    ("damped-foot-displacement", &[], Kind::Length, Excitation::DampedFootMotion),
];

/// The names of the time.
const TIMES: [&str; 4] = ["time", "t", "times", "seconds"];

/// The most lines without numbers before the columns.
const MOST_TITLES: usize = 200;

/// What another layout knows of its columns.
#[derive(Debug)]
pub(super) struct Known {
    pub(super) kind: &'static str,
    pub(super) names: Vec<String>,
    pub(super) unit: Option<Unit>,
}

impl Default for Known {
    fn default() -> Self {
        Self { kind: "columns", names: Vec::new(), unit: None }
    }
}

/// The sign between the cells of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Delimiter {
    Sign(char),
    Blanks,
}

impl Delimiter {
    fn of(row: &str) -> Self {
        let sign = [';', '\t', ','].into_iter().find(|sign| row.contains(*sign));
        sign.map_or(Self::Blanks, Self::Sign)
    }

    /// Splits a row into its cells.
    fn cells<'a>(self, row: &'a str, cells: &mut Vec<&'a str>) {
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
    fn without_last(cells: &mut Vec<&str>) {
        if cells.len() > 1 && cells.last() == Some(&"") {
            cells.pop();
        }
    }

    /// The names in a header, of as many columns as a row has.
    fn names(header: &str, columns: usize) -> Vec<String> {
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
                Some(name) if word.starts_with(['(', '[']) => {
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
fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    ["#", "%", "!", "//", "*", "|"].into_iter().find_map(|mark| line.strip_prefix(mark))
}

/// A number in a cell, with a decimal comma where another sign separates the cells.
fn number<F: Float + FromStr>(cell: &str, delimiter: Delimiter) -> Option<F> {
    text::number(cell).or_else(|| {
        let has_comma =
            delimiter != Delimiter::Sign(',') && !cell.contains('.') && cell.matches(',').count() == 1;
        has_comma.then(|| text::number(&cell.replace(',', "."))).flatten()
    })
}

/// Whether a row is one of numbers: a cell is a number, with or without a unit.
fn is_row(line: &str) -> bool {
    let delimiter = Delimiter::of(line);
    let mut cells = Vec::new();
    delimiter.cells(line, &mut cells);
    cells.iter().any(|cell| {
        let (digits, unit) = split(cell);
        number::<f64>(cell, delimiter).is_some()
            || (text::number::<f64>(digits).is_some() && Reader::is_unit(unit))
            || cell.eq_ignore_ascii_case("nan")
    })
}

/// What a column is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Time,
    Load(usize),
    Other,
}

/// A name in a header.
#[derive(Debug, Clone)]
struct Name {
    /// As it is written, without its unit.
    own: String,
    unit: Option<String>,
    role: Role,
}

fn role(name: &str) -> Role {
    let name = name.to_lowercase().replace(['_', ' '], "-");
    if TIMES.contains(&name.as_str()) {
        return Role::Time;
    }
    let is_of = |(own, others, ..): &(&str, &[&str], Kind, Excitation)| {
        *own == name || others.contains(&name.as_str())
    };
    if let Some(load) = LOADS.iter().position(is_of) {
        return Role::Load(load);
    }
    // One of several: acc-x, acc1, acceleration-ns.
    let direction = ["acceleration", "accel", "acc"].into_iter().find_map(|stem| name.strip_prefix(stem));
    match direction {
        Some(rest) if rest.starts_with(|c: char| !c.is_alphabetic()) => Role::Load(0),
        _ => Role::Other,
    }
}

/// Whether a word behind the name of a column is its unit: “acc N” is a direction.
fn fits(role: Role, unit: &str) -> bool {
    Reader::is_unit(unit)
        && match role {
            Role::Other => false,
            Role::Load(0) => unit.contains('/') || matches!(unit, "g" | "mg" | "gal" | "Gal"),
            Role::Time | Role::Load(_) => true,
        }
}

impl Name {
    fn new(header: &str) -> Self {
        let (own, unit) = name_and_unit(header);
        let mut name = Self { own: own.to_owned(), unit: unit.map(str::to_owned), role: role(own) };
        // “Time s”, “acc_g”.
        if name.unit.is_none()
            && let Some((stem, last)) = own.rsplit_once([' ', '_', ','])
            && let stem = stem.trim_end_matches([' ', ','])
            && fits(role(stem), &text::unit(last))
        {
            name = Self { own: stem.to_owned(), unit: Some(last.to_owned()), role: role(stem) };
        }
        name
    }
}

/// The columns that are read.
struct Columns {
    time: Option<usize>,
    load: usize,
    /// The excitation and the unit of the load; without one, a value may have its own.
    excitation: Excitation,
    kind: Kind,
    unit: Option<Unit>,
    /// The unit of the time other than the second.
    second: Option<Unit>,
    channel: Option<String>,
    unused: Vec<String>,
    name: String,
    /// Every number is a sample.
    all: bool,
}

pub(super) fn read<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
    known: Known,
) -> Result<Reading<F>, String> {
    let mut titles: Vec<Line> = Vec::new();
    let mut remark: Option<String> = None;
    let first = loop {
        let Some((number, line)) = lines.next()? else { break None };
        if line.trim().is_empty() {
            continue;
        }
        if let Some(text) = comment(&line) {
            remark = Some(text.trim().to_owned());
            continue;
        }
        if is_row(&line) {
            break Some((number, line));
        }
        if titles.len() >= MOST_TITLES {
            return Err(options.at(number, "no row of numbers in 200 lines"));
        }
        titles.push((number, line));
    };
    let delimiter = first.as_ref().map_or(Delimiter::Sign(','), |(_, row)| Delimiter::of(row));
    let mut cells = Vec::new();
    if let Some((_, row)) = &first {
        delimiter.cells(row, &mut cells);
        Delimiter::without_last(&mut cells);
    }
    let width = cells.len();
    let names = if known.names.is_empty() {
        header(&titles, remark.as_deref(), width)
    } else {
        known.names.iter().map(|name| Name::new(name)).collect()
    };
    if names.is_empty() && first.is_none() {
        return Err(format!("{}: has no samples", options.name));
    }
    let title = titles.last().map(|(_, text)| text.clone()).unwrap_or_default();
    let columns = if names.is_empty() {
        unnamed(width, options, &known)?
    } else {
        named(&names, &title, options, &known)?
    };
    match (columns.time, options.time_step) {
        (None, None) => {
            return Err(format!(
                "{}: has no column time. Give the time between samples by {}",
                options.name, options.words.time_step
            ));
        }
        (Some(_), Some(_)) => {
            return Err(format!(
                "{}: must be left out, because {} has a column time",
                options.words.time_step, options.name
            ));
        }
        _ => {}
    }
    let due = if names.is_empty() { width } else { names.len() };
    rows(lines, first, delimiter, due, columns, options, known.kind)
}

/// The names of the columns and their units: the last line without numbers that has a name of a time or of a load, or else
/// the last one; the line below may have the units.
fn header(titles: &[Line], remark: Option<&str>, width: usize) -> Vec<Name> {
    let of = |text: &str| -> Vec<Name> {
        Delimiter::names(text, width).iter().map(|name| Name::new(name)).collect()
    };
    let is_known = |names: &Vec<Name>| names.iter().any(|name| name.role != Role::Other);
    let mut rows = titles.iter().rev().map(|(_, text)| of(text));
    let Some(last) = rows.next() else {
        // The header of a table may be a comment, which then names a time or a unit: “# a comment” does not.
        let is_header = |names: &Vec<Name>| {
            names.len() == width
                && is_known(names)
                && names.iter().any(|name| name.role == Role::Time || name.unit.is_some())
        };
        let names = remark.map(of).filter(is_header);
        return names.unwrap_or_default();
    };
    if is_known(&last) {
        return last;
    }
    let Some(mut before) = rows.find(is_known) else { return last };
    let units = titles.last().map(|(_, text)| Delimiter::names(text, width)).unwrap_or_default();
    let bare = |unit: &str| text::unit(unit);
    if units.len() == before.len() && units.iter().all(|unit| unit.is_empty() || Reader::is_unit(&bare(unit)))
    {
        for (name, unit) in before.iter_mut().zip(units) {
            if name.unit.is_none() && !unit.is_empty() {
                name.unit = Some(bare(&unit));
            }
        }
    }
    before
}

/// The columns of a table with names.
fn named<F: Float + FromStr>(
    names: &[Name],
    title: &str,
    options: &Options<'_, F>,
    known: &Known,
) -> Result<Columns, String> {
    let file = options.name;
    let time = names.iter().position(|name| name.role == Role::Time);
    let is_load =
        |name: &Name| matches!(name.role, Role::Load(_)) || (known.unit.is_some() && name.role != Role::Time);
    let loads: Vec<usize> =
        (0..).zip(names).filter(|(_, name)| is_load(name)).map(|(place, _)| place).collect();
    let listed = |places: &[usize]| {
        let names: Vec<_> = places.iter().filter_map(|place| Some(names.get(*place)?.own.as_str())).collect();
        names.join(", ")
    };
    let load = match (options.column, loads.as_slice()) {
        (Some(column), _) => chosen(names, column).ok_or_else(|| {
            let all: Vec<usize> = (0..names.len()).collect();
            format!("{} {column}: must be a column of {file}: {}", options.words.column, listed(&all))
        })?,
        (None, [one]) => *one,
        (None, []) => {
            let spelt = LOADS.iter().map(|(name, ..)| *name).chain(["time"]);
            for name in names.iter().filter(|name| name.role == Role::Other) {
                if let Some(known) = spelt.clone().find(|known| is_misspelt(&name.own, known)) {
                    return Err(format!(
                        "{file}: column {} is unknown. Spell it {known}, or rename it",
                        name.own
                    ));
                }
            }
            let spelt: Vec<_> = LOADS.iter().map(|(name, ..)| *name).collect();
            return Err(format!(
                "{file}: a column of the load is missing in the header “{title}”. Name one of {}, such as \
                 acceleration[g], or choose one by {}",
                spelt.join(", "),
                options.words.column
            ));
        }
        (None, many) => {
            return Err(format!(
                "{file}: has the columns {}. Choose one by {}",
                listed(many),
                options.words.column
            ));
        }
    };
    let name = names.get(load).ok_or_else(|| format!("{file}: no load"))?;
    let at = format!("{file}: column {}", name.own);
    let of_role = match name.role {
        Role::Load(index) => LOADS.get(index).map(|(own, _, kind, excitation)| (*own, *kind, *excitation)),
        Role::Time => return Err(format!("{at}: must be a load, not the time")),
        Role::Other => None,
    };
    let kind = of_role.map(|(_, kind, _)| kind);
    let unit = match (&known.unit, &name.unit, options.units) {
        (Some(unit), ..) => Some(unit.clone()),
        (None, Some(_), Some(typed)) => {
            return Err(format!(
                "{} {typed}: must be left out, because {at} has a unit",
                options.words.units
            ));
        }
        (None, Some(unit), None) => Some(Unit::new(&at, unit, options.reader, kind)?),
        (None, None, Some(typed)) => Some(Unit::new(options.words.units, typed, options.reader, kind)?),
        (None, None, None) if of_role.is_none() => {
            return Err(format!("{at}: has no unit. Give it by {}, such as g", options.words.units));
        }
        (None, None, None) => None,
    };
    let excitation = of_role.map(|(.., excitation)| excitation);
    let excitation = excitation.or_else(|| unit.as_ref().map(Unit::excitation));
    let second = match time.and_then(|time| names.get(time)?.unit.as_ref()) {
        Some(unit) => {
            Some(Unit::new(&format!("{file}: column time"), unit, options.reader, Some(Kind::Time))?)
        }
        None => None,
    };
    let is_used = |place: &usize| *place == load || Some(*place) == time;
    let unused = (0..names.len())
        .filter(|place| !is_used(place))
        .filter_map(|place| Some(names.get(place)?.own.clone()));
    Ok(Columns {
        time,
        load,
        excitation: excitation.unwrap_or(Excitation::SurfaceAcceleration),
        kind: unit.as_ref().map(|unit| unit.kind).or(kind).unwrap_or(Kind::Acceleration),
        unit,
        second,
        channel: Some(name.own.clone()),
        unused: if options.column.is_some() { Vec::new() } else { unused.collect() },
        name: of_role.map_or_else(|| name.own.clone(), |(own, ..)| own.to_owned()),
        all: false,
    })
}

/// The column of a name or of a number from 1.
fn chosen(names: &[Name], column: &str) -> Option<usize> {
    let column = column.trim();
    let own = Name::new(column).own;
    let same = |name: &Name| name.own.eq_ignore_ascii_case(&own);
    names.iter().position(same).or_else(|| {
        let place = column.parse::<usize>().ok()?.checked_sub(1)?;
        names.get(place).map(|_| place)
    })
}

/// The columns of a table without names.
fn unnamed<F: Float + FromStr>(
    width: usize,
    options: &Options<'_, F>,
    known: &Known,
) -> Result<Columns, String> {
    let file = options.name;
    let has_step = options.time_step.is_some();
    let all = options.column.is_some_and(|column| column.trim().eq_ignore_ascii_case("all"));
    let load = match options.column.map(str::trim) {
        Some(_) if all => 0,
        Some(column) => {
            let place = column.parse::<usize>().ok().filter(|place| (1..=width).contains(place));
            place.and_then(|place| place.checked_sub(1)).ok_or_else(|| {
                format!(
                    "{} {column}: must be a number from 1 to {width}, or all, because the columns of {file} have no names",
                    options.words.column
                )
            })?
        }
        None if width == 1 => 0,
        None if width == 2 && !has_step => 1,
        None => {
            return Err(format!(
                "{file}: has {width} columns without names. Choose one by {}, such as {width}, or all, row by row",
                options.words.column
            ));
        }
    };
    let time = (!has_step && !all && width > 1).then_some(0);
    if time == Some(load) {
        return Err(format!(
            "{} 1: must be a load, because the first column is the time",
            options.words.column
        ));
    }
    let unit = match (&known.unit, options.units) {
        (Some(unit), _) => unit.clone(),
        (None, Some(typed)) => Unit::new(options.words.units, typed, options.reader, None)?,
        (None, None) => {
            return Err(format!("{file}: states no unit. Give it by {}, such as g", options.words.units));
        }
    };
    let channel = options.column.map(|column| format!("column {}", column.trim()));
    Ok(Columns {
        time,
        load,
        excitation: unit.excitation(),
        kind: unit.kind,
        unit: Some(unit),
        second: None,
        channel: channel.filter(|_| !all),
        unused: Vec::new(),
        name: "the load".to_owned(),
        all,
    })
}

/// Reads the rows from the first one on.
fn rows<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    first: Option<Line>,
    delimiter: Delimiter,
    width: usize,
    columns: Columns,
    options: &Options<'_, F>,
    layout: &'static str,
) -> Result<Reading<F>, String> {
    // Without a unit of the column, values are in the system of the reader, or each has its own.
    let own_unit =
        || Unit { name: options.reader.system().name(columns.kind), factor: None, kind: columns.kind };
    let unit = columns.unit.clone().unwrap_or_else(own_unit);
    let (mut samples, mut times) = (Samples::new(unit), Vec::<F>::new());
    if let Some(first) = first {
        lines.put_back(first);
    }
    while let Some((number_of_line, row)) = lines.next()? {
        if row.trim().is_empty() || comment(&row).is_some() {
            continue;
        }
        let at = |what: &str| options.at(number_of_line, what);
        let mut cells = Vec::with_capacity(width);
        delimiter.cells(&row, &mut cells);
        if cells.len() > width || columns.all {
            Delimiter::without_last(&mut cells);
        }
        if columns.all {
            for cell in &cells {
                let value =
                    number(cell, delimiter).ok_or_else(|| at(&format!("{cell}: must be a number")))?;
                samples.push(value).map_err(|what| at(&what))?;
            }
            continue;
        }
        if cells.len() != width && !(cells.len() > width && delimiter == Delimiter::Blanks) {
            let is_more = cells.len() > width && delimiter == Delimiter::Sign(',');
            let hint = if is_more { ". A decimal needs a point, because commas separate fields" } else { "" };
            return Err(at(&format!("{} fields, must be {width} as above{hint}", cells.len())));
        }
        let cell = |place: usize, name: &str| -> Result<&str, String> {
            let cell = cells.get(place).copied().unwrap_or_default();
            if cell.is_empty() { Err(at(&format!("{name}: is missing"))) } else { Ok(cell) }
        };
        let text = cell(columns.load, &columns.name)?;
        let pushed = match (&columns.unit, number::<F>(text, delimiter)) {
            (Some(_), Some(value)) => samples.push(value),
            (Some(_), None) => return Err(at(&format!("{}: {text}: must be a number", columns.name))),
            (None, _) => {
                let named = options.at(number_of_line, &columns.name);
                samples.push(options.reader.value::<F>(&named, text, columns.kind)?)
            }
        };
        pushed.map_err(|what| at(&format!("{}: {what}", columns.name)))?;
        if let Some(place) = columns.time {
            let text = cell(place, "time")?;
            let time = match (number::<F>(text, delimiter), &columns.second) {
                (Some(time), Some(second)) => second.times(time),
                (Some(time), None) => time,
                (None, None) if Reader::has_unit(text) => {
                    options.reader.value::<F>(&options.at(number_of_line, "time"), text, Kind::Time)?
                }
                (None, _) => return Err(at(&format!("time: {text}: must be a number"))),
            };
            let step = times.last().map(|before| time - *before).filter(|step| *step < F::int(0));
            if let Some(step) = step {
                return Err(at(&format!("time step = {step} s: must be ≥ 0 s")));
            }
            if times.iter().rev().take_while(|before| **before == time).count() > 1 {
                return Err(at("time step = 0 s: must be > 0 s after two values at one time"));
            }
            times.push(time);
        }
    }
    let mut reading = {
        let Columns { channel, excitation, .. } = &columns;
        let (times, start) = match (options.time_step, even(&times)) {
            (Some(step), _) => (Times::Step(step), F::int(0)),
            (None, Some((start, step))) => (Times::Step(step), start),
            (None, None) => (Times::Each(times), F::int(0)),
        };
        samples.finish(layout, channel.clone(), *excitation, times, start, options)?
    };
    reading.unused = columns.unused;
    Ok(reading)
}

/// The first time and the step, if the times are equally spaced but for the rounding of the numbers that they are read
/// into.
fn even<F: Float + FromStr>(times: &[F]) -> Option<(F, F)> {
    let (&first, &last) = (times.first()?, times.last()?);
    let count = times.len().checked_sub(1).filter(|count| *count > 0)?;
    let step = (last - first) / F::from_f64(count as f64);
    // A time has a rounding of its own and perhaps one of its unit; a place has those of the step, its product and its sum.
    let rounding = (first.abs() + last.abs()) * F::epsilon() * F::int(4);
    let near = |(index, time): (usize, &F)| {
        let place = first + step * F::from_f64(index as f64);
        (*time - place).abs() <= rounding
    };
    (step > F::int(0) && times.iter().enumerate().all(near)).then_some((first, step))
}
