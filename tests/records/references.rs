//! Sixteen machines under records, with answers to 25 digits from an independent program, and twenty-four with accelerations
//! and forces from one that steps in time.

use crate::compared::{Origin::AnotherProgram, compared};
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

/// Holds every answer against the references, values relative to their size and times in seconds, and keeps what it compared with the
/// bound.
fn hold<F: Float>(number: impl Fn(&str) -> F + Copy, relative: F, seconds: F, keep: impl Fn(&str, F, F, F)) {
    for (index, case) in cases().iter().enumerate() {
        let (body, record) = built(case, number);
        let found = body.follow(&record).unwrap();
        let of = |key: &str| number(&text(&case["answer"][key]));
        let count = |key: &str| case["answer"][key].as_u64().unwrap();
        let ends = found.stops + found.reversals;
        assert_eq!((found.slides, ends), (count("slides"), count("stops")), "{index}");
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
            keep(name, value, of(name), relative * size);
        }
        for (name, value) in [
            ("max_x_time", found.max_displacement_time.unwrap()),
            ("min_x_time", found.min_displacement_time.unwrap()),
            ("max_v_time", found.max_velocity_time.unwrap()),
            ("min_v_time", found.min_velocity_time.unwrap()),
        ] {
            assert!((value - of(name)).abs() < seconds, "{index} {name}: {value:?} against {:?}", of(name));
            keep(name, value, of(name), seconds);
        }
        // The references count the rest of the step in which a body stops after the record.
        let step = record.step().unwrap();
        let motion = body.motion(&record, F::int(0), F::int(0), F::int(1)).unwrap();
        let last = motion.events.last().map_or(F::int(0), |event| event.time - record.end());
        let after = if last > F::int(0) { step - (last - (last / step).floor() * step) } else { F::int(0) };
        let error = (found.stick_time + after - of("stick_time")).abs();
        assert!(error < seconds, "{index} rest: {:?} + {after:?}, {error:?}", found.stick_time);
        keep("stick_time", found.stick_time + after, of("stick_time"), seconds);
    }
}

#[test]
fn every_answer_of_the_references_is_met() {
    hold(
        |text| text.parse::<f64>().unwrap(),
        1e-12,
        1e-11,
        |name, ours, other, bound| {
            let names = [("_x", "_displacement"), ("_v", "_velocity"), ("", "")];
            let of = names.iter().find(|(short, _)| name.contains(short)).unwrap();
            let output = format!("record {}", name.replacen(of.0, of.1, 1));
            compared(&output, ours, other, AnotherProgram, bound);
        },
    );
}

#[cfg(feature = "mp")]
#[test]
fn every_answer_of_the_references_is_met_to_20_digits() {
    use stickslip::float::Mp;
    hold(|text| text.parse::<Mp<2>>().unwrap(), Mp::from(1e-20), Mp::from(1e-20), |_, _, _, _| ());
}

/// Every answer of the references is enclosed to 18 digits, and so is the motion at 512 bits.
#[cfg(feature = "mp")]
#[test]
fn every_answer_of_the_references_is_enclosed() {
    use stickslip::Field;
    use stickslip::enclosed::{self, Enclosure};
    use stickslip::float::Mp;
    for (index, case) in cases().iter().enumerate() {
        let (body, record) = built(case, |text| text.parse::<Mp<17>>().unwrap());
        let found = enclosed::follow(&body, &record, Mp::ZERO, Mp::ZERO, 64);
        let found = found.unwrap_or_else(|e| panic!("{index}: {e}"));
        let (body, record) = built(case, |text| text.parse::<Mp<8>>().unwrap());
        let exact = body.follow(&record).unwrap();
        assert_eq!((found.slides, found.stops), (exact.slides, exact.stops), "{index}");
        let length = exact.max_displacement.abs().or_larger(exact.min_displacement.abs());
        let speed = exact.max_velocity.abs().or_larger(exact.min_velocity.abs());
        let (work, one) = (exact.load_work.abs(), Mp::<8>::int(1));
        let hold = |name: &str, found: &Enclosure, exact: Mp<8>, size: Mp<8>| {
            let rad = Mp::<8>::from(&found.rad);
            assert!(found.contains(&rug::Float::from(exact)), "{index} {name}: {found} and {exact}");
            assert!(rad < size * Mp::from(1e-18), "{index} {name}: ± {rad}");
            if let Some(reference) = case["answer"].get(name) {
                let reference = text(reference).parse::<Mp<8>>().unwrap();
                let off = (reference - Mp::from(&found.mid)).abs();
                assert!(off < rad + size * Mp::from(1e-21), "{index} {name}: {found} and {reference}");
            }
        };
        hold("max_x", &found.max_displacement, exact.max_displacement, length);
        hold("min_x", &found.min_displacement, exact.min_displacement, length);
        hold("max_v", &found.max_velocity, exact.max_velocity, speed);
        hold("min_v", &found.min_velocity, exact.min_velocity, speed);
        hold("path", &found.path, exact.path, length);
        hold("end_x", &found.end_displacement, exact.end_displacement, length);
        hold(
            "residual_x",
            found.residual_displacement.as_ref().unwrap(),
            exact.residual_displacement.unwrap(),
            length,
        );
        hold("friction_work", &found.friction_work, exact.friction_work, work);
        hold("damper_work", &found.damper_work, exact.damper_work, work);
        hold("load_work", &found.load_work, exact.load_work, work);
        hold(
            "max_x_time",
            found.max_displacement_time.as_ref().unwrap(),
            exact.max_displacement_time.unwrap(),
            one,
        );
        hold("min_v_time", found.min_velocity_time.as_ref().unwrap(), exact.min_velocity_time.unwrap(), one);
        let greatest = exact.max_absolute_acceleration;
        hold("max_acceleration", &found.max_absolute_acceleration, greatest, greatest);
        let greatest = exact.max_transmitted_force;
        hold("max_force", &found.max_transmitted_force, greatest, greatest);
    }
}

/// Accelerations in space, forces on the support, motions and counts of rests, of bodies with and without a spring.
#[test]
fn forces_and_accelerations_are_those_of_stepping_in_time() {
    let text = include_str!("../data/forces.csv");
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let mut count = 0;
    for (index, row) in rows.enumerate() {
        count += 1;
        let field = |name: &str| row[names.iter().position(|other| *other == name).unwrap()];
        let of = |name: &str| field(name).parse::<f64>().unwrap();
        let body = Body::new(of("mass"), of("friction"))
            .and_then(|body| body.with_stiffness(of("stiffness")))
            .and_then(|body| body.with_damping(of("damping")))
            .and_then(|body| body.with_static_friction_ratio(of("static_friction_ratio")))
            .unwrap();
        let excitation = match field("excitation") {
            "force" => Excitation::Force,
            _ => Excitation::SurfaceAcceleration,
        };
        let samples: Vec<f64> = field("samples").split(' ').map(|sample| sample.parse().unwrap()).collect();
        // The program that steps in time counts the rest at its first instant, though the first sample moves the body at once.
        let (held, of_mass) = match excitation {
            Excitation::Force => (0.0, samples[0].abs()),
            _ => (samples[0].abs(), of("mass") * samples[0].abs()),
        };
        let moves_at_once = of_mass > of("friction") * of("static_friction_ratio");
        let at_first = |found: f64, held: f64| if moves_at_once { found.max(held) } else { found };
        let found = body.follow(&Record::new(excitation, of("time_step"), samples).unwrap()).unwrap();
        assert_eq!(found.stops.to_string(), field("stops"), "{index}");
        let length = of("max_displacement").max(-of("min_displacement"));
        let speed = of("max_velocity").max(-of("min_velocity"));
        let (acceleration, force) = (of("max_absolute_acceleration"), of("max_transmitted_force"));
        for (name, value, size) in [
            ("max_absolute_acceleration", at_first(found.max_absolute_acceleration, held), acceleration),
            ("max_transmitted_force", at_first(found.max_transmitted_force, of_mass), force),
            ("max_displacement", found.max_displacement, length),
            ("min_displacement", found.min_displacement, length),
            ("max_velocity", found.max_velocity, speed),
            ("min_velocity", found.min_velocity, speed),
            ("path", found.path, of("path")),
            ("residual_displacement", found.residual_displacement.unwrap(), length),
        ] {
            let error = (value - of(name)).abs();
            assert!(error <= 1e-10 * size, "{index} {name}: {value} against {}", of(name));
        }
    }
    assert_eq!(count, 24);
}

/// Answers of random bodies to 40 digits, from power series in time (`tests/data/record_answers.py`), are enclosed.
#[cfg(feature = "mp")]
#[test]
fn answers_of_random_bodies_are_enclosed() {
    use stickslip::Field;
    use stickslip::enclosed::{self, Enclosure};
    use stickslip::float::Mp;
    let text = include_str!("../data/record_answers.csv");
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let (mut held, mut undecided) = (0, 0);
    for (index, row) in rows.enumerate() {
        let field = |name: &str| row[names.iter().position(|other| *other == name).unwrap()];
        let of = |name: &str| field(name).parse::<Mp<4>>().unwrap();
        let body = Body::new(of("mass"), of("friction"))
            .and_then(|body| body.with_stiffness(of("stiffness")))
            .and_then(|body| body.with_damping(of("damping")))
            .and_then(|body| body.with_static_friction_ratio(of("static_friction_ratio")))
            .unwrap();
        let excitation = match field("excitation") {
            "force" => Excitation::Force,
            "base_acceleration" => Excitation::SurfaceAcceleration,
            "foot_displacement" => Excitation::FootMotion,
            _ => Excitation::DampedFootMotion,
        };
        let samples = field("samples").split(' ').map(|sample| sample.parse().unwrap()).collect();
        let record = Record::new(excitation, of("time_step"), samples).unwrap();
        let found = match enclosed::follow(&body, &record, of("x"), of("v"), 96) {
            Ok(found) => found,
            Err(stickslip::Error::UncertainEvent { .. }) => {
                undecided += 1;
                continue;
            }
            Err(error) => panic!("{index}: {error}"),
        };
        held += 1;
        for (name, count) in
            [("slides", found.slides), ("stops", found.stops), ("reversals", found.reversals)]
        {
            assert_eq!(field(name), count.to_string(), "{index} {name}");
        }
        let answers: [(&str, &Enclosure); 14] = [
            ("max_displacement", &found.max_displacement),
            ("min_displacement", &found.min_displacement),
            ("max_velocity", &found.max_velocity),
            ("min_velocity", &found.min_velocity),
            ("max_absolute_acceleration", &found.max_absolute_acceleration),
            ("max_transmitted_force", &found.max_transmitted_force),
            ("end_displacement", &found.end_displacement),
            ("end_velocity", &found.end_velocity),
            ("residual_displacement", found.residual_displacement.as_ref().unwrap()),
            ("path", &found.path),
            ("stick_time", &found.stick_time),
            ("friction_work", &found.friction_work),
            ("damper_work", &found.damper_work),
            ("load_work", &found.load_work),
        ];
        for (name, found) in answers {
            // The reference has 40 digits, and the path to a limit is cut at 1e-42.
            let reference = of(name);
            let off = (reference - Mp::from(&found.mid)).abs();
            let most = Mp::<4>::from(&found.rad) + reference.abs() * Mp::from(1e-38) + Mp::from(1e-40);
            assert!(off <= most, "{index} {name}: {found} and {reference}");
            assert!(found.rad < 1e-20, "{index} {name}: {found}");
        }
    }
    assert!(held >= 200 && undecided * 20 < held, "{held} enclosed, {undecided} undecided");
}
