//! How often the intervals of 95 % of `identify --motion` contain the truth, over motions of the samples with noise.
//!
//! `.ci/slow intervals` runs it for 300 motions of each kind; `SETS` are others, from `FIRST` on.

#![allow(clippy::print_stdout, reason = "the rates of a campaign")]

use crate::random::Random;
use crate::sampled::{Harmonic, Load, Machine, positions};
use std::f64::consts::{PI, TAU};
use stickslip::Excitation;
use stickslip::design::identify_motion;
use stickslip::motion::record::Record;
use stickslip::uncertainty::Estimate;

/// What moves the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Moved {
    /// A harmonic load: of a force, of the surface, of the support.
    Harmonic,
    /// A sum of three harmonics that have no common period.
    Measured,
    /// The start.
    Free,
}

/// A motion, its load as it was sampled, and the truth.
struct Set {
    mass: f64,
    stiffness: f64,
    friction: f64,
    zeta: f64,
    record: Record<f64>,
    exact: Vec<f64>,
    /// The standard deviation of the noise, in the greatest displacement.
    noise: f64,
}

/// A standard normal number, by Box and Muller's method.
fn normal(random: &mut Random) -> f64 {
    (-2.0 * (1.0 - random.next()).ln()).sqrt() * (TAU * random.next()).cos()
}

impl Set {
    fn drawn(random: &mut Random, moved: Moved) -> Self {
        let (mass, natural) = (random.scale(0.5, 50.0), random.scale(3.0, 30.0));
        let stiffness = mass * natural * natural;
        let (zeta, friction) = (random.scale(0.01, 0.1), random.scale(1.0, 40.0));
        let machine = Machine::new([mass, stiffness, 2.0 * zeta * mass * natural], [friction, 0.0, 1.0], 0.0);
        let (load, excitation, unit) = match (random.next() * 3.0) as u32 {
            0 => (Load::Force, Excitation::Force, 1.0),
            1 => (Load::Surface, Excitation::SurfaceAcceleration, mass),
            _ => (Load::Foot, Excitation::FootMotion, stiffness),
        };
        let ratio = match ((random.next() * 2.0) as u32, moved) {
            (_, Moved::Free) => 1.0,
            (0, _) => random.between(0.5, 0.9),
            _ => random.between(1.1, 1.8),
        };
        let frequency = ratio * natural;
        let amplitude = random.between(1.6, 3.0) * friction / unit;
        let samples_per_cycle = random.scale(20.0, 2000.0);
        let mut cycles = random.between(5.0, 9.0);
        let mut start = [0.0, 0.0];
        if moved == Moved::Free {
            // Each half cycle takes 2r/k and its part of damping.
            let first = random.between(6.0, 24.0);
            start[0] = first * friction / stiffness;
            let decrement = (-PI * zeta).exp();
            let (mut halves, mut height) = (0.0, first);
            while height > 1.0 {
                (halves, height) = (halves + 1.0, decrement * height - 1.0 - decrement);
            }
            cycles = halves / 2.0 * random.between(0.7, 1.4);
        }
        let step = TAU / frequency / samples_per_cycle;
        let count = (cycles * samples_per_cycle) as usize + 1;
        let times: Vec<f64> = (0..count.max(20)).map(|i| i as f64 * step).collect();
        let parts = [
            (1.0, 0.0),
            (random.between(0.45, 0.7), TAU * random.next()),
            (random.between(0.8, 0.95), TAU * random.next()),
        ];
        let wave = |t: f64| match moved {
            Moved::Free => 0.0,
            Moved::Harmonic => amplitude * (frequency * t).sin(),
            Moved::Measured => {
                let sines = parts.iter().map(|(rate, phase)| (rate * frequency * t + phase).sin());
                0.6 * amplitude * sines.sum::<f64>()
            }
        };
        let samples: Vec<f64> = times.iter().map(|t| wave(*t)).collect();
        let exact = if moved == Moved::Measured {
            // Straight lines that are off by 1e-7 of the load.
            let fine = (4000.0 / samples_per_cycle).ceil() as usize;
            let dense: Vec<f64> =
                (0..=(times.len() - 1) * fine).map(|i| i as f64 * step / fine as f64).collect();
            let loads: Vec<f64> = dense.iter().map(|t| wave(*t)).collect();
            positions(machine, load, [&dense, &loads], start, 128.0).into_iter().step_by(fine).collect()
        } else {
            let size = if moved == Moved::Free { 0.0 } else { amplitude };
            let mut follower = Harmonic { machine, load, amplitude: size, frequency }.follower(start, 0.0);
            let parts = (step * 128.0 / machine.period().min(TAU / frequency)).ceil();
            follower.set_step(step / parts);
            let mut places = vec![start[0]];
            while places.len() < times.len() {
                (0..parts as u32).for_each(|_| follower.advance(&mut None));
                places.push(follower.state[0]);
            }
            places
        };
        let record = Record::at_times(excitation, times, samples).unwrap();
        Self { mass, stiffness, friction, zeta, record, exact, noise: random.scale(1e-3, 5e-2) }
    }
}

impl Set {
    /// A set of this kind by its number, and its displacements with noise.
    fn numbered(moved: Moved, number: u64) -> (Self, Vec<f64>, f64) {
        let mut random = Random(1 + 10_000 * moved as u64 + number);
        let set = Self::drawn(&mut random, moved);
        let most = set.exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let noise = set.noise * most;
        let measured = set.exact.iter().map(|x| x + noise * normal(&mut random)).collect();
        (set, measured, noise)
    }
}

/// Of so many sets, how many have the truth in the interval: friction, damping ratio, and those refused.
#[derive(Debug, Default)]
struct Rates {
    sets: u32,
    friction: u32,
    zeta: u32,
    refused: u32,
}

fn rates(moved: Moved) -> Rates {
    let number = |name: &str, few: u64| std::env::var(name).map_or(few, |text| text.parse().unwrap());
    let (first, sets) = (number("FIRST", 0), number("SETS", 300));
    let mut rates = Rates::default();
    for i in first..first + sets {
        let (set, measured, noise) = Set::numbered(moved, i);
        let Ok(found) = identify_motion(set.mass, Some(set.stiffness), &set.record, &measured) else {
            rates.refused += 1;
            println!("{moved:?} {i}: refused, {} samples, noise {:.4}", measured.len(), set.noise);
            continue;
        };
        let is_in = |estimate: Estimate, truth: f64| {
            let (low, high) = estimate.interval();
            if !(low..=high).contains(&truth) {
                let off = (estimate.value - truth) / estimate.standard_error;
                println!(
                    "{moved:?} {i}: {truth} not in {low} to {high}, {off:.2} errors, {} samples, noise {:.4}, \
                     found {:.4}, {:?}",
                    measured.len(),
                    set.noise,
                    found.noise * set.noise / noise,
                    set.record.excitation()
                );
            }
            u32::from((low..=high).contains(&truth))
        };
        rates.sets += 1;
        rates.friction += is_in(found.friction, set.friction);
        rates.zeta += is_in(found.damping_ratio, set.zeta);
    }
    println!("{moved:?}: {rates:?}");
    rates
}

/// Of 300 intervals of 95 %, fewer than 93 or more than 97 in a hundred have a probability of 8 % each; outside 91 and 98.5 in a hundred
/// one of 2e-3.
fn hold(moved: Moved) {
    let Rates { sets, friction, zeta, refused } = rates(moved);
    for inside in [friction, zeta] {
        let rate = f64::from(inside) / f64::from(sets);
        assert!((0.91..=0.985).contains(&rate), "{moved:?}: {inside} of {sets}");
    }
    assert!(refused * 20 < sets, "{moved:?}: {refused} refused");
}

/// Free motions of which a descent alone ends with half a cycle too many or too few: what is left is the noise.
#[test]
fn another_number_of_half_cycles_is_found() {
    for number in [6, 11, 26, 31, 36, 113, 236] {
        let (set, measured, noise) = Set::numbered(Moved::Free, number);
        let found = identify_motion(set.mass, Some(set.stiffness), &set.record, &measured).unwrap();
        // The standard error of a standard deviation, four times.
        let room = 4.0 / (2.0 * measured.len() as f64).sqrt();
        assert!((found.noise / noise - 1.0).abs() < room, "{number}: {} for {noise}", found.noise);
        let off = (found.friction.value - set.friction).abs() / found.friction.standard_error;
        assert!(off < 4.0, "{number}: {:?} for {}", found.friction, set.friction);
    }
}

#[test]
#[ignore = "a campaign: .ci/slow intervals"]
fn intervals_under_a_harmonic_load() {
    hold(Moved::Harmonic);
}

#[test]
#[ignore = "a campaign: .ci/slow intervals"]
fn intervals_under_a_measured_load() {
    hold(Moved::Measured);
}

#[test]
#[ignore = "a campaign: .ci/slow intervals"]
fn intervals_of_a_free_motion() {
    hold(Moved::Free);
}
