//! A rotating unbalance over its speed, and a friction pendulum, compared with small time steps.

use super::base_motion::Room;
use super::{close, number};
use crate::command_line::{json, refused, stdout};
use std::f64::consts::TAU;

const FEEDER: &str = "--mass 120kg --stiffness 60kN/m --friction 150N --damping-ratio 3%";

/// Eight speeds through the resonance at 213.5 rpm, with stops and without.
#[test]
fn an_unbalance_moves_the_body_as_small_time_steps_do() {
    for (i, speed) in [200.0, 205.0, 212.0, 220.0, 250.0, 320.0, 480.0, 900.0].into_iter().enumerate() {
        let drive =
            if i % 2 == 0 { "--unbalance 0.36kg*m" } else { "--eccentric-mass 3kg --eccentricity 120mm" };
        let found = json(&format!("steady {FEEDER} {drive} --frequency {speed}rpm --format json"));
        let frequency = speed * TAU / 60.0;
        let damping = 0.06 * (60e3 * 120.0_f64).sqrt();
        let room = Room { mass: 120.0, stiffness: 60e3, friction: 150.0, frequency, damping };
        // The mass m_e moves with x + e sin ω_d t.
        let stepped = room.stepped(3.0 * 0.12 * frequency * frequency, 0.0, 0.0, 120, 4000);
        let far = number(&found["physical"]["max_displacement"]);
        close(far, stepped.stroke, 4e-3);
        close(number(&found["physical"]["unbalance"]), 0.36, 1e-12);
        assert_eq!(found["sticks_per_cycle"].as_u64() > Some(0), stepped.held > 0, "{speed}");
    }
}

/// On a spherical surface of radius R the body at x is pulled back by m g x/R.
#[test]
fn a_pendulum_is_a_spring() {
    let machine = "--mass 120t --pendulum-radius 2m --friction-coefficient 5%";
    let found = json(&format!("steady {machine} --base-acceleration 0.12g --frequency 0.5Hz --format json"));
    let (weight, frequency) = (120e3 * 9.80665, 0.5 * TAU);
    let room =
        Room { mass: 120e3, stiffness: weight / 2.0, friction: 0.05 * weight, frequency, damping: 0.0 };
    let surface = 0.12 * 9.80665 / (frequency * frequency);
    // The support moves with the base, and the spring stands on it.
    let stepped = room.stepped(0.0, surface, surface, 60, 4000);
    close(number(&found["physical"]["max_displacement"]), stepped.stroke, 4e-3);
    close(number(&found["physical"]["period"]), TAU * (2.0 / 9.80665_f64).sqrt(), 1e-12);
    let moon = json(&format!(
        "response {machine} --gravity 1.62m/s2 --base-acceleration 0.02g --frequency 0.5Hz --format json"
    ));
    close(number(&moon["physical"]["stiffness"]), 120e3 * 1.62 / 2.0, 1e-12);
}

/// The border as an unbalance, bands of speed, and a curve over it in its unit.
#[test]
fn an_unbalance_has_its_design_answers() {
    let least = json(&format!("design force {FEEDER} --frequency 480rpm --format json"));
    let unbalance = number(&least["unbalance"]);
    let at = |share: f64| {
        let drive = format!("--unbalance {}kg*m --frequency 480rpm", share * unbalance);
        json(&format!("response {FEEDER} {drive} --format json"))["regime"].clone()
    };
    assert_eq!((at(1.000_001), at(0.999_999)), ("non-sticking".into(), "sticking".into()));
    let bands =
        json(&format!("design bands {FEEDER} --unbalance 0.36kg*m --from 60rpm --to 1500rpm --format json"));
    assert_eq!(bands["bands"].as_array().map_or(1, Vec::len), 1, "{bands}");
    let curve = stdout(&format!(
        "response-curve displacement {FEEDER} --unbalance 0.36kg*m --frequency 60rpm:900rpm:20"
    ));
    assert!(curve.starts_with("curve,frequency[rpm],"), "{curve}");
    assert!(curve.lines().last().unwrap().contains(",900,"), "{curve}");
    assert!(stdout(&format!("response {FEEDER} --unbalance 0.36kg*m --frequency 480rpm")).contains("kg·m"));
}

#[test]
fn a_wrong_unbalance_is_refused() {
    let at = "response --mass 120kg --stiffness 60kN/m --friction 150N --frequency 480rpm";
    for (arguments, parts) in [
        ("--unbalance 3kg", vec!["--unbalance 3kg", "an unbalance (kg*m", "“kg” is a unit of mass"]),
        ("--unbalance=-1kg*m", vec!["--unbalance -1kg*m", "must be > 0"]),
        ("--eccentricity 12mm", vec!["--eccentric-mass is missing"]),
        ("--eccentric-mass 3kg", vec!["--eccentric-mass 3kg", "--eccentricity"]),
        ("--eccentric-mass -3kg --eccentricity 1mm", vec!["--eccentric-mass -3kg", "> 0"]),
        ("--eccentric-mass 3kg --force 1N", vec!["--eccentric-mass 3kg", "--eccentricity"]),
        ("--unbalance 1kg*m --force 1N", vec!["--unbalance", "one of the two"]),
    ] {
        refused(&format!("{at} {arguments}"), &parts);
    }
    let pendulum = "response --mass 1t --friction 1kN --frequency 1Hz --force 3kN --pendulum-radius";
    refused(&format!("{pendulum} -2m"), &["--pendulum-radius -2m", "pendulum radius R", "> 0"]);
    refused(&format!("{pendulum} 2m --period 2s"), &["--period and --pendulum-radius", "one of the two"]);
}
