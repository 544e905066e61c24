//! What holds of batches, whatever the points, their number and where a slice begins: shared by the tests and the fuzz target.

use stickslip::batch::{Batch, Cycles, FixedOmega, Level, Peaks, Triple};
use stickslip::{Border, Cycle, Ratios, Regime, regime};

/// Outputs of a batch in the order of [`Cycles`]; of [`Triple`] and [`Peaks`] those at these places.
const THREE: [usize; 3] = [0, 5, 7];
const FIVE: [usize; 5] = [0, 5, 7, 2, 3];

type Columns<const N: usize> = [Vec<f64>; N];

fn cycles(omega: &[f64], run: impl FnOnce(Cycles<'_>)) -> (Vec<Option<Regime>>, Columns<9>) {
    let mut regimes = vec![None; omega.len()];
    let mut columns: Columns<9> = std::array::from_fn(|_| vec![0.0; omega.len()]);
    let [a, b, c, d, e, f, g, h, i] = &mut columns;
    run(Cycles {
        regime: &mut regimes,
        max_displacement: a,
        displacement_phase: b,
        max_velocity: c,
        velocity_phase: d,
        deviation: e,
        min_force_ratio: f,
        contraction: g,
        loop_size_stiffness: h,
        loop_size_inertia: i,
    });
    (regimes, columns)
}

fn triple(omega: &[f64], run: impl FnOnce(Triple<'_>)) -> Columns<3> {
    let mut columns: Columns<3> = std::array::from_fn(|_| vec![0.0; omega.len()]);
    let [a, b, c] = &mut columns;
    run(Triple { max_displacement: a, min_force_ratio: b, loop_size_stiffness: c });
    columns
}

fn peaks(omega: &[f64], run: impl FnOnce(Peaks<'_>)) -> Columns<5> {
    let mut columns: Columns<5> = std::array::from_fn(|_| vec![0.0; omega.len()]);
    let [a, b, c, d, e] = &mut columns;
    run(Peaks {
        max_displacement: a,
        min_force_ratio: b,
        loop_size_stiffness: c,
        max_velocity: d,
        velocity_phase: e,
    });
    columns
}

fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

/// The outputs of one point's own code; `None` where there is no cycle.
fn alone(omega: f64, alpha: f64) -> Option<[f64; 9]> {
    let cycle = Cycle::new(Ratios::new(omega, alpha).ok()?).ok()?;
    Some([
        cycle.max_displacement(),
        cycle.displacement_phase(),
        cycle.max_velocity(),
        cycle.velocity_phase(),
        cycle.deviation(),
        Border::new(omega).ok()?.min_force_ratio(),
        cycle.contraction(),
        cycle.loop_size_stiffness(),
        cycle.loop_size_inertia(),
    ])
}

/// Everything that batches promise of `length` points taken in turn from `points`, in a slice that begins at `offset` of its memory.
///
/// # Panics
/// Where a promise is broken: that is the finding.
pub(crate) fn batches(points: &[(f64, f64)], offset: usize, length: usize) {
    if points.is_empty() {
        return;
    }
    let (omega, alpha): (Vec<f64>, Vec<f64>) = points.iter().cycle().take(offset + length).copied().unzip();
    let (omega, alpha) = (&omega[offset..], &alpha[offset..]);
    let due = Due::of(points, offset, length);
    let row = omega.first().and_then(|&omega| FixedOmega::new(omega).ok());
    let row = row.map(|row| {
        let points: Vec<_> = points.iter().map(|&(_, alpha)| (row.omega(), alpha)).collect();
        (row, Due::of(&points, offset, length))
    });
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        let batch = Batch::new().at_level(level);
        let (regimes, columns) = cycles(omega, |out| batch.cycles(omega, alpha, out).unwrap());
        let three = triple(omega, |out| batch.triple(omega, alpha, out).unwrap());
        let five = peaks(omega, |out| batch.peaks(omega, alpha, out).unwrap());
        due.check(&regimes, &columns, level);
        // The columns that are computed with fewer others beside them.
        for (part, place) in three.iter().zip(THREE) {
            due.check_column(part, place, level);
        }
        for (part, place) in five.iter().zip(FIVE) {
            let same = part.iter().zip(&columns[place]).all(|(&x, &y)| bits(x) == bits(y));
            assert!(same, "output {place} of the peaks, {level:?}");
        }
        if let Some((row, due)) = &row {
            let (regimes, columns) = cycles(alpha, |out| batch.cycles_at(row, alpha, out).unwrap());
            due.check(&regimes, &columns, level);
        }
    }
}

/// What is due of one point.
struct Point {
    omega: f64,
    alpha: f64,
    regime: Option<Regime>,
    values: Option<[f64; 9]>,
}

/// What is due of points that are taken in turn: each is worked out once, however often it comes.
struct Due {
    points: Vec<Point>,
    offset: usize,
    length: usize,
}

impl Due {
    fn of(points: &[(f64, f64)], offset: usize, length: usize) -> Self {
        let due = |&(omega, alpha): &(f64, f64)| {
            let (regime, values) = (regime(omega, alpha).ok(), alone(omega, alpha));
            Point { omega, alpha, regime, values }
        };
        Self { points: points.iter().take(offset + length).map(due).collect(), offset, length }
    }

    fn each(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().cycle().skip(self.offset).take(self.length)
    }

    fn check(&self, regimes: &[Option<Regime>], columns: &Columns<9>, level: Level) {
        for (due, found) in self.each().zip(regimes) {
            assert_eq!(*found, due.regime, "{level:?} at ({:e}, {:e})", due.omega, due.alpha);
        }
        for (place, column) in columns.iter().enumerate() {
            self.check_column(column, place, level);
        }
    }

    fn check_column(&self, column: &[f64], place: usize, level: Level) {
        const BORDER: usize = 5;
        for (due, &found) in self.each().zip(column) {
            let at = || format!("output {place}, {level:?} at ({:e}, {:e})", due.omega, due.alpha);
            // Beside a pole the body may slide on without the cycle of two reversals.
            let exists = due.values.is_some() || place == BORDER && due.regime.is_some();
            assert_eq!(found.is_nan(), !exists, "{}: {found}", at());
            let Some(values) = due.values else { continue };
            let value = values[place];
            assert!(bits(found) == bits(value), "{}: {found} for {value}", at());
        }
    }
}
