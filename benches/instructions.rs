//! One kernel over many points and nothing else, to be run under an instruction counter.
//!
//! `instructions KERNEL N` evaluates KERNEL at N points; `benches/instructions.sh` takes the difference of two N, so
//! that start-up does not count. Without arguments it checks that the generic and the plain kernels agree to the
//! last bit.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod kernels;
mod plain;
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
    let mut args = std::env::args().skip(1).filter(|a| a != "--bench");
    let (Some(kernel), Some(n)) = (args.next(), args.next().and_then(|n| n.parse().ok())) else {
        for &(omega, alpha) in &points {
            let bits = |v: &[f64]| v.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&kernels::triple(omega, alpha)), bits(&plain::triple(omega, alpha)));
            assert_eq!(bits(&kernels::cycle(omega, alpha)), bits(&plain::cycle(omega, alpha)));
        }
        println!("generic and plain kernels agree to the last bit at {} points", points.len());
        return;
    };
    let sum = match kernel.as_str() {
        "triple-generic" => run(kernels::triple, &points, n),
        "triple-plain" => run(plain::triple, &points, n),
        "cycle-generic" => run(kernels::cycle, &points, n),
        "cycle-plain" => run(plain::cycle, &points, n),
        other => {
            eprintln!("no kernel {other}");
            std::process::exit(2);
        }
    };
    println!("{sum:e}");
}
