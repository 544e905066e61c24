//! Sweeps to Parquet: a column for each output, a row group whenever enough rows are in memory.

mod column;
mod resume;

use super::create;
use super::rows::Rows;
use crate::args::SweepArgs;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::progress;
use crate::record::Record;
use clap::ValueEnum;
use column::Column;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::fs::File;
use std::io;
use std::ops::Range;
use std::sync::Arc;

/// Rows of a group, at most.
const ROWS: usize = 1 << 17;
/// Bytes of a group in memory, about, whatever the digits of its numbers.
const BYTES: usize = 1 << 26;

pub(super) fn run<F: Value>(args: &SweepArgs, rows: &Rows<F>, part: Range<u64>) -> Outcome {
    let Some(file) = &args.out else {
        return Err(Failure::Input("--format parquet: give its file by --out FILE".to_owned()));
    };
    if args.no_header {
        return Err(Failure::Input("--no-header: a Parquet file names its columns; leave it out".to_owned()));
    }
    if args.resume && file.exists() {
        return resume::go_on(file, args, rows, part);
    }
    // Before the file, so that a sweep without an answer leaves none.
    let columns = columns(rows)?;
    let table = Table::new(create(file)?, columns, args)?;
    table.fill(rows, part)
}

fn columns<F: Value>(rows: &Rows<F>) -> Result<Vec<Column>, Failure> {
    let first = rows.record(0)?;
    Ok(first.names().into_iter().zip(first.cells()).map(|(name, cell)| Column::of(name, &cell)).collect())
}

/// A file that is being written.
struct Table {
    writer: SerializedFileWriter<File>,
    columns: Vec<Column>,
    rows: usize,
}

impl Table {
    fn new(file: File, columns: Vec<Column>, args: &SweepArgs) -> Result<Self, Failure> {
        let note = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let mut notes = vec![
            note("omega", args.omega.clone()),
            note("units", "lengths r_y/k, velocities r_y/k ω_d, energies r_y²/k, phases rad".to_owned()),
        ];
        let question =
            args.question.to_possible_value().map(|value| note("sweep", value.get_name().to_owned()));
        notes.extend(question);
        notes.extend(args.alpha.clone().map(|alpha| note("alpha", alpha)));
        let properties = WriterProperties::builder()
            .set_created_by(concat!("stickslip ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_compression(Compression::SNAPPY)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_key_value_metadata(Some(notes));
        let writer = SerializedFileWriter::new(file, schema(&columns)?, Arc::new(properties.build()))?;
        Ok(Self { writer, columns, rows: 0 })
    }

    /// Answers the points and ends the file. Broken off it is ended too, with the rows that it has.
    fn fill<F: Value>(mut self, rows: &Rows<F>, points: Range<u64>) -> Outcome {
        let outcome = progress::in_order(
            points,
            |points| points.map(|point| rows.record(point)).collect::<Result<Vec<_>, _>>(),
            |records| records.iter().try_for_each(|record| self.push(record)),
        );
        outcome.and(self.end())
    }

    fn push<F: Value>(&mut self, record: &Record<F>) -> Outcome {
        for (column, cell) in self.columns.iter_mut().zip(record.cells()) {
            column.push(&cell);
        }
        self.rows += 1;
        if self.rows >= ROWS || self.columns.iter().map(Column::bytes).sum::<usize>() >= BYTES {
            self.write_group()?;
        }
        Ok(())
    }

    /// The rows in memory as a group of the file.
    fn write_group(&mut self) -> Outcome {
        let mut group = self.writer.next_row_group()?;
        for column in &mut self.columns {
            let Some(mut writer) = group.next_column()? else { break };
            column.write(writer.untyped())?;
            writer.close()?;
        }
        group.close()?;
        self.rows = 0;
        Ok(())
    }

    fn end(mut self) -> Outcome {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.writer.close()?;
        Ok(())
    }
}

fn schema(columns: &[Column]) -> Result<Arc<Type>, ParquetError> {
    let fields = columns.iter().map(|column| column.field().map(Arc::new)).collect::<Result<_, _>>()?;
    Ok(Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?))
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
