//! Systems beside two bodies by small steps.

use crate::command_line::{json, stdout};
use crate::compared::Origin::{ByHand, SmallSteps};
use crate::compared::{agreed, compared};
use crate::place::place;
use crate::random::Random;
use crate::stepped::{Pair, Stepped};
use serde_json::Value;
use std::f64::consts::TAU;

/// The error of 4,000 steps of the fourth order in a period, whose fastest vibration has some ten of its own: (10·2π/4000)⁴ for each radian.
const STEPS: u32 = 4000;
const BOUND: f64 = 3e-8;

fn drawn(random: &mut Random) -> Pair {
    let frequency = random.between(0.6, 1.2);
    Pair {
        mass: [1.0, random.between(0.4, 0.8)],
        spring: [random.between(2.0, 4.0), random.between(1.0, 3.0)],
        damper: [random.between(0.1, 0.3), random.between(0.1, 0.4)],
        friction: random.between(0.5, 1.2),
        peak: random.between(1.0, 1.4),
        force: [random.between(0.8, 1.6), frequency, random.between(0.0, 3.0)],
        base: [random.between(0.2, 0.8), 2.0 * frequency],
    }
}

fn described(pair: &Pair) -> String {
    let Pair { mass, spring, damper, friction, peak, force, base } = pair;
    let link = |between: &str, i: usize| {
        format!("[[springs]]\nbetween = {between}\nstiffness = {}\ndamping = {}\n", spring[i], damper[i])
    };
    format!(
        "masses = {{ a = {}, b = {} }}\n{}{}[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"a\"]\n\
         friction = {friction}\npeak = {peak}\n[[forces]]\non = \"b\"\namplitude = {}\nfrequency = {}\nphase = {}\n\
         [base]\nacceleration = {{ amplitude = {}, frequency = {} }}\n",
        mass[0],
        mass[1],
        link("[\"ground\", \"a\"]", 0),
        link("[\"a\", \"b\"]", 1),
        force[0],
        force[1],
        force[2],
        base[0],
        base[1],
    )
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The state at an end of an answer.
fn state(answer: &Value) -> [f64; 4] {
    let all = [numbers(&answer["displacement"]), numbers(&answer["velocity"])].concat();
    all.try_into().unwrap()
}

/// Follows a motion to its limit: the error of the coarse periods is forgotten in the others.
fn settle(found: &mut Stepped, period: f64) {
    (0..40).for_each(|_| found.follow(period, STEPS / 10));
    (0..20).for_each(|_| found.follow(period, STEPS));
}

/// Everything that a motion of a time has: extremes, events, rests and each work alone.
fn same_motion(of: &str, answer: &Value, found: &Stepped, begin: f64) {
    let near = |name: &str, ours: f64, other: f64| {
        compared(&format!("{of} {name}"), ours, other, SmallSteps, BOUND * (1.0 + other.abs()));
    };
    for (first, quantity) in [(0, "displacement"), (2, "velocity")] {
        for (which, name) in ["max", "min"].into_iter().enumerate() {
            let name = format!("{name}_{quantity}");
            for (body, &ours) in numbers(&answer[&name]).iter().enumerate() {
                near(&name, ours, found.extremes[first + body][which]);
            }
        }
    }
    for (body, &ours) in numbers(&answer["max_absolute_acceleration"]).iter().enumerate() {
        let [most, least] = found.extremes[4 + body];
        // A parabola of an acceleration between the steps.
        compared(
            &format!("{of} max_absolute_acceleration"),
            ours,
            most.max(-least),
            SmallSteps,
            1e-6 * (1.0 + ours),
        );
    }
    let element = &answer["elements"][0];
    near("load_work", number(&answer["load_work"]), found.state[4]);
    near("damper_work", number(&answer["damper_work"]), found.state[5]);
    near("elements", number(&element["work"]), found.state[6]);
    near("elements", number(&element["time_at_rest"]), found.rest);
    let stops = found.events.iter().filter(|(_, kind)| *kind == "stick").count();
    agreed(&format!("{of} elements"), element["stops"].as_u64(), Some(stops as u64), SmallSteps);
    let events = answer["events"].as_array().unwrap();
    let kinds: Vec<_> = events.iter().map(|event| event["kind"].as_str().unwrap()).collect();
    let due: Vec<_> = found.events.iter().map(|(_, kind)| *kind).collect();
    agreed(&format!("{of} events"), kinds, due, SmallSteps);
    for (event, (time, _)) in events.iter().zip(&found.events) {
        // A grazing end of a slide lies at the root of an error of its velocity.
        compared(&format!("{of} events"), number(&event["time"]), time - begin, SmallSteps, 1e-6);
    }
    agreed(&format!("{of} coordinates"), &answer["coordinates"], &serde_json::json!(["a", "b"]), ByHand);
}

/// The motion from rest, with its samples.
#[test]
fn motions_of_systems_are_those_of_small_steps() {
    let mut random = Random(91);
    for _ in 0..6 {
        let pair = drawn(&mut random);
        let file = place("pair.toml");
        std::fs::write(&file, described(&pair)).unwrap();
        let (line, until) = (format!("system {}", file.display()), 19.0);
        let answer = json(&format!("{line} simulate --until {until} --format json"));
        let mut found = Stepped::new(pair, 0.0, [0.0; 4]);
        let before = pair.energy(&found.state);
        found.follow(until, 3 * STEPS);
        let of = "system simulate";
        agreed(&format!("{of} kind"), answer["kind"].as_str(), Some("transient"), ByHand);
        compared(&format!("{of} duration"), number(&answer["duration"]), until, ByHand, 0.0);
        agreed(&format!("{of} start"), state(&answer["start"]), [0.0; 4], ByHand);
        for (ours, other) in state(&answer["end"]).into_iter().zip(found.state) {
            compared(
                &format!("{of} end by system::System::with_base"),
                ours,
                other,
                SmallSteps,
                BOUND * (1.0 + other.abs()),
            );
        }
        let stored = pair.energy(&found.state) - before;
        compared(
            &format!("{of} stored_energy"),
            number(&answer["stored_energy"]),
            stored,
            SmallSteps,
            BOUND * (1.0 + stored),
        );
        same_motion(of, &answer, &found, 0.0);
        // Samples of the motion.
        let rows = stdout(&format!("{line} simulate --until {until} --samples 5"));
        let mut found = Stepped::new(pair, 0.0, [0.0; 4]);
        for (row, part) in rows.lines().skip(1).zip(0..) {
            let ours: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
            if part > 0 {
                found.follow(until / 5.0, STEPS);
            }
            let rate = pair.rate(found.time, &found.state, found.sign);
            let base = pair.base_at(found.time);
            let z = found.state;
            let due = [
                ("time", until * f64::from(part) / 5.0),
                ("displacement", z[0]),
                ("displacement", z[1]),
                ("velocity", z[2]),
                ("velocity", z[3]),
                ("force", pair.contact(found.time, &z, found.sign)),
                ("absolute_acceleration", rate[2] + base),
                ("absolute_acceleration", rate[3] + base),
            ];
            for ((name, other), ours) in due.into_iter().zip(ours) {
                compared(
                    &format!("{of} {name}"),
                    ours,
                    other,
                    SmallSteps,
                    10.0 * BOUND * (1.0 + other.abs()),
                );
            }
        }
    }
}

/// The trace of a matrix and that of its square: sums of its multipliers and of their squares.
fn traces(matrix: &[[f64; 4]; 4]) -> [f64; 2] {
    let square = |i: usize| (0..4).map(|j| matrix[i][j] * matrix[j][i]).sum::<f64>();
    [(0..4).map(|i| matrix[i][i]).sum(), (0..4).map(square).sum()]
}

/// The greatest factor by which the distance of two motions grows from the eighth period on.
fn growth_of_small_steps(pair: Pair, period: f64, followed: u64) -> f64 {
    let mut one = Stepped::new(pair, 0.0, [0.0; 4]);
    let mut other = Stepped::new(pair, 0.0, [0.0; 4]);
    let (mut smallest, mut growth) = (f64::INFINITY, 1.0_f64);
    for count in 0..followed {
        if count == 8 {
            for (i, by) in [1.0, 0.7, -1.3, 0.9].into_iter().enumerate() {
                other.state[i] += 1e-7 * by;
            }
        }
        one.follow(period, STEPS / 10);
        other.follow(period, STEPS / 10);
        let apart = one.state.iter().zip(other.state).fold(0.0_f64, |sum, (a, b)| sum.hypot(a - b));
        if count >= 8 && apart > 1e-12 {
            smallest = smallest.min(apart);
            growth = growth.max(apart / smallest);
        }
    }
    growth
}

/// The steady motion: the one that the motion from rest goes to, its works one by one, and the multipliers of differences.
#[test]
fn steady_motions_of_systems_are_those_of_small_steps() {
    let mut random = Random(92);
    let mut sticking = 0;
    for _ in 0..6 {
        let pair = drawn(&mut random);
        let period = TAU / pair.force[1];
        let file = place("pair.toml");
        std::fs::write(&file, described(&pair)).unwrap();
        let answer = json(&format!("system {} steady --format json", file.display()));
        let of = "system steady";
        compared(&format!("{of} period"), number(&answer["period"]), period, ByHand, 1e-14 * period);
        let start = state(&answer["start"]);
        let distance = |z: &[f64]| start.iter().zip(z).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // From rest.
        let mut limit = Stepped::new(pair, 0.0, [0.0; 4]);
        let followed = answer["periods_followed"].as_u64().unwrap();
        (0..followed).for_each(|_| limit.follow(period, STEPS / 10));
        // The search ends where the motion has come nearer to its limit by a quarter or more.
        let nearer = distance(&limit.state) / distance(&[0.0; 4]);
        compared(&format!("{of} periods_followed"), nearer, 0.0, SmallSteps, 0.25);
        let growth = number(&answer["disturbance_growth"]);
        let seen = growth_of_small_steps(pair, period, followed);
        compared(&format!("{of} disturbance_growth"), (growth / seen).ln(), 0.0, SmallSteps, 1.0);
        settle(&mut limit, period);
        for (ours, other) in start.into_iter().zip(limit.state) {
            compared(&format!("{of} start"), ours, other, SmallSteps, BOUND * (1.0 + other.abs()));
        }
        // One period of it.
        let mut found = Stepped::new(pair, 0.0, start);
        found.follow(period, STEPS);
        agreed(&format!("{of} kind"), answer["kind"].as_str(), Some("periodic"), ByHand);
        let back = distance(&found.state);
        agreed(&format!("{of} periods"), answer["periods"].as_u64(), (back < BOUND).then_some(1), SmallSteps);
        compared(&format!("{of} change"), number(&answer["change"]), back, SmallSteps, BOUND);
        for (i, (drift, mean)) in
            numbers(&answer["drift"]).into_iter().zip(numbers(&answer["mean_velocity"])).enumerate()
        {
            let by = found.state[i] - start[i];
            compared(&format!("{of} drift"), drift, by, SmallSteps, BOUND);
            compared(&format!("{of} mean_velocity"), mean, by / period, SmallSteps, BOUND);
        }
        compared(
            &format!("{of} stored_energy"),
            number(&answer["stored_energy"]),
            pair.energy(&found.state) - pair.energy(&[start[0], start[1], start[2], start[3], 0.0, 0.0, 0.0]),
            SmallSteps,
            10.0 * BOUND,
        );
        same_motion(of, &answer, &found, 0.0);
        sticking += usize::from(found.rest > 0.0);
        // Differences of disturbed periods: their second order is some 1e-5 here, as those ten times as large show, and the error of
        // the steps over the disturbance 1.5e-4.
        let by = 1e-4;
        let end = |i: usize, by: f64| {
            let mut disturbed = start;
            disturbed[i] += by;
            let mut found = Stepped::new(pair, 0.0, disturbed);
            found.follow(period, STEPS);
            found.state
        };
        if found.sign == 0 {
            continue;
        }
        let mut map = [[0.0; 4]; 4];
        for j in 0..4 {
            let (after, before) = (end(j, by), end(j, -by));
            for (i, row) in map.iter_mut().enumerate() {
                row[j] = (after[i] - before[i]) / (2.0 * by);
            }
        }
        let multipliers: Vec<[f64; 2]> = answer["multipliers"]
            .as_array()
            .unwrap()
            .iter()
            .map(|pair| [number(&pair[0]), number(&pair[1])])
            .collect();
        let sums = [
            multipliers.iter().map(|m| m[0]).sum(),
            multipliers.iter().map(|m| m[0] * m[0] - m[1] * m[1]).sum(),
        ];
        for (ours, other) in sums.into_iter().zip(traces(&map)) {
            compared(&format!("{of} multipliers"), ours, other, SmallSteps, 2e-4);
        }
    }
    assert!(sticking > 2, "{sticking}");
}

/// The least load without a rest: the motion of small steps rests below it and not above, and almost rests at it. From rest the
/// contact holds up to the force that the second body alone exerts on it.
#[test]
fn borders_of_systems_are_those_of_small_steps() {
    let mut random = Random(93);
    let of = |name: &str| format!("system border {name}");
    for _ in 0..4 {
        let mut pair = drawn(&mut random);
        (pair.base[0], pair.force[2], pair.peak) = (0.0, 0.0, random.between(1.1, 1.6));
        let file = place("pair.toml");
        let still = described(&pair);
        std::fs::write(&file, still.split("[base]").next().unwrap()).unwrap();
        let answer = json(&format!("system {} border --format json", file.display()));
        let least = number(&answer["least_load_factor"]);
        let period = TAU / pair.force[1];
        // The long motion under a multiple of the load, from a start that slides.
        let long = |factor: f64| {
            let mut with = pair;
            with.force[0] *= factor;
            let mut found = Stepped::new(with, 0.0, [0.0, 0.0, 3.0, 0.0]);
            settle(&mut found, period);
            let mut one = Stepped::new(with, found.time, std::array::from_fn(|i| found.state[i]));
            one.follow(period, STEPS);
            one
        };
        let rests = |factor: f64| long(factor).events.iter().any(|(_, kind)| *kind == "stick");
        agreed(
            &of("least_load_factor by system::System::border"),
            [rests(0.999 * least), rests(1.001 * least)],
            [true, false],
            SmallSteps,
        );
        // Between reversals at the border the velocity is least where it touches zero, or at their ends.
        let touching = number(&answer["touching_time"]);
        let at = long(1.001 * least);
        let reversal = at.events.iter().find(|(_, kind)| *kind == "reverse").unwrap().0;
        let mut near = at.clone();
        near.follow(reversal + period - near.time, STEPS);
        near.follow(touching, STEPS);
        compared(&of("touching_time"), near.state[2].abs() / at.extremes[2][0], 0.0, SmallSteps, 0.02);
        // The second body on its spring and damper, by complex numbers.
        let (spring, damper, w) = (pair.spring[1], pair.damper[1], pair.force[1]);
        let transmitted =
            pair.force[0] * spring.hypot(damper * w) / (spring - pair.mass[1] * w * w).hypot(damper * w);
        let from_rest = pair.peak * pair.friction / transmitted;
        compared(
            &of("least_load_factor_from_rest"),
            number(&answer["least_load_factor_from_rest"]),
            from_rest,
            ByHand,
            1e-12 * from_rest,
        );
        // The cycle at the load of the file, which is well above the border.
        pair.force[0] *= 3.0 * least;
        std::fs::write(&file, described(&pair).split("[base]").next().unwrap()).unwrap();
        let cycle = &json(&format!("system {} border --format json", file.display()))["cycle"];
        let mut found = Stepped::new(pair, 0.0, [0.0; 4]);
        settle(&mut found, period);
        let begin = found.time;
        let mut one = Stepped::new(pair, begin, std::array::from_fn(|i| found.state[i]));
        one.follow(period, STEPS);
        for (name, other) in [
            ("max_displacement", one.extremes[0][0]),
            ("max_velocity", one.extremes[2][0]),
            ("work", one.state[6]),
        ] {
            let output = of("cycle by system::System::cycle");
            compared(&output, number(&cycle[name]), other, SmallSteps, 1e-6 * (1.0 + other));
        }
        // At the times of the greatest displacement and velocity the motion has them.
        for (name, place, most) in
            [("displacement_time", 0, one.extremes[0][0]), ("velocity_time", 2, one.extremes[2][0])]
        {
            let mut then = Stepped::new(pair, begin, std::array::from_fn(|i| found.state[i]));
            then.follow(number(&cycle[name]), STEPS);
            compared(&of("cycle"), then.state[place], most, SmallSteps, 1e-6 * (1.0 + most));
        }
    }
}

/// What is said of a machine of two bodies: its frequencies are the roots of `m M ω⁴ − (k M + K (m + M)) ω² + k K`, and with the first
/// body held that of the second one.
#[test]
fn what_is_said_of_a_machine_is_computed_by_hand() {
    let mut random = Random(94);
    let of = |name: &str| format!("system {name}");
    for i in 0..6 {
        let pair = drawn(&mut random);
        let file = place("pair.toml");
        let text = described(&pair);
        let text = if i < 3 { text.split("[base]").next().unwrap().to_owned() } else { text };
        std::fs::write(&file, text).unwrap();
        let answer = json(&format!("system {} --format json", file.display()));
        agreed(&of("coordinates"), &answer["coordinates"], &serde_json::json!(["a", "b"]), ByHand);
        agreed(&of("negative_damping"), answer["negative_damping"].as_bool(), Some(false), ByHand);
        // A base that moves is a harmonic of its own.
        let loads: Vec<f64> =
            [pair.force[1], pair.base[1]].into_iter().take(if i < 3 { 1 } else { 2 }).collect();
        agreed(&of("harmonics"), numbers(&answer["harmonics"]), loads, ByHand);
        agreed(&of("records"), answer["records"].as_u64(), Some(0), ByHand);
        // Ground that does not move has no direction of its own.
        agreed(&of("sliding_both_ways"), &answer["sliding_both_ways"], &serde_json::json!([]), ByHand);
        let ([m, n], [k, l]) = (pair.mass, pair.spring);
        let (half, product) = ((k * n + l * (m + n)) / (2.0 * m * n), k * l / (m * n));
        let root = (half * half - product).sqrt();
        for (ours, square) in
            numbers(&answer["natural_frequencies"]).into_iter().zip([half - root, half + root])
        {
            compared(&of("natural_frequencies"), ours, square.sqrt(), ByHand, 1e-13);
        }
        let held = (l / n).sqrt();
        compared(
            &of("natural_frequencies_stuck"),
            number(&answer["natural_frequencies_stuck"][0]),
            held,
            ByHand,
            1e-14,
        );
        let element = &answer["elements"][0];
        agreed(
            &of("elements"),
            (element["name"].as_str(), element["kind"].as_str()),
            (Some("c"), Some("contact")),
            ByHand,
        );
        compared(&of("elements"), number(&element["natural_frequencies_stuck"][0]), held, ByHand, 1e-14);
    }
}

/// `rigid_modes`: as many as parts that hang on no ground, counted by hand.
#[test]
fn rigid_modes_are_the_parts_without_ground() {
    let file = place("parts.toml");
    let spring = |a: &str, b: &str| {
        format!("[[springs]]\nbetween = [\"{a}\", \"{b}\"]\nstiffness = 3\ndamping = 0.1\n")
    };
    let masses = "masses = { a = 1, b = 2, c = 3, d = 4, e = 5 }\n";
    for (springs, due) in [
        (vec![], 5),
        (vec![("a", "b")], 4),
        (vec![("ground", "a"), ("b", "c"), ("d", "e")], 2),
        (vec![("ground", "a"), ("a", "b"), ("b", "c"), ("c", "d"), ("d", "e")], 0),
        (vec![("a", "b"), ("b", "c"), ("c", "a"), ("d", "e")], 2),
    ] {
        let springs: String = springs.iter().map(|(a, b)| spring(a, b)).collect();
        std::fs::write(&file, format!("{masses}{springs}")).unwrap();
        let answer = json(&format!("system {} --format json", file.display()));
        agreed("system rigid_modes", answer["rigid_modes"].as_u64(), Some(due), ByHand);
        let zeros = numbers(&answer["natural_frequencies"]).iter().filter(|w| **w == 0.0).count();
        agreed("system natural_frequencies", zeros as u64, due, ByHand);
    }
}
