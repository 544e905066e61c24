//! `stickslip sweep`.

pub(crate) mod loops;
#[cfg(feature = "parquet")]
mod parquet;
pub(crate) mod rows;

use crate::args::{SweepArgs, SweepFormat, TableArgs};
use crate::axes::Axes;
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::output::{Lines, named};
#[cfg(feature = "parquet")]
use crate::record::Record;
use crate::resume;
use rows::SweepRows;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::path::Path;

pub(crate) fn run(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, compute(args: &SweepArgs, out))
}

fn compute<F: Value>(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    let format = format(&args.table)?;
    let axes = Axes::new(&args.machine, &args.units.reader())?;
    let rows = SweepRows::<F>::new(args, format, axes)?;
    write_table(&args.table, format, &rows, out)
}

/// The format of a table, if its file's name has one.
pub(crate) fn format(args: &TableArgs) -> Result<SweepFormat, Failure> {
    args.format().ok_or_else(|| {
        let name = args.out.as_deref().map_or(String::new(), |file| file.display().to_string());
        Failure::Input(format!(
            "--out {name}: the name must end in .csv, .jsonl or .parquet, or --format be given"
        ))
    })
}

/// Rows of many columns, each computed from its number alone.
pub(crate) trait Table<F>: resume::Rows {
    /// The number of rows.
    fn len(&self) -> u64;

    /// A row without its answers, with the names of all rows.
    #[cfg(feature = "parquet")]
    fn form(&self) -> &Record<F>;

    /// A row.
    #[cfg(feature = "parquet")]
    fn record(&self, point: u64) -> Result<Record<F>, Failure>;

    /// The first rows of a range, at least one.
    #[cfg(feature = "parquet")]
    fn records(&self, points: Range<u64>) -> Vec<Result<Record<F>, Failure>> {
        vec![self.record(points.start)]
    }

    /// What identifies the table, by name.
    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)>;
}

/// Writes a table, or a part of it.
pub(crate) fn write_table<F: Value>(
    args: &TableArgs,
    format: SweepFormat,
    rows: &impl Table<F>,
    out: &mut impl Write,
) -> Outcome {
    let part = part(args.shard.as_deref(), rows.len())?;
    if args.resume && args.out.is_none() {
        return Err(Failure::Input("--resume: needs the file to continue, --out FILE".to_owned()));
    }
    match format {
        SweepFormat::Csv | SweepFormat::Jsonl => to_text(args, rows, part, out),
        SweepFormat::Parquet => to_parquet(args, rows, part),
    }
}

fn to_text(args: &TableArgs, rows: &impl resume::Rows, part: Range<u64>, out: &mut impl Write) -> Outcome {
    match &args.out {
        None => write(rows, part, !args.no_header, out),
        Some(name) if args.resume && name.exists() => {
            let (file, done) = resume::reopen(name, rows, &part, !args.no_header)?;
            to_file(rows, part.start + done.rows..part.end, !done.header && !args.no_header, &file, name)
        }
        Some(name) => to_file(rows, part, !args.no_header, &resume::create(name, "--out")?, name),
    }
}

/// Writes the rows to the end of a file. After any interruption the file can be resumed.
fn to_file(rows: &impl resume::Rows, part: Range<u64>, header: bool, file: &File, name: &Path) -> Outcome {
    let name = name.display().to_string();
    let outcome = write(rows, part, header, &mut Lines::new(file, name.as_str()));
    // This reports data that the system failed to write.
    outcome.and(file.sync_all().map_err(|e| named(&name, e).into()))
}

#[cfg(feature = "parquet")]
fn to_parquet<F: Value>(args: &TableArgs, rows: &impl Table<F>, part: Range<u64>) -> Outcome {
    parquet::run(args, rows, part)
}

#[cfg(not(feature = "parquet"))]
fn to_parquet<F: Value>(_: &TableArgs, _: &impl Table<F>, _: Range<u64>) -> Outcome {
    Err(no_parquet())
}

#[cfg(not(feature = "parquet"))]
pub(crate) fn no_parquet() -> Failure {
    Failure::Input("--format parquet: needs a build with the feature parquet".to_owned())
}

/// Writes the rows of a part, with their header.
fn write(rows: &impl resume::Rows, part: Range<u64>, header: bool, out: &mut impl Write) -> Outcome {
    if header {
        out.write_all(&rows.header()?)?;
    }
    resume::write(part, out, |points| rows.texts(points), |text, out| Ok(out.write_all(&text)?))
}

/// The rows of `--shard I/N`: the parts are contiguous, and differ by at most one row.
fn part(shard: Option<&str>, rows: u64) -> Result<Range<u64>, Failure> {
    let Some(text) = shard else { return Ok(0..rows) };
    let numbers: Option<(u64, u64)> =
        text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((i, n)) if 1 <= i && i <= n => {
            let end = |i: u64| (u128::from(rows) * u128::from(i) / u128::from(n)) as u64;
            Ok(end(i - 1)..end(i))
        }
        Some(_) | None => {
            Err(Failure::Input(format!("--shard {text}: must be I/N with whole numbers, 1 ≤ I ≤ N")))
        }
    }
}
