//! The limit with η = 1: Newton's method for a fixed point of H, half a turn of the drive with a change of
//! sign. A symmetric motion is such a fixed point.
//!
//! # Why this finds the limit of every motion
//!
//! Friction is monotone: of two motions under the same drive,
//! `d/dφ ½(δx² + δw²) = −(r₁ − r₂) δw − 2ζδw² ≤ 0`. So
//!
//! * H never increases the distance `hypot(δx, δw)`; in particular the residual |H(y) − y| never grows from
//!   one half turn to the next. A Newton step is kept where it halves the residual; otherwise the motion is
//!   followed.
//! * Two periodic motions keep their distance permanently. For α > 1 that leaves **one limit only, and it is
//!   symmetric**: proved in docs/development/theory/stability.md, with its exceptions, a family at Ω = 1/(2n) at the
//!   border and above, and Ω = 1 with α ≥ 4/π. With damping there are no exceptions: a constant distance has
//!   δw = 0, and of two bodies at a distance that slide alike one would have another friction. For α ≤ 1 the
//!   limit is rest, anywhere in an interval (`rest`), and shooting is not used.
//! * So a fixed point of H, however found, is the limit of every start. This does not require multipliers
//!   inside the unit circle, but they give the speed of the approach; near 1/(2n) one of them rounds to 1, and
//!   the closed-form cycle is taken where its residual is rounding.

use super::fixed_point::{Trial, rate_noise};
use super::long_run::{LongRun, unsettled};
use super::propagation::HalfTurns;
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;

/// A second start for the shooting method.
pub(crate) struct Guess<F> {
    pub(crate) at: PhasePoint<F>,
    /// The natural time from the start to its first velocity zero.
    pub(crate) hint: F,
    /// Whether the start is known to be the limit of every motion, to within rounding: the closed-form cycle,
    /// if it does not stick and is not large compared with the force.
    pub(crate) is_limit: bool,
}

/// The limit by Newton's method from a start; `hint` is the natural time from the start to the first velocity zero.
///
/// `guess` is a second start, for when Newton's step from the first fails. It needs no justification: its
/// residual decides, and any fixed point is the limit of every start.
///
/// # Errors
/// As for [`HalfTurns::new`].
pub(crate) fn shoot<F: Float>(
    equation: Equation<F>,
    start: PhasePoint<F>,
    hint: F,
    guess: impl FnOnce() -> Result<Option<Guess<F>>, Broken>,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Broken> {
    let mut guess = Some(guess);
    let mut best = Trial::of(HalfTurns::new(equation, start, 1, hint, budget)?);
    let mut follow = 1;
    loop {
        let left = best.left;
        if budget.half_turns > budget.most {
            return Ok(unsettled(&equation, &best.motion.start, left.norm(), budget));
        }
        // A residual of the size of rounding is not sufficient where a disturbance hardly decays: the bound
        // on the distance decides.
        let known = best.is_known();
        if left.is_rounding(1) && known {
            return best.steady(budget).map(LongRun::Periodic);
        }
        if let Some((dx, dw)) = best.step(1) {
            let y = best.motion.start;
            let there = PhasePoint { x: y.x + dx, w: y.w + dw, ..y };
            let tried = Trial::of(best.motion.moved_to(there, (dx, dw), budget)?);
            let after = tried.left;
            // Where the rounding of w exceeds all of x, the norm does not show that x has settled.
            let is_less = after.norm() * F::int(2) <= left.norm() && !left.is_rounding(1);
            let is_settled = after.is_rounding(16) && !left.is_rounding(64) && after.is_as_fine_as(&left);
            if is_less || is_settled {
                best = tried;
                continue;
            }
            // The residual is rounding, slightly more than expected.
            if left.is_rounding(64) && known {
                return best.steady(budget).map(LongRun::Periodic);
            }
        }
        let other = guess.take().map_or(Ok(None), |guess| guess())?;
        if let Some(Guess { at, hint, is_limit }) = other {
            let tried = Trial::of(HalfTurns::new(equation, at, 1, hint, budget)?);
            let after = tried.left;
            // Near 1/(2n) no residual distinguishes the limit from its neighbours; a proof does.
            let decay = F::int(1) - tried.motion.derivative.determinant().abs();
            let proved = is_limit && decay > rate_noise(tried.motion.count) && after.is_rounding(4);
            if proved && !tried.is_known() {
                return tried.motion.steady(after.bounds(), budget).map(LongRun::Periodic);
            }
            if after.norm() < left.norm() || after.is_rounding(1) || !known {
                best = tried;
                continue;
            }
        }
        // The motion is followed for a while: each half turn brings it closer to the limit, and finally into
        // the range of Newton's method.
        let mut motion = best.motion;
        for _ in 0..follow {
            let HalfTurns { start, end, .. } = motion;
            motion = motion.moved_to(end, (end.x - start.x, end.w - start.w), budget)?;
        }
        best = Trial::of(motion);
        follow = if follow < LONGEST_FOLLOW { follow.saturating_mul(2) } else { follow };
    }
}

const LONGEST_FOLLOW: u32 = 64;
