//! A checksum of the rows of a file, kept beside it in `FILE.check`, so that a resumed file need not be computed again.
//!
//! A line of `FILE.check` has a number of bytes, from the beginning of the file to the end of a row, and the checksum of
//! these bytes. It is written after them, and may lag behind: rows after the last line are computed again.

use crate::output::with_suffix;
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use stickslip_front::text::open_regular;

/// The checksum FNV-1a of 64 bits. Each step is one-to-one, so that texts that differ in one byte have different ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Checksum(u64);

impl Checksum {
    /// That of no bytes.
    pub(crate) const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub(crate) fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    /// Sixteen hexadecimal digits.
    pub(crate) fn text(self) -> String {
        format!("{:016x}", self.0)
    }
}

/// The first line of `FILE.check`. A file that begins otherwise is not touched.
const FIRST: &str = "stickslip: bytes and checksums of the file of rows beside this one\n";

/// The greatest length of `FILE.check`: a line for each half second of weeks.
const LONGEST: u64 = 1 << 26;

/// The time between two lines.
const EVERY: Duration = Duration::from_millis(500);

fn place(file: &Path) -> PathBuf {
    with_suffix(file, ".check")
}

/// The checksums that were kept, by the number of bytes; none where there is no such file.
pub(super) fn kept(file: &Path) -> BTreeMap<u64, String> {
    let mut text = String::new();
    let read = open_regular(&place(file)).and_then(|found| found.take(LONGEST).read_to_string(&mut text));
    let Some(lines) = read.ok().and_then(|_| text.strip_prefix(FIRST)) else { return BTreeMap::new() };
    let line = |line: &str| {
        let (bytes, sum) = line.split_once(' ')?;
        Some((bytes.parse().ok()?, sum.to_owned()))
    };
    lines.lines().filter_map(line).collect()
}

/// A file of rows whose checksum is kept while it is written.
pub(crate) struct Checked<'a> {
    file: &'a File,
    /// The bytes written to the end of the last complete row, and their checksum.
    rows: (u64, Checksum),
    /// All bytes written, the beginning of a row included, and their checksum.
    all: (u64, Checksum),
    /// `FILE.check`, as long as it can be written.
    log: Option<File>,
    logged: Instant,
}

impl<'a> Checked<'a> {
    /// The file after so many bytes with this checksum.
    pub(super) fn new(name: &Path, file: &'a File, bytes: u64, sum: Checksum) -> Self {
        let (rows, log) = ((bytes, sum), Self::log(&place(name)).ok());
        let mut checked = Self { file, rows, all: rows, log, logged: Instant::now() };
        checked.begin_log();
        checked
    }

    /// Opens `FILE.check`, unless it is a file of other origin, or none, such as a pipe, which may have no other end.
    fn log(place: &Path) -> io::Result<File> {
        if fs::metadata(place).is_ok_and(|found| !found.is_file()) {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        let mut log = OpenOptions::new().create(true).truncate(false).read(true).write(true).open(place)?;
        let mut first = Vec::new();
        (&mut log).take(FIRST.len() as u64).read_to_end(&mut first)?;
        // It may have been cut by a kill.
        if FIRST.as_bytes().starts_with(&first) { Ok(log) } else { Err(io::ErrorKind::AlreadyExists.into()) }
    }

    /// Writes the file anew, with one line.
    fn begin_log(&mut self) {
        let emptied = |mut log: File| {
            log.set_len(0)?;
            log.seek(SeekFrom::Start(0))?;
            log.write_all(FIRST.as_bytes())?;
            Ok::<_, io::Error>(log)
        };
        self.log = self.log.take().and_then(|log| emptied(log).ok());
        self.note();
    }

    /// Writes a line. Without it the rows are only computed again.
    fn note(&mut self) {
        let (bytes, sum) = self.rows;
        let line = format!("{bytes} {}\n", sum.text());
        let written = |mut log: File| log.write_all(line.as_bytes()).map(|()| log);
        self.log = self.log.take().and_then(|log| written(log).ok());
        self.logged = Instant::now();
    }

    /// Keeps the checksum of all complete rows.
    pub(super) fn finish(mut self) {
        self.begin_log();
    }
}

impl Write for Checked<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.file.write(bytes)?;
        let written = bytes.get(..count).unwrap_or_default();
        let end = written.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1);
        let (rows, rest) = written.split_at(end);
        let add = |(length, mut sum): (u64, Checksum), part: &[u8]| {
            sum.add(part);
            (length + part.len() as u64, sum)
        };
        if !rows.is_empty() {
            self.all = add(self.all, rows);
            self.rows = self.all;
        }
        self.all = add(self.all, rest);
        if self.logged.elapsed() >= EVERY {
            self.note();
        }
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::Checksum;

    #[test]
    fn a_changed_byte_changes_the_checksum() {
        let sum = |bytes: &[u8]| {
            let mut sum = Checksum::EMPTY;
            sum.add(bytes);
            sum.text()
        };
        // The published value for "foobar".
        assert_eq!(sum(b"foobar"), "85944171f73967e8");
        let text: Vec<u8> = (0..200).collect();
        for place in 0..text.len() {
            for bit in 0..8 {
                let mut changed = text.clone();
                changed[place] ^= 1 << bit;
                assert_ne!(sum(&changed), sum(&text));
            }
        }
    }
}
