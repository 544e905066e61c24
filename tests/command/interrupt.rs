//! Interrupts are heard within 0.3 s, whatever the command is at; a failure of the system is told.

use crate::command_line::stickslip;
use std::io::{Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

fn start(arguments: &str) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(arguments.split_whitespace())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn signal(child: &Child, name: &str) {
    assert!(Command::new("kill").args([name, &child.id().to_string()]).status().unwrap().success());
}

/// How long it takes to end from now on; it has to within a minute.
fn ends_within(child: &mut Child) -> Duration {
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        assert!(begin.elapsed() < Duration::from_secs(60), "it does not end");
        std::thread::sleep(Duration::from_millis(2));
    }
    begin.elapsed()
}

/// Ends with status 130 and one line, in time, with room for a machine that has other work.
fn heard(mut child: Child, what: &str) {
    let took = ends_within(&mut child);
    let mut message = String::new();
    child.stderr.take().unwrap().read_to_string(&mut message).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{what}: {message}");
    assert!(message.contains("interrupted") && message.lines().count() == 1, "{what}: {message}");
    assert!(took < Duration::from_millis(1500), "{what}: {took:?}");
}

fn place(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_file(&place);
    place
}

#[test]
fn an_interrupt_is_heard_in_the_middle_of_work_that_takes_long() {
    let picture = place("interrupted.svg");
    let map = format!("map stops --omega 0.0001:0.001:500 --alpha 1.5:8:500 --out {}", picture.display());
    for (arguments, name) in [
        ("sweep steady --omega 1e-6:2e-6:600 --alpha 2", "-INT"),
        ("design bands --alpha 1e10 --from 1e-8 --to 1e10", "-TERM"),
        (map.as_str(), "-HUP"),
        #[cfg(feature = "mp")]
        ("simulate --omega 0.00001 --alpha 6 --cycles 100 --bits 8192 --format csv", "-INT"),
        #[cfg(feature = "mp")]
        ("verify --bits 8192", "-INT"),
    ] {
        let mut child = start(arguments);
        // Nobody reads: a writer that waits for its reader hears, too.
        std::thread::sleep(Duration::from_millis(500));
        assert!(child.try_wait().unwrap().is_none(), "{arguments}: over before it was interrupted");
        signal(&child, name);
        heard(child, arguments);
    }
    assert!(!picture.exists());
}

#[test]
fn an_interrupt_is_heard_while_waiting_for_input() {
    for arguments in ["response --points -", "border --points - --format csv", "steady --points -"] {
        let child = start(arguments);
        std::thread::sleep(Duration::from_millis(200));
        signal(&child, "-INT");
        heard(child, arguments);
    }
    let pipe = place("interrupted-pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let child = start(&format!("response --points {}", pipe.display()));
    std::thread::sleep(Duration::from_millis(200));
    signal(&child, "-TERM");
    heard(child, "a pipe that nobody writes to");
    std::fs::remove_file(pipe).unwrap();
}

/// A writer that waits for its reader; the rows that the reader got are whole.
#[test]
fn an_interrupt_is_heard_while_nobody_reads() {
    let mut child = start("sweep response --omega 0.5:2:1000 --alpha 1.1:9:1000");
    std::thread::sleep(Duration::from_millis(500));
    signal(&child, "-INT");
    let took = ends_within(&mut child);
    assert!(took < Duration::from_millis(1500), "{took:?}");
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

/// Work that hears at once, and then has a header to write that nobody reads.
#[test]
fn an_interrupt_is_heard_where_the_last_write_finds_no_reader() {
    let (reader, mut full) = std::io::pipe().unwrap();
    // As much as a pipe of Linux holds.
    full.write_all(&[b'x'; 1 << 16]).unwrap();
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args("simulate --omega 1e-6 --alpha 2 --cycles 9 --samples 1 --format csv".split(' '))
        .stdin(Stdio::null())
        .stdout(full)
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(400));
    signal(&child, "-INT");
    let took = ends_within(&mut child);
    assert!(took < Duration::from_millis(1500), "{took:?}");
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(reader);
}

#[test]
fn a_second_interrupt_ends_at_once() {
    let child = start("sweep steady --omega 1e-6:2e-6:600 --alpha 2");
    std::thread::sleep(Duration::from_millis(300));
    signal(&child, "-INT");
    std::thread::sleep(Duration::from_millis(20));
    signal(&child, "-INT");
    heard(child, "a second interrupt");
}

/// A full disk is no success, and the message says which output it was.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_that_names_the_output() {
    for arguments in [
        "response --omega 1.5 --alpha 2.5",
        "border --omega 0.4 --format json",
        "sweep border --omega 0.5:2:5",
        "steady --omega 0.4 --alpha 6",
        "simulate --omega 0.4 --alpha 6 --cycles 2 --format csv",
        "design bands --alpha 12 --from 0.1 --to 2",
        "decay --x0 12",
        "figure 8",
        "figures",
        "map --omega 0.5:1:3 --alpha 2:3:3",
        "completions bash",
        "man",
        "verify",
        "--help",
        "--version",
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
            .args(arguments.split(' '))
            .stdout(full)
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}: {message}");
        assert!(message.contains("No space left") && message.lines().count() == 1, "{arguments}: {message}");
        if !arguments.starts_with("--") {
            assert!(message.contains("standard output"), "{arguments}: {message}");
        }
    }
}

#[test]
fn what_is_echoed_cannot_reach_the_terminal_as_it_is() {
    for (name, value) in [("--omega", "1\u{1b}[31m"), ("--omega", "1\n2"), ("--alpha", "\u{7}\r2")] {
        let other = if name == "--omega" { "--alpha" } else { "--omega" };
        let output = stickslip("response").args([name, value, other, "2"]).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(message.matches('\n').count(), 1, "{message:?}");
        assert!(!message.trim_end().chars().any(char::is_control), "{message:?}");
    }
}
