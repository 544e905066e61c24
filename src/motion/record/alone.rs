//! One body through a record, steps in which nothing happens in blocks.
//!
//! Whatever else happens is left to the [`Follower`](super::follow::Follower), which takes the step from its start. A
//! step in a block depends on none after it, so that the answers are the same bits as those of steps one by one.

use super::load::Record;
use super::quiet::{Followed, Limits, Passed, Push, Quiet, Step};
use super::rows::{at, select, set};
use super::turns::Turning;
use crate::float::{Float, Task};

/// The steps of a block.
const BLOCK: usize = 16;
/// The steps in which no range grew, after which a body alone takes blocks.
const CALM: usize = 2;

/// Follows one body through a record.
pub(super) fn follow_alone<F: Float>(body: &mut Followed<F>, record: &Record<F>) {
    F::fused(Alone { body, record });
}

/// One body under a record.
struct Alone<'a, F> {
    body: &'a mut Followed<F>,
    record: &'a Record<F>,
}

impl<F: Float> Task for Alone<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { body, record } = self;
        let (mut index, samples) = (0usize, record.samples());
        while index.saturating_add(1) < samples.len() && body.failure.is_none() {
            let length = record.step_after(index);
            // The samples up to the end of the steps of this length.
            let mut equal = if record.step().is_some() { samples.len() } else { index.saturating_add(2) };
            while equal < samples.len() && record.step_after(equal.saturating_sub(1)) == length {
                equal = equal.saturating_add(1);
            }
            let samples = samples.get(index..equal).unwrap_or_default();
            if length > F::int(0) {
                follow_equal(body, samples, |taken| record.time(index.saturating_add(taken)), length);
            } else if let &[first, second, ..] = samples {
                body.jump([first, second], record.time(index));
            }
            index = equal.saturating_sub(1);
        }
    }
}

/// Follows one body through steps of one length.
#[inline(always)]
fn follow_equal<F: Float>(body: &mut Followed<F>, samples: &[F], time: impl Fn(usize) -> F, length: F) {
    let step = Step::new(length);
    let whole = body.follower.whole_step(length);
    let mut left = samples;
    let mut state = [body.follower.x, body.follower.v];
    let mut quiet = Quiet::of(body, whole.as_ref(), &step);
    let mut limits = Limits::of(body);
    let mut turning = Turning::of(body, whole.as_ref(), &step);
    // The quiet steps since the last event, and those in which no range grew.
    let (mut steps, mut calm) = (0usize, 0usize);
    while left.len() > 1 {
        if calm >= CALM
            && let Some(block) = left.first_chunk::<{ BLOCK + 1 }>()
        {
            let taken = pass_block(body, &mut state, &quiet, &limits, block, &step);
            left = left.get(taken..).unwrap_or_default();
            steps = steps.saturating_add(taken);
            if taken == BLOCK {
                continue;
            }
        }
        let &[first, second, ..] = left else { break };
        let start = time(samples.len().saturating_sub(left.len()));
        let end = start + length;
        left = left.get(1..).unwrap_or_default();
        let (is_quiet, is_within) =
            pass_one(body, &mut state, &quiet, &mut limits, [first, second], end, &step);
        calm = if is_quiet & is_within { calm.saturating_add(1) } else { 0 };
        if is_quiet {
            steps = steps.saturating_add(1);
            continue;
        }
        write(body, state, &limits, steps, length);
        let linear = &body.follower.linear;
        let turn = if body.is_followed([first, second]) {
            None
        } else {
            turning.alone(linear, &quiet, state, &limits, [first, second], &step)
        };
        let is_taken = match turn {
            Some(turn) => body.turn(&turn, [first, second], start, &step, whole.as_ref()),
            None => body.take([first, second], start, &step, whole.as_ref()),
        };
        if !is_taken {
            return;
        }
        state = [body.follower.x, body.follower.v];
        if let Some([push, sign]) = Quiet::turned(quiet.sign, body) {
            (quiet.push, quiet.sign) = (push, sign);
        } else {
            quiet = Quiet::of(body, whole.as_ref(), &step);
        }
        turning.update(body);
        limits = Limits::of(body);
        steps = 0;
    }
    write(body, state, &limits, steps, length);
}

/// Returns the state after so many quiet steps to its body.
#[inline(always)]
fn write<F: Float>(body: &mut Followed<F>, state: [F; 2], limits: &Limits<F>, steps: usize, length: F) {
    body.set_state(state);
    limits.write(body);
    body.rested(steps, length);
}

/// Takes a step if nothing happens in it; whether it did, and whether the ranges stay.
#[inline(always)]
fn pass_one<F: Float>(
    body: &mut Followed<F>,
    state: &mut [F; 2],
    quiet: &Quiet<F>,
    limits: &mut Limits<F>,
    [first, second]: [F; 2],
    end_time: F,
    step: &Step<F>,
) -> (bool, bool) {
    let load = quiet.load([first, second], (second - first) * step.inverse);
    let push = quiet.push(&load);
    let end = quiet.after(*state, &push);
    if quiet.sign * end[1] < F::int(0) {
        return (false, false);
    }
    let moved = quiet.moved(*state, &push);
    let passed = quiet.passed([*state, end], &load, moved, limits, Some(end_time));
    if passed.is_quiet {
        (*state, *limits) = (end, passed.limits);
        body.totals.load_work = body.totals.load_work + passed.work;
        body.totals.foot_work = body.totals.foot_work + load.foot * moved;
    }
    (passed.is_quiet, passed.is_within)
}

/// Takes the steps of a block up to the first in which something may happen or a range grow; the number of steps taken.
///
/// The states of the whole block come first, one after another; what they wait for and all else is done for all steps of the
/// block at once.
#[inline(always)]
fn pass_block<F: Float>(
    body: &mut Followed<F>,
    state: &mut [F; 2],
    quiet: &Quiet<F>,
    limits: &Limits<F>,
    samples: &[F; BLOCK + 1],
    step: &Step<F>,
) -> usize {
    let zero = F::int(0);
    let row = [zero; BLOCK];
    let (mut push_x, mut push_v) = (row, row);
    let load_of = |i: usize| {
        let (first, second) = (at(samples, i), at(samples, i.saturating_add(1)));
        quiet.load([first, second], (second - first) * step.inverse)
    };
    for i in 0..BLOCK {
        let push = quiet.push(&load_of(i));
        set(&mut push_x, i, push.x);
        set(&mut push_v, i, push.v);
    }
    // Each state stands in two rows, as an end and as a start: a loop over one row with two places is not taken in lanes.
    let (mut x, mut v, mut end_x, mut end_v) = (row, row, row, row);
    let mut now = *state;
    for i in 0..BLOCK {
        set(&mut x, i, now[0]);
        set(&mut v, i, now[1]);
        now = quiet.after(now, &Push { x: at(&push_x, i), v: at(&push_v, i) });
        set(&mut end_x, i, now[0]);
        set(&mut end_v, i, now[1]);
    }
    let (mut event, mut load_work, mut foot_work) = (row, row, row);
    for i in 0..BLOCK {
        let load = load_of(i);
        let (start, end) = ([at(&x, i), at(&v, i)], [at(&end_x, i), at(&end_v, i)]);
        let moved = quiet.moved(start, &Push { x: at(&push_x, i), v: at(&push_v, i) });
        let Passed { is_quiet, work, .. } = quiet.passed([start, end], &load, moved, limits, None);
        set(&mut event, i, select(is_quiet, zero, F::int(1)));
        set(&mut load_work, i, work);
        set(&mut foot_work, i, load.foot * moved);
    }
    let is_whole = !event.iter().fold(false, |any, event| any | (*event != zero));
    let taken = if is_whole { BLOCK } else { event.iter().take_while(|event| **event == zero).count() };
    for i in 0..taken {
        body.totals.load_work = body.totals.load_work + at(&load_work, i);
        body.totals.foot_work = body.totals.foot_work + at(&foot_work, i);
    }
    *state = if is_whole { now } else { [at(&x, taken), at(&v, taken)] };
    taken
}
