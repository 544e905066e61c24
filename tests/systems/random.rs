//! Random systems against an independent check, symmetric ones, and ones whose contacts have dependent directions.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

#[cfg(feature = "generators")]
#[path = "../invariants/blows.rs"]
mod blows;
#[cfg(feature = "generators")]
#[path = "../invariants/systems.rs"]
pub(crate) mod systems;

use crate::closed_form::contact;
use crate::generator::Random;
use stickslip::system::{
    Beyond, Element, EventKind, Harmonic, Kind, Law, Model, Record, Signal, State, System,
};

/// Two equal halves: what happens on one side happens on the other at the same instant, without a loop and without a slip.
#[test]
fn symmetric_structures() {
    let mut random = Random(6);
    let mut events = 0;
    for number in 0..300 {
        let (m, k, c) = (random.between(0.5, 2.0), random.between(1.0, 6.0), random.between(0.05, 0.5));
        let (middle, join) = (random.between(0.5, 2.0), random.between(0.5, 4.0));
        let peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 1.6) };
        let friction = random.between(0.1, 0.6);
        let element = |at: usize, sign: f64| Element {
            name: format!("{at}"),
            direction: (0..3).map(|i| if i == at { sign } else { 0.0 }).collect(),
            moves: Signal::constant(0.0),
            kind: Kind::Contact { law: Law::constant(friction), peak, normal: None },
        };
        // The bodies 0 and 2 are equal, and hang on the body 1.
        let model = Model {
            mass: vec![vec![m, 0.0, 0.0], vec![0.0, middle, 0.0], vec![0.0, 0.0, m]],
            damping: vec![vec![c, 0.0, 0.0], vec![0.0, c, 0.0], vec![0.0, 0.0, c]],
            stiffness: vec![
                vec![k + join, -join, 0.0],
                vec![-join, 2.0 * join, -join],
                vec![0.0, -join, k + join],
            ],
            elements: vec![element(0, 1.0), element(2, if random.next() < 0.5 { 1.0 } else { -1.0 })],
            harmonics: vec![Harmonic {
                frequency: random.between(0.3, 3.0),
                sin: vec![0.0, random.between(0.5, 3.0), 0.0],
                cos: vec![],
            }],
            ..Model::default()
        };
        let system = System::new(&model).expect("valid");
        let period = std::f64::consts::TAU / model.harmonics[0].frequency;
        let motion = system
            .simulate(&State::rest(3), 40.0 * period)
            .unwrap_or_else(|e| panic!("{number}: {e}\n{model:?}"));
        let of = |i: usize| motion.events.iter().filter(|e| e.element == i).collect::<Vec<_>>();
        let (one, other) = (of(0), of(1));
        assert_eq!(one.len(), other.len(), "{number}: {:?}\n{model:?}", motion.events);
        for (a, b) in one.iter().zip(&other) {
            assert!(a.kind == b.kind && (a.time - b.time).abs() < 1e-9 * period, "{number}: {a:?} {b:?}");
        }
        for pair in one.windows(2) {
            assert!(pair[1].time - pair[0].time > 1e-6 * period, "{number}: {pair:?}\n{model:?}");
        }
        events += one.len();
    }
    assert!(events > 3_000, "{events}");
}

/// A body on the ground with a second one on it, and loads that grow and turn.
fn pair(elements: Vec<Element<f64>>, force: Vec<f64>) -> Model<f64> {
    Model {
        mass: vec![vec![2.0, 0.0], vec![0.0, 1.0]],
        damping: vec![vec![0.2, -0.1], vec![-0.1, 0.1]],
        stiffness: vec![vec![3.0, -1.0], vec![-1.0, 1.0]],
        elements,
        records: vec![Record {
            times: vec![0.0, 2.0, 4.0, 6.0, 9.0],
            values: vec![0.0, 4.0, -4.0, 3.0, 0.0],
            force,
            beyond: Beyond::Zero,
        }],
        ..Model::default()
    }
}

/// Contacts of one direction are one contact, with the sum of their frictions at rest and in motion, whatever their order.
#[test]
fn equal_directions_add_their_frictions() {
    let mut random = Random(7);
    let mut events = 0;
    for number in 0..200 {
        let force = vec![random.between(0.2, 1.0), random.between(-1.0, 1.0)];
        let (kinetic, peaks) =
            ([0.1, 0.3, 0.5].map(|r| r * random.between(0.5, 1.0)), [1.0, random.between(1.0, 1.5), 1.2]);
        let parts: Vec<_> = (0..3)
            .map(|i| contact(vec![if i == 1 { -1.0 } else { 1.0 }, 0.0], kinetic[i], peaks[i]))
            .collect();
        let sum: f64 = kinetic.iter().sum();
        let held: f64 = kinetic.iter().zip(&peaks).map(|(r, p)| r * p).sum();
        let one =
            System::new(&pair(vec![contact(vec![1.0, 0.0], sum, held / sum)], force.clone())).expect("valid");
        let expected = one.simulate(&State::rest(2), 12.0).expect("it moves");
        for order in [[0, 1, 2], [2, 0, 1], [1, 2, 0]] {
            let elements = order.iter().map(|&i| parts[i].clone()).collect();
            let system = System::new(&pair(elements, force.clone())).expect("valid");
            let motion = system.simulate(&State::rest(2), 12.0).expect("it moves");
            for (a, b) in [
                (&motion.end.displacement, &expected.end.displacement),
                (&motion.end.velocity, &expected.end.velocity),
                (&motion.max_velocity, &expected.max_velocity),
            ] {
                let by = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(by < 1e-12, "{number}, {order:?}: by {by:e}");
            }
            // Each event is one of all three.
            for (k, event) in expected.events.iter().enumerate() {
                let all: Vec<_> = motion.events.iter().skip(3 * k).take(3).collect();
                let same = |e: &&stickslip::system::Event<f64>| {
                    e.kind == event.kind && (e.time - event.time).abs() < 1e-11
                };
                assert!(all.len() == 3 && all.iter().all(same), "{number}, {order:?}: {all:?} for {event:?}");
            }
            events += motion.events.len();
        }
    }
    assert!(events > 2_000, "{events}");
}

/// A loop of three contacts: the ground and the first body, the two bodies, the second body and the ground. It holds as
/// long as the forces lie in the hexagon of what the three can hold; the release is its edge, by hand.
#[test]
fn a_loop_of_contacts_lets_go_at_the_edge_of_what_it_holds() {
    let mut random = Random(8);
    let mut seen = [0; 3];
    for number in 0..300 {
        let r = [random.between(0.2, 1.0), random.between(0.2, 1.0), random.between(0.2, 1.0)];
        let force = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        // With forces (f, g): |f| ≤ r₀ + r₁, |g| ≤ r₁ + r₂, |f + g| ≤ r₀ + r₂.
        let edges = [
            (force[0].abs(), r[0] + r[1], [0, 1]),
            (force[1].abs(), r[1] + r[2], [1, 2]),
            ((force[0] + force[1]).abs(), r[0] + r[2], [0, 2]),
        ];
        let (edge, level) = edges
            .iter()
            .enumerate()
            .map(|(i, (by, bound, _))| (i, bound / by))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .expect("three");
        if level > 3.9 {
            continue;
        }
        seen[edge] += 1;
        let directions = [vec![1.0, 0.0], vec![-1.0, 1.0], vec![0.0, 1.0]];
        let order = [[0, 1, 2], [2, 1, 0], [1, 2, 0]][number % 3];
        let elements = order.iter().map(|&i| contact(directions[i].clone(), r[i], 1.0)).collect();
        let system = System::new(&pair(elements, force.to_vec())).expect("valid");
        let motion = system.simulate(&State::rest(2), 4.0).expect("it moves");
        // The load is 2t up to 2.
        let first: Vec<_> = motion.events.iter().take(2).collect();
        let mut slipped: Vec<usize> = first.iter().map(|e| order[e.element]).collect();
        slipped.sort_unstable();
        assert!(
            first.iter().all(|e| e.kind == EventKind::Slip && (e.time - level / 2.0).abs() < 1e-13),
            "{number}: {first:?} for {level}"
        );
        assert_eq!(slipped, edges[edge].2, "{number}");
    }
    assert!(seen.iter().all(|&n| n > 20), "{seen:?}");
}

/// A block between two belts of one direction, which move apart as the cube of time: nothing up to the second derivative
/// tells which holds it. The stronger does.
#[test]
fn the_stronger_of_two_belts_holds() {
    // sin ωt and sin 3ωt/3 begin alike.
    for stronger in [0, 1] {
        let belt = |i: usize| Element {
            moves: Signal {
                sin: if i == 0 { vec![1.0, 0.0] } else { vec![0.0, 1.0 / 3.0] },
                ..Signal::constant(0.0)
            },
            ..contact(vec![1.0], if i == stronger { 5.0 } else { 1.0 }, 1.0)
        };
        let harmonic = |frequency: f64| Harmonic { frequency, sin: Vec::new(), cos: Vec::new() };
        let model = Model {
            mass: vec![vec![1.0]],
            damping: vec![vec![0.0]],
            stiffness: vec![vec![0.0]],
            elements: vec![belt(0), belt(1)],
            harmonics: vec![harmonic(1.0), harmonic(3.0)],
            ..Model::default()
        };
        let system = System::new(&model).expect("valid");
        for time in [0.01_f64, 0.1, 0.3] {
            let state = &system.states(&State::rest(1), &[time]).expect("it moves")[0];
            let belts = [time.sin(), (3.0 * time).sin() / 3.0];
            assert!((state.velocity[0] - belts[stronger]).abs() < 1e-14, "{stronger} at {time}: {state:?}");
        }
    }
}

/// A belt that stops for an instant carries a body on, whose friction on the ground is more than the belt could overcome if it turned: the velocity
/// 0.25 (1 − sin 0.5t) is a difference, whose rounding is no turn.
#[test]
fn a_belt_that_stops_for_an_instant_carries_on() {
    let belt = Signal { constant: 0.25, sin: vec![-0.25], ..Signal::constant(0.0) };
    let model = Model {
        mass: vec![vec![0.5]],
        constant: vec![2.67],
        elements: vec![
            contact(vec![1.0], 1.625, 1.0),
            Element { moves: belt, ..contact(vec![1.0], 0.875, 1.75) },
        ],
        harmonics: vec![Harmonic { frequency: 0.5, sin: vec![0.0], cos: vec![] }],
        ..Model { damping: vec![vec![0.0]], stiffness: vec![vec![0.0]], ..Model::default() }
    };
    let system = System::new(&model).expect("valid");
    let start = State { velocity: vec![0.25], ..State::rest(1) };
    for parts in 150..400 {
        let times: Vec<f64> = (1..=parts).map(|i| 16.0 * f64::from(i) / f64::from(parts)).collect();
        let states = system.states(&start, &times).expect("it moves");
        for (state, t) in states.iter().zip(&times) {
            let due = [0.25 * t - 0.5 * (1.0 - (0.5 * t).cos()), 0.25 * (1.0 - (0.5 * t).sin())];
            let by = (state.displacement[0] - due[0]).abs().max((state.velocity[0] - due[1]).abs());
            assert!(by < 1e-13, "{parts}: by {by:e} at {t}: {state:?}");
        }
    }
}

#[cfg(feature = "generators")]
mod any {
    use super::systems;
    use crate::drawn::cases;
    use arbitrary::{Arbitrary, Unstructured};
    use core::cell::Cell;
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;
    use stickslip::generators::Structure;
    use stickslip::system::{Element, Kind, Model};

    pub(super) fn run() {
        let most = crate::count(150, 20_000);
        let samples = if most > 150 { 200 } else { 60 };
        let (events, balances, slips) = (Cell::new(0), Cell::new(0), Cell::new(0));
        let (energy, parts) = (Cell::new(0.0_f64), Cell::new(0.0_f64));
        let endless = Cell::new(0);
        // Flights without a loss may shrink by a hundredth each, and end in rounding before their sum is known. A joint without mass may stop
        // and lock so soon after each other that rounding cannot tell which comes first.
        let may_end = |model: &Model<f64>| {
            let is_elastic = |element: &Element<f64>| matches!(element.kind, Kind::HardStop { restitution, .. } if restitution == 1.0);
            let has_joint = model.mass.iter().enumerate().any(|(i, row)| row[i] == 0.0);
            has_joint || model.elements.iter().any(is_elastic)
        };
        let bytes = proptest::collection::vec(any::<u8>(), 300..900);
        TestRunner::new(cases(u32::try_from(most).expect("few")))
            .run(&bytes, |bytes| {
                let structure = Structure::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
                let seen = systems::motion(&structure, samples);
                if seen.samples == 0 {
                    assert!(may_end(&structure.model), "rounding cannot tell the events");
                    endless.set(endless.get() + 1);
                }
                events.set(events.get() + seen.events);
                balances.set(balances.get() + seen.balances);
                slips.set(slips.get() + systems::slips(&structure));
                energy.set(energy.get().max(seen.energy));
                parts.set(parts.get().max(seen.parts));
                Ok(())
            })
            .unwrap();
        println!(
            "{most} systems: {} events, {} balances, {} slips, energy by {:e}, parts by {:e}, {} without an answer",
            events.get(),
            balances.get(),
            slips.get(),
            energy.get(),
            parts.get(),
            endless.get()
        );
        assert!(endless.get() * 2_000 <= most, "{} of {most}", endless.get());
        assert!(events.get() > 5 * most, "{} events", events.get());
        assert!(balances.get() > 20 * most, "{} balances", balances.get());
        assert!(slips.get() > most / 10, "{} slips", slips.get());
    }
}

/// Systems of all kinds: laws, momentum, energy, extremes, releases, and the same motion in two parts.
#[cfg(feature = "generators")]
#[test]
fn every_element_obeys_its_law() {
    any::run();
}
