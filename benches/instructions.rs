//! One kernel over many points and nothing else, to be run under an instruction counter.
//!
//! `instructions KERNEL N` evaluates KERNEL at N points. `benches/instructions.sh` takes the difference
//! between two values of N, which removes the start-up.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod kernels;
mod points;

use std::hint::black_box;

fn run<const N: usize>(kernel: impl Fn(f64, f64) -> [f64; N], points: &[(f64, f64)], n: usize) -> f64 {
    let mut sum = 0.0;
    for &(omega, alpha) in points.iter().cycle().take(n) {
        sum += black_box(kernel(black_box(omega), black_box(alpha)))[0];
    }
    sum
}

fn main() {
    let points = points::points(2000);
    let low: Vec<_> = points::points_from(10_000, 0.35).into_iter().filter(|p| p.0 < 0.5).collect();
    let mut args = std::env::args().skip(1).filter(|a| a != "--bench");
    let (Some(kernel), Some(n)) = (args.next(), args.next().and_then(|n| n.parse().ok())) else {
        println!("instructions KERNEL N");
        return;
    };
    let sum = match kernel.as_str() {
        "triple" => run(kernels::triple, &points, n),
        "cycle" => run(kernels::cycle, &points, n),
        "five" => run(kernels::five, &points, n),
        "cycle-low" => run(kernels::cycle, &low, n),
        "response" => run(kernels::response, &points, n),
        "cycle-static-friction" => run(kernels::cycle_with_static_friction, &points, n),
        "response-static-friction" => run(kernels::response_with_static_friction, &points, n),
        "damped" => run(kernels::damped, &points, n),
        "damped-low" => run(kernels::damped, &low, n),
        "amplitude-damped-low" => run(kernels::amplitude_damped, &low, n),
        other => {
            eprintln!("no kernel {other}");
            std::process::exit(2);
        }
    };
    println!("{sum:e}");
}
