//! Helpers that run the command, shared by the tests of its parts.

#![allow(dead_code, reason = "each test takes what it needs")]

use assert_cmd::Command;
use serde_json::Value;

/// The command with the arguments of a line.
pub(crate) fn stickslip(arguments: &str) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"));
    command.args(arguments.split_whitespace());
    for colours in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
        command.env_remove(colours);
    }
    command
}

/// The line on standard error after two seconds, where that is no terminal.
pub(crate) const GOES_ON: &str = "stickslip: note: still computing. Ctrl-C ends it\n";

/// Standard error without that line, which a slow machine adds.
pub(crate) fn said(stderr: &[u8]) -> String {
    String::from_utf8(stderr.to_vec()).unwrap().replace(GOES_ON, "")
}

/// The standard output of a successful run with empty standard error.
pub(crate) fn stdout(arguments: &str) -> String {
    let assert = stickslip(arguments).assert().success();
    let output = assert.get_output();
    assert_eq!(said(&output.stderr), "", "{arguments}");
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Waits until a process of the command handles signals, or ends: an earlier signal would end it at once.
///
/// Where there is no `/proc` it does not wait.
pub(crate) fn listens(child: &mut std::process::Child) {
    // SIGHUP, SIGINT and SIGTERM are 1, 2 and 15.
    const ALL: u64 = 1 | 1 << 1 | 1 << 14;
    let status = format!("/proc/{}/status", child.id());
    while let (Ok(text), None) = (std::fs::read_to_string(&status), child.try_wait().unwrap()) {
        let caught = text.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        if u64::from_str_radix(caught.trim(), 16).unwrap() & ALL == ALL {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
}

/// The same, parsed as JSON.
pub(crate) fn json(arguments: &str) -> Value {
    serde_json::from_str(&stdout(arguments)).unwrap()
}

/// The run must fail with exit status 2, an empty standard output, and one line on standard error that
/// contains all of `parts`.
pub(crate) fn refused(arguments: &str, parts: &[&str]) {
    let assert = stickslip(arguments).assert().code(2).stdout("");
    let text = said(&assert.get_output().stderr);
    assert_eq!(text.matches('\n').count(), 1, "{arguments}: {text}");
    // What a message quotes is the input's.
    let own: String =
        text.split('“').map(|part| part.split_once('”').map_or(part, |(_, rest)| rest)).collect();
    assert!(arguments.contains(';') || !own.contains(';'), "{arguments}: a semicolon in “{text}”");
    for part in parts {
        assert!(text.contains(part), "{arguments}: “{part}” is not in “{text}”");
    }
}
