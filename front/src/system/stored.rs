//! Matrices in files of their own: Matrix Market (`.mtx`), and arrays of NumPy (`.npy`, `.npz`) with those of `scipy.sparse.save_npz`.
//!
//! nalgebra-sparse reads Matrix Market, too, but into doubles alone, where `--bits` takes decimals as they are typed, and with a parser
//! generator.

mod entry;
#[cfg(feature = "npz")]
mod numpy;

use self::entry::{Entry, Take, check_size, square};
use super::node::{Fields, Node, Number};
use crate::text::{Folder, printable};
use serde_json::Value;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

/// The greatest length of a file with a matrix.
const LONGEST: u64 = 1 << 27;

/// A square matrix: rows of numbers, the name of a file, or a table of `file` and `array`. Its size is given, or its own.
pub(super) fn matrix<F: Number>(
    node: &Node<'_>,
    folder: &Folder<'_>,
    size: Option<usize>,
) -> Result<Vec<Vec<F>>, String> {
    match node.value() {
        Value::String(file) => in_file(node, folder, file, None, size),
        Value::Object(_) => of_fields(&node.fields()?, folder, size, &[]),
        _ => {
            let size = match size {
                Some(size) => size,
                None => node.list()?.len(),
            };
            check_size(size).map_err(|e| format!("{}: {e}", node.place()))?;
            node.matrix(size)
        }
    }
}

/// The matrix of the fields `file` and `array`, beside others that are read elsewhere.
pub(super) fn of_fields<F: Number>(
    fields: &Fields<'_>,
    folder: &Folder<'_>,
    size: Option<usize>,
    others: &[&'static str],
) -> Result<Vec<Vec<F>>, String> {
    // A misspelt name says more than a missing one.
    fields.end_with(&[&["file", "array"], others].concat())?;
    let node = fields.required("file")?;
    let array = fields.get("array").map(|node| node.text()).transpose()?;
    in_file(&node, folder, node.text()?, array, size)
}

fn in_file<F: Number>(
    node: &Node<'_>,
    folder: &Folder<'_>,
    file: &str,
    array: Option<&str>,
    size: Option<usize>,
) -> Result<Vec<Vec<F>>, String> {
    let zeros = |n: usize| vec![vec![F::int(0); n]; n];
    let mut rows: Vec<Vec<F>> = Vec::new();
    let mut take = |n: usize, i: usize, j: usize, entry: &Entry<'_>| {
        if rows.is_empty() {
            rows = zeros(n);
        }
        let value = match entry {
            Entry::Text(text) => text.parse().ok().filter(|x: &F| x.is_finite()),
            #[cfg(feature = "npz")]
            Entry::Number(x) => Some(F::from_f64(*x)).filter(|x| x.is_finite()),
        };
        let value = value.ok_or_else(|| match entry {
            Entry::Text(text) => format!("{text}: must be a finite number"),
            #[cfg(feature = "npz")]
            Entry::Number(x) => {
                format!("entry ({}, {}) = {x}: must be finite", i.saturating_add(1), j.saturating_add(1))
            }
        })?;
        if let Some(place) = rows.get_mut(i).and_then(|row| row.get_mut(j)) {
            *place = *place + value;
        }
        Ok(())
    };
    let found = read(folder, &folder.path(file), array, size, &mut take);
    let n = found.map_err(|e| format!("{}: {}: {}", node.place(), printable(file), printable(&e)))?;
    Ok(if rows.is_empty() { zeros(n) } else { rows })
}

/// The size of the matrix in a file, whose entries are taken.
fn read(
    folder: &Folder<'_>,
    file: &Path,
    array: Option<&str>,
    size: Option<usize>,
    take: Take<'_>,
) -> Result<usize, String> {
    let end = file.extension().and_then(|end| end.to_str()).unwrap_or("").to_ascii_lowercase();
    if !["mtx", "npy", "npz"].contains(&end.as_str()) {
        return Err("must be rows of numbers, or the name of a file .mtx, .npy or .npz".to_owned());
    }
    let opened = folder.open(file).map_err(|e| e.to_string())?;
    let length = opened.metadata().map_err(|e| e.to_string())?.len();
    if length > LONGEST {
        return Err(format!("has {length} bytes, must have ≤ {LONGEST}"));
    }
    match end.as_str() {
        "mtx" if array.is_some() => Err("must have no array: a file .mtx is one matrix".to_owned()),
        "mtx" => market(BufReader::new(opened.take(LONGEST)), size, take),
        "npy" if array.is_some() => Err("must have no array: a file .npy is one matrix".to_owned()),
        _ => of_numpy(opened, end == "npz", array, size, take),
    }
}

#[cfg(feature = "npz")]
use numpy::of_numpy;

#[cfg(not(feature = "npz"))]
fn of_numpy(
    _: std::fs::File,
    _: bool,
    _: Option<&str>,
    _: Option<usize>,
    _: Take<'_>,
) -> Result<usize, String> {
    Err("must be a file .mtx here: the command reads .npy and .npz, and in Python NumPy does".to_owned())
}

/// What is not stored of a matrix.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Symmetry {
    General,
    Symmetric,
    Skew,
}

/// The lines of a file that are no comments, with their numbers.
struct Lines<R> {
    source: R,
    line: String,
    number: usize,
}

impl<R: BufRead> Lines<R> {
    /// The next line, if there is one.
    fn next(&mut self) -> Result<Option<&str>, String> {
        loop {
            self.line.clear();
            self.number = self.number.saturating_add(1);
            let length = self.source.read_line(&mut self.line);
            match length.map_err(|e| format!("line {}: {e}", self.number))? {
                0 => return Ok(None),
                _ if self.number > 1 && (self.line.starts_with('%') || self.line.trim().is_empty()) => {}
                _ => return Ok(Some(self.line.trim())),
            }
        }
    }
}

/// A matrix in the format of Matrix Market.
fn market(source: impl BufRead, size: Option<usize>, take: Take<'_>) -> Result<usize, String> {
    let mut lines = Lines { source, line: String::new(), number: 0 };
    let first = lines.next()?.unwrap_or("").to_ascii_lowercase();
    let mut words = first.split_whitespace();
    if (words.next(), words.next()) != (Some("%%matrixmarket"), Some("matrix")) {
        return Err("line 1: must begin with %%MatrixMarket matrix".to_owned());
    }
    let mut word = |allowed: &[&str]| {
        let word = words.next().unwrap_or("");
        let place = allowed.iter().position(|known| *known == word);
        place.ok_or_else(|| format!("line 1: “{word}” must be one of {}", allowed.join(", ")))
    };
    let is_array = word(&["coordinate", "array"])? == 1;
    let is_pattern = word(&["real", "double", "integer", "pattern"])? == 3;
    let symmetry = match word(&["general", "symmetric", "skew-symmetric"])? {
        0 => Symmetry::General,
        1 => Symmetry::Symmetric,
        _ => Symmetry::Skew,
    };
    if is_array && is_pattern {
        return Err("line 1: pattern must be one of real, integer for an array".to_owned());
    }
    let sizes = lines.next()?.unwrap_or("");
    let sizes: Option<Vec<usize>> = sizes.split_whitespace().map(|word| word.parse().ok()).collect();
    let (rows, columns, given) = match (sizes.as_deref(), is_array) {
        (Some(&[rows, columns]), true) => (rows, columns, None),
        (Some(&[rows, columns, given]), false) => (rows, columns, Some(given)),
        _ => {
            let due = if is_array { "rows and columns" } else { "rows, columns and entries" };
            return Err(format!("line {}: must be the numbers of {due}", lines.number));
        }
    };
    let n = square(rows, columns, size)?;
    let mut both = |i: usize, j: usize, text: &str| {
        take(n, i, j, &Entry::Text(text))?;
        match symmetry {
            _ if i == j => Ok(()),
            Symmetry::General => Ok(()),
            Symmetry::Symmetric => take(n, j, i, &Entry::Text(text)),
            Symmetry::Skew => {
                let opposite = match text.strip_prefix('-') {
                    Some(size) => size.to_owned(),
                    None => format!("-{}", text.strip_prefix('+').unwrap_or(text)),
                };
                take(n, j, i, &Entry::Text(&opposite))
            }
        }
    };
    // Below the diagonal, or on it.
    let first_row = |column: usize| match symmetry {
        Symmetry::General => 0,
        Symmetry::Symmetric => column,
        Symmetry::Skew => column.saturating_add(1),
    };
    let mut count = 0_usize;
    let due = match given {
        Some(given) => given,
        None => (0..n).map(|column| n.saturating_sub(first_row(column))).sum(),
    };
    // The place of the next entry of an array, by columns.
    let (mut row, mut column) = (first_row(0), 0_usize);
    while let Some(line) = lines.next()? {
        count = count.saturating_add(1);
        let about = |what: &str| format!("{line}: {what}");
        let found = if count > due {
            Err(about(&format!("must be left out: the file has {due} entries")))
        } else if is_array {
            let found = both(row, column, line);
            row = row.saturating_add(1);
            if row >= n {
                column = column.saturating_add(1);
                row = first_row(column);
            }
            found
        } else {
            let mut words = line.split_whitespace();
            let place = |word: Option<&str>| {
                let place: usize = word?.parse().ok()?;
                place.checked_sub(1).filter(|place| *place < n)
            };
            let [i, j] = [place(words.next()), place(words.next())];
            match (i, j, if is_pattern { Some("1") } else { words.next() }, words.next()) {
                (None, ..) | (_, None, ..) => {
                    Err(about(&format!("must begin with a row and a column ≥ 1 and ≤ {n}")))
                }
                (_, _, _, Some(_)) | (_, _, None, _) => {
                    let due = if is_pattern { "a row and a column" } else { "a row, a column and a number" };
                    Err(about(&format!("must be {due}")))
                }
                (Some(i), Some(j), Some(_), None) if i < first_row(j) => {
                    let due = if symmetry == Symmetry::Skew { "below" } else { "on or below" };
                    Err(about(&format!("must be {due} the diagonal, because the rest follows from it")))
                }
                (Some(i), Some(j), Some(text), None) => both(i, j, text),
            }
        };
        if let Err(e) = found {
            return Err(format!("line {}: {e}", lines.number));
        }
    }
    if count < due {
        return Err(format!("has {count} entries, must have {due}"));
    }
    Ok(n)
}

#[cfg(test)]
mod tests {
    use super::{Entry, market};

    fn of(text: &str) -> Result<Vec<Vec<f64>>, String> {
        let mut rows = Vec::new();
        let n = market(text.as_bytes(), None, &mut |n, i, j, entry| {
            rows.resize(n, vec![0.0; n]);
            match entry {
                Entry::Text(text) => rows[i][j] += text.parse::<f64>().map_err(|_| "no number".to_owned())?,
                #[cfg(feature = "npz")]
                Entry::Number(x) => rows[i][j] += x,
            }
            Ok(())
        })?;
        rows.resize(n, vec![0.0; n]);
        Ok(rows)
    }

    #[test]
    fn each_kind_of_matrix_market_is_read() {
        for (text, due) in [
            ("coordinate real general\n% 1\n\n2 2 3\n1 1 4\n2 1 -1e-1\n2 1 .5\n", [[4.0, 0.0], [0.4, 0.0]]),
            ("coordinate integer symmetric\n2 2 2\n2 1 -3\n2 2 7\n", [[0.0, -3.0], [-3.0, 7.0]]),
            ("coordinate real skew-symmetric\n2 2 1\n2 1 -3\n", [[0.0, 3.0], [-3.0, 0.0]]),
            ("coordinate real skew-symmetric\n2 2 1\n2 1 +3\n", [[0.0, -3.0], [3.0, 0.0]]),
            ("coordinate pattern general\n2 2 1\n1 2\n", [[0.0, 1.0], [0.0, 0.0]]),
            ("coordinate real general\n2 2 0\n", [[0.0; 2]; 2]),
            ("array real general\n2 2\n1\n2\n3\n4\n", [[1.0, 3.0], [2.0, 4.0]]),
            ("ARRAY Real Symmetric\n2 2\n1\n2\n3\n", [[1.0, 2.0], [2.0, 3.0]]),
            ("array real skew-symmetric\n2 2\n5\n", [[0.0, -5.0], [5.0, 0.0]]),
        ] {
            assert_eq!(of(&format!("%%MatrixMarket matrix {text}")).unwrap(), due, "{text}");
        }
    }

    #[test]
    fn wrong_lines_are_named() {
        for (text, due) in [
            ("", "line 1: must begin with %%MatrixMarket matrix"),
            ("%%MatrixMarket vector array real general\n", "line 1: must begin with %%MatrixMarket matrix"),
            (
                "coordinate complex general\n",
                "line 1: “complex” must be one of real, double, integer, pattern",
            ),
            ("coordinate real\n", "line 1: “” must be one of general, symmetric, skew-symmetric"),
            ("array pattern general\n", "line 1: pattern must be one of real, integer for an array"),
            ("coordinate real general\n2 2\n", "line 2: must be the numbers of rows, columns and entries"),
            ("array real general\n% a\n2 -2\n", "line 3: must be the numbers of rows and columns"),
            ("array real general\n2 3\n", "has 2 rows and 3 columns, must have 2 of both"),
            ("array real general\n0 0\n", "has 0 rows, must be ≥ 1 and ≤ "),
            (
                "coordinate real general\n2 2 1\n3 1 4\n",
                "line 3: 3 1 4: must begin with a row and a column ≥ 1 and ≤ 2",
            ),
            (
                "coordinate real general\n2 2 1\n0 1 4\n",
                "line 3: 0 1 4: must begin with a row and a column ≥ 1 and ≤ 2",
            ),
            ("coordinate real general\n2 2 1\n1 1\n", "line 3: 1 1: must be a row, a column and a number"),
            ("coordinate pattern general\n2 2 1\n1 1 1\n", "line 3: 1 1 1: must be a row and a column"),
            ("coordinate real symmetric\n2 2 1\n1 2 1\n", "line 3: 1 2 1: must be on or below the diagonal"),
            ("coordinate real skew-symmetric\n2 2 1\n1 1 1\n", "line 3: 1 1 1: must be below the diagonal"),
            ("coordinate real general\n2 2 1\n1 1 x\n", "line 3: no number"),
            ("coordinate real general\n2 2 2\n1 1 1\n", "has 1 entries, must have 2"),
            ("array real general\n1 1\n1\n2\n", "line 4: 2: must be left out: the file has 1 entries"),
        ] {
            let whole = if text.is_empty() || text.starts_with('%') {
                text.to_owned()
            } else {
                format!("%%MatrixMarket matrix {text}")
            };
            let found = of(&whole).unwrap_err();
            assert!(found.starts_with(due), "{text}: {found}");
        }
    }
}
