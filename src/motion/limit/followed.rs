//! The limit of a motion from one start, with a static friction above the kinetic one.
//!
//! Friction is then not monotone: a body at rest resists more than a moving one, two motions under the same
//! drive can diverge, and the proof in `shooting` for every start does not hold. Limits can coexist, be
//! asymmetric, take several turns of the drive, or be irregular. The motion itself is therefore computed, and
//! the result holds for this start only.
//!
//! H advances the state by half a turn and changes its sign (`shooting`). Let m be the least number with
//! `Hᵐ(y) = y`.
//!
//! * m odd: the motion is symmetric, `x(t + mT/2) = −x(t)`, and takes m turns.
//! * m even: the motion is asymmetric and takes m/2 turns; `H(y)` is on its mirror image, another motion.
//!
//! # How a periodic motion is recognised
//!
//! The state is compared with a reference, which is renewed after 16, 32, 64, 128, 256, 384 … half turns, so
//! that m up to [`LONGEST`] is found. Where it returns to the reference within 2⁻²⁰ of its size, Newton's
//! method on Hᵐ gives the periodic motion, with its derivative J along it. It is the limit of this start
//! where all of these hold:
//!
//! * its multipliers are within the unit circle;
//! * it is within 2⁻¹² of the motion followed, relative to its size, and both have the same sequence of
//!   slides and stops over m half turns;
//! * the distance after those is that of the linearised motion, J times that before, to an eighth of itself.
//!
//! Then the motion is in the range of the linearised map, which contracts. Otherwise it is followed further.
//! A state that returns after m half turns can return after fewer, and an even m alone does not mean an
//! asymmetric motion: `Trial::earliest` decides.
//!
//! # How an irregular motion is recognised
//!
//! A disturbance is carried along by the exact linearised motion from a quarter of the budget on; its mean
//! logarithmic growth is the Lyapunov exponent. Where no periodic motion was found by the end of the budget,
//! the motion does not come back to its last reference and the exponent is not below zero by more than four
//! times its standard error, the motion is irregular as far as it was followed: chaotic where the exponent is
//! above that, and otherwise one whose neighbours neither leave it nor approach it. Such motions exist: with
//! one stop in a cycle the state is one number, and the map of a turn can be a map of a circle onto itself,
//! with breaks where a stop begins or ends. Then the motion is quasi-periodic.

mod observation;

use super::family;
use super::fixed_point::{Trial, distance, rate_noise, size};
use super::long_run::{LongRun, Rest, unsettled};
use super::matrix::Matrix;
use super::propagation::HalfTurns;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::{Ratios, springless};
use crate::motion::broken::{Broken, Budget};
use crate::motion::slide::equation::Equation;
use crate::motion::state::{PhasePoint, State};
use observation::{GrowthAtResonance, Observation};

/// Half turns that a periodic motion may take.
const LONGEST: u32 = 128;

/// The limit of the motion from a start, α > 1, η > 1.
///
/// # Errors
/// [`Error::SearchBound`], [`Error::Interrupted`].
pub(crate) fn limit<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Error> {
    let equation = Equation::new(ratios);
    let mut y = PhasePoint::of(&start, equation.omega);
    let mut reference = y;
    let (mut lag, mut next_reference) = (0u32, 16u64);
    let usual = F::pi() / equation.omega;
    // Whether the motion returned to this reference, and to the one before.
    let (mut is_tried, mut was_tried) = (false, false);
    let mut observation = Observation::new(budget.most);
    let mut change = F::int(0);
    let grows = GrowthAtResonance::of(&ratios);
    while budget.half_turns < budget.most {
        let step = HalfTurns::new(equation, y, 1, usual, budget)?;
        step.each_part(budget, |part| {
            observation.add(part);
            Ok(())
        })?;
        if let Some(position) = step.rest {
            let position = if observation.is_upside_down { -position } else { position };
            let periods = budget.periods();
            return Ok(LongRun::Rest(Rest { position, slides: Some(observation.slides), periods }));
        }
        observation.stretch(&step.derivative, budget.half_turns);
        change = distance(&step.end, &y);
        if let Some(growth) = grows.as_ref().and_then(|grows| grows.seen(&y, &step.end)) {
            return Ok(LongRun::Unbounded { growth });
        }
        y = step.end;
        lag = lag.saturating_add(1);
        let is_back = distance(&y, &reference) <= F::exp2i(-20) * size(&reference);
        if is_back && !is_tried {
            is_tried = true;
            // Without a spring the motion returns to another place after an odd number of half turns.
            let first = if is_free(&equation) { 1 } else { lag };
            for half_turns in [first, lag, lag.saturating_mul(2)] {
                let here = observation.upright(&y);
                if let Some(found) = periodic(ratios, &here, half_turns, budget)? {
                    return Ok(found);
                }
            }
        }
        if budget.half_turns >= next_reference {
            next_reference = budget.half_turns.saturating_add(budget.half_turns.min(u64::from(LONGEST)));
            (reference, lag, was_tried, is_tried) = (y, 0, is_tried, false);
        }
    }
    let here = observation.upright(&y);
    let irregular =
        if is_tried || was_tried { None } else { observation.irregular(&equation, &here, budget) };
    Ok(irregular.map_or_else(|| unsettled(&equation, &here, change, budget), LongRun::Irregular))
}

/// The periodic motion of m half turns next to a point of the motion followed, where it is the limit.
fn periodic<F: Float>(
    ratios: Ratios<F>,
    near: &PhasePoint<F>,
    m: u32,
    budget: &mut Budget<'_>,
) -> Result<Option<LongRun<F>>, Broken> {
    let equation = Equation::new(ratios);
    let begun = Trial::at(equation, *near, m, budget)?;
    let (begin, arrived, pattern) = (begun.motion.start, begun.motion.end, begun.motion.pattern());
    if family::is_one(ratios) && !is_within(&begun.motion.derivative, -F::exp2i(-20)) {
        // One multiplier is 1: Newton's step is undefined, and the motion is followed until its own change is
        // rounding.
        let is_settled =
            begun.left.is_rounding(4) && is_within(&begun.motion.derivative, rate_noise(u64::from(m)));
        // Where the type does not resolve friction, the other multiplier rounds to 1 and the remaining change is unknown.
        let other = begun.motion.derivative.determinant().abs();
        let settles = F::int(1) - other > rate_noise(u64::from(m));
        return if is_settled && settles { member(&begun, other, budget).map(Some) } else { Ok(None) };
    }
    let is_free = is_free(&equation);
    if is_free && m.is_multiple_of(2) {
        return repeated(begun, budget);
    }
    let slack = if is_free { rate_noise(u64::from(m)) } else { F::int(0) };
    let found = begun.newton(budget)?;
    let (y, step, left) = (&found.motion.start, &found.motion, &found.left);
    if !(found.is_periodic(16) && step.rest.is_none() && is_within(&step.derivative, slack)) {
        return Ok(None);
    }
    let (before, room) = ((begin.x - y.x, begin.w - y.w), left.bound());
    let away = before.0.hypot(before.1);
    let linear = step.derivative.times(before);
    let off = (arrived.x - y.x - linear.0).hypot(arrived.w - y.w - linear.1);
    let is_followed = away <= F::exp2i(-12) * size(y)
        && pattern == step.pattern()
        && off <= away / F::int(8) + F::int(64) * room;
    if !is_followed {
        return Ok(None);
    }
    let found = found.earliest(16, budget)?;
    if !is_within(&found.motion.derivative, slack) {
        return Ok(None);
    }
    Ok(Some(LongRun::Periodic(found.steady(budget)?)))
}

/// Whether the spring cannot be seen. It then holds no place: a body that is moved stays moved, in H with a change of sign.
/// One multiplier of Hᵐ is 1 for an even m and −1 for an odd one, but for rounding.
fn is_free<F: Float>(equation: &Equation<F>) -> bool {
    equation.omega * F::int(4) >= springless()
}

/// The motion of a body without a spring over an even number of half turns, where it has come to repeat: Newton's step is
/// undefined, because the motion repeats at any place.
fn repeated<F: Float>(settled: Trial<F>, budget: &mut Budget<'_>) -> Result<Option<LongRun<F>>, Broken> {
    let step = &settled.motion;
    let noise = rate_noise(u64::from(step.m));
    let other = step.derivative.determinant().abs();
    let has_settled = settled.left.is_rounding(16)
        && step.rest.is_none()
        && is_within(&step.derivative, noise)
        && F::int(1) - other > noise;
    if !has_settled {
        return Ok(None);
    }
    let (x, w) = settled.left.bounds();
    let longer = F::int(1) / (F::int(1) - other);
    Ok(Some(LongRun::Periodic(step.steady((x * longer, w * longer), budget)?)))
}

/// The member of a family at Ω = 1/(2n) that a motion has settled on, `other` being its multiplier that is not 1.
fn member<F: Float>(settled: &Trial<F>, other: F, budget: &mut Budget<'_>) -> Result<LongRun<F>, Broken> {
    let off = settled.left.bound() / (F::int(1) - other);
    let HalfTurns { equation, start, hint, .. } = settled.motion;
    family::finish(&HalfTurns::new(equation, start, 2, hint, budget)?, off, budget)
}

/// Whether the multipliers are within the unit circle, with that much room.
fn is_within<F: Float>(derivative: &Matrix<F>, room: F) -> bool {
    let [(a, b), (c, d)] = derivative.eigenvalues();
    let most = F::int(1) + room;
    let (first, second) = (a.hypot(b), c.hypot(d));
    if room == F::int(0) { first < most && second < most } else { first <= most && second <= most }
}

#[cfg(test)]
mod tests;
