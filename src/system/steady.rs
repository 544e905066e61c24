//! Steady motions: the period map, its exact derivative, and Newton's method.
//!
//! In a branch a disturbance δ of the state moves by `δ′ = A δ`. At an event, where the row g of a guard is zero and
//! the derivative of the state goes from f₋ to f₊, a disturbed motion is early or late by `g δ/(g f₋)`, so that
//! `δ₊ = δ₋ + (f₊ − f₋) g δ₋/(g f₋)`. The product of these over a period is the map's derivative J.
//!
//! Newton's step solves `(I − J) x = P(x₀) − x₀`. Where a rest keeps part of the state, or an elastic contact never
//! yields, I − J is singular; the limit of `Σ Jᵏ (P(x₀) − x₀)` lies in the range of I − J, and is `(I − J) y` with
//! `(I − J)² y = P(x₀) − x₀`.

use super::assembly::{Assembly, Rule};
use super::equation::Mode;
use super::error::Error;
use super::events::{Event, EventKind, Stretch, Watch};
use super::first_passage::integer;
use super::follow::Follower;
use super::matrix::{Matrix, add_times, dot};
use super::model::State;
use super::motion::{Motion, Observer, state};
use crate::float::Float;
use crate::machine::error::written;
use crate::named::named;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{DMatrix, Schur};

named! {
    /// The kind of a motion after a long time.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
    pub enum SteadyKind [name] {
        /// It repeats itself.
        Periodic = "periodic",
        /// Nothing moves.
        Rest = "rest",
        /// It grows without bound.
        Growing = "growing",
        /// It has not settled within the periods that were followed.
        Unsettled = "unsettled",
    }
}

/// The motion that a start leads to.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Steady<F> {
    /// Its kind.
    pub kind: SteadyKind,
    /// The period of the motion: that of the loads times [`Steady::periods`], or its own without loads; 0 at rest without
    /// loads.
    pub period: F,
    /// After how many periods of the loads it repeats itself; 1 where it does not.
    pub periods: usize,
    /// The state at the phase 0 of the loads; without loads at some instant.
    pub start: State<F>,
    /// One period of it; the last one followed, where it does not repeat itself.
    pub motion: Motion<F>,
    /// The multipliers of a small disturbance over the period, (real, imaginary), by size. They are computed at f64, and
    /// empty where the motion does not repeat itself.
    pub multipliers: Vec<(f64, f64)>,
    /// The change of the state over the period, relative to the motion's size.
    pub change: F,
    /// The number of periods that were followed; without loads, of spans of 32 periods of the lowest natural frequency.
    pub followed: usize,
}

/// The most periods that are followed.
const MOST_PERIODS: usize = 2048;
/// The greatest multiple of the loads' period.
const MOST_MULTIPLE: usize = 64;
/// The most steps of a period of the loads.
const MOST_STEPS: usize = 250_000;
/// The multiple of the followed motion within which a fixed point is looked for, where disturbances do not die away.
const NEAR: i32 = 1_000_000;

/// What a period shows: its events, and the greatest values of the three parts of the state at the ends of steps.
struct Seen<F> {
    events: Vec<(usize, EventKind)>,
    sizes: [F; 3],
    tangent: Option<Vec<Vec<F>>>,
    observer: Option<Observer<F>>,
    buffer: Vec<F>,
}

/// The parts of the state with one unit each: q, q′ and forces.
fn blocks<'a, F: Float>(system: &Assembly<F>, z: &'a [F]) -> [&'a [F]; 3] {
    let n = system.n;
    [0..n, n..2 * n, 2 * n..system.free].map(|r| z.get(r).unwrap_or(&[]))
}

fn largest<F: Float>(list: &[F]) -> F {
    list.iter().fold(F::int(0), |m, x| m.or_larger(x.abs()))
}

impl<F: Float> Watch<F> for Seen<F> {
    fn stretch(&mut self, system: &Assembly<F>, stretch: &Stretch<'_, F>) {
        let (branch, time) = (stretch.branch, stretch.time);
        if let Some(observer) = &mut self.observer {
            observer.stretch(system, stretch);
        }
        for (size, block) in self.sizes.iter_mut().zip(blocks(system, stretch.from)) {
            *size = size.or_larger(largest(block));
        }
        let Some(tangent) = &mut self.tangent else { return };
        let part = stretch.motion.is_none().then(|| branch.free_motion(time, system.free));
        let Some(motion) = stretch.motion.or(part.as_ref()) else { return };
        self.buffer.resize(system.free, F::int(0));
        for column in tangent {
            motion.transposed_of(column, &mut self.buffer);
            column.copy_from_slice(&self.buffer);
        }
    }

    fn event(&mut self, event: Event<F>) {
        self.events.push((event.element, event.kind));
        if let Some(observer) = &mut self.observer {
            observer.event(event);
        }
    }

    fn needs_changes(&self) -> bool {
        self.tangent.is_some()
    }

    fn changes(&mut self, guard: &[F], from: &[F], to: &[F]) {
        let speed = dot(guard, from);
        for column in self.tangent.iter_mut().flatten() {
            let late = dot(guard, column) / speed;
            for ((x, &a), &b) in column.iter_mut().zip(to).zip(from) {
                *x = *x + (a - b) * late;
            }
        }
    }
}

/// The search for a steady motion.
pub(super) struct Search<'a, F> {
    pub(super) system: &'a Assembly<F>,
    pub(super) follower: Follower<'a, F>,
    pub(super) period: F,
}

/// A fixed point of the period map, with the map there.
type Fixed<F> = (Vec<F>, Mapped<F>);

/// A step of the period map.
pub(super) struct Mapped<F> {
    pub(super) to: Vec<F>,
    pub(super) events: Vec<(usize, EventKind)>,
    pub(super) sizes: [F; 3],
    /// The columns of J, for the states that are not given functions of time.
    pub(super) tangent: Vec<Vec<F>>,
    /// The answers, where they were asked for.
    observed: Option<Answers<F>>,
}

/// A state, and the answers from there on.
type Answers<F> = (State<F>, Motion<F>);

impl<F: Float> Search<'_, F> {
    pub(super) fn free(&self) -> Vec<F> {
        self.follower.z.get(..self.system.free).unwrap_or(&[]).to_vec()
    }

    /// One period on, from where the motion is, with the derivative of the map before and with the answers, where asked.
    fn advance(&mut self, tangent: Option<Vec<Vec<F>>>, answers: bool) -> Result<Mapped<F>, Error> {
        self.follower.rewind();
        let first = answers.then(|| (self.follower.z.clone(), state(self.system, &self.follower)));
        let observer = first.as_ref().map(|(first, _)| Observer::new(self.system, first));
        let mut seen =
            Seen { events: Vec::new(), sizes: [F::int(0); 3], tangent, observer, buffer: Vec::new() };
        self.follower.run(self.period, &mut seen)?;
        let tangent = seen.tangent.unwrap_or_default();
        let observed = first
            .zip(seen.observer)
            .map(|((first, start), observer)| (start, observer.finish(self.system, &first, &self.follower)));
        Ok(Mapped { to: self.free(), events: seen.events, sizes: seen.sizes, tangent, observed })
    }

    /// `multiple` periods from a state, with the derivative, and with the answers of the first period, where asked.
    pub(super) fn map(&mut self, from: &[F], multiple: usize, answers: bool) -> Result<Mapped<F>, Error> {
        self.follower.restart(from)?;
        let mut all = self.advance(Some(self.directions()), answers)?;
        for _ in 1..multiple {
            let mapped = self.advance(Some(all.tangent), false)?;
            all.tangent = mapped.tangent;
            all.to = mapped.to;
            all.events.extend(mapped.events);
            for (size, new) in all.sizes.iter_mut().zip(mapped.sizes) {
                *size = size.or_larger(new);
            }
        }
        Ok(all)
    }

    /// The unit vectors, without what the present branch does not admit.
    fn directions(&self) -> Vec<Vec<F>> {
        let (system, free) = (self.system, self.system.free);
        let modes = self.follower.branch().map_or(&[][..], |b| &b.modes);
        let stuck: Vec<usize> =
            modes.iter().enumerate().filter(|(_, m)| matches!(m, Mode::Stuck)).map(|(i, _)| i).collect();
        let mut columns = Vec::with_capacity(free);
        for i in 0..free {
            let mut column = vec![F::int(0); system.size];
            if let Some(one) = column.get_mut(i) {
                *one = F::int(1);
            }
            super::next_branch::at_rest(system, &mut column, &stuck);
            for (part, mode) in system.parts.iter().zip(modes) {
                if let (Rule::Elastic { place, .. }, Mode::Yields { .. }) = (&part.rule, mode)
                    && let Some(force) = column.get_mut(*place)
                {
                    *force = F::int(0);
                }
            }
            column.truncate(free);
            columns.push(column);
        }
        columns
    }

    /// The difference of two states relative to the motion's size.
    pub(super) fn distance(&self, a: &[F], b: &[F], sizes: &[F; 3]) -> F {
        let difference: Vec<F> = a.iter().zip(b).map(|(&a, &b)| a - b).collect();
        let mut most = F::int(0);
        for (block, &size) in blocks(self.system, &difference).into_iter().zip(sizes) {
            let by = largest(block);
            if by > F::int(0) {
                most = most.or_larger(if size > F::int(0) { by / size } else { F::int(1) });
            }
        }
        most
    }

    /// Newton's method from a state: the fixed point with its derivative and its events, where it is one.
    fn newton(&mut self, from: &[F], multiple: usize) -> Result<Option<Fixed<F>>, Error> {
        let free = self.system.free;
        let enough = F::epsilon() * F::int(16);
        let closed = F::epsilon() * F::int(4096);
        let mut x = from.to_vec();
        let mut best: Option<(F, Vec<F>, Mapped<F>)> = None;
        for round in 0..12 {
            // Where Newton's next error will be below rounding, this round is the last.
            let is_last = multiple == 1
                && best.as_ref().is_some_and(|(least, ..)| *least < F::epsilon().sqrt() * F::int(16));
            let mapped = match self.map(&x, multiple, is_last) {
                Ok(mapped) => mapped,
                Err(Error::Interrupted) => return Err(Error::Interrupted),
                Err(_) => return Ok(None),
            };
            let by = self.distance(&mapped.to, &x, &mapped.sizes);
            let mut matrix: Matrix<F> = Matrix::identity(free);
            for (j, column) in mapped.tangent.iter().enumerate() {
                for (i, &value) in column.iter().enumerate() {
                    let one = matrix.at(i, j);
                    matrix.set(i, j, one - value);
                }
            }
            let right: Vec<F> = mapped.to.iter().zip(&x).map(|(&a, &b)| a - b).collect();
            if !by.is_finite() || !matrix.rows().all(|r| r.iter().all(|x: &F| x.is_finite())) {
                return Ok(None);
            }
            let better = best.as_ref().is_none_or(|(least, ..)| by < *least);
            let stalled =
                best.as_ref().is_some_and(|(least, ..)| by * F::int(2) > *least && *least <= closed);
            if better {
                best = Some((by, x.clone(), mapped));
            }
            let diverges = round > 3
                && best.as_ref().is_some_and(|(least, ..)| by * F::int(2) > *least && *least > closed);
            if by <= enough || stalled || diverges {
                break;
            }
            let (mut step, missing) = matrix.solved(&right);
            if missing > 0 {
                let (y, _) = matrix.times(&matrix).solved(&right);
                step = matrix.of(&y);
            }
            add_times(&mut x, F::int(1), &step);
            self.keep_bounds(&mut x);
        }
        Ok(best.filter(|(by, ..)| *by <= closed).map(|(_, x, mapped)| (x, mapped)))
    }

    /// Whether the followed motion does not lead to a fixed point, because a part of it is neither damped nor found at the fixed
    /// point: an undamped vibration of its own, or one at resonance, whose fixed point lies at infinity.
    fn is_kept(&self, multipliers: &[(f64, f64)], x: &[F], followed: &[F], sizes: &[F; 3]) -> bool {
        let own = |&(re, im): &(f64, f64)| im.abs() > 1e-9 && re.hypot(im) > 1.0 - 1e-12;
        let apart = self.distance(x, followed, sizes);
        (multipliers.iter().any(own) && apart > F::exp2i(-30))
            || (multipliers.first().is_some_and(|&(re, im)| re.hypot(im) > 1.0 - 1e-9)
                && apart > F::int(NEAR))
    }

    /// Elastic forces do not exceed their frictions.
    pub(super) fn keep_bounds(&self, x: &mut [F]) {
        for part in &self.system.parts {
            if let Rule::Elastic { place, friction, .. } = part.rule
                && let Some(force) = x.get_mut(place)
                && force.abs() > friction
            {
                *force = friction.with_sign_of(*force);
            }
        }
    }

    /// The answers over `multiple` periods from a state.
    pub(super) fn observed(&mut self, from: Option<&[F]>, multiple: usize) -> Result<Answers<F>, Error> {
        match from {
            Some(from) => self.follower.restart(from)?,
            None => self.follower.rewind(),
        }
        let first = self.follower.z.clone();
        let start = state(self.system, &self.follower);
        let mut observer = Observer::new(self.system, &first);
        let until = self.period * integer(multiple);
        self.follower.run(until, &mut observer)?;
        Ok((start, observer.finish(self.system, &first, &self.follower)))
    }

    /// The answers of the latest period that, with its energy, stays within the range of numbers.
    fn last_finite(&mut self, states: &[Vec<F>]) -> Result<Answers<F>, Error> {
        let mut last = Err(Error::Unbounded { time: written(self.period) });
        for from in states.iter().rev() {
            last = self.observed(Some(from), 1);
            match &last {
                Ok((_, motion)) => {
                    let works = [motion.stored, motion.load_work, motion.damper_work];
                    if works.iter().all(|work| work.is_finite()) {
                        break;
                    }
                }
                Err(Error::Unbounded { .. }) => {}
                Err(_) => break,
            }
        }
        last
    }
}

/// The motion that a start leads to.
pub(crate) fn steady<'a, F: Float>(
    system: &'a Assembly<F>,
    period: F,
    slowest: impl FnOnce() -> Option<F>,
    follower: Follower<'a, F>,
) -> Result<Steady<F>, Error> {
    let step = follower.branch().map_or(period, |branch| branch.step);
    if !step.is_finite() || period > step * integer(MOST_STEPS) {
        return Err(Error::Unsupported {
            name: "period of the loads".to_string(),
            condition: "must have at most 250000 steps of the system's fastest rate",
        });
    }
    let mut search = Search { system, follower, period };
    let mut states = vec![search.free()];
    let mut events: Vec<Vec<(usize, EventKind)>> = Vec::new();
    let mut sizes = [F::int(0); 3];
    let mut next = 4;
    let mut growth = [F::int(0); 2];
    let mut is_cut = false;
    while events.len() < MOST_PERIODS {
        let mapped = match search.advance(None, false) {
            Ok(mapped) => mapped,
            Err(Error::Unbounded { .. }) => break,
            // The motion is told as far as it was followed.
            Err(Error::TooLong { .. }) if !events.is_empty() => {
                is_cut = true;
                search.follower.renew();
                break;
            }
            Err(error) => return Err(error),
        };
        let before = states.last().cloned().unwrap_or_default();
        let change = search.distance(&mapped.to, &before, &mapped.sizes);
        sizes = mapped.sizes;
        states.push(mapped.to);
        events.push(mapped.events);
        let followed = events.len();
        if followed == MOST_PERIODS / 4 || followed == MOST_PERIODS / 2 {
            growth =
                [growth.last().copied().unwrap_or(F::int(0)), sizes.first().copied().unwrap_or(F::int(0))];
        }
        let settled = change <= F::epsilon() * F::int(2);
        if followed < next && !settled {
            continue;
        }
        if !settled {
            next *= 2;
        }
        let from = states.last().cloned().unwrap_or_default();
        for multiple in 1..=MOST_MULTIPLE.min(if settled { 1 } else { followed / 4 }) {
            // A motion of several periods comes back to its state, and not after one.
            let back = |k: usize| {
                let then = states.get((followed - k)..).and_then(|s| s.first());
                then.map_or(F::int(0), |then| search.distance(&from, then, &sizes))
            };
            if multiple > 1 && back(multiple) * F::int(2) > back(1) {
                continue;
            }
            // Motions of many periods are looked for where the followed one almost repeats itself.
            if multiple > 8 && back(multiple) > F::ratio(1, 1000) {
                continue;
            }
            let Some((x, mut mapped)) = search.newton(&from, multiple)? else { continue };
            // It may be one of fewer periods, which divide these.
            let mut found = multiple;
            for fewer in (1..multiple).filter(|&fewer| multiple.is_multiple_of(fewer)) {
                let part = search.map(&x, fewer, false)?;
                if search.distance(&part.to, &x, &part.sizes) <= F::epsilon() * F::int(65_536) {
                    (found, mapped) = (fewer, part);
                    break;
                }
            }
            if found < multiple && found == 1 {
                continue;
            }
            let multiple = found;
            let lasts = events.get(followed - multiple..).unwrap_or(&[]).concat();
            let multipliers = multipliers(&mapped.tangent, system.free);
            let unstable = multipliers.first().is_some_and(|&(re, im)| re.hypot(im) > 1.0 + 1e-6);
            if !settled && (lasts != mapped.events || unstable) {
                continue;
            }
            if !settled && search.is_kept(&multipliers, &x, &from, &sizes) {
                continue;
            }
            let change = search.distance(&mapped.to, &x, &mapped.sizes);
            let x = if settled { from } else { x };
            let (start, motion) = match mapped.observed {
                Some(observed) if !settled => observed,
                _ => search.observed(Some(&x), multiple)?,
            };
            let rests = motion.max_displacement == motion.min_displacement;
            let kind = if rests { SteadyKind::Rest } else { SteadyKind::Periodic };
            let period = period * integer(multiple);
            return Ok(Steady {
                kind,
                period,
                periods: multiple,
                start,
                motion,
                multipliers,
                change,
                followed,
            });
        }
        // The search has moved it.
        search.follower.restart(&from)?;
    }
    let followed = events.len();
    let size = sizes.first().copied().unwrap_or(F::int(0));
    let [early, middle] = growth;
    // Within a part of an own vibration a beginning looks like growth.
    let is_long = slowest().is_none_or(|longest| period * integer(followed) > longest * F::int(8));
    let grows = (followed < MOST_PERIODS && !is_cut)
        || (early > F::int(0)
            && is_long
            && middle * F::int(2) > early * F::int(3)
            && size * F::int(2) > middle * F::int(3));
    let before = states.iter().rev().nth(1).cloned().unwrap_or_default();
    let change = search.distance(states.last().map_or(&[][..], Vec::as_slice), &before, &sizes);
    let (start, motion) = search.last_finite(&states)?;
    let kind = if grows { SteadyKind::Growing } else { SteadyKind::Unsettled };
    Ok(Steady { kind, period, periods: 1, start, motion, multipliers: Vec::new(), change, followed })
}

/// The eigenvalues of the leading part of a matrix of columns, the largest first.
pub(super) fn multipliers<F: Float>(columns: &[Vec<F>], free: usize) -> Vec<(f64, f64)> {
    let entry = |i: usize, j: usize| columns.get(j).and_then(|c| c.get(i)).map_or(0.0, |x| x.to_f64());
    let matrix = DMatrix::<f64>::from_fn(free, free, entry);
    if !matrix.iter().all(|x| x.is_finite()) {
        return Vec::new();
    }
    let Some(schur) = Schur::try_new(matrix, f64::EPSILON, 10_000) else { return Vec::new() };
    let mut values: Vec<(f64, f64)> = schur.complex_eigenvalues().iter().map(|c| (c.re, c.im)).collect();
    values.sort_by(|a, b| b.0.hypot(b.1).total_cmp(&a.0.hypot(a.1)));
    values
}

/// The common period of the harmonics.
pub(crate) fn common_period<F: Float>(frequencies: &[F]) -> Result<F, Error> {
    let unsupported = |condition| Error::Unsupported { name: "harmonics".to_string(), condition };
    let least = frequencies
        .iter()
        .copied()
        .reduce(|a, b| if b < a { b } else { a })
        .ok_or_else(|| unsupported("must have an entry: a steady motion has the period of a load"))?;
    // Rounded multiples of a common frequency differ from it by a few units.
    let doubt = F::epsilon() * F::int(64);
    for multiple in 1..=1000 {
        let whole = |f: &F| {
            let ratio = *f / least * F::int(multiple);
            (ratio - ratio.round()).abs() <= doubt * ratio
        };
        if frequencies.iter().all(whole) {
            return Ok(F::int(2) * F::pi() * F::int(multiple) / least);
        }
    }
    Err(unsupported("must have a common period of at most 1000 periods of the slowest"))
}
