//! The cases of `tests/data/systems.json`, whose values an independent program computed.

use serde_json::Value;
use stickslip::system::{Beyond, Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State};

pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) model: Model<f64>,
    pub(crate) run: Value,
    pub(crate) answer: Value,
}

/// All cases.
pub(crate) fn cases() -> Vec<Case> {
    cases_of(include_str!("../data/systems.json"))
}

/// The cases of a file.
pub(crate) fn cases_of(text: &str) -> Vec<Case> {
    let all: Value = serde_json::from_str(text).expect("the file is JSON");
    all.as_array().expect("a list of cases").iter().map(case).collect()
}

/// A number, or one of more digits in a string.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_str().map_or_else(|| value.as_f64().expect("a number"), |s| s.parse().expect("a number"))
}

/// The digits of a number.
#[cfg(feature = "mp")]
pub(crate) fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// A list of numbers; empty where there is none.
pub(crate) fn list(value: &Value) -> Vec<f64> {
    value.as_array().map_or_else(Vec::new, |list| list.iter().map(number).collect())
}

fn rows(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().expect("rows").iter().map(list).collect()
}

fn signal(value: &Value, constant: f64) -> Signal<f64> {
    let constant = value.get("const").map_or(constant, number);
    Signal { sin: list(&value["sin"]), cos: list(&value["cos"]), ..Signal::constant(constant) }
}

fn case(value: &Value) -> Case {
    let system = &value["system"];
    let elements = system["elements"].as_array().expect("elements").iter().enumerate().map(element).collect();
    let harmonics = system["harmonics"].as_array().expect("harmonics").iter().map(|h| Harmonic {
        frequency: number(&h["frequency"]),
        sin: list(&h["sin"]),
        cos: list(&h["cos"]),
    });
    let records = system.get("record").map(|r| Record {
        times: list(&r["times"]),
        values: list(&r["values"]),
        force: list(&r["force"]),
        beyond: Beyond::Zero,
    });
    Case {
        name: value["name"].as_str().expect("a name").to_owned(),
        model: Model {
            coordinates: Vec::new(),
            mass: rows(&system["mass"]),
            damping: rows(&system["damping"]),
            stiffness: rows(&system["stiffness"]),
            elements,
            constant: Vec::new(),
            harmonics: harmonics.collect(),
            records: records.into_iter().collect(),
            moved: Vec::new(),
            levels: Vec::new(),
        },
        run: value["run"].clone(),
        answer: value["answer"].clone(),
    }
}

fn element((i, value): (usize, &Value)) -> Element<f64> {
    let direction = list(&value["direction"]);
    let side = value.get("side").map_or(1.0, number);
    let kind = match value["type"].as_str() {
        Some("contact") => Kind::Contact {
            law: value.get("law").map_or_else(
                || Law::constant(number(&value["friction"])),
                |law| Law { points: rows(law).iter().map(|p| (p[0], p[1])).collect() },
            ),
            peak: value.get("peak").map_or(1.0, number),
            normal: value.get("normal").map(|n| Normal {
                signal: signal(n, 0.0),
                displacement: Vec::new(),
                velocity: Vec::new(),
            }),
        },
        Some("elastic") => {
            let (stiffness, friction) = (number(&value["stiffness"]), number(&value["friction"]));
            Kind::Elastic { stiffness, friction, normal: None }
        }
        Some("stop") => Kind::Stop {
            gap: number(&value["gap"]),
            stiffness: number(&value["stiffness"]),
            damping: value.get("damping").map_or(0.0, number),
        },
        other => panic!("an element of the type {other:?}"),
    };
    Element {
        name: format!("element {i}"),
        direction: direction.iter().map(|b| b * side).collect(),
        moves: value.get("belt").map_or_else(|| Signal::constant(0.0), |b| signal(b, 0.0)),
        kind,
    }
}

/// The start of a case.
pub(crate) fn start(case: &Case) -> State<f64> {
    let mut start = State::rest(case.model.mass.len());
    for (place, name) in [(&mut start.displacement, "displacement"), (&mut start.velocity, "velocity")] {
        if let Some(given) = case.run.get(name) {
            *place = list(given);
        }
    }
    start
}
