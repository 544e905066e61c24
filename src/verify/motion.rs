//! The answers checked against the exact motion, which uses none of them: it starts from rest and is computed
//! slide by slide.

use super::followed::apart;
use super::{Case, Digits, Identity, Residual, Standing};
use crate::float::Float;

macro_rules! moving {
    ($($equation:literal $digits:ident $statement:literal: |$c:ident, $m:ident| $residual:expr),+ $(,)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            standing: Standing::Holds,
            digits: Digits::$digits,
            residual: Residual::OfCase(|$c: &Case<'_, F>| { let $m = $c.motion.as_ref()?; $residual }),
        }),+]
    };
}

/// 0 if a count is as expected, and otherwise a large residual.
pub(super) fn count<F: Float>(found: u32, expected: u32) -> F {
    if found == expected { F::int(0) } else { F::int(1) }
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    moving![
        "44" All "Δ₀ is that of the exact motion": |c, m| {
            Some(c.within(m.steady.max_displacement.value - c.answers.max_displacement, c.scale, m.doubt))
        },
        "43" All "ω_d t₂ is that of the exact motion": |c, m| {
            // An error of a phase changes the velocity by that error times the acceleration before the
            // reversal.
            let phase = apart(m.steady.max_displacement.phase.reduced(), c.answers.displacement_phase);
            let acceleration = c.given.omega.square() * m.steady.max_displacement.value + F::int(1);
            Some(c.within(phase * acceleration / c.given.omega, c.scale / c.given.omega, m.doubt))
        },
        "49" All "V₀ is the greatest velocity of the exact motion": |c, m| {
            let velocity = (m.steady.max_velocity.value - c.answers.max_velocity) * c.given.omega;
            Some(c.within(velocity, c.scale * (c.given.omega + F::int(1)), m.doubt))
        },
        "46" All "ω_d t₁ is that of the exact motion": |c, m| {
            let phase = apart(m.steady.max_velocity.phase.reduced(), c.answers.velocity_phase);
            let velocity = m.steady.max_velocity.value * c.given.omega;
            let jerk = c.alpha * c.given.omega * m.steady.max_velocity.phase.reduced().cos() - velocity;
            Some(c.within(phase * jerk / c.given.omega, c.scale * (c.given.omega + F::int(1) / c.given.omega), m.doubt))
        },
        "62" All "the exact motion has two reversals a cycle and no stop": |c, m| {
            let steady = &m.steady;
            Some((count::<F>(steady.sticks_per_cycle, 0) + count(steady.velocity_zeros_per_cycle, 2)) * c.scale)
        },
        "64" All "A₁ is the work against friction": |c, m| {
            let work = c.answers.loop_size_stiffness * c.alpha.square() / F::int(2);
            Some(c.within((m.steady.energy_out - work) / F::int(4), c.scale, m.doubt))
        },
        "67" All "A₂ is Ω² times the work of the drive": |c, m| {
            let work = c.answers.loop_size_inertia * (c.alpha / c.given.omega).square() / F::int(2);
            let terms = c.alpha * c.scale;
            Some(c.within(m.steady.energy_in - work, terms, c.alpha * m.doubt))
        },
        "λ" All "λ₁² + λ₂² and λ₁²λ₂² are those of the exact motion's linearised cycle": |c, m| {
            let [(a, b), (p, q)] = m.steady.multipliers;
            let (trace, product) = (a + p, a * p - b * q);
            let (sum, determinant) = half_cycle(c);
            let off = (sum.square() - F::int(2) * determinant - trace).abs() + (determinant.square() - product).abs();
            Some(c.within(off, F::int(1) + F::int(1) / c.given.omega, m.doubt))
        },
        "λ" Half "λ₁ + λ₂ and λ₁λ₂, with their signs, are those of the exact half cycle by differences": |c, m| {
            let ((trace, product), (sum, determinant)) = (m.half_map?, half_cycle(c));
            Some(((trace - sum).abs() + (product - determinant).abs()) * c.scale)
        },
        "λ" All "the contraction is the larger |λ|": |c, m| {
            let squared = m.steady.contraction();
            let found = c.answers.contraction;
            let [(a, b), (p, q)] = c.answers.multipliers.parts();
            let listed = a.hypot(b).or_larger(p.hypot(q));
            // A double root keeps half of the digits.
            let off = (found - listed).abs().or_larger((found.square() - squared).square());
            Some(c.within(off, F::int(1) + F::int(1) / c.given.omega, m.doubt))
        },
    ]
}

/// Sum and product of the half-cycle multipliers among the answers.
fn half_cycle<F: Float>(c: &Case<'_, F>) -> (F, F) {
    let [(a, b), (p, q)] = c.answers.multipliers.parts();
    (a + p, a * p - b * q)
}
