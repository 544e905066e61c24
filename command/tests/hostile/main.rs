//! Command lines with every option and with extreme and absurd values: each ends in time and within its memory, with an
//! answer or with one line that says what is wrong.
//!
//! An ordinary run draws some lines; `.ci/slow hostile` draws LINES of them from SEED, from the line FIRST on. A line that
//! breaks a promise is printed, so that it can be run by itself in the folder of its files.
#![cfg(target_os = "linux")]

#[path = "../../../tests/random/generator.rs"]
mod generator;
mod lines;

use lines::Lines;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// The memory of a command in KiB: that of its data, which the system refuses beyond, and the greatest that it may occupy.
const MEMORY: u64 = 300_000;

/// The processor seconds of an answer, and of a refusal. The work of a refused command is that before its reason was found.
const LONGEST: u64 = 10;

/// The time after which a line that does not end is killed, whatever it waits for.
const WAITING: Duration = Duration::from_secs(300);

/// The number in an environment variable.
fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// The end of a line.
enum End {
    Answered,
    Refused,
    Broken(String),
}

/// What a line took.
#[derive(Debug, Clone, Copy)]
struct Taken {
    processor: Duration,
    /// The greatest memory in KiB.
    memory: u64,
}

/// What the children of this process that have ended took, or one that has not: both from the system's files.
fn taken(process: &Path) -> Option<Taken> {
    let status = std::fs::read_to_string(process.join("status")).ok()?;
    let memory = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let memory = memory.split_whitespace().next()?.parse().ok()?;
    let times = std::fs::read_to_string(process.join("stat")).ok()?;
    // After the name in parentheses: the user's and the system's time are the 12th and 13th, in hundredths of a second.
    let numbers: Vec<&str> = times.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |at: usize| numbers.get(at).and_then(|text| text.parse::<u64>().ok());
    Some(Taken { processor: Duration::from_millis(10 * (ticks(11)? + ticks(12)?)), memory })
}

/// Runs a line in a folder: its end, and what it took.
fn run(line: &[String], folder: &Path, longest: u64) -> (End, Taken) {
    let program = assert_cmd::cargo::cargo_bin!("stickslip");
    let limits = format!("ulimit -d {MEMORY}; ulimit -f 200000; ulimit -t {longest}; exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    let mut child = command
        .args(["-c", &limits])
        .arg(program)
        .args(line)
        .env("MALLOC_ARENA_MAX", "2")
        .env("RAYON_NUM_THREADS", "2")
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let (mut out, mut errors) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
    let (mut stdout, mut stderr) = (Vec::new(), Vec::new());
    let process = PathBuf::from(format!("/proc/{}", child.id()));
    let mut taken = Taken { processor: Duration::ZERO, memory: 0 };
    let status = std::thread::scope(|scope| {
        scope.spawn(|| out.read_to_end(&mut stdout).unwrap());
        scope.spawn(|| errors.read_to_end(&mut stderr).unwrap());
        let begin = Instant::now();
        loop {
            if let Some(now) = self::taken(&process) {
                taken = Taken { processor: now.processor, memory: now.memory.max(taken.memory) };
            }
            if let Some(status) = child.try_wait().unwrap() {
                break status;
            }
            // One that waits takes no time of the processor.
            if begin.elapsed() > WAITING {
                child.kill().unwrap();
            }
            std::thread::sleep(Duration::from_millis(3));
        }
    });
    let output = Output { status, stdout, stderr };
    let message = String::from_utf8_lossy(&output.stderr);
    let lines = message.lines().count();
    let end = match output.status.code() {
        Some(0) => {
            if String::from_utf8_lossy(&output.stdout).contains("NaN") {
                End::Broken("says NaN".to_owned())
            } else {
                End::Answered
            }
        }
        Some(2) if output.stdout.is_empty() && (1..=3).contains(&lines) => End::Refused,
        // Rows that were answered before a bad one are kept.
        Some(2) if lines >= 1 && output.stdout.ends_with(b"\n") => End::Refused,
        // An unfulfilled search, or a statement that does not hold, has a reason in words.
        Some(1) if (1..=3).contains(&lines) && !message.contains("os error 12") => End::Refused,
        // An answer of very many rows that comes as it is computed.
        None if output.stdout.len() > 1 << 20 => End::Answered,
        None => End::Broken(format!("no end after {:.1?} of the processor", taken.processor)),
        Some(code) => End::Broken(format!("status {code}")),
    };
    let end =
        if taken.memory > MEMORY { End::Broken(format!("{} KiB of memory", taken.memory)) } else { end };
    match end {
        End::Broken(what) => {
            let said = message.lines().take(3).collect::<Vec<_>>().join(" | ");
            (End::Broken(format!("{what}: {said}")), taken)
        }
        end => (end, taken),
    }
}

#[test]
fn hostile_lines_are_answered_or_refused_in_time() {
    let (count, seed, first) = (number("LINES", 60), number("SEED", 1), number("FIRST", 0));
    // An unoptimised command is slower.
    let longest = LONGEST * if cfg!(debug_assertions) { 3 } else { 1 };
    let next = AtomicU64::new(first);
    let found = Mutex::new((BTreeMap::<&str, u64>::new(), Vec::<(Taken, String)>::new(), Vec::new()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    if place >= first + count {
                        break;
                    }
                    let folder = tempfile::tempdir().unwrap();
                    lines::write_files(folder.path());
                    let line = Lines::new(seed, place).line();
                    let (end, taken) = run(&line, folder.path(), longest);
                    let shown = line.join(" ");
                    let mut found = found.lock().unwrap();
                    let name = match end {
                        End::Answered => "answered",
                        End::Refused => "refused",
                        End::Broken(what) => {
                            found.2.push(format!("{what}\n    stickslip {shown}"));
                            "broken"
                        }
                    };
                    *found.0.entry(name).or_default() += 1;
                    found.1.push((taken, shown));
                    let longest = |line: &(Taken, String)| Reverse(line.0.processor);
                    let largest = |line: &(Taken, String)| Reverse(line.0.memory);
                    // The longest and the largest ones.
                    found.1.sort_by_key(largest);
                    let count = found.1.len().min(3);
                    let rest = found.1.split_off(count);
                    let mut kept = std::mem::replace(&mut found.1, rest);
                    found.1.sort_by_key(longest);
                    found.1.truncate(5);
                    found.1.append(&mut kept);
                }
            });
        }
    });
    let (counts, longest, broken) = found.into_inner().unwrap();
    let mut text = format!("{count} lines: {counts:?}\n");
    for (Taken { processor, memory }, line) in &longest {
        let _ = writeln!(text, "{:.2} s, {} MB: {line}", processor.as_secs_f64(), memory / 1000);
    }
    #[allow(clippy::print_stdout, reason = "the counts, which --nocapture shows")]
    {
        println!("{text}");
    }
    assert!(broken.is_empty(), "{}\n{text}", broken.join("\n"));
    // Hostile lines of which none is answered would test the reading of arguments only.
    assert!(counts.get("answered").is_some_and(|answered| answered * 20 > count), "{counts:?}");
}
