//! Static friction above the kinetic one, and `stickslip attractors`, from the user's side.

use crate::command_line::{json, refused, stdout};
use crate::place::place;

const PAIR: &str = "--omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3";

#[test]
fn a_long_run_says_that_it_is_of_its_start() {
    let answer = json(&format!("steady {PAIR} --format json"));
    let number = |name: &str| answer[name].as_f64().unwrap_or_else(|| panic!("{name}: {answer}"));
    let (most, least) = (number("max_displacement"), number("min_displacement"));
    assert!((most - least - 10.548_676).abs() < 2e-6 && (most + least).abs() > 0.1, "{answer}");
    assert_eq!((number("static_friction_ratio"), number("turns_per_cycle")), (1.3, 1.0));
    assert_eq!((answer["symmetric"].as_bool(), answer["limit"].as_str()), (Some(false), Some("periodic")));
    let text = stdout(&format!("steady {PAIR}"));
    assert!(text.contains("The limit of this start") && !text.contains("every start"), "{text}");
    let rest = json("steady --omega 0.8 --alpha 1.2 --static-friction-ratio 1.3 --format json");
    assert_eq!((rest["limit"].as_str(), rest["rest_position"].as_f64()), (Some("rest"), Some(0.0)));
}

#[test]
fn a_machine_has_it_as_a_force() {
    let machine = "--mass 2 --stiffness 8 --friction 4 --force 16 --frequency 1 --damping-ratio 0.02";
    let by_force = json(&format!("steady {machine} --static-friction 5.2 --format json"));
    let by_ratio = json(&format!("steady {machine} --static-friction-ratio 1.3 --format json"));
    let ratios = json(&format!("steady {PAIR} --format json"));
    let most = |answer: &serde_json::Value| answer["max_displacement"].as_f64().unwrap();
    assert!((most(&by_force) - most(&ratios)).abs() < 1e-9 && (most(&by_ratio) - most(&ratios)).abs() < 1e-9);
    assert_eq!(by_force["physical"]["static_friction"].as_f64(), Some(5.2));
    refused(
        &format!("steady {machine} --static-friction 3"),
        &["--static-friction 3", "static friction ratio η = 0.75 must be ≥ 1"],
    );
    refused(
        &format!("steady {machine} --static-friction 5 --static-friction-ratio 1.2"),
        &["--static-friction-ratio and --static-friction"],
    );
}

#[test]
fn border_response_and_design_know_it() {
    // α_min = hypot(K, (1 − Ω²) η/Ω²), K = (1 − Ω²) tan(π/2Ω)/Ω.
    let (omega, eta) = (0.8f64, 1.3f64);
    let k = (1.0 - omega * omega) * (std::f64::consts::FRAC_PI_2 / omega).tan() / omega;
    let least = k.hypot((1.0 - omega * omega) * eta / (omega * omega));
    let ratios = "--omega 0.8 --static-friction-ratio 1.3 --format json";
    let close = |found: &serde_json::Value| (found.as_f64().unwrap() / least - 1.0).abs() < 1e-14;
    assert!(close(&json(&format!("border {ratios}"))["min_force_ratio"]));
    assert!(close(&json(&format!("design force {ratios}"))["force_ratio"]));
    let response = json(&format!("response --alpha 2 {ratios}"));
    assert!(close(&response["min_force_ratio"]));
    assert_eq!(response["static_friction_ratio"].as_f64(), Some(1.3));
    let text = stdout("response --omega 0.8 --alpha 2 --static-friction-ratio 1.3");
    assert!(text.starts_with("Depends on the start: a body at rest is released"), "{text}");
    let decay = json("decay --x0 2.2 --static-friction-ratio 2.5 --format json");
    assert_eq!((decay["half_cycles"].as_u64(), decay["rest_position"].as_f64()), (Some(0), Some(2.2)));
}

/// At Ω = 1.036 and η = 2.07 the cycle without a stop exists from 1.302564 r_y on, and from rest nothing moves up to
/// 2.07 r_y.
#[test]
fn design_keeps_rest_the_cycle_and_every_start_apart() {
    let ratios = "--omega 1.036 --static-friction-ratio 2.07";
    let machine = "--mass 50 --stiffness 1000 --frequency 4.4 --static-friction-ratio 2.07";
    for question in [
        format!("force {ratios}"),
        format!("friction {ratios}"),
        format!("force {ratios} --damping-ratio 0.02"),
        format!("force {machine} --friction 5"),
        format!("friction {machine} --force 600 --damping-ratio 0.02"),
    ] {
        let text = stdout(&format!("design {question}"));
        let has = |words: &str| text.contains(words);
        assert!(!has("never sticks") && has("A body at rest is released"), "{text}");
        assert!(has("A motion without a stop exists and attracts its neighbourhood"), "{text}");
        assert_eq!(has("Every start leads"), question.contains("damping-ratio"), "{text}");
    }
    let number = |found: &serde_json::Value, name: &str| found[name].as_f64().unwrap_or(f64::NAN);
    let found = json(&format!("design force {ratios} --format json"));
    assert_eq!(number(&found, "release_force_ratio"), 2.07);
    assert!((number(&found, "force_ratio") - 1.302_564).abs() < 1e-6, "{found}");
    assert!(found.get("every_start_force_ratio").is_none(), "{found}");
    let found = json(&format!("design force {ratios} --damping-ratio 0.02 --format json"));
    assert!(number(&found, "every_start_force_ratio") > 2.07, "{found}");
    let by_force = json(&format!("design force {machine} --friction 5 --format json"));
    let released = number(&by_force, "release_force");
    assert!((released - 5.0 * 2.07).abs() < 1e-12, "{by_force}");
    let by_friction = json(&format!("design friction {machine} --force {released} --format json"));
    assert!((number(&by_friction, "release_friction") - 5.0).abs() < 1e-12, "{by_friction}");
    // With one friction every start leads to the cycle.
    for question in ["force --omega 1.036", "friction --omega 1.036 --static-friction-ratio 1"] {
        assert!(stdout(&format!("design {question}")).contains("never sticks"), "{question}");
    }
}

/// Machines, their regime, whether a motion without a stop exists, whether a body at rest is released, and the regime
/// from rest.
const STATEMENTS: [(&str, &str, bool, bool, &str); 6] = [
    ("--omega 1.036 --alpha 1.31 --static-friction-ratio 2.07", "depends-on-start", true, false, "stuck"),
    ("--omega 1.036 --alpha 2.06 --static-friction-ratio 2.07", "depends-on-start", true, false, "stuck"),
    ("--omega 0.5 --alpha 1.2 --static-friction-ratio 1.3", "depends-on-start", false, false, "stuck"),
    ("--omega 0.5 --alpha 2 --static-friction-ratio 1.3", "sticking", false, true, "sticking"),
    (
        "--omega 0.331 --alpha 100 --static-friction-ratio 1.01 --damping-ratio 0.0005",
        "depends-on-start",
        true,
        true,
        "non-sticking",
    ),
    (
        "--omega 1 --alpha 4 --static-friction-ratio 1.5 --damping-ratio 0.1",
        "non-sticking",
        true,
        true,
        "non-sticking",
    ),
];

/// The regime is that of every start; whether a motion without a stop exists and what a body at rest does are
/// said for themselves, in every format.
#[test]
fn response_and_maps_say_what_steady_does() {
    for (ratios, regime, without_stop, moves, from_rest) in STATEMENTS {
        let found = json(&format!("response {ratios} --format json"));
        assert_eq!(found["regime"], regime, "{found}");
        assert_eq!(
            (&found["motion_without_stop"], &found["moves_from_rest"]),
            (&without_stop.into(), &moves.into())
        );
        let steady = json(&format!("steady {ratios} --format json"));
        assert_eq!(steady["regime"], from_rest, "{steady}");
        let text = stdout(&format!("response {ratios}"));
        assert!(!text.contains("stops in each cycle") && text.contains("releases a body at rest"), "{text}");
        let rows = stdout(&format!("sweep response {ratios} --format csv --outputs regime,moves_from_rest"));
        assert_eq!(rows.lines().nth(1), Some(format!("{regime},{moves}").as_str()), "{rows}");
    }
    // Where the map of the regime names what every start does, the map of the stops has it from rest.
    let plane = "--omega 0.3,0.55,1.036 --alpha 0.9,1.31,2.06,2.5,6 --static-friction-ratio 2.07";
    let last = |rows: String| -> Vec<String> {
        rows.lines().skip(1).map(|row| row.rsplit(',').next().unwrap().to_owned()).collect()
    };
    let [regimes, stops] =
        ["regime", "stops"].map(|quantity| last(stdout(&format!("map {quantity} {plane}"))));
    assert_eq!(regimes.len(), 15);
    for (regime, stops) in regimes.iter().zip(&stops) {
        match regime.as_str() {
            "stuck" => assert_eq!(stops, ""),
            "sticking" => assert!(stops.parse::<u32>().is_ok_and(|stops| stops > 0), "{stops}"),
            "depends-on-start" => {}
            other => panic!("{other}"),
        }
    }
    assert!(
        regimes.iter().zip(&stops).any(|(regime, stops)| regime == "depends-on-start" && stops.is_empty())
    );
}

#[cfg(feature = "mp")]
#[test]
fn an_enclosed_response_says_what_the_response_does() {
    for (ratios, regime, _, moves, _) in STATEMENTS {
        let found = json(&format!("response {ratios} --format json"));
        let enclosed = stdout(&format!("response {ratios} --enclose"));
        let rest = if moves { "A body at rest is released" } else { "A body at rest at x = 0 stays" };
        assert!(enclosed.contains(rest), "{enclosed}");
        let enclosed = json(&format!("response {ratios} --enclose --format json"));
        let below = enclosed["regime"] == "below the border";
        assert!(below || enclosed["regime"] == regime, "{enclosed}");
        assert_eq!(
            (below, &enclosed["moves_from_rest"]),
            (found["max_displacement"].is_null(), &moves.into())
        );
    }
}

#[test]
fn what_does_not_know_it_refuses_it() {
    refused("border --omega 0.8 --static-friction-ratio 1.3 --no-stop", &["η = 1.3 must be 1 here"]);
    refused("design bands --alpha 3 --from 0.1 --to 2 --static-friction-ratio 1.3", &["does not use it"]);
    refused("steady --omega 0.8 --alpha 2 --static-friction-ratio 0.9", &["η = 0.9 must be ≥ 1"]);
    refused(
        "steady --omega 0.8 --alpha 2 --static-friction-ratio nan",
        &["--static-friction-ratio nan: must be a finite number, and is NaN"],
    );
    refused("attractors --omega 0.8 --alpha 2 --starts 0", &["--starts 0"]);
    refused("attractors --omega 0.8 --alpha 2 --reach -1", &["--reach -1: must be > 0"]);
}

#[test]
fn attractors_are_found_whatever_the_number_of_threads() {
    let line = format!("attractors {PAIR} --starts 60 --format json");
    let found = |threads: &str| {
        let mut command = crate::command_line::stickslip(&line);
        let output = command.env("RAYON_NUM_THREADS", threads).assert().success().get_output().stdout.clone();
        String::from_utf8(output).unwrap()
    };
    let one = found("1");
    assert!(one == found("2") && one == found("5"), "{one}");
    let answer: serde_json::Value = serde_json::from_str(&one).unwrap();
    let limits = answer["attractors"].as_array().unwrap();
    assert_eq!((limits.len(), answer["unsettled"].as_u64()), (2, Some(0)), "{answer}");
    let starts: u64 = limits.iter().map(|limit| limit["starts"].as_u64().unwrap()).sum();
    assert_eq!(starts, 60);
    for (limit, other) in [(&limits[0], 2), (&limits[1], 1)] {
        assert_eq!((limit["mirror"].as_u64(), limit["symmetric"].as_bool()), (Some(other), Some(false)));
        assert_eq!(limit["sticks_per_cycle"].as_u64(), Some(1));
    }
    let rows = stdout(&format!("attractors {PAIR} --starts 60 --format csv"));
    assert_eq!(rows.lines().count(), 3, "{rows}");
    assert!(rows.starts_with("attractor,limit,share,starts,first_x,first_v,mirror,"), "{rows}");
    let text = stdout(&format!("attractors {PAIR} --starts 60"));
    assert!(text.contains("2 limits from 60 starts") && text.contains("the mirror image of 1"), "{text}");
}

/// The symmetric motion between the mirror pair is unstable: no start leads to it.
#[test]
fn motions_that_no_start_leads_to() {
    let line = format!("attractors {PAIR} --starts 40 --unstable 2");
    let answer = json(&format!("{line} --format json"));
    assert_eq!(answer["attractors"].as_array().unwrap().len(), 2, "{answer}");
    let others = answer["other_motions"].as_array().unwrap();
    assert_eq!(others.len(), 1, "{answer}");
    let other = &others[0];
    assert_eq!((other["attractor"].as_u64(), other["starts"].as_u64()), (Some(3), Some(0)), "{answer}");
    assert_eq!((other["limit"].as_str(), other["symmetric"].as_bool()), (Some("unstable"), Some(true)));
    assert!((other["max_displacement"].as_f64().unwrap() - 5.271_292_025).abs() < 1e-8, "{answer}");
    let multiplier = other["multipliers"][0][0].as_f64().unwrap();
    assert!((multiplier - 1.192_208_330_88).abs() < 1e-9, "{answer}");
    let rows = stdout(&format!("{line} --format csv"));
    assert!(rows.lines().count() == 4 && rows.contains("\n3,unstable,0.0,0,,,"), "{rows}");
    let text = stdout(&line);
    assert!(text.contains("3. Symmetric, a cycle of one turn of the drive, unstable"), "{text}");
    // The multipliers are real.
    assert!(text.contains("  greatest multiplier      1.192208 in a cycle"), "{text}");
    assert!(json(&format!("attractors {PAIR} --starts 40 --format json"))["other_motions"].is_null());
    // An unstable pair, whose numbers continue those of the limits.
    let three = "--omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87";
    let answer = json(&format!("attractors {three} --starts 60 --unstable 1 --format json"));
    let mirrors: Vec<_> =
        answer["other_motions"].as_array().unwrap().iter().map(|m| m["mirror"].as_u64()).collect();
    assert_eq!(mirrors, [Some(5), Some(4)], "{answer}");
    let one = stdout("attractors --omega 0.8 --alpha 2.5 --starts 20 --unstable 1");
    assert!(one.contains("No periodic motion of one turn that no start leads to"), "{one}");
    refused(&format!("attractors {PAIR} --unstable 0"), &["--unstable", "0"]);
    refused(&format!("attractors {PAIR} --unstable 65"), &["--unstable", "65"]);
}

/// Each start of the plane has the limit that `attractors` and `steady` report, in ratios and in units.
#[test]
fn basins_name_the_limit_of_each_start() {
    let grid = "--x0 -6:6:5 --v0 -4:4:3";
    let rows = stdout(&format!("basins {PAIR} {grid}"));
    let rows: Vec<Vec<&str>> = rows.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], ["x0[B]", "v0[B ω_d]", "attractor", "limit"]);
    assert_eq!(rows.len(), 16);
    let mut seen = std::collections::BTreeMap::new();
    for row in &rows[1..] {
        let steady = json(&format!("steady {PAIR} --x0 {} --v0 {} --format json", row[0], row[1]));
        let most = steady["max_displacement"].as_f64().unwrap();
        let known = *seen.entry(row[2]).or_insert(most);
        assert!((known - most).abs() < 1e-6, "{row:?} {known} {most}");
    }
    let most: Vec<f64> = seen.into_values().collect();
    assert!(most.len() == 2 && (most[0] - most[1]).abs() > 0.1, "{most:?}");
    // With B = 5 mm and ω_d = 5 rad/s the starts are the same, limit by limit.
    let machine = "--mass 10 --stiffness 1000 --friction 5 --frequency 5 --force 20 --damping-ratio 0.02";
    let grid = "--x0=-0.03:0.03:5 --v0=-0.1:0.1:3";
    let physical = stdout(&format!("basins {machine} --static-friction-ratio 1.3 {grid}"));
    for (line, row) in physical.lines().zip(&rows) {
        let line: Vec<&str> = line.split(',').collect();
        assert_eq!(line[2..], row[2..], "{line:?}");
    }
    assert!(physical.starts_with("x0[m],v0[m/s],"), "{physical}");
}

/// Without a grid the starts reach equally far to both sides, around every limit, in ratios and in units.
#[test]
fn basins_reach_around_every_limit() {
    let column = |line: &str, place: usize| -> Vec<f64> {
        stdout(line).lines().skip(1).map(|row| row.split(',').nth(place).unwrap().parse().unwrap()).collect()
    };
    let most = json(&format!("steady {PAIR} --format json"))["max_displacement"].as_f64().unwrap();
    let machine = "--mass 10 --stiffness 1000 --friction 5 --frequency 5 --force 20 --damping-ratio 0.02";
    let machine = format!("{machine} --static-friction-ratio 1.3");
    for (place, other) in [(0, "--v0 0"), (1, "--x0 0")] {
        let starts = column(&format!("basins {PAIR} {other}"), place);
        let last = starts[starts.len() - 1];
        assert!(starts.len() == 101 && starts[0] == -last && last > most, "{starts:?}");
        assert!(starts.is_sorted());
        // B = 5 mm, B ω_d = 25 mm/s.
        let scale = [0.005, 0.025][place];
        for (a, b) in column(&format!("basins {machine} {other}"), place).iter().zip(starts) {
            assert!((a - scale * b).abs() < 1e-12, "{a} {b}");
        }
    }
}

#[test]
fn basins_are_drawn() {
    let file = place("basins-of-a-pair.svg");
    let other = place("descending.svg");
    let line = format!("basins {PAIR} --x0 -6:6:21 --v0 -4:4:11 --out {}", file.display());
    assert_eq!(stdout(&line), "");
    let svg = std::fs::read_to_string(&file).unwrap();
    for text in ["1: periodic, x from", "2: periodic, x from", "displacement at the start (B)"] {
        assert!(svg.contains(text), "{text}: {svg}");
    }
    refused(&format!("basins {PAIR} --x0 -6:6:2000 --v0 -4:4:2000"), &["--x0, --v0: 4000000 starts"]);
    refused(&format!("basins {PAIR} --x0 1e80,2e80 --v0 0,1"), &["--x0"]);
    refused(&format!("basins {PAIR} --x0 3,1 --v0 0,1 --out {}", other.display()), &["ascending"]);
}

/// The picture of the limits contains the line on which symmetry breaks.
#[test]
fn a_map_of_limits_has_the_line_of_symmetry() {
    let file = place("limits-and-line.svg");
    let grid = "--omega 0.45:0.6:4 --alpha 2.5:4.5:4 --damping-ratio 0.02 --static-friction-ratio";
    stdout(&format!("map limits {grid} 1.3 --out {}", file.display()));
    let line = "symmetry breaks at a multiplier of −1";
    assert!(std::fs::read_to_string(&file).unwrap().contains(line));
    stdout(&format!("map limits {grid} 1 --out {} --overwrite", file.display()));
    assert!(!std::fs::read_to_string(&file).unwrap().contains(line));
}

/// A short text for the limits of some starts at each point: the six machines, and a single limit with η = 1.
#[test]
fn a_map_of_limits() {
    for (ratios, expected) in [
        ("--omega 0.5,0.8 --alpha 4,5 --damping-ratio 0.02 --static-friction-ratio 1.3", "a mirror pair"),
        ("--omega 0.573,0.8 --alpha 3.92,5 --damping-ratio 0.005 --static-friction-ratio 1.87", "several"),
        (
            "--omega 0.45,0.8 --alpha 8.5,9 --damping-ratio 0.02 --static-friction-ratio 3",
            "irregular among them",
        ),
        ("--omega 0.5,0.8 --alpha 4,5 --damping-ratio 0.02", "\"one, symmetric\""),
        ("--omega 0.5,0.8 --alpha 0.5,0.6 --damping-ratio 0.02", "rest"),
    ] {
        let rows = stdout(&format!("map limits {ratios}"));
        assert!(rows.starts_with("omega,alpha,limits\n"), "{rows}");
        let first = rows.lines().nth(1).unwrap();
        assert!(first.ends_with(&format!(",{expected}")), "{ratios}: {first}");
    }
}

/// One float above the static friction, or above 1, every command finds the motion; at that number, rest.
#[test]
fn every_command_tells_rest_from_motion_at_the_same_float() {
    for (eta, moving) in [(1.5f64, "periodic"), (1.0, "periodic")] {
        for steps in [0u32, 1, 2, 5, 9, 20, 450] {
            let alpha = (0..steps).fold(eta, |alpha, _| alpha.next_up());
            let machine = format!("--omega 0.6 --alpha {alpha:?} --static-friction-ratio {eta}");
            let moves = steps > 0;
            let limit = if moves { moving } else { "rest" };
            let steady = json(&format!("steady {machine} --format json"));
            assert_eq!(steady["limit"], limit, "steady {machine}");
            assert_eq!(steady["regime"], if moves { "sticking" } else { "stuck" }, "steady {machine}");
            let response = json(&format!("response {machine} --format json"));
            assert_eq!(response["moves_from_rest"], moves, "response {machine}");
            let attractors = json(&format!("attractors {machine} --starts 1 --format json"));
            assert_eq!(attractors["attractors"][0]["limit"], limit, "attractors {machine}");
            let simulated = stdout(&format!("simulate {machine} --cycles 2 --format csv"));
            assert_eq!(simulated.contains("slide-forward"), moves, "simulate {machine}: {simulated}");
            let grid =
                format!("--omega 0.6 --alpha {alpha:?}:{:?}:2 --static-friction-ratio {eta}", 2.0 * eta);
            let map = stdout(&format!("map steady:max_displacement {grid} --quiet"));
            let first: f64 = map.lines().nth(1).unwrap().rsplit(',').next().unwrap().parse().unwrap();
            assert_eq!(first > 0.0, moves, "map {grid}: {map}");
            assert_eq!(Some(first), steady["max_displacement"].as_f64(), "map {grid}: {map}");
        }
    }
}
