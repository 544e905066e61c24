//! Tests of `identify.rs`.

use super::model::motion;
use super::outliers::judge;
use super::search::{ResponseCurve, reduced};
use super::valleys::{Levels, searched};
use super::{AmplitudeKind, Identified, Measurement, PhaseKind, Reading, identify, in_ratios};
use crate::cycle::damped;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::motion::{LongRun, State, Trajectory};
use crate::random::Random;
use crate::{Cycle, Drive, Error, Oscillator, Ratios};

const FORCE: f64 = 12.0;

fn body(friction: f64, zeta: f64) -> Oscillator<f64> {
    Oscillator::new(2.0, 8.0, friction).unwrap().with_damping_ratio(zeta).unwrap()
}

/// The exact curve between two frequencies.
fn curve(friction: f64, zeta: f64, (low, high): (f64, f64), count: u32, phases: bool) -> Vec<Measurement> {
    let body = body(friction, zeta);
    let at = |i: u32| low + (high - low) * f64::from(i) / f64::from(count - 1);
    (0..count)
        .map(|i| {
            let drive = Drive::force(FORCE, at(i)).unwrap();
            let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
            Measurement {
                angular_frequency: at(i),
                amplitude: cycle.max_displacement * body.friction_displacement(),
                phase: phases.then_some(cycle.displacement_phase),
            }
        })
        .collect()
}

fn found(curve: &[Measurement]) -> Identified {
    identify(2.0, Some(8.0), Some(FORCE), curve, Reading::default()).unwrap()
}

/// Root mean squares of dense samples of motions with stops, read as peaks: the kind is recognised, with the noise of the curve.
#[test]
fn root_mean_squares_of_motions_with_stops_are_recognised() {
    let body = body(7.0, 0.05);
    let measured = |i: u32| {
        let angular_frequency = 0.4 + 0.2 * f64::from(i);
        let ratios = Drive::force(FORCE, angular_frequency).unwrap().ratios(&body).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let steady = limit.steady_state().unwrap();
        let count = 20_000;
        let samples = Trajectory::new(ratios, steady.state).unwrap().samples(count).unwrap().take(20_000);
        let square: f64 = samples.map(|at| at.unwrap().state.x.powi(2)).sum();
        let amplitude = (square / f64::from(count)).sqrt() * body.friction_displacement();
        (Measurement { angular_frequency, amplitude, phase: None }, steady.sticks_per_cycle > 0)
    };
    let curve: Vec<_> = (0..12).map(measured).collect();
    assert!(curve.iter().filter(|(_, stops)| *stops).count() >= 4, "{curve:?}");
    let curve: Vec<_> = curve.into_iter().map(|(measured, _)| measured).collect();
    let (kind, noise) = found(&curve).better.unwrap();
    assert!(kind == AmplitudeKind::RootMeanSquare && noise < 1e-3, "{kind:?} {noise}");
}

#[test]
fn a_body_without_a_damper_is_found() {
    for (friction, count) in [(0.3, 8), (1.5, 12), (3.0, 6), (4.5, 10)] {
        let fit = found(&curve(friction, 0.0, (1.3, 3.5), count, false));
        assert!((fit.friction_bound.value / friction - 1.0).abs() < 1e-6, "{friction} {count}: {fit:?}");
        assert!(fit.damping_ratio.value < 1e-6, "{friction} {count}: {fit:?}");
    }
}

#[test]
fn one_frequency_does_not_tell_friction_from_damping() {
    let point = curve(3.0, 0.05, (1.5, 3.6), 2, false)[0];
    let error = identify(2.0, Some(8.0), Some(FORCE), &[point; 4], Reading::default()).unwrap_err();
    assert!(matches!(error, Error::NotIdentified), "{error}");
}

#[test]
fn an_exact_curve_gives_its_parameters_back() {
    for (friction, zeta) in [(3.0, 0.05), (1.5, 0.01), (4.0, 0.2), (0.5, 0.03)] {
        for phases in [false, true] {
            let fit = found(&curve(friction, zeta, (1.2, 3.6), 20, phases));
            assert!((fit.friction_bound.value / friction - 1.0).abs() < 1e-8, "{friction} {zeta}: {fit:?}");
            assert!((fit.damping_ratio.value / zeta - 1.0).abs() < 1e-8, "{friction} {zeta}: {fit:?}");
            assert!(fit.noise < 1e-9 && fit.residuals.iter().all(|r| !r.stops && !r.is_suspect()));
        }
    }
}

/// The closed form and the exact motion meet on the border, with all quantities that are read from them.
#[test]
fn a_motion_is_continuous_where_it_begins_to_stop() {
    for (omega, zeta) in [(0.23, 0.03), (0.4, 0.01), (0.7, 0.0), (1.4, 0.1), (0.02, 0.3)] {
        let half = HalfPeriod::new(omega, f64::max(zeta, 1e-9));
        let border = 1.0 / damped::border(&half).min_force_ratio;
        let at = |kappa: f64| motion(omega, [kappa, zeta], true).unwrap();
        let (slides, stops) = (at(border * (1.0 - 1e-7)), at(border * (1.0 + 1e-7)));
        assert!(!slides.stops && stops.stops, "{omega} {zeta}");
        for (a, b) in
            [(slides.peak, stops.peak), (slides.whole.root_mean_square, stops.whole.root_mean_square)]
        {
            assert!((a / b - 1.0).abs() < 1e-4, "{omega} {zeta}: {slides:?} {stops:?}");
        }
        let turned = |a: f64, b: f64| reduced(a - b).abs();
        assert!(turned(slides.peak_phase, stops.peak_phase) < 2e-3, "{omega} {zeta}: {slides:?} {stops:?}");
        assert!(turned(slides.whole.lag, stops.whole.lag) < 1e-4, "{omega} {zeta}: {slides:?} {stops:?}");
    }
}

/// A slow motion with stops is within the stated errors of the exact one.
#[test]
fn a_slow_body_follows_the_force() {
    for (omega, kappa, zeta) in
        [(0.0019, 0.1, 0.0), (0.0019, 0.7, 0.01), (0.0015, 0.4, 0.5), (0.0019, 0.3, 3.0)]
    {
        let slow = motion(omega, [kappa, zeta], false).unwrap();
        let ratios = Ratios::new(omega, 1.0 / kappa).unwrap().with_damping_ratio(zeta).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let peak = limit.steady_state().unwrap().max_displacement;
        assert!((slow.peak - kappa * peak.value).abs() < 20.0 * omega * omega, "{omega} {kappa} {zeta}");
        assert!(
            reduced(slow.peak_phase - peak.phase.reduced()).abs() < 5.0 * omega,
            "{omega} {kappa} {zeta}"
        );
    }
}

/// A region without an end is left at the bound on its nodes, and the search says so.
#[test]
fn a_search_without_end_is_cut() {
    let measured = curve(3.0, 0.05, (1.2, 3.6), 8, false);
    let body = body(3.0, 0.05);
    let points: Vec<_> =
        measured.iter().map(|m| in_ratios(&super::Spring::Of(body), FORCE, m).unwrap()).collect();
    let curve = ResponseCurve::of(&points, AmplitudeKind::Peak, PhaseKind::Peak);
    let found = judge(&curve, [0.3, 0.1], None).unwrap();
    for (alike, is_whole) in [(2.0 * found.fit.sum, true), (f64::INFINITY, false)] {
        let levels = Levels { least: found.fit.sum, alike, followed: alike };
        let (lower, region) = searched(&curve, &found, Vec::new(), levels).unwrap();
        assert!(lower.is_none() && region.is_whole == is_whole, "{alike}");
    }
}

#[test]
fn too_little_or_bad_input_is_refused() {
    let few = curve(3.0, 0.05, (1.2, 3.6), 2, false);
    assert_eq!(
        identify(2.0, Some(8.0), Some(FORCE), &few, Reading::default()),
        Err(Error::TooFewMeasurements { count: 2 })
    );
    let mut bad = curve(3.0, 0.05, (1.2, 3.6), 5, false);
    bad[2].amplitude = -1.0;
    let error = identify(2.0, Some(8.0), Some(FORCE), &bad, Reading::default()).unwrap_err();
    assert_eq!(error.to_string(), "measurement 3: peak displacement Δ₀ = -1 must be > 0");
    // A force far too large for these amplitudes.
    let curve = curve(3.0, 0.05, (1.2, 3.6), 9, false);
    let error = identify(2.0, Some(8.0), Some(1e12 * FORCE), &curve, Reading::default()).unwrap_err();
    assert!(matches!(error, Error::Unexplained { .. }), "{error}");
}

/// For amplitudes beyond those of a body without a damper, far from resonance and near it, zero damping fits
/// best. The friction of this fit is compared with the minimum of the sum of squares.
#[test]
fn where_less_than_no_damping_would_fit_friction_alone_is_fitted() {
    for (friction, most) in [(1.5, 0.02), (3.0, 0.01), (4.5, 0.03)] {
        let mut measured = curve(friction, 0.0, (1.3, 3.5), 12, false);
        for point in &mut measured {
            let ratio = point.angular_frequency / 2.0;
            point.amplitude *= 1.0 + most / (1.0 + 30.0 * (1.0 - ratio).powi(2)) - most / 3.0;
        }
        let fit = found(&measured);
        assert!(fit.damping_ratio.value <= 1e-8, "{friction}: {fit:?}");
        let squares = |friction: f64| -> f64 {
            let body = body(friction, 0.0);
            let off = |m: &Measurement| {
                let drive = Drive::force(FORCE, m.angular_frequency).unwrap();
                let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
                1.0 - cycle.max_displacement * body.friction_displacement() / m.amplitude
            };
            measured.iter().map(|m| off(m).powi(2)).sum()
        };
        let (mut low, mut high) = (0.8 * friction, 1.2 * friction);
        for _ in 0..60 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if squares(a) < squares(b) { high = b } else { low = a }
        }
        // The minimum of a sum of squares is known to half of the digits.
        assert!((fit.friction_bound.value / low - 1.0).abs() < 1e-6, "{friction} {low}: {fit:?}");
    }
}

/// Amplitudes that know nothing of a resonance are refused; those of a body with errors of a fifth are not.
#[test]
fn white_noise_is_refused_and_a_noisy_resonance_is_not() {
    let mut random = Random(9);
    let (mut noise_answered, mut curves_refused) = (0, 0);
    for i in 0..24u32 {
        let count = [8, 15, 30][(i % 3) as usize];
        let mut noise = curve(1.5, 0.02, (1.2, 3.6), count, false);
        for point in &mut noise {
            point.amplitude = if i % 2 == 0 { 10.0 * random.next() } else { 10f64.powf(2.0 * random.next()) };
        }
        match identify(2.0, Some(8.0), Some(FORCE), &noise, Reading::default()) {
            Ok(_) => noise_answered += 1,
            Err(error) => assert!(
                matches!(
                    error,
                    Error::CurveUnexplained { .. } | Error::Unexplained { .. } | Error::NotIdentified
                ),
                "{error}"
            ),
        }
        let mut noisy = curve(1.5, 0.02, (1.2, 3.6), count.max(15), false);
        for point in &mut noisy {
            point.amplitude *= 1.0 + 0.2 * (random.next() + random.next() + random.next() - 1.5) * 2.0;
        }
        curves_refused +=
            u32::from(identify(2.0, Some(8.0), Some(FORCE), &noisy, Reading::default()).is_err());
    }
    assert!(noise_answered <= 1 && curves_refused == 0, "{noise_answered} {curves_refused}");
}
