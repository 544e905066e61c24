//! The time of a step of a record: one body after another, and bodies side by side on one core.
//!
//! 512 bodies of periods from 0.1 s to 4.2 s with 5 % damping follow 4,000 steps of 0.01 s, of white noise and of noise
//! filtered twice. Friction is a multiple of the record's mean square root. Prints the best of five runs.

#![allow(missing_docs, clippy::print_stdout, reason = "a program that prints a table")]

#[path = "../tests/random/generator.rs"]
mod generator;

use generator::Random;
use std::hint::black_box;
use std::time::Instant;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record, follow_each};

const STEPS: usize = 4000;
const BODIES: usize = 512;

fn best(mut run: impl FnMut()) -> f64 {
    let time = |run: &mut dyn FnMut()| {
        let begin = Instant::now();
        run();
        begin.elapsed().as_secs_f64()
    };
    (0..5).map(|_| time(&mut run)).fold(f64::INFINITY, f64::min) * 1e9 / (STEPS * BODIES) as f64
}

fn main() {
    let mut random = Random(3);
    let white: Vec<f64> = (0..=STEPS).map(|_| random.between(-0.5, 0.5)).collect();
    let mut filters = (0.0, 0.0);
    let smooth = white.iter().map(|sample| {
        filters.0 += 0.15 * (sample - filters.0);
        filters.1 += 0.15 * (filters.0 - filters.1);
        filters.1
    });
    let smooth: Vec<f64> = smooth.collect();
    println!("record  friction/rms  stops in 1,000 steps  ns a step alone  side by side");
    for (name, samples) in [("white", white), ("smooth", smooth)] {
        let mean_square = samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64;
        let record = Record::new(Excitation::SurfaceAcceleration, 0.01, samples).unwrap();
        for part in [0.0, 0.2, 0.5, 1.0] {
            let body = |k: usize| {
                let omega = std::f64::consts::TAU / (0.1 + 0.008 * k as f64);
                Body::new(1.0, part * mean_square.sqrt())
                    .and_then(|body| body.with_stiffness(omega * omega))
                    .and_then(|body| body.with_damping(0.1 * omega))
                    .unwrap()
            };
            let bodies: Vec<_> = (0..BODIES).map(body).collect();
            let stops: u64 =
                follow_each(&bodies, &record).into_iter().map(|answer| answer.unwrap().stops).sum();
            let alone = best(|| {
                for body in &bodies {
                    let _ = black_box(body.follow(&record));
                }
            });
            let together = best(|| drop(black_box(follow_each(&bodies, &record))));
            let stops = stops as f64 * 1000.0 / (STEPS * BODIES) as f64;
            println!("{name:<8}{part:<14}{stops:<22.1}{alone:<17.1}{together:.1}");
        }
    }
}
