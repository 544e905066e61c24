//! Steps without an event, which are taken in blocks and in lanes, beside the motion with states, which takes each step by
//! its events.

use crate::generator::Random;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record};

/// Noise that is filtered twice.
fn smooth(count: usize) -> Vec<f64> {
    let (mut random, mut once, mut twice) = (Random(7), 0.0, 0.0);
    let samples = (0..count).map(|_| {
        once += 0.15 * (random.between(-0.5, 0.5) - once);
        twice += 0.15 * (once - twice);
        twice
    });
    samples.collect()
}

fn bodies() -> impl Iterator<Item = Body<f64>> {
    (0..48u32).map(|k| {
        let omega = std::f64::consts::TAU / (0.1 + 0.08 * f64::from(k));
        let body = Body::new(2.0, [0.0, 0.01, 0.03][(k % 3) as usize])
            .and_then(|body| body.with_stiffness(2.0 * omega * omega))
            .and_then(|body| body.with_damping([0.0, 0.2, 2.0, 6.0][(k % 4) as usize] * omega))
            .and_then(|body| body.with_static_friction_ratio(if k % 5 == 0 { 1.2 } else { 1.0 }))
            .unwrap();
        if k % 7 == 0 { body.one_way() } else { body }
    })
}

#[test]
fn steps_without_an_event_have_the_answers_of_steps_by_events() {
    let mut checked = 0;
    for excitation in [Excitation::Force, Excitation::SurfaceAcceleration, Excitation::DampedFootMotion] {
        let record = Record::new(excitation, 0.01, smooth(1500)).unwrap();
        // From rest and from speeds beyond which the first slide goes, or from which it only falls.
        for (body, v) in bodies().zip([0.0, 0.4, 0.03, 1.0, 0.001].into_iter().cycle()) {
            let quick = body.follow_from(&record, 0.0, v).unwrap();
            let slow = body.motion(&record, 0.0, v, 1.0).unwrap().answer;
            assert_eq!(
                (quick.slides, quick.stops, quick.reversals),
                (slow.slides, slow.stops, slow.reversals),
                "{body:?}"
            );
            let length = slow.max_displacement.abs().max(slow.min_displacement.abs());
            let speed = slow.max_velocity.max(-slow.min_velocity);
            let work = slow.load_work.abs().max(slow.friction_work);
            for (name, quick, slow, size) in [
                ("max_displacement", quick.max_displacement, slow.max_displacement, length),
                ("min_displacement", quick.min_displacement, slow.min_displacement, length),
                ("max_velocity", quick.max_velocity, slow.max_velocity, speed),
                ("min_velocity", quick.min_velocity, slow.min_velocity, speed),
                (
                    "max_velocity_time",
                    quick.max_velocity_time.unwrap(),
                    slow.max_velocity_time.unwrap(),
                    100.0,
                ),
                (
                    "min_velocity_time",
                    quick.min_velocity_time.unwrap(),
                    slow.min_velocity_time.unwrap(),
                    100.0,
                ),
                (
                    "acceleration",
                    quick.max_absolute_acceleration,
                    slow.max_absolute_acceleration,
                    slow.max_absolute_acceleration,
                ),
                (
                    "force",
                    quick.max_transmitted_force,
                    slow.max_transmitted_force,
                    slow.max_transmitted_force,
                ),
                ("end_velocity", quick.end_velocity, slow.end_velocity, speed),
                ("path", quick.path, slow.path, slow.path),
                ("stick_time", quick.stick_time, slow.stick_time, 15.0),
                ("load_work", quick.load_work, slow.load_work, work),
                ("damper_work", quick.damper_work, slow.damper_work, work),
            ] {
                let off = (quick - slow).abs();
                assert!(off <= 2e-12 * size, "{name}: {quick} and {slow} of {body:?}, {excitation:?}");
            }
            checked += slow.slides;
        }
    }
    assert!(checked > 3000, "{checked} slides");
}
