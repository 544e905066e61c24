//! The numbers of a model, as they are checked: finite, of their length, and within their bounds.

use super::error::Error;
use super::matrix::Matrix;
use super::model::Record;
use crate::float::Float;
use crate::machine::error::written;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// The name of a place of a list, which counts from 1.
pub(super) fn place(list: &str, i: usize) -> String {
    format!("{list}[{}]", i + 1)
}

pub(super) fn check_record<F: Float>(name: &str, record: &Record<F>) -> Result<(), Error> {
    let (found, expected) = (record.values.len(), record.times.len());
    if found != expected {
        return Err(Error::Length { name: format!("{name}.values"), found, expected });
    }
    if expected < 2 {
        return Err(Error::Length { name: format!("{name}.times"), found: expected, expected: 2 });
    }
    for &x in record.times.iter().chain(&record.values) {
        finite(name, x)?;
    }
    // Two samples at one time are a step of the load; a third one, or no other time, is none.
    let is_short = record.times.first() == record.times.last();
    let later = record.times.iter().skip(2).map(Some).chain([None]);
    for ((&a, &b), after) in record.times.iter().zip(record.times.iter().skip(1)).zip(later) {
        if b < a || (b == a && (is_short || after == Some(&b))) {
            return Err(Error::NotIncreasing {
                name: format!("{name}.times"),
                value: written(a),
                next: written(b),
            });
        }
    }
    Ok(())
}

/// A square matrix of finite numbers.
pub(super) fn square<F: Float>(
    name: &str,
    rows: &[Vec<F>],
    n: usize,
    symmetric: bool,
) -> Result<Matrix<F>, Error> {
    if rows.len() != n {
        return Err(Error::Length { name: name.to_string(), found: rows.len(), expected: n });
    }
    for (i, row) in rows.iter().enumerate() {
        vector(&place(name, i), row, n)?;
    }
    let matrix = Matrix::from_rows(rows);
    if symmetric {
        for i in 0..n {
            for j in 0..i {
                let (value, mirrored) = (matrix.at(i, j), matrix.at(j, i));
                if value != mirrored {
                    let name = name.to_string();
                    let (value, mirrored) = (written(value), written(mirrored));
                    return Err(Error::NotSymmetric { name, row: i + 1, column: j + 1, value, mirrored });
                }
            }
        }
    }
    Ok(matrix)
}

/// A list of `n` finite numbers.
pub(super) fn vector<F: Float>(name: &str, list: &[F], n: usize) -> Result<Vec<F>, Error> {
    if list.len() != n {
        return Err(Error::Length { name: name.to_string(), found: list.len(), expected: n });
    }
    list.iter().enumerate().map(|(i, &x)| finite(&place(name, i), x)).collect()
}

/// A list of `n` finite numbers, or an empty one for zeros.
pub(super) fn padded<F: Float>(name: &str, list: &[F], n: usize) -> Result<Vec<F>, Error> {
    if list.is_empty() { Ok(vec![F::int(0); n]) } else { vector(name, list, n) }
}

/// Puts a list into a column.
pub(super) fn column<F: Float>(
    matrix: &mut Matrix<F>,
    j: usize,
    name: &str,
    list: &[F],
) -> Result<(), Error> {
    let n = matrix.rows().count();
    for (i, x) in padded(name, list, n)?.into_iter().enumerate() {
        matrix.set(i, j, x);
    }
    Ok(())
}

pub(super) fn finite<F: Float>(name: &str, value: F) -> Result<F, Error> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { name: name.to_string(), value: written(value) })
    }
}

pub(super) fn positive<F: Float>(name: &str, value: F) -> Result<F, Error> {
    if finite(name, value)? > F::int(0) {
        Ok(value)
    } else {
        Err(Error::NotPositive { name: name.to_string(), value: written(value) })
    }
}

pub(super) fn at_least<F: Float>(name: &str, value: F, least: F) -> Result<F, Error> {
    if finite(name, value)? >= least {
        Ok(value)
    } else {
        Err(Error::Below { name: name.to_string(), value: written(value), least: written(least) })
    }
}
