//! The answers of a motion: events, extremes, time at rest, and energy.

use super::assembly::{Assembly, Driven, Part, Rule, unit};
use super::blow::Blow;
use super::branch::{Branch, static_bound};
use super::dependent::least;
use super::events::{Event, EventKind, Stretch, Watch};
use super::first_passage::{greatest_above, integer, shorten, shortened};
use super::follow::Follower;
use super::levels::Sides;
use super::matrix::{Matrix, Sum, add_times, dot, entries, size_of_dot};
use super::mode::{Mode, places};
use super::model::State;
use super::under::loaded;
use super::waves::{self, Products, Waves, opposite};
use crate::float::Float;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// A motion, with its answers.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Motion<F> {
    /// Its length in time.
    pub duration: F,
    /// The state at its end.
    pub end: State<F>,
    /// The greatest displacement of each coordinate, between events too.
    pub max_displacement: Vec<F>,
    /// The least displacement of each coordinate.
    pub min_displacement: Vec<F>,
    /// The greatest velocity of each coordinate.
    pub max_velocity: Vec<F>,
    /// The least velocity of each coordinate.
    pub min_velocity: Vec<F>,
    /// The greatest size of the absolute acceleration of each coordinate, `q″ + influence · acceleration`, on both sides of every
    /// event; none without a [`Base`](super::Base).
    pub max_absolute_acceleration: Vec<F>,
    /// All events in order.
    pub events: Vec<Event<F>>,
    /// The answers of the elements, in the order of the model.
    pub elements: Vec<ElementMotion<F>>,
    /// The work of the loads, `∫ f·q′ dt`, and of the forces that move coordinates as they are prescribed.
    pub load_work: F,
    /// The work done on the dampers, `∫ q′·C q′ dt`.
    pub damper_work: F,
    /// What kinetic energy and the springs, `½ q′·M q′ + ½ q·K q`, have gained. With it
    /// `load_work = damper_work + Σ work + stored`.
    pub stored: F,
}

/// The answers of an element.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ElementMotion<F> {
    /// Its name.
    pub name: String,
    /// The time in which a contact sticks, an elastic contact holds, or a stop is within its gap.
    pub time_at_rest: F,
    /// How often such a time begins; at a stop with a restitution after a contact, not after a blow.
    pub stops: usize,
    /// How many blows a stop with a restitution gets, of ever smaller ones those that are followed.
    pub blows: usize,
    /// The work that the bodies do on it, `∫ T b·q′ dt`: that of its other side is not included. That of a blow is the impulse times the mean
    /// of b·q′ before and after it, `½ (1 − e²) (b·q′)²/(b·M⁻¹b)` at a stop that does not move.
    pub work: F,
    /// The greatest speed of a contact, or size of the stretch of a spring, whose law has an end
    /// ([`System::stopping_beyond`](super::System::stopping_beyond)); none for the others.
    pub reach: Option<F>,
}

/// Watches a motion for its answers.
pub(crate) struct Observer<F> {
    n: usize,
    /// Greatest and least of q, q′.
    greatest: Vec<F>,
    least: Vec<F>,
    /// The greatest absolute accelerations.
    accelerations: Vec<F>,
    sides: Sides,
    pub(crate) events: Vec<Event<F>>,
    at_rest: Vec<Sum<F>>,
    /// Of each element, when it has just closed or stuck, and how often it was at rest at once when it closed.
    closed: Vec<(Option<(EventKind, F)>, usize)>,
    work: Vec<F>,
    reach: Vec<F>,
    load_work: F,
    damper_work: F,
    terms: Vec<F>,
    polynomial: Vec<F>,
    /// The Taylor coefficients of each entry of the state, one after the other.
    entries: Vec<F>,
    /// `∫₀¹ sʲ v ds`, j = 0, 1 …, of each velocity, and of one along an element.
    moments: Vec<F>,
    along: Vec<F>,
    /// `∫₀¹ sʲ sᵏ ds = 1/(j + k + 1)`.
    shares: Matrix<F>,
    /// The entries of the rows of the loads, and of the dampers, that are not zero.
    loads: Vec<Entries<F>>,
    dampers: Vec<Entries<F>>,
}

/// Entries of a row with their columns.
type Entries<F> = Vec<(usize, F)>;

impl<F: Float> Observer<F> {
    pub(crate) fn new(system: &Assembly<F>, z: &[F]) -> Self {
        let seen: Vec<F> = z.iter().take(2 * system.n).copied().collect();
        let zero = F::int(0);
        Self {
            n: system.n,
            greatest: seen.clone(),
            least: seen,
            accelerations: vec![zero; system.base.len()],
            sides: Sides::new(system),
            events: Vec::new(),
            at_rest: vec![Sum::at(zero); system.parts.len()],
            closed: vec![(None, 0); system.parts.len()],
            work: vec![zero; system.parts.len()],
            reach: vec![zero; system.parts.len()],
            load_work: zero,
            damper_work: zero,
            terms: Vec::new(),
            polynomial: Vec::new(),
            entries: Vec::new(),
            moments: Vec::new(),
            along: Vec::new(),
            shares: Matrix::zero(0, 0),
            loads: system.load.rows().map(entries).collect(),
            dampers: system.damping.rows().map(entries).collect(),
        }
    }

    /// The answers, at the end of the motion from `start`.
    pub(crate) fn finish(
        mut self,
        system: &Assembly<F>,
        start: &[F],
        follower: &Follower<'_, F>,
    ) -> Motion<F> {
        let n = self.n;
        // Ever smaller blows end in contact some time after the last one that is followed.
        let end = follower.time();
        self.events.iter_mut().filter(|event| event.time > end).for_each(|event| event.time = end);
        self.events.sort_by(|a, b| a.time.partial_cmp(&b.time).unwrap_or(core::cmp::Ordering::Equal));
        let part = |list: &[F], from: usize| list.get(from..from + n).unwrap_or(&[]).to_vec();
        let stored = energy(system, &follower.z) - energy(system, start);
        let stops = |element: usize| {
            let begins = |kind: EventKind| match kind {
                EventKind::Stick | EventKind::Lock => true,
                EventKind::Open => {
                    matches!(
                        system.parts.get(element).map(|p| &p.rule),
                        Some(Rule::Stop { .. } | Rule::Hard { .. })
                    )
                }
                EventKind::Slip | EventKind::Reverse | EventKind::Touch => false,
                EventKind::Yield | EventKind::Close | EventKind::Rise | EventKind::Fall => false,
                EventKind::Blow => false,
            };
            let begun = self.events.iter().filter(|e| e.element == element && begins(e.kind)).count();
            begun + self.closed.get(element).map_or(0, |closed| closed.1)
        };
        let elements = system
            .parts
            .iter()
            .zip(self.at_rest.iter().zip(&self.work))
            .enumerate()
            .map(|(i, (part, (at_rest, &work)))| ElementMotion {
                name: part.name.clone(),
                time_at_rest: at_rest.value,
                stops: stops(i),
                blows: self.events.iter().filter(|e| e.element == i && e.kind == EventKind::Blow).count(),
                work,
                reach: part.limit.and(self.reach.get(i).copied()),
            })
            .collect();
        Motion {
            duration: follower.time(),
            end: state(system, follower),
            max_displacement: part(&self.greatest, 0),
            min_displacement: part(&self.least, 0),
            max_velocity: part(&self.greatest, n),
            min_velocity: part(&self.least, n),
            max_absolute_acceleration: self.accelerations,
            elements,
            events: self.events,
            load_work: self.load_work,
            damper_work: self.damper_work,
            stored,
        }
    }

    /// The extremes with those of a state.
    fn see(&mut self, z: &[F]) {
        for ((greatest, least), &x) in self.greatest.iter_mut().zip(&mut self.least).zip(z) {
            *greatest = greatest.or_larger(x);
            *least = if x < *least { x } else { *least };
        }
    }

    /// The extremes of q and q′ over a stretch, whose Taylor terms are known.
    fn extremes(&mut self, count: usize, to: &[F], waves: Option<&Waves<F>>) {
        // What is far below the rounding of all displacements, or velocities, is a coordinate that does not move.
        let floor = |list: Option<&[F]>| {
            let most = list.unwrap_or(&[]).iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
            most * F::epsilon() * F::epsilon()
        };
        let floors = waves.map(|_| (floor(to.get(..self.n)), floor(to.get(self.n..2 * self.n))));
        let known = self.greatest.iter_mut().zip(&mut self.least).zip(to);
        for (i, (entry, ((greatest, least), &end))) in self.entries.chunks_exact(count).zip(known).enumerate()
        {
            *greatest = greatest.or_larger(end);
            *least = if end < *least { end } else { *least };
            let c = trimmed(entry);
            if let Some(waves) = waves {
                let reach = c.iter().fold(F::int(0), |sum, c| sum + c.abs());
                let reach = reach + waves::reach(waves.at(i));
                if floors.is_some_and(|(places, speeds)| reach <= if i < self.n { places } else { speeds }) {
                    continue;
                }
                let rounding = reach * F::epsilon();
                *greatest = waves.greatest(c, waves.at(i), *greatest, rounding);
                *least = -waves.greatest(&negative(c), &opposite(waves.at(i)), -*least, rounding);
                continue;
            }
            let Some((&first, [slope, rest @ ..])) = c.split_first() else { continue };
            // c₁ above Σ k|cₖ|: the signal rises or falls all the time, and its ends count.
            let mut k = F::int(1);
            let (mut turn, mut reach) = (F::int(0), slope.abs());
            for c in rest {
                k = k + F::int(1);
                turn = turn + k * c.abs();
                reach = reach + c.abs();
            }
            if slope.abs() > turn {
                continue;
            }
            let rounding = (first.abs() + reach) * F::epsilon();
            if first + reach > *greatest {
                *greatest = greatest_above(c, *greatest, rounding);
            }
            if first - reach < *least {
                self.polynomial.clear();
                self.polynomial.extend(c.iter().map(|&c| -c));
                *least = -greatest_above(&self.polynomial, -*least, rounding);
            }
        }
    }

    /// The greatest absolute accelerations over a stretch, whose Taylor terms are known.
    fn absolute_accelerations(
        &mut self,
        system: &Assembly<F>,
        stretch: &Stretch<'_, F>,
        waves: Option<&Waves<F>>,
    ) {
        let &Stretch { branch, time, .. } = stretch;
        let Some(last) = self.terms.rchunks_exact(system.size.max(1)).next() else { return };
        // z′ has the terms (k + 1)/t · (term k + 1), and the last by the equation.
        let tail = match &stretch.leap {
            Some(leap) => leap.derivative(last),
            None => branch.derivative(last),
        };
        let terms = || self.terms.chunks_exact(system.size.max(1));
        let c = &mut self.polynomial;
        for (i, (greatest, base)) in self.accelerations.iter_mut().zip(&system.base).enumerate() {
            let place = system.n + i;
            let entry = |list: &[F]| list.get(place).copied().unwrap_or(F::int(0));
            c.clear();
            let mut k = F::int(0);
            for (term, next) in terms().zip(terms().skip(1)) {
                k = k + F::int(1);
                c.push(entry(next) * k / time + dot(base, term));
            }
            c.push(entry(&tail) + dot(base, last));
            let slope = waves.map(|waves| (waves, waves.slope(place, time)));
            let all = slope.as_ref().map_or(F::int(0), |(_, slope)| waves::reach(slope));
            if c.iter().fold(all, |sum, c| sum + c.abs()) <= *greatest {
                continue;
            }
            let size = terms().fold(F::int(0), |sum, term| {
                sum + branch.size_of_slope(place, term) + size_of_dot(base, term)
            });
            let error = size * F::epsilon() * integer(system.size);
            if let Some((waves, slope)) = slope {
                *greatest = waves.greatest(c, &slope, *greatest, error);
                *greatest = waves.greatest(&negative(c), &opposite(&slope), *greatest, error);
                continue;
            }
            shorten(c, error);
            *greatest = greatest_above(c, *greatest, error);
            c.iter_mut().for_each(|c| *c = -*c);
            *greatest = greatest_above(c, *greatest, error);
        }
    }

    /// The greatest speeds, and sizes of stretches, of the elements whose law has an end, over a stretch whose Taylor terms are known.
    fn reaches(&mut self, system: &Assembly<F>, waves: Option<&Waves<F>>) {
        let Self { terms, polynomial: c, reach, .. } = self;
        for (part, reach) in system.parts.iter().zip(reach).filter(|(part, _)| part.limit.is_some()) {
            let row = part.bends().map_or(part.velocity.as_slice(), |(stretch, _)| stretch);
            c.clear();
            c.extend(terms.chunks_exact(system.size.max(1)).map(|term| dot(row, term)));
            let size = c.iter().fold(F::int(0), |sum, c| sum + c.abs());
            if let Some(waves) = waves {
                let own = waves.of(row);
                let rounding = (size + waves::reach(&own)) * F::epsilon();
                *reach = waves.greatest(c, &own, *reach, rounding);
                *reach = waves.greatest(&negative(c), &opposite(&own), *reach, rounding);
                continue;
            }
            if size > *reach {
                shorten(c, size * F::epsilon());
                *reach = greatest_above(c, *reach, size * F::epsilon());
                c.iter_mut().for_each(|c| *c = -*c);
                *reach = greatest_above(c, *reach, size * F::epsilon());
            }
        }
    }

    /// The Taylor coefficients of each entry of the state, from the Taylor terms: how many there are.
    fn part(&mut self, size: usize) -> usize {
        let count = self.terms.len() / size.max(1);
        self.entries.resize(size * count, F::int(0));
        for (entry, list) in self.entries.chunks_exact_mut(count.max(1)).enumerate() {
            let mut place = entry;
            for to in list {
                *to = self.terms.get(place).copied().unwrap_or(F::int(0));
                place += size;
            }
        }
        count.max(1)
    }

    /// What the fast modes of a long step add to the works of the rest.
    fn works_of_waves(
        &mut self,
        system: &Assembly<F>,
        branch: &Branch<F>,
        time: F,
        count: usize,
        waves: &Waves<F>,
    ) {
        let products = Products::new(&waves.rates, count);
        let n = system.n;
        let polynomial = |row: &[F], from: usize| {
            let mut sum = vec![F::int(0); count];
            for (i, &x) in row.iter().enumerate().filter(|(_, x)| **x != F::int(0)) {
                add_times(
                    &mut sum,
                    x,
                    self.entries.get((from + i) * count..(from + i + 1) * count).unwrap_or(&[]),
                );
            }
            sum
        };
        // A row over the velocities.
        let along = |row: &[F]| (polynomial(row, n), waves.from(row, n));
        let with =
            |(p, a): &(Vec<F>, Vec<_>), (q, b): &(Vec<F>, Vec<_>)| time * products.beside((p, a), (q, b));
        for ((part, tension), done) in system.parts.iter().zip(&branch.tension).zip(&mut self.work) {
            let force = (polynomial(tension, 0), waves.of(tension));
            *done = *done + with(&force, &along(&part.direction));
        }
        for i in 0..n {
            let velocity = along(&unit(n, i));
            let drive = system.moved.iter().find(|driven| driven.coordinate == i);
            let drive = drive.map(|driven| driving(system, branch, driven));
            let load = drive.as_deref().unwrap_or_else(|| system.load.row(i));
            self.load_work = self.load_work + with(&(polynomial(load, 0), waves.of(load)), &velocity);
            self.damper_work = self.damper_work + with(&along(system.damping.row(i)), &velocity);
        }
    }

    /// Works over a stretch, whose Taylor coefficients are known.
    fn works(&mut self, system: &Assembly<F>, branch: &Branch<F>, time: F, count: usize) {
        if self.shares.columns() < count {
            self.shares = shares(count.next_multiple_of(8));
        }
        let Self { entries: all, moments, along, shares, .. } = self;
        let velocities = all.get(system.n * count..).unwrap_or(&[]);
        moments.resize(system.n * count, F::int(0));
        for (moments, velocity) in moments.chunks_exact_mut(count).zip(velocities.chunks_exact(count)) {
            shares.transposed_of(velocity, moments);
        }
        for ((part, tension), done) in system.parts.iter().zip(&branch.tension).zip(&mut self.work) {
            along.clear();
            along.resize(count, F::int(0));
            for (moments, &b) in moments.chunks_exact(count).zip(&part.direction) {
                if b != F::int(0) {
                    add_times(along, b, moments);
                }
            }
            let row = tension.iter().copied().enumerate().filter(|(_, x)| *x != F::int(0));
            *done = *done + time * work(row, all, along, count);
        }
        for (i, moments) in moments.chunks_exact(count).enumerate() {
            let [load, damper] =
                [&self.loads, &self.dampers].map(|rows| rows.get(i).map_or(&[][..], Vec::as_slice));
            let drive = system.moved.iter().find(|driven| driven.coordinate == i);
            let drive = drive.map(|driven| entries(&driving(system, branch, driven)));
            self.load_work = self.load_work
                + time * work(drive.as_deref().unwrap_or(load).iter().copied(), all, moments, count);
            self.damper_work =
                self.damper_work + time * work(damper.iter().copied(), velocities, moments, count);
        }
    }
}

/// `∫₀¹ (row · z) v ds`, by the Taylor coefficients of each entry of z and the moments of v.
fn work<F: Float>(row: impl Iterator<Item = (usize, F)>, of: &[F], moments: &[F], count: usize) -> F {
    let entry = |i: usize| of.get(i * count..(i + 1) * count).unwrap_or(&[]);
    row.fold(F::int(0), |sum, (i, x)| sum + x * dot(entry(i), moments))
}

/// The row of the force that moves a coordinate as it is prescribed, with its loads: `m a + (C q′ + K q) + Σ b T`.
fn driving<F: Float>(system: &Assembly<F>, branch: &Branch<F>, driven: &Driven<F>) -> Vec<F> {
    let (i, one) = (driven.coordinate, F::int(1));
    let mut row = system.load.row(i).to_vec();
    add_times(&mut row, -one, system.force.row(i));
    add_times(&mut row, system.mass.at(i, i), &driven.acceleration);
    for (part, tension) in system.parts.iter().zip(&branch.tension) {
        add_times(&mut row, part.direction.get(i).copied().unwrap_or(F::int(0)), tension);
    }
    row
}

/// Watches for the first passage of a level.
pub(crate) struct Passage<F> {
    element: usize,
    sides: Sides,
    terms: Vec<F>,
    events: Vec<Event<F>>,
}

impl<F: Float> Passage<F> {
    pub(crate) fn new(system: &Assembly<F>, level: usize) -> Self {
        let element = system.parts.len() + level;
        Self { element, sides: Sides::new(system), terms: Vec::new(), events: Vec::new() }
    }

    pub(crate) fn time(&self) -> Option<F> {
        self.events.iter().find(|event| event.element == self.element).map(|event| event.time)
    }
}

impl<F: Float> Watch<F> for Passage<F> {
    fn stretch(&mut self, system: &Assembly<F>, stretch: &Stretch<'_, F>) {
        self.events.clear();
        stretch.taylor(&mut self.terms);
        self.sides.pass(system, stretch, &self.terms, &mut self.events);
    }

    fn event(&mut self, _: Event<F>) {}

    fn is_over(&self) -> bool {
        self.time().is_some()
    }
}

/// `1/(j + k + 1)`, j, k = 0, 1 … `count` − 1.
fn shares<F: Float>(count: usize) -> Matrix<F> {
    let inverse: Vec<F> = (1..2 * count).map(|k| F::int(1) / integer(k)).collect();
    let mut shares = Matrix::zero(count, count);
    for i in 0..count {
        shares.row_mut(i).iter_mut().zip(inverse.iter().skip(i)).for_each(|(to, &from)| *to = from);
    }
    shares
}

impl<F: Float> Watch<F> for Observer<F> {
    fn stretch(&mut self, system: &Assembly<F>, stretch: &Stretch<'_, F>) {
        let &Stretch { branch, from, to, time, at, .. } = stretch;
        for ((mode, at_rest), (closed, caught)) in
            branch.modes.iter().zip(&mut self.at_rest).zip(&mut self.closed)
        {
            if matches!(mode, Mode::Stuck | Mode::Holds | Mode::Away) {
                at_rest.add(time);
            }
            // Ever smaller blows take some time yet: a contact under them rests later, and their stop is open as long.
            match (closed.take(), mode) {
                (Some((kind, instant)), Mode::Stuck | Mode::Holds) => {
                    *caught += usize::from(kind == EventKind::Close);
                    at_rest.add(at - instant);
                }
                (Some((_, instant)), Mode::Resting) => at_rest.add(instant - at),
                _ => {}
            }
        }
        stretch.taylor(&mut self.terms);
        let waves = stretch.leap.as_ref().and_then(|leap| leap.waves(from, to));
        self.sides.pass(system, stretch, &self.terms, &mut self.events);
        // The velocity of a joint jumps where it begins to slide, and one that is prescribed by a record at its samples.
        if system.jerks || !system.massless.is_empty() {
            self.see(from);
        }
        let count = self.part(system.size);
        self.extremes(count, to, waves.as_ref());
        if !system.base.is_empty() {
            self.absolute_accelerations(system, stretch, waves.as_ref());
        }
        self.works(system, branch, time, count);
        if let Some(waves) = &waves {
            self.works_of_waves(system, branch, time, count, waves);
        }
        self.reaches(system, waves.as_ref());
    }

    fn event(&mut self, event: Event<F>) {
        if let Some((closed, _)) = self.closed.get_mut(event.element) {
            let begins = matches!(event.kind, EventKind::Close | EventKind::Stick);
            *closed = begins.then_some((event.kind, event.time));
        }
        self.events.push(event);
    }

    fn blow(&mut self, system: &Assembly<F>, blow: &Blow<F>, to: &[F]) {
        self.see(to);
        if let Some(work) = self.work.get_mut(blow.element) {
            *work = *work + blow.impulse * blow.mean;
        }
        // The force that moves a coordinate as it is prescribed takes its part of the blow.
        let direction = system.parts.get(blow.element).map_or(&[][..], |part| &part.direction);
        for driven in &system.moved {
            let by = direction.get(driven.coordinate).copied().unwrap_or(F::int(0));
            let velocity = to.get(system.n + driven.coordinate).copied().unwrap_or(F::int(0));
            self.load_work = self.load_work + blow.impulse * by * velocity;
        }
    }
}

fn negative<F: Float>(c: &[F]) -> Vec<F> {
    c.iter().map(|&c| -c).collect()
}

/// The coefficients without those below the rounding of the others.
fn trimmed<F: Float>(c: &[F]) -> &[F] {
    let size = c.iter().fold(F::int(0), |sum, c| sum + c.abs());
    shortened(c, size * F::epsilon())
}

/// ½ q′·M q′ + ½ q·K q.
fn energy<F: Float>(system: &Assembly<F>, z: &[F]) -> F {
    let n = system.n;
    let (q, v) = (z.get(..n).unwrap_or(&[]), z.get(n..2 * n).unwrap_or(&[]));
    (dot(v, &system.mass.of(v)) + dot(q, &system.stiffness.of(q))) / F::int(2)
}

/// The state of a follower.
pub(crate) fn state<F: Float>(system: &Assembly<F>, follower: &Follower<'_, F>) -> State<F> {
    let (n, z) = (system.n, &follower.z);
    let force = follower.branch().map_or_else(Vec::new, |branch| forces(system, branch, z));
    let displacement = z.get(..n).unwrap_or(&[]).to_vec();
    let velocity = z.get(n..2 * n).unwrap_or(&[]).to_vec();
    let absolute_acceleration = match follower.branch() {
        Some(branch) if !system.base.is_empty() => {
            let slope = branch.derivative(z);
            system.base.iter().zip(slope.iter().skip(n)).map(|(row, &slope)| slope + dot(row, z)).collect()
        }
        _ => Vec::new(),
    };
    State { displacement, velocity, force, absolute_acceleration }
}

/// The force of each element. Where dependent directions leave the shares of contacts that stick open, none exceeds its bound.
fn forces<F: Float>(system: &Assembly<F>, branch: &Branch<F>, z: &[F]) -> Vec<F> {
    let mut force: Vec<F> = branch.tension.iter().map(|row| dot(row, z)).collect();
    if !system.is_dependent {
        return force;
    }
    let system = &*loaded(system, &branch.modes);
    let stuck = places(&branch.modes, Mode::is_held);
    let own: Vec<F> = stuck.iter().filter_map(|&i| force.get(i).copied()).collect();
    // The least and the greatest force; a stop that gives no way has no greatest one.
    let of = |part: &Part<F>| match part.rule {
        Rule::Hard { .. } => (F::int(0), None),
        Rule::Contact { .. } | Rule::Elastic { .. } | Rule::Stop { .. } | Rule::Spring { .. } => {
            let bound = dot(&static_bound(part), z);
            (-bound, Some(bound))
        }
    };
    let bounds: Vec<(F, Option<F>)> = stuck.iter().filter_map(|&i| system.parts.get(i)).map(of).collect();
    let is_within = |(&t, (low, high)): (&F, &(F, Option<F>))| t >= *low && high.is_none_or(|high| t <= high);
    if own.iter().zip(&bounds).all(is_within) {
        return force;
    }
    let coupling = system.coupling_of(&stuck);
    let doubt: Vec<F> =
        coupling.rows().map(|row| size_of_dot(row, &own) * F::epsilon() * F::int(256)).collect();
    let room = |&t: &F, &(low, high): &(F, Option<F>)| (Some(low - t), high.map(|high| high - t));
    let zeros = vec![F::int(0); own.len()];
    let (low, high): (Vec<_>, Vec<_>) = own.iter().zip(&bounds).map(|(t, bound)| room(t, bound)).unzip();
    for (&i, by) in
        stuck.iter().zip(least(&coupling, &zeros, &doubt, &low, &high).unwrap_or_else(|_| zeros.clone()))
    {
        if let Some(force) = force.get_mut(i) {
            *force = *force + by;
        }
    }
    force
}
