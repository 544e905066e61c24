//! `system … --bits N`: beside motions that mpmath has computed at 50 digits, at two precisions, and what has no such digits.

use crate::command_line::{json, refused, stdout};
use crate::place::{Place, place};
use serde_json::Value;
use stickslip::Float;
use stickslip::float::{Field, Mp};

const CASES: &str = include_str!("../../../../tests/data/system_digits.json");

type Wide = Mp<4>;

fn number(digits: &Value) -> Wide {
    digits.as_str().unwrap_or_else(|| panic!("a text of digits: {digits}")).parse().unwrap()
}

fn numbers(list: &Value) -> Vec<Wide> {
    list.as_array().unwrap().iter().map(number).collect()
}

/// The file of a case, JSON where it begins with a brace.
fn file(folder: &Place, text: &str) -> String {
    let end = if text.starts_with('{') { "json" } else { "toml" };
    let file = folder.join(format!("machine.{end}"));
    std::fs::write(&file, text).unwrap();
    file.display().to_string()
}

fn folder(name: &str) -> Place {
    let folder = place(name);
    std::fs::create_dir(&*folder).unwrap();
    folder
}

fn question(name: &str, case: &Value) -> String {
    match name {
        "steady" | "border" => name.to_owned(),
        _ => format!("simulate --until {}", case["until"].as_str().unwrap()),
    }
}

/// Thirty digits at 128 bits, and forty-two at 256, where the reference has 48.
#[test]
fn the_digits_of_another_program() {
    let cases: Value = serde_json::from_str(CASES).unwrap();
    let folder = folder("digits");
    for (bits, part) in [(128, 1e-30), (256, 1e-42)] {
        for (name, case) in cases.as_object().unwrap() {
            let file = file(&folder, case["file"].as_str().unwrap());
            let question = question(name, case);
            let found = json(&format!("system {file} {question} --bits {bits} --format json"));
            let near = |output: &str, found: Wide, due: Wide, size: f64| {
                let off = (found - due).to_f64().abs();
                assert!(off <= part * size, "{name}, {output} at {bits} bits: {found} {due}");
            };
            if name == "border" {
                let output = "least_load_factor";
                near(output, number(&found[output]), number(&case[output]), 1.0);
                continue;
            }
            let state = &found[if name == "steady" { "start" } else { "end" }];
            for what in ["displacement", "velocity"] {
                let (found, due) = (numbers(&state[what]), numbers(&case[what]));
                assert_eq!(found.len(), due.len(), "{name}");
                let size = due.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
                for (found, due) in found.into_iter().zip(due) {
                    near(what, found, due, size);
                }
            }
            let (events, due) = (found["events"].as_array().unwrap(), case["events"].as_array().unwrap());
            assert_eq!(events.len(), due.len(), "{name}");
            for (event, due) in events.iter().zip(due) {
                assert_eq!((&event["element"], &event["kind"]), (&due[1], &due[2]), "{name}");
                near("events", number(&event["time"]), number(&due[0]), 1.0);
            }
        }
    }
}

/// What each machine is to be asked, with what is hard about it.
const MACHINES: [(&str, &str); 9] = [
    // A joint out of its balance at the start.
    (
        "units = \"N,m\"\nmasses = { joint = { mass = 0, start = \"0.1 m\" }, box = \"2 kg\" }\n[[springs]]\nbetween = [\"ground\", \"joint\"]\nstiffness = 30\n\
         [[springs]]\nbetween = [\"joint\", \"box\"]\nstiffness = 10\n[[contacts]]\nbetween = [\"ground\", \"joint\"]\nfriction = 0.3\n[[contacts]]\nbetween = \
         [\"joint\", \"box\"]\nfriction = 0.2\n[[forces]]\non = \"box\"\namplitude = 9\nfrequency = 2\n",
        "simulate --until 3s",
    ),
    // A drift.
    (
        r#"{"mass":[[1.1]],"elements":[{"type":"contact","direction":[1],"friction":0.3}],"constant":[0.1],"harmonics":[{"frequency":1.3,"sin":[1]}]}"#,
        "steady",
    ),
    // A self-excited motion, whose period is found.
    (
        r#"{"mass":[[1]],"damping":[[0.01]],"stiffness":[[1]],"elements":[{"type":"contact","direction":[1],"friction":0.3,"peak":1.5,"belt":0.1}]}"#,
        "steady",
    ),
    // Elastic contacts in parallel.
    (
        r#"{"mass":[[1.1]],"damping":[[0.05]],"stiffness":[[1]],"elements":[{"type":"elastic","direction":[1],"stiffness":1,"friction":0.3},{"type":"elastic","direction":[1],"stiffness":2,"friction":0.1}],"harmonics":[{"frequency":1.3,"sin":[1]}]}"#,
        "steady",
    ),
    // A body of 1e-300.
    (
        r#"{"mass":[[1e-300]],"damping":[[0.1e-300]],"stiffness":[[1e-300]],"elements":[{"type":"contact","direction":[1],"friction":0.3e-300}],"harmonics":[{"frequency":1.3,"sin":[1e-300]}]}"#,
        "steady",
    ),
    // Loads with corners, whose times are parts of a period with π in it, and a surface that moves.
    (
        "units=\"N,mm\"\nmasses={a=\"1t\"}\n[[springs]]\nbetween=[\"ground\",\"a\"]\nstiffness=30\ndamping=\"3 N*s/mm\"\n[[contacts]]\nbetween=[\"ground\",\"a\"]\n\
         friction=\"0.1kN\"\nmoves={amplitude=\"10 mm/s\",frequency=\"1Hz\"}\n[[forces]]\non=\"a\"\namplitude=\"1kN\"\nshape=\"square\"\nduty=0.3\nphase=\"30deg\"\n\
         frequency=\"1 Hz\"\n[[forces]]\non=\"a\"\namplitude=\"0.7kN\"\nshape=\"triangle\"\nfrequency=\"2 Hz\"\n",
        "steady",
    ),
    // A normal load that depends on the motion.
    (
        r#"{"mass":[[1,0],[0,1]],"damping":[[0.1,0],[0,0.1]],"stiffness":[[2,-1],[-1,2]],"elements":[{"type":"contact","direction":[1,0],"friction":0.3,"normal":{"const":1,"displacement":[0,0.5],"sin":[0.1]}}],"harmonics":[{"frequency":0.7,"sin":[1,1]}]}"#,
        "steady",
    ),
    // The base by a spline of samples, and a motion to a value that is passed.
    (
        "units=\"N,mm\"\nmasses={a=\"1t\"}\n[[springs]]\nbetween=[\"ground\",\"a\"]\nstiffness=30\n[[contacts]]\nname=\"c\"\nbetween=[\"ground\",\"a\"]\nfriction=\"0.01kN\"\n\
         [base]\ndisplacement=\"base.csv\"\n",
        "simulate --until 1.5s",
    ),
    (
        r#"{"mass":[[1]],"stiffness":[[1]],"elements":[{"type":"contact","direction":[1],"friction":0.1}],"start":{"displacement":[3],"velocity":[0]}}"#,
        "simulate --until q1=-1.3",
    ),
];

/// All numbers of an answer with their places, but for estimates.
fn leaves(place: &str, value: &Value, found: &mut Vec<(String, Wide)>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                if !["change", "decay", "name", "kind", "coordinates", "units", "multipliers"]
                    .contains(&name.as_str())
                {
                    leaves(&format!("{place}.{name}"), value, found);
                }
            }
        }
        Value::Array(list) => list.iter().for_each(|value| leaves(place, value, found)),
        Value::String(_) => found.push((place.to_owned(), number(value))),
        _ => {}
    }
}

/// Whatever is in a file, 128 bits have 33 digits of what 256 bits have, and the works add up.
#[test]
fn two_precisions_agree() {
    let folder = folder("precisions");
    let rows: String = (0..40).map(|i| format!("{}e-2,{}e-1\n", i * 5, (i * 7 % 11) * 3)).collect();
    std::fs::write(folder.join("base.csv"), format!("time[s],displacement[mm]\n{rows}")).unwrap();
    for (text, question) in MACHINES {
        let file = file(&folder, text);
        let [narrow, wide] =
            [128, 256].map(|bits| json(&format!("system {file} {question} --bits {bits} --format json")));
        let [mut found, mut due] = [Vec::new(), Vec::new()];
        leaves("", &narrow, &mut found);
        leaves("", &wide, &mut due);
        assert_eq!(found.len(), due.len(), "{question} {text}");
        let largest = |end: &str| {
            let own = due.iter().filter(|(place, _)| place.contains(end));
            own.map(|(_, x)| x.to_f64().abs()).fold(0.0, f64::max)
        };
        for ((place, found), (_, due)) in found.iter().zip(&due) {
            let kinds = ["displacement", "velocity", "work", "time", "acceleration"];
            let of = match place {
                place if place.contains("drift") => "displacement",
                // What cancels has the rounding of the works.
                place if place.contains("energy") => "work",
                _ => "",
            };
            let of = if of.is_empty() {
                kinds.into_iter().find(|kind| place.contains(kind)).unwrap_or("")
            } else {
                of
            };
            let size = if of.is_empty() { due.to_f64().abs() } else { largest(of) };
            let off = (*found - *due).to_f64().abs();
            assert!(off <= 1e-33 * size, "{question} {place}: {found} {due} {text}");
        }
        for answer in [narrow, wide] {
            let of = |key: &str| number(&answer[key]);
            let works = answer["elements"].as_array().unwrap().iter().map(|e| number(&e["work"]));
            let (mut left, mut size) = (of("load_work") - of("damper_work") - of("stored_energy"), 0.0);
            for work in works {
                (left, size) = (left - work, size + work.to_f64().abs());
            }
            size += of("load_work").to_f64().abs() + of("stored_energy").to_f64().abs();
            assert!(left.to_f64().abs() <= 1e-33 * size, "{question} {text}: {left} of {size}");
        }
    }
}

/// A ball that falls from 1 m at e = ½ comes to rest after √(2/g) (1 + 2), which digits tell from the sum of the flights that are followed.
#[test]
fn the_end_of_ever_smaller_blows_has_all_digits() {
    let folder = folder("ball");
    let ball = r#"{"mass":[[1]],"constant":[9.81],"elements":[{"type":"stop","direction":[1],"gap":0,"restitution":0.5}],"start":{"displacement":[-1],"velocity":[0]}}"#;
    let file = file(&folder, ball);
    for (bits, part) in [(128, 1e-36), (256, 1e-74)] {
        let found = json(&format!("system {file} simulate --until 3 --bits {bits} --format json"));
        let due = Field::sqrt(Wide::from(200) / Wide::from(981)) * Wide::from(3);
        let close = found["events"].as_array().unwrap().last().unwrap();
        assert_eq!(close["kind"], "close");
        for found in [&close["time"], &found["elements"][0]["time_at_rest"]] {
            assert!((number(found) - due).to_f64().abs() < part, "{bits} bits: {found} {due}");
        }
    }
}

/// States at times, and rows of a grid, have their numbers as texts in CSV, JSON and Parquet, and those of doubles are near them.
#[test]
fn samples_and_rows_have_the_digits() {
    let folder = folder("rows");
    let file = file(&folder, MACHINES[3].0);
    let line = format!("system {file} simulate --until 0.1 --samples 3 --bits 128");
    let text = stdout(&line);
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0][0]), (5, "time"));
    // A third of a tenth, and not that of a double.
    assert!(rows[2][0].starts_with("0.0333333333333333333333333333333333333"), "{text}");
    let whole = json(&format!("system {file} simulate --until 0.1 --bits 128 --format json"));
    // A motion in parts rounds otherwise.
    let off = number(&whole["end"]["displacement"][0]) - rows[4][1].parse::<Wide>().unwrap();
    assert!(off.to_f64().abs() < 1e-38, "{off}");
    assert_eq!(json(&format!("{line} --format json"))["displacement"][3][0], rows[4][1]);
    let out = folder.join("states.csv");
    stdout(&format!("{line} --out {}", out.display()));
    assert_eq!(std::fs::read_to_string(out).unwrap(), text);
    let curve = json(&format!("system {file} curve --frequency 1.2,1.3 --bits 128 --format json"));
    let steady = json(&format!("system {file} steady --bits 128 --format json"));
    assert_eq!(curve[1]["frequency"], "1.3");
    assert_eq!(curve[1]["q1.max_displacement"], steady["max_displacement"][0]);
    #[cfg(feature = "parquet")]
    {
        let out = folder.join("rows.parquet");
        stdout(&format!("system {file} curve --frequency 1.2,1.3 --bits 128 --out {}", out.display()));
        assert!(std::fs::metadata(out).unwrap().len() > 100);
    }
    let of_doubles = json(&format!("system {file} steady --format json"));
    let near =
        number(&steady["max_displacement"][0]).to_f64() - of_doubles["max_displacement"][0].as_f64().unwrap();
    assert!(near.abs() < 1e-13, "{near}");
    // The text has the digits of the period.
    let text = stdout(&format!("system {file} steady --bits 128"));
    let period = steady["period"].as_str().unwrap();
    assert!(text.contains(&format!("period                   {period}\n")), "{text}");
}

/// What is only estimated, or drawn, has no more digits than a double.
#[test]
fn what_has_no_such_digits_is_refused() {
    let folder = folder("refused");
    let body = "units=\"N,mm\"\nmasses={a=\"1t\"}\n[[springs]]\nbetween=[\"ground\",\"a\"]\nstiffness=30\n[[contacts]]\nname=\"c\"\nbetween=[\"ground\",\"a\"]\n";
    let law = file(&folder, &format!("{body}law={{formula=\"0.2+0.1*v\"}}\n"));
    refused(
        &format!("system {law} simulate --until 1s --bits 128"),
        &["law: must be a table with more bits than a double has"],
    );
    let sweep = format!(
        "{body}friction=1\n[[forces]]\non=\"a\"\namplitude=3\nsweep={{from=\"1Hz\",to=\"2Hz\",duration=\"2s\"}}\n"
    );
    let sweep = file(&folder, &sweep);
    refused(
        &format!("system {sweep} simulate --until 1s --bits 128"),
        &["sweep: must be left out with more bits"],
    );
    let plain = file(&folder, &format!("{body}friction=1\n"));
    for (rest, due) in [
        ("--bits 128", "--bits: this question does not use it"),
        ("simulate --until 1s --bits 0", "--bits"),
        ("simulate --until 1s --bits 8193", "--bits 8193: precision = 8193 bits must be ≥ 1 and ≤ 8192"),
        ("simulate --until 1s --bits 128 --picture a.svg", "--picture: must be left out beside --bits"),
        ("steady --set c.friction=1:2:2 --resolve --bits 128", "--resolve: must be left out beside --bits"),
        ("simulate --until nan --bits 128", "--until nan: must be a finite number"),
        ("simulate --until -1s --bits 128", "--until -1s: must be > 0 and finite"),
        ("simulate --until 1s --set c.friction=-1 --bits 128", "must be ≥ 0"),
    ] {
        refused(&format!("system {plain} {rest}"), &[due]);
    }
}
