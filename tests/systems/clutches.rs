//! `CoupledClutches` of the Modelica Standard Library: four shafts in a row, three clutches between them. The first is pressed by
//! 20 cos(0.4π t) N, the second by 20 N from 0.4 s on, the third by 20 N from 0.9 s on, with the coefficient 0.5; the torque on the first shaft, which
//! turns with 10 rad/s at the start, is 10 sin(10π t) N m. Each shaft has 1 kg m², and static friction is 1.1 times the kinetic.

use core::f64::consts::PI;
use stickslip::system::{Element, EventKind, Harmonic, Kind, Law, Model, Normal, Signal, State, System};

/// The machine from a time on, with these clutches pressed. The times are whole turns of the torque.
fn machine(from: f64, pressed: usize) -> Model<f64> {
    let diagonal = |x: f64| (0..4).map(|i| (0..4).map(|j| if i == j { x } else { 0.0 }).collect()).collect();
    let (sin, cos) = (0.4 * PI * from).sin_cos();
    let clutch = |i: usize| {
        let mut direction = vec![0.0; 4];
        (direction[i], direction[i + 1]) = (1.0, -1.0);
        // cos 0.4π(t + b) = cos 0.4πt cos 0.4πb − sin 0.4πt sin 0.4πb.
        let wave = Signal { sin: vec![0.0, -sin], cos: vec![0.0, cos], ..Signal::constant(0.0) };
        let signal = if i == 0 { wave } else { Signal::constant(1.0) };
        let normal = Some(Normal { signal, displacement: vec![], velocity: vec![] });
        let kind = Kind::Contact { law: Law::constant(10.0), peak: 1.1, normal };
        Element { name: format!("clutch {}", i + 1), direction, moves: Signal::constant(0.0), kind }
    };
    Model {
        mass: diagonal(1.0),
        damping: diagonal(0.0),
        stiffness: diagonal(0.0),
        elements: (0..pressed).map(clutch).collect(),
        harmonics: vec![
            Harmonic { frequency: 10.0 * PI, sin: vec![10.0, 0.0, 0.0, 0.0], cos: vec![] },
            Harmonic { frequency: 0.4 * PI, sin: vec![], cos: vec![] },
        ],
        ..Model::default()
    }
}

/// The events, which a solver of our own in another language has to these digits; OpenModelica's are off by up to 4·10⁻⁶ s.
#[test]
fn clutches_lock_and_let_go() {
    let mut state = State { velocity: vec![10.0, 0.0, 0.0, 0.0], ..State::rest(4) };
    let mut events = Vec::new();
    for (from, to, pressed) in [(0.0, 0.4, 1), (0.4, 0.9, 2), (0.9, 1.2, 3)] {
        let system = System::new(&machine(from, pressed)).expect("valid");
        let motion = system.simulate(&state, to - from).expect("it moves");
        events.extend(motion.events.iter().map(|e| (from + e.time, e.element, e.kind)));
        state = State { force: vec![], ..motion.end };
    }
    let first: Vec<_> = events.iter().filter(|e| e.0 < 0.9).collect();
    let expected = [
        (0.709_621_474_693_747, EventKind::Stick),
        (0.791_662_359_154_816, EventKind::Stick),
        (0.831_108_506_137_653, EventKind::Slip),
    ];
    assert_eq!(first.len(), expected.len(), "{events:?}");
    for (seen, expected) in first.iter().zip(expected) {
        assert!(seen.2 == expected.1 && (seen.0 - expected.0).abs() < 1e-14, "{seen:?} for {expected:?}");
    }
}
