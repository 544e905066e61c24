//! Systems in which no two motions move apart, and what this says of the limit of a start.
//!
//! Let δ be the difference of two motions under the same loads, and
//! `E = ½ δv·M δv + ½ δq·K δq + Σ δT²/(2k)` its energy, summed over the elastic contacts with their springs k. Where K is symmetric and positive
//! definite, the symmetric part of C is not negative, and each friction rises with its velocity or is constant, and depends on time besides alone,
//!
//! `E′ = −δv·C δv − Σ δT δw ≤ 0`:
//!
//! w is the velocity along a contact, or that of the slider of an elastic contact, and δT δw ≥ 0, since a friction that rises, sticks between its bounds and
//! slides at them is a monotone graph. So no map P over a period increases the energy of a difference.
//!
//! **Without kept numbers.** Let x be a fixed point of P with multipliers below 1 alone. The motions that go to x form an open set, as they end near x.
//! It is closed, too: where motions that go to x begin as near to z as one likes, that of z comes as near to x as one likes, and so near that it goes
//! there. Every start is in it. The multipliers must be those of all motions near x: where an element only just begins to slide, the motions in which it
//! does not may have fixed points of their own. So the derivative of P is compared with the map of a small disturbance of x, forth and back.
//!
//! **With kept numbers.** An elastic contact that holds for the whole period of x has a least distance m of its force from its friction. Within
//! `E < m²/(2k)` of x it holds for ever. In this ball, and with the kept numbers of z, which x has, the argument is as before.

use super::assembly::{Assembly, Rule};
use super::calm::{Margins, is_dissipative, is_symmetric, symmetric_part, without_moved};
use super::matrix::{at, dot};
use crate::float::Float;

/// Whether no two motions of a system move apart.
pub(super) fn is_monotone<F: Float>(system: &Assembly<F>) -> bool {
    let is_given = |row: &[F]| row.iter().take(system.free).all(|&x| x == F::int(0));
    let rises = |rule: &Rule<F>| match rule {
        Rule::Contact { pieces, peak, normal } => {
            pieces.iter().all(|piece| piece.slope >= F::int(0))
                && *peak == F::int(1)
                && normal.as_deref().is_none_or(is_given)
        }
        Rule::Elastic { bound, normal, .. } => is_given(bound) && normal.as_deref().is_none_or(is_given),
        Rule::Stop { .. } | Rule::Hard { .. } | Rule::Spring { .. } => false,
    };
    system.massless.is_empty()
        && system.parts.iter().all(|part| part.under.is_none() && rises(&part.rule))
        && is_symmetric(&system.stiffness)
        && is_dissipative(&without_moved(system, &symmetric_part(&system.damping)))
        && without_moved(system, &system.stiffness).cholesky(F::epsilon()).is_ok()
}

/// The energy of a difference of two states.
pub(super) fn energy_of<F: Float>(system: &Assembly<F>, delta: &[F]) -> F {
    let n = system.n;
    let [q, v] = [0, n].map(|from| delta.get(from..from + n).unwrap_or(&[]));
    let springs = system.parts.iter().fold(F::int(0), |sum, part| match &part.rule {
        Rule::Elastic { stiffness, place, .. } => sum + at(delta, *place).square() / *stiffness,
        Rule::Contact { .. } | Rule::Stop { .. } | Rule::Hard { .. } | Rule::Spring { .. } => sum,
    });
    (dot(v, &system.mass.of(v)) + dot(q, &system.stiffness.of(q)) + springs) / F::int(2)
}

/// The energy of a difference below which these silent elements stay silent, where all of them are elastic.
pub(super) fn energy_of_silence<F: Float>(
    system: &Assembly<F>,
    silent: &[usize],
    margins: &Margins<F>,
) -> Option<F> {
    let mut least: Option<F> = None;
    for &i in silent {
        let Some(Rule::Elastic { stiffness, .. }) = system.parts.get(i).map(|part| &part.rule) else {
            return None;
        };
        for &(_, _, margin) in margins.least.iter().filter(|(_, element, _)| *element == i) {
            // A quarter of it, for rounding.
            let energy = margin.square() / (*stiffness * F::int(8));
            let energy = if margin > F::int(0) { energy } else { F::int(0) };
            least = Some(least.map_or(energy, |least| if energy < least { energy } else { least }));
        }
    }
    least
}
