//! The values of an output, gathered until they are written.

use crate::row::{self, Cell, Number};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::{ColumnWriter, ColumnWriterImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};
use parquet::schema::types::Type;
use std::fs::File;

/// A column of the file: the existing values, and for each row 1 if it has a value and 0 otherwise.
pub(crate) struct ParquetColumn {
    name: String,
    values: Values,
    there: Vec<i16>,
    bytes: usize,
}

enum Values {
    Doubles(Vec<f64>),
    Counts(Vec<i64>),
    Flags(Vec<bool>),
    /// Text, and numbers with more digits than a double.
    Texts(Vec<ByteArray>),
}

impl ParquetColumn {
    /// A column for cells of the same kind as `cell`.
    pub(crate) fn of(name: String, cell: &Cell<Number>, is_wide: bool) -> Self {
        let values = match cell {
            Cell::Number(_) | Cell::Pairs(_) | Cell::Intervals(_) if !is_wide => Values::Doubles(Vec::new()),
            Cell::Count(_) => Values::Counts(Vec::new()),
            Cell::Flag(_) => Values::Flags(Vec::new()),
            Cell::Number(_) | Cell::Pairs(_) | Cell::Intervals(_) | Cell::Text(_) => {
                Values::Texts(Vec::new())
            }
        };
        Self { name, values, there: Vec::new(), bytes: 0 }
    }

    /// The field in the file's schema.
    pub(crate) fn field(&self) -> Result<Type, ParquetError> {
        let (physical, logical) = match self.values {
            Values::Doubles(_) => (Physical::DOUBLE, None),
            Values::Counts(_) => (Physical::INT64, None),
            Values::Flags(_) => (Physical::BOOLEAN, None),
            Values::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        Type::primitive_type_builder(&self.name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(logical)
            .build()
    }

    pub(crate) fn push(&mut self, cell: &Cell<Number>) {
        let before = self.len();
        match (&mut self.values, cell) {
            (Values::Doubles(values), Cell::Number(number)) => {
                values.extend(number.as_ref().and_then(Number::double))
            }
            (Values::Counts(values), Cell::Count(count)) => {
                values.extend(count.and_then(|n| i64::try_from(n).ok()));
            }
            (Values::Flags(values), Cell::Flag(flag)) => values.extend(flag),
            (Values::Texts(values), Cell::Number(Some(_)) | Cell::Text(_)) => {
                let text = cell.text();
                self.bytes += text.len();
                values.push(text.into_bytes().into());
            }
            // This cannot occur: the columns are made from the cells of the first row, and every row has the
            // same kinds.
            _ => {}
        }
        self.bytes += 10;
        self.there.push(i16::from(self.len() > before));
    }

    fn len(&self) -> usize {
        match &self.values {
            Values::Doubles(values) => values.len(),
            Values::Counts(values) => values.len(),
            Values::Flags(values) => values.len(),
            Values::Texts(values) => values.len(),
        }
    }

    /// Appends some of the rows of a file.
    pub(crate) fn read(&mut self, reader: &mut ColumnReader, count: usize) -> Result<(), ParquetError> {
        let before = self.len();
        let there = Some(&mut self.there);
        let read = match (&mut self.values, reader) {
            (Values::Doubles(values), ColumnReader::DoubleColumnReader(reader)) => {
                reader.read_records(count, there, None, values)?
            }
            (Values::Counts(values), ColumnReader::Int64ColumnReader(reader)) => {
                reader.read_records(count, there, None, values)?
            }
            (Values::Flags(values), ColumnReader::BoolColumnReader(reader)) => {
                reader.read_records(count, there, None, values)?
            }
            (Values::Texts(values), ColumnReader::ByteArrayColumnReader(reader)) => {
                let read = reader.read_records(count, there, None, values)?;
                self.bytes += values.iter().skip(before).map(ByteArray::len).sum::<usize>();
                read
            }
            _ => return Err(ParquetError::General(format!("column {}: of another kind", self.name))),
        };
        self.bytes += 10 * count;
        if read.0 == count {
            return Ok(());
        }
        Err(ParquetError::General(format!("column {}: {} rows, must be {count}", self.name, read.0)))
    }

    /// The approximate size in memory.
    pub(crate) const fn bytes(&self) -> usize {
        self.bytes
    }

    /// Writes the rows and clears them.
    pub(crate) fn write(&mut self, writer: &mut ColumnWriter<'_>) -> Result<(), ParquetError> {
        let there = &self.there;
        match (&mut self.values, writer) {
            (Values::Doubles(values), ColumnWriter::DoubleColumnWriter(writer)) => {
                write(writer, values, there)
            }
            (Values::Counts(values), ColumnWriter::Int64ColumnWriter(writer)) => write(writer, values, there),
            (Values::Flags(values), ColumnWriter::BoolColumnWriter(writer)) => write(writer, values, there),
            (Values::Texts(values), ColumnWriter::ByteArrayColumnWriter(writer)) => {
                write(writer, values, there)
            }
            _ => Err(ParquetError::General(format!("column {}: of another kind", self.name))),
        }?;
        self.there.clear();
        self.bytes = 0;
        Ok(())
    }
}

/// Writes the values and clears them.
fn write<T: DataType>(
    writer: &mut ColumnWriterImpl<'_, T>,
    values: &mut Vec<T::T>,
    there: &[i16],
) -> Result<(), ParquetError> {
    writer.write_batch(values, Some(there), None)?;
    values.clear();
    Ok(())
}

/// The first and the last row of a file.
pub(crate) fn ends(reader: &SerializedFileReader<File>) -> Result<Option<(Row, Row)>, ParquetError> {
    let Some(last_group) = reader.num_row_groups().checked_sub(1) else { return Ok(None) };
    let first = reader.get_row_group(0)?.get_row_iter(None)?.next().transpose()?;
    let last = reader.get_row_group(last_group)?.get_row_iter(None)?.last().transpose()?;
    Ok(first.zip(last))
}

/// Whether a row that was read equals the record.
pub(crate) fn equals(row: &Row, record: &row::Row) -> bool {
    let field = |cell: Cell<Number>| match cell {
        Cell::Number(Some(Number::Double(number))) => Field::Double(number),
        Cell::Count(Some(count)) => i64::try_from(count).map_or(Field::Null, Field::Long),
        Cell::Flag(Some(flag)) => Field::Bool(flag),
        Cell::Number(Some(_)) | Cell::Text(_) => Field::Str(cell.text()),
        Cell::Number(None) | Cell::Count(None) | Cell::Flag(None) | Cell::Pairs(_) | Cell::Intervals(_) => {
            Field::Null
        }
    };
    row.get_column_iter().map(|(_, field)| field.clone()).eq(record.cells().map(field))
}
