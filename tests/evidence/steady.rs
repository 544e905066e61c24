//! The steady motion of machines under every drive, every column of it, beside dense samples.

use crate::compared::{Origin::DenseSamples, recorded};
use crate::machines::Driven;
use crate::random::Random;
use crate::sampled::{Cycle, Extreme, Limit, Load, Of};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use stickslip::Excitation;
use stickslip::internal::{Value, observed};
use stickslip::motion::{LongRun, State, SteadyAnswer, SteadyState};

/// A value that the samples give.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Expected {
    /// A number, and the difference that is allowed.
    Number(f64, f64),
    /// An extreme with its sign: no sample may be beyond the value, and it may be beyond those between samples by
    /// rounding only.
    Most(Extreme, f64, f64),
    /// A phase in [0, 2π).
    Phase(f64, f64),
    Count(u64),
    Flag(bool),
    Text(&'static str),
    /// Two complex numbers by their sum, their product, and the difference that is allowed.
    Pairs([f64; 2], f64),
    Nothing,
    /// A test of its own compares it.
    Elsewhere,
    /// A number of at least 0 and at most this.
    AtMost(f64),
    /// A number or its negative, and the difference that is allowed.
    Either(f64, f64),
}

impl Expected {
    pub(crate) const fn is_elsewhere(&self) -> bool {
        matches!(self, Self::Elsewhere)
    }
}

/// Holds a value of the library beside that of the samples, and records it as this output.
///
/// # Errors
/// A text of both where they differ.
pub(crate) fn hold(
    output: &str,
    value: Value<f64>,
    expected: Expected,
    case: &dyn std::fmt::Debug,
) -> Result<(), String> {
    let number = || match value {
        Value::Number(Some(x)) => x,
        _ => f64::NAN,
    };
    let is_so = match expected {
        Expected::Number(x, room) => (number() - x).abs() <= room,
        Expected::Most(Extreme { sampled, value, .. }, unit, room) => {
            let beyond = if value >= 0.0 { sampled / unit - number() } else { number() - sampled / unit };
            beyond <= 3e-2 * room && (number() - value / unit).abs() <= room
        }
        Expected::Phase(x, room) => {
            let off = (number() - x).rem_euclid(TAU);
            (0.0..TAU).contains(&number()) && off.min(TAU - off) <= room
        }
        Expected::Count(count) => value == Value::Count(Some(count)),
        Expected::Flag(flag) => value == Value::Flag(Some(flag)),
        Expected::Text(text) => value == Value::Text(text),
        Expected::Pairs([sum, product], room) => match value {
            Value::Pairs(Some([(a, b), (c, d)])) => {
                let (s, p) = ([a + c, b + d], [a * c - b * d, a * d + b * c]);
                (s[0] - sum).abs() <= room
                    && (p[0] - product).abs() <= room
                    && s[1].abs() <= room
                    && p[1].abs() <= room
            }
            _ => false,
        },
        Expected::Elsewhere => return Ok(()),
        Expected::Nothing => {
            matches!(value, Value::Number(None) | Value::Count(None) | Value::Flag(None) | Value::Pairs(None))
        }
        Expected::AtMost(most) => (0.0..=most).contains(&number()),
        Expected::Either(x, room) => (number().abs() - x.abs()).abs() <= room,
    };
    if !is_so {
        return Err(format!("{output}: {value:?} of the library, {expected:?} of the samples: {case:?}"));
    }
    let (ours, other, bound): (f64, f64, f64) = match expected {
        Expected::Number(x, room) => (number(), x, room),
        Expected::Most(Extreme { value, .. }, unit, room) => (number(), value / unit, room),
        // The nearer one of the phases that are a turn apart.
        Expected::Phase(x, room) => (number() - TAU * ((number() - x) / TAU).round(), x, room),
        Expected::Either(x, room) => (number().abs(), x.abs(), room),
        Expected::AtMost(most) => (number(), 0.0, most),
        _ => {
            recorded(output, &value, &expected, DenseSamples, 0.0);
            return Ok(());
        }
    };
    recorded(output, &ours, &other, DenseSamples, bound);
    Ok(())
}

/// The units of ratios, by their own definitions.
pub(crate) struct Units {
    pub(crate) length: f64,
    pub(crate) velocity: f64,
    pub(crate) acceleration: f64,
    pub(crate) force: f64,
    pub(crate) work: f64,
}

impl Units {
    pub(crate) fn of(driven: &Driven) -> Self {
        let length = driven.friction / driven.stiffness;
        let velocity = length * driven.frequency;
        let acceleration = velocity * driven.frequency;
        Self { length, velocity, acceleration, force: driven.friction, work: driven.friction * length }
    }
}

fn shifted(extreme: Extreme, by: f64) -> Extreme {
    Extreme { sampled: extreme.sampled - by, value: extreme.value - by, ..extreme }
}

/// The greatest force on the support without the constant force, and the transmissibility.
pub(crate) fn transmitted(driven: &Driven, cycle: &Cycle) -> (Extreme, Extreme) {
    let found = &cycle.found;
    let (most, least) = (found.most(Of::Transmitted), found.least(Of::Transmitted));
    let (most, least) = (shifted(most, driven.mean), shifted(least, driven.mean));
    let (sampled, value) =
        (most.sampled.abs().max(least.sampled.abs()), most.value.abs().max(least.value.abs()));
    let force = Extreme { sampled, value, time: 0.0 };
    let scale = |extreme: Extreme, by: f64| Extreme {
        sampled: extreme.sampled / by,
        value: extreme.value / by,
        ..extreme
    };
    let ratio = if driven.is_foot() {
        // The acceleration of the body over that of the support.
        let of_foot = driven.amplitude * driven.frequency * driven.frequency;
        scale(found.greatest(Of::Acceleration), of_foot)
    } else {
        scale(force, driven.force())
    };
    (force, ratio)
}

/// The greatest force in the spring, without that of the mean displacement.
pub(crate) fn spring(driven: &Driven, cycle: &Cycle) -> Extreme {
    let mean = driven.stiffness * driven.harmonic().mean();
    let (most, least) = (cycle.found.most(Of::Spring), cycle.found.least(Of::Spring));
    let (most, least) = (shifted(most, mean), shifted(least, mean));
    Extreme {
        sampled: most.sampled.abs().max(least.sampled.abs()),
        value: most.value.abs().max(least.value.abs()),
        time: 0.0,
    }
}

/// The equivalent oscillator of the samples: by the works of friction in each direction and of the damper in a turn, and by
/// the force of spring and friction at the ends of the loop.
pub(crate) fn equivalent(name: &str, driven: &Driven, cycle: &Cycle) -> f64 {
    let (found, machine) = (&cycle.found, driven.machine());
    let (most, least) = (found.most(Of::Displacement).value, found.least(Of::Displacement).value);
    let work = (found.friction_work(&machine) + found.damper_work) / f64::from(cycle.turns);
    let amplitude = (most - least) / 2.0;
    let [forward, backward] = machine.friction;
    let (high, low) = (driven.stiffness * most + forward, driven.stiffness * least - backward);
    let stiffness = (high - low) / (most - least);
    let natural = (driven.stiffness / driven.mass).sqrt();
    let damping = work / (std::f64::consts::PI * driven.frequency * amplitude * amplitude);
    match name {
        "equivalent_damping" => damping * driven.frequency / driven.stiffness,
        "equivalent_damping_ratio" => damping / (2.0 * driven.mass * natural),
        "equivalent_stiffness" => stiffness / driven.stiffness,
        _ => work / (TAU * stiffness * amplitude * amplitude),
    }
}

/// The condition of a time: half the range of a quantity over the size of its second derivative would be the square of
/// it. An extreme is known to `room`, and its time to the root of it at worst.
const TIME: f64 = 2e-7;

/// What the samples give for a column of the steady state.
fn expected(
    name: &str,
    driven: &Driven,
    cycle: &Cycle,
    steady: &SteadyState<f64>,
    value: Value<f64>,
) -> Expected {
    let units = Units::of(driven);
    let found = &cycle.found;
    let mean = driven.harmonic().mean();
    let reach = found.most(Of::Displacement).value - found.least(Of::Displacement).value;
    let most = |of: Of, unit: f64, by: f64| {
        let extreme = shifted(found.most(of), by);
        Expected::Most(
            extreme,
            unit,
            1e-9 * extreme.value.abs().max(reach / 2.0 * unit / units.length) / unit,
        )
    };
    let least = |of: Of, unit: f64, by: f64| {
        let extreme = shifted(found.least(of), by);
        Expected::Most(
            extreme,
            unit,
            1e-9 * extreme.value.abs().max(reach / 2.0 * unit / units.length) / unit,
        )
    };
    let greatest =
        |extreme: Extreme, unit: f64| Expected::Most(extreme, unit, 1e-9 * (extreme.value / unit).abs());
    let phase = |extreme: Extreme| Expected::Phase(driven.phase(extreme.time), TIME);
    let works = driven.force() * reach * 2.0;
    let work = |value: f64| Expected::Number(value / units.work, 1e-9 * works / units.work);
    let relative = |value: f64| Expected::Number(value, 1e-9);
    let times = |of: Of| {
        let half = TAU * f64::from(cycle.turns) / 2.0;
        let phases = |extreme: Extreme| extreme.time * driven.frequency;
        // Both instants lie in one cycle that begins with a turn of the seam, whose place is the library's own.
        let apart = (phases(found.most(of)) - phases(found.least(of))).abs();
        let apart = apart.min(2.0 * half - apart);
        (apart - half).abs() / (2.0 * half)
    };
    let asymmetry = |of: Of, by: f64| {
        let (high, low) = (found.most(of).value - by, found.least(of).value - by);
        Expected::Number((high + low).abs() / high, 1e-8 * (high.abs() + low.abs()) / high.abs())
    };
    let (force, ratio) = transmitted(driven, cycle);
    match name {
        "regime" => Expected::Text(if found.rests > 0 { "sticking" } else { "non-sticking" }),
        "limit" => Expected::Text("periodic"),
        "max_displacement" => most(Of::Displacement, units.length, mean),
        "max_displacement_phase" => phase(found.most(Of::Displacement)),
        "min_displacement" => least(Of::Displacement, units.length, mean),
        "min_displacement_phase" => phase(found.least(Of::Displacement)),
        "max_velocity" => most(Of::Velocity, units.velocity, 0.0),
        "max_velocity_phase" => phase(found.most(Of::Velocity)),
        "min_velocity" => least(Of::Velocity, units.velocity, 0.0),
        "min_velocity_phase" => phase(found.least(Of::Velocity)),
        "sticks_per_cycle" => Expected::Count(found.rests),
        "velocity_zeros_per_cycle" => Expected::Count(found.ends),
        "stick_fraction" => relative(found.rest * driven.frequency / (TAU * f64::from(cycle.turns))),
        "error_1" => asymmetry(Of::Displacement, mean),
        // The sign depends on the beginning of the cycle, which the measure leaves open.
        "error_2" => Expected::Either(times(Of::Displacement), TIME),
        "error_3" => asymmetry(Of::Velocity, 0.0),
        "error_4" => Expected::Either(times(Of::Velocity), TIME),
        // A support with the damper works on both, and at rest on the damper, too.
        "energy_in" if driven.harmonic().load == Load::DampedFoot => work(found.foot_work),
        "energy_in" => work(found.load_work),
        "energy_out" => work(driven.friction * (found.path[0] + found.path[1])),
        "damper_work" => work(found.damper_work),
        "multipliers" => Expected::Pairs(cycle.multipliers, 2e-6),
        // The distance of the state found from the limit of the samples, which is known to some 1e-11 of its reach.
        "distance" => {
            let phase = steady.state.phase.reduced() - driven.lead();
            let speed = found.most(Of::Velocity).value / units.velocity;
            let is_near = |[x, v]: &[f64; 2]| {
                ((x - mean) / units.length - steady.state.x).abs()
                    <= steady.distance.0 + 1e-10 * reach / units.length
                    && (v / units.velocity - steady.state.v).abs() <= steady.distance.1 + 1e-9 * speed
            };
            let states = driven.harmonic().states(cycle, phase);
            assert!(
                states.iter().any(is_near),
                "{states:?} {mean} {} {} {:?} {:?} {driven:?}",
                units.length,
                units.velocity,
                steady.state,
                steady.distance
            );
            Expected::AtMost(1e-9 * (1.0 + reach / units.length))
        }
        // Of motions that rest or are irregular.
        "rest_position" | "lyapunov_exponent" | "lyapunov_exponent_error" | "turns_observed" => {
            assert!(matches!(value, Value::Number(None) | Value::Count(None)), "{name}: {value:?}");
            Expected::Elsewhere
        }
        // The work of the search, no quantity of the motion: half a turn at least, or the budget at most.
        "periods" => {
            assert!(matches!(value, Value::Number(Some(periods)) if (0.0..=20_000.0).contains(&periods)));
            Expected::Elsewhere
        }
        "reversals_per_cycle" if found.rests > 0 => Expected::Nothing,
        "reversals_per_cycle" => Expected::Count(found.ends),
        "dynamic_amplification" => {
            let size = (found.most(Of::Displacement).value - mean) * driven.stiffness / driven.force();
            Expected::Number(size, 1e-9 * size.abs())
        }
        "max_acceleration" => greatest(found.greatest(Of::Acceleration), units.acceleration),
        "transmitted_force" => greatest(force, units.force),
        "transmissibility" => greatest(ratio, 1.0),
        "max_absolute_displacement" if driven.is_surface() => {
            let (most, least) = (found.most(Of::AbsoluteDisplacement), found.least(Of::AbsoluteDisplacement));
            let (most, least) = (shifted(most, mean), shifted(least, mean));
            let extreme = if most.value.abs() >= least.value.abs() { most } else { least };
            let size = Extreme { sampled: extreme.sampled.abs(), value: extreme.value.abs(), ..extreme };
            greatest(size, units.length)
        }
        // The surface is fixed, and so is the body's place in space.
        "max_absolute_displacement" if driven.is_foot() => {
            let (most, least) = (found.most(Of::Displacement), found.least(Of::Displacement));
            let (most, least) = (shifted(most, mean), shifted(least, mean));
            let extreme = if most.value.abs() >= least.value.abs() { most } else { least };
            let size = Extreme { sampled: extreme.sampled.abs(), value: extreme.value.abs(), ..extreme };
            greatest(size, units.length)
        }
        "max_absolute_displacement" => Expected::Nothing,
        "max_spring_force" => greatest(spring(driven, cycle), units.force),
        "equivalent_damping"
        | "equivalent_damping_ratio"
        | "equivalent_stiffness"
        | "effective_damping_ratio" => {
            let value = equivalent(name, driven, cycle);
            Expected::Number(value, 1e-9 * value)
        }
        "turns_per_cycle" => Expected::Count(cycle.turns.into()),
        "symmetric" => Expected::Flag(cycle.is_symmetric),
        _ => panic!("no reference of {name} for {steady:?}"),
    }
}

/// The function of the library that a column is from.
fn function(name: &str) -> &'static str {
    match name {
        "error_1" | "error_2" | "error_3" | "error_4" => "motion::SteadyState::errors",
        "max_acceleration" | "transmitted_force" | "max_absolute_displacement" | "max_spring_force" => {
            "motion::SteadyState::peaks"
        }
        "limit" => "motion::LongRun::from_start",
        _ => "motion::LongRun::steady_state",
    }
}

/// Every column of the steady state of machines under every drive: with dampers, static friction, friction by
/// direction and a constant force.
#[test]
fn every_column_of_the_steady_state_is_that_of_the_samples() {
    let mut random = Random(11);
    let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
    let mut failures: BTreeMap<String, (u32, String)> = BTreeMap::new();
    for excitation in Excitation::ALL {
        let mut compared = 0;
        while compared < 40 {
            let driven = Driven::any(&mut random, excitation);
            let harmonic = driven.harmonic();
            // The library's start is at the phase 0 of the force, at the mean displacement.
            let Limit::Periodic(cycle) = harmonic.limit([harmonic.mean(), 0.0], -driven.lead(), 400) else {
                continue;
            };
            let limit = LongRun::from_start(driven.ratios(), State::default()).unwrap();
            let Some(steady) = limit.steady_state() else { panic!("{limit:?} of {driven:?}") };
            compared += 1;
            let answer = SteadyAnswer::new(driven.ratios(), &limit, true).unwrap();
            assert!(!observed(driven.ratios(), &limit).by_border, "{driven:?}");
            let (found, units, mean) = (&cycle.found, Units::of(&driven), harmonic.mean());
            let [high, low] = [found.most(Of::Displacement), found.least(Of::Displacement)]
                .map(|extreme| (extreme.value - mean) / units.length);
            let room = 1e-9 * (high - low);
            let within =
                LongRun::within(driven.ratios(), State::default(), 20_000, &mut || ControlFlow::Continue(()));
            for (function, limit) in [("extrema", &limit), ("within", &within.unwrap())] {
                let (least, most) = limit.extrema().unwrap();
                let of = format!("fn motion::LongRun::{function}");
                crate::compared::compared(&of, most, high, DenseSamples, room);
                crate::compared::compared(&of, least, low, DenseSamples, room);
            }
            for column in SteadyAnswer::<f64>::COLUMNS {
                let name = column.definition.name;
                let value = (column.of)(&answer);
                let expected = expected(name, &driven, &cycle, steady, value);
                let output = format!("steady {name} by {}", function(name));
                if let Err(text) = hold(&output, value, expected, &driven) {
                    let entry = failures.entry(format!("{name} {excitation:?}")).or_insert((0, text));
                    entry.0 += 1;
                }
                *counts.entry(name).or_default() += 1;
            }
        }
    }
    let texts: Vec<_> =
        failures.iter().map(|(name, (count, text))| format!("{name} {count} times: {text}")).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n"));
    assert!(counts.values().all(|&count| count == 40 * 7), "{counts:?}");
}

/// Every amplitude of the steady motion under every drive, of machines with two reversals and with stops, and its unit.
#[test]
fn every_amplitude_is_that_of_the_samples() {
    use stickslip::motion::Amplitude;
    let mut random = Random(15);
    for excitation in Excitation::ALL {
        let mut compared = 0;
        while compared < 12 {
            let driven = Driven::any(&mut random, excitation);
            let harmonic = driven.harmonic();
            let start = [harmonic.mean(), 0.0];
            let Limit::Periodic(cycle) = harmonic.limit(start, -driven.lead(), 400) else { continue };
            // Beside a cycle without stops a start from rest may stop, where static friction is higher.
            if driven.eta > 1.0 && cycle.found.rests > 0 {
                continue;
            }
            compared += 1;
            let found = &cycle.found;
            let mean = harmonic.mean();
            let about =
                |of: Of, by: f64| (found.most(of).value - by).abs().max((found.least(of).value - by).abs());
            let (force, ratio) = transmitted(&driven, &cycle);
            let scales = stickslip::Scales::new(&driven.oscillator(), &driven.drive()).unwrap();
            for (amplitude, expected) in [
                (Amplitude::Displacement, about(Of::Displacement, mean)),
                (Amplitude::Velocity, about(Of::Velocity, 0.0)),
                (Amplitude::Acceleration, about(Of::Acceleration, 0.0)),
                (Amplitude::TransmittedForce, force.value),
                (Amplitude::Transmissibility, ratio.value),
                (Amplitude::AbsoluteDisplacement, about(Of::AbsoluteDisplacement, mean)),
            ] {
                if amplitude == Amplitude::AbsoluteDisplacement && !driven.is_surface() {
                    continue;
                }
                let reached = amplitude.of(driven.ratios(), excitation).unwrap();
                let value = reached.value.unwrap() * amplitude.unit(&scales);
                assert!(
                    (value / expected - 1.0).abs() < 1e-8,
                    "{amplitude:?}: {value} {expected} {driven:?}"
                );
            }
        }
    }
}
