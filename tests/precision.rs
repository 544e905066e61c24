//! The closed forms at any precision: against 40 digits computed independently, and N bits against 2N.
#![cfg(feature = "mp")]

use stickslip::float::mp::Mp;
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

/// The largest error of each output of `N` limbs, in units in the last place, against `D` limbs.
fn worst<const N: usize, const D: usize>(count: usize) -> Vec<(&'static str, f64, f64, f64)> {
    let mut worst: Vec<(&'static str, f64, f64, f64)> = Vec::new();
    for (omega, over) in points(count) {
        let alpha = Border::new(omega).unwrap().min_force_ratio() * over;
        let narrow = answers(Mp::<N>::from(omega), Mp::<N>::from(alpha));
        let wide = answers(Mp::<D>::from(omega), Mp::<D>::from(alpha));
        let speed = narrow[2].1.unwrap();
        for (i, ((name, narrow), (_, wide))) in narrow.into_iter().zip(wide).enumerate() {
            let (Some(narrow), Some(wide)) = (narrow, wide) else { panic!("{name} at ({omega}, {alpha})") };
            let ulp = match name {
                _ if name.ends_with("phase") => {
                    if narrow > Mp::of_int(1) {
                        narrow.ulp()
                    } else {
                        Mp::epsilon()
                    }
                }
                "deviation" => {
                    if narrow.abs() > speed {
                        narrow.ulp()
                    } else {
                        speed.ulp()
                    }
                }
                _ => narrow.ulp(),
            };
            let error = ((Mp::<D>::rounded(narrow) - wide).abs() / Mp::rounded(ulp)).to_f64();
            if worst.len() <= i {
                worst.push((name, 0.0, 0.0, 0.0));
            }
            if error > worst[i].1 || error.is_nan() {
                worst[i] = (name, error, omega, over);
            }
        }
    }
    worst
}

#[test]
fn measure() {
    for (name, error, omega, over) in worst::<4, 8>(3000) {
        println!("{name:30} {error:10.3} at {omega} {over}");
    }
}
