//! Large branches whose matrix has few entries: chains, frames and plates with their masses at the nodes.
//!
//! Nothing of their size squared is built. A step is the Taylor series of the state, and a guard over it is the polynomial `Σ (g Aᵏ z hᵏ/k!) sᵏ` of the
//! same terms. With the terms `tₖ = (|A| h)ᵏ |z|/k!` of the sizes, entry by entry, what is left out after the degree N is at most `|g| Σ_{k>N} tₖ`,
//! and the rounding `ε (K + 1)(d + 3) |g| Σ tₖ`, as in `branch.rs`, where d is now the greatest number of entries of a row.

use super::assembly::{Assembly, Part, Rule};
use super::first_passage::integer;
use super::guard::{Guard, degree_of_full_accuracy, degree_over};
use super::matrix::{Sparse, add_times, at};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;

/// The least number of free states from which on such a branch is followed in this way.
const LEAST: usize = 48;
/// A step of 1/ρ by matrices has a product for each entry of theirs, one by the series takes as long as so many of those for each entry of A.
const PRODUCTS: usize = 60;
/// The products of a guard with each state: ten coefficients and a bound, for the two guards of an element.
const OF_GUARDS: usize = 22;
/// The step in 1/ρ: a longer one has fewer terms in a unit of time, and a rounding of up to e³.
const REACH: i32 = 3;
/// How many states one bound is for.
const TIMES: u32 = 256;
/// The terms of the sizes beyond the degree: those that follow are below a unit of them.
const MORE: usize = 3;

/// Whether a system is so large that the derivative of a period takes as long as many periods.
pub(super) const fn is_large<F>(system: &Assembly<F>) -> bool {
    system.free >= LEAST
}

/// What such a branch needs beside its matrix.
#[derive(Debug, Clone)]
pub(crate) struct Few<F> {
    /// The step in 1/ρ, and the degree of full accuracy.
    pub(crate) reach: F,
    pub(crate) degree: usize,
    /// |A|.
    sizes: Sparse<F>,
    /// (K + 1)(d + 3) ε.
    rounding: F,
    last: RefCell<Errors<F>>,
}

/// The last error bounds: they hold for all states whose sizes are below those that they are of.
#[derive(Debug, Clone)]
struct Errors<F> {
    of: Vec<F>,
    errors: Vec<F>,
    /// How often they may still be taken: a motion may become smaller.
    left: u32,
}

impl<F: Float> Few<F> {
    /// For a matrix of a system, where it has few entries.
    pub(crate) fn new(system: &Assembly<F>, a: &Sparse<F>) -> Option<Self> {
        let Assembly { free, size, parts, massless, .. } = system;
        let is_hard = |part: &Part<F>| matches!(part.rule, Rule::Hard { .. });
        if !system.shortcuts
            || !is_large(system)
            || F::precision() > 64
            || !massless.is_empty()
            || parts.iter().any(is_hard)
        {
            return None;
        }
        let (entries, longest) =
            a.rows().take(*free).fold((0, 0), |(sum, most), row| (sum + row.len(), row.len().max(most)));
        let products = free.saturating_add(OF_GUARDS * parts.len()).saturating_mul(*size);
        let reach = F::int(REACH);
        let degree = degree_of_full_accuracy(reach);
        (entries.saturating_mul(PRODUCTS) <= products).then(|| Self {
            reach,
            degree,
            sizes: a.map(|x| x.abs()),
            rounding: F::epsilon() * integer((degree + 1) * (longest + 3)),
            last: RefCell::new(Errors { of: Vec::new(), errors: Vec::new(), left: 0 }),
        })
    }

    /// A function of the entries by which |g| bounds the error of the polynomial of a guard's row g over a step, at a state of these sizes.
    pub(crate) fn errors<R>(&self, sizes: &[F], step: F, degree: usize, of: impl FnOnce(&[F]) -> R) -> R {
        let mut last = self.last.borrow_mut();
        let holds = last.left > 0 && sizes.iter().zip(&last.of).all(|(x, most)| x <= most);
        if holds {
            last.left -= 1;
        } else {
            // Twice the sizes, so that what grows needs few of them.
            let known = if last.left > 0 { core::mem::take(&mut last.of) } else { Vec::new() };
            let most = sizes.iter().enumerate().map(|(i, &x)| (x + x).or_larger(at(&known, i)));
            let most: Vec<F> = most.collect();
            let left = if last.left > 0 { last.left - 1 } else { TIMES };
            *last = Errors { errors: self.new_errors(&most, step, degree), of: most, left };
        }
        of(&last.errors)
    }

    fn new_errors(&self, sizes: &[F], step: F, degree: usize) -> Vec<F> {
        let zero = F::int(0);
        let (mut term, mut next) = (sizes.to_vec(), vec![zero; sizes.len()]);
        let (mut sum, mut beyond) = (term.clone(), vec![zero; sizes.len()]);
        for k in 1..=degree + MORE {
            let factor = step / integer(k);
            self.sizes.times_of(|x| x * factor, &term, &mut next);
            core::mem::swap(&mut term, &mut next);
            add_times(if k <= degree { &mut sum } else { &mut beyond }, F::int(1), &term);
        }
        add_times(&mut beyond, self.rounding * F::ratio(65, 64), &sum);
        beyond
    }

    /// The number of its entries in memory.
    pub(crate) fn entries(&self) -> usize {
        2 * self.sizes.rows().map(<[_]>::len).sum::<usize>()
    }
}

impl<F: Float> Guard<F> {
    /// The polynomial over a stretch whose Taylor terms are given.
    pub(crate) fn polynomial_of(&self, terms: &[F], c: &mut Vec<F>) {
        c.clear();
        c.extend(terms.chunks_exact(self.row.len().max(1)).map(|term| {
            self.entries.iter().fold(F::int(0), |sum, &(j, x)| term.get(j).map_or(sum, |&z| sum + x * z))
        }));
    }

    /// Its error bound by the entries of all errors.
    pub(crate) fn error_by(&self, errors: &[F]) -> F {
        self.entries
            .iter()
            .fold(self.corner, |sum, &(j, x)| errors.get(j).map_or(sum, |&e| sum + x.abs() * e))
    }
}

/// The terms of a series over a part of its time: as many as are above rounding.
pub(crate) fn shortened_terms<F: Float>(terms: &mut Vec<F>, size: usize, part: F, degree: usize) {
    let terms_left = degree_over(part * F::int(REACH), F::int(1), degree) + 1;
    terms.truncate(terms_left * size);
    let mut factor = F::int(1);
    for term in terms.chunks_exact_mut(size.max(1)).skip(1) {
        factor = factor * part;
        term.iter_mut().for_each(|x| *x = *x * factor);
    }
}
