//! The ends of the domain with viscous damping, verdicts beside the border, and sensitivities.

use super::{plane, ratios};
use crate::random::Random;
use std::f64::consts::TAU;
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Drive, Error, Float, Oscillator, Regime, Response, Verdict, design};

#[test]
fn resonance_is_bounded_and_places_are_decided() {
    let at_one = Response::new(ratios(1.0, 0.01, 2.0));
    assert_eq!((at_one.regime, Verdict::new(at_one.ratios)), (Regime::NonSticking, Verdict::NonSticking));
    assert_eq!(Response::new(ratios(1.0, 0.0, 2.0)).regime, Regime::Unbounded);
    for (omega, zeta) in [(0.4, 0.05), (0.7, 0.3), (1.0, 1.0), (0.25, 1e-3)] {
        let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
        let verdict = |over: f64| Verdict::new(ratios(omega, zeta, least * over));
        assert_eq!(verdict(1.0), Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
        assert_eq!((verdict(1.0 - 1e-13), verdict(1.0 + 1e-13)), (Verdict::Sticking, Verdict::NonSticking));
        assert_eq!(Verdict::new(ratios(omega, zeta, 0.9)), Verdict::AtRest);
        assert!(matches!(Cycle::new(ratios(omega, zeta, least * 0.999)), Err(Error::Sticks { .. })));
    }
}
/// The error bound of the border on which the verdict relies.
#[test]
fn the_border_is_known_to_its_error_bound() {
    let mut random = Random(19);
    for _ in 0..3000 {
        let (omega, zeta) = plane(&mut random);
        let narrow = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
        let wide = Border::of(&ratios(Mp::<4>::from(omega), Mp::from(zeta), Mp::from(1))).min_force_ratio;
        let error = ((Mp::<4>::from(narrow) - wide) / wide).to_f64().abs() / f64::EPSILON;
        assert!(error < f64::from(Verdict::<f64>::DAMPED_BORDER_ERROR), "{omega} {zeta}: {error}");
    }
}
#[test]
fn the_turning_point_suffices_from_half_the_damped_frequency_on() {
    let mut random = Random(20);
    let mut inner = 0;
    for _ in 0..3000 {
        let (omega, zeta) = plane(&mut random);
        let border = Border::of(&ratios(omega, zeta, 1.0));
        let suffices = zeta >= 1.0 || omega >= (1.0 - zeta * zeta).sqrt() / 2.0;
        assert!(border.border_phase == 0.0 || !suffices, "{omega} {zeta}");
        assert!(border.min_force_ratio >= border.min_force_ratio_turning_point);
        inner += i32::from(border.border_phase != 0.0);
    }
    assert!(inner > 100, "{inner}");
}
/// The verdict of a machine with a damper is that of its ratios, except within rounding of an edge, where it
/// is undecided.
#[test]
fn a_machine_with_a_damper_has_a_place() {
    let mut random = Random(17);
    for i in 0..400 {
        let (omega, zeta) = match i % 4 {
            0 => (1.0 / random.between(2.97, 3.03), random.scale(1e-6, 3e-3)),
            _ => plane(&mut random),
        };
        let omega = omega.clamp(0.01, 100.0);
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping_ratio(zeta).unwrap();
        let found = design::forces_without_stop(&body, 2.0 * omega).unwrap();
        let ends: Vec<_> = found.intervals().flat_map(|(low, high)| [Some(low), high]).flatten().collect();
        for end in ends {
            let at = |by: f64| Verdict::of(&body, &Drive::force(end * by, 2.0 * omega).unwrap()).unwrap();
            let of_ratios = |by: f64| {
                let ratios = Drive::force(end * by, 2.0 * omega).unwrap().ratios(&body).unwrap();
                Verdict::new(ratios)
            };
            if end > 3.0 * (1.0 + 1e-12) {
                assert_eq!(at(1.0).regime(), None, "{omega} {zeta} {end}");
            }
            for by in [1.0 - 1e-9, 1.0 + 1e-9, 0.9, 1.1] {
                let (of_machine, of_ratios) = (at(by), of_ratios(by));
                // Near a peak, the rounding of the border is that of the distance from the peak.
                let is_hidden = of_machine.regime().is_none() && (by - 1.0).abs() < 1e-8;
                assert!(of_machine == of_ratios || is_hidden, "{omega} {zeta} {end} {by}: {of_machine:?}");
            }
        }
    }
    // A peak narrower than the rounding of the frequency leaves the verdict undecided.
    let light = Oscillator::new(1.0, 1.0, 1.0).unwrap().with_damping_ratio(1e-17).unwrap();
    let force = |p| Verdict::of(&light, &Drive::force(p, 1.0 / 3.0).unwrap()).unwrap();
    assert_eq!(force(1e17).regime(), None);
    assert_eq!(force(1e5), stickslip::Verdict::SixReversals);
    // A box of machines with a damper is decided by ball arithmetic.
    let boxed = stickslip::uncertainty::Interval::exactly;
    let damped = stickslip::uncertainty::ParameterBox::Machine(stickslip::uncertainty::Parameters {
        excitation: stickslip::Excitation::Force,
        mass: boxed(1.0),
        stiffness: boxed(1.0),
        friction_bound: boxed(1.0),
        amplitude: boxed(3.0),
        angular_frequency: boxed(0.7),
        damping: boxed(0.1),
    });
    assert_eq!(damped.verdict(), Ok(stickslip::Verdict::NonSticking));
}
#[test]
fn the_ends_of_the_domain_have_finite_answers() {
    for omega in [2f64.powi(-250), 1e-30, 1e-9, 1e-4, 1.0, 1.0 + f64::EPSILON, 1e4, 2f64.powi(250)] {
        for zeta in
            [2f64.powi(-250), 1e-20, 1e-9, 0.999_999_999, 1.0, 1.000_000_001, 30.0, 1e9, 2f64.powi(250)]
        {
            let border = Border::of(&ratios(omega, zeta, 1.0));
            let least = border.min_force_ratio;
            assert!(least.is_finite() && least > 0.0, "{omega:e} {zeta:e}: {least}");
            assert!((0.0..TAU).contains(&border.border_phase));
            let Some(alpha) = [2.0 * least, 4.0].into_iter().find(|a| *a >= least && *a < 2f64.powi(250))
            else {
                continue;
            };
            let found = Response::new(ratios(omega, zeta, alpha));
            let c = found.cycle.as_ref().unwrap();
            for x in [c.max_displacement, c.max_velocity, c.contraction(), c.damper_work()] {
                assert!(x.is_finite() && x >= 0.0, "{omega:e} {zeta:e} {alpha}: {x}");
            }
            assert!(c.contraction() <= 1.0, "{omega:e} {zeta:e} {alpha}: {}", c.contraction());
        }
    }
}
#[cfg(feature = "dual")]
#[test]
fn sensitivities_with_damping_are_those_of_differences() {
    let h = 1e-6;
    for (omega, zeta, alpha) in
        [(0.7, 0.05, 2.4), (0.4, 0.05, 9.0), (1.0, 0.1, 3.0), (0.8, 1.3, 14.0), (0.21, 0.02, 60.0)]
    {
        for (output, _, slopes) in crate::by_ratios(ratios(omega, zeta, alpha)) {
            let at = |omega, alpha| output.of(&Response::new(ratios(omega, zeta, alpha))).unwrap();
            let by_omega = (at(omega + h, alpha) - at(omega - h, alpha)) / (2.0 * h);
            let by_alpha = (at(omega, alpha + h) - at(omega, alpha - h)) / (2.0 * h);
            for (a, b) in slopes.into_iter().zip([by_omega, by_alpha]) {
                let close = (a - b).abs() < 1e-5 * (1.0 + b.abs());
                assert!(close, "{} at {omega} {zeta} {alpha}: {a} for {b}", output.name());
            }
        }
    }
}

/// On the border the deceleration at the maximum is that of friction but for rounding: the contraction is a number
/// there.
#[test]
fn the_contraction_on_the_border_is_a_number() {
    let ratios = super::ratios(0.001_999_999_999_957_319, 0.472_574_926_607_863_93, 499_998.893_332_360_84);
    let cycle = stickslip::Cycle::new(ratios).unwrap();
    assert!((0.0..=1e-300).contains(&cycle.contraction()), "{}", cycle.contraction());
}
