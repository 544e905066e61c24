//! Arrays of NumPy: one in a file `.npy`, several in an archive `.npz`, and the sparse matrices of `scipy.sparse.save_npz`.
//!
//! The crates npyz and ndarray-npy read the header with a parser generator, and an archive with encryption and codecs in C that NumPy never
//! writes; the archive here is the crate zip's, with deflate alone.

use super::entry::{Entry, Take, square};
use crate::system::described::MOST_COORDINATES;
use crate::system::node::nearest;
use std::fs::File;
use std::io::{Read, Seek};
use zip::ZipArchive;

/// An array as it is stored.
struct Array {
    shape: Vec<usize>,
    by_columns: bool,
    /// Its kind and the bytes of an item, such as f8.
    kind: char,
    width: usize,
    is_big: bool,
    bytes: Vec<u8>,
}

/// The most items of an array: those of the largest matrix.
const MOST: usize = MOST_COORDINATES * MOST_COORDINATES;

/// What a field of the header's dictionary has behind its name.
fn value<'h>(header: &'h str, name: &str) -> Option<&'h str> {
    let (_, rest) = header.split_once(&format!("'{name}'"))?;
    Some(rest.trim_start().strip_prefix(':')?.trim_start())
}

impl Array {
    fn read(mut source: impl Read) -> Result<Self, String> {
        let mut bytes = |count: usize| {
            let mut read = vec![0; count];
            source.read_exact(&mut read).map_err(|_| "must be a whole array of NumPy".to_owned())?;
            Ok::<_, String>(read)
        };
        let start = bytes(8)?;
        if !start.starts_with(b"\x93NUMPY") {
            return Err("must be an array of NumPy".to_owned());
        }
        let is_first = start.get(6) == Some(&1);
        let length = bytes(if is_first { 2 } else { 4 })?;
        let length = length
            .iter()
            .rev()
            .fold(0_usize, |sum, &byte| sum.saturating_mul(256).saturating_add(byte.into()));
        if length > 1 << 16 {
            return Err("must be an array of NumPy".to_owned());
        }
        let header = bytes(length)?;
        let header = String::from_utf8_lossy(&header);
        let no_header = || "must have a header with descr, fortran_order and shape".to_owned();
        let descr = value(&header, "descr").ok_or_else(no_header)?;
        let quoted = descr.strip_prefix(['\'', '"']).and_then(|rest| rest.split(['\'', '"']).next());
        let descr = quoted.ok_or("must have numbers, and no records")?;
        let by_columns = value(&header, "fortran_order").ok_or_else(no_header)?.starts_with("True");
        let shape = value(&header, "shape").and_then(|rest| rest.strip_prefix('(')?.split(')').next());
        let shape = shape.ok_or_else(no_header)?.split(',').map(str::trim).filter(|text| !text.is_empty());
        let shape: Vec<usize> = shape.map(str::parse).collect::<Result<_, _>>().map_err(|_| no_header())?;
        let mut letters = descr.chars();
        let is_big = letters.next() == Some('>');
        let kind = letters.next().unwrap_or(' ');
        let width: usize = letters.as_str().parse().unwrap_or(0);
        if !matches!((kind, width), ('f', 4 | 8) | ('i' | 'u', 1 | 2 | 4 | 8) | ('b', 1) | ('S', 1..=16)) {
            return Err(format!("has the type {descr}, must have f4, f8, integers or bool"));
        }
        let count = shape.iter().fold(1_usize, |product, &items| product.saturating_mul(items));
        if count > MOST {
            return Err(format!("has {count} items, must have ≤ {MOST}"));
        }
        let bytes = bytes(count.saturating_mul(width))?;
        Ok(Self { shape, by_columns, kind, width, is_big, bytes })
    }

    fn numbers(&self) -> Result<Vec<f64>, String> {
        if self.kind == 'S' {
            return Err("must have numbers".to_owned());
        }
        let number = |item: &[u8]| {
            let mut wide = [0_u8; 8];
            let own = wide.iter_mut().zip(item);
            own.for_each(|(to, from)| *to = *from);
            if self.is_big {
                wide.get_mut(..self.width).unwrap_or(&mut []).reverse();
            }
            let bits = u64::from_le_bytes(wide);
            // The sign of a shorter integer.
            let unused = 64_u32.saturating_sub(u32::try_from(self.width).unwrap_or(8).saturating_mul(8));
            match (self.kind, self.width) {
                ('f', 8) => f64::from_bits(bits),
                ('f', _) => {
                    let [a, b, c, d, ..] = wide;
                    f64::from(f32::from_le_bytes([a, b, c, d]))
                }
                ('i', _) => (bits.cast_signed() << unused >> unused) as f64,
                _ => bits as f64,
            }
        };
        Ok(self.bytes.chunks_exact(self.width.max(1)).map(number).collect())
    }
}

/// The size of the matrix in a file of NumPy.
pub(super) fn of_numpy(
    file: File,
    is_archive: bool,
    array: Option<&str>,
    size: Option<usize>,
    take: Take<'_>,
) -> Result<usize, String> {
    if !is_archive {
        return dense(&Array::read(std::io::BufReader::new(file))?, size, take);
    }
    let mut archive = Archive(ZipArchive::new(std::io::BufReader::new(file)).map_err(|e| e.to_string())?);
    let found = archive.0.file_names().filter_map(|name| Some(name.ok()?.strip_suffix(".npy")?.to_owned()));
    let mut names: Vec<String> = found.collect();
    names.sort();
    let known = || names.iter().map(String::as_str);
    if let Some(name) = array {
        if !known().any(|own| own == name) {
            return Err(format!("has no array {name}. {}", nearest(name, known())));
        }
        return archive.with(name, |array| dense(array, size, take));
    }
    if ["data", "format", "shape"].iter().all(|part| known().any(|own| own == *part)) {
        return sparse(&mut archive, size, take);
    }
    match names.as_slice() {
        [name] => archive.with(name, |array| dense(array, size, take)),
        [] => Err("has no array".to_owned()),
        several => Err(format!(
            "has the arrays {}: must name one, such as array = \"{}\"",
            several.join(", "),
            names.first().map_or("", String::as_str)
        )),
    }
}

struct Archive<R>(ZipArchive<R>);

impl<R: Read + Seek> Archive<R> {
    fn with<T>(&mut self, name: &str, of: impl FnOnce(&Array) -> Result<T, String>) -> Result<T, String> {
        let about = |e: String| format!("array {name}: {e}");
        let entry = self.0.by_name(&format!("{name}.npy")).map_err(|e| about(e.to_string()))?;
        Array::read(entry).and_then(|array| of(&array)).map_err(about)
    }

    /// The numbers of an array with one axis.
    fn list(&mut self, name: &str) -> Result<Vec<f64>, String> {
        self.with(name, |array| {
            if array.shape.len() != 1 {
                return Err("must have one axis".to_owned());
            }
            array.numbers()
        })
    }

    /// Places ≥ 0 and below a bound.
    fn places(&mut self, name: &str, below: usize) -> Result<Vec<usize>, String> {
        let place = |x: f64| {
            let place = x as usize;
            if x >= 0.0 && x.fract() == 0.0 && place < below {
                return Ok(place);
            }
            Err(format!("array {name}: {x} must be a whole number ≥ 0 and < {below}"))
        };
        self.list(name)?.into_iter().map(place).collect()
    }
}

fn dense(array: &Array, size: Option<usize>, take: Take<'_>) -> Result<usize, String> {
    let &[rows, columns] = array.shape.as_slice() else {
        return Err(format!("has {} axes, must have 2", array.shape.len()));
    };
    let n = square(rows, columns, size)?;
    let places = (0..n).flat_map(|first| (0..n).map(move |second| (first, second)));
    for ((first, second), x) in places.zip(array.numbers()?) {
        let (i, j) = if array.by_columns { (second, first) } else { (first, second) };
        take(n, i, j, &Entry::Number(x))?;
    }
    Ok(n)
}

/// The matrix of an archive of `scipy.sparse.save_npz`.
fn sparse<R: Read + Seek>(
    archive: &mut Archive<R>,
    size: Option<usize>,
    take: Take<'_>,
) -> Result<usize, String> {
    let format =
        archive.with("format", |array| Ok(String::from_utf8_lossy(&array.bytes).replace('\0', "")))?;
    let shape = archive.places("shape", usize::MAX)?;
    let &[height, width] = shape.as_slice() else {
        return Err(format!("has {} axes, must have 2", shape.len()));
    };
    let n = square(height, width, size)?;
    if !["coo", "csr", "csc"].contains(&format.as_str()) {
        return Err(format!("has the format {format}, must have csr, csc or coo"));
    }
    let data = archive.list("data")?;
    let agree = |name: &str, found: usize, due: usize| {
        if found == due { Ok(()) } else { Err(format!("array {name}: has {found} items, must have {due}")) }
    };
    let ((row, rows), (column, columns)) = if format == "coo" {
        (("row", archive.places("row", n)?), ("col", archive.places("col", n)?))
    } else {
        let ends = archive.places("indptr", data.len().saturating_add(1))?;
        agree("indptr", ends.len(), n.saturating_add(1))?;
        let pairs = || ends.iter().zip(ends.iter().skip(1));
        if let Some((from, to)) = pairs().find(|(from, to)| from > to) {
            return Err(format!("array indptr: {to} must be ≥ {from} before it"));
        }
        let each = pairs().zip(0..n);
        let slow = each.flat_map(|((from, to), place)| std::iter::repeat_n(place, to.saturating_sub(*from)));
        let (slow, fast) = (("indptr", slow.collect::<Vec<_>>()), ("indices", archive.places("indices", n)?));
        if format == "csr" { (slow, fast) } else { (fast, slow) }
    };
    agree(row, rows.len(), data.len())?;
    agree(column, columns.len(), data.len())?;
    for ((i, j), x) in rows.into_iter().zip(columns).zip(data) {
        take(n, i, j, &Entry::Number(x))?;
    }
    Ok(n)
}
