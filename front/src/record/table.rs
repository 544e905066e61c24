//! Columns of numbers: separated by commas, semicolons, tabs or blanks, with or without names and units, below any lines of
//! text. LabVIEW and the programs of loggers write them, too.

pub(super) mod cells;
pub(super) mod clock;
mod columns;
mod header;
mod known;

use super::lines::Line;
use super::sheet::{Found, Sheet, Times};
use super::unit::Ratio;
use super::{Unit, text};
use crate::inputs::units::{Kind, Reader};
use cells::{Delimiter, Row, comment, decimal, is_number, width};
use columns::{Columns, named, unnamed};
use header::{Name, header};
pub(super) use known::Known;

/// The most lines without numbers before the columns.
const MOST_TITLES: usize = 200;

/// The most bytes of such a line.
const LONGEST_TITLE: usize = 1 << 16;

/// The lines before the rows.
#[derive(Default)]
struct Above {
    titles: Vec<Line>,
    /// The last comment.
    remark: Option<String>,
    /// A step that a line states, and its line.
    step: Option<(u64, Times)>,
}

impl Above {
    /// Takes a line that is none of the rows.
    fn take(&mut self, (number, line): Line, reader: &Reader) {
        if let Some((digits, unit, is_rate)) = header::step(&line) {
            let factor = |kind: Kind, unit: &str| reader.factor_of_column("", unit, kind).ok();
            let times = match (is_rate, unit.as_str()) {
                (true, "" | "Hz" | "hz" | "1/s" | "S/s" | "sps" | "samples/s" | "samples/sec") => {
                    Some(Times::step("1", &digits))
                }
                (true, "kHz" | "kS/s") => Some(Times::step("0.001", &digits)),
                (false, "") => Some(Times::step(&digits, "1")),
                (false, unit) => factor(Kind::Time, &text::unit(unit))
                    .map(|factor| Times::Step(Ratio::new(&digits, "1"), Some(factor), "0".to_owned())),
                _ => None,
            };
            self.step = times.map(|times| (number, times)).or(self.step.take());
        }
        match comment(&line) {
            Some(text) => self.remark = Some(text.trim().to_owned()),
            None => self.titles.push((number, line)),
        }
    }

    /// Whether a row that begins with a word is one of the table, whose names then stand above it.
    fn has_names(&self, width: usize) -> bool {
        let names = |(_, line): &Line| Delimiter::names(line, width);
        let has_load = |names: Vec<String>| names.iter().any(|name| Name::new(name).is_load());
        self.titles.iter().map(names).any(|names| names.len() == width && has_load(names))
    }
}

/// Whether a line with numbers stands above the table: a line without any follows, and then rows of another width.
fn is_above(line: &str, next: &[Line]) -> bool {
    let mut next = next.iter().filter(|(_, line)| !line.trim().is_empty() && comment(line).is_none());
    next.next().is_some_and(|(_, line)| cells::row(line) != Row::Numbers)
        && next
            .find(|(_, line)| cells::row(line) == Row::Numbers)
            .is_some_and(|(_, row)| width(row) != width(line))
}

/// Reads the lines before the rows, and the first row.
fn above(sheet: &mut Sheet<'_>) -> Result<(Above, Option<Line>), String> {
    let mut above = Above::default();
    while let Some(line) = sheet.lines.next()? {
        if line.1.trim().is_empty() {
            continue;
        }
        let is_row = comment(&line.1).is_none()
            && match cells::row(&line.1) {
                Row::Title => false,
                Row::Labelled => above.has_names(width(&line.1)) && header::step(&line.1).is_none(),
                Row::Numbers => !is_above(&line.1, &sheet.lines.head(20)?),
            };
        if is_row {
            return Ok((above, Some(line)));
        }
        if above.titles.len() >= MOST_TITLES {
            return Err(sheet.at(line.0, "no row of numbers in 200 lines"));
        }
        if line.1.len() > LONGEST_TITLE {
            return Err(sheet.at(line.0, "must be a row of numbers, or a line of text shorter than 64 KiB"));
        }
        above.take(line, sheet.asked.reader);
    }
    Ok((above, None))
}

pub(super) fn read(sheet: &mut Sheet<'_>, known: Known) -> Result<Found, String> {
    let options = sheet.asked;
    let file = options.name;
    let (above, first) = above(sheet)?;
    let delimiter = first.as_ref().map_or(Delimiter::Sign(','), |(_, row)| Delimiter::of(row));
    let width = first.as_ref().map_or(0, |(_, row)| width(row));
    let names = if known.names.is_empty() {
        header(&above.titles, above.remark.as_deref(), width)
    } else {
        known.names.iter().map(|name| Name::new(name)).collect()
    };
    if names.is_empty() && first.is_none() {
        return Err(format!("{file}: has no samples"));
    }
    if first.is_none() && !names.iter().any(Name::is_known) {
        return Err(format!("{file}: has no row of numbers"));
    }
    let may_be_load =
        |name: &&Name| name.is_load() || (known.unit.is_some() && name.role != header::Role::Time);
    sheet.channels = names.iter().filter(may_be_load).map(|name| name.own.clone()).collect();
    let title = above.titles.last().map(|(_, text)| text.clone()).unwrap_or_default();
    let columns = if names.is_empty() {
        unnamed(width, options.time_step.is_some() || above.step.is_some(), options, &known)?
    } else {
        named(&names, &title, options, &known)?
    };
    let mut notes = Vec::new();
    let times = match (columns.time, options.time_step, above.step) {
        (None, None, None) => {
            return Err(format!(
                "{file}: has no column time. Give the time between samples by {}, or the column by {}",
                options.words.time_step, options.words.time_column
            ));
        }
        (Some(_), Some(_), _) => {
            return Err(format!(
                "{}: must be left out, because {file} has a column time",
                options.words.time_step
            ));
        }
        (Some(_), None, _) => Times::Each,
        (None, Some(_), _) => Times::Asked,
        (None, None, Some((line, times))) => {
            notes.push(format!("The step is that of line {line}."));
            times
        }
    };
    let due = if names.is_empty() { width } else { names.len() };
    let repeated = rows(sheet, first, delimiter, due, &columns)?;
    if repeated > 0 {
        notes.push(format!("{repeated} rows that repeat the one above them were left out."));
    }
    let Columns { channel, excitation, unused, .. } = columns;
    Ok(Found { channel, unused, notes, ..Found::new(known.kind, excitation, times) })
}

/// Reads the rows from the first one on. Returns the number of rows that repeat the one above them.
fn rows(
    sheet: &mut Sheet<'_>,
    first: Option<Line>,
    delimiter: Delimiter,
    width: usize,
    columns: &Columns,
) -> Result<usize, String> {
    let options = sheet.asked;
    // Without a unit of the column, values are in the system of the reader, or each has its own.
    let own_unit = || Unit {
        name: options.reader.system().name(columns.kind),
        factor: None,
        kind: columns.kind,
        scale: Ratio::one(),
    };
    sheet.sink.begin(columns.unit.clone().unwrap_or_else(own_unit));
    if let Some(first) = first {
        sheet.lines.put_back(first);
    }
    let (mut start, mut repeated) = (None, 0usize);
    let mut before = (String::new(), String::new());
    let mut sign: Option<(char, u64)> = None;
    while let Some((number, row)) = sheet.lines.next()? {
        if row.trim().is_empty() || comment(&row).is_some() {
            continue;
        }
        let at = |what: &str| options.at(number, what);
        let mut cells = Vec::with_capacity(width);
        delimiter.cells(&row, &mut cells);
        if cells.len() > width || columns.all {
            Delimiter::without_last(&mut cells);
        }
        if columns.all {
            for cell in &cells {
                if !sheet.sink.sample(&decimal(cell, delimiter)).map_err(|what| at(&what))? {
                    return Err(at(&format!("{cell}: must be a number")));
                }
            }
            continue;
        }
        let is_short = columns.has_remarks && cells.len().checked_add(1) == Some(width);
        if cells.len() != width && !is_short && !(cells.len() > width && delimiter == Delimiter::Blanks) {
            let is_more = cells.len() > width && delimiter == Delimiter::Sign(',');
            let hint = if is_more { ". A decimal needs a point, because commas separate fields" } else { "" };
            return Err(at(&format!("{} fields, must be {width} as above{hint}", cells.len())));
        }
        let cell = |place: usize, name: &str| -> Result<&str, String> {
            let cell = cells.get(place).copied().unwrap_or_default();
            if cell.is_empty() { Err(at(&format!("{name}: is missing"))) } else { Ok(cell) }
        };
        let sample = cell(columns.load, &columns.name)?;
        let time = columns.time.map(|place| cell(place, "time")).transpose()?;
        // 999.5 and 1,000 in one column: one of the two signs separates thousands, and which one is not known.
        for text in [Some(sample), time.filter(|time| clock::instant(time).is_none())].into_iter().flatten() {
            let own = text.chars().find(|c| *c == '.' || *c == ',' && delimiter != Delimiter::Sign(','));
            match (own, sign) {
                (Some(own), Some((other, line))) if own != other => {
                    return Err(at(&format!(
                        "{text}: has the sign “{own}”, and a number in line {line} “{other}”"
                    )));
                }
                (Some(own), None) => sign = Some((own, number)),
                _ => {}
            }
        }
        // A logger may write a row twice; two values at one time are a step.
        if let Some(time) = time {
            if before.0 == time && before.1 == sample {
                repeated = repeated.saturating_add(1);
                continue;
            }
            let (last_time, last_sample) = &mut before;
            time.clone_into(last_time);
            sample.clone_into(last_sample);
        }
        let named = |what: String| at(&format!("{}: {what}", columns.name));
        if columns.unit.is_none() {
            let name = options.at(number, &columns.name);
            sheet
                .sink
                .valued(&name, &decimal(sample, delimiter), columns.kind)
                .map_err(|what| if what.starts_with(&name) { what } else { named(what) })?;
        } else if !sheet.sink.sample(&decimal(sample, delimiter)).map_err(named)? {
            return Err(at(&format!("{}: {sample}: must be a number", columns.name)));
        }
        let Some(time) = time else { continue };
        let second = columns.second.as_ref().and_then(|unit| unit.factor);
        let is_time = match clock::instant(time).filter(|_| !is_number(time, delimiter)) {
            Some(instant) => {
                let start = *start.get_or_insert(instant);
                sheet.sink.time("time", &clock::seconds(instant.saturating_sub(start)), None)
            }
            None => sheet.sink.time(&options.at(number, "time"), &decimal(time, delimiter), second),
        };
        match is_time {
            Ok(true) => {}
            Ok(false) => return Err(at(&format!("time: {time}: must be a number"))),
            Err(what) if what.starts_with(options.name) => return Err(what),
            Err(what) => return Err(at(&what)),
        }
    }
    Ok(repeated)
}
