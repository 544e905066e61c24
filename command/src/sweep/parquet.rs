//! Sweeps to Parquet: a column for each output, and a row group whenever enough rows are in memory.
//!
//! Only the end of a Parquet file contains the positions of its columns, so that a file without its end is
//! lost. The rows therefore go to a directory next to the file first, as parts that are Parquet files of
//! their own, about one per second. Once the sweep is complete they are merged into the file. After any
//! interruption the parts are kept, and can be resumed.

mod column;
mod parts;

use super::Table;
use crate::args::TableArgs;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::output::{Lines, PendingFile};
use crate::progress;
use crate::record::Record;
use column::ParquetColumn;
use core::marker::PhantomData;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use parts::Parts;
use std::fs::File;
use std::io;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The greatest number of rows in a group.
const ROWS: usize = 1 << 17;
/// The approximate greatest size of a group in memory, whatever the precision of its numbers.
const BYTES: usize = 1 << 26;

pub(super) fn run<F: Value, T: Table<F>>(args: &TableArgs, rows: &T, part: Range<u64>) -> Outcome {
    let Some(file) = &args.out else {
        return Err(Failure::Input("--format parquet: give its file by --out FILE".to_owned()));
    };
    if args.no_header {
        return Err(Failure::Input(
            "--no-header: must be left out, because a Parquet file names its columns".to_owned(),
        ));
    }
    let sweep = Sweep { rows, part, notes: notes(rows), columns: columns(rows), of: PhantomData };
    if file.exists() {
        if !args.resume {
            let text = format!("--out {}: must not exist yet. Continue it with --resume", file.display());
            return Err(Failure::Input(text));
        }
        // The file is made from all parts at once: if it exists, nothing is left to do.
        sweep.is_whole(file).map_err(|what| error_at(file, &what))?;
        return Parts::remove_left(file);
    }
    let mut parts = Parts::open(file, args.resume)?;
    let done = parts.check(&sweep)?;
    let mut table = PendingRows { columns: columns(rows), rows: 0, start: done };
    let outcome = progress::in_order_kept(
        done..sweep.part.end,
        |points| rows.records(points),
        |record| match record {
            Some(record) => table.push(&record, &mut parts, &sweep),
            None => table.commit(&mut parts, &sweep),
        },
    );
    // The existing rows are kept even after an interruption.
    match table.commit(&mut parts, &sweep).and(outcome) {
        Ok(()) => parts.become_file(file, &sweep),
        Err(failure) => parts.remove_empty().and(Err(failure)),
    }
}

/// The error for a file that is to be resumed.
fn error_at(file: &Path, what: &str) -> Failure {
    Failure::Input(format!("--resume: {}: {what}", file.display()))
}

/// A sweep, with the metadata that identify it.
struct Sweep<'a, F, T> {
    rows: &'a T,
    part: Range<u64>,
    notes: Vec<KeyValue>,
    columns: Vec<ParquetColumn>,
    of: PhantomData<F>,
}

impl<F: Value, T: Table<F>> Sweep<'_, F, T> {
    /// Fails unless the file contains the rows of these points, according to its metadata, its columns, their
    /// number, and its first and last rows.
    fn has(&self, reader: &SerializedFileReader<File>, points: Range<u64>) -> Result<(), String> {
        let metadata = reader.metadata().file_metadata();
        let found = metadata.key_value_metadata().map_or(&[][..], Vec::as_slice);
        for key in self.notes.iter().chain(found).map(|note| &note.key) {
            let value = |notes: &[KeyValue]| {
                notes
                    .iter()
                    .find(|note| note.key == *key)
                    .and_then(|note| note.value.clone())
                    .unwrap_or_default()
            };
            let (found, due) = (value(found), value(&self.notes));
            if found != due {
                return Err(format!("of another sweep: its {key} is “{found}”, here it is “{due}”"));
            }
        }
        let text = |e: ParquetError| e.to_string();
        if metadata.schema() != &*schema(&self.columns).map_err(text)? {
            return Err("its columns are not those of this sweep".to_owned());
        }
        let rows = u64::try_from(metadata.num_rows()).unwrap_or(0);
        if rows != points.end - points.start {
            return Err(format!("{rows} rows, must be {}", points.end - points.start));
        }
        if let Some((first, last)) = column::ends(reader).map_err(text)? {
            for (row, point) in [(first, points.start), (last, points.end - 1)] {
                let record = self.rows.record(point).map_err(|e| e.to_string())?;
                if !column::equals(&row, &record) {
                    return Err(format!("row {} is not of this sweep", point - self.part.start + 1));
                }
            }
        }
        Ok(())
    }

    fn is_whole(&self, file: &Path) -> Result<(), String> {
        let reader = open(file).map_err(|e| e.to_string())?;
        self.has(&reader, self.part.clone())
    }

    /// A writer of row groups.
    fn writer<'f>(&self, out: Lines<&'f File>) -> Result<SerializedFileWriter<Lines<&'f File>>, Failure> {
        let properties = WriterProperties::builder()
            .set_created_by(concat!("stickslip ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_compression(Compression::SNAPPY)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_key_value_metadata(Some(self.notes.clone()));
        Ok(SerializedFileWriter::new(out, schema(&self.columns)?, Arc::new(properties.build()))?)
    }
}

fn open(file: &Path) -> Result<SerializedFileReader<File>, Failure> {
    Ok(SerializedFileReader::new(File::open(file)?)?)
}

fn notes<F: Value>(rows: &impl Table<F>) -> Vec<KeyValue> {
    let units = "lengths r_y/k, velocities r_y/k ω_d, energies r_y²/k, phases rad, and a unit in brackets where a column has its own";
    let notes = rows.notes().into_iter().map(|(key, value)| KeyValue::new(key, value));
    core::iter::once(KeyValue::new("units".to_owned(), units.to_owned())).chain(notes).collect()
}

fn columns<F: Value>(rows: &impl Table<F>) -> Vec<ParquetColumn> {
    let form = rows.form();
    form.names().into_iter().zip(form.cells()).map(|(name, cell)| ParquetColumn::of(name, &cell)).collect()
}

/// The rows in memory, from a point on.
struct PendingRows {
    columns: Vec<ParquetColumn>,
    rows: usize,
    start: u64,
}

impl PendingRows {
    fn push<F: Value, T: Table<F>>(
        &mut self,
        record: &Record<F>,
        parts: &mut Parts,
        sweep: &Sweep<'_, F, T>,
    ) -> Outcome {
        for (column, cell) in self.columns.iter_mut().zip(record.cells()) {
            column.push(&cell);
        }
        self.rows += 1;
        if is_group(&self.columns, self.rows) {
            self.commit(parts, sweep)?;
        }
        Ok(())
    }

    /// Writes the rows in memory as a part.
    fn commit<F: Value, T: Table<F>>(&mut self, parts: &mut Parts, sweep: &Sweep<'_, F, T>) -> Outcome {
        // The rows are taken only once, even if the write fails: the columns are then no longer complete.
        let rows = std::mem::take(&mut self.rows);
        if rows > 0 {
            let end = self.start + rows as u64;
            let columns = &mut self.columns;
            parts.add(self.start..end, |out| {
                let mut writer = sweep.writer(out)?;
                write_group(&mut writer, columns)?;
                Ok(writer.into_inner()?)
            })?;
            self.start = end;
        }
        Ok(())
    }
}

/// Whether the rows suffice for a group.
fn is_group(columns: &[ParquetColumn], rows: usize) -> bool {
    rows >= ROWS || columns.iter().map(ParquetColumn::bytes).sum::<usize>() >= BYTES
}

/// Writes the rows in memory as a group of the file.
fn write_group<W: io::Write + Send>(
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

fn schema(columns: &[ParquetColumn]) -> Result<Arc<Type>, ParquetError> {
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
