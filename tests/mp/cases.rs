//! The case file for authors of solvers: `tests/data/cases.json`, written with `STICKSLIP_WRITE=1`.

use crate::kept::Kept;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use stickslip::float::Mp;
use stickslip::motion::{LongRun, State, SteadyOutput, SteadyState};
use stickslip::{Float, Ratios, enclosed};

/// Ω, α, ζ and η of each case, in decimal.
const CASES: [[&str; 4]; 40] = [
    // Without a stop.
    ["1.5", "2.5", "0", "1"],
    ["0.7", "3", "0", "1"],
    ["1.02", "2", "0", "1"],
    ["2", "1.7", "0", "1"],
    ["10", "1.4", "0", "1"],
    ["0.9", "1.5", "0.05", "1.1"],
    ["1", "1.5", "0.1", "1"],
    ["1", "3", "0.001", "1"],
    ["0.8", "2", "0.02", "1"],
    ["0.55", "4", "0.3", "1"],
    ["1.2", "2", "0.7", "1"],
    ["1.5", "6", "1", "1"],
    ["3", "40", "5", "1"],
    ["0.4", "9", "0", "1"],
    ["0.45", "8", "0.01", "1"],
    ["0.3", "16", "0", "1"],
    ["0.3333", "90", "0.002", "1"],
    ["0.28", "12.5", "0", "1"],
    ["5", "2", "0.05", "1.3"],
    ["1.0001", "1.3", "0.0005", "1"],
    // With stops.
    ["0.4", "6", "0", "1"],
    ["0.3", "4", "0.1", "1"],
    ["0.15", "3", "0", "1"],
    ["0.1", "3", "0", "1"],
    ["0.03", "3", "0", "1"],
    ["0.2", "1.5", "0.02", "1"],
    ["1.3", "1.3", "0", "1"],
    ["0.9", "1.1", "0", "1"],
    ["2.5", "1.2", "0.1", "1"],
    ["0.6", "1.9", "0.5", "1"],
    ["0.25", "5", "1", "1"],
    ["0.5", "10", "2", "1"],
    ["0.72495", "1.5", "0.05", "1.1"],
    ["0.5", "4", "0.02", "1.3"],
    ["0.7", "2", "0.1", "1.5"],
    ["0.2", "4", "0.05", "1.2"],
    ["1.1", "1.6", "0.01", "1.05"],
    ["0.12", "2.2", "0.2", "1.4"],
    ["0.05", "1.8", "0", "1"],
    ["0.35", "3.3", "0.03", "1.02"],
];

const OUTPUTS: [SteadyOutput; 6] = [
    SteadyOutput::MaxDisplacement,
    SteadyOutput::MinDisplacement,
    SteadyOutput::MaxVelocity,
    SteadyOutput::MinVelocity,
    SteadyOutput::StickFraction,
    SteadyOutput::EnergyOut,
];

fn steady<F: Float>([omega, alpha, zeta, eta]: [F; 4]) -> SteadyState<F> {
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    let ratios = ratios.with_static_friction_ratio(eta).unwrap();
    *LongRun::from_start(ratios, State::default()).unwrap().steady_state().unwrap()
}

/// The answers to 30 digits.
fn digits<const LIMBS: usize>(case: [&str; 4]) -> Vec<(&'static str, String)> {
    let found = steady(case.map(|text| text.parse::<Mp<LIMBS>>().unwrap()));
    OUTPUTS
        .map(|output| {
            (output.definition().name, rug::Float::from(output.of(&found)).to_string_radix(10, Some(30)))
        })
        .into()
}

fn text() -> String {
    let cases = CASES.map(|case| {
        let (found, wider) = (digits::<4>(case), digits::<8>(case));
        assert_eq!(found, wider, "{case:?}");
        let counted = steady(case.map(|text| text.parse::<Mp<4>>().unwrap()));
        let known = case.map(|text| text.parse().unwrap());
        let [omega, alpha, zeta, eta] = &known;
        let proved = enclosed::KnownRatios::new(omega)
            .with_force_ratio(alpha)
            .with_damping_ratio(zeta)
            .with_static_friction_ratio(eta)
            .steady(104)
            .unwrap();
        if let Ok(proved) = &proved {
            let most = steady(case.map(|text| text.parse::<Mp<8>>().unwrap())).max_displacement.value;
            assert!(proved.max_displacement.contains(&rug::Float::from(most)), "{case:?}");
        }
        let mut answer = serde_json::Map::new();
        answer.insert("sticks_per_cycle".to_owned(), json!(counted.sticks_per_cycle));
        answer.insert("velocity_zeros_per_cycle".to_owned(), json!(counted.velocity_zeros_per_cycle));
        answer.extend(found.into_iter().map(|(name, digits)| (name.to_owned(), json!(digits))));
        json!({
            "name": case.join(", "), "omega": case[0], "alpha": case[1], "damping_ratio": case[2],
            "static_friction_ratio": case[3], "proved": proved.is_ok(), "answer": answer,
        })
    });
    let about = "m = k = r_y = 1, so that x″ + 2ζx′ + x + sgn x′ = α sin Ωt; at rest while |α sin Ωt − x| ≤ η. The steady motion \
                 from rest at x = 0: displacements in r_y/k, velocities in r_y/k · ω_d, energy_out in r_y²/k for a \
                 cycle, stick_fraction of the time. 30 digits, the same at 256 and 512 bits; `proved`: enclosed in balls.";
    let file = json!({ "schema": "cases.schema.json", "about": about, "cases": cases.to_vec() });
    serde_json::to_string_pretty(&in_order(file)).unwrap() + "\n"
}

/// The value with the keys of its objects in alphabetical order, whatever order the crate keeps.
fn in_order(value: Value) -> Value {
    match value {
        Value::Object(map) => {
            let sorted: BTreeMap<String, Value> =
                map.into_iter().map(|(key, value)| (key, in_order(value))).collect();
            Value::Object(sorted.into_iter().collect())
        }
        Value::Array(items) => Value::Array(items.into_iter().map(in_order).collect()),
        single => single,
    }
}

#[test]
fn the_case_file_is_what_is_computed() {
    let text = text();
    assert_eq!(Kept::default().at("tests/data/cases.json", &text), text);
}

/// At f64 the cases have their digits: 1e-12 of the greatest value of a kind allows for slow contraction.
#[test]
fn the_cases_hold_at_f64() {
    let file: Value = serde_json::from_str(include_str!("../data/cases.json")).unwrap();
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), CASES.len());
    for case in cases {
        let of = |name: &str| case[name].as_str().unwrap().parse::<f64>().unwrap();
        let found = steady([of("omega"), of("alpha"), of("damping_ratio"), of("static_friction_ratio")]);
        assert_eq!(case["answer"]["sticks_per_cycle"], json!(found.sticks_per_cycle), "{case}");
        for output in OUTPUTS {
            let expected: f64 = case["answer"][output.definition().name].as_str().unwrap().parse().unwrap();
            let error = (output.of(&found) - expected).abs() / expected.abs().max(1.0);
            assert!(error < 1e-12, "{case} {}: {error:e}", output.definition().name);
        }
    }
}
