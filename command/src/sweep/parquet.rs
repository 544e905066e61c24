//! Sweeps to Parquet.
//!
//! Only the end of a Parquet file contains the positions of its columns, so that a file without its end is
//! lost. The rows therefore go to a directory next to the file first, as parts that are Parquet files of
//! their own, about one per second. Once the sweep is complete they are merged into the file. After any
//! interruption the parts are kept, and can be resumed.

mod parts;
mod sealed;
mod whole;

use super::Table;
use crate::args::TableArgs;
use crate::failure::Outcome;
use crate::output::PendingFile;
use crate::parquet_file::{self, Group};
use crate::progress;
use crate::row::Row;
use parquet::file::metadata::KeyValue;
use parts::Parts;
use std::ops::Range;
use whole::{Sweep, error_at, open};

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
