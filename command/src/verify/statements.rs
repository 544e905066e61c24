//! The equations of the paper and of the cycle with a damper, with the answers put in.
//!
//! Each statement is a left side less a right side. Statements of the paper have no damper and apply at
//! ζ = 0; the others apply at every ζ.

use super::case::Case;
use super::verdict::{Standing, StatementVerdict};
use stickslip::cycle::{equations as eq, printed};
use stickslip::{Output, Real};

/// One statement, with its residual in units of B unless stated otherwise.
pub(super) struct Statement<C, R> {
    /// The equation's number, with a letter where the equation has parts.
    pub(super) equation: &'static str,
    /// The statement in words.
    pub(super) words: &'static str,
    pub(super) standing: Standing,
    /// The left side less the right side; `None` where the statement does not apply.
    pub(super) residual: fn(&C) -> Option<R>,
}

impl<C, R> Statement<C, R> {
    /// The verdict before the first point.
    pub(super) fn verdict(&self) -> StatementVerdict {
        StatementVerdict::of(self.equation, self.words, self.standing)
    }
}

macro_rules! statements {
    ($kind:ident, $case:ty: $($equation:literal $words:literal: |$c:ident $(, $u:ident)?| $residual:expr),+ $(,)?) => {
        vec![$(Statement {
            equation: $equation,
            words: $words,
            standing: Standing::Holds,
            residual: |$c: &$case| {
                $(let $u = &$c.unknowns;)?
                statements!(@$kind $c, $residual)
            },
        }),+]
    };
    (@paper $c:ident, $residual:expr) => { (!$c.signs.is_damped).then(|| $residual) };
    (@any $c:ident, $residual:expr) => { $residual };
}
pub(super) use statements;

/// All statements about the answers, in any arithmetic.
pub(super) fn all<R: Real>() -> Vec<Statement<Case<R>, R>> {
    [branches(), elimination(), closed_forms(), with_damper(), misprints()].into_iter().flatten().collect()
}

/// Eq. 2–25: the two branches, and the conditions that match them.
fn branches<R: Real>() -> Vec<Statement<Case<R>, R>> {
    let mut all = statements![paper, Case<R>:
        "3" "x(t₄) = −Δ₀, half a period after t₂": |c, u| {
            c.given.falling_displacement(u, eq::half_period_later(u.displacement_phase)) + u.max_displacement
        },
        "11" "x₁(t₁) = Δ₁": |c, u| c.given.rising_displacement(u, u.velocity_phase) - u.deviation,
        "12" "x₂(t₃) = −Δ₁": |c, u| {
            c.given.falling_displacement(u, eq::half_period_later(u.velocity_phase)) + u.deviation
        },
        "13" "x₁′(t₁) = V₀": |c, u| c.given.rising_velocity(u, u.velocity_phase) - u.max_velocity,
        "14" "x₂′(t₃) = −V₀": |c, u| {
            c.given.falling_velocity(u, eq::half_period_later(u.velocity_phase)) + u.max_velocity
        },
        "17" "x₁′(t₂) = 0": |c, u| c.given.rising_velocity(u, u.displacement_phase),
        "18" "x₂′(t₂) = 0": |c, u| c.given.falling_velocity(u, u.displacement_phase),
        "19" "x₁(t₂) = Δ₀": |c, u| c.given.rising_displacement(u, u.displacement_phase) - u.max_displacement,
        "20" "x₂(t₂) = Δ₀": |c, u| c.given.falling_displacement(u, u.displacement_phase) - u.max_displacement,
    ];
    all.extend(statements![any, Case<R>:
        "21" "matching: x₁′(t₂) = 0": |c| { let [e, ..] = c.matched(); Some(e) },
        "22" "matching: x₂′(t₂) = 0, with a damper x₂′(t₃) = −V₀": |c| { let [_, e, ..] = c.matched(); Some(e) },
        "23" "matching: x₁(t₂) = Δ₀": |c| { let [_, _, e, ..] = c.matched(); Some(e) },
        "24" "matching: x₂(t₂) = Δ₀, with a damper x₂(t₃) = −Δ₁": |c| { let [_, _, _, e, _] = c.matched(); Some(e) },
        "25" "matching: x″(t₁) = 0": |c| { let [.., e] = c.matched(); Some(e) },
    ]);
    all
}

/// Eq. 27–39 and 45: the elimination of the unknowns.
fn elimination<R: Real>() -> Vec<Statement<Case<R>, R>> {
    statements![paper, Case<R>:
        "27" "ρ, the free swing at t₁, brings the body to rest at t₂": |c, u| {
            let (sine, cosine) = c.given.lag(u).sin_cos();
            c.given.amplitude * c.omega * u.displacement_phase.cos() + c.given.rho(u) * cosine
                - c.given.offset(u) * sine
        },
        "37" "ρ has the sign of 1 − Ω": |c, u| {
            let rho = c.given.rho(u);
            rho * c.sign() - rho.abs()
        },
        "28" "a cos θ + b sin θ = 0": |c, u| c.given.elimination_of_rate(u),
        "29" "a sin θ − b cos θ = 2B": |c, u| c.given.elimination_of_position(u),
        "32" "a² + b² = 2(1 + cos π₁)(ρ² + X²)": |c, u| {
            let (a, b) = (c.given.coefficient_a(u), c.given.coefficient_b(u));
            c.near_pole(a.square() + b.square() - c.given.squared_coefficients(u))
        },
        "33" "cos θ = −2Bb/(a² + b²)": |c, u| {
            (c.given.lag(u).cos() - c.given.cos_lag_from_coefficients(u)) * c.one_plus_cos()
        },
        "34" "sin θ = 2Ba/(a² + b²)": |c, u| {
            (c.given.lag(u).sin() - c.given.sin_lag_from_coefficients(u)) * c.one_plus_cos()
        },
        "35" "a² + b² = 4B²": |c, u| {
            let (a, b) = (c.given.coefficient_a(u), c.given.coefficient_b(u));
            a.square() + b.square() - R::int(4)
        },
        "36" "ρ² = 2B²/(1 + cos π₁) − X²": |c, u| {
            c.near_pole((c.given.rho(u).square() - c.given.squared_rho(u)) * c.one_plus_cos())
        },
        "37" "V₀/ω_n = AΩ cos ω_d t₁ + sgn(1−Ω) √ρ²": |c, u| {
            // The factor ρ restores the digits: the root of a small difference keeps only half of them.
            let left = c.given.max_velocity(u, c.sign()) - u.max_velocity;
            c.near_pole(left * c.given.rho(u) * c.one_plus_cos())
        },
        "38" "cos θ = −b/(2B)": |c, u| c.given.lag(u).cos() - c.given.cos_lag(u),
        "39" "sin θ = a/(2B)": |c, u| c.given.lag(u).sin() - c.given.sin_lag(u),
        "45" "(1 + cos π₁)(B cos θ − X) + B sin π₁ sin θ = 0": |c, u| c.given.combined_lag(u),
    ]
}

/// α, Δ₀/B and sin ω_d t₂ at the turning point by eq. 61.
fn at_turning_point<R: Real>(c: &Case<R>) -> (R, R, R) {
    let (k, q) = (c.circular.k, c.one_minus_square);
    let alpha = eq::turning_point_border(k, q, c.omega);
    let delta = eq::max_displacement(k, alpha, q);
    (alpha, delta, eq::sin_displacement_phase(delta, alpha, q))
}

/// The quotient of two numbers, less 1, on the scale of the case.
fn off<R: Real>(c: &Case<R>, found: R, expected: R) -> R {
    (found / expected - R::int(1)) * c.scale
}

/// Eq. 40–67 without a damper: the closed forms and Den Hartog's half cycle.
fn closed_forms<R: Real>() -> Vec<Statement<Case<R>, R>> {
    statements![paper, Case<R>:
        "40" "A sin ω_d t₂ = Δ₀": |c, u| c.given.amplitude * u.displacement_phase.sin() - u.max_displacement,
        "41" "A cos ω_d t₂ = BT/Ω": |c, u| {
            c.given.amplitude * u.displacement_phase.cos() - c.circular.tangent / c.omega
        },
        "42" "Δ₀² = A² − (BT/Ω)²": |c, u| {
            let one = R::int(1);
            let by_42 = eq::max_displacement_from_amplitude(c.given.amplitude, one, c.circular.tangent, c.omega);
            (by_42.square() - u.max_displacement.square()) / c.scale
        },
        "43" "sgn sin ω_d t₂ = sgn(1 − Ω), cos ω_d t₂ = K/α": |c, u| {
            let (sine, cosine) = u.displacement_phase.sin_cos();
            let root = ((R::int(1) - cosine) * (R::int(1) + cosine)).sqrt() * c.sign();
            (sine - root) * sine + cosine - eq::cos_displacement_phase(c.circular.k, c.alpha)
        },
        "46" "x″(t₁) = 0 in ω_d t₁ alone": |c, u| {
            let pi_1 = eq::pi_1(c.omega).sin_cos();
            eq::velocity_phase_residual(c.given.amplitude, c.omega, pi_1, c.given.lag(u), u.velocity_phase.sin())
        },
        "41, 43" "K = (1 − Ω²) tan(π/2Ω)/Ω": |c| {
            c.circular.k - eq::phase_function_of_tangent(c.omega, c.circular.tangent)
        },
        "44" "Δ₀/B = √[(α − K)(α + K)]/|1 − Ω²|": |c, u| {
            let by_44 = eq::max_displacement(c.circular.k, c.alpha, c.one_minus_square);
            (by_44.square() - u.max_displacement.square()) / c.scale
        },
        "47" "Δ₁/B = α sin ω_d t₁ − 1": |c, u| eq::deviation(c.alpha, u.velocity_phase.sin()) - u.deviation,
        "48, 49" "V₀ = Bω_d [A/B cos ω_d t₁ + ρ/(BΩ)], signs corrected": |c, u| {
            let cos_pi_1 = eq::pi_1(c.omega).cos();
            let at = u.velocity_phase.sin_cos();
            let by_49 =
                eq::max_velocity_from_phase(c.given.amplitude, c.omega, cos_pi_1, at, u.deviation, c.sign());
            c.near_pole((by_49 - u.max_velocity / c.omega) * c.given.rho(u) * c.one_plus_cos())
        },
        "50" "Den Hartog: x(0) = Δ₀": |c, u| c.half.displacement(R::int(0)) - u.max_displacement,
        "51" "Den Hartog: x′(0) = 0": |c| c.half.velocity(R::int(0)),
        "52" "Den Hartog: x(π/ω_d) = −Δ₀": |c, u| c.half.displacement(R::pi()) + u.max_displacement,
        "53" "Den Hartog: x′(π/ω_d) = 0": |c| c.half.velocity(R::pi()),
        "54" "Den Hartog's half cycle is the falling one of eq. 16": |c, u| {
            let turn = R::pi() / R::int(3);
            let phase = u.displacement_phase + turn;
            c.half.displacement(turn) - c.given.falling_displacement(u, phase)
        },
        "55" "C₁ = ΩA sin φ": |c| c.half.c1 - c.omega * c.half.amplitude * c.half.phase_lag.sin(),
        "56" "C₂ = Δ₀ − B − A cos φ": |c, u| {
            c.half.c2 + R::int(1) + c.half.amplitude * c.half.phase_lag.cos() - u.max_displacement
        },
        "57–59" "on eq. 61 the force at a reversal is r_y": |c| {
            let (alpha, delta, sine) = at_turning_point(c);
            let one = R::int(1);
            eq::slip_excess(alpha, sine, one, delta, one) / c.scale
        },
        "60" "vanishes on eq. 61": |c| {
            let (alpha, ..) = at_turning_point(c);
            let one = R::int(1);
            eq::turning_point_residual(one, alpha, c.omega, c.circular.tangent)
                / (one + c.omega.square()).square()
                / c.scale
        },
        "61" "Δ₀/B = 1/Ω² there": |c| {
            let (_, delta, _) = at_turning_point(c);
            (delta * c.omega.square() - R::int(1)) / c.scale
        },
        "65, 66" "A₁(√2 |K|) = 4/(|K| |1 − Ω²|)": |c| {
            let (k, q) = (c.circular.k, c.one_minus_square);
            let best = eq::best_force_ratio(k);
            let size = eq::loop_size_stiffness(eq::max_displacement(k, best, q), best);
            off(c, size, eq::best_loop_size(k, q))
        },
    ]
}

/// Statements about the border and the dissipation, with or without a damper.
fn with_damper<R: Real>() -> Vec<Statement<Case<R>, R>> {
    statements![any, Case<R>:
        "λ" "without a damper it is a root of λ² ± (1+s) cos π₁ λ + s, or its modulus": |c, u| {
            if c.signs.is_damped {
                return None;
            }
            let s = eq::multiplier_product(c.omega, u.max_displacement);
            let (modulus, cos_pi_1) = (c.get(Output::Contraction)?, eq::pi_1(c.omega).cos());
            let half = (R::int(1) + s) * cos_pi_1;
            Some(if c.is_below(half.square(), R::int(4) * s)? {
                modulus.square() - s
            } else {
                eq::characteristic_polynomial(modulus, s, -cos_pi_1.abs())
            })
        },
        "61" "the turning point's border is q hypot(S, H), S = (1 + G + 2ζΩH)/Ω²": |c| {
            let ((k, _, shift), (q, _)) = (c.amplitudes(), c.linear);
            let width = (R::int(1) + shift + R::int(2) * c.zeta * c.omega * k / q) / c.omega.square();
            let found = c.get(Output::MinForceRatioTurningPoint)?;
            // The factor: G is a difference of two numbers of the size of the motion.
            Some(off(c, found, k.hypot(q * width)) / (R::int(1) + R::int(1) / c.omega).square())
        },
        "62" "the border is q hypot(S, H), where S − G is its Δ₀/B": |c| {
            let ((k, _, shift), (q, _)) = (c.amplitudes(), c.linear);
            let width = c.get(Output::LeastDisplacement)? + shift;
            Some(c.get(Output::MinForceRatio)? - k.hypot(q * width))
        },
        "62" "the turning point's border is not above the border": |c| {
            let excess = c.get(Output::MinForceRatio)? - c.get(Output::MinForceRatioTurningPoint)?;
            Some(excess.abs() - excess)
        },
        "62" "on the border the body is at −Δ₀, at rest, half a period after Δ₀": |c| {
            let start = c.on_border()?;
            let (x, w) = c.falling_from(start, R::pi());
            Some((x + start.2).abs() + w.abs())
        },
        "62" "on the border velocity and acceleration are zero at τ*": |c| {
            let (alpha, phase, _) = c.on_border()?;
            let tau = c.get(Output::BorderPhase)?;
            let (x, w) = c.falling_from(c.on_border()?, tau);
            let damper = R::int(2) * c.zeta * w;
            Some(w.abs() + (alpha * (phase + tau).sin() - x - damper + R::int(1)).abs())
        },
        "63, 64" "A₁ = 2ks/p₀², s = 4 r_y Δ₀": |c, u| {
            let s = eq::loop_size(R::int(1), u.max_displacement);
            Some(off(c, R::int(2) * s / c.alpha.square(), c.get(Output::LoopSizeStiffness)?))
        },
        "64" "A₁ = 8(Δ₀/B)/α²": |c, u| {
            let by_64 = eq::loop_size_stiffness(u.max_displacement, c.alpha);
            Some(off(c, by_64, c.get(Output::LoopSizeStiffness)?))
        },
        "67" "A₂ = Ω² A₁": |c| {
            let by_67 = eq::loop_size_inertia(c.get(Output::LoopSizeStiffness)?, c.omega);
            Some(off(c, by_67, c.get(Output::LoopSizeInertia)?))
        },
        "65" "α*² = 2Q(Q + qG), Q = hypot(K, qG); without a damper α* = √2 |K|": |c| {
            let ((k, _, shift), (q, _)) = (c.amplitudes(), c.linear);
            let (best, lift) = (c.get(Output::BestForceRatio)?, q * shift);
            let size = k.hypot(lift);
            Some((best.square() - R::int(2) * size * (size + lift)) / (best + size))
        },
        "66" "A₁max = 4/(q(Q + qG))": |c| {
            let ((k, _, shift), (q, _)) = (c.amplitudes(), c.linear);
            let lift = q * shift;
            let term = k.hypot(lift) + lift;
            Some((c.get(Output::BestLoopSize)? * q * term / R::int(4) - R::int(1)) * term)
        },
        "λ" "the contraction is the larger root of λ² + (M₁₁ + sM₂₂)λ + s e^{−2ζT}, or its modulus": |c| {
            let (sum, product) = c.multipliers();
            let modulus = c.get(Output::Contraction)?;
            Some(if c.is_below(sum.square(), R::int(4) * product)? {
                modulus.square() - product
            } else {
                modulus.square() - modulus * sum.abs() + product
            })
        },
        "44" "margin: α/α_min": |c| {
            Some(off(c, c.get(Output::Margin)? * c.get(Output::MinForceRatio)?, c.alpha))
        },
        "44" "dynamic amplification: Δ₀ k/p₀": |c, u| {
            Some(c.get(Output::DynamicAmplification)? * c.alpha - u.max_displacement)
        },
        "44" "transmissibility: the transmitted force over p₀": |c| {
            Some(off(c, c.get(Output::Transmissibility)? * c.alpha, c.get(Output::TransmittedForce)?))
        },
        "44" "the greatest force in the spring is kΔ₀": |c, u| {
            Some(c.get(Output::MaxSpringForce)? - u.max_displacement)
        },
        "44" "equivalent stiffness: k_eff Δ₀ = kΔ₀ + r_y": |c, u| {
            let delta = u.max_displacement;
            Some(c.get(Output::EquivalentStiffness)? * delta - delta - R::int(1))
        },
        "63" "equivalent damping without a damper: π c_eq ω_d Δ₀ = 4 r_y": |c, u| {
            let work = R::pi() * c.get(Output::EquivalentDamping)? * u.max_displacement;
            (!c.signs.is_damped).then(|| off(c, work, R::int(4)))
        },
        "63" "equivalent damping ratio: ζ_eq = c_eq/(2√(k m))": |c| {
            let twice = R::int(2) * c.omega * c.get(Output::EquivalentDampingRatio)?;
            Some(off(c, twice, c.get(Output::EquivalentDamping)?))
        },
        "63" "effective damping ratio: 2ξ(kΔ₀ + r_y) = c_eq ω_d Δ₀": |c, u| {
            let delta = u.max_displacement;
            let force = R::int(2) * c.get(Output::EffectiveDampingRatio)? * (delta + R::int(1));
            Some(off(c, force, c.get(Output::EquivalentDamping)? * delta))
        },
    ]
}

/// Equations that are wrong as printed, at points where they fail.
fn misprints<R: Real>() -> Vec<Statement<Case<R>, R>> {
    let mut all = statements![any, Case<R>:
        "43" "as printed, π/2 < ω_d t₂ < 3π/2, fails where K > 0": |c, u| {
            has_positive_k(c).then(|| {
                let sine = u.max_displacement / c.given.amplitude;
                (printed::displacement_phase(sine) - u.displacement_phase) * c.scale
            })
        },
        "49" "as printed, both roots positive, fails for Ω > 1": |c, u| {
            (!c.signs.is_damped && c.signs.is_above_one).then(|| {
                let cos_pi_1 = eq::pi_1(c.omega).cos();
                let wrong = printed::max_velocity(c.omega, c.alpha, cos_pi_1, u.deviation);
                off(c, wrong * c.omega, u.max_velocity)
            })
        },
        "61" "as printed, sufficient, fails between 1/(2n+1) and 1/(2n)": |c| {
            let (least, by_61) = (c.get(Output::MinForceRatio)?, c.get(Output::MinForceRatioTurningPoint)?);
            has_positive_k(c).then(|| off(c, least, by_61))
        },
    ];
    all.iter_mut().for_each(|statement| statement.standing = Standing::Refuted);
    all
}

/// Whether K > 0, in the paper's setting.
fn has_positive_k<R: Real>(c: &Case<R>) -> bool {
    !c.signs.is_damped && c.is_below(R::int(0), c.circular.k) == Some(true)
}
