//! The border: the cycle there by Newton's method, the exact motion on either side, and the maximum of the
//! dissipation.
//!
//! On the border of the two-reversal cycle the body is about to stop: either the excess force at the turning
//! point is r_y, or the velocity touches zero once on the way. With less force there is a stop; with more
//! there is none.

use super::solved::points;
use super::{Case, Digits, Identity, Residual, Standing};
use crate::float::Float;
use crate::nonsticking::matching::newton::Solution;

use super::edge::OnBorder;
macro_rules! on_border {
    ($($equation:literal $digits:ident $statement:literal: |$c:ident, $b:ident| $residual:expr),+ $(,)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            standing: Standing::Holds,
            digits: Digits::$digits,
            residual: Residual::OfCase(|$c: &Case<'_, F>| { let $b = $c.on_border.as_ref()?; $residual }),
        }),+]
    };
}

/// A residual in units of `size`, relative to the accuracy of the solution.
fn relative<F: Float>(c: &Case<'_, F>, s: &Solution<F>, residual: F, size: F) -> Option<F> {
    let lost = F::exp2i((s.lost_bits as i32).min(F::RATIO_EXPONENT));
    Some(residual / (size * lost) * c.scale)
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    on_border![
        "58, 59" All "Newton's method with α free: the turning point's border": |c, b| {
            let per_turn = (F::int(1) + F::int(1) / c.given.omega).square();
            Some((b.turning_point? / b.edge.turning_point - F::int(1)) / per_turn * c.scale)
        },
        "62" All "Newton's method on the border: nowhere in the half cycle does the body go back": |c, b| {
            let s = b.solved.as_ref()?;
            let (g, u, n) = (given(c, b), &s.unknowns, points(c.given.omega));
            let most = (1..n).fold(F::int(0), |most, i| {
                most.or_larger(g.falling_velocity(u, u.displacement_phase + F::pi() * F::ratio(i, n)))
            });
            relative(c, s, most, u.max_velocity)
        },
        "62" All "Newton's method on the border: at τ* the velocity and the acceleration are zero": |c, b| {
            let s = b.solved.as_ref()?;
            let (g, u) = (given(c, b), &s.unknowns);
            let phase = u.displacement_phase + b.edge.phase;
            let x = g.falling_displacement(u, phase);
            let acceleration = b.edge.min_force_ratio * phase.sin() - x + F::int(1);
            let velocity = g.falling_velocity(u, phase);
            relative(c, s, acceleration.abs() + velocity.abs(), F::int(1) + u.max_displacement + u.max_velocity)
        },
        "62" All "Newton's method on the border: Δ₀/B is S": |c, b| {
            let s = b.solved.as_ref()?;
            relative(c, s, s.unknowns.max_displacement - b.edge.least_displacement, b.edge.least_displacement)
        },
        "62" All "the exact motion stops just below the border, and not above": |c, b| {
            let (below, above) = b.stops?;
            Some(if below > 0 && above == 0 { F::int(0) } else { c.scale })
        },
        "65" Half "A₁ of the exact motion is stationary at α*, by differences": |c, b| {
            Some(b.optimum?.1 * c.scale)
        },
        "66" All "A₁ of the exact motion at α* is A₁max": |c, b| {
            let most = c.formulae.best_loop_size_at(&c.phase_function);
            Some((b.optimum?.0 / most - F::int(1)) * c.scale)
        },
    ]
}

/// The data of the matching problem on the border.
fn given<F: Float>(c: &Case<'_, F>, b: &OnBorder<F>) -> crate::nonsticking::matching::Given<F> {
    let amplitude = b.edge.min_force_ratio / c.one_minus_square;
    crate::nonsticking::matching::Given { amplitude, ..c.given }
}
