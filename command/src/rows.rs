//! The rows of a file or of standard input, in bounded memory, and the names of their columns.

use crate::columns;
use crate::failure::{Failure, Outcome};
use csv::{ReaderBuilder, StringRecord, Trim};
use std::cell::Cell;
use std::fs::File;
use std::io::{self, BufRead, BufReader, ErrorKind, Read};
use std::path::Path;
use stickslip_front::text::{UTF16, is_utf16};

/// The greatest length of a row in bytes: some hundred numbers of 8192 bits.
const LONGEST_ROW: u64 = 1 << 18;

/// Opens a file; `-` is standard input.
pub(crate) fn open(file: &Path, argument: &str) -> Result<Box<dyn Read>, Failure> {
    if file == Path::new("-") {
        return Ok(Box::new(io::stdin().lock()));
    }
    let bad = |e: io::Error| format!("{argument}: {e}");
    let mut opened = BufReader::new(File::open(file).map_err(bad)?);
    // An error of reading is that of the reader.
    if opened.fill_buf().is_ok_and(is_utf16) {
        return Err(format!("{argument}: {UTF16}").into());
    }
    Ok(Box::new(opened))
}

/// The number of bytes read since the last complete row.
#[derive(Default)]
pub(crate) struct Ahead(Cell<u64>);

impl Ahead {
    /// Subtracts the length of a complete row.
    fn complete(&self, length: u64) {
        self.0.set(self.0.get() - length);
    }
}

/// A source that fails on a row without an end.
pub(crate) struct Bounded<'a, R> {
    pub(crate) source: R,
    pub(crate) ahead: &'a Ahead,
}

impl<R: Read> Read for Bounded<'_, R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let Ahead(ahead) = self.ahead;
        if ahead.get() > LONGEST_ROW {
            let text = format!("the length of a row must be ≤ {LONGEST_ROW} bytes");
            return Err(io::Error::new(ErrorKind::InvalidData, text));
        }
        let count = self.source.read(bytes).map_err(|e| {
            // A call that a signal interrupted is repeated.
            let again = e.kind() == ErrorKind::Interrupted;
            if again { e } else { io::Error::new(ErrorKind::InvalidData, e.to_string()) }
        })?;
        ahead.set(ahead.get() + count as u64);
        Ok(count)
    }
}

/// A table and its header.
pub(crate) fn table<R: Read>(source: R, name: &str) -> Result<(csv::Reader<R>, StringRecord), Failure> {
    let mut table = ReaderBuilder::new().trim(Trim::All).from_reader(source);
    let header = table.headers().map_err(|e| unreadable(name, e))?.clone();
    Ok((table, header))
}

/// Takes each row with its line.
pub(crate) fn each(
    table: &mut csv::Reader<impl Read>,
    name: &str,
    ahead: &Ahead,
    mut take: impl FnMut(&StringRecord, u64) -> Outcome,
) -> Outcome {
    let mut row = StringRecord::new();
    let mut begin = table.position().byte();
    ahead.complete(begin);
    while table.read_record(&mut row).map_err(|e| unreadable(name, e))? {
        let end = table.position().byte();
        ahead.complete(end - begin);
        begin = end;
        take(&row, row.position().map_or(0, csv::Position::line))?;
    }
    Ok(())
}

/// The failure for input that the reader cannot parse as a row.
fn unreadable(name: &str, error: csv::Error) -> Failure {
    let text = columns::unreadable(name, &error);
    if let csv::ErrorKind::Io(error) = error.into_kind()
        && error.kind() != ErrorKind::InvalidData
    {
        // A closed pipe or a full disk is not an error of the input.
        return error.into();
    }
    Failure::Input(text)
}
