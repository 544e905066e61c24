//! `stickslip design` from the user's side: every answer is substituted into the forward commands.

use crate::command_line::{refused, stdout};
use serde_json::Value;

fn json(arguments: &str) -> Value {
    crate::command_line::json(&format!("{arguments} --format json"))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn close(a: f64, b: f64) {
    assert!((a / b - 1.0).abs() < 1e-12, "{a} against {b}");
}

const BODY: &str = "--mass 50 --stiffness 1000 --friction 5";

#[test]
fn least_force_and_greatest_friction_are_the_border() {
    let force = json(&format!("design force {BODY} --frequency 6"));
    let border = json(&format!("border {BODY} --frequency 6"));
    close(number(&force["force"]), number(&border["physical"]["min_force"]));
    close(number(&force["foot_displacement"]) * 1000.0, number(&force["force"]));
    close(number(&force["base_displacement"]) * 50.0 * 36.0, number(&force["force"]));
    close(number(&force["base_acceleration"]) * 50.0, number(&force["force"]));
    let friction =
        json(&format!("design friction --mass 50 --stiffness 1000 --frequency 6 --force {}", force["force"]));
    close(number(&friction["friction"]), 5.0);
    close(number(&json("design force --omega 0.4")["force_ratio"]), 6.949737755908733);
    close(1.0 / number(&json("design friction --omega 0.4")["friction_to_force"]), 6.949737755908733);
}

#[test]
fn the_bands_end_where_the_regime_changes() {
    let bands = json("design bands --alpha 12 --from 0.1 --to 2");
    let bands = bands.as_array().unwrap();
    assert_eq!(bands.len(), 2);
    let regime = |omega: f64| json(&format!("response --alpha 12 --omega {omega}"))["regime"].clone();
    for band in bands {
        let (low, high) = (number(&band["omega_from"]), number(&band["omega_to"]));
        assert_eq!((regime(low), regime(high)), ("non-sticking".into(), "non-sticking".into()));
        if band["high_edge"] == "border" {
            assert_eq!(regime(high * (1.0 + 1e-9)), "sticking");
        }
        assert_eq!(regime(low * (1.0 - 1e-9)), "sticking");
    }
    let physical = json(&format!("design bands {BODY} --force 60 --from 0.5 --to 9"));
    let natural = 20f64.sqrt();
    close(number(&physical[0]["frequency_from"]), natural * number(&bands[0]["omega_from"]));
    assert!(stdout("design bands --alpha 1.1 --from 0.1 --to 2").starts_with("The body sticks"));
}

#[test]
fn the_force_for_a_target_reaches_it() {
    for (question, output) in [("displacement", "max_displacement"), ("velocity", "max_velocity")] {
        let force = json(&format!("design {question} --omega 1.5 --target 2"));
        let back = json(&format!("response --omega 1.5 --alpha {}", force["force_ratio"]));
        close(number(&back[output]), 2.0);
        let force = json(&format!("design {question} {BODY} --frequency 6 --target 0.05"));
        let back = json(&format!("response {BODY} --frequency 6 --force {}", force["force"]));
        close(number(&back["physical"][output]), 0.05);
    }
}

#[test]
fn the_best_friction_and_stiffness_are_better_than_their_neighbours() {
    let best = json("design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12");
    assert_eq!(best["optimum"], "interior");
    let energy = |friction: f64| {
        let machine = format!("--mass 50 --stiffness 1000 --friction {friction} --frequency 6 --force 12");
        number(&json(&format!("steady {machine}"))["physical"]["energy_out"])
    };
    let friction = number(&best["friction"]);
    close(energy(friction), number(&best["energy"]));
    assert!(
        energy(friction * 1.01) < number(&best["energy"])
            && energy(friction * 0.99) < number(&best["energy"])
    );
    assert_eq!(json("design dissipation --omega 0.6")["optimum"], "border");
    for (question, why) in [
        ("dissipation --omega 1.5", "an interior maximum."),
        ("dissipation --omega 0.6", "at the sticking threshold."),
        ("dissipation --omega 0.6 --sticking", "where it sticks, by the exact motion."),
        ("stiffness --alpha 1.5 --from 0.6 --to 0.7", "at the end of the range."),
    ] {
        let note = stdout(&format!("design {question}"));
        assert!(note.lines().next().unwrap().ends_with(why), "{note}");
    }
    let of_all = json("design dissipation --omega 0.6 --sticking");
    let steady = json(&format!("steady --omega 0.6 --alpha {}", of_all["force_ratio"]));
    let alpha = number(&of_all["force_ratio"]);
    let size = 2.0 * number(&steady["energy_out"]) / (alpha * alpha);
    assert!((size / number(&of_all["loop_size_stiffness"]) - 1.0).abs() < 1e-9);
    assert!(number(&of_all["bound"]) <= number(&of_all["loop_size_stiffness"]) * (1.0 + 1.1e-6));
    let stiff = json("design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500");
    assert_eq!((number(&stiff["stiffness"]), stiff["optimum"].as_str()), (1500.0, Some("end-of-range")));
    let omega = json("design stiffness --alpha 1.25 --from 0.6 --to 0.95");
    let loop_size =
        |omega: f64| number(&json(&format!("response --alpha 1.25 --omega {omega}"))["loop_size_inertia"]);
    let at = number(&omega["omega"]);
    close(loop_size(at), number(&omega["loop_size_inertia"]));
    assert!(loop_size(at * 1.001) < loop_size(at) && loop_size(at * 0.999) < loop_size(at));
}

/// Each problem that allows a damper is answered with one, in both kinds of units, and searched answers are
/// marked as such; the others refuse a damper.
#[test]
fn with_a_damper() {
    let damped = "--omega 1 --damping-ratio 0.05";
    for (question, output) in [("velocity", "max_velocity"), ("displacement", "max_displacement")] {
        let force = json(&format!("design {question} {damped} --target 8"));
        let back = json(&format!("response {damped} --alpha {}", force["force_ratio"]));
        close(number(&back[output]), 8.0);
    }
    let bands = json("design bands --alpha 31 --damping-ratio 0.01 --from 0.1 --to 2");
    let bands = bands.as_array().unwrap();
    assert_eq!((bands.len(), &bands[0]["found_by"]), (2, &Value::from("search")));
    let border = json(&format!("border --damping-ratio 0.01 --omega {}", bands[0]["omega_from"]));
    close(number(&border["min_force_ratio"]), 31.0);
    assert!(stdout("design bands --alpha 31 --damping-ratio 0.01 --from 0.1 --to 2").contains("not a proof"));
    let best = json("design dissipation --omega 0.7 --damping-ratio 0.05");
    let back = json(&format!("response --omega 0.7 --damping-ratio 0.05 --alpha {}", best["force_ratio"]));
    close(
        number(&back["best_force_ratio"]).max(number(&back["min_force_ratio"])),
        number(&best["force_ratio"]),
    );
    let of_all = json("design dissipation --omega 0.3 --damping-ratio 0.05 --sticking");
    let alpha = number(&of_all["force_ratio"]);
    let steady = json(&format!("steady --omega 0.3 --damping-ratio 0.05 --alpha {alpha}"));
    assert_eq!(of_all["optimum"], "sticking");
    let size = 2.0 * number(&steady["energy_out"]) / (alpha * alpha);
    assert!((size / number(&of_all["loop_size_stiffness"]) - 1.0).abs() < 1e-9, "{of_all}");
    let machine = "--mass 50 --friction 5 --frequency 6 --force 12 --damping 20";
    let stiff = json(&format!("design stiffness {machine} --from 500 --to 3000"));
    assert_eq!(stiff["found_by"], "search");
    let energy = |k: f64| {
        let found = json(&format!("response {machine} --stiffness {k}"));
        number(&found["loop_size_stiffness"]) / k
    };
    let k = number(&stiff["stiffness"]);
    assert!(energy(k) >= energy(k * 1.001) && energy(k) >= energy(k * 0.999), "{stiff}");
    let arguments = "stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 900";
    let says = &["Give the damping constant", "--damping-ratio"];
    refused(&format!("design {arguments} --damping-ratio 0.05"), says);
}

/// A range that ends beside the resonance, whose peak is as narrow as the damping is weak.
#[test]
fn the_best_stiffness_beside_an_end_of_the_range() {
    let best = json(
        "design stiffness --mass 1 --friction 1 --frequency 1 --force 24 --damping 0.0004 --from 0.4 --to 1.02",
    );
    assert!((number(&best["energy"]) / 227_267.6 - 1.0).abs() < 1e-6, "{best}");
    assert!((number(&best["stiffness"]) - 1.0).abs() < 1e-7, "{best}");
    assert_eq!((&best["optimum"], &best["found_by"]), (&Value::from("interior"), &Value::from("search")));
    let best = json(
        "design stiffness --mass 50t --friction 5kN --frequency 1Hz --force 30kN --damping 6.3kN*s/m \
         --from 1000kN/m --to 2010kN/m --units kN,m",
    );
    assert!((number(&best["energy"]) / 11.941 - 1.0).abs() < 1e-4, "{best}");
    assert!((number(&best["stiffness"]) / 1973.9 - 1.0).abs() < 1e-4, "{best}");
}

/// Far below the resonance the free vibration has decayed at each turn: the border is 2q/Ω², and α = 10²⁰ reaches
/// down to Ω = √2·10⁻¹⁰. With little damping there are too many half turns to search.
#[test]
fn bands_far_below_the_resonance() {
    let bands = json("design bands --alpha 1e20 --damping-ratio 5% --from 1e-10 --to 5e-9");
    assert_eq!(bands.as_array().unwrap().len(), 1);
    close(number(&bands[0]["omega_from"]), 2f64.sqrt() * 1e-10);
    close(number(&bands[0]["omega_to"]), 5e-9);
    refused(
        "design bands --alpha 1e20 --damping-ratio 1e-9 --from 1e-10 --to 5e-9",
        &["--from 1e-10", "frequency ratio Ω = 1e-10 must be ≥"],
    );
}

/// Forces and bands without a stop with a damper: six reversals a cycle with little damping, and none with
/// more.
#[test]
fn without_a_stop_with_a_damper() {
    let ends = |answer: &Value| answer["no_stop_force_ratios"].as_array().unwrap().len();
    let some = json("border --omega 0.331 --damping-ratio 0.001 --no-stop");
    let found = &some["no_stop_force_ratios"];
    assert!((number(&found[0][0]) - 56.24322231107378).abs() < 1e-10, "{some}");
    assert!((number(&found[0][1]) - 147.55834811749975).abs() < 1e-9, "{some}");
    assert_eq!((ends(&some), &found[1][0]), (2, &some["min_force_ratio"]));
    let force = json("design force --omega 0.331 --damping-ratio 0.001 --no-stop");
    assert_eq!((&force["no_stop_force_ratios"], &force["force_ratio"]), (found, &found[0][0]));
    assert_eq!(ends(&json("design force --omega 0.331 --damping-ratio 0.05 --no-stop")), 1);
    let reversals = |arguments: &str| -> Vec<u64> {
        let bands = json(&format!("design bands {arguments} --no-stop"));
        bands.as_array().unwrap().iter().filter_map(|band| band["reversals_per_cycle"].as_u64()).collect()
    };
    assert_eq!(reversals("--alpha 80 --from 0.32 --to 0.36 --damping-ratio 0.002"), [2, 6, 2]);
    assert_eq!(reversals("--alpha 80 --from 0.32 --to 0.36 --damping-ratio 0.01"), [2, 2]);
    let machine = "--mass 2 --stiffness 8 --friction 3 --damping-ratio 0.001";
    let newtons = json(&format!("design force {machine} --frequency 0.662 --no-stop"));
    let least = number(&newtons["no_stop_forces"][0][0]);
    assert!((least / (3.0 * 56.24322231107378) - 1.0).abs() < 1e-11, "{newtons}");
    let text = stdout("border --omega 0.331 --damping-ratio 0.001 --no-stop");
    assert!(text.contains("where it reverses six times a cycle"), "{text}");
}

#[test]
fn text_begins_with_the_answer() {
    let text = stdout(&format!("design force {BODY} --frequency 6 --units kN,m"));
    assert!(text.starts_with(
        "The body never sticks at a force of 7.393705 kN or more: a rotating unbalance of 0.2053807 t·m, a motion of 0.007393705 m of the spring's support over \
         a fixed surface, or of 0.004107614 m of a base that carries the surface."
    ));
    assert!(stdout("design bands --alpha 12 --from 0.1 --to 2").contains("2 bands of that range"));
}

#[test]
fn bad_input_is_one_line_with_argument_value_and_inequality() {
    for (arguments, parts) in [
        ("design", vec!["command", "--help"]),
        ("design displacement --omega 1.5 --target 0.1", vec!["Δ₀/B = 0.1", "≥ 0.444"]),
        ("design displacement --omega 1 --target 3", vec!["Ω = 1"]),
        ("design displacement --omega 1.5", vec!["--target is missing"]),
        ("design velocity --omega 1.5 --target nan", vec!["NaN", "finite"]),
        (
            "design bands --alpha 12 --from 2 --to 1",
            vec!["--from 2 --to 1: the lower end must be ≤ the upper end"],
        ),
        ("design bands --alpha nan --from 1 --to 2", vec!["--alpha nan", "finite"]),
        ("design bands --alpha 12 --to 2", vec!["--from is missing"]),
        (
            "design bands --alpha 3 --from 2 --to 0.1",
            vec!["--from 2 --to 0.1", "the lower end must be ≤ the upper end"],
        ),
        ("design displacement --omega 1.5 --target 0", vec!["--target 0", "must be > 0"]),
        ("design velocity --omega 1.5 --target -1", vec!["--target -1", "must be > 0"]),
        ("design stiffness --alpha 2 --from 0 --to 1", vec!["--from 0", "must be > 0"]),
        ("design force --omega 0", vec!["--omega 0", "> 0"]),
        ("design force --omega 0.4 --mass 3", vec!["--mass 3", "design force does not use it in ratios"]),
        ("design dissipation --mass 50 --stiffness 1000 --frequency 6", vec!["--force", "missing"]),
        ("design dissipation --omega 1", vec!["Ω = 1"]),
        ("design stiffness --alpha 1.1 --from 0.1 --to 2", vec!["1.1"]),
    ] {
        refused(arguments, &parts);
    }
}

/// The friction over a band: the answer, the trivial cases, the picture, and one line for each mistake.
#[test]
fn the_best_friction_over_a_band() {
    let isolator = "design friction --mass 800kg --period 2.2s --damping-ratio 5%";
    let asked = format!("{isolator} --base-displacement 50mm --over 0.2Hz:2Hz --of absolute-displacement");
    let found = json(&asked);
    assert!((number(&found["greatest"]) / 0.05 - 1.0).abs() < 1e-9, "{found}");
    assert_eq!((&found["optimum"], &found["found_by"]), (&"interior".into(), &"search".into()));
    assert_eq!(found["at_frequencies"].as_array().map(Vec::len), Some(2));
    // The steady motion at the second of the two has that amplitude, with less friction a greater one.
    let at = |share: f64| {
        let friction = share * number(&found["friction"]);
        let frequency = number(&found["at_frequencies"][1][0]);
        let machine = format!("--mass 800kg --period 2.2s --damping-ratio 5% --friction {friction}N");
        let drive = format!("--base-displacement 50mm --frequency {frequency}rad/s");
        let steady = json(&format!("steady {machine} {drive}"));
        number(&steady["physical"]["max_absolute_displacement"])
    };
    assert!((at(1.0) / 0.05 - 1.0).abs() < 1e-9 && at(0.99) > 0.0501);
    assert!(stdout(&asked).contains(" and at "), "{}", stdout(&asked));
    // At rest it is that amplitude, too.
    assert!(stdout(&asked).contains(" N or more, also at rest: 0.05 m, with the least of them at "));
    assert!(number(&found["greatest_friction"]) >= number(&found["rest_friction"]), "{found}");
    assert!((at(20.0) / 0.05 - 1.0).abs() < 1e-9);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("curves.svg");
    stdout(&format!("{asked} --picture {}", file.display()));
    assert!(std::fs::read_to_string(&file).unwrap().contains("<svg"));
    refused(&format!("{asked} --picture {}", file.display()), &["--picture", "must not exist yet"]);
    let between = format!("{isolator} --base-acceleration 1m/s2 --over 0.4Hz:0.6Hz --of acceleration");
    assert!(json(&between)["greatest_friction"].is_null() && !stdout(&between).contains(" or more"));
    let force = format!("{isolator} --force 300N");
    assert!(
        stdout(&format!("{force} --over 0.2Hz:2Hz --of displacement")).contains("because the body rests")
    );
    let less = stdout(&format!("{force} --over 0.9Hz:2Hz --of transmitted-force"));
    assert!(
        less.starts_with("The peak transmitted force from ") && less.contains(" falls with the friction: "),
        "{less}"
    );
    for (arguments, parts) in [
        ("--over 2Hz --of displacement", ["--over 2Hz", "LOW:HIGH"]),
        ("--over 2Hz:1Hz --of displacement", ["--over 2Hz:1Hz", "the lower end must be < the upper end"]),
        ("--over 1Hz:1mm --of displacement", ["--over 1mm", "a frequency"]),
        ("--over 1Hz:2Hz", ["--of <WHAT>", "not provided"]),
        ("--over 1Hz:2Hz --of displacement --frequency 1Hz", ["--frequency 1Hz", "must be left out"]),
        ("--over 1Hz:2Hz --of absolute-displacement", ["--force 300N", "a motion of the base"]),
    ] {
        refused(&format!("{force} {arguments}"), &parts);
    }
}

#[test]
fn the_frictions_for_an_amplitude_give_it() {
    let machine = "--mass 50kg --stiffness 1kN/m --damping-ratio 1% --units N,mm";
    let mut regimes = Vec::new();
    for (frequency, target) in [(0.3, 2.0), (0.9, 14.0), (1.5, 3.0), (1.5, 0.5)] {
        let drive = format!("--frequency {frequency}Hz --force 12N");
        let found = json(&format!("design friction {machine} {drive} --target-amplitude {target}mm"));
        assert_eq!(found["target_amplitude"], target);
        let solutions = found["solutions"].as_array().unwrap();
        assert!(!solutions.is_empty(), "{frequency} {target}");
        for one in solutions {
            let steady = json(&format!("steady {machine} {drive} --friction {}N", one["friction"]));
            let displacement = number(&steady["physical"]["max_displacement"]);
            assert!((displacement / target - 1.0).abs() < 1e-9, "{frequency} {target}: {displacement}");
            assert_eq!(one["units"]["friction"], "N");
            regimes.push(one["regime"].clone());
        }
    }
    assert!(regimes.contains(&"sticking".into()) && regimes.contains(&"non-sticking".into()), "{regimes:?}");
    let beyond = stdout(
        "design friction --mass 50kg --stiffness 1kN/m --frequency 1rad/s --force 12N --target-amplitude 1m",
    );
    assert!(beyond.starts_with("No friction gives an amplitude of 1 m"), "{beyond}");
    refused(
        "design friction --omega 0.7 --target-amplitude 2",
        &["--target-amplitude 2: design friction does not use it in ratios"],
    );
    let line = "design friction --mass 1 --stiffness 1 --frequency 2 --force 1";
    refused(
        &format!("{line} --target-amplitude 0"),
        &["--target-amplitude 0: peak displacement", "must be > 0"],
    );
}

/// A block of 1 kg with µ_s = 0.5, µ_k = 0.3 and 200 N/m, pulled at 0.1 m/s: the formulae of textbooks on stick-slip
/// without a damper, t_stick = 2 (F_s − F_k)/(k V) and t_slip = 2 (π − arctan((F_s − F_k) ω/(k V)))/ω.
#[test]
fn a_pulled_block_sticks_and_slips_as_textbooks_say() {
    let pull = json(
        "pull --mass 1kg --stiffness 200N/m --friction-coefficient 0.3 --static-friction 4.903325N --speed 0.1m/s",
    );
    let (drop, omega): (f64, f64) = (0.2 * 9.80665, 200f64.sqrt());
    close(number(&pull["stick_time"]), 2.0 * drop / 20.0);
    close(number(&pull["slip_time"]), 2.0 * (std::f64::consts::PI - (drop * omega / 20.0).atan()) / omega);
    close(number(&pull["period"]), number(&pull["slip_time"]) + number(&pull["stick_time"]));
    close(number(&pull["slip_distance"]), 0.1 * number(&pull["period"]));
    close(number(&pull["max_velocity"]), 0.1 + (drop / 200.0 * omega).hypot(0.1));
    assert!(pull["smooth_above"].is_null());
    let smooth = stdout(
        "pull --mass 1 --stiffness 200 --damping-ratio 5% --friction 3 --static-friction-ratio 1.2 --speed 5",
    );
    assert!(smooth.starts_with("Smooth: the body slides on"), "{smooth}");
    refused(
        "pull --mass 1 --stiffness 200 --friction 3 --speed 0",
        &["--speed 0: velocity v = 0 must be > 0"],
    );
    refused("pull --mass 1 --friction 3 --speed 1", &["--stiffness (or --period", "is missing"]);
}
