//! One body by this engine, against the exact motion of one body.

use crate::closed_form::{contact, one_body};
use crate::generator::Random;
use stickslip::motion::record::{Body, Record as Samples};
use stickslip::motion::{DrivePhase, End, State as Phase, Trajectory};
use stickslip::system::{Beyond, EventKind, Model, Record, State, System};
use stickslip::{Excitation, Ratios};

/// The number of machines: a tenth of those of `.ci/slow systems`.
fn machines() -> usize {
    crate::count(2_000, 20_000)
}

/// The events of a segment's end.
const fn kind(end: End) -> Option<EventKind> {
    match end {
        End::Reversal => Some(EventKind::Reverse),
        End::Stop => Some(EventKind::Stick),
        End::Release => Some(EventKind::Slip),
        End::Grazing | End::Never => None,
    }
}

/// Machines over eight periods from random starts, a quarter of them from rest, with a mean force in half of them: the same
/// events, and the same place at the end.
#[test]
fn harmonic_loads() {
    let mut random = Random(3);
    let (mut count, mut stops) = (0, 0);
    for number in 0..machines() {
        let omega = random.between(0.1_f64.ln(), 5.0_f64.ln()).exp();
        let damping = random.between(0.0, 0.4) * random.next();
        let peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 2.0) };
        let alpha = random.between(0.5_f64.ln(), 12.0_f64.ln()).exp();
        let (x, v) = if random.next() < 0.25 {
            (0.0, 0.0)
        } else {
            (random.between(-4.0, 4.0), random.between(-4.0, 4.0))
        };
        let mean = if random.next() < 0.5 { 0.0 } else { random.between(-2.0, 2.0) };
        let periods = 8;
        let ratios = Ratios::new(omega, alpha)
            .and_then(|r| if damping > 0.0 { r.with_damping_ratio(damping) } else { Ok(r) })
            .and_then(|r| if peak > 1.0 { r.with_static_friction_ratio(peak) } else { Ok(r) })
            .expect("valid ratios");
        let start = Phase::new(0.0, x, v / omega).expect("a valid start");
        let end = DrivePhase::new(periods, 0.0).expect("a valid phase");
        let mut expected = Vec::new();
        let mut place = (x, 0.0);
        for segment in Trajectory::new(ratios, start).expect("valid ratios") {
            let segment = segment.expect("it is found");
            let after = segment.end().map(|end| end.phase);
            if let Some(phase) = after.filter(|phase| phase.since(end) < 0.0) {
                let time = phase.since(DrivePhase::new(0, 0.0).expect("a valid phase")) / omega;
                expected.extend(kind(segment.ends_by).map(|kind| (time, kind)));
            } else {
                let state = segment.at(end).state;
                place = (state.x, state.v * omega);
                break;
            }
        }
        let model = Model { constant: vec![mean], ..one_body(omega, alpha, damping, peak) };
        let system = System::new(&model).expect("valid");
        let start = State { displacement: vec![x + mean], velocity: vec![v], ..State::rest(1) };
        let until = f64::from(u32::try_from(periods).expect("small")) * std::f64::consts::TAU / omega;
        let motion = system.simulate(&start, until).expect("it is found");
        let seen: Vec<_> =
            motion.events.iter().filter(|e| e.kind != EventKind::Touch).map(|e| (e.time, e.kind)).collect();
        let what = format!("{number}: Ω {omega} α {alpha} ζ {damping} η {peak} from {x}, {v} about {mean}");
        assert_eq!(
            seen.iter().map(|e| e.1).collect::<Vec<_>>(),
            expected.iter().map(|e| e.1).collect::<Vec<_>>(),
            "{what}\n{seen:?}\n{expected:?}"
        );
        for (a, b) in seen.iter().zip(&expected) {
            assert!((a.0 - b.0).abs() < 1e-10 * until, "{what}: {a:?} for {b:?}");
        }
        let size = motion.max_displacement[0].max(-motion.min_displacement[0]).max(1.0);
        let speed = motion.max_velocity[0].max(-motion.min_velocity[0]).max(omega);
        let by = (motion.end.displacement[0] - mean - place.0).abs() / size;
        let by_v = (motion.end.velocity[0] - place.1).abs() / speed;
        assert!(by < 1e-10 && by_v < 1e-10, "{what}: ends by {by:e}, {by_v:e}");
        let work = motion.load_work - motion.damper_work - motion.elements[0].work - motion.stored;
        let sum = motion.load_work.abs() + motion.damper_work + motion.elements[0].work + motion.stored.abs();
        // What is stored is the difference of two energies, with their rounding.
        let level = size.max(mean.abs() + 1.0).powi(2) + speed.powi(2);
        assert!(
            work.abs() <= 1e-12 * sum + 8.0 * f64::EPSILON * level,
            "{what}: energy by {work:e} of {sum:e}"
        );
        stops += seen.iter().filter(|e| e.1 == EventKind::Stick).count();
        count += seen.len();
    }
    assert!(stops > 5 * machines() && count > 10 * machines(), "{count} events, {stops} stops");
}

/// Bodies under random records, and after them until they rest.
#[test]
fn records() {
    let mut random = Random(4);
    let mut stops = 0;
    for number in 0..machines() / 4 {
        let (mass, stiffness) = (random.between(0.5, 4.0), random.between(1.0, 60.0));
        let damping = random.between(0.0, 0.3) * 2.0 * (stiffness * mass).sqrt();
        let friction = random.between(0.1, 1.0);
        let peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 1.6) };
        let step = random.between(0.05, 0.2);
        let mut value = 0.0;
        let samples: Vec<f64> = (0..30)
            .map(|_| {
                value = 0.8 * value + random.between(-1.5, 1.5);
                value
            })
            .collect();
        let body = Body::new(mass, friction)
            .and_then(|b| b.with_stiffness(stiffness))
            .and_then(|b| b.with_damping(damping))
            .and_then(|b| b.with_static_friction_ratio(peak))
            .expect("valid");
        let record = Samples::new(Excitation::Force, step, samples.clone()).expect("valid");
        let expected = body.follow(&record).expect("it is found");
        let times: Vec<f64> = (0..samples.len()).map(|i| record.time(i)).collect();
        let end = record.end();
        let model = Model {
            mass: vec![vec![mass]],
            damping: vec![vec![damping]],
            stiffness: vec![vec![stiffness]],
            elements: vec![contact(vec![1.0], friction, peak)],
            records: vec![Record { times, values: samples, force: vec![1.0], beyond: Beyond::Zero }],
            ..Model::default()
        };
        let system = System::new(&model).expect("valid");
        let during = system.simulate(&State::rest(1), end).expect("it is found");
        let all = system.simulate(&State::rest(1), end + 400.0).expect("it is found");
        let size = expected.max_displacement.max(-expected.min_displacement).max(1e-3);
        let speed = expected.max_velocity.max(-expected.min_velocity).max(1e-3);
        let residual = expected.residual_displacement.expect("it rests");
        for (name, seen, value, scale) in [
            ("end displacement", during.end.displacement[0], expected.end_displacement, size),
            ("end velocity", during.end.velocity[0], expected.end_velocity, speed),
            ("time at rest", during.elements[0].time_at_rest, expected.stick_time, end),
            ("max displacement", all.max_displacement[0], expected.max_displacement, size),
            ("min displacement", all.min_displacement[0], expected.min_displacement, size),
            ("max velocity", all.max_velocity[0], expected.max_velocity, speed),
            ("min velocity", all.min_velocity[0], expected.min_velocity, speed),
            ("residual displacement", all.end.displacement[0], residual, size),
            ("friction work", all.elements[0].work, expected.friction_work, friction * size),
            ("damper work", all.damper_work, expected.damper_work, friction * size),
            ("load work", all.load_work, expected.load_work, friction * size),
        ] {
            let by = (seen - value).abs() / scale;
            assert!(by < 1e-10, "{number}: {name} {seen} for {value}, by {by:e}");
        }
        let count = |kind| all.events.iter().filter(|e| e.kind == kind).count();
        let seen = count(EventKind::Stick);
        assert_eq!(u64::try_from(seen).ok(), Some(expected.stops), "{number}: stops");
        let turns = u64::try_from(count(EventKind::Reverse)).ok();
        assert_eq!(turns, Some(expected.reversals), "{number}: reversals");
        stops += seen;
    }
    assert!(stops > machines() / 2, "{stops}");
}
