//! Guards, whose first zeros are events, and the Taylor series of rows over the state.

use super::first_passage::integer;
use super::matrix::{Matrix, Sparse, add_times};
use super::propagator::Bound;
use crate::float::Float;
use alloc::vec::Vec;

/// What a guard's zero means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Trigger {
    /// The sliding velocity is zero.
    Stops,
    /// The speed leaves its piece of the law.
    Piece(usize),
    /// The force reaches its bound in this direction.
    Releases { forward: bool },
    /// The normal load is zero.
    Parts,
    /// The normal load comes back.
    Meets,
    /// The stretch reaches the gap.
    Closes,
    /// The force of a stop is zero.
    Opens,
    /// A lifted stop is back within its gap.
    Clears,
    /// A lifted stop presses again.
    Presses,
    /// The law is not known beyond.
    Ends,
}

/// A guard: positive as long as its branch lasts.
#[derive(Debug, Clone)]
pub(crate) struct Guard<F> {
    pub(crate) element: usize,
    pub(crate) trigger: Trigger,
    pub(crate) row: Vec<F>,
    /// The other contacts of dependent directions that are released with this one.
    pub(crate) others: Vec<(usize, bool)>,
    /// The entries of the row that are not zero, where the branch has few.
    pub(crate) entries: Vec<(usize, F)>,
    /// The rounding of a corner of a law, where the branch has few entries.
    pub(crate) corner: F,
    /// The row whose product with |z| bounds the error of the Taylor polynomial of full degree, where the branch has many entries.
    pub(crate) error: Vec<F>,
    /// For each state its part of the Taylor coefficients over the step.
    pub(crate) taylor: Matrix<F>,
}

impl<F: Float> Guard<F> {
    pub(super) fn new(element: usize, trigger: Trigger, row: Vec<F>, others: Vec<(usize, bool)>) -> Self {
        let (entries, error, taylor) = (Vec::new(), Vec::new(), Matrix::zero(0, 0));
        Self { element, trigger, row, others, entries, corner: F::int(0), error, taylor }
    }

    /// The Taylor polynomial at z over a part of the step.
    pub(crate) fn polynomial(&self, z: &[F], part: F, c: &mut Vec<F>) {
        c.resize(self.taylor.columns(), F::int(0));
        self.taylor.transposed_of(z, c);
        if part != F::int(1) {
            let mut factor = F::int(1);
            for c in c.iter_mut() {
                *c = *c * factor;
                factor = factor * part;
            }
        }
    }
}

/// What the rows of a branch need.
pub(super) struct Series<'a, F> {
    pub(super) transposed: &'a Sparse<F>,
    pub(super) step: F,
    pub(super) bound: &'a Bound<F>,
    pub(super) degree: usize,
}

impl<F: Float> Series<'_, F> {
    /// The rows `g Aᵏ hᵏ/k!` for k = 0 … `last`, one after the other.
    pub(super) fn terms(&self, row: &[F], last: usize) -> Vec<F> {
        let mut terms = Vec::with_capacity((last + 1) * row.len());
        terms.extend_from_slice(row);
        series(self.transposed, self.step, last, row.len(), &mut terms);
        terms
    }

    /// The error bound of a row's polynomial of full degree.
    pub(super) fn error(&self, row: &[F]) -> Vec<F> {
        let terms = self.terms(row, self.degree + 1);
        self.error_of(&self.rounding(row), &terms, self.degree + 1)
    }

    /// The row of the rounding.
    pub(super) fn rounding(&self, row: &[F]) -> Vec<F> {
        let count = integer::<F>((self.degree + 1) * (row.len() + 3)) * F::epsilon();
        self.bound.of(row).into_iter().map(|x| x * count).collect()
    }

    /// The error bound where the term with this number is the first that is left out.
    pub(super) fn error_of(&self, rounding: &[F], terms: &[F], first: usize) -> Vec<F> {
        let mut error = rounding.to_vec();
        let size = rounding.len();
        if let Some(rest) = terms.get(first * size..(first + 1) * size) {
            add_times(&mut error, F::int(1), &self.bound.of(rest));
        }
        error
    }
}

/// Continues a list of vectors of a size with `Aᵏ x tᵏ/k!` up to k = `last`.
pub(super) fn series<F: Float>(a: &Sparse<F>, time: F, last: usize, size: usize, terms: &mut Vec<F>) {
    // A product writes whole blocks.
    terms.resize((last + 1) * size + 8, F::int(0));
    let mut rest = terms.as_mut_slice();
    for k in 1..=last {
        let Some((before, after)) = rest.split_at_mut_checked(size) else { break };
        let factor = time / integer(k);
        a.times_of(|x| x * factor, before, after);
        rest = after;
    }
    terms.truncate((last + 1) * size);
}

/// How many Taylor terms are above rounding over a time t ≤ h.
pub(super) fn degree_over<F: Float>(time: F, step: F, degree: usize) -> usize {
    let (part, least) = (time / step, F::epsilon() / F::int(64));
    let mut term = part;
    (1..degree)
        .find(|&k| {
            term = term * part / integer(k + 1);
            term <= least
        })
        .unwrap_or(degree)
}

/// The degree from which on the terms of eˣ, x ≤ `most`, are below rounding.
pub(super) fn degree_of_full_accuracy<F: Float>(most: F) -> usize {
    let (mut degree, mut term) = (1, most);
    let least = F::epsilon() / F::int(64);
    while term > least {
        degree += 1;
        term = term * most / integer(degree + 1);
    }
    degree
}

/// The matrix whose columns are the first vectors of this size in a list.
pub(super) fn columns_of<F: Float>(list: &[F], size: usize, count: usize) -> Matrix<F> {
    let mut matrix = Matrix::zero(size, count);
    for (k, vector) in list.chunks_exact(size.max(1)).take(count).enumerate() {
        vector.iter().enumerate().for_each(|(j, &x)| matrix.set(j, k, x));
    }
    matrix
}
