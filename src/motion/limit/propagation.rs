//! Propagation of the motion from one phase of the drive to another, with the matrix of its disturbances.

use super::matrix::{Matrix, reversal_ratio};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::velocity_zero::{Lost, Outcome, VelocityZero};
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::Motion;
use crate::motion::slide::stick::Stick;
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::PhasePoint;
use crate::motion::trajectory::Next;
use alloc::vec::Vec;

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

/// m half turns of the motion from a point: the map `Hᵐ` there, with its derivative.
#[derive(Debug)]
pub(crate) struct HalfTurns<F> {
    pub(crate) equation: Equation<F>,
    pub(crate) start: PhasePoint<F>,
    /// The number of half turns.
    pub(crate) m: u32,
    /// The point at the end, at the phase of the start and with the opposite sign after an odd number of half
    /// turns.
    pub(crate) end: PhasePoint<F>,
    /// The matrix that maps (δx, δw) at the start to the end.
    pub(crate) derivative: Matrix<F>,
    /// The first parts, up to [`MOST_KEPT`].
    pub(crate) parts: Vec<MotionPart<F>>,
    /// How many parts there are, kept or not.
    pub(crate) count: u64,
    /// Whether the parts include a stop.
    pub(crate) sticks: bool,
    /// The position at which the body rests permanently, if it does.
    pub(crate) rest: Option<F>,
    /// The natural time to the first velocity zero, as expected.
    pub(crate) hint: F,
}

/// The greatest number of parts kept: all parts of a half turn for Ω above about 1/120. Further parts are propagated again on
/// demand.
const MOST_KEPT: usize = 1024;

impl<F: Float> HalfTurns<F> {
    /// The motion over m half turns from a point on. `hint` is the natural time to the first velocity zero,
    /// where one is expected.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn new(
        equation: Equation<F>,
        start: PhasePoint<F>,
        m: u32,
        hint: F,
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        // A negligible speed counts as rest, as in a start, because the slide would end after a time that
        // underflows.
        let start =
            if start.w.abs() < F::least_ratio() { PhasePoint { w: F::int(0), ..start } } else { start };
        let (mut parts, mut count) = (Vec::with_capacity(4), 0u64);
        let (mut sticks, mut rest) = (false, None);
        let (end, derivative) = follow(equation, start, m, hint, budget, |part| {
            if let MotionPart::Stick(stick, _) = &part {
                sticks = true;
                rest = if stick.release.is_none() { Some(stick.x) } else { None };
            }
            count = count.saturating_add(1);
            if parts.len() < MOST_KEPT {
                parts.push(part);
            }
            Ok(())
        })?;
        budget.spend(u64::from(m));
        let end = PhasePoint { phase: start.phase, ..end };
        let (end, derivative) = if m.is_multiple_of(2) {
            (end, derivative)
        } else {
            (PhasePoint { x: -end.x, w: -end.w, ..end }, derivative.negated())
        };
        Ok(Self { equation, start, m, end, derivative, parts, count, sticks, rest, hint })
    }

    /// A number that represents the sequence of slides and stops, as far as they are kept; most sequences differ
    /// in it.
    pub(crate) fn pattern(&self) -> u64 {
        self.parts.iter().fold(self.count, |pattern, part| {
            let kind = match part {
                MotionPart::Slide(slide, _) | MotionPart::Onward(slide, ..) => match slide.direction {
                    Direction::Forward => 1,
                    Direction::Backward => 2,
                },
                MotionPart::Stick(..) => 3,
            };
            pattern.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(kind)
        })
    }

    /// Visits all parts, in order.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn each_part(
        &self,
        budget: &mut Budget<'_>,
        mut visit: impl FnMut(&MotionPart<F>) -> Result<(), Broken>,
    ) -> Result<(), Broken> {
        if self.parts.len() as u64 == self.count {
            return self.parts.iter().try_for_each(visit);
        }
        follow(self.equation, self.start, self.m, self.hint, budget, |part| visit(&part)).map(|_| ())
    }

    /// These half turns from another start. The first velocity zero is expected where a change of the start by
    /// (δx, δw) moves it.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn moved_to(
        &self,
        start: PhasePoint<F>,
        change: (F, F),
        budget: &mut Budget<'_>,
    ) -> Result<Self, Broken> {
        let hint = match self.parts.first() {
            Some(MotionPart::Slide(slide, zero)) => zero.expected(change, slide.equation.damping),
            Some(MotionPart::Onward(..) | MotionPart::Stick(..)) | None => self.hint,
        };
        Self::new(self.equation, start, self.m, hint, budget)
    }
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
    from: PhasePoint<F>,
    half_turns: u32,
    hint: F,
    budget: &mut Budget<'_>,
    mut visit: impl FnMut(MotionPart<F>) -> Result<(), Broken>,
) -> Result<(PhasePoint<F>, Matrix<F>), Broken> {
    let zero = F::int(0);
    let usual = F::pi() / equation.omega;
    let target = from.phase.later_by_half_turns(i64::from(half_turns));
    let mut monodromy = Matrix::identity();
    let mut hint = hint;
    let mut next = Next::from_state(equation, from.phase, from.x, from.w);
    if matches!(next, Next::Stick(_)) {
        monodromy = monodromy.after_zero(zero);
    }
    let most = f64::from(half_turns) * (64.0 + 16.0 / equation.omega.to_f64());
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
                    return Ok((PhasePoint { phase: target, x: stick.x, w: zero }, monodromy));
                }
            },
            Next::Slide(slide) => {
                let limit = target.since(slide.start) / equation.omega;
                match slide.until(hint, limit).map_err(|Lost| slide.lost("the velocity zero"))? {
                    Outcome::Zero(end) => {
                        visit(MotionPart::Slide(slide, end))?;
                        next = Next::after(&slide, &end).0;
                        monodromy = monodromy.over(&slide, &end, &next);
                        hint = usual;
                    }
                    Outcome::Onward(motion) => {
                        let end = PhasePoint { phase: target, x: motion.x, w: motion.w };
                        visit(MotionPart::Onward(slide, limit, target, motion))?;
                        return Ok((end, monodromy.after_slide(motion.rotation, equation.damping)));
                    }
                }
            }
        }
    }
    Err(equation.lost("the end of a half turn", from.phase, "64 + 16/Ω slides and stops"))
}

impl<F: Float> Matrix<F> {
    /// The disturbance after a slide, its velocity zero `end` and the beginning of what comes next.
    #[inline]
    pub(crate) fn over(self, slide: &Slide<F>, end: &VelocityZero<F>, next: &Next<F>) -> Self {
        let ratio = match next {
            Next::Slide(on) if on.direction == slide.direction => F::int(1),
            Next::Slide(back) => reversal_ratio(back.acceleration),
            Next::Stick(_) => F::int(0),
        };
        self.after_slide(end.rotation, slide.equation.damping).after_zero(ratio)
    }
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
