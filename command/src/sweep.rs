//! `stickslip sweep`.

#[cfg(feature = "parquet")]
mod parquet;
pub(crate) mod rows;

use crate::args::{SweepArgs, SweepFormat};
use crate::axes::Axes;
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::output::{Lines, named};
use crate::resume::{self, Rows as _};
use rows::SweepRows;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::path::Path;

pub(crate) fn run(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, compute(args: &SweepArgs, out))
}

fn compute<F: Value>(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    let Some(format) = args.format() else {
        let name = args.out.as_deref().map_or(String::new(), |file| file.display().to_string());
        return Err(Failure::Input(format!(
            "--out {name}: the name must end in .csv, .jsonl or .parquet, or --format be given"
        )));
    };
    let axes = Axes::new(&args.machine, &args.units.reader())?;
    let rows = SweepRows::<F>::new(args, axes)?;
    let part = part(args.shard.as_deref(), rows.len())?;
    if args.resume && args.out.is_none() {
        return Err(Failure::Input("--resume: needs the file to continue, --out FILE".to_owned()));
    }
    match format {
        SweepFormat::Csv | SweepFormat::Jsonl => to_text(args, &rows, part, out),
        SweepFormat::Parquet => to_parquet(args, &rows, part),
    }
}

fn to_text<F: Value>(
    args: &SweepArgs,
    rows: &SweepRows<F>,
    part: Range<u64>,
    out: &mut impl Write,
) -> Outcome {
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
fn to_file<F: Value>(
    rows: &SweepRows<F>,
    part: Range<u64>,
    header: bool,
    file: &File,
    name: &Path,
) -> Outcome {
    let name = name.display().to_string();
    let outcome = write(rows, part, header, &mut Lines::new(file, name.as_str()));
    // This reports data that the system failed to write.
    outcome.and(file.sync_all().map_err(|e| named(&name, e).into()))
}

#[cfg(feature = "parquet")]
fn to_parquet<F: Value>(args: &SweepArgs, rows: &SweepRows<F>, part: Range<u64>) -> Outcome {
    parquet::run(args, rows, part)
}

#[cfg(not(feature = "parquet"))]
fn to_parquet<F: Value>(_: &SweepArgs, _: &SweepRows<F>, _: Range<u64>) -> Outcome {
    Err(Failure::Input("--format parquet: needs a build with the feature parquet".to_owned()))
}

/// Writes the rows of a part of the sweep, with their header.
fn write<F: Value>(rows: &SweepRows<F>, part: Range<u64>, header: bool, out: &mut impl Write) -> Outcome {
    if header {
        out.write_all(&rows.header()?)?;
    }
    resume::write(part, out, |point| rows.text(point), |text, out| Ok(out.write_all(&text)?))
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
