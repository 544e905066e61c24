//! The closed-form cycle without damping validated as a motion, from one slide.
//!
//! The rising half of the cycle begins at its minimum displacement, `(−Δ₀, 0)` at `θ₂ − π`, and is one slide
//! of natural length `π/Ω`. At its end the drive has turned by π, so that the angle of the drive needs no
//! circular function, and the free angle, `π/Ω = 2β`, is known from the cycle. On its way the slide passes
//! the section, the fastest point y at θ₁; half a turn from y leads to the velocity zero and back on the
//! mirrored slide. The difference between the end of that half turn and −y is a free vibration,
//!
//! ```text
//! H(y) − y = −R (δx, w w′₊/w′₋),     δx = x(π/Ω) − Δ₀,  w = w(π/Ω)
//! ```
//!
//! with w′₋ and w′₊ the accelerations before and after the reversal and R the rotation from θ₂ − π to θ₁: the
//! residual that `shooting` judges, together with its bound on the distance. The sign of the residual matters
//! to neither. The velocity zero is within rounding of π/Ω, because friction reverses with the velocity: `w′₋
//! = w′₊ − 2 < −2`.
//!
//! # Why no velocity zero is missed
//!
//! The speed f has `f″ + f = g ∝ cos θ` (`event`). Let the half turn begin where g ≥ 0, at f = 0 with f′ > 0,
//! and let g change its sign at φ = b. Then f > 0 for `0 < φ ≤ min(b, π)`; also for the time `atan2(f, f′)`
//! before the later point b; and on the last stretch, if it is not longer than π, because f is positive at
//! its beginning, and zero only at its end. For Ω ≥ 1 the whole slide is shorter than π, and f(b) is not
//! needed. In every other case the search of `velocity_zero` answers.
//!
//! The cycle proves that the maximum speed is at θ₁; the validation requires a zero acceleration there.

use super::fixed_point::{Residual, is_known};
use super::matrix::{Matrix, reversal_ratio};
use super::measures::{CycleStatistics, Extreme};
use super::steady::{SteadyParts, SteadyState};
use crate::cycle::Cycle;
use crate::float::Float;
use crate::motion::drive::DrivePhase;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::Motion;
use crate::motion::slide::stick::force_rounding;
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::Point;

/// The steady state of the cycle, if half a turn of the motion agrees with it to within rounding.
#[inline]
pub(crate) fn validated<F: Float>(equation: Equation<F>, cycle: &Cycle<F>) -> Option<SteadyState<F>> {
    let (zero, two) = (F::int(0), F::int(2));
    if equation.is_damped() {
        return None;
    }
    let omega = equation.omega;
    let origin = DrivePhase::of_half_turn(0, zero);
    let least = origin.advanced(cycle.displacement_phase).later_by_half_turns(-1);
    let slide = Slide::new(equation, least, -cycle.max_displacement, zero, Direction::Forward);
    if slide.acceleration <= equation.static_excess() + force_rounding(&equation, slide.x) {
        return None;
    }
    let arrival = slide.after_half_turn(cycle.sin_cos_beta());
    let reversal = reversal_ratio(slide.acceleration);
    let greatest = Extreme { value: arrival.x, phase: least.later_by_half_turns(1) };

    let fastest = origin.advanced(cycle.velocity_phase);
    // Each phase is reduced to one turn.
    let lag = fastest.since(least);
    let lag = if lag > F::pi() { lag - two * F::pi() } else { lag };
    let middle = slide.motion(lag / omega);
    let still = middle.acceleration.square() <= F::epsilon() * middle.w.square() && middle.w > zero;
    if !(still && slide.turns_first_at(F::pi() / omega)) {
        return None;
    }

    let y = Point { phase: fastest, x: middle.x, w: middle.w };
    let (s, c) = middle.rotation;
    let (dx, dw) = (arrival.x + slide.x, arrival.w * reversal);
    let residual = Residual::new(&equation, &y, (c * dx + s * dw, c * dw - s * dx));
    let rest =
        (arrival.rotation.0 * c - arrival.rotation.1 * s, arrival.rotation.1 * c + arrival.rotation.0 * s);
    let monodromy =
        Matrix::identity().after_slide(rest, zero).after_zero(reversal).after_slide(middle.rotation, zero);
    let inverse = monodromy.inverse_of_one_plus();
    if !(residual.is_rounding(1) && is_known(&y, inverse, &residual)) {
        return None;
    }
    let max_v = Extreme { value: middle.w / omega, phase: fastest };
    Some(SteadyState::of(SteadyParts {
        equation,
        start: y,
        half_turns: 1,
        statistics: CycleStatistics::of_reversals(
            greatest,
            max_v,
            two * slide.work_of_drive(&arrival),
            two * (arrival.x - slide.x),
        ),
        multipliers: monodromy.squared_eigenvalues(),
        distance: inverse.absolute().times(residual.bounds()),
        periods: F::ratio(1, 2),
    }))
}

impl<F: Float> Slide<F> {
    /// The motion after half a turn of the drive, at natural time π/Ω, from (sin β, cos β) of β = π/2Ω.
    #[inline]
    fn after_half_turn(&self, sin_cos_beta: (F, F)) -> Motion<F> {
        self.motion_of::<false>(&self.equation.half_turn(sin_cos_beta))
    }

    /// Whether the velocity of a forward slide from rest has its first zero at `end`, half a turn later,
    /// where it is zero to within rounding.
    #[inline]
    fn turns_first_at(&self, end: F) -> bool {
        self.does_not_turn_before(end)
            || self
                .velocity_zero(end)
                .is_ok_and(|zero| !zero.grazes && (zero.phi - end).square() <= F::epsilon() * end.square())
    }

    /// Whether the signs of the drive's power alone show that no velocity zero precedes the zero at `end`.
    #[inline]
    fn does_not_turn_before(&self, end: F) -> bool {
        let (pi, omega) = (F::pi(), self.equation.omega);
        let boundary = (pi / F::int(2) - self.start.angle()) / omega;
        if !self.start.is_even() || end - boundary > pi {
            return false;
        }
        if boundary <= pi {
            return true;
        }
        let m = self.motion(boundary);
        m.w > F::int(0) && boundary - m.w.atan2(m.acceleration) <= pi
    }
}

#[cfg(test)]
mod tests;
