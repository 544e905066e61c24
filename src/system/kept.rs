//! What a contact at rest keeps: computed from where it came to rest, so that rounding does not add up over the steps.
//!
//! A contact that sticks keeps its stretch, y = y₀. An elastic contact that holds has the force `T = T₀ + k (y − y₀)`, so that
//! T − k y is kept. A motion that is integrated for millions of steps moves away from both by the rounding of each step.

use super::assembly::{Assembly, Rule};
use super::branch::Branch;
use super::matrix::{add_times, dot};
use super::mode::{Mode, places};
use super::next_branch::at_rest;
use crate::float::Float;
use alloc::vec::Vec;

/// After so many steps the state is brought back to what is kept. Rounding of fewer steps is below what is printed.
const STEPS: u32 = 128;

/// The kept numbers of all elements: y₀ of a contact that sticks or of a stop that gives no way, T − k y of an elastic contact that holds.
#[derive(Debug, Clone)]
pub(crate) struct Kept<F> {
    numbers: Vec<Option<F>>,
    steps: u32,
}

impl<F: Float> Kept<F> {
    /// Nothing yet.
    pub(crate) const fn new() -> Self {
        Self { numbers: Vec::new(), steps: 0 }
    }

    /// Forgets all.
    pub(crate) fn clear(&mut self) {
        self.numbers.clear();
    }

    /// Takes over what begins to be kept in a branch at this state.
    pub(crate) fn renew(&mut self, system: &Assembly<F>, branch: Option<&Branch<F>>, z: &[F]) {
        let Some(branch) = branch else { return };
        self.numbers.resize(system.parts.len(), None);
        for ((number, part), mode) in self.numbers.iter_mut().zip(&system.parts).zip(&branch.modes) {
            *number = match (mode, &part.rule, &part.stretch) {
                (Mode::Stuck | Mode::Resting, _, Some(stretch)) => number.or_else(|| Some(dot(stretch, z))),
                (Mode::Holds, Rule::Elastic { stiffness, place, .. }, Some(stretch)) => {
                    number.or_else(|| {
                        let force = z.get(*place).copied()?;
                        Some(force - *stiffness * dot(stretch, z))
                    })
                }
                _ => None,
            };
        }
    }

    /// Forgets displacements that have been shifted, in the branch at this state.
    pub(crate) fn shifted(&mut self, system: &Assembly<F>, branch: Option<&Branch<F>>, z: &[F]) {
        self.clear();
        self.renew(system, branch, z);
    }

    /// Counts a step, and brings the state back to what is kept where there have been many.
    #[inline]
    pub(crate) fn hold(&mut self, system: &Assembly<F>, branch: &Branch<F>, z: &mut [F]) {
        self.steps += 1;
        if self.steps >= STEPS {
            self.steps = 0;
            self.restore(system, branch, z);
        }
    }

    /// Brings the state back to what is kept.
    pub(crate) fn restore(&self, system: &Assembly<F>, branch: &Branch<F>, z: &mut [F]) {
        let n = system.n;
        let stuck = places(&branch.modes, Mode::is_held);
        match &branch.tie {
            Some(tie) => tie.project(system, &branch.modes, z),
            None => at_rest(system, z, &stuck),
        }
        let mut apart = Vec::new();
        let mut held = Vec::new();
        for i in stuck {
            if let (Some(part), Some(Some(number))) = (system.parts.get(i), self.numbers.get(i))
                && let Some(stretch) = part.stretch.as_ref().filter(|_| !system.is_light(part))
            {
                apart.push(dot(stretch, z) - *number);
                held.push(i);
            }
        }
        if apart.iter().any(|x| *x != F::int(0)) {
            let shares = system.coupling_of(&held).pseudo_inverse().of(&apart);
            for (&i, &share) in held.iter().zip(&shares) {
                if let Some(part) = system.parts.get(i) {
                    add_times(z.get_mut(..n).unwrap_or(&mut []), -share, &part.response);
                }
            }
        }
        for (part, number) in system.parts.iter().zip(&self.numbers) {
            if let (Rule::Elastic { stiffness, place, .. }, Some(number), Some(stretch)) =
                (&part.rule, number, &part.stretch)
            {
                let force = *number + *stiffness * dot(stretch, z);
                if let Some(place) = z.get_mut(*place) {
                    *place = force;
                }
            }
        }
    }
}
