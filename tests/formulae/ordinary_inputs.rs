//! Inputs that break straightforward code and must be ordinary here: the floats next to Ω = 1 and 1/n, huge
//! and tiny ratios.

use stickslip::cycle::{self, matching};
use stickslip::generators::neighbours;
use stickslip::{Border, Cycle, Error, PhaseFunction, Ratios, Regime, Response};

fn response(omega: f64, alpha: f64) -> Response<f64> {
    Response::new(Ratios::new(omega, alpha).unwrap())
}

#[test]
fn every_float_beside_one_has_its_answer() {
    let four_over_pi = 4.0 / std::f64::consts::PI;
    for omega in neighbours(1.0, 50) {
        let answer = response(omega, 1.5);
        assert!((answer.border.min_force_ratio - four_over_pi).abs() < 1e-14);
        if omega == 1.0 {
            assert_eq!(answer.regime, Regime::Unbounded);
            continue;
        }
        let cycle = answer.cycle.as_ref().unwrap();
        // Δ₀ |1 − Ω²| = √(α² − K²) with K = −4/π − (2/π)(Ω − 1), V₀ → Δ₀.
        let k = four_over_pi + four_over_pi / 2.0 * (omega - 1.0);
        let expected = (2.25 - k * k).sqrt() / ((1.0 - omega) * (1.0 + omega)).abs();
        assert!((cycle.max_displacement / expected - 1.0).abs() < 2e-15, "{omega:e}");
        assert!((cycle.max_velocity / cycle.max_displacement - 1.0).abs() < 2e-14);
        assert!(cycle.deviation().is_finite() && cycle.contraction() <= 1.0);
        assert!(
            (cycle.displacement_at(0.3) + cycle.displacement_at(0.3 + std::f64::consts::PI)).abs()
                <= 1e-13 * cycle.max_displacement
        );
    }
}

#[test]
fn at_one_the_regime_depends_on_four_over_pi() {
    for (alpha, regime) in [(1.0, Regime::Stuck), (1.27, Regime::Sticking), (1.28, Regime::Unbounded)] {
        assert_eq!(response(1.0, alpha).regime, regime);
        assert!(response(1.0, alpha).cycle.as_ref().is_none());
    }
    assert!(matches!(Cycle::new(Ratios::new(1.0, 1.28).unwrap()), Err(Error::Unbounded { .. })));
    assert!(matches!(Cycle::new(Ratios::new(1.0, 1.27).unwrap()), Err(Error::Sticks { .. })));
}

#[test]
fn every_float_beside_a_pole_has_its_border() {
    for n in [3.0f64, 5.0, 7.0, 9.0, 101.0] {
        for omega in neighbours(1.0 / n, 20) {
            // No double is 1/n for these n: the distance 1 − nΩ is exact, and K ≈ −(1 − Ω²)·2/(π(1 − nΩ)).
            let rest = (-n).mul_add(omega, 1.0);
            assert!(rest != 0.0);
            let k = PhaseFunction::new(omega).unwrap().value();
            let expected = -(1.0 - omega * omega) * 2.0 / (std::f64::consts::PI * rest);
            assert!((k / expected - 1.0).abs() < 1e-13, "{omega:e}: {k:e} for {expected:e}");
            let border = Border::new(omega).unwrap();
            assert!(border.min_force_ratio.is_finite() && border.min_force_ratio >= k.abs());
            let answer = response(omega, border.min_force_ratio * 1.5);
            let cycle = answer.cycle.as_ref().unwrap();
            assert!(cycle.max_displacement > border.least_displacement);
            assert!(cycle.max_velocity.is_finite() && cycle.velocity_phase.is_finite());
            assert_eq!(response(omega, border.min_force_ratio * 0.99).reversals_per_cycle(), Some(6));
        }
    }
}

#[test]
fn every_float_beside_a_zero_of_k_has_its_border() {
    for n in [2.0f64, 4.0, 6.0, 100.0] {
        for omega in neighbours(1.0 / n, 20) {
            let border = Border::new(omega).unwrap();
            let limit = 1.0 / (omega * omega) - 1.0;
            assert!((border.min_force_ratio / limit - 1.0).abs() < 1e-12, "{omega:e}");
            let cycle = Cycle::new(Ratios::new(omega, limit * 1.1).unwrap()).unwrap();
            assert!(cycle.contraction() > 1.0 - 1e-10 && cycle.contraction() <= 1.0 + 1e-15);
        }
    }
}

#[test]
fn the_whole_domain_is_finite_and_consistent() {
    let mut omega = 2f64.powi(-250);
    let mut seen = 0;
    while omega <= 2f64.powi(250) {
        let border = Border::new(omega).unwrap();
        let least = border.min_force_ratio;
        assert!(
            least.is_finite() && least >= border.min_force_ratio_turning_point && least >= 1.2,
            "{omega:e}: {least:e}"
        );
        if least * 2.0 <= 2f64.powi(250) {
            let answer = response(omega, least * 2.0);
            let cycle = answer.cycle.as_ref().unwrap();
            for value in [
                cycle.max_displacement,
                cycle.max_velocity,
                cycle.loop_size_stiffness(),
                cycle.loop_size_inertia(),
                cycle.contraction(),
            ] {
                assert!(value.is_normal() && value > 0.0, "{omega:e}: {cycle:?}");
            }
            assert!((0.0..std::f64::consts::TAU).contains(&cycle.velocity_phase));
            assert!((0.0..std::f64::consts::TAU).contains(&cycle.displacement_phase));
            seen += 1;
        }
        omega *= 1.37;
    }
    assert!(seen > 500, "{seen}");
}

#[test]
fn tiny_force_is_at_rest_and_formulae_outside_their_domain_say_nan() {
    for alpha in [f64::from_bits(1), f64::MIN_POSITIVE, 1e-300, 0.5, 1.0] {
        assert_eq!(response(0.7, alpha).regime, Regime::Stuck);
    }
    assert!(cycle::max_displacement(2.0f64, 1.5, 0.5).is_nan());
    assert!(cycle::equations::displacement_phase(2.0f64, 1.5, 0.5).is_nan());
    let cycle = *response(0.7, 2.0).cycle.as_ref().unwrap();
    assert!(cycle.displacement_at(f64::NAN).is_nan() && cycle.velocity_at(f64::INFINITY).is_nan());
    assert_eq!(matching::pi_1(0.5f64), std::f64::consts::TAU);
}

#[test]
fn far_above_the_natural_frequency_no_digit_is_lost() {
    // Δ₀, ω_d t₂, V₀, ω_d t₁, Δ₁ from eq. 44, 41, the velocity's own maximum and eq. 47 at 150 digits.
    for (omega, alpha, expected) in [
        (
            1e3,
            3.0,
            [
                2.555_897_658_560_855e-6,
                4.161_319_506_393_069,
                2.617_197_129_611_493_5e-6,
                2.801_755_669_397_666_5,
                2.113_909_972_789_074e-7,
            ],
        ),
        (
            1e6,
            2.5,
            [
                1.944_890_459_572_492_6e-12,
                4.032_999_053_633_882,
                2.023_414_766_796_564_5e-12,
                2.730_075_807_522_219,
                1.978_225_564_588_333e-13,
            ],
        ),
        (
            1e30,
            2.0,
            [
                1.237_981_784_893_324e-60,
                3.809_049_869_618_177,
                1.352_310_472_400_663_3e-60,
                2.617_993_877_991_494_4,
                1.615_991_890_593_36e-61,
            ],
        ),
    ] {
        let answer = response(omega, alpha);
        let c = answer.cycle.as_ref().unwrap();
        let found =
            [c.max_displacement, c.displacement_phase, c.max_velocity, c.velocity_phase, c.deviation()];
        for (value, reference) in found.iter().zip(expected) {
            assert!((value / reference - 1.0).abs() < 5e-15, "{omega:e}: {value:e} for {reference:e}");
        }
        assert!((c.displacement_at(c.velocity_phase) / c.deviation() - 1.0).abs() < 1e-13);
    }
}
