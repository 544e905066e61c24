//! One kernel of the exact motion over many points and nothing else, to be run under an instruction counter:
//! `exact_instructions KERNEL N`. Apart from the closed forms' own program, so that neither changes what is inlined in the other.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod motions;
mod points;

use std::hint::black_box;
use stickslip::{Cycle, Ratios};

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
        other => {
            eprintln!("no kernel {other}");
            std::process::exit(2);
        }
    };
    println!("{sum:e}");
}
