//! Each field of a file, typed wrong in every way: the message names the field that was typed.

use crate::{by_matrices, by_names};
use serde_json::{Value, json};
use std::path::Path;
use stickslip_front::system::{NamedSystem, parsed};

/// A step to a value: of a table, or of a list, from 0.
#[derive(Clone)]
enum Step {
    Field(String),
    Place(usize),
}

/// The paths of all values but of tables and lists.
fn leaves(value: &Value, path: &[Step], found: &mut Vec<Vec<Step>>) {
    let inner = |step: Step| [path, &[step]].concat();
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(name, value)| leaves(value, &inner(Step::Field(name.clone())), found));
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, value)| leaves(value, &inner(Step::Place(i)), found));
        }
        _ => found.push(path.to_vec()),
    }
}

/// The place as messages write it: `springs[2].stiffness`.
fn place(path: &[Step]) -> String {
    let mut text = String::new();
    for step in path {
        match step {
            Step::Field(name) if text.is_empty() => text.push_str(name),
            Step::Field(name) => text += &format!(".{name}"),
            Step::Place(i) => text += &format!("[{}]", i + 1),
        }
    }
    text
}

fn at<'v>(value: &'v mut Value, path: &[Step]) -> &'v mut Value {
    path.iter().fold(value, |value, step| match step {
        Step::Field(name) => &mut value[name.as_str()],
        Step::Place(i) => &mut value[*i],
    })
}

fn built(value: &Value) -> Result<(), String> {
    let built = parsed(&value.to_string(), "x")
        .and_then(|value| NamedSystem::new(&value, [], Path::new("none"), None).map(drop));
    if let Err(why) = &built {
        assert!(!why.contains('\n') && !why.contains("[0]"), "{why}");
    }
    built
}

/// The last field of a path.
fn field(path: &[Step]) -> &str {
    let mut names = path.iter().filter_map(|step| match step {
        Step::Field(name) => Some(name.as_str()),
        Step::Place(_) => None,
    });
    names.next_back().unwrap()
}

fn files() -> [Value; 2] {
    [by_names(), by_matrices()]
}

#[test]
fn what_is_no_value_of_a_field_is_named_by_its_place() {
    let mut tried = 0;
    for file in files() {
        let mut paths = Vec::new();
        leaves(&file, &[], &mut paths);
        for path in &paths {
            let wrong = [
                json!(true),
                json!([]),
                json!({}),
                json!([[1]]),
                json!("5 furlong"),
                json!("NaN"),
                json!("inf"),
                json!(""),
            ];
            for new in wrong {
                // Any text is a name.
                if ["name", "coordinates"].contains(&field(path))
                    && new.as_str().is_some_and(|text| !text.is_empty())
                {
                    continue;
                }
                if field(path) == "odd" && new.is_boolean() {
                    continue;
                }
                let mut value = file.clone();
                *at(&mut value, path) = new.clone();
                let why = built(&value).expect_err(&place(path));
                assert!(why.starts_with(&place(path)), "{} = {new}: {why}", place(path));
                tried += 1;
            }
        }
    }
    assert!(tried > 800, "{tried}");
}

/// A quantity of another dimension.
#[test]
fn a_wrong_unit_is_named_by_its_place() {
    let file = by_names();
    let mut paths = Vec::new();
    leaves(&file, &[], &mut paths);
    let mut tried = 0;
    for path in paths {
        if ["name", "on", "between", "units"].contains(&field(&path)) {
            continue;
        }
        let refused = ["1 kg", "1 mm"].map(|new| {
            let mut value = file.clone();
            *at(&mut value, &path) = json!(new);
            built(&value).err().filter(|why| why.starts_with(&place(&path)))
        });
        assert!(refused.iter().any(Option::is_some), "{}: {refused:?}", place(&path));
        tried += 1;
    }
    assert!(tried >= 30, "{tried}");
}

/// A negative number, where it is refused at all, is so by the name of its field.
#[test]
fn a_negative_value_is_named() {
    let mut refused = 0;
    for file in files() {
        let mut paths = Vec::new();
        leaves(&file, &[], &mut paths);
        for path in paths {
            for new in [json!(-1e9), json!(-1)] {
                let mut value = file.clone();
                *at(&mut value, &path) = new;
                if let Err(why) = built(&value) {
                    let is_named = why.contains(&place(&path)) || why.contains(field(&path));
                    assert!(is_named, "{}: {why}", place(&path));
                    refused += 1;
                }
            }
        }
    }
    assert!(refused > 60, "{refused}");
}

/// A field that is missing has its default, or is named; an unknown one is named with its place.
#[test]
fn a_missing_field_and_an_unknown_one_are_named() {
    for file in files() {
        let mut paths = Vec::new();
        leaves(&file, &[], &mut paths);
        for path in &paths {
            let (last, before) = path.split_last().unwrap();
            let mut value = file.clone();
            match (at(&mut value, before), last) {
                (Value::Object(map), Step::Field(name)) => drop(map.remove(name)),
                (Value::Array(list), Step::Place(i)) => drop(list.remove(*i)),
                _ => unreachable!(),
            }
            if let Err(why) = built(&value) {
                // Of a body that is not there, those that were between it and others.
                let is_named = why.contains(field(path)) || matches!(last, Step::Place(_));
                assert!(is_named || place(path).starts_with("masses."), "{}: {why}", place(path));
                assert!(
                    why.starts_with(&place(&before[..before.len().min(1)]))
                        || place(path).starts_with("masses."),
                    "{}: {why}",
                    place(path)
                );
            }
            let mut value = file.clone();
            let Value::Object(map) = at(&mut value, before) else { continue };
            map.insert("zzz".to_owned(), json!(1));
            // A body may have any name.
            if place(before) != "masses" {
                let why = built(&value).expect_err("zzz");
                let due = if before.is_empty() {
                    "zzz is unknown".to_owned()
                } else {
                    format!("{}.zzz is unknown", place(before))
                };
                assert!(why.starts_with(&due), "{why}");
                let (_, names) = why.split_once("Expected one of ").unwrap();
                let mut names: Vec<&str> = names.split(", ").collect();
                let count = names.len();
                names.sort_unstable();
                names.dedup();
                assert_eq!(names.len(), count, "{why}");
            }
        }
    }
    let mut value = by_names();
    let one = "one of amplitude with frequency, constant, waves, and record";
    value["forces"][0] = json!({"on": "roof"});
    assert_eq!(built(&value).unwrap_err(), format!("forces[1]: needs {one}"));
    let mut value = by_names();
    value["mass"] = json!([[1]]);
    assert_eq!(
        built(&value).unwrap_err(),
        "masses, mass: must be one of the two: bodies by name, or a matrix"
    );
}

/// A list of another length is blamed itself, and not one that goes with it.
#[test]
fn a_list_of_another_length_is_named() {
    let file = by_matrices();
    let lists = [
        "mass[1]",
        "damping[2]",
        "stiffness[1]",
        "constant",
        "start.displacement",
        "start.velocity",
        "harmonics[1].sin",
        "harmonics[1].cos",
        "record.values",
        "record.force",
        "elements[1].direction",
        "elements[4].normal.displacement",
    ];
    let pointer = |place: &str| -> String {
        let parts = place.split(['.', '[']).map(|part| match part.strip_suffix(']') {
            Some(place) => (place.parse::<usize>().unwrap() - 1).to_string(),
            None => part.to_owned(),
        });
        parts.map(|part| format!("/{part}")).collect()
    };
    for place in lists {
        for longer in [true, false] {
            let mut value = file.clone();
            let list = value.pointer_mut(&pointer(place)).unwrap().as_array_mut().unwrap();
            let last = list.pop().unwrap();
            if longer {
                list.extend([last.clone(), last]);
            }
            let (found, due) = (list.len(), if longer { list.len() - 1 } else { list.len() + 1 });
            assert_eq!(built(&value).unwrap_err(), format!("{place}: has {found} numbers, must have {due}"));
        }
    }
    // Three rows of two numbers.
    let mut value = file.clone();
    value["mass"] = json!([[1, 0], [0, 1], [0, 0]]);
    assert_eq!(built(&value).unwrap_err(), "mass[1]: has 2 numbers, must have 3");
    value = file;
    value["damping"] = json!([[1, 0]]);
    assert_eq!(built(&value).unwrap_err(), "damping: has 1 rows, must have 2");
}

/// A stop is elastic or has a restitution from 0 to 1, in both kinds of file.
#[test]
fn a_stop_is_elastic_or_has_a_restitution() {
    for (file, place) in [(by_names(), "stops[3]"), (by_matrices(), "elements[5]")] {
        let list = if place.starts_with("stops") { "stops" } else { "elements" };
        let number = if list == "stops" { 2 } else { 4 };
        let with = |name: &str, new: Value| {
            let mut value = file.clone();
            value[list][number][name] = new;
            built(&value).unwrap_err()
        };
        assert!(built(&file).is_ok());
        assert_eq!(with("restitution", json!(1.5)), format!("{place}.restitution 1.5: must be ≤ 1"));
        assert_eq!(with("restitution", json!(-0.5)), format!("{place}.restitution -0.5: must be ≥ 0"));
        let without = "must be left out of a stop with a restitution, which gives no way";
        assert_eq!(with("stiffness", json!(3)), format!("{place}.stiffness 3: {without}"));
        assert_eq!(with("damping", json!(3)), format!("{place}.damping 3: {without}"));
        let mut value = file.clone();
        value[list][number].as_object_mut().unwrap().remove("restitution");
        assert_eq!(built(&value).unwrap_err(), format!("{place}: needs one of stiffness and restitution"));
    }
}

/// Friction under a stop with a restitution is between bodies by name, or under the stop that is named; and it is across the stop.
#[test]
fn friction_under_a_stop_names_that_stop() {
    let named = |along: Value| {
        json!({
            "masses": {"up": 1, "along": 1},
            "stops": [{"name": "floor", "between": ["up", "ground"], "gap": 0, "restitution": 0.4, "coefficient": 0.3, "along": along}],
        })
    };
    let by_place = |stop: &str, direction: Value| {
        json!({
            "mass": [[1, 0], [0, 1]],
            "elements": [
                {"type": "contact", "name": "rub", "direction": direction, "friction": 0.3, "stop": stop},
                {"type": "stop", "name": "floor", "direction": [0, -1], "gap": 0, "restitution": 0.4},
            ],
        })
    };
    for value in [named(json!(["ground", "along"])), by_place("floor", json!([1, 0]))] {
        let found = NamedSystem::new(&value, [], Path::new(""), None).unwrap();
        let (own, other) = if value["stops"].is_array() { ("floor friction", 0) } else { ("rub", 1) };
        let rubs = found.described.model.elements.iter().find(|element| element.name == own).unwrap();
        assert!(
            matches!(rubs.kind, stickslip::system::Kind::UnderStop { stop, coefficient, peak } if stop == other && coefficient == 0.3 && peak == 1.0)
        );
    }
    let across = "must be across the stop that presses on it";
    let why = built(&named(json!(["ground", "up"]))).unwrap_err();
    assert!(why.starts_with("floor friction must") && why.contains(across) && !why.contains('\n'), "{why}");
    let why = built(&by_place("floor", json!([1, 1]))).unwrap_err();
    assert!(why.starts_with("rub must") && why.contains(across), "{why}");
    assert_eq!(
        built(&by_place("flor", json!([1, 0]))).unwrap_err(),
        "elements[1].stop flor: is no element. Did you mean floor?"
    );
    let place = "must be under the force of a stop with a restitution";
    assert!(built(&by_place("rub", json!([1, 0]))).unwrap_err().contains(place));
    let without = |name: &str| {
        let mut value = named(json!(["ground", "along"]));
        value["stops"][0].as_object_mut().unwrap().remove(name);
        built(&value).unwrap_err()
    };
    assert_eq!(without("along"), "stops[1].along is missing");
    assert!(without("coefficient").ends_with("needs the coefficient of a friction"));
}
