//! The answers to the inverse problems, checked by the exact motion.

use crate::drawn::cases;
use proptest::prelude::*;
use stickslip::design;
use stickslip::motion::{LongRun, State, SteadyState};
use stickslip::{Border, Ratios};

/// The steady motion from rest.
fn motion(omega: f64, alpha: f64) -> SteadyState<f64> {
    let limit = LongRun::from_start(Ratios::new(omega, alpha).unwrap(), State::default()).unwrap();
    *limit.steady_state().unwrap_or_else(|| panic!("({omega}, {alpha}): {limit:?}"))
}

/// Whether Ω is at least `gap` of a turn away from 1/n, where a motion settles slowly or not at all.
fn settles(omega: f64, gap: f64) -> bool {
    ((1.0 / omega).round() * omega - 1.0).abs() > gap * omega
}

/// A₁ of a motion: its work divided by p₀²/(2k).
fn loop_size(omega: f64, alpha: f64) -> f64 {
    2.0 * motion(omega, alpha).energy_out / (alpha * alpha)
}

proptest! {
    #![proptest_config(cases(1500))]

    #[test]
    fn the_force_for_a_target_moves_it_there(omega in 0.15f64..6.0, over in 1.001f64..20.0) {
        prop_assume!(settles(omega, 0.01));
        let least = Border::new(omega).unwrap().least_displacement;
        let force = design::force_ratio_for_displacement(omega, 0.0, least * over).unwrap();
        let steady = motion(omega, force);
        prop_assert_eq!(steady.sticks_per_cycle, 0);
        prop_assert!((steady.max_displacement.value / (least * over) - 1.0).abs() < 1e-9);
        let speed = steady.max_velocity.value * 1.5;
        let force = design::force_ratio_for_velocity(omega, 0.0, speed).unwrap();
        prop_assert!((motion(omega, force).max_velocity.value / speed - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_least_force_divides_sliding_from_the_rest(omega in 0.15f64..6.0) {
        prop_assume!(settles(omega, 0.02));
        let least = Border::new(omega).unwrap().min_force_ratio;
        let slides = |alpha| {
            let steady = motion(omega, alpha);
            steady.sticks_per_cycle == 0 && steady.velocity_zeros_per_cycle == 2
        };
        prop_assert!(slides(least * (1.0 + 1e-6)) && !slides(least * (1.0 - 1e-6)));
    }

    #[test]
    fn the_bands_divide_sliding_from_the_rest(alpha in 1.3f64..30.0, low in 0.12f64..0.5) {
        for band in design::bands(alpha, 0.0, low..=3.0).unwrap() {
            let band = band.unwrap();
            let inside = band.low + 0.37 * (band.high - band.low);
            if settles(inside, 1e-3) {
                prop_assert_eq!(motion(inside, alpha).sticks_per_cycle, 0, "{} of {:?}", inside, band);
            }
            let outside = band.low * (1.0 - 1e-5);
            if band.low_edge == design::Edge::Border && settles(outside, 1e-3) {
                let steady = motion(outside, alpha);
                prop_assert!(steady.sticks_per_cycle > 0 || steady.velocity_zeros_per_cycle > 2);
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn no_friction_dissipates_more(omega in 0.2f64..3.0, other in prop::collection::vec(1.01f64..20.0, 20)) {
        prop_assume!(settles(omega, 0.02));
        let best = design::most_dissipating_force_ratio(omega, 0.0).unwrap();
        prop_assert!((loop_size(omega, best.at * (1.0 + 1e-9)) / best.value - 1.0).abs() < 1e-6);
        let of_all = design::most_dissipating_force_ratio_of_all(omega, 0.0, 1e-3).unwrap();
        prop_assert!(of_all.value >= best.value * (1.0 - 1e-12));
        prop_assert!((loop_size(omega, of_all.at * (1.0 + 1e-9)) / of_all.value - 1.0).abs() < 1e-4);
        for alpha in other {
            prop_assert!(loop_size(omega, alpha) <= of_all.bound * (1.0 + 1e-9), "{} at {}", alpha, omega);
        }
    }
}
