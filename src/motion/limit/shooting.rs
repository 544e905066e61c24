//! The periodic motion by Newton's method on the half-turn map.
//!
//! `H` advances the state (x, w) at a phase θ₀ by half a turn of the drive and changes its sign: a symmetric
//! motion is a fixed point of H, with `H′ = −M`, M the monodromy of the half turn. A Newton step is
//! `(1 + M)⁻¹ (H(y) − y)`.
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
//!   symmetric**: proved in docs/theory/stability.md, with its exceptions, a family at Ω = 1/(2n) at the
//!   border and above, and Ω = 1 with α ≥ 4/π. With damping there are no exceptions: a constant distance has
//!   δw = 0, and of two bodies at a distance that slide alike one would have another friction. For α ≤ 1 the
//!   limit is rest, anywhere in an interval (`rest`), and shooting is not used.
//! * So a fixed point of H, however found, is the limit of every start. This does not require multipliers
//!   inside the unit circle, but they give the speed of the approach; near 1/(2n) one of them rounds to 1, and
//!   the closed-form cycle is taken where its residual is rounding.

use super::matrix::Matrix;
use super::propagation::{MotionPart, Propagation, propagate};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::state::Point;

/// A fixed point of the half-turn map, with the propagation of half a turn from it.
#[derive(Debug)]
pub(crate) struct Fixed<F> {
    pub(crate) start: Point<F>,
    pub(crate) propagation: Propagation<F>,
    /// The possible distance of (x, w) at the start from the limit: `|(1 + M)⁻¹| (|H(y) − y| + rounding)`,
    /// entry by entry.
    pub(crate) distance: (F, F),
}

/// The result of shooting.
#[derive(Debug)]
pub(crate) enum Shot<F> {
    Settled(Fixed<F>),
    /// The budget is spent; the state at the end and its residual.
    Unsettled(Point<F>, F),
}

/// The residual `H(y) − y`, and its rounding error where it is zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Residual<F> {
    pub(crate) x: F,
    pub(crate) w: F,
    noise_x: F,
    noise_w: F,
}

impl<F: Float> Residual<F> {
    /// The residual (x, w) from y, with the rounding of the terms of x and w (two units each) and of the
    /// phase: half a unit of θ moves x by w/Ω and w by w′/Ω.
    pub(crate) fn new(equation: &Equation<F>, y: &Point<F>, (x, w): (F, F)) -> Self {
        let Equation { omega, alpha, damping, .. } = *equation;
        let (one, unit) = (F::int(1), F::int(4) * F::epsilon());
        let forced = alpha / (one + omega.square());
        let rate = (one + alpha + y.x.abs() + damping * y.w.abs()) / omega;
        Self {
            x,
            w,
            noise_x: unit * (y.x.abs() + forced + y.w.abs() / omega),
            noise_w: unit * (y.w.abs() + forced * omega + rate),
        }
    }

    /// This residual with the rounding of `count` half turns.
    pub(crate) fn of_half_turns(self, count: u64) -> Self {
        let count = F::from_f64(count as f64);
        Self { noise_x: count * self.noise_x, noise_w: count * self.noise_w, ..self }
    }

    /// The norm of the residual, a distance that the motion never increases.
    pub(crate) fn norm(&self) -> F {
        self.x.hypot(self.w)
    }

    /// Whether the residual is at most `times` times its rounding.
    pub(crate) fn is_rounding(&self, times: i32) -> bool {
        let times = F::int(times);
        self.x.abs() <= times * self.noise_x && self.w.abs() <= times * self.noise_w
    }

    /// Whether the rounding of this residual is at most four times that of the other one: at large
    /// displacements rounding hides any residual.
    fn is_as_fine_as(&self, other: &Self) -> bool {
        let four = F::int(4);
        self.noise_x <= four * other.noise_x && self.noise_w <= four * other.noise_w
    }

    /// The norm of the residual plus the norm of its rounding.
    pub(crate) fn bound(&self) -> F {
        self.norm() + self.noise_x.hypot(self.noise_w)
    }

    /// Bounds on x and w of the residual, rounding included.
    pub(crate) fn bounds(&self) -> (F, F) {
        (self.x.abs() + self.noise_x, self.w.abs() + self.noise_w)
    }
}

fn residual<F: Float>(equation: &Equation<F>, y: &Point<F>, propagation: &Propagation<F>) -> Residual<F> {
    Residual::new(equation, y, (-propagation.end.x - y.x, -propagation.end.w - y.w))
}

/// The expected natural time to the first velocity zero from a point that differs by (δx, δw) from the start
/// of `propagation`.
fn first_zero<F: Float>(propagation: &Propagation<F>, usual: F, change: (F, F)) -> F {
    match propagation.parts.first() {
        Some(MotionPart::Slide(slide, zero)) => zero.expected(change, slide.equation.damping),
        Some(MotionPart::Onward(..) | MotionPart::Stick(..)) | None => usual,
    }
}

/// A second start for the shooting method.
pub(crate) struct Guess<F> {
    pub(crate) at: Point<F>,
    /// The natural time from the start to its first velocity zero.
    pub(crate) hint: F,
    /// Whether the start is known to be the limit of every motion, to within rounding: the closed-form cycle,
    /// if it does not stick and is not large compared with the force.
    pub(crate) is_limit: bool,
}

/// The rounding of the propagated disturbance after a number of parts of a motion, with a margin.
pub(crate) fn rate_noise<F: Float>(parts: u64) -> F {
    F::int(64) * F::epsilon() * F::from_f64(parts as f64 + 1.0)
}

/// Newton's method from a start; `hint` is the natural time from the start to the first velocity zero.
///
/// `guess` is a second start, for when Newton's step from the first fails. It needs no justification: its
/// residual decides, and any fixed point is the limit of every start.
///
/// # Errors
/// As for [`propagate`].
pub(crate) fn shoot<F: Float>(
    equation: Equation<F>,
    start: Point<F>,
    hint: F,
    guess: impl FnOnce() -> Result<Option<Guess<F>>, Broken>,
    budget: &mut Budget<'_>,
) -> Result<Shot<F>, Broken> {
    let two = F::int(2);
    let mut guess = Some(guess);
    let mut best = propagate(equation, start, 1, hint, Vec::with_capacity(4), budget)?;
    let mut y = start;
    let mut left = residual(&equation, &y, &best);
    let mut spare = Vec::new();
    let mut follow = 1;
    budget.spend(1);
    loop {
        let inverse = best.monodromy.inverse_of_one_plus();
        if budget.half_turns > budget.most {
            return Ok(Shot::Unsettled(y, left.norm()));
        }
        // A residual of the size of rounding is not sufficient where a disturbance hardly decays: the bound
        // on the distance decides.
        let known = is_known(&y, inverse, &left);
        if left.is_rounding(1) && known {
            return Ok(Shot::Settled(settled(y, best, inverse, &left)));
        }
        let (dx, dw) = inverse.times((left.x, left.w));
        let trial = Point { x: y.x + dx, w: y.w + dw, ..y };
        if dx.is_finite() && dw.is_finite() {
            let tried = propagate(equation, trial, 1, first_zero(&best, hint, (dx, dw)), spare, budget)?;
            budget.spend(1);
            let after = residual(&equation, &trial, &tried);
            // Where the rounding of w exceeds all of x, the norm does not show that x has settled.
            let is_less = after.norm() * two <= left.norm() && !left.is_rounding(1);
            let is_settled = after.is_rounding(16) && !left.is_rounding(64) && after.is_as_fine_as(&left);
            if is_less || is_settled {
                (y, left) = (trial, after);
                spare = core::mem::replace(&mut best, tried).parts;
                continue;
            }
            spare = tried.parts;
            // The residual is rounding, slightly more than expected.
            if left.is_rounding(64) && known {
                return Ok(Shot::Settled(settled(y, best, inverse, &left)));
            }
        }
        let other = guess.take().map_or(Ok(None), |guess| guess())?;
        if let Some(Guess { at: elsewhere, hint, is_limit }) = other {
            let tried = propagate(equation, elsewhere, 1, hint, spare, budget)?;
            budget.spend(1);
            let after = residual(&equation, &elsewhere, &tried);
            // Near 1/(2n) no residual distinguishes the limit from its neighbours; a proof does.
            let seen = F::int(1) - tried.monodromy.determinant().abs() > rate_noise(tried.count);
            let proved = is_limit && seen && after.is_rounding(4);
            if proved && !is_known(&elsewhere, tried.monodromy.inverse_of_one_plus(), &after) {
                return Ok(Shot::Settled(Fixed {
                    start: elsewhere,
                    propagation: tried,
                    distance: after.bounds(),
                }));
            }
            if after.norm() < left.norm() || after.is_rounding(1) || !known {
                (y, left) = (elsewhere, after);
                spare = core::mem::replace(&mut best, tried).parts;
                continue;
            }
            spare = tried.parts;
        }
        // The motion is followed for a while: each half turn brings it closer to the limit, and finally into
        // the range of Newton's method.
        for _ in 0..follow {
            let to = Point { phase: y.phase, x: -best.end.x, w: -best.end.w };
            let hint = first_zero(&best, hint, (to.x - y.x, to.w - y.w));
            y = to;
            let next = propagate(equation, y, 1, hint, spare, budget)?;
            spare = core::mem::replace(&mut best, next).parts;
            budget.spend(1);
        }
        left = residual(&equation, &y, &best);
        follow = if follow < LONGEST_FOLLOW { follow.saturating_mul(2) } else { follow };
        if budget.half_turns > budget.most {
            return Ok(Shot::Unsettled(y, left.norm()));
        }
    }
}

const LONGEST_FOLLOW: u32 = 64;

/// Whether the bound on the distance from the limit is small compared with the motion itself.
pub(crate) fn is_known<F: Float>(y: &Point<F>, inverse: Matrix<F>, left: &Residual<F>) -> bool {
    let (x, w) = inverse.absolute().times(left.bounds());
    let size = y.x.abs() + y.w.abs();
    F::int(16) * x <= size && F::int(16) * w <= size
}

fn settled<F: Float>(
    start: Point<F>,
    propagation: Propagation<F>,
    inverse: Matrix<F>,
    left: &Residual<F>,
) -> Fixed<F> {
    Fixed { start, propagation, distance: inverse.absolute().times(left.bounds()) }
}
