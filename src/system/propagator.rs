//! The exponential of a branch's matrix, by its series.
//!
//! The loads and the records depend on themselves alone, each pair of them on that pair: with the free states first,
//! `e^{At} = [E, G; 0, R]`, and R has a block of two rows for each pair. So the memory grows with the number of loads
//! and not with its square.

use super::first_passage::integer;
use super::matrix::{Matrix, Sparse, add_times, dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;

/// `(e^{At})ᵀ`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Propagator<F> {
    /// The columns of the free states: (E, G)ᵀ.
    pub(crate) free: Matrix<F>,
    /// The blocks of Rᵀ, one below the other; the last row is that of the constant.
    given: Matrix<F>,
}

impl<F: Float> Propagator<F> {
    pub(crate) fn zero(size: usize, free: usize) -> Self {
        Self { free: Matrix::zero(size, free), given: Matrix::zero(size - free, 2) }
    }

    /// The series of `(e^{At})ᵀ` from Aᵀ, for a matrix whose absolute values have a spectral radius of at most 1/t. Its terms are
    /// put into `terms`, where there is a place for them.
    pub(crate) fn new(
        transposed: &Sparse<F>,
        free: usize,
        time: F,
        degree: usize,
        terms: Option<&mut Self>,
    ) -> Self {
        let mut zero = Self::zero(transposed.rows().count(), free);
        (0..free).for_each(|i| zero.free.set(i, i, F::int(1)));
        let given = transposed.square_from(free);
        (0..given.rows().count()).for_each(|i| zero.given.set(i, i % 2, F::int(1)));
        let (of_free, of_given) = terms.map(|terms| (&mut terms.free, &mut terms.given)).unzip();
        Self {
            free: exponential(transposed, zero.free, time, degree, of_free),
            given: exponential(&given, zero.given, time, degree, of_given),
        }
    }

    /// The sum of the terms of a series, which are in this one, each by its factor.
    pub(crate) fn sum_of_terms(&self, factors: &[F], result: &mut Self) {
        self.free.sum_of_pushed(factors, &mut result.free);
        self.given.sum_of_pushed(factors, &mut result.given);
    }

    /// `e^{At} z`.
    #[inline]
    pub(crate) fn of(&self, z: &[F], result: &mut [F]) {
        let free = self.free.columns();
        let Some((to, given)) = result.split_at_mut_checked(free) else { return };
        self.free.transposed_of(z, to);
        let pairs = z.get(free..).unwrap_or(&[]).chunks(2);
        let mut blocks = self.given.rows();
        for (z, to) in pairs.zip(given.chunks_mut(2)) {
            match (z, to, blocks.next(), blocks.next()) {
                (&[x, y], [p, q], Some(&[a, b]), Some(&[c, d])) => {
                    *p = x * a + y * c;
                    *q = x * b + y * d;
                }
                (&[x], [p], Some(&[a, _]), None) => *p = x * a,
                _ => {}
            }
        }
    }

    /// `e^{At}` as a whole.
    pub(crate) fn dense(&self) -> Matrix<F> {
        let (size, free) = (self.free.rows().count(), self.free.columns());
        let mut dense = Matrix::zero(size, size);
        for (j, row) in self.free.rows().enumerate() {
            row.iter().enumerate().for_each(|(i, &x)| dense.set(i, j, x));
        }
        for (j, row) in self.given.rows().enumerate() {
            let first = free + j - j % 2;
            row.iter().enumerate().for_each(|(i, &x)| dense.set(first + i, free + j, x));
        }
        dense
    }

    /// The number of its entries in memory.
    pub(crate) const fn entries(&self) -> usize {
        self.free.entries() + self.given.entries()
    }
}

/// The powers `E^(2^k)` of the free part of `e^{Ah}`, by which many whole steps are one: those that have been asked for.
#[derive(Debug)]
pub(crate) struct Powers<F> {
    /// Transposed.
    list: RefCell<Vec<Matrix<F>>>,
}

impl<F: Float> Powers<F> {
    /// None yet.
    pub(crate) const fn new() -> Self {
        Self { list: RefCell::new(Vec::new()) }
    }

    /// Those of this step.
    pub(crate) fn begin(&self, whole: &Propagator<F>) {
        let mut list = self.list.borrow_mut();
        if list.is_empty() {
            list.push(whole.free.leading(whole.free.columns()));
        }
    }

    /// Applies E so many times to vectors.
    pub(crate) fn apply(&self, times: u32, vectors: &mut [Vec<F>]) {
        let mut list = self.list.borrow_mut();
        let mut to = vec![F::int(0); list.first().map_or(0, Matrix::columns)];
        for k in 0..u32::BITS - times.leading_zeros() {
            if let Some(last) = list.last().filter(|_| list.len() <= k as usize) {
                let next = last.times(last);
                list.push(next);
            }
            let Some(power) = list.get(k as usize).filter(|_| times >> k & 1 == 1) else { continue };
            for vector in vectors.iter_mut() {
                power.transposed_of(vector, &mut to);
                vector.copy_from_slice(&to);
            }
        }
    }

    /// The number of entries in memory.
    pub(crate) fn entries(&self) -> usize {
        self.list.borrow().iter().map(Matrix::entries).sum()
    }
}

/// A bound of `e^{|A|h}`, for products with rows from the left.
#[derive(Debug, Clone)]
pub(crate) struct Bound<F> {
    /// The rows of the free states: (E, G).
    free: Matrix<F>,
    /// As of a propagator.
    given: Matrix<F>,
}

impl<F: Float> Bound<F> {
    /// By |A|ᵀ. The series is cut: what is left out is below a unit of its terms.
    pub(crate) fn new(sizes: &Sparse<F>, free: usize, time: F, degree: usize) -> Self {
        let Propagator { free, given } = Propagator::new(sizes, free, time, degree, None);
        let more = |x: F| x + x * F::ratio(1, 64);
        Self { free: free.transposed().map(more), given: given.map(more) }
    }

    /// `|r| e^{|A|h}` of a row r, most of whose entries may be zero.
    pub(crate) fn of(&self, row: &[F]) -> Vec<F> {
        let mut result = vec![F::int(0); row.len()];
        let mut left = row.iter().map(|x| x.abs());
        for (own, x) in self.free.rows().zip(left.by_ref()) {
            if x != F::int(0) {
                add_times(&mut result, x, own);
            }
        }
        let given: Vec<F> = left.collect();
        let pairs = given.chunks(2).flat_map(|pair| [pair, pair]);
        let first = row.len().saturating_sub(given.len());
        let places = result.get_mut(first..).unwrap_or(&mut []).iter_mut();
        for ((place, block), pair) in places.zip(self.given.rows()).zip(pairs) {
            *place = *place + dot(block, pair);
        }
        result
    }

    /// The number of its entries in memory.
    pub(crate) const fn entries(&self) -> usize {
        self.free.entries() + self.given.entries()
    }
}

/// `e^{At} X` by the series, from X, whose terms are pushed to `terms`.
pub(crate) fn exponential<F: Float>(
    a: &Sparse<F>,
    x: Matrix<F>,
    time: F,
    degree: usize,
    mut terms: Option<&mut Matrix<F>>,
) -> Matrix<F> {
    let mut sum = x;
    let (mut term, mut next) = (sum.clone(), sum.clone());
    let mut keep = |term: &Matrix<F>| {
        if let Some(terms) = &mut terms {
            terms.push(term);
        }
    };
    keep(&term);
    for k in 1..=degree {
        a.times(&term, time / integer(k), &mut next);
        core::mem::swap(&mut term, &mut next);
        sum.plus(&term);
        keep(&term);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Thirteen steps at once are thirteen steps, one after the other.
    #[test]
    fn powers_are_as_many_steps() {
        // An oscillator: q′ = v, v′ = −q − 0.1 v.
        let rows = [vec![(1, 1.0)], vec![(0, -1.0), (1, -0.1)], vec![]];
        let transposed = Sparse::new(3, rows.into_iter()).transposed();
        let whole = Propagator::new(&transposed, 2, 0.4_f64, 20, None);
        let powers = Powers::new();
        powers.begin(&whole);
        let mut found = [vec![1.0, 0.3], vec![-0.2, 2.0]];
        let due = found.clone().map(|mut x| {
            for _ in 0..13 {
                let mut next = [0.0; 3];
                whole.of(&[x[0], x[1], 0.0], &mut next);
                x = next[..2].to_vec();
            }
            x
        });
        powers.apply(13, &mut found);
        for (a, b) in found.iter().flatten().zip(due.iter().flatten()) {
            assert!((a - b).abs() < 1e-15, "{a} {b}");
        }
        // Those with the exponents 1, 2, 4 and 8.
        assert_eq!(powers.list.borrow().len(), 4);
    }
}
