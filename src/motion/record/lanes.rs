//! Bodies side by side under one record: each step of a slide without an event is taken in vector lanes, and
//! whatever else happens by the [`Follower`] of the body alone.
//!
//! A step is a table of numbers that a body has for all steps of one length. The lanes decide only that nothing
//! happens: no stop by the certificate of [`super::slide`], no release, no extreme that would widen a range. Where a
//! lane cannot exclude it, the follower takes the step again from its start. A lane depends on no other, so that the
//! answers of a body are the same bits in any company; a body alone is one lane.

use super::follow::{Failed, Failure, Follower};
use super::linear::Responses;
use super::load::{Factors, Piece, Record};
use super::totals::Totals;
use crate::float::Float;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// A number of each lane.
type Row<F, const L: usize> = [F; L];

#[inline(always)]
fn at<F: Float, const L: usize>(row: &Row<F, L>, lane: usize) -> F {
    row.get(lane).copied().unwrap_or_else(|| F::int(0))
}

#[inline(always)]
fn set<F, const L: usize>(row: &mut Row<F, L>, lane: usize, value: F) {
    if let Some(place) = row.get_mut(lane) {
        *place = value;
    }
}

#[inline(always)]
fn select<F>(condition: bool, yes: F, no: F) -> F {
    if condition { yes } else { no }
}

fn infinity<F: Float>() -> F {
    F::int(1) / F::int(0)
}

/// `first` and the other condition, which one lane computes only where the first holds, and several ones always, so
/// that there is no branch.
#[inline(always)]
fn both<const L: usize>(first: bool, second: impl FnOnce() -> bool) -> bool {
    if L == 1 { first && second() } else { first & second() }
}

/// A body that is followed, with its answers.
#[derive(Debug)]
pub(super) struct Followed<F> {
    pub(super) follower: Follower<F>,
    pub(super) factors: Factors<F>,
    pub(super) totals: Totals<F>,
    pub(super) failure: Option<Failed<F>>,
}

/// The numbers that a step changes in all lanes, with their places in a body.
macro_rules! state {
    ($($field:ident: $($place:ident).+,)*) => {
        #[derive(Debug, Clone, Copy)]
        struct State<F, const L: usize> {
            $($field: Row<F, L>,)*
        }

        impl<F: Float, const L: usize> State<F, L> {
            fn zero() -> Self {
                Self { $($field: [F::int(0); L],)* }
            }

            /// Takes the state of a body into its lane.
            fn read(&mut self, lane: usize, body: &Followed<F>) {
                $(set(&mut self.$field, lane, body.$($place).+);)*
            }

            /// Returns the state of a lane to its body.
            fn write(&self, lane: usize, body: &mut Followed<F>) {
                // A rest of whole steps, which the lanes took.
                if at(&self.stick_time, lane) != body.totals.stick_time {
                    (body.follower.last.has_rested, body.follower.last.lost) = (true, None);
                }
                $(body.$($place).+ = at(&self.$field, lane);)*
            }
        }
    };
}

state! {
    x: follower.x,
    v: follower.v,
    load_work: totals.load_work,
    foot_work: totals.foot_work,
    stick_time: totals.stick_time,
    most_velocity: totals.velocity.most.value,
    most_velocity_time: totals.velocity.most.time,
    least_velocity: totals.velocity.least.value,
    least_velocity_time: totals.velocity.least.time,
    most_acceleration: totals.acceleration.most.value,
    least_acceleration: totals.acceleration.least.value,
    most_free: totals.free_acceleration.most.value,
    least_free: totals.free_acceleration.least.value,
}

/// The numbers of all lanes.
#[derive(Debug)]
struct Lanes<F, const L: usize> {
    state: State<F, L>,
    /// The direction: 0 at rest.
    sign: Row<F, L>,
    /// The load per mass of a sample, and of its slope.
    factor: Row<F, L>,
    damper: Row<F, L>,
    mean: Row<F, L>,
    friction: Row<F, L>,
    held_forward: Row<F, L>,
    held_backward: Row<F, L>,
    rate: Row<F, L>,
    square: Row<F, L>,
    omega: Row<F, L>,
    /// S₁ to S₄ after a step; S₁ is NaN where a step is longer than π/d, so that nothing can be excluded.
    impulse: Row<F, L>,
    step: Row<F, L>,
    ramp: Row<F, L>,
    parabola: Row<F, L>,
    /// 1 where something may have happened in the step.
    event: Row<F, L>,
}

impl<F: Float, const L: usize> Lanes<F, L> {
    fn new(bodies: &[Followed<F>]) -> Self {
        let zero = [F::int(0); L];
        let row = |empty: F, of: fn(&Followed<F>) -> F| {
            core::array::from_fn(|lane| bodies.get(lane).map_or(empty, of))
        };
        let number = |of| row(F::int(0), of);
        let mut lanes = Self {
            state: State::zero(),
            sign: zero,
            factor: number(|body| body.factors.factor),
            damper: number(|body| body.factors.damper),
            mean: number(|body| body.follower.constants.mean),
            friction: number(|body| body.follower.constants.friction),
            held_forward: row(infinity(), |body| body.follower.constants.held),
            held_backward: row(infinity(), |body| {
                let c = &body.follower.constants;
                select(c.is_one_way, infinity(), c.held)
            }),
            rate: number(|body| body.follower.constants.rate),
            square: number(|body| body.follower.constants.square),
            omega: number(|body| body.follower.omega),
            impulse: zero,
            step: zero,
            ramp: zero,
            parabola: zero,
            event: zero,
        };
        for (lane, body) in bodies.iter().enumerate() {
            lanes.read(lane, body);
        }
        lanes
    }

    /// Sets the responses of all lanes to those after a step.
    fn set_step(&mut self, whole: &[Option<Responses<F>>]) {
        for (lane, responses) in whole.iter().enumerate() {
            let nan = F::int(0) / F::int(0);
            set(&mut self.impulse, lane, responses.map_or(nan, |s| s.impulse));
            set(&mut self.step, lane, responses.map_or(nan, |s| s.step));
            set(&mut self.ramp, lane, responses.map_or(nan, |s| s.ramp));
            set(&mut self.parabola, lane, responses.map_or(nan, |s| s.parabola));
        }
    }

    /// Takes a body into its lane.
    fn read(&mut self, lane: usize, body: &Followed<F>) {
        self.state.read(lane, body);
        set(&mut self.sign, lane, body.follower.mode.sign());
    }

    /// A lane without a body, or with one that is not followed any further: it rests, whatever the load.
    fn empty(&mut self, lane: usize) {
        set(&mut self.sign, lane, F::int(0));
        set(&mut self.held_forward, lane, infinity());
        set(&mut self.held_backward, lane, infinity());
    }

    /// The numbers of a lane that all steps of one length have in common.
    #[inline(always)]
    fn given(&self, i: usize) -> Given<F> {
        Given {
            factors: Factors { factor: at(&self.factor, i), damper: at(&self.damper, i) },
            sign: at(&self.sign, i),
            mean: at(&self.mean, i),
            friction: at(&self.friction, i),
            rate: at(&self.rate, i),
            square: at(&self.square, i),
            omega: at(&self.omega, i),
            responses: [at(&self.impulse, i), at(&self.step, i), at(&self.ramp, i), at(&self.parabola, i)],
        }
    }

    /// Takes the step between two samples in all lanes in which nothing happens. Returns whether something may have
    /// happened in another one.
    #[inline(always)]
    fn pass(&mut self, samples: [F; 2], time: F, step: &Step<F>) -> bool {
        if L == 1 {
            match self.pass_quietly(samples, step) {
                Quiet::Passed => return false,
                Quiet::Event => {
                    set(&mut self.event, 0, F::int(1));
                    return true;
                }
                Quiet::Unknown => {}
            }
        }
        let zero = F::int(0);
        let length = step.length;
        let end = time + length;
        for i in 0..L {
            let given = self.given(i);
            let (x, v, sign) = (at(&self.state.x, i), at(&self.state.v, i), given.sign);
            let taken = given.take([x, v], samples, step);
            let Taken { piece: Piece { from: first, to: last, slope, foot, .. }, moved, area, .. } = taken;
            let rests = sign == zero;
            let rests_on = self.rests_on(i, &taken);
            let slides_on = (sign * taken.end_v > zero) & !given.turns::<L>(v, &taken, length);
            // The derivatives a′ and a″, and bounds of both by energies that do not grow.
            let (a, end_a) = (select(rests, zero, taken.a), select(rests, zero, taken.end_a));
            let (end_x, end_v) = (taken.end_x, taken.end_v);
            let (j, end_j) = (given.jerk(slope, v, a), given.jerk(slope, end_v, end_a));
            let (b, end_b) = (given.bend(a, j), given.bend(end_a, end_j));
            // Extremes at the ends; one between them is no further from the nearer end than g″ allows.
            let changes =
                |start: F, end: F| ((start < zero) & (end > zero)) | ((start > zero) & (end < zero));
            let beyond_v = || given.beyond(a, j, step);
            let beyond_a = || given.beyond(j, b, step);
            let (free, end_free) = (a - first, end_a - last);
            let extreme = |most: F, least: F, start: F, end: F, may: bool, beyond: &dyn Fn() -> F| {
                let [top, bottom] = ends(start, end);
                let is_flagged = both::<L>(may, || is_outside([most, least], [top, bottom], beyond()));
                (most.or_larger(top), -((-least).or_larger(-bottom)), is_flagged)
            };
            let (most, least) = (at(&self.state.most_velocity, i), at(&self.state.least_velocity, i));
            let (most_v, least_v, is_v) = extreme(most, least, v, end_v, changes(a, end_a), &beyond_v);
            let most_time = select(most_v > most, end, at(&self.state.most_velocity_time, i));
            let least_time = select(least_v < least, end, at(&self.state.least_velocity_time, i));
            let (most, least) = (at(&self.state.most_acceleration, i), at(&self.state.least_acceleration, i));
            let (most_a, least_a, is_a) = extreme(most, least, a, end_a, changes(j, end_j), &beyond_a);
            let (most, least) = (at(&self.state.most_free, i), at(&self.state.least_free, i));
            let bends = changes(j - slope, end_j - slope) | changes(b, end_b);
            let (most_f, least_f, is_f) = extreme(most, least, free, end_free, bends, &beyond_a);
            let is_event = (rests & !rests_on) | (!rests & (!slides_on | is_v | is_a | is_f));
            set(&mut self.event, i, select(is_event, F::int(1), zero));
            if L == 1 && is_event {
                return true;
            }
            let stays = rests | is_event;
            let state = &mut self.state;
            macro_rules! advance {
                ($field:ident, $unless:expr, $value:expr) => {
                    let before = at(&state.$field, i);
                    let value: F = $value(before);
                    set(&mut state.$field, i, select($unless, before, value));
                };
            }
            advance!(x, stays, |_| end_x);
            advance!(v, stays, |_| end_v);
            advance!(load_work, stays, |work| work + (last * moved - slope * area));
            advance!(foot_work, stays, |work| work + foot * moved);
            advance!(stick_time, is_event | !rests, |time| time + length);
            advance!(most_velocity, stays, |_| most_v);
            advance!(least_velocity, stays, |_| least_v);
            advance!(most_velocity_time, stays, |_| most_time);
            advance!(least_velocity_time, stays, |_| least_time);
            advance!(most_acceleration, is_event, |_| most_a);
            advance!(least_acceleration, is_event, |_| least_a);
            advance!(most_free, is_event, |_| most_f);
            advance!(least_free, is_event, |_| least_f);
        }
        self.event.iter().fold(false, |any, event| any | (*event != zero))
    }

    /// Whether a body at rest stays there.
    #[inline(always)]
    fn rests_on(&self, i: usize, taken: &Taken<F>) -> bool {
        let Taken { now, later, .. } = *taken;
        let (forward, backward) = (at(&self.held_forward, i), -at(&self.held_backward, i));
        (now <= forward) & (later <= forward) & (now >= backward) & (later >= backward)
    }

    /// Takes the step of the first lane if nothing happens and no range can change: one bound for each range, without a
    /// look at where its extremes are.
    #[inline(always)]
    fn pass_quietly(&mut self, samples: [F; 2], step: &Step<F>) -> Quiet {
        let (zero, given) = (F::int(0), self.given(0));
        let (x, v, sign) = (at(&self.state.x, 0), at(&self.state.v, 0), given.sign);
        let taken = given.take([x, v], samples, step);
        let Taken { piece: Piece { from, to, slope, foot, .. }, a, end_v, end_a, .. } = taken;
        let state = &self.state;
        let ranges = [
            [at(&state.most_velocity, 0), at(&state.least_velocity, 0)],
            [at(&state.most_acceleration, 0), at(&state.least_acceleration, 0)],
            [at(&state.most_free, 0), at(&state.least_free, 0)],
        ];
        if sign == zero {
            if !self.rests_on(0, &taken) {
                return Quiet::Event;
            }
            let is_same =
                !is_outside(ranges[1], [zero; 2], zero) && !is_outside(ranges[2], ends(-from, -to), zero);
            if is_same {
                let stick_time = at(&self.state.stick_time, 0) + step.length;
                set(&mut self.state.stick_time, 0, stick_time);
            }
            return if is_same { Quiet::Passed } else { Quiet::Unknown };
        }
        if !(sign * end_v > zero) {
            return Quiet::Event;
        }
        let j = given.jerk(slope, v, a);
        let beyond = given.beyond(j, given.bend(a, j), step);
        let is_same = !given.turns::<1>(v, &taken, step.length)
            && !is_outside(ranges[0], ends(v, end_v), given.beyond(a, j, step))
            && !is_outside(ranges[1], ends(a, end_a), beyond)
            && !is_outside(ranges[2], ends(a - from, end_a - to), beyond);
        if is_same {
            let (moved, area) = (taken.moved, taken.area);
            let load_work = at(&self.state.load_work, 0) + (to * moved - slope * area);
            let foot_work = at(&self.state.foot_work, 0) + foot * moved;
            let state = &mut self.state;
            set(&mut state.x, 0, taken.end_x);
            set(&mut state.v, 0, end_v);
            set(&mut state.load_work, 0, load_work);
            set(&mut state.foot_work, 0, foot_work);
            return Quiet::Passed;
        }
        Quiet::Unknown
    }
}

/// What a look at the bounds of a step says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Quiet {
    /// Nothing happened, and the step is taken.
    Passed,
    /// A stop or a release.
    Event,
    Unknown,
}

/// The greater and the lesser of a quantity's values at both ends of a step.
#[inline(always)]
fn ends<F: Float>(start: F, end: F) -> [F; 2] {
    [start.or_larger(end), -((-start).or_larger(-end))]
}

/// Whether numbers up to `beyond` above the greater or below the lesser of two are outside a range.
#[inline(always)]
fn is_outside<F: Float>([most, least]: [F; 2], [top, bottom]: [F; 2], beyond: F) -> bool {
    (top + beyond > most) | (bottom - beyond < least)
}

/// The numbers of a body that all steps of one length have in common.
#[derive(Debug, Clone, Copy)]
struct Given<F> {
    factors: Factors<F>,
    sign: F,
    mean: F,
    friction: F,
    rate: F,
    square: F,
    omega: F,
    /// S₁ to S₄.
    responses: [F; 4],
}

/// A step that a body has taken: at rest `now` and `later` are the forces on it.
#[derive(Debug, Clone, Copy)]
struct Taken<F> {
    piece: Piece<F>,
    now: F,
    later: F,
    a: F,
    end_a: F,
    moved: F,
    end_x: F,
    end_v: F,
    /// The integral of the displacement since the start.
    area: F,
}

impl<F: Float> Given<F> {
    /// The state after a step is the response to the state before it and to the load less friction, g + st:
    /// `x + S₁v + S₂(g − ω²x) + S₃s` and `v + S₁(g − ω²x − 2βv) + S₂(s − ω²v)`.
    #[inline(always)]
    fn take(&self, [x, v]: [F; 2], samples: [F; 2], step: &Step<F>) -> Taken<F> {
        let &Self { ref factors, sign, mean, friction, rate, square, responses: [s1, s2, s3, s4], .. } = self;
        let piece = Piece::new(factors, samples, step.length, step.inverse);
        let Piece { from: first, to: last, slope, .. } = piece;
        // A rest.
        let spring = square * x;
        let (now, later) = (first + mean - spring, last + mean - spring);
        // A slide.
        let push = mean - sign * friction;
        let force = (first + push) - spring;
        let a = force - rate * v;
        let moved = s1 * v + (s2 * force + s3 * slope);
        let end_v = v + ((s1 * force + s2 * slope) - (rate * s1 + square * s2) * v);
        let end_x = x + moved;
        let end_a = ((last + push) - square * end_x) - rate * end_v;
        let area = v * (s2 + rate * s3) + (a * s3 + slope * s4);
        Taken { piece, now, later, a, end_a, moved, end_x, end_v, area }
    }

    /// Whether the velocity may have vanished and turned back.
    #[inline(always)]
    fn turns<const L: usize>(&self, v: F, taken: &Taken<F>, length: F) -> bool {
        let (zero, sign) = (F::int(0), self.sign);
        let Taken { a, end_a, end_v, piece: Piece { slope, .. }, .. } = *taken;
        both::<L>((sign * a < zero) & (sign * end_a > zero), || {
            let swing = ((slope - self.square * v) - self.rate * a).abs() + self.omega * a.abs();
            let far = length * (a.abs() + length * swing);
            (sign * v <= far) | (sign * end_v <= far)
        })
    }

    /// a′.
    #[inline(always)]
    fn jerk(&self, slope: F, v: F, a: F) -> F {
        (slope - self.square * v) - self.rate * a
    }

    /// a″.
    #[inline(always)]
    fn bend(&self, a: F, jerk: F) -> F {
        -(self.rate * jerk + self.square * a)
    }

    /// How far an extreme in a step is from the nearer end at most, by the first two derivatives at the start.
    #[inline(always)]
    fn beyond(&self, first: F, second: F, step: &Step<F>) -> F {
        (second.abs() + self.omega * first.abs()) * step.eighth
    }
}

/// A step of the record: its length h, 1/h and h²/8.
#[derive(Debug, Clone, Copy)]
struct Step<F> {
    length: F,
    inverse: F,
    eighth: F,
}

/// The samples between two looks at whether to go on.
const SAMPLES: usize = 1 << 12;

/// Follows at most `L` bodies through a record as long as `keep_going` allows; where one cannot be followed, its failure
/// says why.
#[inline(always)]
pub(super) fn follow<F: Float, const L: usize>(
    bodies: &mut [Followed<F>],
    record: &Record<F>,
    keep_going: &dyn Fn() -> ControlFlow<()>,
) {
    let mut lanes = Lanes::<F, L>::new(bodies);
    for (lane, body) in bodies.iter_mut().enumerate() {
        if body.failure.is_some() {
            lanes.empty(lane);
        }
    }
    let mut whole = Vec::new();
    let mut step = Step { length: F::int(0), inverse: F::int(0), eighth: F::int(0) };
    let samples = record.samples();
    for (index, (&first, &second)) in samples.iter().zip(samples.iter().skip(1)).enumerate() {
        if index.is_multiple_of(SAMPLES) && keep_going().is_break() {
            let time = record.time(index);
            for body in bodies.iter_mut() {
                body.failure = body.failure.or(Some((Failure::Interrupted, time)));
            }
            break;
        }
        let length = record.step_after(index);
        if length == F::int(0) {
            // Two samples at one time: the next step begins with the second.
            continue;
        }
        if length != step.length {
            step = Step { length, inverse: F::int(1) / length, eighth: length.square() * F::ratio(1, 8) };
            whole = bodies.iter().map(|body| body.follower.whole_step(length)).collect();
            lanes.set_step(&whole);
        }
        let time = record.time(index);
        if lanes.pass([first, second], time, &step) {
            step_alone(&mut lanes, bodies, &whole, [first, second], time, &step);
        }
    }
    for (lane, body) in bodies.iter_mut().enumerate() {
        lanes.state.write(lane, body);
    }
}

/// Takes the step in the lanes in which something may have happened.
#[inline(never)]
fn step_alone<F: Float, const L: usize>(
    lanes: &mut Lanes<F, L>,
    bodies: &mut [Followed<F>],
    whole: &[Option<Responses<F>>],
    samples: [F; 2],
    time: F,
    step: &Step<F>,
) {
    for (lane, (body, whole)) in bodies.iter_mut().zip(whole).enumerate() {
        if at(&lanes.event, lane) == F::int(0) {
            continue;
        }
        lanes.state.write(lane, body);
        let piece = Piece::new(&body.factors, samples, step.length, step.inverse);
        match body.follower.step(&piece, time, whole.as_ref(), &mut body.totals) {
            Ok(()) => lanes.read(lane, body),
            Err(failure) => {
                body.failure = Some((failure, time));
                lanes.empty(lane);
            }
        }
    }
}
