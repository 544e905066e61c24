//! Running the command in a test: shared by the tests of each of its parts.

#![allow(dead_code, reason = "each test takes what it needs")]

use assert_cmd::Command;
use serde_json::Value;

/// The command with the arguments of a line.
pub(crate) fn stickslip(arguments: &str) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"));
    command.args(arguments.split_whitespace());
    command
}

/// What it prints where it succeeds, with nothing on standard error.
pub(crate) fn stdout(arguments: &str) -> String {
    let output = stickslip(arguments).assert().success().stderr("").get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

/// The same as JSON.
pub(crate) fn json(arguments: &str) -> Value {
    serde_json::from_str(&stdout(arguments)).unwrap()
}

/// Exit status 2, nothing on standard output, one line on standard error that has all of `parts`.
pub(crate) fn refused(arguments: &str, parts: &[&str]) {
    let assert = stickslip(arguments).assert().code(2).stdout("");
    let text = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert_eq!(text.matches('\n').count(), 1, "{arguments}: {text}");
    for part in parts {
        assert!(text.contains(part), "{arguments}: “{part}” is not in “{text}”");
    }
}
