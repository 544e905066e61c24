//! The map P of the state over a period, and its exact derivative J.
//!
//! In a branch a disturbance δ of the state moves by `δ′ = A δ`. At an event, where the row g of a guard is zero and
//! the derivative of the state goes from f₋ to f₊, a disturbed motion is early or late by `g δ/(g f₋)`, so that
//! `δ₊ = δ₋ + (f₊ − f₋) g δ₋/(g f₋)`. A blow at a stop with a restitution changes the velocities by R, too:
//! `δ₊ = R δ₋ + (f₊ − R f₋) g δ₋/(g f₋)`. The product of these over a period is J.

use super::assembly::{Assembly, Rule};
use super::blow::{Blow, Reset, beside, place_at_gap};
use super::drift::{Drift, Natural};
use super::error::Error;
use super::events::{Event, EventKind, Stretch, Watch};
use super::first_passage::integer;
use super::follow::Follower;
use super::matrix::{add_times, clear, dot};
use super::mode::{Mode, places, yields};
use super::model::State;
use super::motion::{Motion, Observer, state};
use super::propagator::Powers;
use crate::float::Float;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// An event of a period, without its time.
pub(super) type Happened = (usize, EventKind);

/// What a period shows: its events, and the greatest values of the three parts of the state at the ends of steps.
struct Seen<F> {
    events: Vec<Event<F>>,
    sizes: [F; 3],
    tangent: Option<Vec<Vec<F>>>,
    /// By how much each column is late at the events of this instant; nothing at a sample.
    late: Vec<F>,
    observer: Option<Observer<F>>,
    buffer: Vec<F>,
    /// Whole steps of one branch that have not moved the columns yet, with their number: many are one product.
    pending: Option<(Rc<Powers<F>>, u32)>,
}

impl<F: Float> Seen<F> {
    /// Moves the columns by the whole steps that are left.
    fn catch_up(&mut self) {
        if let (Some(tangent), Some((powers, times))) = (&mut self.tangent, self.pending.take()) {
            powers.apply(times, tangent);
        }
    }
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
        self.late.clear();
        if self.tangent.is_none() {
            return;
        }
        let are_few = |tangent: &Vec<Vec<F>>| tangent.len() * 16 <= system.free;
        let by_series = branch.few.is_some() && stretch.leap.is_none();
        if stretch.is_whole && !(by_series && self.tangent.as_ref().is_some_and(are_few)) {
            match &mut self.pending {
                Some((powers, times)) if Rc::ptr_eq(powers, &branch.powers) => {
                    *times = times.saturating_add(1)
                }
                _ => {
                    self.catch_up();
                    branch.powers.begin(branch.whole());
                    self.pending = Some((branch.powers.clone(), 1));
                }
            }
            return;
        }
        self.catch_up();
        let Some(tangent) = &mut self.tangent else { return };
        if by_series {
            return branch.move_columns(tangent, time);
        }
        let part = stretch.motion.is_none().then(|| match &stretch.leap {
            Some(leap) => leap.free_motion(system.free),
            None => branch.free_motion(time, system.free),
        });
        let Some(motion) = stretch.motion.map(|motion| &motion.free).or(part.as_ref()) else { return };
        self.buffer.resize(system.free, F::int(0));
        for column in tangent {
            motion.transposed_of(column, &mut self.buffer);
            column.copy_from_slice(&self.buffer);
        }
    }

    fn event(&mut self, event: Event<F>) {
        self.events.push(event);
        if let Some(observer) = &mut self.observer {
            observer.event(event);
        }
    }

    fn needs_changes(&self) -> bool {
        self.tangent.is_some()
    }

    fn blow(&mut self, system: &Assembly<F>, blow: &Blow<F>, to: &[F]) {
        if let Some(observer) = &mut self.observer {
            observer.blow(system, blow, to);
        }
    }

    fn changes(&mut self, guard: Option<&[F]>, reset: Option<&Reset<F>>, from: &[F], to: &[F]) {
        self.catch_up();
        let tangent = self.tangent.get_or_insert_default();
        if let Some(guard) = guard {
            let speed = dot(guard, from);
            self.late.clear();
            self.late.extend(tangent.iter().map(|column| dot(guard, column) / speed));
        }
        let mut from = from.to_vec();
        if let Some(reset) = reset {
            tangent.iter_mut().for_each(|column| reset.apply(column));
            reset.apply(&mut from);
        }
        for (column, &late) in tangent.iter_mut().zip(&self.late) {
            for ((x, &a), &b) in column.iter_mut().zip(to).zip(&from) {
                *x = *x + (a - b) * late;
            }
        }
    }
}

/// The motion with the map over a period.
pub(super) struct PeriodMap<'a, F> {
    pub(super) system: &'a Assembly<F>,
    pub(super) follower: Follower<'a, F>,
    pub(super) period: F,
    pub(super) drift: Drift<F>,
    natural: Natural<F>,
    /// The steps so far.
    pub(super) steps: u64,
}

/// A step of the period map.
pub(super) struct Mapped<F> {
    /// The state at the end, with the part in U of the state at the beginning.
    pub(super) to: Vec<F>,
    /// The part in U by which the displacements have moved on.
    pub(super) drift: Vec<F>,
    pub(super) events: Vec<Event<F>>,
    pub(super) sizes: [F; 3],
    /// The columns of J in the quotient, for the states that are not given functions of time.
    pub(super) tangent: Vec<Vec<F>>,
    /// What the elements do at the beginning.
    pub(super) modes: Vec<Mode>,
    /// The answers, where they were asked for.
    pub(super) observed: Option<Answers<F>>,
}

/// A state, and the answers from there on.
pub(super) type Answers<F> = (State<F>, Motion<F>);

impl<'a, F: Float> PeriodMap<'a, F> {
    pub(super) fn new(system: &'a Assembly<F>, follower: Follower<'a, F>, period: F) -> Self {
        let (drift, natural) = (Drift::new(system, period), Natural::new(system, period));
        Self { system, follower, period, drift, natural, steps: 0 }
    }

    pub(super) fn free(&self) -> Vec<F> {
        self.follower.z.get(..self.system.free).unwrap_or(&[]).to_vec()
    }

    /// One period on, from where the motion is, with the derivative of the map before and with the answers, where asked. The
    /// displacements are then moved back by their drift, which changes nothing.
    pub(super) fn advance(
        &mut self,
        tangent: Option<Vec<Vec<F>>>,
        answers: bool,
    ) -> Result<Mapped<F>, Error> {
        let system = self.system;
        self.follower.rewind();
        let (from, modes) = (self.follower.z.clone(), self.modes());
        let start = answers.then(|| state(system, &self.follower));
        let observer = answers.then(|| Observer::new(system, &from));
        let mut seen = Seen {
            events: Vec::new(),
            sizes: [F::int(0); 3],
            tangent,
            late: Vec::new(),
            observer,
            buffer: Vec::new(),
            pending: None,
        };
        let done = self.follower.run(self.period, &mut seen);
        seen.catch_up();
        self.steps = self.steps.saturating_add(self.follower.renew());
        done?;
        let moved: Vec<F> = self.follower.z.iter().zip(&from).take(system.n).map(|(&a, &b)| a - b).collect();
        let observed =
            start.zip(seen.observer).map(|(start, o)| (start, o.finish(system, &from, &self.follower)));
        // Rounding of what is prescribed does not add up.
        self.follower.rewind();
        let mut drift = self.drift.part(&moved);
        if self.drift.count() > 0 {
            drift.iter_mut().for_each(|x| *x = -*x);
            self.follower.shift(&drift);
            drift.iter_mut().for_each(|x| *x = -*x);
        }
        let mut tangent = seen.tangent.unwrap_or_default();
        tangent.iter_mut().for_each(|column| self.drift.remove(column));
        Ok(Mapped {
            to: self.free(),
            drift,
            events: seen.events,
            sizes: self.sizes(seen.sizes),
            tangent,
            modes,
            observed,
        })
    }

    /// The sizes of the three parts of the state: those that were seen, of which none is far below what loads, frictions and the
    /// springs make. A motion that is smaller yet keeps its digits beside them.
    fn sizes(&self, seen: [F; 3]) -> [F; 3] {
        let [displacement, velocity, force] = self.largest(&seen);
        let least = F::exp2i(-24);
        let [x, v, t] = seen;
        [x.or_larger(displacement * least), v.or_larger(velocity * least), t.or_larger(force * least)]
    }

    /// The sizes whose rounding the three parts of a state have.
    fn largest(&self, sizes: &[F; 3]) -> [F; 3] {
        let ([x, v, t], [displacement, velocity, force]) = (*sizes, self.natural.sizes);
        let x = x.or_larger(displacement);
        [x, v.or_larger(velocity).or_larger(x * self.natural.rate), t.or_larger(force)]
    }

    /// The rounding of the three parts of a state.
    fn rounding(&self, sizes: &[F; 3]) -> [F; 3] {
        self.largest(sizes).map(|size| size * F::epsilon() * F::int(8))
    }

    /// Whether the velocities of a motion are rounding.
    pub(super) fn rests(&self, motion: &Motion<F>) -> bool {
        let largest = |a: &[F], b: &[F]| a.iter().chain(b).fold(F::int(0), |most, v| most.or_larger(v.abs()));
        let displacement = largest(&motion.max_displacement, &motion.min_displacement);
        let [_, rounding, _] = self.rounding(&[displacement, F::int(0), F::int(0)]);
        largest(&motion.max_velocity, &motion.min_velocity) <= rounding
    }

    /// `multiple` periods from a state, with the derivative, and with the answers of the first period, where asked. Without an event the map
    /// is affine: in the branch of a known period without one it has that period's derivative.
    pub(super) fn map(
        &mut self,
        from: &[F],
        multiple: usize,
        answers: bool,
        known: Option<&Mapped<F>>,
    ) -> Result<Mapped<F>, Error> {
        self.follower.restart(from)?;
        let modes = self.modes();
        if let Some(known) =
            known.filter(|known| multiple == 1 && known.events.is_empty() && known.modes == modes)
        {
            let mapped = self.advance(None, answers)?;
            if mapped.events.is_empty() {
                return Ok(Mapped { tangent: known.tangent.clone(), ..mapped });
            }
            self.follower.restart(from)?;
        }
        let mut all = self.advance(Some(self.directions()), answers)?;
        for count in 1..multiple {
            let mapped = self.advance(Some(all.tangent), false)?;
            all.tangent = mapped.tangent;
            all.to = mapped.to;
            for (sum, &by) in all.drift.iter_mut().zip(&mapped.drift) {
                *sum = *sum + by;
            }
            let before = self.period * integer(count);
            all.events
                .extend(mapped.events.into_iter().map(|event| Event { time: before + event.time, ..event }));
            for (size, new) in all.sizes.iter_mut().zip(mapped.sizes) {
                *size = size.or_larger(new);
            }
        }
        Ok(all)
    }

    /// What the elements do in the present branch.
    fn modes(&self) -> Vec<Mode> {
        self.follower.branch().map_or_else(Vec::new, |branch| branch.modes.clone())
    }

    /// The unit vectors, without what the present branch does not admit.
    fn directions(&self) -> Vec<Vec<F>> {
        let (system, free) = (self.system, self.system.free);
        let modes = self.follower.branch().map_or(&[][..], |b| &b.modes);
        let (held, touching) = (places(modes, Mode::is_held), places(modes, |mode| mode == Mode::Resting));
        let mut columns = Vec::with_capacity(free);
        for i in 0..free {
            let mut column = vec![F::int(0); system.size];
            if let Some(one) = column.get_mut(i) {
                *one = F::int(1);
            }
            match self.follower.branch().and_then(|branch| branch.tie.as_ref()) {
                Some(tie) => tie.project(system, modes, &mut column),
                None => super::next_branch::at_rest(system, &mut column, &held),
            }
            place_at_gap(system, &mut column, &touching);
            for (part, mode) in system.parts.iter().zip(modes) {
                match (&part.rule, *mode) {
                    (_, Mode::Yields { forward }) => yields(part, forward, &mut column),
                    (Rule::Elastic { place, .. }, Mode::Apart) => clear(&mut column, *place),
                    _ => {}
                }
            }
            if self.is_moved(i) {
                column.fill(F::int(0));
            }
            column.truncate(free);
            columns.push(column);
        }
        columns
    }

    /// A disturbance that the present branch admits, in a direction that no symmetry knows: the parts are those of the golden section.
    pub(super) fn disturbance(&self, sizes: &[F; 3]) -> Vec<F> {
        let golden = (F::int(5).sqrt() - F::int(1)) / F::int(2);
        let mut sum = vec![F::int(0); self.system.free];
        for (i, column) in self.directions().iter().enumerate() {
            let turn = golden * integer(i + 1);
            add_times(&mut sum, (F::ratio(1, 2) + turn - turn.floor()) * self.size_at(sizes, i), column);
        }
        sum
    }

    /// Whether an entry of the state is prescribed.
    fn is_moved(&self, i: usize) -> bool {
        let n = self.system.n;
        self.system.moved.iter().any(|moved| i == moved.coordinate || i == n + moved.coordinate)
    }

    /// The places of the elements that are at rest in the present branch, without those in `busy`.
    pub(super) fn silent(&self, busy: &[Event<F>]) -> Vec<usize> {
        let modes = self.follower.branch().map_or(&[][..], |b| &b.modes);
        let mut silent = places(modes, |mode| matches!(mode, Mode::Stuck | Mode::Holds));
        silent.retain(|&i| !busy.iter().any(|event| event.element == i));
        silent
    }

    /// The rows of what the elements keep in the present branch, without those in `busy`: b·q of a contact that sticks, T − k b·q of an
    /// elastic contact that holds. The map does not change them, so that J has one multiplier 1 for each. Stops in touch keep
    /// their own b·q, which is no number of a motion: the rows are those of what moves beside them.
    pub(super) fn kept_rows(&self, busy: &[Event<F>]) -> Vec<Vec<F>> {
        let modes = self.follower.branch().map_or(&[][..], |b| &b.modes);
        let touching = places(modes, |mode| mode == Mode::Resting);
        let mut rows = Vec::new();
        for i in self.silent(busy) {
            let (Some(part), Some(mode)) = (self.system.parts.get(i), modes.get(i)) else { continue };
            let mut row = vec![F::int(0); self.system.free];
            let along = beside(self.system, i, &touching);
            match (mode, &part.rule) {
                (Mode::Stuck, _) => add_times(&mut row, F::int(1), &along),
                (Mode::Holds, Rule::Elastic { stiffness, place, .. }) => {
                    add_times(&mut row, -*stiffness, &along);
                    if let Some(force) = row.get_mut(*place) {
                        *force = F::int(1);
                    }
                }
                _ => continue,
            }
            let moved = |(i, x): (usize, &mut F)| {
                if self.is_moved(i) {
                    *x = F::int(0);
                }
            };
            row.iter_mut().enumerate().for_each(moved);
            if row.iter().any(|&x| x != F::int(0)) {
                rows.push(row);
            }
        }
        self.drift.blind(rows)
    }

    /// A vector over the state in units of the motion's sizes.
    pub(super) fn scaled(&self, mut list: Vec<F>, sizes: &[F; 3]) -> Vec<F> {
        let n = self.system.n;
        for (i, x) in list.iter_mut().enumerate() {
            *x = *x / size_at(n, sizes, i);
        }
        list
    }

    /// The size of an entry of the state.
    pub(super) fn size_at(&self, sizes: &[F; 3], i: usize) -> F {
        size_at(self.system.n, sizes, i)
    }

    /// The difference of two states relative to the motion's sizes, as far as it is above the rounding of each part.
    pub(super) fn distance(&self, a: &[F], b: &[F], sizes: &[F; 3]) -> F {
        let difference: Vec<F> = a.iter().zip(b).map(|(&a, &b)| a - b).collect();
        let mut most = F::int(0);
        let rounding = self.rounding(sizes);
        for ((block, &size), &rounding) in
            blocks(self.system, &difference).into_iter().zip(sizes).zip(&rounding)
        {
            let by = largest(block);
            if by.is_finite() && by > rounding {
                most = most.or_larger(if size > F::int(0) { (by - rounding) / size } else { F::int(1) });
            } else if !by.is_finite() {
                return by;
            }
        }
        most
    }

    /// Elastic forces do not exceed their frictions.
    pub(super) fn keep_bounds(&self, x: &mut [F]) {
        let given = self.follower.z.get(self.system.free..).unwrap_or(&[]);
        for part in &self.system.parts {
            let Rule::Elastic { place, bound, .. } = &part.rule else { continue };
            let bound = dot(bound, x) + dot(bound.get(x.len()..).unwrap_or(&[]), given);
            let bound = bound.or_larger(F::int(0));
            if let Some(force) = x.get_mut(*place)
                && force.abs() > bound
            {
                *force = bound.with_sign_of(*force);
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
        let done = self.follower.run(self.period * integer(multiple), &mut observer);
        self.steps = self.steps.saturating_add(self.follower.renew());
        done?;
        Ok((start, observer.finish(self.system, &first, &self.follower)))
    }
}

/// The size of an entry of the state; 1 where nothing of its kind moves.
fn size_at<F: Float>(n: usize, sizes: &[F; 3], i: usize) -> F {
    let [displacement, velocity, force] = *sizes;
    let size = if i < n {
        displacement
    } else if i < 2 * n {
        velocity
    } else {
        force
    };
    if size > F::int(0) { size } else { F::int(1) }
}
