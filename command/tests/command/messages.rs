//! The words of messages and help: one clear line in the units that were typed.

use crate::command_line::{json, refused, stdout, stickslip};

const MACHINE: &str = "--mass 800kg --period 2.2s --friction 500N";

#[test]
fn no_help_has_a_semicolon() {
    let all = stdout("--help");
    assert!(!all.contains(';'), "{all}");
    let commands: Vec<&str> = all
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next().filter(|name| !name.is_empty()))
        .collect();
    assert!(commands.len() >= 18, "{commands:?}");
    for command in commands {
        let help = stdout(&format!("help {command}"));
        assert!(!help.contains(';'), "{command}: {help}");
    }
    for question in ["force", "friction", "bands", "displacement", "velocity", "dissipation", "stiffness"] {
        let help = stdout(&format!("design {question} --help"));
        assert!(!help.contains(';'), "{question}: {help}");
    }
    assert!(!stdout("outputs").contains(';'));
}

/// One looks for the limits of the model in the general help first.
#[test]
fn the_general_help_has_the_limits_of_the_model() {
    let help = stdout("--help").split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "one body",
        "Coulomb friction and a harmonic drive",
        "blows with a coefficient of restitution and friction under them",
    ] {
        assert!(help.contains(part), "{part} is not in {help}");
    }
}

#[test]
fn a_value_of_two_words_is_named() {
    for (line, word) in [
        ("response --omega 1.5 --force 30 N", "--force 30 N: must be one word, --force 30N"),
        ("map margin --stiffness 12 kN/mm", "--stiffness 12 kN/mm: must be one word, --stiffness 12kN/mm"),
        ("sweep response --frequency 2 Hz", "--frequency 2 Hz: must be one word"),
        ("response-curve --mass 800 kg", "--mass 800 kg: must be one word"),
    ] {
        refused(line, &[word]);
    }
}

#[test]
fn a_command_without_arguments_says_what_it_needs() {
    for command in ["response", "steady", "attractors", "basins", "simulate --cycles 1", "motion-plot"] {
        refused(command, &["--omega and --alpha are missing", "or a machine: --mass", "--force"]);
    }
    refused("border", &["--omega is missing", "or a machine: --mass"]);
}

/// Frequency ratios from 1.41 to 1.90, where the border's minimum is at α = 1.512.
fn stiffness(force: f64) -> String {
    let machine = "--mass 50kg --friction 5N --frequency 6rad/s --from 500N/m --to 900N/m";
    format!("design stiffness {machine} --force {force}N")
}

/// Bounds are stated in the unit of the argument.
#[test]
fn bounds_are_in_the_unit_that_was_typed() {
    let bands = format!("design bands {MACHINE} --force 510N");
    refused(
        &format!("{bands} --from 5Hz --to 1Hz"),
        &["--from 5Hz --to 1Hz: the lower end must be ≤ the upper"],
    );
    refused(&format!("{bands} --from -1Hz --to 3Hz"), &["--from -1Hz: the frequency must be > 0"]);
    let line = format!("{bands} --from 1Hz --to 1e100Hz");
    refused(&line, &["--to 1e100Hz: the frequency must be ≥ ", " Hz and ≤ ", " Hz"]);
    let parts = ["--force 5.5N: must be at least 1.3745", "times as large", "range from 500N/m to 900N/m"];
    refused(&stiffness(5.5), &parts);
    let line = format!("design displacement {MACHINE} --frequency 0.5Hz --target 1mm");
    refused(&line, &["--target 1mm: must be ≥ ", " mm with --frequency 0.5Hz"]);
    let line = format!("response {MACHINE} --force 1kN --frequency 1e-100Hz");
    refused(&line, &["the frequency must be ≥ ", " Hz and ≤ ", " Hz"]);
    refused(&format!("response {MACHINE} --force 1kN --frequency -2Hz"), &["the frequency must be > 0"]);
    for (line, no) in [(format!("{bands} --from 5Hz --to 1Hz"), "rad/s"), (stiffness(5.5), "Ω")] {
        let output = stickslip(&line).output().unwrap();
        assert!(!String::from_utf8(output.stderr).unwrap().contains(no), "{line}");
    }
}

/// The least force that the message states is the least.
#[test]
fn the_factor_of_a_message_suffices() {
    let output = stickslip(&stiffness(5.5)).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    let factor = message.split("at least ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    let least = 5.5 * factor.parse::<f64>().unwrap();
    refused(&stiffness(least * (1.0 - 1e-5)), &["at least 1.00001 times as large"]);
    stdout(&stiffness(least * (1.0 + 1e-6)));
}

/// A percentage without its sign is a large damping ratio.
#[test]
fn a_note_asks_whether_a_damping_ratio_is_a_percentage() {
    let noted = |line: &str| String::from_utf8(stickslip(line).output().unwrap().stderr).unwrap();
    let note = noted("response --omega 1.5 --alpha 8 --damping-ratio 4");
    assert!(note.starts_with("stickslip: note: --damping-ratio 4 is 400 % of critical damping"), "{note}");
    assert!(note.contains("--damping-ratio 4%") && note.lines().count() == 1, "{note}");
    assert_eq!(noted("response --omega 1.5 --alpha 8 --damping-ratio 4 --quiet"), "");
    assert_eq!(noted("response --omega 1.5 --alpha 8 --damping-ratio 400%"), "");
    assert_eq!(noted("response --omega 1.5 --alpha 8 --damping-ratio 0.9"), "");
    assert_ne!(noted("sweep response --omega 1.5 --alpha 8 --damping-ratio 1,2,5"), "");
}

/// Two of Ω, the frequency and the spring determine the third.
#[test]
fn a_frequency_ratio_and_a_spring_give_the_frequency() {
    let machine = "--mass 50 --stiffness 200 --friction 5";
    // ω_n = 2 rad/s
    let by_frequency = json(&format!("response {machine} --frequency 3 --force 12 --format json"));
    for spring in ["--stiffness 200", "--period 3.14159265358979323846"] {
        let by_ratio =
            format!("response --mass 50 {spring} --friction 5 --omega 1.5 --force 12 --format json");
        let (found, due) = (&json(&by_ratio)["physical"], &by_frequency["physical"]);
        for name in ["angular_frequency", "max_displacement", "stiffness"] {
            let (a, b) = (found[name].as_f64().unwrap(), due[name].as_f64().unwrap());
            assert!((a / b - 1.0).abs() < 1e-14, "{spring} {name}: {a} {b}");
        }
    }
    assert!(stdout(&format!("border {machine} --omega 1.5")).contains("two-reversal threshold"));
    let sweep = stdout(&format!(
        "sweep response {machine} --omega 1:2:3 --force 12 --outputs physical.angular_frequency"
    ));
    assert_eq!(sweep, "angular_frequency[rad/s]\n2.0\n3.0\n4.0\n");
    let three = format!("response {machine} --omega 1.5 --frequency 3 --force 12");
    refused(&three, &["--omega, --frequency and --stiffness: give two of the three"]);
    refused(
        "response --mass 50 --omega 1.5 --friction 5 --force 12",
        &["--frequency (or --stiffness, --period, --natural-frequency, --pendulum-radius) is missing"],
    );
}

#[test]
fn units_are_read_as_engineers_write_them() {
    let line = |damping: &str, frequency: &str| {
        let machine = "--mass 800kg --stiffness 20kN/m --friction 500N --force 3kN";
        stdout(&format!("response {machine} --damping {damping} --frequency {frequency} --format json"))
    };
    let due = line("300N*s/m", "1.5Hz");
    for (damping, frequency) in [("300Ns/m", "1.5hz"), ("0.3kNs/m", "90cpm"), ("0.3Ns/mm", "90RPM")] {
        let (found, due): (serde_json::Value, serde_json::Value) =
            (serde_json::from_str(&line(damping, frequency)).unwrap(), serde_json::from_str(&due).unwrap());
        let value = |of: &serde_json::Value| of["max_displacement"].as_f64().unwrap();
        assert!((value(&found) / value(&due) - 1.0).abs() < 1e-14, "{damping} {frequency}");
    }
}

#[test]
fn a_mass_is_printed_in_a_unit_that_one_reads() {
    let machine = "--mass 1200kg --stiffness 1kN/mm --friction 5kN --frequency 6Hz --force 12kN";
    let text = stdout(&format!("response {machine} --units kN,mm"));
    assert!(text.contains("mass m                   1200 kg                = 0.0012 kN·s²/mm"), "{text}");
    let text = stdout(&format!("response {machine} --units kN,m"));
    assert!(text.contains("mass m                   1.2 t\n"), "{text}");
    let rows = stdout(&format!(
        "map margin {} --mass 1t:2t:2 --units kN,mm",
        machine.replace("--mass 1200kg", "").replace("--frequency 6Hz", "--frequency 5Hz:6Hz:2")
    ));
    assert!(rows.starts_with("frequency[Hz],mass[kg],margin\n5.0,1000.0,"), "{rows}");
}

#[test]
fn the_motion_of_a_machine_has_units_in_its_header() {
    let machine = "--mass 50t --stiffness 1kN/mm --friction 5kN --frequency 0.3Hz --force 12kN --units kN,mm";
    let header = |rest: &str| {
        let text = stdout(&format!("simulate {rest} --cycles 1"));
        text.lines().next().unwrap().to_owned()
    };
    let samples = header(&format!("{machine} --samples 4 --format csv"));
    assert!(
        samples.ends_with(",time[s],displacement[mm],velocity[mm/s],acceleration[mm/s^2],friction_force[kN]"),
        "{samples}"
    );
    let segments = header(&format!("{machine} --format csv"));
    let due = ",start_time[s],end_time[s],start_displacement[mm],start_velocity[mm/s],end_displacement[mm]";
    assert!(segments.ends_with(due), "{segments}");
    assert!(!header("--omega 0.4 --alpha 6 --samples 4 --format csv").contains('['));
    // The keys of JSON lines are as they were.
    let line: serde_json::Value =
        serde_json::from_str(&header(&format!("{machine} --samples 4 --format jsonl"))).unwrap();
    assert!(["time", "displacement", "velocity", "friction_force"].iter().all(|key| line[key].is_number()));
    assert!(line.get("physical").is_none());
    assert!(header(&format!("{machine} --samples 4")).contains("displacement[mm]"));
}

#[test]
fn a_body_that_never_moves_is_said_so() {
    let text = stdout("steady --mass 50 --stiffness 200 --friction 5 --frequency 3 --force 2");
    assert_eq!(text, "Stuck: the body never moves.\n");
    let text = stdout("steady --mass 50 --stiffness 200 --friction 5 --frequency 3 --force 2 --x0 0.01");
    assert_eq!(text, "Stuck: the body never moves from 0.4 B = 0.01 m.\n");
}

/// Words of the field.
#[test]
fn words_are_those_of_the_field() {
    let response = stdout("response --omega 1.5 --alpha 2.5");
    assert!(
        response.contains("maximum dissipation at") && response.contains("loop size A₁ there"),
        "{response}"
    );
    let machine = "--mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500";
    let stiffness = stdout(&format!("design stiffness {machine}"));
    assert!(stiffness.contains("with a stiffness of"), "{stiffness}");
    refused(
        "map --mass 50 --stiffness 10 --friction 5 --frequency 1:2:3 --force 12",
        &["map: 1 grid, must be two"],
    );
}
