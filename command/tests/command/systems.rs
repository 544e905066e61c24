//! `stickslip system` from the user's side: cases of other projects, a file of named bodies, and what is wrong with files.

#[cfg(feature = "mp")]
mod digits;
mod drives;
#[cfg(feature = "mp")]
mod enclosed;
mod joints;
mod many;
mod pictures;
mod questions;

use crate::command_line::{json, refused, stdout, stickslip};
use crate::compared::Origin::{AnotherProgram, ByHand};
use crate::compared::{agreed, compared};
use crate::place::place;
use serde_json::{Value, json as value};

const CASES: &str = include_str!("../../../tests/data/systems.json");

/// Two masses, of which one slides.
pub(crate) const MACHINE: &str = include_str!("../machine.toml");

/// The machine on a base that moves.
pub(crate) fn shaken() -> String {
    format!("{MACHINE}[base]\nacceleration = {{ amplitude = \"0.2 g\", frequency = \"2 Hz\" }}\n")
}

fn numbers(list: &Value) -> Vec<f64> {
    let number = |x: &Value| x.as_f64().unwrap_or_else(|| x.as_str().unwrap().parse().unwrap());
    list.as_array().unwrap().iter().map(number).collect()
}

/// The greatest distance of two lists, over the greatest number of the second.
fn distance(found: &[f64], due: &[f64]) -> f64 {
    assert_eq!(found.len(), due.len());
    let size = due.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let far = found.iter().zip(due).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    if size > 0.0 { far / size } else { far }
}

/// Thirty-nine cases by an independent program with 25 and more digits: states, extremes, times at rest, events.
#[test]
fn the_cases_of_others_have_their_answers() {
    let cases: Value = serde_json::from_str(CASES).unwrap();
    let mut done = 0;
    for case in cases.as_array().unwrap() {
        let (name, run, due) = (case["name"].as_str().unwrap(), &case["run"], &case["answer"]);
        let mut system = case["system"].clone();
        if run.get("displacement").is_some() {
            system["start"] = value!({"displacement": run["displacement"], "velocity": run["velocity"]});
        }
        let file = place("case.json");
        std::fs::write(&file, system.to_string()).unwrap();
        let question = match run["until"].as_f64() {
            Some(until) => format!("simulate --until {until}"),
            None => "steady".to_owned(),
        };
        let found = json(&format!("system {} {question} --format json", file.display()));
        let (state, of) = if run["until"].is_null() { ("start", "start") } else { ("end", "displacement") };
        let place = [numbers(&found[state]["displacement"]), numbers(&found[state]["velocity"])].concat();
        let mut expected = numbers(&due[of]);
        if state == "end" {
            expected.extend(numbers(&due["velocity"]));
        }
        let of = if run["until"].is_null() { "system steady" } else { "system simulate" };
        let same = |name: &str, found: &[f64], due: &[f64], part: f64| {
            assert_eq!(found.len(), due.len());
            let size = due.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            for (ours, other) in found.iter().zip(due) {
                let room = if size > 0.0 { part * size } else { part };
                compared(&format!("{of} {name}"), *ours, *other, AnotherProgram, room);
            }
        };
        same(state, &place, &expected, 1e-10);
        if let Some(most) = due.get("max") {
            for (part, due) in [("max", most), ("min", &due["min"])] {
                let [x, v] =
                    ["displacement", "velocity"].map(|what| numbers(&found[format!("{part}_{what}")]));
                let (due, bodies) = (numbers(due), x.len());
                same(&format!("{part}_displacement"), &x, &due[..bodies], 1e-9);
                same(&format!("{part}_velocity"), &v, &due[bodies..], 1e-9);
            }
        }
        let events = found["events"].as_array().unwrap();
        let count = due["event_count"].as_u64();
        agreed(&format!("{of} events"), Some(events.len() as u64), count, AnotherProgram);
        for (event, due) in events.iter().zip(due["events"].as_array().unwrap()) {
            let time: f64 = due[0].as_str().unwrap().parse().unwrap();
            compared(&format!("{of} events"), event["time"].as_f64().unwrap(), time, AnotherProgram, 1e-9);
            assert_eq!((&event["element"], &event["kind"]), (&due[1], &due[2]), "{name}");
        }
        done += 1;
    }
    assert_eq!(done, 39);
}

#[test]
fn a_machine_by_names_is_the_same_as_by_matrices() {
    let (named, matrices) = (place("machine.toml"), place("machine.json"));
    std::fs::write(&named, MACHINE).unwrap();
    // In t, N and mm, with ω = 6π.
    let by_matrices = value!({
        "mass": [[1.0, 0.0], [0.0, 0.5]], "damping": [[0.3, 0.0], [0.0, 0.0]],
        "stiffness": [[500.0, -300.0], [-300.0, 300.0]],
        "elements": [{"type": "contact", "direction": [1, 0], "friction": 450}],
        "harmonics": [{"frequency": 6.0 * std::f64::consts::PI, "sin": [0, 1500]}],
        "start": {"displacement": [0, 3], "velocity": [0, 0]},
    });
    std::fs::write(&matrices, by_matrices.to_string()).unwrap();
    for question in ["steady", "simulate --until 2", "border"] {
        let unit = if question.ends_with('2') { "s" } else { "" };
        let one = json(&format!("system {} {question}{unit} --format json", named.display()));
        let two = json(&format!("system {} {question} --format json", matrices.display()));
        for key in ["max_displacement", "min_velocity", "least_load_factor", "load_work"] {
            let list = |answer: &Value| match answer.get(key) {
                Some(Value::Array(_)) => numbers(&answer[key]),
                Some(number) => vec![number.as_f64().unwrap()],
                None => Vec::new(),
            };
            assert!(distance(&list(&one), &list(&two)) < 1e-12, "{question} {key}");
        }
    }
    let text = stdout(&format!("system {}", named.display()));
    assert!(text.starts_with("A system of 2 coordinates, one contact."), "{text}");
    // ω² of [[500, −300], [−300, 300]] and diag(1, ½) are (1100 ± √(1100² − 480000))/2.
    assert!(text.contains("all contacts sliding     1.763677 Hz, 4.975216 Hz"), "{text}");
    assert!(text.contains("all contacts at rest     3.898484 Hz"), "{text}");
}

/// On a base that moves, the forces on a body give its acceleration in space: the motion of the base is not among them.
#[test]
fn absolute_accelerations_are_the_forces_over_the_masses() {
    let file = place("shaken.toml");
    std::fs::write(&file, shaken()).unwrap();
    let line = format!("system {}", file.display());
    let found = json(&format!("{line} simulate --until 3s --format json"));
    assert_eq!(found["units"]["acceleration"], "mm/s²");
    let samples = json(&format!("{line} simulate --until 3s --samples 30000 --format json"));
    let units = serde_json::json!({ "time": "s", "displacement": "mm", "velocity": "mm/s", "acceleration": "mm/s²", "force": "N" });
    assert_eq!(samples["units"], units);
    let lists = ["displacement", "velocity", "force", "absolute_acceleration"];
    let lists = lists.map(|name| samples[name].as_array().unwrap().iter().map(numbers).collect::<Vec<_>>());
    let times = numbers(&samples["time"]);
    let [x, v, force, seen] = &lists;
    let mut due = [0.0f64; 2];
    for (i, time) in times.iter().enumerate() {
        let spring = 300.0 * (x[i][1] - x[i][0]);
        let block = spring - 200.0 * x[i][0] - 0.3 * v[i][0] - force[i][0];
        let roof = (1500.0 * (std::f64::consts::TAU * 3.0 * time).sin() - spring) / 0.5;
        assert!(distance(&seen[i], &[block, roof]) < 1e-10, "{time}: {:?} for {block}, {roof}", seen[i]);
        due = [due[0].max(block.abs()), due[1].max(roof.abs())];
    }
    // The differences of the velocity with the acceleration of the base, away from events.
    let events: Vec<f64> =
        found["events"].as_array().unwrap().iter().map(|e| e["time"].as_f64().unwrap()).collect();
    let mut compared = 0;
    for i in 1..times.len() - 1 {
        let between = times[i - 1]..=times[i + 1];
        if events.iter().any(|time| between.contains(time)) {
            continue;
        }
        let base = 0.2 * 9806.65 * (std::f64::consts::TAU * 2.0 * times[i]).sin();
        for body in 0..2 {
            let slope = (v[i + 1][body] - v[i - 1][body]) / (times[i + 1] - times[i - 1]);
            // ω² of the fastest vibration is 977 s⁻², and (0.1 ms)²/6 of it 2·10⁻⁶ of the acceleration.
            let by = (seen[i][body] - slope - base).abs();
            assert!(by < 4e-6 * due[body], "{body} at {}: {} by {by:e}", times[i], seen[i][body]);
            compared += 1;
        }
    }
    assert!(compared > 59_000, "{compared}");
    let rows = stdout(&format!("{line} simulate --until 3s --samples 30"));
    let mut rows = rows.lines().map(|row| row.rsplitn(3, ',').take(2).map(str::to_owned).collect::<Vec<_>>());
    let header = ["roof", "block"].map(|name| format!("{name}.absolute_acceleration[mm/s²]"));
    assert_eq!(rows.next().unwrap(), header);
    for (i, row) in rows.enumerate() {
        let row: Vec<f64> = row.iter().rev().map(|text| text.parse().unwrap()).collect();
        assert!(distance(&row, &seen[1000 * i]) < 1e-11, "{i}: {row:?}");
    }
    for (seen, due) in numbers(&found["max_absolute_acceleration"]).into_iter().zip(due) {
        // A jump is up to 10⁻⁴ s from a sample.
        let above = (seen - due) / due;
        assert!((-1e-9..1e-3).contains(&above), "{seen} for {due}");
    }
    let most = |line: &str| numbers(&json(line)["max_absolute_acceleration"])[1].to_string();
    let table = stdout(&format!("{line} steady --set bearing.friction=450N,500N"));
    let ends: Vec<_> = table.lines().filter_map(|row| row.rsplit(',').next()).collect();
    let steady = most(&format!("{line} steady --format json"));
    assert_eq!(ends[..2], ["roof.max_absolute_acceleration[mm/s²]", steady.as_str()]);
    let text = stdout(&format!("{line} simulate --until 3s"));
    assert_eq!(text.matches("  absolute acceleration    up to ").count(), 2, "{text}");
    std::fs::write(&file, MACHINE).unwrap();
    let still = json(&format!("{line} simulate --until 3s --format json"));
    assert!(still.get("max_absolute_acceleration").is_none() && still["units"].get("acceleration").is_none());
    let still = json(&format!("{line} simulate --until 3s --samples 3 --format json"));
    assert!(still.get("absolute_acceleration").is_none() && still["units"].get("acceleration").is_none());
}

/// A record beside matrices is in the units that their file names, or in SI, which is said.
#[test]
fn a_record_beside_matrices_is_in_their_units() {
    let folder = place("matrices-under-a-record");
    std::fs::create_dir(&*folder).unwrap();
    let record = folder.join("record.csv");
    let rows =
        (0..300).map(|i| format!("{:.2},{}\n", 0.01 * f64::from(i), 0.3 * (0.12 * f64::from(i)).sin()));
    std::fs::write(&record, "time[s],acceleration[g]\n".to_owned() + &rows.collect::<String>()).unwrap();
    // 1.5 t on 20 N/mm with 300 N, in N and mm, and in SI.
    let run = |name: &str, units: &str, scale: [f64; 3]| {
        let file = folder.join(name);
        let [mass, stiffness, friction] = scale;
        let text = format!(
            r#"{{{units}"mass": [[{mass}]], "stiffness": [[{stiffness}]],
                "elements": [{{"type": "contact", "direction": [1], "friction": {friction}}}]}}"#
        );
        std::fs::write(&file, text).unwrap();
        let line = format!("system {} record {} --format json", file.display(), record.display());
        let ran = stickslip(&line).assert().success().get_output().clone();
        let table = format!("system {} spectrum {}", file.display(), record.display());
        let grid = stickslip(&table).assert().success().get_output().clone();
        let said = [ran.stderr, grid.stderr].map(|text| String::from_utf8(text).unwrap());
        let answer: Value = serde_json::from_slice(&ran.stdout).unwrap();
        (answer, String::from_utf8(grid.stdout).unwrap(), said)
    };
    let (small, rows, said) = run("mm.json", "\"units\": \"N,mm\", ", [1.5, 20.0, 300.0]);
    assert_eq!(small["units"]["displacement"], "mm");
    assert!(
        rows.contains("q1.max_displacement[mm]") && said.iter().all(|text| !text.contains("m/s²")),
        "{rows}"
    );
    let (plain, rows, said) = run("si.json", "", [1500.0, 20_000.0, 300.0]);
    assert!(plain.get("units").is_none() && rows.contains("q1.max_displacement,"), "{rows}");
    for text in said {
        assert!(text.contains("record.csv: taken in m/s² beside the matrices; units = \"N,mm\""), "{text}");
    }
    for name in ["max_displacement", "min_velocity", "max_absolute_acceleration"] {
        let due: Vec<f64> = numbers(&plain[name]).iter().map(|x| 1000.0 * x).collect();
        assert!(distance(&numbers(&small[name]), &due) < 1e-11, "{name}");
    }
}

/// A pad on a belt whose normal load follows a displacement: the frequencies of the machine that slides, its growth, and the friction from
/// which on it flutters, 5/6 without dampers and 0.0004 more with these.
#[test]
fn sliding_that_flutters_is_said() {
    let file = place("squeal.json");
    let system = |friction: f64, belt: f64, stiffness: f64| {
        let system = value!({
            "mass": [[1, 0], [0, 1]], "damping": [[0.02, 0], [0, 0.02]], "stiffness": [[7, -2], [-2, stiffness]],
            "elements": [{"type": "contact", "name": "pad", "direction": [1, 0], "friction": friction, "belt": belt,
                "normal": {"const": 1, "displacement": [0, -3]}}],
        });
        std::fs::write(&file, system.to_string()).unwrap();
        let line = format!("system {}", file.display());
        (json(&format!("{line} --format json")), stdout(&line))
    };
    let (found, text) = system(0.7, 5.0, 5.0);
    // By another program.
    compared("system sliding", found["sliding"]["growth"].as_f64().unwrap(), -0.01, AnotherProgram, 1e-9);
    let threshold = &found["sliding"]["threshold"]["coefficient"];
    compared("system sliding", threshold.as_f64().unwrap(), 0.833_733_333_3, AnotherProgram, 1e-9);
    assert!(
        distance(&numbers(&found["natural_frequencies"]), &[2.259_551_46, 2.625_724_13]) < 1e-8,
        "{found}"
    );
    let sliding = &found["sliding"];
    assert!(
        distance(
            &numbers(&value!([sliding["growth"], sliding["threshold"]["coefficient"]])),
            &[-0.01, 0.833_733_333_3]
        ) < 1e-9
    );
    assert_eq!(sliding["threshold"]["kind"], "flutter");
    assert!(text.contains("all contacts sliding     2.259551, 2.625724"), "{text}");
    assert!(
        text.contains(
            "decays at the rate 0.01. It flutters from a coefficient of friction of 0.8337333 on, at 2.44949."
        ),
        "{text}"
    );
    let (_, text) = system(0.84, 5.0, 5.0);
    assert!(text.contains("Steady sliding is unstable: a disturbance grows at the rate 0.0308195 and oscillates at 2.449809."), "{text}");
    // The belt travels the other way, and the determinant falls to 0 where 14 = 2 (2 + 3 µ).
    let (found, text) = system(0.7, -5.0, 2.0);
    assert!(
        (found["sliding"]["threshold"]["coefficient"].as_f64().unwrap() - 5.0 / 3.0).abs() < 1e-5,
        "{found}"
    );
    assert!(text.contains(" It diverges from a coefficient of friction of 1.66"), "{text}");
    let (found, text) = system(0.7, 0.0, 5.0);
    agreed("system sliding_both_ways", found["sliding_both_ways"][0].as_str(), Some("pad"), ByHand);
    assert!(found["sliding"].is_null(), "{found}");
    assert!(text.contains("The friction of pad changes sign with the direction of sliding"), "{text}");
}

/// A strut past its buckling load, and a damper that feeds: by matrices only, and named as what they are.
#[test]
fn what_grows_is_named() {
    let file = place("grows.json");
    let system = |stiffness: f64, damping: f64| {
        let system = value!({
            "mass": [[1.0, 0.0], [0.0, 2.0]], "damping": [[0.3, 0.0], [0.0, damping]], "stiffness": [[stiffness, 0.0], [0.0, 8.0]],
            "elements": [{"type": "contact", "direction": [1, 0], "friction": 0.5}],
            "harmonics": [{"frequency": 1.0, "sin": [1, 1]}],
        });
        std::fs::write(&file, system.to_string()).unwrap();
        let line = format!("system {}", file.display());
        (json(&format!("{line} --format json")), stdout(&line), stdout(&format!("{line} steady")))
    };
    let growing = "Growing: the motion grows without bound.";
    let (found, text, steady) = system(-2.0, 0.1);
    assert_eq!(numbers(&found["natural_frequencies"])[0], -std::f64::consts::SQRT_2);
    assert_eq!(found["negative_damping"], false);
    assert!(text.contains("all contacts sliding     unstable (grows at the rate 1.414214), 2"), "{text}");
    assert!(!text.contains("feeds") && steady.starts_with(growing) && !steady.contains("inf"), "{steady}");
    let (found, text, steady) = system(2.0, -0.1);
    agreed("system negative_damping", found["negative_damping"].as_bool(), Some(true), ByHand);
    assert!(text.contains("The damping is negative in some direction: it feeds the motion."), "{text}");
    assert!(steady.starts_with(growing), "{steady}");
    let (_, text, steady) = system(2.0, 0.1);
    assert!(
        !text.contains("unstable") && !text.contains("feeds") && steady.starts_with("Periodic"),
        "{text}"
    );
}

/// The foreseen steps of 60 bodies exceed their budget, which is below that of few bodies.
#[test]
fn a_long_motion_of_a_large_system_is_refused_at_once() {
    let count = 60;
    let mut bodies = vec![vec![0.0; count]; count];
    for (i, row) in bodies.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    let zeros = vec![vec![0.0; count]; count];
    let file = place("large.json");
    let mut force = vec![0.0; count];
    force[0] = 1.0;
    let system = value!({
        "mass": bodies, "damping": zeros, "stiffness": bodies,
        "harmonics": [{"frequency": 1.0, "sin": force}],
    });
    std::fs::write(&file, system.to_string()).unwrap();
    let line = format!("system {}", file.display());
    // The state has 60 displacements, 60 velocities, sine, cosine and 1: 512·10⁶/(123·120) steps.
    refused(
        &format!("{line} simulate --until 40000"),
        &["--until 40000: must be ≤ 34", "34688 steps of the fastest"],
    );
    stdout(&format!("{line} simulate --until 1"));
}

/// Just below the least load the contact rests in each period, just above it never.
#[test]
fn the_border_is_between_sticking_and_not() {
    let file = place("machine.toml");
    std::fs::write(&file, MACHINE).unwrap();
    let border = json(&format!("system {} border --format json", file.display()));
    let least = 1500.0 * border["least_load_factor"].as_f64().unwrap();
    for (factor, rests) in [(0.999, 2), (1.001, 0)] {
        let set = format!("--set forces[1].amplitude={}N", least * factor);
        let found = json(&format!("system {} steady --format json {set}", file.display()));
        assert_eq!(found["elements"][0]["stops"], rests, "{factor}");
    }
    let text = stdout(&format!("system {} border", file.display()));
    let verdict =
        "The contact bearing never sticks if the load on roof is at least 0.3040677 times this one.\n";
    assert!(text.starts_with(verdict), "{text}");
    let cycle = &border["cycle"];
    let steady = json(&format!("system {} steady --format json", file.display()));
    assert!(
        distance(&[cycle["max_displacement"].as_f64().unwrap()], &numbers(&steady["max_displacement"])[..1])
            < 1e-12
    );
}

#[test]
fn a_grid_has_a_row_for_each_place() {
    let file = place("machine.toml");
    std::fs::write(&file, MACHINE).unwrap();
    let curve = stdout(&format!(
        "system {} curve --frequency 1Hz:5Hz:3 --set bearing.friction=400N:600N:2",
        file.display()
    ));
    let rows: Vec<Vec<&str>> = curve.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 7);
    assert_eq!(rows[0][..3], ["bearing.friction[N]", "frequency[Hz]", "kind"]);
    let place = rows[0].iter().position(|name| *name == "roof.max_displacement[mm]").unwrap();
    let one = json(&format!("system {} steady --format json --set bearing.friction=600N", file.display()));
    assert_eq!(rows[5][..2], ["600.0", "3.0"]);
    assert_eq!(rows[5][place].parse::<f64>().unwrap(), numbers(&one["max_displacement"])[1]);
    // A column has the unit of its quantity, however the values were typed.
    for typed in ["400:600:2", "400,600", "400N,0.6kN", "400,600N", "0.4kN,600 N"] {
        let command = format!("system {} border --set", file.display());
        let path = format!("bearing.friction={typed}");
        let mut arguments: Vec<&str> = command.split(' ').collect();
        arguments.push(&path);
        let answer = String::from_utf8(stickslip("").args(arguments).output().unwrap().stdout).unwrap();
        let rows: Vec<Vec<&str>> = answer.lines().map(|line| line.split(',').collect()).collect();
        let unit = if typed.starts_with("0.4k") { "kN" } else { "N" };
        assert_eq!(rows[0][0], format!("bearing.friction[{unit}]"), "{typed}");
        let due = if unit == "N" { ["400.0", "600.0"] } else { ["0.4", "0.6"] };
        assert_eq!([rows[1][0], rows[2][0]], due, "{typed}");
    }
    // A list in another order, as JSON lines, one row of which is wrong.
    let line =
        format!("system {} border --set bearing.friction=-1N,600N,400N --format jsonl", file.display());
    let answer = stickslip(&line).output().unwrap();
    let rows: Vec<Value> = String::from_utf8(answer.stdout)
        .unwrap()
        .lines()
        .map(|row| serde_json::from_str(row).unwrap())
        .collect();
    let least = json(&format!("system {} border --format json --set bearing.friction=400N", file.display()));
    assert_eq!(rows[2]["least_load_factor"], least["least_load_factor"]);
    assert_eq!(
        (&rows[0]["bearing.friction[N]"], &rows[0]["least_load_factor"]),
        (&value!(-1.0), &Value::Null)
    );
    let said = String::from_utf8(answer.stderr).unwrap();
    assert!(
        said.contains("no answer in row 1: bearing.friction=-1N: contacts[1].friction -1N")
            && said.contains("≥ 0"),
        "{said}"
    );
}

/// A grid over two records, whole, in two parts, and continued after an interruption, is the same; each row is the
/// motion of the one system under the one record.
/// In a file and on the command line: a column without a typed unit names it.
#[test]
fn a_bare_frequency_is_in_radians_per_second() {
    let file = place("bare.toml");
    let described = |frequency: &str| {
        let body = "[[springs]]\nbetween = [\"ground\", \"m\"]\nstiffness = 300";
        let load = format!("[[forces]]\non = \"m\"\namplitude = 5\nfrequency = {frequency}");
        std::fs::write(&file, format!("masses = {{ m = 2 }}\n{body}\n{load}\n")).unwrap();
        format!("system {}", file.display())
    };
    let state =
        |frequency: &str| json(&format!("{} steady --format json", described(frequency)))["start"].clone();
    // A frequency with a unit stands beside bare numbers.
    let due = state("\"3 rad/s\"");
    assert_eq!(due, state("3"));
    assert_ne!(due, state("\"3 Hz\""));
    let line = described("1");
    let rows = |typed: &str| -> Vec<(String, String)> {
        let rows = stdout(&format!("{line} {typed}"));
        rows.lines()
            .filter_map(|row| row.split_once(','))
            .map(|(a, b)| (a.to_owned(), b.to_owned()))
            .collect()
    };
    for (name, bare, typed) in [
        ("frequency", "curve --frequency 2:3:2", "curve --frequency 2rad/s:3rad/s:2"),
        ("frequency", "curve --frequency 2,3", "curve --frequency 2rad/s,3rad/s"),
        (
            "forces[1].frequency",
            "steady --set forces[1].frequency=2:3:2",
            "steady --set forces[1].frequency=2rad/s:3rad/s:2",
        ),
    ] {
        assert_eq!(rows(bare), rows(typed), "{bare}");
        assert_eq!(rows(bare)[0].0, format!("{name}[rad/s]"));
    }
    // Matrices without units have radians per unit of time.
    let matrices = r#"{"mass": [[2]], "stiffness": [[300]], "harmonics": [{"frequency": 3, "sin": [5]}]}"#;
    std::fs::write(&file, matrices).unwrap();
    assert_eq!(rows("curve --frequency 2:3:2")[0].0, "frequency");
    assert_eq!(due, json(&format!("{line} steady --format json"))["start"]);
}

#[test]
fn a_grid_over_records_is_whole_in_parts_and_continued() {
    let folder = place("records-of-a-system");
    std::fs::create_dir(&*folder).unwrap();
    let of = |name: &str| folder.join(name);
    std::fs::write(of("machine.toml"), MACHINE).unwrap();
    for (name, sign) in [("a.csv", 1.0), ("b.csv", -2.0)] {
        let rows = (0..400).map(|i| {
            let t = f64::from(i) * 0.01;
            format!("{t},{}", sign * 0.1 * (9.0 * t).sin())
        });
        let text = ["time[s],acceleration[g]".to_owned()].into_iter().chain(rows).collect::<Vec<_>>();
        std::fs::write(of(name), text.join("\n")).unwrap();
    }
    let [machine, a, b] = ["machine.toml", "a.csv", "b.csv"].map(|name| of(name).display().to_string());
    let grid = format!("system {machine} record {a} {b} --set bearing.friction=300N:900N:4");
    let whole = stdout(&grid);
    let rows: Vec<Vec<&str>> = whole.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), &rows[0][..3]), (9, &["record", "bearing.friction[N]", "duration[s]"][..]));
    assert_eq!(rows[7][..2], [&*b, "700.0"]);
    let one = json(&format!("system {machine} record {b} --set bearing.friction=700N --format json"));
    let place = |name: &str| rows[0].iter().position(|own| *own == name).unwrap();
    let at = |name: &str| rows[7][place(name)].parse::<f64>().unwrap();
    assert_eq!(at("block.max_displacement[mm]"), numbers(&one["max_displacement"])[0]);
    assert_eq!(at("roof.end_displacement[mm]"), numbers(&one["end"]["displacement"])[1]);
    assert_eq!(at("bearing.work[N·mm]"), one["elements"][0]["work"].as_f64().unwrap());
    let parts = ["1/2", "2/2 --no-header"].map(|shard| stdout(&format!("{grid} --shard {shard}")));
    assert_eq!(parts.concat(), whole);
    let file = of("grid.csv");
    let cut = whole.lines().take(4).collect::<Vec<_>>().join("\n") + "\nb.csv,70";
    std::fs::write(&file, &whole.as_bytes()[..cut.len().min(whole.len())]).unwrap();
    stdout(&format!("{grid} --out {} --resume", file.display()));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), whole);
    // Of another grid.
    refused(
        &format!(
            "system {machine} record {b} {a} --set bearing.friction=300N:900N:4 --out {} --resume",
            file.display()
        ),
        &["--resume", "grid.csv"],
    );
}

#[test]
fn each_mistake_is_one_line_with_its_place() {
    let file = place("machine.toml");
    for (old, new, parts) in [
        (
            "friction = \"450 N\"",
            "frictoin = \"450 N\"",
            vec!["contacts[1].frictoin is unknown. Did you mean friction?"],
        ),
        (
            "stiffness = \"200 N/mm\"",
            "stifness = \"200 N/mm\"",
            vec!["springs[1].stifness is unknown", "stiffness?"],
        ),
        ("\"500 kg\"", "\"500 N\"", vec!["masses.roof.mass 500 N", "must be a mass", "unit of force"]),
        ("block = \"1 t\"", "block = \"-1 t\"", vec!["masses.block -1 t: must be ≥ 0"]),
        (
            "[\"block\", \"roof\"]",
            "[\"block\", \"rof\"]",
            vec!["springs[2].between[2] rof: is no body. Did you mean roof?"],
        ),
        (
            "\"200 N/mm\"",
            "\"-200 N/mm\"",
            vec!["springs[1].stiffness -200 N/mm: must be ≥ 0", "buckled strut"],
        ),
        (
            "\"0.3 N*s/mm\"",
            "\"-0.3 N*s/mm\"",
            vec!["springs[1].damping -0.3", "must be ≥ 0", "feeds the motion"],
        ),
        ("[masses]", "[masses", vec!["line 3"]),
        ("frequency = \"3 Hz\"", "frequency = \"0 Hz\"", vec!["forces[1].frequency 0 Hz: must be > 0"]),
        ("units = \"N,mm\"", "units = \"N,furlong\"", vec!["units N,furlong"]),
        ("on = \"roof\"", "on = \"ground\"", vec!["forces[1].on ground", "does not move"]),
        ("friction = \"450 N\"", "friction = \"-450 N\"", vec!["contacts[1].friction -450 N: must be ≥ 0"]),
        (
            "friction = \"450 N\"",
            "friction = \"450 N\"\npeak = 0.5",
            vec!["contacts[1].peak 0.5: must be ≥ 1"],
        ),
        ("friction = \"450 N\"", "friction = nan", vec!["contacts[1].friction NaN: must be finite"]),
        (
            "stiffness = \"200 N/mm\"",
            "stiffness = \"-200 N/mm\"",
            vec!["springs[1].stiffness -200 N/mm: must be ≥ 0", "by matrices"],
        ),
        (
            "damping = \"0.3 N*s/mm\"",
            "damping = -0.3",
            vec!["springs[1].damping -0.3: must be ≥ 0", "by matrices"],
        ),
        ("damping = \"0.3 N*s/mm\"", "damping = inf", vec!["springs[1].damping inf: must be finite"]),
        (
            "friction = \"450 N\"",
            "friction = 1\ncoefficient = 0.1",
            vec!["contacts[1]: must have only one of friction"],
        ),
        (
            "friction = \"450 N\"",
            "friction = 1\nstiffness = 2\npeak = 2",
            vec!["contacts[1].peak 2: must be left out"],
        ),
        ("name = \"bearing\"", "name = \"roof\"", vec!["the name roof is used twice"]),
        ("name = \"bearing\"", "name = \"\"", vec!["contacts[1].name : a name must not be empty"]),
    ] {
        std::fs::write(&file, MACHINE.replacen(old, new, 1)).unwrap();
        refused(&format!("system {} steady", file.display()), &parts);
    }
    std::fs::write(&file, MACHINE).unwrap();
    let line = format!("system {}", file.display());
    refused(&format!("{line} simulate"), &["--until is missing"]);
    refused(&format!("{line} simulate --until 0s"), &["--until 0s: must be > 0"]);
    refused(&format!("{line} simulate --until inf"), &["--until inf: must be > 0 and finite"]);
    refused(
        &format!("{line} steady --set bearing.friction=1N --set bearing.friction=2N"),
        &["must be given once"],
    );
    refused(&format!("{line} curve --frequency 1Hz,,2Hz"), &["--frequency 1Hz,,2Hz: a value is missing"]);
    refused(&format!("{line} steady --overwrite"), &["--overwrite: needs --picture"]);
    refused(&format!("{line} steady --set contacts[0].friction=1N"), &["whole number ≥ 1"]);
    for path in ["contacts.0.friction", "contacts.1.friction", "contacts[2].friction"] {
        let parts = [format!("{path}=1N: "), "no place of the list, which has [1] to [1]".to_owned()];
        refused(&format!("{line} steady --set {path}=1N"), &parts.each_ref().map(String::as_str));
    }
    let same = ["contacts[1].friction", "bearing.friction"];
    let same = same.map(|path| stdout(&format!("{line} steady --set {path}=321N")));
    assert_eq!(same[0], same[1]);
    // What was typed is blamed, not the value of the file that it replaces, and not a harmonic of the engine.
    refused(
        &format!("{line} steady --set bearing.friction=-1N"),
        &["bearing.friction=-1N: contacts[1].friction -1N: must be ≥ 0"],
    );
    for typed in ["-3", "0", "-2Hz"] {
        let due = format!("--frequency {typed}: must be > 0 and finite");
        refused(&format!("{line} curve --frequency={typed}"), &[&due]);
    }
    refused(&format!("{line} simulate --until 1e300s"), &["--until 1e300s: must be ≤"]);
    refused(&format!("{line} steady --until 1s"), &["--until: this question does not use it"]);
    refused(&format!("{line} steady --set bearin.friction=5N"), &["bearin is neither a name nor a place"]);
    refused(&format!("{line} curve --frequency 1Hz:2kHz:5"), &["both ends must have the same unit"]);
    refused(&format!("{line} record none.at2"), &["none.at2"]);
    refused("system none.toml", &["none.toml"]);
}

/// The rows of a resolved curve are those of the grid, as they were, and others, the highest of which is the peak of a fine grid.
#[test]
fn a_table_may_have_its_peaks() {
    let folder = place("peaks-of-tables");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("machine.toml");
    std::fs::write(&file, MACHINE.replace("450 N", "50 N")).unwrap();
    let line = format!("system {} curve --frequency 4Hz:6Hz", file.display());
    let coarse = stdout(&format!("{line}:5"));
    let resolved = stdout(&format!("{line}:5 --resolve"));
    let rows: Vec<&str> = resolved.lines().collect();
    assert_eq!(rows[0], format!("{},source", coarse.lines().next().unwrap()));
    let given: Vec<&str> = rows.iter().filter_map(|row| row.strip_suffix(",grid")).collect();
    assert_eq!(given, coarse.lines().skip(1).collect::<Vec<_>>());
    let added = rows.iter().filter(|row| row.ends_with(",added")).count();
    assert!(added > 5 && added + 6 == rows.len(), "{resolved}");
    let place = rows[0].split(',').position(|name| name == "roof.max_displacement[mm]").unwrap();
    let top = |table: &str| {
        let cells =
            table.lines().skip(1).map(|row| row.split(',').nth(place).unwrap().parse::<f64>().unwrap());
        cells.fold(0.0f64, f64::max)
    };
    let fine = top(&stdout(&format!("system {} curve --frequency 4.965Hz:4.985Hz:801", file.display())));
    let (seen, missed) = (top(&resolved), top(&coarse));
    assert!((seen / fine - 1.0).abs() < 1e-6 && missed < 0.9 * fine, "{seen} {missed} {fine}");
    let places = resolved.lines().skip(1).map(|row| row.split(',').next().unwrap().parse::<f64>().unwrap());
    assert!(places.collect::<Vec<_>>().is_sorted());
    let many = json(&format!("{line}:5 --resolve --format json"));
    assert_eq!(many.as_array().unwrap().len(), rows.len() - 1);
    refused(
        &format!("system {} border --set bearing.friction=1N:9N:3 --resolve", file.display()),
        &["--resolve: belongs to curve and steady"],
    );
    refused(&format!("{line}:5 --set bearing.friction=1N,2N --resolve"), &["--resolve: needs one axis"]);
    refused(&format!("{line}:5 --resolve --resume"), &["--resume"]);
}

#[cfg(feature = "parquet")]
#[test]
fn rows_and_samples_are_the_same_as_parquet() {
    let folder = place("parquet-of-systems");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("machine.toml");
    std::fs::write(&file, shaken()).unwrap();
    for (name, line) in [
        ("samples", "simulate --until 1s --samples 50"),
        ("grid", "curve --frequency 1Hz:5Hz:9 --set bearing.friction=1N,450N"),
    ] {
        let [csv, parquet] = ["csv", "parquet"].map(|end| folder.join(format!("{name}.{end}")));
        for out in [&csv, &parquet] {
            stdout(&format!("system {} {line} --out {}", file.display(), out.display()));
        }
        let text = std::fs::read_to_string(&csv).unwrap();
        let rows = crate::parquet::text(&parquet);
        assert_eq!(rows, text, "{name}");
        assert!(
            text.lines().next().unwrap().contains("roof.") && text.contains("absolute_acceleration[mm/s²]")
        );
    }
}

/// Two values of a record at one time are a step of the load for a system, as for one body: a conveyor that jerks.
#[test]
fn a_step_of_a_record_moves_a_system_as_it_moves_one_body() {
    let folder = place("steps-of-a-record");
    std::fs::create_dir(&*folder).unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let rows = "0,0.3\n0.06,0.3\n0.06,-0.9\n0.08,-0.9\n0.08,0.3\n0.14,0.3\n0.14,-0.9\n0.16,-0.9\n";
    let record = write("jerk.csv", &format!("time[s],acceleration[g]\n{rows}"));
    let machine = write(
        "track.toml",
        "units = \"N,mm\"\nmasses = { part = \"1 kg\" }\n[[contacts]]\nname = \"track\"\nbetween = [\"ground\",\"part\"]\n\
         coefficient = 0.5\nnormal_load = \"9.80665 N\"\n",
    );
    let system = json(&format!("system {machine} record {record} --until 1s --format json"));
    let one = json(&format!(
        "record {record} --units N,mm --mass 1kg --no-spring --friction 4.903325N --format json"
    ));
    let (found, due) =
        (system["end"]["displacement"][0].as_f64().unwrap(), one["residual_displacement"].as_f64().unwrap());
    assert!(due > 1.0 && (found / due - 1.0).abs() < 1e-12, "{found} {due}");
    // Three at one time are none.
    let record = write("three.csv", "time[s],acceleration[g]\n0,0\n1,0.3\n1,0.4\n1,0.5\n2,0\n");
    refused(&format!("system {machine} record {record}"), &["three.csv line 5"]);
}
