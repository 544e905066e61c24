//! Friction and damping from noisy response curves: the frequency with which the stated interval contains the
//! true values.

use crate::random::Random;
use std::f64::consts::TAU;
use stickslip::design::{Measurement, identify};
use stickslip::{Cycle, Drive, Oscillator};

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
        let found = identify(&body(1.0, 0.0), 12.0, &curve).unwrap();
        let within = |(low, high): (f64, f64), x: f64| u32::from(low <= x && x <= high);
        friction_within += within(found.friction_bound.interval(), friction);
        damping_within += within(found.damping_ratio.interval(), zeta);
    }
    (f64::from(friction_within) / f64::from(trials), f64::from(damping_within) / f64::from(trials))
}

#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let (friction, damping) = coverage(2_000, 1);
    assert!((friction - 0.95).abs() <= 0.02 && (damping - 0.95).abs() <= 0.02, "{friction} {damping}");
}
