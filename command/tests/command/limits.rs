//! Memory, time, threads and files of others: what is too much is refused, and nothing is waited for or lost in silence.

use crate::command_line::{GOES_ON, listens, refused, said, stdout, stickslip};
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// Long enough for a command that ends by itself on any machine, and an end for one that waits for ever.
const NEVER: Duration = Duration::from_secs(120);

fn folder() -> (tempfile::TempDir, impl Fn(&str) -> String) {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().to_owned();
    (folder, move |name: &str| root.join(name).display().to_string())
}

fn pipe(place: &str) {
    assert!(Command::new("mkfifo").arg(place).status().unwrap().success());
}

/// Ten thousand motions of a hundred thousand stops a cycle take far more than two seconds. Ctrl-C ends them.
#[test]
fn long_work_says_that_it_goes_on() {
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(["map", "stops", "--omega", "4e-6:5e-6:100", "--alpha", "2:3:100"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    listens(&mut child);
    let mut errors = BufReader::new(child.stderr.take().unwrap());
    let mut line = String::new();
    errors.read_line(&mut line).unwrap();
    assert_eq!(line, GOES_ON);
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let rest: Vec<String> = errors.lines().map(Result::unwrap).collect();
    assert!(rest.len() == 1 && rest[0].contains("interrupted"), "{rest:?}");
}

/// Threads that the system refuses, and more of them than it can run, change no answer.
#[test]
fn the_number_of_threads_is_what_the_system_gives() {
    let sweep = "sweep response --omega 0.5:2:40 --alpha 2,4";
    let due = stdout(sweep);
    let program = assert_cmd::cargo::cargo_bin!("stickslip");
    for (limit, threads) in
        [("true", "20000"), ("ulimit -v 150000", "16"), ("ulimit -v 100000", "16"), ("ulimit -v 80000", "")]
    {
        let output = Command::new("sh")
            .args(["-c", &format!("{limit}; exec \"$0\" {sweep}")])
            .arg(program)
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        let message = said(&output.stderr);
        assert!(output.status.success() && message.is_empty(), "{limit}: {message}");
        assert!(output.stdout == due.as_bytes(), "{limit}");
    }
}

#[test]
fn manual_pages_keep_what_is_there() {
    let (_folder, place) = folder();
    let (man, page) = (place("man"), place("man/stickslip-steady.1"));
    stdout(&format!("man --out {man}"));
    let kept = fs::read_to_string(&page).unwrap();
    assert!(kept.contains(".TH stickslip-steady 1"));
    fs::write(&page, "mine").unwrap();
    let count = || fs::read_dir(&man).unwrap().count();
    let before = count();
    assert!(before > 24, "{before}");
    refused(&format!("man --out {man}"), &["must not exist yet. Replace it with --overwrite"]);
    assert_eq!(fs::read_to_string(&page).unwrap(), "mine");
    stdout(&format!("man --out {man} --overwrite"));
    assert!(fs::read_to_string(&page).unwrap() == kept && count() == before);
    refused("man --overwrite", &["--out"]);
    // A link is not followed: neither to a file, nor to where there is none.
    let (other, none, linked) = (place("other"), place("none"), place("linked"));
    fs::create_dir(&linked).unwrap();
    fs::write(&other, "mine").unwrap();
    for target in [&other, &none] {
        let link = Path::new(&linked).join("stickslip-steady.1");
        symlink(target, &link).unwrap();
        refused(&format!("man --out {linked}"), &["stickslip-steady.1: must not exist yet"]);
        assert_eq!(fs::read_dir(&linked).unwrap().count(), 1);
        fs::remove_file(link).unwrap();
    }
    assert!(fs::read_to_string(&other).unwrap() == "mine" && !Path::new(&none).exists());
}

/// A pipe beside an output has no other end.
#[test]
fn a_pipe_in_place_of_a_file_is_no_wait() {
    let (_folder, place) = folder();
    let rows = place("rows.csv");
    pipe(&format!("{rows}.check"));
    pipe(&format!("{}.4194305-0.part", place("curve.csv")));
    for line in [
        format!("sweep response --omega 0.5:2:7 --alpha 2,4 --out {rows}"),
        format!("sweep response --omega 0.5:2:7 --alpha 2,4 --out {rows} --resume"),
        format!("response-curve --omega 0.5:2:7 --alpha 2 --out {}", place("curve.csv")),
    ] {
        stickslip(&line).timeout(NEVER).assert().success();
    }
    assert_eq!(fs::read_to_string(&rows).unwrap().lines().count(), 15);
    let machine = place("machine.toml");
    pipe(&place("law.csv"));
    let text = "masses = { a = 1 }\n[[contacts]]\nbetween = [\"ground\", \"a\"]\nlaw = \"law.csv\"\n";
    fs::write(&machine, text).unwrap();
    let assert = stickslip(&format!("system {machine}")).timeout(NEVER).assert().code(2);
    let message = said(&assert.get_output().stderr);
    assert!(message.contains("contacts[1].law: ") && message.contains("law.csv: must be a regular file"));
}

#[test]
fn control_characters_reach_neither_a_terminal_nor_a_drawing() {
    let (_folder, place) = folder();
    for (letter, shown) in
        [("\u{1b}", "\\u{1b}"), ("\u{fffe}", "\\u{fffe}"), ("\u{ffff}", "\\u{ffff}"), ("\u{9b}", "\\u{9b}")]
    {
        let curve = format!("response-curve --omega 0.5:2:7 --alpha 2 --out {}", place("x.svg"));
        let due = format!("--title a{shown}b: must have no control characters");
        refused(&format!("{curve} --title a{letter}b"), &[&due]);
    }
    // The name of a channel is that of a file.
    let record = place("record.csv");
    fs::write(&record, "time[s],\u{1b}red[g]\n0,0\n0.5,0.2\n1,0\n").unwrap();
    let body = "--units kN,mm --mass 1t --period 1s --friction-coefficient 0.05";
    let text = stdout(&format!("record {record} {body} --column 2"));
    assert!(text.contains("“\\u{1b}red”") && !text.contains('\u{1b}'), "{text}");
}

#[test]
fn a_text_of_sixteen_bits_is_named() {
    let (_folder, place) = folder();
    let file = place("file.csv");
    let wide = |text: &str| -> Vec<u8> {
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
    };
    for (text, line) in [
        ("omega,alpha\n0.5,6\n", format!("response --points {file}")),
        (
            "time[s],acceleration[g]\n0,0\n1,0.1\n",
            format!("record {file} --mass 1 --stiffness 1 --friction 1"),
        ),
        ("masses = { a = 1 }\n", format!("system {file}")),
        (
            "frequency,displacement\n1,2\n",
            format!("identify {file} --mass 5kg --stiffness 20kN/m --force 100N"),
        ),
    ] {
        fs::write(&file, wide(text)).unwrap();
        refused(&line, &[&file, "must be text in UTF-8, but is UTF-16"]);
    }
}

#[test]
fn a_picture_has_a_greatest_number_of_pixels() {
    let (_folder, place) = folder();
    let curve = "response-curve --omega 0.5:2:7 --alpha 2 --size";
    if cfg!(feature = "png") {
        let png = place("x.png");
        for size in ["10000x10000", "4001x2500"] {
            let due = format!("--size {size}: a PNG has twice this width and height");
            refused(&format!("{curve} {size} --out {png}"), &[&due, "≤ 40000000 pixels"]);
        }
        assert!(!Path::new(&png).exists());
    }
    stdout(&format!("{curve} 10000x10000 --out {}", place("x.svg")));
}

/// All samples of a system are in memory, 200 MB of them.
#[test]
fn the_samples_of_a_system_have_a_greatest_number() {
    let (_folder, place) = folder();
    let machine = place("machine.toml");
    fs::write(&machine, "masses = { a = 1 }\n").unwrap();
    let line = |count: u32| format!("system {machine} simulate --until 1 --samples {count}");
    refused(&line(1_000_000), &["--samples 1000000: must be a whole number ≥ 1 and ≤ 602409"]);
    assert_eq!(stdout(&line(1000)).lines().count(), 1002);
}

/// The mass and the spring are at fault, not the speed.
#[test]
fn the_inputs_of_an_infinite_frequency_are_blamed() {
    let line = "pull --mass 1e-300 --stiffness 1e300 --friction 1 --static-friction-ratio 1.3 --speed 1";
    refused(line, &["--mass 1e-300 --stiffness 1e300", "natural frequency", "must be finite"]);
}
