//! The destination of a stream of records.

use crate::args::{Header, StreamFormat};
use crate::failure::{Failure, Outcome};
#[cfg(feature = "parquet")]
use crate::parquet_file::ParquetStream;
use crate::record::Row;
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

    /// Writes one record. Except for Parquet, every record is complete whenever the program ends between
    /// two calls.
    pub(crate) fn write(&mut self, record: &Row) -> Outcome {
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
    pub(crate) fn write_header(&mut self, record: &Row) -> Outcome {
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

#[cfg(not(feature = "parquet"))]
pub(crate) fn no_parquet() -> Failure {
    Failure::Input("--format parquet: needs a build with the feature parquet".to_owned())
}
