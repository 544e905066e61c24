//! The verdict on a steady motion: of many periods, of no end, and of growth.

use crate::closed_form::contact;
use std::f64::consts::TAU;
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Normal, Signal, State, SteadyKind, System};

/// One body of 1 kg on 100 N/m under a load of 1 N, with a damper.
fn linear(frequency: f64, damping: f64) -> Model<f64> {
    Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![damping]],
        stiffness: vec![vec![100.0]],
        harmonics: vec![Harmonic { frequency, sin: vec![1.0], cos: vec![] }],
        ..Model::default()
    }
}

/// From rest the amplitude at the undamped resonance grows as F t/(2 m ω), without a bound.
#[test]
fn an_undamped_resonance_grows() {
    let steady = System::new(&linear(10.0, 0.0)).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Growing);
    let time = steady.followed as f64 * steady.period;
    let seen = steady.motion.max_displacement[0];
    assert!((seen / (time / 20.0) - 1.0).abs() < 0.01, "{seen} after {time}");
    // The least damper bounds it, at F/(c ω).
    let steady = System::new(&linear(10.0, 1e-6)).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Periodic);
    assert!(
        (steady.motion.max_displacement[0] / 1e5 - 1.0).abs() < 1e-6,
        "{:?}",
        steady.motion.max_displacement
    );
}

/// A body on a spring of negative stiffness leaves the range of numbers: the period that is told is a late one within it, over
/// which the motion grows as e^{κt}, κ² = 2.
#[test]
fn a_motion_that_leaves_the_range_of_numbers_grows() {
    let model = Model { stiffness: vec![vec![-2.0]], ..linear(1.0, 0.0) };
    let steady = System::new(&model).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Growing);
    let (from, to) = (steady.start.displacement[0], steady.motion.end.displacement[0]);
    let due = (2.0_f64.sqrt() * steady.period).exp();
    assert!(from > 1e100 && (to / from / due - 1.0).abs() < 1e-12, "{from}, {to}");
    assert!(steady.motion.stored.is_finite() && steady.motion.load_work.is_finite(), "{:?}", steady.motion);
}

/// Without a damper the body keeps the vibration of its start: (sin ωt − (ω/Ω) sin Ωt) F/(k − mω²) from rest.
#[test]
fn an_undamped_vibration_of_its_own_does_not_settle() {
    let system = System::new(&linear(TAU, 0.0)).unwrap();
    let steady = system.steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Unsettled);
    // The start of the forced motion alone has none.
    let velocity = TAU / (100.0 - TAU * TAU);
    let start = State { velocity: vec![velocity], ..State::rest(1) };
    let steady = system.steady(&start).unwrap();
    assert_eq!(steady.kind, SteadyKind::Periodic);
    assert!((steady.motion.max_displacement[0] / (velocity / TAU) - 1.0).abs() < 1e-9);
}

/// Two thousand periods of a load that is much faster than the body are the beginning of a motion, not growth.
#[test]
fn a_fast_load_does_not_look_like_growth() {
    let steady = System::new(&linear(1e9, 0.0)).unwrap().steady(&State::rest(1)).unwrap();
    assert_eq!(steady.kind, SteadyKind::Unsettled);
}

/// A table whose contact has a normal load that varies repeats itself after nine periods: its states nine periods apart
/// are equal, and nearer ones are not.
#[test]
fn a_motion_of_nine_periods_is_found() {
    let omega = TAU * 3.769230769230769;
    let load = |factor: f64, phase: f64, size: f64| Harmonic {
        frequency: factor * omega,
        sin: vec![0.0, size * phase.cos()],
        cos: vec![0.0, size * phase.sin()],
    };
    let friction = 0.18344827586206897;
    let normal = Signal { sin: vec![0.0, 200.0], ..Signal::constant(1176.8) };
    let model = Model {
        mass: vec![vec![0.6, 0.0], vec![0.0, 0.12]],
        damping: vec![vec![3.2, -0.2], vec![-0.2, 0.2]],
        stiffness: vec![vec![3060.0, -60.0], vec![-60.0, 60.0]],
        elements: vec![Element {
            name: "guide".into(),
            direction: vec![-1.0, 1.0],
            moves: Signal::constant(0.0),
            kind: Kind::Contact {
                law: Law::constant(friction),
                peak: 1.2,
                normal: Some(Normal { signal: normal, displacement: vec![], velocity: vec![] }),
            },
        }],
        harmonics: vec![load(1.0, 0.0, 200.0), load(2.0, 40f64.to_radians(), 90.0), load(3.0, 1.0, 60.0)],
        ..Model::default()
    };
    let system = System::new(&model).unwrap();
    let steady = system.steady(&State::rest(2)).unwrap();
    assert_eq!((steady.kind, steady.periods), (SteadyKind::Periodic, 9));
    let times: Vec<f64> = (0..=9).map(|k| 300.0 * TAU / omega + f64::from(k) * TAU / omega).collect();
    let states = system.states(&State::rest(2), &times).unwrap();
    let apart = |k: usize| (states[k].displacement[1] - states[0].displacement[1]).abs();
    assert!(
        apart(9) < 1e-9 && (1..9).all(|k| apart(k) > 1e-4),
        "{:?}",
        (1..10).map(apart).collect::<Vec<_>>()
    );
}

/// Two bodies, the second of which meets a wall.
fn before_a_wall(frequency: f64, gap: f64, friction: f64) -> Model<f64> {
    let wall = Element {
        name: "wall".into(),
        direction: vec![0.0, 1.0],
        moves: Signal::constant(0.0),
        kind: Kind::Stop { gap, stiffness: 30.0, damping: 0.5 },
    };
    Model {
        mass: vec![vec![1.0, 0.0], vec![0.0, 0.5]],
        damping: vec![vec![0.2, -0.1], vec![-0.1, 0.1]],
        stiffness: vec![vec![2.0, -1.0], vec![-1.0, 1.0]],
        elements: vec![wall, contact(vec![1.0, 0.0], friction, 1.0)],
        harmonics: vec![Harmonic { frequency, sin: vec![0.0, 1.0], cos: vec![] }],
        ..Model::default()
    }
}

/// The states of these bodies at the ends of some periods, by Runge and Kutta's method of fourth order; the friction is
/// `r v/|v|`, smoothed below 10⁻⁶ of the largest velocities.
fn stepped(frequency: f64, gap: f64, friction: f64, start: &State<f64>, periods: usize) -> Vec<[f64; 4]> {
    let slope = |t: f64, [x, y, v, w]: [f64; 4]| {
        let depth = y - gap;
        let wall = if depth > 0.0 { (30.0 * depth + 0.5 * w).max(0.0) } else { 0.0 };
        let drag = friction * (v / 1e-5).clamp(-1.0, 1.0);
        let first = -2.0 * x + y - 0.2 * v + 0.1 * w - drag;
        let second = x - y + 0.1 * v - 0.1 * w - wall + (frequency * t).sin();
        [v, w, first, second / 0.5]
    };
    let steps = 200_000;
    let h = TAU / frequency / f64::from(steps);
    let mut z = [start.displacement[0], start.displacement[1], start.velocity[0], start.velocity[1]];
    let plus = |z: [f64; 4], k: [f64; 4], s: f64| std::array::from_fn(|i| z[i] + s * k[i]);
    (0..periods)
        .map(|_| {
            for i in 0..steps {
                let t = f64::from(i) * h;
                let a = slope(t, z);
                let b = slope(t + h / 2.0, plus(z, a, h / 2.0));
                let c = slope(t + h / 2.0, plus(z, b, h / 2.0));
                let d = slope(t + h, plus(z, c, h));
                z = std::array::from_fn(|k| z[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
            }
            z
        })
        .collect()
}

/// Motions of two and of three periods, and two stable motions of one system, from different starts. Small steps from the
/// state that is found come back to it after as many periods, and not before.
#[test]
fn motions_of_several_periods_and_several_motions_of_one_system() {
    let from = |velocity: f64| State { velocity: vec![0.0, velocity], ..State::rest(2) };
    // Where the wall is out of reach the motion is another one; it is steady before the nearer wall, too.
    let far = System::new(&before_a_wall(1.6, 10.0, 0.05)).unwrap().steady(&from(0.0)).unwrap().start;
    for (frequency, gap, friction, start, periods, greatest) in [
        (2.1, 0.5, 0.0, from(0.0), 2, 0.791458),
        (3.1, 0.2, 0.0, from(0.0), 3, 0.337753),
        (1.6, 1.0, 0.05, far, 1, 0.666163),
        // From rest the beginning of the motion meets the wall, and goes on to do so.
        (1.6, 1.0, 0.05, from(0.0), 2, 1.060555),
        (1.6, 1.0, 0.05, from(6.0), 2, 1.060555),
        // Newton's method finds this one from four and from six of its periods, too.
        (2.5, 0.5, 0.0, from(3.0), 2, 0.589921),
        (2.5, 0.5, 0.0, from(6.0), 2, 0.589921),
    ] {
        let name = format!("{frequency}, {gap}, {friction} from {start:?}");
        let system = System::new(&before_a_wall(frequency, gap, friction)).unwrap();
        let steady = system.steady(&start).unwrap();
        assert_eq!((steady.kind, steady.periods), (SteadyKind::Periodic, periods), "{name}");
        let most: f64 = steady.motion.max_displacement[1];
        assert!((most - greatest).abs() < 1e-6, "{name}: {most}");
        let start = [&steady.start.displacement[..], &steady.start.velocity[..]].concat();
        let ends = stepped(frequency, gap, friction, &steady.start, periods);
        let apart = |end: &[f64; 4]| end.iter().zip(&start).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let back: Vec<f64> = ends.iter().map(apart).collect();
        let (last, before) = back.split_last().unwrap();
        assert!(*last < 2e-4 && before.iter().all(|by| *by > 1e-2), "{name}: {back:?}");
    }
}

/// A constant load shifts a body on a spring, and drives one without a spring away.
#[test]
fn a_border_needs_a_spring_for_a_constant_load() {
    let model = |stiffness: f64, constant: f64| Model {
        mass: vec![vec![1.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![stiffness]],
        elements: vec![contact(vec![1.0], 1.0, 1.0)],
        harmonics: vec![Harmonic { frequency: 5.0, sin: vec![3.0], cos: vec![] }],
        constant: vec![constant],
        ..Model::default()
    };
    let border = |stiffness, constant| System::new(&model(stiffness, constant)).unwrap().border();
    let text = border(0.0, 0.5).unwrap_err().to_string();
    assert!(text.starts_with("constant load must be absent where no spring carries it"), "{text}");
    assert!(border(0.0, 0.0).is_ok());
    let (without, with) = (border(7.0, 0.0).unwrap(), border(7.0, 0.5).unwrap());
    assert_eq!(without.least_load_factor, with.least_load_factor);
}

/// A damper with a rate of 10⁷ a second dies away at once, and does not shorten the steps: the amplitude is that of the closed form.
#[test]
fn a_strong_damper_settles() {
    let steady = System::new(&linear(1.0, 1e7)).unwrap().steady(&State::rest(1)).unwrap();
    let due = 1.0 / (99.0_f64.powi(2) + 1e14).sqrt();
    let found = steady.motion.max_displacement[0];
    assert!((found / due - 1.0).abs() < 1e-9, "{found} {due}");
}

/// A rate so much faster than the load that a period would take hours is refused at once.
#[test]
fn a_period_of_too_many_steps_is_refused() {
    for model in [linear(1e-9, 0.1), linear(1.0, 1e300)] {
        let why = System::new(&model).unwrap().steady(&State::rest(1)).unwrap_err().to_string();
        assert!(why.starts_with("period of the loads must have at most 250000 steps"), "{why}");
    }
}

/// A body that rubs on the ground and strikes a stop: with (damping, friction, gap, restitution).
pub(crate) fn striking([damping, friction, gap, restitution]: [f64; 4], frequency: f64) -> Model<f64> {
    let element = |name: &str, kind| Element {
        name: name.into(),
        direction: vec![1.0],
        moves: Signal::constant(0.0),
        kind,
    };
    let law = Law { points: vec![(0.0, friction)] };
    Model {
        stiffness: vec![vec![1.0]],
        elements: vec![
            element("guide", Kind::Contact { law, peak: 1.0, normal: None }),
            element("stop", Kind::HardStop { gap, restitution }),
        ],
        ..linear(frequency, damping)
    }
}

/// An irregular motion between a spring and a stop, which dampers and friction bound, does not grow, whatever two of its periods say.
#[test]
fn an_irregular_motion_does_not_grow() {
    let system = System::new(&striking([0.11, 0.19, 0.06, 0.72], 4.0)).unwrap();
    let found = system.steady(&State::rest(1)).unwrap();
    assert_eq!(found.kind, SteadyKind::Unsettled);
    assert_eq!(found.disturbance_growth, 1.0 / f64::EPSILON);
    let times: Vec<f64> = (0..20_000).map(f64::from).collect();
    let reach = |states: &[State<f64>]| states.iter().map(|s| s.displacement[0].abs()).fold(0.0, f64::max);
    let states = system.states(&State::rest(1), &times).unwrap();
    let (before, after) = states.split_at(10_000);
    assert!((reach(after) / reach(before) - 1.0).abs() < 0.2, "{} {}", reach(before), reach(after));
}
