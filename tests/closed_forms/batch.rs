//! Batches against the library's own code for one point and against 256 bits, with every set of instructions the processor
//! has.

use crate::random::Random;
use stickslip::batch::{Batch, Cycles, FixedOmega, LengthMismatch, Level, Peaks, Triple};
use stickslip::{Border, Cycle, Ratios, Regime, regime};

/// All outputs, in the order of `Cycles`.
struct Answer {
    regime: Vec<Option<Regime>>,
    columns: [Vec<f64>; 9],
}

const BORDER: usize = 5;

/// The bits of a number; those of any NaN are the same.
fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

impl Answer {
    fn of(n: usize, run: impl FnOnce(Cycles<'_>) -> Result<(), LengthMismatch>) -> Self {
        let mut answer =
            Self { regime: vec![None; n], columns: std::array::from_fn(|_| vec![f64::INFINITY; n]) };
        let [a, b, c, d, e, f, g, h, i] = &mut answer.columns;
        run(Cycles {
            regime: &mut answer.regime,
            max_displacement: a,
            displacement_phase: b,
            max_velocity: c,
            velocity_phase: d,
            deviation: e,
            min_force_ratio: f,
            contraction: g,
            loop_size_stiffness: h,
            loop_size_inertia: i,
        })
        .unwrap();
        answer
    }

    fn bits(&self) -> [Vec<u64>; 9] {
        self.columns.each_ref().map(|column| column.iter().map(|&x| bits(x)).collect())
    }
}

fn cycles(batch: Batch, omega: &[f64], alpha: &[f64]) -> Answer {
    Answer::of(omega.len(), |out| batch.cycles(omega, alpha, out))
}

fn triple(batch: Batch, omega: &[f64], alpha: &[f64]) -> [Vec<f64>; 3] {
    let mut columns = std::array::from_fn(|_| vec![f64::INFINITY; omega.len()]);
    let [a, b, c] = &mut columns;
    batch
        .triple(omega, alpha, Triple { max_displacement: a, min_force_ratio: b, loop_size_stiffness: c })
        .unwrap();
    columns
}

fn five(columns: &mut [Vec<f64>; 5]) -> Peaks<'_> {
    let [a, b, c, d, e] = columns;
    Peaks {
        max_displacement: a,
        min_force_ratio: b,
        loop_size_stiffness: c,
        max_velocity: d,
        velocity_phase: e,
    }
}

fn peaks(batch: Batch, omega: &[f64], alpha: &[f64]) -> [Vec<f64>; 5] {
    let mut columns = std::array::from_fn(|_| vec![f64::INFINITY; omega.len()]);
    batch.peaks(omega, alpha, five(&mut columns)).unwrap();
    columns
}

/// Where the columns of `Peaks` are among those of `Cycles`.
const PEAKS: [usize; 5] = [0, BORDER, 7, 2, 3];

fn levels() -> impl Iterator<Item = Level> {
    Level::ALL.into_iter().filter(|level| level.is_available())
}

/// Ω random in several measures and the floats beside 1, 1/2, 1/3, 2/3, 2; α from below the border up, and beside it.
fn points(n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut random = Random(11);
    let mut omegas = Vec::new();
    for &special in &[1.0, 0.5, 1.0 / 3.0, 2.0 / 3.0, 2.0, 0.4, 0.25] {
        let (mut up, mut down): (f64, f64) = (special, special);
        for _ in 0..20 {
            omegas.extend([up, down]);
            (up, down) = (up.next_up(), down.next_down());
        }
        for e in 1..50 {
            omegas.extend([special * (1.0 + 0.5f64.powi(e)), special * (1.0 - 0.5f64.powi(e))]);
        }
    }
    while omegas.len() < n {
        omegas.push(random.between(0.5, 2.5));
        omegas.push(random.scale(0.5, 1e3));
        omegas.push(random.scale(0.01, 0.5));
        omegas.push(1.0 + random.scale(1e-9, 0.3));
        omegas.push(1.0 - random.scale(1e-9, 0.3));
    }
    let mut alphas = Vec::new();
    for (i, &omega) in omegas.iter().enumerate() {
        let border = Border::new(omega).unwrap().min_force_ratio();
        alphas.push(match i % 8 {
            0 => border,
            1 => border.next_up(),
            2 => border.next_down(),
            3 => border * random.between(0.3, 1.0),
            4 => border * (1.0 + random.scale(1e-15, 1e-3)),
            5 => border * random.scale(1.0, 1e4),
            _ => border * random.between(1.0, 4.0),
        });
    }
    (omegas, alphas)
}

/// What the errors are measured in, where an error of K as large as K's own counts as 1.
fn amplification(omega: f64, alpha: f64) -> f64 {
    let k = stickslip::PhaseFunction::new(omega).unwrap().value();
    alpha * alpha / ((alpha - k) * (alpha + k))
}

#[test]
fn every_level_gives_the_same_bits() {
    let (omega, alpha) = points(6000);
    let all = cycles(Batch::new().at_level(Level::Portable), &omega, &alpha);
    let three = triple(Batch::new().at_level(Level::Portable), &omega, &alpha);
    for level in levels().filter(|&level| level != Level::Scalar) {
        let batch = Batch::new().at_level(level);
        assert_eq!(batch.level(), level);
        let other = cycles(batch, &omega, &alpha);
        assert!(other.bits() == all.bits() && other.regime == all.regime, "{level:?}");
        let all_bits = |columns: &[Vec<f64>; 3]| {
            columns.each_ref().map(|c| c.iter().map(|&x| bits(x)).collect::<Vec<_>>())
        };
        assert!(all_bits(&triple(batch, &omega, &alpha)) == all_bits(&three), "{level:?}");
    }
}

/// What `.ci/run` asks again on a processor without AVX-512, naming the level that is then due.
#[test]
fn levels_are_those_of_the_processor() {
    let best = Level::best();
    assert_eq!(Batch::new().level(), best);
    assert!(best.is_available() && levels().next() == Some(Level::Scalar));
    if let Ok(due) = std::env::var("STICKSLIP_BEST_LEVEL") {
        assert_eq!(format!("{best:?}"), due);
    }
    // What is not there gives way to the portable loops.
    for level in Level::ALL {
        let due = if level.is_available() { level } else { Level::Portable };
        assert_eq!(Batch::new().at_level(level).level(), due);
    }
}

/// The same loops, so the same bits, but for points of which the velocity is left to the careful path.
#[test]
fn the_peaks_are_those_of_all() {
    let (omega, alpha) = points(20_000);
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let (all, five) = (cycles(batch, &omega, &alpha), peaks(batch, &omega, &alpha));
        for (column, among_all) in five.iter().zip(PEAKS) {
            for (i, (&x, &y)) in column.iter().zip(&all.columns[among_all]).enumerate() {
                assert_eq!(bits(x), bits(y), "{among_all}, {level:?} at {} {}", omega[i], alpha[i]);
            }
        }
    }
}

/// Ordinary points are answered by the loops, not one by one: their bits are not those of the scalar code.
fn the_loops_answer(low: f64, high: f64, alone_at_most: usize) {
    let mut random = Random(17);
    let omega: Vec<_> = (0..1000).map(|_| random.between(low, high)).collect();
    let alpha: Vec<_> = omega
        .iter()
        .map(|&omega| Border::new(omega).unwrap().min_force_ratio() * random.between(1.05, 4.0))
        .collect();
    let answer = cycles(Batch::new().at_level(Level::Portable), &omega, &alpha);
    let same = (0..omega.len())
        .filter(|&i| {
            alone(omega[i], alpha[i]).unwrap().map(f64::to_bits)
                == answer.columns.each_ref().map(|c| c[i].to_bits())
        })
        .count();
    assert!(same < alone_at_most, "{same} of 1000");
    within(worst(&answer, &omega, &alpha, |i| alone(omega[i], alpha[i])), APART, &omega, &alpha);
}

#[test]
fn below_one_half_the_loops_answer() {
    the_loops_answer(0.1, 0.5, 10);
}

/// From Ω = 1/2 on, and wherever the loops do not reach, a batch gives the bits of a point alone, at every level.
#[test]
fn from_one_half_on_a_batch_has_the_bits_of_its_points() {
    let (omega, alpha) = points(20_000);
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let (all, three) = (cycles(batch, &omega, &alpha), triple(batch, &omega, &alpha));
        let mut compared = 0;
        for i in (0..omega.len()).filter(|&i| omega[i] >= 0.5) {
            let border = Border::new(omega[i]).unwrap().min_force_ratio();
            let nan = f64::NAN;
            let mut alone = alone(omega[i], alpha[i]).unwrap_or([nan; 9]);
            alone[BORDER] = border;
            for (column, (values, alone)) in all.columns.iter().zip(alone).enumerate() {
                let place = format!("{column}, {level:?} at {:?} {:?}", omega[i], alpha[i]);
                assert_eq!(bits(values[i]), bits(alone), "{} {alone}, output {place}", values[i]);
            }
            for (values, alone) in three.iter().zip([alone[0], border, alone[7]]) {
                assert_eq!(bits(values[i]), bits(alone), "{level:?} at {:?} {:?}", omega[i], alpha[i]);
            }
            compared += 1;
        }
        assert!(compared > 10_000);
    }
}

#[test]
fn the_length_of_a_slice_does_not_matter() {
    let (omega, alpha) = points(2000);
    let whole = cycles(Batch::new(), &omega, &alpha);
    for n in [0, 1, 2, 127, 128, 129, 300] {
        let part = cycles(Batch::new(), &omega[700..700 + n], &alpha[700..700 + n]);
        for (part, whole) in part.bits().iter().zip(whole.bits()) {
            assert_eq!(part[..], whole[700..700 + n]);
        }
    }
    // Runs through several blocks at once, and what is left of them.
    let whole = triple(Batch::new(), &omega, &alpha);
    for n in [0, 1, 127, 128, 129, 300, 1024, 1100] {
        let part = triple(Batch::new(), &omega[700..700 + n], &alpha[700..700 + n]);
        for (part, whole) in part.iter().zip(&whole) {
            assert!(part.iter().zip(&whole[700..]).all(|(&x, &y)| bits(x) == bits(y)), "{n}");
        }
    }
}

#[test]
fn the_regime_and_what_does_not_exist() {
    let (mut omega, mut alpha) = points(6000);
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e300] {
        omega.extend([bad, 0.7, 1.0]);
        alpha.extend([2.0, bad, bad]);
    }
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let (answer, three) = (cycles(batch, &omega, &alpha), triple(batch, &omega, &alpha));
        for i in 0..omega.len() {
            let expected = regime(omega[i], alpha[i]).ok();
            assert_eq!(answer.regime[i], expected, "{level:?} at {} {}", omega[i], alpha[i]);
            let is_cycle = Ratios::new(omega[i], alpha[i]).and_then(Cycle::new).is_ok();
            for (column, values) in answer.columns.iter().enumerate() {
                let exists = is_cycle || column == BORDER && expected.is_some();
                assert_eq!(!values[i].is_nan(), exists, "{column}, {level:?} at {} {}", omega[i], alpha[i]);
            }
            assert_eq!(!three[0][i].is_nan(), is_cycle, "{level:?} at {} {}", omega[i], alpha[i]);
            assert_eq!(!three[2][i].is_nan(), is_cycle);
        }
    }
}

/// The outputs of one point's own code.
fn alone<F: stickslip::Float>(omega: F, alpha: F) -> Option<[F; 9]> {
    let c = Cycle::new(Ratios::new(omega, alpha).ok()?).ok()?;
    Some([
        c.max_displacement(),
        c.displacement_phase(),
        c.max_velocity(),
        c.velocity_phase(),
        c.deviation(),
        Border::new(omega).ok()?.min_force_ratio(),
        c.contraction(),
        c.loop_size_stiffness(),
        c.loop_size_inertia(),
    ])
}

/// The unit each error is counted in: the last place of the value, for phases of max(phase, 1), for Δ₁ of max(|Δ₁|, V₀), for the
/// contraction of 1 over the root that turns at gσ = 1.
fn units(omega: f64, values: &[f64; 9]) -> [f64; 9] {
    let mut units = values.map(f64::abs);
    units[1] = units[1].max(1.0);
    units[3] = units[3].max(1.0);
    units[4] = units[4].max(values[2]);
    let g_sine = omega * omega * values[0] * (std::f64::consts::PI / omega).sin().abs();
    units[6] = (1.0 - g_sine).abs().max(1e-15).sqrt().recip().max(1.0);
    units.map(|x| x * f64::EPSILON)
}

/// The largest errors against `exact`, each divided by the amplification of an error of K.
fn worst(
    answer: &Answer,
    omega: &[f64],
    alpha: &[f64],
    exact: impl Fn(usize) -> Option<[f64; 9]>,
) -> [(f64, usize); 9] {
    let mut worst = [(0.0, 0); 9];
    for i in 0..omega.len() {
        let Some(exact) = exact(i) else { continue };
        if answer.columns[0][i].is_nan() {
            continue; // which side of the border: decided by the border as rounded
        }
        let (units, factor) = (units(omega[i], &exact), amplification(omega[i], alpha[i]));
        for column in 0..9 {
            let factor = if column == BORDER { 1.0 } else { factor };
            let error = (answer.columns[column][i] - exact[column]).abs() / units[column] / factor;
            if error > worst[column].0 {
                worst[column] = (error, i);
            }
        }
    }
    worst
}

/// Bounds of the batch's errors in the units of [`worst`], against 256 bits.
#[cfg(feature = "mp")]
const BOUNDS: [f64; 9] = [2.5, 1.5, 3.5, 2.5, 2.5, 3.5, 2.0, 2.5, 3.0];

/// How far the batch and one point's own code may be apart.
const APART: [f64; 9] = [2.5, 2.0, 4.0, 3.0, 2.0, 4.0, 2.0, 2.5, 3.0];

fn within(worst: [(f64, usize); 9], bounds: [f64; 9], omega: &[f64], alpha: &[f64]) {
    for (column, (&(error, i), bound)) in worst.iter().zip(bounds).enumerate() {
        assert!(error <= bound, "output {column}: {error} units at Ω = {:?}, α = {:?}", omega[i], alpha[i]);
    }
}

#[test]
fn as_one_point_alone() {
    let (omega, alpha) = points(60_000);
    let answer = cycles(Batch::new(), &omega, &alpha);
    within(worst(&answer, &omega, &alpha, |i| alone(omega[i], alpha[i])), APART, &omega, &alpha);
}

#[cfg(feature = "mp")]
fn at_256_bits(omega: f64, alpha: f64) -> Option<[f64; 9]> {
    use stickslip::Float;
    use stickslip::float::mp::Mp;
    Some(alone(Mp::<4>::from_f64(omega), Mp::from_f64(alpha))?.map(Mp::to_f64))
}

/// The whole range of Ω and α, all outputs and the three: every level.
#[cfg(feature = "mp")]
#[test]
fn against_256_bits() {
    let (omega, alpha) = points(20_000);
    let exact: Vec<_> = omega.iter().zip(&alpha).map(|(&omega, &alpha)| at_256_bits(omega, alpha)).collect();
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let mut answer = cycles(batch, &omega, &alpha);
        within(worst(&answer, &omega, &alpha, |i| exact[i]), BOUNDS, &omega, &alpha);
        // The three, among the others.
        let three = triple(batch, &omega, &alpha);
        for (column, place) in three.into_iter().zip([0, BORDER, 7]) {
            answer.columns[place] = column;
        }
        within(worst(&answer, &omega, &alpha, |i| exact[i]), BOUNDS, &omega, &alpha);
    }
}

/// Where an error of K counts κ = α²/(α² − K²) times and κ is more than 16, it must not: the errors, not divided by κ, stay below
/// what κ = 16 allows.
#[cfg(feature = "mp")]
#[test]
fn no_error_is_more_than_sixteen_times_that_of_k() {
    let mut random = Random(19);
    let (mut omega, mut alpha) = (Vec::new(), Vec::new());
    while omega.len() < 3000 {
        let beside = 1.0 + random.scale(1e-9, 0.2) * if omega.len() % 2 == 0 { 1.0 } else { -1.0 };
        let k = stickslip::PhaseFunction::new(beside).unwrap().value();
        // α² = K² κ/(κ − 1)
        let factor: f64 = random.scale(4.0, 1e5);
        let force = k.abs() * (factor / (factor - 1.0)).sqrt();
        if Border::new(beside).unwrap().min_force_ratio() < force {
            omega.push(beside);
            alpha.push(force);
        }
    }
    let exact: Vec<_> = omega.iter().zip(&alpha).map(|(&omega, &alpha)| at_256_bits(omega, alpha)).collect();
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let answer = cycles(batch, &omega, &alpha);
        let three = triple(batch, &omega, &alpha);
        for i in 0..omega.len() {
            let exact = exact[i].unwrap();
            let units = units(omega[i], &exact);
            let error = |found: f64, column: usize| (found - exact[column]).abs() / units[column];
            // The contraction has a unit of its own.
            for column in [0, 1, 2, 3, 4, 7, 8] {
                let error = error(answer.columns[column][i], column);
                assert!(
                    error <= 16.0 * BOUNDS[column],
                    "{column}, {level:?}: {error} at {} {}",
                    omega[i],
                    alpha[i]
                );
            }
            for (three, column) in three.iter().zip([0, BORDER, 7]) {
                let error = error(three[i], column);
                assert!(
                    error <= 16.0 * BOUNDS[column],
                    "{column}, {level:?}: {error} at {} {}",
                    omega[i],
                    alpha[i]
                );
            }
        }
    }
}

#[test]
fn rows_of_one_frequency() {
    let mut random = Random(5);
    for omega in [0.3, 0.49, 0.5, 0.7, 1f64.next_up(), 1.0, 1.5, 2.0, 700.0, 1e9] {
        let row = FixedOmega::new(omega).unwrap();
        let border = Border::new(omega).unwrap().min_force_ratio();
        assert_eq!((row.omega(), row.min_force_ratio()), (omega, border));
        let mut alpha: Vec<_> = (0..300).map(|_| border * random.between(0.9, 4.0)).collect();
        alpha.extend([border, border.next_up(), border.next_down(), 0.5, f64::NAN, 1e300, -1.0]);
        let omegas = vec![omega; alpha.len()];
        for level in levels() {
            let batch = Batch::new().at_level(level);
            let answer = Answer::of(alpha.len(), |out| batch.cycles_at(&row, &alpha, out));
            let free = cycles(batch, &omegas, &alpha);
            assert_eq!(answer.regime, free.regime, "{omega}");
            assert!(answer.bits() == free.bits(), "{omega}");
            within(worst(&answer, &omegas, &alpha, |i| alone(omega, alpha[i])), APART, &omegas, &alpha);

            let mut columns = std::array::from_fn(|_| vec![0.0; alpha.len()]);
            batch.peaks_at(&row, &alpha, five(&mut columns)).unwrap();
            for (column, among_all) in columns.iter().zip(PEAKS) {
                let all = answer.columns[among_all].iter().map(|&x| bits(x));
                assert!(column.iter().map(|&x| bits(x)).eq(all), "{omega} {among_all}");
            }

            let mut columns: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; alpha.len()]);
            let [a, b, c] = &mut columns;
            let out = Triple { max_displacement: a, min_force_ratio: b, loop_size_stiffness: c };
            batch.triple_at(&row, &alpha, out).unwrap();
            let reference = triple(batch, &omegas, &alpha);
            for i in 0..alpha.len() {
                let factor = amplification(omega, alpha[i]).abs().max(1.0);
                for (column, reference) in columns.iter().zip(&reference) {
                    let (x, y) = (column[i], reference[i]);
                    let apart = (x - y).abs() / y.abs();
                    let close = x == y || apart <= 8.0 * factor * f64::EPSILON;
                    assert!(close || x.is_nan() && y.is_nan(), "{omega} {}: {x} {y}", alpha[i]);
                }
            }
        }
    }
    assert!(FixedOmega::new(0.0).is_err());
}

#[test]
fn slices_of_different_lengths() {
    let mut ten: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; 10]);
    let [a, b, c] = &mut ten;
    let out = Triple { max_displacement: a, min_force_ratio: &mut b[..9], loop_size_stiffness: c };
    let error = Batch::new().triple(&[1.5; 10], &[3.0; 10], out).unwrap_err();
    assert_eq!(error.to_string(), "least force ratio α_min has 9 elements where 10 are due");
    assert!(Batch::new().steady(&[1.5; 10], &[3.0; 11]).is_err());
}

#[test]
fn the_exact_motion() {
    use stickslip::exact::{LongRun, State};
    let omega = [1.5, 0.4, 0.7, 0.5, 1.0, f64::NAN];
    let alpha = [2.5, 6.0, 1.2, 4.0, 2.0, 2.0];
    let answers = Batch::new().steady(&omega, &alpha).unwrap();
    for (i, answer) in answers.iter().enumerate() {
        let expected = Ratios::new(omega[i], alpha[i]).and_then(|r| LongRun::from_start(r, State::rest()));
        match (answer, expected) {
            (Ok(LongRun::Periodic(a)), Ok(LongRun::Periodic(b))) => {
                assert!((a.max_displacement() / b.max_displacement() - 1.0).abs() < 1e-12, "{}", omega[i]);
                assert!((a.max_velocity() / b.max_velocity() - 1.0).abs() < 1e-12, "{}", omega[i]);
            }
            (a, b) => assert_eq!(a, &b),
        }
    }
}

#[cfg(feature = "rayon")]
#[test]
fn threads_change_nothing() {
    let (omega, alpha) = points(30_000);
    let (one, many) = (Batch::new(), Batch::new().on_threads());
    let (a, b) = (cycles(one, &omega, &alpha), cycles(many, &omega, &alpha));
    assert!(a.bits() == b.bits() && a.regime == b.regime);
    let (a, b) = (triple(one, &omega, &alpha), triple(many, &omega, &alpha));
    assert!(format!("{a:?}") == format!("{b:?}"));
    let (a, b) = (
        one.steady(&omega[3000..3100], &alpha[3000..3100]),
        many.steady(&omega[3000..3100], &alpha[3000..3100]),
    );
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
}

#[cfg(feature = "generators")]
mod any {
    use arbitrary::{Arbitrary, Unstructured};
    use proptest::prelude::*;
    use stickslip::generators::Point;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(100))]

        /// Of any number of points, hard on purpose, wherever their slice begins.
        #[test]
        fn batches_keep_their_promises(bytes in prop::collection::vec(any::<u8>(), 0..600), offset in 0usize..16, length in 0usize..400) {
            let mut from = Unstructured::new(&bytes);
            let mut points = Vec::new();
            while !from.is_empty() {
                let Ok(Point { omega, alpha }) = Point::arbitrary(&mut from) else { break };
                points.push((omega, alpha));
            }
            crate::batches::batches(&points, offset, length);
        }
    }
}
