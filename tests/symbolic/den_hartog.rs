//! Eq. 50–56: Den Hartog's half cycle is the same motion.

use super::ideal::Ideal;
use super::scalar::{Symbol, free};
use super::setting::{Matching, int};
use stickslip::Real;
use stickslip::cycle::den_hartog::{FallingHalf, cosine_coefficient, phase_lag, sine_coefficient};

/// The half cycle with φ = ω_d t₂ − π/2 and with free C₁ and C₂.
fn half(m: &Matching) -> FallingHalf<Symbol> {
    FallingHalf {
        amplitude: m.given.amplitude,
        friction_displacement: m.given.friction_displacement,
        omega: m.given.omega,
        phase_lag: phase_lag(m.unknowns.displacement_phase),
        c1: free("C₁"),
        c2: free("C₂"),
    }
}

/// Eq. 50–53, left sides minus right sides.
fn conditions(m: &Matching, half: &FallingHalf<Symbol>) -> [Symbol; 4] {
    let delta = m.unknowns.max_displacement;
    let end = Symbol::pi();
    [
        half.displacement(int(0)) - delta,
        half.velocity(int(0)),
        half.displacement(end) + delta,
        half.velocity(end),
    ]
}

#[test]
fn equations_55_and_56_follow_from_50_to_53() {
    let m = Matching::new();
    let half = half(&m);
    let (a, b) = (m.given.amplitude, m.given.friction_displacement);
    let (sine, cosine) = half.phase_lag.sin_cos();
    let conditions = conditions(&m, &half);
    let first_two = Ideal::new(&conditions[..2], &[m.pi_1.0]);
    first_two.assert_exactly("55, left", half.c1 - m.given.omega * a * sine);
    first_two.assert_exactly("56, left", half.c2 - (m.unknowns.max_displacement - b - a * cosine));
    let all = Ideal::new(&conditions, &[]);
    all.assert_exactly("55, right", half.c1 - sine_coefficient(b, m.tangent()));
    let right = half.c2 - cosine_coefficient(b);
    assert!(!all.holds(right), "as eq. 40, not where 1 + cos π₁ vanishes");
    all.assert_exactly("56, right", m.one_plus() * right);
    // The certificates of docs/development/proof.md.
    let [d50, d51, d52, d53] = conditions;
    let (positions, rates) = (d50 + d52, d51 + d53);
    let ((s1, c1), one_plus) = (m.pi_1, m.one_plus());
    let circle = c1 * c1 + s1 * s1 - int(1);
    let e55 = int(2) * (one_plus * half.c1 + b * s1);
    assert!((e55 - (s1 * positions + one_plus * rates - half.c1 * circle)).is_zero());
    let e56 = int(2) * one_plus * (half.c2 + b);
    assert!((e56 - (one_plus * positions - s1 * rates - half.c2 * circle)).is_zero());
    for (what, wrong) in [
        ("55 with the other sign", half.c1 + sine_coefficient(b, m.tangent())),
        ("56 with the other sign", m.one_plus() * (half.c2 + cosine_coefficient(b))),
        ("55 and 56 exchanged", m.one_plus() * (half.c1 - cosine_coefficient(b))),
    ] {
        assert!(!all.holds(wrong), "{what} follows");
    }
}

#[test]
fn den_hartogs_displacement_and_phase_are_equations_42_and_43() {
    // A cos φ = Δ₀ and Ω A sin φ = C₁ are eq. 40 and 41 at ω_d t₂ = φ + π/2, so that Δ₀ is eq. 42.
    let m = Matching::new();
    let half = half(&m);
    let ideal = Ideal::new(&conditions(&m, &half), &[]);
    ideal.assert_exactly("41", m.equation_41());
    ideal.assert_exactly("40", m.one_plus() * m.equation_40());
    assert!(!ideal.holds(m.equation_40()));
    // Conversely, eq. 40 and 41 with C₁ and C₂ satisfy all four.
    let back = Ideal::new(
        &[
            m.equation_40(),
            m.equation_41(),
            half.c1 - sine_coefficient(m.given.friction_displacement, m.tangent()),
            half.c2 - cosine_coefficient(m.given.friction_displacement),
        ],
        &[],
    );
    for (name, condition) in ["50", "51", "52", "53"].iter().zip(conditions(&m, &half)) {
        assert!(back.holds(m.one_plus() * condition), "{name}");
    }
}
