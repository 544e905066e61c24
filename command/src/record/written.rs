//! A record as JSON, as a row of CSV, and as a row of a table.

use super::{Cell, Record, csv_text};
use crate::args::Header;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::outputs::plain;
use std::io::{self, Write};

impl<F: Value> Record<F> {
    /// One line of JSON.
    pub(crate) fn write_line(&self, out: &mut impl Write) -> Outcome {
        serde_json::to_writer(&mut *out, self)?;
        Ok(out.write_all(b"\n")?)
    }

    /// The row as text, of CSV or of JSON lines.
    pub(crate) fn line(&self, is_csv: bool) -> Result<Vec<u8>, Failure> {
        if is_csv {
            return csv_text(|writer| self.write_row(writer));
        }
        let mut text = Vec::new();
        self.write_line(&mut text)?;
        Ok(text)
    }

    /// One row of CSV, with an empty cell for a missing value. Each number has the digits that identify it.
    pub(crate) fn write_row(&self, out: &mut csv::Writer<impl Write>) -> Outcome {
        Ok(out.serialize(self.cells().collect::<Vec<_>>())?)
    }

    /// The header of the rows.
    pub(crate) fn write_header(&self, out: &mut csv::Writer<impl Write>, header: Header) -> Outcome {
        Ok(out.write_record(match header {
            Header::Names => self.names(),
            Header::Units => self.names_with_units(),
        })?)
    }

    /// The cells of a row, each with one value, those in physical units last.
    pub(crate) fn cells(&self) -> impl Iterator<Item = Cell<F>> + '_ {
        let physical = self.physical.values.iter().map(|(_, _, cell)| *cell);
        self.fields.iter().map(|(_, cell)| *cell).chain(physical).flat_map(|cell| cell.parts()).flatten()
    }

    /// The names of the cells of a row.
    pub(crate) fn names(&self) -> Vec<String> {
        let own = self.fields.iter().flat_map(|(key, cell)| cell.part_names(key.name));
        own.chain(self.physical.names()).collect()
    }

    /// The names of the cells of a row, with the unit in brackets after each dimensionless name that has one.
    fn names_with_units(&self) -> Vec<String> {
        let own = self.fields.iter().flat_map(|(key, cell)| {
            let unit = plain(key.measure.unit());
            let unit = if unit.is_empty() { unit } else { format!("[{unit}]") };
            cell.part_names(key.name).into_iter().map(move |name| name + &unit)
        });
        own.chain(self.physical.names()).collect()
    }

    /// One row of a table for reading, with seven digits and columns of equal width.
    pub(crate) fn write_table_row(&self, out: &mut impl Write) -> io::Result<()> {
        let beside = self.physical.values_beside().iter().map(|(_, _, cell)| cell);
        for (i, cell) in self.fields.iter().map(|(_, cell)| cell).chain(beside).enumerate() {
            let text = cell.text();
            let gap = if i == 0 { "" } else { "  " };
            write!(out, "{gap}{text:>COLUMN$}")?;
        }
        writeln!(out)
    }

    /// The header of a table for reading.
    pub(crate) fn write_table_header(&self, out: &mut impl Write) -> io::Result<()> {
        let own = self.fields.iter().map(|(key, _)| key.name.to_owned());
        let beside = self.physical.names().take(self.physical.values_beside().len());
        let names: Vec<String> = own.chain(beside).map(|name| format!("{name:>COLUMN$}")).collect();
        writeln!(out, "{}", names.join("  "))
    }
}

/// The width of a column in a table for reading.
const COLUMN: usize = 14;
