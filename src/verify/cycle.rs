//! Eq. 15, 16, 40–67 and the multipliers: the identities of the answers themselves.

use super::followed::apart;
use super::matching::holding;
use super::terms::{Claim, Terms};
use super::{Case, Digits, Identity, Residual, Standing};
use crate::float::{Float, Real};
use crate::nonsticking::{matching::pi_1, stability};
use crate::phase_function::phase_function_of_tangent;

/// A third of the falling half cycle: its length in phase, its phase, and the phase half a period earlier.
fn on_the_way<F: Real>(c: &Terms<'_, F>) -> (F, F, F) {
    let turn = F::pi() / F::int(3);
    let falling = c.unknowns.displacement_phase + turn;
    (turn, falling, falling - F::pi())
}

/// V₀/(Bω_d) by eq. 49 with the correct signs.
fn by_49<F: Real>(c: &Terms<'_, F>) -> F {
    c.formulae.max_velocity_from_phase(
        c.given.amplitude,
        c.given.omega,
        pi_1(c.given.omega).cos(),
        c.unknowns.velocity_phase.sin_cos(),
        c.unknowns.deviation,
        c.sign,
    )
}

/// α of eq. 61, and the corresponding Δ₀/B and sin ω_d t₂.
fn at_turning_point<F: Real>(c: &Terms<'_, F>) -> (F, F, F) {
    let (k, q) = (c.k, c.one_minus_square);
    let alpha = c.formulae.turning_point_border(k, q, c.given.omega);
    let delta = c.formulae.max_displacement(k, alpha, q);
    (alpha, delta, c.formulae.sin_displacement_phase(delta, alpha, q))
}

/// A₁ at any α (eq. 64 with eq. 44).
fn loop_at<F: Real>(c: &Terms<'_, F>, alpha: F) -> F {
    let delta = c.formulae.max_displacement(c.k, alpha, c.one_minus_square);
    c.formulae.loop_size_stiffness(delta, alpha)
}

pub(super) fn identities<F: Real>() -> Vec<Claim<F>> {
    let mut claims = holding![
        "40" "A sin ω_d t₂ = Δ₀": |c| {
            c.given.amplitude * c.unknowns.displacement_phase.sin() - c.unknowns.max_displacement
        },
        "41" "A cos ω_d t₂ = BT/Ω": |c| {
            c.given.amplitude * c.unknowns.displacement_phase.cos() - c.tangent / c.given.omega
        },
        "42" "Δ₀² = A² − (BT/Ω)²": |c| {
            let (a, t) = (c.given.amplitude, c.tangent);
            let by_42 = c.formulae.max_displacement_from_amplitude(a, t, c.given.omega);
            (by_42.square() - c.unknowns.max_displacement.square()) / c.scale
        },
        "43" "sgn sin ω_d t₂ = sgn(1 − Ω), cos ω_d t₂ = K/α": |c| {
            let (sine, cosine) = c.unknowns.displacement_phase.sin_cos();
            let root = ((F::int(1) - cosine) * (F::int(1) + cosine)).sqrt() * c.sign;
            (sine - root) * sine + cosine - c.formulae.cos_displacement_phase(c.k, c.alpha)
        },
        "46" "x″(t₁) = 0 in ω_d t₁ alone": |c| {
            c.formulae.velocity_phase_residual(
                c.given.amplitude,
                c.given.omega,
                pi_1(c.given.omega).sin_cos(),
                c.given.lag(&c.unknowns),
                c.unknowns.velocity_phase.sin(),
            )
        },
        "41, 43" "K = (1 − Ω²) tan(π/2Ω)/Ω": |c| {
            let by_tangent = phase_function_of_tangent(c.given.omega, c.tangent);
            c.k - by_tangent
        },
        "44" "Δ₀/B = √[(α − K)(α + K)]/|1 − Ω²|": |c| {
            let by_44 = c.formulae.max_displacement(c.k, c.alpha, c.one_minus_square);
            (by_44.square() - c.unknowns.max_displacement.square()) / c.scale
        },
        "47" "Δ₁/B = α sin ω_d t₁ − 1": |c| {
            c.formulae.deviation(c.alpha, c.unknowns.velocity_phase.sin()) - c.unknowns.deviation
        },
        "48, 49" "V₀ = Bω_d [A/B cos ω_d t₁ + ρ/(BΩ)], signs corrected": |c| {
            c.near_pole((by_49(c) - c.answers.max_velocity) * c.formulae.rho(&c.given, &c.unknowns) * c.one_plus_cos())
        },
        "50" "Den Hartog: x(0) = Δ₀": |c| c.half.displacement(F::int(0)) - c.unknowns.max_displacement,
        "51" "Den Hartog: x′(0) = 0": |c| c.half.velocity(F::int(0)),
        "52" "Den Hartog: x(π/ω_d) = −Δ₀": |c| c.half.displacement(F::pi()) + c.unknowns.max_displacement,
        "53" "Den Hartog: x′(π/ω_d) = 0": |c| c.half.velocity(F::pi()),
        "55" "C₁ = ΩA sin φ": |c| c.half.c1 - c.given.omega * c.half.amplitude * c.half.phase_lag.sin(),
        "56" "C₂ = Δ₀ − B − A cos φ": |c| {
            c.half.c2 + F::int(1) + c.half.amplitude * c.half.phase_lag.cos() - c.unknowns.max_displacement
        },
        "57–59" "on eq. 61 the force at a reversal is r_y": |c| {
            let (alpha, delta, sine) = at_turning_point(c);
            c.formulae.slip_excess(alpha, sine, delta) / c.scale
        },
        "60" "vanishes on eq. 61": |c| {
            let (alpha, ..) = at_turning_point(c);
            c.formulae.turning_point_residual(alpha, c.given.omega, c.tangent)
                / (F::int(1) + c.given.omega.square()).square()
                / c.scale
        },
        "61" "Δ₀/B = 1/Ω² there": |c| {
            let (_, delta, _) = at_turning_point(c);
            (delta * c.given.omega.square() - F::int(1)) / c.scale
        },
        "63, 64" "A₁ = 2ks/p₀², s = 4 r_y Δ₀": |c| {
            let s = c.formulae.loop_size(c.unknowns.max_displacement);
            (F::int(2) * s / c.alpha.square() / c.answers.loop_size_stiffness - F::int(1)) * c.scale
        },
        "65, 66" "A₁(√2 |K|) = 4/(|K| |1 − Ω²|)": |c| {
            let k = c.k;
            let best = loop_at(c, c.formulae.best_force_ratio(k));
            (best / c.formulae.best_loop_size(k, c.one_minus_square) - F::int(1)) * c.scale
        },
        "64" "A₁ = 8(Δ₀/B)/α²": |c| {
            let by_64 = c.formulae.loop_size_stiffness(c.unknowns.max_displacement, c.alpha);
            (by_64 / c.answers.loop_size_stiffness - F::int(1)) * c.scale
        },
        "65" "α* as it is answered": |c| {
            (c.formulae.best_force_ratio(c.k) / c.best.0 - F::int(1)) * c.scale
        },
        "66" "A₁max as it is answered": |c| {
            (c.formulae.best_loop_size(c.k, c.one_minus_square) / c.best.1 - F::int(1)) * c.scale
        },
        "67" "A₂ as it is answered": |c| {
            let by_67 = c.formulae.loop_size_inertia(c.answers.loop_size_stiffness, c.given.omega);
            (by_67 / c.answers.loop_size_inertia - F::int(1)) * c.scale
        },
        "67" "A₂ = Ω² A₁": |c| {
            let ratio = c.answers.loop_size_inertia / c.answers.loop_size_stiffness / c.given.omega.square();
            (ratio - F::int(1)) * c.scale
        },
    ];
    claims.push(Claim {
        equation: "λ",
        statement: "the contraction is a root of λ² ± (1+s) cos π₁ λ + s, or its modulus",
        residual: contraction,
    });
    claims
}

/// The contraction by the characteristic polynomial, where it is certain whether the multipliers are complex.
fn contraction<F: Real>(c: &Terms<'_, F>) -> Option<F> {
    let s = c.formulae.multiplier_product(c.given.omega, c.unknowns.max_displacement);
    let (modulus, cos_pi_1) = (c.answers.contraction, pi_1(c.given.omega).cos());
    Some(if c.is_complex? {
        modulus.square() - s
    } else {
        stability::characteristic_polynomial(modulus, s, -cos_pi_1.abs())
    })
}

macro_rules! answered {
    ($($equation:literal $statement:literal: |$c:ident| $residual:expr),+ $(,)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            standing: Standing::Holds,
            digits: Digits::All,
            residual: Residual::OfCase(|$c: &Case<'_, F>| Some($residual)),
        }),+]
    };
}

/// The waveform at any phase, and the phases of the answers.
pub(super) fn answered<F: Float>() -> Vec<Identity<F>> {
    answered![
        "15" "x₁(t) is the waveform": |c| {
            let (_, _, rising) = on_the_way(c);
            c.formulae.rising_displacement(&c.given, &c.unknowns, rising) - c.formulae.displacement_at(&c.cycle, rising)
        },
        "15′" "x₁′(t) is its velocity": |c| {
            let (_, _, rising) = on_the_way(c);
            c.formulae.rising_velocity(&c.given, &c.unknowns, rising) - c.formulae.velocity_at(&c.cycle, rising) * c.given.omega
        },
        "16" "x₂(t) is the waveform": |c| {
            let (_, falling, _) = on_the_way(c);
            c.formulae.falling_displacement(&c.given, &c.unknowns, falling) - c.formulae.displacement_at(&c.cycle, falling)
        },
        "16′" "x₂′(t) is its velocity": |c| {
            let (_, falling, _) = on_the_way(c);
            c.formulae.falling_velocity(&c.given, &c.unknowns, falling) - c.formulae.velocity_at(&c.cycle, falling) * c.given.omega
        },
        "43" "ω_d t₂ is the angle that is answered": |c| {
            apart(
                c.formulae.displacement_phase(c.k, c.alpha, c.given.omega),
                c.unknowns.displacement_phase,
            )
        },
        "54" "Den Hartog's waveform is the same": |c| {
            let (turn, falling, _) = on_the_way(c);
            c.half.displacement(turn) - c.formulae.displacement_at(&c.cycle, falling)
        },
    ]
}
