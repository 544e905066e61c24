//! Relations that need no reference: the mirror image, other units, a common factor, a step in two, a later beginning.

use crate::machines::Driven;
use crate::random::Random;
use crate::records::{RECORDS, Shaken};
use stickslip::motion::record::{Entry, RecordAnswer};
use stickslip::motion::{LongRun, State};
use stickslip::{Excitation, Response, Scales};

/// The values of an answer by name; a count as a number, and NaN where there is none.
fn values(answer: &RecordAnswer<f64>) -> Vec<(&'static str, f64)> {
    let value = |entry: Entry<'_, f64>| match entry {
        Entry::Value(value) => value.copied().unwrap_or(f64::NAN),
        Entry::Count(count) => count as f64,
    };
    answer.entries().into_iter().map(|(name, _, entry)| (name, value(entry))).collect()
}

fn of(all: &[(&str, f64)], name: &str) -> f64 {
    all.iter().find(|(other, _)| *other == name).unwrap_or_else(|| panic!("{name}")).1
}

/// The name of an answer in the mirror, and whether it changes its sign there.
fn mirrored(name: &str) -> (String, f64) {
    if let Some(rest) = name.strip_prefix("max_").filter(|rest| is_signed(rest)) {
        return (format!("min_{rest}"), if rest.ends_with("_time") { 1.0 } else { -1.0 });
    }
    if let Some(rest) = name.strip_prefix("min_") {
        return (format!("max_{rest}"), if rest.ends_with("_time") { 1.0 } else { -1.0 });
    }
    let turns = ["end_displacement", "end_velocity", "residual_displacement"].contains(&name);
    (name.to_owned(), if turns { -1.0 } else { 1.0 })
}

fn is_signed(rest: &str) -> bool {
    rest.starts_with("displacement") || rest.starts_with("velocity")
}

fn same(one: f64, two: f64) -> bool {
    one == two || (one.is_nan() && two.is_nan())
}

/// A body in the mirror: the friction of each direction is that of the other, and forces and samples change their signs.
fn mirror(shaken: &Shaken) -> Shaken {
    let samples = shaken.samples.iter().map(|x| -x).collect();
    let [forward, backward] = shaken.friction;
    let start = shaken.start.map(|x| -x);
    Shaken { friction: [backward, forward], mean: -shaken.mean, samples, start, ..shaken.clone() }
}

/// The mirror image of a record, bit for bit.
#[test]
fn a_record_in_the_mirror_moves_in_the_mirror() {
    let mut random = Random(61);
    let mut compared = 0;
    for excitation in RECORDS {
        for _ in 0..500 {
            let shaken = Shaken { is_one_way: false, ..Shaken::any(&mut random, excitation) };
            let (one, two) = (values(&shaken.followed()), values(&mirror(&shaken).followed()));
            compared += 1;
            for (name, value) in &one {
                let (other, sign) = mirrored(name);
                assert!(
                    same(*value, sign * of(&two, &other)),
                    "{name} {value} {}: {shaken:?}",
                    of(&two, &other)
                );
            }
        }
    }
    assert_eq!(compared, 2000);
}

/// The body and its record in units of force, length and time that are these times those of before.
fn in_units(shaken: &Shaken, [force, length, time]: [f64; 3]) -> Shaken {
    let (mass, velocity) = (force * time * time / length, length / time);
    let size = match shaken.excitation {
        stickslip::Excitation::Force => force,
        stickslip::Excitation::SurfaceAcceleration => velocity / time,
        _ => length,
    };
    Shaken {
        mass: shaken.mass * mass,
        stiffness: shaken.stiffness * (force / length),
        damping: shaken.damping * (force / velocity),
        friction: shaken.friction.map(|x| x * force),
        mean: shaken.mean * force,
        start: [shaken.start[0] * length, shaken.start[1] * velocity],
        times: shaken.times.iter().map(|t| t * time).collect(),
        samples: shaken.samples.iter().map(|x| x * size).collect(),
        ..shaken.clone()
    }
}

/// The size of a unit of an answer.
fn size(name: &str, [force, length, time]: [f64; 3]) -> f64 {
    if name.ends_with("_time") {
        time
    } else if name.ends_with("_work") {
        force * length
    } else if name.contains("force") {
        force
    } else if name.contains("acceleration") {
        length / time / time
    } else if name.contains("velocity") {
        length / time
    } else if name.contains("displacement") || name == "path" || name == "cycle_amplitude" {
        length
    } else if name == "equivalent_stiffness" {
        force / length
    } else {
        1.0
    }
}

/// The scale on which an answer has rounding.
fn scale(all: &[(&'static str, f64)], name: &str, span: f64) -> f64 {
    let most = |names: &[&str]| names.iter().map(|name| of(all, name).abs()).fold(0.0, f64::max);
    if name == "stick_time" {
        span
    } else if name.ends_with("_time") {
        // An extreme is flat: its time is known to the root of the rounding.
        span * 1e4
    } else if name.ends_with("_work") {
        most(&["friction_work", "damper_work", "load_work"])
    } else if ["path", "equivalent_stiffness", "equivalent_damping_ratio"].contains(&name) {
        most(&[name])
    } else if name.contains("force") {
        most(&["max_transmitted_force"])
    } else if name.contains("acceleration") {
        most(&["max_absolute_acceleration"])
    } else if name.contains("velocity") {
        most(&["max_velocity", "min_velocity"])
    } else {
        most(&["max_displacement", "min_displacement"])
    }
}

/// Whether extremes may be equal at several times, of which rounding chooses one: under loads of one size, and in a long
/// slide without a damper.
fn has_ties(shaken: &Shaken) -> bool {
    let is_again = |i: usize| shaken.samples[..i].iter().any(|x| x.abs() == shaken.samples[i].abs());
    shaken.damping == 0.0 || (1..shaken.samples.len()).any(is_again)
}

/// Holds all answers of two bodies against each other, counts exactly and values to rounding.
fn hold(one: &Shaken, two: &Shaken, units: [f64; 3], later: f64) {
    let (first, second) = (values(&one.followed()), values(&two.followed()));
    let span = one.times[one.times.len() - 1] - one.times[0];
    let has_ties = has_ties(one);
    for (name, value) in &first {
        if has_ties && name.ends_with("_time") && *name != "stick_time" {
            continue;
        }
        let unit = size(name, units);
        let mut other = of(&second, name) / unit;
        // The time at rest is a duration, of which a later beginning adds none where the body moves from the start.
        if name.ends_with("_time") && *name != "stick_time" {
            other -= later;
        }
        let is_count = ["slides", "stops", "reversals"].contains(name);
        let room = if is_count { 0.0 } else { 1e-10 * scale(&first, name, span) };
        let is_so = same(*value, other) || (value - other).abs() <= room;
        assert!(is_so, "{name}: {value} {other} of {one:?} and {two:?}");
    }
}

/// Five systems of units, powers of two among them, in which rounding is the same.
#[test]
fn other_units_have_the_same_motion() {
    let mut random = Random(62);
    for excitation in RECORDS {
        for _ in 0..60 {
            let shaken = Shaken::any(&mut random, excitation);
            for units in [
                [1e-3, 1e3, 1.0],
                [1.0 / 4.448_221_615_260_5, 1.0 / 0.0254, 1.0],
                [1.0, 100.0, 1e3],
                [1e-3, 1.0, 1.0 / 60.0],
            ] {
                hold(&shaken, &in_units(&shaken, units), units, 0.0);
            }
            let exact = [0.25, 64.0, 1.0];
            let (one, two) = (values(&shaken.followed()), values(&in_units(&shaken, exact).followed()));
            for (name, value) in &one {
                let other = of(&two, name) / size(name, exact);
                assert!(same(*value, other), "{name}: {value} {other} of {shaken:?}");
            }
        }
    }
}

/// Mass, stiffness, damping and all forces times one factor: the motion stays, forces and works have the factor.
#[test]
fn a_factor_of_everything_changes_no_motion() {
    let mut random = Random(63);
    for excitation in RECORDS {
        for _ in 0..60 {
            let shaken = Shaken::any(&mut random, excitation);
            for factor in [0.37, 1e4] {
                // The unit of force in which all of them are smaller, with the motion as it is.
                hold(&shaken, &in_units(&shaken, [factor, 1.0, 1.0]), [factor, 1.0, 1.0], 0.0);
            }
        }
    }
}

/// A step of a record split in two.
#[test]
fn a_step_in_two_is_the_same_step() {
    let mut random = Random(64);
    for excitation in RECORDS {
        for _ in 0..100 {
            let shaken = Shaken::any(&mut random, excitation);
            let mut split = shaken.clone();
            let at = (random.next() * (shaken.times.len() - 1) as f64) as usize;
            let part = random.between(0.1, 0.9);
            let between = |all: &[f64]| all[at] + part * (all[at + 1] - all[at]);
            split.times.insert(at + 1, between(&shaken.times));
            split.samples.insert(at + 1, between(&shaken.samples));
            hold(&shaken, &split, [1.0; 3], 0.0);
        }
    }
}

/// A step of zeros before a record that begins with zero: the body rests before it, and all times are later by the step.
#[test]
fn a_later_beginning_changes_times_alone() {
    let mut random = Random(65);
    for excitation in RECORDS {
        for _ in 0..100 {
            let mut shaken = Shaken { start: [0.0; 2], ..Shaken::any(&mut random, excitation) };
            // At rest without a load: friction holds the constant force, and the first sample is zero.
            if shaken.friction[0].min(shaken.friction[1]) == 0.0 {
                continue;
            }
            shaken.samples[0] = 0.0;
            let step = shaken.times[1] - shaken.times[0];
            let mut later = shaken.clone();
            later.times = shaken.times.iter().map(|t| t + step).collect();
            later.times.insert(0, shaken.times[0]);
            later.samples.insert(0, 0.0);
            let (one, two) = (values(&shaken.followed()), values(&later.followed()));
            let span = shaken.times[shaken.times.len() - 1] - shaken.times[0];
            let has_ties = has_ties(&shaken);
            for (name, value) in &one {
                if has_ties && name.ends_with("_time") && *name != "stick_time" {
                    continue;
                }
                let other = of(&two, name);
                let first = shaken.times[0];
                let is_count = ["slides", "stops", "reversals"].contains(name);
                let room = if is_count { 0.0 } else { 1e-10 * scale(&one, name, span) };
                // The rest before the beginning counts as rest, and a value of the first instant keeps its time.
                let by = if name.ends_with("_time") && (*name == "stick_time" || *value != first) {
                    step
                } else {
                    0.0
                };
                let is_so = same(*value, other) || (value + by - other).abs() <= room;
                assert!(is_so, "{name}: {value} {other} of {shaken:?}");
            }
        }
    }
}

/// Harmonic motions: the start in the mirror half a turn later leads to the mirror image, bit for bit.
#[test]
fn a_start_in_the_mirror_leads_to_the_mirror_image() {
    let mut random = Random(66);
    let mut asymmetric = 0;
    for i in 0..400 {
        let driven = Driven::any(&mut random, Excitation::ALL[i % Excitation::ALL.len()]);
        let ratios = driven.ratios();
        let start = [random.between(-4.0, 4.0), random.between(-4.0, 4.0)];
        let one = LongRun::from_start(ratios, State::new(0.0, start[0], start[1]).unwrap()).unwrap();
        let half = stickslip::motion::DrivePhase::new(0, std::f64::consts::PI).unwrap();
        let other = State { phase: half, x: -start[0], v: -start[1] };
        let two = LongRun::from_start(ratios, other).unwrap();
        let (Some(one), Some(two)) = (one.steady_state(), two.steady_state()) else { continue };
        asymmetric += u32::from(!one.is_symmetric);
        let size = one.max_displacement.value.abs() + one.min_displacement.value.abs();
        let room = 1e-9 * size + one.distance.0 + two.distance.0;
        for (a, b) in [
            (one.max_displacement.value, -two.min_displacement.value),
            (one.min_displacement.value, -two.max_displacement.value),
        ] {
            assert!((a - b).abs() <= room, "{a} {b} {driven:?} {start:?}");
        }
        assert_eq!(one.sticks_per_cycle, two.sticks_per_cycle, "{driven:?} {start:?}");
        assert_eq!(one.is_symmetric, two.is_symmetric, "{driven:?} {start:?}");
    }
    assert!(asymmetric > 3, "{asymmetric}");
}

/// Harmonic motions in other units, and with everything times one factor: answers in ratios stay, and each unit is the
/// product of its own factors.
#[test]
fn ratios_are_the_same_in_all_units() {
    let mut random = Random(67);
    for i in 0..200 {
        let driven = Driven::any(&mut random, Excitation::ALL[i % Excitation::ALL.len()]);
        let (force, length) = (0.125, 512.0);
        let amplitude = match driven.excitation {
            stickslip::Excitation::Force => force,
            stickslip::Excitation::Unbalance => force / length * length,
            _ => length,
        };
        let other = Driven {
            mass: driven.mass * force / length,
            stiffness: driven.stiffness * force / length,
            damping: driven.damping * force / length,
            friction: driven.friction * force,
            offset: driven.offset * force,
            mean: driven.mean * force,
            amplitude: driven.amplitude * amplitude,
            ..driven
        };
        let (one, two) = (driven.ratios(), other.ratios());
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-14 * a.abs();
        assert!(close(one.omega(), two.omega()) && close(one.alpha(), two.alpha()), "{driven:?}");
        assert!(close(one.damping_ratio(), two.damping_ratio()), "{driven:?}");
        let scales = |driven: &Driven| Scales::new(&driven.oscillator(), &driven.drive()).unwrap();
        let (a, b) = (scales(&driven), scales(&other));
        assert!(close(a.length * length, b.length) && close(a.force * force, b.force), "{driven:?}");
        assert!(close(a.velocity * length, b.velocity) && close(a.time, b.time), "{driven:?}");
        let energies = close(a.energy_stiffness * force * length, b.energy_stiffness)
            && close(a.energy_inertia * force * length, b.energy_inertia);
        assert!(energies, "{driven:?}");
        // Everything times two.
        let doubled = Driven {
            mass: 2.0 * driven.mass,
            stiffness: 2.0 * driven.stiffness,
            damping: 2.0 * driven.damping,
            friction: 2.0 * driven.friction,
            offset: 2.0 * driven.offset,
            mean: 2.0 * driven.mean,
            amplitude: match driven.excitation {
                stickslip::Excitation::Force | stickslip::Excitation::Unbalance => 2.0 * driven.amplitude,
                _ => driven.amplitude,
            },
            ..driven
        };
        let [one, two] = [driven, doubled].map(|driven| Response::new(driven.ratios()));
        let [one, two] = [one, two].map(|response| response.cycle.map(|cycle| cycle.max_displacement));
        match (one, two) {
            (Some(one), Some(two)) => {
                assert!((one - two).abs() <= 1e-12 * one.abs(), "{driven:?}: {one} {two}")
            }
            (one, two) => assert_eq!(one, two, "{driven:?}"),
        }
    }
}
