//! The library's side of `benches/sticking.sh`: `sticking OMEGA ALPHA ZETA RUNS` prints the greatest displacement of the steady state from rest
//! at 256 bits, then the least time at f64 in microseconds and the relative error.
#![allow(clippy::print_stdout, reason = "a program of its own: what it prints is its answer")]

use std::hint::black_box;
use std::time::Instant;
use stickslip::exact::{LongRun, State};
use stickslip::{Error, Float, Mp, Ratios};

fn greatest<F: Float>(omega: F, alpha: F, zeta: F) -> Result<Option<F>, Error> {
    let ratios = Ratios::new(omega, alpha)?.with_damping_ratio(zeta)?;
    Ok(LongRun::from_start(ratios, State::rest())?.steady_state().map(|steady| steady.max_displacement()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let [omega, alpha, zeta, runs] = &arguments[..] else {
        println!("sticking OMEGA ALPHA ZETA RUNS");
        return Ok(());
    };
    let [omega, alpha, zeta] = [omega.parse::<f64>()?, alpha.parse()?, zeta.parse()?];
    let [a, b, c] = [omega, alpha, zeta].map(Mp::<4>::from);
    let exact = greatest(a, b, c)?.ok_or("no periodic motion")?;
    let (mut best, mut found) = (f64::INFINITY, f64::NAN);
    for _ in 0..runs.parse()? {
        let begin = Instant::now();
        found = greatest(black_box(omega), black_box(alpha), black_box(zeta))?.ok_or("no periodic motion")?;
        best = best.min(begin.elapsed().as_secs_f64());
    }
    let error = ((Mp::<4>::from(found) - exact) / exact).to_f64().abs();
    println!("{:.17}\t{:.2}\t{error:.1e}", exact.to_f64(), best * 1e6);
    Ok(())
}
