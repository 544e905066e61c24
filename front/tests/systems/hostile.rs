//! Files of systems that are wrong in one place or several: each is refused on one line, or is a system.

use crate::{by_matrices, by_names};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::path::Path;
use stickslip_front::system::{Answer, Description, NamedSystem, parsed};

/// What people and machines put where something else belongs.
fn hostile() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Null),
        Just(json!(true)),
        Just(json!([])),
        Just(json!({})),
        Just(json!([[[[[[]]]]]])),
        prop::sample::select(vec![
            0.0, -0.0, -1.0, 1e-320, 1e308, -1e308, 1e300, 1e-300, 0.1, 3.0, 1e15, 1e-15,
        ])
        .prop_map(|x| json!(x)),
        prop::sample::select(vec![
            "NaN",
            "inf",
            "-inf",
            "1e400",
            "",
            " ",
            "1 kN",
            "5 mm",
            "3 Hz",
            "1e308 m",
            "-1 kg",
            "1 furlong",
            "ground",
            "block",
            "rof",
            "../../etc/passwd",
            "\u{0}",
            "…",
            "1,5",
            "1 N/mm/mm",
            "9999999999999999999999 kg",
        ])
        .prop_map(|text| json!(text)),
        Just(json!("x".repeat(100_000))),
        Just(json!(vec![1.0; 300])),
        Just(json!([["ground", "block"], 3])),
    ]
}

/// The place of a value, as choices among the members of each level.
fn change(value: &mut Value, path: &[usize], new: &Value, how: u8) {
    let Some((first, rest)) = path.split_first() else {
        *value = new.clone();
        return;
    };
    match value {
        Value::Object(map) if !map.is_empty() => {
            let key = map.keys().nth(first % map.len()).unwrap().clone();
            if rest.is_empty() && how == 1 {
                map.remove(&key);
            } else if rest.is_empty() && how == 2 {
                let old = map.remove(&key).unwrap();
                map.insert(format!("{key}s"), old);
            } else {
                change(&mut map[&key], rest, new, how);
            }
        }
        Value::Array(list) if !list.is_empty() => {
            let place = first % list.len();
            if rest.is_empty() && how == 1 {
                list.remove(place);
            } else if rest.is_empty() && how == 2 {
                let copy = list[place].clone();
                list.push(copy);
            } else {
                change(&mut list[place], rest, new, how);
            }
        }
        _ => *value = new.clone(),
    }
}

/// A system is built and followed for a moment, and a refusal is one line of bounded length.
fn tried(value: &Value) -> Result<bool, TestCaseError> {
    let name = "machine.json";
    let built = parsed(&value.to_string(), name)
        .and_then(|value| NamedSystem::new(&value, [], Path::new("none"), None));
    let short = |text: &str| {
        prop_assert!(!text.contains('\n') && !text.is_empty() && text.len() < 300_000, "{text}");
        Ok(())
    };
    match built {
        Ok(system) => {
            prop_assert!(serde_json::to_string(&Description::new(&system)).is_ok());
            // A thousandth of a radian of the fastest vibration.
            let found =
                (0..40).map(|i| 0.1f64.powi(i)).find(|until| system.check_until(*until * 1e3, "").is_ok());
            if let Some(until) = found {
                match system.system.simulate(&system.described.start, until) {
                    Ok(motion) => {
                        prop_assert!(
                            serde_json::to_string(&Answer::transient(&system.described, &motion)).is_ok()
                        )
                    }
                    Err(error) => short(&error.to_string())?,
                }
            }
            Ok(true)
        }
        Err(text) => short(&text).map(|()| false),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn a_wrong_file_of_bodies_is_refused_on_one_line(
        changes in prop::collection::vec((prop::collection::vec(0usize..8, 1..5), hostile(), 0u8..4), 1..3)
    ) {
        let mut value = by_names();
        for (path, new, how) in &changes {
            change(&mut value, path, new, *how);
        }
        tried(&value)?;
    }

    #[test]
    fn a_wrong_file_of_matrices_is_refused_on_one_line(
        changes in prop::collection::vec((prop::collection::vec(0usize..8, 1..5), hostile(), 0u8..4), 1..3)
    ) {
        let mut value = by_matrices();
        for (path, new, how) in &changes {
            change(&mut value, path, new, *how);
        }
        tried(&value)?;
    }

    #[test]
    fn any_text_is_a_system_or_refused_on_one_line(text in "\\PC{0,200}") {
        if let Err(why) = parsed(&text, "x").and_then(|value| NamedSystem::new(&value, [], Path::new("none"), None)) {
            prop_assert!(!why.contains('\n'), "{why}");
        }
    }
}

#[test]
fn the_files_are_right_before_they_are_changed() {
    for value in [by_names(), by_matrices()] {
        NamedSystem::new(&value, [], Path::new(""), None).unwrap();
        assert!(tried(&value).unwrap());
    }
}

/// Too many bodies are refused before there are matrices of them.
#[test]
fn too_many_bodies_are_refused() {
    let mut text = "[masses]\n".to_owned();
    (0..100_000).for_each(|i| text += &format!("b{i} = 1\n"));
    let refused =
        parsed(&text, "x").and_then(|value| NamedSystem::new(&value, [], Path::new(""), None).map(drop));
    assert_eq!(refused.unwrap_err(), "masses: 100000 of them, must be ≥ 1 and ≤ 2000");
}
