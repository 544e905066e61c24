//! The closed forms at any precision: against 40 digits computed independently, and N bits against 2N.
#![cfg(feature = "mp")]

use std::collections::BTreeMap;
use stickslip::float::{AtPrecision, mp::Mp};
use stickslip::{Border, Float, Ratios, Response};

/// Every output at (Ω, α), by the names of `tests/data/points.csv`.
fn answers<F: Float>(omega: F, alpha: F) -> Vec<(&'static str, Option<F>)> {
    let response = Response::new(Ratios::new(omega, alpha).unwrap());
    let cycle = response.cycle().expect("every point is non-sticking");
    let border = response.border();
    vec![
        ("max_displacement", Some(cycle.max_displacement())),
        ("displacement_phase", Some(cycle.displacement_phase())),
        ("max_velocity", Some(cycle.max_velocity())),
        ("velocity_phase", Some(cycle.velocity_phase())),
        ("deviation", Some(cycle.deviation())),
        ("min_force_ratio", Some(border.min_force_ratio())),
        ("min_force_ratio_turning_point", Some(border.turning_point())),
        ("border_phase", Some(border.phase())),
        ("loop_size_stiffness", Some(cycle.loop_size_stiffness())),
        ("loop_size_inertia", Some(cycle.loop_size_inertia())),
        ("best_force_ratio", Some(response.best_force_ratio())),
        ("best_loop_size", response.best_loop_size()),
        ("contraction", Some(cycle.contraction())),
    ]
}

fn forty_digits<const L: usize>() {
    let mut lines = include_str!("data/points.csv").lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').skip(2).collect();
    let mut points = 0;
    for line in lines {
        let mut cells = line.split(',');
        let mut double = || Mp::<L>::from(cells.next().unwrap().parse::<f64>().unwrap());
        let (omega, alpha) = (double(), double());
        let expected: Vec<Option<Mp<L>>> = cells.map(|text| text.parse().ok()).collect();
        let answers = answers(omega, alpha);
        assert_eq!((answers.len(), expected.len()), (names.len(), names.len()));
        for (((name, answer), column), expected) in answers.into_iter().zip(&names).zip(expected) {
            assert_eq!(name, *column);
            let (Some(answer), Some(expected)) = (answer, expected) else {
                assert_eq!(answer.is_some(), expected.is_some_and(|x| x.is_finite()), "{name} at {line}");
                continue;
            };
            let scale = if expected.is_zero() { Mp::of_int(1) } else { expected.abs() };
            let error = (answer - expected).abs() / scale;
            assert!(error.to_f64() <= 1e-38, "{name} at ({omega}, {alpha}): {answer} for {expected}");
        }
        points += 1;
    }
    assert_eq!(points, 17);
}

#[test]
fn every_output_at_every_point_to_1e_38() {
    forty_digits::<3>();
    forty_digits::<4>();
    forty_digits::<64>();
}

/// Numbers in [0, 1), the same in every run.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        // Knuth's 64-bit linear congruential generator; its high bits.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// (Ω, α/α_min): the bands of Ω in turn, α from 1.05 of the border up to a thousand times it.
fn points(count: usize) -> impl Iterator<Item = (f64, f64)> {
    let mut uniform = Uniform(7);
    (0..count).map(move |i| {
        let omega = match i % 6 {
            0 => uniform.between(0.5, 1.0),
            1 => uniform.between(1.0, 2.0),
            2 => uniform.between(2.0, 50.0),
            3 => uniform.between(1.0 / 3.0, 0.5),
            4 => uniform.between(0.2, 0.25),
            _ => uniform.between(0.05, 1.0),
        };
        let over =
            if i % 2 == 0 { uniform.between(1.05, 3.0) } else { 1.05 * 10f64.powf(3.0 * uniform.next()) };
        (omega, over)
    })
}

/// All answers with guard bits, each rounded once.
struct Guarded<F>(F, F);

impl<F: Float> AtPrecision<F> for Guarded<F> {
    type Output = Vec<(&'static str, Option<F>)>;

    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> Self::Output {
        let all = answers(there(self.0), there(self.1));
        all.into_iter().map(|(name, answer)| (name, answer.map(&back))).collect()
    }
}

/// The largest error of each output of N limbs against D limbs, in the units of the design: the last place of the
/// output, of max(phase, 1) for a phase and of max(|Δ₁|, V₀) for the deviation.
fn worst<const N: usize, const D: usize>(
    count: usize,
    guarded: bool,
) -> BTreeMap<&'static str, (f64, String)> {
    let mut worst = BTreeMap::new();
    for (omega, over) in points(count) {
        let alpha = Border::new(omega).unwrap().min_force_ratio() * over;
        let (x, y) = (Mp::<N>::from(omega), Mp::<N>::from(alpha));
        let narrow = if guarded { Mp::guarded(Guarded(x, y)) } else { answers(x, y) };
        let wide = answers(Mp::<D>::from(omega), Mp::<D>::from(alpha));
        let speed = narrow.iter().find(|(name, _)| *name == "max_velocity").and_then(|(_, v)| *v).unwrap();
        for ((name, narrow), (_, wide)) in narrow.into_iter().zip(wide) {
            let (Some(narrow), Some(wide)) = (narrow, wide) else { panic!("{name} at ({omega}, {alpha})") };
            let least = match name {
                "displacement_phase" | "velocity_phase" | "border_phase" => Mp::of_int(1),
                "deviation" => speed,
                _ => Mp::ZERO,
            };
            let ulp = if narrow.abs() > least { narrow.ulp() } else { least.ulp() };
            let error = ((Mp::<D>::rounded(narrow) - wide) / Mp::rounded(ulp)).abs().to_f64();
            let entry = worst.entry(name).or_insert((0.0, String::new()));
            // Said so that NaN counts.
            let better = error <= entry.0;
            if !better {
                *entry = (error, format!("({omega}, {alpha})"));
            }
        }
    }
    assert_eq!(worst.len(), 13);
    worst
}

fn agrees<const N: usize, const D: usize>(count: usize) {
    for (name, (error, place)) in worst::<N, D>(count, true) {
        assert!(error <= 1.0, "{name} at {place}, {N} limbs: {error} units in the last place");
    }
}

#[test]
fn with_guard_bits_twice_the_precision_changes_nothing() {
    agrees::<1, 2>(4_000);
    agrees::<2, 4>(10_000);
    agrees::<4, 8>(10_000);
    agrees::<8, 16>(2_000);
    agrees::<16, 32>(500);
    agrees::<64, 128>(24);
}

#[test]
#[ignore = "prints the errors without guard bits"]
fn without_guard_bits() {
    for (name, (error, place)) in worst::<4, 8>(10_000, false) {
        println!("{name:30} {error:10.2} at {place}");
    }
}
