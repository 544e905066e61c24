//! From one stop to the next half a turn later: a map of one number.
//!
//! The state of a body at rest is its displacement x alone. It determines the release, `α sin θ = x ± η` in
//! closed form, and thereby the motion after the release up to the stop half a turn later, at X. A symmetric
//! motion with a stop is a fixed point of `G(x) = −X`. A disturbance δx is released as (δx, 0) and changed by
//! the slides until the body stops again: `G′ = −M₁₁`, M the product of their free vibrations and reversals
//! (`matrix`).

use super::fixed_point::Residual;
use super::matrix::Matrix;
use super::propagation::MotionPart;
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::velocity_zero::{Lost, VelocityZero};
use crate::motion::slide::equation::Equation;
use crate::motion::slide::stick::{Stick, release_angle};
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::PhasePoint;
use crate::motion::trajectory::Next;
use alloc::vec::Vec;

/// The stops that the search uses: those released in one direction, in one half turn of the drive.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Station {
    pub(crate) half_turn: i64,
    pub(crate) direction: Direction,
}

/// The motion from one stop to the next, half a turn later.
#[derive(Debug)]
pub(crate) struct Passage<F> {
    /// Displacement of the stop at the beginning.
    pub(crate) from: F,
    /// The phase of the release.
    pub(crate) release: DrivePhase<F>,
    /// The slides and stops between the two stops.
    pub(crate) parts: Vec<MotionPart<F>>,
    /// The stop half a turn later.
    pub(crate) stop: Stick<F>,
    /// The residual `G(x) − x` and its rounding.
    pub(crate) left: Residual<F>,
    /// The derivative `G′(x)`.
    pub(crate) rate: F,
    /// Whether each slide is proved to last until its computed end.
    pub(crate) is_proved: bool,
}

/// A neighbouring passage, from which the ends of slides are predicted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Expected<'a, F> {
    pub(crate) by: Option<&'a Passage<F>>,
    /// Whether an end must be proved, in addition to being found at its predicted time.
    pub(crate) is_proved: bool,
}

/// Maximum number of parts of a passage; longer ones are left to `shooting`.
const MOST_PARTS: usize = 64;

/// The passage from a stop at x; `None` if there is no stop at the beginning or half a turn later, or the end of a slide is not found.
///
/// # Errors
/// [`crate::Error::Interrupted`].
pub(crate) fn passage<F: Float>(
    equation: Equation<F>,
    station: Station,
    x: F,
    expected: Expected<'_, F>,
    mut parts: Vec<MotionPart<F>>,
    budget: &mut Budget<'_>,
) -> Result<Option<Passage<F>>, Broken> {
    parts.clear();
    let Some(angle) = release_angle(&equation, x, station.direction) else { return Ok(None) };
    let release = DrivePhase::of_half_turn(station.half_turn, angle);
    let next_half_turn = station.half_turn.saturating_add(1);
    // A slide is expected to last for half a turn of the drive, or for a free period if that is shorter and
    // does not decay.
    let least_rate = if equation.is_damped() { F::int(0) } else { F::ratio(1, 2) };
    let usual = F::pi() / equation.omega.or_larger(least_rate);
    let mut slide = Slide::released(equation, release, x, station.direction);
    let mut monodromy = Matrix::identity();
    let mut is_proved = true;
    budget.spend(1);
    while parts.len() < MOST_PARTS {
        budget.ask()?;
        let hint = match expected.by.and_then(|like| like.parts.get(parts.len())) {
            Some(MotionPart::Slide(before, zero)) if before.direction == slide.direction => {
                Some(before.expected_again(zero, &slide))
            }
            _ => None,
        };
        let guess = if expected.is_proved { None } else { hint };
        let zero: VelocityZero<F> = match guess.and_then(|hint| slide.velocity_zero_near(hint)) {
            Some(found) => {
                is_proved = false;
                found
            }
            None => match slide.velocity_zero(hint.unwrap_or(usual)) {
                Ok(found) => found,
                // A stop that is tried may be one that no motion has: without a spring, at a distance that only a spring holds.
                Err(Lost) => return Ok(None),
            },
        };
        parts.push(MotionPart::Slide(slide, zero));
        let next = Next::after(&slide, &zero).0;
        monodromy = monodromy.over(&slide, &zero, &next);
        match next {
            Next::Slide(on) => slide = on,
            Next::Stick(stop) => {
                let Some((phase, direction)) = stop.release else { return Ok(None) };
                if phase.half_turns() == next_half_turn && direction != station.direction {
                    let (zero, rest) = (F::int(0), PhasePoint { phase: release, x, w: F::int(0) });
                    let left = Residual::new(&equation, &rest, (-stop.x - x, zero));
                    let rate = -monodromy.a;
                    return Ok(Some(Passage { from: x, release, parts, stop, left, rate, is_proved }));
                }
                if phase.half_turns() > station.half_turn {
                    return Ok(None);
                }
                parts.push(MotionPart::Stick(stop, phase.since(stop.start)));
                slide = Slide::released(equation, phase, stop.x, direction);
            }
        }
        if zero.phase.half_turns() > next_half_turn {
            return Ok(None);
        }
    }
    Ok(None)
}

/// The residual `G(x) − x` at a point x, and its slope.
#[derive(Clone, Copy)]
pub(crate) struct Miss<F> {
    pub(crate) x: F,
    pub(crate) value: F,
    pub(crate) slope: F,
}

impl<F: Float> Miss<F> {
    /// The step to the zero of the cubic through this point and the point `before`, with their slopes;
    /// Newton's step without a point before.
    pub(crate) fn step(&self, before: Option<Self>) -> F {
        let (two, three) = (F::int(2), F::int(3));
        let newton = -(self.value / self.slope);
        let Some(before) = before else { return newton };
        // value + slope t + a t² + b t³, where t is counted from this point
        let back = self.x - before.x;
        let secant = (self.value - before.value) / back;
        let a = (two * self.slope + before.slope - three * secant) / back;
        let b = (self.slope + before.slope - two * secant) / back.square();
        // This starts with the nearest zero of the parabola and takes Newton's steps for the cubic.
        let discriminant = self.slope.square() - F::int(4) * a * self.value;
        let bends_away = discriminant <= F::int(0) || !discriminant.is_finite();
        if bends_away {
            return newton;
        }
        let mut t = -(two * self.value) / (self.slope - discriminant.sqrt());
        for _ in 0..3 {
            let value = self.value + t * (self.slope + t * (a + t * b));
            let slope = self.slope + t * (two * a + three * t * b);
            t = t - value / slope;
        }
        t
    }
}
