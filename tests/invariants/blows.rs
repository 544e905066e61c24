//! Promises of blows.

use stickslip::system::{Element, EventKind, Kind, Model, Motion};

/// A blow arrives at its stop, and leaves it with e times that velocity, or faster where another stop is hit at the same instant or touches.
pub(crate) fn rebounds(model: &Model<f64>, motion: &Motion<f64>, doubt: f64) -> usize {
    let is_hard = |element: &&Element<f64>| matches!(element.kind, Kind::HardStop { .. });
    let is_alone = model.elements.iter().filter(is_hard).count() == 1;
    let blows = motion.events.iter().filter(|event| event.kind == EventKind::Blow);
    blows
        .map(|event| {
            let Kind::HardStop { restitution, .. } = model.elements[event.element].kind else {
                panic!("a blow at element {}", event.element)
            };
            let (before, after) = event.velocities.expect("velocities of a blow");
            let late = after + restitution * before;
            let doubt = doubt + 1e-12 * (before.abs() + after.abs());
            assert!(
                before > -doubt && late <= doubt && (!is_alone || late >= -doubt),
                "from {before} to {after} with e = {restitution}: {event:?}"
            );
        })
        .count()
}
