//! The schema of the documentation is that of the reader.

use crate::{by_matrices, by_names};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use stickslip_front::system::NamedSystem;

fn schema() -> Value {
    serde_json::from_str(include_str!("../../../docs/system.schema.json")).unwrap()
}

/// Whether a value has the form of a schema: the keywords that this schema uses.
fn fits(value: &Value, of: &Value, all: &Value) -> bool {
    let of = match of.get("$ref").and_then(Value::as_str) {
        Some(name) => &all["$defs"][name.strip_prefix("#/$defs/").unwrap()],
        None => of,
    };
    let is = |kind: &Value| match kind.as_str().unwrap() {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        other => panic!("{other}"),
    };
    let has_type = match of.get("type") {
        None => true,
        Some(Value::Array(kinds)) => kinds.iter().any(is),
        Some(kind) => is(kind),
    };
    let any =
        of.get("anyOf").is_none_or(|list| list.as_array().unwrap().iter().any(|of| fits(value, of, all)));
    let listed = of.get("enum").is_none_or(|list| list.as_array().unwrap().contains(value));
    let length =
        value.as_array().map_or_else(|| value.as_object().map_or(0, |map| map.len()), Vec::len) as u64;
    let bound = |name: &str| of.get(name).and_then(Value::as_u64);
    let is_sized =
        ["minItems", "minProperties"].iter().filter_map(|name| bound(name)).all(|least| length >= least)
            && ["maxItems", "maxProperties"].iter().filter_map(|name| bound(name)).all(|most| length <= most);
    let items = match (value, of.get("items")) {
        (Value::Array(items), Some(of)) => items.iter().all(|item| fits(item, of, all)),
        _ => true,
    };
    let members = match (value, of.get("type").and_then(Value::as_str)) {
        (Value::Object(map), Some("object")) => map.iter().all(|(name, value)| {
            match (of.get("properties").and_then(|own| own.get(name)), of.get("additionalProperties")) {
                (Some(of), _) => fits(value, of, all),
                (None, Some(Value::Bool(may))) => *may,
                (None, Some(of)) => fits(value, of, all),
                (None, None) => true,
            }
        }),
        _ => true,
    };
    let required = of.get("required").and_then(Value::as_array);
    let is_whole =
        required.is_none_or(|names| names.iter().all(|name| value.get(name.as_str().unwrap()).is_some()));
    has_type && any && listed && is_sized && items && members && is_whole
}

#[test]
fn right_files_fit_the_schema_and_wrong_ones_do_not() {
    let all = schema();
    for value in [by_names(), by_matrices()] {
        assert!(fits(&value, &all, &all), "{value}");
        let mut wrong = value.clone();
        wrong["mases"] = json!({});
        assert!(!fits(&wrong, &all, &all));
    }
    let cases: Value = serde_json::from_str(include_str!("../../../tests/data/systems.json")).unwrap();
    for case in cases.as_array().unwrap() {
        assert!(fits(&case["system"], &all, &all), "{}", case["name"]);
    }
    for (path, new) in [
        ("/masses/block", json!([])),
        ("/contacts/0/between", json!(["ground"])),
        ("/stops/0/gap", Value::Null),
    ] {
        let mut wrong = by_names();
        *wrong.pointer_mut(path).unwrap() = new;
        assert!(!fits(&wrong, &all, &all), "{path}");
    }
}

/// The reader's list of the fields of a table, from its refusal of an unknown one, is the schema's.
#[test]
fn the_schema_has_the_fields_of_the_reader() {
    let all = schema();
    let of_reader = |mut value: Value, path: &str| -> BTreeSet<String> {
        value.pointer_mut(path).unwrap()["zzzzzzzzzzzzzzzzzzzzzzzz"] = json!(1);
        let why = NamedSystem::new(&value, [], Path::new(""), None).unwrap_err();
        let (_, names) = why.split_once("Expected one of ").unwrap_or_else(|| panic!("{path}: {why}"));
        names.split(", ").map(str::to_owned).collect()
    };
    let in_files = || {
        let mut value = by_matrices();
        value["stiffness"] =
            json!({ "file": concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems/stored/two.mtx") });
        value
    };
    let contact = |path: &str, other: &Value| {
        let mut value = by_names();
        *value.pointer_mut(path).unwrap() = other.clone();
        value
    };
    let tables = [
        ("bodies", "", by_names()),
        ("body", "/masses/roof", by_names()),
        ("spring", "/springs/0", by_names()),
        ("contact", "/contacts/0", by_names()),
        ("stop", "/stops/0", by_names()),
        ("curve", "/contacts/5/law", by_names()),
        ("spring_curve", "/springs/0/law", by_names()),
        ("force", "/forces/0", by_names()),
        ("base", "/base", by_names()),
        ("signal", "/base/acceleration", by_names()),
        ("signal", "/contacts/1/moves", by_names()),
        ("motion", "/masses/table/moves", by_names()),
        ("sweep", "/forces/2/sweep", by_names()),
        ("level", "/levels/0", by_names()),
        ("damping", "/damping", by_names()),
        ("matrix_damping", "/damping", by_matrices()),
        ("matrix_of_file", "/stiffness", in_files()),
        ("matrices", "", by_matrices()),
        ("harmonic", "/harmonics/0", by_matrices()),
        ("normal", "/contacts/2/normal_load", contact("/contacts/0/friction", &json!(1))),
    ];
    for (name, path, value) in tables {
        let own: BTreeSet<String> =
            all["$defs"][name]["properties"].as_object().unwrap().keys().cloned().collect();
        let mut found = of_reader(value, path);
        // Bodies by name are the other kind of file.
        if name == "matrices" {
            assert!(found.remove("masses"));
        }
        assert_eq!(found, own, "{name}");
    }
    // The fields of an element depend on its type: together they are the schema's.
    let mut found = BTreeSet::new();
    for place in 0..6 {
        found.append(&mut of_reader(by_matrices(), &format!("/elements/{place}")));
    }
    let own: BTreeSet<String> =
        all["$defs"]["element"]["properties"].as_object().unwrap().keys().cloned().collect();
    assert_eq!(found, own);
}

/// Answers, values to set and messages have the names that a file of matrices gives its coordinates.
#[test]
fn the_coordinates_of_matrices_have_names() {
    let made = |names: &Value| {
        let mut value = by_matrices();
        value["coordinates"] = names.clone();
        NamedSystem::new(&value, [], Path::new(""), None)
    };
    assert_eq!(made(&json!(["block", "roof"])).unwrap().described.coordinates, ["block", "roof"]);
    for (names, why) in [
        (json!(["block"]), "coordinates: has 1 names, must have 2"),
        (json!(["block", "block"]), "is used twice"),
        (json!(["block", "ground"]), "the ground does not move"),
        (json!(["block", 2]), "must be a text"),
        (json!(["block", ""]), "must not be empty"),
        (json!("block"), "coordinates"),
    ] {
        let found = made(&names).unwrap_err();
        assert!(found.contains(why), "{found}");
    }
    let mut value = by_matrices();
    value.as_object_mut().unwrap().remove("coordinates");
    let found = NamedSystem::new(&value, [], Path::new(""), None).unwrap();
    assert_eq!(found.described.coordinates, ["q1", "q2"]);
}
