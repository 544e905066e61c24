//! Invariants of batches for any points, any number of them and any start of a slice, shared by the tests and
//! the fuzz target.

use stickslip::batch::{Batch, Level};
use stickslip::{Output, Ratios, Regime, Response};

/// The outputs of the loops, and one that is computed point by point.
const OUTPUTS: [Output; 10] = [
    Output::MinForceRatio,
    Output::MaxDisplacement,
    Output::LoopSizeStiffness,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::DisplacementPhase,
    Output::LoopSizeInertia,
    Output::Deviation,
    Output::Contraction,
    Output::BestForceRatio,
];

/// The outputs with these indices, and the regime.
fn outputs(
    n: usize,
    places: &[usize],
    level: Level,
    run: impl FnOnce(Batch<'_>) -> Result<(), stickslip::Error>,
) -> (Vec<Option<Regime>>, Vec<Vec<f64>>) {
    let (mut regimes, mut numbers) = (vec![None; n], vec![vec![0.0; n]; places.len()]);
    let slices = places.iter().zip(&mut numbers);
    let batch = Batch::new().at_level(level).with_regime(&mut regimes);
    run(slices.fold(batch, |batch, (&place, slice)| batch.with(OUTPUTS[place], slice))).unwrap();
    (regimes, numbers)
}

fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

/// The outputs by the code for one point; NaN where one does not exist.
fn alone(omega: f64, alpha: f64) -> [f64; OUTPUTS.len()] {
    let response = Ratios::new(omega, alpha).map(Response::new);
    OUTPUTS.map(|output| response.as_ref().ok().and_then(|at| output.of(at)).unwrap_or(f64::NAN))
}

/// Checks every promise about batches for `length` points taken in turn from `points`, in a slice that begins
/// at `offset` of its memory.
///
/// # Panics
///
/// If a promise is broken; the fuzzer reports this as a finding.
pub(crate) fn batches(points: &[(f64, f64)], offset: usize, length: usize) {
    if points.is_empty() {
        return;
    }
    let (omega, alpha): (Vec<f64>, Vec<f64>) = points.iter().cycle().take(offset + length).copied().unzip();
    let (omega, alpha) = (&omega[offset..], &alpha[offset..]);
    let due = Due::of(points, offset, length);
    let first = omega.first().copied().unwrap_or_default();
    let row = vec![first; length];
    let of_row: Vec<_> = points.iter().map(|&(_, alpha)| (first, alpha)).collect();
    let due_of_row = Due::of(&of_row, offset, length);
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        let all: Vec<usize> = (0..OUTPUTS.len()).collect();
        // All outputs, and subsets, which need fewer loops.
        for places in [&all[..], &[0, 1, 2], &[0, 1, 2, 3, 4], &[8], &[6]] {
            let (regimes, columns) = outputs(length, places, level, |batch| batch.run(omega, alpha));
            due.check(places, &regimes, &columns, level);
        }
        let (regimes, columns) = outputs(length, &all, level, |batch| batch.run(&row, alpha));
        due_of_row.check(&all, &regimes, &columns, level);
    }
}

/// The expected results of one point.
struct Point {
    omega: f64,
    alpha: f64,
    regime: Option<Regime>,
    values: [f64; OUTPUTS.len()],
}

/// The expected results of points taken in turn: each is computed once, however often it occurs.
struct Due {
    points: Vec<Point>,
    offset: usize,
    length: usize,
}

impl Due {
    fn of(points: &[(f64, f64)], offset: usize, length: usize) -> Self {
        let due = |&(omega, alpha): &(f64, f64)| {
            let (regime, values) =
                (Ratios::new(omega, alpha).ok().map(|at| Response::new(at).regime), alone(omega, alpha));
            Point { omega, alpha, regime, values }
        };
        Self { points: points.iter().take(offset + length).map(due).collect(), offset, length }
    }

    fn each(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().cycle().skip(self.offset).take(self.length)
    }

    fn check(&self, places: &[usize], regimes: &[Option<Regime>], columns: &[Vec<f64>], level: Level) {
        for (due, found) in self.each().zip(regimes) {
            assert_eq!(*found, due.regime, "{level:?} at ({:e}, {:e})", due.omega, due.alpha);
        }
        for (column, &place) in columns.iter().zip(places) {
            for (due, &found) in self.each().zip(column) {
                let (value, name) = (due.values[place], OUTPUTS[place].name());
                let at = || format!("{name}, {level:?} at ({:e}, {:e})", due.omega, due.alpha);
                assert!(bits(found) == bits(value), "{}: {found} for {value}", at());
            }
        }
    }
}
