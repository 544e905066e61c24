//! Steps in which slides end and begin, of a body alone and of bodies side by side.
//!
//! In such a step a body slides to its stop, rests, and slides to the end of the step; any of the three may be missing.
//! The formulae and decisions are those of the [`Follower`](super::follow::Follower), without branches where loops take
//! them in vector lanes. The follower itself takes the steps with more: extremes that a bound leaves open, a speed with a
//! minimum that may be a stop, a second stop, and signs that are NaN.

use super::follow::{Failure, Mode, Stretch};
use super::linear::{Law, Linear, Responses};
use super::load::Piece;
use super::number::{Number as _, first_guess};
use super::quiet::{Followed, Limits, Load, Quiet, Step, greater, infinity, lesser};
use super::rows::select;
use super::slide::{Moment, Slide};
use crate::float::{Float, Signed as _};
use crate::root::Halley;

#[cfg(feature = "batch")]
mod lanes;

#[cfg(feature = "batch")]
pub(super) use lanes::Turns;

/// The numbers of a body that its turns need, from its last event on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turning<F> {
    mean: F,
    friction: F,
    /// The static friction, against either direction.
    held: F,
    backward: F,
    excess: F,
    /// The responses after the step, and 1 where they are known and the series serves all times up to it.
    impulse: F,
    step: F,
    ramp: F,
    parabola: F,
    is_known: F,
    widest: F,
    /// The greatest speed in either direction, and the ranges of a and of a less the load.
    forward_speed: F,
    backward_speed: F,
    most_a: F,
    least_a: F,
    most_free: F,
    least_free: F,
}

impl<F: Float> Turning<F> {
    fn none() -> Self {
        let zero = F::int(0);
        Self {
            mean: zero,
            friction: zero,
            held: zero,
            backward: zero,
            excess: zero,
            impulse: zero,
            step: zero,
            ramp: zero,
            parabola: zero,
            is_known: zero,
            widest: zero,
            forward_speed: zero,
            backward_speed: zero,
            most_a: zero,
            least_a: zero,
            most_free: zero,
            least_free: zero,
        }
    }

    #[inline(always)]
    fn responses(&self) -> Responses<F> {
        let &Self { impulse, step, ramp, parabola, .. } = self;
        Responses { impulse, step, ramp, parabola }
    }

    /// Those of a body, given the responses after a step of this length.
    pub(super) fn of(body: &Followed<F>, whole: Option<&Responses<F>>, step: &Step<F>) -> Self {
        let c = &body.follower.constants;
        let mut one = Self {
            mean: c.mean,
            friction: c.friction,
            held: c.held,
            backward: if c.is_one_way { infinity() } else { c.held },
            excess: c.excess,
            ..Self::none()
        };
        // Types that no processor has are faster step by step.
        let serves = F::PRECISION <= f64::MANTISSA_DIGITS && body.follower.linear.is_near(step.length);
        if let (Some(whole), true) = (whole, serves) {
            one.is_known = F::int(1);
            Responses { impulse: one.impulse, step: one.step, ramp: one.ramp, parabola: one.parabola } =
                *whole;
        }
        one.update(body);
        one
    }

    /// The numbers that events change.
    pub(super) fn update(&mut self, body: &Followed<F>) {
        let (totals, nan) = (&body.totals, F::int(0) / F::int(0));
        let velocity = &totals.velocity;
        // As for the limits of a quiet step, the range of the velocity is one of slides once it has 0.
        let [forward, backward] =
            if velocity.has(F::int(0)) { [velocity.most.value, -velocity.least.value] } else { [nan; 2] };
        (self.forward_speed, self.backward_speed) = (forward, backward);
        (self.most_a, self.least_a) = (totals.acceleration.most.value, totals.acceleration.least.value);
        (self.most_free, self.least_free) =
            (totals.free_acceleration.most.value, totals.free_acceleration.least.value);
        self.widest = body.follower.widest;
    }
}

/// A step with a stop, a release, or both.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn<F> {
    /// 1 where the step is such a one.
    is_taken: F,
    /// The time of the stop, and 1 where there is one; the step's length where there is none, and 0 for a body at rest.
    stop: F,
    stops: F,
    /// The way to there, and its integral.
    moved: F,
    area: F,
    /// The length of the rest, the direction of the slide after it, which is 0 where there is none, and its
    /// acceleration.
    wait: F,
    sign: F,
    a: F,
    /// The length of that slide, the way of it and its integral.
    length: F,
    way: F,
    way_area: F,
    /// The velocity at the end of the step.
    v: F,
    /// The acceleration at the start of the step, and 1 where a bound leaves extremes of the first slide open, and of the
    /// second.
    start: F,
    is_open: F,
    is_way_open: F,
    /// 1 where the second slide may stop within the step, so that the follower takes it.
    is_left: F,
}

impl<F: Float> Turn<F> {
    fn none() -> Self {
        let zero = F::int(0);
        Self {
            is_taken: zero,
            stop: zero,
            stops: zero,
            moved: zero,
            area: zero,
            wait: zero,
            sign: zero,
            a: zero,
            length: zero,
            way: zero,
            way_area: zero,
            v: zero,
            start: zero,
            is_open: zero,
            is_way_open: zero,
            is_left: zero,
        }
    }
}

/// The most steps of a search for a stop.
const SEARCH: usize = 16;

impl<F: Float> Turning<F> {
    /// The greatest speed in a direction.
    #[inline(always)]
    fn speed(&self, sign: F) -> F {
        select(sign > F::int(0), self.forward_speed, self.backward_speed)
    }

    /// The ranges without the speed.
    #[inline(always)]
    fn ranges(&self) -> Limits<F> {
        let &Self { most_a, least_a, most_free, least_free, .. } = self;
        Limits { most_a, least_a, most_free, least_free, ..Limits::none() }
    }

    /// The slide with which a step begins.
    #[inline(always)]
    fn opening(&self, quiet: &Quiet<F>, [x, v]: [F; 2], load: &Load<F>, length: F) -> Opening<F> {
        let (zero, sign, law) = (F::int(0), quiet.sign, quiet.law());
        let a = load.from + self.mean - sign * self.friction - quiet.rate * v - quiet.square * x;
        let slide = Slide { v, a: select(sign == zero, zero, a), slope: load.slope, sign };
        let end = slide.moment(&law, &self.responses());
        let (speed, end_speed) = (sign * v, sign * end.v);
        let is_slide = sign != zero;
        let has_stop = is_slide & (end_speed <= zero);
        // A speed that has a minimum has it not below the smaller end by more than t max |a|.
        let has_minimum = (sign * slide.a < zero) & (sign * end.a > zero);
        let lost = length * slide.greatest_acceleration(&law, quiet.omega, length);
        let is_clear = !has_minimum | ((speed - lost > zero) & (end_speed - lost > zero));
        let is_plain = !is_slide | (has_stop & (speed > zero)) | ((end_speed > zero) & is_clear);
        Opening { slide, end, has_stop, is_plain: is_plain & (self.is_known != zero) }
    }

    /// The rest at x under a load that changes from one value to another within a time.
    #[inline(always)]
    fn rest(&self, law: &Law<F>, x: F, [load, end]: [F; 2], slope: F, left: F) -> Rest<F> {
        let (zero, one) = (F::int(0), F::int(1));
        let offset = self.mean - law.square * x;
        let (now, later) = (load + offset, end + offset);
        let size = greater(load.abs(), end.abs())
            + self.mean.abs()
            + law.square * greater(self.widest, x.abs())
            + self.held;
        let exceeds = |force: F, held: F| (force - held > zero) & !(force - held).is_lost(size);
        let [is_forward, is_backward] = [exceeds(now, self.held), exceeds(-now, self.backward)];
        let [is_late_forward, is_late_backward] = [exceeds(later, self.held), exceeds(-later, self.backward)];
        let is_now = is_forward | is_backward;
        let sign = select(is_forward, one, select(is_backward, -one, select(is_late_forward, one, -one)));
        let is_released = is_now | is_late_forward | is_late_backward;
        let after = (self.held - sign * now) / (sign * slope);
        let after = select(left - after < zero, left, after.or_larger(zero));
        let wait = select(is_now, zero, after);
        let a = select(is_now, now - sign * self.friction, sign * self.excess);
        Rest { is_released, wait: select(is_released, wait, left), sign, a }
    }

    /// A turn with the slide to the end of the step, given the responses after its length.
    #[inline(always)]
    fn closing(&self, quiet: &Quiet<F>, load: &Load<F>, responses: &Responses<F>, turn: &Turn<F>) -> Turn<F> {
        let (zero, law) = (F::int(0), quiet.law());
        let slide = Slide { v: zero, a: turn.a, slope: load.slope, sign: turn.sign };
        let end = slide.moment(&law, responses);
        let from = turn.stop + turn.wait;
        // The ranges that grew since the last event are greater, so that these serve as well.
        let ranges = Limits { most_speed: self.speed(turn.sign), ..self.ranges() };
        let loads = [load.from + load.slope * from, load.from + load.slope * (from + turn.length)];
        let is_inside = is_inside(&slide, &law, quiet.omega, &end, loads, turn.length, &ranges);
        let is_plain =
            (turn.sign * end.v > zero) & !((turn.sign * turn.a < zero) & (turn.sign * end.a > zero));
        let is_released = turn.sign != zero;
        // A slide that begins with a = 0 has no stop but by rounding.
        let is_left = is_released & !is_plain & (turn.sign * turn.a > zero);
        let is_taken = (turn.is_taken != zero) & (!is_released | is_plain | is_left);
        Turn {
            is_taken: select(is_taken, F::int(1), zero),
            is_left: select(is_left, F::int(1), zero),
            way: end.moved,
            way_area: slide.area(&law, responses),
            v: select(is_released, end.v, turn.v),
            is_way_open: select(is_inside | !is_released, zero, F::int(1)),
            ..*turn
        }
    }

    /// The turn of a body alone in a step; `None` where it is not one.
    #[inline(always)]
    pub(super) fn alone(
        &self,
        linear: &Linear<F>,
        quiet: &Quiet<F>,
        [x, v]: [F; 2],
        limits: &Limits<F>,
        samples: [F; 2],
        step: &Step<F>,
    ) -> Option<Turn<F>> {
        let (zero, one, length, law) = (F::int(0), F::int(1), step.length, quiet.law());
        if self.is_known == zero {
            return None;
        }
        let load = quiet.load(samples, (samples[1] - samples[0]) * step.inverse);
        let mut turn = Turn { is_taken: one, ..Turn::none() };
        let mut last = load.from;
        if quiet.sign != zero {
            let opening = self.opening(quiet, [x, v], &load, length);
            let Opening { slide, mut end, .. } = opening;
            let stop = if opening.is_plain & opening.has_stop {
                Some(opening.stop(linear, length)?)
            } else if opening.is_plain {
                None
            } else {
                slide.stop(linear, quiet.omega, length, &end)?
            };
            let responses;
            (end, responses, turn.stop) = match stop {
                Some(stop) => {
                    turn.stops = one;
                    let responses = linear.near(stop);
                    (Moment { v: zero, ..slide.moment(&law, &responses) }, responses, stop)
                }
                None => (end, self.responses(), length),
            };
            last = load.from + load.slope * turn.stop;
            let is_inside = is_inside(&slide, &law, quiet.omega, &end, [load.from, last], turn.stop, limits);
            (turn.start, turn.is_open) = (slide.a, select(is_inside, zero, one));
            (turn.moved, turn.area, turn.v) = (end.moved, slide.area(&law, &responses), end.v);
            if stop.is_none() {
                return Some(turn);
            }
        }
        let left = length - turn.stop;
        if left.positive() != Some(true) {
            return None;
        }
        let rest = self.rest(&law, x + turn.moved, [last, load.to], load.slope, left);
        turn.wait = rest.wait;
        if !rest.is_released {
            return Some(turn);
        }
        (turn.sign, turn.a, turn.length) = (rest.sign, rest.a, length - (turn.stop + rest.wait));
        if turn.length.positive() != Some(true) {
            return None;
        }
        let turn = self.closing(quiet, &load, &linear.near(turn.length), &turn);
        (turn.is_taken != zero).then_some(turn)
    }
}

/// The slide with which a step begins, its end if it does not stop, whether it stops, and whether it is one that a turn
/// may begin with.
#[derive(Debug, Clone, Copy)]
struct Opening<F> {
    slide: Slide<F>,
    end: Moment<F>,
    has_stop: bool,
    is_plain: bool,
}

impl<F: Float> Opening<F> {
    /// The stop of a slide that has one, for a body alone.
    #[inline(always)]
    fn stop(&self, linear: &Linear<F>, length: F) -> Option<F> {
        let speed = |t: F| self.slide.speed(&linear.law, &linear.near(t));
        let (mut search, mut is_found) = (self.search(length), false);
        for _ in 0..SEARCH {
            (search, is_found) = search.step(speed(search.x), None);
            if is_found {
                break;
            }
        }
        let of = |t: F| {
            let [speed, a, ..] = speed(t);
            (speed, a)
        };
        is_found.then(|| search.x.implicit_root(of))
    }

    /// The search for the stop.
    #[inline(always)]
    fn search(&self, length: F) -> Halley<F> {
        let (zero, sign) = (F::int(0), self.slide.sign);
        let ends = [[self.slide.v, self.slide.a], [self.end.v, self.end.a]];
        Halley::new(first_guess([zero, length], ends.map(|end| end.map(|d| sign * d))), zero, length)
    }
}

/// A rest, its length, and the direction and the acceleration of the slide after it.
#[derive(Debug, Clone, Copy)]
struct Rest<F> {
    is_released: bool,
    wait: F,
    sign: F,
    a: F,
}

/// Whether a slide for a length, to this end, stays inside the ranges, by the bound of its extremes.
#[inline(always)]
fn is_inside<F: Float>(
    slide: &Slide<F>,
    law: &Law<F>,
    omega: F,
    end: &Moment<F>,
    [first, last]: [F; 2],
    length: F,
    ranges: &Limits<F>,
) -> bool {
    let [of_v, of_a] = slide.beyond(law, omega, length);
    let is_v = greater(slide.sign * slide.v, slide.sign * end.v) + of_v <= ranges.most_speed;
    let is_within = |start: F, end: F, most: F, least: F| {
        (greater(start, end) + of_a <= most) & (lesser(start, end) - of_a >= least)
    };
    is_v & is_within(slide.a, end.a, ranges.most_a, ranges.least_a)
        & is_within(slide.a - first, end.a - last, ranges.most_free, ranges.least_free)
}

impl<F: Float> Followed<F> {
    /// Takes a step with a turn; whether it could be taken.
    #[inline(always)]
    pub(super) fn turn(
        &mut self,
        turn: &Turn<F>,
        samples: [F; 2],
        time: F,
        step: &Step<F>,
        whole: Option<&Responses<F>>,
    ) -> bool {
        let piece = Piece::new(&self.factors, samples, step.length, step.inverse);
        let taken = self.turn_in(turn, &piece, time, whole);
        self.keep(taken, time)
    }

    #[inline(always)]
    fn turn_in(
        &mut self,
        turn: &Turn<F>,
        piece: &Piece<F>,
        time: F,
        whole: Option<&Responses<F>>,
    ) -> Result<(), Failure> {
        let zero = F::int(0);
        if let Mode::Slide(sign) = self.follower.mode {
            let slide = Slide { v: self.follower.v, a: turn.start, slope: piece.slope, sign };
            let way = Way { from: zero, length: turn.stop, moved: turn.moved, area: turn.area };
            self.slides(piece, time, &slide, &way, [turn.is_open, select(turn.stops == zero, turn.v, zero)])
                .ok_or(Failure::Uncertain)?;
            if turn.stops == zero {
                return Ok(());
            }
            self.follower.end(time + turn.stop, sign, &mut self.totals).ok_or(Failure::Uncertain)?;
        }
        if turn.wait > zero {
            self.follower
                .rested(piece, time, turn.stop, turn.wait, &mut self.totals)
                .ok_or(Failure::Uncertain)?;
        }
        if turn.sign != zero {
            let from = turn.stop + turn.wait;
            self.follower
                .begin([turn.sign, turn.a], time + from, piece.from, &mut self.totals)
                .ok_or(Failure::Uncertain)?;
            if turn.is_left != zero {
                return self.follower.step_from(piece, [time, from], whole, &mut self.totals);
            }
            let slide = Slide { v: zero, a: turn.a, slope: piece.slope, sign: turn.sign };
            let way = Way { from, length: turn.length, moved: turn.way, area: turn.way_area };
            self.slides(piece, time, &slide, &way, [turn.is_way_open, turn.v]).ok_or(Failure::Uncertain)?;
        }
        Ok(())
    }

    /// Adds a slide, to a velocity at its end.
    #[inline(always)]
    fn slides(
        &mut self,
        piece: &Piece<F>,
        time: F,
        slide: &Slide<F>,
        way: &Way<F>,
        [is_open, v]: [F; 2],
    ) -> Option<()> {
        let last = piece.from + piece.slope * (way.from + way.length);
        self.totals.works([last, piece.slope, piece.foot], way.moved, way.area);
        if is_open != F::int(0) {
            self.include_extremes(piece, time, slide, way, v)?;
        }
        (self.follower.x, self.follower.v) = (self.follower.x + way.moved, v);
        Some(())
    }

    /// Includes the extremes of a slide.
    #[inline(never)]
    fn include_extremes(
        &mut self,
        piece: &Piece<F>,
        time: F,
        slide: &Slide<F>,
        way: &Way<F>,
        v: F,
    ) -> Option<()> {
        let linear = &self.follower.linear;
        let responses = linear.near(way.length);
        let end = Moment { v, ..slide.moment(&linear.law, &responses) };
        let load = |t: F| piece.from + piece.slope * t;
        let stretch = Stretch {
            time: time + way.from,
            x: self.follower.x,
            length: way.length,
            load: [load(way.from), load(way.from + way.length)],
            responses: &responses,
            end: &end,
            foot: piece.foot,
            is_short: true,
        };
        self.totals.extremes(linear, slide, &stretch)
    }
}

/// A slide within a step: when it begins, its length, its way and the integral of that.
#[derive(Debug, Clone, Copy)]
struct Way<F> {
    from: F,
    length: F,
    moved: F,
    area: F,
}

#[cfg(test)]
mod tests;
