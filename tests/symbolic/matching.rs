//! Eq. 1–41 and 45: the consequences of the matching conditions.

use super::ideal::Ideal;
use super::polynomial::Polynomial;
use super::scalar::{Symbol, angle, angle_with, free};
use super::setting::{Matching, int};
use stickslip::cycle::equations::cos_displacement_phase;
use stickslip::cycle::matching::half_period_later;
use stickslip::cycle::phase_function::one_minus_square;
use stickslip::{Field, Real};

#[test]
fn the_symbols_rho_and_x_are_the_librarys() {
    let m = Matching::new();
    assert_eq!(m.given.rho(&m.unknowns).value(), m.rho.value());
    assert_eq!(m.given.offset(&m.unknowns).value(), m.offset.value());
    // The divisors of eq. 40 and 41.
    assert_eq!(m.equation_40().denominator().len(), 1);
    assert_eq!(m.equation_40().numerator(), (m.height - m.unknowns.max_displacement).numerator());
    let e41 = m.rate * m.one_plus() - m.given.friction_displacement * m.pi_1.0;
    assert_eq!(m.equation_41().numerator(), e41.numerator());
}

#[test]
fn equations_1_to_20_are_identities() {
    let m = Matching::new();
    let (g, u) = (&m.given, &m.unknowns);
    let (t1, t2) = (u.velocity_phase, u.displacement_phase);
    let (t3, t4) = (half_period_later(t1), half_period_later(t2));
    for (name, zero) in [
        ("11", g.rising_displacement(u, t1) - u.deviation),
        ("12", g.falling_displacement(u, t3) + u.deviation),
        ("13", g.rising_velocity(u, t1) - u.max_velocity),
        ("14", g.falling_velocity(u, t3) + u.max_velocity),
        ("17 is 21", g.rising_velocity(u, t2) - m.residuals()[0]),
        ("18 is 22", g.falling_velocity(u, t2) - m.residuals()[1]),
        ("19 is 23", g.rising_displacement(u, t2) - u.max_displacement - m.residuals()[2]),
        ("20 is 24", g.falling_displacement(u, t2) - u.max_displacement - m.residuals()[3]),
        ("2, 3: x", g.falling_displacement(u, t4) + g.rising_displacement(u, t2)),
        ("2, 3: v", g.falling_velocity(u, t4) + g.rising_velocity(u, t2)),
    ] {
        assert!(zero.is_zero(), "{name}: {zero:?}");
    }
    // At any phase, with the angle of the branch named.
    let phase = free("τ");
    let _ = (angle("τ", phase), angle("ω_n(t − t₁)", (phase - t1) / g.omega));
    let q = one_minus_square(g.omega);
    let later = half_period_later(phase);
    for (x, v, friction) in [
        (g.rising_displacement(u, phase), g.rising_velocity(u, phase), g.friction_displacement),
        (g.falling_displacement(u, phase), g.falling_velocity(u, phase), -g.friction_displacement),
    ] {
        assert!((v - g.omega * x.derivative(phase)).is_zero(), "v is not x′");
        // Eq. 1 over k, in the phase: Ω² x″ + x ± B = (p₀/k) sin ω_d t, p₀/k = A(1 − Ω²).
        let second = g.omega * v.derivative(phase);
        let one = second + x + friction - g.amplitude * q * phase.sin();
        assert!(one.is_zero(), "eq. 1: {one:?}");
        assert!(!(one + friction).is_zero());
    }
    assert!((g.falling_displacement(u, later) + g.rising_displacement(u, phase)).is_zero(), "symmetry");
    // Eq. 25 states that in eq. 1 at t₁, where x = Δ₁, the acceleration is zero.
    let acceleration = g.amplitude * q * m.t1.0 - u.deviation - g.friction_displacement;
    assert!((acceleration + m.residuals()[4]).is_zero(), "25");
}

#[test]
fn equations_28_and_29_are_differences_and_32_an_identity_of_the_circle() {
    let m = Matching::new();
    let (g, u) = (&m.given, &m.unknowns);
    let [e21, e22, e23, e24, _] = m.residuals();
    assert!((g.elimination_of_rate(u) - (e21 - e22)).is_zero(), "28");
    assert!((g.elimination_of_position(u) - (e23 - e24)).is_zero(), "29");
    let (a, b) = (g.coefficient_a(u), g.coefficient_b(u));
    let e32 = a * a + b * b - g.squared_coefficients(u);
    Ideal::new(&[], &[e32]).assert_exactly("32", e32);
    // The denominators of eq. 33 and 34 are a² + b² alone, of eq. 36 1 + cos π₁.
    assert_eq!(g.cos_lag_from_coefficients(u).denominator(), [(a * a + b * b).numerator()]);
    assert_eq!(g.squared_rho(u).denominator(), [m.one_plus().numerator()]);
}

/// The name, and the left side minus the right side, of those of eq. 28–45 that follow directly from eq.
/// 21–24.
fn plain_consequences(m: &Matching) -> Vec<(&'static str, Symbol)> {
    let (g, u, (s, c)) = (&m.given, &m.unknowns, m.lag);
    let (a, b) = (g.coefficient_a(u), g.coefficient_b(u));
    let friction = g.friction_displacement;
    vec![
        ("28", g.elimination_of_rate(u)),
        ("29", g.elimination_of_position(u)),
        ("33", c - g.cos_lag_from_coefficients(u)),
        ("34", s - g.sin_lag_from_coefficients(u)),
        ("35", a * a + b * b - int(4) * friction * friction),
        ("36", m.rho * m.rho - g.squared_rho(u)),
        ("38", c - g.cos_lag(u)),
        ("39", s - g.sin_lag(u)),
        ("41", m.equation_41()),
        ("45", g.combined_lag(u)),
    ]
}

#[test]
fn equations_28_to_39_41_and_45_follow_from_21_to_24() {
    let m = Matching::new();
    let ideal = Ideal::new(&m.first_four(), &[]);
    for (name, claim) in plain_consequences(&m) {
        ideal.assert_exactly(name, claim);
    }
}

#[test]
fn equation_40_follows_times_one_plus_cos_pi_1() {
    let m = Matching::new();
    let ideal = Ideal::new(&m.first_four(), &[]);
    let e40 = m.height - m.unknowns.max_displacement;
    assert_eq!(m.equation_40().numerator(), e40.numerator());
    assert!(!ideal.holds(e40), "plainly it does not follow");
    ideal.assert_exactly("40", m.one_plus() * e40);
    // Where 1 + cos π₁ has an inverse, the claim follows.
    let inverse = free("1/(1 + cos π₁)");
    let mut hypotheses = m.first_four();
    hypotheses.push(inverse * m.one_plus() - int(1));
    Ideal::new(&hypotheses, &[]).assert_exactly("40", e40);
}

/// The certificates of `docs/development/proof.md`, each an identity of polynomials.
#[test]
fn the_certificates_by_hand_expand() {
    let m = Matching::new();
    let (g, u) = (&m.given, &m.unknowns);
    let [e21, e22, e23, e24, e25] = m.residuals();
    let ((s, c), (s1, c1), (rho, x)) = (m.lag, m.pi_1, (m.rho, m.offset));
    let (one_plus, friction, two) = (m.one_plus(), g.friction_displacement, int(2));
    let (a, b) = (g.coefficient_a(u), g.coefficient_b(u));
    let (r1, r) = (c1 * c1 + s1 * s1 - int(1), c * c + s * s - int(1));
    let (e28, e29) = (e21 - e22, e23 - e24);
    let (e38, e39) = (two * friction * c + b, two * friction * s - a);
    let e35 = a * a + b * b - int(4) * friction * friction;
    let norm = rho * rho + x * x;
    let e36 = one_plus * norm - two * friction * friction;
    let e40 = m.height - u.max_displacement;
    let e41 = m.rate * one_plus - friction * s1;
    let e45 = g.combined_lag(u);
    let e46 = e45 + one_plus * (g.amplitude * g.omega * g.omega * m.t1.0 + x);
    for (name, claim, certificate) in [
        ("32", a * a + b * b - two * one_plus * norm, norm * r1),
        ("33", (a * a + b * b) * c + two * friction * b, a * e28 - b * e29),
        ("34", (a * a + b * b) * s - two * friction * a, b * e28 + a * e29),
        ("35", e35, e28 * e28 + (e29 + int(4) * friction) * e29 - (a * a + b * b) * r),
        ("36", two * e36, e35 - norm * r1),
        ("38", e38, s * e28 - c * e29 - b * r),
        ("39", e39, a * r - c * e28 - s * e29),
        ("40", two * one_plus * e40, one_plus * (e23 + e24) - s1 * e28 + r1 * (x * c + rho * s)),
        ("41", two * e41, one_plus * (e21 + e22) + s1 * e29 + r1 * (rho * c - x * s)),
        ("45", two * e45, one_plus * e38 + s1 * e39 + x * r1),
        ("46", e46, e45 + one_plus * e25),
    ] {
        assert!((claim - certificate).is_zero(), "{name}");
        assert!(!(claim + certificate).is_zero(), "{name}, with the other sign");
    }
    assert_eq!((g.elimination_of_rate(u) - e28).numerator(), int(0).numerator());
    assert_eq!(
        (c - g.cos_lag(u)).numerator(),
        e38.numerator().scaled(&Symbol::ratio(1, 2).numerator().as_constant().unwrap())
    );
}

#[test]
fn equation_37_leaves_the_sign_of_its_root_open() {
    let m = Matching::new();
    let (g, u) = (&m.given, &m.unknowns);
    let plus = u.max_velocity - g.max_velocity(u, int(1));
    let minus = u.max_velocity - g.max_velocity(u, int(-1));
    let ideal = Ideal::new(&m.first_four(), &[plus]);
    assert!(ideal.holds(m.one_plus() * plus * minus), "one of the two signs is right");
    assert!(!ideal.holds(plus) && !ideal.holds(minus), "and algebra does not say which");
}

#[test]
fn equations_24_and_22_add_nothing_but_36() {
    let mut m = Matching::without_lag(None);
    let (g, friction) = (m.given, m.given.friction_displacement);
    let e36 = m.rho * m.rho - g.squared_rho(&m.unknowns);
    // Substitute eq. 38–41 for P, Q and the angle.
    let (sine, cosine) = (g.sin_lag(&m.unknowns), g.cos_lag(&m.unknowns));
    let t2 = free("t₂ of 40, 41");
    angle_with(
        t2,
        m.unknowns.max_displacement / g.amplitude,
        cos_displacement_phase(m.phase_function(), m.alpha()),
    );
    m.unknowns.displacement_phase = t2;
    angle_with(g.lag(&m.unknowns), sine, cosine);
    let [e21, e22, e23, e24, _] = m.residuals();

    let with_36 = Ideal::new(&[e36], &[m.pi_1.0]);
    with_36.assert_exactly("24", e24);
    with_36.assert_exactly("22", e22);
    with_36.assert_exactly("21", e21);
    with_36.assert_exactly("23", e23);
    // Each gives eq. 36 back: eq. 24 directly, eq. 22 times sin π₁.
    Ideal::new(&[e24], &[m.pi_1.0]).assert_exactly("36", friction * e36);
    let from_22 = Ideal::new(&[e22], &[m.pi_1.0]);
    assert!(!from_22.holds(e36), "where sin π₁ = 0, eq. 22 says nothing");
    from_22.assert_exactly("36", m.pi_1.0 * e36);
    assert!(!Ideal::new(&[], &[e24]).holds(e24), "eq. 24 is not void");
}

#[test]
fn wrong_equations_are_rejected() {
    let m = Matching::new();
    let (g, u, (s, c)) = (&m.given, &m.unknowns, m.lag);
    let ideal = Ideal::new(&m.first_four(), &[]);
    let (a, b) = (g.coefficient_a(u), g.coefficient_b(u));
    let wrong_b = m.rho * m.pi_1.0 + m.offset * m.one_plus();
    let friction = g.friction_displacement;
    let wrong = [
        ("sign in 31: 28", a * c + wrong_b * s),
        ("sign in 31: 29", a * s - wrong_b * c - int(2) * friction),
        ("38 and 39 exchanged", c - g.sin_lag(u)),
        ("39 and 38 exchanged", s - g.cos_lag(u)),
        ("33 without its sign", c + g.cos_lag_from_coefficients(u)),
        ("2B² for 4B² in 35", a * a + b * b - int(2) * friction * friction),
        (
            "1 − cos π₁ in 36",
            (int(1) - m.pi_1.1) * (m.rho * m.rho + m.offset * m.offset) - int(2) * friction * friction,
        ),
        ("Δ₀ + B in 40", m.one_plus() * (m.height - u.max_displacement - friction)),
        ("sine for cosine in 41", m.one_plus() * m.height - friction * m.pi_1.0),
        ("no Ω in 41", m.one_plus() * m.rate - g.omega * friction * m.pi_1.0),
    ];
    for (what, claim) in wrong {
        assert!(!ideal.holds(claim), "{what} follows");
    }
    // A certificate is not trusted: with one cofactor changed it proves nothing.
    let claim = g.cos_lag(u) - c;
    let mut certificate = ideal.certificate(&claim.numerator()).unwrap();
    let at = certificate.cofactors.iter().position(|h| !h.is_zero()).unwrap();
    certificate.cofactors[at] = -&certificate.cofactors[at];
    assert!(!certificate.shows(&claim.numerator()));
}

#[test]
fn from_wrong_hypotheses_the_equations_do_not_follow() {
    let m = Matching::at_rational_angles();
    let (hypotheses, claims) = (m.first_four(), plain_consequences(&m));
    let surviving = |hypotheses: &[Symbol]| {
        let ideal = Ideal::new(hypotheses, &[m.rho, m.offset]);
        claims.iter().filter(|(_, claim)| ideal.holds(*claim)).count()
    };
    assert_eq!(surviving(&hypotheses), claims.len());
    for (at, hypothesis) in hypotheses.iter().enumerate() {
        for (exponents, c) in hypothesis.numerator().terms() {
            let term = Symbol::from(Polynomial::from_terms([(exponents.clone(), c.clone())]));
            let mut mutated = hypotheses.clone();
            mutated[at] = Symbol::from(hypothesis.numerator()) - int(2) * term;
            let kept = surviving(&mutated);
            assert!(kept < claims.len(), "eq. {} with the other sign of {term:?}: all follow", at + 21);
        }
    }
}
