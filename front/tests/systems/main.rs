//! Files of systems: wrong ones, and the schema of right ones.
#![cfg(feature = "system")]

mod bounds;
mod curves;
mod damping;
mod drives;
mod grazing;
mod hostile;
mod prescribed;
mod schema;
mod springs;
mod stepper;
mod stored;
mod wrong;

#[path = "../../../tests/random/generator.rs"]
mod generator;
#[path = "../../../tests/place/mod.rs"]
mod place;

use serde_json::{Value, json};
use std::path::Path;
use stickslip_front::system::{NamedSystem, parsed};

/// How many are compared: the second number under `.ci/slow systems`.
fn count(usual: usize, all: usize) -> usize {
    if std::env::var_os("STICKSLIP_ALL_SYSTEMS").is_some() { all } else { usual }
}

/// The system of a text.
fn named(text: &str) -> NamedSystem {
    let value = parsed(text, "machine.toml").unwrap();
    NamedSystem::new(&value, [], Path::new(""), None).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Every field of bodies by name.
fn by_names() -> Value {
    json!({
        "units": "N,mm",
        "masses": {"table": {"moves": {"displacement": {"amplitude": 2, "frequency": 4, "shape": "triangle"}}}, "block": "1 t", "roof": {"mass": "500 kg", "start": "3 mm", "velocity": "1 mm/s"}},
        "springs": [
            {"name": "cable", "between": ["ground", "roof"], "law": {"formula": "3*x + x^3", "tolerance": "1 N"}, "odd": false},
            {"name": "bump", "between": ["ground", "roof"], "law": [[0, 0], ["4 mm", "3 N"], [6, 40]], "odd": true},
            {"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"},
            {"between": ["block", "roof"], "stiffness": 300},
        ],
        "contacts": [
            {"name": "bearing", "between": ["ground", "block"], "friction": "450 N", "peak": 1.2},
            {"between": ["block", "roof"], "law": [[0, 40], ["10 mm/s", 30]], "moves": {"amplitude": 3, "frequency": 2}},
            {"between": ["ground", "roof"], "coefficient": 0.1, "normal_load": {"constant": 90, "amplitude": 20, "frequency": 3, "vertical": {"amplitude": "0.1 g", "frequency": 5}}},
            {"between": ["table", "roof"], "coefficient": 0.2, "stiffness": "5 N/mm",
                "normal_load": {"constant": 9, "between": ["ground", "block"], "stiffness": 2, "damping": 0.1}},
            {"between": ["ground", "roof"], "friction": "10 N", "stiffness": "5 N/mm"},
            {"name": "seal", "between": ["ground", "block"], "law": {"kinetic": "3 N", "static": "4 N", "speed": "5 mm/s", "exponent": 2, "viscous": 0.1, "tolerance": 0.5}},
            {"name": "felt", "between": ["ground", "roof"], "law": {"formula": "3 + exp(-v)"}},
        ],
        "stops": [
            {"between": ["ground", "roof"], "gap": "9 mm", "stiffness": "1 kN/mm", "damping": 0.1},
            {"between": ["ground", "roof"], "gap": "9 mm", "stiffness": 3, "coefficient": 0.3, "along": ["ground", "block"]},
            {"between": ["block", "roof"], "gap": "20 mm", "restitution": 0.4},
        ],
        "forces": [
            {"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz", "phase": "30deg"},
            {"on": "block", "constant": 5, "waves": [{"amplitude": 1, "frequency": 2, "shape": "square", "duty": 0.3}]},
            {"on": "block", "amplitude": 5, "sweep": {"from": "1 Hz", "to": "2 Hz", "duration": "1 s", "tolerance": 0.1}},
        ],
        "levels": [{"on": "roof", "displacement": "1 mm"}, {"name": "fast", "between": ["block", "roof"], "velocity": 3}],
        "base": {"acceleration": {"amplitude": "0.1 g", "frequency": "2 Hz"}},
        "damping": {"rayleigh": [0.1, "0.2 ms"], "ratio": "2 %"},
    })
}

/// Every field of matrices.
fn by_matrices() -> Value {
    json!({
        "mass": [[1.0, 0.1], [0.1, 0.5]], "damping": {"matrix": [[0.3, 0], [0, 0]], "rayleigh": [0.1, 0.2], "ratio": ["2 %"]}, "stiffness": [[500, -300], [-300, 300]],
        "coordinates": ["block", "roof"],
        "elements": [
            {"type": "contact", "direction": [1, 0], "friction": 450, "belt": {"const": 1, "sin": [0.5]}},
            {"type": "elastic", "direction": [1, -1], "stiffness": 50, "friction": 3},
            {"type": "stop", "direction": [0, 1], "gap": 0.1, "stiffness": 1e4, "side": -1},
            {"type": "contact", "direction": [0, 1], "friction": 0.3, "normal": {"const": 2, "displacement": [0.1, 0]}},
            {"type": "stop", "direction": [1, 0], "gap": 0.4, "restitution": 0.6},
            {"type": "spring", "direction": [0, 1], "law": [[-1, 0], [0, 0], [1, 20]], "odd": false},
        ],
        "harmonics": [{"frequency": 18.8, "sin": [0, 1500], "cos": [1, 0]}],
        "record": {"times": [0, 0.1, 0.2], "values": [0, 1, -1], "force": [1, 1]},
        "constant": [1, 2],
        "start": {"displacement": [0, 3], "velocity": [0, 0]},
    })
}
