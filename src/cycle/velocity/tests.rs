//! No point of the half cycle is faster than the maximum, and every start leads to the same maximum.

use super::centre::from_centre;
use super::iteration::from_bracket;
use super::{GivenCycle, by_low_waves, fastest};
use crate::cycle::half_cycle::HalfCycle;
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::cycle::reversal::Reversal;
use crate::cycle::{Border, Cycle, max_displacement};
use crate::drawn::cases;
use crate::machine::ratios::Ratios;
use core::cell::Cell;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

fn half(omega: f64, alpha: f64) -> (HalfCycle<f64>, f64) {
    let p = PhaseFunction::new(omega).unwrap();
    let k = p.value();
    (HalfCycle::new(&p, max_displacement(k, alpha, one_minus_square(omega))), k)
}

proptest! {
    #![proptest_config(cases(4000))]

    /// Checks the module's proof by a scan of the whole half cycle.
    #[test]
    fn nothing_in_the_half_cycle_is_faster(
        omega in prop_oneof![0.05f64..3.0, (0.0f64..40.0).prop_map(|e| 10f64.powf(e))],
        over in 1.0001f64..4.0,
    ) {
        prop_assume!((omega - 1.0).abs() > 1e-6);
        let alpha = Border::new(omega).unwrap().min_force_ratio * over;
        let (half, k) = half(omega, alpha);
        let best = fastest(&half, k, alpha);
        let beta = std::f64::consts::FRAC_PI_2 / omega;
        prop_assert!(best.psi.abs() <= beta);
        let n = 4000;
        for i in 0..=n {
            let psi = beta * (f64::from(2 * i) / f64::from(n) - 1.0);
            let v = half.velocity(psi).value;
            prop_assert!(v <= best.velocity * (1.0 + 1e-13), "{} at {psi}: {v}", best.velocity);
        }
    }
}

/// The start in the middle may find nothing; where it does, it is the root of the bracket.
#[test]
fn both_starts_find_the_same_root() {
    let compared = Cell::new(0);
    let drawn = (0.5f64..3.0, 1.0001f64..4.0);
    let same = |(omega, over): (f64, f64)| {
        prop_assume!((omega - 1.0).abs() > 1e-3);
        let alpha = Border::new(omega).unwrap().min_force_ratio * over;
        let (half, k) = half(omega, alpha);
        if let Some((quick, _)) = from_centre(&half) {
            let safe = from_bracket(&half, k, alpha);
            prop_assert!((quick.psi - safe).abs() < 1e-8, "{} {safe}", quick.psi);
            compared.set(compared.get() + 1);
        }
        Ok(())
    };
    TestRunner::new(cases(4000)).run(&drawn, same).unwrap();
    assert!(compared.get() > 2000, "{}", compared.get());
}

/// Below Ω = 1/2 one step from the start arrives, for either sign of cos β.
#[test]
fn the_first_start_is_near_enough() {
    let mut arrived = [0; 2];
    for i in 0..400 {
        let omega = 0.03 + 0.47 * (f64::from(i) * 0.618_034).fract();
        let alpha = Border::new(omega).unwrap().min_force_ratio * (1.01 + f64::from(i % 7));
        let p = PhaseFunction::new(omega).unwrap();
        let reversal = Reversal::new(&p, alpha).of_sliding(omega);
        let displacement = reversal.max_displacement_pair();
        let displacement_phase = reversal.displacement_phase();
        let found = by_low_waves(p, GivenCycle { reversal, displacement, alpha, displacement_phase });
        let (half, k) = half(omega, alpha);
        let Some((found, _)) = found else { continue };
        arrived[usize::from(half.sin_cos_beta().1 < 0.0)] += 1;
        let expected = from_bracket(&half, k, alpha);
        assert!((found.psi - expected).abs() < 1e-7 / omega, "{omega} {alpha}: {} {expected}", found.psi);
    }
    assert!(arrived[0] + arrived[1] > 390 && arrived[0].min(arrived[1]) > 150, "{arrived:?}");
}

/// Half way between two crests of the faster wave, to within rounding: at f32 the minimum there was once
/// taken for the maximum.
#[test]
fn not_the_minimum_between_two_equal_maxima() {
    let cycle = Cycle::new(Ratios::new(0.186_831_79f32, 28.893_51).unwrap()).unwrap();
    assert!((cycle.max_velocity - 35.545_4).abs() < 1e-4, "{}", cycle.max_velocity);
}
