//! `stickslip sweep`.

pub(crate) mod loops;
#[cfg(feature = "parquet")]
mod parquet;
pub(crate) mod rows;
mod table;

use crate::args::{Header, SweepArgs, SweepFormat, TableArgs};
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::grid::Axes;
use crate::output::Lines;
use crate::resume;
use crate::row::csv_text;
use rows::SweepRows;
use std::io::Write;
use std::ops::Range;
pub(crate) use table::Table;
#[cfg(feature = "parquet")]
pub(crate) use table::notes;

/// The greatest number of points, as of the segments of `simulate`: hours at some millions per second.
const MOST_ROWS: u64 = 10_000_000_000;

pub(crate) fn run(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.bits, compute(args: &SweepArgs, out))
}

fn compute<F: Value>(args: &SweepArgs, out: &mut impl Write) -> Outcome {
    let format = args.table.format()?;
    let axes = Axes::new(&args.machine, &args.units.reader())?;
    if axes.len() > MOST_ROWS {
        let names: Vec<&str> = axes.grids().iter().map(|(parameter, _)| parameter.option()).collect();
        return Err(format!("{}: the grid must have ≤ {MOST_ROWS} points", names.join(" ")).into());
    }
    write_table(&args.table, format, &SweepRows::<F>::new(args, axes)?, out)
}

/// The rows of a table as text.
struct TextRows<'a> {
    table: &'a dyn Table,
    is_csv: bool,
    header: Header,
}

impl resume::Rows for TextRows<'_> {
    fn of(&self) -> &'static str {
        self.table.of()
    }

    fn header(&self) -> Result<Vec<u8>, Failure> {
        let form = self.table.form();
        csv_text(|writer| if self.is_csv { form.write_header(writer, self.header) } else { Ok(()) })
    }

    fn text(&self, point: u64) -> Result<Vec<u8>, Failure> {
        self.table.row(point)?.line(self.is_csv)
    }

    fn texts(&self, points: Range<u64>) -> Vec<Result<Vec<u8>, Failure>> {
        self.table.rows(points).into_iter().map(|row| row?.line(self.is_csv)).collect()
    }

    fn hold_their_grid(&self) -> bool {
        self.table.hold_their_grid()
    }

    fn is_on_grid(&self, line: &[u8], point: u64) -> Result<bool, Failure> {
        self.table.is_on_grid(line, point, self.is_csv)
    }
}

/// Writes a table, or a part of it.
pub(crate) fn write_table(
    args: &TableArgs,
    format: SweepFormat,
    table: &dyn Table,
    out: &mut impl Write,
) -> Outcome {
    let part = part(args.shard.as_deref(), table.len())?;
    if args.resume && args.out.is_none() {
        return Err("--resume: needs the file to continue, --out FILE".into());
    }
    let is_csv = match format {
        SweepFormat::Csv => true,
        SweepFormat::Jsonl => false,
        #[cfg(feature = "parquet")]
        SweepFormat::Parquet => return parquet::run(args, table, part),
        #[cfg(not(feature = "parquet"))]
        SweepFormat::Parquet => return Err(crate::sink::no_parquet()),
    };
    to_text(args, &TextRows { table, is_csv, header: args.header }, part, out)
}

fn to_text(args: &TableArgs, rows: &dyn resume::Rows, part: Range<u64>, out: &mut impl Write) -> Outcome {
    let header = !args.no_header;
    if let Some(name) = &args.out {
        let (place, end) = (("--out", name.as_path()), part.end);
        let mut fill = |start, out: &mut Lines<resume::Checked<'_>>| write(rows, start..end, out);
        return resume::to_file(place, args.resume, rows, &part, header, &mut fill);
    }
    if header {
        out.write_all(&rows.header()?)?;
    }
    write(rows, part, out)
}

fn write(rows: &dyn resume::Rows, part: Range<u64>, out: &mut impl Write) -> Outcome {
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
        Some(_) | None => Err(format!("--shard {text}: must be I/N with whole numbers, 1 ≤ I ≤ N").into()),
    }
}
