//! A file as columns of numbers, whatever its layout.

use super::lines::Lines;
use super::options::Options;
use super::sheet::{Found, Sheet, Sink};
use super::table;
use std::io::BufRead;

/// Reads a table below the lines that are left out.
pub(super) fn as_table(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    for _ in 0..sheet.asked.skip {
        if sheet.lines.next()?.is_none() {
            break;
        }
    }
    table::read(sheet, table::Known::default())
}

/// Reads a text as a table.
pub(super) fn read_as_table(
    text: &mut dyn BufRead,
    options: &Options<'_>,
    sink: &mut dyn Sink,
) -> Result<Found, String> {
    as_table(&mut Sheet { lines: Lines::new(text, options.name), asked: options, sink, channels: Vec::new() })
}
