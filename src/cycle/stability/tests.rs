//! Tests of `stability.rs`.

use super::{Multipliers, characteristic_polynomial, contraction, multiplier_product};
use crate::drawn::cases;
use crate::{Border, Cycle, Ratios};
use proptest::prelude::*;

#[test]
fn the_contraction_is_a_root_of_the_characteristic_polynomial() {
    // Real multipliers: Ω = 0.95, Δ₀/B = 2; the largest is −contraction or +contraction.
    let (omega, delta) = (0.95f64, 1.2f64);
    let beta = std::f64::consts::FRAC_PI_2 / omega;
    let lambda = contraction(omega, delta, beta.sin_cos());
    let s = multiplier_product(omega, delta);
    let cos_pi_1 = (2.0 * beta).cos();
    let residual = |l: f64| characteristic_polynomial(l, s, cos_pi_1).abs();
    assert!(residual(lambda).min(residual(-lambda)) < 1e-15);
    assert!(residual(lambda).max(residual(-lambda)) > 1e-3);
}

#[test]
fn the_modulus_of_a_complex_pair() {
    let (omega, delta) = (0.7f64, 3.488_507_872_497_762f64);
    let beta = std::f64::consts::FRAC_PI_2 / omega;
    let lambda = contraction(omega, delta, beta.sin_cos());
    assert!((lambda * lambda - multiplier_product(omega, delta)).abs() < 1e-15);
}

#[test]
fn on_the_border_at_two_nothing_is_left() {
    // g rounds to a number below 1, and gσ to one above.
    let left = contraction(
        2.000_000_000_000_026_f64,
        0.249_999_999_999_993_37,
        (0.707_106_781_186_554_8, 0.707_106_781_186_540_2),
    );
    assert!((0.0..1e-7).contains(&left), "{left}");
    let cycle = Cycle::new(Ratios::new(2.000_000_000_000_026, 1.677_050_983_124_846_8).unwrap()).unwrap();
    assert!((0.0..1e-7).contains(&cycle.contraction()), "{cycle:?}");
}

#[test]
fn marginal_at_one_over_n() {
    assert_eq!(contraction(0.5, 5.333, (0.0, -1.0)), 1.0);
}

/// With so much damping that the square of a multiplier underflows, it keeps its digits. Its factor
/// `e^{−ζT}`, T = π/Ω, has the rounding of the exponent: four roundings of ζT.
#[cfg(feature = "mp")]
#[test]
fn a_contraction_whose_square_underflows() {
    use crate::float::{Float, Mp};
    fn found<F: Float>([omega, zeta, alpha]: [f64; 3]) -> F {
        let ratios = Ratios::new(F::from_f64(omega), F::from_f64(alpha)).unwrap();
        Cycle::new(ratios.with_damping_ratio(F::from_f64(zeta)).unwrap()).unwrap().contraction()
    }
    for [omega, zeta, alpha] in [
        [0.006_159_127_929_907_48, 1.000_000_000_612_478_7, 52_724.0],
        [0.006_159_127_929_907_48, 0.9, 52_724.0],
        [0.006, 1.001, 1e5],
        [0.0055, 0.999_999_9, 1e6],
        [0.02, 0.999, 1e5],
    ] {
        let (rough, fine) =
            (found::<f64>([omega, zeta, alpha]), found::<Mp<4>>([omega, zeta, alpha]).to_f64());
        let rounding = 4.0 * f64::EPSILON * zeta * std::f64::consts::PI / omega;
        assert!(fine > 0.0 && (rough / fine - 1.0).abs() < rounding, "{omega} {zeta}: {rough:e} {fine:e}");
    }
}

fn multipliers(omega: f64, alpha: f64) -> Multipliers<f64> {
    Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().multipliers()
}

#[test]
fn the_multipliers_of_the_exact_motion() {
    // From the monodromy of the simulated motion at (0.7, 2).
    let [(re, im), _] = multipliers(0.7, 2.0).cycle;
    assert!((re + 0.222_401_57).abs() < 5e-9 && (im - 0.138_157_96).abs() < 5e-9, "{re} {im}");
}

#[test]
fn a_disturbance_that_is_gone_at_once() {
    // Ω = 2 on the border: cos(π/Ω) = 0 and s = 0.
    let quarter = core::f64::consts::FRAC_1_SQRT_2;
    let m = Multipliers::new(2.0, 0.25 * (1.0 - 1e-15), (quarter, quarter));
    assert!(m.contraction < 1e-14, "{m:?}");
    assert_eq!(m.cycles_to_settle(1e-12), Some(1));
}

/// Where the roots nearly coincide, on the border and near Ω = 2, the rounding of their product exceeds the
/// roots.
#[test]
fn at_a_double_root_the_larger_is_first() {
    let mut real = 0;
    for i in 0..2000 {
        let omega = if i == 0 { 1.9999999995343387f64 } else { 2.0 - f64::from(i) * 3.7e-12 };
        let least = Border::new(omega).unwrap().min_force_ratio;
        let alpha = if i == 0 { 1.6770509830428322 } else { least * (1.0 + f64::from(i % 4) * f64::EPSILON) };
        let Ok(cycle) = Cycle::new(Ratios::new(omega, alpha).unwrap()) else { continue };
        let [first, second] = cycle.multipliers().half_cycle;
        assert!(first.0.hypot(first.1) >= second.0.hypot(second.1), "{first:?} {second:?} at {omega}");
        assert!((first.0.hypot(first.1) - cycle.contraction()).abs() < 1e-7, "{first:?} at {omega}");
        real += u32::from(first.1 == 0.0);
    }
    assert!(real > 100, "{real}");
}

#[test]
fn cycles_to_settle() {
    let m = multipliers(0.7, 2.0);
    let (rate, tolerance) = (m.contraction, 1e-12);
    let cycles = m.cycles_to_settle(tolerance).unwrap();
    assert_eq!(cycles, (tolerance.ln() / rate.ln()).ceil() as u64);
    assert_eq!(m.cycles_to_settle(1.0), Some(0));
    assert_eq!(m.cycles_to_settle(rate), Some(1));
    assert_eq!(m.cycles_to_settle(0.0), None);
    assert_eq!(multipliers(0.5, 4.0).cycles_to_settle(0.5), None);
    let slow = multipliers(0.5001, 4.0);
    let expected = 1e-6f64.ln() / slow.contraction.ln();
    assert!((slow.cycles_to_settle(1e-6).unwrap() as f64 - expected).abs() <= 1.0 + 1e-6 * expected);
}

/// The larger modulus of a pair.
fn modulus(pair: [(f64, f64); 2]) -> f64 {
    pair.into_iter().map(|(re, im)| re.hypot(im)).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn roots_of_the_characteristic_polynomial(omega in 0.05f64..20.0, over in 1.0f64..8.0) {
        prop_assume!((omega - 1.0).abs() > 1e-9);
        let alpha = Border::new(omega).unwrap().min_force_ratio * over;
        let cycle = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
        let (m, s) = (cycle.multipliers(), multiplier_product(omega, cycle.max_displacement));
        let cos_pi_1 = (std::f64::consts::PI / omega).cos();
        for (re, im) in m.half_cycle {
            // λ² + (1 + s) C λ + s, real and imaginary part
            let real = characteristic_polynomial(re, s, cos_pi_1) - im * im;
            let imaginary = im * (2.0 * re + (1.0 + s) * cos_pi_1);
            prop_assert!(real.abs() < 1e-13 && imaginary.abs() < 1e-13, "{real:e} {imaginary:e}");
        }
        prop_assert!((modulus(m.half_cycle) - cycle.contraction()).abs() < 1e-14);
        prop_assert!(modulus(m.cycle) <= 1.0 + 1e-15);
    }
}
