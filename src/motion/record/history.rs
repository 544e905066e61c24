//! The motion under a record as states and events.

use super::answers::{RecordAnswer, Weights};
use super::body::Body;
use super::follow::{Onset, Stretch, Watch};
use super::linear::Linear;
use super::load::{Piece, Record};
use super::slide::Slide;
use super::totals::Totals;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::positive;
use alloc::vec::Vec;
use core::cmp::Ordering;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// A state of a body under a record.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct RecordState<F> {
    /// Time.
    pub time: F,
    /// Displacement.
    pub displacement: F,
    /// Velocity.
    pub velocity: F,
    /// Acceleration, in relation to the surface; after an event that of the motion to come.
    pub acceleration: F,
    /// ±1 while the body slides in this direction, 0 at rest.
    pub direction: i8,
    /// Acceleration in space: that of the body and of its moving surface together.
    pub absolute_acceleration: F,
    /// Friction force on the body: against its motion, and at rest the force that holds it. It is the opposite of the
    /// friction of an `Instant`, which stands on the side of the spring in the equation of motion.
    pub friction: F,
    /// Force of spring, damper and friction together on all that bears the body: `k x + c x′ − friction`, and where the
    /// support of the spring moves by u, `k(x − u) + c x′ − friction`.
    pub transmitted_force: F,
    /// Force of the load on the body, without the constant force: p, −m a of an acceleration a of the surface, or k u + c u′
    /// of a support, with the damper on it.
    pub load: F,
}

/// The beginning or the end of a slide.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RecordEvent<F> {
    /// Time.
    pub time: F,
    /// Displacement.
    pub displacement: F,
    /// ±1 for a release in this direction, 0 for a stop.
    pub direction: i8,
}

/// The motion of a body under a record.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct RecordMotion<F> {
    /// Its extremes, sums and counts.
    pub answer: RecordAnswer<F>,
    /// States at the beginning, at each event, and at equal parts of each step between them.
    pub states: Vec<RecordState<F>>,
    /// Releases and stops, to the rest after the record.
    pub events: Vec<RecordEvent<F>>,
}

/// The most states that are kept.
const MOST_STATES: usize = 20_000_000;
/// The number of states beyond which those long after the record are left out.
const ENOUGH: usize = 100_000;

/// Collects states and events beside the answers.
struct History<F> {
    totals: Totals<F>,
    states: Vec<RecordState<F>>,
    events: Vec<RecordEvent<F>>,
    /// The greatest distance of states.
    interval: F,
    /// The time up to which states are kept, also where there are enough.
    until: F,
    weights: Weights<F>,
    excitation: Excitation,
}

impl<F: Float> History<F> {
    /// Adds a state under a load per mass; `spring` is the force of the spring on its support at 0, which a body at rest bears.
    fn push(&mut self, time: F, [x, v, a]: [F; 3], sign: F, [load, spring]: [F; 2]) {
        let &Weights { mass, friction, friction_offset, mean_force, .. } = &self.weights;
        let direction = direction(sign);
        let push = mass * load;
        let friction =
            if direction == 0 { spring - push - mean_force } else { -(sign * friction + friction_offset) };
        let absolute = if self.excitation.carries_surface() { a - load } else { a };
        let force = if self.excitation.moves_foot() || self.excitation.carries_surface() {
            mean_force - mass * absolute
        } else {
            push + mean_force - mass * a
        };
        self.states.push(RecordState {
            time,
            displacement: x,
            velocity: v,
            acceleration: a,
            direction,
            absolute_acceleration: absolute,
            friction,
            transmitted_force: force,
            load: push,
        });
    }

    /// Whether no state of this time is kept.
    fn is_full(&self, time: F) -> bool {
        time >= self.until && self.states.len() > ENOUGH
    }

    /// The number of equal parts of a length that are no longer than the interval.
    fn parts(&self, length: F) -> f64 {
        (length / self.interval).to_f64().ceil()
    }
}

fn direction<F: Float>(sign: F) -> i8 {
    match sign.partial_cmp(&F::int(0)) {
        Some(Ordering::Greater) => 1,
        Some(Ordering::Less) => -1,
        _ => 0,
    }
}

impl<F: Float> Watch<F> for History<F> {
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()> {
        self.totals.slid(linear, slide, stretch)?;
        if self.is_full(stretch.time) {
            return Some(());
        }
        let parts = self.parts(stretch.length);
        let load = |t: F| [stretch.load[0] + slide.slope * t, F::int(0)];
        self.push(stretch.time, [stretch.x, slide.v, slide.a], slide.sign, load(F::int(0)));
        let mut part = 1.0;
        while part < parts {
            let t = stretch.length * F::from_f64(part) / F::from_f64(parts);
            if self.is_full(stretch.time + t) || self.states.len() > MOST_STATES {
                break;
            }
            let moment = slide.at(linear, t)?;
            let state = [stretch.x + moment.moved, moment.v, moment.a];
            self.push(stretch.time + t, state, slide.sign, load(t));
            part += 1.0;
        }
        Some(())
    }

    fn rested(&mut self, x: F, piece: &Piece<F>, start: F, from: F, length: F) -> Option<()> {
        self.totals.rested(x, piece, start, from, length)?;
        let zero = F::int(0);
        let spring = self.weights.stiffness * x;
        let (parts, mut part) = (self.parts(length), 0.0);
        loop {
            let t = from + length * F::from_f64(part) / F::from_f64(parts);
            self.push(start + t, [x, zero, zero], zero, [piece.from + piece.slope * t, spring]);
            part += 1.0;
            if part >= parts || self.is_full(start + t) || self.states.len() > MOST_STATES {
                return Some(());
            }
        }
    }

    fn released(&mut self, time: F, x: F, sign: F, onset: Onset) {
        self.totals.released(time, x, sign, onset);
        if onset == Onset::Touched {
            // The slide goes on.
            self.events.pop();
            while self.states.last().is_some_and(|state| state.direction == 0) {
                self.states.pop();
            }
            return;
        }
        self.events.push(RecordEvent { time, displacement: x, direction: direction(sign) });
    }

    fn stopped(&mut self, time: F, x: F) -> Option<()> {
        self.totals.stopped(time, x)?;
        self.events.push(RecordEvent { time, displacement: x, direction: 0 });
        Some(())
    }

    fn struck(&mut self, velocities: [F; 2], time: F) -> Option<()> {
        self.totals.struck(velocities, time)
    }

    fn freed(&mut self) {
        self.totals.freed();
    }

    fn counted(&mut self) {
        self.totals.counted();
    }

    fn stays(&mut self, load: F, time: F) -> Option<()> {
        self.totals.stays(load, time)
    }

    fn goes_on(&mut self, x: F, time: F) -> Option<()> {
        self.totals.goes_on(x, time)
    }

    fn tends_to(&mut self, places: [F; 2], load: F, swings: F) -> Option<()> {
        self.totals.tends_to(places, load, swings)
    }
}

impl<F: Float> Body<F> {
    /// The motion under a record from the displacement x and the velocity v, with its states at distances of at most
    /// `interval`, and its events.
    ///
    /// States are kept to the rest of the body; of more than 10⁵ no longer after the record than the record is long. The
    /// answers agree with those of [`Body::follow_from`] to rounding.
    ///
    /// # Errors
    /// As [`Body::follow_from`], and where the interval is not > 0, or more than 2·10⁷ states would be kept.
    pub fn motion(&self, record: &Record<F>, x: F, v: F, interval: F) -> Result<RecordMotion<F>, Error> {
        let interval = positive(Quantity::TimeStep, interval)?;
        let mut followed = self.followed(record, x, v)?;
        let (start, end) = (record.time(0), record.end());
        let mut history = History {
            totals: followed.totals,
            states: Vec::new(),
            events: Vec::new(),
            interval,
            until: end + (end - start),
            weights: Weights::of(self, |x| x),
            excitation: record.excitation(),
        };
        let sign = followed.follower.mode.sign();
        if sign != F::int(0) {
            history.events.push(RecordEvent { time: start, displacement: x, direction: direction(sign) });
        }
        let rest = self.watched(record, &mut followed.follower, &followed.factors, &mut history)?;
        let zero = F::int(0);
        let last = history.states.last().map_or(start, |state| state.time);
        let time = history.events.last().map_or(last, |event| event.time).or_larger(last);
        if followed.follower.mode.sign() == zero {
            let load = followed.factors.after(record.after(), record.last());
            // A support that has let go leaves no spring.
            let spring = self.mass() * followed.follower.constants.square * followed.follower.x;
            history.push(time.or_larger(end), [followed.follower.x, zero, zero], zero, [load, spring]);
        }
        let History { totals, states, events, .. } = history;
        if states.len() > MOST_STATES {
            return Err(Error::TooManyEvents { time: written(last) });
        }
        let answer = self.answered(record, [x, v], rest, &totals)?;
        Ok(RecordMotion { answer, states, events })
    }
}
