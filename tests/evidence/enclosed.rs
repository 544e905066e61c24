//! Guaranteed digits beside motions at 40 digits by another program, tests/data/enclosed.py: every ball contains its
//! reference.

use crate::compared::{Origin::AnotherProgram, recorded};
use serde_json::Value;
use stickslip::enclosed::{self, Enclosure, Known};
use stickslip::float::Mp;
use stickslip::motion::record::{Body, Entry, Record};
use stickslip::{Error, Excitation, Field, Output};

const REFERENCES: &str = include_str!("../data/enclosed.json");

fn cases(kind: &str) -> Vec<Value> {
    let all: Value = serde_json::from_str(REFERENCES).unwrap();
    all[kind].as_array().unwrap().clone()
}

/// A number of the file, which is a binary fraction.
fn number<const N: usize>(value: &Value) -> Mp<N> {
    Mp::from(value.as_f64().unwrap())
}

/// Holds a ball against 40 digits: it contains them, or misses them by their own rounding only.
fn hold(of: &str, name: &str, ball: &Enclosure, digits: &Value, case: &Value) {
    let reference: Mp<4> = digits.as_str().unwrap().parse().unwrap();
    let middle = Mp::<4>::from(&ball.mid);
    let rad = Mp::<4>::from(&ball.rad);
    let room = rad + (reference.abs() + Mp::from(1e-3)) * Mp::from(1e-38);
    let off = (reference - middle).abs();
    assert!(off <= room, "{name}: {ball} and {digits} of {case}");
    assert!(rad <= (reference.abs() + Mp::from(1e-3)) * Mp::from(1e-12), "{name}: ± {rad} of {case}");
    recorded(&format!("--enclose {of}"), &ball.to_string(), digits, AnotherProgram, 0.0);
}

#[test]
fn records_contain_their_references() {
    let (mut answers, mut unproved) = (0, 0);
    let all = cases("records");
    for case in &all {
        let of = |name: &str| number::<17>(&case[name]);
        let excitation = match case["kind"].as_str().unwrap() {
            "force" => Excitation::Force,
            "surface" => Excitation::SurfaceAcceleration,
            "foot" => Excitation::FootMotion,
            _ => Excitation::DampedFootMotion,
        };
        let body = Body::new(of("mass"), of("friction"))
            .and_then(|body| body.with_stiffness(of("stiffness")))
            .and_then(|body| body.with_damping(of("damping")))
            .and_then(|body| body.with_static_friction_ratio(of("static_friction_ratio")))
            .unwrap();
        let samples = case["samples"].as_array().unwrap().iter().map(number).collect();
        let record = Record::new(excitation, of("time_step"), samples).unwrap();
        let [x, v] = [0, 1].map(|i| number(&case["start"][i]));
        let found = match enclosed::follow(&body, &record, x, v, 64) {
            Ok(found) => found,
            Err(Error::UncertainEvent { .. }) => {
                unproved += 1;
                continue;
            }
            Err(e) => panic!("{e} of {case}"),
        };
        for (name, _, entry) in found.entries() {
            let reference = &case["answer"][name];
            match entry {
                Entry::Count(count) => assert_eq!(reference.as_u64(), Some(count), "{name} of {case}"),
                Entry::Value(Some(ball)) => hold("record", name, ball, reference, case),
                Entry::Value(None) => assert!(reference.is_null(), "{name} of {case}"),
            }
            answers += 1;
        }
    }
    // A start exactly on a bound, or an extreme that is reached twice, is undecided.
    assert!(unproved * 10 < all.len() && answers > 4000, "{unproved} {answers}");
}

fn known(value: &Value) -> Known {
    Known::exactly(number::<2>(value)).unwrap()
}

#[test]
fn steady_states_contain_their_references() {
    let (mut proved, mut sticking) = (0, 0);
    for case in cases("steady") {
        let [omega, alpha, zeta] = ["omega", "alpha", "damping_ratio"].map(|name| known(&case[name]));
        let answer = &case["answer"];
        let Ok(steady) = enclosed::KnownRatios::new(&omega)
            .with_force_ratio(&alpha)
            .with_damping_ratio(&zeta)
            .steady(64)
            .unwrap()
        else {
            continue;
        };
        proved += 1;
        sticking += u32::from(steady.sticks_per_cycle > 0);
        hold("steady", "max_displacement", &steady.max_displacement, &answer["max_displacement"], &case);
        hold("steady", "max_velocity", &steady.max_velocity, &answer["max_velocity"], &case);
        hold("steady", "stick_fraction", &steady.stick_fraction, &answer["stick_fraction"], &case);
        for (ball, name) in
            [(&steady.min_displacement, "max_displacement"), (&steady.min_velocity, "max_velocity")]
        {
            let mut mirror = ball.clone();
            mirror.mid = -mirror.mid;
            hold("steady", name, &mirror, &answer[name], &case);
        }
        assert_eq!(answer["sticks_per_cycle"].as_u64(), Some(steady.sticks_per_cycle.into()), "{case}");
        let zeros = steady.velocity_zeros_per_cycle;
        assert_eq!(answer["velocity_zeros_per_cycle"].as_u64(), Some(zeros.into()), "{case}");
    }
    assert!(proved > 30 && sticking > 8, "{proved} {sticking}");
}

#[test]
fn responses_contain_their_references() {
    let mut compared = 0;
    for case in cases("steady") {
        let [omega, alpha, zeta] = ["omega", "alpha", "damping_ratio"].map(|name| known(&case[name]));
        let answer = &case["answer"];
        let is_free = answer["sticks_per_cycle"] == 0 && answer["velocity_zeros_per_cycle"] == 2;
        let found = enclosed::KnownRatios::new(&omega)
            .with_force_ratio(&alpha)
            .with_damping_ratio(&zeta)
            .response(64)
            .unwrap();
        assert_eq!(found.get(Output::MaxDisplacement).is_some(), is_free, "{case}");
        // The border is above the force ratio where the motion stops, and below it elsewhere.
        let border = &found.get(Output::MinForceRatio).unwrap().mid;
        assert_eq!(*border <= case["alpha"].as_f64().unwrap(), is_free, "{case}");
        if !is_free {
            continue;
        }
        compared += 1;
        for (output, name) in [
            (Output::MaxDisplacement, "max_displacement"),
            (Output::MaxVelocity, "max_velocity"),
            (Output::MaxAcceleration, "max_acceleration"),
            (Output::TransmittedForce, "transmitted_force"),
        ] {
            hold(
                "response",
                name,
                found.get(output).unwrap_or_else(|| panic!("{name} of {case}")),
                &answer[name],
                &case,
            );
        }
        let digits = |name: &str| answer[name].as_str().unwrap().parse::<Mp<4>>().unwrap();
        let (alpha, omega) = (number::<4>(&case["alpha"]), number::<4>(&case["omega"]));
        for (output, value) in [
            (Output::LoopSizeStiffness, digits("energy") * Mp::from(2.0) / (alpha * alpha)),
            (Output::LoopSizeInertia, digits("energy") * Mp::from(2.0) * omega * omega / (alpha * alpha)),
            (Output::DynamicAmplification, digits("max_displacement") / alpha),
            (Output::Transmissibility, digits("transmitted_force") / alpha),
        ] {
            let name = output.definition().name;
            let text = Value::String(value.to_string());
            hold(
                "response",
                name,
                found.get(output).unwrap_or_else(|| panic!("{name} of {case}")),
                &text,
                &case,
            );
        }
    }
    assert!(compared > 10, "{compared}");
}
