//! The destination of a stream of records.

use crate::args::Header;
use crate::bits::Value;
use crate::failure::Outcome;
use crate::record::Record;
use std::io::{self, Write};

/// JSON lines, or rows under one header, of CSV or of a table for reading.
pub(crate) enum Sink<W: Write> {
    Lines(W),
    Rows { writer: Box<csv::Writer<W>>, header: bool, names: Header },
    Table { out: W, header: bool },
}

impl<W: Write> Sink<W> {
    pub(crate) fn lines(out: W) -> Self {
        Self::Lines(out)
    }

    pub(crate) fn rows(out: W, names: Header) -> Self {
        Self::Rows { writer: Box::new(csv::Writer::from_writer(out)), header: false, names }
    }

    pub(crate) fn table(out: W) -> Self {
        Self::Table { out, header: false }
    }

    /// Writes one record. Whenever the program ends between two calls, every record is complete.
    pub(crate) fn write<F: Value>(&mut self, record: &Record<F>) -> Outcome {
        self.write_header(record)?;
        match self {
            Self::Lines(out) => record.write_line(out),
            Self::Rows { writer, .. } => record.write_row(writer),
            Self::Table { out, .. } => Ok(record.write_table_row(out)?),
        }
    }

    /// Writes the header alone, if rows have one.
    pub(crate) fn write_header<F: Value>(&mut self, record: &Record<F>) -> Outcome {
        match self {
            Self::Lines(_) | Self::Rows { header: true, .. } | Self::Table { header: true, .. } => Ok(()),
            Self::Rows { writer, header, names } => {
                *header = true;
                record.write_header(writer, *names)
            }
            Self::Table { out, header } => {
                *header = true;
                Ok(record.write_table_header(out)?)
            }
        }
    }

    pub(crate) fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Lines(out) | Self::Table { out, .. } => out.flush(),
            Self::Rows { writer, .. } => writer.flush(),
        }
    }
}
