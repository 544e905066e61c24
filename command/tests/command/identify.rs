//! `identify` from files as they come: wrong values, other kinds of amplitude and phase, columns, endless input.

use crate::command_line::{json, refused, stdout, stickslip};
use std::f64::consts::{SQRT_2, TAU};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const MACHINE: &str = "--mass 5kg --stiffness 20kN/m --force 100N";

/// Frequency in Hz, amplitude in mm and phase in degrees of the machine with 12 N and 2 %, with 1 % of noise.
fn measured() -> Vec<(f64, f64, f64)> {
    let at = |i: u32| {
        let hertz = 4.0 + 0.5 * f64::from(i);
        let ratios = ::stickslip::Ratios::new(TAU * hertz / 4000f64.sqrt(), 100.0 / 12.0).unwrap();
        let ratios = ratios.with_damping_ratio(0.02).unwrap();
        let limit =
            ::stickslip::motion::LongRun::from_start(ratios, ::stickslip::motion::State::default()).unwrap();
        let peak = limit.steady_state().unwrap().max_displacement;
        let noise = 0.01 * (7.0 * f64::from(i)).sin();
        // r_y/k = 0.6 mm
        (hertz, 0.6 * peak.value * (1.0 + noise), (peak.phase.reduced() + noise).to_degrees())
    };
    (0..25).map(at).collect()
}

/// A file with a header and a line for each measurement.
fn file(folder: &Path, header: &str, line: impl Fn(usize, (f64, f64, f64)) -> String) -> PathBuf {
    let mut text = format!("{header}\n");
    for (i, row) in measured().into_iter().enumerate() {
        writeln!(text, "{}", line(i, row)).unwrap();
    }
    let name = folder.join("curve.csv");
    std::fs::write(&name, text).unwrap();
    name
}

fn value(found: &serde_json::Value, key: &str) -> f64 {
    found[key]["value"].as_f64().unwrap()
}

/// Within 5 % of 12 N and 2 %.
fn is_true(found: &serde_json::Value) -> bool {
    (value(found, "friction") / 12.0 - 1.0).abs() < 0.05
        && (value(found, "damping_ratio") / 0.02 - 1.0).abs() < 0.05
}

#[test]
fn wrong_values_are_left_out_and_named_by_line() {
    let folder = tempfile::tempdir().unwrap();
    let factor = |i: usize| match i {
        5 => 3.0,
        12 => 0.3,
        18 => 2.0,
        _ => 1.0,
    };
    let name =
        file(folder.path(), "frequency[Hz],amplitude[mm]", |i, (f, a, _)| format!("{f},{}", a * factor(i)));
    let command = format!("identify {} {MACHINE}", name.display());
    let found = json(&format!("{command} --format json"));
    assert!(is_true(&found), "{found}");
    let lines: Vec<u64> =
        found["suspects"].as_array().unwrap().iter().map(|s| s["line"].as_u64().unwrap()).collect();
    assert_eq!((lines, found["used"].as_u64()), (vec![7, 14, 20], Some(22)));
    let text = stdout(&command);
    assert!(text.contains("explain 22 of 25 measurements"), "{text}");
    let named = "Left out because the others contradict them: line 7 (amplitude), line 14 (amplitude), line 20 (amplitude).";
    assert!(text.contains(named), "{text}");
    assert_eq!(text.matches("left out").count(), 3, "{text}");
}

#[test]
fn the_kind_of_the_amplitudes_is_given_or_suspected() {
    for (kind, factor) in [("rms", 1.0 / SQRT_2), ("peak-to-peak", 2.0)] {
        let folder = tempfile::tempdir().unwrap();
        let name =
            file(folder.path(), "frequency[Hz],amplitude[mm]", |_, (f, a, _)| format!("{f},{}", a * factor));
        let command = format!("identify {} {MACHINE}", name.display());
        assert!(is_true(&json(&format!("{command} --amplitude {kind} --format json"))), "{kind}");
        let text = stdout(&command);
        assert!(
            text.contains(&format!("The amplitudes look like {kind} values: with --amplitude {kind}")),
            "{text}"
        );
    }
}

/// An interval does not leave what is physical, even where the curve determines nothing.
#[test]
fn an_interval_is_physical() {
    let folder = tempfile::tempdir().unwrap();
    let curve = |share: f64| {
        file(folder.path(), "frequency[Hz],amplitude[mm]", |i, (f, a, _)| {
            format!("{f},{}", a * if i % 2 == 0 { 1.0 - share } else { 1.0 + share })
        })
    };
    // Off by half, and no nearer to a resonance than to one amplitude.
    let name = curve(0.5);
    refused(&format!("identify {} {MACHINE}", name.display()), &["no friction and damping explain it"]);
    let name = curve(0.25);
    let found = json(&format!("identify {} {MACHINE} --format json", name.display()));
    for key in ["friction", "friction_coefficient", "damping_ratio", "damping"] {
        let ends = [0, 1].map(|i| found[key]["interval_95"][i].as_f64().unwrap());
        assert!(0.0 <= ends[0] && ends[0] <= ends[1] && ends[1].is_finite(), "{key}: {ends:?}");
    }
    assert!(found["friction"]["interval_95"][1].as_f64().unwrap() <= 100.0);
    let text = stdout(&format!("identify {} {MACHINE}", name.display()));
    assert!(text.contains("The model does not explain this curve"), "{text}");
}

#[test]
fn phases_are_read_by_their_unit_and_their_sign() {
    let folder = tempfile::tempdir().unwrap();
    let read = |header: &str, phase: &dyn Fn(f64) -> f64| {
        let name = file(folder.path(), header, |_, (f, a, p)| format!("{f},{a},{}", phase(p)));
        format!("identify {} {MACHINE}", name.display())
    };
    // The header as an instrument may write it.
    let command = read("Frequency[Hz],Amplitude[mm],Phase[deg]", &|p| p);
    let found = json(&format!("{command} --format json"));
    assert!(is_true(&found) && found["phase_kind"] == "peak", "{found}");
    assert!(
        found["phase_residuals"].as_array().unwrap().iter().all(|r| r.as_f64().unwrap().abs() < 0.03),
        "{found}"
    );
    let text = stdout(&command);
    assert!(
        text.contains("error of one phase") && text.contains("Phases are read as --phase peak"),
        "{text}"
    );
    // The transfer function of an instrument: about a quarter turn less, with the other sign.
    let command = read("frequency[Hz],amplitude[mm],phase[deg]", &|p| 90.0 - p);
    let found = json(&format!("{command} --format json"));
    assert!(found["phase_kind"] == "transfer-function", "{found}");
    assert!((value(&found, "friction") / 12.0 - 1.0).abs() < 0.2, "{found}");
    let command = read("frequency[Hz],amplitude[mm],phase[deg]", &|p| 90.0 - p);
    assert!(stdout(&command).contains("--phase transfer-function"));
    let command = read("frequency[Hz],amplitude[mm],phase[deg]", &|p| 90.0 - p) + " --phase peak";
    let found = json(&format!("{command} --format json"));
    assert!(found["phase_kind"] == "peak" && found["better_phase"] == "transfer-function", "{found}");
    assert!(stdout(&command).contains("The phases look like transfer-function values"));
    // Degrees in a column that is in radians.
    let command = read("frequency[Hz],amplitude[mm],phase", &|p| p);
    refused(&command, &["line 2: phase", "2π", "phase[deg]"]);
    let command = read("frequency[Hz],amplitude[mm],phase", &|p| p.to_radians());
    assert!(is_true(&json(&format!("{command} --format json"))));
}

#[test]
fn columns_are_used_named_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let name = file(folder.path(), "frequency[Hz],amplitude[mm],remark", |_, (f, a, _)| format!("{f},{a},x"));
    let text = stdout(&format!("identify {} {MACHINE}", name.display()));
    assert!(text.contains("Columns not used: remark."), "{text}");
    for (header, part) in [
        ("frequency[Hz],amplitude[mm],phse[deg]", "column phse is unknown. Spell it phase"),
        ("frequency[Hz],amplitude[mm],Amplitude[mm]", "column Amplitude must be there once only"),
    ] {
        let name = file(folder.path(), header, |_, (f, a, _)| format!("{f},{a},{a}"));
        refused(&format!("identify {} {MACHINE}", name.display()), &[part]);
    }
}

#[test]
fn every_failure_names_its_line() {
    for (text, part) in [
        ("frequency[Hz],amplitude[mm]\n5,1\n6,-2\n", "line 3: peak displacement Δ₀ = -0.002 must be > 0"),
        ("frequency[Hz],amplitude[mm]\n5,1\n0,2\n", "line 3: angular frequency"),
        ("frequency[Hz],amplitude[mm]\n5,1\n6\n", "line 3: 1 fields, must be 2 as in the header"),
        ("frequency[Hz],amplitude[mm]\n5,1\n6,1\n", "the number of measurements = 2 must be ≥ 3"),
        ("frequency[Hz],amplitude[mm]\n5,1\n5,1\n5,1\n", "several frequencies"),
        ("frequency[Hz],amplitude[mm]\n5,1e-9\n7,1e-9\n9,1e-9\n12,1e-9\n", "The best fit is at"),
    ] {
        let output = stickslip(&format!("identify - {MACHINE}")).write_stdin(text).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{text}: {message}");
        assert!(message.contains(part) && message.lines().count() == 1, "{part}: {message}");
    }
}

/// A row without an end and a file without an end are refused in bounded memory.
#[test]
fn endless_input_is_refused() {
    let run = |text: String| stickslip(&format!("identify - {MACHINE}")).write_stdin(text).output().unwrap();
    let output = run("0".repeat(1 << 20));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && message.contains("must be ≤ 262144"), "{message}");
    let output = run("frequency[Hz],amplitude[mm]\n".to_owned() + &"5,1\n".repeat(10_001));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("line 10002: the number of measurements must be ≤ 10000"), "{message}");
    #[cfg(unix)]
    refused(&format!("identify /dev/zero {MACHINE}"), &["/dev/zero", "must be ≤ 262144"]);
}

/// A decay by its peaks and by its samples: the numbers of the body that made them, as a force with the spring or with
/// the mass.
#[test]
fn a_free_decay_gives_friction_and_damping() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let place = folder.path().join(name);
        std::fs::write(&place, text).unwrap();
        place.display().to_string()
    };
    let decay =
        "decay --mass 30kg --stiffness 12kN/m --friction 16N --damping-ratio 1% --x0 40mm --units N,mm";
    let turns = folder.path().join("turns.csv");
    stdout(&format!("{decay} --out {}", turns.display()));
    let text = std::fs::read_to_string(&turns).unwrap();
    assert!(text.starts_with("turn,time[s],displacement[mm]\n0,0,40"), "{text}");
    // The last turning point is the rest.
    let lines: Vec<&str> = text.lines().collect();
    let moving = lines[..lines.len() - 1].join("\n").replace("displacement", "peak");
    let found = json(&format!("identify --decay {} --mass 30kg --format json", write("p.csv", &moving)));
    let of = |key: &str| found[key]["value"].as_f64().unwrap();
    for (key, due) in [
        ("friction", 16.0),
        ("friction_coefficient", 16.0 / (30.0 * 9.80665)),
        ("damping_ratio", 0.01),
        ("natural_frequency", 20.0 / TAU),
        ("friction_displacement", 0.016 / 12.0),
    ] {
        assert!((of(key) / due - 1.0).abs() < 1e-6, "{key}: {found}");
    }
    // One side alone, and the other without signs.
    let text = "peak[mm]\n40\n33.1\n26.5\n20.2\n14.1\n";
    let peaks = write("peaks.csv", text);
    let answer = stdout(&format!("identify --decay {peaks} --stiffness 12kN/m"));
    assert!(answer.contains("friction force r_y") && !answer.contains("With --stiffness"), "{answer}");
    let every = json(&format!("identify --decay {peaks} --half-cycles --format json"));
    let alone = json(&format!("identify --decay {peaks} --format json"));
    let friction = |found: &serde_json::Value| found["friction_displacement"]["value"].as_f64().unwrap();
    assert!((friction(&every) / friction(&alone) - 2.0).abs() < 0.05, "{every} {alone}");
    // Samples of an undamped body, every millisecond, with a zero of their own.
    let mut samples = String::from("time[s],displacement[mm]\n");
    for i in 0..3000 {
        let t = f64::from(i) * 1e-3;
        let n = (t / (TAU / 40.0)).floor();
        let turn = (-1f64).powf(n) * (40.0 - 4.0 * n);
        let (middle, angle) = (2f64.copysign(turn), 20.0 * t - n * TAU / 2.0);
        let x = if n < 10.0 { middle + (turn - middle) * angle.cos() } else { 0.0 };
        writeln!(samples, "{t},{}", 5.0 + x).unwrap();
    }
    let found = json(&format!(
        "identify --decay {} --mass 30kg --units N,mm --format json",
        write("s.csv", &samples)
    ));
    assert!((found["friction"]["value"].as_f64().unwrap() / 24.0 - 1.0).abs() < 1e-3, "{found}");
    assert!(found["damping_ratio"]["value"].as_f64().unwrap() < 1e-4, "{found}");
    for (text, parts) in [
        ("40\n33\n26\n20\n", ["column peak or displacement", "“40”"]),
        ("peak[mm]\n40\n33\n26\n", ["the number of turning points = 3", "≥ 4"]),
        ("peak[mm]\n40\n33\nx\n20\n", ["line 4", "peak x"]),
        ("peak[mm]\n10\n20\n30\n40\n", ["line 3", "must fall"]),
        ("peak[s]\n10\n20\n30\n40\n", ["column peak", "a length"]),
        ("displacement[mm]\n1\n2\n", ["column time is missing", "displacement"]),
        ("time[s],displacement[mm],peak[mm]\n1,2,3\n", ["one of the columns", "peak or displacement"]),
        ("time[s],displacement[mm]\n0,1\n0,2\n", ["line 3", "time step"]),
    ] {
        refused(&format!("identify --decay {}", write("wrong.csv", text)), &parts);
    }
    refused("identify --decay missing.csv", &["missing.csv"]);
    refused(&format!("identify --half-cycles {peaks}"), &["--decay"]);
    refused(&format!("identify --decay {peaks} --force 3N"), &["--force 3N", "does not use it"]);
}

/// A decay draws itself, and lists its turning points.
#[test]
fn a_decay_lists_its_turning_points_and_draws_itself() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let answer = stdout(&format!("decay --x0 4.5 --out {}", file("a.svg")));
    assert!(answer.contains("turning points at") && answer.contains("-2.5 B"), "{answer}");
    assert!(std::fs::read_to_string(file("a.svg")).unwrap().contains("turning points"));
    refused(&format!("decay --x0 4.5 --out {}", file("a.svg")), &["must not exist yet"]);
    refused(&format!("decay --x0 1e9 --out {}", file("b.svg")), &["500000000 half cycles", "≤ 2000"]);
    refused(&format!("decay --x0 4.5 --out {}", file("c.txt")), &[".svg"]);
    assert!(!stdout("decay --x0 0.5").contains("turning points at"));
}
