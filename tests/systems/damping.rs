//! Damping by modes beside mpmath's and SciPy's, and closed forms of two masses.

use crate::compared::Origin::{AnotherProgram, ByHand};
use crate::compared::{compared, near};
use serde_json::Value;
use std::str::FromStr;
use stickslip::Float;
use stickslip::system::{Error, Model, Moved, MovedBy, Signal, State, System};

/// A case of another program: its name, its model, the ratios and C.
type Case<F> = (String, Model<F>, Vec<F>, Vec<Vec<F>>);

/// The cases of `tests/data/damping_by_modes.json`, in numbers of any precision.
fn cases<F: Float + FromStr + Default>() -> Vec<Case<F>> {
    let all: Value = serde_json::from_str(include_str!("../data/damping_by_modes.json")).unwrap();
    let list = |value: &Value| -> Vec<F> {
        let number = |x: &Value| x.as_str().unwrap().parse().ok().unwrap();
        value.as_array().unwrap().iter().map(number).collect()
    };
    let rows = |value: &Value| -> Vec<Vec<F>> { value.as_array().unwrap().iter().map(list).collect() };
    let case = |case: &Value| {
        let mass = rows(&case["mass"]);
        let zeros = vec![vec![F::int(0); mass.len()]; mass.len()];
        let moved = case["moved"].as_array().unwrap().iter().map(|place| Moved {
            coordinate: usize::try_from(place.as_u64().unwrap()).unwrap(),
            by: MovedBy::Velocity,
            signal: Signal::constant(F::int(0)),
        });
        let model = Model {
            mass,
            damping: zeros,
            stiffness: rows(&case["stiffness"]),
            moved: moved.collect(),
            ..Model::default()
        };
        (case["name"].as_str().unwrap().to_owned(), model, list(&case["ratios"]), rows(&case["damping"]))
    };
    all.as_array().unwrap().iter().map(case).collect()
}

/// The entries within a part of the greatest. The rounding of n products of M^(−1/2) K M^(−1/2) changes its root by ω_max/ω_min times as much, at
/// most 40 here.
fn are_those_of_others<F: Float + FromStr + Default>(part: f64) {
    for (name, model, ratios, due) in cases::<F>() {
        let found = model.with_damping_ratios(&ratios).unwrap_or_else(|e| panic!("{name}: {e}")).damping;
        let most = due.iter().flatten().fold(0.0, |most: f64, x| most.max(x.to_f64().abs()));
        for (i, (own, others)) in found.iter().zip(&due).enumerate() {
            for (j, (&x, &y)) in own.iter().zip(others).enumerate() {
                let by = (x - y).to_f64().abs();
                assert!(by <= part * most, "{name} ({i}, {j}): {x} for {y}, off by {by:e}");
                let bound = (part * most).max(f64::EPSILON * y.to_f64().abs());
                compared(
                    "fn system::Model::with_damping_ratios",
                    x.to_f64(),
                    y.to_f64(),
                    AnotherProgram,
                    bound,
                );
                assert!(found[j][i] == x, "{name}: not symmetric");
            }
        }
    }
}

#[test]
fn damping_by_modes_is_that_of_another_program() {
    assert_eq!(cases::<f64>().len(), 9);
    are_those_of_others::<f64>(1e-12);
}

#[cfg(feature = "mp")]
#[test]
fn damping_by_modes_has_any_number_of_digits() {
    are_those_of_others::<stickslip::float::Mp<2>>(1e-35);
}

fn two(stiffness: [[f64; 2]; 2]) -> Model<f64> {
    Model {
        mass: vec![vec![2.0, 0.0], vec![0.0, 2.0]],
        damping: vec![vec![0.0; 2]; 2],
        stiffness: stiffness.map(Vec::from).to_vec(),
        ..Model::default()
    }
}

/// Two masses m on three springs k: ω₁² = k/m in phase, ω₂² = 3k/m against each other, and each decays as one mass with ζ.
#[test]
fn two_masses_decay_in_closed_form() {
    let model = two([[10.0, -5.0], [-5.0, 10.0]]);
    let ratios = [0.03, 0.2];
    for (both, omega, zeta) in [(1.0, 2.5_f64.sqrt(), ratios[0]), (-1.0, 7.5_f64.sqrt(), ratios[1])] {
        let system = System::new(&model.clone().with_damping_ratios(&ratios).unwrap()).unwrap();
        let start = State { displacement: vec![1.0, both], ..State::rest(2) };
        for time in [0.5, 2.0, 7.0] {
            let end = system.simulate(&start, time).unwrap().end;
            let damped = omega * (1.0 - zeta * zeta).sqrt();
            let (sin, cos) = (damped * time).sin_cos();
            let due = (-zeta * omega * time).exp() * (cos + zeta * omega / damped * sin);
            assert!(
                (end.displacement[0] - due).abs() < 1e-13 && (end.displacement[1] - both * due).abs() < 1e-13
            );
        }
    }
    // Rayleigh's factors that give these ratios: ζ = (a/ω + b ω)/2.
    let (one, two) = (2.5_f64.sqrt(), 7.5_f64.sqrt());
    let b = 2.0 * (ratios[1] * two - ratios[0] * one) / (7.5 - 2.5);
    let a = 2.0 * ratios[0] * one - b * 2.5;
    let [by_ratios, by_factors] = [model.clone().with_damping_ratios(&ratios), model.with_rayleigh(a, b)];
    let (by_ratios, by_factors) = (by_ratios.unwrap().damping, by_factors.unwrap().damping);
    for (x, y) in by_ratios.iter().flatten().zip(by_factors.iter().flatten()) {
        assert!((x - y).abs() < 1e-14, "{x} for {y}");
    }
    // In phase the dampers give 2 ζ₁ω₁ m, against each other 2 ζ₂ω₂ m.
    let (sum, difference) = (ratios[0] * one + ratios[1] * two, ratios[0] * one - ratios[1] * two);
    for (own, due) in by_factors[0].iter().zip([2.0 * sum, 2.0 * difference]) {
        near("fn system::Model::with_rayleigh", *own, due, ByHand, 1e-14);
    }
}

/// Given dampers stay, and a motion that strains nothing is not damped: along it C is the one that was given.
#[test]
fn dampers_that_are_given_stay() {
    let mut model = two([[5.0, -5.0], [-5.0, 5.0]]);
    model.damping = vec![vec![0.5, 0.0], vec![0.0, 0.0]];
    // ω² = 2k/m = 5 and g = √m/√2 (1, −1): 2 ζ ω g gᵀ.
    let share = 2.0 * 0.1 * 5.0_f64.sqrt();
    let found = model.with_damping_ratios(&[0.1]).unwrap().damping;
    for (own, due) in found.iter().flatten().zip([0.5 + share, -share, -share, share]) {
        assert!((own - due).abs() < 1e-14);
    }
    // A direction of negative stiffness has no damping either: one of the two modes has.
    let model = two([[-1.0, 0.0], [0.0, 8.0]]);
    let found = model.clone().with_damping_ratios(&[0.25]).unwrap().damping;
    for (own, due) in found.iter().flatten().zip([0.0, 0.0, 0.0, 2.0]) {
        assert!((own - due).abs() < 1e-14);
    }
    let many = model.with_damping_ratios(&[0.25, 0.3]).unwrap_err();
    assert_eq!(many, Error::TooMany { name: "damping ratios".into(), found: 2, most: 1 });
}

#[test]
fn wrong_damping_is_named() {
    let good = || two([[10.0, -5.0], [-5.0, 10.0]]);
    let uneven = two([[10.0, -5.0], [-4.0, 10.0]]);
    let mut loose = two([[-5.0, 5.0], [5.0, 5.0]]);
    loose.mass[0][0] = 0.0;
    let mut negative = good();
    negative.mass[1][1] = -2.0;
    let mut short = good();
    short.damping.clear();
    for (found, due) in [
        (good().with_damping_ratios(&[]), "damping ratios has 0 entries, but must have 1"),
        (good().with_damping_ratios(&[0.1, -0.1]), "damping ratios = -0.1 must be ≥ 0"),
        (good().with_damping_ratios(&[f64::NAN]), "damping ratios = NaN must be finite"),
        (good().with_damping_ratios(&[0.1; 3]), "damping ratios: 3 of them, must be ≤ 2"),
        (good().with_rayleigh(f64::INFINITY, 0.0), "rayleigh: a = inf must be finite"),
        (good().with_rayleigh(0.0, f64::NAN), "rayleigh: b = NaN must be finite"),
        (uneven.with_damping_ratios(&[0.1]), "stiffness: entry (2, 1) = -4 must equal entry (1, 2) = -5"),
        (
            loose.with_damping_ratios(&[0.1]),
            "coordinate 1 must be held by springs, because it has no mass and modes have a damping ratio",
        ),
        (negative.with_damping_ratios(&[0.1]), "mass must be positive definite: pivot 2 is -2"),
        (short.with_rayleigh(0.1, 0.1), "damping has 0 entries, but must have 2"),
    ] {
        assert_eq!(found.unwrap_err().to_string(), due);
    }
}
