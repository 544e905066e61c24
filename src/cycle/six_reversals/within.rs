//! Whether the six-reversal cycle exists: at a point, and over intervals of Ω and α for all of them or for none.
//!
//! Every line of constant Ω, and every line of constant α, meets the region near a pole in one interval, so
//! that the region contains a box if it contains its corners. On one side of the pole the greatest α
//! increases towards the pole, and the least is monotone on each of the two edges that it consists of. Both
//! are observed on the curves themselves, not proved.

use super::edges::{Edges, edges};
use super::is_strong_enough;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;
use crate::machine::ratios::Ratios;

/// The statement that holds over a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Within {
    /// The cycle exists for all.
    All,
    /// For none.
    None,
    /// For some, or it is too close to tell.
    Some,
}

/// At one point; [`Within::Some`] within the error of an edge.
pub(crate) fn within<F: Float>(ratios: &Ratios<F>) -> Within {
    within_edges(super::force_ratios(ratios), ratios.alpha())
}

/// At an α with these edges.
pub(crate) fn within_edges<F: Float>(edges: Option<(F, F)>, alpha: F) -> Within {
    edges.map_or(Within::None, |(low, high)| compared((low, low), (high, high), (alpha, alpha)))
}

/// Of α, the least and the greatest force ratio, each (low, high).
fn compared<F: Float>(low: (F, F), high: (F, F), alpha: (F, F)) -> Within {
    let (one, error) = (F::int(1), F::int(EDGE_ERROR) * F::epsilon());
    if alpha.0 > low.1 * (one + error) && alpha.1 < high.0 * (one - error) {
        Within::All
    } else if alpha.1 < low.0 * (one - error) || alpha.0 > high.1 * (one + error) {
        Within::None
    } else {
        Within::Some
    }
}

/// Over `omega` × `alpha`, each (low, high), without a damper and with one friction.
pub(crate) fn within_box<F: Float>(omega: (F, F), alpha: (F, F)) -> Within {
    if !is_strong_enough(omega.1, alpha.1) || omega.0 * F::int(2) >= F::int(1) || !meets_a_pole(omega) {
        return Within::None;
    }
    let at = |omega: F| {
        let is_above = PhaseFunction::of_valid(omega).tangent() > F::int(0);
        (edges(omega, F::int(0), F::int(1)), is_above)
    };
    let ((left, left_side), (right, right_side)) = (at(omega.0), at(omega.1));
    // Between two neighbouring integers 1/Ω: the box is on one side of one pole, to which the region extends.
    // If both ends are outside the region, so is all between them.
    let is_one_side = left_side == right_side && omega.1 - omega.0 < omega.0.square();
    match (left, right) {
        (None, None) if omega.0 == omega.1 || is_one_side => Within::None,
        (Some(left), Some(right)) => between(&left, &right, alpha, is_one_side),
        (None | Some(_), None) | (None, Some(_)) => Within::Some,
    }
}

fn between<F: Float>(left: &Edges<F>, right: &Edges<F>, alpha: (F, F), is_one_side: bool) -> Within {
    let ordered = |a: F, b: F| if a < b { (a, b) } else { (b, a) };
    let found = compared(ordered(left.low, right.low), ordered(left.high, right.high), alpha);
    let is_one_curve = is_one_side && left.least == right.least;
    if found == Within::None && !is_one_curve { Within::Some } else { found }
}

/// Relative error bound of the edges, in units of [`Float::epsilon`].
const EDGE_ERROR: i32 = 64;

/// Whether 1/Ω comes within reach of an odd integer, 3 or more: 0.0213 below and 0.0375 above it.
///
/// Ω and 1/Ω are rounded by half a unit in the last place each, which is more than that reach from 2⁴⁷ on.
fn meets_a_pole<F: Float>((low, high): (F, F)) -> bool {
    let rounding = 2.0 * f64::EPSILON;
    let from = 1.0 / high.to_f64() * (1.0 - rounding) - 0.0375;
    let to = 1.0 / low.to_f64() * (1.0 + rounding) + 0.0213;
    let last = 2.0 * ((to - 1.0) / 2.0).floor() + 1.0;
    last >= 3.0 && last >= from
}
