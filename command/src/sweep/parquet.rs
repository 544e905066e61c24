//! Sweeps to Parquet.
//!
//! Only the end of a Parquet file contains the positions of its columns, so that a file without its end is
//! lost. The rows therefore go to a directory next to the file first, as parts that are Parquet files of
//! their own, about one per second. Once the sweep is complete they are merged into the file. After any
//! interruption the parts are kept, and can be resumed.

mod parts;
mod sealed;

use super::Table;
use crate::args::TableArgs;
use crate::failure::{Failure, Outcome};
use crate::output::PendingFile;
use crate::parquet_file::{self, Group};
use crate::progress;
use crate::row::Row;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use parts::Parts;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

pub(super) fn run(args: &TableArgs, rows: &dyn Table, part: Range<u64>) -> Outcome {
    let Some(file) = &args.out else {
        return Err("--format parquet: give its file by --out FILE".into());
    };
    if args.no_header {
        return Err("--no-header: must be left out, because a Parquet file names its columns".into());
    }
    let group = Group::of(rows.form());
    let sweep = Sweep { rows, part, notes: notes(rows), schema: group.schema()? };
    if file.exists() {
        if !args.resume {
            let text = format!("--out {}: must not exist yet. Continue it with --resume", file.display());
            return Err(text.into());
        }
        // The file is made from all parts at once: if it exists, nothing is left to do.
        sweep.check(file, sweep.part.clone()).map_err(|what| error_at(file, &what))?;
        return Parts::remove_left(file, &sweep);
    }
    let mut parts = Parts::open(file, args.resume)?;
    let done = parts.check(&sweep)?;
    let mut table = PendingRows { group, start: done };
    let outcome = progress::in_order_kept(
        done..sweep.part.end,
        |points| rows.rows(points),
        |found| match found {
            Some(row) => table.push(&row, &mut parts, &sweep),
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
struct Sweep<'a> {
    rows: &'a dyn Table,
    part: Range<u64>,
    notes: Vec<KeyValue>,
    schema: Arc<Type>,
}

impl Sweep<'_> {
    /// Fails unless the file contains the rows of these points, according to its metadata, its columns, their
    /// number, and its first and last rows.
    fn has(&self, reader: &SerializedFileReader<File>, points: Range<u64>) -> Result<(), String> {
        let metadata = reader.metadata().file_metadata();
        let found = metadata.key_value_metadata().map_or(&[][..], Vec::as_slice);
        let keys = self.notes.iter().chain(found).map(|note| &note.key);
        for key in keys.filter(|key| *key != sealed::NOTE) {
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
        if metadata.schema() != &*self.schema {
            return Err("its columns are not those of this sweep".to_owned());
        }
        let rows = u64::try_from(metadata.num_rows()).unwrap_or(0);
        if rows != points.end - points.start {
            return Err(format!("{rows} rows, must be {}", points.end - points.start));
        }
        if let Some((first, last)) = parquet_file::ends(reader).map_err(text)? {
            for (row, point) in [(first, points.start), (last, points.end - 1)] {
                let due = self.rows.row(point).map_err(|e| e.to_string())?;
                if !parquet_file::equals(&row, &due) {
                    return Err(format!("row {} is not of this sweep", point - self.part.start + 1));
                }
            }
        }
        Ok(())
    }

    /// Fails unless the file is as it was written, with the rows of these points.
    fn check(&self, file: &Path, points: Range<u64>) -> Result<(), String> {
        // Only a file that is as it was written is parsed.
        let opened = File::open(file).map_err(|e| e.to_string())?;
        sealed::check(&opened)?;
        let reader = SerializedFileReader::new(opened).map_err(|e| e.to_string())?;
        self.has(&reader, points)
    }

    /// A writer of row groups, for a file that is sealed.
    fn writer<W: Write + Send>(&self, out: W) -> Result<SerializedFileWriter<W>, Failure> {
        let notes = self.notes.iter().cloned().chain([sealed::note()]).collect();
        parquet_file::writer(out, self.schema.clone(), notes)
    }
}

fn open(file: &Path) -> Result<SerializedFileReader<File>, Failure> {
    Ok(SerializedFileReader::new(File::open(file)?)?)
}

fn notes(rows: &dyn Table) -> Vec<KeyValue> {
    let notes = rows.notes().into_iter().map(|(key, value)| KeyValue::new(key, value));
    core::iter::once(parquet_file::units_note()).chain(notes).collect()
}

/// The rows in memory, from a point on.
struct PendingRows {
    group: Group,
    start: u64,
}

impl PendingRows {
    fn push(&mut self, row: &Row, parts: &mut Parts, sweep: &Sweep<'_>) -> Outcome {
        self.group.push(row);
        if self.group.is_full() { self.commit(parts, sweep) } else { Ok(()) }
    }

    /// Writes the rows in memory as a part.
    fn commit(&mut self, parts: &mut Parts, sweep: &Sweep<'_>) -> Outcome {
        let points = self.start..self.start + self.group.rows as u64;
        if points.is_empty() {
            return Ok(());
        }
        self.start = points.end;
        parts.add(points, |out| {
            let mut writer = sweep.writer(out)?;
            self.group.write(&mut writer)?;
            writer.finish()?;
            Ok(())
        })
    }
}
