//! The lines of a text, with their numbers. No more than one line is in memory, and one without an end is refused.

use crate::text::{UTF16, is_utf16};
use std::collections::VecDeque;
use std::io::{BufRead, Read};

/// The greatest length of a line in bytes: some files have all samples in one line.
const LONGEST: u64 = 1 << 24;

/// The most bytes that are looked at before they are read, but for a longer line.
const MOST_AHEAD: usize = 1 << 18;

/// A line: its number from 1, and its text without its end.
pub(super) type Line = (u64, String);

/// The lines of a source.
pub(super) struct Lines<'a> {
    pub(super) source: &'a mut dyn BufRead,
    name: &'a str,
    /// The number of lines that have been read.
    count: u64,
    /// The lines that were looked at.
    ahead: VecDeque<Line>,
}

impl<'a> Lines<'a> {
    pub(super) const fn new(source: &'a mut dyn BufRead, name: &'a str) -> Self {
        Self { source, name, count: 0, ahead: VecDeque::new() }
    }

    fn read(&mut self) -> Result<Option<Line>, String> {
        let mut bytes = Vec::new();
        let mut bounded = Read::take(&mut self.source, LONGEST);
        let length =
            bounded.read_until(b'\n', &mut bytes).map_err(|error| format!("{}: {error}", self.name))?;
        if length == 0 {
            return Ok(None);
        }
        self.count = self.count.saturating_add(1);
        let refused = |what: &str| Err(format!("{} line {}: {what}", self.name, self.count));
        if bytes.contains(&0) {
            return refused(if is_utf16(&bytes) { UTF16 } else { "must be text, but has a zero byte" });
        }
        if length as u64 == LONGEST && bytes.last() != Some(&b'\n') {
            return refused("must be shorter than 16 MiB");
        }
        // Old headers are in Latin-1, whose bytes are the first characters of Unicode.
        let text = match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => error.as_bytes().iter().map(|byte| char::from(*byte)).collect(),
        };
        // DOS ends a file by its own character.
        let text = text.trim_end_matches(['\n', '\r', '\u{1a}']).trim_start_matches('\u{feff}');
        Ok(Some((self.count, text.to_owned())))
    }

    /// The next line.
    pub(super) fn next(&mut self) -> Result<Option<Line>, String> {
        match self.ahead.pop_front() {
            Some(line) => Ok(Some(line)),
            None => self.read(),
        }
    }

    /// The next lines, up to a number and a size, which stay the next ones.
    pub(super) fn head(&mut self, count: usize) -> Result<Vec<Line>, String> {
        let size = |ahead: &VecDeque<Line>| ahead.iter().map(|(_, line)| line.len()).sum::<usize>();
        while self.ahead.len() < count
            && size(&self.ahead) < MOST_AHEAD
            && let Some(line) = self.read()?
        {
            self.ahead.push_back(line);
        }
        Ok(self.ahead.iter().take(count).cloned().collect())
    }

    /// Puts a line back.
    pub(super) fn put_back(&mut self, line: Line) {
        self.ahead.push_front(line);
    }
}
