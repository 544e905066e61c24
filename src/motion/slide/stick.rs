//! Sticking: the body at rest until the remaining force reaches the friction force.
//!
//! At rest at x friction balances `α sin θ − x` (in units of r_y), up to η. The body is released forward
//! where `α sin θ` increases through `x + η` and backward where it decreases through `x − η`: at an arcsine,
//! or never.

use super::Direction;
use super::equation::Equation;
use crate::float::Float;
use crate::motion::drive_phase::DrivePhase;

/// A stop: the body at rest at x until a phase in closed form, or for ever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stick<F> {
    pub(crate) equation: Equation<F>,
    pub(crate) start: DrivePhase<F>,
    pub(crate) x: F,
    /// The phase and direction of the release; `None` if the body rests for ever, that is if `|x| ≤ η − α`.
    ///
    /// Accuracy at f64: that of x divided by the drive's rate of change there, `α cos θ`.
    pub(crate) release: Option<(DrivePhase<F>, Direction)>,
}

impl<F: Float> Stick<F> {
    /// The stop at x from the phase `start` on, where `|α sin θ − x| ≤ η` to within rounding.
    pub(crate) fn new(equation: Equation<F>, start: DrivePhase<F>, x: F) -> Self {
        Self::until(equation, start, x, false)
    }

    /// The stop at x from the phase `start` on, with the force at its bound and about to decrease: the next
    /// release is in another half turn.
    pub(crate) fn held(equation: Equation<F>, start: DrivePhase<F>, x: F) -> Self {
        Self::until(equation, start, x, true)
    }

    fn until(equation: Equation<F>, start: DrivePhase<F>, x: F, falling: bool) -> Self {
        let rising = if start.is_even() { Direction::Forward } else { Direction::Backward };
        let here = if falling { None } else { release(&equation, start, x, rising, false) };
        // In the present half turn the force increases towards one bound only.
        if let Some(phase) = here {
            return Self { equation, start, x, release: Some((phase, rising)) };
        }
        let forward = release(&equation, start, x, Direction::Forward, falling);
        let backward = release(&equation, start, x, Direction::Backward, falling);
        let first = match (forward, backward) {
            (Some(f), Some(b)) if b.since(f) < F::int(0) => Some((b, Direction::Backward)),
            (Some(f), _) => Some((f, Direction::Forward)),
            (None, Some(b)) => Some((b, Direction::Backward)),
            (None, None) => None,
        };
        Self { equation, start, x, release: first }
    }

    /// The duration as a phase; `None` for a stop that never ends.
    pub(crate) fn duration(&self) -> Option<F> {
        self.release.map(|(end, _)| end.since(self.start))
    }
}

/// The tolerance within which the friction force counts as at its bound: the rounding of `α sin θ − x`.
#[inline]
pub(crate) fn force_rounding<F: Float>(equation: &Equation<F>, x: F) -> F {
    F::int(4) * F::epsilon() * (equation.alpha + x.abs() + equation.static_friction)
}

/// The angle within its half turn at which the body is released in one direction; `None` if the force never
/// exceeds friction.
///
/// It solves `α sin θ = y = η ± x`. A maximum of the force that exceeds the bound by no more than its
/// rounding does not count where it moves the body by less than x can resolve. It counts where the body leaves with an
/// acceleration, η > 1, and next to x = 0: an excess e moves it by about `9e²/2Ω²`.
pub(crate) fn release_angle<F: Float>(equation: &Equation<F>, x: F, direction: Direction) -> Option<F> {
    let Equation { alpha, static_friction, .. } = *equation;
    let sign = direction.sign::<F>();
    let y = static_friction + sign * x;
    // This form avoids the rounding of y, which matters where α is close to η.
    let above = (alpha - static_friction) - sign * x;
    let is_felt = || equation.has_higher_static_friction() || above.square() >= F::epsilon() * x.abs();
    let exceeds = above > force_rounding(equation, x) || above > F::int(0) && is_felt();
    if !exceeds {
        return None;
    }
    let below = alpha + y;
    let product = if below > F::int(0) { above * below } else { F::int(0) };
    Some(y.atan2(product.sqrt()))
}

/// The phase of the release in one direction, from the phase `now` on.
///
/// The backward direction is the mirror image of the forward one: x → −x and half a turn later. `α sin θ = y
/// = x + η` with cos θ > 0 has one solution in each even half turn, where y < α. `falling`: the present half
/// turn does not count.
fn release<F: Float>(
    equation: &Equation<F>,
    now: DrivePhase<F>,
    x: F,
    direction: Direction,
    falling: bool,
) -> Option<DrivePhase<F>> {
    let rounding = force_rounding(equation, x);
    let y = equation.static_friction + direction.sign::<F>() * x;
    let angle = release_angle(equation, x, direction)?;
    let rises = now.is_even() == (direction == Direction::Forward);
    if !rises {
        return Some(now.in_half_turn(1, angle));
    }
    if falling {
        return Some(now.in_half_turn(2, angle));
    }
    // The force is within rounding of the bound and rising: the body is released now.
    let force = equation.alpha * now.angle().sin();
    if y - force <= rounding {
        return Some(now);
    }
    Some(DrivePhase::of_half_turn(now.half_turns(), angle))
}

#[cfg(test)]
mod tests {
    use super::{Stick, force_rounding};
    use crate::Ratios;
    use crate::motion::DrivePhase;
    use crate::motion::slide::Direction;
    use crate::motion::slide::equation::Equation;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn stick(alpha: f64, theta: f64, x: f64) -> Stick<f64> {
        let equation = Equation::new(Ratios::new(0.7, alpha).unwrap());
        Stick::new(equation, DrivePhase::of(theta).unwrap(), x)
    }

    #[test]
    fn rounding_is_that_of_three_terms() {
        // 4 ε (α + |x| + η)
        let ratios = Ratios::new(0.7, 3.0).unwrap();
        let equations = [1.0, 2.0].map(|eta| Equation::new(ratios.with_static_friction_ratio(eta).unwrap()));
        let found = equations.map(|equation| [-2.0, 2.0].map(|x| force_rounding(&equation, x)));
        assert_eq!(found, [[24.0 * f64::EPSILON; 2], [28.0 * f64::EPSILON; 2]]);
    }

    #[test]
    fn gives_way_where_the_force_reaches_the_bound() {
        for (alpha, theta, x) in
            [(2.0f64, 0.0f64, 0.0f64), (1.3, 3.0, 0.2), (4.0, -0.3, -1.5), (1.3, 1.8, 0.3)]
        {
            let s = stick(alpha, theta, x);
            let (end, direction) = s.release.unwrap();
            let friction = alpha * end.sin_cos().0 - x;
            assert!((friction - direction.sign::<f64>()).abs() < 1e-14);
            // The force does not reach the bound earlier.
            let length = s.duration().unwrap();
            for i in 1..1000 {
                let before = alpha * (theta + length * f64::from(i) / 1000.0).sin() - x;
                assert!(before.abs() < 1.0 + 1e-12, "{alpha} {theta} {x}: {before}");
            }
        }
    }

    /// With static friction above the kinetic one, the force equals η at the release and was below it before.
    #[test]
    fn gives_way_at_the_static_friction() {
        for (alpha, eta, theta, x) in
            [(2.0f64, 1.3f64, 0.0f64, 0.0f64), (4.0, 2.5, 3.0, 0.2), (4.0, 1.01, -0.3, -1.5)]
        {
            let ratios = Ratios::new(0.7, alpha).unwrap().with_static_friction_ratio(eta).unwrap();
            let s = Stick::new(Equation::new(ratios), DrivePhase::of(theta).unwrap(), x);
            let (end, direction) = s.release.unwrap();
            let friction = alpha * end.sin_cos().0 - x;
            assert!((friction - eta * direction.sign::<f64>()).abs() < 1e-14, "{alpha} {eta}: {friction}");
            let length = s.duration().unwrap();
            for i in 1..1000 {
                let before = alpha * (theta + length * f64::from(i) / 1000.0).sin() - x;
                assert!(before.abs() < eta + 1e-12, "{alpha} {theta} {x}: {before}");
            }
        }
        let held = Ratios::new(0.7, 1.2).unwrap().with_static_friction_ratio(1.25).unwrap();
        assert_eq!(Stick::new(Equation::new(held), DrivePhase::of(0.3).unwrap(), 0.04).release, None);
    }

    #[test]
    fn rests_for_ever_where_the_force_is_too_small() {
        assert_eq!(stick(0.9, 0.3, 0.05).release, None);
        assert_eq!(stick(1.0, 0.3, 0.0).release, None);
        let (end, direction) = stick(0.9, 0.0, -0.2).release.unwrap();
        assert_eq!(direction, Direction::Forward);
        assert!((end.reduced() - (0.8f64 / 0.9).asin()).abs() < 1e-15);
    }

    /// A held body that both directions can release slides in the one whose half turn comes first.
    #[test]
    fn after_a_hold_the_next_half_turn_releases() {
        let equation = Equation::new(Ratios::new(0.7, 3.0).unwrap());
        for (theta, direction) in [(0.4, Direction::Backward), (0.4 + PI, Direction::Forward)] {
            let stick = Stick::held(equation, DrivePhase::of(theta).unwrap(), 0.0);
            assert_eq!(stick.release.map(|(_, direction)| direction), Some(direction));
            assert!((stick.duration().unwrap() - (PI - 0.4 + (1.0f64 / 3.0).asin())).abs() < 1e-14);
        }
    }

    #[test]
    fn at_the_bound_a_rising_force_lets_go_and_a_falling_one_holds() {
        let x = 2.0 * 0.5f64.sin() - 1.0;
        assert_eq!(stick(2.0, 0.5, x).duration(), Some(0.0));
        let falling = stick(2.0, PI - 0.5, x);
        assert_eq!(falling.release.unwrap().1, Direction::Backward);
        assert!(falling.duration().unwrap() > 0.1);
        // A force whose maximum just reaches the bound is held, too.
        assert_eq!(stick(1.5, FRAC_PI_2, 0.5).release.map(|r| r.1), Some(Direction::Backward));
    }
}
