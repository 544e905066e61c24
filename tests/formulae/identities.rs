//! The equations of the paper, one by one, on cycles at random (Ω, α).
//!
//! Each check is a residual relative to the size of its terms. The points keep a distance of 1e-3 from Ω = 1
//! and 1/(2n+1), where the paper's own forms, unlike the library's, lose digits.

use crate::drawn::cases;
use proptest::prelude::*;
use stickslip::cycle::{self, border};
use stickslip::{Border, Cycle, PhaseFunction, Ratios};

const TOLERANCE: f64 = 1e-10;

/// A non-sticking cycle with Ω in (0.15, 4) and α from just above the border to eight times it.
fn cycles() -> impl Strategy<Value = Cycle<f64>> {
    (0.15f64..4.0, 1.0001f64..8.0)
        .prop_filter("the paper's forms are singular there", |(omega, _)| {
            [1.0, 3.0, 5.0].iter().all(|n| (omega * n - 1.0).abs() > 1e-3)
        })
        .prop_map(|(omega, over)| {
            let least = Border::new(omega).unwrap().min_force_ratio;
            Cycle::new(Ratios::new(omega, least * over).unwrap()).unwrap()
        })
}

/// The size of the terms: amplitudes, friction, and the tangent, whose denominator is a small cosine.
fn scale(cycle: &Cycle<f64>) -> f64 {
    let p = PhaseFunction::new(cycle.ratios.omega()).unwrap();
    1.0 + cycle.ratios.forced_amplitude().abs() + cycle.max_displacement + p.tangent().powi(2)
}

macro_rules! vanish {
    ($cycle:expr, $($name:literal: $value:expr),+ $(,)?) => {
        let scale = scale($cycle);
        $(
            let (value, at): (f64, _) = ($value, $cycle.ratios);
            prop_assert!(value.abs() <= TOLERANCE * scale, "{}: {value:e} of {scale:e} at {at:?}", $name);
        )+
    };
}

fn meet_on_the_border(omega: f64) {
    let p = PhaseFunction::new(omega).unwrap();
    let q = (1.0 - omega) * (1.0 + omega);
    let alpha = border::turning_point_border(p.value(), q, omega);
    let delta = cycle::max_displacement(p.value(), alpha, q);
    let sine = cycle::equations::sin_displacement_phase(delta, alpha, q);
    let scale = 1.0 + alpha * alpha / (q * q);
    assert!((delta * omega * omega - 1.0).abs() < 1e-10 * scale);
    assert!(border::slip_excess(alpha, sine, 1.0, delta, 1.0).abs() < 1e-10 * scale);
    // There eq. 60 vanishes for any B, and nowhere else.
    for b in [1.0, 0.37] {
        let at = |alpha| border::turning_point_residual(b, alpha, omega, p.tangent());
        assert!(at(alpha).abs() < 1e-10 * scale * omega.powi(4).max(1.0), "{}", at(alpha));
        assert!(at(alpha * 1.01) > 0.0 && at(alpha * 0.99) < 0.0);
    }
    assert!(border::turning_point_criterion(p.value(), omega, alpha));
    assert!(!border::turning_point_criterion(p.value(), omega, alpha.next_down() * (1.0 - 1e-15)));
}

/// An input that failed once.
#[test]
fn equations_57_to_62_met_here_too() {
    meet_on_the_border(0.401_897_162_409_002_03);
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn equations_15_16_and_54_are_one_waveform(c in cycles(), part in 0.0f64..1.0) {
        let (g, u, half) = (c.given(), c.unknowns(), c.den_hartog());
        let turn = part * std::f64::consts::PI;
        let falling = u.displacement_phase + turn;
        let rising = falling - std::f64::consts::PI;
        let omega = g.omega;
        vanish!(&c,
            "15": g.rising_displacement(&u, rising) - c.displacement_at(rising),
            "15′": g.rising_velocity(&u, rising) - c.velocity_at(rising) * omega,
            "16": g.falling_displacement(&u, falling) - c.displacement_at(falling),
            "16′": g.falling_velocity(&u, falling) - c.velocity_at(falling) * omega,
            "54": half.displacement(turn) - c.displacement_at(falling),
            "54′": half.velocity(turn) - c.velocity_at(falling) * omega,
        );
        prop_assert!(half.velocity(turn) <= TOLERANCE * scale(&c), "Den Hartog's condition");
    }

    #[test]
    fn equation_1_is_obeyed_between_reversals(c in cycles(), part in 0.01f64..0.99) {
        // (x″ + x + sgn x′ − α sin ω_d t)/… with x″ from the velocity by a symmetric difference.
        let (omega, alpha) = (c.ratios.omega(), c.ratios.alpha());
        let phase = c.displacement_phase - part * std::f64::consts::PI;
        let h = 1e-5 * omega.min(1.0);
        let second = omega * omega * (c.velocity_at(phase + h) - c.velocity_at(phase - h)) / (2.0 * h);
        let residual = second + c.displacement_at(phase) + 1.0 - alpha * phase.sin();
        prop_assert!(residual.abs() < 1e-8 * scale(&c), "{residual:e} at {:?}", c.ratios);
    }

    #[test]
    fn equations_57_to_62_meet_on_the_border(omega in 0.15f64..4.0) {
        prop_assume!([1.0, 3.0, 5.0].iter().all(|n| (omega * n - 1.0).abs() > 1e-3));
        meet_on_the_border(omega);
    }

    #[test]
    fn equations_65_and_66_are_the_maximum_of_64(omega in 0.15f64..4.0, off in 0.001f64..0.3) {
        let (p, q) = (PhaseFunction::new(omega).unwrap(), (1.0 - omega) * (1.0 + omega));
        prop_assume!(p.value().abs() > 1e-3 && q.abs() > 1e-3);
        let best = cycle::equations::best_force_ratio(p.value());
        let loop_at = |alpha| {
            cycle::loop_size_stiffness(cycle::max_displacement(p.value(), alpha, q), alpha)
        };
        let greatest = cycle::equations::best_loop_size(p.value(), q);
        prop_assert!((loop_at(best) - greatest).abs() <= 1e-12 * greatest);
        prop_assert!(loop_at(best * (1.0 + off)) < greatest && loop_at(best * (1.0 - off / 2.0)) < greatest);
    }
}
