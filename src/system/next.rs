//! The branch after an event: which of the contacts at rest stick, and which way the others go.
//!
//! With the forces T of the contacts at rest their accelerations are `a = a₀ − G T`, `G = Bᵀ M⁻¹ B`. A contact that
//! sticks has a = 0 and `|T| ≤ peak r(0) N`; one that slides has `T = s r(0) N` and `s a ≥ 0`. With peak = 1 and G
//! positive definite this is a linear complementarity problem with exactly one solution; a dependent direction leaves
//! the forces open, and the least are taken.
//!
//! A contact sticks as long as it can. The search therefore starts with all of them stuck, lets that one go whose force
//! is furthest beyond its bound, and takes back those that would slide the wrong way.

use super::assembly::{Assembly, Rule};
use super::branch::sign;
use super::matrix::{Matrix, add_times, dot, size_of_dot};
use crate::float::Float;
use alloc::vec;
use alloc::vec::Vec;

/// A contact at rest that is to be decided.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtRest {
    pub(crate) element: usize,
    /// It was released at this very instant, in this direction.
    pub(crate) released: Option<bool>,
}

/// What a contact at rest does next: it sticks, or slides forward or backward.
pub(crate) type Choice = Option<bool>;

/// Decides all contacts at rest at once. `force` is the force on each coordinate without theirs, and `size` the sum of
/// its parts' sizes. The element that cannot be decided is the error.
pub(crate) fn decide<F: Float>(
    system: &Assembly<F>,
    z: &[F],
    at_rest: &[AtRest],
    force: &[F],
    size: &[F],
) -> Result<Vec<Choice>, usize> {
    let contacts: Vec<Contact<F>> =
        at_rest.iter().filter_map(|one| Contact::new(system, z, one, force, size)).collect();
    if contacts.is_empty() {
        return Ok(Vec::new());
    }
    let mut choices: Vec<Choice> = at_rest.iter().map(|c| c.released).collect();
    let most = 8 * contacts.len() + 8;
    for round in 0..most {
        let (tension, acceleration) = balance(system, &contacts, &choices);
        // In the later rounds the first in order is changed, which ends for every positive definite G.
        match change(&contacts, &choices, &tension, &acceleration, round >= most / 2) {
            None => return Ok(choices),
            Some((i, choice)) => {
                if let Some(place) = choices.get_mut(i) {
                    *place = choice;
                }
            }
        }
    }
    exhaustive(system, &contacts).ok_or_else(|| at_rest.first().map_or(0, |c| c.element))
}

/// A contact at rest with its numbers.
struct Contact<F> {
    element: usize,
    /// a₀.
    acceleration: F,
    /// Its rounding.
    doubt: F,
    kinetic: F,
    bound: F,
}

impl<F: Float> Contact<F> {
    fn new(system: &Assembly<F>, z: &[F], one: &AtRest, force: &[F], size: &[F]) -> Option<Self> {
        let part = system.parts.get(one.element)?;
        let Rule::Contact { pieces, peak, normal } = &part.rule else { return None };
        let load = normal.as_ref().map_or(F::int(1), |row| dot(row, z).or_larger(F::int(0)));
        let kinetic = pieces.first()?.force * load;
        let acceleration = dot(&part.response, force) - dot(&part.moves, z);
        let scale = size_of_dot(&part.response, size) + size_of_dot(&part.moves, z);
        let doubt = scale * F::epsilon() * F::int(256);
        Some(Self { element: one.element, acceleration, doubt, kinetic, bound: kinetic * *peak })
    }
}

/// The forces and accelerations for these choices.
fn balance<F: Float>(system: &Assembly<F>, contacts: &[Contact<F>], choices: &[Choice]) -> (Vec<F>, Vec<F>) {
    let coupling = |i: usize, j: usize| match (contacts.get(i), contacts.get(j)) {
        (Some(a), Some(b)) => system.coupling.at(a.element, b.element),
        _ => F::int(0),
    };
    let mut tension: Vec<F> = contacts
        .iter()
        .zip(choices)
        .map(|(c, choice)| choice.map_or(F::int(0), |forward| sign::<F>(forward) * c.kinetic))
        .collect();
    let acceleration = |tension: &[F]| -> Vec<F> {
        contacts
            .iter()
            .enumerate()
            .map(|(i, c)| {
                tension.iter().enumerate().fold(c.acceleration, |a, (j, &t)| a - coupling(i, j) * t)
            })
            .collect()
    };
    let stuck: Vec<usize> = choices.iter().enumerate().filter(|(_, c)| c.is_none()).map(|(i, _)| i).collect();
    if !stuck.is_empty() {
        let free = acceleration(&tension);
        let mut matrix = Matrix::zero(stuck.len(), stuck.len());
        let mut right = vec![F::int(0); stuck.len()];
        for (a, (&i, right)) in stuck.iter().zip(&mut right).enumerate() {
            stuck.iter().enumerate().for_each(|(b, &j)| matrix.set(a, b, coupling(i, j)));
            *right = free.get(i).copied().unwrap_or(F::int(0));
        }
        for (&i, held) in stuck.iter().zip(matrix.pseudo_inverse().of(&right)) {
            if let Some(place) = tension.get_mut(i) {
                *place = held;
            }
        }
    }
    let acceleration = acceleration(&tension);
    (tension, acceleration)
}

/// The next change: the stuck contact furthest beyond its bound, else the sliding one that goes the wrong way.
fn change<F: Float>(
    contacts: &[Contact<F>],
    choices: &[Choice],
    tension: &[F],
    acceleration: &[F],
    first: bool,
) -> Option<(usize, Choice)> {
    let mut worst: Option<(F, usize, Choice)> = None;
    let all = contacts.iter().zip(choices).zip(tension.iter().zip(acceleration)).enumerate();
    for (i, ((contact, choice), (&tension, &acceleration))) in all {
        let own = contact.doubt;
        let (excess, next) = match *choice {
            None => {
                // The doubt of a₀ is one of T by about the same factor that leads from a₀ to T.
                let doubt = if contact.acceleration.abs() > own {
                    (tension / contact.acceleration).abs() * own
                } else {
                    contact.bound * F::epsilon() * F::int(256)
                };
                let over = tension.abs()
                    - contact.bound
                    - doubt.or_larger(contact.bound * F::epsilon() * F::int(64));
                let relative = if contact.bound > F::int(0) { over / contact.bound } else { over };
                (relative, Some(tension > F::int(0)))
            }
            Some(forward) => (-sign::<F>(forward) * acceleration - own, None),
        };
        if excess > F::int(0) {
            if first {
                return Some((i, next));
            }
            // Releases come before returns.
            let better = worst.is_none_or(|(most, _, kind)| {
                (next.is_some() && kind.is_none()) || (next.is_some() == kind.is_some() && excess > most)
            });
            if better {
                worst = Some((excess, i, next));
            }
        }
    }
    worst.map(|(_, i, next)| (i, next))
}

/// The consistent choice with the most stuck contacts, among all of them; none for more than eight.
fn exhaustive<F: Float>(system: &Assembly<F>, contacts: &[Contact<F>]) -> Option<Vec<Choice>> {
    let count = u32::try_from(contacts.len()).ok().filter(|&n| n <= 8)?;
    let mut best: Option<Vec<Choice>> = None;
    for code in 0..3_u32.pow(count) {
        let choices: Vec<Choice> = (0..count)
            .map(|i| match code / 3_u32.pow(i) % 3 {
                0 => None,
                1 => Some(true),
                _ => Some(false),
            })
            .collect();
        let stuck = |c: &[Choice]| c.iter().filter(|c| c.is_none()).count();
        if best.as_ref().is_some_and(|b| stuck(b) >= stuck(&choices)) {
            continue;
        }
        let (tension, acceleration) = balance(system, contacts, &choices);
        if change(contacts, &choices, &tension, &acceleration, true).is_none() {
            best = Some(choices);
        }
    }
    best
}

/// Whether an element cannot move while others stick: its direction is a combination of theirs.
pub(crate) fn depends<F: Float>(system: &Assembly<F>, element: usize, stuck: &[usize]) -> bool {
    let mut matrix = Matrix::zero(stuck.len(), stuck.len());
    for (a, &i) in stuck.iter().enumerate() {
        stuck.iter().enumerate().for_each(|(b, &j)| matrix.set(a, b, system.coupling.at(i, j)));
    }
    let row: Vec<F> = stuck.iter().map(|&i| system.coupling.at(element, i)).collect();
    let own = system.coupling.at(element, element);
    !stuck.is_empty()
        && own - dot(&row, &matrix.pseudo_inverse().of(&row)) <= own * F::epsilon() * F::int(4096)
}

/// Takes the velocities of these elements out of the state, by the impulse of least energy.
pub(crate) fn at_rest<F: Float>(system: &Assembly<F>, z: &mut [F], elements: &[usize]) {
    if elements.is_empty() {
        return;
    }
    let parts: Vec<_> = elements.iter().filter_map(|&i| system.parts.get(i)).collect();
    let mut matrix = Matrix::zero(parts.len(), parts.len());
    for (a, &i) in elements.iter().enumerate() {
        elements.iter().enumerate().for_each(|(b, &j)| matrix.set(a, b, system.coupling.at(i, j)));
    }
    let velocity: Vec<F> = parts.iter().map(|p| dot(&p.velocity, z)).collect();
    if velocity.iter().all(|&v| v == F::int(0)) {
        return;
    }
    let impulse = matrix.pseudo_inverse().of(&velocity);
    let n = system.n;
    for (part, &impulse) in parts.iter().zip(&impulse) {
        add_times(z.get_mut(n..2 * n).unwrap_or(&mut []), -impulse, &part.response);
    }
}
