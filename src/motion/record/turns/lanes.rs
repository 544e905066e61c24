//! Turns in vector lanes.

use super::{SEARCH, Turn, Turning, is_inside};
use crate::float::Float;
use crate::motion::record::linear::{Law, Responses};
use crate::motion::record::quiet::{Followed, Step};
use crate::motion::record::rows::{LimitsRows, QuietRows, Row, at, rows, select, set};
use crate::motion::record::slide::{Moment, Slide};
use crate::root::Halley;
use alloc::vec::Vec;

rows! {
    TurningRows of Turning:
    mean, friction, held, backward, excess, impulse, step, ramp, parabola, is_known, widest, forward_speed,
    backward_speed, most_a, least_a, most_free, least_free,
}

rows! {
    TurnRows of Turn:
    is_taken, stop, stops, moved, area, wait, sign, a, length, way, way_area, v, start,
    is_open, is_way_open, is_left,
}

rows! {
    HalleyRows of Halley:
    x, low, high, last, last_but_one,
}

rows! {
    ResponsesRows of Responses:
    impulse, step, ramp, parabola,
}

/// The turns of bodies side by side.
#[derive(Debug)]
pub(in crate::motion::record) struct Turns<F, const L: usize> {
    turning: TurningRows<F, L>,
    /// The coefficients of the series of all lanes; those of a shorter series begin with zeros.
    series: Vec<[[Row<F, L>; 2]; 2]>,
    turn: TurnRows<F, L>,
}

fn is_any<F: Float, const L: usize>(row: &Row<F, L>) -> bool {
    row.iter().fold(false, |any, number| any | (*number != F::int(0)))
}

impl<F: Float, const L: usize> Turns<F, L> {
    pub(in crate::motion::record) fn new() -> Self {
        Self { turning: TurningRows::none(), series: Vec::new(), turn: TurnRows::none() }
    }

    /// Takes a body into its lane, given the responses after a step of this length.
    pub(in crate::motion::record) fn read(
        &mut self,
        lane: usize,
        body: &Followed<F>,
        whole: Option<&Responses<F>>,
        step: &Step<F>,
    ) {
        self.turning.set(lane, &Turning::of(body, whole, step));
        let terms = body.follower.linear.series();
        while self.series.len() < terms.len() {
            self.series.insert(0, [[[F::int(0); L]; 2]; 2]);
        }
        let missing = self.series.len().saturating_sub(terms.len());
        let none = [[F::int(0); 2]; 2];
        for (rows, terms) in self.series.iter_mut().zip(core::iter::repeat_n(&none, missing).chain(terms)) {
            for (row, term) in rows.iter_mut().flatten().zip(terms.iter().flatten()) {
                set(row, lane, *term);
            }
        }
    }

    /// Takes a body into its lane after an event.
    pub(in crate::motion::record) fn update(&mut self, lane: usize, body: &Followed<F>) {
        let mut one = self.turning.at(lane);
        one.update(body);
        self.turning.set(lane, &one);
    }

    /// The numbers of a lane.
    #[inline(always)]
    pub(in crate::motion::record) fn of(&self, lane: usize) -> Turning<F> {
        self.turning.at(lane)
    }

    /// The turn of a lane in the step that was taken, if it was one.
    pub(in crate::motion::record) fn turn(&self, lane: usize) -> Option<Turn<F>> {
        let turn = self.turn.at(lane);
        (turn.is_taken != F::int(0)).then_some(turn)
    }

    /// The responses of all lanes at times that the series serves.
    #[inline(always)]
    fn responses(&self, quiet: &QuietRows<F, L>, times: &Row<F, L>) -> ResponsesRows<F, L> {
        let zero = [F::int(0); L];
        let mut squares = zero;
        for i in 0..L {
            set(&mut squares, i, at(times, i).square());
        }
        let (mut third, mut fourth, mut odd_third, mut odd_fourth) = (zero, zero, zero, zero);
        let next = |sum: &mut Row<F, L>, terms: &Row<F, L>| {
            for i in 0..L {
                let now = at(sum, i) * at(&squares, i) + at(terms, i);
                set(sum, i, now);
            }
        };
        for [even, odd] in &self.series {
            next(&mut third, &even[0]);
            next(&mut fourth, &even[1]);
            next(&mut odd_third, &odd[0]);
            next(&mut odd_fourth, &odd[1]);
        }
        let mut responses = ResponsesRows::none();
        for i in 0..L {
            let law = Law { rate: at(&quiet.rate, i), square: at(&quiet.square, i) };
            let sums = [[at(&third, i), at(&fourth, i)], [at(&odd_third, i), at(&odd_fourth, i)]];
            responses.set(i, &law.responses(at(times, i), sums));
        }
        responses
    }

    /// Takes the step between two samples in the lanes whose `event` is not 0.
    #[inline(always)]
    pub(in crate::motion::record) fn take(
        &mut self,
        quiet: &QuietRows<F, L>,
        [x, v]: [&Row<F, L>; 2],
        limits: &LimitsRows<F, L>,
        event: &Row<F, L>,
        [first, second]: [F; 2],
        step: &Step<F>,
    ) {
        let (zero, one, length) = (F::int(0), F::int(1), step.length);
        let change = (second - first) * step.inverse;
        let none = [zero; L];
        let (mut start_a, mut searched, mut may, mut stops) = (none, none, none, none);
        let mut search = HalleyRows::none();
        for i in 0..L {
            let (quiet, body) = (quiet.at(i), self.turning.at(i));
            let load = quiet.load([first, second], change);
            let opening = body.opening(&quiet, [at(x, i), at(v, i)], &load, length);
            let is_taken = (at(event, i) != zero) & opening.is_plain;
            search.set(i, &opening.search(length));
            set(&mut start_a, i, opening.slide.a);
            set(&mut stops, i, select(opening.has_stop, one, zero));
            set(&mut may, i, select(is_taken, one, zero));
            set(&mut searched, i, select(is_taken & opening.has_stop, one, zero));
        }
        for _ in 0..SEARCH {
            if !is_any(&searched) {
                break;
            }
            let responses = self.responses(quiet, &search.x);
            for i in 0..L {
                let quiet = quiet.at(i);
                let law = Law { rate: quiet.rate, square: quiet.square };
                let slope = change * quiet.factor;
                let slide = Slide { v: at(v, i), a: at(&start_a, i), slope, sign: quiet.sign };
                let before = search.at(i);
                let (next, is_found) = before.step(slide.speed(&law, &responses.at(i)), None);
                let is_on = at(&searched, i) != zero;
                search.set(
                    i,
                    &Halley {
                        x: select(is_on, next.x, before.x),
                        low: select(is_on, next.low, before.low),
                        high: select(is_on, next.high, before.high),
                        last: select(is_on, next.last, before.last),
                        last_but_one: select(is_on, next.last_but_one, before.last_but_one),
                    },
                );
                set(&mut searched, i, select(is_on & !is_found, one, zero));
            }
        }
        // The slide at the start of the step, to its stop or to the end of the step; none at rest.
        for i in 0..L {
            let found = at(&search.x, i).implicit_root(|t| {
                let law = Law { rate: at(&quiet.rate, i), square: at(&quiet.square, i) };
                let slope = change * at(&quiet.factor, i);
                let slide = Slide { v: at(v, i), a: at(&start_a, i), slope, sign: at(&quiet.sign, i) };
                let [speed, a, ..] = slide.speed(&law, &self.responses(quiet, &[t; L]).at(i));
                (speed, a)
            });
            let other = select(at(&quiet.sign, i) == zero, zero, length);
            set(&mut search.x, i, select(at(&stops, i) != zero, found, other));
        }
        let to_stop = self.responses(quiet, &search.x);
        let mut lengths = none;
        for i in 0..L {
            let (quiet, body) = (quiet.at(i), self.turning.at(i));
            let law = Law { rate: quiet.rate, square: quiet.square };
            let (load, sign) = (quiet.load([first, second], change), quiet.sign);
            let (is_slide, has_stop) = (sign != zero, at(&stops, i) != zero);
            let slide = Slide { v: at(v, i), a: at(&start_a, i), slope: load.slope, sign };
            let (responses, stop) = (to_stop.at(i), at(&search.x, i));
            let end = slide.moment(&law, &responses);
            let end = Moment { v: select(has_stop, zero, end.v), ..end };
            let last = load.from + load.slope * stop;
            let is_inside =
                is_inside(&slide, &law, quiet.omega, &end, [load.from, last], stop, &limits.at(i));
            let rest = body.rest(&law, at(x, i) + end.moved, [last, load.to], load.slope, length - stop);
            let is_resting = has_stop | !is_slide;
            let is_released = is_resting & rest.is_released;
            let left = length - (stop + rest.wait);
            let is_taken = (at(&may, i) != zero)
                & (at(&searched, i) == zero)
                & (!is_resting | (length - stop > zero))
                & (!is_released | (left > zero));
            set(&mut lengths, i, select(is_released, left, zero));
            self.turn.set(
                i,
                &Turn {
                    is_taken: select(is_taken, one, zero),
                    stop,
                    stops: at(&stops, i),
                    moved: end.moved,
                    area: slide.area(&law, &responses),
                    wait: rest.wait,
                    sign: select(is_released, rest.sign, zero),
                    a: rest.a,
                    length: left,
                    way: zero,
                    way_area: zero,
                    v: end.v,
                    start: slide.a,
                    is_open: select(is_inside | !is_slide, zero, one),
                    is_way_open: zero,
                    is_left: zero,
                },
            );
        }
        if !is_any(&lengths) {
            return;
        }
        let responses = self.responses(quiet, &lengths);
        for i in 0..L {
            let (quiet, body, turn) = (quiet.at(i), self.turning.at(i), self.turn.at(i));
            let load = quiet.load([first, second], change);
            self.turn.set(i, &body.closing(&quiet, &load, &responses.at(i), &turn));
        }
    }
}
