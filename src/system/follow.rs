//! The motion, from event to event.

mod choose;
mod passage;

use super::assembly::{Assembly, Part, Rule};
use super::blow::{Blows, Strike};
use super::branch::Branch;
use super::branches::Branches;
use super::error::Error;
use super::events::{Event, EventKind, Stretch, Watch, kind_of};
use super::guard::Trigger;
use super::kept::Kept;
use super::massless;
use super::matrix::{Sum, add_times, clear, dot, size_of_dot};
use super::mode::{Mode, lock, slides, yields};
use super::model::State;
use super::precision::small;
use super::propagator::Propagator;
use super::waves::Complex;
use crate::float::Float;
use crate::machine::error::written;
use alloc::vec;
use alloc::vec::Vec;

/// The largest number of steps beside those that end at samples of records: some seconds of work, as a step of a large
/// system multiplies large matrices.
pub(super) fn most_steps<F>(system: &Assembly<F>) -> u64 {
    let size = (system.size * system.free).max(256) as u64;
    (512_000_000 / size).max(20_000)
}

/// The most blows of one instant. Stops that are hit in turns take a part of the velocity with each, until it is rounding.
const MOST_TURNS: usize = 4096;

/// After so many steps a motion asks whether to go on: one of thousands of bits takes a second.
fn steps_between_questions<F: Float>() -> u64 {
    if F::precision() > 64 { 1 } else { 512 }
}

/// Where no long step is possible, the next one is tried after so many short ones.
const SHORT_STEPS: u32 = 8;

/// The motion at one instant.
pub(crate) struct Follower<'a, F> {
    system: &'a Assembly<F>,
    branches: Branches<F>,
    /// What contacts at rest keep.
    kept: Kept<F>,
    /// What is known of the stops that give no way.
    blows: Blows<F>,
    pub(crate) z: Vec<F>,
    clock: Sum<F>,
    /// The instant of the next sample of a record.
    sample: Option<F>,
    /// Whether a sample has come after the last step.
    at_sample: bool,
    /// Events without a step between them, and how many of them are blows.
    instant: usize,
    turns: usize,
    steps: u64,
    most_steps: u64,
    sizes: Vec<F>,
    values: Vec<F>,
    errors: Vec<F>,
    terms: Vec<F>,
    after: Vec<F>,
    /// e^{At} over a part of a step.
    motion: Propagator<F>,
    /// The fast modes of a long step that is tried, and the short steps until the next one is.
    amplitudes: Vec<Complex<F>>,
    wait: u32,
}

/// A motion at one instant, to be taken up again.
pub(crate) struct Saved<F> {
    z: Vec<F>,
    time: F,
    pub(crate) modes: Vec<Mode>,
    kept: Kept<F>,
    blows: Blows<F>,
}

/// A guard that has reached zero.
struct Fired {
    /// Whether it has been below zero since a sample or an event of this instant, instead of falling to it.
    is_forced: bool,
    element: usize,
    trigger: Trigger,
    /// Contacts that are released with it.
    others: Vec<(usize, bool)>,
}

impl<'a, F: Float> Follower<'a, F> {
    /// The motion at time 0. `longest` bounds every step.
    pub(crate) fn new(system: &'a Assembly<F>, start: &State<F>, longest: F) -> Result<Self, Error> {
        let mut z = vec![F::int(0); system.size];
        let n = system.n;
        for (place, &x) in z.iter_mut().zip(start.displacement.iter().chain(&start.velocity)) {
            *place = x;
        }
        if let Some(last) = z.last_mut() {
            *last = F::int(1);
        }
        let records = system.records.iter().filter(|record| !record.repeats());
        let samples: usize = records.map(|record| record.times.len()).sum();
        let mut follower = Self {
            system,
            branches: Branches::new(longest),
            kept: Kept::new(),
            blows: Blows::new(system),
            z,
            clock: Sum::at(F::int(0)),
            sample: None,
            at_sample: false,
            instant: 0,
            turns: 0,
            steps: 0,
            most_steps: most_steps(system).saturating_add(4 * samples as u64),
            sizes: Vec::new(),
            values: Vec::new(),
            errors: Vec::new(),
            terms: Vec::new(),
            after: Vec::new(),
            motion: Propagator::zero(system.size, system.free),
            amplitudes: Vec::new(),
            wait: 0,
        };
        debug_assert_eq!(start.displacement.len(), n, "the state has been checked");
        follower.set_phase();
        follower.set_sample();
        follower.set_forces(&start.force)?;
        follower.begin()?;
        Ok(follower)
    }

    /// The time.
    pub(crate) const fn time(&self) -> F {
        self.clock.value
    }

    /// The branch.
    pub(crate) fn branch(&self) -> Option<&Branch<F>> {
        self.branches.current()
    }

    /// The forces of the elastic contacts at the start, within their bounds.
    fn set_forces(&mut self, forces: &[F]) -> Result<(), Error> {
        for (part, &force) in self.system.parts.iter().zip(forces) {
            let Rule::Elastic { place, bound, .. } = &part.rule else { continue };
            let bound = dot(bound, &self.z).or_larger(F::int(0));
            // A state of a motion may be beyond the bound by rounding.
            if force.abs() > bound * (F::int(1) + F::epsilon() * F::int(1024)) {
                return Err(Error::Unsupported {
                    name: alloc::format!("{}: force of the start {}", part.name, written(force)),
                    condition: "must not exceed its friction",
                });
            }
            if let Some(place) = self.z.get_mut(*place) {
                *place = if force.abs() > bound { bound.with_sign_of(force) } else { force };
            }
        }
        Ok(())
    }

    /// Sets the time, for loads that repeat themselves, to 0.
    pub(crate) fn rewind(&mut self) {
        self.clock = Sum::at(F::int(0));
        self.set_phase();
        self.set_sample();
    }

    /// The number of steps since the last call; as many as a motion may have follow.
    pub(crate) const fn renew(&mut self) -> u64 {
        core::mem::replace(&mut self.steps, 0)
    }

    /// The motion as it is, to be taken up again.
    pub(crate) fn saved(&self) -> Saved<F> {
        let modes = self.branch().map_or_else(Vec::new, |branch| branch.modes.clone());
        let (kept, blows) = (self.kept.clone(), self.blows.clone());
        Saved { z: self.z.clone(), time: self.time(), modes, kept, blows }
    }

    /// Takes a motion up again, without a new choice of its branch.
    pub(crate) fn resume(&mut self, saved: &Saved<F>) {
        self.z.clone_from(&saved.z);
        self.clock = Sum::at(saved.time);
        (self.instant, self.turns) = (0, 0);
        self.set_sample();
        self.branches.enter(self.system, &saved.modes);
        self.wait = 0;
        self.kept.clone_from(&saved.kept);
        self.blows.clone_from(&saved.blows);
    }

    /// Moves the displacements by steps that no force notices.
    pub(crate) fn shift(&mut self, by: &[F]) {
        add_times(&mut self.z, F::int(1), by);
        self.kept.shifted(self.system, self.branches.current(), &self.z);
    }

    /// Begins anew at time 0, from these displacements, velocities and elastic forces.
    pub(crate) fn restart(&mut self, free: &[F]) -> Result<(), Error> {
        for (z, &x) in self.z.iter_mut().zip(free) {
            *z = x;
        }
        (self.instant, self.turns) = (0, 0);
        self.rewind();
        self.begin()
    }

    /// The harmonics at the present time.
    pub(crate) fn set_phase(&mut self) {
        for (i, &frequency) in self.system.frequencies.iter().enumerate() {
            let (sin, cos) = (frequency * self.time()).sin_cos();
            let place = self.system.harmonic(i);
            for (k, x) in [(place, sin), (place + 1, cos)] {
                if let Some(z) = self.z.get_mut(k) {
                    *z = x;
                }
            }
        }
    }

    /// The records from the present time on, which may be that of a sample, with the motions that are prescribed.
    fn set_sample(&mut self) {
        let (system, time) = (self.system, self.time());
        let earlier = |a: F, b: F| if b < a { b } else { a };
        self.sample = system.records.iter().filter_map(|record| record.next(time)).reduce(earlier);
        self.at_sample = true;
        for (i, record) in system.records.iter().enumerate() {
            let (value, slope) = record.from(time);
            let place = system.record(i);
            for (k, x) in [(place, value), (place + 1, slope)] {
                if let Some(z) = self.z.get_mut(k) {
                    *z = x;
                }
            }
        }
        for driven in &system.moved {
            let places = [driven.coordinate, system.n + driven.coordinate];
            for (place, row) in places.into_iter().zip([&driven.displacement, &driven.velocity]) {
                let x = row.as_ref().map(|row| dot(row, &self.z));
                if let (Some(x), Some(z)) = (x, self.z.get_mut(place)) {
                    *z = x;
                }
            }
        }
    }

    /// Passes a sample: a velocity that is prescribed may change at once, and with it the modes of contacts.
    fn pass_sample(&mut self, watch: &mut impl Watch<F>) -> Result<(), Error> {
        if !self.system.jerks {
            self.set_sample();
            return Ok(());
        }
        if !self.system.massless.is_empty() {
            let old = self.branch().map_or_else(Vec::new, |branch| branch.modes.clone());
            self.set_sample();
            let modes = self.choose()?;
            self.tell(&old, &modes, &[], None, watch);
            return Ok(());
        }
        let speeds =
            |z: &[F]| -> Vec<F> { self.system.parts.iter().map(|part| dot(&part.velocity, z)).collect() };
        let before = speeds(&self.z);
        self.set_sample();
        let after = speeds(&self.z);
        let rounding = |part: &Part<F>| size_of_dot(&part.velocity, &self.z) * F::epsilon() * F::int(256);
        let pairs = before.iter().zip(&after).zip(&self.system.parts);
        if pairs.into_iter().all(|((&a, &b), part)| (b - a).abs() <= rounding(part)) {
            return Ok(());
        }
        let old = self.branch().map_or_else(Vec::new, |branch| branch.modes.clone());
        self.blows.clear();
        let modes = self.choose()?;
        self.tell(&old, &modes, &[], None, watch);
        Ok(())
    }

    /// Chooses the first branch.
    fn begin(&mut self) -> Result<(), Error> {
        self.kept.clear();
        self.blows.clear();
        if !self.system.massless.is_empty() {
            // Where it changes which stops are in touch, there is another balance.
            let mut now = self.modes_of_state()?;
            for _ in 0..8 {
                let open = massless::open(self.system, &self.z, &now.0, &now.1);
                massless::balance(self.system, &mut self.z, &now.0, &open);
                let before = core::mem::replace(&mut now, self.modes_of_state()?).0;
                if now.0 == before {
                    break;
                }
            }
        }
        self.choose().map(|_| ())
    }

    /// Tells the events that lead from some modes to others, with those of blows.
    fn tell(
        &self,
        old: &[Mode],
        new: &[Mode],
        touched: &[usize],
        strike: Option<&Strike<F>>,
        watch: &mut impl Watch<F>,
    ) {
        let time = self.time();
        for blow in strike.iter().flat_map(|strike| &strike.blows) {
            watch.blow(self.system, blow, &self.z);
            if blow.told.is_some() {
                let (element, velocities) = (blow.element, blow.told);
                watch.event(Event { time, element, kind: EventKind::Blow, velocities });
            }
        }
        for (element, (old, new)) in old.iter().zip(new).enumerate() {
            let Some(kind) = kind_of(*old, *new, touched.contains(&element)) else { continue };
            let time = match (kind, strike) {
                // A blow turns what moves with the body.
                (EventKind::Reverse | EventKind::Touch, Some(_)) => continue,
                (EventKind::Close | EventKind::Stick, Some(strike)) => time + strike.later,
                _ => time,
            };
            watch.event(Event { time, element, kind, velocities: None });
        }
    }

    fn undecided(&self, element: usize) -> Error {
        let name = self.system.parts.get(element).map_or_else(Default::default, |p| p.name.clone());
        Error::Undecided { name, time: written(self.time()) }
    }

    /// The law of an element is not known from here on.
    fn leaves(&self, element: usize) -> Error {
        let part = self.system.parts.get(element);
        let name = part.map_or_else(Default::default, |part| part.name.clone());
        let limit = part.and_then(|part| part.limit).unwrap_or(F::int(0));
        Error::LeavesLaw { element, name, limit: written(limit), time: written(self.time()) }
    }

    /// Makes the branch with these modes the present one.
    fn enter(&mut self, modes: &[Mode]) {
        self.branches.enter(self.system, modes);
        self.wait = 0;
        self.kept.renew(self.system, self.branches.current(), &self.z);
    }

    /// Follows the motion until a time.
    pub(crate) fn run(&mut self, until: F, watch: &mut impl Watch<F>) -> Result<(), Error> {
        let zero = F::int(0);
        loop {
            let sample = self.sample.filter(|&t| t < until);
            let end = sample.unwrap_or(until);
            let rest = end - self.clock.value - self.clock.late;
            if rest <= zero {
                if sample.is_none() {
                    return Ok(());
                }
                self.clock = Sum::at(end);
                self.pass_sample(watch)?;
                continue;
            }
            self.steps += 1;
            if self.steps > self.most_steps {
                return Err(Error::TooLong { time: written(self.time()), limit: self.most_steps });
            }
            if self.steps.is_multiple_of(steps_between_questions::<F>())
                && (self.system.keep_going)().is_break()
            {
                return Err(Error::Interrupted);
            }
            let fired = self.step(rest, end, watch)?;
            if watch.is_over() {
                return Ok(());
            }
            if !fired.is_empty() {
                self.pass(&fired, watch)?;
            } else if self.time() >= end {
                if sample.is_some() {
                    self.pass_sample(watch)?;
                } else {
                    return Ok(());
                }
            }
        }
    }

    /// One step, to the end of the branch's step, to the end given or to an event.
    fn step(&mut self, rest: F, end: F, watch: &mut impl Watch<F>) -> Result<Vec<Fired>, Error> {
        let system = self.system;
        let Some(branch) = self.branches.current() else { return Ok(Vec::new()) };
        sizes_of(system, branch, &self.z, &mut self.sizes);
        if !branch.splits.is_empty() && self.leap(rest, end, watch)? {
            return Ok(Vec::new());
        }
        let Some(branch) = self.branches.current() else { return Ok(Vec::new()) };
        let whole = rest >= branch.step;
        let time = if whole { branch.step } else { rest };
        let event = self.first_event(time)?;
        let is_near = self.blows.is_near();
        let Some(branch) = self.branches.current() else { return Ok(Vec::new()) };
        let part = event.map_or(F::int(1), |(at, _)| at);
        let lasted = time * part;
        self.after.resize(self.z.len(), F::int(0));
        let motion = if branch.few.is_some() {
            None
        } else if event.is_none() && whole {
            Some(branch.whole())
        } else {
            branch.motion(lasted, &mut self.terms, &mut self.motion).then_some(&self.motion)
        };
        match motion {
            Some(motion) => motion.of(&self.z, &mut self.after),
            None if branch.few.is_some() => branch.after_part(part, &mut self.terms, &mut self.after),
            None => branch.after(&self.z, lasted, &mut self.terms, &mut self.after),
        }
        if !self.after.iter().all(|x| x.is_finite()) {
            return Err(Error::Unbounded { time: written(self.time()) });
        }
        // An element that a sample, or an event of this instant, has put beyond its guard.
        let is_forced = lasted <= F::int(0) && (self.at_sample || self.instant > 0);
        if lasted > F::int(0) {
            self.at_sample = false;
            let (from, to) = (&self.z, &self.after);
            let at = self.clock.value;
            let is_whole = event.is_none() && whole;
            let terms = branch.few.as_ref().map(|_| self.terms.as_slice());
            let stretch = Stretch { branch, from, to, time: lasted, at, motion, terms, is_whole, leap: None };
            watch.stretch(system, &stretch);
        }
        // A flight between small blows takes its time.
        if lasted > branch.step * small(24) || (is_near && lasted > F::int(0)) {
            (self.instant, self.turns) = (0, 0);
        }
        self.blows.moved(system, &self.sizes, part, lasted);
        core::mem::swap(&mut self.z, &mut self.after);
        self.kept.hold(system, branch, &mut self.z);
        if event.is_none() && !whole {
            self.clock = Sum::at(end);
        } else {
            self.clock.add(lasted);
        }
        let Some((_, number)) = event else { return Ok(Vec::new()) };
        Ok(self.fired(number, is_forced))
    }

    /// A long step, over which no guard reaches zero whatever the fast modes do: whether there is one.
    fn leap(&mut self, rest: F, end: F, watch: &mut impl Watch<F>) -> Result<bool, Error> {
        if self.wait > 0 {
            self.wait -= 1;
            return Ok(false);
        }
        let system = self.system;
        let Some(branch) = self.branches.current().filter(|_| !self.blows.is_near()) else {
            return Ok(false);
        };
        let found = branch.splits.iter().find_map(|split| {
            let time = split.clear_time(&self.z, &self.sizes, rest, &mut self.amplitudes, &mut self.terms)?;
            Some((split, time))
        });
        let Some((split, time)) = found else {
            self.wait = SHORT_STEPS;
            return Ok(false);
        };
        let leap = split.leap(&self.amplitudes, time);
        self.after.resize(self.z.len(), F::int(0));
        leap.after(&self.z, &mut self.terms, &mut self.after);
        if !self.after.iter().all(|x| x.is_finite()) {
            return Err(Error::Unbounded { time: written(self.time()) });
        }
        let (from, to, at) = (&*self.z, &*self.after, self.clock.value);
        let (motion, terms, is_whole, leap) = (None, None, false, Some(leap));
        let stretch = Stretch { branch, from, to, time, at, motion, terms, is_whole, leap };
        watch.stretch(system, &stretch);
        (self.at_sample, self.instant) = (false, 0);
        self.blows.moved(system, &self.sizes, F::int(1), time);
        core::mem::swap(&mut self.z, &mut self.after);
        self.kept.restore(system, branch, &mut self.z);
        if time < rest {
            self.clock.add(time);
        } else {
            self.clock = Sum::at(end);
        }
        Ok(true)
    }

    /// Passes the events that have fired, and enters the next branch.
    fn pass(&mut self, fired: &[Fired], watch: &mut impl Watch<F>) -> Result<(), Error> {
        let system = self.system;
        let Some(branch) = self.branch() else { return Ok(()) };
        let before = branch.modes.clone();
        let meets = fired.iter().any(|f| f.trigger == Trigger::Meets);
        let rate = if meets { branch.derivative(&self.z) } else { Vec::new() };
        let row = |f: &Fired| branch.guards.iter().find(|g| g.element == f.element && g.trigger == f.trigger);
        let change = watch
            .needs_changes()
            .then(|| fired.first().and_then(|f| row(f).map(|guard| (f, guard))))
            .flatten()
            .map(|(f, guard)| ((!f.is_forced).then(|| guard.row.clone()), branch.derivative(&self.z)));
        self.instant += 1;
        let is_blow = |f: &Fired| {
            f.trigger == Trigger::Closes
                && system.parts.get(f.element).is_some_and(|part| matches!(part.rule, Rule::Hard { .. }))
        };
        self.turns += usize::from(fired.iter().any(is_blow));
        if self.instant - self.turns > 16 + 8 * system.parts.len() || self.turns > MOST_TURNS {
            return Err(self.undecided(fired.first().map_or(0, |f| f.element)));
        }
        let mut modes = before.clone();
        let (mut touched, mut released, mut hit) = (Vec::new(), Vec::new(), Vec::new());
        for Fired { element, trigger, others, .. } in fired {
            let (Some(part), Some(mode)) = (system.parts.get(*element), modes.get_mut(*element)) else {
                continue;
            };
            match (*trigger, &part.rule) {
                (Trigger::Stops, Rule::Contact { .. }) => {
                    touched.push(*element);
                    *mode = Mode::Stuck;
                }
                (Trigger::Stops, _) => lock(part, mode, &mut self.z),
                (Trigger::Piece(piece), _) => {
                    if let Mode::Slides { forward, .. } = *mode {
                        *mode = Mode::Slides { forward, piece };
                    } else {
                        *mode = Mode::Bends { piece };
                    }
                }
                (Trigger::Ends, _) => return Err(self.leaves(*element)),
                (Trigger::Releases { forward }, Rule::Elastic { .. }) => {
                    yields(part, forward, &mut self.z);
                    *mode = Mode::Yields { forward };
                }
                (Trigger::Releases { forward }, _) => {
                    released.push((*element, forward));
                    released.extend_from_slice(others);
                }
                (Trigger::Parts, rule) => {
                    if let Rule::Elastic { place, .. } = rule {
                        clear(&mut self.z, *place);
                    }
                    *mode = Mode::Apart;
                }
                (Trigger::Meets, Rule::Elastic { stiffness, bound, .. }) => {
                    // Both its force and its bound begin at 0: the faster one decides.
                    let velocity = dot(&part.velocity, &self.z);
                    let holds = *stiffness * velocity.abs() <= dot(bound, &rate);
                    *mode = if holds { Mode::Holds } else { Mode::Yields { forward: velocity > F::int(0) } };
                }
                (Trigger::Meets, rule) => {
                    let velocity = dot(&part.velocity, &self.z);
                    *mode = if self.is_slow(*element) { Mode::Stuck } else { slides(rule, velocity) };
                }
                (Trigger::Closes, Rule::Hard { .. }) => hit.push(*element),
                (Trigger::Closes | Trigger::Presses, _) => *mode = Mode::Pressed,
                (Trigger::Opens, Rule::Stop { depth, .. }) => {
                    // Within rounding of its gap it is there.
                    let size =
                        size_of_dot(depth, &self.z).or_larger(depth.last().map_or(F::int(0), |x| x.abs()));
                    let deep = dot(depth, &self.z) > size * F::epsilon() * F::int(256);
                    *mode = if deep { Mode::Lifted } else { Mode::Away };
                }
                (Trigger::Opens | Trigger::Clears, _) => *mode = Mode::Away,
            }
        }
        let strike = self.strike(&mut modes, &hit)?;
        self.follow_stops(&mut modes);
        let is_resting = |(i, mode): (usize, &Mode)| mode.is_held() || self.may_rest(i, *mode);
        let resting: Vec<usize> =
            modes.iter().enumerate().filter(|one| is_resting(*one)).map(|one| one.0).collect();
        if system.massless.is_empty() {
            let arrives =
                strike.is_some() || resting.iter().any(|&i| !before.get(i).is_some_and(|m| m.is_held()));
            self.settle(&mut modes, resting, &released, arrives)?;
            self.enter(&modes);
        } else {
            modes = self.choose_light(&[modes, before.clone()], &resting)?;
        }
        if strike.is_none() {
            self.blows.disturb();
        }
        self.tell(&before, &modes, &touched, strike.as_ref(), watch);
        if let (Some(branch), Some((row, from))) = (self.branch(), change) {
            let reset = strike.as_ref().map(|strike| &strike.reset);
            watch.changes(row.as_deref(), reset, &from, &branch.derivative(&self.z));
        }
        Ok(())
    }
}

/// The sizes of the state's numbers, which have their rounding. The velocity of a body that is carried along by a side that moves is that of
/// this side, a sum whose terms may be far greater than itself: a belt that stops for an instant.
fn sizes_of<F: Float>(system: &Assembly<F>, branch: &Branch<F>, z: &[F], sizes: &mut Vec<F>) {
    sizes.clear();
    sizes.extend(z.iter().map(|x| x.abs()));
    let held = |i: &&usize| branch.modes.get(**i).is_some_and(|mode| mode.is_held());
    let drives =
        |i: usize| system.parts.get(i).and_then(|part| Some((part, part.velocity.get(2 * system.n..)?)));
    for &i in system.carriers.iter().filter(held) {
        let (Some((part, row)), Some(loads)) = (drives(i), z.get(2 * system.n..)) else { continue };
        let carried = size_of_dot(row, loads) / system.coupling.at(i, i);
        if carried.is_finite() {
            let velocities = sizes.iter_mut().skip(system.n);
            velocities.zip(&part.response).for_each(|(size, share)| *size = *size + carried * share.abs());
        }
    }
}
