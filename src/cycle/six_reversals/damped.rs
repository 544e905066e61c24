//! The cycle of six reversals with a damper, which exists for small damping, and its force ratios with a static
//! friction above the kinetic one.
//!
//! # The matching problem
//!
//! Free vibration is `e^{Au}`, `A = [[0, 1], [−1, −2ζ]]`, with the waves C, S, D of [`equations::Wave`]. With
//! the reversals σ = (1, −1, 1) at −a, 0, b and the free vibration g at the second of them, displacement with
//! friction's part and velocity are
//!
//! ```text
//! z(u) = forced wave + e^{Au} g + Σ σ_j sgn(u_j − u) e^{A(u − u_j)} (1, 0)ᵀ.
//! ```
//!
//! It is antisymmetric, z(u + T) = −z(u), where g is the contribution of the reversals:
//!
//! ```text
//! cosh(AT/2) g = sinh(AT/2) w,     w = Σ σ_j e^{−Au_j} (1, 0)ᵀ = (C(a) + C(−b) − 1, −S(a) − S(−b)).
//! ```
//!
//! `J = (A + ζ)/d` has J² = −1, so that with β = dT/2 and t = tanh(ζT/2) this is
//!
//! ```text
//! (cos β − t sin β J) g + (t cos β − sin β J) w = 0,
//! ```
//!
//! smooth where cos β and t vanish. The velocity is zero at the reversals: with s and c as without damping,
//! `κ(u) = (cos Ωu − D(u))/S(u)` and `μ(u) = sin Ωu/(ΩS(u))`,
//!
//! ```text
//! g₂ = s − S(a) + S(−b),
//! cμ(−a) + g₁ + sκ(−a) = 1 + C(a) − C(−b),      −cμ(b) − g₁ − sκ(b) = 1 + C(−b) − C(a).
//! ```
//!
//! At ζ = 0 they are the equations of [`super`]. Damping takes the pole away, and with it the endless force
//! ratios there: the cycle exists where both cot β and t are small.
//!
//! # Proved and searched statements
//!
//! As without damping, and with it without an exception: a cycle that is found is the limit of every start.
//! That there is no other motion without a stop below the border is searched, against the exact motion
//! (`docs/theory/six-reversals.md`).

mod edges;
mod equations;

use super::equations::{Closing, Unknowns};
use super::{at_the_pole, newton};
use crate::float::{Float, at_precision};
use crate::machine::ratios::Ratios;
pub(crate) use edges::force_ratios;
pub(super) use equations::Problem;

/// The least and the greatest force ratio of six reversals at the Ω, ζ and η of these ratios.
pub(crate) fn force_ratios_of<F: Float>(ratios: &Ratios<F>) -> Option<(F, F)> {
    force_ratios(ratios.omega(), ratios.damping_ratio(), ratios.static_friction_ratio())
}

/// Whether α is between them; the rounded edges themselves belong to the cycle.
pub(crate) fn is_within<F: Float>(ratios: &Ratios<F>) -> bool {
    // On the edges AΩ² is nowhere below 4, and q above 3/4.
    let is_strong_enough = ratios.alpha() * ratios.omega().square() > F::int(3);
    is_strong_enough
        && force_ratios_of(ratios).is_some_and(|(low, high)| low <= ratios.alpha() && ratios.alpha() <= high)
}

/// The cycle at an Ω < 1/2 and a ζ > 0 with the force as `αΩ²/q`, if the equations have a solution that
/// belongs to the pole.
pub(super) fn at_force<F: Float>(problem: &Problem<F>, force: F) -> Option<Unknowns<F>> {
    let start = followed(problem, force)?;
    solved(problem, Closing::Force(force), start)
}

/// A solution from a start that is close to it.
fn solved<F: Float>(problem: &Problem<F>, closing: Closing<F>, start: Unknowns<F>) -> Option<Unknowns<F>> {
    newton::polished(problem.omega, start, |y| problem.residuals(y, closing))
}

/// The solution for a force followed from the pole without damping, where it is a closed form, in steps of ζ
/// and of the distance.
fn followed<F: Float>(problem: &Problem<F>, force: F) -> Option<Unknowns<F>> {
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
const STEPS: i32 = 16;
