//! Sixteen machines under records, with answers to 25 digits from an independent program.

use serde_json::Value;
use stickslip::motion::record::{Body, Record};
use stickslip::{Excitation, Float};

/// A number in the text of the reference, in decimal or as a 64-bit number.
fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn cases() -> Vec<Value> {
    serde_json::from_str(include_str!("../data/records.json")).unwrap()
}

/// The machine and the record of a case, given the number of a text.
fn built<F: Float>(case: &Value, number: impl Fn(&str) -> F) -> (Body<F>, Record<F>) {
    let of = |key: &str| number(&text(&case[key]));
    let forward = of("friction");
    let mut body = Body::new(of("mass"), forward)
        .and_then(|body| body.with_stiffness(of("stiffness")))
        .and_then(|body| body.with_damping(of("damping")))
        .and_then(|body| body.with_static_friction_ratio(of("static_friction_ratio")))
        .unwrap();
    if !case["friction_backward"].is_null() {
        body = body.with_directional_friction(forward, of("friction_backward")).unwrap();
    }
    let samples = case["base_acceleration_mm_s2"].as_array().unwrap();
    let samples = samples.iter().map(|sample| number(&text(sample)) / F::int(1000)).collect();
    let record = Record::new(Excitation::SurfaceAcceleration, of("time_step"), samples).unwrap();
    (body, record)
}

/// Holds every answer against the references: values relative to their size, and times in seconds.
fn hold<F: Float>(number: impl Fn(&str) -> F + Copy, relative: F, seconds: F) {
    for (index, case) in cases().iter().enumerate() {
        let (body, record) = built(case, number);
        let found = body.follow(&record).unwrap();
        let of = |key: &str| number(&text(&case["answer"][key]));
        let count = |key: &str| case["answer"][key].as_u64().unwrap();
        assert_eq!((found.slides, found.stops), (count("slides"), count("stops")), "{index}");
        let length = of("max_x").abs().or_larger(of("min_x").abs());
        let speed = of("max_v").abs().or_larger(of("min_v").abs());
        let work = of("load_work").abs();
        for (name, value, size) in [
            ("max_x", found.max_displacement, length),
            ("min_x", found.min_displacement, length),
            ("max_v", found.max_velocity, speed),
            ("min_v", found.min_velocity, speed),
            ("path", found.path, length),
            ("end_x", found.end_displacement, length),
            ("residual_x", found.residual_displacement.unwrap(), length),
            ("friction_work", found.friction_work, work),
            ("damper_work", found.damper_work, work),
            ("load_work", found.load_work, work),
        ] {
            let error = (value - of(name)).abs() / size;
            assert!(error < relative, "{index} {name}: {value:?} against {:?}, {error:?}", of(name));
        }
        for (name, value) in [
            ("max_x_time", found.max_displacement_time),
            ("min_x_time", found.min_displacement_time),
            ("max_v_time", found.max_velocity_time),
            ("min_v_time", found.min_velocity_time),
        ] {
            assert!((value - of(name)).abs() < seconds, "{index} {name}: {value:?} against {:?}", of(name));
        }
        // The references count the rest of the step in which a body stops after the record.
        let step = record.step().unwrap();
        let motion = body.motion(&record, F::int(0), F::int(0), F::int(1)).unwrap();
        let last = motion.events.last().map_or(F::int(0), |event| event.time - record.end());
        let after = if last > F::int(0) { step - (last - (last / step).floor() * step) } else { F::int(0) };
        let error = (found.stick_time + after - of("stick_time")).abs();
        assert!(error < seconds, "{index} rest: {:?} + {after:?}, {error:?}", found.stick_time);
    }
}

#[test]
fn every_answer_of_the_references_is_met() {
    hold(|text| text.parse::<f64>().unwrap(), 1e-12, 1e-11);
}

#[cfg(feature = "mp")]
#[test]
fn every_answer_of_the_references_is_met_to_20_digits() {
    use stickslip::float::Mp;
    hold(|text| text.parse::<Mp<2>>().unwrap(), Mp::from(1e-20), Mp::from(1e-20));
}
