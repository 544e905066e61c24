//! One batch over many points and nothing else, to be run under an instruction counter: `batch_instructions
//! KERNEL N` runs KERNEL over 128,000 points N times. The counter's emulated processor selects the
//! instructions: AVX2 under valgrind.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod columns;
mod points;

use columns::{ALL, FIVE, Room, THREE};
use stickslip::Ratios;
use stickslip::batch::Batch;

const POINTS: usize = 128_000;

fn main() {
    let mut args = std::env::args().skip(1).filter(|a| a != "--bench");
    let (Some(kernel), Some(n)) = (args.next(), args.next().and_then(|n| n.parse().ok())) else {
        println!("batch_instructions KERNEL N");
        return;
    };
    let is_low = kernel.ends_with("-damped-low");
    let least = if kernel.ends_with("-low") { 0.35 } else { 0.5 };
    let mut all = points::points_from(POINTS, least);
    // With a damper those below Ω = 1/2 alone, 7 % of all, again and again.
    all.retain(|&(omega, _)| !is_low || omega < 0.5);
    let (omega, alpha): (Vec<_>, Vec<_>) = all.iter().copied().cycle().take(POINTS).unzip();
    let (mut room, batch) = (Room::new(POINTS), Batch::new);
    let row = [1.5; POINTS];
    let damped = |(&omega, &alpha)| Ratios::new(omega, alpha).and_then(|at| at.with_damping_ratio(0.02)).ok();
    let damped: Vec<_> = omega.iter().zip(&alpha).filter_map(damped).collect();
    for _ in 0..n {
        match kernel.as_str() {
            "batch-triple" | "batch-triple-low" => room.run(batch, &omega, &alpha, THREE),
            "batch-peaks" | "batch-peaks-low" => room.run(batch, &omega, &alpha, FIVE),
            "batch-peaks-fixed" => room.run(batch, &row, &alpha, FIVE),
            "batch-cycles" | "batch-cycles-low" => room.run(batch, &omega, &alpha, ALL),
            "batch-triple-damped" | "batch-triple-damped-low" => room.run_each(batch, &damped, THREE),
            "batch-peaks-damped" | "batch-peaks-damped-low" => room.run_each(batch, &damped, FIVE),
            "batch-triple-fixed" => room.run(batch, &row, &alpha, THREE),
            "batch-cycles-fixed" => room.run(batch, &row, &alpha, ALL),
            other => {
                eprintln!("no kernel {other}");
                std::process::exit(2);
            }
        }
    }
    println!("{:?}", batch().level());
}
