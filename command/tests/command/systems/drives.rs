//! Loads that repeat themselves, normal loads that vary, bodies that are moved and values that are passed, from files.

use super::{distance, numbers};
use crate::command_line::{json, refused, said, stdout, stickslip};
use crate::compared::{Origin::ByHand, near};
use crate::place::{Place, place};
use std::f64::consts::TAU;

const G: f64 = 9.80665;

/// A folder with files.
fn folder(name: &str, files: &[(&str, &str)]) -> Place {
    let folder = place(name);
    std::fs::create_dir(&*folder).unwrap();
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    folder
}

fn number(found: &serde_json::Value) -> f64 {
    found.as_f64().unwrap()
}

/// A part of 1 kg on a track, with a friction of 0.5 of its weight.
const TRACK: &str = "units = \"N,mm\"\nmasses = { part = \"1 kg\" }\n[[contacts]]\nname = \"track\"\nbetween = [\"ground\", \"part\"]\n\
                     coefficient = 0.5\nnormal_load = \"9.80665 N\"\n";

/// A track that jerks carries its part forward by the squares of velocities: 0.9 g for 0.02 s against a friction of 0.5 g, then 0.3 g with it. Fifty
/// cycles carry it 59.075 mm, as in Winkler's paper on such conveyors.
#[test]
fn a_conveyor_that_jerks_carries_its_part_as_by_hand() {
    let cycle = "time[s],acceleration[g]\n0,0.3\n0.06,0.3\n0.06,-0.9\n0.08,-0.9\n";
    let file = format!("{TRACK}[base]\nacceleration = {{ file = \"cycle.csv\", repeats = true }}\n");
    let folder = folder("jerks", &[("cycle.csv", cycle), ("jerk.toml", &file)]);
    let machine = folder.join("jerk.toml").display().to_string();
    let steady = json(&format!("system {machine} steady --format json"));
    let speed = 400.0 * G * 0.02;
    let due = speed * speed / 2.0 * (1.0 / (400.0 * G) + 1.0 / (800.0 * G));
    assert!((number(&steady["drift"][0]) - due).abs() < 1e-12, "{steady}");
    assert_eq!((&steady["kind"], &steady["periods"]), (&"periodic".into(), &1.into()));
    let events: Vec<_> = steady["events"].as_array().unwrap().iter().map(|e| number(&e["time"])).collect();
    assert!(distance(&events, &[0.01, 0.06]) < 1e-12, "{events:?}");
    // After fifty of them the track is still.
    let cycles: String = (0..50)
        .map(|i| f64::from(i) * 0.08)
        .map(|t| {
            let [a, b] = [t + 0.06, t + 0.08].map(|t| (t * 100.0).round() / 100.0);
            format!("{a},0.3\n{a},-0.9\n{b},-0.9\n{b},0.3\n")
        })
        .collect();
    let record = format!(
        "time[s],acceleration[g]\n0,0.3\n{}",
        cycles.trim_end().trim_end_matches(",0.3").rsplit_once('\n').unwrap().0
    );
    std::fs::write(folder.join("fifty.csv"), record).unwrap();
    let fifty = format!("{TRACK}[base]\nacceleration = \"fifty.csv\"\n");
    std::fs::write(folder.join("fifty.toml"), fifty).unwrap();
    let end =
        json(&format!("system {} simulate --until 5s --format json", folder.join("fifty.toml").display()));
    let due = 49.0 * due + speed * speed / 2.0 * (1.0 / (400.0 * G) + 1.0 / (500.0 * G));
    let found = number(&end["end"]["displacement"][0]);
    assert!((found - due).abs() < 1e-10 && (found - 59.075).abs() < 1e-3, "{found} {due}");
}

/// The way of a part of 1 kg in the last of some periods, by steps: a force and a bound of the friction over time. A step is one of Runge
/// and Kutta, and its passages of 0 are halved.
fn drift_by_steps(force: impl Fn(f64) -> f64, bound: impl Fn(f64) -> f64, period: f64) -> f64 {
    const STEPS: u32 = 4000;
    let (mut x, mut v, mut direction, mut before) = (0.0, 0.0, 0.0, 0.0);
    for turn in 0..40 {
        before = x;
        for step in 0..STEPS {
            let (mut t, end) =
                [step, step + 1].map(|i| period * (f64::from(turn) + f64::from(i) / f64::from(STEPS))).into();
            while t < end {
                if direction == 0.0 {
                    // The rest ends where the force passes the bound.
                    let over = |t: f64| force(t).abs() > bound(t);
                    if !over(end) {
                        break;
                    }
                    let (mut low, mut high) = (t, end);
                    while high - low > 1e-15 * period {
                        let middle = f64::midpoint(low, high);
                        if middle <= low || middle >= high {
                            break;
                        }
                        if over(middle) { high = middle } else { low = middle }
                    }
                    (t, direction) = (high, force(high).signum());
                    continue;
                }
                let rate = |t: f64| force(t) - direction * bound(t);
                // The acceleration is one of time alone: the steps are Simpson's.
                let after = |h: f64| {
                    let [a, b, c] = [t, t + h / 2.0, t + h].map(rate);
                    let gain = h / 6.0 * (a + 4.0 * b + c);
                    (x + h * v + h * h / 6.0 * (a + 2.0 * b), v + gain)
                };
                let (next, speed) = after(end - t);
                if direction * speed > 0.0 {
                    (x, v, t) = (next, speed, end);
                    continue;
                }
                let (mut low, mut high) = (0.0, end - t);
                while high - low > 1e-15 * period {
                    let middle = f64::midpoint(low, high);
                    if direction * after(middle).1 > 0.0 { low = middle } else { high = middle }
                }
                (x, v, t) = (after(high).0, 0.0, t + high);
                direction = if force(t).abs() > bound(t) { force(t).signum() } else { 0.0 };
            }
        }
    }
    x - before
}

/// A part under two harmonics of its load, as in the paper of Maza-Cuello and Maza on such drives.
#[test]
fn a_part_drifts_under_two_harmonics() {
    let file = TRACK.replace("0.5", "0.2").replace("9.80665 N", "9.81 N")
        + "[[forces]]\non = \"part\"\namplitude = \"6 N\"\nfrequency = \"10 Hz\"\n[[forces]]\non = \"part\"\namplitude = \"6 N\"\nfrequency = \
           \"20 Hz\"\nphase = \"90 deg\"\n";
    let folder = folder("two_harmonics", &[("part.toml", &file)]);
    let found = json(&format!("system {} steady --format json", folder.join("part.toml").display()));
    let force = |t: f64| 6.0 * ((TAU * 10.0 * t).sin() + (TAU * 20.0 * t).cos());
    let due = 1000.0 * drift_by_steps(force, |_| 0.2 * 9.81, 0.1);
    let ours = number(&found["drift"][0]);
    assert!((ours - due).abs() < 1e-8, "{ours} {due}");
}

/// A track that swings by 2 mm at 25° and 15 Hz, whose part weighs the more the faster it goes up.
#[test]
fn a_conveyor_that_swings_carries_its_part() {
    let acceleration = 0.002 * (TAU * 15.0_f64).powi(2);
    let (sin, cos) = 25.0_f64.to_radians().sin_cos();
    let file = format!(
        "units = \"N,mm\"\nmasses = {{ part = \"1 kg\" }}\n[[contacts]]\nbetween = [\"ground\", \"part\"]\ncoefficient = 0.4\nnormal_load = {{ \
         constant = \"{G} N\", vertical = {{ amplitude = \"{} m/s^2\", frequency = \"15 Hz\", phase = \"180 deg\" }} }}\n[base]\ndisplacement \
         = {{ amplitude = \"{} mm\", frequency = \"15 Hz\" }}\n",
        acceleration * sin,
        2.0 * cos
    );
    let folder = folder("swings", &[("track.toml", &file)]);
    let found = json(&format!("system {} steady --format json", folder.join("track.toml").display()));
    let wave = |t: f64| acceleration * (TAU * 15.0 * t).sin();
    let due = 15_000.0 * drift_by_steps(|t| cos * wave(t), |t| 0.4 * (G - sin * wave(t)), 1.0 / 15.0);
    let speed = number(&found["mean_velocity"][0]);
    assert!((speed - due).abs() < 1e-7, "{speed} {due}");
    assert!((speed - 64.602).abs() < 1e-3, "{found}");
}

/// A box slides off a bed that brakes: 2 m under the difference of its acceleration and the friction's.
#[test]
fn a_box_passes_the_end_of_its_bed_when_it_is_there_by_hand() {
    let bed = "units = \"N,m\"\nmasses = { box = \"20 kg\" }\n[[contacts]]\nname = \"bed\"\nbetween = [\"ground\", \"box\"]\ncoefficient = \
               0.25\nnormal_load = \"196.133 N\"\n[base]\nacceleration = \"-4 m/s^2\"\n[[levels]]\nname = \"half\"\non = \"box\"\ndisplacement = \
               \"1 m\"\n[[levels]]\nbetween = [\"ground\", \"box\"]\nvelocity = \"1 m/s\"\n";
    let folder = folder("bed", &[("truck.toml", bed)]);
    let machine = format!("system {}", folder.join("truck.toml").display());
    let by = 4.0 - 0.25 * G;
    for (level, due) in [("box = 2 m", (4.0 / by).sqrt()), ("bed.velocity=2m/s", 2.0 / by)] {
        let line = format!("{machine} simulate --format json --until");
        let found = json_of(&line, level);
        let output = "system simulate duration by system::System::first_passage";
        near(output, number(&found["duration"]), due, ByHand, 1e-14);
        let events = found["events"].as_array().unwrap();
        let of = |name: &str| events.iter().find(|event| event["name"] == name).unwrap();
        assert!((number(&of("half")["time"]) / (2.0 / by).sqrt() - 1.0).abs() < 1e-14, "{found}");
        assert_eq!((&of("half")["kind"], &of("half")["element"]), (&"rise".into(), &1.into()));
        assert!((number(&of("levels[2]")["time"]) * by - 1.0).abs() < 1e-14, "{found}");
    }
    for (level, why) in [
        ("box = -2 m", "must be passed within"),
        ("bos = 2 m", "Did you mean box?"),
        ("box = 2 kg", "must be a length"),
        ("box.velocity = 2 m", "must be a velocity"),
    ] {
        let run = stickslip(&format!("{machine} simulate --until")).arg(level).assert().code(2).stdout("");
        let text = said(&run.get_output().stderr);
        assert!(text.contains(why) && text.lines().count() == 1, "{level}: {text}");
    }
}

/// The answer of a line with a last argument that has blanks.
fn json_of(line: &str, last: &str) -> serde_json::Value {
    let run = stickslip(line).arg(last).assert().success();
    serde_json::from_slice(&run.get_output().stdout).unwrap()
}

/// A block on a table that is moved is that on a base with the same motion, whichever quantity gives it.
#[test]
fn a_table_that_is_moved_is_a_base_that_moves() {
    let block = "[[springs]]\nbetween = [\"table\", \"block\"]\nstiffness = \"30 N/m\"\ndamping = 0.4\n[[contacts]]\nname = \"pad\"\nbetween = \
                 [\"table\", \"block\"]\nfriction = \"3 N\"\npeak = 1.1\n";
    let on = |table: &str, rest: &str| {
        format!("units = \"N,m\"\n[masses]\nblock = {{ mass = 2, start = {rest} }}\n{table}{block}")
    };
    let base = on("", "0.03").replace("\"table\"", "\"ground\"");
    // a = −ω² u, and v = ω u a quarter of a period before.
    let wave = |amplitude: f64, phase: f64| {
        format!("{{ amplitude = {amplitude:?}, frequency = 7, phase = {phase:?} }}")
    };
    let (quarter, half) = (TAU / 4.0, TAU / 2.0);
    let of_base = [
        format!("acceleration = {}", wave(0.2 * 49.0, 0.3 + half)),
        format!("velocity = {}", wave(0.2 * 7.0, 0.3 + quarter)),
        format!("displacement = {}", wave(0.2, 0.3)),
    ];
    let of_table = [
        format!("displacement = {}", wave(0.2, 0.3)),
        format!("velocity = {}", wave(0.2 * 7.0, 0.3 + quarter)),
        format!("acceleration = {}", wave(0.2 * 49.0, 0.3 + half)),
    ];
    let folder = folder("table", &[]);
    let file = folder.join("machine.toml");
    let simulated = |text: &str, question: &str| {
        std::fs::write(&file, text).unwrap();
        json(&format!("system {} {question} --format json", file.display()))
    };
    let until = "simulate --until 9s";
    let due = simulated(&format!("{base}[base]\n{}\n", of_base[0]), until);
    let count = due["events"].as_array().unwrap().len();
    assert!(count > 15, "{due}");
    for motion in &of_base[1..] {
        let found = simulated(&format!("{base}[base]\n{motion}\n"), until);
        assert!(
            distance(&numbers(&found["end"]["displacement"]), &numbers(&due["end"]["displacement"])) < 1e-12
        );
    }
    let x = 0.2 * 0.3_f64.sin();
    for (i, motion) in of_table.iter().enumerate() {
        // The block begins where it does over the base, and as fast.
        let v = 0.2 * 7.0 * 0.3_f64.cos();
        let begin = if i == 0 { x } else { 0.0 };
        let text = on(
            &format!("table = {{ moves = {{ {motion} }} }}\n"),
            &format!("{:?}, velocity = {v:?}", begin + 0.03),
        );
        let found = simulated(&text, until);
        let end = numbers(&found["end"]["displacement"]);
        let apart = [end[0] - end[1]];
        assert!(distance(&apart, &numbers(&due["end"]["displacement"])) < 1e-11, "{motion}: {found}");
        assert_eq!(found["events"].as_array().unwrap().len(), count, "{motion}");
        // What moves the table is in the balance of energy.
        let works: f64 = found["elements"].as_array().unwrap().iter().map(|e| number(&e["work"])).sum();
        let left = number(&found["load_work"])
            - number(&found["damper_work"])
            - works
            - number(&found["stored_energy"]);
        assert!(left.abs() < 1e-10 * number(&found["load_work"]), "{motion}: {left}");
        if i < 2 {
            let steady = simulated(&text, "steady");
            let still = simulated(&format!("{base}[base]\n{}\n", of_base[0]), "steady");
            assert_eq!(steady["kind"], "periodic");
            let work = |found: &serde_json::Value| number(&found["elements"][0]["work"]);
            assert!((work(&steady) / work(&still) - 1.0).abs() < 1e-10, "{motion}");
        }
    }
    // The contact of a surface with the same motion, without springs to it.
    let friction = |table: &str, rest: &str| {
        on(table, rest).replace(
            "between = [\"table\", \"block\"]\nstiffness",
            "between = [\"ground\", \"block\"]\nstiffness",
        )
    };
    let beside =
        simulated(&friction(&format!("table = {{ moves = {{ {} }} }}\n", of_table[0]), "0.03"), until);
    for motion in &of_table {
        let text =
            friction("", "0.03").replace("\"table\"", "\"ground\"") + &format!("moves = {{ {motion} }}\n");
        let found = simulated(&text, until);
        let (found, due) = (numbers(&found["end"]["displacement"]), numbers(&beside["end"]["displacement"]));
        assert!(distance(&found, &due[..1]) < 1e-11, "{motion}: {found:?} {due:?}");
    }
}

/// A block on the ground at the pulled end of a spring sticks and slips as on a belt in the frame of that end, and goes along with it.
#[test]
fn a_block_at_the_pulled_end_of_a_spring_is_one_on_a_belt() {
    let block = |ends: &str, rest: &str| {
        format!(
            "units = \"N,m\"\n[masses]\nblock = 1\n{rest}[[springs]]\nbetween = [\"{ends}\", \"block\"]\nstiffness = 100\ndamping = \
             0.2\n[[contacts]]\nbetween = [\"ground\", \"block\"]\nlaw = [[0, 10], [0.5, 7], [2, 6]]\npeak = 1.2\n"
        )
    };
    let pulled = block("hand", "hand = { moves = \"0.2 m/s\" }\n");
    let belt = block("ground", "") + "moves = \"-0.2 m/s\"\n";
    let held = pulled.clone() + "[[springs]]\nbetween = [\"ground\", \"block\"]\nstiffness = 1\n";
    let files = [("pulled.toml", &*pulled), ("belt.toml", &*belt), ("held.toml", &*held)];
    let folder = folder("pulled", &files);
    let name = |name: &str| folder.join(name).display().to_string();
    let [found, due] =
        ["pulled.toml", "belt.toml"].map(|file| json(&format!("system {} steady --format json", name(file))));
    let same = |of: fn(&serde_json::Value) -> f64| (of(&found) / of(&due) - 1.0).abs();
    assert_eq!((&found["kind"], found["events"].as_array().unwrap().len()), (&due["kind"], 2));
    assert!(same(|found| number(&found["period"])) < 1e-10, "{found} {due}");
    assert!(same(|found| number(&found["elements"][0]["time_at_rest"])) < 1e-10, "{found} {due}");
    assert!(same(|found| number(&found["damper_work"])) < 1e-9, "{found} {due}");
    let drift = 0.2 * number(&found["period"]);
    assert!(distance(&numbers(&found["drift"]), &[drift, drift]) < 1e-12, "{found}");
    refused(&format!("system {} steady", name("held.toml")), &["must come back"]);
}

/// The loop of a bearing: a plate that is moved against the ground has the friction of its direction, and 4 r X of work in a period.
#[test]
fn a_bearing_at_an_imposed_displacement_has_its_loop() {
    let rig = "units = \"kN,mm\"\n[masses]\nplate = { moves = { displacement = { amplitude = \"50 mm\", frequency = \"0.2 Hz\" } } }\n\
               [[springs]]\nbetween = [\"ground\", \"plate\"]\nstiffness = 2\n[[contacts]]\nname = \"bearing\"\nbetween = [\"ground\", \
               \"plate\"]\nfriction = \"30 kN\"\n";
    let folder = folder("rig", &[("rig.toml", rig)]);
    let machine = format!("system {}", folder.join("rig.toml").display());
    for question in ["steady", "simulate --until 5s"] {
        let found = json(&format!("{machine} {question} --format json"));
        assert!((number(&found["elements"][0]["work"]) - 6000.0).abs() < 1e-9, "{found}");
        assert!((number(&found["load_work"]) - 6000.0).abs() < 1e-9, "{found}");
    }
    let rows = stdout(&format!("{machine} simulate --until 5s --samples 8"));
    for row in rows.lines().skip(1) {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let is_due = cells[3].abs() == 30.0 && (cells[2].abs() < 1e-9 || cells[2] * cells[3] > 0.0);
        assert!(is_due, "{row}");
    }
}

/// A weight under an acceleration upwards is a normal load by a wave; a record of it presses as the same load in newtons.
#[test]
fn a_weight_that_is_shaken_upwards_presses_as_its_force() {
    let pendulum = |load: &str| {
        format!(
            "units = \"kN,mm\"\nmasses = {{ slab = \"100 t\" }}\n[[springs]]\nbetween = [\"ground\", \"slab\"]\nstiffness = \"0.65 \
             kN/mm\"\n[[contacts]]\nbetween = [\"ground\", \"slab\"]\ncoefficient = 0.06\nnormal_load = {load}\n[base]\nacceleration = {{ \
             amplitude = \"0.2 g\", frequency = \"0.5 Hz\" }}\n"
        )
    };
    let up = "time[s],up[g],other\n0,0,0\n0.5,0.6,0\n1.5,-1.2,0\n3,0.2,0\n3.5,0,0\n";
    let pressed = "time[s],force[kN]\n0,0\n0.5,294.1995\n1.5,-588.399\n3,98.0665\n3.5,0\n";
    let folder = folder("pendulum", &[("up.csv", up), ("pressed.csv", pressed)]);
    let file = folder.join("pendulum.toml");
    let ends = [
        "{ constant = \"980.665 kN\", vertical = { file = \"up.csv\", column = \"up\", scale = 0.5 } }",
        "{ constant = \"980.665 kN\", file = \"pressed.csv\" }",
        "[\"980.665 kN\", { record = { file = \"pressed.csv\", column = 2 } }]",
    ]
    .map(|load| {
        std::fs::write(&file, pendulum(load)).unwrap();
        let found = json(&format!("system {} simulate --until 6s --format json", file.display()));
        (numbers(&found["end"]["displacement"]), found["events"].as_array().unwrap().len())
    });
    assert!(ends[0].1 > 3, "{ends:?}");
    for end in &ends[1..] {
        assert!(distance(&end.0, &ends[0].0) < 1e-12 && end.1 == ends[0].1, "{ends:?}");
    }
}

/// A record in a file of a system is read, scaled and cut as by `record`; two of them add up.
#[test]
fn records_in_a_file_are_those_of_the_command_for_one_body() {
    let rows: String = (0..200)
        .map(|i| f64::from(i) * 0.02)
        .map(|t| format!("{t:.2},{:.6},{:.6}\n", (5.0 * t).sin(), (9.0 * t).cos()))
        .collect();
    let folder = folder("options", &[("two.csv", &format!("t[s],east[g],north[g]\n{rows}"))]);
    let file = folder.join("two.toml");
    let record = folder.join("two.csv").display().to_string();
    let options = "--column north --scale 0.4 --from 0.5s --to 2.5s";
    let one = json(&format!(
        "record {record} {options} --units N,mm --mass 1kg --no-spring --friction 1N --format json"
    ));
    let system = |acceleration: &str| {
        let text = TRACK.replace("coefficient = 0.5\nnormal_load = \"9.80665 N\"", "friction = \"1 N\"");
        std::fs::write(&file, format!("{text}[base]\nacceleration = {acceleration}\n")).unwrap();
        json(&format!("system {} simulate --until 9s --format json", file.display()))
    };
    let table = |scale: f64| {
        format!(
            "{{ file = \"two.csv\", column = \"north\", scale = {scale}, from = \"0.5 s\", to = \"2.5 s\" }}"
        )
    };
    let whole = system(&table(0.4));
    let due = number(&one["residual_displacement"]);
    assert!((number(&whole["end"]["displacement"][0]) / due - 1.0).abs() < 1e-12, "{whole} {one}");
    let parts = system(&format!("[{}, {}]", table(0.1), table(0.3)));
    assert!((number(&parts["end"]["displacement"][0]) / due - 1.0).abs() < 1e-11, "{parts}");
}

/// The steady motion under each shape is what the start leads to, and a curve changes the frequency of shapes.
#[test]
fn the_steady_motion_under_each_shape_is_the_limit_of_the_start() {
    let folder = folder("shapes", &[]);
    let file = folder.join("machine.toml");
    for (shape, frequency) in [("square", 3.0), ("triangle", 5.0), ("sawtooth", 4.0), ("pulse", 6.0)] {
        let machine = |frequency: f64| {
            format!(
                "units = \"N,m\"\nmasses = {{ a = 1.5, b = 1 }}\n[[springs]]\nbetween = [\"ground\", \"a\"]\nstiffness = 60\ndamping = \
                 0.6\n[[springs]]\nbetween = [\"a\", \"b\"]\nstiffness = 40\ndamping = 0.5\n[[contacts]]\nbetween = [\"ground\", \
                 \"a\"]\nfriction = 3\npeak = 1.2\n[[forces]]\non = \"b\"\namplitude = 14\nfrequency = {frequency:?}\nphase = 0.7\nshape = \
                 \"{shape}\"\n"
            )
        };
        std::fs::write(&file, machine(frequency)).unwrap();
        let name = file.display().to_string();
        let steady = json(&format!("system {name} steady --format json"));
        let period = TAU / frequency;
        assert!((number(&steady["period"]) / period - 1.0).abs() < 1e-15);
        let long = json(&format!("system {name} simulate --until {}s --format json", 400.0 * period));
        for part in ["displacement", "velocity"] {
            let (found, due) = (numbers(&steady["start"][part]), numbers(&long["end"][part]));
            assert!(distance(&found, &due) < 1e-9, "{shape}: {found:?} {due:?}");
        }
        let row = stdout(&format!("system {name} curve --frequency 2.5rad/s,4.5rad/s --format json"));
        let rows: serde_json::Value = serde_json::from_str(&row).unwrap();
        std::fs::write(&file, machine(4.5)).unwrap();
        let due = json(&format!("system {name} steady --format json"));
        let found = number(&rows[1]["b.max_displacement[m]"]);
        assert!((found / number(&due["max_displacement"][1]) - 1.0).abs() < 1e-9, "{shape}: {rows}");
    }
}

/// What is no drive says what to write instead.
#[test]
fn a_drive_that_cannot_be_is_refused_on_one_line() {
    let velocity = "t[s],v[m/s]\n0,0\n1,1\n2,0\n";
    let step = "t[s],f[N]\n0,5\n1,5\n1,9\n2,9\n";
    let files = [("v.csv", velocity), ("step.csv", step), ("x.csv", "t[s],x[mm]\n0,0\n1,2\n1,1\n2,0\n")];
    let folder = folder("refused", &files);
    let file = folder.join("machine.toml");
    let line = format!("system {} simulate --until 1s", file.display());
    let start = "units = \"N,m\"\nmasses = { a = 1, b = 1 }\n";
    let contact = "[[contacts]]\nname = \"pad\"\nbetween = [\"ground\", \"a\"]\n";
    for (text, why) in [
        (format!("{contact}coefficient = 0.3\nnormal_load = {{ constant = 9, amplitude = 3, frequency = 2, shape = \"square\" }}"), "must not change at once"),
        (format!("{contact}coefficient = 0.3\nnormal_load = {{ file = \"step.csv\" }}"), "must not change at once"),
        (format!("{contact}law = [[0, 3], [1, 2]]\nnormal_load = {{ constant = 9 }}"), "without a coefficient"),
        ("[[stops]]\nbetween = [\"ground\", \"a\"]\ngap = 0.1\nstiffness = 9\ndamping = 1\ncoefficient = 0.2\nalong = [\"ground\", \"b\"]".to_owned(), "must be left out of a stop with damping"),
        ("[base]\ndisplacement = \"x.csv\"".to_owned(), "must not change at once: that takes an infinite acceleration"),
        ("[[forces]]\non = \"a\"\namplitude = 1\nfrequency = 2\nshape = \"trangle\"".to_owned(), "Did you mean triangle?"),
        ("[[forces]]\non = \"a\"\namplitude = 1\nsweep = { from = 1, to = 1e9, duration = 100 }".to_owned(), "give a larger tolerance"),
        ("[[forces]]\non = \"a\"\nfrequency = 2".to_owned(), "needs an amplitude"),
        ("[[forces]]\non = \"a\"\nconstant = 2\nrepeats = true".to_owned(), "needs the name of its file"),
        ("[[levels]]\non = \"c\"\ndisplacement = 1".to_owned(), "is neither a body nor a contact or stop"),
    ] {
        std::fs::write(&file, format!("{start}{text}\n")).unwrap();
        refused(&line, &[why]);
    }
    let text = "units = \"N,m\"\n[masses]\na = { moves = { velocity = \"v.csv\" } }\nb = 1\n[[springs]]\nbetween = [\"a\", \"b\"]\nstiffness = 9\n";
    std::fs::write(&file, text).unwrap();
    stdout(&line);
    refused(&format!("system {} steady", file.display()), &["must repeat themselves"]);
}

/// A record of another quantity is met by what its header needs, and the name of a file in place of a quantity by the table of a record.
#[test]
fn what_is_written_in_place_of_a_wrong_record() {
    let rest = "\n[[contacts]]\nbetween = [\"ground\", \"box\"]\nfriction = \"2 N\"\n";
    let files = [
        ("base.toml", format!("masses = {{ box = \"1 kg\" }}{rest}[base]\nvelocity = \"force.csv\"\n")),
        (
            "moved.toml",
            format!("[masses]\nbox = \"1 kg\"\npad = {{ moves = {{ displacement = \"force.csv\" }} }}{rest}"),
        ),
        ("side.toml", format!("masses = {{ box = \"1 kg\" }}{rest}moves = \"force.csv\"\n")),
        (
            "normal.toml",
            format!("masses = {{ box = \"1 kg\" }}{rest}normal_load = \"force.csv\"\n")
                .replace("friction = \"2 N\"", "coefficient = 0.2"),
        ),
    ];
    let folder = folder("wrong_record", &[("force.csv", "time[s],force[N]\n0,0\n1,5\n2,1\n")]);
    for (name, text) in &files {
        let text = format!("units = \"N,mm\"\n{text}");
        std::fs::write(folder.join(name), text).unwrap();
        let line = format!("system {} simulate --until 1s", folder.join(name).display());
        let why = match *name {
            "base.toml" => {
                "has no column of a velocity (m/s, mm/s, in/s): time, force. Write its unit after its name"
            }
            "moved.toml" => {
                "has no column of a length (m, mm, in): time, force. Write its unit after its name"
            }
            _ => "must be a number. A record is a table, { file = \"force.csv\" }",
        };
        refused(&line, &[why]);
        let said = said(&stickslip(&line).assert().code(2).get_output().stderr);
        assert!(!said.contains("is read with"), "{said}");
    }
}
