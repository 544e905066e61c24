//! The motion, followed from period to period, and whether it goes to a fixed point of the period map.
//!
//! **The limit of this start.** Let z be the state after some periods, x a fixed point that Newton's method finds from it, J the derivative
//! there, and δ = z − x. A fixed point is only a guess: there may be several, and z may be nearer to another. It is the limit where
//! the motion approaches it as J says. Each of the periods after z must have the events of x and bring the state to x + J δ, within
//! |δ| (1 − |λ|)/4 and |δ|/8, λ being the largest multiplier, until its part of the disturbance and |δ| have fallen to a quarter. What a map
//! does beside J is of second order in δ, so that the bound holds the better the smaller δ becomes.
//!
//! What silent elements keep is the same at z and x (`fixed_point.rs`). Where x is the point of a manifold to first order only, |δ| must be
//! below 2⁻²⁴, so that its square is rounding.
//!
//! Where no two motions of the system move apart, or no event can come any more, the limit is proved without that (`monotone.rs`, `calm.rs`).
//!
//! A motion that changes by no more than rounding in a period, and to which Newton's method has nothing to add, has arrived.
//!
//! **Rounding on the way.** A fixed point is right whatever rounding does, but which of several a start leads to is not, where the way is
//! chaotic for a while. So a disturbance v of the motion is carried along, `v ← J v`, and the greatest factor is kept by which it
//! grew between any two instants, in units of the motion's sizes: rounding errors of each instant grow so.

use super::assembly::Assembly;
use super::calm::{Calm, Margins};
use super::error::Error;
use super::events::Event;
use super::first_passage::integer;
use super::fixed_point::{Fixed, kept_basis};
use super::follow::{Follower, most_steps};
use super::matrix::{add_times, dot};
use super::monotone::{energy_of, energy_of_silence, is_monotone};
use super::motion::Motion;
use super::period_map::{Answers, Happened, Mapped, PeriodMap};
use super::precision::small;
use super::steady::{Steady, SteadyKind};
use crate::float::Float;
use crate::machine::error::written;
use alloc::collections::VecDeque;
use alloc::vec::Vec;
use core::cell::OnceCell;

/// The greatest multiple of the loads' period.
pub(super) const MOST_MULTIPLE: usize = 64;
/// The steps of a whole search, in those of one motion: some seconds where the motion settles slowly.
const MOST_WORK: u64 = 4;

/// Why a motion is not followed further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// It leaves the range of numbers.
    Unbounded,
    /// A period takes more steps than a motion may have.
    Cut,
    /// The work of the search is done.
    Work,
}

/// The motion, followed from period to period.
pub(super) struct Following<'a, F> {
    pub(super) map: PeriodMap<'a, F>,
    /// The last states, and the events of the periods before them.
    pub(super) states: VecDeque<Vec<F>>,
    pub(super) events: VecDeque<Vec<Event<F>>>,
    pub(super) sizes: [F; 3],
    /// The greatest sizes since they were last asked for.
    greatest: [F; 3],
    pub(super) drift: Vec<F>,
    /// The displacement that the drift of all periods adds up to.
    moved: Vec<F>,
    pub(super) followed: usize,
    disturbance: Disturbance<F>,
    most_work: u64,
    pub(super) end: Option<End>,
    /// Whether no two motions move apart, once it has been asked for.
    is_monotone: OnceCell<bool>,
}

/// A small disturbance of the motion that is followed.
struct Disturbance<F> {
    /// None before the first period that it is followed in, and after one that ended it.
    now: Option<Vec<F>>,
    /// By how much it has grown since it was smallest, and the greatest such factor.
    grown: f64,
    growth: f64,
}

impl<F: Float> Disturbance<F> {
    /// The periods before it is followed: within them rounding stays far below the motion, and most motions have settled.
    const FROM: usize = 8;

    const NONE: Self = Self { now: None, grown: 1.0, growth: 1.0 };

    /// After a period, with what the map's derivative has made of it.
    fn advance(&mut self, map: &PeriodMap<'_, F>, sizes: &[F; 3], to: Vec<F>) {
        let square = |sum: F, x: F| sum + x * x;
        let by = map.scaled(to.clone(), sizes).into_iter().fold(F::int(0), square).sqrt().to_f64();
        if !(by > 0.0 && by.is_finite()) {
            // Contacts at rest have ended it: errors begin anew.
            *self = Self { growth: self.growth, ..Self::NONE };
            return;
        }
        if self.now.is_some() {
            let most = 1.0 / F::epsilon().to_f64();
            self.grown = (self.grown * by).clamp(1.0, most);
            self.growth = self.growth.max(self.grown);
        }
        let inverse = F::from_f64(1.0 / by);
        self.now = Some(to.into_iter().map(|x| x * inverse).collect());
    }
}

impl<'a, F: Float> Following<'a, F> {
    pub(super) fn new(system: &'a Assembly<F>, follower: Follower<'a, F>, period: F) -> Self {
        let map = PeriodMap::new(system, follower, period);
        let states = VecDeque::from([map.free()]);
        let drift = alloc::vec![F::int(0); system.n];
        let moved = drift.clone();
        let most_work = most_steps(system).saturating_mul(MOST_WORK);
        let (sizes, greatest) = ([F::int(0); 3], [F::int(0); 3]);
        Self {
            map,
            states,
            events: VecDeque::new(),
            sizes,
            greatest,
            drift,
            moved,
            followed: 0,
            disturbance: Disturbance::NONE,
            most_work,
            end: None,
            is_monotone: OnceCell::new(),
        }
    }

    /// The state now.
    pub(super) fn now(&self) -> Vec<F> {
        self.states.back().cloned().unwrap_or_default()
    }

    /// One period on, if there is one.
    pub(super) fn advance(&mut self) -> Result<Option<Mapped<F>>, Error> {
        if self.map.steps > self.most_work {
            self.end = Some(End::Work);
        }
        if self.end.is_some() {
            return Ok(None);
        }
        let before = self.map.follower.saved();
        let is_disturbed = self.followed >= Disturbance::<F>::FROM;
        let disturbed = is_disturbed.then(|| {
            let now = self.disturbance.now.get_or_insert_with(|| self.map.disturbance(&self.sizes));
            alloc::vec![now.clone()]
        });
        match self.map.advance(disturbed, false) {
            Ok(mut mapped) => {
                self.sizes = mapped.sizes;
                for (greatest, &size) in self.greatest.iter_mut().zip(&mapped.sizes) {
                    *greatest = greatest.or_larger(size);
                }
                if let Some(to) = mapped.tangent.pop() {
                    self.disturbance.advance(&self.map, &mapped.sizes, to);
                }
                self.drift.clone_from(&mapped.drift);
                add_times(&mut self.moved, F::int(1), &mapped.drift);
                self.followed += 1;
                if self.states.len() > MOST_MULTIPLE {
                    self.states.pop_front();
                    self.events.pop_front();
                }
                self.states.push_back(mapped.to.clone());
                self.events.push_back(mapped.events.clone());
                Ok(Some(mapped))
            }
            Err(Error::Unbounded { .. }) => {
                self.map.follower.resume(&before);
                self.end = Some(End::Unbounded);
                Ok(None)
            }
            // The motion is told as far as it was followed.
            Err(Error::TooLong { .. }) if self.followed > 0 => {
                self.map.follower.resume(&before);
                self.end = Some(End::Cut);
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// The greatest sizes of displacements, velocities and forces since this was last asked for. One period tells nothing of growth: those
    /// of an irregular motion differ by any factor.
    pub(super) fn take_greatest(&mut self) -> [F; 3] {
        core::mem::replace(&mut self.greatest, [F::int(0); 3])
    }

    /// The distance of the state now from that some periods before.
    pub(super) fn back(&self, periods: usize) -> F {
        let then = self.states.len().checked_sub(periods + 1).and_then(|i| self.states.get(i));
        match (self.states.back(), then) {
            (Some(now), Some(then)) => self.map.distance(now, then, &self.sizes),
            _ => F::int(1) / F::epsilon(),
        }
    }

    /// Whether the last period had no event, and the one before had.
    pub(super) fn has_become_quiet(&self) -> bool {
        let mut last = self.events.iter().rev();
        last.next().is_some_and(Vec::is_empty) && last.next().is_some_and(|events| !events.is_empty())
    }

    /// How nearly the motion repeats itself, after any number of periods.
    pub(super) fn recurrence(&self) -> F {
        let least = |a: F, b: F| if b < a { b } else { a };
        (1..=MOST_MULTIPLE).map(|k| self.back(k)).fold(F::int(1) / F::epsilon(), least)
    }

    /// Whether the motion goes to a fixed point of `multiple` periods, by following it further. `ones` is the number of multipliers that
    /// are 1 beside those of what is kept.
    pub(super) fn approaches(
        &mut self,
        fixed: &Fixed<F>,
        multiple: usize,
        ones: usize,
    ) -> Result<bool, Error> {
        let tiny = F::epsilon() * F::exp2i(16);
        let sizes = fixed.mapped.sizes;
        let now = self.now();
        let first = self.map.distance(&now, &fixed.x, &sizes);
        let apart = |map: &PeriodMap<'_, F>, z: &[F]| -> Vec<F> {
            map.scaled(z.iter().zip(&fixed.x).map(|(&a, &b)| a - b).collect(), &sizes)
        };
        // Without an element P is linear, and each motion goes where J takes it.
        let is_linear = self.map.system.parts.is_empty() && fixed.largest().is_some_and(|most| most < 1.0);
        if first <= tiny || is_linear {
            return Ok(true);
        }
        if !first.is_finite() || (fixed.is_first_order && first > small(24)) {
            return Ok(false);
        }
        let Some(&(re, im)) = fixed.multipliers.get(ones) else { return Ok(false) };
        let largest = re.hypot(im);
        if largest > 1.0 + 1e-6 {
            return Ok(false);
        }
        // A vibration of its own that nothing damps is kept.
        if largest > 1.0 - 1e-9 {
            return Ok(first <= small(30));
        }
        // What a map does beside J must be less than the slowest part of the disturbance falls by, or another motion is as near.
        let small = F::from_f64(((1.0 - largest) / 4.0).min(0.125));
        // The slowest part of the disturbance falls to a quarter in so many maps.
        let enough = (-(4.0_f64.ln()) / largest.max(1e-3).ln()).ceil();
        let most = 2.0 * enough + 64.0;
        let work = (self.map.steps / (self.followed as u64 + 1)).max(1).saturating_mul(multiple as u64);
        let is_short = enough * work as f64 <= self.most_work.saturating_sub(self.map.steps) as f64;
        if ones == 0
            && let Some(is_drawn) =
                self.is_drawn(fixed, multiple, if is_short { enough } else { f64::INFINITY })?
        {
            return Ok(is_drawn);
        }
        if !is_short {
            return Ok(false);
        }
        let now = self.now();
        let (first, mut delta) = (self.map.distance(&now, &fixed.x, &sizes), apart(&self.map, &now));
        let cycle: Vec<Happened> = happened(&fixed.mapped.events);
        let stays = self.stays(fixed);
        let most = if stays { 32.0 * most } else { most };
        let mut count = 0.0;
        while count < most {
            count += 1.0;
            let mut events = Vec::new();
            for _ in 0..multiple {
                let Some(mapped) = self.advance()? else { return Ok(false) };
                events.extend(happened(&mapped.events));
            }
            let (now, mut due) = (self.now(), fixed.x.clone());
            for (i, (x, by)) in due.iter_mut().zip(fixed.derivative.of(&delta)).enumerate() {
                *x = *x + by * self.map.size_at(&sizes, i);
            }
            let before = delta.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
            let off = self.map.distance(&now, &due, &sizes);
            if off > before * small + tiny || !is_same_cycle(&events, &cycle) {
                return Ok(false);
            }
            delta = apart(&self.map, &now);
            let left = self.map.distance(&now, &fixed.x, &sizes);
            // The place that a motion without a drift comes to adds up over all periods.
            let falls = if stays { tiny } else { first / F::int(4) };
            if left <= tiny || (count >= enough && left <= falls) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the motion goes to a fixed point of `multiple` periods whose multipliers are below 1, where this can be proved or refuted without following it to
    /// there: no two motions of the system move apart (`monotone.rs`), or no event comes any more (`calm.rs`). The motion is followed for at most so many periods.
    fn is_drawn(&mut self, fixed: &Fixed<F>, multiple: usize, most: f64) -> Result<Option<bool>, Error> {
        let system = self.map.system;
        if self.map.drift.count() > 0 || fixed.is_first_order {
            return Ok(None);
        }
        let is_monotone = *self.is_monotone.get_or_init(|| is_monotone(system));
        if is_monotone && !self.is_smooth(fixed, multiple)? {
            return Ok(None);
        }
        if is_monotone && fixed.kept == 0 {
            return Ok(Some(true));
        }
        if multiple > 1 {
            return Ok(None);
        }
        let before = self.map.follower.saved();
        let mut margins = Margins::new();
        self.map.follower.restart(&fixed.x)?;
        let silent = self.map.silent(&fixed.mapped.events);
        let keeps = self.keeps_numbers_of(fixed);
        let calm = match self.map.follower.branch() {
            Some(branch) if fixed.mapped.events.is_empty() && branch.modes == before.modes => {
                Calm::new(system, branch)
            }
            _ => None,
        };
        if keeps && (calm.is_some() || is_monotone) {
            self.map.follower.run(self.map.period, &mut margins)?;
        }
        self.map.follower.resume(&before);
        let energy = if is_monotone { energy_of_silence(system, &silent, &margins) } else { None };
        let mut own = margins.least.iter().filter(|(_, element, _)| silent.contains(element));
        if !keeps || (calm.is_none() && energy.is_none()) || !own.all(|&(.., margin)| margin > F::int(0)) {
            return Ok(None);
        }
        let mut count = 0.0;
        loop {
            let delta: Vec<F> = self.now().iter().zip(&fixed.x).map(|(&a, &b)| a - b).collect();
            if calm.as_ref().is_some_and(|calm| calm.stays(system, &delta, &margins))
                || energy.is_some_and(|energy| energy_of(system, &delta) < energy)
            {
                return Ok(Some(true));
            }
            count += 1.0;
            if count > most {
                return Ok(None);
            }
            let Some(mapped) = self.advance()? else { return Ok(Some(false)) };
            let wakes = |event: &Event<F>| calm.is_some() || silent.contains(&event.element);
            if mapped.events.iter().any(wakes) {
                return Ok(Some(false));
            }
        }
    }

    /// Whether the motion has the kept numbers of a fixed point, from which the map goes on. Newton's method keeps those of elements that are silent on its
    /// way, which those at its end need not have been.
    fn keeps_numbers_of(&self, fixed: &Fixed<F>) -> bool {
        let delta = self.now().iter().zip(&fixed.x).map(|(&a, &b)| a - b).collect();
        let delta = self.map.scaled(delta, &fixed.mapped.sizes);
        let rows = kept_basis(&self.map, &fixed.mapped);
        rows.iter().all(|row| dot(row, &delta).abs() <= F::epsilon() * F::exp2i(16))
    }

    /// Whether J is the derivative of the map on both sides of a fixed point: for a small disturbance forth and back.
    fn is_smooth(&mut self, fixed: &Fixed<F>, multiple: usize) -> Result<bool, Error> {
        let (before, sizes) = (self.map.follower.saved(), fixed.mapped.sizes);
        let mut is_smooth = true;
        for sign in [1, -1] {
            self.map.follower.restart(&fixed.x)?;
            let part = F::int(sign) * small(20);
            let by: Vec<F> = self.map.disturbance(&sizes).into_iter().map(|x| x * part).collect();
            let mut from = fixed.x.clone();
            add_times(&mut from, F::int(1), &by);
            self.map.keep_bounds(&mut from);
            let by: Vec<F> = from.iter().zip(&fixed.x).map(|(&a, &b)| a - b).collect();
            self.map.follower.restart(&from)?;
            for _ in 0..multiple {
                self.map.advance(None, false)?;
            }
            let mut due = fixed.x.clone();
            for (i, (x, by)) in
                due.iter_mut().zip(fixed.derivative.of(&self.map.scaled(by, &sizes))).enumerate()
            {
                *x = *x + by * self.map.size_at(&sizes, i);
            }
            let off = self.map.distance(&self.map.free(), &due, &sizes);
            is_smooth &= off <= part.abs() * F::exp2i(-10);
        }
        self.map.follower.resume(&before);
        Ok(is_smooth)
    }

    /// Whether a motion that nothing holds in its place has no drift.
    fn stays(&self, fixed: &Fixed<F>) -> bool {
        let zero = alloc::vec![F::int(0); fixed.mapped.drift.len()];
        self.map.drift.count() > 0
            && self.map.distance(&fixed.mapped.drift, &zero, &fixed.mapped.sizes)
                <= F::epsilon() * F::exp2i(16)
    }

    /// The answers of a motion from a state.
    pub(super) fn answer(
        &mut self,
        fixed: Fixed<F>,
        multiple: usize,
        loads: bool,
    ) -> Result<Steady<F>, Error> {
        let multipliers = fixed.all_multipliers();
        let stays = self.stays(&fixed);
        let (start, motion) = match fixed.mapped.observed {
            Some(observed) if multiple == 1 && !stays => observed,
            _ => {
                let mut x = fixed.x.clone();
                if stays {
                    add_times(&mut x, F::int(1), &self.moved);
                }
                self.map.observed(Some(&x), multiple)?
            }
        };
        let kind = self.kind(&motion);
        let mut drift = fixed.mapped.drift;
        if stays {
            drift.fill(F::int(0));
        }
        let mut found = self.over(kind, (start, motion), multiple, drift);
        if matches!(kind, SteadyKind::Rest | SteadyKind::Uniform) && !loads {
            found.period = F::int(0);
            found.drift.fill(F::int(0));
        }
        Ok(Steady { multipliers, change: fixed.by, ..found })
    }

    /// The answers over so many periods, with the drift in them.
    fn over(
        &self,
        kind: SteadyKind,
        (start, motion): Answers<F>,
        multiple: usize,
        drift: Vec<F>,
    ) -> Steady<F> {
        let period = self.map.period * integer(multiple);
        Steady {
            kind,
            period,
            periods: multiple,
            start,
            motion,
            mean_velocity: drift.iter().map(|&by| by / period).collect(),
            drift,
            multipliers: Vec::new(),
            change: F::int(0),
            decay: F::int(0),
            followed: self.followed,
            disturbance_growth: self.disturbance.growth,
        }
    }

    /// The kind of a motion that repeats itself.
    fn kind(&self, motion: &Motion<F>) -> SteadyKind {
        if self.map.rests(motion) {
            return SteadyKind::Rest;
        }
        let mut size = F::int(0);
        let mut varies = F::int(0);
        for (&most, &least) in motion.max_velocity.iter().zip(&motion.min_velocity) {
            size = size.or_larger(most.abs()).or_larger(least.abs());
            varies = varies.or_larger(most - least);
        }
        let is_uniform = self.map.drift.count() > 0 && varies <= size * F::epsilon() * F::exp2i(12);
        if is_uniform { SteadyKind::Uniform } else { SteadyKind::Periodic }
    }

    /// The answers where the motion has not settled.
    pub(super) fn unsettled(&mut self, grows: bool, change: F, decay: F) -> Result<Steady<F>, Error> {
        let answers = self.last_finite()?;
        let kind = if grows { SteadyKind::Growing } else { SteadyKind::Unsettled };
        Ok(Steady { change, decay, ..self.over(kind, answers, 1, self.drift.clone()) })
    }

    /// The answers of the latest period that, with its energy, stays within the range of numbers.
    fn last_finite(&mut self) -> Result<Answers<F>, Error> {
        let mut last = Err(Error::Unbounded { time: written(self.map.period) });
        for from in self.states.iter().rev() {
            last = self.map.observed(Some(from), 1);
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

fn happened<F: Float>(events: &[Event<F>]) -> Vec<Happened> {
    events.iter().map(|event| (event.element, event.kind)).collect()
}

/// Whether each element has the same events in the same order, from any of them on: an event at the phase 0 may fall into the period
/// before, and those of two elements at one instant may change places.
fn is_same_cycle(a: &[Happened], b: &[Happened]) -> bool {
    let of = |list: &[Happened], element: usize| -> Vec<Happened> {
        list.iter().filter(|event| event.0 == element).copied().collect()
    };
    let is_turned = |element: usize| {
        let (a, mut b) = (of(a, element), of(b, element));
        a.len() == b.len()
            && (a == b
                || (0..b.len()).any(|_| {
                    b.rotate_left(1);
                    a == b
                }))
    };
    a.len() == b.len() && a.iter().all(|event| is_turned(event.0))
}
