//! The two kinds of base motion and an isolator, compared with small time steps in the fixed frame, which use
//! neither p₀ nor Ω nor α.

use super::{close, number};
use crate::command_line::{json, refused, stdout};
use std::f64::consts::TAU;

const ISOLATOR: &str = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 2Hz";
/// A body on a spring and on a surface, both of which may move.
pub(crate) struct Room {
    pub(crate) mass: f64,
    pub(crate) stiffness: f64,
    pub(crate) friction: f64,
    pub(crate) frequency: f64,
    /// Constant of a damper between the body and its support.
    pub(crate) damping: f64,
}
/// Results of small time steps over the last cycle: greatest displacement relative to the surface, absolute
/// displacement and acceleration.
pub(crate) struct Stepped {
    pub(crate) stroke: f64,
    absolute: f64,
    acceleration: f64,
    /// Energy dissipated by the damper.
    damper: f64,
    /// Energy dissipated by friction.
    pub(crate) friction: f64,
    /// The number of steps in which friction held the body.
    pub(crate) held: u32,
}
impl Room {
    /// Explicit time steps. `foot` and `surface` are the displacement amplitudes of the spring's support and of
    /// the surface, and `force` is the amplitude of a force on the body. In each step, friction removes as
    /// much of the relative momentum as it can.
    pub(crate) fn stepped(&self, force: f64, foot: f64, surface: f64, cycles: u32, steps: u32) -> Stepped {
        let Self { mass, stiffness, friction, frequency, damping } = *self;
        let dt = TAU / frequency / f64::from(steps);
        let (mut y, mut v) = (0.0, surface * frequency);
        let mut found =
            Stepped { stroke: 0.0, absolute: 0.0, acceleration: 0.0, damper: 0.0, friction: 0.0, held: 0 };
        for step in 0..cycles * steps {
            let theta = frequency * dt * f64::from(step);
            let (sine, next) = (theta.sin(), (theta + frequency * dt).cos());
            let slip = v - surface * frequency * theta.cos();
            let free = v + dt * (force * sine - stiffness * (y - foot * sine) - damping * slip) / mass;
            let (carrier, most) = (surface * frequency * next, friction * dt / mass);
            let after = free - (free - carrier).clamp(-most, most);
            let acceleration = (after - v) / dt;
            v = after;
            y += dt * v;
            if step >= (cycles - 1) * steps {
                let over = y - surface * (theta + frequency * dt).sin();
                found.stroke = found.stroke.max(over.abs());
                found.friction += friction.min((free - carrier).abs() * mass / dt) * slip.abs() * dt;
                found.held += u32::from((free - carrier).abs() < most);
                found.damper += damping * slip * slip * dt;
                found.absolute = found.absolute.max(y.abs());
                found.acceleration = found.acceleration.max(acceleration.abs());
            }
        }
        found
    }
}
/// The isolator for a coefficient of friction and a frequency in hertz.
pub(crate) fn isolator(coefficient: f64, hertz: f64) -> Room {
    let mass = 800.0;
    Room {
        mass,
        stiffness: mass * (TAU / 2.2).powi(2),
        friction: coefficient * mass * 9.80665,
        frequency: TAU * hertz,
        damping: 0.0,
    }
}
#[test]
fn an_isolator_moves_as_small_steps_of_time_say() {
    let answer = json(&format!("response {ISOLATOR} --base-acceleration 0.15g --units N,mm --format json"));
    let physical = &answer["physical"];
    // 8.3974 mm with the standard gravity of 9.80665 m/s², 8.4002 mm with 9.81 m/s².
    assert!((number(&physical["max_displacement"]) - 8.3974).abs() < 5e-5, "{physical}");
    assert_eq!(
        (&physical["units"]["max_displacement"], &physical["units"]["max_acceleration"]),
        (&"mm".into(), &"mm/s²".into())
    );
    // The base moves by a₀/ω², and carries both the surface and the support.
    let base = 0.15 * 9.80665 / (2.0 * TAU).powi(2);
    let room = isolator(0.05, 2.0);
    let stepped = room.stepped(0.0, base, base, 40, 40_000);
    close(number(&physical["max_displacement"]), 1e3 * stepped.stroke, 1e-3);
    close(number(&physical["max_absolute_displacement"]), 1e3 * stepped.absolute, 1e-3);
    close(number(&physical["transmitted_force"]) / 800.0, stepped.acceleration, 1e-3);
    close(number(&answer["transmissibility"]), stepped.acceleration / (0.15 * 9.80665), 1e-3);
    close(number(&physical["base_displacement"]), 1e3 * base, 1e-12);
    // The same base given by its displacement and by its velocity.
    for (option, amplitude) in [("displacement", base), ("velocity", base * 2.0 * TAU)] {
        let unit = if option == "velocity" { "m/s" } else { "m" };
        let same = json(&format!("response {ISOLATOR} --base-{option} {amplitude}{unit} --format json"));
        close(number(&same["max_displacement"]), number(&answer["max_displacement"]), 1e-12);
    }
}
/// From 0.3 to 5 Hz, also with more friction, where the body sticks.
#[test]
fn an_isolator_over_its_frequencies() {
    let mut sticking = 0;
    for coefficient in [0.05, 0.08, 0.12] {
        for hertz in [0.3, 0.45, 0.8, 1.5, 5.0] {
            let base = 0.15 * 9.80665 / (TAU * hertz).powi(2);
            // Close to resonance the motion takes a thousand cycles to settle.
            let (cycles, steps) = if hertz == 0.45 { (2000, 4000) } else { (200, 8000) };
            let stepped = isolator(coefficient, hertz).stepped(0.0, base, base, cycles, steps);
            let machine = format!(
                "--mass 800kg --period 2.2s --friction-coefficient {coefficient} --frequency {hertz}Hz"
            );
            let answer = json(&format!("steady {machine} --base-acceleration 0.15g --format json"));
            sticking += u32::from(answer["regime"] == "sticking");
            let physical = &answer["physical"];
            close(number(&physical["max_displacement"]), stepped.stroke, 3e-3);
            close(number(&physical["max_absolute_displacement"]), stepped.absolute, 3e-3);
            close(number(&physical["transmitted_force"]) / 800.0, stepped.acceleration, 6e-3);
        }
    }
    assert!(sticking > 0);
}
/// The motion of the spring's support alone, over a fixed surface, is a different motion with its own name.
#[test]
fn the_two_base_motions_differ_and_say_which_they_are() {
    let foot = json(&format!("steady {ISOLATOR} --foot-displacement 70mm --format json"));
    let stepped = isolator(0.05, 2.0).stepped(0.0, 0.07, 0.0, 400, 10_000);
    close(number(&foot["physical"]["max_displacement"]), stepped.stroke, 2e-3);
    let carried = json(&format!("steady {ISOLATOR} --base-displacement 70mm --format json"));
    let stepped = isolator(0.05, 2.0).stepped(0.0, 0.07, 0.07, 400, 10_000);
    close(number(&carried["physical"]["max_displacement"]), stepped.stroke, 2e-3);
    assert!(number(&carried["max_displacement"]) > 10.0 * number(&foot["max_displacement"]));
    assert_eq!(foot["physical"]["drive"], "motion of the spring's support over a fixed surface");
    // The old option names state their meaning in every form of answer.
    for (command, option, words) in [
        ("response", "--base-motion 70mm", "the spring's support moves over a fixed surface"),
        ("response", "--base-acceleration 0.15g", "the base carries the surface"),
        ("steady", "--foot-displacement 70mm", "the spring's support moves over a fixed surface"),
        ("steady", "--base-velocity 0.1m/s", "the base carries the surface"),
        ("design friction", "--base-acceleration 0.15g", "the base carries the surface"),
        ("design dissipation", "--base-motion 70mm", "the spring's support moves over a fixed surface"),
    ] {
        let machine = if command.starts_with("design") {
            "--mass 800kg --period 2.2s --frequency 2Hz"
        } else {
            ISOLATOR
        };
        let text = stdout(&format!("{command} {machine} {option}"));
        assert!(text.to_lowercase().contains(words), "{command} {option}: {text}");
    }
    let design = json(
        "design friction --mass 800kg --period 2.2s --frequency 2Hz --base-acceleration 0.15g --format json",
    );
    assert!(design["base_motion"].as_str().unwrap().contains("carries the surface"));
    assert_eq!(design["units"]["friction"], "N");
    close(number(&design["friction_coefficient"]) * 800.0 * 9.80665, number(&design["friction"]), 1e-14);
}
/// If only support and surface act on the body, they together carry the inertia m x″, where x is the absolute
/// motion.
#[test]
fn a_moving_foot_and_the_surface_feel_the_inertia() {
    for (frequency, foot, damper) in [(150.0, 0.04, ""), (6.6, 0.03, ""), (6.6, 0.03, " --damping-ratio 0.1")]
    {
        for question in ["response", "steady"] {
            let answer = json(&format!(
                "{question} --mass 1kg --stiffness 100N/m --friction 1N --frequency {frequency}rad/s \
                 --foot-displacement {foot}m{damper} --format json"
            ));
            let physical = &answer["physical"];
            let acceleration = number(&physical["max_acceleration"]);
            close(number(&physical["transmitted_force"]), acceleration, 1e-13);
            let ratio = acceleration / (frequency * frequency * foot);
            close(number(&answer["transmissibility"]), ratio, 1e-13);
            close(number(&answer["max_absolute_displacement"]), number(&answer["max_displacement"]), 1e-9);
        }
    }
    let rows = stdout(
        "response-curve transmissibility --mass 1kg --stiffness 100N/m --friction 1N --frequency \
         100rad/s,150rad/s --foot-displacement 40mm",
    );
    let last = rows.lines().last().unwrap().split(',').nth(3).unwrap().parse::<f64>().unwrap();
    assert!((0.005..0.006).contains(&last), "{rows}");
}
/// For a base with a given acceleration, the force is the same at every frequency.
#[test]
fn bands_of_a_base_with_a_given_acceleration_are_those_of_its_force() {
    let isolator = "design bands --mass 800kg --period 2.2s --friction-coefficient 0.05 --from 0.1Hz --to \
        5Hz --format json";
    let base = json(&format!("{isolator} --base-acceleration 0.7m/s2"));
    let force = json(&format!("{isolator} --force 560N"));
    for end in ["frequency_from", "frequency_to"] {
        close(number(&base[0][end]), number(&force[0][end]), 1e-13);
    }
}

/// A damper by its ratio or its constant, compared with small time steps in the fixed frame.
#[test]
fn a_damper_is_given_by_ratio_or_constant() {
    let machine =
        "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 0.7Hz --base-acceleration 0.15g";
    // c = 2ζ √(k m) = 2ζ m ω_n
    let constant = 2.0 * 0.1 * 800.0 * TAU / 2.2;
    let by_ratio = json(&format!("response {machine} --damping-ratio 10% --format json"));
    let by_constant = json(&format!("response {machine} --damping {constant}N*s/m --format json"));
    assert_eq!(by_ratio["regime"], "non-sticking");
    for answer in [&by_ratio, &by_constant] {
        close(number(&answer["damping_ratio"]), 0.1, 1e-12);
        close(number(&answer["physical"]["damping"]), constant, 1e-12);
        assert_eq!(answer["physical"]["units"]["damping"], "N·s/m");
    }
    let base = 0.15 * 9.80665 / (TAU * 0.7).powi(2);
    let room = Room { damping: constant, ..isolator(0.05, 0.7) };
    let stepped = room.stepped(0.0, base, base, 60, 20_000);
    let physical = &by_ratio["physical"];
    close(number(&physical["max_displacement"]), stepped.stroke, 1e-3);
    close(number(&physical["max_absolute_displacement"]), stepped.absolute, 1e-3);
    close(number(&physical["transmitted_force"]) / 800.0, stepped.acceleration, 1e-3);
    close(number(&physical["damper_energy_per_cycle"]), stepped.damper, 1e-3);
    // Quantities that do not depend on the split between friction and damping: the minimum force, and the
    // undamped ones.
    let least = json(
        &format!("border {machine} --damping-ratio 0.1 --format json")
            .replace(" --base-acceleration 0.15g", ""),
    );
    close(number(&least["min_force_ratio"]), number(&by_ratio["min_force_ratio"]), 1e-14);
    let design = json("design force --omega 1.54 --damping-ratio 0.1 --format json");
    close(number(&design["force_ratio"]), number(&by_ratio["min_force_ratio"]), 1e-12);
    // A curve contains the values that the closed forms have, and marks those that they do not have.
    let rows = stdout("response-curve --omega 0.5:1.5:5 --alpha 2 --damping-ratio 0.02,0.2");
    let values = rows.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let values: Vec<Vec<&str>> = values.filter(|row| row[5] == "grid").collect();
    assert_eq!(values.len(), 10);
    for row in &values {
        // With the exact motion, the value may exist where the body stops.
        assert!(row[2] == "sticking" || (row[2] == "non-sticking" && !row[3].is_empty()), "{row:?}");
    }
    let [light, heavy] = [2, 7].map(|i| values[i][3].parse::<f64>().unwrap());
    // k Δ₀/p₀ at Ω = 1 is of the order 1/(2ζ).
    assert!(light > 5.0 * heavy && light < 25.0, "{light} {heavy}");
    assert!(stdout("border --omega 0.6 --damping-ratio 0.1").contains("damping ratio ζ          0.1"));
    let ends = json("border --omega 0.4 --damping-ratio 0.1 --no-stop --format json");
    assert_eq!(ends["no_stop_force_ratios"][0][0], ends["min_force_ratio"]);
    refused("response --omega 0.4 --alpha 8 --damping-ratio -0.1", &["--damping-ratio -0.1", "must be ≥ 0"]);
    refused(
        &format!("response {machine} --damping-ratio 0.1 --damping 3N*s/m"),
        &["--damping-ratio and --damping"],
    );
    refused(
        &format!("response {machine} --damping 3N"),
        &["--damping 3N", "“N” is a unit of force", "a damping constant"],
    );
}

/// A body at rest on its base moves with it, feels its acceleration, and moves no further.
#[test]
fn a_body_at_rest_moves_with_its_base() {
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --base-acceleration 0.01g";
    for (what, unit) in [("absolute", "mm"), ("displacement", "mm"), ("transmissibility", "1")] {
        let units = if unit == "1" { "" } else { "--units N,mm" };
        let rows = stdout(&format!("response-curve {what} {machine} --frequency 0.6Hz:3Hz:4 {units}"));
        assert_eq!(rows.lines().count(), 5, "{rows}");
        for row in rows.lines().skip(1) {
            let cells: Vec<&str> = row.split(',').collect();
            let hertz: f64 = cells[1].parse().unwrap();
            let base = 1e3 * 0.01 * 9.80665 / (TAU * hertz).powi(2);
            let due = [("absolute", base), ("displacement", 0.0), ("transmissibility", 1.0)];
            let due = due.into_iter().find(|(name, _)| *name == what).unwrap().1;
            assert_eq!(cells[2], "stuck", "{row}");
            assert!((cells[3].parse::<f64>().unwrap() - due).abs() <= 1e-12 * due, "{what} {row} {due}");
        }
    }
}
