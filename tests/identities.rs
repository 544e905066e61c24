//! The equations of the paper, one by one, on cycles at random (Ω, α).
//!
//! Each check is a residual against the size of the terms it is made of. The points keep 1e-3 away from Ω = 1
//! and 1/(2n+1), where the paper's own forms, unlike the library's, lose digits.

use proptest::prelude::*;
use stickslip::nonsticking::{self, border, matching};
use stickslip::{Border, Cycle, PhaseFunction, Ratios};

const TOLERANCE: f64 = 1e-10;

/// A non-sticking cycle with Ω in (0.15, 4), α from just above the border to eight times it.
fn cycles() -> impl Strategy<Value = Cycle<f64>> {
    (0.15f64..4.0, 1.0001f64..8.0)
        .prop_filter("the paper's forms are singular there", |(omega, _)| {
            [1.0, 3.0, 5.0].iter().all(|n| (omega * n - 1.0).abs() > 1e-3)
        })
        .prop_map(|(omega, over)| {
            let least = Border::new(omega).unwrap().min_force_ratio();
            Cycle::new(Ratios::new(omega, least * over).unwrap()).unwrap()
        })
}

/// The size of the terms: amplitudes, friction and the tangent that divides by a small cosine.
fn scale(cycle: &Cycle<f64>) -> f64 {
    let p = PhaseFunction::new(cycle.ratios().omega()).unwrap();
    1.0 + cycle.ratios().forced_amplitude().abs() + cycle.max_displacement() + p.tangent().powi(2)
}

macro_rules! vanish {
    ($cycle:expr, $($name:literal: $value:expr),+ $(,)?) => {
        let scale = scale($cycle);
        $(
            let (value, at): (f64, _) = ($value, $cycle.ratios());
            prop_assert!(value.abs() <= TOLERANCE * scale, "{}: {value:e} of {scale:e} at {at:?}", $name);
        )+
    };
}

/// A function of (given, unknowns).
type Of = fn(&matching::Given<f64>, &matching::Unknowns<f64>) -> f64;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn equations_21_to_25_vanish(c in cycles()) {
        let [e21, e22, e23, e24, e25] = c.given().residuals(&c.unknowns());
        vanish!(&c, "21": e21, "22": e22, "23": e23, "24": e24, "25": e25);
    }

    #[test]
    fn equations_28_to_39_and_45_hold(c in cycles()) {
        let (g, u) = (c.given(), c.unknowns());
        let at = |f: Of| f(&g, &u);
        let (a, b, rho) = (at(matching::Given::coefficient_a), at(matching::Given::coefficient_b), g.rho(&u));
        let (sin_lag, cos_lag) = g.lag(&u).sin_cos();
        let sign = (1.0 - c.ratios().omega()).signum();
        let divisor = 1.0 + matching::pi_1(g.omega).cos();
        vanish!(&c,
            "28": g.elimination_of_rate(&u),
            "29": g.elimination_of_position(&u),
            "32": (a * a + b * b - g.squared_coefficients(&u)) / 4.0,
            "33": (cos_lag - g.cos_lag_from_coefficients(&u)) * divisor,
            "34": (sin_lag - g.sin_lag_from_coefficients(&u)) * divisor,
            "35": a * a + b * b - 4.0,
            "36": (rho * rho - g.squared_rho(&u)) * divisor,
            "38": cos_lag - g.cos_lag(&u),
            "39": sin_lag - g.sin_lag(&u),
            "45": g.combined_lag(&u),
        );
        // 37: through a square root of a difference, which squares the distance to zero.
        let by_37 = g.max_velocity(&u, sign);
        vanish!(&c, "37": (by_37 - u.max_velocity) * rho * divisor);
        prop_assert!(rho * sign >= -1e-7 * scale(&c), "ρ has the sign of 1 − Ω: {rho}");
    }

    #[test]
    fn equations_11_to_20_join_the_branches(c in cycles()) {
        let (g, u) = (c.given(), c.unknowns());
        let (t1, t2) = (u.velocity_phase, u.displacement_phase);
        let (t3, t4) = (matching::half_period_later(t1), matching::half_period_later(t2));
        vanish!(&c,
            "11": g.rising_displacement(&u, t1) - u.deviation,
            "12": g.falling_displacement(&u, t3) + u.deviation,
            "13": g.rising_velocity(&u, t1) - u.max_velocity,
            "14": g.falling_velocity(&u, t3) + u.max_velocity,
            "17": g.rising_velocity(&u, t2),
            "18": g.falling_velocity(&u, t2),
            "19": g.rising_displacement(&u, t2) - u.max_displacement,
            "20": g.falling_displacement(&u, t2) - u.max_displacement,
            "3": g.falling_displacement(&u, t4) + u.max_displacement,
        );
    }

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
        let (omega, alpha) = (c.ratios().omega(), c.ratios().alpha());
        let phase = c.displacement_phase() - part * std::f64::consts::PI;
        let h = 1e-5 * omega.min(1.0);
        let second = omega * omega * (c.velocity_at(phase + h) - c.velocity_at(phase - h)) / (2.0 * h);
        let residual = second + c.displacement_at(phase) + 1.0 - alpha * phase.sin();
        prop_assert!(residual.abs() < 1e-8 * scale(&c), "{residual:e} at {:?}", c.ratios());
    }

    #[test]
    fn equations_50_to_56_are_the_same_cycle(c in cycles()) {
        let (half, pi) = (c.den_hartog(), std::f64::consts::PI);
        let delta = c.max_displacement();
        let (sine, cosine) = half.phase_lag.sin_cos();
        vanish!(&c,
            "50": half.displacement(0.0) - delta,
            "51": half.velocity(0.0),
            "52": half.displacement(pi) + delta,
            "53": half.velocity(pi),
            "55": half.c1 - half.omega * half.amplitude * sine,
            "56": half.c2 - (delta - half.friction_displacement - half.amplitude * cosine),
        );
    }

    #[test]
    fn equations_40_to_44_agree(c in cycles()) {
        let (omega, alpha) = (c.ratios().omega(), c.ratios().alpha());
        let (p, a) = (PhaseFunction::new(omega).unwrap(), c.ratios().forced_amplitude());
        let (sine, cosine) = c.displacement_phase().sin_cos();
        let q = (1.0 - omega) * (1.0 + omega);
        let by_42 = nonsticking::max_displacement_from_amplitude(a, 1.0, p.tangent(), omega);
        vanish!(&c,
            "40": sine - nonsticking::sin_displacement_phase(c.max_displacement(), alpha, q),
            "40, A": a * sine - c.max_displacement(),
            "41": cosine - nonsticking::cos_displacement_phase(p.value(), alpha),
            "41, A": a * cosine - p.tangent() / omega,
            "42": by_42 * by_42 - c.max_displacement().powi(2),
        );
    }

    #[test]
    fn equations_46_to_49_give_the_maximum_velocity(c in cycles()) {
        let (g, u) = (c.given(), c.unknowns());
        let (omega, alpha) = (g.omega, c.ratios().alpha());
        let sin_cos_pi_1 = matching::pi_1(omega).sin_cos();
        let sin_cos_t1 = u.velocity_phase.sin_cos();
        let e46 = nonsticking::velocity_phase_residual(g.amplitude, omega, sin_cos_pi_1, g.lag(&u), sin_cos_t1.0);
        let sign = (1.0 - omega).signum();
        let by_49 = nonsticking::max_velocity_from_phase(
            g.amplitude, omega, sin_cos_pi_1.1, sin_cos_t1, u.deviation, sign);
        let rho = g.rho(&u);
        vanish!(&c,
            "46": e46,
            "47": sin_cos_t1.0 - (1.0 + u.deviation) / alpha,
            "49": (by_49 - c.max_velocity()) * rho * (1.0 + sin_cos_pi_1.1),
        );
    }

    #[test]
    fn equations_57_to_62_meet_on_the_border(omega in 0.15f64..4.0) {
        prop_assume!([1.0, 3.0, 5.0].iter().all(|n| (omega * n - 1.0).abs() > 1e-3));
        let p = PhaseFunction::new(omega).unwrap();
        let alpha = border::turning_point_border(p.value(), omega);
        let q = (1.0 - omega) * (1.0 + omega);
        let delta = nonsticking::max_displacement(p.value(), alpha, q);
        let sine = nonsticking::sin_displacement_phase(delta, alpha, q);
        let scale = 1.0 + alpha * alpha / (q * q);
        prop_assert!((delta * omega * omega - 1.0).abs() < 1e-10 * scale);
        prop_assert!(border::slip_excess(alpha, sine, 1.0, delta, 1.0).abs() < 1e-10 * scale);
        // Eq. 60 vanishes there, for any B, and nowhere else.
        for b in [1.0, 0.37] {
            let at = |alpha| border::turning_point_residual(b, alpha, omega, p.tangent());
            prop_assert!(at(alpha).abs() < 1e-10 * scale * omega.powi(4).max(1.0), "{}", at(alpha));
            prop_assert!(at(alpha * 1.01) > 0.0 && at(alpha * 0.99) < 0.0);
        }
        prop_assert!(border::turning_point_criterion(p.value(), omega, alpha));
        prop_assert!(!border::turning_point_criterion(p.value(), omega, alpha.next_down() * (1.0 - 1e-15)));
    }

    #[test]
    fn equations_63_to_67_are_the_loop(c in cycles()) {
        let (omega, alpha, delta) = (c.ratios().omega(), c.ratios().alpha(), c.max_displacement());
        let (mass, stiffness, friction) = (2.0, 7.0, 3.0);
        let (p0, wd2) = (alpha * friction, omega * omega * stiffness / mass);
        let s = nonsticking::loop_size(friction, delta * friction / stiffness);
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-13 * b.abs();
        prop_assert!(close(c.loop_size_stiffness(), 2.0 * stiffness * s / (p0 * p0)));
        prop_assert!(close(c.loop_size_inertia(), 2.0 * mass * wd2 * s / (p0 * p0)));
    }

    #[test]
    fn equations_65_and_66_are_the_maximum_of_64(omega in 0.15f64..4.0, off in 0.001f64..0.3) {
        let (p, q) = (PhaseFunction::new(omega).unwrap(), (1.0 - omega) * (1.0 + omega));
        prop_assume!(p.value().abs() > 1e-3 && q.abs() > 1e-3);
        let best = nonsticking::best_force_ratio(p.value());
        let loop_at = |alpha| {
            nonsticking::loop_size_stiffness(nonsticking::max_displacement(p.value(), alpha, q), alpha)
        };
        let greatest = nonsticking::best_loop_size(p.value(), q);
        prop_assert!((loop_at(best) - greatest).abs() <= 1e-12 * greatest);
        prop_assert!(loop_at(best * (1.0 + off)) < greatest && loop_at(best * (1.0 - off / 2.0)) < greatest);
    }
}
