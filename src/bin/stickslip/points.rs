//! Many points from a file or standard input, answered row by row in bounded memory.

use crate::args::Format;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::number;
use crate::interrupt;
use crate::record::Record;
use crate::sink::Sink;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::cell::RefCell;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;
use stickslip::Error;

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
    let outcome = answer_all(FlushFirst { source, sink: &sink }, &name, columns, &sink, answer);
    sink.borrow_mut().flush()?;
    outcome
}

fn answer_all<F: Value, const N: usize, W: Write>(
    source: impl Read,
    name: &str,
    columns: [&str; N],
    sink: &RefCell<Sink<W>>,
    answer: impl Fn([F; N]) -> Result<Record<F>, Error>,
) -> Outcome {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(source);
    let header = reader.headers().map_err(|e| unreadable(name, e))?.clone();
    let mut places = [0; N];
    for (place, column) in places.iter_mut().zip(columns) {
        *place = header.iter().position(|h| h.trim_start_matches('\u{feff}') == column).ok_or_else(|| {
            let found = header.iter().collect::<Vec<_>>().join(",");
            Failure::Input(format!("{name}: column {column} is missing; the header is “{found}”"))
        })?;
    }
    let mut row = StringRecord::new();
    while reader.read_record(&mut row).map_err(|e| unreadable(name, e))? {
        let line = row.position().map_or(0, csv::Position::line);
        let mut values = [F::int(0); N];
        for ((value, place), column) in values.iter_mut().zip(places).zip(columns) {
            let text = row.get(place).unwrap_or_default();
            *value = number(&format!("{name} line {line}: {column}"), text)?;
        }
        let record = answer(values).map_err(|e| Failure::Input(format!("{name} line {line}: {e}")))?;
        sink.borrow_mut().write(&record)?;
        interrupt::check()?;
    }
    Ok(())
}

/// What the reader could not make a row of.
fn unreadable(name: &str, error: csv::Error) -> Failure {
    let line = error.position().map_or(String::new(), |p| format!(" line {}", p.line()));
    Failure::Input(if let csv::ErrorKind::UnequalLengths { expected_len, len, .. } = error.kind() {
        format!("{name}{line}: {len} fields, must be {expected_len} as in the header")
    } else {
        format!("{name}{line}: {error}")
    })
}

/// Flushes the answers before each wait for more input, so that a live pipe sees them at once.
struct FlushFirst<'a, R, W: Write> {
    source: R,
    sink: &'a RefCell<Sink<W>>,
}

impl<R: Read, W: Write> Read for FlushFirst<'_, R, W> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.sink.borrow_mut().flush()?;
        self.source.read(bytes)
    }
}
