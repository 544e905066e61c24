//! Promises of answers under laws that are curves: each element obeys the curve itself within what its table and the printed digits allow,
//! the energy closes, samples lie within the extremes, and the last one is the end.

#![allow(dead_code, reason = "each fuzz target and test takes what it needs")]

use super::blows::rebounds;
use serde_json::{Value, json};
use std::path::Path;
use stickslip::generators::{Curve, Curved, Structure};
use stickslip::system::{Element, Error, Kind, Model, Motion, Signal, State};
use stickslip_front::system::{Digits, NamedSystem, Why};

/// What a check has seen.
#[derive(Debug, Default, Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) events: usize,
    pub(crate) samples: usize,
    /// Forces of curves that were compared.
    pub(crate) forces: usize,
    /// The greatest difference from a curve, in parts of what is allowed.
    pub(crate) closest: f64,
}

fn signal(of: &Signal<f64>) -> Value {
    json!({ "const": of.constant, "sin": of.sin, "cos": of.cos })
}

/// A signal of at most the frequencies of the model.
fn element(place: usize, element: &Element<f64>, curve: Option<&Curve>) -> Value {
    let mut value = match (&element.kind, curve) {
        (
            Kind::Contact { .. },
            Some(Curve::Stribeck { kinetic, static_friction, speed, exponent, viscous }),
        ) => {
            let law = json!({
                "kinetic": kinetic, "static": static_friction, "speed": speed, "exponent": exponent, "viscous": viscous
            });
            json!({ "type": "contact", "law": law })
        }
        (kind, Some(Curve::Formula { text, .. })) => {
            let kind = if matches!(kind, Kind::Spring { .. }) { "spring" } else { "contact" };
            json!({ "type": kind, "law": { "formula": text } })
        }
        (Kind::Contact { law, peak, normal }, _) => {
            let mut value = json!({ "type": "contact", "peak": peak });
            match &law.points[..] {
                [(_, friction)] => value["friction"] = json!(friction),
                points => value["law"] = json!(points),
            }
            if let Some(normal) = normal {
                value["normal"] = signal(&normal.signal);
                if !normal.displacement.is_empty() {
                    value["normal"]["displacement"] = json!(normal.displacement);
                }
            }
            value
        }
        (Kind::UnderStop { stop, coefficient, peak }, _) => {
            json!({ "type": "contact", "stop": format!("e{stop}"), "friction": coefficient, "peak": peak })
        }
        (Kind::Elastic { stiffness, friction, .. }, _) => {
            json!({ "type": "elastic", "stiffness": stiffness, "friction": friction })
        }
        (Kind::Stop { gap, stiffness, damping }, _) => {
            json!({ "type": "stop", "gap": gap, "stiffness": stiffness, "damping": damping })
        }
        (Kind::HardStop { gap, restitution }, _) => {
            json!({ "type": "stop", "gap": gap, "restitution": restitution })
        }
        (Kind::Spring { points }, _) => json!({ "type": "spring", "law": points, "odd": false }),
    };
    value["name"] = json!(format!("e{place}"));
    value["direction"] = json!(element.direction);
    if element.moves != Signal::constant(0.0) {
        value["belt"] = signal(&element.moves);
    }
    value
}

/// The file of a system.
fn file(curved: &Curved) -> Value {
    let Curved { structure: Structure { model, start, .. }, curves } = curved;
    let curve = |place: usize| curves.iter().find(|one| one.0 == place).map(|one| &one.1);
    let elements: Vec<Value> =
        model.elements.iter().enumerate().map(|(i, e)| element(i, e, curve(i))).collect();
    let n = model.mass.len();
    let whole = |list: &[f64]| -> Vec<f64> { (0..n).map(|i| list.get(i).copied().unwrap_or(0.0)).collect() };
    let harmonics: Vec<Value> = model
        .harmonics
        .iter()
        .map(|h| json!({ "frequency": h.frequency, "sin": whole(&h.sin), "cos": whole(&h.cos) }))
        .collect();
    let mut value = json!({
        "mass": model.mass, "damping": model.damping, "stiffness": model.stiffness, "constant": whole(&model.constant),
        "harmonics": harmonics, "elements": elements,
        "start": { "displacement": start.displacement, "velocity": start.velocity },
    });
    if let Some(record) = model.records.first() {
        value["record"] = json!({ "times": record.times, "values": record.values, "force": record.force });
    }
    value
}

/// The unit of the last digit of a number as it is printed; none of 0, which may be one that no law changes.
fn last(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let text = format!("{x:e}");
    let (digits, power) = text.split_once('e').expect("a power");
    let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
    10.0_f64.powi(power.parse::<i32>().expect("a power") - i32::try_from(decimals).expect("few"))
}

/// The units of the last digits of a list. A number that was rounded to 0 has that of the coarsest.
fn units(list: &[f64]) -> Vec<f64> {
    let coarsest = list.iter().copied().map(last).fold(0.0, f64::max);
    list.iter().map(|&x| if x == 0.0 { coarsest } else { last(x) }).collect()
}

/// The other side's velocity, and the way of it that harmonics make.
fn side(moves: &Signal<f64>, model: &Model<f64>, time: f64) -> (f64, f64) {
    let part = |list: &[f64], k: usize| list.get(k).copied().unwrap_or(0.0);
    model.harmonics.iter().enumerate().fold((moves.constant, 0.0), |(speed, way), (k, h)| {
        let (sin, cos) = (h.frequency * time).sin_cos();
        let (a, b) = (part(&moves.sin, k), part(&moves.cos, k));
        (speed + a * sin + b * cos, way + (b * sin - a * cos) / h.frequency)
    })
}

/// By how much a force is off its curve, and what is allowed.
fn off(
    curve: &Curve,
    element: &Element<f64>,
    model: &Model<f64>,
    time: f64,
    state: &State<f64>,
    force: f64,
) -> (f64, f64) {
    let along = |list: &[f64]| element.direction.iter().zip(list).map(|(b, x)| b * x).sum::<f64>();
    let doubt =
        |list: &[f64]| element.direction.iter().zip(units(list)).map(|(b, x)| (b * x).abs()).sum::<f64>();
    let (speed, way) = side(&element.moves, model, time);
    let spread = |at: f64, by: f64, of: &dyn Fn(f64) -> f64| {
        [at - by, at + by].into_iter().map(|x| (of(x) - of(at)).abs()).fold(0.0, f64::max)
    };
    if let Kind::Spring { .. } = element.kind {
        let (x, by) = (along(&state.displacement) - way, doubt(&state.displacement) + 1e-12);
        return ((force - curve.value(x)).abs(), spread(x, by, &|x| curve.value(x)));
    }
    let (v, by) = (along(&state.velocity) - speed, doubt(&state.velocity) + 1e-12);
    let of = |v: f64| curve.value(v.abs());
    let changes = spread(v, by, &of);
    // Within its doubt of 0 a contact may be at rest, with any force up to the friction there.
    let off = if v.abs() <= by { force.abs() - curve.value(0.0) } else { (force - v.signum() * of(v)).abs() };
    (off.max(0.0), changes)
}

/// Checks an answer. An error must name an element whose events rounding cannot tell.
///
/// # Panics
/// If a promise is broken.
pub(crate) fn motion(curved: &Curved, samples: u32) -> Seen {
    let Curved { structure, curves } = curved;
    let until = &structure.until;
    let value = file(curved);
    let found = NamedSystem::new(&value, [], Path::new(""), None)
        .unwrap_or_else(|e| panic!("the generator makes valid systems: {e}\n{value}"));
    let start = &found.described.start;
    let answer = match found.simulate(start, *until) {
        Ok(answer) => answer,
        Err(Why::Engine(Error::Undecided { .. })) => return Seen::default(),
        Err(why) => panic!("{why}\n{value}"),
    };
    let (motion, Some(digits)) = answer else {
        assert!(curves.is_empty(), "digits of curves are said");
        return Seen::default();
    };
    assert_eq!(digits.tables.len(), curves.len(), "{value}");
    balance(&motion, &value);
    // A blow is told with the digits of its velocities.
    let of_blows = motion.events.iter().filter_map(|event| event.velocities);
    let coarsest = of_blows.flat_map(|(a, b)| units(&[a, b])).fold(0.0, f64::max);
    rebounds(&structure.model, &motion, 2.0 * coarsest + 1e-9);
    let times: Vec<f64> = (1..=samples).map(|i| until * f64::from(i) / f64::from(samples)).collect();
    let states = match found.states(start, &times) {
        Ok(states) => states,
        Err(Why::Engine(Error::Undecided { .. })) => return Seen::default(),
        Err(why) => panic!("{why}\n{value}"),
    };
    let mut seen = Seen { events: motion.events.len(), ..Seen::default() };
    for (state, &time) in states.iter().zip(&times) {
        seen.samples += 1;
        within(&motion, state, &value);
        stays(&structure.model, state, time, &value);
        if !digits.events_agree {
            continue;
        }
        // Tables whose events lie on both sides of a sample share no branch there.
        let beside =
            |e: &stickslip::system::Event<f64>| (e.time - time).abs() < 1e-6 * until + 8.0 * last(e.time);
        if motion.events.iter().any(beside) {
            continue;
        }
        law(curved, &digits, state, time, &mut seen, &value);
    }
    let end = states.last().expect("a sample");
    for (a, b) in [(&end.displacement, &motion.end.displacement), (&end.velocity, &motion.end.velocity)] {
        for ((x, y), (dx, dy)) in a.iter().zip(b).zip(units(a).into_iter().zip(units(b))) {
            assert!(
                (x - y).abs() <= 2.0 * dx.max(dy) + 1e-9,
                "the end is {y} and, with samples, {x}\n{value}"
            );
        }
    }
    seen
}

/// Each curve's force of a sample.
fn law(curved: &Curved, digits: &Digits, state: &State<f64>, time: f64, seen: &mut Seen, value: &Value) {
    let Curved { structure: Structure { model, .. }, curves } = curved;
    let of_forces = units(&state.force);
    for ((place, curve), table) in curves.iter().zip(&digits.tables) {
        let (element, force) = (&model.elements[*place], state.force[*place]);
        let (off, changes) = off(curve, element, model, time, state, force);
        // An extrapolated force has 4/3 of the error of one table and 1/3 of that of one with half the pieces, which is four times as large.
        let allowed = 8.0 / 3.0 * table.within + of_forces[*place] + changes + 1e-9;
        assert!(
            off <= allowed,
            "element {place} at {time}: {off} from its curve, {allowed} allowed\n{value}"
        );
        seen.forces += 1;
        seen.closest = seen.closest.max(off / allowed);
    }
}

/// No body is beyond a stop that gives no way, by more than the digits of the displacements.
fn stays(model: &Model<f64>, state: &State<f64>, time: f64, value: &Value) {
    for element in &model.elements {
        let Kind::HardStop { gap, .. } = element.kind else { continue };
        let along = |list: &[f64]| element.direction.iter().zip(list).map(|(b, x)| b * x).sum::<f64>();
        let doubt: f64 =
            element.direction.iter().zip(units(&state.displacement)).map(|(b, x)| (b * x).abs()).sum();
        let deep = along(&state.displacement) - side(&element.moves, model, time).1 - gap;
        assert!(deep <= doubt + 1e-9, "{deep:e} beyond a stop at {time}, {doubt:e} in digits\n{value}");
    }
}

/// A state is within the extremes.
fn within(motion: &Motion<f64>, state: &State<f64>, value: &Value) {
    for (list, greatest, least) in [
        (&state.displacement, &motion.max_displacement, &motion.min_displacement),
        (&state.velocity, &motion.max_velocity, &motion.min_velocity),
    ] {
        let doubts = [list, greatest, least].map(|list| units(list));
        let doubt = doubts.iter().flatten().copied().fold(1e-9, f64::max);
        for ((x, high), low) in list.iter().zip(greatest).zip(least) {
            assert!(
                *x <= high + 2.0 * doubt && *x >= low - 2.0 * doubt,
                "{x} within {low} and {high}\n{value}"
            );
        }
    }
}

/// The energy closes within the digits of its parts.
fn balance(motion: &Motion<f64>, value: &Value) {
    let parts: Vec<f64> = [motion.load_work, motion.damper_work, motion.stored]
        .into_iter()
        .chain(motion.elements.iter().map(|e| e.work))
        .collect();
    assert!(parts.iter().all(|x| x.is_finite()), "{parts:?}\n{value}");
    let left = parts[0] - parts[1..].iter().sum::<f64>();
    let total: f64 = parts.iter().map(|x| x.abs()).sum();
    let doubt: f64 = units(&parts).into_iter().sum();
    assert!(
        left.abs() <= doubt + 1e-9 * (total + 0.01),
        "energy by {left:e} of {total:e}, {doubt:e} in digits\n{value}"
    );
}
