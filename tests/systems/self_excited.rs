//! Motions without a load that varies: stick-slip on a belt, rest and growth.

use crate::closed_form::contact;
use crate::generator::Random;
use stickslip::system::{Element, Kind, Law, Model, Signal, State, Steady, SteadyKind, System};

/// A body on a belt of the speed v, with the friction r in motion and peak r at rest.
fn belt(mass: f64, stiffness: f64, damping: f64, speed: f64, kind: Kind<f64>) -> Model<f64> {
    let moves = Signal::constant(speed);
    Model {
        mass: vec![vec![mass]],
        damping: vec![vec![damping]],
        stiffness: vec![vec![stiffness]],
        elements: vec![Element { name: "belt".into(), direction: vec![1.0], moves, kind }],
        ..Model::default()
    }
}

/// Without a damper the slip is part of a circle about r/k from (peak r/k, v) on, and the rest lasts 2(peak − 1)r/(k v).
#[test]
fn stick_slip_on_a_belt_is_that_of_the_closed_form() {
    let mut random = Random(9);
    for number in 0..200 {
        let (m, k, v) = (random.between(0.5, 2.0), random.between(1.0, 20.0), random.between(0.05, 1.0));
        let (r, peak) = (random.between(0.2, 2.0), random.between(1.1, 2.0));
        let kind = Kind::Contact { law: Law::constant(r), peak, normal: None };
        let system = System::new(&belt(m, k, 0.0, v, kind)).expect("valid");
        let start = State { velocity: vec![v], ..State::rest(1) };
        let steady = system.steady(&start).expect("it moves");
        let omega = (k / m).sqrt();
        let excess = (peak - 1.0) * r / k;
        let radius = excess.hypot(v / omega);
        let slip = 2.0 * (std::f64::consts::PI - (excess * omega / v).atan()) / omega;
        let period = slip + 2.0 * excess / v;
        assert_eq!(steady.kind, SteadyKind::Periodic, "{number}");
        for (name, seen, expected) in [
            ("period", steady.period, period),
            ("greatest", steady.motion.max_displacement[0], r / k + radius),
            ("least", steady.motion.min_displacement[0], r / k - radius),
            ("at rest", steady.motion.elements[0].time_at_rest, 2.0 * excess / v),
        ] {
            assert!((seen / expected - 1.0).abs() < 1e-11, "{number}: {name} {seen} for {expected}");
        }
        // The shift in time, and nothing else: a rest forgets.
        let sizes: Vec<f64> = steady.multipliers.iter().map(|m| m.0.hypot(m.1)).collect();
        assert!((sizes[0] - 1.0).abs() < 1e-8 && sizes[1] < 1e-8, "{number}: {sizes:?}");
    }
}

/// A falling law without a rest: the motion grows from the unstable equilibrium to its cycle, found from either side.
#[test]
fn a_falling_law_has_one_cycle() {
    let law = Law { points: vec![(0.0, 1.0), (0.5, 0.6), (2.0, 0.5)] };
    let model = Model {
        mass: vec![vec![1.0, 0.0], vec![0.0, 0.5]],
        damping: vec![vec![0.05, -0.02], vec![-0.02, 0.02]],
        stiffness: vec![vec![3.0, -1.0], vec![-1.0, 1.0]],
        elements: vec![Element {
            name: "belt".into(),
            direction: vec![1.0, 0.0],
            moves: Signal::constant(0.3),
            kind: Kind::Contact { law, peak: 1.0, normal: None },
        }],
        ..Model::default()
    };
    let system: System<f64> = System::new(&model).expect("valid");
    let near = State { displacement: vec![0.38, 0.38], velocity: vec![0.0, 0.01], ..State::rest(2) };
    let far = State { displacement: vec![2.0, -1.0], ..State::rest(2) };
    let found: Vec<Steady<f64>> = [near, far].iter().map(|s| system.steady(s).expect("it moves")).collect();
    for steady in &found {
        assert_eq!(steady.kind, SteadyKind::Periodic, "{steady:?}");
        let end = system.states(&steady.start, &[steady.period]).expect("it moves").pop().expect("one");
        for (a, b) in end.displacement.iter().zip(&steady.start.displacement) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }
    assert!(
        (found[0].period / found[1].period - 1.0).abs() < 1e-10,
        "{} {}",
        found[0].period,
        found[1].period
    );
    let greatest = |i: usize| -> f64 { found[i].motion.max_displacement[0] };
    assert!((greatest(0) - greatest(1)).abs() < 1e-10);
}

/// A rising law brings the body to its equilibrium, a sum of springs that push drives it away.
#[test]
fn rest_and_growth() {
    let law = Law { points: vec![(0.0, 0.5), (1.0, 1.0)] };
    let system = System::new(&belt(1.0, 4.0, 0.1, 0.2, Kind::Contact { law, peak: 1.0, normal: None }))
        .expect("valid");
    let start = State { displacement: vec![1.0], ..State::rest(1) };
    let steady = system.steady(&start).expect("it moves");
    assert_eq!(steady.kind, SteadyKind::Rest, "{steady:?}");
    // The belt slides below: k x = r(0.2).
    assert!((steady.start.displacement[0] - 0.6 / 4.0).abs() < 1e-12, "{steady:?}");
    let model = Model {
        elements: vec![contact(vec![1.0], 0.1, 1.0)],
        ..belt(1.0, 4.0, -0.2, 0.0, Kind::Contact { law: Law::constant(0.0), peak: 1.0, normal: None })
    };
    let steady = System::new(&model).expect("valid").steady(&start).expect("it moves");
    assert_eq!(steady.kind, SteadyKind::Growing, "{steady:?}");
}
