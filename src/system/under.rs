//! Friction under the force of a stop that gives no way.
//!
//! **In touch.** The force λ ≥ 0 of the stop is a row over the state, by which the friction `T = s µ λ` is linear as under any normal load. It is open where the stop is.
//! Here λ does not depend on T: no contact or stop joins both through M⁻¹. Hence λ is that of the branch without such contacts, there is one
//! motion, and nothing jams.
//!
//! **In a blow** the force of the stop is a pulse of the area P. Across it nothing else is as great as the friction under the pulse, so that
//! `Δv = −b·M⁻¹b Q`, where Q is the impulse of `|T| ≤ µ λ` that opposes v as long as there is one. Whatever the shape of the pulse, its end is
//! `Q = v/(b·M⁻¹b)` within `|Q| ≤ µ P`: Coulomb's law holds for impulses. Static friction has no part, because nothing pulls what has stopped.
//! Several contacts at one body share in it as forces do, by the least value of `½ Qᵀ G Q − vᵀ Q` in the box.

use super::assembly::{Assembly, Rule};
use super::dependent::{least, rank};
use super::equation::Equation;
use super::error::Error;
use super::matrix::{Matrix, add_times, dot, size_of_dot};
use super::mode::Mode;
use crate::float::Float;
use alloc::borrow::Cow;
use alloc::vec;
use alloc::vec::Vec;

impl<F: Float> Assembly<F> {
    /// The contacts under stops that give no way, each with its stop.
    pub(crate) fn under_stops(&self) -> impl Iterator<Item = (usize, usize)> {
        self.parts.iter().enumerate().filter_map(|(i, part)| Some((i, part.under?)))
    }

    /// Refuses friction on which the force of its stop depends.
    pub(super) fn check_under(&self) -> Result<(), Error> {
        let unsupported = |i: usize, condition| {
            Err(Error::Unsupported {
                name: self.parts.get(i).map_or_else(Default::default, |p| p.name.clone()),
                condition,
            })
        };
        let is_stop = |i: usize| matches!(self.parts.get(i).map(|part| &part.rule), Some(Rule::Hard { .. }));
        for (i, stop) in self.under_stops() {
            if !is_stop(stop) {
                return unsupported(
                    i,
                    "must be under the force of a stop with a restitution, by its place among the elements",
                );
            }
            let mut joined = vec![i];
            let mut next = 0;
            while let Some(&from) = joined.get(next) {
                next += 1;
                let more =
                    (0..self.parts.len()).filter(|to| self.is_joined(from, *to) && !joined.contains(to));
                let more: Vec<usize> = more.collect();
                joined.extend(more);
            }
            if self.under_stops().any(|(_, stop)| joined.contains(&stop)) {
                return unsupported(
                    i,
                    "must be across the stop that presses on it, without a contact, another stop or an entry of the mass matrix that \
                     joins both: the force of the stop would depend on the friction. Give the stop a stiffness",
                );
            }
        }
        // Such as a guide along the fall of a block: how much of a load either of them takes is not determined at rest.
        let contacts = || self.parts.iter().filter(|part| matches!(part.rule, Rule::Contact { .. }));
        let contacts: Vec<&[F]> = contacts().map(|part| part.direction.as_slice()).collect();
        for (i, stop) in self.under_stops() {
            let direction = self.parts.get(stop).map(|part| part.direction.as_slice());
            let all: Vec<&[F]> = contacts.iter().copied().chain(direction).collect();
            if rank(&all) == rank(&contacts) {
                return unsupported(
                    i,
                    "must be under a stop whose force the motion determines, without a contact along its direction, or contacts along a sum \
                     that has it: these share the force. Give the stop a stiffness",
                );
            }
        }
        Ok(())
    }

    /// Whether the force of one of two elements that hold depends on that of the other one.
    fn is_joined(&self, i: usize, j: usize) -> bool {
        let holds = |i: usize| self.parts.get(i).is_some_and(super::assembly::Part::may_hold);
        let sizes = self.coupling.at(i, i) * self.coupling.at(j, j);
        holds(i) && holds(j) && self.coupling.at(i, j).abs() > sizes.sqrt() * F::epsilon() * F::int(64)
    }
}

/// The system with the normal loads of the contacts under stops as rows, where other elements have these modes.
pub(crate) fn loaded<'a, F: Float>(system: &'a Assembly<F>, modes: &[Mode]) -> Cow<'a, Assembly<F>> {
    let in_touch = |stop: usize| modes.get(stop) == Some(&Mode::Resting);
    if !system.under_stops().any(|(_, stop)| in_touch(stop)) {
        return Cow::Borrowed(system);
    }
    let mut open = modes.to_vec();
    for (i, _) in system.under_stops() {
        open.get_mut(i).into_iter().for_each(|mode| *mode = Mode::Apart);
    }
    let forces = Equation::new(system, &open).tension;
    let mut loaded = system.clone();
    for part in &mut loaded.parts {
        if let (Some(stop), Rule::Contact { normal, .. }) = (part.under, &mut part.rule)
            && in_touch(stop)
        {
            *normal = forces.get(stop).cloned();
        }
    }
    Cow::Owned(loaded)
}

/// A friction's impulse under a blow.
pub(crate) struct Rub<F> {
    pub(crate) element: usize,
    /// Q.
    pub(crate) impulse: F,
    /// The stop of the blow.
    stop: usize,
    /// Q/P where it slides in one direction throughout; none where it comes to rest.
    slides: Option<F>,
}

/// A friction under a stop with an impulse.
struct Loaded<F> {
    element: usize,
    stop: usize,
    coefficient: F,
    /// µ P.
    most: F,
}

/// The impulses of the frictions under stops with these impulses, at a state whose velocities along the stops may have jumped already.
pub(crate) fn rubs<F: Float>(
    system: &Assembly<F>,
    z: &[F],
    stops: &[(usize, F)],
) -> Result<Vec<Rub<F>>, usize> {
    let mut loaded: Vec<Loaded<F>> = Vec::new();
    for (element, stop) in system.under_stops() {
        let normal = stops.iter().find(|one| one.0 == stop).map_or(F::int(0), |one| one.1);
        let rule = system.parts.get(element).map(|part| &part.rule);
        if let (true, Some(Rule::Contact { pieces, .. })) = (normal > F::int(0), rule) {
            let coefficient = pieces.first().map_or(F::int(0), |piece| piece.force);
            loaded.push(Loaded { element, stop, coefficient, most: coefficient * normal });
        }
    }
    let Some(first) = loaded.first().map(|one| one.element) else { return Ok(Vec::new()) };
    let places: Vec<usize> = loaded.iter().map(|one| one.element).collect();
    let parts = || places.iter().filter_map(|&i| system.parts.get(i));
    let velocity: Vec<F> = parts().map(|part| dot(&part.velocity, z)).collect();
    let doubt: Vec<F> =
        parts().map(|part| size_of_dot(&part.velocity, z) * F::epsilon() * F::int(256)).collect();
    let high: Vec<Option<F>> = loaded.iter().map(|one| Some(one.most)).collect();
    let low: Vec<Option<F>> = loaded.iter().map(|one| Some(-one.most)).collect();
    let impulses = least(&system.coupling_of(&places), &velocity, &doubt, &low, &high).map_err(|_| first)?;
    let rub = |(one, &impulse): (&Loaded<F>, &F)| {
        let slides = (impulse.abs() >= one.most).then(|| one.coefficient.with_sign_of(impulse));
        Rub { element: one.element, impulse, stop: one.stop, slides }
    };
    Ok(loaded.iter().zip(&impulses).map(rub).collect())
}

/// The derivatives of velocities after the frictions of a blow: for each stop the change by its impulse, and for each friction that comes to rest
/// its element with the change by its velocity before.
pub(crate) struct Rubbed<F> {
    pub(crate) by_stop: Vec<(usize, Vec<F>)>,
    pub(crate) by_rest: Vec<(usize, Vec<F>)>,
}

pub(crate) fn rubbed<F: Float>(system: &Assembly<F>, rubs: &[Rub<F>]) -> Rubbed<F> {
    let rests: Vec<usize> = rubs.iter().filter(|rub| rub.slides.is_none()).map(|rub| rub.element).collect();
    let inverse =
        if rests.is_empty() { Matrix::zero(0, 0) } else { system.coupling_of(&rests).pseudo_inverse() };
    let response = |i: usize| system.parts.get(i).map_or(&[][..], |part| &part.response);
    // What comes to rest takes out what the others do to its velocity.
    let held = |along: &[F], to: &mut Vec<F>| {
        for (&rest, share) in rests.iter().zip(inverse.of(along)) {
            add_times(to, share, response(rest));
        }
    };
    let by_stop = rubs.iter().filter_map(|rub| {
        let ratio = rub.slides?;
        let mut by: Vec<F> = response(rub.element).iter().map(|&x| ratio * x).collect();
        let along: Vec<F> =
            rests.iter().map(|&rest| -ratio * system.coupling.at(rest, rub.element)).collect();
        held(&along, &mut by);
        Some((rub.stop, by))
    });
    let by_rest = rests.iter().enumerate().map(|(k, &rest)| {
        let mut by = vec![F::int(0); system.n];
        let along: Vec<F> = (0..rests.len()).map(|i| F::int(i32::from(i == k))).collect();
        held(&along, &mut by);
        (rest, by)
    });
    Rubbed { by_stop: by_stop.collect(), by_rest: by_rest.collect() }
}
