//! The answer to one point, or to many from a file or standard input, row by row in bounded memory.

use crate::args::{Format, Header, OutputArgs, StartArgs, StreamFormat, Swept, used};
use crate::bits::Value;
use crate::columns::Column;
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::interrupt;
use crate::output;
use crate::outputs;
use crate::progress;
use crate::row::Row;
use crate::rows::{self, Ahead, Bounded};
use crate::sink::Sink;
use csv::StringRecord;
use std::cell::RefCell;
use std::io::{self, Read, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::inputs::{Given, Input, Point, Role};
use stickslip_front::names::{is_misspelt, name_and_unit};

/// The time after which answers are written, even if more are coming.
const UNSEEN: Duration = Duration::from_millis(10);

/// The request for one point, or for a file of points.
pub(crate) struct AskedPoints<'a> {
    pub(crate) question: Swept,
    pub(crate) output: &'a OutputArgs,
    /// The arguments of the start, if the command has one.
    pub(crate) start: Option<&'a StartArgs>,
}

impl AskedPoints<'_> {
    /// Answers the point of the arguments, in words by `note` or by its row, or with `--points` each row of the file.
    pub(crate) fn answered<F: Value, A, W: Write>(
        &self,
        machine: &[(Input, String)],
        out: &mut W,
        answer: impl Fn(&Given<F>, &Point<F>, &Reader) -> Result<(A, Row), Failure>,
        note: impl FnOnce(&Point<F>, &A, &Given<F>, &mut W) -> io::Result<()>,
    ) -> Outcome {
        let reader = self.output.units.reader();
        let given = input::read::<F>(machine, &reader)?;
        let answer = |given: &Given<F>| {
            let given = input::with_any_mass(given);
            let point = input::problem(self.question, &given)?;
            answer(&given, &point, &reader).map(|found| (point, found))
        };
        if let Some(file) = &self.output.points {
            return rows_of(file, self, (given, &reader), out, |given| {
                answer(given).map(|(_, (_, row))| row)
            });
        }
        let (point, (found, row)) = answer(&given)?;
        if self.output.is_json()? {
            return output::json(&row, out);
        }
        let given = input::with_any_mass(&given);
        Ok(note(&point, &found, &given, out)?)
    }
}

/// Answers each row of a file with the row that `answer` makes from its quantities.
///
/// Reading stops at a row that cannot be answered: the rows before it are complete, and the failure names the
/// line and the value.
fn rows_of<F: Value>(
    file: &Path,
    asked: &AskedPoints<'_>,
    given: (Given<F>, &Reader),
    out: &mut impl Write,
    answer: impl Fn(&Given<F>) -> Result<Row, Failure>,
) -> Outcome {
    let output = asked.output;
    let name = file.display().to_string();
    let source = rows::open(file, &format!("--points {name}"))?;
    let format = match output.format.unwrap_or(Format::Jsonl) {
        Format::Jsonl => StreamFormat::Jsonl,
        Format::Csv => StreamFormat::Csv,
        Format::Text | Format::Json => return Err("--format: must be jsonl or csv with --points".into()),
    };
    let sink = RefCell::new(Sink::new(format, out, output.header)?);
    let ahead = Ahead::default();
    let source = FlushFirst { source: Bounded { source, ahead: &ahead }, sink: &sink };
    let outcome = answer_all((source, &ahead), &name, asked, given, &sink, answer);
    sink.borrow_mut().flush()?;
    outcome
}

fn answer_all<F: Value, W: Write>(
    (source, ahead): (impl Read, &Ahead),
    name: &str,
    asked: &AskedPoints<'_>,
    (mut given, units): (Given<F>, &Reader),
    sink: &RefCell<Sink<W>>,
    answer: impl Fn(&Given<F>) -> Result<Row, Failure>,
) -> Outcome {
    let (mut table, header) = rows::table(source, name)?;
    let used = used::columns(asked.question.command());
    let (columns, is_machine) = columns(&header, name, &used, (&given, units, asked.start))?;
    let output = asked.output;
    let has = |p: Input| given.has(p) || columns.iter().any(|(own, _)| *own == p);
    let needed = if is_machine { of_a_machine() } else { vec![vec![Input::Omega], vec![Input::Alpha]] };
    let mut needed = needed.into_iter().filter(|several| several.iter().any(|p| used.contains(p)));
    if let Some(missing) = needed.find(|several| !several.iter().any(|p| has(*p))) {
        let found = header.iter().collect::<Vec<_>>().join(",");
        let names: Vec<_> = missing.iter().map(|p| format!("{} (or {})", p.column(), p.option())).collect();
        let hint = if header.len() == 1 && found.contains([';', '\t']) {
            ". Columns must be separated by commas, and decimals written with a point"
        } else {
            ""
        };
        return Err(format!(
            "{name}: column {} is missing in the header “{found}”{hint}",
            names.join(", or ")
        )
        .into());
    }
    if !is_machine && output.units.units.is_some() {
        return Err("--units: must be left out, because the file gives ratios, which have no unit".into());
    }
    if output.header == Header::Units && output.format != Some(Format::Csv) {
        return Err("--header units: needs --format csv, because only CSV has a header".into());
    }
    let counted = progress::counter("points");
    let mut flushed = Instant::now();
    let mut any = false;
    rows::each(&mut table, name, ahead, |row, line| {
        let at = format!("{name} line {line}");
        for (parameter, column) in &columns {
            given.set(*parameter, column.value(row, &at, units)?);
        }
        let row = answer(&given).map_err(|failure| failure.about(&at))?;
        sink.borrow_mut().write(&row)?;
        any = true;
        // The next row may take long.
        if flushed.elapsed() > UNSEEN {
            sink.borrow_mut().flush()?;
            flushed = Instant::now();
        }
        counted.inc(1);
        interrupt::check()
    })?;
    if !any {
        // A file without rows still has a header, which is the same for any point.
        columns.iter().for_each(|(parameter, _)| given.set(*parameter, F::int(2)));
        sink.borrow_mut().write_header(&answer(&given)?)?;
    }
    Ok(())
}

/// The inputs of a machine under its drive: one of each group.
fn of_a_machine() -> Vec<Vec<Input>> {
    let tuned = [Input::of_role(Role::Spring), vec![Input::Omega]].concat();
    let [friction, frequency, drive] = [Role::Friction, Role::Frequency, Role::Drive].map(Input::of_role);
    vec![Input::of_role(Role::Mass), tuned, friction, frequency, drive]
}

/// The columns that are read, those of `used`, and whether the columns and the arguments belong to a machine.
///
/// Each column must occur once, and none may also be an argument. A note names the columns that are not read.
fn columns<F: Value>(
    header: &StringRecord,
    name: &str,
    used: &[Input],
    (given, reader, start): (&Given<F>, &Reader, Option<&StartArgs>),
) -> Result<(Vec<(Input, Column)>, bool), Failure> {
    let known = || used.iter().copied();
    let is_typed = |p: Input| given.has(p) || start.is_some_and(|start| start.text(p).is_some());
    let (mut found, mut unread): (Vec<(Input, _)>, Vec<&str>) = (Vec::new(), Vec::new());
    for (place, text) in header.iter().enumerate() {
        let (own, unit) = name_and_unit(text);
        let plain = own.to_lowercase().replace(['-', ' '], "_");
        let refused = |what: &str| Err(format!("{name}: column {own} {what}").into());
        let by_symbol = || known().find(|p| p.letter() == Some(plain.as_str()));
        let Some(parameter) = known().find(|p| p.is_column(&plain)).or_else(by_symbol) else {
            // A misspelt column must not be ignored.
            if let Some(p) = known().find(|p| is_misspelt(&plain, &p.column())) {
                return refused(&format!("is unknown. Spell it {}, or rename it", p.column()));
            }
            // Columns of earlier answers are not inputs, and need no note.
            let is_input = Input::ALL.iter().any(|p| p.is_column(&plain));
            if is_input || outputs::find(&plain).is_none() {
                unread.push(own);
            }
            continue;
        };
        if !parameter.is_column(&plain) {
            progress::note(&format!("{name}: column {own} is read as {}", parameter.column()));
        }
        if found.iter().any(|(earlier, _)| *earlier == parameter) {
            return refused("must be there once only");
        }
        if is_typed(parameter) {
            return refused(&format!("must be left out, or {}, which gives the same", parameter.option()));
        }
        found.push((parameter, (place, own, unit)));
    }
    if !unread.is_empty() {
        let (columns, are) = if unread.len() == 1 { ("column", "is") } else { ("columns", "are") };
        progress::note(&format!("{name}: {columns} {} {are} not used", unread.join(", ")));
    }
    let has = |p: Input| given.has(p) || found.iter().any(|(own, _)| *own == p);
    let is_machine = known().any(|p| p.is_physical() && has(p));
    let columns = found.into_iter().map(|(parameter, (place, own, unit))| {
        let is_ratio = !is_machine && parameter.role() == Role::Start;
        let kind = if is_ratio { Kind::Ratio } else { parameter.kind() };
        let unit = unit.filter(|unit| kind != Kind::Ratio || !parameter.ratio_units().contains(unit));
        Ok((parameter, Column::new(name, (place, own, unit), kind, reader)?))
    });
    Ok((columns.collect::<Result<_, Failure>>()?, is_machine))
}

/// Flushes the answers before each wait for more input, so that a live pipe sees them at once.
struct FlushFirst<'a, R, W: Write> {
    source: Bounded<'a, R>,
    sink: &'a RefCell<Sink<W>>,
}

impl<R: Read, W: Write> Read for FlushFirst<'_, R, W> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.sink.borrow_mut().flush()?;
        self.source.read(bytes)
    }
}
