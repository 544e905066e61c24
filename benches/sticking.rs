//! The library's side of `benches/sticking.sh`: `sticking OMEGA ALPHA ZETA REFERENCE RUNS` prints the least
//! time of the steady state from rest in microseconds and the relative error of its maximum displacement.
#![allow(clippy::print_stdout, reason = "a program of its own: what it prints is its answer")]

use std::hint::black_box;
use std::time::Instant;
use stickslip::motion::{LongRun, State};
use stickslip::{Error, Ratios};

fn greatest(omega: f64, alpha: f64, zeta: f64) -> Result<Option<f64>, Error> {
    let ratios = Ratios::new(omega, alpha)?.with_damping_ratio(zeta)?;
    Ok(LongRun::from_start(ratios, State::default())?
        .steady_state()
        .map(|steady| steady.max_displacement.value))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let [omega, alpha, zeta, reference, runs] = &arguments[..] else {
        println!("sticking OMEGA ALPHA ZETA REFERENCE RUNS");
        return Ok(());
    };
    let [omega, alpha, zeta, reference]: [f64; 4] =
        [omega.parse()?, alpha.parse()?, zeta.parse()?, reference.parse()?];
    let (mut best, mut found) = (f64::INFINITY, f64::NAN);
    for _ in 0..runs.parse()? {
        let begin = Instant::now();
        found = greatest(black_box(omega), black_box(alpha), black_box(zeta))?.ok_or("no periodic motion")?;
        best = best.min(begin.elapsed().as_secs_f64());
    }
    println!("{:.2}\t{:.1e}", best * 1e6, (found / reference - 1.0).abs());
    Ok(())
}
