//! Laws with an end.

use stickslip::system::{Element, Error, Kind, Law, Model, Signal, State, System};

fn element(kind: Kind<f64>) -> Element<f64> {
    Element { name: "law".into(), direction: vec![1.0], moves: Signal::constant(0.0), kind }
}

/// x = 3 sin t of a mass of 1 on a spring of 1 leaves a law that ends at 2 where sin t = 2/3, and tells how far it went before.
#[test]
fn a_motion_ends_where_a_law_ends() {
    let one = |x: f64| vec![vec![x]];
    let kind = Kind::Spring { points: vec![(-2.0, -2.0), (-1.0, -1.0), (0.5, 0.5), (2.0, 2.0)] };
    let (mass, damping, stiffness) = (one(1.0), one(0.0), one(0.0));
    let model = Model { mass, damping, stiffness, elements: vec![element(kind)], ..Model::default() };
    let system = System::new(&model).expect("valid").stopping_beyond(0, 2.0);
    let start = State { velocity: vec![3.0], ..State::rest(1) };
    let end = (2.0_f64 / 3.0).asin();
    let motion = system.simulate(&start, end - 1e-6).expect("within the law");
    let reach = motion.elements[0].reach.expect("its law has an end");
    assert!((reach - 3.0 * (end - 1e-6).sin()).abs() < 1e-12, "{reach}");
    let left = system.simulate(&start, end + 1e-6);
    assert!(matches!(left, Err(Error::LeavesLaw { element: 0, .. })), "{left:?}");
    // The speed of a contact under a force of 2 and a friction of 1 is t.
    let kind = Kind::Contact { law: Law::constant(1.0), peak: 1.0, normal: None };
    let model = Model {
        mass: one(1.0),
        damping: one(0.0),
        stiffness: one(0.0),
        constant: vec![2.0],
        elements: vec![element(kind)],
        ..Model::default()
    };
    let system = System::new(&model).expect("valid").stopping_beyond(0, 0.5);
    let motion = system.simulate(&State::rest(1), 0.499).expect("within the law");
    assert!((motion.elements[0].reach.expect("its law has an end") - 0.499).abs() < 1e-12);
    assert!(system.simulate(&State::rest(1), 0.501).is_err());
    let without = System::new(&model).expect("valid").simulate(&State::rest(1), 2.0).expect("no end");
    assert_eq!(without.elements[0].reach, None);
}
