//! Friction and damping from response curves with noise, stops, wrong values and other readings: how often the
//! stated interval contains the true values, and how far an answer is from them.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::random::Random;
use std::f64::consts::{FRAC_PI_2, SQRT_2, TAU};
use stickslip::design::{AmplitudeKind, Identified, Measurement, PhaseKind, Reading, identify};
use stickslip::motion::{LongRun, State, Trajectory};
use stickslip::uncertainty::Estimate;
use stickslip::{Cycle, Drive, Error, Oscillator, Ratios};

/// A standard normal number, by Box and Muller's method.
fn normal(random: &mut Random) -> f64 {
    (-2.0 * (1.0 - random.next()).ln()).sqrt() * (TAU * random.next()).cos()
}

/// The shares of `trials` machines, each measured at 30 frequencies with 1 % noise, whose true friction and
/// damping lie within the 95 % intervals.
fn coverage(trials: u32, seed: u64) -> (f64, f64) {
    let mut random = Random(seed);
    let (mut friction_within, mut damping_within) = (0, 0);
    for _ in 0..trials {
        let (friction, zeta) = (random.between(1.0, 4.0), random.scale(0.02, 0.2));
        let body = |friction, zeta: f64| {
            Oscillator::new(2.0, 8.0, friction).unwrap().with_damping_ratio(zeta).unwrap()
        };
        let measure = |i: u32, random: &mut Random| {
            let angular_frequency = 1.2 + 2.4 * f64::from(i) / 29.0;
            let drive = Drive::force(12.0, angular_frequency).unwrap();
            let body = body(friction, zeta);
            let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
            let exact = cycle.max_displacement * body.friction_displacement();
            Measurement { angular_frequency, amplitude: exact * (1.0 + 0.01 * normal(random)), phase: None }
        };
        let curve: Vec<_> = (0..30).map(|i| measure(i, &mut random)).collect();
        let found = identify(2.0, Some(8.0), Some(12.0), &curve, Reading::default()).unwrap();
        let within = |(low, high): (f64, f64), x: f64| u32::from(low <= x && x <= high);
        friction_within += within(found.friction_bound.interval(), friction);
        damping_within += within(found.damping_ratio.interval(), zeta);
    }
    (f64::from(friction_within) / f64::from(trials), f64::from(damping_within) / f64::from(trials))
}

#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let (friction, damping) = coverage(curves(800), 1);
    assert!((friction - 0.95).abs() <= 0.02 && (damping - 0.95).abs() <= 0.02, "{friction} {damping}");
}

/// A motion in units of p₀/k, by the exact motion.
struct Truth {
    peak: f64,
    phase: f64,
    root_mean_square: f64,
    /// The lag of the fundamental.
    lag: f64,
}

impl Truth {
    fn at(omega: f64, kappa: f64, zeta: f64) -> Self {
        let ratios = Ratios::new(omega, 1.0 / kappa).unwrap().with_damping_ratio(zeta).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let steady = limit.steady_state().unwrap();
        let (n, mut square, mut sine, mut cosine) = (4000, 0.0, 0.0, 0.0);
        let samples = Trajectory::new(ratios, steady.state).unwrap().samples(n).unwrap();
        for state in samples.take(n as usize).map(|at| at.unwrap().state) {
            let (s, c) = state.phase.reduced().sin_cos();
            square += state.x * state.x;
            sine += state.x * s;
            cosine += state.x * c;
        }
        let peak = steady.max_displacement;
        Self {
            peak: kappa * peak.value,
            phase: peak.phase.reduced(),
            root_mean_square: kappa * (square / f64::from(n)).sqrt(),
            lag: (-cosine).atan2(sine),
        }
    }
}

/// A curve of one machine with 2 % noise, at evenly spaced frequencies; half of the curves have phases.
fn drawn(random: &mut Random, count: u32) -> (f64, f64, Vec<Measurement>) {
    let kappa = random.between(0.05, 0.7);
    let zeta = if random.next() < 0.3 { 0.0 } else { random.scale(0.002, 0.2) };
    let (low, high) = (random.scale(0.15, 0.7), random.between(1.2, 3.0));
    let has_phases = random.next() < 0.5;
    let measure = |i: u32, random: &mut Random| {
        let angular_frequency = low + (high - low) * f64::from(i) / f64::from(count - 1);
        let truth = Truth::at(angular_frequency, kappa, zeta);
        let amplitude = truth.peak * (1.0 + 0.02 * normal(random));
        let phase = (truth.phase + 0.02 * normal(random)).rem_euclid(TAU);
        Measurement { angular_frequency, amplitude, phase: has_phases.then_some(phase) }
    };
    (kappa, zeta, (0..count).map(|i| measure(i, random)).collect())
}

fn suspects(found: &Identified) -> usize {
    found.residuals.iter().filter(|r| r.is_suspect()).count()
}

/// The number of curves of a test: more by the environment variable `CURVES`.
fn curves(few: u32) -> u32 {
    std::env::var("CURVES").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}

fn within(estimate: Estimate, truth: f64) -> u32 {
    let (low, high) = estimate.interval();
    u32::from(low <= truth && truth <= high)
}

/// No value is left out, none of the curves is refused, and the truth lies in the intervals as often as they say; see
/// docs/development/robustness.md.
#[test]
fn curves_with_stops_are_fitted() {
    let mut random = Random(11);
    let (count, mut left_out, mut inside) = (curves(24), 0, [0; 2]);
    for i in 0..count {
        let (kappa, zeta, curve) = drawn(&mut random, 12 + i % 20);
        let found = identify(1.0, Some(1.0), Some(1.0), &curve, Reading::default()).unwrap();
        let off = |estimate: Estimate, truth: f64| (estimate.value - truth).abs() / estimate.standard_error;
        let (friction, damping) = (off(found.friction_bound, kappa), off(found.damping_ratio, zeta));
        assert!(friction < 6.0 && damping < 6.0, "{i}: {kappa} {zeta} {found:?}");
        assert!(found.friction_bound.interval().0 >= 0.0 && found.damping_ratio.interval().0 >= 0.0);
        assert_eq!((found.better, found.noise < 0.04), (None, true), "{i}: {found:?}");
        left_out += usize::from(suspects(&found) > 0);
        inside[0] += within(found.friction_bound, kappa);
        inside[1] += within(found.damping_ratio, zeta);
    }
    println!("of {count}: {left_out} left out, {inside:?} within");
    assert_eq!(left_out, 0);
    // Of 24, at least 21 with a probability of 97 %.
    assert!(inside.iter().all(|&n| n >= (0.93 * f64::from(count)) as u32 - count / 20), "{inside:?}");
}

/// The amplitude in units of p₀/k, in closed form or by the exact motion.
fn amplitude(omega: f64, kappa: f64, zeta: f64) -> f64 {
    let ratios = Ratios::new(omega, 1.0 / kappa.max(1e-12)).unwrap().with_damping_ratio(zeta).unwrap();
    if let Ok(cycle) = Cycle::new(ratios) {
        return kappa.max(1e-12) * cycle.max_displacement;
    }
    let limit = LongRun::from_start(ratios, State::default()).unwrap();
    limit.steady_state().map_or(0.0, |steady| kappa * steady.max_displacement.value)
}

/// A curve of amplitudes with noise of 1 to 8 %, at 8 to 27 frequencies, many of them with stops.
fn noisy(seed: u64) -> Vec<Measurement> {
    let mut random = Random(seed);
    let count = 8 + (seed % 20) as u32;
    let (kappa, zeta) = (random.between(0.05, 0.7), random.scale(0.002, 0.2));
    let (low, high) = (random.scale(0.08, 0.5), random.between(0.6, 2.0));
    let noise = random.between(0.01, 0.08);
    let measure = |i: u32| {
        let angular_frequency = low + (high - low) * f64::from(i) / f64::from(count - 1);
        let amplitude = amplitude(angular_frequency, kappa, zeta) * (1.0 + noise * normal(&mut random));
        Measurement { angular_frequency, amplitude, phase: None }
    };
    (0..count).map(measure).collect()
}

/// The sum of squares of the amplitudes that count.
fn squares(curve: &[Measurement], found: &Identified, kappa: f64, zeta: f64) -> f64 {
    let counted = std::iter::zip(curve, &found.residuals).filter(|(_, r)| !r.is_suspect());
    let off = |m: &Measurement| 1.0 - amplitude(m.angular_frequency, kappa, zeta) / m.amplitude;
    counted.map(|(m, _)| off(m).powi(2)).sum()
}

/// By how many standard errors a value lies beyond the interval.
fn beyond(estimate: Estimate, x: f64) -> f64 {
    let (low, high) = estimate.interval();
    (low - x).max(x - high) / estimate.standard_error
}

/// The quantile of Student's distribution is greater.
const LEAST_QUANTILE: f64 = 1.96;
/// Half a step of the search, in standard errors.
const HALF_A_STEP: [f64; 2] = [0.175, 0.25];

/// No point of a dense grid around the answer, nor of a coarse one over the whole range, has a lesser sum of squares, and those
/// with sums below that of the ends of the interval lie in it. Of the first two curves a descent from the best points
/// of a grid of starts ends in a higher valley, beyond a motion that begins to stop.
#[test]
fn no_valley_is_lower_than_the_answer() {
    for seed in [195, 285].into_iter().chain(0..u64::from(curves(60))) {
        let curve = noisy(seed);
        let found = identify(1.0, Some(1.0), Some(1.0), &curve, Reading::default()).unwrap();
        assert!(found.search_is_complete, "{seed}");
        let [friction, damping] = [found.friction_bound, found.damping_ratio];
        let least = squares(&curve, &found, friction.value, damping.value);
        let counted = curve.len() - suspects(&found);
        let level = least * (1.0 + LEAST_QUANTILE.powi(2) / (counted as f64 - 2.0));
        let near = |i: u32, e: Estimate| e.value + 4.0 * e.standard_error * (f64::from(i) / 16.0 - 1.0);
        let fine = (0..=32).flat_map(|i| (0..=32).map(move |j| (near(i, friction), near(j, damping))));
        let far = |i: u32, j: u32| (0.05 * f64::from(i), 0.01 * f64::from(j * j));
        let coarse = (1..20).flat_map(|i| (0..12).map(move |j| far(i, j)));
        for (kappa, zeta) in fine.chain(coarse).filter(|(r, z)| *r > 0.0 && *r < 1.0 && *z >= 0.0) {
            let there = squares(&curve, &found, kappa, zeta);
            // The descent ends where it would gain less than this.
            assert!(there >= least * (1.0 - 1e-9), "{seed}: {there} at {kappa} {zeta}, {found:?}");
            let beyond = beyond(friction, kappa).max(beyond(damping, zeta));
            assert!(
                there > level || beyond < HALF_A_STEP[0],
                "{seed}: {beyond} at {kappa} {zeta}, {found:?}"
            );
        }
    }
}

/// The same with the natural frequency or the force unknown: at no other one, given as known, is there a better fit, and
/// those as good as the ends of the interval lie in it.
#[test]
fn no_other_natural_frequency_or_force_is_better() {
    for seed in 0..u64::from(curves(6)) {
        let curve = noisy(20 * seed + 12 + seed % 8);
        let with = |natural: Option<f64>, force| {
            identify(1.0, natural.map(|x| x * x), force, &curve, Reading::default())
        };
        let answer = if seed % 2 == 0 { with(None, Some(1.0)) } else { with(Some(1.0), None) };
        let Some(found) = answer.ok().filter(|found| suspects(found) == 0) else { continue };
        assert!(found.search_is_complete, "{seed}");
        let unknown = found.natural_frequency.or(found.force).unwrap();
        let sum = |found: &Identified| found.residuals.iter().map(|r| r.amplitude.powi(2)).sum::<f64>();
        let level = sum(&found) * (1.0 + LEAST_QUANTILE.powi(2) / (curve.len() as f64 - 3.0));
        for i in -8..=8 {
            let value = unknown.value + 0.4 * f64::from(i) * unknown.standard_error;
            let known =
                if seed % 2 == 0 { with(Some(value), Some(1.0)) } else { with(Some(1.0), Some(value)) };
            let Some(known) = known.ok().filter(|found| suspects(found) == 0) else { continue };
            assert!(sum(&known) >= sum(&found) * (1.0 - 1e-6), "{seed} {value}: {known:?} {found:?}");
            for (own, other) in [
                (unknown, value),
                (found.friction_bound, known.friction_bound.value),
                (found.damping_ratio, known.damping_ratio.value),
            ] {
                assert!(
                    sum(&known) > level || beyond(own, other) < HALF_A_STEP[1],
                    "{seed} {value}: {known:?} {found:?}"
                );
            }
        }
    }
}

/// One to three wrong amplitudes of 25.
#[test]
fn wrong_amplitudes_do_not_move_the_answer() {
    let mut random = Random(7);
    let (count, mut inside, mut named, mut wrongs, mut others) = (curves(16), [0; 2], 0, 0, 0);
    for _ in 0..count {
        let (kappa, zeta, mut curve) = drawn(&mut random, 25);
        let mut wrong: Vec<usize> = Vec::new();
        let number = random.between(1.0, 4.0) as usize;
        while wrong.len() < number {
            let i = random.between(0.0, 25.0) as usize;
            if !wrong.contains(&i) {
                curve[i].amplitude *=
                    if random.next() < 0.5 { random.scale(1.3, 10.0) } else { random.scale(0.1, 0.7) };
                wrong.push(i);
            }
        }
        let found = identify(1.0, Some(1.0), Some(1.0), &curve, Reading::default()).unwrap();
        inside[0] += within(found.friction_bound, kappa);
        inside[1] += within(found.damping_ratio, zeta);
        let is_named = |i: usize| found.residuals[i].amplitude_is_suspect;
        named += wrong.iter().filter(|&&i| is_named(i)).count();
        others += (0..25).filter(|i| !wrong.contains(i) && found.residuals[*i].is_suspect()).count();
        wrongs += wrong.len();
    }
    println!("of {count}: {inside:?} within, {named} of {wrongs} named, {others} others");
    assert!(inside.iter().all(|&n| n >= count * 9 / 10), "{inside:?} of {count}");
    assert!(named * 100 >= wrongs * 95, "{named} of {wrongs}");
}

/// The exact curve of r_y = 0.2 without a damper, to five digits, three of whose motions stop.
#[test]
fn phases_and_stops_lead_to_the_true_minimum() {
    let frequencies = [0.2, 0.3, 0.4, 0.6, 0.8, 1.2, 1.5];
    let amplitudes = [0.96447, 0.88633, 1.13218, 1.55060, 2.71142, 2.18595, 0.76594];
    let phases = [1.4209, 0.9858, 1.2581, 1.6943, 1.7898, 4.4352, 4.4195];
    let curve: Vec<_> = (0..7)
        .map(|i| Measurement {
            angular_frequency: frequencies[i],
            amplitude: amplitudes[i],
            phase: Some(phases[i]),
        })
        .collect();
    let found = identify(1.0, Some(1.0), Some(1.0), &curve, Reading::default()).unwrap();
    assert!((found.friction_bound.value - 0.2).abs() < 1e-5 && found.damping_ratio.value < 1e-5, "{found:?}");
    assert!(found.noise < 1e-5 && found.phase_noise.unwrap() < 1e-4, "{found:?}");
    assert_eq!((suspects(&found), found.residuals.iter().filter(|r| r.stops).count()), (0, 3));
}

/// A machine of 5 kg, 20 kN/m and 100 N with 12 N of friction and 2 % of damping, measured at 25 frequencies
/// from 4 to 16 Hz; one of them flips between stopping and sliding near the answer.
fn shaker(read: impl Fn(u32, &Truth) -> (f64, Option<f64>)) -> Vec<Measurement> {
    let measure = |i: u32| {
        let angular_frequency = TAU * (4.0 + 0.5 * f64::from(i));
        let truth = Truth::at(angular_frequency / 4000f64.sqrt(), 0.12, 0.02);
        let (amplitude, phase) = read(i, &truth);
        Measurement { angular_frequency, amplitude: amplitude * 100.0 / 20e3, phase }
    };
    (0..25).map(measure).collect()
}

fn of_shaker(curve: &[Measurement], reading: Reading) -> Identified {
    identify(5.0, Some(20e3), Some(100.0), curve, reading).unwrap()
}

/// Within three standard errors of the truth, with the noise of the measurements.
fn is_true(found: &Identified) -> bool {
    let near =
        |estimate: Estimate, truth: f64| (estimate.value - truth).abs() <= 3.0 * estimate.standard_error;
    near(found.friction_bound, 12.0) && near(found.damping_ratio, 0.02) && found.noise < 0.03
}

#[test]
fn no_good_curve_is_refused() {
    for seed in 0..20 {
        let noise = std::cell::RefCell::new(Random(seed));
        let curve = shaker(|_, truth| (truth.peak * (1.0 + 0.02 * normal(&mut noise.borrow_mut())), None));
        let found = of_shaker(&curve, Reading::default());
        let off = (found.friction_bound.value - 12.0) / found.friction_bound.standard_error;
        assert!(off.abs() < 4.0 && found.noise < 0.03, "{seed}: {found:?}");
    }
}

#[test]
fn three_wrong_amplitudes_are_named() {
    let mut noise = Random(3);
    let factors: Vec<f64> = (0..25).map(|_| 1.0 + 0.02 * normal(&mut noise)).collect();
    let wrong = |i: u32| match i {
        5 => 3.0,
        12 => 0.3,
        18 => 2.0,
        _ => factors[i as usize],
    };
    let found = of_shaker(&shaker(|i, truth| (truth.peak * wrong(i), None)), Reading::default());
    assert!(is_true(&found), "{found:?}");
    let named: Vec<usize> = (0..25).filter(|&i| found.residuals[i].is_suspect()).collect();
    assert_eq!(named, [5, 12, 18]);
}

/// Amplitudes of another kind: found as such if the reading says so, and otherwise a suspicion.
#[test]
fn amplitudes_of_another_kind_are_suspected() {
    let noise = |i: u32| 1.0 + 0.02 * (7.0 * f64::from(i)).sin();
    for kind in [AmplitudeKind::RootMeanSquare, AmplitudeKind::PeakToPeak] {
        let measured = |truth: &Truth| match kind {
            AmplitudeKind::RootMeanSquare => truth.root_mean_square,
            _ => 2.0 * truth.peak,
        };
        let curve = shaker(|i, truth| (noise(i) * measured(truth), None));
        let found = of_shaker(&curve, Reading { amplitude: kind, phase: None });
        assert!(is_true(&found) && found.better.is_none() && suspects(&found) == 0, "{kind:?}: {found:?}");
        let (better, noise) = of_shaker(&curve, Reading::default()).better.unwrap();
        assert!(better == kind && noise < 0.03, "{kind:?}: {better:?} {noise}");
    }
    // A root mean square is not its harmonic approximation where a motion has stops.
    let truth = Truth::at(0.4, 0.4, 0.0);
    assert!((truth.root_mean_square * SQRT_2 / truth.peak - 1.0).abs() > 0.01);
}

#[test]
fn the_sign_of_phases_is_found() {
    let noise = |i: u32| 0.02 * (7.0 * f64::from(i)).sin();
    let kinds = [PhaseKind::Peak, PhaseKind::Lag, PhaseKind::TransferFunction];
    for kind in kinds {
        let phase = |truth: &Truth| match kind {
            PhaseKind::Peak => truth.phase,
            PhaseKind::Lag => truth.lag,
            PhaseKind::TransferFunction => -truth.lag,
        };
        let curve = shaker(|i, truth| (truth.peak * (1.0 + noise(i + 3)), Some(phase(truth) + noise(i))));
        let found = of_shaker(&curve, Reading::default());
        assert!(found.phase == Some(kind) && is_true(&found), "{kind:?}: {found:?}");
        assert!(found.phase_noise.unwrap() < 0.03 && suspects(&found) == 0, "{kind:?}: {found:?}");
        // A kind that was named is not changed.
        let other = kinds[usize::from(kind == PhaseKind::Peak)];
        let named = Reading { phase: Some(other), ..Reading::default() };
        let found = of_shaker(&curve, named);
        assert!(found.phase == Some(other) && found.phase_noise.unwrap() > 0.1, "{kind:?}: {found:?}");
    }
    // The peak of a motion without friction is a quarter turn after its lag.
    let truth = Truth::at(1.5, 1e-6, 0.05);
    assert!((truth.phase - truth.lag - FRAC_PI_2).abs() < 1e-4);
}

#[test]
fn the_measurement_that_is_wrong_is_named() {
    let mut curve = shaker(|_, truth| (truth.peak, Some(truth.phase)));
    curve[3].phase = Some(163.0);
    let error = identify(5.0, Some(20e3), Some(100.0), &curve, Reading::default()).unwrap_err();
    assert!(matches!(error, Error::InMeasurement { index: 3, .. }), "{error}");
    let text = "measurement 4: phase ω_d t = 163 must be ≥ -6.283185307179586 and ≤ 6.283185307179586";
    assert_eq!(error.to_string(), text);
}
