//! The answers checked against eq. 21–25 solved by Newton's method, which uses none of them.

use super::followed::apart;
use super::{Case, Digits, Identity, Residual, Standing};
use crate::float::Float;
use crate::nonsticking::matching::newton::Solution;

/// A difference of two numbers of this `size`, relative to the accuracy of the solution.
fn in_good_digits<F: Float>(c: &Case<'_, F>, s: &Solution<F>, difference: F, size: F) -> F {
    let lost = F::exp2i((s.lost_bits as i32).min(F::RATIO_EXPONENT));
    difference / (size * lost) * c.scale
}

macro_rules! solved {
    ($($equation:literal $statement:literal: |$c:ident, $s:ident| $difference:expr, $size:expr);+ $(;)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            standing: Standing::Holds,
            digits: Digits::All,
            residual: Residual::OfCase(|$c: &Case<'_, F>| {
                let $s = $c.solved.as_ref()?;
                Some(in_good_digits($c, $s, $difference, $size))
            }),
        }),+]
    };
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    solved![
        "21–25" "Newton's method: Δ₀":
            |c, s| s.unknowns.max_displacement - c.unknowns.max_displacement, s.unknowns.max_displacement;
        "21–25" "Newton's method: ω_d t₂":
            |c, s| apart(s.unknowns.displacement_phase, c.unknowns.displacement_phase), F::int(1);
        "21–25" "Newton's method: V₀":
            |c, s| s.unknowns.max_velocity - c.unknowns.max_velocity, s.unknowns.max_velocity;
        "21–25" "Newton's method: ω_d t₁, before t₂":
            |c, s| s.unknowns.velocity_phase - c.unknowns.velocity_phase, F::int(1);
        "21–25" "Newton's method: Δ₁":
            |c, s| s.unknowns.deviation - c.unknowns.deviation, c.scale;
        "25" "Newton's method: no instant of its rising branch is faster than V₀":
            |c, s| {
                let (g, u, n) = (&c.given, &s.unknowns, points(c.given.omega));
                (1..n).fold(F::int(0), |most, i| {
                    let phase = u.displacement_phase - F::pi() * F::ratio(i, n);
                    most.or_larger(g.rising_velocity(u, phase) - c.unknowns.max_velocity)
                })
            }, s.unknowns.max_velocity;
    ]
}

/// The number of points in a half cycle: eight per free oscillation of the spring.
pub(super) fn points<F: Float>(omega: F) -> i32 {
    (16.0 + 8.0 / omega.to_f64()) as i32
}
