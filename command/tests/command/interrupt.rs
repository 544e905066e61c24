//! An interrupt takes effect within 0.3 s, whatever the command is doing; a system failure is reported.

use crate::command_line::{listens, said, stickslip};
use crate::place::place;
use std::io::{Read, Write};
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

/// The time until the process ends, and the time allowed: 0.3 s, plus four times the delay of a simultaneous
/// process that sleeps for 0.25 s, which measures process start and other load. Some threads of the command
/// have to be woken in turn.
fn ends_within(child: &mut Child) -> (Duration, Duration) {
    const SLEEP: Duration = Duration::from_millis(250);
    let begin = Instant::now();
    let mut sleeper = Command::new("sleep").arg("0.25").spawn().unwrap();
    let (mut took, mut slept) = (None, None);
    loop {
        if took.is_none() && child.try_wait().unwrap().is_some() {
            took = Some(begin.elapsed());
        }
        if slept.is_none() && sleeper.try_wait().unwrap().is_some() {
            slept = Some(begin.elapsed());
        }
        if let (Some(took), Some(slept)) = (took, slept) {
            return (took, Duration::from_millis(300) + 4 * slept.saturating_sub(SLEEP));
        }
        assert!(begin.elapsed() < Duration::from_secs(60), "it does not end");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Interrupts the process that `interrupted` starts. One of three attempts must end in time, because a single
/// delay may be due to the machine.
fn ends_in_time(what: &str, interrupted: impl Fn() -> Child) -> Child {
    let mut late = Vec::new();
    for _ in 0..3 {
        let mut child = interrupted();
        let (took, allowed) = ends_within(&mut child);
        if took <= allowed {
            return child;
        }
        late.push((took, allowed));
    }
    panic!("{what}: (took, allowed) {late:?}");
}

/// The process ends with status 130 and one line, in time.
fn heard(what: &str, interrupted: impl Fn() -> Child) {
    let mut child = ends_in_time(what, interrupted);
    let mut message = Vec::new();
    child.stderr.take().unwrap().read_to_end(&mut message).unwrap();
    let message = said(&message);
    assert_eq!(child.wait().unwrap().code(), Some(130), "{what}: {message}");
    assert!(message.contains("interrupted") && message.lines().count() == 1, "{what}: {message}");
}

/// A command that gets a signal after some milliseconds of work.
fn interrupted(arguments: &str, after: u64, name: &str) -> Child {
    let mut child = start(arguments);
    listens(&mut child);
    std::thread::sleep(Duration::from_millis(after));
    assert!(child.try_wait().unwrap().is_none(), "{arguments}: over before it was interrupted");
    signal(&child, name);
    child
}

#[test]
fn an_interrupt_is_heard_in_the_middle_of_work_that_takes_long() {
    let picture = place("interrupted.svg");
    let map = format!("map stops --omega 0.0001:0.001:500 --alpha 1.5:8:500 --out {}", picture.display());
    let file = place("interrupted.toml");
    std::fs::write(&file, crate::systems::MACHINE).unwrap();
    // A motion of 900,000 steps, alone and in each row of a grid.
    let motion = format!("system {} simulate --until 20000s", file.display());
    let grid = format!("{motion} --set bearing.friction=300N,450N,600N");
    for (arguments, name) in [
        (motion.as_str(), "-INT"),
        (grid.as_str(), "-INT"),
        ("sweep steady --omega 1e-6:2e-6:600 --alpha 2", "-INT"),
        ("design bands --alpha 1e10 --from 1e-8 --to 1e10", "-TERM"),
        (map.as_str(), "-HUP"),
        #[cfg(feature = "mp")]
        ("simulate --omega 0.00001 --alpha 6 --cycles 100 --bits 8192 --format csv", "-INT"),
        #[cfg(feature = "mp")]
        ("verify --bits 8192", "-INT"),
    ] {
        // Nobody reads the output: a writer that waits for its reader is interrupted, too.
        heard(arguments, || interrupted(arguments, 500, name));
    }
    assert!(!picture.exists());
}

#[test]
fn an_interrupt_is_heard_while_waiting_for_input() {
    for arguments in ["response --points -", "border --points - --format csv", "steady --points -"] {
        heard(arguments, || interrupted(arguments, 200, "-INT"));
    }
    let pipe = place("interrupted-pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let waiting = format!("response --points {}", pipe.display());
    heard("a pipe that nobody writes to", || interrupted(&waiting, 200, "-TERM"));
}

/// A writer waits for its reader; the rows that the reader received are complete.
#[test]
fn an_interrupt_is_heard_while_nobody_reads() {
    let sweep = "sweep response --omega 0.5:2:1000 --alpha 1.1:9:1000";
    let mut child = ends_in_time(sweep, || interrupted(sweep, 500, "-INT"));
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

/// The work is interrupted immediately, and a header that nobody reads has yet to be written.
#[test]
fn an_interrupt_is_heard_where_the_last_write_finds_no_reader() {
    let (reader, mut full) = std::io::pipe().unwrap();
    // The capacity of a pipe on Linux.
    full.write_all(&[b'x'; 1 << 16]).unwrap();
    let mut child = ends_in_time("a full pipe", || {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
            .args("simulate --omega 1e-6 --alpha 2 --cycles 9 --samples 1 --format csv".split(' '))
            .stdin(Stdio::null())
            .stdout(full.try_clone().unwrap())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        listens(&mut child);
        std::thread::sleep(Duration::from_millis(400));
        signal(&child, "-INT");
        child
    });
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(reader);
}

#[test]
fn a_second_interrupt_ends_at_once() {
    // While it waits for input, the process notices a signal only at the end of a 0.15 s interval.
    let mut late = Vec::new();
    for _ in 0..5 {
        let mut child = interrupted("response --points -", 300, "-INT");
        std::thread::sleep(Duration::from_millis(10));
        signal(&child, "-INT");
        let (took, allowed) = ends_within(&mut child);
        assert_eq!(child.wait().unwrap().code(), Some(130));
        if took + Duration::from_millis(220) <= allowed {
            return;
        }
        late.push((took, allowed));
    }
    panic!("(took, allowed and 0.22 s more) {late:?}");
}

/// A full disk is a failure, and the message names the output.
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
