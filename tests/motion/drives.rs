//! Forces, displacements and works under every drive, compared with samples of the motion in physical units.
//!
//! The samples are of a simulation of its own: `m x″ = f − k(x − u) − c(x′ − v) − r sgn x′` by Runge–Kutta steps, with the
//! instants of stops and releases bisected. Of the library it takes only a state of the steady motion, and finds that the
//! state returns.

use crate::random::Random;
use std::f64::consts::TAU;
use stickslip::internal::Value;
use stickslip::motion::{Amplitude, LongRun, State, SteadyAnswer, SteadyOutput, SteadyState, Trajectory};
use stickslip::{Drive, Error, Excitation, Oscillator, Output, Ratios, Response, Scales};

/// A machine, and the load by its own formulae.
#[derive(Debug, Clone, Copy)]
struct Machine {
    mass: f64,
    stiffness: f64,
    damping: f64,
    friction: f64,
    held: f64,
    excitation: Excitation,
    frequency: f64,
    amplitude: f64,
    /// A constant force.
    mean: f64,
}

/// What acts at one time: a force on the body, the displacement and the velocity of the spring's support, the velocity of
/// the damper's, and displacement and acceleration of the base under the body.
struct Load {
    force: f64,
    foot: (f64, f64),
    damper: f64,
    base: (f64, f64),
}

impl Machine {
    fn body(&self) -> Oscillator<f64> {
        let body = Oscillator::new(self.mass, self.stiffness, self.friction).unwrap();
        body.with_damping(self.damping).unwrap().with_static_friction(self.held).unwrap()
    }

    fn drive(&self) -> Drive<f64> {
        let drive = Drive::new(self.excitation, self.amplitude, self.frequency).unwrap();
        drive.with_mean_force(self.mean).unwrap()
    }

    /// The amplitude of the motion of the support or the base.
    fn moved(&self) -> f64 {
        match self.excitation {
            Excitation::SurfaceVelocity => self.amplitude / self.frequency,
            Excitation::SurfaceAcceleration => self.amplitude / self.frequency.powi(2),
            _ => self.amplitude,
        }
    }

    /// The load at the phase θ of the force on the body: a damped support lags behind it.
    fn load(&self, theta: f64) -> Load {
        let (w, u) = (self.frequency, self.moved());
        let none = Load { force: 0.0, foot: (0.0, 0.0), damper: 0.0, base: (0.0, 0.0) };
        match self.excitation {
            Excitation::Force => Load { force: self.amplitude * theta.sin(), ..none },
            Excitation::Unbalance => Load { force: self.amplitude * w * w * theta.sin(), ..none },
            Excitation::FootMotion => Load { foot: (u * theta.sin(), u * w * theta.cos()), ..none },
            Excitation::DampedFootMotion => {
                let late = theta - (self.damping * w / self.stiffness).atan();
                let speed = u * w * late.cos();
                Load { foot: (u * late.sin(), speed), damper: speed, ..none }
            }
            // The force of inertia is in phase with the displacement of the base.
            _ => Load { base: (u * theta.sin(), -u * w * w * theta.sin()), ..none },
        }
    }

    /// The force on the body but for friction.
    fn pull(&self, theta: f64, x: f64, v: f64) -> f64 {
        let load = self.load(theta);
        load.force + self.mean
            - self.mass * load.base.1
            - self.stiffness * (x - load.foot.0)
            - self.damping * (v - load.damper)
    }
}

/// What the samples of a cycle say.
#[derive(Debug, Default)]
struct Seen {
    displacement: f64,
    acceleration: f64,
    force: f64,
    absolute: f64,
    damper: f64,
    /// The work of what moves: of the force, the support or the base.
    drive: f64,
    friction: f64,
    end: (f64, f64),
}

const STEPS: u32 = 4000;

impl Seen {
    /// The cycle of `turns` turns from a phase and a state.
    fn of(m: &Machine, turns: u32, phase: f64, start: (f64, f64)) -> Self {
        let mut seen = Self { end: start, ..Self::default() };
        let step = TAU / f64::from(STEPS);
        let (mut theta, until) = (phase, phase + TAU * f64::from(turns));
        let mut side = if start.1 == 0.0 { 0.0 } else { start.1.signum() };
        while theta < until - 1e-12 {
            let (h, from) = (step.min(until - theta), seen.end);
            if side == 0.0 {
                let slips = |part: f64| m.pull(theta + part, from.0, 0.0).abs() > m.held;
                let length = if slips(h) { bisected(h, slips) } else { h };
                seen.add(m, (theta, length), 0.0, [from; 3]);
                theta += length;
                if length < h {
                    // A first step off the place of rest.
                    side = m.pull(theta, from.0, 0.0).signum();
                    let first = [0.0, 5e-7, 1e-6].map(|part| stepped(m, theta, part, from, side));
                    seen.add(m, (theta, 1e-6), side, first);
                    (theta, seen.end) = (theta + 1e-6, first[2]);
                }
                continue;
            }
            let at = |part: f64| stepped(m, theta, part, from, side);
            let turns = |part: f64| at(part).1 * side <= 0.0;
            let length = if turns(h) { bisected(h, turns) } else { h };
            let to = at(length);
            seen.add(m, (theta, length), side, [from, at(length / 2.0), to]);
            (theta, seen.end) = (theta + length, to);
            if length < h {
                seen.end.1 = 0.0;
                let pull = m.pull(theta, to.0, 0.0);
                side = if pull.abs() <= m.held { 0.0 } else { pull.signum() };
            }
        }
        seen
    }

    /// Adds the states at both ends and in the middle of a step, and the works along it by Simpson's rule.
    fn add(&mut self, m: &Machine, (theta, length): (f64, f64), side: f64, states: [(f64, f64); 3]) {
        let mut powers = [[0.0; 3]; 3];
        for (n, ((x, v), powers)) in (0u8..).zip(states.into_iter().zip(&mut powers)) {
            let theta = theta + length * f64::from(n) / 2.0;
            let load = m.load(theta);
            let friction = if side == 0.0 { m.pull(theta, x, 0.0) } else { side * m.friction };
            let acceleration = (m.pull(theta, x, v) - friction) / m.mass;
            // By Newton's second law spring, damper and friction are what the force upon the body leaves.
            let force = m.mass * (acceleration + load.base.1) - load.force - m.mean;
            self.displacement = self.displacement.max(x.abs());
            self.acceleration = self.acceleration.max(acceleration.abs());
            self.force = self.force.max(force.abs());
            self.absolute = self.absolute.max((x + load.base.0).abs());
            let relative = v - load.damper;
            let foot = m.stiffness * (load.foot.0 - x) * load.foot.1 - m.damping * relative * load.damper;
            let drive = (load.force - m.mass * load.base.1) * v + foot;
            *powers = [m.damping * relative * relative, drive, friction * v];
        }
        let [a, b, c] = powers;
        let along = |i: usize| (a[i] + 4.0 * b[i] + c[i]) / 6.0 * length / m.frequency;
        self.damper += along(0);
        self.drive += along(1);
        self.friction += along(2);
    }
}

/// The state a part of a turn later, sliding to this side, by one Runge–Kutta step.
fn stepped(m: &Machine, theta: f64, part: f64, (x, v): (f64, f64), side: f64) -> (f64, f64) {
    let h = part / m.frequency;
    let rate =
        |late: f64, x: f64, v: f64| (v, (m.pull(theta + late * part, x, v) - side * m.friction) / m.mass);
    let (x1, v1) = rate(0.0, x, v);
    let (x2, v2) = rate(0.5, x + h / 2.0 * x1, v + h / 2.0 * v1);
    let (x3, v3) = rate(0.5, x + h / 2.0 * x2, v + h / 2.0 * v2);
    let (x4, v4) = rate(1.0, x + h * x3, v + h * v3);
    (x + h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4), v + h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4))
}

/// Where a step first is beyond.
fn bisected(h: f64, beyond: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, h);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if beyond(middle) { high = middle } else { low = middle }
    }
    high
}

/// A number of an answer by its name.
fn of(answer: &SteadyAnswer<'_, f64>, name: &str) -> Option<f64> {
    let column = SteadyAnswer::COLUMNS.into_iter().find(|column| column.definition.name == name).unwrap();
    let Value::Number(value) = (column.of)(answer) else { panic!("{name}") };
    value
}

/// The physical size of its unit.
fn size_of(name: &str, scales: &Scales<f64>) -> f64 {
    let mut columns = SteadyAnswer::<f64>::COLUMNS.into_iter();
    columns.find(|column| column.definition.name == name).unwrap().definition.measure.size(scales)
}

/// A random machine under a drive, which slides, stops or rests.
fn machine(random: &mut Random, excitation: Excitation) -> Machine {
    let (mass, stiffness, friction) =
        (random.scale(0.5, 200.0), random.scale(10.0, 1e4), random.scale(0.1, 100.0));
    let natural = (stiffness / mass).sqrt();
    let mut m = Machine {
        mass,
        stiffness,
        damping: 2.0 * random.scale(0.01, 1.2) * (stiffness * mass).sqrt(),
        friction,
        held: friction * if random.next() < 0.3 { random.between(1.0, 1.5) } else { 1.0 },
        excitation,
        frequency: natural * random.scale(0.3, 3.0),
        amplitude: 1.0,
        mean: 0.0,
    };
    let unit = m.drive().force_amplitude(&m.body());
    m.amplitude = friction / unit * random.scale(0.7, 12.0);
    m
}

/// A steady motion, and its samples.
fn sampled(m: &Machine, steady: &SteadyState<f64>, scales: &Scales<f64>) -> Seen {
    let State { phase, x, v, .. } = steady.state;
    let start = (x * scales.length, v * scales.velocity);
    let seen = Seen::of(m, steady.turns_per_cycle, phase.reduced(), start);
    let off = ((seen.end.0 - start.0) / scales.length).hypot((seen.end.1 - start.1) / scales.velocity);
    assert!(off < 1e-7 * (1.0 + seen.displacement / scales.length), "{m:?} does not return: {off:e}");
    seen
}

/// The samples come close to the greatest value, and none is above it.
fn is_greatest(found: f64, sampled: f64, scale: f64) -> bool {
    found > sampled - 1e-8 * scale && found < sampled + 2e-5 * scale
}

/// Every way to the force on the support, to the transmissibility and to the absolute displacement, of a thousand
/// machines under every drive: moving without a stop, with stops, and at rest.
#[test]
fn forces_and_displacements_are_those_of_samples_under_every_drive() {
    let mut random = Random(53);
    let mut counts = [0; 3];
    for n in 0..1050 {
        let m = machine(&mut random, Excitation::ALL[n % 7]);
        let (body, drive) = (m.body(), m.drive());
        let (ratios, scales) = (drive.ratios(&body).unwrap(), Scales::new(&body, &drive).unwrap());
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let steady = limit.steady_state();
        let seen = match (&limit, steady) {
            (_, Some(steady)) => sampled(&m, steady, &scales),
            (LongRun::Rest(rest), _) => Seen::of(&m, 1, 0.0, (rest.position * scales.length, 0.0)),
            _ => continue,
        };
        // p₀, and the accelerations of support and base, by their own formulae.
        let p0 = (0..STEPS).map(|i| m.pull(TAU * f64::from(i) / f64::from(STEPS), 0.0, 0.0).abs());
        let p0 = p0.fold(0.0, f64::max);
        let foot = m.moved() * m.frequency.powi(2);
        let is_foot = matches!(m.excitation, Excitation::FootMotion | Excitation::DampedFootMotion);
        let is_base = is_foot || !matches!(m.excitation, Excitation::Force | Excitation::Unbalance);
        let ratio = if is_foot { seen.acceleration / foot } else { seen.force / p0 };
        let size = seen.force.max(p0);
        let close = |what: &str, value: f64, sampled: f64, scale: f64| {
            assert!(is_greatest(value, sampled, scale), "{what} of {m:?}: {value} {sampled}");
        };
        let by = |amplitude: Amplitude| {
            amplitude.of(ratios, m.excitation).unwrap().value.unwrap() * amplitude.unit(&scales)
        };
        close("force", by(Amplitude::TransmittedForce), seen.force, size);
        close("ratio", by(Amplitude::Transmissibility), ratio, ratio + 1e-9);
        let answer = SteadyAnswer::new(ratios, &limit, true).unwrap();
        let of_answer = |name: &str| of(&answer, name).map(|value| value * size_of(name, &scales));
        close("force", of_answer("transmitted_force").unwrap(), seen.force, size);
        close("ratio", of_answer("transmissibility").unwrap(), ratio, ratio + 1e-9);
        let absolute = of_answer("max_absolute_displacement");
        assert_eq!(absolute.is_some(), is_base, "{m:?}");
        if let Some(absolute) = absolute {
            close("absolute displacement", absolute, seen.absolute, seen.absolute.max(m.moved()) + 1e-300);
        }
        let response = Response::new(ratios);
        let unit = |output: Output| output.of(&response).map(|value| value * output.unit(&scales));
        match (steady, response.cycle) {
            (Some(_), Some(_)) => {
                close("force", unit(Output::TransmittedForce).unwrap(), seen.force, size);
                close("ratio", unit(Output::Transmissibility).unwrap(), ratio, ratio);
                assert_eq!(unit(Output::MaxAbsoluteDisplacement).is_some(), is_base);
                let [force, ratio] =
                    Output::values([Output::TransmittedForce, Output::Transmissibility], ratios);
                assert_eq!(
                    (Some(force), Some(ratio)),
                    (Output::TransmittedForce.of(&response), Output::Transmissibility.of(&response))
                );
                counts[0] += 1;
            }
            (Some(_), None) => counts[1] += 1,
            (None, _) => counts[2] += 1,
        }
    }
    assert!(counts[0] > 250 && counts[1] > 250 && counts[2] > 60, "{counts:?}");
}

/// The works of what moves, of friction and of the damper, whose other end may move: `∮ c (x′ − u′)² dt`.
#[test]
fn works_are_those_of_samples_under_every_drive() {
    let mut random = Random(10);
    let mut counts = [0; 3];
    for n in 0..420 {
        let m = machine(&mut random, Excitation::ALL[n % 7]);
        let (body, drive) = (m.body(), m.drive());
        let (ratios, scales) = (drive.ratios(&body).unwrap(), Scales::new(&body, &drive).unwrap());
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let answer = SteadyAnswer::new(ratios, &limit, false).unwrap();
        let work = |name: &str| of(&answer, name).unwrap() * size_of(name, &scales);
        let seen = match (&limit, limit.steady_state()) {
            (_, Some(steady)) => sampled(&m, steady, &scales),
            (LongRun::Rest(rest), _) => Seen::of(&m, 1, 0.0, (rest.position * scales.length, 0.0)),
            _ => continue,
        };
        let close = |what: &str, value: f64, sampled: f64| {
            let scale = seen.drive.abs() + seen.damper + seen.friction + scales.force * scales.length;
            assert!((value - sampled).abs() <= 1e-6 * scale, "{what} of {m:?}: {value} {sampled}");
        };
        close("damper", work("damper_work"), seen.damper);
        close("drive", work("energy_in"), seen.drive);
        close("friction", work("energy_out"), seen.friction);
        match (limit.steady_state(), Response::new(ratios).cycle) {
            (Some(steady), cycle) => {
                let unit = scales.force * scales.length;
                close("damper", SteadyOutput::DamperWork.of(steady) * unit, seen.damper);
                if let Some(cycle) = cycle {
                    close("damper of the cycle", cycle.damper_work() * unit, seen.damper);
                }
                counts[usize::from(cycle.is_none())] += 1;
            }
            (None, _) => counts[2] += 1,
        }
    }
    assert!(counts[0] > 90 && counts[1] > 90 && counts[2] > 25, "{counts:?}");
}

/// A mean force shifts the motion and the force on the support, and the answers are about the mean.
#[test]
fn answers_are_about_the_mean() {
    let mut random = Random(6);
    let mut moving = 0;
    for _ in 0..60 {
        let mut m = machine(&mut random, Excitation::Force);
        m.held = m.friction;
        m.mean = m.friction * random.between(-20.0, 20.0);
        let (body, drive) = (m.body(), m.drive());
        let (ratios, scales) = (drive.ratios(&body).unwrap(), Scales::new(&body, &drive).unwrap());
        let Some(steady) = LongRun::from_start(ratios, State::default()).unwrap().steady_state().copied()
        else {
            continue;
        };
        let State { phase, x, v, .. } = steady.state;
        let start = (scales.mean_displacement + x * scales.length, v * scales.velocity);
        let seen = Seen::of(&m, 1, phase.reduced(), start);
        let size = seen.force + seen.displacement * m.stiffness;
        let force =
            Amplitude::TransmittedForce.of(ratios, m.excitation).unwrap().value.unwrap() * scales.force;
        assert!(is_greatest(force + m.mean.abs(), seen.force, size), "{m:?}: {force} {}", seen.force);
        let far = steady.max_displacement.value * scales.length + scales.mean_displacement.abs();
        assert!(is_greatest(far, seen.displacement, seen.displacement), "{m:?}: {far} {}", seen.displacement);
        moving += 1;
    }
    assert!(moving > 40, "{moving}");
}

/// The greatest displacement of a motion that is not symmetric lies on either side; its amplification is of the maximum.
#[test]
fn the_amplification_is_that_of_the_maximum_displacement() {
    let ratios = Ratios::new(0.597, 3.315).unwrap().with_static_friction_ratio(2.293).unwrap();
    let limit = LongRun::from_start(ratios, State::default()).unwrap();
    let steady = limit.steady_state().unwrap();
    assert!(!steady.is_symmetric && steady.min_displacement.value < -steady.max_displacement.value);
    // The motion sampled in time, of a machine of unit stiffness, mass and friction.
    let motion = Trajectory::new(ratios, steady.state).unwrap();
    let count = 4000 * steady.turns_per_cycle as usize;
    let most =
        motion.samples(4000).unwrap().take(count).map(|at| at.unwrap().state.x).fold(f64::MIN, f64::max);
    let answer = SteadyAnswer::new(ratios, &limit, false).unwrap();
    let found = of(&answer, "dynamic_amplification").unwrap();
    assert!(
        (found - most / 3.315).abs() < 1e-5 && (found - 1.450_796).abs() < 1e-6,
        "{found} {}",
        most / 3.315
    );
}

/// The machine of a report: a support of 12 mm at 6 rad/s carries 26.846 N, 1.2429 times what its acceleration would.
#[test]
fn the_support_of_a_moving_foot_carries_the_mass_times_the_acceleration() -> Result<(), Error> {
    let body = Oscillator::new(50.0, 1000.0, 5.0)?;
    let drive = Drive::new(Excitation::FootMotion, 0.012, 6.0)?;
    let (response, scales) = (Response::new(drive.ratios(&body)?), Scales::new(&body, &drive)?);
    let of = |output: Output| output.of(&response).map_or(f64::NAN, |value| value * output.unit(&scales));
    let due = [of(Output::TransmittedForce), of(Output::Transmissibility)];
    assert!((due[0] - 26.846).abs() < 1e-3 && (due[1] - 1.2429).abs() < 1e-4, "{due:?}");
    Ok(())
}

/// Derivatives, boxes and draws have the forces of the same excitation.
#[cfg(all(feature = "dual", feature = "random", feature = "serde", feature = "mp"))]
#[test]
fn every_way_to_an_output_knows_the_excitation() {
    use stickslip::Regime;
    use stickslip::sensitivity::Sensitivities;
    use stickslip::uncertainty::{Interval, MonteCarlo, ParameterBox, Parameters};
    let outputs = [Output::TransmittedForce, Output::Transmissibility, Output::MaxAbsoluteDisplacement];
    let mut random = Random(4);
    let mut moving = 0;
    for n in 0..140 {
        let mut m = machine(&mut random, Excitation::ALL[n % 7]);
        (m.held, m.damping) = (m.friction, if n % 2 == 0 { 0.0 } else { m.damping });
        let (body, drive) = (m.body(), m.drive());
        let (ratios, scales) = (drive.ratios(&body).unwrap(), Scales::new(&body, &drive).unwrap());
        let response = Response::new(ratios);
        if response.cycle.is_none() {
            continue;
        }
        moving += 1;
        let derived = Sensitivities::by_parameters(&body, &drive).unwrap();
        let written = serde_json::to_value(response).unwrap();
        let boxed = ParameterBox::Machine(Parameters {
            excitation: m.excitation,
            mass: Interval::exactly(m.mass),
            stiffness: Interval::exactly(m.stiffness),
            friction_bound: Interval::exactly(m.friction),
            amplitude: Interval::exactly(m.amplitude),
            angular_frequency: Interval::exactly(m.frequency),
            damping: Interval::exactly(m.damping),
        });
        let draw = Parameters {
            excitation: m.excitation,
            mass: m.mass,
            stiffness: m.stiffness,
            friction_bound: m.friction,
            amplitude: m.amplitude,
            angular_frequency: m.frequency,
            damping: m.damping,
        };
        let drawn = MonteCarlo::new(|_| draw, &outputs, 1, 1).unwrap();
        assert_eq!(drawn.count(Regime::NonSticking), 1);
        for output in outputs {
            let due = output.of(&response);
            assert_eq!(written[output.name()].as_f64(), due, "{output} of {m:?}");
            let due = due.map(|value| value * output.unit(&scales));
            let same = |found: Option<f64>, what: &str| {
                let close = found.zip(due).is_some_and(|(a, b)| (a / b - 1.0).abs() < 1e-9);
                assert!(
                    close || found.is_none() && due.is_none(),
                    "{what} of {output}, {m:?}: {found:?} {due:?}"
                );
            };
            same(derived.of(output).map(|found| found.value), "derivative");
            same(boxed.range(output, 1).unwrap().map(|range| range.low), "box");
            let enclosed = boxed.enclosed(output, 1).unwrap();
            same(enclosed.map(|range| f64::midpoint(range.low, range.high)), "enclosure");
            same(drawn.values(output).first().copied(), "draw");
        }
    }
    assert!(moving > 40, "{moving}");
}
