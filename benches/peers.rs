//! The library's side of `benches/peers.sh`. `peers points FILE N LEAST` writes N points with Ω uniform from
//! LEAST to 2.5. `peers FILE` prints their time in nanoseconds per point, the best of many runs. `peers
//! threads N` times N points on one thread and on all threads.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

mod columns;
mod kernels;
mod points;

use columns::{ALL, FIVE, Room, THREE};
use std::time::Instant;
use stickslip::batch::{Batch, Level};
use stickslip::{Output, Ratios, Response};

const AMPLITUDE: [Output; 3] = [Output::MaxDisplacement, Output::MinForceRatio, Output::LoopSizeStiffness];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["points", file, n, least] => {
            let points = points::points_from(n.parse()?, least.parse()?);
            let columns = points.iter().map(|p| p.0).chain(points.iter().map(|p| p.1));
            Ok(std::fs::write(file, columns.flat_map(f64::to_le_bytes).collect::<Vec<_>>())?)
        }
        #[cfg(feature = "rayon")]
        ["threads", n] => {
            let (omega, alpha): (Vec<_>, Vec<_>) = points::points(n.parse()?).into_iter().unzip();
            threads(&omega, &alpha);
            Ok(())
        }
        [file] => {
            let bytes = std::fs::read(file)?;
            let numbers: Vec<_> =
                bytes.as_chunks::<8>().0.iter().map(|chunk| f64::from_le_bytes(*chunk)).collect();
            let (omega, alpha) = numbers.split_at(numbers.len() / 2);
            time(omega, alpha);
            Ok(())
        }
        _ => {
            println!("peers points FILE N LEAST | peers FILE | peers threads N");
            Ok(())
        }
    }
}

fn time(omega: &[f64], alpha: &[f64]) {
    let mut room = Room::new(omega.len());
    let report = |name: &str, kernel: &str, run: &mut dyn FnMut()| {
        let best = (0..60).fold(f64::INFINITY, |best: f64, _| {
            let start = Instant::now();
            run();
            best.min(start.elapsed().as_secs_f64())
        });
        println!("{name}\t{kernel}\t{:.2}", best / omega.len() as f64 * 1e9);
    };
    // Point by point, with the functions for a single point.
    let mut sum = 0.0;
    let points = || omega.iter().zip(alpha);
    report("stickslip, a point alone", "triple", &mut || {
        sum += points().map(|(&omega, &alpha)| kernels::triple(omega, alpha)[0]).sum::<f64>();
    });
    report("stickslip, a point alone", "all of a cycle", &mut || {
        sum += points().map(|(&omega, &alpha)| kernels::cycle(omega, alpha)[0]).sum::<f64>();
    });
    report("stickslip, a point alone", "five", &mut || {
        sum += points().map(|(&omega, &alpha)| kernels::five(omega, alpha)[0]).sum::<f64>();
    });
    let damped = |(&omega, &alpha)| Ratios::new(omega, alpha).and_then(|at| at.with_damping_ratio(0.02)).ok();
    let damped: Vec<_> = points().filter_map(damped).collect();
    report("stickslip, a point alone", "damped", &mut || {
        sum += damped.iter().map(|&ratios| Output::values(AMPLITUDE, ratios)[0]).sum::<f64>();
    });
    report("stickslip, a point alone", "damped, all of a cycle", &mut || {
        sum += damped.iter().filter_map(|&ratios| Response::new(ratios).loop_size_stiffness).sum::<f64>();
    });
    std::hint::black_box(sum);
    for level in Level::ALL.into_iter().filter(|level| level.is_available() && *level != Level::Portable) {
        let batch = || Batch::new().at_level(level);
        let name = format!("stickslip {level:?}");
        report(&name, "triple", &mut || room.run(batch, omega, alpha, THREE));
        report(&name, "damped", &mut || room.run_each(batch, &damped, THREE));
        report(&name, "damped, five", &mut || room.run_each(batch, &damped, FIVE));
        report(&name, "five", &mut || room.run(batch, omega, alpha, FIVE));
        report(&name, "all", &mut || room.run(batch, omega, alpha, ALL));
        let row = vec![1.5; alpha.len()];
        report(&name, "triple, fixed Ω", &mut || room.run(batch, &row, alpha, THREE));
        report(&name, "five, fixed Ω", &mut || room.run(batch, &row, alpha, FIVE));
        report(&name, "all, fixed Ω", &mut || room.run(batch, &row, alpha, ALL));
    }
}

/// One thread and all threads in turn, so that other load on the machine affects both.
#[cfg(feature = "rayon")]
fn threads(omega: &[f64], alpha: &[f64]) {
    let mut room = Room::new(omega.len());
    let batches: [(_, fn() -> Batch<'static>); 2] =
        [("one thread", Batch::new), ("all threads", || Batch::new().on_threads())];
    for (kernel, n) in [("triple", omega.len()), ("five", omega.len()), ("all", omega.len())] {
        let mut best = [f64::INFINITY; 2];
        for _ in 0..15 {
            for (best, (_, batch)) in best.iter_mut().zip(batches) {
                let start = Instant::now();
                match kernel {
                    "triple" => room.run(batch, omega, alpha, THREE),
                    "five" => room.run(batch, omega, alpha, FIVE),
                    _ => room.run(batch, omega, alpha, ALL),
                }
                *best = best.min(start.elapsed().as_secs_f64());
            }
        }
        for (best, (name, _)) in best.iter().zip(batches) {
            println!("stickslip, {name}\t{kernel}, {n} points\t{:.2}", best / n as f64 * 1e9);
        }
    }
}
