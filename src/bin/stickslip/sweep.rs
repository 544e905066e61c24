//! `stickslip sweep`.

mod resume;
pub(crate) mod rows;

use crate::args::{Format, SweepArgs, Swept};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::grid::Grid;
use crate::progress;
use rows::Rows;
use std::fs::{File, OpenOptions};
use std::io::{BufWriter, ErrorKind, Write};
use std::ops::Range;

/// The command with its arguments and where its answer goes.
struct Run<'a, W>(&'a SweepArgs, &'a mut W);

pub(crate) fn run(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    bits::run(args.bits, Run(args, out))
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        let omega = Grid::parse("--omega", &args.omega)?;
        let alpha = match (&args.alpha, args.question) {
            (Some(text), Swept::Response | Swept::Steady) => Grid::parse("--alpha", text)?,
            (None, Swept::Border) => Grid::List(vec![F::int(1)]),
            (None, Swept::Response | Swept::Steady) => {
                return Err(Failure::Input("--alpha is missing".to_owned()));
            }
            (Some(_), Swept::Border) => {
                return Err(Failure::Input("--alpha: a border has none; leave it out".to_owned()));
            }
        };
        let rows = Rows::<F>::new(args, omega, alpha)?;
        let part = part(args.shard.as_deref(), rows.len())?;
        match &args.out {
            None if args.resume => {
                Err(Failure::Input("--resume: give the file to go on with by --out FILE".to_owned()))
            }
            None => write(&rows, part, !args.no_header, out),
            Some(file) if args.resume && file.exists() => {
                let (file, done) = resume::reopen(file, &rows, &part, !args.no_header)?;
                let mut out = BufWriter::new(file);
                write(&rows, part.start + done.rows..part.end, !done.header && !args.no_header, &mut out)?;
                Ok(out.flush()?)
            }
            Some(file) => {
                let name = file.display();
                let created = OpenOptions::new().write(true).create_new(true).open(file);
                let created: File = created.map_err(|e| {
                    Failure::Input(if e.kind() == ErrorKind::AlreadyExists {
                        format!("--out {name}: must not exist yet; --resume goes on with it")
                    } else {
                        format!("--out {name}: {e}")
                    })
                })?;
                let mut out = BufWriter::new(created);
                write(&rows, part, !args.no_header, &mut out)?;
                Ok(out.flush()?)
            }
        }
    }
}

/// The rows of a part of the sweep, with their header.
fn write<F: Value>(rows: &Rows<F>, part: Range<u64>, header: bool, out: &mut impl Write) -> Outcome {
    if header {
        out.write_all(&rows.header()?)?;
    }
    let outcome = progress::in_order(part, |points| rows.text(points), |text| Ok(out.write_all(&text)?));
    out.flush()?;
    outcome
}

/// The rows of `--shard I/N`: the parts follow each other without gap, and differ by one row at most.
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

/// `csv` or `jsonl`.
fn is_csv(format: Format) -> Result<bool, Failure> {
    match format {
        Format::Csv => Ok(true),
        Format::Jsonl => Ok(false),
        Format::Text | Format::Json => {
            Err(Failure::Input("--format: the answer to a sweep is csv or jsonl".to_owned()))
        }
    }
}
