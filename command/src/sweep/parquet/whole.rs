//! The whole sweep, whose rows a file or a part has.

use super::super::Table;
use super::sealed;
use crate::failure::Failure;
use crate::parquet_file;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The error for a file that is to be resumed.
pub(super) fn error_at(file: &Path, what: &str) -> Failure {
    Failure::Input(format!("--resume: {}: {what}", file.display()))
}

/// A sweep, with the metadata that identify it.
pub(super) struct Sweep<'a> {
    pub(super) rows: &'a dyn Table,
    pub(super) part: Range<u64>,
    pub(super) notes: Vec<KeyValue>,
    pub(super) schema: Arc<Type>,
}

impl Sweep<'_> {
    /// Fails unless the file contains the rows of these points, according to its metadata, its columns, their
    /// number, and its first and last rows.
    pub(super) fn has(&self, reader: &SerializedFileReader<File>, points: Range<u64>) -> Result<(), String> {
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
    pub(super) fn check(&self, file: &Path, points: Range<u64>) -> Result<(), String> {
        // Only a file that is as it was written is parsed.
        let opened = File::open(file).map_err(|e| e.to_string())?;
        sealed::check(&opened)?;
        let reader = SerializedFileReader::new(opened).map_err(|e| e.to_string())?;
        self.has(&reader, points)
    }

    /// A writer of row groups, for a file that is sealed.
    pub(super) fn writer<W: Write + Send>(&self, out: W) -> Result<SerializedFileWriter<W>, Failure> {
        let notes = self.notes.iter().cloned().chain([sealed::note()]).collect();
        parquet_file::writer(out, self.schema.clone(), notes)
    }
}

pub(super) fn open(file: &Path) -> Result<SerializedFileReader<File>, Failure> {
    Ok(SerializedFileReader::new(File::open(file)?)?)
}
