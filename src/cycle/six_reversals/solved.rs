//! The equations of a cycle of six reversals, solved.

use super::equations::{Closing, Problem, Unknowns};
use super::newton;
use crate::float::{Float, at_precision};

/// The cycle with the force as `αΩ²/q`, if the equations have a solution that belongs to the pole.
pub(super) fn at_force<F: Float>(problem: &Problem<F>, force: F) -> Option<Unknowns<F>> {
    let start = followed(problem, force)?;
    solved(problem, Closing::Force(force), start)
}

/// A solution from a start that is close to it.
pub(super) fn solved<F: Float>(
    problem: &Problem<F>,
    closing: Closing<F>,
    start: Unknowns<F>,
) -> Option<Unknowns<F>> {
    newton::polished(problem.omega, start, |y| problem.residuals(y, closing))
}

/// The solution for a force followed from the pole without damping, where it is a closed form, in steps of ζ
/// and of the distance.
pub(super) fn followed<F: Float>(problem: &Problem<F>, force: F) -> Option<Unknowns<F>> {
    at_precision!(narrowed, <'a, F>(problem: &'a Problem<F>, force: F) -> Option<Unknowns<F>>, |there, back: G| {
        let (problem, force) = (problem.map(&there), there(force));
        let mut y = at_the_pole(problem.omega, force)?;
        for step in 1..=STEPS {
            y = solved(&problem.towards_the_pole(G::ratio(step, STEPS)), Closing::Force(force), y)?;
        }
        Some(y.map(back))
    })
}

/// Steps from the pole.
pub(super) const STEPS: i32 = 16;

/// The cycle at a pole with this Ω: `a = b = π/3`, `s = −1/κ(π/3)`, `p = −c μ(π/3)`.
pub(super) fn at_the_pole<F: Float>(omega: F, force: F) -> Option<Unknowns<F>> {
    let third = F::pi() / F::int(3);
    let root = F::int(3).sqrt();
    let (slow_sine, slow_cosine) = (omega * third).sin_cos();
    let sine = -root / (F::int(2) * slow_cosine - F::int(1));
    let square = force.square() - (omega * sine).square();
    let cosine = square.sqrt();
    let swing = -cosine * slow_sine * F::int(2) / (omega * root);
    (square > F::int(0)).then_some(Unknowns { before: third, after: third, sine, cosine, swing })
}
