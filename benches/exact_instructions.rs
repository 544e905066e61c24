//! One kernel of the exact motion over many points and nothing else, to be run under an instruction counter:
//! `exact_instructions KERNEL N`. It is separate from the program of the closed forms, so that neither
//! changes the inlining in the other.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod motions;
mod points;

use std::hint::black_box;
use stickslip::motion::{LongRun, State};
use stickslip::{Cycle, Ratios};

/// A motion with stops, whose (Ω, α, ζ) are the numbers in the kernel's name.
fn with_stops(kernel: &str) -> Option<(f64, f64, f64)> {
    let mut numbers = kernel.strip_prefix("steady-with-stops-")?.split('-').map(|n| n.parse().ok());
    Some((numbers.next()??, numbers.next()??, numbers.next()??))
}

/// Every 97th cell, in order, of a map of 1,000 × 500 steady states with Ω from 0.1 to 2 and α from 1.05 to
/// 10.
fn map(n: usize) -> (Vec<f64>, Vec<f64>) {
    let cell = |i: usize| ((97 * i) / 500 % 1000, 97 * i % 500);
    let at = |i: usize| {
        let (column, row) = cell(i);
        (0.1 + 1.9 * column as f64 / 999.0, 1.05 + 8.95 * row as f64 / 499.0)
    };
    (0..n).map(at).unzip()
}

/// The sum of their maximum displacements.
#[inline(never)]
fn steady_map(omega: &[f64], alpha: &[f64]) -> f64 {
    let motion = |(&omega, &alpha)| {
        let limit = LongRun::from_start(Ratios::new(omega, alpha).ok()?, State::default()).ok()?;
        Some(limit.steady_state()?.max_displacement.value)
    };
    omega.iter().zip(alpha).filter_map(motion).sum()
}

fn main() {
    let points = points::points(2000);
    let mut args = std::env::args().skip(1).filter(|a| a != "--bench");
    let (Some(kernel), Some(n)) = (args.next(), args.next().and_then(|n| n.parse().ok())) else {
        println!("exact_instructions KERNEL N");
        return;
    };
    let over = |f: fn(f64, f64) -> f64| -> f64 {
        points
            .iter()
            .cycle()
            .take(n)
            .map(|&(omega, alpha)| black_box(f(black_box(omega), black_box(alpha))))
            .sum()
    };
    let sum = match kernel.as_str() {
        "steady-from-rest" => over(|omega, alpha| motions::steady_from_rest(omega, alpha)[0]),
        "steady-beside-resonance" => over(|_, alpha| motions::steady_from_rest(1.02, alpha + 1.0)[0]),
        "steady-from-cycle" => {
            let cycle = |&(omega, alpha): &(f64, f64)| Ratios::new(omega, alpha).and_then(Cycle::new).ok();
            let cycles: Vec<_> = points.iter().filter_map(cycle).collect();
            cycles
                .iter()
                .cycle()
                .take(n)
                .map(|c| black_box(motions::steady_from_cycle(black_box(c)))[0])
                .sum()
        }
        "twenty-slides" => over(|omega, alpha| motions::twenty_slides(omega, alpha)[0]),
        "steady-map" => {
            let (omega, alpha) = map(n);
            black_box(steady_map(&omega, &alpha))
        }
        other if let Some((omega, alpha, zeta)) = with_stops(other) => (0..n)
            .map(|_| {
                let [omega, alpha, zeta] = [omega, alpha, zeta].map(black_box);
                black_box(motions::steady_with_damping(omega, alpha, zeta))[0]
            })
            .sum(),
        other => {
            eprintln!("no kernel {other}");
            std::process::exit(2);
        }
    };
    println!("{sum:e}");
}
