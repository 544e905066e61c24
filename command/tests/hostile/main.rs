//! Command lines with every option and with extreme and absurd values: each ends in time and within its memory, with an
//! answer or with one line that says what is wrong.
//!
//! An ordinary run draws some lines; `.ci/slow hostile` draws LINES of them from SEED. A line that breaks a promise is
//! printed, so that it can be run by itself in the folder of its files.
#![cfg(target_os = "linux")]

mod lines;

use lines::Lines;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// The address space of a command in KiB; its answers take far less than 300 MB of memory, and the threads' stacks, the
/// program and its libraries are counted here, too.
const SPACE: u64 = 600_000;

/// The time of an answer, and of a refusal. The work of a refused command is that before its reason was found.
const LONGEST: Duration = Duration::from_secs(10);

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

/// Runs a line in a folder: its end, and the time it took.
fn run(line: &[String], folder: &Path, longest: Duration) -> (End, Duration) {
    let program = assert_cmd::cargo::cargo_bin!("stickslip");
    let limits = format!("ulimit -v {SPACE}; ulimit -f 200000; exec \"$0\" \"$@\"");
    let begin = Instant::now();
    let output = Command::new("timeout")
        .args(["--signal=KILL", &format!("{}", longest.as_secs_f64()), "sh", "-c", &limits])
        .arg(program)
        .args(line)
        .env("MALLOC_ARENA_MAX", "2")
        .env("RAYON_NUM_THREADS", "2")
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let time = begin.elapsed();
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
        None | Some(137) if output.stdout.len() > 1 << 20 => End::Answered,
        None | Some(137) => End::Broken(format!("no end in {longest:?}")),
        Some(code) => End::Broken(format!("status {code}")),
    };
    match end {
        End::Broken(what) => {
            let said = message.lines().take(3).collect::<Vec<_>>().join(" | ");
            (End::Broken(format!("{what}: {said}")), time)
        }
        end => (end, time),
    }
}

#[test]
fn hostile_lines_are_answered_or_refused_in_time() {
    let (count, seed) = (number("LINES", 60), number("SEED", 1));
    // An unoptimised command is slower.
    let longest = LONGEST * if cfg!(debug_assertions) { 3 } else { 1 };
    let next = AtomicU64::new(0);
    let found = Mutex::new((BTreeMap::<&str, u64>::new(), Vec::<(Duration, String)>::new(), Vec::new()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    if place >= count {
                        break;
                    }
                    let folder = tempfile::tempdir().unwrap();
                    lines::write_files(folder.path());
                    let line = Lines::new(seed, place).line();
                    let (end, time) = run(&line, folder.path(), longest);
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
                    found.1.push((time, shown));
                    found.1.sort_by_key(|line| std::cmp::Reverse(line.0));
                    found.1.truncate(5);
                }
            });
        }
    });
    let (counts, longest, broken) = found.into_inner().unwrap();
    let mut text = format!("{count} lines: {counts:?}\n");
    for (time, line) in &longest {
        let _ = writeln!(text, "{:.2} s: {line}", time.as_secs_f64());
    }
    #[allow(clippy::print_stdout, reason = "the counts, which --nocapture shows")]
    {
        println!("{text}");
    }
    assert!(broken.is_empty(), "{}\n{text}", broken.join("\n"));
    // Hostile lines of which none is answered would test the reading of arguments only.
    assert!(counts.get("answered").is_some_and(|answered| answered * 20 > count), "{counts:?}");
}
