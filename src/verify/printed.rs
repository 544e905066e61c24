//! Equations that are wrong as printed, at points where they fail.

use super::{Case, Digits, Identity, Residual, Standing};
use crate::float::Float;
use crate::nonsticking::{matching::pi_1, printed};

fn refuted<F>(
    equation: &'static str,
    statement: &'static str,
    residual: fn(&Case<'_, F>) -> Option<F>,
) -> Identity<F> {
    Identity {
        equation,
        statement,
        standing: Standing::Refuted,
        digits: Digits::All,
        residual: Residual::OfCase(residual),
    }
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    vec![
        refuted("43", "as printed, π/2 < ω_d t₂ < 3π/2, fails where K > 0", |c| {
            (c.k > F::int(0)).then(|| {
                let sine = c.unknowns.max_displacement / c.given.amplitude;
                (printed::displacement_phase(sine) - c.unknowns.displacement_phase) * c.scale
            })
        }),
        refuted("49", "as printed, both roots positive, fails for Ω > 1", |c| {
            (c.given.omega > F::int(1)).then(|| {
                let cos_pi_1 = pi_1(c.given.omega).cos();
                let wrong = printed::max_velocity(c.given.omega, c.alpha, cos_pi_1, c.unknowns.deviation);
                (wrong / c.answers.max_velocity - F::int(1)) * c.scale
            })
        }),
        refuted("61", "as printed, sufficient, fails between 1/(2n+1) and 1/(2n)", |c| {
            (c.k > F::int(0)).then(|| {
                let edge = c.formulae.edge(&c.phase_function);
                (edge.min_force_ratio / edge.turning_point - F::int(1)) * c.scale
            })
        }),
    ]
}
