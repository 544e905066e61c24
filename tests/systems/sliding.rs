//! Steady sliding on travelling sides, beside closed forms and the roots that another program found.

use crate::compared::Origin::{AnotherProgram, ByHand};
use crate::compared::near;
use crate::generator::Random;
use stickslip::system::{Element, Kind, Law, Model, Normal, Signal, State, System};

/// A contact along `direction` with a normal load by displacement, whose other side travels.
fn pad(direction: &[f64], coefficient: f64, normal: &[f64], speed: f64) -> Element<f64> {
    Element {
        name: "pad".into(),
        direction: direction.to_vec(),
        moves: Signal::constant(speed),
        kind: Kind::Contact {
            law: Law::constant(coefficient),
            peak: 1.0,
            normal: Some(Normal {
                signal: Signal::constant(1.0),
                displacement: normal.to_vec(),
                velocity: vec![],
            }),
        },
    }
}

fn rows<const N: usize>(matrix: [[f64; N]; N]) -> Vec<Vec<f64>> {
    matrix.into_iter().map(Vec::from).collect()
}

fn close(found: f64, due: f64, by: f64) {
    assert!((found - due).abs() <= by * due.abs().max(1e-3), "{found} {due}");
}

fn squeal(coefficient: f64, damping: f64) -> System<f64> {
    System::new(&Model {
        mass: rows([[1.0, 0.0], [0.0, 1.0]]),
        damping: rows([[damping, 0.0], [0.0, damping]]),
        stiffness: rows([[7.0, -2.0], [-2.0, 5.0]]),
        elements: vec![pad(&[1.0, 0.0], coefficient, &[0.0, -3.0], 5.0)],
        ..Model::default()
    })
    .unwrap()
}

/// Mode coupling of two coordinates. The numbers are the eigenvalues by NumPy; the threshold without dampers is 5/6.
#[test]
fn two_modes_couple() {
    for (coefficient, frequencies, growth) in [
        (0.7, [2.259_551_46, 2.625_724_13], -0.01),
        (0.84, [2.449_829_83; 2], 0.030_819_501_660_8),
        (1.2, [2.467_854_82; 2], 0.290_514_374_424_3),
    ] {
        let system = squeal(coefficient, 0.02);
        for (own, due) in system.natural_frequencies(&[]).into_iter().zip(frequencies) {
            near("fn system::System::natural_frequencies", own, due, AnotherProgram, 1e-8);
        }
        let found = system.sliding().unwrap();
        near("fn system::System::sliding", found.growth, growth, AnotherProgram, 1e-9);
        let threshold = found.threshold.unwrap();
        close(threshold.factor * coefficient, 0.833_733_333_333_333, 1e-12);
        close(threshold.frequency, 2.449_489_742_783, 1e-9);
    }
    close(squeal(0.7, 0.0).sliding().unwrap().threshold.unwrap().factor * 0.7, 5.0 / 6.0, 1e-10);
    assert_eq!(squeal(0.7, 0.0).sliding().unwrap().growth, 0.0);
    // At rest the pad leaves one frequency, without friction.
    close(squeal(0.7, 0.0).natural_frequencies(&[0])[0], 5f64.sqrt(), 1e-12);
}

/// A mass on two inclined springs, pressed on a belt by a third one (Hoffmann, Fischer, Allgaier and Gaul, 2002): with `K` of
/// the springs and k₃ that of the contact, the frequencies coalesce at `µ = [(K₁₁ − K₂₂)²/4 + K₁₂²]/(K₁₂ k₃)`. With dampers the
/// growth begins where Hurwitz's determinant of the characteristic polynomial is zero. And where `det K` is, it does not
/// oscillate.
#[test]
fn the_minimal_model_of_mode_coupling() {
    let mut random = Random(5);
    let [mut fluttering, mut diverging] = [0; 2];
    for i in 0..200 {
        let mut k = [[0.0; 2]; 2];
        for _ in 0..2 {
            let (size, angle) = (random.between(0.5, 2.0), random.between(0.1, 3.0));
            let (sin, cos) = f64::sin_cos(angle);
            let by = [[size * cos * cos, size * sin * cos], [size * sin * cos, size * sin * sin]];
            k.iter_mut().flatten().zip(by.as_flattened()).for_each(|(x, by)| *x += by);
        }
        let contact = random.between(0.5, 2.0);
        k[1][1] += contact;
        // A belt that travels forwards drags the mass forwards, the more the higher the load N = 1 − k₃ y.
        let (mass, dampers) =
            (random.between(0.5, 2.0), [random.between(0.01, 0.1), random.between(0.01, 0.1)]);
        let is_damped = i % 2 == 1;
        let c = if is_damped { dampers } else { [0.0; 2] };
        let system = System::new(&Model {
            mass: rows([[mass, 0.0], [0.0, mass]]),
            damping: rows([[c[0], 0.0], [0.0, c[1]]]),
            stiffness: rows(k),
            elements: vec![pad(&[1.0, 0.0], 0.5, &[0.0, -contact], 3.0)],
            ..Model::default()
        })
        .unwrap();
        // K₁₂ + mu k₃ in place of K₁₂ in the first row.
        let upper = |mu: f64| k[0][1] + mu * contact;
        let of_flutter = |mu: f64| {
            if !is_damped {
                return 0.25 * (k[0][0] - k[1][1]).powi(2) + upper(mu) * k[1][0];
            }
            let [a, b] = c.map(|c| c / mass);
            let [p, q] = [k[0][0] / mass, k[1][1] / mass];
            let (a1, a2) = (a * q + b * p, p + q + a * b);
            let (a0, a3) = (p * q - upper(mu) * k[1][0] / mass.powi(2), a + b);
            a1 * a2 * a3 - a1 * a1 - a0 * a3 * a3
        };
        let of_divergence = |mu: f64| k[0][0] * k[1][1] - upper(mu) * k[1][0];
        let found = system.sliding().unwrap().threshold;
        let Some(found) = found else {
            // Both are straight in mu.
            assert!(of_flutter(9.99) > 0.0 && of_divergence(9.99) > 0.0, "{i}");
            continue;
        };
        let mu = 0.5 * found.factor;
        let first = if found.frequency > 0.0 { &of_flutter as &dyn Fn(f64) -> f64 } else { &of_divergence };
        let zero = -first(0.0) / (first(mu) - first(0.0)) * mu;
        near("fn system::System::sliding", mu, zero, ByHand, if is_damped { 1e-9 } else { 1e-8 });
        for at in [of_flutter(0.999 * mu), of_divergence(0.999 * mu)] {
            assert!(at > 0.0, "{i} {mu}");
        }
        if found.frequency > 0.0 { fluttering += 1 } else { diverging += 1 }
    }
    assert!(fluttering > 40 && diverging > 10, "{fluttering} {diverging}");
}

/// Three masses: a pad between two of them on a side that travels, and a falling law on a belt, which feeds as a damper of
/// −0.25. The roots are those of NumPy.
#[test]
fn a_pad_beside_a_falling_law() {
    let belt = Element {
        name: "belt".into(),
        direction: vec![0.0, 0.0, 1.0],
        moves: Signal::constant(2.0),
        kind: Kind::Contact {
            law: Law { points: vec![(0.0, 9.0), (1.0, 8.0), (3.0, 7.5)] },
            peak: 1.0,
            normal: None,
        },
    };
    let system = System::new(&Model {
        mass: rows([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]]),
        damping: rows([[0.3, -0.1, 0.0], [-0.1, 0.2, -0.05], [0.0, -0.05, 0.4]]),
        stiffness: rows([[900.0, -400.0, 0.0], [-400.0, 1100.0, -300.0], [0.0, -300.0, 800.0]]),
        elements: vec![pad(&[1.0, -1.0, 0.0], 0.45, &[0.0, 250.0, -120.0], -2.0), belt],
        ..Model::default()
    })
    .unwrap();
    let found = system.sliding().unwrap();
    close(found.growth, -0.022_558_502_197_6, 1e-10);
    close(found.frequency, 14.562_743_014_66, 1e-10);
    let threshold = found.threshold.unwrap();
    close(threshold.factor, 3.627_683_612_610_77, 1e-10);
    close(threshold.frequency, 23.071_096_661_446, 1e-8);
    for (own, due) in
        system.natural_frequencies(&[]).into_iter().zip([14.562_752_55, 19.725_619_35, 33.211_336_16])
    {
        close(own, due, 1e-8);
    }
}

/// The exact motion near the equilibrium grows as the roots say.
#[test]
fn a_small_disturbance_grows_at_the_stated_rate() {
    let system = squeal(0.84, 0.02);
    let found = system.sliding().unwrap();
    // N = 1 − 3 q₂, T = −µ N, K q = (µ N, 0): the equilibrium.
    let (mu, k) = (0.84, [[7.0, -2.0 + 3.0 * 0.84], [-2.0, 5.0]]);
    let det = k[0][0] * k[1][1] - k[0][1] * k[1][0];
    let rest = [k[1][1] * mu / det, -k[1][0] * mu / det];
    let start = State { displacement: vec![rest[0] + 1e-6, rest[1]], ..State::rest(2) };
    // Turns of the one frequency apart, the disturbance is multiplied by the growth alone.
    let turn = std::f64::consts::TAU / found.frequency;
    let states = system.states(&start, &[20.0 * turn, 60.0 * turn]).unwrap();
    let off = |state: &State<f64>| state.displacement[0] - rest[0];
    let rate = (off(&states[1]) / off(&states[0])).ln() / (40.0 * turn);
    // The other pair has decayed to 0.09 and 0.0008 of it.
    close(rate, found.growth, 0.05);
    let plain =
        Model { mass: rows([[1.0]]), damping: rows([[0.0]]), stiffness: rows([[1.0]]), ..Model::default() };
    assert_eq!(System::new(&plain).unwrap().sliding(), None);
}

/// A stiffness that is given unsymmetric has the frequencies of its own roots: 1 ± i, (3, 5), and −1 among them.
#[test]
fn an_unsymmetric_stiffness_has_its_own_frequencies() {
    let of = |stiffness: [[f64; 2]; 2]| {
        let zero = rows([[0.0; 2]; 2]);
        let model = Model {
            mass: rows([[1.0, 0.0], [0.0, 1.0]]),
            damping: zero,
            stiffness: rows(stiffness),
            ..Model::default()
        };
        System::new(&model).unwrap().natural_frequencies(&[])
    };
    for (stiffness, due) in [
        ([[1.0, 1.0], [-1.0, 1.0]], [(0.5 + 0.5f64.sqrt()).sqrt(); 2]),
        ([[3.0, 7.0], [0.0, 5.0]], [3f64.sqrt(), 5f64.sqrt()]),
        ([[-1.0, 7.0], [0.0, 4.0]], [-1.0, 2.0]),
    ] {
        for (own, due) in of(stiffness).into_iter().zip(due) {
            close(own, due, 1e-12);
        }
    }
}
