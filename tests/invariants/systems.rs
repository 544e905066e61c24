//! Promises of the motion of systems: it solves the equation of motion, obeys every element's law, closes its energy, and does
//! not depend on the times that are asked for.

#![allow(dead_code, reason = "each fuzz target and test takes what it needs")]

use super::blows::rebounds;
use stickslip::Float;
use stickslip::generators::Structure;
use stickslip::system::{Element, Error, EventKind, Kind, Model, Motion, Signal, State, System};

fn dot<F: Float>(a: &[F], b: &[F]) -> F {
    a.iter().zip(b).fold(F::int(0), |sum, (&a, &b)| sum + a * b)
}

/// The value of a signal.
fn value<F: Float>(signal: &Signal<F>, model: &Model<F>, time: F) -> F {
    let part = |list: &[F], k: usize| list.get(k).copied().unwrap_or(F::int(0));
    model.harmonics.iter().enumerate().fold(signal.constant, |sum, (k, h)| {
        let (sin, cos) = (h.frequency * time).sin_cos();
        sum + part(&signal.sin, k) * sin + part(&signal.cos, k) * cos
    })
}

/// The stretch of an element without its other side's way, and its velocity.
fn moving<F: Float>(element: &Element<F>, model: &Model<F>, time: F, state: &State<F>) -> (F, F) {
    let mut y = dot(&element.direction, &state.displacement);
    let v = dot(&element.direction, &state.velocity) - value(&element.moves, model, time);
    for (k, h) in model.harmonics.iter().enumerate() {
        let part = |l: &[F]| l.get(k).copied().unwrap_or(F::int(0));
        let (sin, cos) = (part(&element.moves.sin), part(&element.moves.cos));
        let (sin_phase, cos_phase) = (h.frequency * time).sin_cos();
        y = y - (cos * sin_phase - sin * cos_phase) / h.frequency;
    }
    (y, v)
}

/// What an element's law says of a state: an excess over the doubt, if it is broken.
pub(crate) fn broken<F: Float>(
    element: &Element<F>,
    model: &Model<F>,
    time: F,
    state: &State<F>,
    force: F,
    doubt: F,
) -> Option<String> {
    let (y, v) = moving(element, model, time, state);
    let zero = F::int(0);
    let positive = |x: F| if x > zero { x } else { zero };
    let is_broken = match &element.kind {
        Kind::Contact { law, peak, normal } => {
            let load = normal.as_ref().map_or(F::int(1), |n| {
                value(&n.signal, model, time) + dot(&n.displacement, &state.displacement)
            });
            let load = positive(load);
            let speed = v.abs();
            let line = |p: &[(F, F)]| p[0].1 + (p[1].1 - p[0].1) * (speed - p[0].0) / (p[1].0 - p[0].0);
            let pieces: Vec<_> = law.points.windows(2).collect();
            let r = match pieces.iter().rev().find(|p| p[0].0 <= speed) {
                // The last piece goes on down to zero.
                Some(p) => positive(line(p)),
                None => law.points[0].1,
            };
            let due = if v < zero { -(r * load) } else { r * load };
            // At a speed within the doubt a law that rises may be above its peak.
            let bound = *peak * law.points[0].1;
            let holds = force.abs() - if r > bound { r } else { bound } * load;
            if speed > doubt { (force - due).abs() > doubt } else { holds > doubt }
        }
        Kind::UnderStop { stop, coefficient, peak } => {
            let load = *coefficient * positive(state.force[*stop]);
            let due = if v < zero { -load } else { load };
            if v.abs() > doubt { (force - due).abs() > doubt } else { force.abs() - *peak * load > doubt }
        }
        Kind::Elastic { friction, .. } => {
            // A slider that yields goes with its force. After a lock the force falls by k v²/2a at least.
            let back = if force < zero { v } else { -v };
            let yields_backwards = back > F::from_f64(1e-3) && force.abs() > *friction - doubt;
            force.abs() > *friction + doubt || yields_backwards && *friction > doubt
        }
        Kind::Stop { gap, stiffness, damping } => {
            let pressed = if y > *gap { positive(*stiffness * (y - *gap) + *damping * v) } else { zero };
            let edge = if (y - *gap).abs() < doubt { *damping * v.abs() } else { zero };
            (force - pressed).abs() > doubt + edge
        }
        Kind::Spring { points } => {
            let last = points.len() - 2;
            let place = (0..last).find(|&i| y < points[i + 1].0).unwrap_or(last);
            let ((a, f), (b, g)) = (points[place], points[place + 1]);
            (force - (f + (g - f) * (y - a) / (b - a))).abs() > doubt
        }
        Kind::HardStop { gap, .. } => {
            // It pushes where it is touched, and nothing is beyond it.
            let is_away = y < *gap - doubt;
            y > *gap + doubt || force < -doubt || (is_away && force.abs() > doubt)
        }
    };
    is_broken.then(|| format!("y = {y}, v = {v}, T = {force}"))
}

/// The force on each coordinate without masses: loads, springs, dampers and elements.
fn force(model: &Model<f64>, time: f64, state: &State<f64>) -> Vec<f64> {
    let n = model.mass.len();
    let at = |list: &[f64], i: usize| list.get(i).copied().unwrap_or(0.0);
    (0..n)
        .map(|i| {
            let mut sum = at(&model.constant, i);
            for h in &model.harmonics {
                let (sin, cos) = (h.frequency * time).sin_cos();
                sum += at(&h.sin, i) * sin + at(&h.cos, i) * cos;
            }
            for r in &model.records {
                let next = r.times.partition_point(|&t| t <= time);
                if next > 0 && next < r.times.len() {
                    let part = (time - r.times[next - 1]) / (r.times[next] - r.times[next - 1]);
                    let p = r.values[next - 1] + part * (r.values[next] - r.values[next - 1]);
                    sum += at(&r.force, i) * p;
                }
            }
            for (element, tension) in model.elements.iter().zip(&state.force) {
                sum -= element.direction[i] * tension;
            }
            sum - dot(&model.stiffness[i], &state.displacement) - dot(&model.damping[i], &state.velocity)
        })
        .collect()
}

/// Gauss's eight nodes and weights on [0, 1].
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// The model from a time on.
fn later(model: &Model<f64>, by: f64) -> Model<f64> {
    let mut model = model.clone();
    // sin ω(t + b) = sin ωt cos ωb + cos ωt sin ωb.
    let turns: Vec<(f64, f64)> = model.harmonics.iter().map(|h| (h.frequency * by).sin_cos()).collect();
    let turned = |(s, c): (f64, f64), x: f64, y: f64| (x * c - y * s, x * s + y * c);
    for (h, &turn) in model.harmonics.iter_mut().zip(&turns) {
        let n = h.sin.len();
        h.cos.resize(n, 0.0);
        for (x, y) in h.sin.iter_mut().zip(&mut h.cos) {
            (*x, *y) = turned(turn, *x, *y);
        }
    }
    let signal = |signal: &mut Signal<f64>| {
        let count = signal.sin.len().max(signal.cos.len());
        signal.sin.resize(count, 0.0);
        signal.cos.resize(count, 0.0);
        for ((x, y), &turn) in signal.sin.iter_mut().zip(&mut signal.cos).zip(&turns) {
            (*x, *y) = turned(turn, *x, *y);
        }
    };
    for element in &mut model.elements {
        signal(&mut element.moves);
        if let Kind::Contact { normal: Some(normal), .. } = &mut element.kind {
            signal(&mut normal.signal);
        }
    }
    for record in &mut model.records {
        record.times.iter_mut().for_each(|t| *t -= by);
    }
    model
}

/// What a check has seen.
#[derive(Debug, Default, Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) blows: usize,
    pub(crate) events: usize,
    pub(crate) samples: usize,
    pub(crate) balances: usize,
    /// The greatest difference of a motion in two parts, relative to its size.
    pub(crate) parts: f64,
    pub(crate) energy: f64,
}

/// Checks a motion; an error must name an element whose events rounding cannot tell.
///
/// # Panics
/// If a promise is broken.
pub(crate) fn motion(structure: &Structure, samples: u32) -> Seen {
    let Structure { model, start, until } = structure;
    let system = System::new(model).expect("the generator makes valid systems");
    let motion = match system.simulate(start, *until) {
        Ok(motion) => motion,
        Err(Error::Undecided { .. }) => return Seen::default(),
        Err(error) => panic!("{error}"),
    };
    let mut seen = Seen { events: motion.events.len(), ..Seen::default() };
    let size = size(&motion);
    let times: Vec<f64> = (1..=samples).map(|i| until * f64::from(i) / f64::from(samples)).collect();
    let Some(states) = states(&system, start, &times) else { return Seen::default() };
    let beside = |time: f64| motion.events.iter().any(|e| (e.time - time).abs() < 1e-9 * until);
    for (state, &time) in states.iter().zip(&times) {
        seen.samples += 1;
        if !beside(time) {
            for (i, element) in model.elements.iter().enumerate() {
                let fault = broken(element, model, time, state, state.force[i], 1e-9);
                assert!(fault.is_none(), "element {i} at {time}: {fault:?}\n{:?}", motion.events);
            }
        }
        within(&motion, state, time, size);
    }
    seen.energy = energy(&motion);
    // The rounding of the many steps that a joint on a damper takes.
    let most = if has_fast_joint(model) { 1e-11 } else { 1e-12 };
    assert!(seen.energy <= most, "energy by {:e}", seen.energy);
    let last = states.last().expect("a sample");
    // A falling law and a stop let rounding grow, some 10⁵ times within these spans.
    let by = difference(last, &motion.end) / size;
    assert!(by < 1e-7, "the state at the end by {by:e} with samples on the way");
    seen.parts = in_parts(&system, structure, &motion) / size;
    assert!(seen.parts < 1e-6, "the state at the end by {:e} in two parts", seen.parts);
    seen.blows = rebounds(model, &motion, 1e-12 * size);
    seen.balances = balance(&system, structure, &motion, size);
    seen
}

/// The states, none where rounding cannot tell the events.
fn states(system: &System<f64>, start: &State<f64>, times: &[f64]) -> Option<Vec<State<f64>>> {
    match system.states(start, times) {
        Ok(states) => Some(states),
        Err(Error::Undecided { .. }) => None,
        Err(error) => panic!("{error}"),
    }
}

/// The greatest value of a motion.
fn size(motion: &Motion<f64>) -> f64 {
    [&motion.max_displacement, &motion.min_displacement, &motion.max_velocity, &motion.min_velocity]
        .into_iter()
        .flatten()
        .fold(0.1, |m: f64, x| m.max(x.abs()))
}

fn difference(a: &State<f64>, b: &State<f64>) -> f64 {
    let pairs = a.displacement.iter().zip(&b.displacement).chain(a.velocity.iter().zip(&b.velocity));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// A state is within the extremes.
fn within(motion: &Motion<f64>, state: &State<f64>, time: f64, size: f64) {
    let doubt = 1e-9 * size;
    let lists = [
        (&state.displacement, &motion.max_displacement, &motion.min_displacement),
        (&state.velocity, &motion.max_velocity, &motion.min_velocity),
    ];
    for (seen, greatest, least) in lists {
        for ((x, high), low) in seen.iter().zip(greatest).zip(least) {
            assert!(*x <= high + doubt && *x >= low - doubt, "{x} at {time} within {low} and {high}");
        }
    }
}

/// What is missing in the energy, relative to the work.
fn energy(motion: &Motion<f64>) -> f64 {
    let works: f64 = motion.elements.iter().map(|e| e.work).sum();
    let left = motion.load_work - motion.damper_work - works - motion.stored;
    let size = motion.load_work.abs()
        + motion.damper_work
        + motion.elements.iter().map(|e| e.work.abs()).sum::<f64>()
        + motion.stored.abs();
    left.abs() / (size + 0.01)
}

/// The difference of the end when the motion is begun anew on the way.
fn in_parts(system: &System<f64>, structure: &Structure, motion: &Motion<f64>) -> f64 {
    let Structure { model, start, until } = structure;
    // Not beside an event: there the elements' states are those of either side.
    let cut = (1..20)
        .map(|k| until * (0.37 + 0.013 * f64::from(k)))
        .find(|cut| motion.events.iter().all(|e| (e.time - cut).abs() > 1e-4 * until));
    let Some(cut) = cut else { return 0.0 };
    let Some(mut middle) = states(system, start, &[cut]).and_then(|mut s| s.pop()) else { return 0.0 };
    for (force, element) in middle.force.iter_mut().zip(&model.elements) {
        match element.kind {
            Kind::Elastic { friction, .. } => *force = force.clamp(-friction, friction),
            _ => *force = 0.0,
        }
    }
    let rest = System::new(&later(model, cut)).expect("valid");
    states(&rest, &middle, &[until - cut]).map_or(0.0, |end| difference(&end[0], &motion.end))
}

/// Whether a body without mass is on a damper.
fn has_fast_joint(model: &Model<f64>) -> bool {
    let is_fast = |(mass, damping): (&Vec<f64>, &Vec<f64>)| {
        mass.iter().all(|&m| m == 0.0) && damping.iter().any(|&c| c != 0.0)
    };
    model.mass.iter().zip(&model.damping).any(is_fast)
}

/// Between two events the momentum changes by the forces: the number of intervals seen.
fn balance(system: &System<f64>, structure: &Structure, motion: &Motion<f64>, size: f64) -> usize {
    let Structure { model, start, until } = structure;
    let mut ends: Vec<f64> = motion.events.iter().map(|e| e.time).chain([0.0, *until]).collect();
    ends.extend(model.records.iter().flat_map(|r| r.times.iter().copied()).filter(|t| t < until));
    ends.extend((1..40).map(|k| until * f64::from(k) / 40.0));
    ends.sort_by(f64::total_cmp);
    let mut count = 0;
    let mut times = Vec::new();
    // It goes to its balance faster than eight nodes of an interval can tell.
    if has_fast_joint(model) {
        return 0;
    }
    // The instant of a blow is known to the rounding of the displacement over its velocity.
    let has_blows = model.elements.iter().any(|element| matches!(element.kind, Kind::HardStop { .. }));
    let inside = if has_blows { 1e-3 } else { 1e-9 };
    // Each blow may multiply rounding: after dozens the samples have them at other instants.
    let mut blows = motion.events.iter().filter(|event| event.kind == EventKind::Blow);
    let known = blows.nth(60).map_or(f64::INFINITY, |blow| blow.time);
    for pair in ends.windows(2).filter(|pair| pair[1] < known) {
        let length = pair[1] - pair[0];
        if length > 1e-6 * until {
            // Just inside, so that all states are of one branch.
            let (low, high) = (pair[0] + inside * length, pair[1] - inside * length);
            times.push(low);
            let nodes = GAUSS.iter().rev().map(|g| -g.0).chain(GAUSS.iter().map(|g| g.0));
            times.extend(nodes.map(|x| low + (high - low) * (0.5 + 0.5 * x)));
            times.push(high);
        }
    }
    let Some(states) = states(system, start, &times) else { return 0 };
    let n = model.mass.len();
    for (times, states) in times.chunks(10).zip(states.chunks(10)) {
        let length = times[9] - times[0];
        // A corner of a law, or a stop that lets go without an event, is within.
        if corners(model, times, states) {
            continue;
        }
        let mut impulse = vec![0.0; n];
        let mut way = vec![0.0; n];
        let weights = GAUSS.iter().rev().map(|g| g.1).chain(GAUSS.iter().map(|g| g.1));
        for ((state, &time), weight) in states[1..9].iter().zip(&times[1..9]).zip(weights) {
            let forces = force(model, time, state);
            for i in 0..n {
                impulse[i] += 0.5 * length * weight * forces[i];
                way[i] += 0.5 * length * weight * state.velocity[i];
            }
        }
        for i in 0..n {
            let gained: f64 =
                (0..n).map(|j| model.mass[i][j] * (states[9].velocity[j] - states[0].velocity[j])).sum();
            let gone = states[9].displacement[i] - states[0].displacement[i];
            let by = (gained - impulse[i]).abs().max((gone - way[i]).abs());
            assert!(
                by < 1e-8 * size,
                "coordinate {i} by {by:e} from {} to {}\n{:?}",
                times[0],
                times[9],
                motion.events
            );
        }
        count += 1;
    }
    count
}

/// Whether an element passes a corner of its law within the interval.
fn corners(model: &Model<f64>, times: &[f64], states: &[State<f64>]) -> bool {
    model.elements.iter().any(|element| {
        let seen: Vec<(f64, f64)> =
            times.iter().zip(states).map(|(&t, s)| moving(element, model, t, s)).collect();
        match &element.kind {
            Kind::Contact { law, .. } if law.points.len() > 1 => {
                let falls_to_zero = {
                    let [a, b] = [law.points[law.points.len() - 2], law.points[law.points.len() - 1]];
                    let slope = (b.1 - a.1) / (b.0 - a.0);
                    (slope < 0.0).then(|| a.0 - a.1 / slope)
                };
                let points = law.points.iter().map(|p| p.0).chain(falls_to_zero);
                points.into_iter().any(|at| {
                    let sides = |f: fn(f64) -> f64| {
                        let near = 0.02;
                        let above = seen.iter().any(|s| f(s.1) > at - near);
                        let below = seen.iter().any(|s| f(s.1) < at + near);
                        above && below
                    };
                    at > 0.0 && sides(f64::abs)
                })
            }
            Kind::Spring { points } => {
                let inner = points.iter().skip(1).take(points.len().saturating_sub(2));
                let sides =
                    |at: f64| seen.iter().any(|s| s.0 > at - 0.02) && seen.iter().any(|s| s.0 < at + 0.02);
                inner.into_iter().any(|point| sides(point.0))
            }
            Kind::Stop { gap, .. } => {
                let deep = seen.iter().any(|s| s.0 > gap - 0.02);
                deep && seen.iter().any(|s| s.0 < gap + 0.02)
            }
            _ => false,
        }
    })
}

/// The releases of a motion: a contact whose direction no other depends on slips at its bound, not before.
pub(crate) fn slips(structure: &Structure) -> usize {
    let Structure { model, start, until } = structure;
    let Ok(system) = System::new(model) else { return 0 };
    let Ok(motion) = system.simulate(start, *until) else { return 0 };
    let mut count = 0;
    for event in motion.events.iter().filter(|e| e.kind == EventKind::Slip) {
        let element = &model.elements[event.element];
        let Kind::Contact { law, peak, normal: None } = &element.kind else { continue };
        let alone = |e: &&Element<f64>| matches!(e.kind, Kind::Contact { .. });
        if model.elements.iter().filter(alone).count() > 1 && !stands_alone(model, event.element) {
            continue;
        }
        let before = event.time - 1e-7;
        let quiet =
            motion.events.iter().all(|e| e.element == event.element || (e.time - event.time).abs() > 1e-6);
        let corner = |t: f64| (t - event.time).abs() < 1e-6;
        let record = model.records.iter().flat_map(|r| r.times.iter()).any(|&t| corner(t));
        if before <= 0.0
            || !quiet
            || record
            || motion
                .events
                .iter()
                .any(|e| e.element == event.element && e.time < event.time && event.time - e.time < 1e-6)
        {
            continue;
        }
        let Some(state) = states(&system, start, &[before]).and_then(|mut s| s.pop()) else { continue };
        let bound = peak * law.points[0].1;
        let force = state.force[event.element].abs();
        assert!((force - bound).abs() < 1e-4, "{force} for {bound} before {event:?}");
        count += 1;
    }
    count
}

/// Whether no other contact has a direction on the same coordinates.
fn stands_alone(model: &Model<f64>, element: usize) -> bool {
    let own = &model.elements[element].direction;
    model.elements.iter().enumerate().all(|(i, other)| {
        let shares = own.iter().zip(&other.direction).any(|(a, b)| *a != 0.0 && *b != 0.0);
        i == element || !matches!(other.kind, Kind::Contact { .. }) || !shares
    })
}
