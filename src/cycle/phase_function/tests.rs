use super::PhaseFunction;

fn at(omega: f64) -> PhaseFunction<f64> {
    PhaseFunction::new(omega).unwrap()
}

fn close(a: f64, b: f64, ulps: f64) {
    assert!((a - b).abs() <= ulps * f64::EPSILON * b.abs(), "{a:e} against {b:e}");
}

#[test]
fn ordinary_values() {
    // The references of T and K were computed with 40 digits and rounded.
    close(at(2.0).value(), -1.5, 1.0);
    close(at(3.0).value(), -1.539_600_717_839_002, 2.0);
    close(at(0.75).value(), -1.010_362_971_081_845, 3.0);
    assert_eq!(at(0.5).value(), 0.0);
    assert_eq!(at(0.25).value(), 0.0);
}

#[test]
fn smooth_through_the_natural_frequency() {
    let four_over_pi = 4.0 / std::f64::consts::PI;
    close(at(1.0).value(), -four_over_pi, 1.0);
    close(at(1f64.next_up()).value(), -four_over_pi, 2.0);
    close(at(1f64.next_down()).value(), -four_over_pi, 2.0);
    // K(1 + ε) − K(1) = −(2/π)ε + (π/3)ε² …, from K = −(2/π)(1+Ω)(1 − y²/3 …).
    let (e, pi) = (1e-6, std::f64::consts::PI);
    close(at(1.0 + e).value() + four_over_pi, -2.0 / pi * e + pi / 3.0 * e * e, 4e6);
}

#[test]
fn the_floats_beside_a_third_are_ordinary() {
    // 1 − 3Ω = ±2⁻⁵⁴·{1, 2}: cot of a tiny angle, K = ±(8/9)·… exactly predictable.
    let below = 1.0f64 / 3.0;
    let above = below.next_up();
    for omega in [below, above] {
        let rest = (-3.0f64).mul_add(omega, 1.0);
        let expected = -(1.0 - omega * omega) / omega * (2.0 * omega / (std::f64::consts::PI * rest));
        close(at(omega).value(), expected, 6.0);
    }
    assert!(at(below).value() < -1e15 && at(above).value() > 1e15);
}

#[test]
fn sine_and_cosine_agree_with_the_plain_angle() {
    for omega in [0.07, 0.11, 0.13, 0.21, 0.26, 0.31, 0.36, 0.45, 0.55, 0.8, 1.3, 1.9, 2.5, 40.0] {
        let (s, c) = at(omega).sin_cos();
        let (sp, cp) = (std::f64::consts::FRAC_PI_2 / omega).sin_cos();
        assert!((s - sp).abs() < 1e-14 && (c - cp).abs() < 1e-14, "{omega}");
        let lobe = at(omega).lobe_phase().value();
        assert!((lobe.sin() - s.abs()).abs() < 1e-14 && (0.0..std::f64::consts::PI).contains(&lobe));
        assert!((lobe.tan() / at(omega).tangent() - 1.0).abs() < 1e-13, "{omega}");
    }
}
