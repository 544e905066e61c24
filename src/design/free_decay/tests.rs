//! Tests of `free_decay.rs`.

use super::{DecayIdentified, TurningPoints, identify_decay, identify_turning_points};
use crate::machine::error::Error;
use crate::motion::FreeDecay;
use crate::random::Random;

/// Turning points of the exact motion in B, by its own recursion, to the rest of the body.
fn turns(first: f64, zeta: f64, count: usize) -> Vec<f64> {
    let (mut x, mut found) = (first, Vec::new());
    let kappa = (-zeta * std::f64::consts::PI / (1.0 - zeta * zeta).sqrt()).exp();
    for _ in 0..count {
        found.push(x);
        if x.abs() <= 1.0 {
            break;
        }
        x = -x.signum() * (kappa * (x.abs() - 1.0) - 1.0);
    }
    found
}

/// Normal numbers of a fixed seed.
struct Noise(Random);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0.next() + 1e-300
    }
    fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

#[test]
fn exact_turning_points_give_their_parameters_back() {
    for (zeta, friction, first) in
        [(0.0, 0.3, 40.0), (0.02, 0.5, 30.0), (0.2, 0.01, 4000.0), (0.05, 2.0, 40.0)]
    {
        let all: Vec<f64> = turns(first, zeta, 9).into_iter().map(|x| friction * x).collect();
        // The recursion is that of the exact motion.
        let decay = FreeDecay::new(first, 0.0, zeta, 1.0).unwrap();
        assert!(decay.half_cycles >= 8);
        let one_side: Vec<f64> = all.iter().copied().step_by(2).collect();
        let of = |turns: &[f64], kind| identify_turning_points(turns, None, kind).unwrap();
        for found in [of(&all, TurningPoints::EveryHalfCycle), of(&one_side, TurningPoints::EveryCycle)] {
            assert!(
                (found.friction_displacement.value - friction).abs() < 1e-6 * friction * first,
                "{found:?}"
            );
            assert!((found.damping_ratio.value - zeta).abs() < 1e-7, "{zeta}: {found:?}");
        }
    }
}

/// A decay sampled from the closed form of each half cycle, with noise of a part of the first amplitude.
fn sampled(friction: f64, zeta: f64, noise: f64, random: &mut Noise) -> DecayIdentified {
    let (natural, rest) = (9.0, 0.7);
    let turns: Vec<f64> = turns(40.0, zeta, 12).into_iter().map(|x| friction * x).collect();
    let d = (1.0 - zeta * zeta).sqrt();
    let half = std::f64::consts::PI / (natural * d);
    let (mut times, mut values) = (Vec::new(), Vec::new());
    for i in 0..900 {
        let t = f64::from(i) * half * 10.9 / 900.0;
        let n = (t / half) as usize;
        let last = turns.len() - 1;
        // The body rests at the last one.
        let (x, angle) =
            (turns[n.min(last)], if n < last { natural * d * (t - half * n as f64) } else { 0.0 });
        let middle = x.signum() * friction;
        let wave = (-zeta / d * angle).exp() * (angle.cos() + zeta / d * angle.sin());
        times.push(t);
        values.push(rest + middle + (x - middle) * wave + noise * 40.0 * friction * random.normal());
    }
    identify_decay(&times, &values).unwrap()
}

#[test]
fn a_sampled_decay_gives_its_parameters_back() {
    for zeta in [0.0, 0.01, 0.06] {
        let found = sampled(0.4, zeta, 0.0, &mut Noise(Random(1)));
        assert!((found.friction_displacement.value - 0.4).abs() < 1e-5, "{zeta}: {found:?}");
        assert!((found.damping_ratio.value - zeta).abs() < 1e-6, "{zeta}");
        assert!((found.natural_frequency.unwrap().value - 9.0).abs() < 1e-5, "{zeta}");
    }
}

/// With one per cent of noise the intervals contain the truth in 95 of 100 measurements: of 2,000 decays by their
/// turning points, and of 60 by their samples.
#[test]
fn the_intervals_contain_the_truth() {
    let mut random = Noise(Random(3));
    let (mut inside, mut tried) = ([0u32; 2], 0);
    for i in 0..2000 {
        let zeta = [0.0, 0.005, 0.02, 0.05][i % 4];
        let count = [6, 8, 10][i % 3];
        let noisy: Vec<f64> =
            turns(60.0, zeta, count).into_iter().map(|x| 0.5 * (x + 0.01 * 60.0 * random.normal())).collect();
        let found = identify_turning_points(&noisy, None, TurningPoints::EveryHalfCycle).unwrap();
        for (inside, (estimate, truth)) in
            inside.iter_mut().zip([(found.friction_displacement, 0.5), (found.damping_ratio, zeta)])
        {
            let (low, high) = estimate.interval();
            *inside += u32::from(low <= truth && truth <= high);
        }
        tried += 1;
    }
    for inside in inside {
        let share = f64::from(inside) / f64::from(tried);
        assert!((0.94..=0.97).contains(&share), "{share}");
    }
    let mut inside = [0u32; 3];
    for i in 0..60 {
        let zeta = [0.0, 0.01, 0.03][i % 3];
        let found = sampled(0.4, zeta, 0.01, &mut random);
        let truth = [
            (found.friction_displacement, 0.4),
            (found.damping_ratio, zeta),
            (found.natural_frequency.unwrap(), 9.0),
        ];
        for (inside, (estimate, truth)) in inside.iter_mut().zip(truth) {
            let (low, high) = estimate.interval();
            *inside += u32::from(low <= truth && truth <= high);
        }
    }
    // Of 60, at least 53 with a probability of 99 %.
    assert!(inside.iter().all(|&inside| inside >= 53), "{inside:?}");
}

#[test]
fn what_is_no_decay_is_refused() {
    let of = |turns: &[f64]| identify_turning_points(turns, None, TurningPoints::EveryCycle);
    assert!(matches!(of(&[3.0, 2.0, 1.0]), Err(Error::DecayTooShort { count: 3, least: 4 })));
    for wrong in [f64::NAN, f64::INFINITY, 0.0] {
        assert!(matches!(of(&[4.0, 3.0, wrong, 1.0]), Err(Error::InMeasurement { index: 2, .. })));
    }
    // Their squares would be no numbers.
    for size in [1e300, 1e-300] {
        let wrong = of(&[10.0, 8.0, 6.0, 5.0].map(|x| x * size / 10.0));
        let Err(Error::InMeasurement { index: 0, error }) = wrong else { panic!("{size}: {wrong:?}") };
        assert!(matches!(*error, Error::OutOfRange { .. }), "{error}");
    }
    let large: Vec<f64> = (0..50).map(|i| 1e300 * f64::from(i).cos()).collect();
    let times: Vec<f64> = (0..50).map(f64::from).collect();
    assert!(matches!(identify_decay(&times, &large), Err(Error::InMeasurement { index: 0, .. })));
    assert!(matches!(of(&[1.0, 3.0, 9.0, 27.0]), Err(Error::InMeasurement { index: 1, .. })));
    let times = identify_turning_points(
        &[4.0, 3.0, 2.0, 1.0],
        Some(&[0.0, 1.0, 1.0, 2.0]),
        TurningPoints::EveryCycle,
    );
    assert!(matches!(times, Err(Error::InMeasurement { index: 2, .. })));
    let flat: Vec<f64> = (0..50).map(f64::from).collect();
    assert!(matches!(identify_decay(&flat, &[0.5; 50]), Err(Error::DecayTooShort { .. })));
    assert!(matches!(identify_decay(&flat, &[0.5; 49]), Err(Error::LengthMismatch { .. })));
    assert!(identify_decay(&[0.0, 0.0], &[1.0, 2.0]).is_err());
}
