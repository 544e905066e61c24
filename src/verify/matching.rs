//! Eq. 3 and 11–39: the two branches and the matching conditions.

use super::terms::{Claim, Terms};
use crate::float::Real;
use crate::nonsticking::matching::half_period_later;

macro_rules! holding {
    ($($equation:literal $statement:literal: |$c:ident| $residual:expr),+ $(,)?) => {
        vec![$(Claim { equation: $equation, statement: $statement, residual: |$c: &Terms<'_, F>| Some($residual) }),+]
    };
}
pub(super) use holding;

/// `a`, `b` and ρ (eq. 30, 31, 27).
fn coefficients<F: Real>(c: &Terms<'_, F>) -> (F, F, F) {
    let (g, u) = (&c.given, &c.unknowns);
    (c.formulae.coefficient_a(g, u), c.formulae.coefficient_b(g, u), c.formulae.rho(g, u))
}

fn lag<F: Real>(c: &Terms<'_, F>) -> (F, F) {
    c.given.lag(&c.unknowns).sin_cos()
}

pub(super) fn identities<F: Real>() -> Vec<Claim<F>> {
    holding![
        "3" "x(t₄) = −Δ₀, half a period after t₂": |c| {
            c.formulae.falling_displacement(&c.given, &c.unknowns, half_period_later(c.unknowns.displacement_phase))
                + c.unknowns.max_displacement
        },
        "11" "x₁(t₁) = Δ₁": |c| {
            c.formulae.rising_displacement(&c.given, &c.unknowns, c.unknowns.velocity_phase) - c.unknowns.deviation
        },
        "12" "x₂(t₃) = −Δ₁": |c| {
            c.formulae.falling_displacement(&c.given, &c.unknowns, half_period_later(c.unknowns.velocity_phase))
                + c.unknowns.deviation
        },
        "13" "x₁′(t₁) = V₀": |c| {
            c.formulae.rising_velocity(&c.given, &c.unknowns, c.unknowns.velocity_phase) - c.unknowns.max_velocity
        },
        "14" "x₂′(t₃) = −V₀": |c| {
            c.formulae.falling_velocity(&c.given, &c.unknowns, half_period_later(c.unknowns.velocity_phase))
                + c.unknowns.max_velocity
        },
        "17" "x₁′(t₂) = 0": |c| c.formulae.rising_velocity(&c.given, &c.unknowns, c.unknowns.displacement_phase),
        "18" "x₂′(t₂) = 0": |c| c.formulae.falling_velocity(&c.given, &c.unknowns, c.unknowns.displacement_phase),
        "19" "x₁(t₂) = Δ₀": |c| {
            c.formulae.rising_displacement(&c.given, &c.unknowns, c.unknowns.displacement_phase) - c.unknowns.max_displacement
        },
        "20" "x₂(t₂) = Δ₀": |c| {
            c.formulae.falling_displacement(&c.given, &c.unknowns, c.unknowns.displacement_phase) - c.unknowns.max_displacement
        },
        "21" "matching: x₁′(t₂) = 0": |c| { let [e, ..] = c.formulae.residuals(&c.given, &c.unknowns); e },
        "22" "matching: x₂′(t₂) = 0": |c| { let [_, e, ..] = c.formulae.residuals(&c.given, &c.unknowns); e },
        "23" "matching: x₁(t₂) = Δ₀": |c| { let [_, _, e, ..] = c.formulae.residuals(&c.given, &c.unknowns); e },
        "24" "matching: x₂(t₂) = Δ₀": |c| { let [_, _, _, e, _] = c.formulae.residuals(&c.given, &c.unknowns); e },
        "25" "matching: x″(t₁) = 0": |c| { let [.., e] = c.formulae.residuals(&c.given, &c.unknowns); e },
        "27" "ρ, what swings at ω_n at t₁, brings the body to rest at t₂": |c| {
            let (s, cosine) = lag(c);
            let (rho, x) = (coefficients(c).2, c.given.offset(&c.unknowns));
            c.given.amplitude * c.given.omega * c.unknowns.displacement_phase.cos() + rho * cosine - x * s
        },
        "37" "ρ has the sign of 1 − Ω": |c| {
            let rho = coefficients(c).2;
            rho * c.sign - rho.abs()
        },
        "28" "a cos θ + b sin θ = 0": |c| c.given.elimination_of_rate(&c.unknowns),
        "29" "a sin θ − b cos θ = 2B": |c| c.given.elimination_of_position(&c.unknowns),
        "32" "a² + b² = 2(1 + cos π₁)(ρ² + X²)": |c| {
            let (a, b, _) = coefficients(c);
            c.near_pole(a.square() + b.square() - c.given.squared_coefficients(&c.unknowns))
        },
        "33" "cos θ = −2Bb/(a² + b²)": |c| {
            (lag(c).1 - c.given.cos_lag_from_coefficients(&c.unknowns)) * c.one_plus_cos()
        },
        "34" "sin θ = 2Ba/(a² + b²)": |c| {
            (lag(c).0 - c.given.sin_lag_from_coefficients(&c.unknowns)) * c.one_plus_cos()
        },
        "35" "a² + b² = 4B²": |c| {
            let (a, b, _) = coefficients(c);
            a.square() + b.square() - F::int(4)
        },
        "36" "ρ² = 2B²/(1 + cos π₁) − X²": |c| {
            c.near_pole((coefficients(c).2.square() - c.formulae.squared_rho(&c.given, &c.unknowns)) * c.one_plus_cos())
        },
        "37" "V₀/ω_n = AΩ cos ω_d t₁ + sgn(1−Ω) √ρ²": |c| {
            // The factor ρ restores the digits: the root of a small difference keeps only half of them.
            let left = c.formulae.max_velocity(&c.given, &c.unknowns, c.sign) - c.unknowns.max_velocity;
            c.near_pole(left * coefficients(c).2 * c.one_plus_cos())
        },
        "38" "cos θ = −b/(2B)": |c| lag(c).1 - c.given.cos_lag(&c.unknowns),
        "39" "sin θ = a/(2B)": |c| lag(c).0 - c.given.sin_lag(&c.unknowns),
        "45" "(1 + cos π₁)(B cos θ − X) + B sin π₁ sin θ = 0": |c| c.given.combined_lag(&c.unknowns),
    ]
}
