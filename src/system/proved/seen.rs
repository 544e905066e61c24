//! The answers of a motion in balls: extremes, events, times at rest and works.

use super::super::events::{EventKind, kind_of};
use super::super::mode::Mode;
use super::branch::{Branch, Flow};
use super::cloud::{above, around_zero};
use super::machine::{Machine, Number, Row, add_times, dot, is_zero, zeros};
use super::series::Series;
use crate::float::Field;
use crate::float::ball::Radius;
use crate::float::mp::Mp;
use alloc::vec::Vec;

/// How often a part of a step is halved, at most, where a greatest value is sought.
const DEPTH: u32 = 40;

/// The greatest value so far: one that is reached is not below `least`, and none is above `most`.
#[derive(Debug, Clone, Copy)]
struct Greatest {
    least: Mp<26>,
    most: Mp<26>,
}

impl Greatest {
    const fn of(least: Mp<26>, most: Mp<26>) -> Self {
        Self { least, most }
    }

    fn see(&mut self, value: &Number, is_reached: bool) {
        if is_reached && value.lower() > self.least {
            self.least = value.lower();
        }
        if value.upper() > self.most {
            self.most = value.upper();
        }
    }

    fn ball(&self) -> Number {
        Number::between(self.least, self.most)
    }
}

/// What a motion did so far.
pub(super) struct Seen {
    greatest: Vec<Greatest>,
    /// Of the opposite values.
    least: Vec<Greatest>,
    pub(super) works: Row,
    pub(super) load_work: Number,
    pub(super) damper_work: Number,
    pub(super) events: Vec<(Number, usize, EventKind)>,
    at_rest: Row,
    since: Vec<Option<Number>>,
}

/// A part of the motion in one step.
pub(super) struct Stretch<'a> {
    pub(super) branch: &'a Branch,
    pub(super) flow: &'a Flow,
    pub(super) step: Number,
    /// Its places in the step: those of the event before it and of its end.
    pub(super) from: Number,
    pub(super) to: Number,
}

impl Seen {
    pub(super) fn new(machine: &Machine, z: &[Number], modes: &[Mode]) -> Self {
        let zero = Number::int(0);
        let of = |x: &Number| Greatest::of(x.lower(), x.upper());
        let states = || z.iter().take(2 * machine.n);
        let mut seen = Self {
            greatest: states().map(of).collect(),
            least: states().map(|x| of(&-*x)).collect(),
            works: machine.parts.iter().map(|_| zero).collect(),
            load_work: zero,
            damper_work: zero,
            events: Vec::new(),
            at_rest: machine.parts.iter().map(|_| zero).collect(),
            since: machine.parts.iter().map(|_| None).collect(),
        };
        seen.rests(modes, zero);
        seen
    }

    /// Notes which elements are at rest from a time on.
    fn rests(&mut self, modes: &[Mode], time: Number) {
        for ((mode, since), sum) in modes.iter().zip(&mut self.since).zip(&mut self.at_rest) {
            let rests = matches!(mode, Mode::Stuck | Mode::Holds | Mode::Away);
            match *since {
                None if rests => *since = Some(time),
                Some(begun) if !rests => {
                    *sum = *sum + (time - begun);
                    *since = None;
                }
                _ => {}
            }
        }
    }

    /// The modes change.
    pub(super) fn change(&mut self, time: Number, old: &[Mode], new: &[Mode]) {
        for (element, (old, new)) in old.iter().zip(new).enumerate() {
            if let Some(kind) = kind_of(*old, *new, false) {
                self.events.push((time, element, kind));
            }
        }
        self.rests(new, time);
    }

    /// The times at rest until the end.
    pub(super) fn at_rest(&self, end: Number) -> Row {
        let one = |(sum, since): (&Number, &Option<Number>)| since.map_or(*sum, |begun| *sum + (end - begun));
        self.at_rest.iter().zip(&self.since).map(one).collect()
    }

    pub(super) fn greatest(&self) -> Row {
        self.greatest.iter().map(Greatest::ball).collect()
    }

    pub(super) fn least(&self) -> Row {
        self.least.iter().map(|least| -least.ball()).collect()
    }

    pub(super) fn stretch(&mut self, machine: &Machine, stretch: &Stretch<'_>) {
        for (i, (greatest, least)) in self.greatest.iter_mut().zip(&mut self.least).enumerate() {
            extremes(&stretch.flow.entry(i), stretch, greatest, least);
        }
        self.works(machine, stretch);
    }

    fn works(&mut self, machine: &Machine, stretch: &Stretch<'_>) {
        let Stretch { branch, flow, step, from, to } = *stretch;
        let n = machine.n;
        let integral = |series: &Series| {
            let sum = series.integral();
            (sum.at(to) - sum.at(from)) * step
        };
        let velocities: Vec<Series> = (0..n).map(|i| flow.entry(n + i)).collect();
        let along = |direction: &[Number], first: usize| -> Row {
            let mut row = zeros(machine.size);
            add_times(row.get_mut(first..).unwrap_or(&mut []), Number::int(1), direction);
            row
        };
        let of_elements = machine.parts.iter().zip(&branch.modes).zip(&branch.tension).zip(&mut self.works);
        for (((part, mode), tension), work) in of_elements {
            // What sticks on a side that does not move.
            let is_still = *mode == Mode::Stuck && part.velocity.iter().skip(2 * n).all(is_zero);
            if is_still || tension.iter().all(is_zero) {
                continue;
            }
            let done = match tension.split_last() {
                // A constant force.
                Some((force, others)) if others.iter().all(is_zero) => {
                    let way = flow.of(&along(&part.direction, 0));
                    *force * (way.at(to) - way.at(from))
                }
                _ => integral(&flow.of(tension).times(&flow.of(&along(&part.direction, n)))),
            };
            *work = *work + done;
        }
        for (i, velocity) in velocities.iter().enumerate() {
            if let Some(load) = machine.load.get(i).filter(|row| row.iter().any(|x| !is_zero(x))) {
                self.load_work = self.load_work + integral(&flow.of(load).times(velocity));
            }
            if let Some(damper) = machine.damping.get(i).filter(|row| row.iter().any(|x| !is_zero(x))) {
                let force = flow.of(&along(damper, n));
                self.damper_work = self.damper_work + integral(&force.times(velocity));
            }
        }
    }
}

/// The extremes of a series over a stretch.
fn extremes(series: &Series, stretch: &Stretch<'_>, greatest: &mut Greatest, least: &mut Greatest) {
    let (from, to) = (stretch.from, stretch.to);
    let slope = series.slope();
    let end = series.over(to, &slope);
    greatest.see(&end, true);
    least.see(&-end, true);
    let Some(first) = series.0.first() else { return };
    let reach = series.0.iter().skip(1).map(above).fold(Radius::ZERO, Radius::plus);
    let all = *first + around_zero(reach);
    if all.upper() <= greatest.least && (-all).upper() <= least.least {
        return;
    }
    // An event may be where the slope is zero: a little beyond it the zero is a crossing.
    let beyond = Number::exact(Mp::of_int(1).scale2(-16));
    let (first, last) = ((from - beyond).lower(), (to + beyond).upper());
    let last = if last > Mp::of_int(1) { Mp::of_int(1) } else { last };
    for zero in slope.zeros(first, last, DEPTH) {
        let place = zero.place();
        if place.is_below(&from) || to.is_below(&place) {
            continue;
        }
        let value = series.over(place, &slope);
        let is_reached = place.lower() >= from.upper() && place.upper() <= to.lower();
        greatest.see(&value, is_reached);
        least.see(&-value, is_reached);
    }
}

/// `½ q′·M q′ + ½ q·K q`.
pub(super) fn energy(machine: &Machine, z: &[Number]) -> Number {
    let (q, v) = (z.get(..machine.n).unwrap_or(&[]), z.get(machine.n..2 * machine.n).unwrap_or(&[]));
    let form = |rows: &[Row], x: &[Number]| {
        rows.iter().zip(x).fold(Number::int(0), |sum, (row, entry)| sum + dot(row, x) * *entry)
    };
    (form(&machine.mass, v) + form(&machine.stiffness, q)) / Number::int(2)
}
