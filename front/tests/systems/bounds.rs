//! Files that are too large, or that name what has no end, are refused before they take memory or time.

use serde_json::Value;
use std::path::Path;
use stickslip_front::system::{LONGEST, MOST_VALUES, NamedSystem, decoded, parsed};
use stickslip_front::text::UTF16;

fn refused(text: &str) -> String {
    let built =
        parsed(text, "x").and_then(|value| NamedSystem::new(&value, [], Path::new("none"), None).map(drop));
    built.unwrap_err()
}

/// A body with this after it.
fn body(rest: &str) -> String {
    format!("masses = {{ block = 1 }}\n{rest}")
}

#[test]
fn a_file_has_a_greatest_length_and_a_greatest_number_of_values() {
    assert_eq!(decoded(vec![b' '; LONGEST + 1], "x"), Err(format!("x: must be ≤ {LONGEST} bytes")));
    let list = format!("[{}1]", "1,".repeat(MOST_VALUES));
    for text in [format!("{{\"mass\": {list}}}"), format!("mass = {list}\n")] {
        assert!(refused(&text).ends_with(&format!("values, must have ≤ {MOST_VALUES}")));
    }
    let blank = body(&"\n".repeat(LONGEST / 2 + 1));
    assert_eq!(refused(&blank), format!("x: must be ≤ {} bytes, or JSON", LONGEST / 2));
}

/// Matrices of the most coordinates with all digits are read.
#[test]
fn the_largest_matrices_are_within_the_limits() {
    let n = 200;
    let entry = |i: usize, j: usize| if i == j { 2.345_678_901_234_568 } else { -1.234_567_890_123_456_8e-3 };
    let matrix: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let text = serde_json::json!({"mass": matrix, "stiffness": matrix, "damping": matrix, "elements": []})
        .to_string();
    NamedSystem::new(&parsed(&text, "x").unwrap(), [], Path::new(""), None).unwrap();
}

#[test]
fn frequencies_and_records_have_a_greatest_number() {
    let force = |i: usize| format!("[[forces]]\non = \"block\"\namplitude = 1\nfrequency = {i}\n");
    let forces = |count: usize| body(&(1..=count).map(force).collect::<String>());
    let built = NamedSystem::new(&parsed(&forces(1000), "x").unwrap(), [], Path::new(""), None).unwrap();
    assert_eq!(built.described.model.harmonics.len(), 1000);
    assert_eq!(
        refused(&forces(20_001)),
        "forces[20001].frequency 20001: must be one of ≤ 20000 frequencies in the file"
    );
    let contact = "[[contacts]]\nbetween = [\"ground\", \"block\"]\nfriction = 1\n";
    // 3,000,000/(4 + 70·50) = 856.2.
    for (count, is_refused) in [(856, false), (857, true)] {
        let text = forces(count) + &contact.repeat(50);
        let found = parsed(&text, "x").and_then(|value| NamedSystem::new(&value, [], Path::new(""), None));
        let due =
            "loads: 857 frequencies and records, must be ≤ 856 with these coordinates, contacts and stops";
        assert_eq!(found.err(), is_refused.then(|| due.to_owned()));
    }
    // Any number of them at one frequency.
    parsed(&body(&force(1).repeat(2000)), "x")
        .and_then(|value| NamedSystem::new(&value, [], Path::new(""), None))
        .unwrap();
    let harmonics = vec!["{\"frequency\": 1}"; 20_001].join(",");
    let text = format!("{{\"mass\": [[1]], \"harmonics\": [{harmonics}]}}");
    assert_eq!(refused(&text), "harmonics: 20001 of them, must be ≤ 20000");
    let numbers = |count: usize| (0..count).map(|i| i.to_string()).collect::<Vec<_>>().join(",");
    let record = |times: usize, values: usize, force: usize| {
        let lists = [("times", times), ("values", values), ("force", force)];
        let lists = lists.map(|(name, count)| format!("\"{name}\": [{}]", numbers(count)));
        format!("{{\"mass\": [[1]], \"record\": {{{}}}}}", lists.join(","))
    };
    assert_eq!(refused(&record(3, 2, 1)), "record.values: has 2 numbers, must have 3");
    assert_eq!(refused(&record(3, 3, 2)), "record.force: has 2 numbers, must have 1");
}

/// Of two values under one name one would be lost.
#[test]
fn a_name_is_given_once() {
    for (text, name) in [
        ("{\"masses\": {\"a\": 1, \"a\": 2}}", "a must be given once at line 1"),
        ("{\"masses\": {\"a\": 1},\n \"masses\": {\"b\": 1}}", "masses must be given once at line 2"),
        (
            "{\"mass\": [[1]], \"harmonics\": [{\"frequency\": 1, \"frequency\": 2}]}",
            "frequency must be given once",
        ),
        ("masses = { a = 1 }\nmasses = { b = 1 }\n", "line 2: duplicate key"),
    ] {
        let why = refused(text);
        assert!(why.contains(name), "{why}");
    }
}

/// The reader of JSON that refuses such names reads everything else as another reader does.
#[test]
fn json_is_read_as_by_its_own_reader() {
    let text = r#"{"a": [1, -2, 0.1, 1e300, 18446744073709551615, -9223372036854775808, 5e-324, -0.0, "µ\n\u001b", true, false, null, [[]], {}],
                   "b": {"z": 1, "a": {"z": 2}}, "": 0}"#;
    assert_eq!(parsed(text, "x").unwrap(), serde_json::from_str::<Value>(text).unwrap());
    let keys: Vec<String> = parsed(text, "x").unwrap().as_object().unwrap().keys().cloned().collect();
    assert_eq!(keys, ["a", "b", ""]);
    let deep = format!("{{\"a\": {}", "[".repeat(100_000));
    assert!(refused(&deep).contains("recursion limit"));
}

#[test]
fn a_text_of_sixteen_bits_is_named() {
    let text = body("");
    let bytes: Vec<u8> =
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    assert_eq!(decoded(bytes, "x"), Err(format!("x: {UTF16}")));
    assert_eq!(decoded(text.clone().into_bytes(), "x"), Ok(text));
}

/// A device has no end, and a pipe may have no writer.
#[cfg(target_os = "linux")]
#[test]
fn files_in_a_file_are_regular_files() {
    let contact = |law: &str| {
        format!(
            "[[contacts]]\nbetween = [\"ground\", \"block\"]\nlaw = \"{law}\"\n[[forces]]\non = \"block\"\n"
        )
    };
    for device in ["/dev/zero", "/dev/null", "/proc"] {
        let why = refused(&body(&format!("{}constant = 1\n", contact(device))));
        assert_eq!(why, format!("contacts[1].law: {device}: must be a regular file"));
        let why = refused(&body(&format!("[[forces]]\non = \"block\"\nrecord = \"{device}\"\n")));
        assert_eq!(why, format!("forces[1].record: {device}: must be a regular file"));
        let why = refused(&body(&format!("[base]\nacceleration = \"{device}\"\n")));
        assert_eq!(why, format!("base.acceleration: {device}: must be a regular file"));
    }
}

#[test]
fn names_have_no_control_characters() {
    for letter in ["\\u001b", "\\n", "\\u0085", "\\ufffe", "\\uffff", "\\u0000"] {
        let name = format!("a{letter}b");
        for (text, place) in [
            (format!("{{\"masses\": {{\"{name}\": 1}}}}"), "masses."),
            (
                format!(
                    "{{\"masses\": {{\"a\": 1}}, \"stops\": [{{\"name\": \"{name}\", \"between\": [\"ground\", \"a\"], \"gap\": 1, \"stiffness\": 1}}]}}"
                ),
                "stops[1].name",
            ),
            (
                format!(
                    "{{\"masses\": {{\"a\": 1}}, \"springs\": [{{\"name\": \"{name}\", \"between\": [\"ground\", \"a\"]}}]}}"
                ),
                "springs[1].name",
            ),
            (
                format!(
                    "{{\"masses\": {{\"a\": 1}}, \"forces\": [{{\"name\": \"{name}\", \"on\": \"a\", \"constant\": 1}}]}}"
                ),
                "forces[1].name",
            ),
            (
                format!(
                    "{{\"mass\": [[1]], \"elements\": [{{\"name\": \"{name}\", \"type\": \"contact\", \"direction\": [1], \"friction\": 1}}]}}"
                ),
                "elements[1].name",
            ),
        ] {
            let why = refused(&text);
            assert!(
                why.starts_with(place) && why.ends_with("a name must have no control characters"),
                "{why}"
            );
        }
    }
}
