//! Steady motions without a load that varies: self-excited ones, such as that of a body on a belt, rest, and uniform motion.
//!
//! **Equilibria.** Rest and a uniform motion are fixed points of the map over any time, where the displacements that no force notices are left
//! out. Newton's method and the test of the approach are those of a load with a period (`steady.rs`).
//!
//! **Cycles.** The period τ is an unknown. With the map P(x, τ) and the derivative f of the state, Newton's step solves
//!
//! `(I − J) δx − f(P) δτ = P(x, τ) − x`, `f(x)·δx = 0`,
//!
//! where the second line keeps the phase. The first guess is the time between the same events of a motion that has been
//! followed, or a natural period where there are no events. One multiplier of a self-excited motion is 1: that of a shift in time. Let w be its
//! left eigenvector, w·f = 1. The motion that z goes to has the phase in which w·(z − x) = 0, and x is moved along the cycle by
//! w·(z − x) before the approach is tested.

use super::assembly::Assembly;
use super::error::Error;
use super::events::Event;
use super::first_passage::integer;
use super::fixed_point::{Fixed, defect, eigenvalues, kept_basis, newton, scaled, without_kept};
use super::follow::Follower;
use super::following::{End, Following};
use super::matrix::{Matrix, add_times, dot};
use super::period_map::PeriodMap;
use super::precision::small;
use super::steady::{Steady, SteadyKind};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// How often the span that is followed is doubled where the motion does not settle.
const DOUBLINGS: usize = 9;
/// The greatest number of repetitions of an event that a period is tried with, and the most parts of a period.
const MOST_REPEATED: usize = 16;
/// The periods of the slowest vibration in a span.
const PERIODS: usize = 32;

/// The motion that a start leads to, without harmonics. `longest` is a period of the slowest vibration, `others` are natural periods.
pub(crate) fn self_excited<'a, F: Float>(
    system: &'a Assembly<F>,
    longest: F,
    others: &[F],
    follower: Follower<'a, F>,
) -> Result<Steady<F>, Error> {
    let mut following = Following::new(system, follower, longest);
    let mut sizes: Vec<F> = Vec::new();
    let mut changes: Vec<F> = Vec::new();
    let mut spans = 0;
    // Twice as long each time: what grows without bound has grown by more than a half three times, at the end.
    let grown = |pair: &[F]| matches!(pair, [a, b] if *b * F::int(2) > *a * F::int(3));
    'following: for doubling in 0.. {
        following.map.period = longest;
        let mut events = Vec::new();
        for count in 0..PERIODS << doubling {
            let Some(mapped) = following.advance()? else { break 'following };
            let before = longest * integer(count);
            events
                .extend(mapped.events.into_iter().map(|event| Event { time: before + event.time, ..event }));
            // The last two spans are enough for any number of repetitions that is tried.
            if events.len() > 1 << 16 {
                events.drain(..1 << 15);
            }
        }
        spans += 1 << doubling;
        let [displacement, velocity, _] = following.take_greatest();
        let size = if following.map.drift.count() > 0 { velocity } else { displacement };
        sizes.push(size);
        if sizes.len() >= DOUBLINGS && sizes.windows(2).rev().take(3).all(grown) {
            break;
        }
        if let Some(found) = equilibrium(&mut following)? {
            return Ok(Steady { followed: spans, ..found });
        }
        let mut change = following.back(1);
        for period in periods(&events, others) {
            let (found, by) = cycle(&mut following, period)?;
            change = if by < change { by } else { change };
            if let Some(found) = found {
                return Ok(Steady { followed: spans, ..found });
            }
        }
        changes.push(change);
        let falls = matches!(changes.as_slice(), [.., a, b] if *b * F::int(4) <= *a * F::int(3));
        if doubling + 1 >= DOUBLINGS && !falls {
            break;
        }
    }
    following.map.period = longest;
    let grows = following.end == Some(End::Unbounded)
        || (sizes.len() >= DOUBLINGS && sizes.windows(2).rev().take(3).all(grown));
    let change = changes.last().copied().unwrap_or_else(|| following.back(1));
    let decay = match changes.as_slice() {
        [.., a, b] if b < a => {
            let periods = integer::<F>(PERIODS << (changes.len() - 1));
            F::from_f64(((*b / *a).to_f64().ln() / periods.to_f64()).exp())
        }
        _ => F::int(1),
    };
    let found = following.unsettled(grows, change, decay)?;
    Ok(Steady { followed: spans.max(1), ..found })
}

/// The rest or the uniform motion that the motion goes to, if there is one.
fn equilibrium<F: Float>(following: &mut Following<'_, F>) -> Result<Option<Steady<F>>, Error> {
    let (from, before) = (following.now(), following.map.follower.saved());
    let found = newton(&mut following.map, &from, 1)?;
    following.map.follower.resume(&before);
    let Some(fixed) = found.filter(|fixed| fixed.mapped.events.is_empty()) else { return Ok(None) };
    if !following.approaches(&fixed, 1, 0)? {
        return Ok(None);
    }
    let before = following.map.follower.saved();
    let found = following.answer(fixed, 1, false)?;
    following.map.follower.resume(&before);
    Ok(Some(found).filter(|found| matches!(found.kind, SteadyKind::Rest | SteadyKind::Uniform)))
}

/// The times after which the last events repeat themselves, the shortest first; without events natural periods.
fn periods<F: Float>(events: &[Event<F>], others: &[F]) -> Vec<F> {
    let Some(last) = events.last() else { return others.to_vec() };
    let same = |e: &&Event<F>| e.element == last.element && e.kind == last.kind;
    events.iter().rev().skip(1).filter(same).take(MOST_REPEATED).map(|e| last.time - e.time).collect()
}

/// A cycle: the fixed point of the map over its period.
struct Cycle<F> {
    period: F,
    fixed: Fixed<F>,
    /// The left eigenvector of the multiplier 1, in units of the sizes.
    left: Vec<F>,
}

/// The self-excited motion that the motion goes to, near a period, if there is one; and by how much the first guess does not close.
fn cycle<F: Float>(following: &mut Following<'_, F>, period: F) -> Result<(Option<Steady<F>>, F), Error> {
    let (from, before) = (following.now(), following.map.follower.saved());
    let (mut found, by) = newton_of_cycle(&mut following.map, &from, period)?;
    // The least period.
    if let Some(cycle) = &found {
        let count = cycle.fixed.mapped.events.len();
        let parts = (2..=MOST_REPEATED).rev().filter(|&part| count.is_multiple_of(part));
        for part in parts {
            let (x, period) = (cycle.fixed.x.clone(), cycle.period / integer(part));
            let (fewer, by) = newton_of_cycle(&mut following.map, &x, period)?;
            if fewer.is_some() && by <= F::epsilon().sqrt() / F::int(64) {
                found = fewer;
                break;
            }
        }
    }
    // The phase of the motion.
    for _ in 0..4 {
        let Some(cycle) = &found else { break };
        let apart = from.iter().zip(&cycle.fixed.x).map(|(&a, &b)| a - b).collect();
        let mut late = dot(&cycle.left, &following.map.scaled(apart, &cycle.fixed.mapped.sizes));
        if late.abs() <= cycle.period * F::epsilon() * F::int(64) || late.abs() >= cycle.period {
            break;
        }
        if late < F::int(0) {
            late = late + cycle.period;
        }
        let (x, period) = (cycle.fixed.x.clone(), cycle.period);
        following.map.period = late;
        following.map.follower.restart(&x)?;
        let moved = following.map.advance(None, false)?.to;
        found = newton_of_cycle(&mut following.map, &moved, period)?.0;
    }
    following.map.follower.resume(&before);
    let longest = following.map.period;
    let Some(cycle) = found else { return Ok((None, by)) };
    following.map.period = cycle.period;
    if !following.approaches(&cycle.fixed, 1, 1)? {
        following.map.period = longest;
        return Ok((None, by));
    }
    Ok((Some(following.answer(cycle.fixed, 1, false)?), by))
}

/// Newton's method for the state and the period of a cycle; and by how much the first guess does not close. It leaves the motion elsewhere.
fn newton_of_cycle<F: Float>(
    map: &mut PeriodMap<'_, F>,
    from: &[F],
    period: F,
) -> Result<(Option<Cycle<F>>, F), Error> {
    let (free, zero) = (map.system.free, F::int(0));
    let closed = F::epsilon() * F::int(4096);
    let (mut x, mut period) = (from.to_vec(), period);
    let mut best: Option<Cycle<F>> = None;
    let mut first = F::int(1);
    for round in 0..12 {
        if period <= zero || !period.is_finite() {
            break;
        }
        map.period = period;
        let mapped = match map.map(&x, 1, false, None) {
            Ok(mapped) => mapped,
            Err(Error::Interrupted) => return Err(Error::Interrupted),
            Err(_) => break,
        };
        let by = map.distance(&mapped.to, &x, &mapped.sizes);
        if round == 0 {
            first = by;
        }
        // A motion that is not yet near itself is not near a cycle either.
        if !by.is_finite() || (round == 0 && by > F::ratio(1, 4)) {
            break;
        }
        let sizes = mapped.sizes;
        let kept = kept_basis(map, &mapped);
        let flow = |map: &PeriodMap<'_, F>| -> Vec<F> {
            let follower = &map.follower;
            let mut flow = follower.branch().map_or_else(Vec::new, |b| b.derivative(&follower.z));
            flow.truncate(free);
            map.drift.remove(&mut flow);
            map.scaled(flow, &sizes)
        };
        let after = flow(map);
        map.follower.restart(&x)?;
        let before = flow(map);
        // A rest closes after any time.
        let speed = dot(&before, &before).sqrt();
        if speed <= zero || !speed.is_finite() {
            break;
        }
        let derivative = scaled(map, &mapped);
        let mut inner = defect(&derivative);
        for row in &kept {
            row.iter().enumerate().for_each(|(i, &x)| add_times(inner.row_mut(i), x, row));
        }
        let bordered = |inner: &Matrix<F>, column: &[F], row: &[F]| {
            let mut matrix = Matrix::zero(free + 1, free + 1);
            for i in 0..free {
                let to = matrix.row_mut(i);
                to.iter_mut().zip(inner.row(i)).for_each(|(to, &x)| *to = x);
                if let (Some(to), Some(&x)) = (to.last_mut(), column.get(i)) {
                    *to = x / speed;
                }
            }
            matrix.row_mut(free).iter_mut().zip(row).for_each(|(to, &x)| *to = x / speed);
            matrix
        };
        let mut right: Vec<F> = mapped.to.iter().zip(&x).map(|(&a, &b)| a - b).collect();
        right = map.scaled(right, &sizes);
        right.push(zero);
        let after: Vec<F> = after.iter().map(|&x| -x).collect();
        let (step, _) = bordered(&inner, &after, &before).solved(&right);
        let later = step.get(free).copied().unwrap_or(zero) / speed;
        let next = step.iter().take(free).fold((later / period).abs(), |most, x| most.or_larger(x.abs()));
        let least = best.as_ref().map(|b| b.fixed.by);
        let stalls = least.is_some_and(|least| by * F::int(2) > least && (least <= closed || round > 5));
        if least.is_none_or(|least| by < least) {
            let mut one = vec![zero; free];
            one.push(F::int(1));
            let (mut left, _) = bordered(&inner.transposed(), &before, &before).solved(&one);
            left.truncate(free);
            left.iter_mut().for_each(|x| *x = *x / speed);
            let (kept, is_first_order) = (kept.len(), false);
            let (x, multipliers) = (x.clone(), Vec::new());
            let fixed = Fixed { x, mapped, derivative, multipliers, kept, by, next, is_first_order };
            best = Some(Cycle { period, fixed, left });
        }
        if next <= F::epsilon() * F::int(16) || stalls || !next.is_finite() {
            break;
        }
        for (i, (x, &step)) in x.iter_mut().zip(step.iter().take(free)).enumerate() {
            *x = *x + step * map.size_at(&sizes, i);
        }
        period = period + later;
        map.keep_bounds(&mut x);
    }
    let found = best.filter(|b| b.fixed.by <= closed && b.fixed.next <= small(20));
    Ok((
        found.map(|mut cycle| {
            let all = eigenvalues(&cycle.fixed.derivative);
            // The multiplier of the shift in time is the first.
            let mut own = without_kept(all, cycle.fixed.kept, map.drift.count());
            let apart = |&(re, im): &(f64, f64)| (re - 1.0).hypot(im);
            let nearest = own.iter().enumerate().min_by(|(_, a), (_, b)| apart(a).total_cmp(&apart(b)));
            if let Some(place) = nearest.map(|(place, _)| place) {
                let one = own.remove(place);
                own.insert(0, one);
            }
            cycle.fixed.multipliers = own;
            cycle
        }),
        first,
    ))
}

/// The period of the slowest vibration, and those of all, shortest first: without springs the time of the slowest damper, or
/// a time in which forces move the masses.
pub(crate) fn natural_periods<F: Float>(frequencies: &[F], rate: F) -> (F, Vec<F>) {
    let turn = F::int(2) * F::pi();
    let greatest = frequencies.iter().fold(F::int(0), |most, &w| most.or_larger(w));
    // A rigid motion may have a frequency of rounding.
    let mut all: Vec<F> =
        frequencies.iter().filter(|w| **w > greatest * F::exp2i(-20)).map(|&w| turn / w).collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
    let without = if rate > F::int(0) && rate.is_finite() { turn / rate } else { turn };
    (all.last().copied().unwrap_or(without), all)
}
