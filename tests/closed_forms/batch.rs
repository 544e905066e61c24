//! Batches compared with the library's own code for one point, with every instruction set of the processor:
//! the same bits, and therefore the accuracy of a point (`accuracy.rs`).

#[cfg(feature = "generators")]
mod any;
mod lengths;

use crate::random::Random;
use stickslip::batch::{Batch, Level};
use stickslip::{Border, Error, Output, Ratios, Regime, Response};

/// Outputs that need no search of their own: those of the loops, and some that are computed point by point.
const OUTPUTS: [Output; 13] = [
    Output::MaxDisplacement,
    Output::MinForceRatio,
    Output::LoopSizeStiffness,
    Output::DisplacementPhase,
    Output::LoopSizeInertia,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::Deviation,
    Output::Contraction,
    Output::Margin,
    Output::LeastDisplacement,
    Output::BestForceRatio,
    Output::DynamicAmplification,
];
const LOOPED: &[Output] = OUTPUTS.first_chunk::<9>().unwrap();
/// The outputs of the amplitude, which one loop computes.
const THREE: &[Output] = OUTPUTS.first_chunk::<3>().unwrap();
const FIVE: [Output; 5] = [OUTPUTS[0], OUTPUTS[1], OUTPUTS[2], Output::MaxVelocity, Output::VelocityPhase];

/// The bits of a number; all NaNs count as the same.
fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

#[derive(PartialEq)]
struct Answer {
    regime: Vec<Option<Regime>>,
    columns: Vec<Vec<u64>>,
}

impl Answer {
    fn of(
        batch: Batch<'_>,
        n: usize,
        outputs: &[Output],
        run: impl FnOnce(Batch<'_>) -> Result<(), Error>,
    ) -> Self {
        let (mut regime, mut columns) = (vec![None; n], vec![vec![f64::INFINITY; n]; outputs.len()]);
        let slices = outputs.iter().zip(&mut columns);
        let wanted = slices.fold(batch, |wanted, (&output, slice)| wanted.with(output, slice));
        run(wanted.with_regime(&mut regime)).unwrap();
        let columns = columns.into_iter().map(|column| column.into_iter().map(bits).collect()).collect();
        Self { regime, columns }
    }
}

fn answer(batch: Batch<'_>, omega: &[f64], alpha: &[f64], outputs: &[Output]) -> Answer {
    Answer::of(batch, omega.len(), outputs, |wanted| wanted.run(omega, alpha))
}

/// The same, computed by the code for one point.
fn alone(ratios: impl Iterator<Item = Option<Ratios<f64>>>, outputs: &[Output]) -> Answer {
    let mut due = Answer { regime: Vec::new(), columns: vec![Vec::new(); outputs.len()] };
    for ratios in ratios {
        let response = ratios.map(Response::new);
        due.regime.push(response.map(|at| at.regime));
        for (column, output) in due.columns.iter_mut().zip(outputs) {
            column.push(bits(response.and_then(|at| output.of(&at)).unwrap_or(f64::NAN)));
        }
    }
    due
}

fn points_alone(omega: &[f64], alpha: &[f64], outputs: &[Output]) -> Answer {
    alone(omega.iter().zip(alpha).map(|(&omega, &alpha)| Ratios::new(omega, alpha).ok()), outputs)
}

/// # Panics
///
/// If the two differ: reports the first such point.
fn assert_same(found: &Answer, due: &Answer, at: impl Fn(usize) -> String) {
    if let Some(i) = (0..due.regime.len()).find(|&i| found.regime[i] != due.regime[i]) {
        panic!("{:?} for {:?}: {}", found.regime[i], due.regime[i], at(i));
    }
    for (k, (found, due)) in found.columns.iter().zip(&due.columns).enumerate() {
        if let Some(i) = (0..due.len()).find(|&i| found[i] != due[i]) {
            let [found, due] = [found[i], due[i]].map(f64::from_bits);
            panic!("{found:e} for {due:e}, output {k}: {}", at(i));
        }
    }
}

fn levels() -> impl Iterator<Item = Level> {
    Level::ALL.into_iter().filter(|level| level.is_available())
}

/// Ω random in several measures, and the floats next to 1, 1/2, 1/3, 2/3 and 2; α from below the border up,
/// and close to it.
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
        let border = Border::new(omega).unwrap().min_force_ratio;
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

/// Points inside the domain, and some outside it.
fn points_and_others(n: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut omega, mut alpha) = points(n);
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e300] {
        omega.extend([bad, 0.7, 1.0]);
        alpha.extend([2.0, bad, bad]);
    }
    (omega, alpha)
}

#[test]
fn every_level_has_the_bits_of_the_points_alone() {
    let (omega, alpha) = points_and_others(20_000);
    let due = points_alone(&omega, &alpha, LOOPED);
    for level in levels() {
        let found = answer(Batch::new().at_level(level), &omega, &alpha, LOOPED);
        assert_same(&found, &due, |i| format!("{level:?} at {:e} {:e}", omega[i], alpha[i]));
    }
}

/// The requested outputs determine which loops run, but not the bits.
#[test]
fn any_set_of_outputs_has_the_same_bits() {
    let (omega, alpha) = points_and_others(3000);
    let due = points_alone(&omega, &alpha, &OUTPUTS);
    let mut random = Random(23);
    for level in levels() {
        let mut sets: Vec<Vec<usize>> = (0..OUTPUTS.len()).map(|k| vec![k]).collect();
        sets.extend([(0..3).collect(), vec![0, 1, 2, 5, 6], (0..OUTPUTS.len()).collect(), Vec::new()]);
        sets.extend((0..12).map(|_| (0..OUTPUTS.len()).filter(|_| random.between(0.0, 1.0) < 0.4).collect()));
        for set in sets {
            let outputs: Vec<_> = set.iter().map(|&k| OUTPUTS[k]).collect();
            let due = Answer {
                regime: due.regime.clone(),
                columns: set.iter().map(|&k| due.columns[k].clone()).collect(),
            };
            let found = answer(Batch::new().at_level(level), &omega, &alpha, &outputs);
            assert_same(&found, &due, |i| format!("{level:?}, {set:?} at {:e} {:e}", omega[i], alpha[i]));
        }
    }
}

/// Outputs with a search of their own.
#[test]
fn every_output_can_be_asked_for() {
    let (omega, alpha) = ([0.7, 1.5, 0.4, f64::NAN], [2.0, 2.5, 6.0, 2.0]);
    let found = answer(Batch::new(), &omega, &alpha, &Output::ALL);
    assert_same(&found, &points_alone(&omega, &alpha, &Output::ALL), |i| format!("{}", omega[i]));
}

#[test]
fn with_damping_each_point_is_that_alone() {
    let (omega, alpha) = points_and_others(2000);
    let zeta: Vec<_> = (0..omega.len()).map(|i| [0.0, 0.05, 1.0, -1.0, f64::NAN][i % 5]).collect();
    let ratios = |i: usize| Ratios::new(omega[i], alpha[i]).ok()?.with_damping_ratio(zeta[i]).ok();
    let due = alone((0..omega.len()).map(ratios), LOOPED);
    assert!(due.regime.iter().flatten().count() > 1000);
    let found = Answer::of(Batch::new(), omega.len(), LOOPED, |wanted| wanted.run_each(omega.len(), ratios));
    assert_same(&found, &due, |i| format!("{} {} {}", omega[i], alpha[i], zeta[i]));
}

/// The loops with a damper: at their bounds, beside the pole and ζ = 1, with and without static friction, and
/// with points among them that they cannot compute.
#[test]
fn with_damping_the_loops_have_the_bits_of_the_points_alone() {
    let (omega, alpha) = points_and_others(6000);
    let mut random = Random(36);
    let zeta: Vec<_> = (0..omega.len())
        .map(|i| match i % 9 {
            0 => 0.0,
            1 => 0.875,
            2 => 0.875f64.next_up(),
            3 => 1.0,
            4 => random.scale(1e-75, 1e-6),
            5 => random.scale(1e-9, 40.0),
            6 => (omega[i] - 1.0).abs(),
            _ => random.between(0.0, 0.9),
        })
        .collect();
    let eta: Vec<_> = (0..omega.len()).map(|i| [1.0, 1.0, 1.2, random.scale(1.0, 1e9)][i % 4]).collect();
    // Half of the force ratios in relation to the border with damping.
    let at = |i: usize, alpha: f64| {
        let ratios = Ratios::new(omega[i], alpha).ok()?.with_damping_ratio(zeta[i]).ok()?;
        ratios.with_static_friction_ratio(eta[i]).ok()
    };
    let force = |i: usize| {
        let border = Border::of(&at(i, 2.0)?).min_force_ratio;
        Some([border, border.next_down(), 1.5 * border, border * (1.0 + 1e-12)][i / 2 % 4])
    };
    let alpha: Vec<_> =
        (0..omega.len()).map(|i| if i % 2 == 0 { alpha[i] } else { force(i).unwrap_or(f64::NAN) }).collect();
    let ratios = |i: usize| at(i, alpha[i]);
    // All that have loops with a damper, and parts of them.
    let sets = [THREE, &OUTPUTS[..8], &FIVE, &OUTPUTS[3..5], &OUTPUTS[6..7]];
    for outputs in sets {
        let due = alone((0..omega.len()).map(ratios), outputs);
        for level in levels() {
            for n in [omega.len(), 129, 7] {
                let batch = Batch::new().at_level(level);
                let found = Answer::of(batch, n, outputs, |wanted| wanted.run_each(n, ratios));
                let due = Answer {
                    regime: due.regime[..n].to_vec(),
                    columns: due.columns.iter().map(|column| column[..n].to_vec()).collect(),
                };
                assert_same(&found, &due, |i| {
                    format!("{level:?}: {:?} {:?} {:?} {:?}", omega[i], alpha[i], zeta[i], eta[i])
                });
            }
        }
    }
}

/// Outputs chosen at a point are those of its answer, whatever is chosen with them.
#[test]
fn chosen_outputs_are_those_of_the_answer() {
    let (omega, alpha) = points_and_others(600);
    let bits = |x: f64| if x.is_nan() { None } else { Some(x.to_bits()) };
    for (i, (&omega, &alpha)) in omega.iter().zip(&alpha).enumerate() {
        let Ok(ratios) = Ratios::new(omega, alpha) else { continue };
        let ratios = ratios.with_damping_ratio([0.0, 0.02, 0.6, 3.0][i % 4]).unwrap();
        let ratios = ratios.with_static_friction_ratio([1.0, 1.0, 1.3][i % 3]).unwrap();
        let due = Output::ALL.map(|output| output.of(&Response::new(ratios)).unwrap_or(f64::NAN));
        for (&one, &value) in Output::ALL.iter().zip(&due) {
            let [found] = Output::values([one], ratios);
            let [least, beside] = Output::values([Output::MinForceRatio, one], ratios);
            assert_eq!([found, beside].map(bits), [value; 2].map(bits), "{one} at {ratios:?}");
            assert_eq!(bits(least), bits(Border::of(&ratios).min_force_ratio), "{ratios:?}");
        }
    }
}

/// Outputs that are not requested are not written, and neither is the regime.
#[test]
fn columns_without_the_regime() {
    let (mut border, mut size) = ([0.0; 3], [0.0; 3]);
    let wanted = Batch::new().with(Output::Deviation, &mut size).with(Output::MinForceRatio, &mut border);
    // The last slice for an output counts.
    let mut deviation = [0.0; 3];
    let wanted = wanted.with(Output::Deviation, &mut deviation);
    wanted.run(&[0.7, 1.5, 0.4], &[2.0, 2.5, 6.0]).unwrap();
    assert_eq!(size, [0.0; 3]);
    assert!(border.iter().all(|b| *b > 0.0) && deviation[0].is_finite() && deviation[2].is_nan());
}

/// `.ci/run` runs this test again on a processor without AVX-512, with the name of the expected level.
#[test]
fn levels_are_those_of_the_processor() {
    let best = Level::best();
    assert_eq!(Batch::new().level(), best);
    assert!(best.is_available() && levels().next() == Some(Level::Scalar));
    if let Ok(due) = std::env::var("STICKSLIP_BEST_LEVEL") {
        assert_eq!(format!("{best:?}"), due);
    }
    // A level that is not available falls back to the portable loops.
    for level in Level::ALL {
        let due = if level.is_available() { level } else { Level::Portable };
        assert_eq!(Batch::new().at_level(level).level(), due);
    }
}

#[test]
fn the_length_of_a_slice_does_not_matter() {
    let (omega, alpha) = points(2000);
    for outputs in [LOOPED, THREE] {
        let whole = answer(Batch::new(), &omega, &alpha, outputs);
        for n in [0, 1, 2, 127, 128, 129, 300, 1024, 1100] {
            let part = answer(Batch::new(), &omega[700..700 + n], &alpha[700..700 + n], outputs);
            assert_eq!(part.regime[..], whole.regime[700..700 + n]);
            for (part, whole) in part.columns.iter().zip(&whole.columns) {
                assert_eq!(part[..], whole[700..700 + n]);
            }
        }
    }
}

#[test]
fn the_regime_is_that_of_the_point() {
    let (omega, alpha) = points_and_others(6000);
    let alone = |(&omega, &alpha)| Ratios::new(omega, alpha).ok().map(|at| Response::new(at).regime);
    let due: Vec<_> = omega.iter().zip(&alpha).map(alone).collect();
    for level in levels() {
        assert!(answer(Batch::new().at_level(level), &omega, &alpha, &[]).regime == due, "{level:?}");
    }
}

#[test]
fn rows_of_one_frequency() {
    let mut random = Random(5);
    // At 0.4 a batch leaves every point to the code for one point, whose K is rounded differently.
    for omega in [1e-4, 0.25, 0.250_001, 0.3, 0.4, 0.49, 0.5, 0.7, 1f64.next_up(), 1.0, 1.5, 2.0, 700.0, 1e9]
    {
        let border = Border::new(omega).unwrap().min_force_ratio;
        let mut alpha: Vec<_> = (0..300).map(|_| border * random.between(0.9, 4.0)).collect();
        alpha.extend([border, border.next_up(), border.next_down(), 0.5, f64::NAN, 1e300, -1.0]);
        alpha.extend([7.289_167_038_123_113_5, 10.280_271_693_591_125, 26.292_712_021_941_714]);
        let omegas = vec![omega; alpha.len()];
        for outputs in [&OUTPUTS[..], &FIVE, THREE] {
            let due = points_alone(&omegas, &alpha, outputs);
            for level in levels() {
                let found = answer(Batch::new().at_level(level), &omegas, &alpha, outputs);
                assert_same(&found, &due, |i| format!("{level:?} at {omega:e} {:e}", alpha[i]));
            }
        }
    }
}

#[cfg(feature = "rayon")]
#[test]
fn threads_change_nothing() {
    let (omega, alpha) = points(30_000);
    let (one, many) = (Batch::new, || Batch::new().on_threads());
    for outputs in [LOOPED, THREE] {
        assert!(answer(one(), &omega, &alpha, outputs) == answer(many(), &omega, &alpha, outputs));
    }
    // The same for outputs that are computed point by point.
    let (omegas, alphas) = (&omega[..3000], &alpha[..3000]);
    assert!(answer(one(), omegas, alphas, &OUTPUTS) == answer(many(), omegas, alphas, &OUTPUTS));
}
