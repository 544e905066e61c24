//! Newton's method on the matching problem of six reversals.

use super::equations::Unknowns;
use super::linear::solve;
use crate::float::Float;

/// A solution from a start that is close to it; `None` where the steps do not come down to rounding.
///
/// Each step doubles the correct digits. The steps are judged by the changes of c and s, which determine α:
/// near a pole the upper edge has a short arc, which is less accurate and matters correspondingly less for α.
/// `residuals` gives the left sides minus the right sides of the five equations, and their derivatives.
#[inline]
pub(super) fn polished<F: Float>(
    omega: F,
    start: Unknowns<F>,
    residuals: impl Fn(&Unknowns<F>) -> ([F; 5], [[F; 5]; 5]),
) -> Option<Unknowns<F>> {
    let mut y = start;
    let mut last = None;
    for _ in 0..F::PRECISION.ilog2() + 16 {
        let (values, rows) = residuals(&y);
        let step = solve(rows, values)?;
        let next = y.to_array().into_iter().zip(step).map(|(x, d)| x - d);
        let mut moved = y.to_array();
        moved.iter_mut().zip(next).for_each(|(x, new)| *x = new);
        let after = Unknowns::of_array(moved);
        let size = (after.sine - y.sine).hypot(after.cosine - y.cosine) / after.cosine.abs();
        let limit = omega + F::int(3);
        let inside = |x: F| x > F::int(0) && x < limit;
        if !(inside(after.before) && inside(after.after) && after.cosine > F::int(0)) {
            return None;
        }
        y = after;
        // Below the root of rounding the next step is below rounding; from there on a step that does not
        // shrink is noise.
        let is_noise = last.is_some_and(|last: F| last.square() < F::epsilon() && size * F::int(2) >= last);
        if size <= F::epsilon() || is_noise {
            return Some(y);
        }
        last = Some(size);
    }
    None
}
