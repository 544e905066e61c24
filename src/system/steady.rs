//! The motion that a start leads to: the periods are followed, and a fixed point of the period map is taken for the limit where the
//! motion goes to it.
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
//! A motion that changes by no more than rounding in a period, and to which Newton's method has nothing to add, has arrived.

use super::assembly::Assembly;
use super::error::Error;
use super::events::Event;
use super::first_passage::integer;
use super::fixed_point::{Fixed, newton};
use super::follow::{Follower, most_steps};
use super::matrix::add_times;
use super::model::State;
use super::motion::Motion;
use super::period_map::{Answers, Happened, Mapped, PeriodMap};
use crate::float::Float;
use crate::machine::error::written;
use crate::named::named;
use alloc::collections::VecDeque;
use alloc::string::ToString;
use alloc::vec::Vec;

named! {
    /// The kind of a motion after a long time.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "lowercase"))]
    pub enum SteadyKind [name] {
        /// It repeats itself.
        Periodic = "periodic",
        /// Nothing moves.
        Rest = "rest",
        /// All velocities are constant, and not all are 0.
        Uniform = "uniform",
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
    /// The least period of the motion: that of the loads times [`Steady::periods`], or its own without loads; 0 at rest and in a
    /// uniform motion without loads.
    pub period: F,
    /// After how many periods of the loads it repeats itself; 1 where it does not.
    pub periods: usize,
    /// The state at the phase 0 of the loads; without loads at some instant.
    pub start: State<F>,
    /// One period of it; the last one followed, where it does not repeat itself.
    pub motion: Motion<F>,
    /// The displacement of each coordinate in the period that no force notices, such as that of a body on a conveyor; 0 where springs hold
    /// the system. The motion repeats itself but for it.
    pub drift: Vec<F>,
    /// The mean velocity of each coordinate.
    pub mean_velocity: Vec<F>,
    /// The multipliers of a small disturbance over the period, (real, imaginary), by size: 1 for each number that an element keeps, and
    /// none for the drift. They are computed at f64, and empty where the motion does not repeat itself or they are not found.
    pub multipliers: Vec<(f64, f64)>,
    /// The change of the state over the period, relative to the motion's size.
    pub change: F,
    /// The factor by which the change is multiplied in a period, as it was seen; 0 where the motion has settled, and 1 where its change does
    /// not fall.
    pub decay: F,
    /// The number of periods that were followed; without loads, of spans of 32 periods of the lowest natural frequency.
    pub followed: usize,
}

/// The most periods that are followed where the change of the motion does not fall.
const MOST_PERIODS: usize = 2048;
/// The greatest multiple of the loads' period.
const MOST_MULTIPLE: usize = 64;
/// The most steps of a period of the loads.
const MOST_STEPS: usize = 250_000;
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

/// Whether the motion goes to a fixed point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Approach {
    /// It does.
    Goes,
    /// It goes elsewhere, or stays away.
    Leaves,
}

/// The motion, followed from period to period.
pub(super) struct Following<'a, F> {
    pub(super) map: PeriodMap<'a, F>,
    /// The last states, and the events of the periods before them.
    pub(super) states: VecDeque<Vec<F>>,
    pub(super) events: VecDeque<Vec<Event<F>>>,
    pub(super) sizes: [F; 3],
    pub(super) drift: Vec<F>,
    /// The displacement that the drift of all periods adds up to.
    moved: Vec<F>,
    pub(super) followed: usize,
    most_work: u64,
    pub(super) end: Option<End>,
}

impl<'a, F: Float> Following<'a, F> {
    pub(super) fn new(system: &'a Assembly<F>, follower: Follower<'a, F>, period: F) -> Self {
        let map = PeriodMap::new(system, follower, period);
        let states = VecDeque::from([map.free()]);
        let drift = alloc::vec![F::int(0); system.n];
        let moved = drift.clone();
        let most_work = most_steps(system).saturating_mul(MOST_WORK);
        let sizes = [F::int(0); 3];
        Self { map, states, events: VecDeque::new(), sizes, drift, moved, followed: 0, most_work, end: None }
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
        match self.map.advance(None, false) {
            Ok(mapped) => {
                self.sizes = mapped.sizes;
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

    /// The distance of the state now from that some periods before.
    pub(super) fn back(&self, periods: usize) -> F {
        let then = self.states.len().checked_sub(periods + 1).and_then(|i| self.states.get(i));
        match (self.states.back(), then) {
            (Some(now), Some(then)) => self.map.distance(now, then, &self.sizes),
            _ => F::int(1) / F::epsilon(),
        }
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
    ) -> Result<Approach, Error> {
        let tiny = F::epsilon() * F::exp2i(16);
        let sizes = fixed.mapped.sizes;
        let now = self.now();
        let first = self.map.distance(&now, &fixed.x, &sizes);
        let apart = |map: &PeriodMap<'_, F>, z: &[F]| -> Vec<F> {
            map.scaled(z.iter().zip(&fixed.x).map(|(&a, &b)| a - b).collect(), &sizes)
        };
        let mut delta = apart(&self.map, &now);
        // Without an element P is linear, and each motion goes where J takes it.
        let is_linear = self.map.system.parts.is_empty() && fixed.largest().is_some_and(|most| most < 1.0);
        if first <= tiny || is_linear {
            return Ok(Approach::Goes);
        }
        if !first.is_finite() || (fixed.is_first_order && first > F::exp2i(-24)) {
            return Ok(Approach::Leaves);
        }
        let Some(&(re, im)) = fixed.multipliers.get(ones) else { return Ok(Approach::Leaves) };
        let largest = re.hypot(im);
        if largest > 1.0 + 1e-6 {
            return Ok(Approach::Leaves);
        }
        // A vibration of its own that nothing damps is kept.
        if largest > 1.0 - 1e-9 {
            return Ok(if first <= F::exp2i(-30) { Approach::Goes } else { Approach::Leaves });
        }
        // What a map does beside J must be less than the slowest part of the disturbance falls by, or another motion is as near.
        let small = F::from_f64(((1.0 - largest) / 4.0).min(0.125));
        // The slowest part of the disturbance falls to a quarter in so many maps.
        let enough = (-(4.0_f64.ln()) / largest.max(1e-3).ln()).ceil();
        let most = 2.0 * enough + 64.0;
        let work = (self.map.steps / (self.followed as u64 + 1)).max(1).saturating_mul(multiple as u64);
        if enough * work as f64 > self.most_work.saturating_sub(self.map.steps) as f64 {
            return Ok(Approach::Leaves);
        }
        let cycle: Vec<Happened> = happened(&fixed.mapped.events);
        let stays = self.stays(fixed);
        let most = if stays { 32.0 * most } else { most };
        let mut count = 0.0;
        while count < most {
            count += 1.0;
            let mut events = Vec::new();
            for _ in 0..multiple {
                let Some(mapped) = self.advance()? else { return Ok(Approach::Leaves) };
                events.extend(happened(&mapped.events));
            }
            let (now, mut due) = (self.now(), fixed.x.clone());
            for (i, (x, by)) in due.iter_mut().zip(fixed.derivative.of(&delta)).enumerate() {
                *x = *x + by * self.map.size_at(&sizes, i);
            }
            let before = delta.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
            let off = self.map.distance(&now, &due, &sizes);
            if off > before * small + tiny || !is_same_cycle(&events, &cycle) {
                return Ok(Approach::Leaves);
            }
            delta = apart(&self.map, &now);
            let left = self.map.distance(&now, &fixed.x, &sizes);
            // The place that a motion without a drift comes to adds up over all periods.
            let falls = if stays { tiny } else { first / F::int(4) };
            if left <= tiny || (count >= enough && left <= falls) {
                return Ok(Approach::Goes);
            }
        }
        Ok(Approach::Leaves)
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
        let is_still = matches!(kind, SteadyKind::Rest | SteadyKind::Uniform);
        let period = if is_still && !loads { F::int(0) } else { self.map.period * integer(multiple) };
        let mean = |by: F| if stays { F::int(0) } else { by / motion.duration };
        let mean_velocity = fixed.mapped.drift.iter().map(|&by| mean(by)).collect();
        let mut drift = fixed.mapped.drift;
        if stays || period == F::int(0) {
            drift.fill(F::int(0));
        }
        let (change, decay, followed) = (fixed.by, F::int(0), self.followed);
        Ok(Steady {
            kind,
            period,
            periods: multiple,
            start,
            motion,
            drift,
            mean_velocity,
            multipliers,
            change,
            decay,
            followed,
        })
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
        let states: Vec<Vec<F>> = self.states.iter().cloned().collect();
        let (start, motion) = self.last_finite(&states)?;
        let kind = if grows { SteadyKind::Growing } else { SteadyKind::Unsettled };
        let (period, drift, followed) = (self.map.period, self.drift.clone(), self.followed);
        let mean_velocity = drift.iter().map(|&by| by / period).collect();
        let multipliers = Vec::new();
        Ok(Steady {
            kind,
            period,
            periods: 1,
            start,
            motion,
            drift,
            mean_velocity,
            multipliers,
            change,
            decay,
            followed,
        })
    }

    /// The answers of the latest period that, with its energy, stays within the range of numbers.
    fn last_finite(&mut self, states: &[Vec<F>]) -> Result<Answers<F>, Error> {
        let mut last = Err(Error::Unbounded { time: written(self.map.period) });
        for from in states.iter().rev() {
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

/// A measure of a motion at a number of periods: the sizes of displacements and velocities, and how nearly it repeats itself.
struct Mark<F> {
    followed: usize,
    sizes: [F; 3],
    change: F,
}

/// Whether displacements or velocities have grown by more than a half from each of the last marks to the next.
fn grows<F: Float>(marks: &[Mark<F>]) -> bool {
    let grown = |a: F, b: F| a > F::int(0) && b * F::int(2) > a * F::int(3);
    let by = |part: fn(&[F; 3]) -> F| matches!(marks, [.., a, b, c] if grown(part(&a.sizes), part(&b.sizes)) && grown(part(&b.sizes), part(&c.sizes)));
    by(|sizes| sizes[0]) || by(|sizes| sizes[1])
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
    let mut following = Following::new(system, follower, period);
    let mut marks: Vec<Mark<F>> = Vec::new();
    let (mut next, mut refused) = (4, false);
    while following.advance()?.is_some() {
        let followed = following.followed;
        let settled = following.back(1) <= F::epsilon() * F::int(2);
        if followed >= next || (settled && !refused) {
            next = next.max(followed.saturating_mul(2));
            if let Some(found) = look(&mut following)? {
                return Ok(found);
            }
            refused = settled;
        }
        let followed = following.followed;
        if followed >= marks.last().map_or(MOST_PERIODS / 8, |mark| 2 * mark.followed) {
            marks.push(Mark { followed, sizes: following.sizes, change: following.recurrence() });
            let falls =
                matches!(marks.as_slice(), [.., a, b] if b.change * F::int(33) <= a.change * F::int(32));
            if followed >= MOST_PERIODS && (!falls || grows(&marks)) {
                break;
            }
        }
    }
    let decay = match marks.as_slice() {
        [.., a, b] if b.change < a.change => {
            let periods = integer::<F>(b.followed - a.followed);
            F::from_f64(((b.change / a.change).to_f64().ln() / periods.to_f64()).exp())
        }
        _ => F::int(1),
    };
    // Within a part of an own vibration a beginning looks like growth.
    let is_long = slowest().is_none_or(|longest| period * integer(following.followed) > longest * F::int(8));
    let grows = following.end == Some(End::Unbounded) || (is_long && grows(&marks));
    let change = following.back(1);
    following.unsettled(grows, change, decay)
}

/// The steady motion that the motion goes to now, if there is one.
fn look<F: Float>(following: &mut Following<'_, F>) -> Result<Option<Steady<F>>, Error> {
    let settled = following.back(1) <= F::epsilon() * F::int(2);
    let known = following.states.len().saturating_sub(1);
    for multiple in 1..=MOST_MULTIPLE.min(if settled { 1 } else { (known / 4).max(1) }) {
        // A motion of several periods comes back to its state, and not after one.
        if multiple > 1 && following.back(multiple) * F::int(2) > following.back(1) {
            continue;
        }
        // Motions of many periods are looked for where the followed one almost repeats itself.
        if multiple > 8 && following.back(multiple) > F::ratio(1, 1000) {
            continue;
        }
        let (from, before) = (following.now(), following.map.follower.saved());
        let found = newton(&mut following.map, &from, multiple)?;
        let Some(mut fixed) = found else {
            following.map.follower.resume(&before);
            continue;
        };
        // It may be one of fewer periods, which divide these.
        let mut least = multiple;
        for fewer in (1..multiple).filter(|&fewer| multiple.is_multiple_of(fewer)) {
            let x = fixed.x.clone();
            let part = newton(&mut following.map, &x, fewer)?;
            let near = |part: &Fixed<F>| {
                following.map.distance(&part.x, &x, &part.mapped.sizes) <= F::epsilon().sqrt() / F::int(64)
            };
            if let Some(part) = part.filter(near) {
                (least, fixed) = (fewer, part);
                break;
            }
        }
        following.map.follower.resume(&before);
        if following.approaches(&fixed, least, 0)? == Approach::Goes {
            return following.answer(fixed, least, true).map(Some);
        }
    }
    Ok(None)
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
