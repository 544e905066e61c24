//! Going on with a Parquet file that was broken off.
//!
//! Its end says where its columns are, so that nothing can be written behind it: a new file takes over its row groups
//! as they are, goes on, and takes its place once it is whole.

use super::{Table, columns, schema};
use crate::args::SweepArgs;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::record::Cell;
use crate::sweep::rows::Rows;
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};
use std::fs::{self, File};
use std::ops::Range;
use std::path::{Path, PathBuf};

pub(super) fn go_on<F: Value>(name: &Path, args: &SweepArgs, rows: &Rows<F>, part: Range<u64>) -> Outcome {
    let bad = |what: String| Failure::Input(format!("--resume: {}: {what}", name.display()));
    let old = File::open(name).map_err(|e| bad(e.to_string()))?;
    let reader = SerializedFileReader::new(old.try_clone()?).map_err(|e| {
        bad(format!("without the end of a Parquet file, which one that was cut off lacks: begin anew ({e})"))
    })?;
    let columns = columns(rows)?;
    if reader.metadata().file_metadata().schema() != &*schema(&columns)? {
        return Err(bad("its columns are not those of this sweep".to_owned()));
    }
    let done = u64::try_from(reader.metadata().file_metadata().num_rows()).unwrap_or(0);
    if done > part.end - part.start {
        return Err(bad(format!("{done} rows, must be ≤ {}, those of this sweep", part.end - part.start)));
    }
    if let Some((first, last)) = ends(&reader)? {
        if !is(&first, rows, part.start)? {
            return Err(bad("row 1 is not of this sweep".to_owned()));
        }
        if !is(&last, rows, part.start + done - 1)? {
            return Err(bad(format!("row {done} is not of this sweep")));
        }
    }
    let beside = beside(name);
    let created =
        File::create(&beside).map_err(|e| Failure::Input(format!("--resume: {}: {e}", beside.display())))?;
    let mut table = Table::new(created, columns, args)?;
    take_over(&mut table, &reader, &old)?;
    // Some systems replace no file that is open.
    drop((reader, old));
    let outcome = table.fill(rows, part.start + done..part.end);
    match outcome {
        Ok(()) | Err(Failure::Interrupted) => fs::rename(&beside, name)?,
        Err(_) => fs::remove_file(&beside)?,
    }
    outcome
}

/// The file that takes the place of another.
fn beside(name: &Path) -> PathBuf {
    let mut beside = name.as_os_str().to_owned();
    beside.push(".resumed");
    beside.into()
}

/// The row groups of a file, byte by byte.
fn take_over(table: &mut Table, reader: &SerializedFileReader<File>, old: &File) -> Outcome {
    for group in reader.metadata().row_groups() {
        let mut copy = table.writer.next_row_group()?;
        for column in group.columns() {
            let closed = ColumnCloseResult {
                bytes_written: u64::try_from(column.compressed_size()).unwrap_or(0),
                rows_written: u64::try_from(group.num_rows()).unwrap_or(0),
                metadata: column.clone(),
                bloom_filter: None,
                column_index: None,
                offset_index: None,
            };
            copy.append_column(old, closed)?;
        }
        copy.close()?;
    }
    Ok(())
}

/// The first and the last row of a file.
fn ends(reader: &SerializedFileReader<File>) -> Result<Option<(Row, Row)>, ParquetError> {
    let Some(last_group) = reader.num_row_groups().checked_sub(1) else { return Ok(None) };
    let first = reader.get_row_group(0)?.get_row_iter(None)?.next().transpose()?;
    let last = reader.get_row_group(last_group)?.get_row_iter(None)?.last().transpose()?;
    Ok(first.zip(last))
}

fn is<F: Value>(row: &Row, rows: &Rows<F>, point: u64) -> Result<bool, Failure> {
    Ok(row.get_column_iter().map(|(_, field)| field).eq(&fields(rows, point)?))
}

/// A row of the sweep as a reader finds it.
fn fields<F: Value>(rows: &Rows<F>, point: u64) -> Result<Vec<Field>, Failure> {
    let field = |cell: Cell<F>| match cell {
        Cell::Number(Some(number)) if F::PRECISION <= f64::MANTISSA_DIGITS => Field::Double(number.to_f64()),
        Cell::Count(Some(count)) => i64::try_from(count).map_or(Field::Null, Field::Long),
        Cell::Number(Some(_)) | Cell::Text(_) => Field::Str(cell.text()),
        Cell::Number(None) | Cell::Count(None) | Cell::Pairs(_) => Field::Null,
    };
    Ok(rows.record(point)?.cells().map(field).collect())
}
