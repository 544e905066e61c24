//! Eq. 57–62: the border at the turning point.

use super::ideal::Ideal;
use super::scalar::{Symbol, free, reset};
use super::setting::{Matching, int};
use stickslip::Real;
use stickslip::cycle::border::{slip_excess, turning_point_border, turning_point_residual};
use stickslip::cycle::equations::max_displacement;
use stickslip::cycle::phase_function::{one_minus_square, phase_function_of_tangent};

#[test]
fn equation_60_follows_from_40_41_and_59() {
    let m = Matching::new();
    let (a, b, omega, alpha) = (m.given.amplitude, m.given.friction_displacement, m.given.omega, m.alpha());
    let delta = m.unknowns.max_displacement;
    let (sine, cosine) = m.unknowns.displacement_phase.sin_cos();
    // Friction force 1: stiffness 1/B, force α.
    let e59 = slip_excess(alpha, sine, int(1) / b, delta, int(1));
    let e60 = turning_point_residual(b, alpha, omega, m.tangent());
    // |y| = 1 as y² = 1: α sin ω_d t₂ − Δ₀/B, with sin ω_d t₂ = Δ₀/A substituted.
    let force = alpha * sine - delta / b;
    let circle = sine * sine + cosine * cosine - int(1);
    let magnitude = e59 + int(1);
    let squared = Ideal::new(&[], &[e59]);
    assert!(squared.holds(magnitude * magnitude - force * force), "|y|² = y²");
    let with_40 = alpha * (delta / a) - delta / b;
    assert!(Ideal::new(&[m.equation_40()], &[]).holds(force - with_40));
    // With eq. 42 for Δ₀², eq. 60 is Ω² times with_40² − 1.
    let e42 = delta * delta - a * a + (b * m.tangent() / omega) * (b * m.tangent() / omega);
    let ideal = Ideal::new(&[e42], &[]);
    ideal.assert_exactly("60", (e60 - omega * omega * (with_40 * with_40 - int(1))).numerator().into());
    assert!(Ideal::new(&[m.equation_40(), m.equation_41(), circle], &[]).holds(e42));
    // On the cycle the excess force is exactly Ω²Δ₀/B: eq. 59 is Δ₀/B = 1/Ω².
    assert!((with_40 + omega * omega * delta / b).is_zero());
}

#[test]
fn equations_60_and_61_are_equivalent() {
    reset();
    let [alpha, omega, tan, b] = ["α", "Ω", "T", "B"].map(free);
    let k = phase_function_of_tangent(omega, tan);
    let q = one_minus_square(omega);
    let e60 = turning_point_residual(b, alpha, omega, tan);
    let border = turning_point_border(k, one_minus_square(omega), omega);
    // (1 − Ω²)² times eq. 60 is Ω⁶ (α² − α₆₁²): one vanishes exactly where the other does, for Ω ≠ 0, 1.
    let difference = alpha * alpha - border * border;
    let six = |x: Symbol| x * x * x * x * x * x;
    let ideal = Ideal::new(&[], &[border]);
    assert!(ideal.holds(q * q * e60 - six(omega) * difference));
    assert!(!ideal.holds(q * q * e60 + six(omega) * difference));
    assert!(!ideal.holds(e60), "and neither is zero by itself");
    // As printed: (1/Ω² − 1)² [1 + (ΩT)²].
    let inverse = int(1) / (omega * omega) - int(1);
    let tangent = omega * tan;
    assert!(ideal.holds(border * border - inverse * inverse * (int(1) + tangent * tangent)), "61");
    assert!(!ideal.holds(border * border - inverse * inverse * (int(1) - tangent * tangent)));
    assert!(!ideal.holds(border * border - inverse * inverse * (int(1) + tan * tan)));
    // Eq. 62: (Ω²Δ₀/B)² − 1 has the sign of α² − α₆₁².
    let delta = max_displacement(k, alpha, q);
    let reserve = (omega * omega * delta) * (omega * omega * delta) - int(1);
    let fourth = omega * omega * omega * omega;
    let with_delta = Ideal::new(&[], &[border, delta]);
    assert!(with_delta.holds(q * q * reserve - fourth * difference), "62");
    // Eq. 60 with an error, 1 for Ω² on the right, is not equivalent.
    assert!(!ideal.holds(q * q * (e60 + omega * omega - int(1)) - six(omega) * difference));
}
