//! The closed forms at any precision: compared with 40 digits computed independently, and N bits with 2N.

mod den_hartog;

use super::reference::outputs;
use crate::random::Random;
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float, PhaseFunction, Ratios, Response};

/// Every output at (Ω, α), by the names of `tests/data/points.csv`.
fn answers<F: Float>(omega: F, alpha: F) -> Vec<(&'static str, Option<F>)> {
    outputs(&Response::new(Ratios::new(omega, alpha).unwrap()))
}

fn forty_digits<const L: usize>() {
    let mut lines = include_str!("../data/points.csv").lines();
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
            let scale = if expected == Mp::ZERO { Mp::from(1) } else { expected.abs() };
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

/// (Ω, α/α_min): the bands of Ω in turn, with α from 1.05 to a thousand times the border.
fn points(count: usize) -> impl Iterator<Item = (f64, f64)> {
    let mut random = Random(7);
    (0..count).map(move |i| {
        let omega = match i % 6 {
            0 => random.between(0.5, 1.0),
            1 => random.between(1.0, 2.0),
            2 => random.between(2.0, 50.0),
            3 => random.between(1.0 / 3.0, 0.5),
            4 => random.between(0.2, 0.25),
            _ => random.between(0.05, 1.0),
        };
        let over =
            if i % 2 == 0 { random.between(1.05, 3.0) } else { 1.05 * 10f64.powf(3.0 * random.next()) };
        (omega, over)
    })
}

/// The errors of each output at N limbs compared with D limbs, in units in the last place of the output, of
/// max(phase, 1) for a phase, and of max(|Δ₁|, V₀) for the deviation.
fn errors<const N: usize, const D: usize>(
    omega: Mp<N>,
    alpha: Mp<N>,
    guarded: bool,
) -> Vec<(&'static str, f64)> {
    let ratios = Ratios::new(omega, alpha).unwrap();
    let narrow = outputs(&if guarded { Response::guarded(ratios) } else { Response::new(ratios) });
    let wide = answers(Mp::<D>::rounded(omega), Mp::<D>::rounded(alpha));
    assert_eq!((narrow.len(), wide.len()), (13, 13));
    let speed = narrow.iter().find(|(name, _)| *name == "max_velocity").and_then(|(_, v)| *v).unwrap();
    let pairs = narrow.into_iter().zip(wide).filter(|((_, a), (_, b))| a.is_some() || b.is_some());
    pairs
        .map(|((name, narrow), (_, wide))| {
            let (Some(narrow), Some(wide)) = (narrow, wide) else { panic!("{name} at ({omega}, {alpha})") };
            let least = match name {
                "displacement_phase" | "velocity_phase" | "border_phase" => Mp::from(1),
                "deviation" => speed,
                _ => Mp::ZERO,
            };
            let ulp = if narrow.abs() > least { narrow.ulp() } else { least.ulp() };
            (name, ((Mp::<D>::rounded(narrow) - wide) / Mp::rounded(ulp)).abs().to_f64())
        })
        .collect()
}

/// (Ω, α) at `count` ordinary points.
fn ordinary<const N: usize>(count: usize) -> impl Iterator<Item = (Mp<N>, Mp<N>)> {
    points(count).map(|(omega, over)| {
        let alpha = Border::new(omega).unwrap().min_force_ratio * over;
        (omega.into(), alpha.into())
    })
}

/// Without optimisation numbers of 8192 bits exceed the stack of a test's thread.
fn with_more_stack(test: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(1 << 25).spawn(test).unwrap().join().unwrap();
}

/// Every output has an error of at most one unit in the last place.
fn agrees<const N: usize, const D: usize>(places: impl Iterator<Item = (Mp<N>, Mp<N>)>) {
    for (omega, alpha) in places {
        for (name, error) in errors::<N, D>(omega, alpha, true) {
            assert!(error <= 1.0, "{name} at ({omega}, {alpha}), {N} limbs: {error} units in the last place");
        }
    }
}

#[test]
fn with_guard_bits_twice_the_precision_changes_nothing() {
    agrees::<1, 2>(ordinary(4_000));
    agrees::<2, 4>(ordinary(10_000));
    agrees::<4, 8>(ordinary(10_000));
    agrees::<8, 16>(ordinary(2_000));
    agrees::<16, 32>(ordinary(500));
    with_more_stack(|| agrees::<64, 128>(ordinary(24)));
}

/// Ω = 1/n ± 2⁻ᵏ with α at 1.0001, 1.05 and 3 times the border.
fn beside<const N: usize>(n: &[i32], k: &[i32]) -> Vec<(Mp<N>, Mp<N>)> {
    let mut places = Vec::new();
    for &n in n {
        for &k in k {
            for sign in [-1, 1] {
                let omega = Mp::ratio(1, n) + Mp::from(sign).scale2(-k);
                let border = Border::new(omega).unwrap().min_force_ratio;
                places.extend([20_002, 21_000, 60_000].map(|over| (omega, border * Mp::ratio(over, 20_000))));
            }
        }
    }
    places
}

#[test]
fn beside_the_natural_frequency_and_its_fractions() {
    // The poles of T and K are at odd n, the zeros of K at even n.
    let n = [1, 2, 3, 4, 5, 6];
    agrees::<4, 8>(beside(&n, &[5, 10, 20, 30, 45, 60, 100, 150]).into_iter());
    agrees::<8, 16>(beside(&n, &[100, 200, 240]).into_iter());
    // Closer than the exponents of f64 can represent. The border near a pole is then outside the domain.
    agrees::<32, 64>(beside(&[1, 2, 4], &[600, 1100, 1900]).into_iter());
}

/// Both precisions could agree on a smaller maximum: no point of the cycle is faster than V₀, up to `2^slack`
/// units.
fn nothing_is_faster<const N: usize>(places: &[(Mp<N>, Mp<N>)], slack: i32, samples: i32) {
    for &(omega, alpha) in places {
        let cycle = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
        let greatest = cycle.max_velocity * (Mp::from(1) + Mp::epsilon().scale2(slack));
        for i in 0..samples {
            let phase = Mp::pi() * Mp::ratio(2 * i, samples);
            let velocity = cycle.velocity_at(phase);
            assert!(velocity <= greatest, "({omega}, {alpha}) at {phase}: {velocity}");
        }
    }
}

#[test]
fn the_maximum_velocity_is_the_greatest() {
    nothing_is_faster::<4>(&beside(&[1, 2, 3, 4, 5, 6], &[20, 45, 58, 61, 64, 100, 150]), 20, 200);
    // Closer to 1 than the exponents of f64 can represent, and so close to the border that Δ₀/B is of order
    // one.
    let places = [-1, 1].map(|sign| {
        let omega = Mp::<64>::from(1) + Mp::from(sign).scale2(-1100);
        let width = Mp::from(3) * (Mp::from(1) - omega);
        (omega, PhaseFunction::new(omega).unwrap().value().hypot(width))
    });
    nothing_is_faster(&places, 40, 20);
}

/// Without guard bits, no output loses more units in the last place than this over the ordinary points. The
/// contraction behaves like a square root at its double root.
const PLAIN: [(&str, f64); 13] = [
    ("max_displacement", 1.0),
    ("displacement_phase", 3.0),
    ("max_velocity", 4.0),
    ("velocity_phase", 8.0),
    ("deviation", 8.0),
    ("min_force_ratio", 1.0),
    ("min_force_ratio_turning_point", 1.0),
    ("border_phase", 3.0),
    ("loop_size_stiffness", 1.0),
    ("loop_size_inertia", 1.0),
    ("best_force_ratio", 1.0),
    ("best_loop_size", 1.0),
    ("contraction", 40.0),
];

/// The worst error of each output without guard bits; each must be below its limit.
fn plain<const N: usize, const D: usize>(count: usize) -> [f64; PLAIN.len()] {
    let mut worst = [0.0; PLAIN.len()];
    for (omega, alpha) in ordinary(count) {
        let errors = errors::<N, D>(omega, alpha, false);
        for ((name, error), ((known, limit), worst)) in
            errors.into_iter().zip(PLAIN.into_iter().zip(&mut worst))
        {
            assert_eq!(name, known);
            assert!(
                error <= limit,
                "{name} at ({omega}, {alpha}), {N} limbs: {error} units in the last place"
            );
            *worst = error.max(*worst);
        }
    }
    worst
}

#[test]
fn without_guard_bits_the_last_digits_are_rounding() {
    // A limit that is never approached would be obsolete.
    for ((name, limit), worst) in PLAIN.into_iter().zip(plain::<4, 8>(10_000)) {
        assert!(worst > limit / 4.0, "{name}: {worst} units in the last place");
    }
    // Widths whose computation starts from f64, and from just over a quarter of their bits.
    plain::<2, 4>(2_000);
    plain::<3, 6>(2_000);
    plain::<16, 32>(500);
    with_more_stack(|| {
        plain::<64, 128>(20);
    });
}

/// Errors of K have the greatest effect close to Ω = 1, at the border and above.
#[test]
fn without_guard_bits_no_digit_is_lost_to_cancellation() {
    let places = (3..40).flat_map(|k| {
        let step = 0.5f64.powi(k);
        [1.0 - step, 1.0 + step].into_iter().flat_map(|omega| {
            let border = Border::new(Mp::<8>::from(omega)).unwrap().min_force_ratio.to_f64() * (1.0 + 1e-15);
            [0.0, 1e-9, 1e-4, 0.1].map(|over| (omega, border * (1.0 + over)))
        })
    });
    for (omega, alpha) in places.chain([(0.998_509_518_941_758, 1.272_291_851_270_964_7)]) {
        let errors = errors::<4, 8>(omega.into(), alpha.into(), false);
        for (name, error) in errors.into_iter().filter(|(name, _)| PLAIN.iter().any(|p| p == &(*name, 1.0))) {
            assert!(error <= 1.0, "{name} at ({omega:?}, {alpha:?}): {error} units in the last place");
        }
    }
}
