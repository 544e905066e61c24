//! Batches against the library's own code for one point, with every set of instructions the processor has: the same bits, and so the
//! accuracy of a point (`accuracy.rs`).

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

/// A batch gives the bits of a point alone, at every level.
#[test]
fn a_batch_has_the_bits_of_its_points() {
    let (omega, alpha) = points(20_000);
    for level in levels() {
        let batch = Batch::new().at_level(level);
        let (all, three) = (cycles(batch, &omega, &alpha), triple(batch, &omega, &alpha));
        for i in 0..omega.len() {
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
        }
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

#[test]
fn rows_of_one_frequency() {
    let mut random = Random(5);
    for omega in [1e-4, 0.25, 0.250_001, 0.3, 0.49, 0.5, 0.7, 1f64.next_up(), 1.0, 1.5, 2.0, 700.0, 1e9] {
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
            for (column, reference) in columns.iter().zip(&reference) {
                assert!(
                    column.iter().map(|&x| bits(x)).eq(reference.iter().map(|&x| bits(x))),
                    "{omega} {level:?}"
                );
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
