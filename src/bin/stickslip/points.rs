//! Many points from a file or standard input, answered row by row in bounded memory.

use crate::args::Format;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::number;
use crate::interrupt;
use crate::progress;
use crate::record::Record;
use crate::sink::Sink;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::cell::{Cell, RefCell};
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::path::Path;
use stickslip::Error;

/// Bytes of a row, at most: some hundred numbers of 8192 bits.
const LONGEST_ROW: u64 = 1 << 18;

/// Answers each row of `file` with the record that `answer` makes of its `columns`.
///
/// At a row that cannot be answered it stops: the rows before it are written whole, and the failure names the
/// line and the value.
pub(crate) fn run<F: Value, const N: usize>(
    file: &Path,
    format: Option<Format>,
    columns: [&str; N],
    out: &mut impl Write,
    answer: impl Fn([F; N]) -> Result<Record<F>, Error>,
) -> Outcome {
    let name = file.display().to_string();
    let source: Box<dyn Read> = if file == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(file).map_err(|e| Failure::Input(format!("--points {name}: {e}")))?)
    };
    let sink = RefCell::new(match format.unwrap_or(Format::Jsonl) {
        Format::Jsonl => Sink::lines(out),
        Format::Csv => Sink::rows(out),
        Format::Text | Format::Json => {
            return Err(Failure::Input("--format: the answer to --points is jsonl or csv".to_owned()));
        }
    });
    let ahead = Cell::new(0);
    let source = FlushFirst { source, sink: &sink, ahead: &ahead };
    let outcome = answer_all(source, &ahead, &name, columns, &sink, answer);
    sink.borrow_mut().flush()?;
    outcome
}

fn answer_all<F: Value, const N: usize, W: Write>(
    source: impl Read,
    ahead: &Cell<u64>,
    name: &str,
    columns: [&str; N],
    sink: &RefCell<Sink<W>>,
    answer: impl Fn([F; N]) -> Result<Record<F>, Error>,
) -> Outcome {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(source);
    let header = reader.headers().map_err(|e| unreadable(name, e))?.clone();
    let mut places = [0; N];
    for (place, column) in places.iter_mut().zip(columns) {
        *place = place_of(column, &header, name)?;
    }
    let counted = progress::counter("points");
    let mut row = StringRecord::new();
    let mut begin = reader.position().byte();
    ahead.set(ahead.get() - begin);
    let mut any = false;
    while reader.read_record(&mut row).map_err(|e| unreadable(name, e))? {
        let end = reader.position().byte();
        ahead.set(ahead.get() - (end - begin));
        begin = end;
        let line = row.position().map_or(0, csv::Position::line);
        let mut values = [F::int(0); N];
        for ((value, place), column) in values.iter_mut().zip(places).zip(columns) {
            let text = row.get(place).unwrap_or_default();
            *value = number(&format!("{name} line {line}: {column}"), text)?;
        }
        let record = answer(values).map_err(|e| Failure::Input(format!("{name} line {line}: {e}")))?;
        sink.borrow_mut().write(&record)?;
        any = true;
        counted.inc(1);
        interrupt::check()?;
    }
    if !any {
        // Rows without a point still have a header.
        let some = answer([F::int(2); N]).map_err(|e| Failure::Input(e.to_string()))?;
        sink.borrow_mut().write_header(&some)?;
    }
    Ok(())
}

/// The one place of a column in the header.
fn place_of(column: &str, header: &StringRecord, name: &str) -> Result<usize, Failure> {
    let is = |found: &str| found.trim_start_matches('\u{feff}') == column;
    let mut places = header.iter().enumerate().filter(|(_, found)| is(found)).map(|(place, _)| place);
    match (places.next(), places.next()) {
        (Some(place), None) => Ok(place),
        (Some(_), Some(_)) => Err(Failure::Input(format!("{name}: column {column} must be there once only"))),
        (None, _) => {
            let found = header.iter().collect::<Vec<_>>().join(",");
            Err(Failure::Input(format!("{name}: column {column} is missing; the header is “{found}”")))
        }
    }
}

/// What the reader could not make a row of.
fn unreadable(name: &str, error: csv::Error) -> Failure {
    let line = error.position().map_or(String::new(), |p| format!(" line {}", p.line()));
    let text = if let csv::ErrorKind::UnequalLengths { expected_len, len, .. } = error.kind() {
        format!("{len} fields, must be {expected_len} as in the header")
    } else {
        error.to_string()
    };
    let fault = Failure::Input(format!("{name}{line}: {text}"));
    if let csv::ErrorKind::Io(error) = error.into_kind()
        && error.kind() != ErrorKind::InvalidData
    {
        // Answers that nobody reads, or has room for, are no fault of the input.
        return error.into();
    }
    fault
}

/// Flushes the answers before each wait for more input, so that a live pipe sees them at once; and gives up on a row
/// that does not end.
struct FlushFirst<'a, R, W: Write> {
    source: R,
    sink: &'a RefCell<Sink<W>>,
    /// Bytes that were read since the last whole row.
    ahead: &'a Cell<u64>,
}

impl<R: Read, W: Write> Read for FlushFirst<'_, R, W> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        if self.ahead.get() > LONGEST_ROW {
            let text = format!("a row of more than {LONGEST_ROW} bytes; must be ≤ {LONGEST_ROW}");
            return Err(io::Error::new(ErrorKind::InvalidData, text));
        }
        self.sink.borrow_mut().flush()?;
        let count = self.source.read(bytes).map_err(|e| {
            // A call that a signal broke off is made again.
            let again = e.kind() == ErrorKind::Interrupted;
            if again { e } else { io::Error::new(ErrorKind::InvalidData, e.to_string()) }
        })?;
        self.ahead.set(self.ahead.get() + count as u64);
        Ok(count)
    }
}
