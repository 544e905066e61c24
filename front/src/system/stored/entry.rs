//! Entries of a matrix as they are stored, and its size.

use crate::system::described::MOST_COORDINATES;

/// An entry of a matrix, as it is stored.
pub(super) enum Entry<'a> {
    Text(&'a str),
    #[cfg(feature = "npz")]
    Number(f64),
}

/// What takes the size of a matrix, and its entries with their row and column from 0.
pub(super) type Take<'t> = &'t mut dyn FnMut(usize, usize, usize, &Entry<'_>) -> Result<(), String>;

/// A number of rows that may be.
pub(super) fn check_size(rows: usize) -> Result<(), String> {
    if rows == 0 || rows > MOST_COORDINATES {
        return Err(format!("has {rows} rows, must be ≥ 1 and ≤ {MOST_COORDINATES}"));
    }
    Ok(())
}

/// The size of a matrix with these rows and columns.
pub(super) fn square(rows: usize, columns: usize, size: Option<usize>) -> Result<usize, String> {
    check_size(rows)?;
    let due = size.unwrap_or(rows);
    if (rows, columns) != (due, due) {
        return Err(format!("has {rows} rows and {columns} columns, must have {due} of both"));
    }
    Ok(rows)
}
