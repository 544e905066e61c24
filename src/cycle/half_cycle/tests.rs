//! The motion of half a cycle: its ends, its slopes and its two forms.

use super::HalfCycle;
use crate::cycle::phase_function::PhaseFunction;

/// A possible Δ₀/B of a cycle at Ω; the forms hold for any.
fn half(omega: f64) -> HalfCycle<f64> {
    HalfCycle::new(&PhaseFunction::new(omega).unwrap(), 2.0 / (omega * omega))
}

#[test]
fn ends_are_reversals_at_plus_and_minus_the_maximum() {
    for omega in [0.23, 0.3, 0.4, 0.6, 0.7, 0.99, 1.0 + 1e-9, 1.3, 1.999, 5.0] {
        let (h, beta) = (half(omega), std::f64::consts::FRAC_PI_2 / omega);
        let delta = 2.0 / (omega * omega);
        assert!(h.velocity(beta).value.abs() < 1e-12 * delta, "{omega}");
        assert!(h.velocity(-beta).value.abs() < 1e-12 * delta, "{omega}");
        assert!((h.displacement(-beta) - delta).abs() < 1e-12 * delta, "{omega}");
        assert!((h.displacement(beta) + delta).abs() < 1e-12 * delta, "{omega}");
    }
}

#[test]
fn derivatives_match_differences() {
    for omega in [0.3, 0.45, 0.8, 1.0 + 1e-7, 1.4, 3.0] {
        let (h, d) = (half(omega), 1e-5);
        for psi in [-0.4, 0.0, 0.3] {
            let (a, b, c) = (h.velocity(psi - d), h.velocity(psi), h.velocity(psi + d));
            let scale = 1e-8 * (1.0 + 1.0 / (omega * omega));
            assert!(((c.value - a.value) / (2.0 * d) - b.first).abs() < scale, "{omega} {psi}");
            assert!(((c.first - a.first) / (2.0 * d) - b.second).abs() < scale, "{omega} {psi}");
            assert!(((c.second - a.second) / (2.0 * d) - b.third).abs() < scale, "{omega} {psi}");
            assert!(((c.third - a.third) / (2.0 * d) - b.fourth).abs() < scale, "{omega} {psi}");
            // dx/dψ = −Ω v/(Bω_d)
            let slope = (h.displacement(psi + d) - h.displacement(psi - d)) / (2.0 * d);
            assert!((slope + omega * b.value).abs() < scale, "{omega} {psi}");
        }
    }
}

#[test]
fn both_forms_agree_away_from_one() {
    for omega in [0.7, 1.5, 1.9] {
        let smooth = half(omega);
        let plain = HalfCycle { beside_one: false, ..smooth };
        for psi in [-0.5, 0.1, 0.7] {
            let (a, b) = (smooth.velocity(psi), plain.velocity(psi));
            assert!((a.value - b.value).abs() < 1e-14 * (1.0 + b.value.abs()), "{omega}");
            assert!((a.first - b.first).abs() < 1e-13, "{omega}");
            assert!((smooth.displacement(psi) - plain.displacement(psi)).abs() < 1e-13, "{omega}");
        }
    }
}

/// x/B at ψ = 0 is `tan β [tan(β/2) − 1/Ω]`, of the order 1/Ω².
#[test]
fn far_above_one_the_displacement_keeps_its_digits() {
    for omega in [30.0, 1e4, 1e7] {
        let beta = std::f64::consts::FRAC_PI_2 / omega;
        let (found, exact) =
            (half(omega).displacement(0.0), beta.tan() * ((beta / 2.0).tan() - omega.recip()));
        assert!((found / exact - 1.0).abs() < 16.0 * f64::EPSILON, "{omega}: {found} {exact}");
    }
}

/// The rounding remainder of Δ₀ contributes its own oscillation.
#[test]
fn the_rest_of_the_displacement_counts() {
    for omega in [0.3, 0.8, 1.4, 3.0] {
        let (plain, more) = (half(omega), half(omega).with_rest(0.25));
        for psi in [-0.4, 0.0, 0.3] {
            let due = 0.25 * (omega * psi).cos();
            assert!(
                (more.velocity(psi).value - plain.velocity(psi).value - due).abs() < 1e-13,
                "{omega} {psi}"
            );
        }
    }
}

/// So close to 1 that the start of an iteration would underflow: (1 − Ω)/cos β remains the same.
#[cfg(feature = "mp")]
#[test]
fn brought_into_range_the_motion_keeps_its_shape() {
    use crate::float::Float;
    use crate::float::mp::Mp;
    type Wide = Mp<8>;
    for away in [-300, -260, -240, -10] {
        let omega = Wide::of_int(1) - Wide::exp2i(away);
        let h = HalfCycle::new(&PhaseFunction::new(omega).unwrap(), Wide::exp2i(260));
        let near = h.in_range();
        assert_eq!(near == h, away >= -250, "{away}");
        let shape = |h: &HalfCycle<Wide>| h.one_minus_omega / h.cos_beta;
        assert!((shape(&near) / shape(&h) - Wide::of_int(1)).abs() <= Wide::epsilon() * Wide::of_int(4));
        assert!(near.one_minus_omega >= Wide::exp2i(-250));
        assert_eq!(near.max_displacement, Wide::exp2i(if away < -250 { 250 } else { 260 }));
    }
}
