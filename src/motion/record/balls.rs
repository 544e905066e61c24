//! The motion under a record in balls: every answer with a bound of its error, and every decision certain.
//!
//! The text is that of the floats. A sign that the balls leave open ends the motion with [`Failure::Uncertain`]; more
//! bits decide it, unless the body is exactly on a bound. A zero is enclosed by two times at which the function has
//! certain signs.

use super::answers::{End, RecordAnswer, Weights, begun};
use super::body::{Body, Constants};
use super::follow::Failure;
use super::load::{Factors, Piece, Record};
use super::number::Number;
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Float};
use crate::machine::error::{Error, written};
use crate::machine::excitation::Excitation;

impl<const W: usize> Number for Ball<W> {
    const MOST_TERMS: i32 = <Mp<W> as Number>::MOST_TERMS;

    fn is_within(self, reach: Self) -> Option<bool> {
        (!self.is_entire()).then(|| self.upper() <= reach.upper())
    }

    fn widened(self, error: Self) -> Self {
        let most = error.abs().upper();
        Self::new(self.mid(), self.rad().plus(Radius::above(most)))
    }

    fn is_negligible(term: Self) -> bool {
        <Mp<W> as Number>::is_negligible(term.abs().upper())
    }

    fn is_lost(self, _: Self) -> bool {
        false
    }

    fn is_same(self, other: Self) -> bool {
        // Both are the load of one sample, or one of them is exactly 0.
        self.mid() == other.mid()
    }

    /// The zero of floats at the midpoints, and certain signs at both sides of it.
    fn zero_within(
        [low, high]: [Self; 2],
        longest: Option<Self>,
        ends: [[Self; 2]; 2],
        f: impl Fn(Self) -> Option<[Self; 4]>,
    ) -> Option<Self> {
        let at = |t: Mp<W>| f(Self::exact(t));
        let (left, right) = (low.mid(), high.mid());
        let t = Mp::zero_within(
            [left, right],
            longest.map(|longest| longest.mid()),
            ends.map(|end| end.map(|ball| ball.mid())),
            |t| {
                let [value, slopes @ ..] = at(t)?;
                // Within the uncertainty of f steps may go to and fro.
                let value = if value.contains_zero() { Mp::ZERO } else { value.mid() };
                let [first, second, third] = slopes.map(|slope| slope.mid());
                Some([value, first, second, third])
            },
        )?;
        // One more step, to the middle of the uncertainty.
        let [value, slope, ..] = at(t)?;
        let next = t - value.mid() / slope.mid();
        let t = if next > left && next < right { next } else { t };
        let reach = (value.rad().value() / slope.mid()).abs() + t.abs() * Mp::epsilon();
        let mut reach = reach.scale2(2);
        for _ in 0..Self::MOST_TERMS {
            // Beyond an end the sign is that of the end, which the caller knows.
            let (before, after) = (t - reach, t + reach);
            let from = if before <= low.upper() {
                Some(low.lower())
            } else {
                (at(before)?[0].is_positive()).then_some(before)
            };
            let to = if after >= high.lower() {
                Some(high.upper())
            } else {
                (at(after)?[0].is_negative()).then_some(after)
            };
            if let (Some(from), Some(to)) = (from, to) {
                return Some(Self::between(from, to));
            }
            reach = reach.scale2(1);
        }
        None
    }

    fn count(n: usize) -> Self {
        Self::exact(<Mp<W> as Number>::count(n))
    }

    fn whole(self) -> Option<i32> {
        <Mp<W> as Number>::whole(self.upper())
    }
}

/// A number of the input as a ball.
fn known<const N: usize, const W: usize>(x: Mp<N>) -> Ball<W> {
    Ball::read(x, Radius::above(x))
}

/// What a record does after a sample.
#[derive(Debug)]
enum Change<B> {
    /// The load per mass to the next sample.
    Piece(Piece<B>),
    /// Two samples at one time.
    Jump([B; 2]),
}

impl<B> Change<B> {
    fn piece(self) -> Option<Piece<B>> {
        match self {
            Self::Piece(piece) => Some(piece),
            Self::Jump(_) => None,
        }
    }
}

/// The changes of a record, each with its time.
fn changes<const N: usize, const W: usize>(
    record: &Record<Mp<N>>,
    factors: Factors<Ball<W>>,
) -> impl Iterator<Item = (Ball<W>, Change<Ball<W>>)> + '_ {
    let samples = record.samples();
    let step = record.step().map(known::<N, W>);
    let time = move |index: usize| match step {
        Some(step) => known(record.time(0)) + Ball::count(index) * step,
        None => known(record.time(index)),
    };
    samples.iter().zip(samples.iter().skip(1)).enumerate().map(move |(index, (&first, &second))| {
        let start = time(index);
        if step.is_none() && record.time(index) == record.time(index.saturating_add(1)) {
            // Equal samples are one number here, too.
            let samples = if first == second { [Ball::int(0); 2] } else { [known(first), known(second)] };
            return (start, Change::Jump(samples));
        }
        let length = step.unwrap_or_else(|| time(index.saturating_add(1)) - start);
        let from = known(first);
        // Equal samples are one number, so that the load between them has no slope.
        let is_flat = first == second;
        let to = if is_flat { from } else { known(second) };
        let mut piece = Piece::new(&factors, [from, to], length, Ball::int(1) / length);
        if is_flat {
            piece = Piece {
                from: from * factors.factor,
                to: from * factors.factor,
                slope: Ball::int(0),
                ..piece
            };
        }
        (start, Change::Piece(piece))
    })
}

/// The motion of a body under a record from x and v, at one precision of the balls.
pub(crate) fn follow<const N: usize, const W: usize>(
    body: &Body<Mp<N>>,
    record: &Record<Mp<N>>,
    [x, v]: [Mp<N>; 2],
) -> Result<RecordAnswer<Ball<W>>, Error> {
    let failed = |(failure, time): (Failure, Mp<N>)| {
        if failure == Failure::Uncertain {
            Error::UncertainEvent { time: written(time) }
        } else {
            super::answers::failed((failure, time))
        }
    };
    let (constants, weights) = (Constants::of(body, known::<N, W>), Weights::of(body, known::<N, W>));
    let uncertain = |time: Mp<N>| failed((Failure::Uncertain, time));
    let (begin, start) = (record.time(0), [x, v].map(known::<N, W>));
    let excitation = record.excitation();
    let factors = Factors::new(excitation, weights.mass, &constants);
    let mut pieces =
        changes::<N, W>(record, factors).filter_map(|(time, change)| Some((time, change.piece()?)));
    let begun = pieces
        .next()
        .and_then(|(time, first)| begun(constants, start, known(record.longest_step()), time, &first));
    let (mut follower, mut totals) = begun.ok_or_else(|| uncertain(begin))?;
    for (index, (time, change)) in changes::<N, W>(record, factors).enumerate() {
        let taken = match change {
            Change::Piece(piece) => follower.step(&piece, time, None, &mut totals),
            Change::Jump(samples) => {
                follower.jump(&factors, samples, time, &mut totals).ok_or(Failure::Uncertain)
            }
        };
        taken.map_err(|failure| failed((failure, record.time(index))))?;
    }
    let end = record.end();
    let (x, v) = (follower.x, follower.v);
    let ended = match record.step() {
        Some(step) => known(begin) + Ball::count(record.samples().len().saturating_sub(1)) * known(step),
        None => known(end),
    };
    let (what, last) = ((record.after(), excitation), known(record.last()));
    let (rest, is_free) = follower
        .ended(what, &factors, [ended, last], &mut totals)
        .map_err(|failure| failed((failure, end)))?;
    let foot = if excitation == Excitation::DampedFootMotion && weights.has_damper {
        let pieces = changes::<N, W>(record, factors).filter_map(|(_, change)| change.piece());
        pieces.fold(Ball::int(0), |sum, piece| sum + piece.work_at_rest(&constants))
    } else {
        Ball::int(0)
    };
    let answer = weights.answer(excitation, start, End { x, v, rest, is_free, foot }, &totals);
    answer.ok_or_else(|| uncertain(end))
}
