//! Exercises of textbooks with the answers printed there: docs/exercises.md shows them as recipes.
//!
//! The tolerance is half a unit of the last digit printed, unless the textbook approximates: then the difference is
//! stated, and a solution by small steps of time decides.

use crate::command_line::{json, stdout};
use crate::place::place;
use serde_json::Value;
use std::f64::consts::PI;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

#[track_caller]
fn near(found: f64, printed: f64, room: f64) {
    assert!((found - printed).abs() <= room, "{found} beside {printed}");
}

/// The amplitude under a force by small steps of time, in which friction takes as much of the momentum as it can: right to
/// a step in a quarter of a cycle, 1 in 5,000.
fn amplitude([mass, stiffness, friction, force, frequency]: [f64; 5]) -> f64 {
    let (steps, cycles) = (20_000, 400);
    let dt = 2.0 * PI / frequency / f64::from(steps);
    let (mut x, mut v, mut most) = (0.0, 0.0, 0.0f64);
    for step in 0..steps * cycles {
        let t = dt * (f64::from(step) + 0.5);
        let free = v + dt * (force * (frequency * t).sin() - stiffness * (x + v * dt / 2.0)) / mass;
        let hold = friction * dt / mass;
        let after = free - free.clamp(-hold, hold);
        (x, v) = (x + dt * (v + after) / 2.0, after);
        if step >= steps * (cycles - 2) {
            most = most.max(x.abs());
        }
    }
    most
}

/// Rao, section 2.9: a block displaced by 10 cm is 1 cm from its equilibrium after five cycles in 2 s: µ = 0.1132.
#[test]
fn the_coefficient_of_friction_of_a_decay() {
    let decay =
        "--mass 1kg --period 400ms --friction-coefficient 0.1132 --gravity 9.81m/s^2 --x0 100mm --units N,mm";
    let folder = place("exercise-decay");
    std::fs::create_dir(&folder).unwrap();
    let file = folder.join("turns.csv");
    let answer = json(&format!("decay {decay} --out {} --format json", file.display()));
    let text = std::fs::read_to_string(&file).unwrap();
    let tenth: Vec<f64> =
        text.lines().nth(11).unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(tenth[0], 10.0);
    near(tenth[1], 2.0, 1e-9);
    // Half a unit of the last digit of µ is 0.05 % of 90 mm.
    near(tenth[2], 10.0, 0.05);
    // It is no place of rest: the spring's force there exceeds friction, and the block turns once more.
    assert_eq!(answer["half_cycles"], 11);
    let unit = 0.1132 * 9.81 / (5.0 * PI).powi(2) * 1e3;
    near(number(&answer["physical"]["rest_position"]), 2.0 * unit - tenth[2], 1e-9);
}

/// Rao, section 2.9: a pulley on a shaft, braked by 400 N·m and displaced by 6°: rest after six half cycles, at 0.39734°.
#[test]
fn a_pulley_with_a_brake() {
    let stiffness = 8e10 * PI / 32.0 * 0.05f64.powi(4);
    let answer = json(&format!(
        "decay --mass 25 --stiffness {stiffness} --friction 400 --x0 {} --format json",
        6.0 * PI / 180.0
    ));
    assert_eq!(answer["half_cycles"], 6);
    near(number(&answer["physical"]["rest_position"]) * 180.0 / PI, 0.39734, 1e-4);
}

/// Rao, section 3.8: 10 kg on 4 kN/m with µ = 0.12 vibrates by 40 mm at 2 Hz. By the equivalent damper the force is
/// 97.9874 N, 0.8 % more than it is.
#[test]
fn the_force_for_an_amplitude() {
    let machine =
        "--mass 10kg --stiffness 4000N/m --friction-coefficient 0.12 --gravity 9.81m/s^2 --frequency 2Hz";
    let found = json(&format!("design displacement {machine} --target 40mm --format json"));
    let force = number(&found["force"]);
    let friction: f64 = 0.12 * 10.0 * 9.81;
    let omega = 4.0 * PI / 20.0;
    let printed = (4000.0 * 0.04 * (1.0 - omega * omega)).hypot(4.0 * friction / PI);
    near(printed, 97.9874, 5e-4);
    near(force, 97.204, 5e-4);
    near(printed / force - 1.0, 0.008, 5e-4);
    near(amplitude([10.0, 4000.0, friction, force, 4.0 * PI]), 0.04, 1e-4 * 0.04);
}

/// Inman, section 2.7: 10 kg on 15 kN/m with µ = 0.3 under 90 N at 25 Hz: 3.53e-4 m by the equivalent damper, 5.5 % more
/// than it is.
#[test]
fn the_amplitude_above_resonance() {
    let machine = "--mass 10kg --stiffness 15kN/m --friction-coefficient 0.3 --gravity 9.81m/s^2 --frequency 25Hz --force 90N";
    let found = json(&format!("response {machine} --format json"));
    let exact = number(&found["physical"]["max_displacement"]);
    let (friction, omega) = (0.3 * 10.0 * 9.81, 50.0 * PI / 1500f64.sqrt());
    let printed = 90.0 / 15e3 * (1.0 - (4.0 * friction / (PI * 90.0)).powi(2)).sqrt() / (omega * omega - 1.0);
    near(printed, 3.53e-4, 5e-7);
    near(printed / exact - 1.0, 0.055, 2e-3);
    near(amplitude([10.0, 15e3, friction, 90.0, 50.0 * PI]), exact, 1e-4 * exact);
}

/// Halliday and Resnick, chapter 8: 2 kg at 4 m/s run into a spring of 10 kN/m against 15 N: 5.5 cm.
#[test]
fn a_package_against_a_spring() {
    let answer = json("decay --mass 2kg --stiffness 10kN/m --friction 15N --v0 4m/s --format json");
    near(number(&answer["physical"]["first_turn"]), 0.055, 5e-4);
}

/// Halliday and Resnick, chapter 6: skid marks of 290 m with µ = 0.60 begin at 58 m/s.
#[test]
fn skid_marks() {
    let folder = place("exercise-skid");
    std::fs::create_dir(&folder).unwrap();
    let file = folder.join("none.csv");
    std::fs::write(&file, "force[N]\n0\n0\n").unwrap();
    let path = |speed: f64| {
        let body = format!(
            "--time-step 1s --mass 1kg --no-spring --friction-coefficient 0.6 --gravity 9.8m/s^2 --v0 {speed}m/s"
        );
        number(&json(&format!("record {} {body} --format json", file.display()))["path"])
    };
    assert!(path(57.5) < 290.0 && path(58.5) > 290.0, "{} {}", path(57.5), path(58.5));
    near(path(58.0), 58f64.powi(2) / (2.0 * 0.6 * 9.8), 1e-9);
}

/// Young and Freedman, chapter 7: an elevator of 2000 kg at 4 m/s, a clamp of 17 kN and a spring of 10.6 kN/m stop it in
/// 2.00 m.
#[test]
fn an_elevator_on_a_spring() {
    // Displacements are from the place where the spring carries the weight.
    let answer = json(
        "decay --mass 2000kg --stiffness 10.6kN/m --friction 17kN --mean-force 19.6kN --x0=-1.849056604m --v0 4m/s --format json",
    );
    near(number(&answer["physical"]["path"]), 2.0, 5e-3);
    // The spring's 21.2 kN less the weight is below the clamp's 17 kN: there it stays.
    assert_eq!(answer["half_cycles"], 1);
}

/// Den Hartog 1931: friction below π/4 of the force does not bound the resonance.
#[test]
fn friction_at_resonance() {
    let regime = |ratio: f64| {
        json(&format!("response --omega 1 --alpha {} --format json", 1.0 / ratio))["regime"].clone()
    };
    assert_eq!(regime(PI / 4.0 - 1e-6), "unbounded");
    assert_eq!(regime(PI / 4.0 + 1e-6), "sticking");
}

/// Coulomb's decay (Thomson, section 2.9; Rao, section 2.9): 2F/k less in each half cycle, in the time of the undamped
/// vibration, until F/k holds the body.
#[test]
fn a_decay_is_linear() {
    let folder = place("exercise-linear");
    std::fs::create_dir(&folder).unwrap();
    let file = folder.join("turns.csv");
    let answer = json(&format!(
        "decay --mass 4 --stiffness 900 --friction 9 --x0 0.155 --out {} --format json",
        file.display()
    ));
    let text = std::fs::read_to_string(&file).unwrap();
    for (n, line) in text.lines().skip(1).enumerate() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        near(cells[1], n as f64 * PI / 15.0, 1e-12);
        near(cells[2].abs(), (0.155 - 0.02 * n as f64).abs(), 1e-12);
    }
    // (0.155 − 0.01)/0.02 = 7.25
    assert_eq!(answer["half_cycles"], 8);
}

/// Jacobsen 1930 (Thomson, section 3.9): c_eq = 4F/(πωX), and with a damper c more.
#[test]
fn the_equivalent_viscous_damper() {
    let machine = "--mass 50t --stiffness 1000kN/m --friction 5kN --frequency 6rad/s --force 12kN";
    for command in ["response", "steady"] {
        let found = json(&format!("{command} {machine} --format json"));
        let [c, x] = ["equivalent_damping", "max_displacement"].map(|name| number(&found["physical"][name]));
        near(c * PI * 6.0 * x / (4.0 * 5e3), 1.0, 1e-12);
        near(number(&found["equivalent_damping_ratio"]) * 2.0 * (1e6f64 * 50e3).sqrt() / c, 1.0, 1e-12);
    }
    // In a motion that is nearly harmonic a damper adds its own constant.
    let found = json(
        "response --mass 1 --stiffness 1 --friction 1e-3 --damping 0.1 --frequency 1 --force 1 --format json",
    );
    let [c, x] = ["equivalent_damping", "max_displacement"].map(|name| number(&found["physical"][name]));
    near(c, 0.1 + 4e-3 / (PI * x), 1e-6);
}

/// AASHTO's guide for isolation and ASCE 7: a pendulum of radius R at the displacement D has the stiffness W/R + µW/D and
/// the damping (2/π) µ/(µ + D/R).
#[test]
fn a_friction_pendulum_as_codes_have_it() {
    let found = json(
        "steady --mass 1000kg --pendulum-radius 2m --friction-coefficient 0.06 --frequency 0.5Hz --base-displacement 150mm --format json",
    );
    let [stiffness, d] =
        ["equivalent_stiffness", "max_displacement"].map(|name| number(&found["physical"][name]));
    let weight = 9806.65;
    near(stiffness / (weight / 2.0 + 0.06 * weight / d), 1.0, 1e-12);
    near(number(&found["effective_damping_ratio"]) / (2.0 / PI * 0.06 / (0.06 + d / 2.0)), 1.0, 1e-12);
}

/// Newmark 1965: a block that yields at N g slips by V²/(2gN)(1 − N/A) under a pulse of A g and the velocity V.
#[test]
fn newmarks_block() {
    let folder = place("exercise-newmark");
    std::fs::create_dir(&folder).unwrap();
    let file = folder.join("pulse.csv");
    std::fs::write(&file, "base-acceleration[g]\n-0.3\n-0.3\n").unwrap();
    let body = "--time-step 1s --mass 1kg --no-spring --friction-coefficient 0.1";
    let found = json(&format!("record {} {body} --format json", file.display()));
    let (g, v) = (9.80665, 0.3 * 9.80665);
    near(number(&found["residual_displacement"]), v * v / (2.0 * g * 0.1) * (1.0 - 0.1 / 0.3), 1e-9);
}

/// Harris and Crede: a rigidly connected isolator with dry friction breaks loose at √(4η/π), η = F/(k u₀), by the
/// equivalent damper, 12.8 % above √η, where the inertia of the body exceeds friction.
#[test]
fn an_isolator_breaks_loose() {
    let (friction, foot) = (80.0, 0.01);
    let loose = (friction / (2e4f64 * foot)).sqrt();
    let machine =
        format!("--mass 20kg --stiffness 20kN/m --friction {friction}N --base-displacement {foot}m");
    let natural = (2e4f64 / 20.0).sqrt();
    let regime = |share: f64| {
        let frequency = share * loose * natural;
        json(&format!("steady {machine} --frequency {frequency}rad/s --format json"))["regime"].clone()
    };
    assert_eq!(regime(1.0 - 1e-6), "stuck");
    assert_ne!(regime(1.0 + 1e-6), "stuck");
    near((4.0 / PI).sqrt() - 1.0, 0.128, 5e-4);
    let text = stdout(&format!("steady {machine} --frequency {}rad/s", 0.9 * loose * natural));
    assert!(text.starts_with("The base carries the surface") && text.contains("Stuck"), "{text}");
}
