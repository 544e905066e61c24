//! `stickslip steady`, `simulate` and `decay` from the user's side.

use crate::command_line::{json, refused, stdout, stickslip};
use serde_json::Value;
use std::f64::consts::PI;

/// Values from an independent program.
const STEADY: [(&str, &str, f64, u64, u64); 5] = [
    ("0.4", "6.0", 6.79382, 2, 4),
    ("0.1", "3.0", 2.160_025_244_6, 4, 4),
    ("0.5", "2.0", 2.606_858_408_4, 2, 2),
    ("0.7", "1.2", 1.417_437_097_7, 2, 2),
    ("0.8", "1.1", 0.056_576_588_9, 2, 2),
];

#[test]
fn steady_has_the_agreed_keys_and_values() {
    for (omega, alpha, max, sticks, zeros) in STEADY {
        let answer = json(&format!("steady --omega {omega} --alpha {alpha} --format json"));
        let number = |name: &str| answer[name].as_f64().unwrap_or_else(|| panic!("{name}: {answer}"));
        assert!((number("max_displacement") / max - 1.0).abs() < 1e-6, "({omega}, {alpha}): {answer}");
        assert!((number("min_displacement") / max + 1.0).abs() < 1e-6);
        assert_eq!(answer["sticks_per_cycle"].as_u64(), Some(sticks), "({omega}, {alpha})");
        assert_eq!(answer["velocity_zeros_per_cycle"].as_u64(), Some(zeros), "({omega}, {alpha})");
        assert_eq!(
            (answer["regime"].as_str(), answer["limit"].as_str()),
            (Some("sticking"), Some("periodic"))
        );
        assert!((number("energy_in") / number("energy_out") - 1.0).abs() < 1e-12);
        assert!((0.0..1.0).contains(&number("stick_fraction")) && number("periods") > 0.0);
        assert!(number("min_velocity") < 0.0 && number("max_velocity") > 0.0);
        for name in ["max_displacement", "min_displacement", "max_velocity", "min_velocity"] {
            assert!((0.0..std::f64::consts::TAU).contains(&number(&format!("{name}_phase"))));
        }
        for measure in 1..=4 {
            assert!(number(&format!("error_{measure}")).abs() < 1e-9);
        }
        let modulus = |i: usize| {
            let part = |j: usize| answer["multipliers"][i][j].as_f64().unwrap();
            part(0).hypot(part(1))
        };
        assert!(modulus(0) < 1.0 && modulus(1) < 1.0, "{answer}");
    }
}

#[test]
fn steady_is_the_closed_form_where_it_does_not_stick() {
    let cycle = json("response --omega 1.5 --alpha 2.5 --format json");
    let steady = json("steady --omega 1.5 --alpha 2.5 --format json");
    for (ours, theirs) in [
        ("max_displacement", "max_displacement"),
        ("max_displacement_phase", "displacement_phase"),
        ("max_velocity", "max_velocity"),
        ("max_velocity_phase", "velocity_phase"),
    ] {
        let (a, b) = (steady[ours].as_f64().unwrap(), cycle[theirs].as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-13, "{ours}: {a} against {b}");
    }
    assert_eq!(steady["regime"], "non-sticking");
}

#[test]
fn steady_names_what_has_no_single_limit() {
    let limit = |arguments: &str| json(&format!("steady {arguments} --format json"))["limit"].clone();
    assert_eq!(limit("--omega 0.7 --alpha 0.8 --x0 4"), "rest");
    assert_eq!(limit("--omega 1 --alpha 2"), "none");
    assert_eq!(limit("--omega 0.5 --alpha 4 --x0 1"), "family");
    assert_eq!(limit("--omega 0.4 --alpha 6 --max-periods 1"), "not-converged");
    let resting = json("steady --omega 0.7 --alpha 0.8 --x0 4 --format json");
    let place = resting["rest_position"].as_f64().unwrap();
    assert!(place.abs() <= 0.2 + 1e-12);
    // It stays where it is, and friction carries the force.
    for (name, due) in [
        ("max_displacement", place),
        ("min_displacement", place),
        ("max_velocity", 0.0),
        ("min_velocity", 0.0),
        ("stick_fraction", 1.0),
        ("energy_in", 0.0),
        ("energy_out", 0.0),
        ("max_acceleration", 0.0),
        ("transmitted_force", 0.8),
        ("transmissibility", 1.0),
    ] {
        assert_eq!(resting[name].as_f64(), Some(due), "{name}");
    }
    for name in ["max_displacement_phase", "error_1", "multipliers", "contraction", "distance"] {
        assert!(resting.get(name).is_none_or(Value::is_null), "{name}");
    }
    assert!(stdout("steady --omega 0.4 --alpha 6").starts_with("Sticking: 2 stops in a cycle, 15.07 %"));
    assert!(stdout("steady --omega 1 --alpha 2").starts_with("Unbounded"));
}

#[test]
fn steady_in_physical_units_and_for_many_points() {
    let answer = json("steady --mass 50 --friction 5 --frequency 2 --omega 0.4 --alpha 6 --format json");
    // k = m (ω_d/Ω)² = 1250, B = 5/1250
    let physical = answer["physical"].as_object().unwrap();
    let mut seen = 0;
    for (name, value) in physical {
        let (field, unit) = match name.as_str() {
            "max_displacement" | "min_displacement" | "distance" | "rest_position" => (name.clone(), 0.004),
            "max_velocity" | "min_velocity" => (name.clone(), 0.008),
            "energy_in" | "energy_out" => (name.clone(), 0.02),
            // 2π/ω_d
            "followed_for" => ("periods".to_owned(), std::f64::consts::PI),
            _ if name.ends_with("_time") => (name.replace("_time", "_phase"), 0.5),
            _ => continue,
        };
        seen += 1;
        let Some(number) = answer[&field].as_f64() else {
            assert!(value.is_null() && name == "rest_position", "{name}");
            continue;
        };
        let expected = number * unit;
        assert!(
            (value.as_f64().unwrap() - expected).abs() <= 1e-12 * expected.abs(),
            "{name}: {value} {expected}"
        );
    }
    assert_eq!(seen, 13, "{physical:?}");
    assert!((physical["stiffness"].as_f64().unwrap() - 1250.0).abs() < 1e-9);
    assert_eq!(
        (&physical["units"]["followed_for"], &physical["drive"]),
        (&"s".into(), &"force on the body".into())
    );
    let csv = stickslip("steady --points - --format csv")
        .write_stdin("omega,alpha\n0.4,6\n0.7,0.5\n1,2\n")
        .assert()
        .success()
        .get_output()
        .stdout
        .clone();
    let csv = String::from_utf8(csv).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert!(rows.len() == 4 && rows.iter().all(|row| row.len() == rows[0].len()), "{csv}");
    assert!(rows[0].contains(&"multipliers_2_im"));
}

#[test]
fn simulate_gives_the_phases_one_a_row() {
    let csv = stdout("simulate --omega 0.4 --alpha 6 --cycles 2 --format csv");
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][..4], ["kind", "ends_by", "start_cycle", "start_phase"]);
    assert_eq!((rows[1][0], rows[1][1]), ("stick", "release"));
    let (end_phase, start_phase) = (rows[1][5].parse::<f64>().unwrap(), rows[2][3].parse::<f64>().unwrap());
    assert!((end_phase - (1.0f64 / 6.0).asin()).abs() < 1e-15 && end_phase == start_phase);
    // Each phase begins where the previous one ended, and the last begins in the second cycle.
    for pair in rows[1..].windows(2) {
        assert_eq!(pair[0][4..6], pair[1][2..4]);
        assert_eq!(pair[0][9], pair[1][7]);
    }
    assert_eq!(rows.last().unwrap()[2], "1");
    let lines = stdout("simulate --omega 0.4 --alpha 6 --cycles 2 --format jsonl");
    assert_eq!(lines.lines().count(), rows.len() - 1);
    let first: Value = serde_json::from_str(lines.lines().next().unwrap()).unwrap();
    assert_eq!(first["kind"], "stick");
    assert_eq!(stdout("simulate --omega 0.4 --alpha 6 --cycles 2").lines().count(), rows.len());
}

#[test]
fn phases_in_physical_units() {
    // ω_d = 2, B = 0.004
    let machine = "--mass 50 --friction 5 --frequency 2 --omega 0.4 --alpha 6";
    let csv = stdout(&format!("simulate {machine} --cycles 2 --x0 0.01 --v0 0.03 --format csv"));
    let mut rows = csv::Reader::from_reader(csv.as_bytes());
    let (mut count, mut moving) = (0, 0);
    for row in rows.deserialize::<std::collections::HashMap<String, String>>() {
        let row = row.unwrap();
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        let is = |name: &str, expected: f64| {
            assert!(
                (number(name) - expected).abs() <= 1e-13 * (1.0 + expected.abs()),
                "{name}: {row:?} {expected}"
            );
        };
        for end in ["start", "end"] {
            let theta =
                number(&format!("{end}_cycle")) * std::f64::consts::TAU + number(&format!("{end}_phase"));
            is(&format!("{end}_time[s]"), theta / 2.0);
            is(&format!("{end}_displacement[m]"), number(&format!("{end}_x")) * 0.004);
        }
        is("start_velocity[m/s]", number("start_v") * 0.008);
        moving += i32::from(number("start_velocity[m/s]") != 0.0);
        is("duration", (number("end_time[s]") - number("start_time[s]")) * 2.0);
        count += 1;
    }
    // All but the first begin at a reversal.
    assert!(count > 4 && moving == 1, "{csv}");
}

#[test]
fn simulate_samples_evenly_and_friction_keeps_its_bound() {
    let machine = "--mass 50 --friction 5 --frequency 2 --omega 0.4 --alpha 6";
    let csv = stdout(&format!("simulate {machine} --cycles 3 --samples 50 --x0 0.02 --v0 -0.1 --format csv"));
    assert_eq!(csv.lines().count(), 1 + 3 * 50 + 1);
    let mut rows = csv::Reader::from_reader(csv.as_bytes());
    for (i, row) in rows.deserialize::<std::collections::HashMap<String, f64>>().enumerate() {
        let row = row.unwrap();
        assert!(row["friction"].abs() <= 1.0);
        let time = std::f64::consts::TAU * i as f64 / 50.0 / 2.0;
        assert!((row["time[s]"] - time).abs() < 1e-13 * (1.0 + time), "{i}: {row:?}");
        if i == 0 {
            assert!(
                (row["displacement[m]"] - 0.02).abs() < 1e-15 && (row["velocity[m/s]"] + 0.1).abs() < 1e-15
            );
            assert!((row["x"] - 5.0).abs() < 1e-12 && (row["v"] + 12.5).abs() < 1e-12);
        }
    }
}

#[test]
fn decay_comes_to_rest_where_it_is_known_to() {
    let answer = json("decay --x0 12 --v0 6 --format json");
    assert_eq!(answer["half_cycles"], 8);
    assert!((answer["rest_position"].as_f64().unwrap() - (15.0 - 205f64.sqrt())).abs() < 1e-14);
    // The same body in physical units: m = 2, k = 800, r_y = 4, so that B = 0.005 and ω_n = 20.
    let physical = json("decay --mass 2 --stiffness 800 --friction 4 --x0 0.06 --v0 0.6 --format json");
    assert_eq!(physical["half_cycles"], 8);
    let place = physical["physical"]["rest_position"].as_f64().unwrap();
    assert!((place / (0.005 * (15.0 - 205f64.sqrt())) - 1.0).abs() < 1e-12);
    assert!(stdout("decay --x0 12 --v0 6").starts_with("At rest after 8 half cycles."));
    assert_eq!(json("decay --x0 0.5 --format json")["half_cycles"], 0);
    // 2⁶⁴ − 1 half cycles once.
    refused("decay --x0 1e70", &["--x0 1e70", "must be", "≤ 4503599627370496"]);
    // The machine above by other quantities: k = m (2π/T)², r_y = µ m g, r_s = 1.5 r_y, c = 2 ζ √(k m).
    let same =
        "--mass 2 --period 0.3141592653589793 --friction-coefficient 0.2 --gravity 10 --x0 0.06 --v0 0.6";
    let other = json(&format!("decay {same} --format json"));
    let close = |a: &Value, b: &Value| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-12;
    for name in ["first_turn", "rest_position", "rest_time"] {
        assert!(close(&other["physical"][name], &physical["physical"][name]), "{name}: {other}");
    }
    let by_force = json(&format!("decay {same} --static-friction 6 --damping 1.6 --format json"));
    let by_ratio =
        json(&format!("decay {same} --static-friction-ratio 1.5 --damping-ratio 0.02 --format json"));
    for name in ["static_friction_ratio", "damping_ratio", "rest_position"] {
        assert!(close(&by_force[name], &by_ratio[name]), "{name}: {by_force}");
    }
    assert_ne!(by_force["rest_position"], other["rest_position"]);
}

#[test]
fn bad_input_is_one_line_with_argument_value_and_inequality() {
    for (arguments, parts) in [
        ("steady --omega 0.4 --alpha 6 --x0 nan", vec!["--x0 nan", "finite"]),
        ("steady --omega 0.4 --alpha 6 --v0 inf", vec!["--v0 inf", "finite"]),
        ("steady --omega 0.4 --alpha 6 --x0 one", vec!["--x0 one", "number"]),
        ("steady --omega 0.4 --alpha 6 --max-periods 0", vec!["--max-periods 0", "≥ 1"]),
        ("steady --omega 1e-9 --alpha 6", vec!["--omega", "Ω = 1e-9", "≥"]),
        ("steady --omega 0.4", vec!["--alpha is missing"]),
        ("simulate --omega 0.4 --alpha 6 --cycles -1", vec!["--cycles -1", "≥ 1"]),
        ("simulate --omega 0.4 --alpha 6 --cycles 0", vec!["--cycles 0", "≥ 1"]),
        ("simulate --omega 0.4 --alpha 6 --cycles 1.5", vec!["--cycles 1.5", "whole"]),
        ("simulate --omega 0.4 --alpha 6 --cycles 1e99", vec!["--cycles 1e99"]),
        ("simulate --omega 0.0001 --alpha 6 --cycles 9999999999", vec!["rows", "≤ 1e10"]),
        ("simulate --omega 0.4 --alpha 6 --cycles 2 --samples 0", vec!["--samples 0", "≥ 1"]),
        (
            "simulate --omega 0.4 --alpha 6 --cycles 2 --format json",
            vec!["--format", "text, jsonl, csv, parquet"],
        ),
        ("decay --x0 nan", vec!["--x0 nan", "finite"]),
        ("decay --x0 1 --mass 2", vec!["--friction (or --friction-coefficient) is missing"]),
        ("decay --x0 1 --mass 2 --friction 3", vec!["--stiffness (or --period", "is missing"]),
        ("decay --x0 1 --omega 0.5", vec!["--omega 0.5: decay does not use it"]),
        ("decay --x0 1 --mass 2 --stiffness -1 --friction 1", vec!["stiffness k = -1 must be > 0"]),
    ] {
        refused(arguments, &parts);
    }
}

/// Ctrl-C during a long run leaves complete rows, and the exit status reports it.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_whole_rows() {
    use std::io::Read;
    use std::process::{Command, Stdio};
    let mut child = Command::new(assert_cmd::cargo::cargo_bin("stickslip"))
        .args("simulate --omega 0.4 --alpha 6 --cycles 1000000000 --format csv".split(' '))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut out = child.stdout.take().unwrap();
    let mut text = vec![0; 1 << 16];
    out.read_exact(&mut text).unwrap();
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    out.read_to_end(&mut text).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let text = String::from_utf8(text).unwrap();
    assert!(text.ends_with('\n'));
    let columns = text.lines().next().unwrap().split(',').count();
    assert!(text.lines().all(|line| line.split(',').count() == columns));
    let mut message = String::new();
    child.stderr.take().unwrap().read_to_string(&mut message).unwrap();
    assert!(message.contains("interrupted"), "{message}");
}

/// The work of a damper is printed in a line of its own, however small; without a damper there is no such
/// line.
#[test]
fn the_work_of_a_damper_is_told_apart() {
    let with = stdout("steady --omega 2 --alpha 1.5 --damping-ratio 1e-4");
    assert!(with.contains("  work against the damper  2.95739e-5 r_y B\n"), "{with}");
    let without = stdout("steady --omega 2 --alpha 1.5");
    assert!(without.contains("work against friction") && !without.contains("damper"), "{without}");
}

/// A time history at a sampling rate, in a file whose header has units.
#[test]
fn a_time_history_has_a_rate_and_a_duration() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("history.csv");
    let machine =
        "--mass 50t --stiffness 1000kN/m --friction 5kN --frequency 1.3Hz --force 12kN --units kN,mm";
    let run = format!("simulate {machine} --rate 1kHz --duration 2s");
    stdout(&format!("{run} --out {}", file.display()));
    let text = std::fs::read_to_string(&file).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    assert!(header.contains("time[s],displacement[mm],velocity[mm/s],acceleration[mm/s^2]"), "{header}");
    let column = |name: &str| header.split(',').position(|other| other.starts_with(name)).unwrap();
    let rows: Vec<Vec<f64>> =
        rows.lines().map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let (time, x, v, a) =
        (column("time["), column("displacement["), column("velocity["), column("acceleration["));
    let friction = column("friction_force[");
    assert_eq!(rows.len(), 2001);
    for (i, row) in rows.iter().enumerate() {
        assert!((row[time] - 1e-3 * i as f64).abs() < 1e-12, "{i}");
        // The equation of motion in kN and mm: 50 t = 0.05 kN s²/mm, 1 kN/mm.
        let force = 12.0 * (1.3 * std::f64::consts::TAU * row[time]).sin();
        let balance = 0.05 * row[a] + row[x] + row[friction] - force;
        assert!(balance.abs() < 1e-9, "{i}: {balance}");
    }
    // Velocities are the differences of displacements.
    for pair in rows.windows(2) {
        let slope = (pair[1][x] - pair[0][x]) / 1e-3;
        assert!((slope - (pair[0][v] + pair[1][v]) / 2.0).abs() < 0.5, "{slope} {:?}", pair[0]);
    }
    refused(&format!("{run} --out {}", file.display()), &["must not exist yet"]);
    let lines = folder.path().join("history.jsonl");
    stdout(&format!("simulate {machine} --duration 2s --out {}", lines.display()));
    let text = std::fs::read_to_string(&lines).unwrap();
    assert!(text.lines().all(|line| line.contains("\"kind\"")) && text.lines().count() > 4, "{text}");
    for (arguments, parts) in [
        ("--rate 0Hz --cycles 1", ["--rate 0Hz", "> 0"]),
        ("--duration -1s", ["--duration -1s", "> 0"]),
        ("--duration 1s --cycles 2", ["--cycles", "--duration"]),
        ("--cycles 2 --samples 3 --rate 1Hz", ["--samples", "--rate"]),
        ("--duration 1e9s --rate 1kHz", ["--duration 1e9s --rate 1kHz", "rows"]),
        ("--cycles 1 --out history.txt", ["--out history.txt", ".csv, .jsonl or .parquet"]),
        ("", ["--cycles", "not provided"]),
    ] {
        refused(&format!("simulate {machine} {arguments}"), &parts);
    }
    refused("simulate --omega 1.5 --alpha 3 --duration 1s", &["--duration 1s", "in ratios"]);
}

/// Without a force the body vibrates freely from its start to rest.
#[test]
fn a_force_of_zero_leaves_the_free_vibration() {
    let body = "--mass 30kg --stiffness 12kN/m --friction 16N --damping-ratio 1% --units N,mm";
    let run = format!(
        "simulate {body} --force 0N --frequency 1Hz --x0 40mm --duration 2.5s --rate 100Hz --format csv"
    );
    let text = stdout(&run);
    let last: Vec<f64> = text.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let rest =
        json(&format!("decay {body} --x0 40mm --format json"))["physical"]["rest_position"].as_f64().unwrap();
    assert!((last[7] - rest).abs() < 1e-9 && last[8] == 0.0, "{last:?} {rest}");
    assert!(stdout("simulate --omega 1.5 --alpha 0 --x0 4.5 --cycles 9").contains("never"));
}

/// A drive with the cosine of the time, and one at another phase: segments and samples beside small steps of time.
#[test]
fn a_simulation_starts_at_any_phase_of_the_drive() {
    let (mass, stiffness, friction, force, frequency) = (2.0, 800.0, 4.0, 30.0, 13.0);
    let machine =
        "--mass 2kg --stiffness 800N/m --friction 4N --force 30N --frequency 13rad/s --x0 3mm --v0 20mm/s";
    for (text, phase) in [("90deg", PI / 2.0), ("0.5rad", 0.5), ("200deg", 200.0 * PI / 180.0), ("0", 0.0)] {
        let rows =
            stdout(&format!("simulate {machine} --phase {text} --duration 1s --rate 50Hz --format csv"));
        let mut reader = csv::Reader::from_reader(rows.as_bytes());
        let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let place = |name: &str| header.iter().position(|own| own.split('[').next() == Some(name)).unwrap();
        let (time, at) = (place("time"), place("displacement"));
        let rows: Vec<[f64; 2]> = reader
            .records()
            .map(|row| row.unwrap())
            .map(|row| [time, at].map(|i| row[i].parse::<f64>().unwrap()))
            .collect();
        assert_eq!(rows.len(), 51, "{text}");
        // The midpoint rule, in which friction takes as much of the momentum as it can.
        let (steps, mut x, mut v) = (4000, 3e-3, 0.02);
        let dt = 0.02 / f64::from(steps);
        for (i, [t, place]) in rows.iter().enumerate() {
            assert!(
                (t - 0.02 * i as f64).abs() < 1e-12 && (x - place).abs() < 2e-6,
                "{text} {t}: {x} {place}"
            );
            for step in 0..steps {
                let t = 0.02 * i as f64 + (f64::from(step) + 0.5) * dt;
                let free =
                    v + dt * (force * (frequency * t + phase).sin() - stiffness * (x + v * dt / 2.0)) / mass;
                let most = friction * dt / mass;
                let after = free - free.clamp(-most, most);
                (x, v) = (x + dt * (v + after) / 2.0, after);
            }
        }
        let segments = stdout(&format!("simulate {machine} --phase {text} --duration 1s --format jsonl"));
        let segments: Vec<serde_json::Value> =
            segments.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let number = |row: &serde_json::Value, name: &str| row[name].as_f64().unwrap();
        assert!((number(&segments[0], "start_phase") - phase).abs() < 1e-14);
        assert_eq!(number(&segments[0], "start_time"), 0.0);
        let last = segments.last().unwrap();
        assert!(number(last, "start_time") < 1.0 && number(last, "end_time") >= 1.0, "{last}");
    }
    for (text, word) in
        [("90", "must have a unit"), ("-1deg", "must be ≥ 0"), ("360deg", "must be ≥ 0"), ("1m", "--phase")]
    {
        refused(&format!("simulate {machine} --phase {text} --cycles 1"), &[word]);
    }
}
