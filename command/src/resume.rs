//! Rows in a file, and resuming them after an interruption.
//!
//! A file is resumed only if its rows are those of the same request. The check covers the header, the columns
//! that identify a row in its grid, and as many complete rows, evenly spaced, as a second allows. Rows whose checksum
//! was kept beside the file (`checksum`) are trusted; all others are recomputed, and so are all rows that do not contain
//! their grid. The text after the last complete row must be the beginning of the next row.

mod checksum;

use crate::bits::Here;
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output::{self, Lines, named};
use crate::progress;
use crate::threads;
pub(crate) use checksum::{Checked, Checksum};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;
use std::time::{Duration, Instant};

/// Rows that are each computed from their number alone.
pub(crate) trait Rows: Sync {
    /// The source of the rows, for error messages.
    fn of(&self) -> &'static str;

    /// The header line; empty if there is none.
    fn header(&self) -> Result<Vec<u8>, Failure>;

    /// The text of a row.
    fn text(&self, point: u64) -> Result<Vec<u8>, Failure>;

    /// The texts of the first rows of a range, at least one.
    fn texts(&self, points: Range<u64>) -> Vec<Result<Vec<u8>, Failure>> {
        vec![self.text(points.start)]
    }

    /// Whether a row identifies its point.
    fn hold_their_grid(&self) -> bool;

    /// Whether the grid columns of a row are those of this point, checked at almost no cost.
    fn is_on_grid(&self, line: &[u8], point: u64) -> Result<bool, Failure>;
}

/// Creates a file; an existing one is not overwritten.
fn create(file: &Path, option: &str) -> Result<File, Failure> {
    let argument = format!("{option} {}", file.display());
    let created = OpenOptions::new().write(true).create_new(true).open(file).map_err(|e| {
        if e.kind() == ErrorKind::AlreadyExists {
            format!("{argument}: must not exist yet. Continue it with --resume")
        } else {
            format!("{argument}: {e}")
        }
    })?;
    output::take(&created, &argument)?;
    Ok(created)
}

/// Writes the rows of a part to a new file, or after the complete rows of one that is continued, from a point on that
/// `fill` receives. After any interruption the file can be resumed.
pub(crate) fn to_file(
    (option, name): (&str, &Path),
    is_continued: bool,
    rows: &dyn Rows,
    part: &Range<u64>,
    has_header: bool,
    fill: &mut dyn FnMut(u64, &mut Lines<Checked<'_>>) -> Outcome,
) -> Outcome {
    let (file, done) = if is_continued && name.exists() {
        reopen(name, rows, part, has_header)?
    } else {
        (create(name, option)?, Done { header: false, rows: 0, bytes: 0, sum: Checksum::EMPTY })
    };
    let checked = Checked::new(name, &file, done.bytes, done.sum);
    let name = name.display().to_string();
    let mut out = Lines::new(checked, name.as_str());
    if has_header && !done.header {
        out.write_all(&rows.header()?)?;
    }
    let outcome = fill(part.start + done.rows, &mut out);
    out.into_inner().finish();
    // This reports data that the system failed to write.
    outcome.and(file.sync_all().map_err(|e| named(&name, e).into()))
}

/// Answers the points of a range in parallel, and writes the rows that `take` makes of the answers, in order,
/// as they are computed. `answers` gives those of the first points of a range.
pub(crate) fn write<T: Send, W: Write>(
    points: Range<u64>,
    out: &mut W,
    answers: impl Fn(Range<u64>) -> Vec<Result<T, Failure>> + Sync,
    mut take: impl FnMut(T, &mut W) -> Outcome,
) -> Outcome {
    let outcome = progress::in_order_kept(points, answers, |found| match found {
        Some(found) => take(found, out),
        None => Ok(out.flush()?),
    });
    out.flush()?;
    outcome
}

/// The contents of an existing file.
struct Done {
    header: bool,
    rows: u64,
    bytes: u64,
    sum: Checksum,
}

/// The greatest length of a line in bytes; a row of 8192 bits has less than a tenth of it.
const LONGEST_LINE: u64 = 1 << 20;
/// The greatest number of rows that are compared, and the greatest time for the comparison.
const MOST_COMPARED: usize = 1 << 13;
const COMPARING: Duration = Duration::from_secs(1);

/// Opens the file after its last complete row and truncates the rest.
fn reopen(name: &Path, rows: &dyn Rows, part: &Range<u64>, header: bool) -> Result<(File, Done), Failure> {
    let argument = format!("--resume: {}", name.display());
    let bad = |what: String| Failure::Input(what).about(&argument);
    if !fs::metadata(name).map_err(|e| bad(e.to_string()))?.is_file() {
        return Err(bad("must be a regular file".to_owned()));
    }
    let mut file = OpenOptions::new().read(true).write(true).open(name).map_err(|e| bad(e.to_string()))?;
    output::take(&file, &argument)?;
    let header = if header { rows.header()? } else { Vec::new() };
    let kept = KeptRows::read(&file, rows, part, &header, &checksum::kept(name)).and_then(|kept| {
        let trusted = if rows.hold_their_grid() {
            kept.compare_some(&file, rows, part)?;
            kept.trusted
        } else {
            (0, kept.begin)
        };
        kept.compare_from(trusted, &file, rows, part).map(|()| kept)
    });
    let kept = kept.map_err(|failure| failure.about(&argument))?;
    file.set_len(kept.end)?;
    file.seek(SeekFrom::Start(kept.end))?;
    Ok((file, Done { header: kept.begin > 0, rows: kept.rows, bytes: kept.end, sum: kept.sum }))
}

/// The complete lines of a file.
struct KeptRows {
    rows: u64,
    /// The position of the first row.
    begin: u64,
    /// The position after the last complete line.
    end: u64,
    /// The checksum of the bytes before that position.
    sum: Checksum,
    /// The number of rows whose checksum was kept, and the position after them.
    trusted: (u64, u64),
    /// Some rows, evenly spaced, with their numbers and positions.
    some: Spread,
}

impl KeptRows {
    /// Reads the whole file, and compares the parts that cost little.
    fn read(
        file: &File,
        rows: &dyn Rows,
        part: &Range<u64>,
        header: &[u8],
        sums: &BTreeMap<u64, String>,
    ) -> Result<Self, Failure> {
        let mut lines = BufReader::new(file);
        let (sum, trusted) = (Checksum::EMPTY, (0, header.len() as u64));
        let mut kept = Self { rows: 0, begin: 0, end: 0, sum, trusted, some: Spread::new() };
        let length = part.end - part.start;
        let mut line = Vec::new();
        loop {
            line.clear();
            let count = (&mut lines).take(LONGEST_LINE).read_until(b'\n', &mut line)? as u64;
            if line.ends_with(b"\n") {
                if kept.end == 0 && !header.is_empty() {
                    if line != header {
                        return Err(format!("the header is not of {}", rows.of()).into());
                    }
                    kept.begin = count;
                } else {
                    let point = part.start.saturating_add(kept.rows);
                    kept.rows += 1;
                    if kept.rows <= length && !rows.is_on_grid(&line, point)? {
                        return Err(not_this(rows.of(), kept.rows));
                    }
                    kept.some.push((kept.rows - 1, kept.end, count));
                }
                kept.end += count;
                kept.sum.add(&line);
                if sums.get(&kept.end).is_some_and(|sum| *sum == kept.sum.text()) {
                    kept.trusted = (kept.rows, kept.end);
                }
                if kept.rows.is_multiple_of(1024) {
                    interrupt::check()?;
                }
                continue;
            }
            if kept.rows > length {
                return Err(format!("{} rows, must be ≤ {length}, those of {}", kept.rows, rows.of()).into());
            }
            kept.is_beginning(&line, rows, part, header)?;
            return Ok(kept);
        }
    }

    /// Fails unless the text after the last complete line is the beginning of the next row.
    fn is_beginning(&self, rest: &[u8], rows: &dyn Rows, part: &Range<u64>, header: &[u8]) -> Outcome {
        let next = part.start + self.rows;
        let due = match rest {
            [] => Vec::new(),
            _ if self.end == 0 && !header.is_empty() => header.to_vec(),
            _ if next < part.end => rows.text(next)?,
            _ => Vec::new(),
        };
        if due.starts_with(rest) {
            return Ok(());
        }
        Err(match self.rows {
            0 => format!("it does not begin as {} does", rows.of()),
            n => format!("the text after row {n} is not of {}", rows.of()),
        }
        .into())
    }

    /// Compares evenly spaced rows, for one second.
    fn compare_some(&self, file: &File, rows: &dyn Rows, part: &Range<u64>) -> Outcome {
        let begin = Instant::now();
        let order = self.some.in_order();
        let here = Here::new();
        let (mut left, mut count) = (order.as_slice(), threads::count());
        // The number of rows compared at a time increases, because a single row can take longer than the
        // allowed time.
        while !left.is_empty() && begin.elapsed() < COMPARING {
            let (some, others) = left.split_at(count.min(left.len()));
            (left, count) = (others, 2 * count);
            let mut found = Vec::new();
            for &(row, start, count) in some {
                let mut line = Vec::new();
                let mut file = file;
                file.seek(SeekFrom::Start(start))?;
                file.take(count).read_to_end(&mut line)?;
                found.push((row, line));
            }
            let is_same = |(row, line): &(u64, Vec<u8>)| {
                let point = part.start + row;
                if here.run(|| rows.text(point))? == *line {
                    Ok(())
                } else {
                    Err(not_this(rows.of(), row + 1))
                }
            };
            threads::on_all(|| found.par_iter().try_for_each(is_same))?;
            interrupt::check()?;
        }
        Ok(())
    }

    /// Compares every row after a number of them that end at a position.
    fn compare_from(
        &self,
        (first, position): (u64, u64),
        file: &File,
        rows: &dyn Rows,
        part: &Range<u64>,
    ) -> Outcome {
        let mut file = file;
        file.seek(SeekFrom::Start(position))?;
        let mut found = BufReader::new(file);
        let mut row = first;
        progress::in_order(
            part.start + first..part.start + self.rows,
            |point| rows.text(point),
            |due| {
                let mut line = vec![0; due.len()];
                row += 1;
                if found.read_exact(&mut line).is_err() || line != due {
                    return Err(not_this(rows.of(), row));
                }
                Ok(())
            },
        )
    }
}

pub(crate) fn not_this(of: &str, row: u64) -> Failure {
    Failure::Input(format!("row {row} is not of {of}"))
}

/// Rows by number, position and length, evenly thinned as their number grows, and the last one.
struct Spread {
    rows: Vec<(u64, u64, u64)>,
    last: Option<(u64, u64, u64)>,
    step: u64,
}

impl Spread {
    const fn new() -> Self {
        Self { rows: Vec::new(), last: None, step: 1 }
    }

    fn push(&mut self, row: (u64, u64, u64)) {
        self.last = Some(row);
        if row.0.is_multiple_of(self.step) {
            self.rows.push(row);
        }
        if self.rows.len() > MOST_COMPARED {
            self.step *= 2;
            let step = self.step;
            self.rows.retain(|(number, _, _)| number.is_multiple_of(step));
        }
    }

    /// The rows in the order of the comparison: the ends first, then the middle, then the quarters, and so
    /// on.
    fn in_order(&self) -> Vec<(u64, u64, u64)> {
        let mut order: Vec<_> = self.rows.iter().copied().enumerate().collect();
        order.sort_by_key(|(place, _)| place.reverse_bits());
        self.last.into_iter().chain(order.into_iter().map(|(_, row)| row)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST_COMPARED, Spread};

    #[test]
    fn the_rows_compared_are_spread_evenly_and_have_both_ends() {
        for count in [1, 2, 1000, MOST_COMPARED as u64 + 1, 100_003] {
            let mut spread = Spread::new();
            (0..count).for_each(|row| spread.push((row, 3 * row, 3)));
            let mut numbers: Vec<u64> = spread.in_order().iter().map(|(number, _, _)| *number).collect();
            assert_eq!(numbers[..2.min(numbers.len())], [count - 1, 0][..2.min(numbers.len())]);
            numbers.sort_unstable();
            numbers.dedup();
            assert!(numbers.len() as u64 >= count.min(MOST_COMPARED as u64 / 2));
            assert!(numbers.len() <= MOST_COMPARED + 1);
            assert!(numbers.windows(2).all(|pair| pair[1] - pair[0] <= spread.step), "{count}");
        }
    }
}
