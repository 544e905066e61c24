//! `--enclose`: certain digits in text and in JSON.

use super::command_line::{json, refused, stdout};

/// The number printed with ±, and the radius, in a line that begins with this name.
fn line(text: &str, name: &str) -> (f64, f64) {
    let line = text
        .lines()
        .find(|line| line.trim_start().starts_with(name))
        .unwrap_or_else(|| panic!("{name}: {text}"));
    let words: Vec<&str> = line.split_whitespace().collect();
    let place = words.iter().position(|word| *word == "±").unwrap();
    (words[place - 1].parse().unwrap(), words[place + 1].parse().unwrap())
}

#[test]
fn the_closed_forms_with_their_error_bounds() {
    let plain = json("response --omega 0.4 --alpha 9 --format json");
    let text = stdout("response --omega 0.4 --alpha 9 --enclose");
    assert!(text.starts_with("Non-sticking: the body never stops. This is certain."), "{text}");
    let found = json("response --omega 0.4 --alpha 9 --enclose --format json");
    assert_eq!((found["regime"].as_str(), found["omega"].as_str()), (Some("non-sticking"), Some("0.4")));
    for name in ["max_displacement", "velocity_phase", "min_force_ratio", "loop_size_inertia", "contraction"]
    {
        let value = plain[name].as_f64().unwrap();
        let (mid, rad) = line(&text, name);
        assert!(
            (mid - value).abs() < 1e-14 * value && rad > 0.0 && rad < 1e-17 * value,
            "{name}: {mid} {rad}"
        );
        let number = |part: &str| found[name][part].as_str().unwrap().parse::<f64>().unwrap();
        assert!((number("mid") - value).abs() < 1e-14 * value && number("rad") < 1e-18 * value, "{name}");
    }
    let damped = json(
        "response --omega 0.4 --alpha 9 --damping-ratio 0.02 --static-friction-ratio 1.1 --enclose --format \
         json",
    );
    let plain =
        json("response --omega 0.4 --alpha 9 --damping-ratio 0.02 --static-friction-ratio 1.1 --format json");
    for name in [
        "max_displacement",
        "max_velocity",
        "transmitted_force",
        "max_absolute_displacement",
        "min_force_ratio",
    ] {
        let number = |part: &str| damped[name][part].as_str().unwrap().parse::<f64>().unwrap();
        let value = plain[name].as_f64().unwrap();
        assert!((number("mid") - value).abs() < 1e-12 * value && number("rad") < 1e-18 * value, "{name}");
    }
    assert_eq!(
        (damped["damping_ratio"].as_str(), damped["static_friction_ratio"].as_str()),
        (Some("0.02"), Some("1.1"))
    );
    let border = json("border --omega 0.4 --enclose --bits 256 --format json");
    assert!(
        border["min_force_ratio"]["mid"]
            .as_str()
            .unwrap()
            .starts_with("6.94973775590873527472295777499013999948596912741032010578658")
    );
    assert!(stdout("response --omega 0.5 --alpha 3 --enclose").starts_with("Undecided at 8256 bits"));
    // At a pole the border is infinite.
    let pole = stdout("response --omega 1/3 --alpha 1e9 --enclose");
    assert!(
        pole.starts_with("Below the sticking threshold") && pole.contains("No output has a finite enclosure"),
        "{pole}"
    );
    let resonant = "response --omega 1 --alpha 1.4 --enclose --static-friction-ratio";
    assert!(stdout(&format!("{resonant} 1.5")).contains("Other starts may lead to other motions"));
    assert!(!stdout(&format!("{resonant} 1")).contains("Other starts"));
}

#[test]
fn a_motion_with_stops_is_proved() {
    let plain = json("steady --omega 0.4 --alpha 6 --format json");
    let text = stdout("steady --omega 0.4 --alpha 6 --enclose");
    assert!(text.starts_with("Proved: a periodic motion with 2 stops a cycle exists."), "{text}");
    let found = json("steady --omega 0.4 --alpha 6 --enclose --format json");
    assert_eq!((found["proved"].as_bool(), found["sticks_per_cycle"].as_u64()), (Some(true), Some(2)));
    for name in ["max_displacement", "max_velocity", "stick_fraction"] {
        let value = plain[name].as_f64().unwrap();
        let (mid, rad) = line(&text, name);
        assert!((mid - value).abs() < 1e-12 && rad < 1e-18, "{name}: {mid} {rad}");
    }
    let damped = json("steady --omega 0.3 --alpha 4 --damping-ratio 0.1 --enclose --format json");
    // The reference is an independent event-driven simulation.
    let displacement: f64 = damped["max_displacement"]["mid"].as_str().unwrap().parse().unwrap();
    assert!((displacement - 3.339_881_800_0).abs() < 1e-9, "{displacement}");
    // A motion above critical damping, and one of a mirror pair.
    let text = stdout("steady --omega 0.5 --alpha 3 --damping-ratio 2 --enclose");
    assert!(text.starts_with("Proved: a periodic motion with 2 stops a cycle exists."), "{text}");
    let pair = "steady --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3 --enclose";
    let pair = json(&format!("{pair} --format json"));
    assert_eq!((pair["symmetric"].as_bool(), pair["sticks_per_cycle"].as_u64()), (Some(false), Some(1)));
    let unproved = json("steady --omega 0.7 --alpha 0.9 --enclose --format json");
    assert!(unproved["proved"] == false && unproved["reason"].as_str().unwrap().contains("does not become"));
    assert!(stdout("steady --omega 0.5 --alpha 3 --enclose").starts_with("Not proved"));
}

/// The ball of every residual contains 0, and its greatest distance from 0 is printed.
#[test]
fn the_identities_hold_in_balls() {
    let report = json("verify --enclose --bits 96 --format json");
    assert_eq!((report["bits"].as_u64(), report["enclosed"].as_bool()), (Some(96), Some(true)));
    let identities = report["identities"].as_array().unwrap();
    assert!(identities.len() > 60 && report["passed"] == true);
    for row in identities {
        let worst = row["worst_residual"].as_f64().unwrap();
        assert!(row["standing"] != "holds" || worst <= 1.0, "{row}");
    }
    assert!(identities.iter().any(|row| row["statement"].as_str().unwrap().contains("proved to exist")));
}

#[test]
fn bad_input_is_refused() {
    refused("verify --enclose --bits 5000", &["--bits 5000", "≤ 4096"]);
    refused("response --omega 0.4 --enclose", &["--alpha", "missing"]);
    refused("response --omega x --alpha 3 --enclose", &["--omega x", "must be a number"]);
    refused("response --omega -1 --alpha 3 --enclose", &["--omega -1", "must be > 0"]);
    refused("response --omega 1 --alpha 3 --enclose --format csv", &["--format"]);
    refused(
        "response --omega 1 --alpha 3 --enclose --damping-ratio -0.1",
        &["--damping-ratio -0.1", "must be ≥ 0"],
    );
    refused("response --omega 1 --alpha 3 --enclose --bits 9000", &["--bits 9000", "≤ 8192"]);
    refused("border --omega 1 --enclose --no-stop", &["--enclose", "--no-stop"]);
    refused("steady --omega 1 --alpha 3 --enclose --x0 1", &["--enclose", "--x0"]);
    refused("steady --omega 0.5 --alpha 3 --damping-ratio -2 --enclose", &["--damping-ratio -2", "ζ"]);
    refused("response --points FILE --enclose", &["--enclose"]);
}
