//! Stops with a restitution: closed forms, and random machines beside an independent program.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

#[path = "impacts/small_steps.rs"]
mod small_steps;
#[path = "impacts/under.rs"]
mod under;

use crate::generator::Random;
use small_steps::{Kept, Machine, Rub, Wall};
use std::f64::consts::TAU;
use stickslip::system::{
    Element, Error, Event, EventKind, Harmonic, Kind, Law, Model, Motion, Moved, MovedBy, Signal, State,
    SteadyKind, System,
};

fn element(name: &str, direction: Vec<f64>, kind: Kind<f64>) -> Element<f64> {
    Element { name: name.into(), direction, moves: Signal::constant(0.0), kind }
}

fn stop(direction: Vec<f64>, gap: f64, restitution: f64) -> Element<f64> {
    element("stop", direction, Kind::HardStop { gap, restitution })
}

fn rub(direction: Vec<f64>, friction: f64, peak: f64) -> Element<f64> {
    element("contact", direction, Kind::Contact { law: Law::constant(friction), peak, normal: None })
}

/// One body on a spring.
fn body(mass: f64, damping: f64, stiffness: f64, elements: Vec<Element<f64>>) -> Model<f64> {
    let one = |x: f64| vec![vec![x]];
    let (mass, damping, stiffness) = (one(mass), one(damping), one(stiffness));
    Model { mass, damping, stiffness, elements, ..Model::default() }
}

fn at(displacement: Vec<f64>) -> State<f64> {
    let n = displacement.len();
    State { displacement, ..State::rest(n) }
}

fn of(motion: &Motion<f64>, kind: EventKind) -> Vec<Event<f64>> {
    motion.events.iter().filter(|event| event.kind == kind).copied().collect()
}

/// What is missing in the energy, in parts of the work.
fn energy(motion: &Motion<f64>) -> f64 {
    let works: f64 = motion.elements.iter().map(|e| e.work).sum();
    let size = motion.load_work.abs() + motion.damper_work + motion.stored.abs();
    let size = size + motion.elements.iter().map(|e| e.work.abs()).sum::<f64>();
    (motion.load_work - motion.damper_work - works - motion.stored).abs() / (size + 1e-3)
}

/// A block that falls from h has v = √(2gh), and comes to rest after the time v/g + 2 e v/(g (1 − e)). All its energy is lost.
#[test]
fn a_block_bounces_until_the_sum_of_its_flights() {
    let (g, h, m) = (9.81_f64, 0.4, 2.0);
    for e in [0.1_f64, 0.5, 0.8, 0.95, 0.99] {
        let model = Model { constant: vec![m * g], ..body(m, 0.0, 0.0, vec![stop(vec![1.0], 0.0, e)]) };
        let motion = System::new(&model).unwrap().simulate(&at(vec![-h]), 200.0).unwrap();
        let v = (2.0 * g * h).sqrt();
        let due = v / g + 2.0 * e * v / (g * (1.0 - e));
        let [close] = of(&motion, EventKind::Close)[..] else { panic!("{:?}", motion.events) };
        // The rounding of each velocity, some v ε, is in all later flights.
        assert!((close.time / due - 1.0).abs() < 1e-14 / (1.0 - e), "{e}: {} {due}", close.time);
        let blows = of(&motion, EventKind::Blow);
        for (k, blow) in blows.iter().enumerate() {
            let (before, after) = blow.velocities.unwrap();
            let falls = v * e.powi(k as i32);
            assert!((before / falls - 1.0).abs() < 1e-7 && (after + e * before).abs() < 1e-15 * v, "{e} {k}");
        }
        // The stop is open until then.
        assert!((motion.elements[0].time_at_rest / due - 1.0).abs() < 1e-14 / (1.0 - e), "{e}");
        assert_eq!(motion.elements[0].blows, blows.len());
        assert_eq!(motion.end.displacement, [0.0]);
        assert_eq!(motion.end.velocity, [0.0]);
        assert!((motion.end.force[0] / (m * g) - 1.0).abs() < 1e-14);
        assert!((motion.elements[0].work / (m * g * h) - 1.0).abs() < 1e-12, "{}", motion.elements[0].work);
        assert!(energy(&motion) < 1e-13);
    }
}

/// A sample just behind a blow is behind it, and samples on the way put off no blow: the instants of blows by the closed form.
#[test]
fn samples_beside_small_blows_know_them() {
    let (g, e, v, gap) = (9.81_f64, 0.5_f64, 3.0, 1e3);
    let model = Model { constant: vec![g], ..body(1.0, 0.0, 0.0, vec![stop(vec![1.0], gap, e)]) };
    let system = System::new(&model).unwrap();
    let start = State { velocity: vec![v], ..at(vec![gap - 1.0]) };
    let speed = (v * v + 2.0 * g).sqrt();
    let mut time = (speed - v) / g;
    for k in 0..30 {
        let falls = speed * e.powi(k);
        // So many roundings of the displacement before the blow, and behind it.
        for roundings in [64.0, 512.0] {
            let by = roundings * gap * f64::EPSILON / falls;
            let flight = 2.0 * e * falls / g;
            if by > 0.1 * flight {
                continue;
            }
            let times: Vec<f64> = (-8..=8).filter(|i| *i != 0).map(|i| time + by * f64::from(i)).collect();
            let states = system.states(&start, &times).unwrap();
            for (state, at) in states.iter().zip(&times) {
                let due = if *at < time { falls + g * (at - time) } else { g * (at - time) - e * falls };
                assert!(
                    (state.velocity[0] - due).abs() < 1e-9 * speed,
                    "{k} {roundings}: {state:?} for {due} at {}",
                    at - time
                );
            }
        }
        time += 2.0 * e * falls / g;
    }
}

/// Friction R along the fall: up under g + R/m, down under g − R/m, so that each flight has e √((g − R/m)/(g + R/m)) of the velocity before.
/// With e = 1 it ends, too.
#[test]
fn friction_along_the_fall_ends_the_blows_sooner() {
    let (g, h, m, r) = (9.81_f64, 0.4, 2.0, 6.0);
    let (down, up) = (g - r / m, g + r / m);
    for e in [0.3, 0.6, 1.0] {
        let elements = vec![rub(vec![1.0], r, 1.0), stop(vec![1.0], 0.0, e)];
        let model = Model { constant: vec![m * g], ..body(m, 0.0, 0.0, elements) };
        let motion = System::new(&model).unwrap().simulate(&at(vec![-h]), 20.0).unwrap();
        let v = (2.0 * down * h).sqrt();
        let ratio = e * (down / up).sqrt();
        let due = v / down + e * v * (1.0 / up + 1.0 / (down * up).sqrt()) / (1.0 - ratio);
        let [close] = of(&motion, EventKind::Close)[..] else { panic!("{:?}", motion.events) };
        assert!((close.time / due - 1.0).abs() < 1e-13, "{e}: {} {due}", close.time);
        let [stick] = of(&motion, EventKind::Stick)[..] else { panic!("{:?}", motion.events) };
        assert_eq!(stick.time, close.time);
        // Both hold the weight; none is above its bound.
        let force = &motion.end.force;
        assert!((force[0] + force[1] - m * g).abs() < 1e-12 && force[0].abs() <= r && force[1] >= 0.0);
        assert!(energy(&motion) < 1e-13);
    }
}

/// With e = 0 a body under F₀ + F sin ωt stays where it lands, and leaves where the force changes its sign.
#[test]
fn without_restitution_a_body_stays_until_the_load_pulls() {
    let (m, f0, f, w) = (1.5, 3.0_f64, 5.0, 2.0);
    let load = Harmonic { frequency: w, sin: vec![f], cos: vec![] };
    let model = Model {
        constant: vec![f0],
        harmonics: vec![load],
        ..body(m, 0.0, 0.0, vec![stop(vec![1.0], 0.02, 0.0)])
    };
    let motion = System::new(&model).unwrap().simulate(&State::rest(1), 2.5).unwrap();
    let kinds: Vec<_> = motion.events.iter().map(|event| event.kind).collect();
    assert_eq!(kinds[..3], [EventKind::Blow, EventKind::Close, EventKind::Open], "{kinds:?}");
    assert_eq!(motion.events[0].time, motion.events[1].time);
    let opens = (std::f64::consts::PI + (f0 / f).asin()) / w;
    assert!((motion.events[2].time - opens).abs() < 1e-14, "{}", motion.events[2].time);
    // From rest at the instant it opens: ∬(F₀ + F sin ωt)/m.
    let t = 2.5;
    let (s, c) = (w * opens).sin_cos();
    let x = 0.02
        + (f0 / 2.0 * (t - opens) * (t - opens) + f / w * (c * (t - opens) - ((w * t).sin() - s) / w)) / m;
    assert!((motion.end.displacement[0] - x).abs() < 1e-14, "{} {x}", motion.end.displacement[0]);
    assert!(energy(&motion) < 1e-13);
}

/// A body that presses on a stop beside a contact in the same direction leaves where the pull is that of the friction.
#[test]
fn a_contact_beside_a_stop_holds_a_pull_up_to_its_friction() {
    for peak in [1.0, 1.4] {
        let r = 2.0;
        let load = Harmonic { frequency: 1.0, sin: vec![], cos: vec![4.0] };
        let elements = vec![rub(vec![1.0], r, peak), stop(vec![1.0], 0.0, 0.5)];
        let model = Model { harmonics: vec![load], ..body(1.0, 0.0, 0.0, elements) };
        let motion = System::new(&model).unwrap().simulate(&State::rest(1), 2.5).unwrap();
        let due = (-peak * r / 4.0).acos();
        let first: Vec<_> = motion.events.iter().map(|event| (event.kind, event.element)).collect();
        assert_eq!(first[..2], [(EventKind::Slip, 0), (EventKind::Open, 1)], "{first:?}");
        assert!(motion.events[..2].iter().all(|e| (e.time - due).abs() < 1e-13), "{:?} {due}", motion.events);
    }
}

/// A block on a table that moves by A sin ωt, under a weight towards it: it leaves where A ω² sin ωt = g, and its blows are those of a parabola.
#[test]
fn a_block_bounces_on_a_shaken_table() {
    let (g, a, w, e) = (9.81_f64, 0.01, 60.0_f64, 0.5);
    // Up is positive: the stop is below the block, y_table − y_block ≤ 0.
    let signal = Signal { sin: vec![a], ..Signal::constant(0.0) };
    let model = Model {
        mass: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.0; 2]; 2],
        stiffness: vec![vec![0.0; 2]; 2],
        constant: vec![0.0, -g],
        harmonics: vec![Harmonic { frequency: w, sin: vec![], cos: vec![] }],
        elements: vec![stop(vec![1.0, -1.0], 0.0, e)],
        moved: vec![Moved { coordinate: 0, by: MovedBy::Displacement, signal }],
        ..Model::default()
    };
    let start = State { displacement: vec![0.0, 0.0], velocity: vec![a * w, a * w], ..State::rest(2) };
    let system = System::new(&model).unwrap();
    let motion = system.simulate(&start, 3.0).unwrap();
    let first = motion.events[0];
    assert_eq!(first.kind, EventKind::Open);
    let opens = (g / (a * w * w)).asin() / w;
    assert!((first.time - opens).abs() < 1e-15, "{} {opens}", first.time);
    // The table's wave and the block's parabola, by bisection between samples of 10⁻⁵.
    let (mut t, mut y, mut v) = (opens, a * (w * opens).sin(), a * w * (w * opens).cos());
    let blows = of(&motion, EventKind::Blow);
    assert!(blows.len() > 8, "{:?}", motion.events);
    for blow in blows.iter().take(8) {
        let over = |s: f64| y + v * s - g / 2.0 * s * s - a * (w * (t + s)).sin();
        let mut s = 1e-5;
        while over(s) > 0.0 {
            s += 1e-5;
        }
        let (mut low, mut high) = (s - 1e-5, s);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if over(middle) > 0.0 { low = middle } else { high = middle }
        }
        let (own, table) = (v - g * low, a * w * (w * (t + low)).cos());
        assert!((blow.time - t - low).abs() < 1e-11, "{} {}", blow.time, t + low);
        let (before, after) = blow.velocities.unwrap();
        assert!((before - (table - own)).abs() < 1e-9 && (after + e * before).abs() < 1e-14);
        (t, y, v) = (t + low, a * (w * (t + low)).sin(), table + e * (table - own));
    }
    assert!(energy(&motion) < 1e-12, "{}", energy(&motion));
}

/// Two equal bodies that hit two equal stops at one instant, on a common middle: they stay equal. A body on another one that rests on a
/// stop passes a blow of the upper one on.
#[test]
fn stops_that_are_hit_at_one_instant() {
    let (m, middle, k, c) = (1.0, 0.7, 30.0, 0.4);
    let model = Model {
        mass: vec![vec![m, 0.0, 0.0], vec![0.0, middle, 0.0], vec![0.0, 0.0, m]],
        damping: vec![vec![c, 0.0, 0.0], vec![0.0, 0.0, 0.0], vec![0.0, 0.0, c]],
        stiffness: vec![vec![2.0 * k, -k, 0.0], vec![-k, 2.0 * k, -k], vec![0.0, -k, 2.0 * k]],
        elements: vec![
            stop(vec![1.0, 0.0, 0.0], 0.03, 0.6),
            stop(vec![0.0, 0.0, 1.0], 0.03, 0.6),
            rub(vec![1.0, 0.0, 0.0], 0.4, 1.0),
            rub(vec![0.0, 0.0, 1.0], 0.4, 1.0),
        ],
        harmonics: vec![Harmonic { frequency: 5.0, sin: vec![0.0, 9.0, 0.0], cos: vec![] }],
        ..Model::default()
    };
    let motion = System::new(&model).unwrap().simulate(&State::rest(3), 60.0).unwrap();
    let own = |i: usize| motion.events.iter().filter(|e| e.element == i).collect::<Vec<_>>();
    assert!(own(0).len() > 50);
    for (a, b) in own(0).iter().zip(own(1)) {
        assert!(a.kind == b.kind && (a.time - b.time).abs() < 1e-12, "{a:?} {b:?}");
    }
    assert!((motion.end.displacement[0] - motion.end.displacement[2]).abs() < 1e-12);
    // The lower body rests on its stop, and the upper one falls on it: ξ = (v₁ + e v, …) ≤ 0 for both stops gives v₁₊ = 0.
    let g = 9.81;
    let model = Model {
        mass: vec![vec![2.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.0; 2]; 2],
        stiffness: vec![vec![0.0; 2]; 2],
        constant: vec![2.0 * g, g],
        elements: vec![stop(vec![1.0, 0.0], 0.0, 0.3), stop(vec![-1.0, 1.0], 0.0, 0.5)],
        ..Model::default()
    };
    let motion = System::new(&model).unwrap().simulate(&at(vec![0.0, -0.2]), 3.0).unwrap();
    let v = (2.0 * g * 0.2_f64).sqrt();
    let due = v / g + 2.0 * 0.5 * v / (g * 0.5);
    let [close] = of(&motion, EventKind::Close)[..] else { panic!("{:?}", motion.events) };
    assert!(close.element == 1 && (close.time - due).abs() < 1e-13, "{close:?} {due}");
    assert!(motion.max_displacement[0] < 1e-15 && motion.min_displacement[0] > -1e-15);
    assert!((motion.elements[1].work - g * 0.2).abs() < 1e-12 && energy(&motion) < 1e-13);
    assert!((motion.end.force[0] - 3.0 * g).abs() < 1e-12 && (motion.end.force[1] - g).abs() < 1e-12);
}

/// A stuck contact that a blow sets in motion through the mass matrix slips at once.
#[test]
fn a_blow_sets_a_stuck_contact_in_motion() {
    let model = Model {
        mass: vec![vec![2.0, 0.5], vec![0.5, 1.0]],
        damping: vec![vec![0.0; 2]; 2],
        stiffness: vec![vec![0.0, 0.0], vec![0.0, 40.0]],
        elements: vec![rub(vec![1.0, 0.0], 30.0, 1.0), stop(vec![0.0, 1.0], 0.1, 0.5)],
        ..Model::default()
    };
    let motion = System::new(&model).unwrap().simulate(&at(vec![0.0, -0.2]), 2.0).unwrap();
    let blow = of(&motion, EventKind::Blow)[0];
    let slips = of(&motion, EventKind::Slip);
    assert!(slips.iter().any(|slip| slip.time == blow.time), "{:?}", motion.events);
    assert!(energy(&motion) < 1e-13);
}

/// A body at rest whose upper body a blow turns slips once: rounding that was left to its velocity when it came to rest is no direction.
#[test]
fn a_contact_at_rest_slips_once_where_a_blow_turns_what_slides_on_it() {
    for i in 0..40 {
        let model = Model {
            mass: vec![vec![1.1, 0.0], vec![0.0, 1.0]],
            damping: vec![vec![0.0; 2]; 2],
            stiffness: vec![vec![7.0, 0.0], vec![0.0, 0.0]],
            constant: vec![2.0, 0.0],
            elements: vec![
                rub(vec![1.0, 0.0], 3.0, 1.0),
                rub(vec![-1.0, 1.0], 2.0, 1.0),
                stop(vec![0.0, -1.0], 0.15, 0.5),
            ],
            ..Model::default()
        };
        let start = State { velocity: vec![-0.05 - 0.002 * f64::from(i), -1.0], ..State::rest(2) };
        let motion = System::new(&model).unwrap().simulate(&start, 0.25).unwrap();
        let blow = of(&motion, EventKind::Blow)[0].time;
        let own: Vec<_> = motion.events.iter().filter(|e| e.element == 0).map(|e| (e.kind, e.time)).collect();
        assert!(own.len() == 2 && own[0].0 == EventKind::Stick && own[0].1 < blow, "{i}: {own:?}");
        assert_eq!(own[1], (EventKind::Slip, blow), "{i}: {own:?}");
        assert!(motion.end.velocity[0] > 0.0);
    }
}

/// A body between a wall that gives no velocity back and a heavier one that presses it there: their blows take turns ever sooner, until both are at one
/// instant, after which the motion goes on.
#[test]
fn blows_of_a_body_between_two_others_take_turns_to_an_end() {
    let model = Model {
        mass: vec![vec![0.69, 0.0, 0.0], vec![0.0, 0.6, 0.0], vec![0.0, 0.0, 1.74]],
        damping: vec![vec![1.508, -0.561, 0.0], vec![-0.561, 1.775, -0.25], vec![0.0, -0.25, 1.05]],
        stiffness: vec![vec![68.13, -37.96, 0.0], vec![-37.96, 111.14, -57.21], vec![0.0, -57.21, 57.21]],
        constant: vec![-0.289, -7.954, 0.0],
        elements: vec![
            rub(vec![0.0, -1.0, 0.0], 3.944, 1.0),
            rub(vec![0.0, 0.0, -1.0], 2.301, 1.0),
            stop(vec![-1.0, 0.0, 1.0], 0.1967, 0.47),
            stop(vec![1.0, 0.0, 0.0], 0.0419, 0.0),
        ],
        harmonics: vec![Harmonic {
            frequency: 2.681,
            sin: vec![13.77, -18.02, -7.595],
            cos: vec![4.827, -3.664, 1.663],
        }],
        ..Model::default()
    };
    let (rubs, walls): (Vec<&Element<f64>>, Vec<&Element<f64>>) =
        model.elements.iter().partition(|element| matches!(element.kind, Kind::Contact { .. }));
    let rubs = rubs.iter().map(|element| match &element.kind {
        Kind::Contact { law, peak, .. } => {
            Rub { b: element.direction.clone(), friction: law.points[0].1, peak: *peak, under: None }
        }
        other => panic!("{other:?}"),
    });
    let walls = walls.iter().map(|element| match element.kind {
        Kind::HardStop { gap, restitution } => Wall { b: element.direction.clone(), gap, e: restitution },
        ref other => panic!("{other:?}"),
    });
    let machine = Machine::new(&model, rubs.collect(), walls.collect());
    let start = at(vec![0.0; 3]);
    let motion = System::new(&model).unwrap().simulate(&start, 3.0).unwrap();
    assert!(energy(&motion) < 1e-12, "{}", energy(&motion));
    let blows = of(&motion, EventKind::Blow);
    let turns = blows.windows(2).filter(|pair| pair[1].time - pair[0].time < 1e-4).count();
    assert!(turns >= 3, "{blows:?}");
    let (end, _) = machine.followed(&[0.0; 6], 3.0, 0.002);
    for (own, due) in motion.end.displacement.iter().chain(&motion.end.velocity).zip(&end) {
        assert!((own - due).abs() < 1e-8, "{:?} {end:?}", motion.end);
    }
}

/// The slider of an elastic contact stops with the body that a stop halts: once, and in any units of length and force.
#[test]
fn an_elastic_contact_locks_where_a_stop_halts_the_body() {
    let (mass, spring, stiffness, friction, load, gap) = (1.5_f64, 50.0, 132.0, 2.7, 20.0, 0.1);
    // It yields at x = friction/stiffness, and arrives under the load less the friction.
    let held = ((spring + stiffness) / mass).sqrt();
    let begin = friction / stiffness;
    let yields = (1.0 - begin * (spring + stiffness) / load).acos() / held;
    let speed = load / (spring + stiffness) * held * (held * yields).sin();
    let (free, middle) = ((spring / mass).sqrt(), (load - friction) / spring);
    let (cosine, sine) = (begin - middle, speed / free);
    let turned = sine.atan2(cosine) - ((gap - middle) / cosine.hypot(sine)).acos();
    let arrives = yields + turned / free;
    for (length, force) in [(1.0, 1.0), (1e3, 1.0), (1e3, 1e-3), (0.37, 2.9)] {
        let per = force / length;
        for e in [0.0, 0.3] {
            let kind = Kind::Elastic { stiffness: stiffness * per, friction: friction * force, normal: None };
            let elements = vec![element("slider", vec![1.0], kind), stop(vec![1.0], gap * length, e)];
            let model =
                Model { constant: vec![load * force], ..body(mass * per, 0.0, spring * per, elements) };
            let motion = System::new(&model).unwrap().simulate(&at(vec![0.0]), 3.0).unwrap();
            let (yielded, locked) = (of(&motion, EventKind::Yield), of(&motion, EventKind::Lock));
            assert_eq!(yielded.len(), locked.len(), "{length} {force} {e}: {:?}", motion.events);
            assert!((yielded[0].time - yields).abs() < 1e-13 && (locked[0].time - arrives).abs() < 1e-13);
            let slides: f64 = yielded.iter().zip(&locked).map(|(y, l)| l.time - y.time).sum();
            assert!((motion.elements[0].time_at_rest - (3.0 - slides)).abs() < 1e-12, "{length} {force} {e}");
            // Without restitution the body stays, so that its slider never slides again.
            assert!(e > 0.0 || locked.len() == 1, "{length} {force}: {:?}", motion.events);
        }
    }
}

/// What is no stop with a restitution is refused.
#[test]
fn wrong_stops_are_refused() {
    let system = |gap: f64, e: f64| System::new(&body(1.0, 0.0, 1.0, vec![stop(vec![1.0], gap, e)]));
    let text = |e: Error| e.to_string();
    assert_eq!(text(system(0.1, 1.25).unwrap_err()), "stop: restitution = 1.25 must be ≤ 1");
    assert_eq!(text(system(0.1, -0.5).unwrap_err()), "stop: restitution = -0.5 must be ≥ 0");
    assert!(system(0.1, f64::NAN).is_err() && system(f64::INFINITY, 0.5).is_err());
    let beyond = system(0.1, 0.5).unwrap().simulate(&at(vec![0.3]), 1.0).unwrap_err();
    assert!(text(beyond).starts_with("stop: displacement beyond its gap by 0.19999999999999998 must be ≤ 0"));
    assert!(system(0.1, 0.5).unwrap().simulate(&at(vec![0.1]), 1.0).is_ok());
    let moved = Moved { coordinate: 0, by: MovedBy::Velocity, signal: Signal::constant(1.0) };
    let model = Model { moved: vec![moved], ..body(1.0, 0.0, 1.0, vec![stop(vec![1.0], 0.1, 0.5)]) };
    assert!(text(System::new(&model).unwrap_err()).starts_with("stop: direction must move a mass"));
}

/// Shaw and Holmes' oscillator: x″ + 2ζx′ + x = α cos(Ωt + φ), a stop at x = d. Its motion with one blow every n periods is that of the linear
/// equation from blow to blow: with x(0) = x(T) = d, x′(T) = v, x′(0) = −e v and T = 2πn/Ω, φ is what remains. The product of its multipliers is e² e^{−2ζT}.
#[test]
fn the_motion_of_one_blow_a_period_has_the_closed_form() {
    let mut seen = 0;
    let list = |values: [f64; 3]| values.into_iter();
    let cases = list([0.05, 0.1, 0.2]).flat_map(|zeta| list([1.7, 2.3, 4.2]).map(move |omega| (zeta, omega)));
    let walls = list([-0.1, 0.0, 0.1]).flat_map(|d| list([0.3, 0.5, 0.7]).map(move |e| (d, e)));
    for ((zeta, omega), (d, e)) in cases.flat_map(|case| walls.clone().map(move |wall| (case, wall))) {
        let load = Harmonic { frequency: omega, sin: vec![], cos: vec![1.0] };
        let model =
            Model { harmonics: vec![load], ..body(1.0, 2.0 * zeta, 1.0, vec![stop(vec![1.0], d, e)]) };
        let found = System::new(&model).unwrap().steady(&at(vec![d - 0.2])).unwrap();
        let blows = of(&found.motion, EventKind::Blow);
        if found.kind != SteadyKind::Periodic || blows.len() != 1 {
            continue;
        }
        let n = found.periods;
        seen += 1;
        // x = e^{−ζt}(A cos ω_d t + B sin ω_d t) + G cos(Ωt + φ − ψ).
        let (period, wd) = (TAU * n as f64 / omega, (1.0 - zeta * zeta).sqrt());
        let gain = 1.0 / (1.0 - omega * omega).hypot(2.0 * zeta * omega);
        let psi = (2.0 * zeta * omega).atan2(1.0 - omega * omega);
        let (s, c) = (wd * period).sin_cos();
        let decay = (-zeta * period).exp();
        // The load's part repeats itself: the free part has A = A(T), and its velocity jumps by −(1 + e) v.
        // A(1 − E c) = B E s, and (wd B − ζA) − [(wd B − ζ A) c − (wd A + ζ B) s] E = −(1 + e) v.
        let b = (1.0 - decay * c) / (decay * s);
        let speed = |a: f64, b: f64| wd * b - zeta * a;
        let jump = speed(1.0, b) - decay * (speed(1.0, b) * c - (wd + zeta * b) * s);
        // With A = a v: x(0) = a v + G cos θ = d, x′(0) = (speed) v − G Ω sin θ = −e v.
        let a = -(1.0 + e) / jump;
        let slope = speed(a, a * b) + e;
        // G² = (d − a v)² + (slope v/Ω)².
        let (p, q, r) = (a * a + slope * slope / (omega * omega), -2.0 * a * d, d * d - gain * gain);
        let root = (q * q - 4.0 * p * r).sqrt();
        let roots = [(-q + root) / (2.0 * p), (-q - root) / (2.0 * p)];
        let (v, after) = blows[0].velocities.unwrap();
        let by = roots.iter().map(|root| (v / root - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(by < 1e-13, "{zeta} {omega}: {v} {roots:?}");
        assert!((after + e * v).abs() < 1e-15);
        let theta = (slope * v / omega).atan2(d - a * v);
        // Ωt + φ − ψ at the blow, with the engine's phase 0 at time 0.
        let due = ((theta + psi) / omega).rem_euclid(TAU / omega);
        let apart = (blows[0].time - due).rem_euclid(TAU / omega);
        assert!(apart.min(TAU / omega - apart) < 1e-13, "{} {due}", blows[0].time);
        let product =
            found.multipliers.iter().fold((1.0, 0.0), |(x, y), (re, im)| (x * re - y * im, x * im + y * re));
        let wronski = e * e * (-2.0 * zeta * period).exp();
        assert!(
            (product.0 / wronski - 1.0).abs() < 1e-10 && product.1.abs() < 1e-10,
            "{product:?} {wronski}"
        );
        assert!(energy(&found.motion) < 1e-12);
    }
    assert!(seen >= 40, "{seen}");
}

/// `x″ + x = cos Ωt` with a stop at 0 and the restitution 0.8: the period of the motion of one blow doubles where a multiplier is −1, which the closed form
/// has at 2.653347727855322. There the multipliers of motions below it, by interpolation, are −1, too.
#[test]
fn the_period_doubles_where_the_closed_form_has_it() {
    let due = 2.653_347_727_855_322;
    let steady = |omega: f64, start: &State<f64>| {
        let load = Harmonic { frequency: omega, sin: vec![], cos: vec![1.0] };
        let model = Model { harmonics: vec![load], ..body(1.0, 0.0, 1.0, vec![stop(vec![1.0], 0.0, 0.8)]) };
        System::new(&model).unwrap().steady(start).unwrap()
    };
    // Their sum is smooth in Ω, and −1 − e² where one of them is −1. Other motions of this oscillator do not settle: each begins at the one before.
    let places: Vec<f64> = (0..8).map(|i| due - 0.01 - 0.01 * f64::from(i)).collect();
    let mut start = at(vec![-0.2]);
    let mut values: Vec<f64> = places
        .iter()
        .map(|&omega| {
            let found = steady(omega, &start);
            assert!(found.kind == SteadyKind::Periodic && found.periods == 1, "{omega}");
            start = found.start;
            found.multipliers.iter().map(|one| one.0).sum::<f64>() + 1.64
        })
        .collect();
    // Neville's scheme for the frequency at which the sum is that.
    let sums = values.clone();
    values.clone_from(&places);
    for k in 1..8 {
        for i in 0..8 - k {
            let (a, b) = (sums[i], sums[i + k]);
            values[i] = (a * values[i + 1] - b * values[i]) / (a - b);
        }
    }
    assert!((values[0] - due).abs() < 1e-9, "{} {due}", values[0]);
    let periods = |by: f64| steady(due + by, &steady(due - 0.01, &at(vec![-0.2])).start).periods;
    assert_eq!([periods(-1e-3), periods(1e-3)], [1, 2]);
}

/// A body a on a spring and a contact to the ground, perhaps with a body b on it; the last one has the load `F sin(ωt + φ)` and the stop.
struct Given {
    mass: &'static [f64],
    stiffness: &'static [f64],
    damping: &'static [f64],
    friction: f64,
    /// Gap and restitution.
    stop: [f64; 2],
    /// F, ω and φ.
    load: [f64; 3],
    start: f64,
    /// Displacements and velocities after 6.
    end: &'static [f64],
    /// Blows, reversals, rests and slips in their order.
    events: &'static str,
    /// The time of the last one.
    last: f64,
}

/// Machines of another program, a solver of differential equations with events at 10⁻¹², known to 3·10⁻¹¹.
#[test]
fn machines_of_another_program() {
    let cases = [
        Given {
            mass: &[0.551],
            stiffness: &[92.5],
            damping: &[0.477],
            friction: 4.355,
            stop: [0.173, 0.92],
            load: [28.9, 4.734, 1.302],
            start: -0.061,
            end: &[-0.41040952235379813, -0.10584010028816931],
            events: "brbslbrbrbrbrslrbrbrbrbrbrbslrbrbrbrbrbrbslrbrbrbrbrbrbsl",
            last: 5.609957498586235,
        },
        Given {
            mass: &[0.645],
            stiffness: &[112.2],
            damping: &[1.735],
            friction: 4.317,
            stop: [0.19, 0.62],
            load: [19.8, 13.109, 2.913],
            start: -0.097,
            end: &[-0.21786578475924903, 0.5279494525494318],
            events: "rrbrbrbrbrbrbrbrbrbrbrbrbr",
            last: 5.97728193292672,
        },
        Given {
            mass: &[1.841],
            stiffness: &[146.4],
            damping: &[0.5],
            friction: 1.864,
            stop: [0.289, 0.37],
            load: [22.7, 5.12, 1.932],
            start: 0.007,
            end: &[0.17466242437895252, 0.5889673455904407],
            events: "rrbrrrbrbrrr",
            last: 5.401137122860663,
        },
        Given {
            mass: &[0.597],
            stiffness: &[101.2],
            damping: &[0.863],
            friction: 2.814,
            stop: [0.176, 0.81],
            load: [27.8, 11.601, 5.46],
            start: -0.085,
            end: &[-0.312390939758232, -0.7614055077990067],
            events: "rbslrbrrrbrrrbrrrbrrrbrrrbrrrbrrrbrrrbrrrbrr",
            last: 5.81614739439442,
        },
        Given {
            mass: &[0.687, 2.034],
            stiffness: &[46.7, 168.6],
            damping: &[1.942, 1.115],
            friction: 1.533,
            stop: [0.071, 0.6],
            load: [25.4, 13.307, 0.854],
            start: -0.004,
            end: &[0.001274681795462712, -0.0954991478982993, -2.281099611930002, -1.1892467324179687],
            events: "lbrrrrbrrrrbrrrrbrrrrbrrrrbrrrrbr",
            last: 5.918384440918967,
        },
        Given {
            mass: &[2.143, 2.004],
            stiffness: &[69.4, 284.8],
            damping: &[0.167, 1.421],
            friction: 2.784,
            stop: [0.15, 0.66],
            load: [20.6, 3.331, 5.399],
            start: 0.005,
            end: &[-0.3704953469165788, -0.4295870850299542, 1.1153671366412896, 1.1650555217986622],
            events: "lrbrbbrrrbrbrrrrrbrbrrrrr",
            last: 5.837593553980526,
        },
    ];
    for case in cases {
        let n = case.mass.len();
        let zeros = || vec![vec![0.0; n]; n];
        let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
        for i in 0..n {
            mass[i][i] = case.mass[i];
            for (matrix, x) in [(&mut damping, case.damping[i]), (&mut stiffness, case.stiffness[i])] {
                matrix[i][i] += x;
                if let Some(below) = i.checked_sub(1) {
                    matrix[below][below] += x;
                    matrix[below][i] -= x;
                    matrix[i][below] -= x;
                }
            }
        }
        let unit =
            |place: usize, x: f64| -> Vec<f64> { (0..n).map(|i| if i == place { x } else { 0.0 }).collect() };
        let [amplitude, frequency, phase] = case.load;
        let (sin, cos) = (unit(n - 1, amplitude * phase.cos()), unit(n - 1, amplitude * phase.sin()));
        let [gap, e] = case.stop;
        let model = Model {
            mass,
            damping,
            stiffness,
            elements: vec![rub(unit(0, 1.0), case.friction, 1.0), stop(unit(n - 1, 1.0), gap, e)],
            harmonics: vec![Harmonic { frequency, sin, cos }],
            ..Model::default()
        };
        let motion = System::new(&model).unwrap().simulate(&at(vec![case.start; n]), 6.0).unwrap();
        let letter = |event: &Event<f64>| match event.kind {
            EventKind::Blow => 'b',
            EventKind::Reverse => 'r',
            EventKind::Stick => 's',
            EventKind::Slip => 'l',
            _ => '?',
        };
        assert_eq!(motion.events.iter().map(letter).collect::<String>(), case.events);
        assert!((motion.events.last().unwrap().time - case.last).abs() < 1e-11);
        for (x, due) in motion.end.displacement.iter().chain(&motion.end.velocity).zip(case.end) {
            assert!((x - due).abs() < 1e-11, "{x} {due}");
        }
        assert!(energy(&motion) < 1e-12);
    }
}

/// A random machine of one to three bodies for the engine, and for the small steps.
fn machine(random: &mut Random) -> (Model<f64>, State<f64>, Machine, f64) {
    let n = 1 + random.below(3) as usize;
    let zeros = || vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
    for i in 0..n {
        mass[i][i] = random.between(0.5, 2.0);
        for to in [i.checked_sub(1), (random.next() < 0.4 || i == 0).then_some(n)].into_iter().flatten() {
            let (k, c) = (random.between(10.0, 80.0), random.between(0.0, 0.6));
            for (matrix, x) in [(&mut stiffness, k), (&mut damping, c)] {
                matrix[i][i] += x;
                if to < n {
                    matrix[to][to] += x;
                    matrix[i][to] -= x;
                    matrix[to][i] -= x;
                }
            }
        }
    }
    if n > 1 && random.next() < 0.3 {
        let x = random.between(-0.2, 0.2);
        (mass[0][1], mass[1][0]) = (x, x);
    }
    let along = |random: &mut Random| -> Vec<f64> {
        let mut b = vec![0.0; n];
        let i = random.below(n as u64) as usize;
        b[i] = if random.next() < 0.5 { 1.0 } else { -1.0 };
        if n > 1 && random.next() < 0.3 {
            b[(i + 1) % n] = -b[i];
        }
        b
    };
    let restitution = |random: &mut Random| match random.below(8) {
        0 => 0.0,
        1 => 1.0,
        _ => random.between(0.05, 0.98),
    };
    let walls: Vec<Wall> = (0..1 + random.below(2))
        .map(|_| Wall { b: along(random), gap: random.between(0.02, 0.25), e: restitution(random) })
        .collect();
    let rubs: Vec<Rub> = (0..random.below(3))
        .map(|_| Rub { b: along(random), friction: random.between(0.5, 4.0), peak: 1.0, under: None })
        .collect();
    let harmonics: Vec<Harmonic<f64>> = (0..1 + random.below(2))
        .map(|_| Harmonic {
            frequency: random.between(2.0, 14.0),
            sin: (0..n).map(|_| random.between(-20.0, 20.0)).collect(),
            cos: (0..n).map(|_| random.between(-5.0, 5.0)).collect(),
        })
        .collect();
    let constant: Vec<f64> =
        (0..n).map(|_| if random.next() < 0.4 { random.between(-15.0, 15.0) } else { 0.0 }).collect();
    let elements = rubs.iter().map(|r| rub(r.b.clone(), r.friction, r.peak));
    let elements = elements.chain(walls.iter().map(|w| stop(w.b.clone(), w.gap, w.e))).collect();
    let model = Model { mass, damping, stiffness, elements, constant, harmonics, ..Model::default() };
    let machine = Machine::new(&model, rubs, walls);
    (model, at(vec![0.0; n]), machine, random.between(3.0, 6.0))
}

/// The events without those that are taken back at once: the small steps may find a wall that opens closed again by rounding, and open it anew.
fn lasting(events: &[Kept]) -> Vec<Kept> {
    let mut left: Vec<Kept> = Vec::new();
    for event in events {
        let taken_back = match event.kind {
            EventKind::Close => EventKind::Open,
            EventKind::Stick => EventKind::Slip,
            _ => EventKind::Blow,
        };
        let last = left.iter().rposition(|e| e.element == event.element);
        match last.filter(|&i| left[i].kind == taken_back && event.time - left[i].time < 1e-7) {
            Some(place) if taken_back != EventKind::Blow => drop(left.remove(place)),
            _ => left.push(*event),
        }
    }
    left
}

/// The events without those of ever smaller blows, whose number depends on where they are cut: those within the time before a contact at a
/// stop in which blows are below 10⁻³.
fn plain(events: &[Kept]) -> Vec<Kept> {
    let events = &lasting(events);
    let is_close = |e: &Kept| e.kind == EventKind::Close;
    let begins = |close: &Kept| {
        let mut first = close.time - 1e-9;
        for e in events.iter().rev().filter(|e| e.time <= close.time && e.element == close.element) {
            match e.kind {
                EventKind::Blow if e.speed < 1e-3 => first = e.time - 1e-9,
                EventKind::Close => {}
                _ => break,
            }
        }
        first
    };
    let spans: Vec<(f64, f64)> =
        events.iter().filter(|e| is_close(e)).map(|close| (begins(close), close.time + 1e-6)).collect();
    let is_in = |e: &Kept| spans.iter().any(|span| (span.0..=span.1).contains(&e.time));
    events.iter().filter(|e| is_close(e) || !is_in(e)).copied().collect()
}

/// How far a motion is from that of the small steps, in parts of the motion.
#[derive(Clone, Copy, Default)]
struct Judged {
    by: f64,
    /// Whether both multiply rounding so much that 256 bits judge.
    is_multiplied: bool,
}

/// How far the end of a motion at f64 is from that at 256 bits; infinite where the events differ, or without such numbers.
#[cfg(feature = "mp")]
fn from_exact(model: &Model<f64>, start: &State<f64>, until: f64, motion: &Motion<f64>) -> f64 {
    use crate::precise::{model as wide, state};
    use stickslip::Float;
    use stickslip::float::Mp;
    type Wide = Mp<4>;
    let exact = System::new(&wide::<Wide>(model)).unwrap();
    let exact = exact.simulate(&state(start), Wide::from_f64(until)).unwrap();
    // Blows are cut off where rounding says, and so sooner at f64.
    let told =
        |list: &[Kept]| plain(list).iter().map(|event| (event.element, event.kind)).collect::<Vec<_>>();
    let own: Vec<Kept> = motion.events.iter().map(Kept::of).collect();
    let wide: Vec<Kept> = exact
        .events
        .iter()
        .map(|event| Kept {
            time: event.time.to_f64(),
            element: event.element,
            kind: event.kind,
            speed: event.velocities.map_or(0.0, |pair| pair.0.to_f64()),
        })
        .collect();
    if told(&own) != told(&wide) {
        return f64::INFINITY;
    }
    let wide = exact.end.displacement.iter().chain(&exact.end.velocity);
    let own = motion.end.displacement.iter().chain(&motion.end.velocity);
    own.zip(wide).map(|(a, b)| (a - b.to_f64()).abs()).fold(0.0, f64::max)
}

#[cfg(not(feature = "mp"))]
fn from_exact(_: &Model<f64>, _: &State<f64>, _: f64, _: &Motion<f64>) -> f64 {
    f64::INFINITY
}

/// How far the end of a motion is from that of the small steps, in parts of the motion, where both have the same events; else where they differ.
///
/// Both are within 10⁻⁹, and their events within 10⁻⁷. Where a machine multiplies rounding so much that the small steps do not know their own end so
/// well, by steps of a fifth, by where they end ever smaller blows and by starts 10⁻¹³ apart, the motion has the events of that at 256 bits, is within
/// 10⁻⁹ of it, or ten times nearer to it than to the small steps, and within four times what the small steps know of their own.
fn beside(
    model: &Model<f64>,
    machine: &Machine,
    start: &State<f64>,
    until: f64,
    motion: &Motion<f64>,
) -> Result<Judged, String> {
    let told = motion.events.iter().filter(|event| event.kind != EventKind::Touch);
    let events: Vec<Kept> = told.map(Kept::of).collect();
    let size =
        [&motion.max_displacement, &motion.min_displacement, &motion.max_velocity, &motion.min_velocity]
            .into_iter()
            .flatten()
            .fold(0.1_f64, |most, x| most.max(x.abs()));
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
    let own_end = [&*motion.end.displacement, &*motion.end.velocity].concat();
    let mut last = String::new();
    let (mut ends, mut is_alike): (Vec<Vec<f64>>, bool) = (Vec::new(), false);
    // Finer steps where a short flight was passed over.
    for step in [0.01, 0.002, 0.0004] {
        let from = [&*start.displacement, &*start.velocity].concat();
        let (end, own) = machine.followed(&from, until, step);
        let by = apart(&own_end, &end);
        ends.push(end);
        let (a, b) = (plain(&events), plain(&own));
        // Two stops that close together may do so in either order.
        let ordered = |list: &[Kept]| -> Vec<Kept> {
            let (mut closes, others): (Vec<Kept>, Vec<Kept>) =
                list.iter().partition(|event| event.kind == EventKind::Close);
            closes.sort_by(|a, b| a.element.cmp(&b.element).then(a.time.total_cmp(&b.time)));
            [others, closes].concat()
        };
        let (a, b) = (ordered(&a), ordered(&b));
        // The small steps end ever smaller blows before the sum of their times.
        let is_same = |(a, b): (&Kept, &Kept)| {
            let within = if a.kind == EventKind::Close { 1e-3 } else { 1e-7 };
            (a.kind, a.element) == (b.kind, b.element) && (a.time - b.time).abs() < within
        };
        let names = |list: &[Kept]| list.iter().map(|e| (e.kind, e.element)).collect::<Vec<_>>();
        is_alike = names(&a) == names(&b);
        if is_alike && a.iter().zip(&b).all(is_same) && by < 1e-9 {
            return Ok(Judged { by, is_multiplied: false });
        }
        let first = a.iter().zip(&b).position(|pair| !is_same(pair));
        let first = first.unwrap_or(a.len().min(b.len()));
        let near = |list: &[Kept]| format!("{:?}", &list[first.saturating_sub(2)..list.len().min(first + 3)]);
        last = format!("by {by:e}, {} and {} events\n{}\n{}", a.len(), b.len(), near(&a), near(&b));
    }
    let by = apart(&own_end, &ends[2]);
    let from = [&*start.displacement, &*start.velocity].concat();
    ends.extend([1.6e-5, 2.5e-7].map(|slow| machine.with_slow(slow).followed(&from, until, 0.002).0));
    // They know where an event is within some 10⁻¹³.
    for i in 0..from.len() {
        let mut from = from.clone();
        from[i] += 1e-13 * size;
        ends.push(machine.followed(&from, until, 0.002).0);
    }
    let known = ends.iter().map(|end| apart(end, &ends[2])).fold(0.0, f64::max);
    let exact = if is_alike { from_exact(model, start, until, motion) / size } else { f64::INFINITY };
    if (exact < 1e-9 || exact < 0.1 * by) && by < 4.0 * known {
        println!("by {by:e} of small steps that know their end within {known:e}, {exact:e} of 256 bits");
        return Ok(Judged { by, is_multiplied: true });
    }
    Err(format!("{known:e} of its own, {exact:e} of 256 bits, {last}"))
}

/// Random machines beside an independent program: the same events, and the same end.
#[test]
fn random_machines_are_those_of_small_steps() {
    let mut random = Random(760);
    let (mut compared, mut blows, mut closes, mut opens, mut multiplied) = (0, 0, 0, 0, 0);
    let mut worst: f64 = 0.0;
    let mut failed = Vec::new();
    for number in 0..crate::count(40, 500) {
        let (model, start, machine, until) = machine(&mut random);
        let motion = match System::new(&model).and_then(|system| system.simulate(&start, until)) {
            Ok(motion) => motion,
            Err(error) => panic!("{number}: {error}\n{model:?}"),
        };
        assert!(energy(&motion) < 1e-12, "{number}: {}", energy(&motion));
        match beside(&model, &machine, &start, until, &motion) {
            Ok(Judged { is_multiplied: true, .. }) => multiplied += 1,
            Ok(Judged { by, .. }) => worst = worst.max(by),
            Err(why) => failed.push(format!("{number}: {why}\n{model:?}")),
        }
        compared += 1;
        let count = |kind| of(&motion, kind).len();
        (blows, closes, opens) = (
            blows + count(EventKind::Blow),
            closes + count(EventKind::Close),
            opens + count(EventKind::Open),
        );
    }
    println!(
        "{compared} machines, {blows} blows, {closes} contacts, {opens} of them opened, worst {worst:e}, {multiplied} beside 256 bits"
    );
    assert!(failed.is_empty(), "{} of {compared}\n{}", failed.len(), failed.join("\n"));
    // Few machines multiply rounding so much.
    assert!(multiplied * 100 <= compared, "{multiplied} of {compared}");
    assert!(blows > 10 * compared && closes > compared / 4 && opens > 0, "{blows} {closes} {opens}");
}

/// The steady motions of random machines come back to their start in the small steps, and their multipliers add up to the trace of the
/// differences of these.
#[test]
fn steady_motions_and_their_multipliers_are_those_of_small_steps() {
    let mut random = Random(761);
    let (mut closed, mut traces, mut blows, mut touching, mut unsettled, mut endless) = (0, 0, 0, 0, 0, 0);
    for number in 0..crate::count(40, 300) {
        let (mut model, start, _, _) = machine(&mut random);
        model.harmonics.truncate(1);
        (0..model.mass.len()).for_each(|i| model.damping[i][i] += 0.8);
        let rubs = model.elements.iter().filter_map(|element| match &element.kind {
            Kind::Contact { law, peak, .. } => Some(Rub {
                b: element.direction.clone(),
                friction: law.points[0].1,
                peak: *peak,
                under: None,
            }),
            _ => None,
        });
        let walls = model.elements.iter().filter_map(|element| match element.kind {
            Kind::HardStop { gap, restitution } => {
                Some(Wall { b: element.direction.clone(), gap, e: restitution })
            }
            _ => None,
        });
        let machine = Machine::new(&model, rubs.collect(), walls.collect());
        let is_elastic =
            |e: &Element<f64>| matches!(e.kind, Kind::HardStop { restitution, .. } if restitution == 1.0);
        let found = match System::new(&model).unwrap().steady(&start) {
            Ok(found) => found,
            // A friction that turns takes a part of the velocity of elastic blows in each period, and nothing ends them: flights become ever
            // shorter and more, in an independent program, too.
            Err(Error::TooLong { .. }) if model.elements.iter().any(is_elastic) => {
                endless += 1;
                continue;
            }
            Err(error) => panic!("{number}: {error}\n{model:?}"),
        };
        let largest = found.multipliers.iter().map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
        let of_blows = of(&found.motion, EventKind::Blow).len();
        if found.kind != SteadyKind::Periodic || found.periods > 4 || of_blows == 0 {
            unsettled += usize::from(found.kind != SteadyKind::Periodic);
            continue;
        }
        assert!(energy(&found.motion) < 1e-11, "{number}: {}", energy(&found.motion));
        let first = [&*found.start.displacement, &*found.start.velocity].concat();
        let n = model.mass.len();
        // A contact at rest, or a body at a stop, at the beginning has another mode there in the small steps.
        let is_clear = model.elements.iter().all(|element| {
            let along = |x: &[f64]| element.direction.iter().zip(x).map(|(b, x)| b * x).sum::<f64>();
            match element.kind {
                Kind::HardStop { gap, .. } => gap - along(&first[..n]) > 1e-3,
                _ => along(&first[n..]).abs() > 1e-3,
            }
        });
        if !is_clear {
            touching += 1;
            continue;
        }
        let map = |from: &[f64]| machine.followed(from, found.period, 0.005).0;
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = first.iter().fold(0.1_f64, |most, x| most.max(x.abs()));
        let back = map(&first);
        assert!(apart(&back, &first) < 1e-9 * size, "{number}: {back:?} {first:?}\n{model:?}");
        closed += 1;
        blows += of_blows;
        let sum: f64 = found.multipliers.iter().map(|one| one.0).sum();
        let h = 1e-6;
        let mut trace = 0.0;
        for i in 0..2 * n {
            let moved = |by: f64| {
                let mut from = first.clone();
                from[i] += by;
                map(&from)[i]
            };
            trace += (moved(h) - moved(-h)) / (2.0 * h);
        }
        // The map has a corner where a blow begins or ends within h.
        if (trace - sum).abs() < 1e-4 * (1.0 + largest) {
            traces += 1;
        } else {
            println!("{number}: {trace} {sum} {largest}\n{:?}", found.motion.events);
        }
    }
    println!(
        "{closed} closed, {traces} traces, {blows} blows, {touching} touch at the beginning, {unsettled} unsettled, {endless} with ever more elastic blows"
    );
    assert!(endless * 100 <= crate::count(40, 300), "{endless}");
    assert!(closed > crate::count(10, 100) && traces * 10 >= closed * 9, "{closed} {traces}");
}
