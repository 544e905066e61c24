//! The answers of a motion: events, extremes, time at rest, and energy.

use super::assembly::Assembly;
use super::branch::{Branch, Hull, polynomial, static_bound};
use super::dependent::least;
use super::equation::Mode;
use super::follow::{Event, EventKind, Follower, Watch, shorten};
use super::matrix::{dot, size_of_dot};
use super::model::State;
use super::zero::{greatest_above, integer};
use crate::float::Float;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// A motion, with its answers.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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
    /// All events in order.
    pub events: Vec<Event<F>>,
    /// The answers of the elements, in the order of the model.
    pub elements: Vec<ElementMotion<F>>,
    /// The work of the loads, `∫ f·q′ dt`.
    pub load_work: F,
    /// The work done on the dampers, `∫ q′·C q′ dt`.
    pub damper_work: F,
    /// What kinetic energy and the springs, `½ q′·M q′ + ½ q·K q`, have gained. With it
    /// `load_work = damper_work + Σ work + stored`.
    pub stored: F,
}

/// The answers of an element.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ElementMotion<F> {
    /// Its name.
    pub name: String,
    /// The time in which a contact sticks, an elastic contact holds, or a stop is within its gap.
    pub time_at_rest: F,
    /// How often such a time begins.
    pub stops: usize,
    /// The work that the bodies do on it, `∫ T b·q′ dt`: that of its other side is not included.
    pub work: F,
}

/// Watches a motion for its answers.
pub(crate) struct Observer<F> {
    n: usize,
    hulls: Vec<Option<Hull<F>>>,
    /// Greatest and least of q, q′.
    greatest: Vec<F>,
    least: Vec<F>,
    pub(crate) events: Vec<Event<F>>,
    at_rest: Vec<F>,
    work: Vec<F>,
    load_work: F,
    damper_work: F,
    values: Vec<F>,
    errors: Vec<F>,
    terms: Vec<F>,
    product: Vec<F>,
}

impl<F: Float> Observer<F> {
    pub(crate) fn new(system: &Assembly<F>, z: &[F]) -> Self {
        let seen: Vec<F> = z.iter().take(2 * system.n).copied().collect();
        let zero = F::int(0);
        Self {
            n: system.n,
            hulls: Vec::new(),
            greatest: seen.clone(),
            least: seen,
            events: Vec::new(),
            at_rest: vec![zero; system.parts.len()],
            work: vec![zero; system.parts.len()],
            load_work: zero,
            damper_work: zero,
            values: Vec::new(),
            errors: Vec::new(),
            terms: Vec::new(),
            product: Vec::new(),
        }
    }

    /// The answers, at the end of the motion from `start`.
    pub(crate) fn finish(self, system: &Assembly<F>, start: &[F], follower: &Follower<'_, F>) -> Motion<F> {
        let n = self.n;
        let part = |list: &[F], from: usize| list.get(from..from + n).unwrap_or(&[]).to_vec();
        let stored = energy(system, &follower.z) - energy(system, start);
        let stops = |element: usize| {
            let begins = |kind: EventKind| match kind {
                EventKind::Stick | EventKind::Lock => true,
                EventKind::Open => {
                    matches!(
                        system.parts.get(element).map(|p| &p.rule),
                        Some(super::assembly::Rule::Stop { .. })
                    )
                }
                EventKind::Slip | EventKind::Reverse | EventKind::Touch => false,
                EventKind::Yield | EventKind::Close => false,
            };
            self.events.iter().filter(|e| e.element == element && begins(e.kind)).count()
        };
        let elements = system
            .parts
            .iter()
            .zip(self.at_rest.iter().zip(&self.work))
            .enumerate()
            .map(|(i, (part, (&time_at_rest, &work)))| ElementMotion {
                name: part.name.clone(),
                time_at_rest,
                stops: stops(i),
                work,
            })
            .collect();
        Motion {
            duration: follower.time,
            end: state(system, follower),
            max_displacement: part(&self.greatest, 0),
            min_displacement: part(&self.least, 0),
            max_velocity: part(&self.greatest, n),
            min_velocity: part(&self.least, n),
            elements,
            events: self.events,
            load_work: self.load_work,
            damper_work: self.damper_work,
            stored,
        }
    }

    /// The extremes of q and q′ over a stretch.
    fn extremes(&mut self, number: usize, branch: &Branch<F>, z: &[F], time: F, after: &mut bool) {
        if self.hulls.len() <= number {
            self.hulls.resize_with(number + 1, || None);
        }
        let Some(place) = self.hulls.get_mut(number) else { return };
        let hull = place.get_or_insert_with(|| {
            let unit = |i: usize| (0..z.len()).map(|j| F::int(i32::from(i == j))).collect();
            branch.hull_of(&(0..2 * self.n).map(unit).collect::<Vec<Vec<F>>>())
        });
        hull.at(z, &mut self.values, &mut self.errors);
        let chunks = self.values.chunks_exact(hull.each).zip(&self.errors);
        let known = self.greatest.iter_mut().zip(&mut self.least);
        for ((i, (values, &error)), (greatest, least)) in chunks.enumerate().zip(known) {
            let above = values.iter().any(|&v| v + error > *greatest);
            let below = values.iter().any(|&v| v - error < *least);
            if !(above || below) {
                continue;
            }
            if !*after {
                branch.taylor(z, time, &mut self.terms);
                *after = true;
            }
            let mut c: Vec<F> =
                self.terms.chunks_exact(z.len()).map(|t| t.get(i).copied().unwrap_or(F::int(0))).collect();
            let size = c.iter().fold(F::int(0), |sum, c| sum + c.abs());
            let rounding = size * F::epsilon();
            shorten(&mut c, rounding);
            if above {
                *greatest = greatest_above(&c, *greatest, rounding);
            }
            if below {
                let turned: Vec<F> = c.iter().map(|&c| -c).collect();
                *least = -greatest_above(&turned, -*least, rounding);
            }
        }
    }

    /// Works over a stretch, whose Taylor terms are known.
    fn works(&mut self, system: &Assembly<F>, branch: &Branch<F>, time: F) {
        let n = self.n;
        let coordinate = |i: usize, terms: &[F]| -> Vec<F> {
            terms.chunks_exact(system.size).map(|t| t.get(n + i).copied().unwrap_or(F::int(0))).collect()
        };
        let velocities: Vec<Vec<F>> = (0..n).map(|i| coordinate(i, &self.terms)).collect();
        for ((part, tension), work) in system.parts.iter().zip(&branch.tension).zip(&mut self.work) {
            if tension.iter().all(|&x| x == F::int(0)) {
                continue;
            }
            let force = polynomial(tension, &self.terms);
            let mut v = vec![F::int(0); force.len()];
            for (velocity, &b) in velocities.iter().zip(&part.direction) {
                super::matrix::add_times(&mut v, b, velocity);
            }
            *work = *work + time * integral_of_product(&force, &v, &mut self.product);
        }
        for (i, velocity) in velocities.iter().enumerate() {
            let load = polynomial(system.load.row(i), &self.terms);
            self.load_work = self.load_work + time * integral_of_product(&load, velocity, &mut self.product);
            let mut damper = vec![F::int(0); velocity.len()];
            for (other, &c) in velocities.iter().zip(system.damping.row(i)) {
                super::matrix::add_times(&mut damper, c, other);
            }
            self.damper_work =
                self.damper_work + time * integral_of_product(&damper, velocity, &mut self.product);
        }
    }
}

impl<F: Float> Watch<F> for Observer<F> {
    fn stretch(&mut self, system: &Assembly<F>, number: usize, branch: &Branch<F>, z: &[F], time: F) {
        for (mode, at_rest) in branch.modes.iter().zip(&mut self.at_rest) {
            if matches!(mode, Mode::Stuck | Mode::Holds | Mode::Away) {
                *at_rest = *at_rest + time;
            }
        }
        let mut known = false;
        self.extremes(number, branch, z, time, &mut known);
        if !known {
            branch.taylor(z, time, &mut self.terms);
        }
        self.works(system, branch, time);
    }

    fn event(&mut self, event: Event<F>) {
        self.events.push(event);
    }
}

/// `∫₀¹ a(s) b(s) ds`, by the coefficients of the product.
fn integral_of_product<F: Float>(a: &[F], b: &[F], product: &mut Vec<F>) -> F {
    product.clear();
    product.resize(a.len() + b.len(), F::int(0));
    for (i, &x) in a.iter().enumerate() {
        super::matrix::add_times(product.get_mut(i..).unwrap_or(&mut []), x, b);
    }
    product.iter().enumerate().fold(F::int(0), |sum, (k, &c)| sum + c / integer(k + 1))
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
    State { displacement, velocity, force }
}

/// The force of each element. Where dependent directions leave the shares of contacts that stick open, none exceeds its bound.
fn forces<F: Float>(system: &Assembly<F>, branch: &Branch<F>, z: &[F]) -> Vec<F> {
    let mut force: Vec<F> = branch.tension.iter().map(|row| dot(row, z)).collect();
    if !system.is_dependent {
        return force;
    }
    let stuck: Vec<usize> =
        branch.modes.iter().enumerate().filter(|(_, m)| **m == Mode::Stuck).map(|(i, _)| i).collect();
    let own: Vec<F> = stuck.iter().filter_map(|&i| force.get(i).copied()).collect();
    let bounds: Vec<F> =
        stuck.iter().filter_map(|&i| system.parts.get(i)).map(|p| dot(&static_bound(p), z)).collect();
    if own.iter().zip(&bounds).all(|(t, &bound)| t.abs() <= bound) {
        return force;
    }
    let coupling = system.coupling_of(&stuck);
    let doubt: Vec<F> =
        coupling.rows().map(|row| size_of_dot(row, &own) * F::epsilon() * F::int(256)).collect();
    let rooms = |sign: F| -> Vec<Option<F>> {
        own.iter().zip(&bounds).map(|(&t, &bound)| Some(sign * bound - t)).collect()
    };
    let zeros = vec![F::int(0); own.len()];
    let (low, high) = (rooms(F::int(-1)), rooms(F::int(1)));
    for (&i, by) in
        stuck.iter().zip(least(&coupling, &zeros, &doubt, &low, &high).unwrap_or_else(|_| zeros.clone()))
    {
        if let Some(force) = force.get_mut(i) {
            *force = *force + by;
        }
    }
    force
}
