//! Bodies side by side through a record, each step in which nothing happens in vector lanes.
//!
//! Whatever else happens is left to the [`Follower`](super::follow::Follower), which takes the step from its start. A
//! lane depends on no other, so that the answers of a body are the same bits alone and in any company.

use super::follow::Failure;
use super::linear::Responses;
use super::load::Record;
use super::quiet::{Followed, Limits, Quiet, Step};
use super::rows::{LimitsRows, QuietRows, Row, at, select, set};
use super::turns::Turns;
use crate::float::Float;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// The numbers of all lanes that a step changes.
#[derive(Debug)]
struct State<F, const L: usize> {
    limits: LimitsRows<F, L>,
    x: Row<F, L>,
    v: Row<F, L>,
    load_work: Row<F, L>,
    foot_work: Row<F, L>,
}

impl<F: Float, const L: usize> State<F, L> {
    fn new() -> Self {
        let zero = [F::int(0); L];
        Self { limits: LimitsRows::none(), x: zero, v: zero, load_work: zero, foot_work: zero }
    }

    /// Takes the state of a body into its lane.
    fn read(&mut self, lane: usize, body: &Followed<F>) {
        if body.failure.is_some() {
            // An empty lane rests at 0, whatever its body left there.
            self.limits.set(lane, &Limits::none());
            for row in [&mut self.x, &mut self.v, &mut self.load_work, &mut self.foot_work] {
                set(row, lane, F::int(0));
            }
            return;
        }
        self.limits.set(lane, &Limits::of(body));
        set(&mut self.x, lane, body.follower.x);
        set(&mut self.v, lane, body.follower.v);
        set(&mut self.load_work, lane, body.totals.load_work);
        set(&mut self.foot_work, lane, body.totals.foot_work);
    }

    /// Returns the state of a lane to its body.
    fn write(&self, lane: usize, body: &mut Followed<F>) {
        body.set_state([at(&self.x, lane), at(&self.v, lane)]);
        body.totals.load_work = at(&self.load_work, lane);
        body.totals.foot_work = at(&self.foot_work, lane);
        self.limits.at(lane).write(body);
    }
}

/// The other numbers of all lanes: of each the steps at its last event, and 1 where something may have happened in the
/// step.
#[derive(Debug)]
struct Lanes<F, const L: usize> {
    quiet: QuietRows<F, L>,
    event: Row<F, L>,
    since: [usize; L],
    turns: Turns<F, L>,
    /// Whether the turns are those of this step.
    are_turns: bool,
}

impl<F: Float, const L: usize> Lanes<F, L> {
    fn new() -> Self {
        Self {
            quiet: QuietRows::none(),
            event: [F::int(0); L],
            since: [0; L],
            turns: Turns::new(),
            are_turns: false,
        }
    }

    /// Takes a body into its lane, after so many steps; one that is not followed any further leaves it empty.
    fn read(
        &mut self,
        lane: usize,
        body: &Followed<F>,
        whole: Option<&Responses<F>>,
        step: &Step<F>,
        steps: usize,
    ) {
        self.turns.read(lane, body, whole, step);
        self.begin(lane, body, whole, step, steps);
    }

    /// Takes the numbers of the quiet steps of a body into its lane.
    fn begin(
        &mut self,
        lane: usize,
        body: &Followed<F>,
        whole: Option<&Responses<F>>,
        step: &Step<F>,
        steps: usize,
    ) {
        set(&mut self.since, lane, steps);
        let is_empty = body.failure.is_some();
        self.quiet.set(lane, &if is_empty { Quiet::none() } else { Quiet::of(body, whole, step) });
    }

    /// Takes a body into its lane after a step of the same length.
    fn update(
        &mut self,
        lane: usize,
        body: &Followed<F>,
        whole: Option<&Responses<F>>,
        step: &Step<F>,
        steps: usize,
    ) {
        match Quiet::turned(at(&self.quiet.sign, lane), body) {
            Some([push, sign]) if body.failure.is_none() => {
                set(&mut self.since, lane, steps);
                set(&mut self.quiet.push, lane, push);
                set(&mut self.quiet.sign, lane, sign);
            }
            _ => self.begin(lane, body, whole, step, steps),
        }
        self.turns.update(lane, body);
    }

    /// Returns a lane to its body, after so many steps.
    fn write(&self, state: &State<F, L>, lane: usize, body: &mut Followed<F>, length: F, steps: usize) {
        if body.failure.is_none() {
            state.write(lane, body);
            let since = self.since.get(lane).copied().unwrap_or(steps);
            body.rested(steps.saturating_sub(since), length);
        }
    }

    /// Takes the step between two samples, which begins at a time, from one state of all lanes to the next. Returns the
    /// number of lanes in which something may have happened.
    #[inline(always)]
    fn pass(
        &mut self,
        now: &State<F, L>,
        next: &mut State<F, L>,
        samples: [F; 2],
        time: F,
        step: &Step<F>,
    ) -> F {
        let [first, second] = samples;
        let (zero, change, time) = (F::int(0), (second - first) * step.inverse, time + step.length);
        for i in 0..L {
            let quiet = self.quiet.at(i);
            let start = [at(&now.x, i), at(&now.v, i)];
            let load = quiet.load(samples, change);
            let push = quiet.push(&load);
            let moved = quiet.moved(start, &push);
            let end = quiet.after(start, &push);
            let passed = quiet.passed([start, end], &load, moved, &now.limits.at(i), Some(time));
            set(&mut self.event, i, select(passed.is_quiet, zero, F::int(1)));
            // The state after a step in which something happens is written once more.
            next.limits.set(i, &passed.limits);
            set(&mut next.x, i, end[0]);
            set(&mut next.v, i, end[1]);
            set(&mut next.load_work, i, at(&now.load_work, i) + passed.work);
            set(&mut next.foot_work, i, at(&now.foot_work, i) + load.foot * moved);
        }
        self.event.iter().fold(zero, |events, event| events + *event)
    }
}

/// The events in a step from which on their turns are taken in lanes.
const MANY: i32 = 4;
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
    let mut lanes = Lanes::<F, L>::new();
    // The states before and after a step take turns.
    let (mut even, mut odd) = (State::<F, L>::new(), State::<F, L>::new());
    let mut whole = Vec::new();
    let mut step = Step::new(F::int(0));
    // The steps taken, and the jump of the load after the last one: rests are counted up to there, as for a body alone.
    let (mut steps, mut jump) = (0usize, None);
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
            jump = Some(([first, second], record.time(index)));
            continue;
        }
        let is_even = steps.is_multiple_of(2);
        if length != step.length || jump.is_some() {
            let (jump, before) = (jump.take(), step.length);
            let now = if is_even { &mut even } else { &mut odd };
            step = Step::new(length);
            whole = bodies.iter().map(|body| body.follower.whole_step(length)).collect();
            for (lane, (body, whole)) in bodies.iter_mut().zip(&whole).enumerate() {
                if steps > 0 {
                    lanes.write(now, lane, body, before, steps);
                }
                struck(body, jump);
                lanes.read(lane, body, whole.as_ref(), &step, steps);
                now.read(lane, body);
            }
        }
        let time = record.time(index);
        // Two loops, so that each has states of its own.
        let events = if is_even {
            lanes.pass(&even, &mut odd, [first, second], time, &step)
        } else {
            lanes.pass(&odd, &mut even, [first, second], time, &step)
        };
        if events > F::int(0) {
            let (now, next) = if is_even { (&even, &mut odd) } else { (&odd, &mut even) };
            lanes.are_turns = events >= F::int(MANY);
            if lanes.are_turns {
                lanes.turns.take(
                    &lanes.quiet,
                    [&now.x, &now.v],
                    &now.limits,
                    &lanes.event,
                    [first, second],
                    &step,
                );
            }
            take(&mut lanes, (now, next), bodies, &whole, ([first, second], time), &step, steps);
        }
        steps = steps.saturating_add(1);
    }
    let now = if steps.is_multiple_of(2) { &even } else { &odd };
    for (lane, body) in bodies.iter_mut().enumerate() {
        if steps > 0 {
            lanes.write(now, lane, body, step.length, steps);
        }
        struck(body, jump);
    }
}

/// Takes a jump of the load at a time, if there is one, with a body that is still followed.
fn struck<F: Float>(body: &mut Followed<F>, jump: Option<([F; 2], F)>) {
    if let (Some((samples, time)), None) = (jump, body.failure) {
        body.jump(samples, time);
    }
}

/// Takes the step in the lanes in which something may have happened.
#[inline(never)]
fn take<F: Float, const L: usize>(
    lanes: &mut Lanes<F, L>,
    (now, next): (&State<F, L>, &mut State<F, L>),
    bodies: &mut [Followed<F>],
    whole: &[Option<Responses<F>>],
    (samples, time): ([F; 2], F),
    step: &Step<F>,
    steps: usize,
) {
    for (lane, (body, whole)) in bodies.iter_mut().zip(whole).enumerate() {
        if at(&lanes.event, lane) == F::int(0) || body.failure.is_some() {
            continue;
        }
        lanes.write(now, lane, body, step.length, steps);
        let is_followed = body.is_followed(samples);
        let turn =
            (lanes.are_turns && !is_followed).then(|| lanes.turns.turn(lane)).flatten().or_else(|| {
                if is_followed {
                    return None;
                }
                let state = [at(&now.x, lane), at(&now.v, lane)];
                let (linear, quiet) = (&body.follower.linear, lanes.quiet.at(lane));
                lanes.turns.of(lane).alone(linear, &quiet, state, &now.limits.at(lane), samples, step)
            });
        match turn {
            Some(turn) => body.turn(&turn, samples, time, step, whole.as_ref()),
            None => body.take(samples, time, step, whole.as_ref()),
        };
        lanes.update(lane, body, whole.as_ref(), step, steps.saturating_add(1));
        next.read(lane, body);
    }
}
