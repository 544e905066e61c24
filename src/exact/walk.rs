//! From one phase of the drive to another, through whatever happens in between, with what a disturbance becomes.

use super::drive::DrivePhase;
use super::equation::Equation;
use super::matrix::Matrix;
use super::motion::Motion;
use super::slide::Slide;
use super::stick::Stick;
use super::trajectory::Next;
use super::velocity_zero::VelocityZero;
use crate::float::Float;

/// A point of the motion: displacement x/B and velocity `w = Ωv` at a phase of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point<F> {
    pub(crate) phase: DrivePhase<F>,
    pub(crate) x: F,
    pub(crate) w: F,
}

/// A part of the walk: a slide or a stop, or as much of it as lies within.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Part<F> {
    /// A slide, and the velocity zero that ends it.
    Slide(Slide<F>, VelocityZero<F>),
    /// A slide that goes on: its length in natural time, the phase and the motion there.
    Onward(Slide<F>, F, DrivePhase<F>, Motion<F>),
    /// A stop, and its length as a phase.
    Stick(Stick<F>, F),
}

/// A walk of some half turns.
#[derive(Debug)]
pub(crate) struct Walk<F> {
    pub(crate) end: Point<F>,
    /// (δx, δw) at the end for that at the beginning.
    pub(crate) monodromy: Matrix<F>,
    pub(crate) parts: Vec<Part<F>>,
}

/// The walk of `half_turns` from a point on. `hint` is the natural time to the first velocity zero, where one is expected.
///
/// A motion has at most about `1 + 1/Ω` velocity zeros in half a turn, with a few slides and stops at each. A walk of eight times as
/// many parts would be no motion: it ends, nowhere (NaN). None is known.
pub(crate) fn walk<F: Float>(
    equation: Equation<F>,
    from: Point<F>,
    half_turns: i64,
    hint: F,
    mut parts: Vec<Part<F>>,
) -> Walk<F> {
    parts.clear();
    let (zero, usual) = (F::int(0), F::pi() / equation.omega);
    let target = from.phase.later_by_half_turns(half_turns);
    let mut monodromy = Matrix::identity();
    let mut hint = hint;
    let mut next = Next::from(equation, from.phase, from.x, from.w);
    if matches!(next, Next::Stick(_)) {
        monodromy = monodromy.after_zero(zero);
    }
    let most = 64.0 + 32.0 * half_turns as f64 * (1.0 + 1.0 / equation.omega.to_f64());
    loop {
        if parts.len() as f64 > most {
            let nowhere = F::from_f64(f64::NAN);
            return Walk { end: Point { phase: target, x: nowhere, w: nowhere }, monodromy, parts };
        }
        match next {
            Next::Stick(stick) => match stick.release {
                Some((phase, direction)) if target.since(phase) > zero => {
                    parts.push(Part::Stick(stick, phase.since(stick.start)));
                    next = Next::Slide(Slide::released(equation, phase, stick.x, direction));
                }
                _ => {
                    parts.push(Part::Stick(stick, target.since(stick.start)));
                    return Walk { end: Point { phase: target, x: stick.x, w: zero }, monodromy, parts };
                }
            },
            Next::Slide(slide) => {
                let limit = target.since(slide.start) / equation.omega;
                match slide.until(hint, Some(limit)) {
                    Ok(end) => {
                        parts.push(Part::Slide(slide, end));
                        next = Next::after(&slide, &end).0;
                        let ratio = match &next {
                            Next::Slide(_) if end.grazes => F::int(1),
                            Next::Slide(s) => s.acceleration / end.acceleration,
                            Next::Stick(_) => zero,
                        };
                        monodromy = monodromy.after_slide(end.rotation).after_zero(ratio);
                        hint = usual;
                    }
                    Err(motion) => {
                        let motion = motion.unwrap_or_else(|| slide.motion(limit));
                        let end = Point { phase: target, x: motion.x, w: motion.w };
                        parts.push(Part::Onward(slide, limit, target, motion));
                        let monodromy = monodromy.after_slide(motion.rotation);
                        return Walk { end, monodromy, parts };
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Part, Point, walk};
    use crate::Ratios;
    use crate::exact::DrivePhase;
    use crate::exact::equation::Equation;

    #[test]
    fn the_monodromy_is_the_derivative_of_the_walk() {
        for (omega, alpha, theta, x, w) in [
            (0.7, 2.0, 0.1, -0.4, 1.0),
            (0.4, 6.0, 0.3, -0.5, 2.0),
            (1.5, 2.5, -1.0, 0.2, -1.0),
            (0.13, 3.0, 0.2, 0.1, 0.4),
        ] {
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let phase = DrivePhase::new(theta).unwrap();
            let at = |x, w| walk(equation, Point { phase, x, w }, 2, 1.0, Vec::new());
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
                    let walk =
                        walk(Equation::new(ratios), Point { phase, x, w }, half_turns, 1.0, Vec::new());
                    assert!(
                        walk.end.x.is_finite() && walk.end.w.is_finite(),
                        "{ratios:?} {x:e} {w:e}: {walk:?}"
                    );
                    assert!(walk.parts.len() < 16, "{walk:?}");
                    assert!(matches!(walk.parts.last(), Some(Part::Onward(..) | Part::Stick(..))));
                }
            }
        }
    }
}
