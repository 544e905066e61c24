//! Fifteen questions about drives and loads, as a user asks them, beside the values of `tests/data/questions.py`, which shares nothing with the
//! library.

use crate::command_line::{said, stickslip};
use crate::place::place;
use serde_json::Value;

/// Each is a command with its files. Where a number of others is known, it is in the module of its test: `drives.rs` and `tests/systems`.
#[test]
fn fifteen_questions_have_the_values_of_another_program() {
    let all: Value = serde_json::from_str(include_str!("../../../../tests/data/questions.json")).unwrap();
    let all = all.as_array().unwrap();
    assert_eq!(all.len(), 15);
    for (i, own) in all.iter().enumerate() {
        let folder = place(&format!("question_{i}"));
        std::fs::create_dir(&*folder).unwrap();
        let files = own["files"].as_object().unwrap();
        for (name, text) in files {
            std::fs::write(folder.join(name), text.as_str().unwrap()).unwrap();
        }
        let words = own["command"].as_str().unwrap().split(' ');
        let mut run = stickslip("");
        for word in words {
            if files.contains_key(word) {
                run.arg(folder.join(word))
            } else {
                run.arg(word)
            };
        }
        let run = run.args(["--format", "json"]).assert();
        let output = run.get_output();
        let asked = own["question"].as_str().unwrap();
        assert!(output.status.success(), "{asked}: {}", said(&output.stderr));
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        let values = own["values"].as_object().unwrap();
        assert!(!values.is_empty(), "{asked}");
        for (place, due) in values {
            let [ours, due, within] =
                [found.pointer(place), due.get(0), due.get(1)].map(|number| number.and_then(Value::as_f64));
            let (Some(ours), Some(due), Some(within)) = (ours, due, within) else {
                panic!("{asked}: {place} is not in {found}");
            };
            assert!((ours - due).abs() <= within, "{asked}: {place} is {ours} for {due}");
        }
    }
}
