//! The periodic motion by Newton's method on the half-turn map.
//!
//! `H` takes the state (x, w) at a phase θ₀ half a turn of the drive on and turns it upside down: a symmetric motion is a
//! fixed point of H, with `H′ = −M`, M the monodromy of the half turn. A Newton step is `(1 + M)⁻¹ (H(y) − y)`.
//!
//! # Why this finds the limit of every motion
//!
//! Friction is monotone: of two motions under the same drive, `d/dφ ½(δx² + δw²) = −(r₁ − r₂) δw ≤ 0`. So
//!
//! * H never increases the distance `hypot(δx, δw)`; in particular the residual |H(y) − y| never grows from one half turn to
//!   the next. A Newton step is kept where it halves the residual, and otherwise the motion is simply followed on.
//! * Two periodic motions keep their distance for ever. If the multipliers of one are inside the unit circle it attracts a
//!   neighbourhood, and then everything: **there is one limit only, and it is symmetric**, because a motion turned upside
//!   down half a turn later is a motion, too. More than one limit needs a difference that is itself an undamped free
//!   vibration of the drive's period: Ω = 1/n.

use super::matrix::Matrix;
use super::slide::Equation;
use super::walk::{Part, Point, Walk, walk};
use crate::float::Float;

/// A fixed point of the half-turn map, with the walk of half a turn from it.
#[derive(Debug)]
pub(crate) struct Fixed<F> {
    pub(crate) start: Point<F>,
    pub(crate) walk: Walk<F>,
    /// How far the motion found can be from the limit: `|(1 + M)⁻¹| (|H(y) − y| + rounding)`.
    pub(crate) distance: F,
}

/// What shooting ends with.
#[derive(Debug)]
pub(crate) enum Shot<F> {
    Settled(Fixed<F>),
    /// The budget is spent; the state reached and the residual there.
    Unsettled(Point<F>, F),
}

/// Half turns walked, counted over all attempts.
pub(crate) struct Budget {
    pub(crate) half_turns: u64,
    pub(crate) most: u64,
}

/// What rounding leaves of H(y) − y: that of the state, and that of the phase divided by Ω.
pub(crate) fn rounding<F: Float>(equation: &Equation<F>, y: &Point<F>) -> F {
    let Equation { omega, alpha, .. } = *equation;
    let (one, size) = (F::int(1), y.x.abs() + y.w.abs());
    let gain = alpha * omega / (one + omega.square());
    let rates = y.w.abs() + y.x.abs() + one + alpha;
    let excursion = if omega > one { rates / omega } else { rates };
    F::int(2) * F::epsilon() * (size + gain + excursion / omega)
}

/// `H(y) − y`.
fn residual<F: Float>(y: &Point<F>, walk: &Walk<F>) -> (F, F) {
    (-walk.end.x - y.x, -walk.end.w - y.w)
}

/// Natural time from the start of a walk to its first velocity zero.
fn first_zero<F: Float>(walk: &Walk<F>, usual: F) -> F {
    match walk.parts.first() {
        Some(Part::Slide(_, zero)) => zero.phi,
        Some(Part::Onward(..) | Part::Stick(..)) | None => usual,
    }
}

/// Newton's method from a start; `hint` is the natural time to its first velocity zero.
pub(crate) fn shoot<F: Float>(
    equation: Equation<F>,
    start: Point<F>,
    hint: F,
    budget: &mut Budget,
) -> Shot<F> {
    let two = F::int(2);
    let mut best = walk(equation, start, 1, hint, Vec::new());
    let mut y = start;
    let mut norm = norm_of(residual(&y, &best));
    let mut spare = Vec::new();
    let mut follow = 1;
    budget.half_turns += 1;
    loop {
        let noise = rounding(&equation, &y);
        let inverse = best.monodromy.inverse_of_one_plus();
        if norm <= noise {
            return Shot::Settled(settled(y, best, inverse, norm, noise));
        }
        let (dx, dw) = inverse.times(residual(&y, &best));
        let trial = Point { x: y.x + dx, w: y.w + dw, ..y };
        let sound = dx.is_finite() && dw.is_finite();
        if sound {
            let tried = walk(equation, trial, 1, first_zero(&best, hint), spare);
            budget.half_turns += 1;
            let after = norm_of(residual(&trial, &tried));
            if after * two <= norm {
                (y, norm) = (trial, after);
                spare = core::mem::replace(&mut best, tried).parts;
                continue;
            }
            spare = tried.parts;
            // Rounding alone is left, a little more of it than expected.
            if norm <= noise * F::int(64) {
                return Shot::Settled(settled(y, best, inverse, norm, noise));
            }
        }
        // The motion itself, for a while: each half turn brings it closer, and in the end into Newton's reach.
        for _ in 0..follow {
            y = Point { phase: y.phase, x: -best.end.x, w: -best.end.w };
            let hint = first_zero(&best, hint);
            let next = walk(equation, y, 1, hint, spare);
            spare = core::mem::replace(&mut best, next).parts;
            budget.half_turns += 1;
        }
        norm = norm_of(residual(&y, &best));
        follow = if follow < LONGEST_FOLLOW { follow * 2 } else { follow };
        if budget.half_turns > budget.most {
            return Shot::Unsettled(y, norm);
        }
    }
}

const LONGEST_FOLLOW: u32 = 64;

fn norm_of<F: Float>((x, w): (F, F)) -> F {
    x.hypot(w)
}

fn settled<F: Float>(start: Point<F>, walk: Walk<F>, inverse: Matrix<F>, norm: F, noise: F) -> Fixed<F> {
    let rounding = if norm > noise { norm } else { noise };
    Fixed { start, walk, distance: inverse.norm() * (norm + rounding) }
}
