//! Steps, ramps, pulls and free motions of `simulate`, `decay` without a spring, and friction or force 0 in every command.

use crate::command_line::{self, refused};
use serde_json::Value;
use std::f64::consts::{PI, TAU};

/// Without friction a note says what α is then.
fn stdout(line: &str) -> String {
    command_line::stdout(&format!("{line} --quiet"))
}

fn json(line: &str) -> Value {
    serde_json::from_str(&stdout(line)).unwrap()
}

const G: f64 = 9.80665;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

#[track_caller]
fn close(found: f64, due: f64, allowed: f64) {
    assert!((found - due).abs() <= allowed * due.abs().max(1e-3), "{found} {due}");
}

/// A body under a force over the time, by steps of a Runge–Kutta method whose zeros of the velocity are bisected.
struct Stepped<'a> {
    mass: f64,
    stiffness: f64,
    damping: f64,
    friction: f64,
    held: f64,
    load: &'a dyn Fn(f64) -> f64,
}

impl Stepped<'_> {
    fn rate(&self, t: f64, [x, v]: [f64; 2], sign: f64) -> [f64; 2] {
        [v, ((self.load)(t) - self.stiffness * x - self.damping * v - sign * self.friction) / self.mass]
    }

    fn step(&self, t: f64, y: [f64; 2], h: f64, sign: f64) -> [f64; 2] {
        let add = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        let k1 = self.rate(t, y, sign);
        let k2 = self.rate(t + h / 2.0, add(k1, h / 2.0), sign);
        let k3 = self.rate(t + h / 2.0, add(k2, h / 2.0), sign);
        let k4 = self.rate(t + h, add(k3, h), sign);
        [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    /// The displacements and velocities at multiples of `every`.
    fn at(&self, start: [f64; 2], every: f64, count: usize) -> Vec<[f64; 2]> {
        const PARTS: usize = 20_000;
        let h = every / PARTS as f64;
        let (mut y, mut sign) = (start, start[1].signum() * f64::from(start[1] != 0.0));
        let mut found = vec![y];
        for i in 0..count * PARTS {
            let (mut t, end) = (i as f64 * h, (i + 1) as f64 * h);
            while t < end {
                if sign == 0.0 {
                    let push = (self.load)(end) - self.stiffness * y[0];
                    if push.abs() <= self.held {
                        break;
                    }
                    sign = push.signum();
                }
                let next = self.step(t, y, end - t, sign);
                if next[1] * sign >= 0.0 {
                    y = next;
                    break;
                }
                let (mut low, mut high) = (0.0, end - t);
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    if self.step(t, y, middle, sign)[1] * sign >= 0.0 { low = middle } else { high = middle }
                }
                y = [self.step(t, y, low, sign)[0], 0.0];
                (t, sign) = (t + low, 0.0);
                if low == 0.0 {
                    break;
                }
            }
            if (i + 1) % PARTS == 0 {
                found.push(y);
            }
        }
        found
    }
}

#[test]
fn shapes_are_those_of_small_steps() {
    let machines = [
        (2.0, 800.0, 3.0, 4.0, 5.0),
        (0.7, 90.0, 0.0, 1.5, 1.5),
        (5.0, 2e3, 60.0, 11.0, 20.0),
        (1.3, 0.0, 0.4, 2.0, 3.0),
    ];
    for (mass, stiffness, damping, friction, held) in machines {
        for shape in ["step", "ramp", "pull", "free"] {
            if shape == "pull" && stiffness == 0.0 {
                continue;
            }
            let spring =
                if stiffness == 0.0 { "--no-spring".to_owned() } else { format!("--stiffness {stiffness}") };
            let (drive, start): (_, [f64; 2]) = match shape {
                "step" => ("--force 25", [0.0, 0.0]),
                "ramp" => ("--force 30 --rise 0.7", [0.01, -0.3]),
                "pull" => ("--speed 0.05", [0.0, 0.0]),
                _ => ("", [0.02, 1.5]),
            };
            let load = |t: f64| match shape {
                "step" => 25.0,
                "ramp" => 30.0 * (t / 0.7).min(1.0),
                "pull" => stiffness * 0.05 * t,
                _ => 0.0,
            };
            let by_steps = Stepped { mass, stiffness, damping, friction, held, load: &load };
            let line = format!(
                "simulate --mass {mass} {spring} --damping {damping} --friction {friction} --static-friction {held} \
                 --x0={} --v0={} --shape {shape} {drive} --duration 1.5 --rate {} --units N,m --format jsonl",
                start[0],
                start[1],
                10.0 * TAU
            );
            let text = stdout(&line);
            let rows: Vec<Value> = text.lines().map(|row| serde_json::from_str(row).unwrap()).collect();
            let due = by_steps.at(start, 0.1, 15);
            assert_eq!(rows.len(), due.len(), "{line}");
            for (row, [x, v]) in rows.iter().zip(due) {
                let [found, fast] = ["displacement", "velocity"].map(|name| number(&row[name]));
                assert!((found - x).abs() < 2e-5 && (fast - v).abs() < 2e-3, "{line}\n{row} {x} {v}");
            }
        }
    }
}

#[test]
fn segments_under_shapes_are_closed_forms() {
    let of = |line: &str| -> Vec<Value> {
        stdout(line).lines().map(|row| serde_json::from_str(row).unwrap()).collect()
    };
    // A step of 12 N against 4 N: half a period to 2 (12 − 4)/k.
    let step = of(
        "simulate --mass 2kg --stiffness 800N/m --friction 4N --static-friction 5N --force 12N --shape step \
                   --duration 2s --format jsonl",
    );
    assert_eq!(step.len(), 2);
    close(number(&step[0]["end_displacement"]), 0.02, 1e-14);
    close(number(&step[0]["end_time"]), PI / 20.0, 1e-14);
    assert_eq!([&step[0]["ends_by"], &step[1]["ends_by"]], ["stop", "end"]);
    // One of 30 N turns three times, at 65, 20 and 45 mm, and rests at 40 mm.
    let step = of(
        "simulate --mass 2kg --stiffness 800N/m --friction 4N --force 30N --shape step --duration 2s --format jsonl",
    );
    let ends: Vec<_> = step.iter().map(|row| row["ends_by"].as_str().unwrap()).collect();
    assert_eq!(ends, ["reversal", "reversal", "reversal", "stop", "end"]);
    // A ramp of 24 N/s on a block: released at 4/24 s, then x = 24 t³/12.
    let ramp = of(
        "simulate --mass 2kg --no-spring --friction 4N --force 12N --shape ramp --rise 0.5s --duration 0.4s \
                   --format jsonl",
    );
    close(number(&ramp[0]["end_time"]), 1.0 / 6.0, 1e-14);
    close(number(&ramp[1]["end_displacement"]), 2.0 * (0.4_f64 - 1.0 / 6.0).powi(3), 1e-13);
    // A pull repeats the slips and sticks of `pull`.
    let machine = "--mass 2kg --stiffness 450N/m --friction 3N --static-friction 4N";
    let pull = json(&format!("pull {machine} --speed 20mm/s --format json"));
    let rows = of(&format!("simulate {machine} --shape pull --speed 20mm/s --duration 3s --format jsonl"));
    assert!(rows.len() > 8, "{rows:?}");
    close(number(&rows[0]["end_time"]), 4.0 / (450.0 * 0.02), 1e-14);
    for row in &rows[1..rows.len() - 1] {
        let length = number(&row["end_time"]) - number(&row["start_time"]);
        let due = if row["kind"] == "stick" { &pull["stick_time"] } else { &pull["slip_time"] };
        close(length, number(due), 1e-12);
    }
}

#[test]
fn shapes_refuse_what_they_do_not_use() {
    let machine = "simulate --mass 2kg --stiffness 800N/m --friction 4N --duration 1s";
    for (rest, said) in [
        ("--force 12N --shape step --frequency 2Hz", "--frequency 2Hz: must be left out with --shape step"),
        ("--force 12N --shape step --phase 3deg", "--phase: must be left out with --shape step"),
        ("--shape step", "--force"),
        ("--force 12N --shape ramp", "--rise is missing"),
        ("--force 12N --shape step --rise 1s", "--rise: must be left out with --shape step"),
        ("--shape pull --speed 0m/s", "--speed 0m/s: must be > 0"),
        ("--shape free --force 2N", "--force 2N: must be left out with --shape free"),
        ("--force 12N --frequency 1Hz --rise 1s", "--rise: needs --shape"),
        ("--base-velocity 1m/s --shape step", "--base-velocity 1m/s: must be --force"),
        ("--damped-foot-displacement 1m --shape step", "--damped-foot-displacement 1m: must be --force"),
        ("--no-spring --force 12N --shape step", "--stiffness 800N/m: must be left out with --no-spring"),
    ] {
        refused(&format!("{machine} {rest}"), &[said]);
    }
    refused(
        "simulate --mass 2kg --stiffness 800N/m --friction 4N --force 12N --shape step --duration 1e9s",
        &["--duration 1e9s: about 6.4e9 half cycles", "must be ≤ 1e6"],
    );
    refused(
        "simulate --mass 2kg --no-spring --friction 4N --shape pull --speed 1m/s --duration 2s",
        &["--shape pull"],
    );
}

/// `v²/2µg`, on a slope `v²/2g(µ cos − sin)`, and with a damper `(m/c)ln(1 + c v/r)`.
#[test]
fn a_block_slides_to_its_rest() {
    let of = |line: &str| json(&format!("decay --no-spring {line} --format json"))["physical"].clone();
    let flat = of("--friction-coefficient 0.3 --v0 2m/s");
    close(number(&flat["rest_position"]), 4.0 / (0.6 * G), 1e-14);
    close(number(&flat["rest_time"]), 2.0 / (0.3 * G), 1e-14);
    let (sine, cosine) = 5f64.to_radians().sin_cos();
    // On a slope a displacement counts from the relaxed spring, and the answer says so.
    let sprung = "--mass 800kg --stiffness 6kN/m --friction 100N --x0 0.3m";
    let relaxed = "measured from the relaxed spring";
    assert!(stdout(&format!("decay {sprung} --slope 10deg")).contains(relaxed));
    assert!(!stdout(&format!("decay {sprung} --one-way")).contains(relaxed));
    let mean = stdout(&format!("decay {sprung} --mean-force 300N"));
    assert!(mean.contains("0.05 m (displacements are measured from there)"), "{mean}");
    let slope = of("--friction-coefficient 0.3 --slope 5deg --v0 2m/s");
    close(number(&slope["path"]), 2.0 / (G * (0.3 * cosine - sine)), 1e-13);
    // From rest down a slope with a spring: to twice the displacement of its balance.
    let slide = "decay --mass 1kg --stiffness 100N/m --friction 1N --slope 30deg --x0 0m --format json";
    close(number(&json(slide)["physical"]["first_turn"]), 2.0 * (0.5 * G - 1.0) / 100.0, 1e-13);
    let damped = of("--mass 3kg --friction 1N --damping 2N*s/m --v0=-2m/s --x0 1m");
    let time = 1.5 * 5f64.ln();
    close(number(&damped["rest_time"]), time, 1e-13);
    close(number(&damped["rest_position"]), 1.0 - (3.0 * 2.0 - time) / 2.0, 1e-13);
    let viscous = of("--mass 3kg --friction 0N --damping 2N*s/m --v0 2m/s");
    close(number(&viscous["rest_position"]), 3.0, 1e-13);
    assert!(viscous["rest_time"].is_null());
    let steep = of("--friction-coefficient 0.3 --slope 25deg --v0 2m/s");
    assert!(["rest_position", "path", "rest_time"].iter().all(|name| steep[*name].is_null()), "{steep}");
    refused(
        "decay --friction-coefficient 0.3 --v0 2m/s",
        &["is missing. A body without a spring has --no-spring"],
    );
    refused(
        "decay --no-spring --friction-coefficient 0.3 --v0 2m/s --out /tmp/none.svg",
        &["simulate --shape free"],
    );
}

/// A linear oscillator with ζ: turns κ apart, and a path of x₀ (1 + κ)/(1 − κ).
#[test]
fn without_friction_a_vibration_does_not_rest() {
    let of = |line: &str| {
        json(&format!("decay --mass 1kg --stiffness 100N/m --friction 0N {line} --format json"))["physical"]
            .clone()
    };
    let ratio = (-0.1 * PI / (1.0f64 - 0.01).sqrt()).exp();
    let damped = of("--damping-ratio 0.1 --x0 0.1m");
    close(number(&damped["path"]), 0.1 * (1.0 + ratio) / (1.0 - ratio), 1e-12);
    assert_eq!((number(&damped["rest_position"]), &damped["rest_time"]), (0.0, &Value::Null));
    let free = of("--v0 2m/s");
    close(number(&free["first_turn"]), 0.2, 1e-13);
    assert!(free["path"].is_null() && free["rest_position"].is_null());
}

const MACHINE: &str = "--mass 1kg --stiffness 100N/m --damping-ratio 3%";

/// The amplitude of the linear oscillator under a force of 3 N.
fn linear(hertz: f64) -> f64 {
    let omega = TAU * hertz;
    3.0 / (100.0 - omega * omega).hypot(0.6 * omega)
}

#[test]
fn friction_0_is_the_linear_oscillator_in_every_command() {
    let drive = format!("{MACHINE} --friction 0N --force 3N");
    for command in ["response", "steady"] {
        let found = json(&format!("{command} {drive} --frequency 1.3Hz --format json"));
        close(number(&found["physical"]["max_displacement"]), linear(1.3), 1e-13);
        assert_eq!(number(&found["physical"]["friction"]), 0.0);
        let rows = stdout(&format!(
            "sweep {command} {drive} --frequency 1Hz,1.5Hz,2Hz --outputs max_displacement[m],friction[N] --format csv"
        ));
        // No ratio of the friction exists, and its works and forces are 0.
        for name in ["alpha", "max_displacement", "max_velocity"] {
            assert!(found[name].is_null(), "{command}: {name} {}", found[name]);
        }
        let names: &[&str] = if command == "response" {
            assert!(["min_force_ratio", "best_force_ratio"].iter().all(|name| found[*name].is_null()));
            assert!(found["dynamic_amplification"].is_number());
            &["friction_displacement", "deviation", "min_force", "energy_per_cycle", "best_force_energy"]
        } else {
            assert!(found["energy_in"].is_null() && found["energy_out"].is_null());
            &["friction_displacement", "energy_out"]
        };
        for name in names {
            assert_eq!(number(&found["physical"][name]), 0.0, "{command}: {name}");
        }
        let text = stdout(&format!("{command} {drive} --frequency 1.3Hz"));
        assert!(["displacement B", " B ", "r_y =", "e3"].iter().all(|part| !text.contains(part)), "{text}");
        let rows: Vec<&str> = rows.lines().skip(1).collect();
        for (row, hertz) in rows.iter().zip([1.0, 1.5, 2.0]) {
            let (found, friction) = row.split_once(',').unwrap();
            close(found.parse().unwrap(), linear(hertz), 1e-13);
            assert_eq!(friction.parse(), Ok(0.0));
        }
        assert_eq!(rows.len(), 3);
    }
    let all = stdout(&format!("simulate {drive} --frequency 1.3Hz --cycles 1 --samples 4 --format jsonl"));
    for row in all.lines().map(|row| serde_json::from_str::<Value>(row).unwrap()) {
        assert!(["x", "v", "friction", "r"].iter().all(|name| row[*name].is_null()), "{row}");
        assert!(row["displacement"].is_number() && number(&row["friction_force"]).abs() < 1e-25, "{row}");
    }
    let curve = stdout(&format!("response-curve displacement {drive} --frequency 1Hz:2Hz:3"));
    let rows: Vec<Vec<&str>> = curve.lines().skip(1).map(|row| row.split(',').collect()).collect();
    assert!(rows.len() > 10, "{curve}");
    for row in &rows {
        close(row[3].parse().unwrap(), linear(row[1].parse().unwrap()), 1e-12);
    }
    // By coefficient, and by rows of a grid with other frictions.
    let rows = stdout(&format!(
        "sweep response {MACHINE} --friction-coefficient 0,0.01 --force 3N --frequency 1.3Hz --outputs max_displacement[m]"
    ));
    let rows: Vec<f64> = rows.lines().skip(1).map(|row| row.parse().unwrap()).collect();
    close(rows[0], linear(1.3), 1e-13);
    assert!(rows[1] < 0.999 * rows[0], "{rows:?}");
    let force = json(&format!(
        "design displacement {MACHINE} --friction 0N --frequency 1.3Hz --target 4mm --format json"
    ));
    close(number(&force["force"]), 3.0 * 0.004 / linear(1.3), 1e-13);
    let fast = json(&format!(
        "design velocity {MACHINE} --friction 0N --frequency 1.3Hz --target 4mm/s --format json"
    ));
    close(number(&fast["force"]), 3.0 * 0.004 / (linear(1.3) * TAU * 1.3), 1e-13);
    for (command, name) in [("border", "min_force"), ("design force", "force")] {
        let found = json(&format!("{command} {MACHINE} --friction 0N --frequency 1.3Hz --format json"));
        let found = if command == "border" { &found["physical"][name] } else { &found[name] };
        assert_eq!(number(found), 0.0);
    }
    let bands = json(&format!("design bands {drive} --from 1Hz --to 2Hz --format json"));
    close(number(&bands[0]["frequency_from"]), TAU, 1e-14);
    close(number(&bands[0]["frequency_to"]), 2.0 * TAU, 1e-14);
    assert_eq!(json(&format!("design hold {drive} --format json"))["holds"], "never");
    for command in ["attractors", "basins"] {
        refused(
            &format!("{command} {drive} --frequency 1Hz"),
            &["--friction 0N: must be > 0. Without friction"],
        );
    }
    let pull = json(&format!("pull {MACHINE} --friction 0N --speed 0.3m/s --format json"));
    assert_eq!((number(&pull["max_velocity"]), number(&pull["smooth_above"])), (0.3, 0.0));
    let pull = json("pull --mass 1kg --stiffness 100N/m --friction 0N --speed 0.3m/s --format json");
    assert_eq!(number(&pull["max_velocity"]), 0.6);
    refused(&format!("design force {MACHINE} --friction 0N --frequency 1Hz --no-stop"), &["never stops"]);
}

#[test]
fn force_0_is_a_body_at_rest_in_every_command() {
    let rest = format!("{MACHINE} --friction 1N --force 0N");
    for command in ["response", "steady"] {
        let found = json(&format!("{command} {rest} --frequency 1.3Hz --format json"));
        assert_eq!(found["regime"], "stuck", "{found}");
        assert_eq!(number(&found["physical"]["force_amplitude"]), 0.0);
    }
    let both = json(&format!("steady {MACHINE} --friction 0N --force 0N --frequency 1.3Hz --format json"));
    assert_eq!(both["regime"], "stuck");
    let rows = stdout(&format!(
        "sweep response {MACHINE} --friction 1N --force 0N,3N --frequency 1.3Hz --outputs regime"
    ));
    assert_eq!(rows.lines().skip(1).collect::<Vec<_>>(), ["stuck", "non-sticking"]);
    assert_eq!(json(&format!("design hold {rest} --format json"))["holds"], "always");
    assert_eq!(json(&format!("design bands {rest} --from 1Hz --to 2Hz --format json")), Value::Array(vec![]));
    let curve = stdout(&format!("response-curve displacement {rest} --frequency 1Hz:2Hz:3"));
    assert!(curve.lines().skip(1).all(|row| row.contains(",stuck,0,")), "{curve}");
    let limits = json(&format!("attractors {rest} --frequency 1Hz --starts 20 --format json"));
    assert!(limits.to_string().contains("rest"), "{limits}");
    for (question, rest) in [("friction", ""), ("dissipation", ""), ("friction", "--target-amplitude 2mm")] {
        let line = format!("design {question} {MACHINE} --force 0N --frequency 1Hz {rest}");
        refused(&line, &["--force 0N: must be > 0. Without a drive"]);
    }
    // Free vibration without friction: x = x₀ cos ω t.
    let rows = stdout(
        "simulate --mass 1kg --stiffness 100N/m --friction 0N --force 0N --frequency 1Hz --cycles 1 --samples 4 --x0 1m --format jsonl",
    );
    for row in rows.lines().map(|row| serde_json::from_str::<Value>(row).unwrap()) {
        let due = (10.0 * number(&row["time"])).cos();
        assert!((number(&row["displacement"]) - due).abs() < 1e-13, "{row}");
    }
}

#[test]
fn a_curve_of_too_many_stops_is_refused_at_once() {
    let begin = std::time::Instant::now();
    refused("response-curve force --omega=1e-6:0.0787:5 --alpha 13.46", &["--omega 1e-6…", "must be ≤ 5e5"]);
    assert!(begin.elapsed().as_secs() < 5);
}

/// Every shape, with and without a spring, on slopes, with static friction, with two frictions and one way.
#[test]
fn drives_are_those_of_an_independent_program() {
    let file: Value = serde_json::from_str(include_str!("../../../tests/data/drives.json")).unwrap();
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 30);
    for case in cases {
        let arguments = case["arguments"].as_str().unwrap();
        let rows = stdout(&format!("simulate {arguments} --units N,m --format jsonl"));
        let rows: Vec<Value> = rows.lines().map(|row| serde_json::from_str(row).unwrap()).collect();
        let due = case["states"].as_array().unwrap();
        assert!(rows.len() >= due.len() && due.len() == 10, "{arguments}");
        for (row, state) in rows.iter().zip(due) {
            for (place, name) in ["displacement", "velocity"].into_iter().enumerate() {
                let (found, due) = (number(&row[name]), number(&state[place]));
                // The steps are ω h < 1e-4, of which a Runge–Kutta method has an error far below 1e-13 a step, times 2e5 steps.
                let allowed = 1e-10 * number(&case["scale"][place]);
                assert!((found - due).abs() < allowed, "{arguments}: {name} {found} {due}\n{row}");
            }
        }
    }
}
