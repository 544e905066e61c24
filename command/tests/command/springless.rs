//! A body without a spring under a harmonic drive, from the user's side: beside small steps of a body that has none, and
//! beside the limits of the formulae.

use crate::command_line::{json, refused, stdout};
use crate::compared::{Origin, agreed, compared};
use crate::random::Random;
use crate::stepped::{Pair, Stepped};
use serde_json::Value;
use std::f64::consts::{PI, TAU};

fn number(answer: &Value, name: &str) -> f64 {
    let physical = &answer["physical"][name];
    let found = if physical.is_null() { &answer[name] } else { physical };
    found.as_f64().unwrap_or_else(|| panic!("{name}: {answer}"))
}

/// m = 2, r_y = 4, ω_d = 3: lengths are r_y/(m ω_d²) = 2/9, velocities 2/3.
const MACHINE: &str = "--no-spring --mass 2 --friction 4 --frequency 3";
const LENGTH: f64 = 2.0 / 9.0;

/// Δ₀ = √(α² − π²/4), cos θ₀ = π/(2α) at the turning point, and the threshold √(η² + π²/4): the limits of eq. 43, 44
/// and 61 for Ω → ∞, which the balance of impulses in half a cycle gives, too.
#[test]
fn closed_forms_are_the_limits_for_high_frequencies() {
    for (alpha, eta) in [(1.8621, 1.0), (3.0, 1.0), (50.0, 1.0), (3.0, 1.7)] {
        let ratio = if eta > 1.0 { format!("--static-ratio {eta}") } else { String::new() };
        let answer = json(&format!("response {MACHINE} --force {} {ratio} --format json", 4.0 * alpha));
        let far = (alpha * alpha - PI * PI / 4.0).sqrt();
        let of = |name: &str| number(&answer, name);
        let near = |name: &str, other: f64| {
            compared(&format!("physical {name}"), of(name), other, Origin::ByHand, 1e-14 * other.abs());
        };
        near("max_displacement", far * LENGTH);
        near("energy_per_cycle", 4.0 * 4.0 * far * LENGTH);
        near("min_force", 4.0 * f64::hypot(eta, PI / 2.0));
        // 2α cos θ + π = 0 at the reversal from forward to backward.
        near("displacement_time", (PI + (PI / (2.0 * alpha)).acos()) / 3.0);
        // 4 r_y Δ₀/(p₀²/(2 m ω_d²)) is greatest at α = π/√2.
        near("best_force", 4.0 * PI / 2f64.sqrt());
        for absent in ["omega", "max_spring_force", "dynamic_amplification", "equivalent_damping_ratio"] {
            assert!(answer[absent].is_null() && answer["physical"][absent].is_null(), "{absent}: {answer}");
        }
    }
    let border =
        json("border --no-spring --mass 2 --friction 4 --frequency 3 --static-ratio 1.7 --format json");
    compared(
        "border min_force_ratio",
        number(&border, "min_force_ratio"),
        f64::hypot(1.7, PI / 2.0),
        Origin::ByHand,
        1e-14,
    );
}

/// The motion under a moving base, with and without a damper and static friction, with and without stops.
#[test]
fn steady_motions_are_those_of_small_steps() {
    let mut random = Random(20_261_128);
    let mut kinds = [0; 2];
    for case in 0..24 {
        let alpha = random.between(1.05, 4.05);
        let damping = [0.0, 0.4, 5.0][case % 3] * random.next();
        let peak = if case % 2 == 0 { 1.0 } else { random.between(1.0, 1.6) };
        if alpha <= peak {
            continue;
        }
        let pair = Pair {
            mass: [2.0, 1.0],
            spring: [0.0; 2],
            damper: [damping, 0.0],
            friction: 4.0,
            peak,
            force: [0.0, 1.0, 0.0],
            base: [2.0 * alpha, 3.0],
        };
        let mut motion = Stepped::new(pair, 0.0, [0.0; 4]);
        motion.follow(60.0 * TAU / 3.0, 60 * 256);
        let mut motion = Stepped::new(pair, motion.time, [motion.state[0], 0.0, motion.state[2], 0.0]);
        motion.follow(TAU / 3.0, 4096);
        let answer = json(&format!(
            "steady {MACHINE} --base-acceleration {} --damping {damping} --static-ratio {peak} --format json",
            2.0 * alpha
        ));
        let of = |name: &str| number(&answer, name);
        let [most, least] = motion.extremes[0];
        let length = 1e-8 * (1.0 + most - least);
        let near = |name: &str, ours: f64, other: f64, bound: f64| {
            compared(&format!("steady {name}"), ours, other, Origin::SmallSteps, bound);
        };
        near("max_displacement", of("max_displacement") - of("min_displacement"), most - least, length);
        assert!((of("max_displacement") + of("min_displacement")).abs() < 1e-12, "{answer}");
        near("max_velocity", of("max_velocity"), motion.extremes[2][0], length);
        let share = motion.rest * 3.0 / TAU;
        near("stick_fraction", number(&answer, "stick_fraction"), share, 1e-7);
        near("energy_out", of("energy_out"), motion.state[6], 1e-7 * (1.0 + of("energy_out")));
        let sticks = motion.events.iter().filter(|(_, kind)| *kind == "stick").count();
        agreed(
            "steady sticks_per_cycle",
            answer["sticks_per_cycle"].as_u64(),
            Some(sticks as u64),
            Origin::SmallSteps,
        );
        kinds[usize::from(sticks > 0)] += 1;
    }
    assert!(kinds[0] >= 5 && kinds[1] >= 5, "{kinds:?}");
}

/// A constant force d r_y moves the body on. Without a stop it slides forward for π(1 + d) of each cycle, by the balance of
/// impulses, and the reversals follow from `2α sin(θ₀ + τ/2) sin(τ/2) = (1 − d) τ`.
#[test]
fn a_constant_force_makes_it_drift() {
    for (alpha, d) in [(3.0, 0.2), (5.0, -0.4), (20.0, 0.7)] {
        let forward = PI * (1.0 + d);
        let start = ((1.0 - d) * forward / (2.0 * alpha * (forward / 2.0).sin())).asin() - forward / 2.0;
        let travelled = |from: f64, time: f64, push: f64| {
            alpha * (from.cos() * time - (from + time).sin() + from.sin()) + push * time * time / 2.0
        };
        // The other root of the sine is the one at which the force pushes forward.
        let start = if alpha * start.sin() + d > 1.0 { start } else { PI - forward - start };
        let [there, back] =
            [travelled(start, forward, d - 1.0), travelled(start + forward, TAU - forward, d + 1.0)];
        let drift = there + back;
        // Friction takes up r₊ times the way forward and r₋ times the way back, and the load does that work.
        let by_direction = [4.0 * (1.0 - d), 4.0 * (1.0 + d)];
        for (options, [r, s]) in [
            (format!("--friction 4 --mean-force={}", 4.0 * d), [4.0; 2]),
            (format!("--friction {} --friction-backward {}", by_direction[0], by_direction[1]), by_direction),
        ] {
            let answer = json(&format!(
                "steady --no-spring --mass 2 --frequency 3 --force {} {options} --format json",
                4.0 * alpha
            ));
            assert_eq!(answer["kind"], "periodic", "{answer}");
            let ours = answer["drift"][0].as_f64().unwrap();
            compared("system steady drift", ours, drift * LENGTH, Origin::ByHand, 1e-11 * (alpha * LENGTH));
            let work = (r * there - s * back) * LENGTH;
            for ours in [&answer["elements"][0]["work"], &answer["load_work"]] {
                let ours = ours.as_f64().unwrap();
                compared("system steady load_work", ours, work, Origin::ByHand, 1e-11 * work);
            }
            // The motion from rest goes there: its last forward slide is that of the limit.
            let rows = rows_of(&format!(
                "simulate --no-spring --mass 2 --frequency 3 --force {} {options} --cycles 60",
                4.0 * alpha
            ));
            let slide =
                rows.iter().rfind(|row| row["kind"] == "slide-forward" && row["ends_by"] == "reversal");
            let slide = slide.expect("a slide");
            let of = |name: &str| number(slide, name);
            compared(
                "simulate start_phase",
                (of("start_phase") - start + PI).rem_euclid(TAU) - PI,
                0.0,
                Origin::ByHand,
                1e-10,
            );
            let way = of("end_displacement") - of("start_displacement");
            compared("simulate end_displacement", way, there * LENGTH, Origin::ByHand, 1e-10 * alpha);
            let speed = answer["mean_velocity"][0].as_f64().unwrap();
            compared(
                "system steady mean_velocity",
                speed,
                drift * LENGTH * 3.0 / TAU,
                Origin::ByHand,
                1e-11 * alpha,
            );
        }
    }
    let text = stdout(
        "steady --no-spring --mass 300kg --friction 400N --mean-force 50N --force 700N --frequency 25Hz",
    );
    assert!(text.contains("drifts by"), "{text}");
}

/// The lines of a motion.
fn rows_of(line: &str) -> Vec<Value> {
    let text = stdout(&format!("{line} --format jsonl"));
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// A drift has the rows of any other motion: those of a force that is hardly there are those without it. A sample has the friction of its
/// direction, and the acceleration that the forces give.
#[test]
fn a_motion_that_drifts_is_followed() {
    let near = |a: &Value, b: &Value| match (a.as_f64(), b.as_f64()) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-9,
        _ => a == b,
    };
    for (start, phase) in [("", ""), (" --x0 0.3 --v0=-1.1", " --phase 200deg")] {
        for samples in ["", " --samples 7", " --samples 4"] {
            let line =
                format!("simulate {MACHINE} --force 13 --static-ratio 1.2 --cycles 5{start}{phase}{samples}");
            let (plain, drifting) = (rows_of(&line), rows_of(&format!("{line} --mean-force 1e-11")));
            // The last segment of the one ends with the time, that of the other with itself.
            let count = if samples.is_empty() { plain.len() - 1 } else { plain.len() };
            assert_eq!(plain.len(), drifting.len(), "{line}");
            assert!(count > 8, "{line}");
            for (a, b) in plain.iter().zip(&drifting).take(count) {
                let (one, other) = (a.as_object().unwrap(), b.as_object().unwrap());
                assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
                for (name, value) in one {
                    let same = match value.as_object() {
                        Some(all) => all.iter().all(|(key, value)| near(value, &other[name][key])),
                        None => near(value, &other[name]),
                    };
                    assert!(same, "{line} {name}: {a} {b}");
                }
            }
        }
    }
    let rows = rows_of(
        "simulate --no-spring --mass 2 --friction 4 --friction-backward 5 --mean-force 0.5 --frequency 3 --force 12 --cycles 3 --samples 20",
    );
    let mut directions = [0; 3];
    for row in &rows {
        let of = |name: &str| number(row, name);
        let (time, velocity, friction) = (of("time"), of("velocity"), of("friction_force"));
        let load = 12.0 * (3.0 * time).sin() + 0.5;
        let due = if velocity > 0.0 {
            4.0
        } else if velocity < 0.0 {
            -5.0
        } else {
            load
        };
        compared("simulate --samples friction_force", friction, due, Origin::ByHand, 1e-12);
        compared(
            "simulate --samples acceleration",
            of("acceleration"),
            (load - due) / 2.0,
            Origin::ByHand,
            1e-12,
        );
        directions[if velocity > 0.0 {
            0
        } else if velocity < 0.0 {
            1
        } else {
            2
        }] += 1;
    }
    assert!(directions.iter().all(|count| *count > 0), "{directions:?}");
    refused(
        "simulate --no-spring --mass 2 --friction 4 --frequency 3 --force 12 --mean-force 1 --cycles 100000000",
        &["--cycles 100000000: must be ≤"],
    );
    refused(
        &format!("simulate {MACHINE} --force 12 --mean-force 1 --cycles 60000 --samples 100"),
        &["--cycles 60000: about 6.0e6 samples, must be ≤ 1e6"],
    );
}

/// Inverse questions lead back: the force that they name has the amplitude, or the threshold, that was asked for.
#[test]
fn design_leads_back() {
    let force = json(&format!("design force {MACHINE} --format json"));
    compared(
        "design force force",
        number(&force, "force"),
        4.0 * f64::hypot(1.0, PI / 2.0),
        Origin::ByHand,
        1e-13,
    );
    assert!(force["foot_displacement"].is_null(), "{force}");
    let forces = json(&format!("design force {MACHINE} --no-stop --format json"));
    assert!(forces["foot_displacement"].is_null() && forces["base_displacement"].is_number(), "{forces}");
    let friction = json("design friction --no-spring --mass 2 --frequency 3 --force 12 --format json");
    compared(
        "design friction friction",
        number(&friction, "friction"),
        12.0 / f64::hypot(1.0, PI / 2.0),
        Origin::ByHand,
        1e-13,
    );
    // The energy 4 r √(p² − r²π²/4)/(m ω²) is greatest at r = √2 p/π.
    let most = json("design dissipation --no-spring --mass 2 --frequency 3 --force 12 --format json");
    compared(
        "design dissipation friction",
        number(&most, "friction"),
        12.0 * 2f64.sqrt() / PI,
        Origin::ByHand,
        1e-6,
    );
    for (question, output) in [("displacement", "max_displacement"), ("velocity", "max_velocity")] {
        let found = json(&format!("design {question} {MACHINE} --target 0.9 --format json"));
        let back = json(&format!("response {MACHINE} --force {} --format json", number(&found, "force")));
        assert!((number(&back, output) - 0.9).abs() < 1e-12, "{found} {back}");
    }
    let held = json("design hold --no-spring --mass 2 --friction 4 --base-displacement 0.5 --format json");
    // m u ω² = r_y
    compared("design hold holding_frequency", number(&held, "holding_frequency"), 2.0, Origin::ByHand, 1e-14);
    let band = json(
        "design friction --no-spring --mass 2 --over 2:6 --of displacement --base-acceleration 3 --format json",
    );
    assert_eq!(band["optimum"], "rest", "{band}");
}

/// A crate on a truck that brakes with 3 m/s² needs µ = 3/9.80665; a machine at rest needs the force on it.
#[test]
fn the_least_friction_that_holds() {
    let near = |line: &str, name: &str, other: f64| {
        let found = json(&format!("design hold {line} --quiet --format json"));
        compared(&format!("design hold {name}"), number(&found, name), other, Origin::ByHand, 1e-14 * other);
    };
    near("--no-spring --base-acceleration 3m/s^2", "static_friction_coefficient", 3.0 / 9.80665);
    near("--no-spring --mass 2 --unbalance 0.1 --frequency 5", "static_friction", 2.5);
    near("--mass 2 --stiffness 7 --foot-displacement 0.1", "static_friction", 0.7);
    refused("design hold --mass 2 --unbalance 0.1", &["--frequency is missing"]);
    refused(
        "design hold --mass 2 --stiffness 8 --friction 4 --force 1 --frequency 2",
        &["--frequency 2: must be left out beside a friction"],
    );
}

#[test]
fn a_stiffness_of_zero_is_the_same_and_a_soft_spring_is_near() {
    let drive = "--mass 2 --friction 4 --frequency 3 --force 12 --format json";
    let one = json(&format!("response --no-spring {drive}"));
    assert_eq!(one, json(&format!("response --stiffness 0 {drive}")));
    // The spring's force is k/(m ω_d²) of the inertia.
    let soft = json(&format!("response --stiffness 1e-6 {drive}"));
    let (hard, soft) = (number(&one, "max_displacement"), number(&soft, "max_displacement"));
    assert!((hard - soft).abs() < 1e-7 * hard && hard != soft, "{hard} {soft}");
    let rows =
        stdout("sweep response --no-spring --mass 2 --friction 4 --frequency 3:30:4 --force 12 --format csv");
    assert_eq!(rows.lines().count(), 5, "{rows}");
    // The stiffness that stands for none has its rounding.
    for line in [
        "steady --no-spring --mass 94kg --frequency 13Hz --units N,mm --friction 1N --force 3N",
        "sweep steady --no-spring --mass 7kg --friction 4N --force 5N --frequency 1Hz:5Hz:40 --format csv",
    ] {
        assert!(!stdout(line).is_empty(), "{line}");
    }
    let motion = stdout(&format!("simulate {MACHINE} --force 12 --cycles 3 --format csv"));
    assert!(motion.lines().count() > 5, "{motion}");
}

#[test]
fn what_needs_a_spring_is_refused() {
    for (line, words) in [
        (
            "response --no-spring --mass 2 --friction 4 --frequency 3 --force 12 --period 1",
            "--period 1: must be left out with --no-spring",
        ),
        (
            "response --no-spring --mass 2 --friction 4 --frequency 3 --force 12 --damping-ratio 0.1",
            "--damping-ratio 0.1: must be left out without a spring",
        ),
        (
            "response --no-spring --mass 2 --friction 4 --frequency 3 --foot-displacement 1",
            "--foot-displacement 1: must be left out without a spring",
        ),
        (
            "response --no-spring --mass 2 --friction 4 --frequency 3 --force 12 --mean-force 1",
            "--mean-force 1: must be left out without a spring, because the body drifts",
        ),
        (
            "response --no-spring --mass 2 --friction 0 --frequency 3 --force 12",
            "--friction 0: must be > 0 without a spring",
        ),
        ("response --no-spring --mass 2 --friction 4 --force 12 --omega 2", "stiffness k = 0 must be > 0"),
        (
            "attractors --no-spring --mass 2 --friction 4 --frequency 3 --force 12 --static-ratio 1.2",
            "--no-spring: every start has one limit, but for its place",
        ),
        (
            "steady --no-spring --mass 1 --friction 3 --friction-backward=-1 --force 10 --frequency 1",
            "backward friction r₋ = -1 must be > 0",
        ),
        ("pull --no-spring --mass 2 --friction 4 --speed 1", "stiffness k = 0 must be > 0"),
    ] {
        refused(line, &[words]);
    }
}

/// The range of the displacements and the greatest velocity of small steps after a long time.
fn stepped(damping: f64, peak: f64, acceleration: f64, friction: f64) -> Stepped {
    let pair = Pair {
        mass: [2.0, 1.0],
        spring: [0.0; 2],
        damper: [damping, 0.0],
        friction,
        peak,
        force: [0.0, 1.0, 0.0],
        base: [acceleration, 3.0],
    };
    let mut motion = Stepped::new(pair, 0.0, [0.0; 4]);
    motion.follow(60.0 * TAU / 3.0, 60 * 256);
    let mut motion = Stepped::new(pair, motion.time, [motion.state[0], 0.0, motion.state[2], 0.0]);
    motion.follow(TAU / 3.0, 4096);
    motion
}

/// Fails where two numbers differ by more than a bound.
#[track_caller]
fn agree(ours: f64, other: f64, bound: f64) {
    assert!((ours - other).abs() <= bound, "{ours} for {other}, beyond {bound:e}");
}

/// Every start has one limit, but for its place: with a static friction above the kinetic one, too, where bodies on springs have several.
/// The questions about several limits say so, with the name of the option that was typed.
#[test]
fn a_start_has_one_limit() {
    let mut random = Random(7_511_290);
    for _ in 0..12 {
        let peak = random.between(1.0, 2.5);
        let (alpha, damping) = (random.between(1.05 * peak, 1.05 * peak + 2.5), 3.0 * random.next());
        let machine = format!(
            "steady {MACHINE} --force {} --damping {damping} --static-ratio {peak} --format json",
            4.0 * alpha
        );
        let first = json(&machine);
        for _ in 0..4 {
            let start = [random.between(-9.0, 9.0), random.between(-4.0, 4.0)];
            let other = json(&format!("{machine} --x0={} --v0={}", start[0], start[1]));
            for name in ["max_displacement", "min_displacement", "max_velocity", "min_velocity"] {
                let [a, b] = [&first, &other].map(|answer| number(answer, name));
                assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{machine} from {start:?}: {name} {a} {b}");
            }
            assert_eq!(first["sticks_per_cycle"], other["sticks_per_cycle"], "{machine} from {start:?}");
        }
    }
    for command in ["attractors", "basins"] {
        for (spring, named) in [("--no-spring", "--no-spring"), ("--stiffness 0", "--stiffness 0")] {
            refused(
                &format!("{command} {spring} --mass 2 --friction 4 --force 9 --frequency 3"),
                &[&format!("{named}: every start has one limit"), "`stickslip steady` answers"],
            );
        }
    }
    refused(
        "response --no-spring --mass 2 --friction 0 --force 9 --frequency 3",
        &["--friction 0: must be > 0"],
    );
    refused(
        "steady --no-spring --mass 2 --friction 4 --force 9 --omega 3 --frequency 2",
        &["--omega, --frequency and"],
    );
    refused(
        "steady --no-spring --stiffness 0 --mass 2",
        &["--stiffness 0: must be left out with --no-spring"],
    );
}

/// Friction and damper from a response curve by small steps, of which the lower half stops in each cycle, and from one by its formula.
#[test]
fn friction_and_damping_follow_from_a_curve() {
    let folder = crate::place::place("springless_curve");
    std::fs::create_dir(&*folder).unwrap();
    let file = |name: &str, rows: &[(f64, f64)]| {
        let rows: String = rows.iter().map(|(w, a)| format!("{w},{a}\n")).collect();
        let path = folder.join(name);
        std::fs::write(&path, format!("frequency[rad/s],amplitude[m]\n{rows}")).unwrap();
        path.display().to_string()
    };
    // At ω_d = 3 s, times are those of ω_d = 3 over s, lengths over s², and a damper c is c/s.
    let scales = [1.0, 1.3, 1.7, 2.2, 2.9, 3.7, 4.6, 6.0];
    let rows: Vec<_> = scales
        .iter()
        .map(|s| {
            let [most, least] = stepped(2.5 / s, 1.0, 3.4, 4.0).extremes[0];
            (3.0 * s, (most - least) / 2.0 / (s * s))
        })
        .collect();
    let name = file("steps.csv", &rows);
    let found = json(&format!(
        "identify {name} --units N,m --no-spring --mass 2 --base-acceleration 3.4 --format json"
    ));
    assert!(found["stops"].as_array().unwrap().iter().any(|stops| stops == true), "{found}");
    assert!(found["damping_ratio"].is_null(), "{found}");
    let value = |name: &str| found[name]["value"].as_f64().unwrap();
    agree(value("friction"), 4.0, 1e-5);
    agree(value("damping"), 2.5, 1e-4);
    let formula = |w: f64| (81.0 - (3.0 * PI / 2.0).powi(2)).sqrt() / (2.0 * w * w);
    let rows: Vec<_> = (3..15).map(|i| f64::from(i) * 1.5).map(|w| (w, formula(w))).collect();
    let name = file("formula.csv", &rows);
    let found = json(&format!("identify {name} --units N,m --no-spring --mass 2 --force 9 --format json"));
    agree(found["friction"]["value"].as_f64().unwrap(), 3.0, 1e-7);
    assert!(found["damping"]["value"].as_f64().unwrap() < 1e-6, "{found}");
    refused(&format!("identify {name} --units N,m --no-spring --mass 2"), &["--no-spring: needs the drive"]);
    for option in ["--decay", "--motion"] {
        let line = format!("identify {name} --no-spring --mass 2 {option}");
        refused(&line, &[&format!("--no-spring: must be left out with {option}")]);
    }
}

/// The search for stops tried one at a distance that only a spring holds: the body crept back for longer than phases have digits.
#[test]
fn no_search_begins_where_a_spring_would_hold() {
    // m = r_y = ω_d = 1 in lengths of r_y/(m ω_d²): x Ω² of the answer.
    for (omega, alpha, zeta) in [
        (268_435_456.0, 1.917_098_163_664_791_5, 8_552_963.642_568_92),
        (536_870_912.0_f64, 1.676_724_514_629_020_8, 47_485_480.988_489_754),
    ] {
        let damping = 2.0 * zeta / omega;
        let line =
            format!("steady --omega {omega} --alpha {alpha} --damping-ratio {zeta} --quiet --format json");
        let answer = json(&line);
        // The same machine with m = 2, r_y = 4, ω_d = 3.
        let motion = stepped(6.0 * damping, 1.0, 2.0 * alpha, 4.0);
        let [most, least] = motion.extremes[0];
        let ours = 2.0 * number(&answer, "max_displacement") * omega * omega * LENGTH;
        agree(ours, most - least, 1e-8);
        let share = motion.rest * 3.0 / TAU;
        agree(number(&answer, "stick_fraction"), share, 1e-7);
    }
    for (mass, force, frequency, damping) in [
        (3.491_337_221_191_711_3, 39.044_403_569_580_4, 0.256_611_556_556_549_27, 0.057_091_933_659_207_63),
        (0.331_491_822_534_843_66, 626.439_294_903_244_4, 1.178_813_625_336_375_2, 0.058_788_708_430_704_35),
        (2.512_931_241_927_305_8, 56.669_297_309_116_77, 33.778_375_683_849_376, 17.284_851_365_123_824),
    ] {
        let found = json(&format!(
            "design dissipation --sticking --no-spring --mass {mass} --force {force} --frequency {frequency} --damping {damping} \
             --format json"
        ));
        // The same machine with m = 2, ω_d = 3 and the amplitude 9 of the force.
        let (friction, energy) = (number(&found, "friction") / force * 9.0, number(&found, "energy"));
        let unit = force * force / (mass * frequency * frequency) / (81.0 / 18.0);
        let of = |share: f64| {
            stepped(damping / (mass * frequency) * 6.0, 1.0, 4.5, friction * share).state[6] * unit
        };
        agree(energy, of(1.0), 1e-6 * energy);
        assert!(of(1.02) < energy && of(0.98) < energy, "{found}");
    }
}
