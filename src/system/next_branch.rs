//! The branch after an event: which of the contacts at rest stick, and which way the others go.
//!
//! With the forces T of the contacts at rest their accelerations are `a = a₀ − G T`, `G = Bᵀ M⁻¹ B`. A contact that
//! sticks has a = 0 and |T| ≤ R; one that slides has `T = s R` and `s a ≥ 0`. These are the conditions for the least value
//! of `½ Tᵀ G T − a₀ᵀ T` in the box |T| ≤ R. G is positive semidefinite, so that there is one; the accelerations
//! are unique, and for dependent directions the forces are not. A stop that gives no way has `T ≥ 0`, and opens where T = 0 and a < 0.
//!
//! **Static friction.** R is first the static bound of all contacts. Those that slide then get their kinetic
//! friction, and the problem is solved again, until no more slide. A contact therefore sticks on arrival, and stays at
//! rest, as long as it can; and there is always an answer, after at most as many rounds as there are contacts.
//!
//! **At the bound without an acceleration**, as after a release with peak = 1, the derivative of the same conditions decides:
//! `j = j₀ − G T′`, where T′ of a force at the bound R is at most R′ with `j ≥ 0`, and T′ of one below it is free with j = 0. If
//! T is one of several sets of forces, each of them leads to the same j: a polyhedron's image has the image of its cone.

use super::assembly::{Assembly, Rule};
use super::dependent::{least, rank, rounding};
use super::equation::given_tension;
use super::matrix::{add_times, dot, size_of_dot};
use super::mode::{Mode, sign};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// A contact at rest that is to be decided.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtRest {
    pub(crate) element: usize,
    /// Its force has just reached its bound in this direction.
    pub(crate) released: Option<bool>,
}

/// What a contact at rest does next: it sticks, or slides forward or backward.
pub(crate) type Choice = Option<bool>;

/// A contact at rest with its numbers.
struct Contact<F> {
    element: usize,
    /// a₀.
    acceleration: F,
    /// Its rounding.
    doubt: F,
    kinetic: F,
    bound: F,
    /// A stop that gives no way, which has no bound.
    is_stop: bool,
    released: Choice,
}

impl<F: Float> Contact<F> {
    fn new(system: &Assembly<F>, z: &[F], one: &AtRest, force: &[F], size: &[F]) -> Option<Self> {
        let part = system.parts.get(one.element)?;
        let (kinetic, bound, is_stop) = match &part.rule {
            Rule::Contact { pieces, peak, normal } => {
                let load = normal.as_ref().map_or(F::int(1), |row| dot(row, z).or_larger(F::int(0)));
                let kinetic = pieces.first()?.force * load;
                (kinetic, kinetic * *peak, false)
            }
            Rule::Hard { .. } => (F::int(0), F::int(0), true),
            Rule::Elastic { .. } | Rule::Stop { .. } | Rule::Spring { .. } => return None,
        };
        let acceleration = dot(&part.response, force) - dot(&part.moves, z);
        let scale = size_of_dot(&part.response, size) + size_of_dot(&part.moves, z);
        let doubt = scale * F::epsilon() * F::int(256);
        let (element, released) = (one.element, one.released);
        Some(Self { element, acceleration, doubt, kinetic, bound, is_stop, released })
    }

    /// The greatest force with the bound `bound`.
    fn high(&self, bound: F) -> Option<F> {
        (!self.is_stop).then_some(bound)
    }

    /// The least force.
    fn low(&self, bound: F) -> F {
        if self.is_stop { F::int(0) } else { -bound }
    }

    /// How far a force is from its bound in a direction.
    fn room(&self, bound: F, force: F, forward: bool) -> Option<F> {
        if forward { self.high(bound).map(|high| high - force) } else { Some(force - self.low(bound)) }
    }
}

/// Decides all contacts at rest at once; `modes` are those of the other elements. The element that cannot be decided is
/// the error.
pub(crate) fn decide<F: Float>(
    system: &Assembly<F>,
    z: &[F],
    at_rest: &[AtRest],
    modes: &[Mode],
) -> Result<Vec<Choice>, usize> {
    let first = at_rest.first().map_or(0, |c| c.element);
    let rests = |i: usize| at_rest.iter().any(|c| c.element == i);
    // The force on each coordinate without theirs, and the sum of its parts' sizes.
    let mut force = system.force.of(z);
    let mut size: Vec<F> = system.force.rows().map(|row| size_of_dot(row, z)).collect();
    for (i, (part, mode)) in system.parts.iter().zip(modes).enumerate() {
        if !rests(i)
            && let Some(row) = given_tension(part, *mode)
        {
            push(&mut force, &mut size, &part.direction, dot(&row, z), size_of_dot(&row, z));
        }
    }
    let contacts: Vec<Contact<F>> =
        at_rest.iter().filter_map(|one| Contact::new(system, z, one, &force, &size)).collect();
    let coupling = system.coupling_of(&contacts.iter().map(|c| c.element).collect::<Vec<_>>());
    let free: Vec<F> = contacts.iter().map(|c| c.acceleration).collect();
    let doubt: Vec<F> = contacts.iter().map(|c| c.doubt).collect();
    let mut bounds: Vec<F> = contacts.iter().map(|c| c.bound).collect();
    // Each round lets at least one contact down to its kinetic friction.
    for _ in 0..=contacts.len() {
        let pairs = || contacts.iter().zip(&bounds);
        let high: Vec<Option<F>> = pairs().map(|(contact, &b)| contact.high(b)).collect();
        let low: Vec<Option<F>> = pairs().map(|(contact, &b)| Some(contact.low(b))).collect();
        let mut tension = least(&coupling, &free, &doubt, &low, &high).map_err(|_| first)?;
        let acceleration: Vec<F> =
            free.iter().zip(coupling.rows()).map(|(&a, row)| a - dot(row, &tension)).collect();
        let mut choices: Vec<Choice> = acceleration
            .iter()
            .zip(&doubt)
            .zip(coupling.rows())
            .map(|((&a, &doubt), row)| {
                let doubt = doubt + rounding(row, &tension);
                (a.abs() > doubt).then_some(a > F::int(0))
            })
            .collect();
        keep(system, &contacts, &mut choices);
        let mut lower = lowered(&contacts, &mut bounds, &choices);
        if !lower {
            let now = Now { system, z, force: &force, contacts: &contacts };
            // Forces of inconsistent motions jump along their dependence, each time to one bound more.
            let decided = (0..=contacts.len()).find_map(|_| {
                let decided = now.at_the_bound(modes, &mut tension, &bounds, &mut choices);
                if decided == Some(false) { None } else { decided }
            });
            decided.ok_or(first)?;
            while !are_consistent(system, &contacts, &choices) {
                now.separate(&mut tension, &bounds, &mut choices).ok_or(first)?;
            }
            lower = lowered(&contacts, &mut bounds, &choices);
        }
        if !lower {
            return Ok(choices);
        }
    }
    Err(first)
}

/// Gives contacts that slide their kinetic friction: whether one had more.
fn lowered<F: Float>(contacts: &[Contact<F>], bounds: &mut [F], choices: &[Choice]) -> bool {
    let mut lower = false;
    for ((contact, bound), choice) in contacts.iter().zip(bounds).zip(choices) {
        if choice.is_some() && *bound > contact.kinetic {
            *bound = contact.kinetic;
            lower = true;
        }
    }
    lower
}

/// `force −= b T`, with the sizes.
fn push<F: Float>(force: &mut [F], size: &mut [F], direction: &[F], tension: F, largest: F) {
    add_times(force, -tension, direction);
    size.iter_mut().zip(direction).for_each(|(s, &b)| *s = *s + (b * largest).abs());
}

/// The contacts at rest with the forces on the coordinates.
struct Now<'a, F> {
    system: &'a Assembly<F>,
    z: &'a [F],
    /// Without the forces of these contacts.
    force: &'a [F],
    contacts: &'a [Contact<F>],
}

impl<F: Float> Now<'_, F> {
    /// Decides the contacts without an acceleration, where a force is at its bound: whether they are decided. Otherwise the
    /// forces have moved on to a bound.
    fn at_the_bound(
        &self,
        modes: &[Mode],
        tension: &mut [F],
        bounds: &[F],
        choices: &mut [Choice],
    ) -> Option<bool> {
        let (system, zero) = (self.system, F::int(0));
        let mut still = Vec::new();
        let mut is_at_bound = false;
        for (k, (contact, choice)) in self.contacts.iter().zip(choices.iter()).enumerate() {
            if choice.is_some() {
                continue;
            }
            let (Some(&force), Some(&bound)) = (tension.get(k), bounds.get(k)) else { continue };
            let own = system.coupling.at(contact.element, contact.element);
            // Both sides are moved: no force acts on them.
            if own <= zero {
                continue;
            }
            let size = if contact.is_stop { force.abs() } else { bound };
            let doubt = contact.doubt / own + size * F::epsilon() * F::int(256);
            // An event is found to the rounding of the whole step.
            let near =
                |forward: bool| if contact.released == Some(forward) { F::int(1024) } else { F::int(1) };
            let at = [true, false].map(|forward| {
                contact.room(bound, force, forward).is_some_and(|room| room <= doubt * near(forward))
            });
            is_at_bound |= at.contains(&true);
            still.push((k, at));
        }
        if !is_at_bound && !system.is_dependent {
            return Some(true);
        }
        let rate = self.rate(tension, modes);
        // The derivative of the force on each coordinate, without that of the forces of those that are still.
        let mut force = system.force.of(&rate);
        let mut size: Vec<F> = system.force.rows().map(|row| size_of_dot(row, &rate)).collect();
        for (i, (part, mode)) in system.parts.iter().zip(modes).enumerate() {
            let place = self.contacts.iter().position(|c| c.element == i);
            let mode = match place.map(|k| choices.get(k).copied().flatten()) {
                None => *mode,
                Some(None) => continue,
                Some(Some(forward)) => Mode::Slides { forward, piece: 0 },
            };
            if let Some(row) = given_tension(part, mode) {
                push(&mut force, &mut size, &part.direction, dot(&row, &rate), size_of_dot(&row, &rate));
            }
        }
        let (mut jerk, mut doubts) = (Vec::new(), Vec::new());
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for &(k, [above, below]) in &still {
            let contact = self.contacts.get(k)?;
            let part = system.parts.get(contact.element)?;
            jerk.push(dot(&part.response, &force) - dot(&part.moves, &rate));
            let scale = size_of_dot(&part.response, &size) + size_of_dot(&part.moves, &rate);
            doubts.push(scale * F::epsilon() * F::int(1024));
            let Rule::Contact { pieces, normal, .. } = &part.rule else {
                high.push(None);
                low.push(below.then_some(zero));
                continue;
            };
            let load = normal.as_ref().map_or(F::int(1), |row| dot(row, self.z));
            let full = bounds.get(k).copied()?;
            // R′ = R N′/N; at N = 0 the kinetic friction begins.
            let grows = normal.as_ref().map_or(zero, |row| {
                let by = dot(row, &rate);
                if load > zero { full / load * by } else { pieces.first().map_or(zero, |p| p.force) * by }
            });
            high.push(above.then_some(grows));
            low.push(below.then_some(-grows));
        }
        let places: Vec<usize> =
            still.iter().filter_map(|&(k, _)| self.contacts.get(k)).map(|c| c.element).collect();
        let inner = system.coupling_of(&places);
        let change = match least(&inner, &jerk, &doubts, &low, &high) {
            Ok(change) => change,
            Err(way) if way.is_empty() => return None,
            Err(way) => {
                let places: Vec<usize> = still.iter().map(|&(k, _)| k).collect();
                jump(self.contacts, &places, &way, bounds, tension)?;
                return Some(false);
            }
        };
        for ((&(k, [above, below]), (&j0, row)), &doubt) in
            still.iter().zip(jerk.iter().zip(inner.rows())).zip(&doubts)
        {
            let j = j0 - dot(row, &change);
            let doubt = doubt + rounding(row, &change);
            let released = self.contacts.get(k).and_then(|c| c.released);
            let goes = |forward: bool, at: bool| {
                let by = sign::<F>(forward) * j;
                at && (by > doubt || (released == Some(forward) && by >= -doubt))
            };
            let choice = if goes(true, above) {
                Some(true)
            } else if goes(false, below) {
                Some(false)
            } else {
                None
            };
            if let Some(place) = choices.get_mut(k) {
                *place = choice;
            }
        }
        keep(system, self.contacts, choices);
        Some(true)
    }

    /// Lets one contact go where moving sides part contacts of dependent directions, which the derivatives so far do not show:
    /// along the first derivative of their velocities that is not that of one motion.
    fn separate(&self, tension: &mut [F], bounds: &[F], choices: &mut [Choice]) -> Option<()> {
        let (system, zero) = (self.system, F::int(0));
        let places: Vec<usize> =
            choices.iter().enumerate().filter(|(_, c)| c.is_none()).map(|(k, _)| k).collect();
        let elements: Vec<usize> =
            places.iter().filter_map(|&k| self.contacts.get(k)).map(|c| c.element).collect();
        let matrix = system.coupling_of(&elements);
        let inverse = matrix.pseudo_inverse();
        let mut wave = self.z.to_vec();
        // A wave is zero if twice as many derivatives as it has harmonics are, and a record has one.
        for _ in 0..=2 * system.frequencies.len() + 1 {
            wave = self.turned(&wave);
            let parts = || elements.iter().filter_map(|&i| system.parts.get(i));
            let apart: Vec<F> = parts().map(|p| -dot(&p.moves, &wave)).collect();
            let size = parts().fold(zero, |s, p| s + size_of_dot(&p.moves, &wave));
            let together = matrix.of(&inverse.of(&apart));
            let way: Vec<F> = apart.iter().zip(&together).map(|(&a, &b)| a - b).collect();
            if way.iter().any(|x| x.abs() > size * F::epsilon() * F::int(4096)) {
                let (k, forward) = jump(self.contacts, &places, &way, bounds, tension)?;
                *choices.get_mut(k)? = Some(forward);
                return Some(());
            }
        }
        None
    }

    /// The derivative of the harmonics and records of a state, and zeros.
    fn turned(&self, old: &[F]) -> Vec<F> {
        let mut wave = vec![F::int(0); old.len()];
        let at = |k: usize| old.get(k).copied().unwrap_or(F::int(0));
        for (i, &frequency) in self.system.frequencies.iter().enumerate() {
            let place = self.system.harmonic(i);
            for (k, x) in [(place, frequency * at(place + 1)), (place + 1, -frequency * at(place))] {
                if let Some(wave) = wave.get_mut(k) {
                    *wave = x;
                }
            }
        }
        for i in 0..self.system.records.len() {
            let place = self.system.record(i);
            if let Some(wave) = wave.get_mut(place) {
                *wave = at(place + 1);
            }
        }
        wave
    }

    /// The derivative of the state with these forces.
    fn rate(&self, tension: &[F], modes: &[Mode]) -> Vec<F> {
        let (system, n) = (self.system, self.system.n);
        let mut force = self.force.to_vec();
        for (contact, &tension) in self.contacts.iter().zip(tension) {
            if let Some(part) = system.parts.get(contact.element) {
                add_times(&mut force, -tension, &part.direction);
            }
        }
        let mut rate = self.turned(self.z);
        let velocities = self.z.get(n..2 * n).unwrap_or(&[]).iter().copied();
        let accelerations = system.inverse_mass.of(&force);
        for (place, x) in rate.iter_mut().zip(velocities.chain(accelerations)) {
            *place = x;
        }
        for (part, mode) in system.parts.iter().zip(modes) {
            if let (Rule::Elastic { stiffness, place, .. }, Mode::Holds) = (&part.rule, mode)
                && let Some(rate) = rate.get_mut(*place)
            {
                *rate = *stiffness * dot(&part.velocity, self.z);
            }
        }
        for driven in &system.moved {
            if let Some(rate) = rate.get_mut(n + driven.coordinate) {
                *rate = dot(&driven.acceleration, self.z);
            }
        }
        rate
    }
}

/// Moves forces along a direction until the first of them is at its bound: which one, and in which direction it is there.
fn jump<F: Float>(
    contacts: &[Contact<F>],
    places: &[usize],
    way: &[F],
    bounds: &[F],
    tension: &mut [F],
) -> Option<(usize, bool)> {
    let mut first: Option<(F, usize, bool)> = None;
    for (&k, &step) in places.iter().zip(way) {
        let forward = step > F::int(0);
        let Some(room) = contacts.get(k)?.room(*bounds.get(k)?, *tension.get(k)?, forward) else { continue };
        if step != F::int(0) && first.is_none_or(|(least, ..)| room / step.abs() < least) {
            first = Some(((room / step.abs()).or_larger(F::int(0)), k, forward));
        }
    }
    let (share, first, forward) = first?;
    for (&k, &step) in places.iter().zip(way) {
        if let Some(force) = tension.get_mut(k) {
            *force = *force + share * step;
        }
    }
    Some((first, forward))
}

/// A contact cannot move while others that its direction is a combination of stick.
fn keep<F: Float>(system: &Assembly<F>, contacts: &[Contact<F>], choices: &mut [Choice]) {
    if !system.is_dependent {
        return;
    }
    let sticks = contacts.iter().zip(choices.iter()).filter(|(_, c)| c.is_none());
    let stuck: Vec<usize> = sticks.map(|(c, _)| c.element).collect();
    for (contact, choice) in contacts.iter().zip(choices) {
        if choice.is_some() && follows(system, contact.element, &stuck) {
            *choice = None;
        }
    }
}

/// Whether those that stick can stay: dependent directions need the same dependence of the moving sides.
fn are_consistent<F: Float>(system: &Assembly<F>, contacts: &[Contact<F>], choices: &[Choice]) -> bool {
    if !system.is_dependent {
        return true;
    }
    let stuck = || {
        let parts = contacts.iter().zip(choices).filter(|(_, c)| c.is_none());
        parts.filter_map(|(c, _)| system.parts.get(c.element))
    };
    let directions: Vec<&[F]> = stuck().map(|p| p.direction.as_slice()).collect();
    let velocities: Vec<&[F]> = stuck().map(|p| p.velocity.as_slice()).collect();
    rank(&directions) == rank(&velocities)
}

/// Whether an element's velocity is a combination of those of others.
pub(crate) fn follows<F: Float>(system: &Assembly<F>, element: usize, others: &[usize]) -> bool {
    let mut rows: Vec<&[F]> =
        others.iter().filter_map(|&i| system.parts.get(i)).map(|p| p.velocity.as_slice()).collect();
    let Some(own) = system.parts.get(element) else { return false };
    let before = rank(&rows);
    rows.push(&own.velocity);
    !others.is_empty() && rank(&rows) == before
}

/// Takes the velocities of these elements out of the state, by the impulse of least energy.
pub(crate) fn at_rest<F: Float>(system: &Assembly<F>, z: &mut [F], elements: &[usize]) {
    if elements.is_empty() {
        return;
    }
    let parts: Vec<_> = elements.iter().filter_map(|&i| system.parts.get(i)).collect();
    let velocity: Vec<F> = parts.iter().map(|p| dot(&p.velocity, z)).collect();
    if velocity.iter().all(|&v| v == F::int(0)) {
        return;
    }
    let impulse = match (elements, velocity.as_slice()) {
        (&[element], &[velocity]) if system.coupling.at(element, element) > F::int(0) => {
            vec![F::int(1) / system.coupling.at(element, element) * velocity]
        }
        _ => system.coupling_of(elements).pseudo_inverse().of(&velocity),
    };
    let n = system.n;
    for (part, &impulse) in parts.iter().zip(&impulse) {
        add_times(z.get_mut(n..2 * n).unwrap_or(&mut []), -impulse, &part.response);
    }
}
