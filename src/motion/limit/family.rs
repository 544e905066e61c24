//! Ω = 1/(2n): a family of periodic motions.
//!
//! Here the natural period divides half of the drive's period, and a free vibration of fixed amplitude can be
//! added to the forced one. The motions that do not stick form a family, and each member is periodic: extrema
//! `±α/(1 − Ω²) + c` with `|c| ≤ αΩ²/(1 − Ω²) − 1` (in B). One multiplier of the cycle is 1. The start
//! determines the member that a motion tends to, and so the motion is followed.
//!
//! A motion outside the family sticks slightly less in each cycle, and creeps towards the member at the edge,
//! which touches the sticking threshold: the distance decreases only like 1/cycles. The distance never grows
//! (`shooting`), so that a motion close to this member has it as its limit, to within the distance.

use super::fixed_point::{Residual, rate_noise};
use super::long_run::{LongRun, unsettled};
use super::propagation::HalfTurns;
use super::steady::SteadyState;
use crate::cycle::Border;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::PhasePoint;

/// Whether (Ω, α) has a family: 2nΩ = 1 exactly, and no sticking. If Ω is 1/(2n) only to within rounding, the
/// limit is unique.
pub(crate) fn is_one<F: Float>(ratios: Ratios<F>) -> bool {
    // The greatest frequency ratio of a family is 1/2.
    if ratios.omega() * F::int(3) > F::int(2) || ratios.is_damped() {
        return false;
    }
    let p = PhaseFunction::of_valid(ratios.omega());
    p.is_even_subharmonic() && ratios.alpha() >= Border::of(&ratios).min_force_ratio
}

/// The member that the motion through a point tends to.
///
/// The change from cycle to cycle shrinks by the other multiplier μ, so that after a change d the remaining
/// change is `d μ/(1 − μ)`. This change is added once it is small enough for the motion to be linear in it.
///
/// # Errors
/// As for [`HalfTurns::new`].
pub(crate) fn member<F: Float>(
    equation: Equation<F>,
    start: PhasePoint<F>,
    hint: F,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Error> {
    let one = F::int(1);
    let mut y = start;
    let mut added = false;
    loop {
        let cycle = HalfTurns::new(equation, y, 2, hint, budget)?;
        let (dx, dw) = (cycle.end.x - y.x, cycle.end.w - y.w);
        let residual = Residual::new(&equation, &y, (dx, dw));
        let change = residual.norm();
        let other = cycle.derivative.determinant().abs();
        // Friction is too small compared with the motion for the type to resolve, and the remaining change is
        // unknown.
        let settles = one - other > rate_noise(cycle.count);
        let in_the_limit = |change: F| if settles { change / (one - other) } else { one / F::int(0) };
        let left = in_the_limit(change);
        let size = one + y.x.abs() + y.w.abs();
        let rounding = F::int(4) * (residual.bound() - change);
        // A motion far outside the family loses less in a cycle than its own rounding: it seems to repeat,
        // which proves nothing.
        if is_near(&equation, &y) && settles && (left <= rounding || (added && change <= rounding)) {
            let off = in_the_limit(residual.bound()) + rounding;
            return Ok(finish(&cycle, off, budget)?);
        }
        if cycle.sticks && budget.half_turns >= LONG_CREEP {
            let edge = nearest_edge(equation, &y);
            let off = (edge.x - y.x).hypot(edge.w - y.w);
            if off * F::int(16) < size {
                return Ok(finish(&HalfTurns::new(equation, edge, 2, hint, budget)?, off, budget)?);
            }
        }
        if budget.half_turns > budget.most {
            return Ok(unsettled(&equation, &y, change, budget));
        }
        // The neutral disturbance of the jump is of second order: below rounding for a jump of its root.
        let jump = !added && left.square() <= F::epsilon() * F::ratio(1, 64) * size.square() && settles;
        let reach = if jump { one / (one - other) } else { one };
        y = PhasePoint { phase: y.phase, x: y.x + dx * reach, w: y.w + dw * reach };
        added = added || jump;
    }
}

/// Whether a point is within the range of the members, to within a factor: their displacements are `|x| ≤ α(1
/// + Ω²)/(1 − Ω²) − 1`.
fn is_near<F: Float>(equation: &Equation<F>, y: &PhasePoint<F>) -> bool {
    let (one, omega) = (F::int(1), equation.omega);
    let reach = equation.alpha * (one + omega.square()) / ((one - omega) * (one + omega));
    y.x.abs() + y.w.abs() <= F::int(8) * reach
}

/// The number of half turns after which a motion of a family that still sticks counts as creeping.
const LONG_CREEP: u64 = 400;

/// The member at the edge of the family that is nearest to y, at the phase of y.
///
/// The members are sums of the symmetric cycle and `c cos ω_n(t − t₂)`, |c| up to `αΩ²/(1 − Ω²) − 1`.
fn nearest_edge<F: Float>(equation: Equation<F>, y: &PhasePoint<F>) -> PhasePoint<F> {
    let (zero, one) = (F::int(0), F::int(1));
    let Equation { omega, alpha, .. } = equation;
    let amplitude = alpha / ((one - omega) * (one + omega));
    let room = omega.square() * amplitude - one;
    // t₂ is at π/2: K = 0. The half turn before y begins at an extremum, a maximum where sin θ > 0.
    let before = DrivePhase::of_half_turn(y.phase.half_turns(), -(F::pi() / F::int(2)));
    let maximum = !before.is_even();
    let (side, direction) = if maximum { (one, Direction::Backward) } else { (-one, Direction::Forward) };
    let phi = y.phase.since(before) / omega;
    let at = |c: F| {
        let motion = Slide::new(equation, before, side * amplitude + c, zero, direction).motion(phi);
        PhasePoint { phase: y.phase, x: motion.x, w: motion.w }
    };
    let (high, low) = (at(room), at(-room));
    let distance = |p: &PhasePoint<F>| (p.x - y.x).hypot(p.w - y.w);
    if distance(&high) <= distance(&low) { high } else { low }
}

/// The member with this motion over one turn, at a distance of at most `off` from the limit. The member counts
/// as symmetric if its middle is zero to within that distance.
///
/// # Errors
/// As for [`HalfTurns::steady`].
pub(crate) fn finish<F: Float>(
    cycle: &HalfTurns<F>,
    off: F,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Broken> {
    let (zero, one) = (F::int(0), F::int(1));
    let steady = cycle.steady((off, off), budget)?;
    // No disturbance grows (`shooting`): a multiplier above 1 is rounding, where the type cannot resolve
    // friction compared with the force.
    let other = cycle.derivative.determinant();
    let other = if other.abs() > one { one.with_sign_of(other) } else { other };
    let shift = (steady.max_displacement.value + steady.min_displacement.value).abs();
    Ok(LongRun::Family(SteadyState {
        // A member reverses twice in a cycle and never stops. The outermost member touches the bound of
        // sticking; an apparent stop there is rounding, or the remaining creep.
        sticks_per_cycle: 0,
        velocity_zeros_per_cycle: 2,
        stick_fraction: zero,
        multipliers: [(one, zero), (other, zero)],
        is_symmetric: shift <= F::int(2) * off,
        ..steady
    }))
}

#[cfg(test)]
mod tests;
