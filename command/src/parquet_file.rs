//! Parquet files: a column for each value of a record, and a row group whenever enough rows are in memory.

mod column;

use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::record::Record;
pub(crate) use column::{ParquetColumn, ends, equals};
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::{self, Write};
use std::sync::Arc;

/// The greatest number of rows in a group.
pub(crate) const ROWS: usize = 1 << 17;
/// The approximate greatest size of a group in memory, whatever the precision of its numbers.
const BYTES: usize = 1 << 26;

/// The columns of rows like this one.
pub(crate) fn columns<F: Value>(row: &Record<F>) -> Vec<ParquetColumn> {
    row.names().into_iter().zip(row.cells()).map(|(name, cell)| ParquetColumn::of(name, &cell)).collect()
}

/// Adds a row to its columns.
pub(crate) fn push<F: Value>(columns: &mut [ParquetColumn], row: &Record<F>) {
    for (column, cell) in columns.iter_mut().zip(row.cells()) {
        column.push(&cell);
    }
}

/// The note on the units of columns without a unit in their names.
pub(crate) fn units_note() -> KeyValue {
    let units = "lengths r_y/k, velocities r_y/k ω_d, energies r_y²/k, phases rad, and a unit in brackets where a column has its own";
    KeyValue::new("units".to_owned(), units.to_owned())
}

/// A writer of row groups.
pub(crate) fn writer<W: Write + Send>(
    out: W,
    columns: &[ParquetColumn],
    notes: Vec<KeyValue>,
) -> Result<SerializedFileWriter<W>, Failure> {
    let properties = WriterProperties::builder()
        .set_created_by(concat!("stickslip ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_key_value_metadata(Some(notes));
    Ok(SerializedFileWriter::new(out, schema(columns)?, Arc::new(properties.build()))?)
}

/// Whether the rows suffice for a group.
pub(crate) fn is_group(columns: &[ParquetColumn], rows: usize) -> bool {
    rows >= ROWS || columns.iter().map(ParquetColumn::bytes).sum::<usize>() >= BYTES
}

/// Writes the rows in memory as a group of the file.
pub(crate) fn write_group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    columns: &mut [ParquetColumn],
) -> Outcome {
    let mut group = writer.next_row_group()?;
    for column in columns {
        let Some(mut writer) = group.next_column()? else { break };
        column.write(writer.untyped())?;
        writer.close()?;
    }
    group.close()?;
    Ok(())
}

/// The schema of a file with these columns.
pub(crate) fn schema(columns: &[ParquetColumn]) -> Result<Arc<Type>, ParquetError> {
    let fields = columns.iter().map(|column| column.field().map(Arc::new)).collect::<Result<_, _>>()?;
    // Resumed files hold this name.
    Ok(Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?))
}

/// A stream of rows that becomes a Parquet file. Encoded groups wait in memory until they are taken.
pub(crate) struct ParquetStream {
    writer: SerializedFileWriter<Vec<u8>>,
    columns: Vec<ParquetColumn>,
    rows: usize,
}

impl ParquetStream {
    /// A stream of rows like this one.
    pub(crate) fn new<F: Value>(row: &Record<F>) -> Result<Self, Failure> {
        let columns = columns(row);
        Ok(Self { writer: writer(Vec::new(), &columns, vec![units_note()])?, columns, rows: 0 })
    }

    /// Adds a row, and writes the bytes that are complete.
    pub(crate) fn write<F: Value>(&mut self, row: &Record<F>, out: &mut impl Write) -> Outcome {
        push(&mut self.columns, row);
        self.rows += 1;
        if is_group(&self.columns, self.rows) {
            self.write_rows(out)?;
        }
        Ok(())
    }

    /// Writes the remaining rows and the end of the file.
    pub(crate) fn finish(&mut self, out: &mut impl Write) -> Outcome {
        if self.rows > 0 {
            self.write_rows(out)?;
        }
        self.writer.finish()?;
        self.hand_on(out)
    }

    fn write_rows(&mut self, out: &mut impl Write) -> Outcome {
        self.rows = 0;
        write_group(&mut self.writer, &mut self.columns)?;
        self.writer.flush()?;
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
