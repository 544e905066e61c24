//! Many points from a file or standard input, answered row by row in bounded memory.

use crate::args::{Format, Header, OutputArgs};
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter};
use crate::input::number;
use crate::interrupt;
use crate::progress;
use crate::record::Record;
use crate::rows::{self, Ahead, Bounded, is_misspelt, name_and_unit, unreadable};
use crate::sink::Sink;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::cell::RefCell;
use std::io::{self, Read, Write};
use std::path::Path;
use stickslip::units::{Factor, Reader};

/// The request for a file of points.
pub(crate) struct Asked<'a, F> {
    pub(crate) file: &'a Path,
    pub(crate) output: &'a OutputArgs,
    pub(crate) reader: &'a Reader,
    /// The quantities that all rows share.
    pub(crate) given: Given<F>,
    /// The columns that are read; all others are ignored.
    pub(crate) used: &'a [Parameter],
    /// The columns that a file of ratios requires.
    pub(crate) ratios: &'a [Parameter],
}

/// Answers each row of a file with the record that `answer` makes of its quantities.
///
/// It stops at a row that cannot be answered: the rows before it are complete, and the failure names the line
/// and the value.
pub(crate) fn run<F: Value>(
    asked: Asked<'_, F>,
    out: &mut impl Write,
    answer: impl Fn(&Given<F>) -> Result<Record<F>, Failure>,
) -> Outcome {
    let Asked { file, output, .. } = asked;
    let name = file.display().to_string();
    let source = rows::open(file, &format!("--points {name}"))?;
    let sink = RefCell::new(match output.format.unwrap_or(Format::Jsonl) {
        Format::Jsonl => Sink::lines(out),
        Format::Csv => Sink::rows(out, output.header),
        Format::Text | Format::Json => {
            return Err(Failure::Input("--format: the answer to --points is jsonl or csv".to_owned()));
        }
    });
    let ahead = Ahead::default();
    let source = FlushFirst { source: Bounded { source, ahead: &ahead }, sink: &sink };
    let outcome = answer_all(source, &ahead, &name, asked, &sink, answer);
    sink.borrow_mut().flush()?;
    outcome
}

/// A column that is read.
struct Column {
    parameter: Parameter,
    place: usize,
    name: String,
    /// The factor of the unit in its header; without one, a value may have its own unit.
    factor: Option<Factor>,
}

impl Column {
    fn value<F: Value>(&self, reader: &Reader, name: &str, text: &str) -> Result<F, Failure> {
        match self.factor {
            Some(factor) => Ok(factor.times(number(name, text)?)),
            None => Ok(reader.value(name, text, self.parameter.kind())?),
        }
    }
}

fn answer_all<F: Value, W: Write>(
    source: impl Read,
    ahead: &Ahead,
    name: &str,
    asked: Asked<'_, F>,
    sink: &RefCell<Sink<W>>,
    answer: impl Fn(&Given<F>) -> Result<Record<F>, Failure>,
) -> Outcome {
    let Asked { mut given, used, ratios, reader: units, output, .. } = asked;
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(source);
    let header = reader.headers().map_err(|e| unreadable(name, e))?.clone();
    let columns = columns(&header, name, used, &given, units)?;
    let has = |p: Parameter| given.has(p) || columns.iter().any(|column| column.parameter == p);
    let is_machine = used.iter().any(|p| p.is_physical() && has(*p));
    let needed: Vec<&[Parameter]> = if is_machine {
        let is_needed = |several: &&[Parameter]| several.iter().any(|p| used.contains(p));
        Parameter::OF_A_MACHINE.into_iter().filter(is_needed).collect()
    } else {
        ratios.chunks(1).collect()
    };
    if let Some(missing) = needed.into_iter().find(|several| !several.iter().any(|p| has(*p))) {
        let found = header.iter().collect::<Vec<_>>().join(",");
        let names: Vec<_> = missing.iter().map(|p| format!("{} (or {})", p.column(), p.option())).collect();
        let hint = if header.len() == 1 && found.contains([';', '\t']) {
            "; columns must be separated by commas"
        } else {
            ""
        };
        return Err(Failure::Input(format!(
            "{name}: column {} is missing; the header is “{found}”{hint}",
            names.join(", or ")
        )));
    }
    if !is_machine && output.units.units.is_some() {
        return Err(Failure::Input(
            "--units: the file gives ratios, which have no unit; leave it out".to_owned(),
        ));
    }
    if output.header == Header::Units && output.format != Some(Format::Csv) {
        return Err(Failure::Input("--header units: only CSV has a header; add --format csv".to_owned()));
    }
    let counted = progress::counter("points");
    let mut row = StringRecord::new();
    let mut begin = reader.position().byte();
    ahead.complete(begin);
    let mut any = false;
    while reader.read_record(&mut row).map_err(|e| unreadable(name, e))? {
        let end = reader.position().byte();
        ahead.complete(end - begin);
        begin = end;
        let line = row.position().map_or(0, csv::Position::line);
        for column in &columns {
            let text = row.get(column.place).unwrap_or_default();
            let value = column.value(units, &format!("{name} line {line}: {}", column.name), text)?;
            given.set(column.parameter, value);
        }
        let placed = |failure: Failure| failure.about(&format!("{name} line {line}"));
        let record = answer(&given).map_err(placed)?;
        sink.borrow_mut().write(&record)?;
        any = true;
        counted.inc(1);
        interrupt::check()?;
    }
    if !any {
        // A file without rows still has a header, which is the same for any point.
        columns.iter().for_each(|column| given.set(column.parameter, F::int(2)));
        sink.borrow_mut().write_header(&answer(&given)?)?;
    }
    Ok(())
}

/// The columns that are read; each must occur once, and none may also be an argument.
fn columns<F: Value>(
    header: &StringRecord,
    name: &str,
    used: &[Parameter],
    given: &Given<F>,
    reader: &Reader,
) -> Result<Vec<Column>, Failure> {
    let mut columns: Vec<Column> = Vec::new();
    for (place, text) in header.iter().enumerate() {
        let (own, unit) = name_and_unit(text);
        let plain = own.replace('-', "_");
        let refused = |what: &str| Err(Failure::Input(format!("{name}: column {own} {what}")));
        let Some(&parameter) = used.iter().find(|p| p.is_column(&plain)) else {
            // A misspelt column must not be ignored silently.
            match used.iter().find(|p| is_misspelt(&plain, &p.column())) {
                Some(p) => return refused(&format!("is unknown; spell it {}, or rename it", p.column())),
                None => continue,
            }
        };
        if columns.iter().any(|column| column.parameter == parameter) {
            return refused("must be there once only");
        }
        if given.has(parameter) {
            return refused(&format!("is given by {} too; leave one of them out", parameter.option()));
        }
        let in_header =
            |unit| reader.factor_of_column(&format!("{name}: column {own}"), unit, parameter.kind());
        let factor = unit.map(in_header).transpose()?;
        columns.push(Column { parameter, place, name: own.to_owned(), factor });
    }
    Ok(columns)
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
