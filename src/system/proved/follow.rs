//! The motion in balls, from event to event.
//!
//! The times at which a set of states is known are exact. At an event of a guard g at the instant t*, near the time t of the set, a state moves on
//! by `(f₋ − f₊)(t* − t)`, where f₋ and f₊ are its derivatives before and after, and `t* − t = −g/g′`: this is where the motion of the next
//! branch, which begins at t*, would have been at t. So events widen no time, and sets are moved by linear maps alone.

use super::super::guard::Trigger;
use super::super::mode::{Mode, sign};
use super::branch::{Branch, Flow, joined};
use super::cloud::{Cloud, above};
use super::doubt::{Doubt, Failure};
use super::machine::{Machine, Number, Row, Rule, add_times, at, dot, is_zero, set, solved, zeros};
use super::next::{AtRest, decide};
use super::seen::{Seen, Stretch};
use super::series::{Series, Zero};
use crate::float::Field;
use crate::float::ball::Radius;
use crate::float::mp::Mp;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// The greatest number of steps.
pub(super) const MOST_STEPS: u64 = 200_000;
/// The branches that are kept.
const MOST_BRANCHES: usize = 64;

/// A guard that is zero at the event at which its branch begins, with so many of its derivatives less one.
#[derive(Debug, Clone, Copy)]
struct Fresh {
    element: usize,
    trigger: Trigger,
    order: usize,
}

/// The motion at one time.
pub(super) struct Follower<'m> {
    machine: &'m Machine,
    branches: Vec<(Rc<Branch>, u64)>,
    time: Number,
    cloud: Cloud,
    modes: Vec<Mode>,
    /// From this time to that the branch begins, as differences from `time`.
    begins: [Mp<26>; 2],
    fresh: Vec<Fresh>,
    longest: f64,
    steps: u64,
    pub(super) seen: Seen,
}

/// The end of a motion.
pub(super) struct End {
    pub(super) z: Row,
    pub(super) force: Row,
}

/// An event: its guard, and its place in a step.
struct Event {
    element: usize,
    trigger: Trigger,
    row: Row,
    place: Number,
}

impl<'m> Follower<'m> {
    /// The motion at time 0, from displacements, velocities and the forces of elastic contacts.
    pub(super) fn new(machine: &'m Machine, start: &[Number], longest: f64) -> Result<Self, Failure> {
        let time = Number::int(0);
        let z = joined(start, &machine.loads(time));
        let (modes, fresh) = first_modes(machine, &z)?;
        let seen = Seen::new(machine, &z, &modes);
        let begins = [time.mid(); 2];
        let cloud = Cloud::of_box(start);
        Ok(Self { machine, branches: Vec::new(), time, cloud, modes, begins, fresh, longest, steps: 0, seen })
    }

    /// The branch with these modes.
    fn branch(&mut self, modes: &[Mode]) -> Result<Rc<Branch>, Failure> {
        let now = self.steps;
        if let Some((branch, used)) = self.branches.iter_mut().find(|(branch, _)| branch.modes == modes) {
            *used = now;
            return Ok(Rc::clone(branch));
        }
        if self.branches.len() >= MOST_BRANCHES {
            let oldest = self.branches.iter().enumerate().min_by_key(|(_, (_, used))| *used).map(|(i, _)| i);
            oldest.map(|i| self.branches.swap_remove(i));
        }
        let found = Branch::new(self.machine, modes, self.longest);
        let found = found.ok_or_else(|| self.failed(Doubt::of(None, "its matrices need more bits")))?;
        let branch = Rc::new(found);
        self.branches.push((Rc::clone(&branch), now));
        Ok(branch)
    }

    fn failed(&self, doubt: Doubt) -> Failure {
        failed_at(doubt, self.time)
    }

    /// Follows the motion until a time.
    pub(super) fn run(&mut self, until: Number, keep_going: fn() -> ControlFlow<()>) -> Result<End, Failure> {
        loop {
            self.steps += 1;
            if self.steps > MOST_STEPS {
                return Err(Failure::TooLong(self.time.mid().to_f64()));
            }
            if keep_going().is_break() {
                return Err(Failure::Interrupted);
            }
            let machine = self.machine;
            let modes = self.modes.clone();
            let branch = self.branch(&modes)?;
            let rest = until - self.time;
            let is_last = rest.upper() <= branch.step.lower();
            let step = if is_last { Number::exact(rest.upper()) } else { branch.step };
            if !step.is_positive() {
                return Err(self.failed(Doubt::of(None, "an event is at its end")));
            }
            let end = if is_last { rest / step } else { Number::int(1) };
            let z = joined(&self.cloud.hull(), &machine.loads(self.time));
            if z.iter().any(Number::is_entire) {
                return Err(self.failed(Doubt::of(None, "its state is lost in the widths of numbers")));
            }
            let flow = branch.flow(machine, &z, step);
            let [begin, begun] = self.begins.map(|x| Number::exact(x) / step);
            let from = begin.hull(&begun);
            let event = self.event(&branch, &flow, step, from, end)?;
            let to = event.as_ref().map_or(end, |event| event.place);
            self.seen.stretch(machine, &Stretch { branch: &branch, flow: &flow, step, from, to });
            match event {
                Some(event) => self.pass(&branch, &flow, step, &event)?,
                None if is_last => {
                    self.advance(&branch.after(machine, step, end));
                    let z = joined(&self.cloud.hull(), &machine.loads(until));
                    let force = branch.tension.iter().map(|row| dot(row, &z)).collect();
                    return Ok(End { z, force });
                }
                None => {
                    self.advance(&branch.whole);
                    self.time = self.time + step;
                    self.begins = [Number::int(0).mid(); 2];
                    self.fresh.clear();
                }
            }
        }
    }

    /// Moves the states by the rows of a part of a step.
    fn advance(&mut self, rows: &[Row]) {
        let z = joined(&self.cloud.centre, &self.machine.loads(self.time));
        let centre: Row = rows.iter().map(|row| dot(row, &z)).collect();
        let frame: Vec<Row> =
            self.cloud.frame.iter().map(|column| rows.iter().map(|row| dot(row, column)).collect()).collect();
        self.cloud = self.cloud.moved(&centre, &frame);
    }

    /// The first event in a step.
    fn event(
        &self,
        branch: &Branch,
        flow: &Flow,
        step: Number,
        from: Number,
        end: Number,
    ) -> Result<Option<Event>, Failure> {
        let depth = Mp::<26>::bits_now();
        let mut first: Option<Event> = None;
        for guard in &branch.guards {
            let series = flow.of(&guard.row);
            let doubt = |place: Number, reason| {
                failed_at(Doubt::of(Some(guard.element), reason), self.time + place * step)
            };
            let high = first.as_ref().map_or(end, |event| event.place).upper();
            let fresh = self.fresh.iter().find(|f| f.element == guard.element && f.trigger == guard.trigger);
            let low = match fresh {
                Some(fresh) => departs(&series, fresh.order, from, high)
                    .ok_or_else(|| doubt(from, "which way it departs from its event is not certain"))?,
                None => from.lower(),
            };
            if !series.at(Number::exact(low)).is_positive() {
                return Err(doubt(from, "another event of its kind may be at the same instant"));
            }
            let Some(zero) = series.first_zero(low, high, depth) else { continue };
            let Zero::Simple(place) = zero else {
                // Behind another event, it does not count.
                if first.as_ref().is_some_and(|event| event.place.is_below(&zero.place())) {
                    continue;
                }
                return Err(doubt(
                    zero.place(),
                    "it may only touch the bound of its motion, or reach it with another one",
                ));
            };
            if let Some(other) = &first
                && !place.is_below(&other.place)
            {
                if other.place.is_below(&place) {
                    continue;
                }
                return Err(doubt(place, "its event and one of another contact are at the same instant"));
            }
            first =
                Some(Event { element: guard.element, trigger: guard.trigger, row: guard.row.clone(), place });
        }
        match first {
            Some(event) if end.is_below(&event.place) => Ok(None),
            Some(event) if !event.place.is_below(&end) => {
                let doubt = Doubt::of(Some(event.element), "its event is at the end of the motion");
                Err(failed_at(doubt, self.time + event.place * step))
            }
            first => Ok(first),
        }
    }

    /// Passes an event.
    fn pass(&mut self, branch: &Branch, flow: &Flow, step: Number, event: &Event) -> Result<(), Failure> {
        let machine = self.machine;
        let middle = Number::exact(event.place.mid());
        let late = (event.place - middle) * step;
        let instant = self.time + event.place * step;
        // The states at the event.
        let states: Row = (0..machine.free).map(|i| over(&flow.entry(i), event.place)).collect();
        let z = joined(&states, &machine.loads(instant));
        let mut modes = self.modes.clone();
        let before = branch.derivative(&z);
        let slope = flow.of(&event.row).slope().at(event.place) / step;
        let fresh = self.next(event, instant, &z, &mut modes)?;
        self.seen.change(instant, &self.modes, &modes);
        let next = self.branch(&modes)?;
        let after = self.derivative_near(&next, &z, instant, late)?;
        // To the middle of the event's place, and on to where the next branch would have been.
        self.advance(&branch.after(machine, step, middle));
        self.time = self.time + middle * step;
        let jump: Row = before.iter().zip(&after).map(|(f, g)| (*f - *g) / slope).collect();
        let now = joined(&self.cloud.centre, &machine.loads(self.time));
        let moved = |x: &[Number], by: Number| -> Row {
            x.iter().zip(&jump).map(|(x, jump)| *x - *jump * by).collect()
        };
        let centre = moved(&self.cloud.centre, dot(&event.row, &now));
        let frame: Vec<Row> =
            self.cloud.frame.iter().map(|column| moved(column, dot(&event.row, column))).collect();
        self.cloud = self.cloud.moved(&centre, &frame);
        self.modes = modes;
        self.hold();
        self.begins = [late.lower(), late.upper()];
        self.fresh = fresh;
        Ok(())
    }

    /// The derivatives of the states of a branch between the instants of an event and the time of the set: an a priori enclosure by Picard's
    /// operator.
    fn derivative_near(
        &self,
        branch: &Branch,
        z: &[Number],
        instant: Number,
        late: Number,
    ) -> Result<Row, Failure> {
        let machine = self.machine;
        let span = Number::new(Number::int(0).mid(), above(&late).scaled(1));
        let loads = machine.loads(instant + span);
        let of = |free: &[Number]| branch.derivative(&joined(free, &loads));
        let free = z.get(..machine.free).unwrap_or(&[]);
        let reached =
            |slope: &[Number]| -> Row { free.iter().zip(slope).map(|(x, f)| *x + *f * span).collect() };
        let wide = |states: &[Number]| -> Row {
            let least = Radius::power_of_two(-i64::from(Mp::<26>::bits_now()));
            let one = |x: &Number| {
                let margin = x.rad().plus(above(x).times(least)).scaled(-1);
                Number::new(x.mid(), x.rad().plus(margin).plus(least.times(least)))
            };
            states.iter().map(one).collect()
        };
        let mut guess = wide(&reached(&of(free)));
        for _ in 0..8 {
            let slope = of(&guess);
            let found = reached(&slope);
            let is_inside = |(x, within): (&Number, &Number)| x.is_inside(within);
            if found.iter().zip(&guess).all(is_inside) {
                return Ok(slope);
            }
            guess = wide(&found);
        }
        Err(self.failed(Doubt::of(None, "the instant of its event is too uncertain")))
    }

    /// Takes out of the states what contacts that stick do not have: a velocity; and gives those that yield their friction.
    fn hold(&mut self) {
        let machine = self.machine;
        let (n, free) = (machine.n, machine.free);
        let loads = machine.loads(self.time);
        let is_held = |mode: &Mode| *mode == Mode::Stuck;
        let held: Vec<usize> =
            (0..self.modes.len()).filter(|i| self.modes.get(*i).is_some_and(is_held)).collect();
        let coupling: Vec<Row> =
            held.iter().map(|&i| held.iter().map(|&j| machine.coupling(i, j)).collect()).collect();
        let columns = core::iter::once(&self.cloud.centre).chain(&self.cloud.frame);
        let zero = zeros(machine.size - free);
        let mut is_centre = true;
        let mut moved: Vec<Row> = Vec::new();
        for column in columns {
            let loads = if is_centre { &loads } else { &zero };
            is_centre = false;
            let z = joined(column, loads);
            let mut column = column.clone();
            let speeds: Vec<Row> = held
                .iter()
                .map(|&i| {
                    vec![machine.parts.get(i).map_or_else(|| Number::int(0), |part| dot(&part.velocity, &z))]
                })
                .collect();
            let Some(impulses) = solved(&coupling, &speeds) else { return };
            for (&i, impulse) in held.iter().zip(impulses) {
                if let Some(part) = machine.parts.get(i) {
                    let velocities = column.get_mut(n..2 * n).unwrap_or(&mut []);
                    add_times(velocities, -at(&impulse, 0), &part.response);
                }
            }
            for (part, mode) in machine.parts.iter().zip(&self.modes) {
                if let (Mode::Yields { forward }, Rule::Elastic { place, bound, .. }) = (mode, &part.rule) {
                    set(&mut column, *place, Number::exact(sign(*forward)) * dot(bound, &z));
                }
            }
            moved.push(column);
        }
        if let Some((centre, frame)) = moved.split_first() {
            self.cloud = self.cloud.moved(centre, frame);
        }
    }

    /// The modes after an event, and the guards that begin at 0.
    fn next(
        &self,
        event: &Event,
        instant: Number,
        z: &[Number],
        modes: &mut [Mode],
    ) -> Result<Vec<Fresh>, Failure> {
        let machine = self.machine;
        let (element, trigger) = (event.element, event.trigger);
        let doubt = |reason| failed_at(Doubt::of(Some(element), reason), instant);
        let (Some(part), Some(&mode)) = (machine.parts.get(element), modes.get(element)) else {
            return Err(doubt("it is not there"));
        };
        let is_other = |(i, mode): (usize, &Mode)| (*mode == Mode::Stuck && i != element).then_some(i);
        let others: Vec<usize> = modes.iter().enumerate().filter_map(is_other).collect();
        let at_rest = |element, is_lowered| AtRest { element, is_lowered };
        let mut contacts: Vec<AtRest> = others.into_iter().map(|other| at_rest(other, false)).collect();
        let mut put = |new: Mode| modes.iter_mut().skip(element).take(1).for_each(|mode| *mode = new);
        let one = |trigger, order| vec![Fresh { element, trigger, order }];
        let mut fresh = match (mode, trigger, &part.rule) {
            (Mode::Slides { forward, piece }, Trigger::Piece(next), _) => {
                put(Mode::Slides { forward, piece: next });
                one(Trigger::Piece(piece), 1)
            }
            // It slides on with the force that it had, and its acceleration begins at 0.
            (Mode::Stuck, Trigger::Releases { forward }, _) if !part.has_peak() => {
                put(Mode::Slides { forward, piece: 0 });
                one(Trigger::Stops, 2)
            }
            // Its force has passed the static friction, so that only the kinetic one is left.
            (Mode::Stuck, Trigger::Releases { .. }, _) => {
                contacts.push(at_rest(element, true));
                Vec::new()
            }
            (Mode::Slides { .. }, Trigger::Stops, _) => {
                contacts.push(at_rest(element, false));
                Vec::new()
            }
            (Mode::Holds, Trigger::Releases { forward }, _) => {
                put(Mode::Yields { forward });
                Vec::new()
            }
            (Mode::Yields { forward }, Trigger::Stops, _) => {
                put(Mode::Holds);
                one(Trigger::Releases { forward }, 2)
            }
            (Mode::Away, Trigger::Closes, Rule::Stop { damping, .. }) => {
                put(Mode::Pressed);
                if is_zero(damping) { one(Trigger::Opens, 1) } else { Vec::new() }
            }
            (Mode::Pressed, Trigger::Opens, Rule::Stop { damping, .. }) => {
                if is_zero(damping) {
                    put(Mode::Away);
                    one(Trigger::Closes, 1)
                } else {
                    put(Mode::Lifted);
                    one(Trigger::Presses, 1)
                }
            }
            (Mode::Lifted, Trigger::Clears, _) => {
                put(Mode::Away);
                one(Trigger::Closes, 1)
            }
            (Mode::Lifted, Trigger::Presses, _) => {
                put(Mode::Pressed);
                one(Trigger::Opens, 1)
            }
            // The friction ends and begins at 0, so that no acceleration jumps.
            (Mode::Slides { .. }, Trigger::Parts, _) => {
                put(Mode::Apart);
                one(Trigger::Meets, 1)
            }
            (Mode::Apart, Trigger::Meets, _) => {
                let v = dot(&part.velocity, z);
                if !v.is_positive() && !v.is_negative() {
                    return Err(doubt("which way it slides where its normal load begins is not certain"));
                }
                put(Mode::Slides { forward: v.is_positive(), piece: 0 });
                one(Trigger::Parts, 1)
            }
            _ => return Err(doubt("its mode has no such end")),
        };
        decide(machine, z, &contacts, modes).map_err(|doubt| failed_at(doubt, instant))?;
        let slides = |contact: &&AtRest| matches!(modes.get(contact.element), Some(Mode::Slides { .. }));
        let begins = |contact: &AtRest| Fresh { element: contact.element, trigger: Trigger::Stops, order: 1 };
        fresh.extend(contacts.iter().filter(slides).map(begins));
        Ok(fresh)
    }
}

fn failed_at(doubt: Doubt, time: Number) -> Failure {
    Failure::Doubt(doubt, time.mid().to_f64())
}

/// Up to where a guard that is 0 at an event, with its derivatives below one order, is certainly positive.
fn departs(series: &Series, order: usize, from: Number, high: Mp<26>) -> Option<Mp<26>> {
    let mut slope = series.clone();
    for _ in 0..order {
        slope = slope.slope();
    }
    let mut place = Number::exact(high);
    for _ in 0..128 {
        // The whole way must be beyond the event.
        if place.mid() <= from.upper() {
            return None;
        }
        let rises = slope.at(Number::exact(from.lower())).is_positive()
            && slope.first_zero(from.lower(), place.mid(), 12).is_none();
        if rises && series.at(place).is_positive() {
            return Some(place.mid());
        }
        place = Number::exact(place.mid().scale2(-1));
    }
    None
}

/// The values of a series over a ball.
fn over(series: &Series, x: Number) -> Number {
    series.over(x, &series.slope())
}

/// The modes at the start.
fn first_modes(machine: &Machine, z: &[Number]) -> Result<(Vec<Mode>, Vec<Fresh>), Failure> {
    let mut modes = Vec::with_capacity(machine.parts.len());
    let mut contacts = Vec::new();
    for (element, part) in machine.parts.iter().enumerate() {
        let doubt = |reason| Failure::Doubt(Doubt::of(Some(element), reason), 0.0);
        let v = dot(&part.velocity, z);
        let unsure = || doubt("whether it moves at the start is not certain");
        modes.push(match &part.rule {
            Rule::Contact { normal: Some(row), .. } if !dot(row, z).is_positive() => {
                if !dot(row, z).is_negative() {
                    return Err(doubt("whether its normal load is above 0 at the start is not certain"));
                }
                Mode::Apart
            }
            Rule::Contact { pieces, .. } => {
                if is_zero(&v) {
                    contacts.push(AtRest { element, is_lowered: false });
                    Mode::Stuck
                } else {
                    let forward = if v.is_positive() {
                        true
                    } else if v.is_negative() {
                        false
                    } else {
                        return Err(unsure());
                    };
                    let speed = v.abs();
                    let mut piece = 0;
                    for (i, other) in pieces.iter().enumerate().skip(1) {
                        if other.from.is_below(&speed) {
                            piece = i;
                        } else if !speed.is_below(&other.from) {
                            return Err(doubt("which part of its law holds at the start is not certain"));
                        }
                    }
                    Mode::Slides { forward, piece }
                }
            }
            Rule::Elastic { place, bound, .. } => {
                if !at(z, *place).abs().is_below(&dot(bound, z)) {
                    return Err(doubt("its force is at its bound at the start"));
                }
                Mode::Holds
            }
            Rule::Stop { depth, stiffness, damping } => {
                let deep = dot(depth, z);
                let force = *stiffness * deep + *damping * v;
                if deep.is_negative() {
                    Mode::Away
                } else if deep.is_positive() && force.is_positive() {
                    Mode::Pressed
                } else if deep.is_positive() && force.is_negative() {
                    Mode::Lifted
                } else {
                    return Err(doubt("whether it is closed at the start is not certain"));
                }
            }
        });
    }
    decide(machine, z, &contacts, &mut modes).map_err(|doubt| Failure::Doubt(doubt, 0.0))?;
    let slides = |contact: &&AtRest| matches!(modes.get(contact.element), Some(Mode::Slides { .. }));
    let fresh = |contact: &AtRest| Fresh { element: contact.element, trigger: Trigger::Stops, order: 1 };
    let fresh = contacts.iter().filter(slides).map(fresh).collect();
    Ok((modes, fresh))
}
