//! One number that the bits of many answers at f64 come to: the same for every target the program is compiled for.
//!
//! `bits [POINTS]` prints it for points alone, and for batches of all levels the processor has, which from Ω = 1/2 on have to be the
//! same. Points are uniform, beside 1 and 1/n, and on the border (`tests/ulps/points.rs`).

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

use std::hash::{DefaultHasher, Hash, Hasher};
use stickslip::batch::{Batch, Level, Peaks};
use stickslip::{Border, Ratios, Response};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Ω uniform, beside 1 and beside 1/n; α on the border, just above it, up to four times it, and below.
fn points(count: usize) -> Vec<(f64, f64)> {
    let mut random = Random(14);
    let point = |i: usize| {
        let beside = (0.5 - random.uniform()) / (1u64 << (i % 50)) as f64;
        let omega = match i % 4 {
            0 => 0.5 + 3.0 * random.uniform(),
            1 => 1.0 + beside,
            2 => (1.0 + beside) / (1.0 + (i % 7) as f64),
            _ => 0.05 + 0.95 * random.uniform(),
        };
        let border = Border::new(omega).map_or(1.0, |border| border.min_force_ratio());
        let alpha = match i % 5 {
            0 => border,
            1 => border.next_up(),
            2 => border * (1.0 + beside.abs()),
            3 => border * (0.8 + 0.2 * random.uniform()),
            _ => border * (1.0 + 3.0 * random.uniform()),
        };
        (omega, alpha)
    };
    (0..count).map(point).collect()
}

/// {Δ₀, α_min, A₁, V₀, ω_d t₁}, NaN what does not exist.
fn five(response: &Response<f64>) -> [f64; 5] {
    let border = response.border().min_force_ratio();
    response.cycle().map_or([f64::NAN, border, f64::NAN, f64::NAN, f64::NAN], |cycle| {
        let (size, velocity) = (cycle.loop_size_stiffness(), cycle.max_velocity());
        [cycle.max_displacement(), border, size, velocity, cycle.velocity_phase()]
    })
}

fn main() {
    let count = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(100_000);
    let points = points(count);
    let mut hasher = DefaultHasher::new();
    let mut alone = Vec::new();
    for &(omega, alpha) in &points {
        let Ok(response) = Ratios::new(omega, alpha).map(Response::new) else { continue };
        let bits = five(&response).map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() });
        bits.hash(&mut hasher);
        if let Some(cycle) = response.cycle() {
            let rest = [cycle.displacement_phase(), cycle.deviation(), cycle.contraction()];
            (rest.map(f64::to_bits), cycle.loop_size_inertia().to_bits()).hash(&mut hasher);
        }
        alone.push((omega, alpha, bits));
    }
    println!("{} points alone: {:016x}", alone.len(), hasher.finish());
    alone.retain(|&(omega, ..)| omega >= 0.5);
    let (omega, alpha): (Vec<_>, Vec<_>) = alone.iter().map(|&(omega, alpha, _)| (omega, alpha)).unzip();
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        for length in [omega.len(), 129] {
            let mut columns: [Vec<f64>; 5] = std::array::from_fn(|_| vec![0.0; omega.len()]);
            for (chunk, (omega, alpha)) in omega.chunks(length).zip(alpha.chunks(length)).enumerate() {
                let part = chunk * length..chunk * length + omega.len();
                let [a, b, c, d, e] = columns.each_mut().map(|column| &mut column[part.clone()]);
                let out = Peaks {
                    max_displacement: a,
                    min_force_ratio: b,
                    loop_size_stiffness: c,
                    max_velocity: d,
                    velocity_phase: e,
                };
                if let Err(error) = Batch::new().at_level(level).peaks(omega, alpha, out) {
                    eprintln!("{error}");
                }
            }
            let differ = alone.iter().enumerate().filter(|&(i, (.., bits))| {
                let bits = bits.iter().zip(&columns).filter(|&(&bits, column)| {
                    let x = column[i];
                    bits != if x.is_nan() { u64::MAX } else { x.to_bits() }
                });
                bits.count() > 0
            });
            let differ = differ.count();
            println!("{level:?}, slices of {length}: {differ} of {} differ", omega.len());
            if differ > 0 {
                std::process::exit(1);
            }
        }
    }
}
