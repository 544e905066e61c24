//! A hash of the bits of many answers at f64, which must be the same for every target the program is compiled
//! for.
//!
//! `bits [POINTS]` prints it for single points, and compares these with batches of every level of the
//! processor, in slices of several lengths. Ω is uniform, close to 1 and close to 1/n; α is on the border,
//! close to it and away from it. The same points with a damper have a hash of their own. Where a batch has other bits, the program names the first such point, and
//! exits with status 1.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

#[path = "../tests/random/generator.rs"]
mod generator;

use generator::Random;
use stickslip::batch::{Batch, Level};
use stickslip::{Border, Error, Output, Ratios, Response};

/// The number of points whose answers are kept at a time.
const CHUNK: usize = 100_000;
/// The outputs that the loops compute, in the order of the hash.
const OUTPUTS: [Output; 9] = [
    Output::MaxDisplacement,
    Output::DisplacementPhase,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::Deviation,
    Output::MinForceRatio,
    Output::Contraction,
    Output::LoopSizeStiffness,
    Output::LoopSizeInertia,
];
/// Sets of outputs, chosen so that every loop is omitted in one of them: the loops that run must not change a
/// bit.
const SETS: [&[usize]; 7] =
    [&[0, 5, 7], &[0, 5, 7, 2, 3], &[0, 1, 2, 3, 4, 5, 6, 7, 8], &[8], &[4], &[6, 1], &[2, 6, 8]];

impl Random {
    /// Ω is uniform, close to 1 or close to 1/n; α is on the border, just above it, up to four times it, or
    /// below it.
    fn point(&mut self, i: usize) -> (f64, f64) {
        let beside = (0.5 - self.next()) / (1u64 << (i % 50)) as f64;
        let omega = match i % 4 {
            0 => 0.5 + 3.0 * self.next(),
            1 => 1.0 + beside,
            2 => (1.0 + beside) / (1.0 + (i % 7) as f64),
            _ => 0.05 + 0.95 * self.next(),
        };
        let border = Border::new(omega).map_or(1.0, |border| border.min_force_ratio);
        let alpha = match i % 5 {
            0 => border,
            1 => border.next_up(),
            2 => border * (1.0 + beside.abs()),
            3 => border * (0.8 + 0.2 * self.next()),
            _ => border * (1.0 + 3.0 * self.next()),
        };
        (omega, alpha)
    }
}

/// The hash FNV-1a, which is the same for every version of Rust.
fn hash(state: u64, bits: u64) -> u64 {
    bits.to_le_bytes()
        .iter()
        .fold(state, |state, &byte| (state ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The bits of a number; all NaNs count as the same.
fn bits(x: f64) -> u64 {
    if x.is_nan() { u64::MAX } else { x.to_bits() }
}

/// All outputs of a single point; NaN where one does not exist.
fn alone(omega: f64, alpha: f64) -> [f64; OUTPUTS.len()] {
    let response = Ratios::new(omega, alpha).map(Response::new);
    OUTPUTS.map(|output| response.as_ref().ok().and_then(|at| output.of(at)).unwrap_or(f64::NAN))
}

/// The outputs of a set, computed by a batch in slices of `length`.
fn batched(
    level: Level,
    set: &[usize],
    omega: &[f64],
    alpha: &[f64],
    length: usize,
) -> Result<Vec<Vec<f64>>, Error> {
    let mut found = vec![vec![0.0; omega.len()]; set.len()];
    let mut rests: Vec<&mut [f64]> = found.iter_mut().map(Vec::as_mut_slice).collect();
    for (omega, alpha) in omega.chunks(length).zip(alpha.chunks(length)) {
        let mut batch = Batch::new().at_level(level);
        for (rest, &place) in rests.iter_mut().zip(set) {
            let (part, after) = std::mem::take(rest).split_at_mut(omega.len());
            *rest = after;
            batch = batch.with(OUTPUTS[place], part);
        }
        batch.run(omega, alpha)?;
    }
    Ok(found)
}

/// The hash of the answers of a chunk, starting from `state`; `None` where a batch has other bits than the
/// single points.
fn chunk(points: &[(f64, f64)], state: u64) -> Result<Option<u64>, Error> {
    let due: Vec<_> = points.iter().map(|&(omega, alpha)| alone(omega, alpha)).collect();
    let (omega, alpha): (Vec<_>, Vec<_>) = points.iter().copied().unzip();
    let mut is_same = true;
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        // Blocks are padded, so that short slices cost as much as long ones, and a few of them suffice.
        for (n, length) in [(points.len(), CHUNK), (points.len(), 129), (points.len().min(1000), 7)] {
            for set in SETS {
                for (column, &place) in batched(level, set, &omega[..n], &alpha[..n], length)?.iter().zip(set)
                {
                    let differs = |&i: &usize| bits(column[i]) != bits(due[i][place]);
                    if let Some(i) = (0..n).find(differs) {
                        let (name, point) = (OUTPUTS[place].name(), points[i]);
                        let (found, due) = (column[i], due[i][place]);
                        println!(
                            "{level:?}, slices of {length}, {name} of {set:?}: {found:e} for {due:e} at \
                             {point:?}"
                        );
                        is_same = false;
                    }
                }
            }
        }
    }
    Ok(is_same.then(|| due.iter().flatten().fold(state, |state, &x| hash(state, bits(x)))))
}

/// The damping ratio of a point.
fn damping(i: usize) -> f64 {
    [0.02, 0.3, 1e-9, 0.6, 0.1, 0.45, 1e-4][i % 7]
}

/// The hash of the answers of a chunk with a damper; `None` where a batch has other bits than the single points.
fn damped(points: &[(f64, f64)], state: u64) -> Result<Option<u64>, Error> {
    // λ has no loops.
    let outputs: Vec<_> = OUTPUTS.into_iter().filter(|output| *output != Output::Contraction).collect();
    let ratios = |i: usize| {
        let &(omega, alpha) = points.get(i)?;
        Ratios::new(omega, alpha).ok()?.with_damping_ratio(damping(i)).ok()
    };
    let of = |output: Output, at: &Option<Response<f64>>| {
        at.as_ref().and_then(|at| output.of(at)).unwrap_or(f64::NAN)
    };
    let due: Vec<_> = (0..points.len()).map(|i| ratios(i).map(Response::new)).collect();
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        let mut found = vec![vec![0.0; points.len()]; outputs.len()];
        let columns = outputs.iter().zip(&mut found);
        let batch = Batch::new().at_level(level);
        let batch = columns.fold(batch, |batch, (&output, slice)| batch.with(output, slice));
        batch.run_each(points.len(), ratios)?;
        for (output, column) in outputs.iter().zip(&found) {
            let differs = |&i: &usize| bits(column[i]) != bits(of(*output, &due[i]));
            if let Some(i) = (0..points.len()).find(differs) {
                println!("{level:?}, {} with a damper at {:?}: {:e}", output.name(), points[i], column[i]);
                return Ok(None);
            }
        }
    }
    let all = due.iter().flat_map(|at| OUTPUTS.map(|output| of(output, at)));
    Ok(Some(all.fold(state, |state, x| hash(state, bits(x)))))
}

fn main() {
    let count = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(100_000);
    let (mut random, mut state) = (Random(14), 0xcbf2_9ce4_8422_2325);
    let mut with_damper = state;
    for start in (0..count).step_by(CHUNK) {
        let end = count.min(start + CHUNK);
        let points: Vec<_> = (start..end).map(|i| random.point(i)).collect();
        let all = chunk(&points, state).and_then(|state| Ok(state.zip(damped(&points, with_damper)?)));
        match all {
            Ok(Some(next)) => (state, with_damper) = next,
            Ok(None) => std::process::exit(1),
            Err(error) => {
                eprintln!("{error}");
                std::process::exit(1);
            }
        }
    }
    let levels: Vec<_> = Level::ALL.into_iter().filter(|level| level.is_available()).collect();
    println!(
        "{count} points alone and in batches at {levels:?}: {state:016x}, with a damper {with_damper:016x}"
    );
}
