use super::{Direction, Slide};
use crate::Ratios;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::equation::Equation;

fn slide(omega: f64, alpha: f64, theta: f64, x: f64, w: f64) -> Slide<f64> {
    let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
    Slide::new(equation, DrivePhase::of(theta).unwrap(), x, w, Direction::of(w))
}

/// The scales of rounding at (Ω, α) = (3, 2).
#[test]
fn scales_are_the_sizes_of_the_terms() {
    let s = slide(3.0, 2.0, 0.4, -0.7, -0.9);
    let acceleration: f64 = 2.0 * 0.4f64.sin() + 0.7 + 1.0;
    // 4 Ωα/(1 + Ω²) = 2.4
    assert!((s.velocity_scale() - (acceleration + 0.9 + 2.4)).abs() < 1e-14, "{}", s.velocity_scale());
    let expected = [0.9, acceleration, 6.0 * 0.4f64.cos(), 18.0 * 0.4f64.sin()];
    for (found, expected) in s.short_velocity_scale().into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}

#[test]
fn against_forty_digits() {
    // The textbook solution at 40 digits, rounded: (Ω, φ, x, w, w′) for α = 2.3, θ_i = 0.4, x_i = −0.7,
    // w_i = 0.9.
    for (omega, phi, x, w, a) in REFERENCE {
        let m = slide(omega, 2.3, 0.4, -0.7, 0.9).motion(phi);
        let scale = 4e-16 * (1.0 + phi + omega * phi) * (1.0 + 2.3);
        for (got, expected) in [(m.x, x), (m.w, w), (m.acceleration, a)] {
            assert!((got - expected).abs() < scale, "Ω = {omega}, φ = {phi}: {got} {expected}");
        }
    }
}

include!("reference.rs");

#[test]
fn the_equation_of_motion_is_obeyed() {
    for omega in [1e-3, 0.3, 0.99, 1.0, 1.0 + 1e-12, 1.7, 1e3] {
        let s = slide(omega, 2.0, -0.8, 0.4, -1.3);
        for i in 0..50 {
            let phi = f64::from(i) * 0.07;
            let m = s.motion(phi);
            let residual = m.acceleration + m.x - 1.0 - m.force;
            assert!(residual.abs() < 1e-14, "Ω = {omega}, φ = {phi}: {residual:e}");
            let theta = -0.8 + omega * phi;
            assert!((m.force - 2.0 * theta.sin()).abs() < 1e-12);
            assert!((m.jerk + m.w - 2.0 * omega * theta.cos()).abs() < 1e-12 * (1.0 + omega));
        }
    }
}

#[test]
fn a_released_slide_starts_like_a_cube() {
    let equation = Equation::new(Ratios::new(0.8, 1.7).unwrap());
    let start = DrivePhase::of(0.3).unwrap();
    let x = 1.7 * 0.3f64.sin() - 1.0;
    let s = Slide::released(equation, start, x, Direction::Forward);
    let phi = 1e-5;
    let expected = 1.7 * 0.8 * 0.3f64.cos() * phi * phi / 2.0;
    assert!((s.motion(phi).w / expected - 1.0).abs() < 1e-5);
    assert_eq!(s.motion(0.0).w, 0.0);
}
