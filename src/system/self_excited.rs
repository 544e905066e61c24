//! Steady motions without a load that varies: self-excited ones, such as that of a body on a belt, and rest.
//!
//! The period τ is an unknown. With the map P(x, τ) and the derivative f of the state, Newton's step solves
//!
//! `(I − J) δx − f(P) δτ = P(x, τ) − x`, `f(x)·δx = 0`,
//!
//! where the second line keeps the phase. The first guess is the time between the same events of a motion that has been
//! followed. One multiplier of a self-excited motion is 1: that of a shift in time.

use super::assembly::Assembly;
use super::error::Error;
use super::events::Event;
use super::follow::Follower;
use super::matrix::{Matrix, add_times, dot};
use super::motion::Motion;
use super::steady::{Mapped, Search, Steady, SteadyKind, multipliers};
use crate::float::Float;
use alloc::vec::Vec;

/// How often the span that is followed is doubled.
const DOUBLINGS: usize = 9;
/// The greatest number of repetitions of the first event that a period is tried with.
const MOST_REPEATED: usize = 16;

/// The motion that a start leads to, without harmonics.
pub(crate) fn self_excited<'a, F: Float>(
    system: &'a Assembly<F>,
    span: F,
    follower: Follower<'a, F>,
) -> Result<Steady<F>, Error> {
    let mut search = Search { system, follower, period: span };
    let mut amplitudes: Vec<F> = Vec::new();
    let mut followed = 0;
    let mut last = None;
    for doubling in 0..DOUBLINGS {
        let (start, motion) = match search.observed(None, 1) {
            Ok(seen) => seen,
            Err(Error::Unbounded { .. }) => break,
            Err(error) => return Err(error),
        };
        followed += 1_usize << doubling;
        let from = search.free();
        let amplitude = amplitude(&motion);
        let size = motion
            .max_displacement
            .iter()
            .chain(&motion.min_displacement)
            .fold(F::int(0), |m, x| m.or_larger(x.abs()));
        if amplitude <= size * F::epsilon() * F::int(4096) {
            let change = amplitude / size.or_larger(F::epsilon());
            let (kind, period) = (SteadyKind::Rest, F::int(0));
            return Ok(Steady {
                kind,
                period,
                periods: 1,
                start,
                motion,
                multipliers: Vec::new(),
                change,
                followed,
            });
        }
        for period in periods(&motion.events) {
            if let Some(found) = newton(&mut search, &from, period)? {
                let multipliers = multipliers(&found.mapped.tangent, system.free);
                // All but that of the shift in time.
                let grows = multipliers.iter().filter(|&&(re, im)| re.hypot(im) > 1.0 + 1e-6).count();
                if grows == 0 {
                    search.period = found.period;
                    let (start, motion) = search.observed(Some(&found.x), 1)?;
                    let (kind, period, change) = (SteadyKind::Periodic, found.period, found.by);
                    return Ok(Steady {
                        kind,
                        period,
                        periods: 1,
                        start,
                        motion,
                        multipliers,
                        change,
                        followed,
                    });
                }
            }
            search.follower.restart(&from)?;
        }
        search.follower.restart(&from)?;
        amplitudes.push(amplitude);
        last = Some((start, motion));
        search.period = search.period * F::int(2);
    }
    // Twice as long each time: what grows without bound has grown by more than a half three times, at the end.
    let grown = |pair: &[F]| matches!(pair, [a, b] if *b * F::int(2) > *a * F::int(3));
    let grows = amplitudes.len() < DOUBLINGS || amplitudes.windows(2).rev().take(3).all(grown);
    let Some((start, motion)) = last else {
        return Err(Error::Unbounded { time: crate::machine::error::written(span) });
    };
    let kind = if grows { SteadyKind::Growing } else { SteadyKind::Unsettled };
    let period = motion.duration;
    Ok(Steady {
        kind,
        period,
        periods: 1,
        start,
        motion,
        multipliers: Vec::new(),
        change: F::int(1),
        followed,
    })
}

/// The greatest difference of a coordinate's extremes.
fn amplitude<F: Float>(motion: &Motion<F>) -> F {
    let pairs = motion.max_displacement.iter().zip(&motion.min_displacement);
    pairs.fold(F::int(0), |most, (&a, &b)| most.or_larger(a - b))
}

/// The times after which the last events repeat themselves, the shortest first.
fn periods<F: Float>(events: &[Event<F>]) -> Vec<F> {
    let Some(last) = events.last() else { return Vec::new() };
    let same = |e: &&Event<F>| e.element == last.element && e.kind == last.kind;
    events.iter().rev().skip(1).filter(same).take(MOST_REPEATED).map(|e| last.time - e.time).collect()
}

/// A motion that closes.
struct Found<F> {
    x: Vec<F>,
    period: F,
    by: F,
    mapped: Mapped<F>,
}

/// Newton's method for the state and the period.
fn newton<F: Float>(search: &mut Search<'_, F>, from: &[F], period: F) -> Result<Option<Found<F>>, Error> {
    let (free, zero) = (search.system.free, F::int(0));
    let closed = F::epsilon() * F::int(4096);
    let (mut x, mut period) = (from.to_vec(), period);
    let mut best: Option<Found<F>> = None;
    for round in 0..12 {
        if period <= zero {
            break;
        }
        search.period = period;
        let Ok(mapped) = search.map(&x, 1, false) else { break };
        let by = search.distance(&mapped.to, &x, &mapped.sizes);
        // A motion that is not yet near itself is not near a cycle either.
        if !by.is_finite() || (round == 0 && by > F::ratio(1, 4)) {
            break;
        }
        let after = search.follower.branch().map_or_else(Vec::new, |b| b.derivative(&search.follower.z));
        search.follower.restart(&x)?;
        let before = search.follower.branch().map_or_else(Vec::new, |b| b.derivative(&search.follower.z));
        let mut matrix: Matrix<F> = Matrix::identity(free + 1);
        for (j, column) in mapped.tangent.iter().enumerate() {
            for (i, &value) in column.iter().enumerate() {
                let one = matrix.at(i, j);
                matrix.set(i, j, one - value);
            }
        }
        for (i, (&f, &g)) in after.iter().zip(&before).take(free).enumerate() {
            matrix.set(i, free, -f);
            matrix.set(free, i, g);
        }
        matrix.set(free, free, zero);
        let mut right: Vec<F> = mapped.to.iter().zip(&x).map(|(&a, &b)| a - b).collect();
        right.push(zero);
        let is_better = best.as_ref().is_none_or(|b| by < b.by);
        let stalls = best.as_ref().is_some_and(|b| by * F::int(2) > b.by && (b.by <= closed || round > 5));
        if is_better {
            best = Some(Found { x: x.clone(), period, by, mapped });
        }
        if by <= F::epsilon() * F::int(16) || stalls {
            break;
        }
        let (step, _) = matrix.solved(&right);
        add_times(&mut x, F::int(1), &step);
        period = period + step.get(free).copied().unwrap_or(zero);
        search.keep_bounds(&mut x);
    }
    let found = best.filter(|b| b.by <= closed);
    // A rest closes after any time.
    let moves = |b: &Found<F>| {
        let speed = b.x.get(search.system.n..2 * search.system.n).map_or(zero, |v| dot(v, v));
        speed > zero || !b.mapped.events.is_empty()
    };
    Ok(found.filter(moves))
}

/// The time that a free motion takes to show itself: 32 periods of the first frequency above zero.
pub(crate) fn span<F: Float>(frequencies: &[F]) -> F {
    let slowest = frequencies.iter().copied().find(|&w| w > F::int(0)).unwrap_or(F::int(1));
    F::int(64) * F::pi() / slowest
}
