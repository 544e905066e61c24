//! Random bodies under random records, beside another computation of the motion and dense samples of it.

mod series;

use crate::generator::Random;
use series::Other;
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record, RecordAnswer};

/// A body and a record, in plain numbers.
#[derive(Debug, Clone)]
struct Machine {
    mass: f64,
    stiffness: f64,
    damping: f64,
    forward: f64,
    backward: f64,
    eta: f64,
    mean: f64,
    is_one_way: bool,
    excitation: Excitation,
    step: f64,
    samples: Vec<f64>,
    start: [f64; 2],
}

impl Machine {
    fn random(random: &mut Random) -> Self {
        let mass = random.between(0.5, 12.0);
        let step = random.between(0.005, 0.2);
        let omega = if random.next() < 0.2 { 0.0 } else { 10f64.powf(random.between(-2.0, 0.6)) / step };
        let zeta = match (random.next() * 6.0) as i32 {
            0 => 0.0,
            1 => random.between(1.0, 4.0),
            2 => random.between(0.3, 0.95),
            _ => random.between(0.01, 0.3),
        };
        let rate = if omega > 0.0 { 2.0 * zeta * omega } else { zeta / step };
        let level = random.between(0.5, 8.0);
        let friction = if random.next() < 0.15 { 0.0 } else { level * random.between(0.02, 0.9) };
        let is_directional = random.next() < 0.15;
        let backward = if is_directional { friction * random.between(0.3, 1.5) } else { friction };
        let eta = if random.next() < 0.3 { random.between(1.0, 1.5) } else { 1.0 };
        let mean = if random.next() < 0.25 { level * random.between(-0.5, 0.5) } else { 0.0 };
        let count = 2 + (random.next() * 30.0) as usize;
        let mut samples: Vec<f64> = Vec::new();
        for _ in 0..count {
            let last = samples.last().copied().unwrap_or(0.0);
            let draw = random.next();
            samples.push(if draw < 0.05 {
                0.0
            } else if draw < 0.15 {
                last
            } else {
                random.between(-level, level)
            });
        }
        let excitation = if omega > 0.0 {
            random.one_of(&[
                Excitation::Force,
                Excitation::SurfaceAcceleration,
                Excitation::FootMotion,
                Excitation::DampedFootMotion,
            ])
        } else {
            random.one_of(&[Excitation::Force, Excitation::SurfaceAcceleration])
        };
        let size = match excitation {
            Excitation::Force => mass,
            Excitation::SurfaceAcceleration => -1.0,
            _ => 1.0 / (omega * omega),
        };
        let start = if random.next() < 0.3 {
            [random.between(-4.0, 4.0) * level * step * step, random.between(-2.0, 2.0) * level * step]
        } else {
            [0.0; 2]
        };
        let is_one_way = start[1] >= 0.0 && random.next() < 0.08;
        Self {
            mass,
            stiffness: mass * omega * omega,
            damping: mass * rate,
            forward: mass * friction,
            backward: mass * backward,
            eta,
            mean: mass * mean,
            is_one_way,
            excitation,
            step,
            samples: samples.iter().map(|sample| sample * size).collect(),
            start,
        }
    }

    fn follow(&self) -> Result<RecordAnswer<f64>, stickslip::Error> {
        let mut body = Body::new(self.mass, self.forward)?
            .with_stiffness(self.stiffness)?
            .with_damping(self.damping)?
            .with_static_friction_ratio(self.eta)?
            .with_mean_force(self.mean)?;
        if self.forward != self.backward {
            body = body.with_directional_friction(self.forward, self.backward)?;
        }
        if self.is_one_way {
            body = body.one_way();
        }
        let record = Record::new(self.excitation, self.step, self.samples.clone())?;
        body.follow_from(&record, self.start[0], self.start[1])
    }

    /// The machine with every direction turned.
    fn mirrored(&self) -> Self {
        Self {
            forward: self.backward,
            backward: self.forward,
            mean: -self.mean,
            samples: self.samples.iter().map(|sample| -sample).collect(),
            start: self.start.map(|x| -x),
            ..self.clone()
        }
    }

    /// The machine in other units: the numbers of a length, a time and a mass of 1.
    fn in_units(&self, length: f64, time: f64, mass: f64) -> Self {
        let force = mass * length / (time * time);
        let sample = match self.excitation {
            Excitation::Force => force,
            Excitation::SurfaceAcceleration => length / (time * time),
            _ => length,
        };
        Self {
            mass: self.mass * mass,
            stiffness: self.stiffness * mass / (time * time),
            damping: self.damping * mass / time,
            forward: self.forward * force,
            backward: self.backward * force,
            mean: self.mean * force,
            step: self.step * time,
            samples: self.samples.iter().map(|x| x * sample).collect(),
            start: [self.start[0] * length, self.start[1] * length / time],
            ..self.clone()
        }
    }
}

fn machines() -> impl Iterator<Item = Machine> {
    let mut random = Random(2_026);
    let count = std::env::var("PROPTEST_CASES").map_or(150, |count| count.parse().unwrap());
    (0..count).map(move |_| Machine::random(&mut random))
}

#[test]
fn every_answer_is_that_of_dense_samples() {
    let (mut held, mut close, mut left) = (0, 0, 0);
    for (index, machine) in machines().enumerate() {
        let found = machine.follow().unwrap_or_else(|error| panic!("{index}: {error} of {machine:?}"));
        let other = Other::new(&machine).follow();
        if other.gave_up {
            left += 1;
            continue;
        }
        if other.margin < 1e-9 {
            // A decision within rounding: it may be the other one.
            close += 1;
            continue;
        }
        held += 1;
        let counts = |answer: &RecordAnswer<f64>| (answer.slides, answer.stops, answer.reversals);
        assert_eq!(
            counts(&found),
            (other.slides, other.stops, other.reversals),
            "{index} {machine:?} {found:?} {other:?}"
        );
        assert_eq!(found.cut_time.is_some(), other.cut.is_some(), "{index} {machine:?}");
        let length = other.displacement[0].abs().max(other.displacement[1].abs()).max(other.path);
        let speed = other.velocity[0].abs().max(other.velocity[1].abs());
        let work = other.works.iter().fold(0.0f64, |most, work| most.max(work.abs()));
        let work = work + 0.5 * machine.mass * speed * speed + machine.stiffness * length * length;
        let time = machine.step * machine.samples.len() as f64;
        // The absolute acceleration and the force are differences from the load.
        let load = machine.samples.iter().fold(0.0f64, |most, sample| most.max(sample.abs()));
        let load = match machine.excitation {
            Excitation::SurfaceAcceleration => load,
            Excitation::Force => load / machine.mass,
            _ => load * machine.stiffness / machine.mass,
        };
        let acceleration = other.acceleration.max(load);
        let force = other.force.max(machine.mass * acceleration);
        for (name, value, expected, size) in [
            ("max_displacement", found.max_displacement, other.displacement[0], length),
            ("min_displacement", found.min_displacement, other.displacement[1], length),
            ("max_velocity", found.max_velocity, other.velocity[0], speed),
            ("min_velocity", found.min_velocity, other.velocity[1], speed),
            ("max_absolute_acceleration", found.max_absolute_acceleration, other.acceleration, acceleration),
            ("max_transmitted_force", found.max_transmitted_force, other.force, force),
            ("end_displacement", found.end_displacement, other.end[0], length),
            ("end_velocity", found.end_velocity, other.end[1], speed),
            ("residual", found.residual_displacement.unwrap_or(0.0), other.residual.unwrap_or(0.0), length),
            ("path", found.path, other.path, length),
            ("stick_time", found.stick_time, other.stick_time, time),
            ("friction_work", found.friction_work, other.works[0], work),
            ("damper_work", found.damper_work, other.works[1], work),
            ("load_work", found.load_work, other.works[2], work),
        ] {
            let error = (value - expected).abs();
            assert!(
                error <= 1e-9 * size,
                "{index} {name}: {value} against {expected} of {machine:?} {found:?}"
            );
        }
    }
    assert!(held * 10 > 8 * (held + close + left), "{held} held, {close} close, {left} left");
}

#[test]
fn a_mirrored_record_has_the_mirrored_answer_to_the_last_bit() {
    for (index, machine) in machines().enumerate().filter(|(_, machine)| !machine.is_one_way) {
        let (one, two) = (machine.follow().unwrap(), machine.mirrored().follow().unwrap());
        let mut turned = one;
        turned.max_displacement = -one.min_displacement;
        turned.max_displacement_time = one.min_displacement_time;
        turned.min_displacement = -one.max_displacement;
        turned.min_displacement_time = one.max_displacement_time;
        turned.max_velocity = -one.min_velocity;
        turned.max_velocity_time = one.min_velocity_time;
        turned.min_velocity = -one.max_velocity;
        turned.min_velocity_time = one.max_velocity_time;
        turned.end_displacement = -one.end_displacement;
        turned.end_velocity = -one.end_velocity;
        turned.residual_displacement = one.residual_displacement.map(|x| -x);
        assert_eq!(turned, two, "{index} {machine:?}");
    }
}

#[test]
fn counts_are_the_same_in_all_units() {
    let units = [
        (1000.0, 1.0, 1.0),
        (1000.0, 1.0, 0.001),
        (1000.0, 1000.0, 1.0),
        (39.370_078_740_157_48, 1.0, 0.005_710_147_154_733),
    ];
    for (index, machine) in machines().enumerate() {
        let found = machine.follow().unwrap();
        for (length, time, mass) in units {
            let other = machine.in_units(length, time, mass).follow().unwrap();
            let counts = |answer: &RecordAnswer<f64>| (answer.slides, answer.stops, answer.reversals);
            assert_eq!(counts(&found), counts(&other), "{index} {length} {time} {mass} {machine:?}");
            let most = machine.step * machine.samples.len() as f64;
            let off = (other.stick_time / time - found.stick_time).abs();
            assert!(off < 1e-9 * most, "{index} {length} {time} {mass}: {off} of {machine:?}");
        }
    }
}
