//! One number that the bits of many answers at f64 come to: the same for every target the program is compiled for.
//!
//! `bits [POINTS]` prints it for points alone, and compares with them batches of every level the processor has, in slices of several
//! lengths. Ω is uniform, beside 1 and beside 1/n; α on the border, beside it and away from it. Where a batch has other bits it names the
//! first such point, and ends with status 1.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program of its own: what it prints is its answer"
)]

use stickslip::batch::{Batch, Cycles, LengthMismatch, Level, Peaks, Triple};
use stickslip::{Border, Ratios, Response};

/// Points whose answers are kept at a time.
const CHUNK: usize = 100_000;
/// The outputs in the order of [`Cycles`], and where those of [`Triple`] and [`Peaks`] are among them.
const OUTPUTS: usize = 9;
const THREE: [usize; 3] = [0, 5, 7];
const FIVE: [usize; 5] = [0, 5, 7, 2, 3];

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

    /// Ω uniform, beside 1 and beside 1/n; α on the border, just above it, up to four times it, and below.
    fn point(&mut self, i: usize) -> (f64, f64) {
        let beside = (0.5 - self.uniform()) / (1u64 << (i % 50)) as f64;
        let omega = match i % 4 {
            0 => 0.5 + 3.0 * self.uniform(),
            1 => 1.0 + beside,
            2 => (1.0 + beside) / (1.0 + (i % 7) as f64),
            _ => 0.05 + 0.95 * self.uniform(),
        };
        let border = Border::new(omega).map_or(1.0, |border| border.min_force_ratio());
        let alpha = match i % 5 {
            0 => border,
            1 => border.next_up(),
            2 => border * (1.0 + beside.abs()),
            3 => border * (0.8 + 0.2 * self.uniform()),
            _ => border * (1.0 + 3.0 * self.uniform()),
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

/// The bits of a number; those of any NaN are the same.
fn bits(x: f64) -> u64 {
    if x.is_nan() { u64::MAX } else { x.to_bits() }
}

/// All outputs of a point alone, NaN what does not exist.
fn alone(omega: f64, alpha: f64) -> [f64; OUTPUTS] {
    let nan = [f64::NAN; OUTPUTS];
    let Ok(response) = Ratios::new(omega, alpha).map(Response::new) else { return nan };
    let border = response.border().min_force_ratio();
    let Some(cycle) = response.cycle() else {
        return std::array::from_fn(|i| if i == 5 { border } else { f64::NAN });
    };
    [
        cycle.max_displacement(),
        cycle.displacement_phase(),
        cycle.max_velocity(),
        cycle.velocity_phase(),
        cycle.deviation(),
        border,
        cycle.contraction(),
        cycle.loop_size_stiffness(),
        cycle.loop_size_inertia(),
    ]
}

type Columns<const N: usize> = [Vec<f64>; N];

/// The outputs of a batch of each kind, by slices of `length`.
struct Answers {
    three: Columns<3>,
    five: Columns<5>,
    all: Columns<OUTPUTS>,
}

impl Answers {
    fn new(batch: Batch, omega: &[f64], alpha: &[f64], length: usize) -> Result<Self, LengthMismatch> {
        fn columns<const N: usize>(n: usize) -> Columns<N> {
            std::array::from_fn(|_| vec![0.0; n])
        }
        let n = omega.len();
        let mut found = Self { three: columns(n), five: columns(n), all: columns(n) };
        let mut regimes = vec![None; n];
        let mut start = 0;
        for (omega, alpha) in omega.chunks(length).zip(alpha.chunks(length)) {
            let part = start..start + omega.len();
            start = part.end;
            let [a, b, c] = found.three.each_mut().map(|column| &mut column[part.clone()]);
            let out = Triple { max_displacement: a, min_force_ratio: b, loop_size_stiffness: c };
            batch.triple(omega, alpha, out)?;
            let [a, b, c, d, e] = found.five.each_mut().map(|column| &mut column[part.clone()]);
            let out = Peaks {
                max_displacement: a,
                min_force_ratio: b,
                loop_size_stiffness: c,
                max_velocity: d,
                velocity_phase: e,
            };
            batch.peaks(omega, alpha, out)?;
            let [a, b, c, d, e, f, g, h, i] = found.all.each_mut().map(|column| &mut column[part.clone()]);
            let out = Cycles {
                regime: &mut regimes[part],
                max_displacement: a,
                displacement_phase: b,
                max_velocity: c,
                velocity_phase: d,
                deviation: e,
                min_force_ratio: f,
                contraction: g,
                loop_size_stiffness: h,
                loop_size_inertia: i,
            };
            batch.cycles(omega, alpha, out)?;
        }
        Ok(found)
    }

    /// The columns with the output each is, and which batch it is of.
    fn each(&self) -> impl Iterator<Item = (&'static str, usize, &Vec<f64>)> {
        let three = self.three.iter().zip(THREE).map(|(column, output)| ("three", output, column));
        let five = self.five.iter().zip(FIVE).map(|(column, output)| ("five", output, column));
        three.chain(five).chain(self.all.iter().enumerate().map(|(output, column)| ("all", output, column)))
    }
}

/// What the answers of a chunk come to, from `state` on; `None` where a batch has other bits than its points.
fn chunk(points: &[(f64, f64)], state: u64) -> Result<Option<u64>, LengthMismatch> {
    let due: Vec<_> = points.iter().map(|&(omega, alpha)| alone(omega, alpha)).collect();
    let (omega, alpha): (Vec<_>, Vec<_>) = points.iter().copied().unzip();
    let mut is_same = true;
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        // Blocks are filled up, so that short slices cost as much as long ones: a few are enough.
        for (n, length) in [(points.len(), CHUNK), (points.len(), 129), (points.len().min(1000), 7)] {
            let found = Answers::new(Batch::new().at_level(level), &omega[..n], &alpha[..n], length)?;
            for (kind, output, column) in found.each() {
                let differs = |&i: &usize| bits(column[i]) != bits(due[i][output]);
                if let Some(i) = (0..n).find(differs) {
                    let (found, due) = (column[i], due[i][output]);
                    println!(
                        "{level:?}, slices of {length}, {kind}, output {output}: {found:e} for {due:e} at {:?}",
                        points[i]
                    );
                    is_same = false;
                }
            }
        }
    }
    Ok(is_same.then(|| due.iter().flatten().fold(state, |state, &x| hash(state, bits(x)))))
}

fn main() {
    let count = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(100_000);
    let (mut random, mut state) = (Random(14), 0xcbf2_9ce4_8422_2325);
    for start in (0..count).step_by(CHUNK) {
        let end = count.min(start + CHUNK);
        let points: Vec<_> = (start..end).map(|i| random.point(i)).collect();
        match chunk(&points, state) {
            Ok(Some(next)) => state = next,
            Ok(None) => std::process::exit(1),
            Err(error) => {
                eprintln!("{error}");
                std::process::exit(1);
            }
        }
    }
    let levels: Vec<_> = Level::ALL.into_iter().filter(|level| level.is_available()).collect();
    println!("{count} points alone and in batches at {levels:?}: {state:016x}");
}
