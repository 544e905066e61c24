//! An engineer's input: values with units, the two kinds of base motion, an isolator.
//!
//! The motions are compared with small time steps in the fixed frame, which use neither p₀ nor Ω nor α.

pub(crate) mod base_motion;
mod damped_foot;
mod mean_force;
mod unbalance;

use crate::command_line::{json, refused, stdout, stickslip};
use serde_json::Value;
use std::f64::consts::TAU;

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

pub(crate) fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a / b - 1.0).abs() < tolerance, "{a} against {b}");
}

/// A force in American units and in kN and mm gives the same machine.
#[test]
fn units_convert_in_and_out() {
    let si = "--mass 50000kg --stiffness 1e6N/m --friction 5000N --frequency 6rad/s --force 12000N";
    let mixed = "--mass 50t --stiffness 1kN/mm --friction 5kN --frequency 0.954929658551372Hz --force 12kN";
    let bare = "--mass 50 --stiffness 1000 --friction 5 --frequency 6 --force 12 --units kN,m";
    let inches = "--mass 50t --stiffness 5710.147162769201lbf/in --friction 1124.044715501rpm";
    let one = json(&format!("response {si} --format json"));
    for (line, scale) in [
        (format!("response {mixed} --units kN,mm --format json"), 1e3),
        (format!("response {bare} --format json"), 1.0),
    ] {
        let other = json(&line);
        close(number(&other["max_displacement"]), number(&one["max_displacement"]), 1e-13);
        let length = number(&other["physical"]["max_displacement"]);
        close(length, scale * number(&one["physical"]["max_displacement"]), 1e-13);
        close(number(&other["physical"]["min_force"]), 1e-3 * number(&one["physical"]["min_force"]), 1e-13);
    }
    let text = stdout(&format!("response {mixed} --units kN,mm"));
    assert!(
        text.contains("12.13668 mm") && text.contains("1 kN/mm") && text.contains("0.9549297 Hz"),
        "{text}"
    );
    refused(
        &format!("response {inches} --frequency 6 --force 1N"),
        &["--friction", "“rpm” is a unit of frequency", "a force (N, kN, lbf)"],
    );
    let start = "simulate --mass 50t --stiffness 1kN/mm --friction 5kN --frequency 6rad/s --force 12kN \
        --cycles 1 --samples 4 --x0 3mm --v0 20mm/s --format csv";
    let rows = stdout(start);
    let columns: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let first: Vec<f64> = rows.lines().nth(1).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let at = |name: &str| first[columns.iter().position(|c| *c == name).unwrap()];
    close(at("displacement[m]"), 0.003, 1e-13);
    close(at("velocity[m/s]"), 0.02, 1e-13);
}

#[cfg(feature = "mp")]
#[test]
fn units_keep_all_digits_of_wide_numbers() {
    let answer = json(
        "response --bits 256 --mass 3lb --period 2.2s --friction 1lbf --frequency 2Hz --force 12lbf \
         --format json",
    );
    // 3 × 0.45359237, and 12 pounds of force over one of friction.
    let mass = answer["physical"]["mass"].as_str().unwrap();
    assert!(
        mass.starts_with("1.36077711") && (mass.len() < 14 || mass[10..70].bytes().all(|b| b == b'0')),
        "{mass}"
    );
    assert_eq!(answer["alpha"].as_str().unwrap().trim_end_matches(".0"), "12");
}

/// An option that is nearly right is suggested.
#[test]
fn what_was_meant_is_said() {
    for (arguments, parts) in [
        ("response --omeg 1.5 --alpha 2", ["--omeg", "Did you mean --omega?"]),
        ("respond --omega 1.5", ["respond", "Did you mean response?"]),
        ("response-curve velocty --omega 0.5:1:3 --alpha 2", ["velocty", "Did you mean velocity?"]),
    ] {
        refused(arguments, &parts);
    }
}

#[test]
fn wrong_units_mixed_kinds_and_missing_arguments_are_one_clear_line() {
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05";
    for (arguments, parts) in [
        (
            format!("response {machine} --frequency 2s --force 1N"),
            vec!["--frequency 2s", "“s” is a unit of time", "Hz, rad/s, rpm"],
        ),
        (
            format!("response {machine} --frequency 2Hz --force 1kg"),
            vec!["--force 1kg", "“kg” is a unit of mass"],
        ),
        (
            format!("response {machine} --frequency 2Hz --force 1xN"),
            vec!["“xN” is not a known unit", "N, kN, lbf"],
        ),
        (
            format!("response {machine} --frequency 2Hz --force 12"),
            vec!["--force 12: has no unit beside --mass 800kg"],
        ),
        (
            format!("response {machine} --stiffness 1N/m --frequency 2Hz --force 1N"),
            vec!["--stiffness and --period"],
        ),
        (
            format!("response {machine} --friction 1N --frequency 2Hz --force 1N"),
            vec!["--friction and --friction-coefficient"],
        ),
        (
            format!("response {machine} --frequency 2Hz --force 1N --base-acceleration 0.15g"),
            vec!["--force and --base-acceleration"],
        ),
        (
            format!("response {machine} --frequency 2Hz"),
            vec!["--force (or --unbalance, --eccentricity, --base-acceleration", "is missing"],
        ),
        (format!("response {machine} --force 1N"), vec!["--frequency is missing"]),
        (
            "response --mass 800kg --friction 1N --frequency 2Hz --force 1N".to_owned(),
            vec!["--stiffness (or --period, --natural-frequency, --pendulum-radius, --omega) is missing"],
        ),
        (
            "response --mass 1kg --period -2s --friction 1N --frequency 2Hz --force 1N".to_owned(),
            vec!["--period -2s", "must be > 0"],
        ),
        (
            "response --mass 1kg --period 2s --friction-coefficient -1 --frequency 2Hz --force 1N".to_owned(),
            vec!["--friction-coefficient -1", "must be ≥ 0"],
        ),
        (
            "response --mass 1kg --period 2s --friction 1N --gravity 3m/s2 --frequency 2Hz --force 1N".to_owned(),
            vec!["--gravity", "--friction-coefficient"],
        ),
        (
            format!("response {machine} --frequency 2Hz --base-acceleration -0.15g"),
            vec!["--base-acceleration -0.15g", "> 0"],
        ),
        (
            format!("response {machine} --frequency 2Hz --force 1N --units furlong,m"),
            vec!["--units", "“furlong” is not a unit of force"],
        ),
        (
            "steady --omega 0.5 --alpha 3.3 --static-friction 1.3".to_owned(),
            vec!["--static-friction 1.3: the static friction r_s", "--mass is missing", "give --static-friction-ratio"],
        ),
        (
            "steady --omega 0.5 --alpha 3.3 --damping 0.05".to_owned(),
            vec!["--damping 0.05: the damping constant c", "give --damping-ratio"],
        ),
        ("response --omega 2Hz --alpha 3".to_owned(), vec!["--omega 2Hz", "a plain number"]),
        ("steady --omega 2 --alpha 3 --x0 3mm".to_owned(), vec!["--x0 3mm", "a plain number"]),
        (
            "design bands --no-stop --mass 800kg --period 2.2s --friction 1N --base-displacement 3mm --from 1Hz --to 2Hz"
                .to_owned(),
            vec!["changes with the frequency"],
        ),
        (
            "design stiffness --mass 800kg --friction 1N --frequency 2Hz --force 3N --from 1Hz --to 2N/m".to_owned(),
            vec!["--from 1Hz", "a stiffness (N/m"],
        ),
    ] {
        refused(&arguments, &parts);
    }
}

/// The table of outputs contains every key of every answer, and every column.
#[test]
fn every_output_is_defined() {
    let table = stdout("outputs");
    assert!(stdout("help outputs").contains(table.trim_end()));
    let defined: Vec<&str> = table
        .lines()
        .filter_map(|line| line.strip_prefix("  "))
        .flat_map(|line| line.split("   ").next().unwrap_or(line).split(", "))
        .map(|name| name.split(' ').next().unwrap())
        .collect();
    let is_defined = |name: &str| {
        let end = ["_re", "_im", "_low", "_high"].iter().find_map(|end| name.strip_suffix(end));
        let name = end.map_or(name, |name| name.trim_end_matches(['1', '2']).trim_end_matches('_'));
        defined.contains(&name) || (name.ends_with("_time") && defined.contains(&"…_time"))
    };
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 2Hz";
    let mut tried = 0;
    for arguments in [
        format!("response {machine} --base-acceleration 0.15g --damping-ratio 0.01"),
        format!("response {machine} --foot-displacement 0.3m"),
        format!("steady {machine} --base-acceleration 0.15g --mean-force 1kN --friction-backward 0.3kN"),
        format!("border {machine} --damping 3N*s/m"),
        "border --omega 0.4 --no-stop".to_owned(),
    ] {
        let answer = json(&format!("{arguments} --format json"));
        let keys = answer.as_object().unwrap().keys();
        let physical = answer["physical"].as_object().into_iter().flat_map(serde_json::Map::keys);
        for key in keys.chain(physical).filter(|key| !["physical", "units"].contains(&key.as_str())) {
            assert!(is_defined(key), "{arguments}: {key}");
            tried += 1;
        }
    }
    for samples in ["", " --samples 4"] {
        let rows = stdout(&format!("simulate --omega 0.4 --alpha 6 --cycles 1 --format csv{samples}"));
        for name in rows.lines().next().unwrap().split(',') {
            let like = name.replace("end_", "start_");
            assert!(
                is_defined(name)
                    || is_defined(&like)
                    || table
                        .lines()
                        .any(|line| line.contains("likewise") && line.split(' ').any(|word| word == name)),
                "{name}"
            );
        }
    }
    assert!(tried > 100, "{tried}");
    assert!(!is_defined("nonesuch"));
}

/// Each value in the machine's units is its value in the units of `outputs` times B = r_y/k, B ω_d, B ω_d²,
/// r_y, 1/ω_d or r_y B; here these are 0.375 m, 0.525 m/s, 0.735 m/s², 3 N, 1/1.4 s and 1.125 N·m.
#[test]
fn every_value_in_units_is_its_ratio_times_its_unit() {
    let body = "--mass 2 --stiffness 8 --friction 3 --frequency 1.4 --format json";
    let (turn, hertz) = (TAU / 1.4, 1.4 / TAU);
    let mut compared = 0;
    for (arguments, force, base) in [
        ("steady --force 15 --damping-ratio 0.05", 15.0, false),
        ("steady --base-displacement 15", 58.8, true),
        ("steady --force 6 --static-friction-ratio 1.3", 6.0, false),
        ("steady --force 2.4", 2.4, false),
        ("response --force 15 --damping-ratio 0.05", 15.0, false),
        ("response --base-velocity 21", 58.8, true),
        ("response --foot-displacement 3", 24.0, false),
        ("border --damping-ratio 0.05", 0.0, false),
    ] {
        let answer = json(&format!("{arguments} {body}"));
        let own = |name: &str| answer[name].as_f64();
        for (name, found) in answer["physical"].as_object().unwrap() {
            if ["units", "drive"].contains(&name.as_str()) {
                continue;
            }
            let (due, unit) = match name.as_str() {
                "frequency" => (Some(hertz), "Hz"),
                "angular_frequency" => (Some(1.4), "rad/s"),
                "natural_frequency" => (Some(2.0), "rad/s"),
                "period" => (Some(TAU / 2.0), "s"),
                "mass" => (Some(2.0), "kg"),
                "stiffness" => (Some(8.0), "N/m"),
                "friction" => (Some(3.0), "N"),
                "static_friction" => (Some(3.9), "N"),
                "damping" => (Some(0.4), "N·s/m"),
                "force_amplitude" => (Some(force), "N"),
                "friction_displacement" => (Some(0.375), "m"),
                "foot_displacement" => (Some(3.0), "m"),
                "base_displacement" => (Some(15.0), "m"),
                "base_velocity" => (Some(21.0), "m/s"),
                "base_acceleration" => (Some(29.4), "m/s²"),
                "max_displacement" | "min_displacement" | "deviation" | "distance" | "rest_position"
                | "least_displacement" => (own(name).map(|x| x * 0.375), "m"),
                "max_absolute_displacement" => {
                    assert!(base || arguments.contains("foot"), "{arguments}");
                    (own(name).map(|x| x * 0.375), "m")
                }
                "max_velocity" | "min_velocity" => (own(name).map(|x| x * 0.525), "m/s"),
                "max_acceleration" => (own(name).map(|x| x * 0.735), "m/s²"),
                "transmitted_force" | "max_spring_force" => (own(name).map(|x| x * 3.0), "N"),
                "equivalent_stiffness" => (own(name).map(|x| x * 8.0), "N/m"),
                "equivalent_damping" => (own(name).map(|x| x * 8.0 / 1.4), "N·s/m"),
                "min_force" | "min_force_turning_point" | "best_force" => {
                    (own(&name.replace("force", "force_ratio")).map(|x| x * 3.0), "N")
                }
                "energy_in" | "energy_out" => (own(name).map(|x| x * 1.125), "N·m"),
                "damper_energy_per_cycle" => (own("damper_work").map(|x| x * 1.125), "N·m"),
                // A₁ is stated in units of p₀²/(2k).
                "energy_per_cycle" => (own("loop_size_stiffness").map(|x| x * force * force / 16.0), "N·m"),
                "best_force_energy" => {
                    let best = own("best_force_ratio").map(|ratio| 3.0 * ratio);
                    (own("best_loop_size").zip(best).map(|(size, p0)| size * p0 * p0 / 16.0), "N·m")
                }
                "followed_for" => (own("periods").map(|x| x * turn), "s"),
                time => {
                    let phase = time.strip_suffix("_time").unwrap_or_else(|| panic!("{arguments}: {time}"));
                    (own(&format!("{phase}_phase")).map(|x| x / 1.4), "s")
                }
            };
            assert_eq!(answer["physical"]["units"][name], unit, "{arguments}: {name}");
            let found = found.as_f64();
            let is = match (found, due) {
                (Some(found), Some(due)) => (found - due).abs() <= 1e-13 * due.abs(),
                (found, due) => found == due,
            };
            assert!(is, "{arguments}: {name} {found:?} for {due:?}");
            compared += u32::from(found.is_some());
        }
        let felt = own("transmitted_force").zip(own("transmissibility"));
        let is_share = |(f, ratio): (f64, f64)| (f * 3.0 / force / ratio - 1.0).abs() < 1e-13;
        assert!(arguments.contains("foot") || felt.is_none_or(is_share), "{arguments}");
    }
    assert!(compared > 130, "{compared}");
}

/// A quotient is read from left to right, as a product is: N/m*s is (N/m) s.
#[test]
fn units_are_multiplied_from_left_to_right() {
    let machine = "--mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 2Hz --force 9kN";
    let at = |damping: &str| json(&format!("response {machine} --damping {damping} --format json"));
    let due = at("100N*s/m");
    for text in ["100N/m*s", "0.1kN/m*s", "100s*N/m", "100kg/s"] {
        let found = at(text);
        let ratio = |value: &Value| number(&value["damping_ratio"]);
        close(ratio(&found), ratio(&due), 1e-14);
        close(number(&found["max_displacement"]), number(&due["max_displacement"]), 1e-12);
    }
}

/// 500 kip at 1.5 Hz, and their mass and stiffness in SI.
#[test]
fn the_weight_and_the_natural_frequency_take_the_place_of_mass_and_stiffness() {
    let rest =
        "--friction-coefficient 0.05 --frequency 2Hz --base-acceleration 0.2g --units kip,in --format json";
    let by_weight = json(&format!("response --weight 500kips --natural-frequency 1.5Hz {rest}"));
    let mass = 500.0 * 4_448.221_615_260_5 / 9.80665;
    let stiffness = mass * (3.0 * std::f64::consts::PI).powi(2);
    let by_mass = json(&format!("response --mass {mass}kg --stiffness {stiffness}N/m {rest}"));
    let by_both = json(&format!("response --stiffness {stiffness}N/m --natural-frequency 1.5Hz {rest}"));
    for other in [by_mass, by_both] {
        for name in ["max_displacement", "transmitted_force", "mass", "stiffness"] {
            let [one, two] = [&by_weight, &other].map(|answer| answer["physical"][name].as_f64().unwrap());
            assert!((one / two - 1.0).abs() < 1e-12, "{name}: {one} {two}");
        }
    }
    refused(
        "response --weight 5N --mass 2kg --period 1s --friction 1N --frequency 1Hz --force 2N",
        &["--mass and --weight: give one"],
    );
    refused(
        "response --stiffness 5N/m --mass 2kg --period 1s --friction 1N --frequency 1Hz --force 2N",
        &["--stiffness and --period: give one"],
    );
}

/// A mass that cancels may be left out: motions are those of any mass, and a note says of which mass the forces are.
#[test]
fn a_mass_that_cancels_is_left_out() {
    let base = "--frequency 2Hz --base-acceleration 0.15g --friction-coefficient 0.05 --units N,mm";
    for spring in ["--period 2.2s", "--natural-frequency 0.4Hz", "--pendulum-radius 1.2m --damping-ratio 2%"]
    {
        for command in ["response", "steady"] {
            let run = stickslip(&format!("{command} {spring} {base} --format json")).assert().code(0);
            let note = String::from_utf8(run.get_output().stderr.clone()).unwrap();
            assert!(note.contains("--mass is left out") && note.contains("those of 1 t"), "{note}");
            let without: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
            let with = json(&format!("{command} --mass 37kg {spring} {base} --format json"));
            for name in ["max_displacement", "max_velocity", "max_acceleration", "max_absolute_displacement"]
            {
                close(number(&without["physical"][name]), number(&with["physical"][name]), 1e-12);
            }
            let force = |answer: &Value| number(&answer["physical"]["max_spring_force"]);
            close(force(&without) / 1000.0, force(&with) / 37.0, 1e-12);
        }
    }
    let decay = json("decay --quiet --period 1s --friction-coefficient 0.05 --x0 200mm --format json");
    let with = json("decay --mass 3kg --period 1s --friction-coefficient 0.05 --x0 200mm --format json");
    close(number(&decay["physical"]["path"]), number(&with["physical"]["path"]), 1e-13);
    // A force, a damper by its constant, or a friction by its bound need the mass.
    for rest in [
        "--friction-coefficient 0.05 --force 20N",
        "--friction 3N --base-acceleration 0.15g",
        "--friction-coefficient 0.05 --damping 2N*s/m --base-acceleration 0.15g",
        "--friction-coefficient 0.05 --mean-force 2N --base-acceleration 0.15g",
    ] {
        refused(&format!("response --period 2.2s --frequency 2Hz {rest}"), &["--mass", "missing"]);
    }
}

/// The stiffness m g/R of a pendulum is right to 2 % up to a fifth of the radius.
#[test]
fn a_pendulum_far_from_its_middle_is_said() {
    for (command, far) in [
        (
            "response --pendulum-radius 1m --friction-coefficient 0.05 --frequency 1Hz --base-acceleration 0.2g",
            false,
        ),
        (
            "response --pendulum-radius 0.3m --friction-coefficient 0.05 --frequency 1Hz --base-acceleration 0.5g",
            true,
        ),
        (
            "steady --pendulum-radius 0.3m --friction-coefficient 0.05 --frequency 1Hz --base-acceleration 0.5g",
            true,
        ),
        ("decay --pendulum-radius 1m --friction-coefficient 0.05 --x0 199mm", false),
        ("decay --pendulum-radius 1m --friction-coefficient 0.05 --x0 201mm", true),
    ] {
        let run = stickslip(&format!("{command} --mass 1kg")).assert().code(0);
        let note = String::from_utf8(run.get_output().stderr.clone()).unwrap();
        assert_eq!(note.contains("exceeds a fifth of the radius"), far, "{command}: {note}");
    }
    // The horizontal force of a bowl is m g tan θ, sin θ = x/R.
    let angle = 0.2f64.asin();
    close(angle.tan() / 0.2, 1.0206, 1e-4);
}

/// An unbalance in US units is a mass times a length, and not lbf·s² beside lb.
#[test]
fn an_unbalance_is_read_in_pounds_and_inches_or_in_kilogram_metres() {
    let text = stdout(
        "response --mass 100lb --stiffness 500lb/in --friction 20lb --unbalance 50lb*in --frequency 700rpm --units \
         lbf,in",
    );
    assert!(text.contains("unbalance m_e e          50 lb·in               = 0.129504 lbf·s²"), "{text}");
    // With metric units it is in kg·m.
    let machine =
        "response --mass 12kg --stiffness 140N/mm --friction 25N --unbalance 0.02kg*m --frequency 25Hz";
    for (units, due) in
        [("N,mm", "0.02 kg·m\n"), ("N,m", "0.02 kg·m\n"), ("kN,mm", "0.02 kg·m              = 2e-5 kN·s²")]
    {
        let text = stdout(&format!("{machine} --units {units}"));
        assert!(text.contains(&format!("unbalance m_e e          {due}")), "{units}: {text}");
    }
}

/// A friction of 0 is a linear oscillator, and a simulation with a drive of 0 a free vibration.
#[test]
fn a_friction_or_a_drive_may_be_zero() {
    let (mass, stiffness, frequency, force) = (2.0, 800.0, 4.0 * std::f64::consts::PI, 10.0);
    let machine = "--quiet --mass 2kg --stiffness 800N/m --frequency 2Hz --damping-ratio 5%";
    let damping = 2.0 * 0.05 * f64::sqrt(mass * stiffness);
    let amplitude = force / (stiffness - mass * frequency * frequency).hypot(damping * frequency);
    for friction in ["--friction 0N", "--friction-coefficient 0"] {
        for command in ["response", "steady"] {
            let found = json(&format!("{command} {machine} {friction} --force 10N --format json"));
            let physical = &found["physical"];
            assert_eq!(
                (found["regime"].as_str(), number(&physical["friction"])),
                (Some("non-sticking"), 0.0)
            );
            close(number(&physical["max_displacement"]), amplitude, 1e-12);
            close(number(&physical["max_spring_force"]), stiffness * amplitude, 1e-12);
            close(number(&physical["equivalent_damping"]), damping, 1e-12);
            close(number(&found["equivalent_damping_ratio"]), 0.05, 1e-12);
        }
    }
    // In a simulation without a drive the body vibrates freely.
    for drive in ["--force 0N", "--base-acceleration 0g", "--foot-displacement 0mm", "--unbalance 0kg*m"] {
        let options = "--mass 2kg --stiffness 800N/m --friction 4N --damping-ratio 5% --x0 30mm";
        let rows =
            stdout(&format!("simulate {options} --frequency 2Hz {drive} --duration 2s --format jsonl"));
        let last: Value = serde_json::from_str(rows.lines().last().unwrap()).unwrap();
        let decay = json(&format!("decay {options} --format json"));
        let [rest, due] = [&last["start_displacement"], &decay["physical"]["rest_position"]].map(number);
        assert!(last["kind"] == "stick" && (rest - due).abs() < 1e-12, "{drive}: {rest} {due}");
    }
    refused("response --omega 0.5 --alpha 0", &["must be > 0"]);
    let neither = "response --mass 2kg --stiffness 800N/m --frequency 2Hz --friction 0N --force 0N";
    assert_eq!(json(&format!("{neither} --quiet --format json"))["regime"], "stuck");
}
