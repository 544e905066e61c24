//! A table of rows, each by its place, as text.

use crate::failure::Failure;
use crate::row::Row;
use std::ops::Range;
#[cfg(feature = "parquet")]
use stickslip_front::inputs::Input;

/// Rows of many columns, each computed from its number alone.
pub(crate) trait Table: Sync {
    /// The source of the rows, for error messages.
    fn of(&self) -> &'static str;

    /// The number of rows.
    fn len(&self) -> u64;

    /// A row without its answers, with the names of all rows.
    fn form(&self) -> &Row;

    /// The first rows of a range, at least one.
    fn rows(&self, points: Range<u64>) -> Vec<Result<Row, Failure>>;

    /// A row.
    fn row(&self, point: u64) -> Result<Row, Failure> {
        self.rows(point..point + 1).pop().unwrap_or(Err(Failure::Interrupted))
    }

    /// As [`super::resume::Rows::hold_their_grid`].
    fn hold_their_grid(&self) -> bool;

    /// As [`super::resume::Rows::is_on_grid`], for a row of CSV or of JSON lines.
    fn is_on_grid(&self, line: &[u8], point: u64, is_csv: bool) -> Result<bool, Failure>;

    /// What identifies the table, by name.
    #[cfg(feature = "parquet")]
    fn notes(&self) -> Vec<(String, String)>;
}

/// The typed inputs, and what else identifies a table, by name.
#[cfg(feature = "parquet")]
pub(crate) fn notes<const N: usize>(
    typed: &[(Input, String)],
    others: [(&str, Option<String>); N],
) -> Vec<(String, String)> {
    let typed = typed.iter().map(|(input, text)| (input.column(), text.clone()));
    typed.chain(others.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?)))).collect()
}
