//! The command from the user's side: answers, formats, streams, and messages about bad input.

mod points;
mod refusals;

use crate::command_line::{json, refused, stdout, stickslip};

/// The paper's machine: m = 50 kN s²/m, r_y = 5 kN, ω_d = 2π rad/s.
const PAPER: &str = "--mass 50 --friction 5 --frequency 6.283185307179586";

#[test]
fn the_text_answer_begins_with_the_regime() {
    for (args, regime) in [
        ("--omega 1.5 --alpha 2.5", "Non-sticking:"),
        ("--omega 0.4 --alpha 6", "Sticking:"),
        ("--omega 0.4 --alpha 1", "Stuck:"),
        ("--omega 1 --alpha 1.3", "Unbounded:"),
    ] {
        let text = stdout(&format!("response {args}"));
        assert!(text.starts_with(regime), "{text}");
        assert!(text.contains("minimum without sticking"), "{text}");
        // The note appears where eq. 61 is too low: 1/3 < Ω < 1/2.
        assert_eq!(text.contains("(eq. 61 gives"), args.contains("0.4"), "{text}");
    }
    let text = stdout(&format!("response {PAPER} --omega 0.8 --alpha 2.5 --units kN,m"));
    for line in ["= 0.01013936 m", "= 0.06460706 m/s", "= 6.116908 kN", "0.2027873 kN·m", "3084.251 kN/m"] {
        assert!(text.contains(line), "{line} in {text}");
    }
}

#[test]
fn json_has_the_agreed_keys_in_every_regime() {
    let keys = [
        "omega",
        "alpha",
        "regime",
        "max_displacement",
        "displacement_phase",
        "max_velocity",
        "velocity_phase",
        "deviation",
        "min_force_ratio",
        "min_force_ratio_turning_point",
        "loop_size_stiffness",
        "loop_size_inertia",
        "best_force_ratio",
        "best_loop_size",
        "contraction",
        "reversals_per_cycle",
        "best_force_ratio_slides",
        "dynamic_amplification",
        "max_acceleration",
        "transmitted_force",
        "transmissibility",
        "max_absolute_displacement",
        "max_spring_force",
        "equivalent_damping",
        "equivalent_damping_ratio",
        "equivalent_stiffness",
        "effective_damping_ratio",
    ];
    for (args, regime, absent) in [
        ("--omega 1.5 --alpha 2.5", "non-sticking", 0),
        ("--omega 0.4 --alpha 6", "sticking", 19),
        ("--omega 0.4 --alpha 0.9", "stuck", 19),
        ("--omega 1 --alpha 2", "unbounded", 20),
        ("--omega 0.5 --alpha 4", "non-sticking", 1),
        ("--omega 0.331 --alpha 61.6", "non-sticking", 18),
    ] {
        let answer = json(&format!("response {args} --format json"));
        let object = answer.as_object().unwrap();
        assert_eq!(object.len(), keys.len());
        assert!(keys.iter().all(|k| object.contains_key(*k)));
        assert_eq!(object["regime"], regime);
        assert_eq!(object.values().filter(|v| v.is_null()).count(), absent, "{args}: {answer}");
    }
}

/// Near a pole, below the border of the two-reversal cycle, every command gives the same verdict.
#[test]
fn six_reversals_have_one_verdict() {
    let point = "--omega 0.331 --alpha 61.6";
    for command in ["response", "steady"] {
        let answer = json(&format!("{command} {point} --format json"));
        assert_eq!(answer["regime"], "non-sticking", "{command}");
        assert_eq!(answer["reversals_per_cycle"], 6, "{command}");
        let text = stdout(&format!("{command} {point}"));
        assert!(
            text.contains("never stops and reverses six times") || text.contains("reverses 6 times"),
            "{text}"
        );
    }
    assert!(stdout(&format!("response {point}")).contains("`stickslip steady` gives this motion"));
    assert_eq!(json("response --omega 0.7 --alpha 2 --format json")["reversals_per_cycle"], 2);
    let map = stdout("map regime --omega 0.331,0.336 --alpha 61.6");
    assert!(map.contains("0.331,61.6,non-sticking") && map.contains("0.336,61.6,sticking"), "{map}");
}

#[test]
fn the_force_ratios_without_a_stop() {
    let answer = json("border --omega 0.331 --no-stop --format json");
    let found = &answer["no_stop_force_ratios"];
    let number = |i: usize, j: usize| found[i][j].as_f64().unwrap();
    for (got, expected) in [
        (number(0, 0), 53.67330651204315),
        (number(0, 1), 155.36188887727886),
        (number(1, 0), 179.87627993590212),
    ] {
        assert!((got / expected - 1.0).abs() < 1e-14, "{answer}");
    }
    assert!(found[1][1].is_null() && found.as_array().unwrap().len() == 2);
    assert_eq!(answer["min_force_ratio"], found[1][0]);
    let single = json("border --omega 0.4 --no-stop --format json");
    assert_eq!(single["no_stop_force_ratios"][0][0], single["min_force_ratio"]);
    assert!(json("border --omega 0.331 --format json").get("no_stop_force_ratios").is_none());
    let force = json("design force --omega 0.331 --no-stop --format json");
    assert_eq!((&force["no_stop_force_ratios"], &force["force_ratio"]), (found, &found[0][0]));
    let bands = json("design bands --alpha 80 --from 0.3 --to 0.4 --no-stop --format json");
    let counts: Vec<_> =
        bands.as_array().unwrap().iter().map(|b| b["reversals_per_cycle"].as_u64()).collect();
    assert_eq!(counts, [Some(2), Some(6), Some(2)]);
    refused("design friction --omega 0.331 --no-stop", &["--no-stop"]);
}

/// The note marks answers next to a pole or a zero of K that no machine can attain, and the symmetric cycle
/// of a family.
#[test]
fn numbers_that_no_machine_can_use_are_said_to_be_so() {
    let says = |arguments: &str| stdout(arguments).contains("no machine holds");
    assert!(says("response --omega 0.2 --alpha 300") && says("border --omega 0.2"));
    assert!(
        says("response --omega 0.16666666666666666 --alpha 70") || !says("response --omega 0.3 --alpha 70")
    );
    assert!(!says("response --omega 0.21 --alpha 300") && !says("border --omega 0.331"));
    let eq_65 = |omega: &str| {
        json(&format!("response --omega {omega} --alpha 3 --format json"))["best_force_ratio_slides"]
            .as_bool()
    };
    assert_eq!((eq_65("1.5"), eq_65("0.6")), (Some(true), Some(false)));
    assert!(stdout("response --omega 0.5 --alpha 4").contains("family of cycles"));
    assert!(!stdout("response --omega 0.4999999999999999 --alpha 4").contains("family"));
}

#[test]
fn numbers_come_back_to_the_last_bit() {
    let answer = json("response --omega 0.7 --alpha 2 --format json");
    let library = stickslip::Cycle::new(stickslip::Ratios::new(0.7, 2.0).unwrap()).unwrap();
    assert_eq!(answer["max_displacement"].as_f64(), Some(library.max_displacement));
    assert_eq!(answer["velocity_phase"].as_f64(), Some(library.velocity_phase));
}

#[test]
fn physical_units_are_the_ratios_times_their_scales() {
    let frequency = std::f64::consts::TAU;
    let by_ratio = json(&format!("response {PAPER} --omega 0.8 --alpha 2.5 --format json"));
    let by_force = json(&format!("response {PAPER} --stiffness 3084.25137534 --force 12.5 --format json"));
    let length = 5.0 / 3_084.251_375_34;
    let by_base =
        json(&format!("response {PAPER} --stiffness 3084.25137534 --base-motion 0.00405285 --format json"));
    for (answer, tolerance) in [(&by_ratio, 1e-11f64), (&by_force, 1e-11), (&by_base, 1e-6)] {
        let physical = &answer["physical"];
        for (field, name, scale, unit) in [
            ("max_displacement", "max_displacement", length, "m"),
            ("deviation", "deviation", length, "m"),
            ("max_velocity", "max_velocity", length * frequency, "m/s"),
            ("displacement_phase", "displacement_time", 1.0 / frequency, "s"),
            ("velocity_phase", "velocity_time", 1.0 / frequency, "s"),
            ("min_force_ratio", "min_force", 5.0, "N"),
            ("best_force_ratio", "best_force", 5.0, "N"),
        ] {
            let (ratio, value) = (answer[field].as_f64().unwrap(), physical[name].as_f64().unwrap());
            assert_eq!(physical["units"][name], unit, "{name}");
            assert!((value / (ratio * scale) - 1.0).abs() < tolerance.max(1e-11), "{name}");
            let reference = by_ratio["physical"][name].as_f64().unwrap();
            assert!((value / reference - 1.0).abs() < tolerance * 100.0, "{name}");
        }
        // The energy 4 r_y Δ₀ of a cycle.
        let energy = 4.0 * 5.0 * physical["max_displacement"].as_f64().unwrap();
        assert!((physical["energy_per_cycle"].as_f64().unwrap() / energy - 1.0).abs() < 1e-11);
        assert_eq!(physical["angular_frequency"].as_f64(), Some(frequency));
        // There is no phase, ratio or count among them, and each value has its unit.
        let names: Vec<_> =
            physical.as_object().unwrap().keys().filter(|k| *k != "drive" && *k != "units").collect();
        let units = physical["units"].as_object().unwrap();
        assert!(
            names.len() == units.len() && names.iter().all(|name| units.contains_key(*name)),
            "{names:?}"
        );
    }
    assert!(by_ratio.get("physical").is_some());
    assert!(json("response --omega 0.8 --alpha 2.5 --format json").get("physical").is_none());
}

/// The best loop and the force printed with it belong together: with that force the machine has that loop.
#[test]
fn the_best_force_has_the_best_loop() {
    let at =
        |force: f64| json(&format!("response {PAPER} --omega 1.5 --alpha {} --format json", force / 5.0));
    for force in [12.5, 40.0] {
        let best = at(force)["physical"].clone();
        let there = at(best["best_force"].as_f64().unwrap());
        let (energy, size) = (&best["best_force_energy"], &there["physical"]["energy_per_cycle"]);
        assert!((energy.as_f64().unwrap() / size.as_f64().unwrap() - 1.0).abs() < 1e-12, "{energy} {size}");
    }
}

#[test]
fn the_border_in_all_its_forms() {
    let answer = json("border --omega 0.4 --format json");
    assert!((answer["min_force_ratio"].as_f64().unwrap() / 6.949737755908733 - 1.0).abs() < 1e-14);
    assert!(
        (answer["min_force_ratio_turning_point"].as_f64().unwrap() / 5.654423047491228 - 1.0).abs() < 1e-14
    );
    assert!((answer["border_phase"].as_f64().unwrap() - 0.471_787_094_713_988_6).abs() < 1e-13);
    let physical = json(&format!("border {PAPER} --omega 0.4 --format json"));
    let ratio = physical["physical"]["min_force"].as_f64().unwrap();
    assert!((ratio / (5.0 * 6.949737755908733) - 1.0).abs() < 1e-14);
    // B = r_y/k with k = m (ω_d/Ω)², and a phase is ω_d t, ω_d = 2π.
    let friction_displacement = 5.0 / (50.0 * (std::f64::consts::TAU / 0.4).powi(2));
    for (name, due) in [
        ("min_force_turning_point", 5.0 * 5.654423047491228),
        ("border_time", 0.471_787_094_713_988_6 / std::f64::consts::TAU),
        ("least_displacement", 7.886_745_719_501_848 * friction_displacement),
    ] {
        let found = physical["physical"][name].as_f64().unwrap();
        assert!((found / due - 1.0).abs() < 1e-13, "{name}: {found} for {due}");
    }
    assert!(stdout("border --omega 0.4").contains("6.949738"));
    assert!(stdout("border --omega 1.5").contains("exact here"));
    let rows =
        stickslip("border --points - --format csv").write_stdin("omega\n0.4\n1.5\n").assert().success();
    let text = String::from_utf8(rows.get_output().stdout.clone()).unwrap();
    assert_eq!(text.lines().count(), 3);
}

#[test]
fn help_and_version_go_to_standard_output() {
    assert!(stdout("--version").contains(env!("CARGO_PKG_VERSION")));
    assert!(stdout("response --help").contains("--foot-displacement"));
}

#[test]
fn verify_holds_every_equation() {
    let text = stdout("verify");
    assert!(text.contains("53 bits") && text.trim_end().ends_with("identities as expected"), "{text}");
    let report = json("verify --format json");
    assert_eq!((report["bits"].as_u64(), report["passed"].as_bool()), (Some(53), Some(true)));
    let identities = report["identities"].as_array().unwrap();
    for equation in ["21", "35", "48, 49", "61", "67"] {
        let named = |i: &&serde_json::Value| i["equation"] == equation && i["standing"] == "holds";
        let found = identities.iter().find(named).unwrap_or_else(|| panic!("{equation}"));
        assert!(found["worst_residual"].as_f64().unwrap() < 128.0 && found["points"].as_u64() > Some(100));
    }
    assert!(identities.iter().any(|i| i["equation"] == "49" && i["standing"] == "refuted"));
}

/// With more bits the answers are the same, as strings with all their digits.
#[cfg(feature = "mp")]
#[test]
fn bits_give_all_the_digits_of_the_reference() {
    let points = include_str!("../../../tests/data/points.csv");
    let header: Vec<&str> = points.lines().next().unwrap().split(',').collect();
    let mut long = 0;
    for row in points.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        // The reference uses the doubles nearest to the numbers in the row; here they are written with all
        // their digits.
        let exactly = |cell: &str| format!("{:.120}", cell.parse::<f64>().unwrap());
        let (omega, alpha) = (exactly(cells[0]), exactly(cells[1]));
        let answer = json(&format!("response --omega {omega} --alpha {alpha} --bits 256 --format json"));
        for (name, reference) in header.iter().zip(&cells).skip(2) {
            if *name == "border_phase" || reference.is_empty() {
                continue;
            }
            let digits = answer[*name].as_str().unwrap_or_else(|| panic!("{name}: {}", answer[*name]));
            let as_mp = |text: &str| text.parse::<stickslip::float::Mp<4>>().unwrap();
            let (found, expected) = (as_mp(digits), as_mp(reference));
            let off = stickslip::Float::to_f64(found - expected).abs();
            let size = stickslip::Float::to_f64(expected).abs().max(1e-3);
            assert!(off <= 1e-38 * size, "{name} at {row}: {digits}");
            long += usize::from(digits.len() > 70);
        }
    }
    // Some answers are short because they are whole numbers.
    assert!(long > 150, "{long} answers with all digits");
    // The text answer has all digits, too.
    let answer = json("response --omega 0.7 --alpha 2 --bits 256 --format json");
    let note = stdout("response --omega 0.7 --alpha 2 --bits 256");
    assert!(note.contains(answer["max_displacement"].as_str().unwrap()), "{note}");
    assert!(stdout("verify --bits 192").contains("256 bits"));
    let csv = stdout("response --points ../tests/data/points.csv --format csv --bits 128");
    assert_eq!(csv.lines().count(), 18);
}
