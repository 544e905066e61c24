//! The first place at which a guard, known as a polynomial with an error bound, is certainly negative.
//!
//! `p(s) = Σ cₖ sᵏ` on [0, 1]; its Bernstein coefficients `bᵢ = Σ_{k≤i} [C(i,k)/C(K,k)] cₖ` bound it from both
//! sides, and the number of their changes of sign is not below that of its zeros. A guard within its error bound
//! of zero counts as not yet passed: such a touch cannot be told from a passage. Where all coefficients are above
//! −error there is no passage; where they change sign once there is one zero, which a bracketed Newton's method
//! finds; else the interval is halved.

use super::matrix::add_times;
use crate::float::Float;
use crate::root::{newton_from, newton_within};
use alloc::vec::Vec;
use core::cell::Cell;

/// The Bernstein coefficients on [0, 1] of a polynomial.
pub(crate) fn bernstein<F: Float>(c: &[F]) -> Vec<F> {
    let mut b = c.to_vec();
    let degree = b.len().saturating_sub(1);
    let mut binomial = F::int(1);
    for (k, b) in b.iter_mut().enumerate() {
        *b = *b / binomial;
        // C(K, k+1) = C(K, k) (K − k)/(k + 1)
        binomial = binomial * integer::<F>(degree.saturating_sub(k)) / integer(k + 1);
    }
    let cells = Cell::from_mut(b.as_mut_slice()).as_slice_of_cells();
    for j in 0..degree {
        // From the end on, so that each one meets the one before it as it was.
        for pair in cells.get(j..).unwrap_or(&[]).windows(2).rev() {
            if let [before, b] = pair {
                b.set(b.get() + before.get());
            }
        }
    }
    b
}

/// [`bernstein`] of polynomials side by side: the coefficients are rows of this size, one after the other.
pub(crate) fn bernstein_of_rows<F: Float>(c: &mut [F], size: usize) {
    let degree = (c.len() / size.max(1)).saturating_sub(1);
    let mut binomial = F::int(1);
    for (k, row) in c.chunks_exact_mut(size.max(1)).enumerate() {
        row.iter_mut().for_each(|b| *b = *b / binomial);
        binomial = binomial * integer::<F>(degree.saturating_sub(k)) / integer(k + 1);
    }
    for j in 1..=degree {
        // From the end on, so that each row meets the one before it as it was.
        let mut rest = c.get_mut((j - 1) * size..).unwrap_or(&mut []);
        while let Some(at) = rest.len().checked_sub(2 * size) {
            let (before, last) = rest.split_at_mut(at + size);
            add_times(last, F::int(1), before.get(at..).unwrap_or(&[]));
            rest = before;
        }
    }
}

fn is_finite<F: Float>(b: &[F]) -> bool {
    b.iter().all(|b| b.is_finite())
}

/// A small integer.
pub(crate) fn integer<F: Float>(k: usize) -> F {
    F::int(i32::try_from(k).unwrap_or(i32::MAX))
}

/// `p(s)` and `p′(s)`.
pub(crate) fn value_and_slope<F: Float>(c: &[F], s: F) -> (F, F) {
    c.iter().rev().fold((F::int(0), F::int(0)), |(p, d), &c| (p * s + c, d * s + p))
}

/// The Bernstein coefficients on both halves.
pub(crate) fn halves<F: Float>(b: &[F]) -> (Vec<F>, Vec<F>) {
    let (mut left, mut right) = (Vec::with_capacity(b.len()), b.to_vec());
    let half = F::ratio(1, 2);
    for end in (0..b.len()).rev() {
        left.push(right.first().copied().unwrap_or(F::int(0)));
        // One row of de Casteljau's triangle; what it drops at the end is a coefficient of the right half.
        let mut next = right.get(1).copied();
        for i in 0..end {
            let following = right.get(i + 2).copied();
            if let (Some(place), Some(value)) = (right.get_mut(i), next) {
                *place = (*place + value) * half;
            }
            next = following;
        }
    }
    (left, right)
}

/// The first s in [0, 1] from which on p is certainly negative: the zero before it. `error` bounds the error of
/// p.
pub(crate) fn first_passage<F: Float>(c: &[F], error: F) -> Option<F> {
    // p(s) ≥ c₀ + s (c₁ − Σ|cₖ|), as after an event that has just begun.
    let (&first, rest) = c.split_first()?;
    let bend = rest.iter().skip(1).fold(F::int(0), |sum, c| sum + c.abs());
    let end = first + rest.first().copied().unwrap_or(F::int(0)) - bend;
    if first >= -error && end >= -error {
        return None;
    }
    let b = bernstein(c);
    let depth = F::precision() + 8;
    debug_assert!(error.is_finite() && is_finite(&b), "the caller has checked them: halving would not end");
    search(c, &b, F::int(0), F::int(1), error, depth)
}

/// The first zero of a guard over a part of a step: the one before p is certainly negative, or the one just before the end. The `reach` is the
/// whole step in lengths of the part.
pub(crate) fn first_zero<F: Float>(c: &[F], error: F, reach: F) -> Option<F> {
    first_passage(shortened(c, error), error).or_else(|| passage_at_end(c, error, reach))
}

/// The zero just before the end, where p falls through zero there and is within its error at the end, but with a slope that takes it out of
/// that within the `reach`, in lengths of the interval. Without this a sample just behind an event would be before it, by the error over the slope.
fn passage_at_end<F: Float>(c: &[F], error: F, reach: F) -> Option<F> {
    let one = F::int(1);
    let (end, slope) = value_and_slope(c, one);
    let falls = end < F::int(0) && slope * reach < F::int(-4) * error;
    if !falls || c.first().is_none_or(|&first| first <= F::int(0)) {
        return None;
    }
    let twice = one - F::int(2) * end / slope;
    let before = if twice > F::int(0) { twice } else { F::int(0) };
    let is_between = value_and_slope(c, before).0 > F::int(0);
    is_between.then(|| newton_within(before, one, |s| value_and_slope(c, s)))
}

fn search<F: Float>(c: &[F], b: &[F], low: F, high: F, error: F, depth: u32) -> Option<F> {
    if b.iter().all(|&b| b >= -error) {
        return None;
    }
    let (first, last) = (b.first().copied()?, b.last().copied()?);
    if first < -error || b.iter().all(|&b| b <= F::int(0)) {
        return Some(low);
    }
    let changes =
        b.iter().zip(b.iter().skip(1)).filter(|(a, b)| (**a > F::int(0)) != (**b > F::int(0))).count();
    if first > F::int(0) && last < -error && changes == 1 {
        let start = low + (high - low) * crossing(b);
        return Some(newton_from(start, low, high, |s| value_and_slope(c, s)));
    }
    if depth == 0 {
        return (last < -error).then_some(low);
    }
    let middle = low + (high - low) / F::int(2);
    let (left, right) = halves(b);
    search(c, &left, low, middle, error, depth - 1)
        .or_else(|| search(c, &right, middle, high, error, depth - 1))
}

/// Where the polygon of Bernstein coefficients first falls through zero, between 0 and 1.
fn crossing<F: Float>(b: &[F]) -> F {
    let pairs = b.iter().zip(b.iter().skip(1)).enumerate();
    let fall =
        pairs.filter(|(_, (a, b))| **a > F::int(0) && **b <= F::int(0)).map(|(k, (&a, &b))| (k, a / (a - b)));
    let (k, share) = fall.into_iter().next().unwrap_or((0, F::ratio(1, 2)));
    (integer::<F>(k) + share) / integer(b.len().saturating_sub(1).max(1))
}

/// Leaves out the last coefficients, as long as their sum is far below the error.
pub(crate) fn shorten<F: Float>(c: &mut Vec<F>, error: F) {
    c.truncate(shortened(c, error).len());
}

/// The coefficients without the last ones, as in [`shorten`].
pub(crate) fn shortened<F: Float>(mut c: &[F], error: F) -> &[F] {
    let mut left = error / F::int(16);
    while let [rest @ .., last] = c {
        left = left - last.abs();
        if left < F::int(0) || rest.is_empty() {
            break;
        }
        c = rest;
    }
    c
}

/// The greatest value of p on [0, 1], where it is above `known` by more than `error`.
pub(crate) fn greatest_above<F: Float>(c: &[F], known: F, error: F) -> F {
    greatest_place(c, known, error).0
}

/// The greatest value of p on [0, 1] and its place, where it is above `known` by more than `error`.
pub(crate) fn greatest_place<F: Float>(c: &[F], known: F, error: F) -> (F, Option<F>) {
    let (mut best, b) = ((known, None), bernstein(c));
    // Beyond the range of numbers halving would not end; the next step reports it.
    if is_finite(&b) && error.is_finite() {
        climb(c, &b, (F::int(0), F::int(1)), error, F::precision(), &mut best);
    }
    best
}

fn climb<F: Float>(c: &[F], b: &[F], ends: (F, F), error: F, depth: u32, best: &mut (F, Option<F>)) {
    let (low, high) = ends;
    for (value, at) in [(b.first(), low), (b.last(), high)] {
        if let Some(&value) = value.filter(|v| **v > best.0) {
            *best = (value, Some(at));
        }
    }
    if b.iter().all(|&b| b <= best.0 + error) {
        return;
    }
    let rising = |(a, b): (&F, &F)| *b > *a;
    let rises = || b.iter().zip(b.iter().skip(1)).map(rising);
    let changes = rises().zip(rises().skip(1)).filter(|(a, b)| a != b).count();
    if changes == 1 && rises().next() == Some(true) {
        // One zero of p′: the only maximum inside.
        let slope: Vec<F> = c.iter().enumerate().skip(1).map(|(k, &c)| c * integer(k)).collect();
        let at = newton_within(low, high, |s| value_and_slope(&slope, s));
        let value = value_and_slope(c, at).0;
        if value > best.0 {
            *best = (value, Some(at));
        }
        return;
    }
    if depth == 0 || changes == 0 {
        return;
    }
    let middle = low + (high - low) / F::int(2);
    let (left, right) = halves(b);
    climb(c, &left, (low, middle), error, depth - 1, best);
    climb(c, &right, (middle, high), error, depth - 1, best);
}
