//! The destination of a stream of rows.

use crate::args::{Header, StreamFormat};
use crate::failure::{Failure, Outcome};
#[cfg(feature = "parquet")]
use crate::parquet_file::ParquetStream;
use crate::row::Row;
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
    pub(crate) fn new(format: StreamFormat, out: W, names: Header) -> Result<Self, Failure> {
        match format {
            StreamFormat::Jsonl => Ok(Self::Lines(out)),
            StreamFormat::Csv => {
                Ok(Self::Rows { writer: Box::new(csv::Writer::from_writer(out)), header: false, names })
            }
            StreamFormat::Text => Ok(Self::Table { out, header: false }),
            #[cfg(feature = "parquet")]
            StreamFormat::Parquet => Ok(Self::Parquet { out, stream: None }),
            #[cfg(not(feature = "parquet"))]
            StreamFormat::Parquet => Err(no_parquet()),
        }
    }

    /// Writes one row. Except for Parquet, every row is complete whenever the program ends between
    /// two calls.
    pub(crate) fn write(&mut self, row: &Row) -> Outcome {
        self.write_header(row)?;
        match self {
            Self::Lines(out) => row.write_line(out),
            Self::Rows { writer, .. } => row.write_row(writer),
            Self::Table { out, .. } => Ok(row.write_table_row(out)?),
            #[cfg(feature = "parquet")]
            Self::Parquet { out, stream } => match stream {
                Some(stream) => stream.write(row, out),
                None => stream.insert(Box::new(ParquetStream::new(row)?)).write(row, out),
            },
        }
    }

    /// Writes the header alone, if rows have one.
    pub(crate) fn write_header(&mut self, row: &Row) -> Outcome {
        match self {
            Self::Lines(_) | Self::Rows { header: true, .. } | Self::Table { header: true, .. } => Ok(()),
            Self::Rows { writer, header, names } => {
                *header = true;
                row.write_header(writer, *names)
            }
            Self::Table { out, header } => {
                *header = true;
                Ok(row.write_table_header(out)?)
            }
            #[cfg(feature = "parquet")]
            Self::Parquet { .. } => Ok(()),
        }
    }

    /// Hands on every complete row.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Lines(out) | Self::Table { out, .. } => out.flush(),
            Self::Rows { writer, .. } => writer.flush(),
            #[cfg(feature = "parquet")]
            Self::Parquet { .. } => Ok(()),
        }
    }

    /// Writes the end of a file that has one, after the last row.
    pub(crate) fn finish(&mut self) -> Outcome {
        #[cfg(feature = "parquet")]
        if let Self::Parquet { out, stream: Some(stream) } = self {
            stream.finish(out)?;
        }
        Ok(self.flush()?)
    }
}

#[cfg(not(feature = "parquet"))]
pub(crate) fn no_parquet() -> Failure {
    Failure::Input("--format parquet: needs a build with the feature parquet".to_owned())
}
