//! Parquet files: a column for each value of a record, and a row group whenever enough rows are in memory.

mod column;

use crate::args::Header;
use crate::failure::{Failure, Outcome};
use crate::row::Row;
use column::ParquetColumn;
pub(crate) use column::{ends, equals};
use parquet::basic::Compression;
use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::{self, Write};
use std::sync::Arc;

/// The greatest number of rows in a group.
const ROWS: usize = 1 << 17;
/// The approximate greatest size of a group in memory, whatever the precision of its numbers.
const BYTES: usize = 1 << 26;

/// The note on the units of columns without a unit in their names.
pub(crate) fn units_note() -> KeyValue {
    let units = "lengths r_y/k, velocities r_y/k ω_d, energies r_y²/k, phases rad, and a unit in brackets where a column has its own";
    KeyValue::new("units".to_owned(), units.to_owned())
}

/// A writer of row groups.
pub(crate) fn writer<W: Write + Send>(
    out: W,
    schema: Arc<Type>,
    notes: Vec<KeyValue>,
) -> Result<SerializedFileWriter<W>, Failure> {
    let properties = WriterProperties::builder()
        .set_created_by(concat!("stickslip ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(notes));
    Ok(SerializedFileWriter::new(out, schema, Arc::new(properties.build()))?)
}

/// Rows in memory, which become a group of a file.
pub(crate) struct Group {
    columns: Vec<ParquetColumn>,
    pub(crate) rows: usize,
}

impl Group {
    /// No rows, with the columns of this one.
    pub(crate) fn of(row: &Row) -> Self {
        let columns = row.names(Header::Names).into_iter().zip(row.cells());
        Self {
            columns: columns.map(|(name, cell)| ParquetColumn::of(name, &cell, row.is_wide())).collect(),
            rows: 0,
        }
    }

    /// The schema of a file with these columns.
    pub(crate) fn schema(&self) -> Result<Arc<Type>, ParquetError> {
        let fields = self.columns.iter().map(|column| column.field().map(Arc::new));
        let fields = fields.collect::<Result<_, _>>()?;
        // Resumed files hold this name.
        Ok(Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?))
    }

    pub(crate) fn push(&mut self, row: &Row) {
        self.columns.iter_mut().zip(row.cells()).for_each(|(column, cell)| column.push(&cell));
        self.rows += 1;
    }

    /// Takes some of so many rows of a file, and returns their number, so that the memory is bounded.
    pub(crate) fn read(&mut self, readers: &mut [ColumnReader], most: usize) -> Result<usize, ParquetError> {
        let count = most.min(ROWS - self.rows).min(1 << 12);
        self.columns.iter_mut().zip(readers).try_for_each(|(column, reader)| column.read(reader, count))?;
        self.rows += count;
        Ok(count)
    }

    /// Whether the rows suffice for a group.
    pub(crate) fn is_full(&self) -> bool {
        self.rows >= ROWS || self.columns.iter().map(ParquetColumn::bytes).sum::<usize>() >= BYTES
    }

    /// Writes the rows, if there are any. They are taken even if the write fails: the columns are then no longer
    /// complete.
    pub(crate) fn write<W: Write + Send>(&mut self, writer: &mut SerializedFileWriter<W>) -> Outcome {
        if std::mem::take(&mut self.rows) == 0 {
            return Ok(());
        }
        let mut group = writer.next_row_group()?;
        for column in &mut self.columns {
            let Some(mut writer) = group.next_column()? else { break };
            column.write(writer.untyped())?;
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }
}

/// A stream of rows that becomes a Parquet file. Encoded groups wait in memory until they are taken.
pub(crate) struct ParquetStream {
    writer: SerializedFileWriter<Vec<u8>>,
    group: Group,
}

impl ParquetStream {
    /// A stream of rows like this one.
    pub(crate) fn new(row: &Row) -> Result<Self, Failure> {
        let group = Group::of(row);
        Ok(Self { writer: writer(Vec::new(), group.schema()?, vec![units_note()])?, group })
    }

    /// Adds a row, and writes the bytes that are complete.
    pub(crate) fn write(&mut self, row: &Row, out: &mut impl Write) -> Outcome {
        self.group.push(row);
        if !self.group.is_full() {
            return Ok(());
        }
        self.group.write(&mut self.writer)?;
        self.writer.flush()?;
        self.hand_on(out)
    }

    /// Writes the remaining rows and the end of the file.
    pub(crate) fn finish(&mut self, out: &mut impl Write) -> Outcome {
        self.group.write(&mut self.writer)?;
        self.writer.finish()?;
        self.hand_on(out)
    }

    /// The writer counts its bytes itself, so that they need not stay in memory.
    fn hand_on(&mut self, out: &mut impl Write) -> Outcome {
        Ok(out.write_all(&std::mem::take(self.writer.inner_mut()))?)
    }
}

impl From<ParquetError> for Failure {
    fn from(error: ParquetError) -> Self {
        if let ParquetError::External(inner) = error {
            return match inner.downcast::<io::Error>() {
                Ok(system) => Self::from(*system),
                Err(other) => Self::System(io::Error::other(other)),
            };
        }
        Self::System(io::Error::other(error))
    }
}
