//! The answers of motions under records, every one of them, beside dense samples.

use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{compared, recorded};
use crate::random::Random;
use crate::sampled::{Extreme, Load, Machine, Of, Recorded, record};
use stickslip::Excitation;
use stickslip::motion::record::{Body, Entry, Record, RecordAnswer};

/// A body and a record in any consistent units.
#[derive(Debug, Clone)]
pub(crate) struct Shaken {
    pub(crate) mass: f64,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    pub(crate) friction: [f64; 2],
    pub(crate) eta: f64,
    pub(crate) mean: f64,
    pub(crate) is_one_way: bool,
    pub(crate) start: [f64; 2],
    pub(crate) excitation: Excitation,
    pub(crate) times: Vec<f64>,
    pub(crate) samples: Vec<f64>,
}

/// Every kind of record.
pub(crate) const RECORDS: [Excitation; 4] = [
    Excitation::Force,
    Excitation::FootMotion,
    Excitation::DampedFootMotion,
    Excitation::SurfaceAcceleration,
];

impl Shaken {
    /// A body with or without spring, damper and friction under white noise, a slow wave or steps.
    pub(crate) fn any(random: &mut Random, excitation: Excitation) -> Self {
        let mass = random.scale(0.01, 100.0);
        let step = random.scale(1e-3, 1.0);
        let is_free = random.next() < 0.2 && excitation != Excitation::FootMotion;
        // From a fiftieth of a period to ten periods in a step.
        let natural = std::f64::consts::TAU * random.scale(0.02, 3.0) / step;
        let stiffness = if is_free { 0.0 } else { mass * natural * natural };
        let zeta = match (random.next() * 5.0) as u32 {
            0 => 0.0,
            1 => random.between(1.0, 3.0),
            _ => random.scale(3e-3, 0.5),
        };
        let damping = if is_free { mass * zeta / step } else { 2.0 * zeta * mass * natural };
        // The acceleration of the load, over that of friction.
        let level = random.scale(0.1, 30.0);
        let has_none = random.next() < 0.1 && (zeta > 0.0) && !is_free;
        let friction = if has_none { 0.0 } else { mass * level * random.scale(0.02, 0.9) };
        let backward = if random.next() < 0.25 { friction * random.between(0.5, 2.0) } else { friction };
        let eta = if random.next() < 0.25 { random.between(1.01, 2.0) } else { 1.0 };
        let is_one_way = random.next() < 0.1 && !has_none;
        let mean =
            if random.next() < 0.25 && !has_none { friction * random.between(-0.45, 0.45) } else { 0.0 };
        let count = 3 + (random.next() * 30.0) as usize;
        let kind = (random.next() * 3.0) as u32;
        let samples: Vec<f64> = (0..count)
            .map(|i| match kind {
                0 => random.between(-1.0, 1.0),
                1 => (0.7 * i as f64).sin() * (-0.05 * i as f64).exp(),
                _ => f64::from((random.next() * 3.0) as i32 - 1),
            })
            .collect();
        let size = match excitation {
            Excitation::Force => mass * level,
            Excitation::SurfaceAcceleration => level,
            // A support whose spring gives this force, or whose damper does.
            _ if stiffness > 0.0 => mass * level / stiffness.max(damping / step),
            _ => mass * level * step / damping.max(mass / step),
        };
        let samples = samples.iter().map(|x| x * size).collect();
        let is_even = random.next() < 0.6;
        let mut times = vec![if is_even { 0.0 } else { random.between(-2.0, 2.0) * step }];
        for _ in 1..count {
            let last = times[times.len() - 1];
            times.push(last + if is_even { step } else { step * random.between(0.3, 2.0) });
        }
        let start = if random.next() < 0.3 {
            let v = random.between(-1.0, 1.0) * level * step;
            [random.between(-1.0, 1.0) * level * step * step, if is_one_way { v.abs() } else { v }]
        } else {
            [0.0, 0.0]
        };
        let friction = [friction, backward];
        Self { mass, stiffness, damping, friction, eta, mean, is_one_way, start, excitation, times, samples }
    }

    pub(crate) fn body(&self) -> Body<f64> {
        let body = Body::new(self.mass, self.friction[0]).unwrap();
        let body = body.with_directional_friction(self.friction[0], self.friction[1]).unwrap();
        let body = body.with_stiffness(self.stiffness).unwrap().with_damping(self.damping).unwrap();
        let body = if self.eta > 1.0 { body.with_static_friction_ratio(self.eta).unwrap() } else { body };
        let body = body.with_mean_force(self.mean).unwrap();
        if self.is_one_way { body.one_way() } else { body }
    }

    pub(crate) fn record(&self) -> Record<f64> {
        Record::at_times(self.excitation, self.times.clone(), self.samples.clone()).unwrap()
    }

    pub(crate) fn load(&self) -> Load {
        match self.excitation {
            Excitation::Force => Load::Force,
            Excitation::FootMotion => Load::Foot,
            Excitation::DampedFootMotion => Load::DampedFoot,
            _ => Load::Surface,
        }
    }

    pub(crate) fn sampled(&self, parts: f64) -> Recorded {
        let ([forward, backward], rows) = (self.friction, [self.mass, self.stiffness, self.damping]);
        let friction = [(forward + backward) / 2.0, (forward - backward) / 2.0, self.eta];
        let machine = Machine { is_one_way: self.is_one_way, ..Machine::new(rows, friction, self.mean) };
        record(machine, self.load(), &self.times, &self.samples, self.start, parts)
    }

    /// Whether the extreme of this name is the same at two times of the record.
    fn has_again(&self, name: &str, one: f64, two: f64) -> bool {
        let index = usize::from(name.contains("velocity"));
        let at = |time: f64| {
            let place = self.times.iter().position(|t| *t > time)?;
            let (first, second) = (place.checked_sub(1)?, place);
            let part = (time - self.times[first]) / (self.times[second] - self.times[first]);
            let mut cut = self.clone();
            cut.times.truncate(second);
            cut.samples.truncate(second);
            cut.times.push(time);
            cut.samples.push(self.samples[first] + part * (self.samples[second] - self.samples[first]));
            Some(cut.sampled(64.0).end[index])
        };
        let (one, two) = (at(one), at(two));
        one.zip(two).is_some_and(|(one, two)| (one - two).abs() <= 1e-9 * one.abs())
    }

    pub(crate) fn followed(&self) -> RecordAnswer<f64> {
        self.body().follow_from(&self.record(), self.start[0], self.start[1]).unwrap()
    }
}

/// A value of the samples: an extreme, a number or a count.
enum Expected {
    Extreme(Extreme, f64),
    Time(f64, f64),
    Number(f64, f64),
    Count(u64),
    Nothing,
}

/// What the samples give for an answer.
fn expected(name: &str, shaken: &Shaken, recorded: &Recorded) -> Expected {
    let &Recorded { ref found, end, rest, last, counts, creeps, .. } = recorded;
    let machine = Machine::new(
        [shaken.mass, shaken.stiffness, shaken.damping],
        [
            (shaken.friction[0] + shaken.friction[1]) / 2.0,
            (shaken.friction[0] - shaken.friction[1]) / 2.0,
            shaken.eta,
        ],
        shaken.mean,
    );
    let machine = Machine { is_one_way: shaken.is_one_way, ..machine };
    let (x, v) = (found.greatest(Of::Displacement).value, found.greatest(Of::Velocity).value);
    let span = shaken.times[shaken.times.len() - 1] - shaken.times[0];
    let path = found.path[0] + found.path[1];
    let work = found.friction_work(&machine)
        + found.damper_work
        + found.load_work.abs()
        + found.foot_work.abs()
        + shaken.mass * v * v;
    // An extreme is flat: its time is known to the root of the rounding of its value.
    let record_end = shaken.times[shaken.times.len() - 1];
    let time = |extreme: Extreme| {
        let is_limit = creeps && extreme.time > record_end && (extreme.value - last).abs() < 1e-10 * x;
        if is_limit { Expected::Nothing } else { Expected::Time(extreme.time, 3e-7 * span) }
    };
    let of_cycle =
        |number: Option<f64>| number.map_or(Expected::Nothing, |number| Expected::Number(number, number));
    match name {
        "max_displacement" => Expected::Extreme(found.most(Of::Displacement), x),
        "max_displacement_time" => time(found.most(Of::Displacement)),
        "min_displacement" => Expected::Extreme(found.least(Of::Displacement), x),
        "min_displacement_time" => time(found.least(Of::Displacement)),
        "peak_displacement" => {
            let extreme = found.greatest(Of::Displacement);
            Expected::Extreme(extreme, extreme.value)
        }
        "max_velocity" => Expected::Extreme(found.most(Of::Velocity), v),
        "max_velocity_time" => time(found.most(Of::Velocity)),
        "min_velocity" => Expected::Extreme(found.least(Of::Velocity), v),
        "min_velocity_time" => time(found.least(Of::Velocity)),
        "max_absolute_acceleration" => {
            let extreme = found.greatest(Of::AbsoluteAcceleration);
            Expected::Extreme(extreme, extreme.value)
        }
        "max_transmitted_force" => {
            let extreme = found.greatest(Of::Transmitted);
            Expected::Extreme(extreme, extreme.value)
        }
        "end_displacement" => Expected::Number(end[0], x),
        "end_velocity" => Expected::Number(end[1], v),
        "residual_displacement" => Expected::Number(last, x),
        "path" => Expected::Number(path, path),
        "slides" => Expected::Count(counts[0]),
        "stops" => Expected::Count(counts[1]),
        "reversals" => Expected::Count(counts[2]),
        // The motions that are compared rest, or tend to a limit.
        "cut_time" => Expected::Nothing,
        "stick_time" => Expected::Number(rest, span),
        "cycle_amplitude" => {
            of_cycle(recorded.greatest_cycle(&machine, shaken.start).map(|[amplitude, ..]| amplitude))
        }
        "equivalent_stiffness" => {
            of_cycle(recorded.greatest_cycle(&machine, shaken.start).map(|[_, stiffness, _]| stiffness))
        }
        // The integral of a fast decay needs closer samples.
        "equivalent_damping_ratio" => {
            of_cycle(shaken.sampled(128.0).greatest_cycle(&machine, shaken.start).map(|[.., ratio]| ratio))
        }
        "friction_work" => Expected::Number(found.friction_work(&machine), work),
        "damper_work" => Expected::Number(found.damper_work, work),
        "load_work" => Expected::Number(found.load_work + shaken.mean * (last - shaken.start[0]), work),
        _ => panic!("no reference of {name}"),
    }
}

/// Records an answer that is that of the samples.
fn keep(name: &str, value: &Entry<'_, f64>, expected: &Expected) {
    let output = format!("record {name} by motion::record::Body::follow_from");
    match (value, expected) {
        (
            Entry::Value(Some(found)),
            Expected::Extreme(Extreme { value, .. }, scale) | Expected::Number(value, scale),
        ) => {
            recorded(&output, *found, value, DenseSamples, 1e-9 * scale);
        }
        (Entry::Value(Some(found)), Expected::Time(time, room)) => {
            recorded(&output, *found, time, DenseSamples, *room)
        }
        (Entry::Count(found), Expected::Count(count)) => recorded(&output, found, count, DenseSamples, 0.0),
        _ => recorded(&output, &"none", &"none", DenseSamples, 0.0),
    }
}

/// The difference of an answer from the samples, where it is beyond the allowance: 1e-9 of its scale, and an extreme is
/// nowhere below a sample.
fn off(value: &Entry<'_, f64>, expected: &Expected) -> Option<String> {
    let text =
        |found: f64, reference: f64| Some(format!("{found} of the library, {reference} of the samples"));
    match (value, expected) {
        (Entry::Value(Some(found)), Expected::Extreme(extreme, scale)) => {
            let beyond =
                if extreme.value >= 0.0 { extreme.sampled - *found } else { *found - extreme.sampled };
            let is_off = beyond > 1e-11 * scale || (*found - extreme.value).abs() > 1e-9 * scale;
            if is_off { text(**found, extreme.value) } else { None }
        }
        (Entry::Value(Some(found)), Expected::Time(time, room)) => {
            if (*found - time).abs() > *room {
                text(**found, *time)
            } else {
                None
            }
        }
        (Entry::Value(Some(found)), Expected::Number(number, scale)) => {
            if (*found - number).abs() > 1e-9 * scale { text(**found, *number) } else { None }
        }
        (Entry::Value(None), Expected::Nothing) => None,
        (Entry::Count(found), Expected::Count(count)) => {
            if found != count {
                text(*found as f64, *count as f64)
            } else {
                None
            }
        }
        _ => Some("an answer is missing".to_owned()),
    }
}

/// Every answer of a motion under a record: forces, feet with and without a damper, and surfaces, with and without a
/// spring, a damper and friction.
#[test]
fn every_answer_under_a_record_is_that_of_the_samples() {
    let mut random = Random(21);
    let mut failures: std::collections::BTreeMap<String, (u32, String)> = std::collections::BTreeMap::new();
    let mut count = 0;
    for excitation in RECORDS {
        for _ in 0..60 {
            let shaken = Shaken::any(&mut random, excitation);
            let found = shaken.sampled(64.0);
            if !found.is_over {
                continue;
            }
            count += 1;
            let answer = shaken.followed();
            if shaken.start == [0.0; 2] {
                let from_rest = shaken.body().follow(&shaken.record()).unwrap();
                let x = found.found.greatest(Of::Displacement).value;
                let output = "fn motion::record::Body::follow";
                compared(output, from_rest.end_displacement, found.end[0], DenseSamples, 1e-9 * x);
            }
            for (name, _, value) in answer.entries() {
                let reference = expected(name, &shaken, &found);
                if let Some(text) = off(&value, &reference) {
                    // Of several times with one extreme rounding chooses one.
                    if let (Entry::Value(Some(time)), Expected::Time(first, _)) = (&value, &reference)
                        && shaken.has_again(name, **time, *first)
                    {
                        continue;
                    }
                    let entry =
                        failures.entry(format!("{name} {excitation:?}")).or_insert((0, String::new()));
                    entry.0 += 1;
                    if entry.1.is_empty() {
                        entry.1 = format!("{text}: {shaken:?}");
                    }
                } else {
                    keep(name, &value, &reference);
                }
            }
        }
    }
    let texts: Vec<_> =
        failures.iter().map(|(name, (n, text))| format!("{name}, {n} times: {text}")).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n"));
    assert!(count > 200, "{count}");
}

/// The accelerations and forces of a body at a place and a velocity of the samples, under a value of the record before this
/// sample, by the laws of spring, damper and friction, and the size of their terms.
fn forces(
    shaken: &Shaken,
    place: usize,
    value: f64,
    [x, v]: [f64; 2],
    direction: i8,
) -> [(&'static str, f64, f64); 5] {
    let &Shaken { mass, stiffness, damping, friction: [forward, backward], mean, .. } = shaken;
    let slope =
        (shaken.samples[place] - shaken.samples[place - 1]) / (shaken.times[place] - shaken.times[place - 1]);
    let [foot, foot_velocity, surface, force] = match shaken.load() {
        Load::Force => [0.0, 0.0, 0.0, value],
        Load::Foot => [value, 0.0, 0.0, 0.0],
        Load::DampedFoot => [value, slope, 0.0, 0.0],
        Load::Surface => [0.0, 0.0, value, 0.0],
    };
    let load = force - mass * surface + stiffness * foot + damping * foot_velocity;
    // A body at rest is held by the force that is missing.
    let friction = match direction {
        1 => -forward,
        -1 => backward,
        _ => stiffness * x - load - mean,
    };
    let acceleration = (load + mean + friction - stiffness * x - damping * v) / mass;
    let support = stiffness * (x - foot) + damping * (v - foot_velocity) - friction;
    let size = load.abs()
        + mean.abs()
        + (stiffness * x).abs()
        + (stiffness * foot).abs()
        + (damping * v).abs()
        + (damping * foot_velocity).abs()
        + friction.abs()
        + mass * surface.abs();
    [
        ("acceleration", acceleration, size / mass),
        ("absolute_acceleration", acceleration + surface, size / mass),
        ("friction", friction, size),
        ("load", load, size),
        ("transmitted_force", support, size),
    ]
}

/// The states of a motion and its events: displacement, velocity, accelerations and forces at their times, and the times of
/// stops.
#[test]
fn states_and_events_are_those_of_the_samples() {
    let mut random = Random(22);
    let (mut states, mut stops) = (0, 0);
    for excitation in RECORDS {
        for _ in 0..12 {
            let shaken = Shaken::any(&mut random, excitation);
            let span = shaken.times[shaken.times.len() - 1] - shaken.times[0];
            let [x, v] = shaken.start;
            let motion = shaken.body().motion(&shaken.record(), x, v, span / 40.0).unwrap();
            let found = shaken.sampled(128.0);
            let (x, v) =
                (found.found.greatest(Of::Displacement).value, found.found.greatest(Of::Velocity).value);
            for state in motion.states.iter().step_by(5) {
                let Some(place) = shaken.times.iter().position(|t| *t >= state.time) else { continue };
                if place == 0 {
                    continue;
                }
                // The record up to this state: its end is the state.
                let mut cut = shaken.clone();
                let part =
                    (state.time - shaken.times[place - 1]) / (shaken.times[place] - shaken.times[place - 1]);
                let load =
                    shaken.samples[place - 1] + part * (shaken.samples[place] - shaken.samples[place - 1]);
                cut.times.truncate(place);
                cut.samples.truncate(place);
                if cut.times[place - 1] >= state.time - 1e-9 * span {
                    continue;
                }
                cut.times.push(state.time);
                cut.samples.push(load);
                let end = cut.sampled(64.0).end;
                let of = |name: &str| format!("record --out {name}");
                let sign = if state.direction == 0 { 0.0 } else { end[1].signum() };
                // At an end of a slide the velocity is zero, and the direction is that of the next one.
                if state.direction == 0 || end[1].abs() > 1e-9 * v {
                    compared(&of("direction"), state.direction.into(), sign, DenseSamples, 0.0);
                }
                compared(
                    &of("displacement by motion::record::Body::motion"),
                    state.displacement,
                    end[0],
                    DenseSamples,
                    1e-9 * x,
                );
                compared(&of("velocity"), state.velocity, end[1], DenseSamples, 1e-9 * v);
                states += 1;
                // At the end of the record the load is already the one after it.
                if state.time >= shaken.times[shaken.times.len() - 1] {
                    continue;
                }
                for (name, value, size) in forces(
                    &shaken,
                    place + usize::from(state.time == shaken.times[place]),
                    load,
                    end,
                    state.direction,
                ) {
                    let found = match name {
                        "absolute_acceleration" => state.absolute_acceleration,
                        "acceleration" => state.acceleration,
                        "friction" => state.friction,
                        "load" => state.load,
                        _ => state.transmitted_force,
                    };
                    compared(&of(name), found, value, ByHand, 1e-9 * size);
                }
            }
            let of_library = motion.events.iter().filter(|event| event.direction == 0);
            for (event, [time, place]) in of_library.zip(&found.found.stops) {
                assert!((event.time - time).abs() <= 1e-6 * span, "{event:?} {time} {shaken:?}");
                assert!((event.displacement - place).abs() <= 1e-9 * x, "{event:?} {place} {shaken:?}");
                stops += 1;
            }
        }
    }
    assert!(states > 250 && stops > 100, "{states} {stops}");
}
