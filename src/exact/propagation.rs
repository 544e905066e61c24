//! From one phase of the drive to another, through whatever happens in between, with what a disturbance becomes.

use super::broken::Broken;
use super::budget::Budget;
use super::drive::DrivePhase;
use super::equation::Equation;
use super::matrix::{Matrix, reversal_ratio};
use super::motion::Motion;
use super::slide::Slide;
use super::state::Point;
use super::stick::Stick;
use super::trajectory::Next;
use super::velocity_zero::{Lost, Outcome, VelocityZero};
use crate::float::Float;

/// A part of the motion: a slide or a stop, or as much of it as lies within.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Part<F> {
    /// A slide, and the velocity zero that ends it.
    Slide(Slide<F>, VelocityZero<F>),
    /// A slide that goes on: its length in natural time, the phase and the motion there.
    Onward(Slide<F>, F, DrivePhase<F>, Motion<F>),
    /// A stop, and its length as a phase.
    Stick(Stick<F>, F),
}

/// The motion over some half turns.
#[derive(Debug)]
pub(crate) struct Propagation<F> {
    pub(crate) end: Point<F>,
    /// (δx, δw) at the end for that at the beginning.
    pub(crate) monodromy: Matrix<F>,
    /// The first parts, up to [`MOST_KEPT`].
    pub(crate) parts: Vec<Part<F>>,
    /// How many parts there are, kept or not.
    pub(crate) count: u64,
    /// Whether there is a stop among them.
    pub(crate) sticks: bool,
    /// The natural time to the first velocity zero that was expected.
    pub(crate) hint: F,
}

/// Parts that are kept: all where Ω is above some 1/30. More are propagated again where its parts are asked for.
const MOST_KEPT: usize = 256;

impl<F: Float> Propagation<F> {
    /// All its parts, in order.
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn each_part(
        &self,
        equation: Equation<F>,
        from: Point<F>,
        half_turns: i64,
        budget: &mut Budget<'_>,
        mut visit: impl FnMut(&Part<F>) -> Result<(), Broken>,
    ) -> Result<(), Broken> {
        if self.parts.len() as u64 == self.count {
            return self.parts.iter().try_for_each(visit);
        }
        follow(equation, from, half_turns, self.hint, budget, |part| visit(&part)).map(|_| ())
    }
}

/// The motion over `half_turns` from a point on. `hint` is the natural time to the first velocity zero, where one is expected.
///
/// # Errors
/// As for [`follow`].
pub(crate) fn propagate<F: Float>(
    equation: Equation<F>,
    from: Point<F>,
    half_turns: i64,
    hint: F,
    mut parts: Vec<Part<F>>,
    budget: &mut Budget<'_>,
) -> Result<Propagation<F>, Broken> {
    parts.clear();
    let (mut left_out, mut sticks) = (0u64, false);
    let (end, monodromy) = follow(equation, from, half_turns, hint, budget, |part| {
        sticks |= matches!(part, Part::Stick(..));
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

/// Follows the motion for `half_turns` from a point on, part by part: where it is then, with (δx, δw) there for that at the beginning.
///
/// # Work
///
/// A slide that begins at rest on a half turn where g ≥ 0 for its direction (`event`) lasts for π of natural time or beyond that half
/// turn. After one that begins where g ≤ 0 comes a slide of the other direction, for which g ≥ 0, with or without a stop before it. So a
/// half turn between two changes of sign of cos θ has at most `1 + 1/Ω` slides of the first kind that begin in it, one of the second
/// kind before each and one after the last, and the slide that is under way: **at most 4 + 2/Ω velocity zeros**, and two parts for each.
/// A half turn from any phase touches two such, with 1/Ω in all: at most 16 + 4/Ω parts. Slides whose length is rounding come on top; four
/// times as many parts are an error.
///
/// # Errors
/// [`crate::Error::SearchBound`], [`crate::Error::Interrupted`], and what `visit` says.
pub(crate) fn follow<F: Float>(
    equation: Equation<F>,
    from: Point<F>,
    half_turns: i64,
    hint: F,
    budget: &mut Budget<'_>,
    mut visit: impl FnMut(Part<F>) -> Result<(), Broken>,
) -> Result<(Point<F>, Matrix<F>), Broken> {
    let (zero, one) = (F::int(0), F::int(1));
    let usual = F::pi() / equation.omega;
    let target = from.phase.later_by_half_turns(half_turns);
    let mut monodromy = Matrix::identity();
    let mut hint = hint;
    let mut next = Next::from(equation, from.phase, from.x, from.w);
    if matches!(next, Next::Stick(_)) {
        monodromy = monodromy.after_zero(zero);
    }
    let most = half_turns as f64 * (64.0 + 16.0 / equation.omega.to_f64());
    for _ in 0..most as u64 {
        budget.ask()?;
        match next {
            Next::Stick(stick) => match stick.release {
                Some((phase, direction)) if target.since(phase) > zero => {
                    visit(Part::Stick(stick, phase.since(stick.start)))?;
                    let slide = Slide::released(equation, phase, stick.x, direction);
                    monodromy = monodromy.after_release(slide.gain_at_release());
                    next = Next::Slide(slide);
                }
                _ => {
                    visit(Part::Stick(stick, target.since(stick.start)))?;
                    return Ok((Point { phase: target, x: stick.x, w: zero }, monodromy));
                }
            },
            Next::Slide(slide) => {
                let limit = target.since(slide.start) / equation.omega;
                match slide.until(hint, limit).map_err(|Lost| slide.lost("the velocity zero"))? {
                    Outcome::Zero(end) => {
                        visit(Part::Slide(slide, end))?;
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
                        visit(Part::Onward(slide, limit, target, motion))?;
                        return Ok((end, monodromy.after_slide(motion.rotation, equation.damping)));
                    }
                }
            }
        }
    }
    Err(equation.lost("the end of a half turn", from.phase, "64 + 16/Ω slides and stops"))
}

impl<F: Float> Slide<F> {
    /// `(η − 1)/(αΩ |cos θ|)` of a slide that begins where friction gives way ([`Matrix::after_release`]).
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
mod tests {
    use super::{MOST_KEPT, Part, follow, propagate};
    use crate::Error;
    use crate::Ratios;
    use crate::exact::DrivePhase;
    use crate::exact::equation::Equation;
    use crate::exact::shooting::Budget;
    use crate::exact::state::Point;
    use core::ops::ControlFlow;

    #[test]
    fn the_monodromy_is_the_derivative_of_the_walk() {
        for (omega, alpha, eta, theta, x, w) in [
            (0.7, 2.0, 1.0, 0.1, -0.4, 1.0),
            (0.4, 6.0, 1.0, 0.3, -0.5, 2.0),
            (1.5, 2.5, 1.0, -1.0, 0.2, -1.0),
            (0.13, 3.0, 1.0, 0.2, 0.1, 0.4),
            (0.7, 2.0, 1.5, 0.1, -0.4, 1.0),
            (0.4, 6.0, 2.0, 0.3, -0.5, 2.0),
            (0.13, 3.0, 1.3, 0.2, 0.1, 0.4),
        ] {
            let ratios = Ratios::new(omega, alpha).unwrap().with_static_friction_ratio(eta).unwrap();
            let equation = Equation::new(ratios);
            let phase = DrivePhase::new(theta).unwrap();
            let at = |x, w| {
                propagate(equation, Point { phase, x, w }, 2, 1.0, Vec::new(), &mut Budget::of(0)).unwrap()
            };
            let m = at(x, w).monodromy;
            let h = 1e-6;
            let (right, left) = (at(x + h, w).end, at(x - h, w).end);
            let (up, down) = (at(x, w + h).end, at(x, w - h).end);
            let difference =
                |p: Point<f64>, q: Point<f64>| ((p.x - q.x) / (2.0 * h), (p.w - q.w) / (2.0 * h));
            let ((a, c), (b, d)) = (difference(right, left), difference(up, down));
            for (got, expected) in [(m.a, a), (m.b, b), (m.c, c), (m.d, d)] {
                assert!((got - expected).abs() < 1e-6, "Ω = {omega}: {m:?} {a} {b} {c} {d}");
            }
        }
    }

    /// Where friction is rounding beside the force, a disturbance keeps its size: a quotient of the accelerations made it grow by 7e-5.
    #[test]
    fn no_part_drives_two_motions_apart() {
        let equation =
            Equation::new(Ratios::new(1.319_799_361_868_836_2e-6f64, 8.987_385_541_686_157e62).unwrap());
        let phase = DrivePhase::of_half_turn(1, 2.606_010_784_944_601e-7);
        let from = Point { phase, x: -2.342_122_367_685_313_4e56, w: -1.186_154_571_116_979_4e57 };
        let propagation = propagate(equation, from, 1, 1.0, Vec::new(), &mut Budget::of(0)).unwrap();
        assert!((propagation.monodromy.determinant() - 1.0).abs() < 1e-15, "{:?}", propagation.monodromy);
    }

    /// Of many parts the first are kept, and all are met again where they are asked for.
    #[test]
    fn parts_that_are_not_kept_are_met_again() {
        let equation = Equation::new(Ratios::new(1e-3, 3.0).unwrap());
        let from = Point { phase: DrivePhase::new(0.1).unwrap(), x: 0.2, w: 0.3 };
        let mut budget = Budget::of(0);
        let propagation = propagate(equation, from, 1, 1.0, Vec::new(), &mut budget).unwrap();
        let mut starts = Vec::new();
        let visit = |part: &Part<f64>| {
            starts.push(match part {
                Part::Slide(slide, _) | Part::Onward(slide, ..) => slide.start,
                Part::Stick(stick, _) => stick.start,
            });
            Ok(())
        };
        propagation.each_part(equation, from, 1, &mut budget, visit).unwrap();
        assert!(
            propagation.parts.len() == MOST_KEPT && propagation.count > 300 && propagation.sticks,
            "{}",
            propagation.count
        );
        assert_eq!(starts.len() as u64, propagation.count);
        assert!(starts.windows(2).all(|pair| pair[1].since(pair[0]) > 0.0));
    }

    #[test]
    fn a_walk_is_broken_off() {
        let equation = Equation::new(Ratios::new(1e-3, 3.0).unwrap());
        let from = Point { phase: DrivePhase::new(0.1).unwrap(), x: 0.2, w: 0.3 };
        let mut asked = 0;
        let mut keep_going = || {
            asked += 1;
            if asked < 7 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let mut parts = 0;
        let mut budget = Budget::of(0).with(&mut keep_going);
        let count = |_| {
            parts += 1;
            Ok(())
        };
        let broken = follow(equation, from, 1, 1.0, &mut budget, count);
        assert_eq!((broken.err().map(Error::from), parts, asked), (Some(Error::Interrupted), 6, 7));
    }

    /// A velocity zero at the very end: from rest there, with no time left, the body was found at rest again, for ever.
    #[test]
    fn a_turn_at_the_end_ends_it() {
        // Found in random starts, and next to a member of a family; then at quarter turns of the body, at rest on arrival.
        let found = (
            Ratios::new(2.0, 1.677_050_983_124_842_1).unwrap(),
            DrivePhase::of_half_turn(9, 1.570_796_326_794_887_7),
            3.022_314_549_036_573e23,
            1.437_112_669_326_197_2e39,
        );
        let family = (
            Ratios::new(0.5, 12.0).unwrap(),
            DrivePhase::of_half_turn(1, -std::f64::consts::FRAC_PI_2),
            14.624_326_256_136_987,
            -1e-15,
        );
        for (ratios, phase, x, w) in [found, family] {
            for by in -40..=40 {
                let w = w * (1.0 + f64::from(by) * f64::EPSILON);
                for half_turns in 1..=4 {
                    let (from, free) = (Point { phase, x, w }, &mut Budget::of(0));
                    let propagation =
                        propagate(Equation::new(ratios), from, half_turns, 1.0, Vec::new(), free).unwrap();
                    assert!(
                        propagation.end.x.is_finite() && propagation.end.w.is_finite(),
                        "{ratios:?} {x:e} {w:e}: {propagation:?}"
                    );
                    assert!(propagation.parts.len() < 16, "{propagation:?}");
                    assert!(matches!(propagation.parts.last(), Some(Part::Onward(..) | Part::Stick(..))));
                }
            }
        }
    }
}
