//! Eq. 42–49: peak displacement, and peak velocity with the signs that the paper loses.

use super::ideal::Ideal;
use super::scalar::{Symbol, free};
use super::setting::{Matching, int};
use stickslip::cycle::equations::{
    deviation, max_displacement, max_displacement_from_amplitude, max_velocity_from_phase,
    velocity_phase_residual,
};
use stickslip::cycle::phase_function::one_minus_square;
use stickslip::cycle::printed;
use stickslip::{Field, Real};

/// Eq. 46 in the library's form.
fn equation_46(m: &Matching) -> Symbol {
    let g = &m.given;
    velocity_phase_residual(
        g.amplitude / g.friction_displacement,
        g.omega,
        m.pi_1,
        g.lag(&m.unknowns),
        m.t1.0,
    )
}

/// Eq. 47: Δ₁/B minus the library's form of it.
fn equation_47(m: &Matching) -> Symbol {
    m.unknowns.deviation / m.given.friction_displacement - deviation(m.alpha(), m.t1.0)
}

#[test]
fn equations_42_to_44_follow_from_40_and_41() {
    let m = Matching::new();
    let (a, b, omega) = (m.given.amplitude, m.given.friction_displacement, m.given.omega);
    let (sine, cosine) = m.unknowns.displacement_phase.sin_cos();
    let hypotheses = [m.equation_40(), m.equation_41(), sine * sine + cosine * cosine - int(1)];
    let by_42 = max_displacement_from_amplitude(a, b, m.tangent(), omega);
    let by_44 = max_displacement(m.phase_function(), m.alpha(), one_minus_square(omega));
    let delta = m.unknowns.max_displacement;
    // Compare the squares: a root is known up to its sign, and both sides are positive.
    let squares = |root: Symbol| root * root;
    let radicand = a * a - squares(b * m.tangent() / omega);
    let ideal = Ideal::new(&hypotheses, &[]);
    let e42 = (squares(delta) - radicand).numerator();
    ideal.assert_exactly("42", e42.clone().into());
    // Each of the library's two forms is the root of that, by the relation of its root alone.
    let forms = Ideal::new(&[], &[by_42, by_44]);
    assert!(forms.holds(squares(by_42) - radicand), "42");
    assert!(forms.holds(squares(b * by_44) - radicand), "44");
    assert!(!forms.holds(squares(by_44) - radicand), "44 without its unit");
    // A plus sign under the root is wrong.
    let plus = a * a + squares(b * m.tangent() / omega);
    assert!(!ideal.holds(squares(delta) - plus));
}

#[test]
fn equations_46_and_47_follow_from_25() {
    let m = Matching::new();
    let e25 = m.residuals()[4];
    // Eq. 47 is eq. 25 divided by B.
    assert_eq!(equation_47(&m).numerator(), e25.numerator());
    // Eq. 46 is eq. 45 with eq. 25 substituted, and therefore follows from 21–25.
    let ideal = Ideal::new(&[m.given.combined_lag(&m.unknowns), e25], &[]);
    ideal.assert_exactly("46", equation_46(&m));
    let mut all = m.first_four();
    all.push(e25);
    let ideal = Ideal::new(&all, &[]);
    assert!(ideal.holds(equation_46(&m)));
    // Eq. 46 does not follow without eq. 25, nor with Ω in place of Ω².
    assert!(!Ideal::new(&m.first_four(), &[m.t1.0]).holds(equation_46(&m)));
    let short = m.given.amplitude * m.given.omega * (m.given.omega - int(1)) * m.one_plus() * m.t1.0;
    assert!(!ideal.holds(equation_46(&m) * m.given.friction_displacement - short));
}

#[test]
fn the_second_radicand_of_48_is_that_of_36() {
    // B − A/α − Ω²Δ₁/(1 − Ω²) = X by eq. 25.
    let m = Matching::new();
    let (b, omega) = (m.given.friction_displacement, m.given.omega);
    let q = one_minus_square(omega);
    let inner = b - m.given.amplitude / m.alpha() - omega * omega * m.unknowns.deviation / q;
    Ideal::new(&[m.residuals()[4]], &[]).assert_exactly("48", inner - m.offset);
}

/// Eq. 49, corrected and as printed, where ρ has the sign `of_rho` of its root and A cos ω_d t₁ the sign
/// `of_first` of its root; |1 − Ω²| is (1 − Ω²) times the sign `of_rho` of 1 − Ω.
fn equation_49(of_rho: i32, of_first: i32) -> (bool, bool) {
    let m = Matching::new();
    let (b, omega, alpha) = (m.given.friction_displacement, m.given.omega, m.alpha());
    let q = one_minus_square(omega);
    let dimensionless = m.unknowns.deviation / b;
    let velocity = m.unknowns.max_velocity / (b * omega);
    let corrected =
        max_velocity_from_phase(m.given.amplitude / b, omega, m.pi_1.1, m.t1, dimensionless, int(of_rho));
    let as_printed = printed::max_velocity(omega, alpha, m.pi_1.1, dimensionless);

    // The roots are known up to sign: that of ρ, and that of α cos ω_d t₁.
    let second = m.rho * int(of_rho) / b;
    let first = alpha * m.t1.1 * int(of_first * of_rho);
    let root_of_rho = (int(2) / m.one_plus() - (m.offset / b) * (m.offset / b)).sqrt();
    let inner = int(1) / omega - int(1) / (omega * q) - omega * dimensionless / q;
    let printed_second = (int(2) / (omega * omega * m.one_plus()) - inner * inner).sqrt();
    let printed_first = (alpha * alpha - (int(1) + dimensionless) * (int(1) + dimensionless)).sqrt();
    let holds = |claim: Symbol, hypotheses: &[Symbol]| {
        // The hypotheses are linear: their own relations are not needed, and are checked for consistency
        // below.
        Ideal::without_relations(hypotheses, &[claim]).holds(claim)
    };
    let corrected_holds = holds(velocity - corrected, &[root_of_rho - second]);
    let printed_holds = holds(
        velocity - as_printed,
        &[printed_second - second / omega, printed_first - first, q.abs() - q * int(of_rho)],
    );
    // Each hypothesis is consistent with the relation of its root where eq. 25 and 36 hold.
    let e36 = m.rho * m.rho - m.given.squared_rho(&m.unknowns);
    let consistent = Ideal::new(&[m.residuals()[4], e36], &[]);
    let square = |x: Symbol| x * x;
    assert!(consistent.holds(square(second) - int(2) / m.one_plus() + square(m.offset / b)));
    assert!(
        consistent.holds(square(second / omega) - int(2) / (omega * omega * m.one_plus()) + inner * inner)
    );
    assert!(consistent.holds(square(first) - alpha * alpha + square(int(1) + dimensionless)));
    (corrected_holds, printed_holds)
}

#[test]
fn equation_49_corrected_holds_for_every_sign_and_the_printed_one_for_one_of_four() {
    // Below the natural frequency, with A cos ω_d t₁ positive, both forms hold.
    assert_eq!(equation_49(1, 1), (true, true));
    // Above it, ρ is negative, and the printed second root is wrong.
    assert_eq!(equation_49(-1, 1), (true, false));
    // Near the border, A cos ω_d t₁ is negative, and the printed first root is wrong.
    assert_eq!(equation_49(1, -1), (true, false));
    assert_eq!(equation_49(-1, -1), (true, false));
}

#[test]
fn the_printed_range_of_43_is_one_of_two() {
    // π/2 + arccos(Δ₀/A) has the sine of eq. 40, and the cosine of eq. 41 up to its sign.
    let m = Matching::new();
    let ratio = free("Δ₀/A");
    let phase = printed::displacement_phase(ratio);
    let (sine, cosine) = phase.sin_cos();
    let k = free("K/α");
    // h² = (1 − r²) + r² = 1, h > 0.
    let h = cosine.denominator();
    let h = Symbol::from(h[0].clone());
    let ideal = Ideal::new(&[h - int(1), k * k + ratio * ratio - int(1)], &[sine, cosine]);
    assert!(ideal.holds(sine - ratio), "40");
    assert!(ideal.holds((cosine - k) * (cosine + k)), "41, one of the two");
    assert!(!ideal.holds(cosine - k) && !ideal.holds(cosine + k));
    assert!(!ideal.holds(sine + ratio) && m.alpha().denominator().len() == 1);
}
