//! The limits of many starts, interrupted and resumed.

use crate::command_line::{listens, refused, stdout, stickslip};
use crate::place::place;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// Machines with three limits; with a range of rest next to a motion; with irregular motions; with starts
/// that do not settle.
const MACHINES: [&str; 4] = [
    "--omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87",
    "--omega 0.8 --alpha 1.5 --damping-ratio 0.02 --static-friction-ratio 1.6",
    "--omega 0.45 --alpha 8.5 --damping-ratio 0.02 --static-friction-ratio 3 --max-periods 300",
    "--omega 0.45 --alpha 5 --damping-ratio 0.002 --static-friction-ratio 1.4 --max-periods 40",
];

/// The output of a command with this number of threads.
fn with_threads(line: &str, threads: usize) -> String {
    let threads = threads.to_string();
    let output =
        stickslip(line).env("RAYON_NUM_THREADS", threads).assert().success().get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

#[test]
fn limits_of_starts_go_on_after_the_last_whole_row() {
    for (index, machine) in MACHINES.into_iter().enumerate() {
        for question in [
            format!("attractors {machine} --reach 12 --starts 25 --format json"),
            format!("basins {machine} --x0 -6:6:5 --v0 -4:4:3"),
        ] {
            let (file, kept) = (place("starts-whole"), place("starts-kept"));
            let answer = with_threads(&format!("{question} --rows {}", file.display()), 2);
            assert_eq!(answer, with_threads(&question, 1), "{question}: rows change the answer");
            let rows = std::fs::read(&file).unwrap();
            let header = rows.iter().position(|byte| *byte == b'\n').unwrap() + 1;
            let first = rows[header..].iter().position(|byte| *byte == b'\n').unwrap() + header;
            for (turn, length) in [0, 9, header, first, first + 1, rows.len() / 2, rows.len() - 1, rows.len()]
                .into_iter()
                .enumerate()
            {
                std::fs::write(&kept, &rows[..length]).unwrap();
                let line = format!("{question} --rows {} --resume", kept.display());
                let found = with_threads(&line, 1 + (turn + index) % 3);
                assert_eq!(found, answer, "{question}: from {length} bytes");
                assert!(std::fs::read(&kept).unwrap() == rows, "{question}: from {length} bytes");
            }
        }
    }
}

/// Where no start settles, rows have their header, and a note says why there are none.
#[test]
fn where_nothing_settles_rows_have_their_header() {
    let line = |rest: &str| {
        let machine = "--omega 0.45 --alpha 5 --damping-ratio 0.002 --static-friction-ratio 1.4";
        format!("attractors {machine} --max-periods 2 --starts 3 {rest}")
    };
    let settled = stdout(&line("--format csv").replace("--max-periods 2", "--max-periods 2000"));
    let note = "stickslip: note: 3 of 3 starts had not settled. Allow more periods with --max-periods.\n";
    let none = stickslip(&line("--format csv")).assert().success().stderr(note).get_output().stdout.clone();
    assert_eq!(
        String::from_utf8(none).unwrap().lines().collect::<Vec<_>>(),
        [settled.lines().next().unwrap()]
    );
    stickslip(&line("--format jsonl")).assert().success().stdout("").stderr(note);
    stickslip(&line("--format csv --quiet")).assert().success().stderr("");
    assert!(stdout(&line("")).starts_with("No limit from 3 starts"));
}

/// The run is killed at several moments, and resumed each time until it is complete.
#[test]
fn a_killed_run_goes_on() {
    // It is slow enough to be killed while it runs: a start takes some 200 turns of a chaotic motion.
    let question = "attractors --omega 0.45 --alpha 8.5 --damping-ratio 0.02 --static-friction-ratio 3 \
        --max-periods 400 \
                    --starts 300";
    let (file, kept) = (place("starts-unbroken"), place("starts-killed"));
    let answer = stdout(&format!("{question} --rows {}", file.display()));
    let mut cut = 0;
    for attempt in 0..4u64 {
        let line = format!("{question} --rows {} --resume", kept.display());
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
            .args(line.split_whitespace())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        listens(&mut child);
        std::thread::sleep(Duration::from_millis(60 + 90 * attempt));
        let signal = if attempt % 2 == 0 { "-KILL" } else { "-INT" };
        let _ = Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
        cut += u32::from(!child.wait().unwrap().success());
    }
    assert!(cut > 0, "no run was cut");
    let found = stdout(&format!("{question} --rows {} --resume", kept.display()));
    assert_eq!(found, answer);
    assert!(std::fs::read(&kept).unwrap() == std::fs::read(&file).unwrap());
}

/// The starts form a sequence: a run with more starts continues one with fewer.
#[test]
fn more_starts_go_on_with_fewer() {
    let (few, many) = (place("starts-few"), place("starts-many"));
    let line = |count: u32, rows: &Path| {
        format!("attractors {} --reach 12 --starts {count} --rows {}", MACHINES[0], rows.display())
    };
    stdout(&line(10, &few));
    let answer = stdout(&line(30, &many));
    assert_eq!(stdout(&format!("{} --resume", line(30, &few))), answer);
    assert!(std::fs::read(&few).unwrap() == std::fs::read(&many).unwrap());
}

#[test]
fn the_starts_of_another_run_are_not_gone_on_with() {
    let file = place("starts-another");
    let line = |machine: &str, rest: &str| {
        format!("attractors {machine} --starts 12 {rest} --rows {} --resume", file.display())
    };
    let pair = MACHINES[0];
    stdout(&line(pair, "--reach 12"));
    let kept = std::fs::read_to_string(&file).unwrap();
    let not_these = "row 1 is not of these starts";
    refused(&line(MACHINES[1], "--reach 12"), &["--resume: ", not_these]);
    refused(&line(&pair.replace("1.87", "1.88"), "--reach 12"), &[not_these]);
    refused(&line(&pair.replace("0.005", "0.006"), "--reach 12"), &[not_these]);
    refused(&line(pair, "--reach 12 --max-periods 1000"), &[not_these]);
    refused(&line(pair, "--reach 13"), &["row 2 is not of these starts"]);
    refused(&line(pair, "--reach 12").replace("--starts 12", "--starts 9"), &["12 rows, must be ≤ 9"]);
    refused(
        &line(pair, "--reach 12").replace(" --resume", ""),
        &["must not exist yet. Continue it with --resume"],
    );
    refused(&format!("attractors {pair} --resume"), &["--rows"]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), kept);
    // Another limit in a row, and another digit of a limit's first row.
    for (from, to) in [
        ("periodic,2,", "periodic,4,"),
        ("periodic,2,-2.56", "periodic,2,-2.57"),
        ("periodic,2,", "irregular,,"),
    ] {
        let changed = kept.replacen(from, to, 1);
        assert_ne!(changed, kept);
        std::fs::write(&file, &changed).unwrap();
        refused(&line(pair, "--reach 12"), &["is not of these starts"]);
        assert_eq!(std::fs::read_to_string(&file).unwrap(), changed);
    }
}

/// Whatever is changed in the file, a resumed run gives the same answer or leaves the file alone.
#[test]
fn rows_changed_anywhere_are_made_whole_or_left_alone() {
    let (file, kept) = (place("starts-intact"), place("starts-changed"));
    let question = format!("attractors {} --reach 12 --starts 9", MACHINES[1]);
    let answer = stdout(&format!("{question} --rows {}", file.display()));
    let rows = std::fs::read(&file).unwrap();
    let mut refused = 0;
    for (number, place) in (3..rows.len()).step_by(31).enumerate() {
        let mut changed = rows[..rows.len() - number % 50].to_vec();
        let place = place.min(changed.len() - 1);
        changed[place] ^= 1 << (number % 7);
        std::fs::write(&kept, &changed).unwrap();
        let output = stickslip(&format!("{question} --rows {} --resume", kept.display())).output().unwrap();
        let now = std::fs::read(&kept).unwrap();
        if output.status.success() {
            assert!(now == rows && output.stdout == answer.as_bytes(), "byte {place}");
        } else {
            assert!(
                output.status.code() == Some(2) && output.stdout.is_empty() && now == changed,
                "byte {place}"
            );
            refused += 1;
        }
    }
    assert!(refused > 20, "{refused}");
}
