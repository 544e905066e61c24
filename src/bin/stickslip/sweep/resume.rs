//! Going on with a sweep that was broken off.

use super::rows::Rows;
use crate::bits::Value;
use crate::failure::Failure;
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

/// What a file already holds.
pub(crate) struct Done {
    pub(crate) header: bool,
    pub(crate) rows: u64,
}

/// Opens the file behind its last whole row; what follows that is cut off.
///
/// The header, the first and the last row must be those of this very sweep.
pub(crate) fn reopen<F: Value>(
    name: &Path,
    rows: &Rows<F>,
    part: &Range<u64>,
    header: bool,
) -> Result<(File, Done), Failure> {
    let bad = |what: String| Failure::Input(format!("--resume: {}: {what}", name.display()));
    let mut file = OpenOptions::new().read(true).write(true).open(name).map_err(|e| bad(e.to_string()))?;
    let (lines, last_line, end) = whole_lines(&mut file)?;
    let head = if header { rows.header()? } else { Vec::new() };
    let headed = u64::from(!head.is_empty() && lines > 0);
    let done = lines - headed;
    if done > part.end - part.start {
        return Err(bad(format!("{done} rows, must be ≤ {}, those of this sweep", part.end - part.start)));
    }
    let mut due = if headed == 1 { head } else { Vec::new() };
    if done > 0 {
        due.extend(rows.text(part.start..part.start + 1)?);
        let last = part.start + done - 1;
        if !starts_with(&mut file, last_line, &rows.text(last..last + 1)?)? {
            return Err(bad(format!("row {done} is not of this sweep")));
        }
    }
    if !starts_with(&mut file, 0, &due)? {
        return Err(bad("the first lines are not of this sweep".to_owned()));
    }
    file.set_len(end)?;
    file.seek(SeekFrom::Start(end))?;
    Ok((file, Done { header: headed == 1, rows: done }))
}

/// How many whole lines a file has, where the last of them starts, and where it ends.
fn whole_lines(file: &mut File) -> Result<(u64, u64, u64), Failure> {
    let (mut lines, mut last, mut end, mut place) = (0, 0, 0, 0);
    let mut block = vec![0; 1 << 16];
    loop {
        let count = file.read(&mut block)?;
        if count == 0 {
            return Ok((lines, last, end));
        }
        for byte in block.iter().take(count) {
            place += 1;
            if *byte == b'\n' {
                lines += 1;
                (last, end) = (end, place);
            }
        }
    }
}

/// Whether the file has this text from a place on.
fn starts_with(file: &mut File, place: u64, text: &[u8]) -> Result<bool, Failure> {
    let mut found = Vec::new();
    file.seek(SeekFrom::Start(place))?;
    file.take(text.len() as u64).read_to_end(&mut found)?;
    Ok(found == text)
}
