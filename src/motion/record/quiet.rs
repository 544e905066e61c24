//! Steps of a record in which nothing happens to a body: no stop, no release, and no extreme outside the ranges so far
//! but at the end of the step.
//!
//! A step is a table of numbers that a body has for all steps of one length, until its next event. Bounds decide that
//! nothing happens: in a step of length h a quantity g is no further beyond its greater end than h²/8 times the greatest
//! |g″|. The energy of a free vibration does not grow, so that with a and a′ at the start
//!
//! ```text
//! |v″| ≤ E,   |a″| ≤ (ω + 2β)E,   |a‴| ≤ (ω + 2β)²E,   E = |a′| + ω|a|.
//! ```
//!
//! A range grows in such a step if its quantity is monotone there: its derivative has one sign by the same bounds.
//!
//! A body at rest has the same table with zeros in place of the responses: a is the force on it, and the bounds of a
//! are those of the static friction, and of the forces on the support so far.

use super::follow::{Failed, Failure, Follower, Mode};
use super::linear::{Law, Responses};
use super::load::{Factors, Piece};
use super::number::Number as _;
use super::totals::Totals;
use crate::float::Float;

/// A body that is followed, with its answers.
#[derive(Debug)]
pub(super) struct Followed<F> {
    pub(super) follower: Follower<F>,
    pub(super) factors: Factors<F>,
    pub(super) totals: Totals<F>,
    pub(super) failure: Option<Failed<F>>,
}

/// A step of the record: its length h, 1/h and h²/8.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<F> {
    pub(super) length: F,
    pub(super) inverse: F,
    eighth: F,
}

impl<F: Float> Step<F> {
    #[inline(always)]
    pub(super) fn new(length: F) -> Self {
        Self { length, inverse: F::int(1) / length, eighth: length.square() * F::ratio(1, 8) }
    }
}

/// The load of a step, per mass: at both ends, and its slope.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load<F> {
    pub(super) from: F,
    pub(super) to: F,
    pub(super) slope: F,
    /// 2βu′ of a support on which the damper stands.
    pub(super) foot: F,
}

/// What a step adds to the state, whatever the state is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Push<F> {
    pub(super) x: F,
    pub(super) v: F,
}

/// The numbers of a body in the steps of one length until its next event.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quiet<F> {
    pub(super) factor: F,
    pub(super) damper: F,
    /// The constant force, less friction.
    pub(super) push: F,
    pub(super) rate: F,
    pub(super) square: F,
    pub(super) omega: F,
    /// The direction: 0 at rest.
    pub(super) sign: F,
    /// S₁ to S₃, and what a step takes of x and v: `x` grows by `S₁v − ω²S₂x`, v by `−ω²S₁x − (2βS₁ + ω²S₂)v`.
    pub(super) impulse: F,
    pub(super) step: F,
    pub(super) ramp: F,
    pub(super) x_of_x: F,
    pub(super) v_of_x: F,
    pub(super) v_of_v: F,
    /// The integral of the displacement since the start, by v, a and the slope.
    pub(super) area_of_v: F,
    pub(super) area_of_slope: F,
    /// Bounds of how far v, a and a′ are beyond the greater of their ends, by E; to that of v `below` is added, which is
    /// below 0 at rest, and in a damped slide the speed from which on it may be one that tends to rest.
    pub(super) beyond_v: F,
    pub(super) beyond_a: F,
    pub(super) below: F,
    pub(super) beyond_jerk: F,
    /// 0, and infinite where the ranges must not grow.
    pub(super) never: F,
}

/// The ranges so far: of the speed in the direction of the slide, of a, and of a less the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits<F> {
    pub(super) most_speed: F,
    /// The time of that speed.
    pub(super) fastest: F,
    pub(super) most_a: F,
    pub(super) least_a: F,
    pub(super) most_free: F,
    pub(super) least_free: F,
}

impl<F: Float> Limits<F> {
    pub(super) fn none() -> Self {
        let infinity = infinity::<F>();
        Self {
            most_speed: infinity,
            fastest: F::int(0),
            most_a: infinity,
            least_a: -infinity,
            most_free: infinity,
            least_free: -infinity,
        }
    }

    /// Those of a body.
    pub(super) fn of(body: &Followed<F>) -> Self {
        let totals = &body.totals;
        let (velocity, acceleration, free) =
            (&totals.velocity, &totals.acceleration, &totals.free_acceleration);
        // The range of the velocity has 0 from the first stop on. Before that, it has an end that a slide may pass
        // downwards, and that of a body at rest may not have its acceleration.
        let is_known = velocity.has(F::int(0));
        let Mode::Slide(sign) = body.follower.mode else {
            let c = &body.follower.constants;
            let backward = if c.is_one_way { infinity() } else { c.held };
            let offset = c.mean - c.square * body.follower.x;
            let none = Self::none();
            return if is_known && acceleration.has(F::int(0)) {
                let most_a = lesser(c.held, offset - free.least.value);
                Self { most_a, least_a: greater(-backward, offset - free.most.value), ..none }
            } else {
                Self { most_a: -none.most_a, ..none }
            };
        };
        let fastest = if sign > F::int(0) { velocity.most } else { velocity.least };
        let nan = F::int(0) / F::int(0);
        Self {
            most_speed: if is_known { sign * fastest.value } else { nan },
            fastest: fastest.time,
            most_a: acceleration.most.value,
            least_a: acceleration.least.value,
            most_free: free.most.value,
            least_free: free.least.value,
        }
    }

    /// Returns the ranges to their body.
    pub(super) fn write(&self, body: &mut Followed<F>) {
        let Mode::Slide(sign) = body.follower.mode else { return };
        let totals = &mut body.totals;
        let velocity = &mut totals.velocity;
        let fastest = if sign > F::int(0) { &mut velocity.most } else { &mut velocity.least };
        if self.most_speed > sign * fastest.value {
            (fastest.value, fastest.time) = (sign * self.most_speed, self.fastest);
        }
        let (acceleration, free) = (&mut totals.acceleration, &mut totals.free_acceleration);
        (acceleration.most.value, acceleration.least.value) = (self.most_a, self.least_a);
        (free.most.value, free.least.value) = (self.most_free, self.least_free);
    }
}

/// A step that was looked at: whether nothing happens, the work of the load, and the ranges after it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passed<F> {
    pub(super) is_quiet: bool,
    /// Whether the ranges stay.
    pub(super) is_within: bool,
    pub(super) work: F,
    pub(super) limits: Limits<F>,
}

/// `if first > second { first } else { second }`: a second number that is NaN remains.
#[inline(always)]
pub(super) fn greater<F: Float>(first: F, second: F) -> F {
    if first > second { first } else { second }
}

#[inline(always)]
pub(super) fn lesser<F: Float>(first: F, second: F) -> F {
    if first < second { first } else { second }
}

pub(super) fn infinity<F: Float>() -> F {
    F::int(1) / F::int(0)
}

impl<F: Float> Quiet<F> {
    /// Those of no body: it rests, whatever the load.
    pub(super) fn none() -> Self {
        let zero = F::int(0);
        Self {
            factor: zero,
            damper: zero,
            push: zero,
            rate: zero,
            square: zero,
            omega: zero,
            sign: zero,
            impulse: zero,
            step: zero,
            ramp: zero,
            x_of_x: zero,
            v_of_x: zero,
            v_of_v: zero,
            area_of_v: zero,
            area_of_slope: zero,
            beyond_v: zero,
            beyond_a: zero,
            below: F::int(-1),
            beyond_jerk: zero,
            never: infinity(),
        }
    }

    /// Those of a body, given the responses after a step; without them a slide has no quiet step.
    pub(super) fn of(body: &Followed<F>, whole: Option<&Responses<F>>, step: &Step<F>) -> Self {
        let zero = F::int(0);
        let c = &body.follower.constants;
        let common = Self {
            factor: body.factors.factor,
            damper: body.factors.damper,
            rate: c.rate,
            square: c.square,
            omega: body.follower.omega,
            ..Self::none()
        };
        let Mode::Slide(sign) = body.follower.mode else {
            return Self { push: c.mean, ..common };
        };
        let nan = F::int(0) / F::int(0);
        let s = whole.copied().unwrap_or(Responses { impulse: nan, step: nan, ramp: nan, parabola: nan });
        Self {
            push: c.mean - sign * c.friction,
            sign,
            impulse: s.impulse,
            step: s.step,
            ramp: s.ramp,
            x_of_x: -(c.square * s.step),
            v_of_x: -(c.square * s.impulse),
            v_of_v: -(c.rate * s.impulse + c.square * s.step),
            area_of_v: s.step + c.rate * s.ramp,
            area_of_slope: s.parabola,
            beyond_v: step.eighth,
            beyond_a: step.eighth * (common.omega + c.rate),
            below: body.slowest(),
            beyond_jerk: step.eighth * (common.omega + c.rate).square(),
            never: zero,
            ..common
        }
    }

    #[inline(always)]
    pub(super) fn law(&self) -> Law<F> {
        Law { rate: self.rate, square: self.square }
    }

    /// The constant force less friction, and the direction, of a body that slides, where they are all that has changed.
    pub(super) fn turned(sign_before: F, body: &Followed<F>) -> Option<[F; 2]> {
        let c = &body.follower.constants;
        match body.follower.mode {
            Mode::Slide(sign) if sign_before != F::int(0) => Some([c.mean - sign * c.friction, sign]),
            Mode::Slide(_) | Mode::Rest => None,
        }
    }

    /// The load between two samples, which change by so much in a unit of time.
    #[inline(always)]
    pub(super) fn load(&self, [first, second]: [F; 2], change: F) -> Load<F> {
        let foot = self.damper * change;
        let (from, to) = (first * self.factor + foot, second * self.factor + foot);
        Load { from, to, slope: change * self.factor, foot }
    }

    #[inline(always)]
    pub(super) fn push(&self, load: &Load<F>) -> Push<F> {
        let force = load.from + self.push;
        Push {
            x: self.step * force + self.ramp * load.slope,
            v: self.impulse * force + self.step * load.slope,
        }
    }

    /// The way of x in a step.
    #[inline(always)]
    pub(super) fn moved(&self, [x, v]: [F; 2], push: &Push<F>) -> F {
        push.x + (self.x_of_x * x + self.impulse * v)
    }

    /// The state after a step.
    #[inline(always)]
    pub(super) fn after(&self, [x, v]: [F; 2], push: &Push<F>) -> [F; 2] {
        // The sums with what is known before the state are first, because a body alone waits for the rest.
        let of_x = (x + push.x) + (self.x_of_x * x + self.impulse * v);
        let of_v = (v + push.v) + (self.v_of_x * x + self.v_of_v * v);
        [of_x, of_v]
    }

    /// The acceleration less the load.
    #[inline(always)]
    fn free(&self, [x, v]: [F; 2]) -> F {
        (self.push - self.square * x) - self.rate * v
    }

    /// Looks at a step between two states, which ends at a time. The ranges may grow in it, or not.
    #[inline(always)]
    pub(super) fn passed(
        &self,
        [start, end]: [[F; 2]; 2],
        load: &Load<F>,
        moved: F,
        limits: &Limits<F>,
        growth_at: Option<F>,
    ) -> Passed<F> {
        let (free, end_free) = (self.free(start), self.free(end));
        let (a, end_a) = (free + load.from, end_free + load.to);
        // The derivative of a less the load, and that of a.
        let swing = -(self.square * start[1] + self.rate * a);
        let jerk = load.slope + swing;
        let energy = jerk.abs() + self.omega * a.abs();
        let (of_v, of_a) = (energy * self.beyond_v + self.below, energy * self.beyond_a);
        let (speed, end_speed) = (self.sign * start[1], self.sign * end[1]);
        let is_v = greater(speed, end_speed) + of_v <= limits.most_speed;
        let is_a = (greater(a, end_a) + of_a <= limits.most_a) & (lesser(a, end_a) - of_a >= limits.least_a);
        let is_free = (greater(free, end_free) + of_a <= limits.most_free)
            & (lesser(free, end_free) - of_a >= limits.least_free);
        // A greatest speed that is not known yet is NaN.
        let is_known = limits.most_speed.abs() >= F::int(0);
        let goes_on = (speed > of_v) & (end_speed > of_v) & is_known;
        let area = self.area_of_v * start[1] + (self.ramp * a + self.area_of_slope * load.slope);
        let work = load.to * moved - load.slope * area;
        let is_within = is_v & is_a & is_free;
        let Some(time) = growth_at else {
            return Passed { is_quiet: goes_on & is_within, is_within, work, limits: *limits };
        };
        let end_swing = -(self.square * end[1] + self.rate * end_a);
        let end_jerk = load.slope + end_swing;
        let of_jerk = energy * self.beyond_jerk;
        let has_sign =
            |start: F, end: F, reach: F| (lesser(start, end) > reach) | (greater(start, end) < -reach);
        let is_quiet = goes_on
            & (is_v | has_sign(a, end_a, of_a + self.never))
            & (is_a | has_sign(jerk, end_jerk, of_jerk + self.never))
            & (is_free | has_sign(swing, end_swing, of_jerk + self.never));
        let limits = Limits {
            fastest: if end_speed > limits.most_speed { time } else { limits.fastest },
            most_speed: greater(end_speed, limits.most_speed),
            most_a: greater(greater(a, end_a), limits.most_a),
            least_a: lesser(lesser(a, end_a), limits.least_a),
            most_free: greater(greater(free, end_free), limits.most_free),
            least_free: lesser(lesser(free, end_free), limits.least_free),
        };
        Passed { is_quiet, is_within, work, limits }
    }
}

impl<F: Float> Followed<F> {
    /// Adds rests of so many whole steps.
    pub(super) fn rested(&mut self, steps: usize, length: F) {
        if steps > 0 && matches!(self.follower.mode, Mode::Rest) {
            (self.follower.last.has_rested, self.follower.last.lost) = (true, None);
            self.totals.stick_time = self.totals.stick_time + F::count(steps) * length;
        }
    }

    /// Takes a step by events; whether it could be taken.
    #[inline(never)]
    pub(super) fn take(
        &mut self,
        samples: [F; 2],
        time: F,
        step: &Step<F>,
        whole: Option<&Responses<F>>,
    ) -> bool {
        let piece = Piece::new(&self.factors, samples, step.length, step.inverse);
        let taken = self.follower.step(&piece, time, whole, &mut self.totals);
        self.keep(taken, time)
    }

    /// The speed of a damped slide below which its digits are those of the follower alone, by the greatest so far.
    fn slowest(&self) -> F {
        let (zero, velocity) = (F::int(0), &self.totals.velocity);
        if self.follower.constants.rate > zero {
            velocity.most.value.abs().or_larger(velocity.least.value.abs()) * F::ratio(1, 1 << 24)
        } else {
            zero
        }
    }

    /// Whether the follower alone takes a step between these samples: under a constant load a damped slide may tend to rest,
    /// and goes on from there in the step after it.
    pub(super) fn is_followed(&self, [first, second]: [F; 2]) -> bool {
        let Follower { kept, mode, constants, .. } = &self.follower;
        kept.is_some() || (first == second && constants.rate > F::int(0) && matches!(mode, Mode::Slide(_)))
    }

    /// Sets the state after quiet steps.
    #[inline(always)]
    pub(super) fn set_state(&mut self, [x, v]: [F; 2]) {
        let follower = &mut self.follower;
        if x != follower.x || v != follower.v {
            follower.kept = None;
        }
        (follower.x, follower.v) = (x, v);
    }

    /// Takes a jump of the record between two samples; whether it could be taken.
    pub(super) fn jump(&mut self, samples: [F; 2], time: F) -> bool {
        let taken = self.follower.jump(&self.factors, samples, time, &mut self.totals);
        self.keep(taken.ok_or(Failure::Uncertain), time)
    }

    /// Keeps the failure of a step that begins at this time; whether there is none.
    #[inline(always)]
    pub(super) fn keep(&mut self, taken: Result<(), Failure>, time: F) -> bool {
        self.failure = taken.err().map(|failure| (failure, time));
        self.failure.is_none()
    }
}
