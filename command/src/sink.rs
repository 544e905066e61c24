//! The destination of a stream of records.

use crate::args::Header;
use crate::bits::Value;
use crate::failure::Outcome;
#[cfg(feature = "parquet")]
use crate::parquet_file::ParquetStream;
use crate::record::Record;
use std::io::{self, Write};

/// JSON lines, rows under one header of CSV or of a table for reading, or a Parquet file.
pub(crate) enum Sink<W: Write> {
    Lines(W),
    Rows {
        writer: Box<csv::Writer<W>>,
        header: bool,
        names: Header,
    },
    Table {
        out: W,
        header: bool,
    },
    #[cfg(feature = "parquet")]
    Parquet {
        out: W,
        stream: Option<Box<ParquetStream>>,
    },
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

    #[cfg(feature = "parquet")]
    pub(crate) fn parquet(out: W) -> Self {
        Self::Parquet { out, stream: None }
    }

    /// Writes one record. Except for Parquet, every record is complete whenever the program ends between
    /// two calls.
    pub(crate) fn write<F: Value>(&mut self, record: &Record<F>) -> Outcome {
        self.write_header(record)?;
        match self {
            Self::Lines(out) => record.write_line(out),
            Self::Rows { writer, .. } => record.write_row(writer),
            Self::Table { out, .. } => Ok(record.write_table_row(out)?),
            #[cfg(feature = "parquet")]
            Self::Parquet { out, stream } => match stream {
                Some(stream) => stream.write(record, out),
                None => stream.insert(Box::new(ParquetStream::new(record)?)).write(record, out),
            },
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
            #[cfg(feature = "parquet")]
            Self::Parquet { .. } => Ok(()),
        }
    }

    /// Hands on every complete record.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Lines(out) | Self::Table { out, .. } => out.flush(),
            Self::Rows { writer, .. } => writer.flush(),
            #[cfg(feature = "parquet")]
            Self::Parquet { .. } => Ok(()),
        }
    }

    /// Writes the end of a file that has one, after the last record.
    pub(crate) fn finish(&mut self) -> Outcome {
        #[cfg(feature = "parquet")]
        if let Self::Parquet { out, stream: Some(stream) } = self {
            stream.finish(out)?;
        }
        Ok(self.flush()?)
    }
}
