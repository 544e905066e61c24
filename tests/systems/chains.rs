//! Chains of many bodies, whose steps are the series of the state, beside those by matrices.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::count;
use crate::generator::Random;
use crate::long_steps::loads;
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Motion, Signal, State, System};

/// Twenty-five to fifty bodies on springs and dampers, in a row or with braces over two storeys, with contacts, elastic contacts, stops, belts and springs with
/// laws, under harmonics and records.
fn chain(random: &mut Random) -> Model<f64> {
    let n = 25 + (random.next() * 26.0) as usize;
    let zeros = || vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
    let damped = random.between(0.01, 0.1);
    let braced = random.next() < 0.5;
    for i in 0..n {
        mass[i][i] = random.between(0.5, 2.0);
        let reach = if braced && i > 1 && random.next() < 0.3 { 2 } else { 1 };
        let k = random.between(20.0, 60.0);
        for (matrix, x) in [(&mut stiffness, k), (&mut damping, damped * k)] {
            matrix[i][i] += x;
            if let Some(below) = i.checked_sub(reach) {
                matrix[below][below] += x;
                matrix[below][i] -= x;
                matrix[i][below] -= x;
            }
        }
    }
    let element = |random: &mut Random| {
        let at = (random.next() * n as f64) as usize;
        let mut direction = vec![0.0; n];
        direction[at] = 1.0;
        if at > 0 && random.next() < 0.7 {
            direction[at - 1] = -1.0;
        }
        let friction = random.between(0.3, 3.0);
        let stiffness = random.between(5.0, 60.0);
        let belt = if random.next() < 0.2 { random.between(0.05, 0.3) } else { 0.0 };
        let (moves, kind) = match (random.next() * 6.0) as usize {
            0 | 1 => (0.0, Kind::Elastic { stiffness, friction, normal: None }),
            2 => (0.0, Kind::Stop { gap: random.between(0.02, 0.2), stiffness, damping: 0.1 }),
            3 => {
                let law = Law { points: vec![(0.0, friction), (0.3, 0.8 * friction), (1.0, friction)] };
                (belt, Kind::Contact { law, peak: 1.2, normal: None })
            }
            4 => {
                let points = vec![(-0.2, -0.3 * stiffness), (0.0, 0.0), (0.2, 0.2 * stiffness)];
                (0.0, Kind::Spring { points })
            }
            _ => (belt, Kind::Contact { law: Law::constant(friction), peak: 1.0, normal: None }),
        };
        Element { name: String::new(), direction, moves: Signal::constant(moves), kind }
    };
    let count = 3 + (random.next() * 12.0) as usize;
    let elements = (0..count).map(|_| element(random)).collect();
    let (harmonics, records) = loads(random, n, [-1.0, 2.0], 3.0, [0.0, 1.0, 1.5, 2.5, 4.0]);
    Model { mass, damping, stiffness, elements, harmonics, records, ..Model::default() }
}

/// The greatest difference of two motions in parts of the greatest number of its kind.
fn apart(a: &Motion<f64>, b: &Motion<f64>) -> f64 {
    let lists = |m: &Motion<f64>| {
        let works = m.elements.iter().map(|e| e.work).chain([m.load_work, m.damper_work, m.stored]).collect();
        let places =
            [&m.end.displacement, &m.max_displacement, &m.min_displacement].map(Clone::clone).concat();
        let speeds = [&m.end.velocity, &m.max_velocity, &m.min_velocity].map(Clone::clone).concat();
        let times = m.events.iter().map(|e| e.time).collect();
        [places, speeds, m.end.force.clone(), works, times]
    };
    let far = |(a, b): (Vec<f64>, Vec<f64>)| {
        let size = b.iter().fold(1e-300_f64, |most, x| most.max(x.abs()));
        a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
    };
    lists(a).into_iter().zip(lists(b)).map(far).fold(0.0, f64::max)
}

/// The same events, and the same motion within 10⁻¹⁰, as by matrices. A motion that multiplies rounding is left out: there the events differ of
/// the machine whose masses are greater by a rounding, too, or its motion is as far away.
#[test]
fn long_chains_move_as_by_matrices() {
    let mut random = Random(178);
    let (mut compared, mut events, mut worst, mut rough) = (0, 0, 0.0_f64, 0);
    for number in 0..count(12, 500) {
        let model = chain(&mut random);
        let until = random.between(3.0, 6.0);
        let start = State::rest(model.mass.len());
        let system = System::new(&model).expect("valid");
        let plain = system.clone().by_short_steps().simulate(&start, until);
        let found = system.simulate(&start, until);
        let (plain, found) = match (plain, found) {
            (Ok(plain), Ok(found)) => (plain, found),
            (Err(plain), Err(found)) if plain == found => continue,
            (plain, found) => panic!("{number}: {:?} {:?}", plain.err(), found.err()),
        };
        let mut other = model.clone();
        other.mass.iter_mut().enumerate().for_each(|(i, row)| row[i] *= 1.0 + 3.0 * f64::EPSILON);
        let turned = System::new(&other).expect("valid").by_short_steps().simulate(&start, until);
        let turned = turned.expect("it moves");
        let list = |m: &Motion<f64>| m.events.iter().map(|e| (e.element, e.kind)).collect::<Vec<_>>();
        let own = apart(&turned, &plain);
        if list(&turned) != list(&plain) || own > 1e-11 {
            rough += 1;
            continue;
        }
        assert_eq!(list(&found), list(&plain), "{number}: {model:?}");
        let by = apart(&found, &plain);
        assert!(by < 1e-10, "{number}: {by:e} apart, {own:e} by rounding: {model:?}");
        worst = worst.max(by);
        compared += 1;
        events += found.events.len();
    }
    println!("{compared} chains, {events} events, apart by {worst:e}; {rough} multiply rounding");
    assert!(compared > count(8, 350) && events > 5 * compared, "{compared} {events} {rough}");
}

/// The derivative of a period by the series is that by matrices: the multipliers and the steady motion are the same.
#[test]
fn a_long_chain_has_the_steady_motion_of_its_matrices() {
    let n = 30;
    let zeros = || vec![vec![0.0; n]; n];
    let (mut mass, mut damping, mut stiffness) = (zeros(), zeros(), zeros());
    for i in 0..n {
        mass[i][i] = 1.0;
        for (matrix, x) in [(&mut stiffness, 400.0), (&mut damping, 4.0)] {
            matrix[i][i] += x;
            if i > 0 {
                matrix[i - 1][i - 1] += x;
                matrix[i - 1][i] -= x;
                matrix[i][i - 1] -= x;
            }
        }
    }
    let elements = (0..n).step_by(2).map(|at| {
        let direction = (0..n).map(|j| f64::from(i8::from(j == at) - i8::from(j + 1 == at))).collect();
        let kind = Kind::Elastic { stiffness: 300.0, friction: 2.0 - 0.05 * at as f64, normal: None };
        Element { name: String::new(), direction, moves: Signal::constant(0.0), kind }
    });
    let model = Model {
        mass,
        damping,
        stiffness,
        elements: elements.collect(),
        harmonics: vec![Harmonic { frequency: 2.0, sin: vec![0.5; n], cos: vec![] }],
        ..Model::default()
    };
    let system = System::new(&model).expect("valid");
    let found = system.steady(&State::rest(n)).expect("valid");
    let due = system.by_short_steps().steady(&State::rest(n)).expect("valid");
    assert_eq!((found.kind, found.periods), (due.kind, due.periods));
    assert!(found.motion.events.len() > 30, "{:?}", found.motion.events.len());
    assert!(apart(&found.motion, &due.motion) < 1e-10, "{:e}", apart(&found.motion, &due.motion));
    // The eigenvalues of a matrix that is not normal have some digits less than it has.
    for (a, b) in found.multipliers.iter().zip(&due.multipliers).take(6) {
        assert!((a.0.hypot(a.1) - b.0.hypot(b.1)).abs() < 1e-9, "{a:?} {b:?}");
    }
}
