//! The long run is the one that the start leads to: beside the motion itself, followed for as many periods as settle it.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::cases::{list, number};
use crate::closed_form::contact;
use crate::compared::Origin::{ByHand, SmallSteps};
use crate::compared::{agreed, compared};
use crate::generator::Random;
use serde_json::Value;
use std::f64::consts::TAU;
use stickslip::system::{
    Element, Harmonic, Kind, Law, Model, Normal, Signal, State, Steady, SteadyKind, System,
};

fn below(r: &mut Random, count: usize) -> usize {
    r.below(count as u64) as usize
}

fn unit(n: usize, i: usize, x: f64) -> Vec<f64> {
    (0..n).map(|j| if i == j { x } else { 0.0 }).collect()
}

/// A chain of bodies with dampers in proportion to the springs, with a spring to the ground or without one.
fn chain(numbers: &mut Random, n: usize, damping: f64, grounded: bool) -> Model<f64> {
    let zero = || vec![vec![0.0; n]; n];
    let mut model = Model { mass: zero(), damping: zero(), stiffness: zero(), ..Model::default() };
    for i in 0..n {
        model.mass[i][i] = numbers.between(0.5, 2.0);
        let k = if i == 0 && !grounded { 0.0 } else { numbers.between(0.5, 3.0) };
        for (matrix, x) in [(&mut model.stiffness, k), (&mut model.damping, k * damping)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i - 1][i] -= x;
                matrix[i][i - 1] -= x;
            }
        }
    }
    model
}

fn between(n: usize, i: usize, other: bool) -> Vec<f64> {
    let mut direction = unit(n, i, 1.0);
    if other && i > 0 {
        direction[i - 1] = -1.0;
    }
    direction
}

/// The kinds of machines.
const KINDS: [&str; 5] = ["frame", "stop", "belt", "drift", "parallel"];

/// A machine of a kind.
fn machine(kind: usize, seed: u64) -> Model<f64> {
    let r = &mut Random((seed << 8) | kind as u64);
    let n = 1 + below(r, if kind == 0 || kind == 4 { 4 } else { 3 });
    let damping = if kind == 2 && r.next() < 0.2 { 0.0 } else { r.scale(0.005, 0.1) };
    let mut model = chain(r, n, damping, kind != 3);
    let (frequency, at) = (r.between(0.5, 3.0), below(r, n));
    if kind != 2 {
        model.harmonics.push(Harmonic { frequency, sin: unit(n, at, 1.0), cos: vec![] });
    }
    match kind {
        // A frame on a base that shakes, with friction dampers.
        0 => {
            let amplitude = r.between(0.3, 2.0);
            model.harmonics[0].sin = (0..n).map(|i| -model.mass[i][i] * amplitude).collect();
            for _ in 0..1 + below(r, 2) {
                let i = below(r, n);
                let (direction, friction) = (between(n, i, true), amplitude * r.scale(0.05, 3.0));
                let peak = if r.next() < 0.5 { 1.0 } else { r.between(1.0, 1.6) };
                model.elements.push(if r.next() < 0.6 {
                    let kind = Kind::Elastic { stiffness: r.scale(1.0, 50.0), friction, normal: None };
                    Element { name: String::new(), direction, moves: Signal::constant(0.0), kind }
                } else {
                    contact(direction, friction, peak)
                });
            }
        }
        // End stops.
        1 => {
            for _ in 0..1 + below(r, 2) {
                let i = below(r, n);
                let direction = unit(n, i, if r.next() < 0.3 { -1.0 } else { 1.0 });
                let kind = Kind::Stop {
                    gap: r.between(0.02, 1.0),
                    stiffness: r.scale(5.0, 200.0),
                    damping: r.between(0.0, 0.5),
                };
                model.elements.push(Element {
                    name: String::new(),
                    direction,
                    moves: Signal::constant(0.0),
                    kind,
                });
            }
        }
        // Belts.
        2 => {
            for _ in 0..1 + below(r, 2) {
                let (direction, first) = (unit(n, below(r, n), 1.0), r.between(0.3, 1.5));
                let mut points = vec![(0.0, first)];
                if r.next() < 0.7 {
                    points.push((r.between(0.1, 0.5), first * r.between(0.1, 1.0)));
                    points.push((r.between(0.8, 2.0), first * r.between(0.1, 1.5)));
                }
                let peak = if r.next() < 0.5 { 1.0 } else { r.between(1.0, 1.8) };
                let kind = Kind::Contact { law: Law { points }, peak, normal: None };
                let moves = Signal::constant(r.between(0.05, 1.0));
                model.elements.push(Element { name: String::new(), direction, moves, kind });
            }
        }
        // No spring to the ground, and loads that prefer a direction.
        3 => {
            let cos = unit(n, at, r.between(0.2, 1.0));
            model.harmonics.push(Harmonic { frequency: 2.0 * frequency, sin: vec![], cos });
            for i in 0..n {
                if i == 0 || r.next() < 0.5 {
                    let peak = if r.next() < 0.6 { 1.0 } else { r.between(1.0, 1.5) };
                    model.elements.push(contact(unit(n, i, 1.0), r.scale(0.1, 1.0), peak));
                }
            }
        }
        // Contacts in parallel.
        _ => {
            for _ in 0..2 + below(r, 2) {
                let i = below(r, n);
                let direction = between(n, i, r.next() < 0.5);
                let peak = if r.next() < 0.6 { 1.0 } else { r.between(1.0, 1.5) };
                model.elements.push(contact(direction.clone(), r.scale(0.05, 0.8), peak));
                if r.next() < 0.5 {
                    model.elements.push(contact(direction, r.scale(0.05, 0.8), 1.0));
                }
            }
        }
    }
    model
}

/// The motion after so many times: from state to state, since a load of a period begins anew after it.
fn followed(system: &System<f64>, start: &State<f64>, period: f64, count: usize) -> State<f64> {
    let mut state = start.clone();
    for _ in 0..count.div_ceil(16) {
        state = system.states(&state, &[16.0 * period]).unwrap().remove(0);
    }
    state
}

/// By how much the limit differs from the motion that has been followed until it has settled, in parts of the motion. None where
/// that takes more than `most` periods; `followed_each` of them are in one of those that were followed.
fn difference(
    system: &System<f64>,
    start: &State<f64>,
    steady: &Steady<f64>,
    most: usize,
    followed_each: usize,
) -> Option<f64> {
    let period = steady.motion.duration;
    let sizes = steady.multipliers.iter().map(|(re, im)| re.hypot(*im)).filter(|size| *size < 1.0 - 1e-9);
    let slowest = sizes.fold(0.5, f64::max);
    let count = followed_each * steady.followed + (26.0 / -slowest.ln()).ceil() as usize;
    if count > most {
        return None;
    }
    let state = followed(system, start, period, count);
    let motion = system.simulate(&state, period).unwrap();
    let drifts = steady.mean_velocity.iter().any(|v| *v != 0.0);
    let (mut size, mut by) = (1e-12_f64, 0.0_f64);
    let mut compare = |ours: f64, due: f64| (size, by) = (size.max(due.abs()), by.max((ours - due).abs()));
    for i in 0..system.coordinates() {
        compare(steady.motion.max_velocity[i], motion.max_velocity[i]);
        compare(steady.motion.min_velocity[i], motion.min_velocity[i]);
        if drifts {
            compare(steady.mean_velocity[i] * period, motion.end.displacement[i] - state.displacement[i]);
        } else {
            compare(steady.motion.max_displacement[i], motion.max_displacement[i]);
            compare(steady.motion.min_displacement[i], motion.min_displacement[i]);
        }
    }
    Some(by / size)
}

/// Five kinds of machines: no limit differs from the motion by more than 10⁻⁸ of it.
#[test]
fn the_limit_is_that_of_the_motion() {
    let count = crate::count(40, 400);
    for (kind, name) in KINDS.iter().enumerate() {
        let (mut settled, mut done, mut most) = (0, 0, 0.0_f64);
        for seed in 0..count as u64 {
            let system = System::new(&machine(kind, seed)).unwrap();
            let start = State::rest(system.coordinates());
            let steady = system.steady(&start).unwrap();
            if matches!(steady.kind, SteadyKind::Growing | SteadyKind::Unsettled) {
                continue;
            }
            settled += 1;
            // A chaotic beginning is followed by rounding, and its limit with it.
            let periods = if steady.followed > 400 { 0 } else { 20_000 };
            let Some(by) = difference(&system, &start, &steady, periods, if kind == 2 { 200 } else { 1 })
            else {
                continue;
            };
            done += 1;
            most = most.max(by);
            assert!(by < 1e-8, "{name} {seed}: {by:e} {steady:?}");
        }
        println!("{name}: {settled} of {count} settled, {done} compared, differ by {most:e} at most");
        assert!(10 * settled > 7 * count && 10 * done > 5 * count, "{name}: {settled} {done}");
    }
}

/// The machine of an entry of `tests/data/limits.json`.
fn of_limits(of: &Value) -> Model<f64> {
    let rows = |name: &str| -> Vec<Vec<f64>> { of[name].as_array().unwrap().iter().map(list).collect() };
    let element = |e: &Value| {
        let friction = |e: &Value| number(&e["friction"]);
        let kind = match e["type"].as_str().unwrap() {
            "contact" => {
                let points = e.get("law").map_or_else(
                    || vec![(0.0, friction(e))],
                    |law| law.as_array().unwrap().iter().map(list).map(|pair| (pair[0], pair[1])).collect(),
                );
                let peak = e.get("peak").map_or(1.0, number);
                Kind::Contact { law: Law { points }, peak, normal: None }
            }
            "elastic" => {
                Kind::Elastic { stiffness: number(&e["stiffness"]), friction: friction(e), normal: None }
            }
            _ => Kind::Stop {
                gap: number(&e["gap"]),
                stiffness: number(&e["stiffness"]),
                damping: number(&e["damping"]),
            },
        };
        let moves = Signal::constant(e["moves"].get("constant").map_or(0.0, number));
        Element { name: String::new(), direction: list(&e["direction"]), moves, kind }
    };
    let harmonic = |h: &Value| Harmonic {
        frequency: number(&h["frequency"]),
        sin: list(&h["sin"]),
        cos: list(&h["cos"]),
    };
    let all = |name: &str| of.get(name).and_then(Value::as_array).cloned().unwrap_or_default();
    Model {
        mass: rows("mass"),
        damping: rows("damping"),
        stiffness: rows("stiffness"),
        constant: of.get("constant").map_or_else(Vec::new, list),
        elements: all("elements").iter().map(element).collect(),
        harmonics: all("harmonics").iter().map(harmonic).collect(),
        ..Model::default()
    }
}

/// The long runs of 200 machines that a program without a line of this one has followed: `tests/data/limits.py`.
#[test]
fn limits_are_those_of_another_program() {
    let all: Value = serde_json::from_str(include_str!("../data/limits.json")).unwrap();
    let (mut most, mut settled, mut count) = (0.0_f64, 0, 0);
    for (i, due) in all.as_array().unwrap().iter().enumerate() {
        let model = of_limits(&due["model"]);
        let system = System::new(&model).unwrap();
        let steady = system.steady(&State::rest(system.coordinates())).unwrap();
        count += 1;
        if matches!(steady.kind, SteadyKind::Unsettled) {
            continue;
        }
        settled += 1;
        let name = format!("{i}, {}: {steady:?} for {due}", due["kind"]);
        assert_eq!(due["rest"].as_bool().unwrap(), steady.kind == SteadyKind::Rest, "{name}");
        if steady.kind == SteadyKind::Periodic {
            let period = number(&due["period"]);
            assert!((steady.period / period - 1.0).abs() < 1e-9, "{name}");
            assert_eq!(Some(steady.periods as u64), due["periods"].as_u64(), "{name}");
        }
        let lists: [(&str, &[f64]); 5] = [
            ("max_displacement", &steady.motion.max_displacement),
            ("min_displacement", &steady.motion.min_displacement),
            ("max_velocity", &steady.motion.max_velocity),
            ("min_velocity", &steady.motion.min_velocity),
            ("drift", &steady.drift),
        ];
        let size = lists.iter().flat_map(|(_, list)| *list).fold(1e-12_f64, |most, x| most.max(x.abs()));
        for (what, ours) in lists {
            for (x, other) in ours.iter().zip(due[what].as_array().unwrap()) {
                let Some(other) = other.as_f64() else { continue };
                let by = (x - other).abs() / size;
                most = most.max(by);
                // Its chunks of a slow decay leave some 10⁻¹¹.
                assert!(by < 1e-9, "{what} by {by:e} in {name}");
            }
        }
    }
    println!("{settled} of {count} settled, differ by {most:e} at most");
    assert!(count == 200 && settled >= 198, "{settled}");
}

fn bumper(frequency: f64) -> Model<f64> {
    let kind = Kind::Stop { gap: 0.46, stiffness: 420.0, damping: 0.19 };
    Model {
        mass: vec![vec![0.01]],
        damping: vec![vec![0.055]],
        stiffness: vec![vec![10.0]],
        elements: vec![Element {
            name: "bumper".into(),
            direction: vec![1.0],
            moves: Signal::constant(0.0),
            kind,
        }],
        harmonics: vec![Harmonic { frequency: TAU * frequency, sin: vec![10.0], cos: vec![] }],
        ..Model::default()
    }
}

/// A hammer on a bumper has a motion that does not touch it, and one that hits it in every second period. From rest it goes to the
/// second at each of these frequencies.
#[test]
fn a_hammer_from_rest_hits_its_bumper() {
    for frequency in [11.0, 11.6, 12.2, 12.7, 12.8] {
        let system = System::new(&bumper(frequency)).unwrap();
        let steady = system.steady(&State::rest(1)).unwrap();
        assert!(steady.motion.max_displacement[0] > 0.46, "{frequency}: {steady:?}");
        assert!(
            difference(&system, &State::rest(1), &steady, 5000, 1).is_some_and(|by| by < 1e-9),
            "{frequency}"
        );
    }
}

/// A body that two frequencies drive over a plate with friction drifts: by the momentum of each slide in steps of a two-hundred-thousandth of
/// a period the drift is −2.7537778742 mm a period.
#[test]
fn a_plate_under_two_harmonics_drifts() {
    let model = Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![0.0]],
        elements: vec![contact(vec![1.0], 0.2 * 9.81, 1.0)],
        harmonics: vec![
            Harmonic { frequency: TAU * 10.0, sin: vec![6.0], cos: vec![] },
            Harmonic { frequency: TAU * 20.0, sin: vec![], cos: vec![6.0] },
        ],
        ..Model::default()
    };
    let steady = System::new(&model).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!((steady.kind, steady.periods), (SteadyKind::Periodic, 1));
    compared("system steady drift", steady.drift[0], -2.753_777_874_2e-3, SmallSteps, 1e-12);
    let moved = steady.motion.end.displacement[0] - steady.start.displacement[0];
    assert!(
        (moved - steady.drift[0]).abs() < 1e-15 && (steady.mean_velocity[0] - moved * 10.0).abs() < 1e-14
    );
}

/// A spring that moves the plate by less than rounding in a period is none: the drift is that without it. With one that is weak and notices the
/// place, the motion is still on its way after all periods that are followed, and no place on the way is called its limit.
#[test]
fn a_plate_on_a_spring_of_nothing_drifts() {
    let model = |stiffness: f64| Model {
        mass: vec![vec![10.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![stiffness]],
        elements: vec![contact(vec![1.0], 20.0, 1.0)],
        constant: vec![1.0],
        harmonics: vec![Harmonic { frequency: TAU * 2.0, sin: vec![60.0], cos: vec![] }],
        ..Model::default()
    };
    let steady = |stiffness: f64| System::new(&model(stiffness)).unwrap().steady(&State::rest(1)).unwrap();
    let due = steady(0.0);
    assert!((due.kind, due.drift[0] > 0.01) == (SteadyKind::Periodic, true));
    for stiffness in [1e-300, 1e-100, 1e-20, 8e-15] {
        let found = steady(stiffness);
        assert_eq!(found.kind, SteadyKind::Periodic, "{stiffness}");
        assert!((found.drift[0] / due.drift[0] - 1.0).abs() < 1e-12, "{stiffness}: {:?}", found.drift);
    }
    for stiffness in [1e-14, 1e-12, 1e-10] {
        let found = steady(stiffness);
        assert_eq!(found.kind, SteadyKind::Unsettled, "{stiffness}");
        // In a period it goes as far as without the spring, whose force is a part of the constant one there.
        let way = found.motion.end.displacement[0] - found.start.displacement[0];
        let part = stiffness * found.start.displacement[0].abs();
        assert!((way / due.drift[0] - 1.0).abs() < 2.0 * part + 1e-11, "{stiffness}: {way} {:?}", due.drift);
    }
    // No two motions of this machine move apart: where a period changes the place by more than rounding, its limit is there before the motion.
    // The spring carries the constant force there, as the other load prefers no direction.
    for stiffness in [1e-6, 1e-4] {
        let found = steady(stiffness);
        assert_eq!((found.kind, found.drift[0]), (SteadyKind::Periodic, 0.0), "{stiffness}");
        let middle = 0.5 * (found.motion.max_displacement[0] + found.motion.min_displacement[0]);
        assert!((stiffness * middle - 1.0).abs() < 1e-5, "{stiffness}: {middle}");
    }
    // At 10 N/m the constant force stretches the spring, and the motion is there after some periods.
    let held = steady(10.0);
    assert_eq!((held.kind, held.drift[0]), (SteadyKind::Periodic, 0.0));
}

/// A part on a vibrating track, whose normal load varies: by small steps 64.59793 mm/s.
#[test]
fn a_conveyor_carries_its_part() {
    let normal = Signal { sin: vec![-7.507_935_100_902_13], ..Signal::constant(9.81) };
    let law = Kind::Contact {
        law: Law::constant(0.4),
        peak: 1.0,
        normal: Some(Normal { signal: normal, displacement: vec![], velocity: vec![] }),
    };
    let model = Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![0.0]],
        elements: vec![Element { kind: law, ..contact(vec![1.0], 1.0, 1.0) }],
        harmonics: vec![Harmonic { frequency: TAU * 15.0, sin: vec![16.100_818_782_621_3], cos: vec![] }],
        ..Model::default()
    };
    let steady = System::new(&model).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Periodic);
    compared("system steady mean_velocity", steady.mean_velocity[0], 0.064_597_93, SmallSteps, 1e-7);
}

/// Two bodies on a spring, turned by a constant moment against a damper and dry friction: below its bound all rests; above it they stick and
/// slip, or turn uniformly with `M = c ω + r` where that is fast enough.
#[test]
fn a_string_turns_uniformly_or_rests() {
    let model = |moment: f64| Model {
        mass: vec![vec![4.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.6, -0.1], vec![-0.1, 0.1]],
        stiffness: vec![vec![1.0, -1.0], vec![-1.0, 1.0]],
        elements: vec![contact(vec![0.0, 1.0], 1.0, 2.0)],
        constant: vec![moment, 0.0],
        ..Model::default()
    };
    let steady = |moment: f64| System::new(&model(moment)).unwrap().steady(&State::rest(2)).unwrap();
    assert_eq!(steady(0.8).kind, SteadyKind::Rest);
    let uniform = steady(2.5);
    assert_eq!((uniform.kind, uniform.period), (SteadyKind::Uniform, 0.0));
    let due = (2.5 - 1.0) / 0.5;
    assert!(uniform.mean_velocity.iter().all(|v| (v - due).abs() < 1e-12), "{uniform:?}");
    let slips = steady(1.3);
    assert_eq!(slips.kind, SteadyKind::Periodic);
    assert!(slips.motion.elements[0].stops == 1 && slips.drift[0] > 0.0);
    let mean = slips.drift[0] / slips.period;
    assert!((slips.mean_velocity[1] - mean).abs() < 1e-14 * mean.abs());
    // The balance of moments over a period: M T = c Δ + ∫T dt, and the friction's work is the rest of the load's.
    let motion = &slips.motion;
    let works = motion.damper_work + motion.elements[0].work;
    assert!((motion.load_work - works).abs() < 1e-12 * motion.load_work, "{motion:?}");
}

/// A slide on two rails whose frictions together exceed the load stays at rest: displacements of rounding are no motion.
#[test]
fn rest_is_rest() {
    for load in [57.0, 30.0, 99.0] {
        let model = Model {
            mass: vec![vec![2.0]],
            damping: vec![vec![0.02]],
            stiffness: vec![vec![5.0]],
            elements: vec![contact(vec![1.0], 40.0, 1.0), contact(vec![1.0], 60.0, 1.0)],
            harmonics: vec![Harmonic { frequency: TAU * 3.0, sin: vec![load], cos: vec![] }],
            ..Model::default()
        };
        // At 99 N and 1 m the spring pulls the slide back, by ever smaller slips.
        for place in [0.0, 1.0].into_iter().take(if load > 90.0 { 1 } else { 2 }) {
            let start = State { displacement: vec![place], ..State::rest(1) };
            let steady = System::new(&model).unwrap().steady(&start).unwrap();
            assert_eq!((steady.kind, steady.periods), (SteadyKind::Rest, 1), "{load} {place}: {steady:?}");
            assert!((steady.start.displacement[0] - place).abs() < 1e-13);
        }
    }
}

/// A sum of loads of which none moves anything is rest after one period, not after several.
#[test]
fn a_load_of_nothing_leaves_rest() {
    let model = Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.1]],
        stiffness: vec![vec![4.0]],
        elements: vec![contact(vec![1.0], 0.5, 1.0)],
        harmonics: vec![Harmonic { frequency: 1.3, sin: vec![0.0], cos: vec![] }],
        ..Model::default()
    };
    let start = State { displacement: vec![1.0], ..State::rest(1) };
    let steady = System::new(&model).unwrap().steady(&start).unwrap();
    assert_eq!((steady.kind, steady.periods), (SteadyKind::Rest, 1));
}

/// An elastic contact that holds keeps `T − k y`: after thousands of periods its force is that of the bound it left at its last yield.
#[test]
fn what_a_holding_contact_keeps_does_not_creep() {
    let kind = Kind::Elastic { stiffness: 30.0, friction: 1.0, normal: None };
    let model = Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.2]],
        stiffness: vec![vec![3.0]],
        elements: vec![Element {
            name: "pad".into(),
            direction: vec![1.0],
            moves: Signal::constant(0.0),
            kind,
        }],
        harmonics: vec![Harmonic { frequency: 4.0, sin: vec![0.4], cos: vec![] }],
        ..Model::default()
    };
    let system = System::new(&model).unwrap();
    let start = State { displacement: vec![0.4], ..State::rest(1) };
    let period = TAU / 4.0;
    let motion = system.simulate(&start, 4000.0 * period).unwrap();
    let last = motion.events.last().expect("it yields").time;
    assert!(last < 100.0 * period, "{last}");
    let kept = |state: &State<f64>| state.force[0] - 30.0 * state.displacement[0];
    let states = system.states(&start, &[200.0 * period, 2000.0 * period, 4000.0 * period]).unwrap();
    let first = kept(&states[0]);
    for state in &states {
        assert!((kept(state) - first).abs() < 4e-14, "{} {first}", kept(state));
    }
}

/// With static friction above the kinetic one a body at rest starts where the load reaches the static bound, far above the border of sliding.
#[test]
fn the_border_from_rest_is_the_static_bound() {
    let model = |amplitude: f64, constant: f64| Model {
        mass: vec![vec![1.0, 0.0], vec![0.0, 0.7]],
        damping: vec![vec![0.3, -0.1], vec![-0.1, 0.1]],
        stiffness: vec![vec![2.0, -1.0], vec![-1.0, 1.0]],
        elements: vec![contact(vec![1.0, 0.0], 0.4, 2.2)],
        constant: vec![constant, 0.0],
        harmonics: vec![Harmonic { frequency: 2.3, sin: vec![0.2 * amplitude, amplitude], cos: vec![] }],
        ..Model::default()
    };
    for constant in [0.0, 0.25, -0.3] {
        let border = System::new(&model(1.0, constant)).unwrap().border().unwrap();
        let release = border.least_load_factor_from_rest.unwrap();
        // The structure on the contact at rest, in its steady motion.
        let slips = |amplitude: f64| {
            let model = model(amplitude, constant);
            let stuck = Model { elements: vec![contact(vec![1.0, 0.0], 1e9, 1.0)], ..model.clone() };
            let start = System::new(&stuck).unwrap().steady(&State::rest(2)).unwrap().start;
            let motion = System::new(&model).unwrap().simulate(&start, 40.0 * TAU / 2.3).unwrap();
            !motion.events.is_empty()
        };
        assert!(slips(1.0001 * release) && !slips(0.9999 * release), "{constant}: {release}");
    }
    let plain = Model { elements: vec![contact(vec![1.0, 0.0], 0.4, 1.0)], ..model(1.0, 0.0) };
    assert_eq!(System::new(&plain).unwrap().border().unwrap().least_load_factor_from_rest, None);
}

/// A start beside the limit comes back by the largest multiplier in a period; an undisturbed slow motion that is cut short falls by it, too.
#[test]
fn a_disturbance_falls_by_the_multiplier() {
    // A body between two stops, of which it meets the first.
    let stop = |direction: f64, gap: f64| Element {
        name: String::new(),
        direction: vec![direction],
        moves: Signal::constant(0.0),
        kind: Kind::Stop { gap, stiffness: 8.0, damping: 0.3 },
    };
    let model = |damping: f64| Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![damping]],
        stiffness: vec![vec![2.0]],
        elements: vec![stop(1.0, 0.2), stop(-1.0, 3.0)],
        harmonics: vec![Harmonic { frequency: 1.1, sin: vec![0.4], cos: vec![] }],
        ..Model::default()
    };
    let period = TAU / 1.1;
    let system = System::new(&model(0.05)).unwrap();
    let steady = system.steady(&State::rest(1)).unwrap();
    assert_eq!((steady.kind, steady.periods), (SteadyKind::Periodic, 1));
    agreed("system steady decay", steady.decay, 0.0, ByHand);
    let (re, im) = steady.multipliers[0];
    let mut state = steady.start.clone();
    state.displacement[0] += 1e-7;
    let apart = |state: &State<f64>| {
        let by = [
            state.displacement[0] - steady.start.displacement[0],
            state.velocity[0] - steady.start.velocity[0],
        ];
        by[0].hypot(by[1])
    };
    let states = system.states(&state, &[6.0 * period, 12.0 * period]).unwrap();
    // A spiral of one rate falls by it in the mean.
    let rate = (apart(&states[1]) / apart(&state)).powf(1.0 / 12.0);
    assert!((rate / re.hypot(im) - 1.0).abs() < 0.05, "{rate} {re} {im}");
    // An own vibration of a damper so weak that its multiplier is 1 to rounding: its amplitude falls as e^(−c t/2m).
    let damping = 1e-10;
    let free = Model { elements: vec![stop(1.0, 30.0)], ..model(damping) };
    let slow =
        System::new(&free).unwrap().steady(&State { displacement: vec![5.0], ..State::rest(1) }).unwrap();
    assert_eq!(slow.kind, SteadyKind::Unsettled);
    assert!(slow.change > 1e-3 && slow.decay <= 1.0, "{} {}", slow.change, slow.decay);
    // A factor of 1 − 3e-10, as it was seen in the changes of 1e-3 of the last periods.
    compared("system steady decay", slow.decay, (-damping * period / 2.0).exp(), ByHand, 1e-3);
}

/// Two equal bodies on a weak spring pass their vibration to and fro. The second one holds a slider from rest, which slides for the first time after some
/// twenty periods of the load: the limit depends on how far it is moved then.
#[test]
fn a_slider_that_wakes_late_decides_the_limit() {
    let model = |friction: f64| Model {
        mass: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.004, 0.0], vec![0.0, 0.004]],
        stiffness: vec![vec![1.02, -0.02], vec![-0.02, 1.02]],
        elements: vec![Element {
            name: String::new(),
            direction: vec![0.0, 1.0],
            moves: Signal::constant(0.0),
            kind: Kind::Elastic { stiffness: 0.05, friction, normal: None },
        }],
        harmonics: vec![Harmonic { frequency: 2.5, sin: vec![0.3, 0.0], cos: vec![] }],
        ..Model::default()
    };
    let start = State { displacement: vec![1.0, 0.0], velocity: vec![0.0, 0.0], ..State::rest(2) };
    let mut places = Vec::new();
    for friction in [0.01, 0.015, 0.02] {
        let system = System::new(&model(friction)).unwrap();
        let first = system.simulate(&start, 1000.0).unwrap().events.first().map(|event| event.time);
        let steady = system.steady(&start).unwrap();
        assert_eq!(steady.kind, SteadyKind::Periodic, "{friction}");
        assert!(first.is_some_and(|time| time > 4.0 * TAU / 2.5), "{friction}: {first:?}");
        assert!(steady.motion.events.is_empty() && steady.followed < 400, "{friction}: {}", steady.followed);
        let by = difference(&system, &start, &steady, 20_000, 8).unwrap();
        assert!(by < 1e-9, "{friction}: {by:e}");
        places.push(steady.motion.max_displacement[1] + steady.motion.min_displacement[1]);
    }
    assert!(places.iter().all(|x| x.abs() > 1e-4), "{places:?}");
}

/// Twelve storeys with little damping and three friction dampers: the way to the limit takes hundreds of periods, the answer a few.
#[test]
fn the_limit_of_storeys_is_there_before_the_motion() {
    for (friction, active) in [(0.002, true), (1.0, false)] {
        let n = 12;
        let mut model = chain(&mut Random(7), n, 0.05, true);
        model.harmonics.push(Harmonic { frequency: 0.9, sin: vec![0.05; n], cos: vec![] });
        for at in [0, 4, 8] {
            let kind = Kind::Elastic { stiffness: 2.0, friction, normal: None };
            let (name, moves) = (String::new(), Signal::constant(0.0));
            model.elements.push(Element { name, direction: between(n, at, true), moves, kind });
        }
        let system = System::new(&model).unwrap();
        let start = State::rest(n);
        let steady = system.steady(&start).unwrap();
        assert_eq!(
            (steady.kind, steady.motion.events.is_empty()),
            (SteadyKind::Periodic, !active),
            "{friction}"
        );
        let by = difference(&system, &start, &steady, 20_000, 8).unwrap();
        println!("{friction}: after {} periods, differs by {by:e}", steady.followed);
        assert!(by < 1e-9 && steady.followed <= 300, "{friction}: {by:e} {}", steady.followed);
    }
}
