//! The inverse problems with a damper: velocity and displacement, bands, friction and stiffness.

use stickslip::design::{
    Band, Edge, OptimumKind, bands, force_for_velocity, force_ratio_for_displacement,
    force_ratio_for_velocity, frequency_bands, most_dissipating_force_ratio,
    most_dissipating_frequency_ratio, most_dissipating_stiffness,
};
use stickslip::{Border, Cycle, Drive, Error, Oscillator, Ratios};

fn all(alpha: f64, zeta: f64, low: f64, high: f64) -> Vec<Band<f64>> {
    bands(alpha, zeta, low..=high).unwrap().collect::<Result<_, _>>().unwrap()
}

fn least(omega: f64, zeta: f64) -> f64 {
    Border::of(&Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap()).min_force_ratio
}

/// Compared with 200,000 values of the border: no point outside the bands slides, and none inside sticks.
#[test]
fn none_is_missed_on_a_grid() {
    for (alpha, zeta) in [
        (1.25, 0.01),
        (3.0, 0.2),
        (12.0, 1e-4),
        (12.0, 0.05),
        (31.0, 0.003),
        (200.0, 0.02),
        (60.0, 0.7),
        (9.0, 1.5),
    ] {
        let found = all(alpha, zeta, 0.04, 4.0);
        for i in 0..20_000 {
            let omega = 0.04 * 100f64.powf(f64::from(i) / 20_000.0);
            let inside = found.iter().any(|band| band.low <= omega && omega <= band.high);
            assert_eq!(
                inside,
                least(omega, zeta) <= alpha,
                "α = {alpha}, ζ = {zeta}, Ω = {omega}: {found:?}"
            );
        }
        for band in &found {
            for (end, edge, outside) in [(band.low, band.low_edge, -1e-9), (band.high, band.high_edge, 1e-9)]
            {
                assert!(least(end, zeta) <= alpha, "{band:?}");
                assert!(edge == Edge::Range || least(end * (1.0 + outside), zeta) > alpha, "{band:?}");
            }
        }
    }
}

/// Peaks and bands far narrower than the steps of a uniform mesh.
#[test]
fn a_narrow_gap_and_a_narrow_band_are_found() {
    for zeta in [1e-3f64, 1e-6, 1e-9] {
        // Just below the peak at dT = 3π there is a gap of a small fraction of its width.
        let at = (1.0f64 - zeta * zeta).sqrt() / 3.0;
        let places = (-400..400).map(|i| at * (1.0 + f64::from(i) * zeta / 20.0));
        let (peak, most) =
            places.map(|o| (o, least(o, zeta))).fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        let found = all(most * 0.98, zeta, 0.26, 0.4);
        assert!(found.len() >= 2 && found.iter().all(|b| peak < b.low || peak > b.high), "{zeta}: {found:?}");
    }
    // Just above the minimum between Ω = 1/3 and 1, the band is as without damping.
    let minimum = 1.211_236_5;
    let without = bands(minimum, 0.0, 0.4..=3.0).unwrap().map(Result::unwrap).collect::<Vec<_>>();
    let with = all(minimum, 1e-12, 0.4, 3.0);
    assert_eq!(without.len(), with.len());
    for (a, b) in without.iter().zip(&with) {
        assert!((a.low - b.low).abs() < 1e-6 && (a.high - b.high).abs() < 1e-6, "{a:?} {b:?}");
    }
}

/// There is no band below 1/√(1 + α): `α_min ≥ 1/Ω² − 1`.
#[test]
fn the_border_is_above_its_proved_bound() {
    for i in 0..4000 {
        let omega = 0.02 * 100f64.powf(f64::from(i % 200) / 200.0);
        let zeta = 1e-6 * 1e8f64.powf(f64::from(i / 200) / 20.0);
        assert!(least(omega, zeta) >= (1.0 / (omega * omega) - 1.0) * (1.0 - 1e-13), "{omega} {zeta}");
    }
    assert!(all(10.0, 0.3, 1e-9, 0.3).is_empty());
}

/// The energy dissipated by friction per cycle at a stiffness; 0 where the body sticks.
fn energy(mass: f64, stiffness: f64, friction: f64, damping: f64, drive: &Drive<f64>) -> f64 {
    let body = Oscillator::new(mass, stiffness, friction).unwrap().with_damping(damping).unwrap();
    let cycle = drive.ratios(&body).and_then(Cycle::new);
    cycle.map_or(0.0, |c| 4.0 * friction * c.max_displacement * body.friction_displacement())
}

#[test]
fn no_stiffness_of_a_grid_is_better() {
    let mut inside = 0;
    for (friction, damping, low, high) in [
        (3.0, 0.4, 0.5, 60.0),
        (3.0, 0.01, 4.0, 20.0),
        (0.35, 0.05, 60.0, 190.0),
        (3.0, 2.0, 10.0, 90.0),
        (1.0, 6.0, 0.5, 60.0),
    ] {
        let body = Oscillator::new(2.0, 1.0, friction).unwrap().with_damping(damping).unwrap();
        let drive = Drive::force(9.0, 2.0).unwrap();
        let best = most_dissipating_stiffness(&body, &drive, low..=high).unwrap();
        let at_best = energy(2.0, best.at, friction, damping, &drive);
        assert!((at_best / best.value - 1.0).abs() < 1e-9, "{best:?} {at_best}");
        let better = (0..=20_000)
            .map(|i| low + (high - low) * f64::from(i) / 20_000.0)
            .find(|&k| energy(2.0, k, friction, damping, &drive) > best.value * (1.0 + 1e-12));
        assert_eq!(better, None, "{friction} {damping}: {best:?}");
        inside += u32::from(best.kind == OptimumKind::Interior);
    }
    assert!((2..5).contains(&inside), "{inside}");
    // Without a damper the optimum is at Ω = 1 and infinite; a weak damper makes it finite, close to Ω = 1.
    assert!(matches!(most_dissipating_frequency_ratio(3.0, 0.5..=2.0), Err(Error::AtResonance { .. })));
    let body = Oscillator::new(2.0, 1.0, 3.0).unwrap().with_damping(0.01).unwrap();
    let best = most_dissipating_stiffness(&body, &Drive::force(9.0, 2.0).unwrap(), 4.0..=20.0).unwrap();
    assert!((best.at / 8.0f64 - 1.0).abs() < 1e-2, "{best:?}");
}

#[test]
fn where_it_sticks_throughout_that_is_said() {
    let body = Oscillator::new(2.0, 1.0, 8.0).unwrap().with_damping(0.4).unwrap();
    let error = most_dissipating_stiffness(&body, &Drive::force(9.0, 2.0).unwrap(), 100.0..=300.0);
    assert!(matches!(error, Err(Error::SticksThroughout { .. })), "{error:?}");
}

fn cycle(omega: f64, zeta: f64, alpha: f64) -> Cycle<f64> {
    Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)).and_then(Cycle::new).unwrap()
}

/// Substituting the force gives the target, also through Ω = 1 and ζ = 1.
#[test]
fn a_target_is_reached() {
    for omega in [0.02, 0.21, 0.334, 0.4, 0.7, 1.0, 1.6, 20.0] {
        for zeta in [1e-9, 0.01, 0.2, 0.7, 1.0, 1.5, 8.0] {
            let least = least(omega, zeta);
            for over in [1.0 + 1e-9, 1.2, 5.0, 1e4] {
                let wanted = cycle(omega, zeta, least * over);
                let by_velocity: f64 = force_ratio_for_velocity(omega, zeta, wanted.max_velocity).unwrap();
                let by_displacement: f64 =
                    force_ratio_for_displacement(omega, zeta, wanted.max_displacement).unwrap();
                for (alpha, reached, target) in [
                    (
                        by_velocity,
                        cycle(omega, zeta, by_velocity.max(least)).max_velocity,
                        wanted.max_velocity,
                    ),
                    (
                        by_displacement,
                        cycle(omega, zeta, by_displacement.max(least)).max_displacement,
                        wanted.max_displacement,
                    ),
                ] {
                    // The effect of the rounding of α, given that the cycle is a difference of a and G.
                    let slack = 1e-13
                        * (1.0
                            + alpha / target * (1.0 + omega)
                                / (2.0 * zeta * omega).hypot(1.0 - omega * omega));
                    assert!(
                        (reached / target - 1.0).abs() < slack,
                        "{omega} {zeta} {over}: {reached} for {target}"
                    );
                }
            }
            // The rounding of the border moves the velocity there by as much as 1/q times itself.
            let rounding = 1e-15 / (2.0 * zeta * omega).hypot(1.0 - omega * omega);
            let small = cycle(omega, zeta, least).max_velocity * (1.0 - 1e-9 - rounding);
            let error = force_ratio_for_velocity(omega, zeta, small);
            assert!(matches!(error, Err(Error::TargetSticks { .. })), "{omega} {zeta}: {error:?}");
        }
    }
}

#[test]
fn physical_units_are_the_same_questions() {
    // ω_n = 2, B = 3/8.
    let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping_ratio(0.05).unwrap();
    let wanted = cycle(0.7, 0.05, 3.0);
    let force: f64 = force_for_velocity(&body, 1.4, wanted.max_velocity * 0.375 * 1.4).unwrap();
    assert!((force / 9.0 - 1.0).abs() < 1e-13, "{force}");
    let drive = Drive::force(36.0, 1.0).unwrap();
    let found: Vec<_> = frequency_bands(&body, &drive, 0.2..=4.0).unwrap().map(Result::unwrap).collect();
    let ratios = all(12.0, 0.05, 0.1, 2.0);
    assert_eq!(found.len(), ratios.len());
    for (a, b) in found.iter().zip(&ratios) {
        assert!((a.low / 2.0 - b.low).abs() < 1e-12 && (a.high / 2.0 - b.high).abs() < 1e-12, "{a:?} {b:?}");
    }
}

/// No force ratio of a grid has a larger loop of friction than the optimum.
#[test]
fn the_best_friction_is_the_best() {
    for omega in [0.3, 0.45, 0.7, 1.0, 1.4, 3.0] {
        for zeta in [0.001, 0.05, 0.3, 1.0, 2.0] {
            let best = most_dissipating_force_ratio(omega, zeta).unwrap();
            let least = least(omega, zeta);
            let at = |alpha: f64| cycle(omega, zeta, alpha).loop_size_stiffness();
            assert!((at(best.at) / best.value - 1.0).abs() < 1e-12, "{omega} {zeta}: {best:?}");
            assert!(
                (0..2000).all(|i| at(least * (1.0 + 0.003 * f64::from(i))) <= best.value * (1.0 + 1e-12))
            );
        }
    }
}

/// The width of the border's peaks at dT = 3π, 5π, … decreases with the damping: no band extends over a peak
/// that is higher than α, however small the difference.
#[test]
fn no_band_reaches_over_a_peak() {
    for zeta in [1e-2, 1e-3, 1e-5, 1e-7, 1e-10] {
        for n in 1..=6 {
            let pole = (1.0f64 - zeta * zeta).sqrt() / f64::from(2 * n + 1);
            let peak = least(pole, zeta);
            for below in [1e-3, 0.3] {
                let alpha = peak * (1.0 - below);
                for (low, high) in [(0.8 * pole, 1.2 * pole), (pole * (1.0 - 1e-3), pole * 1.3)] {
                    for band in all(alpha, zeta, low, high) {
                        assert!(band.high < pole || band.low > pole, "{zeta} {n} {below}: {band:?}");
                    }
                }
            }
            assert!(
                all(peak * 1.001, zeta, 0.999 * pole, 1.001 * pole)
                    .iter()
                    .any(|b| b.low < pole && pole < b.high)
            );
        }
    }
}
