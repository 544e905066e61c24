//! Propagation of the motion from one phase of the drive to another, with the matrix of its disturbances.

use super::matrix::{Matrix, reversal_ratio};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive::DrivePhase;
use crate::motion::event::velocity_zero::{Lost, Outcome, VelocityZero};
use crate::motion::slide::Slide;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::Motion;
use crate::motion::slide::stick::Stick;
use crate::motion::state::Point;
use crate::motion::trajectory::Next;

/// A part of the motion: a slide or a stop, or the share of it within the time followed.
#[derive(Debug, Clone, Copy)]
pub(crate) enum MotionPart<F> {
    /// A slide, and the velocity zero that ends it.
    Slide(Slide<F>, VelocityZero<F>),
    /// A slide that continues: its length in natural time, and the phase and the motion there.
    Onward(Slide<F>, F, DrivePhase<F>, Motion<F>),
    /// A stop, and its length as a phase.
    Stick(Stick<F>, F),
}

/// The motion over some half turns.
#[derive(Debug)]
pub(crate) struct Propagation<F> {
    pub(crate) end: Point<F>,
    /// The matrix that maps (δx, δw) at the beginning to the end.
    pub(crate) monodromy: Matrix<F>,
    /// The first parts, up to [`MOST_KEPT`].
    pub(crate) parts: Vec<MotionPart<F>>,
    /// How many parts there are, kept or not.
    pub(crate) count: u64,
    /// Whether the parts include a stop.
    pub(crate) sticks: bool,
    /// The natural time to the first velocity zero, as expected.
    pub(crate) hint: F,
}

/// The greatest number of parts kept: all parts for Ω above about 1/30. Further parts are propagated again on
/// demand.
const MOST_KEPT: usize = 256;

impl<F: Float> Propagation<F> {
    /// Visits all parts of the propagation, in order.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn each_part(
        &self,
        equation: Equation<F>,
        from: Point<F>,
        half_turns: i64,
        budget: &mut Budget<'_>,
        mut visit: impl FnMut(&MotionPart<F>) -> Result<(), Broken>,
    ) -> Result<(), Broken> {
        if self.parts.len() as u64 == self.count {
            return self.parts.iter().try_for_each(visit);
        }
        follow(equation, from, half_turns, self.hint, budget, |part| visit(&part)).map(|_| ())
    }
}

/// The motion over `half_turns` from a point on. `hint` is the natural time to the first velocity zero, where
/// one is expected.
///
/// # Errors
/// As for [`follow`].
pub(crate) fn propagate<F: Float>(
    equation: Equation<F>,
    from: Point<F>,
    half_turns: i64,
    hint: F,
    mut parts: Vec<MotionPart<F>>,
    budget: &mut Budget<'_>,
) -> Result<Propagation<F>, Broken> {
    parts.clear();
    let (mut left_out, mut sticks) = (0u64, false);
    let (end, monodromy) = follow(equation, from, half_turns, hint, budget, |part| {
        sticks |= matches!(part, MotionPart::Stick(..));
        if parts.len() < MOST_KEPT {
            parts.push(part);
        } else {
            left_out = left_out.saturating_add(1);
        }
        Ok(())
    })?;
    let count = left_out.saturating_add(parts.len() as u64);
    Ok(Propagation { end, monodromy, parts, count, sticks, hint })
}

/// Follows the motion for `half_turns` from a point on, part by part. Returns the point at the end and the
/// matrix that maps (δx, δw) from the beginning to the end.
///
/// # Work
///
/// A slide that begins at rest on a half turn where g ≥ 0 for its direction (`event`) lasts for at least π of
/// natural time or ends after that half turn. A slide that begins where g ≤ 0 is followed by one in the other
/// direction, for which g ≥ 0, with or without a stop before it. A half turn between two changes of sign of
/// cos θ therefore contains at most `1 + 1/Ω` beginnings of slides of the first kind, one of the second kind
/// before each and one after the last, and the slide under way: **at most 4 + 2/Ω velocity zeros**, and two
/// parts for each. A half turn from any phase overlaps two such half turns, with 1/Ω in all: at most 16 + 4/Ω
/// parts. Slides whose length is rounding are additional; more than four times as many parts are an error.
///
/// # Errors
/// [`crate::Error::SearchBound`], [`crate::Error::Interrupted`], and the errors of `visit`.
pub(crate) fn follow<F: Float>(
    equation: Equation<F>,
    from: Point<F>,
    half_turns: i64,
    hint: F,
    budget: &mut Budget<'_>,
    mut visit: impl FnMut(MotionPart<F>) -> Result<(), Broken>,
) -> Result<(Point<F>, Matrix<F>), Broken> {
    let (zero, one) = (F::int(0), F::int(1));
    let usual = F::pi() / equation.omega;
    let target = from.phase.later_by_half_turns(half_turns);
    let mut monodromy = Matrix::identity();
    let mut hint = hint;
    let mut next = Next::from_state(equation, from.phase, from.x, from.w);
    if matches!(next, Next::Stick(_)) {
        monodromy = monodromy.after_zero(zero);
    }
    let most = half_turns as f64 * (64.0 + 16.0 / equation.omega.to_f64());
    for _ in 0..most as u64 {
        budget.ask()?;
        match next {
            Next::Stick(stick) => match stick.release {
                Some((phase, direction)) if target.since(phase) > zero => {
                    visit(MotionPart::Stick(stick, phase.since(stick.start)))?;
                    let slide = Slide::released(equation, phase, stick.x, direction);
                    monodromy = monodromy.after_release(slide.gain_at_release());
                    next = Next::Slide(slide);
                }
                _ => {
                    visit(MotionPart::Stick(stick, target.since(stick.start)))?;
                    return Ok((Point { phase: target, x: stick.x, w: zero }, monodromy));
                }
            },
            Next::Slide(slide) => {
                let limit = target.since(slide.start) / equation.omega;
                match slide.until(hint, limit).map_err(|Lost| slide.lost("the velocity zero"))? {
                    Outcome::Zero(end) => {
                        visit(MotionPart::Slide(slide, end))?;
                        next = Next::after(&slide, &end).0;
                        let ratio = match &next {
                            Next::Slide(on) if on.direction == slide.direction => one,
                            Next::Slide(back) => reversal_ratio(back.acceleration),
                            Next::Stick(_) => zero,
                        };
                        monodromy = monodromy.after_slide(end.rotation, equation.damping).after_zero(ratio);
                        hint = usual;
                    }
                    Outcome::Onward(motion) => {
                        let end = Point { phase: target, x: motion.x, w: motion.w };
                        visit(MotionPart::Onward(slide, limit, target, motion))?;
                        return Ok((end, monodromy.after_slide(motion.rotation, equation.damping)));
                    }
                }
            }
        }
    }
    Err(equation.lost("the end of a half turn", from.phase, "64 + 16/Ω slides and stops"))
}

impl<F: Float> Slide<F> {
    /// `(η − 1)/(αΩ |cos θ|)` for a slide that begins with a release ([`Matrix::after_release`]).
    fn gain_at_release(&self) -> F {
        let equation = &self.equation;
        if !equation.has_higher_static_friction() {
            return F::int(0);
        }
        let (_, cosine) = self.sin_cos_start();
        equation.static_excess() / (equation.alpha * equation.omega * cosine.abs())
    }
}

#[cfg(test)]
mod tests;
