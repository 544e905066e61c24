//! Sweeps that go on after an interruption.

use crate::command_line::{refused, stdout, stickslip};
use crate::place::place;
use crate::random::Random;

#[test]
fn a_sweep_goes_on_after_its_last_whole_row() {
    for arguments in [
        "response --omega 0.3:1.3:40 --alpha 1.5:8:25",
        "response --omega 0.3:1.3:40 --alpha 1.5:8:25 --shard 2/3 --no-header",
        "steady --omega 0.3:1.3:10 --alpha 1.5:8:11 --format jsonl",
    ] {
        let whole = stdout(&format!("sweep {arguments}"));
        let file = place("resumed");
        let middle = whole.len() / 2;
        let header = whole.find('\n').unwrap() + 1;
        for length in [0, 10, header, middle, middle + 1, middle + 37, whole.len() - 1, whole.len()] {
            // Even if the file is cut within a character, it is truncated after its last complete row.
            std::fs::write(&file, &whole.as_bytes()[..length]).unwrap();
            stdout(&format!("sweep {arguments} --out {} --resume", file.display()));
            assert!(std::fs::read_to_string(&file).unwrap() == whole, "{arguments}: from {length} bytes");
        }
        std::fs::remove_file(&file).unwrap();
        stdout(&format!("sweep {arguments} --out {} --resume", file.display()));
        assert!(std::fs::read_to_string(&file).unwrap() == whole, "{arguments}: from nothing");
    }
}
#[test]
fn another_sweep_is_not_gone_on_with() {
    let file = place("another");
    let name = file.display();
    stdout(&format!("sweep response --omega 0.5:2:10 --alpha 2,3 --out {name}"));
    let kept = std::fs::read_to_string(&file).unwrap();
    for (arguments, part) in [
        ("response --omega 0.5:2:11 --alpha 2,3 --resume", "not of this sweep"),
        ("response --omega 0.6:2:10 --alpha 2,3 --resume", "not of this sweep"),
        ("steady --omega 0.5:2:10 --alpha 2,3 --resume", "not of this sweep"),
        ("response --omega 0.5:2:10 --alpha 2 --resume", "row 2 is not of this sweep"),
        ("response --omega 0.5:2:10 --alpha 2,3", "must not exist yet"),
    ] {
        let output =
            stickslip(&format!("sweep {arguments} --out {name}")).assert().code(2).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.contains(part) && message.lines().count() == 1, "{arguments}: {message}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), kept, "{arguments}");
    }
}
/// Resumes a sweep with a file that contains `kept`: either it is refused and the file untouched, or the
/// sweep is complete.
fn refused_or_whole(sweep: &str, file: &std::path::Path, kept: &[u8], whole: &str) -> bool {
    std::fs::write(file, kept).unwrap();
    let output = stickslip(&format!("sweep {sweep} --out {} --resume", file.display())).output().unwrap();
    let now = std::fs::read(file).unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    match output.status.code() {
        Some(0) => assert!(now == whole.as_bytes(), "{sweep}: {}", String::from_utf8_lossy(kept)),
        code => {
            assert_eq!((code, message.lines().count()), (Some(2), 1), "{message}");
            assert!(message.contains("of this sweep") || message.contains("begin"), "{message}");
            assert!(now == kept, "{sweep}: changed though refused");
        }
    }
    output.status.code() == Some(2)
}
#[test]
fn a_sweep_goes_on_with_itself_alone() {
    let file = place("itself");
    let alone = |sweep: &str, kept: &str| {
        let whole = stdout(&format!("sweep {sweep}"));
        assert!(refused_or_whole(sweep, &file, kept.as_bytes(), &whole), "{sweep}");
    };
    // Another grid with the same ends, with and without the grid among the columns.
    let linear = stdout("sweep border --omega 0.5:2:10");
    alone("border --omega 0.5:2:10:log", &linear);
    alone("border --omega 0.5:2:10", &stdout("sweep border --omega 0.5:2:10:log"));
    let regimes = stdout("sweep response --omega 0.3:2:20 --alpha 2,5 --outputs regime");
    alone("response --omega 0.3:2:20 --alpha 0.9,5 --outputs regime", &regimes);
    let lines = stdout("sweep border --omega 0.5:2:10 --format jsonl");
    alone("border --omega 0.5:2:10:log --format jsonl", &lines);
    // One row in the middle.
    let row = linear.lines().nth(5).unwrap();
    alone("border --omega 0.5:2:10", &linear.replace(row, &row.replace(",1.", ",2.")));
    // Text that is no row, and text after the last row.
    alone("border --omega 0.5:2:10", "precious notes");
    alone("border --omega 0.5:2:10 --no-header", "precious notes");
    alone("border --omega 0.5:2:10", &(linear.clone() + "0.5,1"));
    alone("border --omega 0.5:2:10", &(linear.clone() + &linear));
    let (some, _) = linear.split_at(linear.len() / 2);
    alone("border --omega 0.5:2:10", &(some.to_owned() + "precious notes"));
}
/// A file cut at any byte is completed; a file with any byte changed is refused.
#[test]
fn a_file_cut_or_changed_anywhere_is_made_whole_or_left_alone() {
    let file = place("anywhere");
    for sweep in [
        "response --omega 0.4:1.5:3 --alpha 2,6 --outputs alpha,max_displacement,omega",
        "response --omega 0.4:1.5:3 --alpha 2,6 --outputs regime,max_velocity --format jsonl",
        "steady --omega 0.4:1.5:3 --alpha 2,6 --outputs multipliers,omega,alpha",
    ] {
        let whole = stdout(&format!("sweep {sweep}"));
        for place in (0..=whole.len()).step_by(11) {
            let refused = refused_or_whole(sweep, &file, &whole.as_bytes()[..place], &whole);
            assert!(!refused, "{sweep}: cut at {place}");
            let mut changed = whole.clone().into_bytes();
            let Some(byte) = changed.get_mut(place) else { continue };
            *byte ^= 1;
            assert!(refused_or_whole(sweep, &file, &changed, &whole), "{sweep}: changed at {place}");
        }
    }
}
/// A limit on the file size acts like a full disk: the failure is reported, and the existing rows can be
/// resumed.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_rows_that_can_be_gone_on_with() {
    let command = assert_cmd::cargo::cargo_bin!("stickslip").display().to_string();
    let sweep = "sweep response --omega 0.3:3:50 --alpha 1.1:9:50";
    let file = place("full");
    let limited = |more: &str| {
        let line =
            format!("trap '' XFSZ; ulimit -f 100; exec '{command}' {sweep} --out {} {more}", file.display());
        std::process::Command::new("sh").args(["-c", &line]).output().unwrap()
    };
    for more in ["", "--resume"] {
        let output = limited(more);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("full: File too large") && message.lines().count() == 1, "{message}");
        assert!(std::fs::metadata(&file).unwrap().len() > 40_000);
    }
    stdout(&format!("{sweep} --out {} --resume", file.display()));
    assert!(std::fs::read_to_string(&file).unwrap() == stdout(sweep));
}
/// Two commands cannot write to one file.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_being_written_is_left_alone() {
    let file = place("busy");
    let sweep = format!("sweep steady --omega 0.001:0.002:1000 --alpha 2:9:100 --out {}", file.display());
    let mut first = std::process::Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(sweep.split(' '))
        .spawn()
        .unwrap();
    while std::fs::metadata(&file).map_or(0, |m| m.len()) < 1_000 {
        assert!(first.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    refused(&format!("{sweep} --resume"), &["busy", "another command is writing to it"]);
    first.kill().unwrap();
    first.wait().unwrap();
}
/// Ctrl-C leaves complete rows, from which `--resume` continues.
#[cfg(unix)]
#[test]
fn an_interrupted_sweep_can_be_gone_on_with() {
    use std::process::Command;
    let file = place("interrupted");
    let sweep = format!("sweep response --omega 0.3:3:1000 --alpha 1.1:9:1000 --out {}", file.display());
    let mut child =
        Command::new(assert_cmd::cargo::cargo_bin("stickslip")).args(sweep.split(' ')).spawn().unwrap();
    while std::fs::metadata(&file).map_or(0, |m| m.len()) < 100_000 {
        assert_eq!(child.try_wait().unwrap(), None, "it ended before it was interrupted");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.ends_with('\n') && text.lines().count() < 1_000_000);
    let columns = text.lines().next().unwrap().split(',').count();
    assert!(text.lines().all(|line| line.split(',').count() == columns));
}
/// A row with an unexpected Ω or α does not belong to the sweep, whatever its other values.
#[test]
fn a_row_of_another_point_is_refused() {
    for (sweep, name) in [
        ("border --omega 0.5:2:400", "omega"),
        ("border --omega 0.5:2:400 --format jsonl", "omega"),
        ("border --omega 0.5:2:400 --outputs best_force_ratio,omega", "omega"),
        ("response --omega 0.7 --alpha 1.5:8:400", "alpha"),
        ("response --omega 0.5:2:400 --alpha 3 --format jsonl", "omega"),
        ("response --omega 0.5:2:400 --alpha 3", "omega"),
    ] {
        let whole = stdout(&format!("sweep {sweep}"));
        let file = place("other-point");
        let lines: Vec<&str> = whole.lines().collect();
        let header = usize::from(!sweep.contains("jsonl"));
        assert_eq!(lines.len(), 400 + header);
        for row in [0, 1, 23, 57, 111, 199, 250, 301, 398, 399] {
            // The point of the row two further on or before; the other values are unchanged.
            let (line, other) = (lines[row + header], lines[(row + 2) % 400 + header]);
            let changed = if header == 1 {
                let place = lines[0].split(',').position(|column| column == name).unwrap();
                let mut cells: Vec<&str> = line.split(',').collect();
                cells[place] = other.split(',').nth(place).unwrap();
                cells.join(",")
            } else {
                let member = |line: &str| {
                    let mut members = line.split(['{', '}', ',']).map(str::to_owned);
                    members.find(|member| member.starts_with(&format!("\"{name}\":"))).unwrap()
                };
                line.replace(&member(line), &member(other))
            };
            assert_ne!(changed, line, "{sweep}");
            let mut kept = lines.clone();
            kept[row + header] = &changed;
            std::fs::write(&file, kept.join("\n") + "\n").unwrap();
            let row = format!("row {} is not of this sweep", row + 1);
            refused(&format!("sweep {sweep} --out {} --resume", file.display()), &[&row]);
        }
        std::fs::remove_file(&file).unwrap();
    }
}

/// A bit changed anywhere in a finished file is named, also in rows that a second does not suffice to compare: they are
/// computed again unless their checksum was kept.
#[test]
fn a_changed_bit_of_a_finished_file_is_named() {
    let mut random = Random(7);
    let mut drawn = |count: usize| random.below(count as u64) as usize;
    for format in ["csv", "jsonl"] {
        let file = place(&format!("finished.{format}"));
        let sweep =
            "response --omega 0.35:2.3:40 --alpha 0.5:9:30 --outputs omega,alpha,max_displacement,regime";
        let line = format!("sweep {sweep} --out {}", file.display());
        stdout(&line);
        let whole = std::fs::read(&file).unwrap();
        let kept = file.with_extension(format!("{format}.check"));
        let sums = std::fs::read(&kept).unwrap();
        // One line for the whole file.
        let text = String::from_utf8(sums.clone()).unwrap();
        assert_eq!(
            (text.lines().count(), text.lines().nth(1).unwrap().split(' ').next().unwrap().parse()),
            (2, Ok(whole.len()))
        );
        for with_sums in [true, false] {
            for _ in 0..15 {
                let mut changed = whole.clone();
                let place = drawn(changed.len());
                changed[place] ^= 1 << drawn(8);
                std::fs::write(&file, &changed).unwrap();
                if with_sums {
                    std::fs::write(&kept, &sums).unwrap();
                } else {
                    let _ = std::fs::remove_file(&kept);
                }
                let output = stickslip(&format!("{line} --resume")).output().unwrap();
                let message = String::from_utf8(output.stderr).unwrap();
                assert_eq!(output.status.code(), Some(2), "byte {place}: {message}");
                assert!(message.contains("finished"), "{message}");
                assert!(std::fs::read(&file).unwrap() == changed);
            }
        }
        std::fs::write(&file, &whole).unwrap();
        std::fs::write(&kept, &sums).unwrap();
        stdout(&format!("{line} --resume"));
        assert!(std::fs::read(&file).unwrap() == whole && std::fs::read(&kept).unwrap() == sums);
        // A file of other origin is not touched.
        std::fs::write(&kept, "notes").unwrap();
        std::fs::write(&file, &whole[..whole.len() / 3]).unwrap();
        stdout(&format!("{line} --resume"));
        assert!(std::fs::read(&file).unwrap() == whole && std::fs::read(&kept).unwrap() == b"notes");
    }
}
