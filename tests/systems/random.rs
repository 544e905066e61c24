//! Random systems: at dense samples every element obeys its law, which no missed event would leave true, and energy
//! closes.

use crate::closed_form::Draw;
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Normal, Signal, State, System};

/// A chain of one to six bodies with one to four elements of all kinds.
pub(crate) fn system(draw: &mut Draw) -> Model<f64> {
    let pick = |draw: &mut Draw, n: usize| ((draw.unit() * n as f64) as usize).min(n - 1);
    let n = 1 + pick(draw, 6);
    let zero = vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zero.clone(), zero.clone(), zero);
    for i in 0..n {
        mass[i][i] = draw.within(0.4, 3.0);
        for (matrix, x) in [(&mut stiffness, draw.within(0.5, 10.0)), (&mut damping, draw.within(0.0, 0.4))] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i - 1][i] -= x;
                matrix[i][i - 1] -= x;
            }
        }
    }
    let base = draw.within(0.3, 3.0);
    let harmonics: Vec<_> = (0..=pick(draw, 3))
        .map(|k| Harmonic {
            frequency: base * (k + 1) as f64,
            sin: (0..n).map(|_| draw.within(-1.0, 1.0)).collect(),
            cos: if draw.unit() < 0.5 { vec![] } else { (0..n).map(|_| draw.within(-1.0, 1.0)).collect() },
        })
        .collect();
    let elements = (0..=pick(draw, 4)).map(|i| {
        let mut direction = vec![0.0; n];
        let at = pick(draw, n);
        direction[at] = 1.0;
        if at > 0 && draw.unit() < 0.4 {
            direction[at - 1] = -1.0;
        }
        let friction = draw.within(0.02, 0.8);
        let mut moves = Signal::constant(0.0);
        let kind = match pick(draw, 6) {
            0 => Kind::Elastic { stiffness: draw.within(1.0, 60.0), friction },
            1 => Kind::Stop {
                gap: draw.within(0.1, 1.0),
                stiffness: draw.within(5.0, 50.0),
                damping: draw.within(0.0, 0.4),
            },
            2 => {
                let rise = draw.within(-0.5, 0.5);
                let law =
                    Law { points: vec![(0.0, friction), (0.2, friction * (1.0 + rise)), (0.7, friction)] };
                Kind::Contact { law, peak: 1.0, normal: None }
            }
            3 => {
                let signal = Signal { constant: 1.0, sin: vec![draw.within(-1.3, 1.3)], cos: vec![] };
                let displacement =
                    if draw.unit() < 0.5 { vec![] } else { (0..n).map(|_| draw.within(-0.2, 0.2)).collect() };
                Kind::Contact {
                    law: Law::constant(friction),
                    peak: 1.0,
                    normal: Some(Normal { signal, displacement }),
                }
            }
            4 => {
                moves.constant = draw.within(-0.5, 0.5);
                Kind::Contact { law: Law::constant(friction), peak: draw.within(1.0, 1.5), normal: None }
            }
            _ => Kind::Contact { law: Law::constant(friction), peak: draw.within(1.0, 1.5), normal: None },
        };
        Element { name: format!("{i}"), direction, moves, kind }
    });
    let mut elements: Vec<_> = elements.collect();
    // Directions of contacts whose last bodies differ are independent, so that their forces are unique.
    let mut last = Vec::new();
    elements.retain(|element| {
        let place = element.direction.iter().rposition(|&b| b != 0.0);
        let is_contact = matches!(element.kind, Kind::Contact { .. });
        let is_new = !is_contact || !last.contains(&place);
        last.extend(is_contact.then_some(place));
        is_new
    });
    Model { mass, damping, stiffness, elements, harmonics, ..Model::default() }
}

/// What an element's law says of a state: an excess over rounding, if it is broken.
fn broken(
    element: &Element<f64>,
    model: &Model<f64>,
    time: f64,
    state: &State<f64>,
    force: f64,
) -> Option<String> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (y, v) = (dot(&element.direction, &state.displacement), dot(&element.direction, &state.velocity));
    let value = |signal: &Signal<f64>| {
        let waves = |list: &[f64], wave: fn(f64) -> f64| {
            list.iter().zip(&model.harmonics).map(|(x, h)| x * wave(h.frequency * time)).sum::<f64>()
        };
        signal.constant + waves(&signal.sin, f64::sin) + waves(&signal.cos, f64::cos)
    };
    let v = v - value(&element.moves);
    let doubt = 1e-9;
    let is_broken = match &element.kind {
        Kind::Contact { law, peak, normal } => {
            let load =
                normal.as_ref().map_or(1.0, |n| value(&n.signal) + dot(&n.displacement, &state.displacement));
            let load = load.max(0.0);
            let speed = v.abs();
            let line = |p: &[(f64, f64)]| p[0].1 + (p[1].1 - p[0].1) * (speed - p[0].0) / (p[1].0 - p[0].0);
            let pieces: Vec<_> = law.points.windows(2).collect();
            let r = match pieces.iter().rev().find(|p| p[0].0 <= speed) {
                Some(p) => line(p).max(0.0),
                None => law.points[0].1,
            };
            let sliding = (force - r * load * v.signum()).abs();
            let holds = force.abs() - peak * law.points[0].1 * load;
            if speed > doubt { sliding > doubt } else { holds > doubt }
        }
        Kind::Elastic { friction, .. } => force.abs() > friction + doubt,
        Kind::Stop { gap, stiffness, damping } => {
            let pressed = if y > *gap { (stiffness * (y - gap) + damping * v).max(0.0) } else { 0.0 };
            (force - pressed).abs() > doubt + if (y - gap).abs() < doubt { damping * v.abs() } else { 0.0 }
        }
    };
    is_broken.then(|| format!("y = {y}, v = {v}, T = {force}"))
}

fn check(number: usize, model: &Model<f64>, samples: u32) -> usize {
    let system = System::new(model).expect("valid");
    let start = State::rest(system.coordinates());
    let until = 5.0 * std::f64::consts::TAU / model.harmonics[0].frequency;
    let motion = system.simulate(&start, until).unwrap_or_else(|e| panic!("{number}: {e}\n{model:?}"));
    let times: Vec<f64> = (1..=samples).map(|i| until * f64::from(i) / f64::from(samples)).collect();
    for (state, &time) in system.states(&start, &times).expect("as before").iter().zip(&times) {
        for (i, element) in model.elements.iter().enumerate() {
            let fault = broken(element, model, time, state, state.force[i]);
            // An event within rounding of a sample may be on either side of it.
            let beside = motion.events.iter().any(|e| (e.time - time).abs() < 1e-9 * until);
            assert!(
                fault.is_none() || beside,
                "{number}: element {i} at {time}: {fault:?}\n{:?}\n{model:?}",
                motion.events
            );
        }
        for i in 0..model.mass.len() {
            let (q, v) = (state.displacement[i], state.velocity[i]);
            assert!(
                q <= motion.max_displacement[i] + 1e-11 && q >= motion.min_displacement[i] - 1e-11,
                "{number}: {i} {q} at {time} within {:?} {:?} {:?}\n{model:?}",
                motion.min_displacement,
                motion.max_displacement,
                motion.events
            );
            assert!(
                v <= motion.max_velocity[i] + 1e-11 && v >= motion.min_velocity[i] - 1e-11,
                "{number}: {v} within {} and {} at {time}\n{:?}\n{model:?}",
                motion.min_velocity[i],
                motion.max_velocity[i],
                motion.events
            );
        }
    }
    let works: f64 = motion.elements.iter().map(|e| e.work).sum();
    let left = motion.load_work - motion.damper_work - works - motion.stored;
    let size = motion.load_work.abs()
        + motion.damper_work
        + motion.elements.iter().map(|e| e.work.abs()).sum::<f64>();
    assert!(
        left.abs() <= 1e-12 * (size + motion.stored.abs() + 0.01),
        "{number}: energy by {left:e} of {size:e}\n{model:?}"
    );
    motion.events.len()
}

#[test]
fn every_element_obeys_its_law() {
    let mut draw = Draw(5);
    let mut events = 0;
    for number in 0..SYSTEMS {
        let model = system(&mut draw);
        events += check(number, &model, 300);
    }
    assert!(events > 10 * SYSTEMS, "{events}");
}

/// Of the 1,000 systems that were checked once.
const SYSTEMS: usize = 300;

/// Two equal halves: what happens on one side happens on the other at the same instant, without a loop and without a slip.
#[test]
fn symmetric_structures() {
    let mut draw = Draw(6);
    let mut events = 0;
    for number in 0..300 {
        let (m, k, c) = (draw.within(0.5, 2.0), draw.within(1.0, 6.0), draw.within(0.05, 0.5));
        let (middle, join) = (draw.within(0.5, 2.0), draw.within(0.5, 4.0));
        let peak = if draw.unit() < 0.5 { 1.0 } else { draw.within(1.0, 1.6) };
        let friction = draw.within(0.1, 0.6);
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
            elements: vec![element(0, 1.0), element(2, if draw.unit() < 0.5 { 1.0 } else { -1.0 })],
            harmonics: vec![Harmonic {
                frequency: draw.within(0.3, 3.0),
                sin: vec![0.0, draw.within(0.5, 3.0), 0.0],
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
