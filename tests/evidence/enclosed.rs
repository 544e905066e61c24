//! Guaranteed digits beside motions at 40 digits by another program, tests/data/enclosed.py: every ball contains its
//! reference.

use crate::compared::Origin::{self, AnotherProgram};
use crate::compared::recorded;
use serde_json::Value;
use stickslip::enclosed::{self, Enclosure, Known};
use stickslip::float::Mp;
use stickslip::motion::record::{Body, Entry, Record};
use stickslip::{Error, Excitation, Field, Output};

const REFERENCES: &str = include_str!("../data/enclosed.json");

fn cases(kind: &str) -> Vec<Value> {
    let all: Value = serde_json::from_str(REFERENCES).unwrap();
    all[kind].as_array().unwrap().clone()
}

/// A number of the file, which is a binary fraction.
fn number<const N: usize>(value: &Value) -> Mp<N> {
    Mp::from(value.as_f64().unwrap())
}

/// Holds a ball against 40 digits of another program: it contains them, or misses them by their own rounding only.
fn hold(of: &str, name: &str, ball: &Enclosure, digits: &Value, case: &Value) {
    hold_against(AnotherProgram, of, name, ball, digits, case);
}

fn hold_against(origin: Origin, of: &str, name: &str, ball: &Enclosure, digits: &Value, case: &Value) {
    let reference: Mp<4> = digits.as_str().unwrap().parse().unwrap();
    let middle = Mp::<4>::from(&ball.mid);
    let rad = Mp::<4>::from(&ball.rad);
    let room = rad + (reference.abs() + Mp::from(1e-3)) * Mp::from(1e-38);
    let off = (reference - middle).abs();
    assert!(off <= room, "{name}: {ball} and {digits} of {case}");
    assert!(rad <= (reference.abs() + Mp::from(1e-3)) * Mp::from(1e-12), "{name}: ± {rad} of {case}");
    let function = match of {
        "record" => "follow",
        "steady" => "KnownRatios::steady",
        _ => "KnownRatios::response, enclosed::Response::get",
    };
    recorded(&format!("--enclose {of} by enclosed::{function}"), &ball.to_string(), digits, origin, 0.0);
}

#[test]
fn records_contain_their_references() {
    let (mut answers, mut unproved) = (0, 0);
    let all = cases("records");
    for case in &all {
        let of = |name: &str| number::<17>(&case[name]);
        let excitation = match case["kind"].as_str().unwrap() {
            "force" => Excitation::Force,
            "surface" => Excitation::SurfaceAcceleration,
            "foot" => Excitation::FootMotion,
            _ => Excitation::DampedFootMotion,
        };
        let body = Body::new(of("mass"), of("friction"))
            .and_then(|body| body.with_stiffness(of("stiffness")))
            .and_then(|body| body.with_damping(of("damping")))
            .and_then(|body| body.with_static_friction_ratio(of("static_friction_ratio")))
            .unwrap();
        let samples = case["samples"].as_array().unwrap().iter().map(number).collect();
        let record = Record::new(excitation, of("time_step"), samples).unwrap();
        let [x, v] = [0, 1].map(|i| number(&case["start"][i]));
        let found = match enclosed::follow(&body, &record, x, v, 64) {
            Ok(found) => found,
            Err(Error::UncertainEvent { .. }) => {
                unproved += 1;
                continue;
            }
            Err(e) => panic!("{e} of {case}"),
        };
        for (name, _, entry) in found.entries() {
            let reference = &case["answer"][name];
            match entry {
                Entry::Count(count) => assert_eq!(reference.as_u64(), Some(count), "{name} of {case}"),
                Entry::Value(Some(ball)) => hold("record", name, ball, reference, case),
                Entry::Value(None) => assert!(reference.is_null(), "{name} of {case}"),
            }
            answers += 1;
        }
    }
    // A start exactly on a bound, or an extreme that is reached twice, is undecided.
    assert!(unproved * 10 < all.len() && answers > 4000, "{unproved} {answers}");
}

/// A slide of a critically damped body, in closed form: `x = L + (A + Bt)e^{−βt}`.
struct Critical {
    limit: Mp<17>,
    a: Mp<17>,
    b: Mp<17>,
    beta: Mp<17>,
}

impl Critical {
    fn new([x, v, limit, beta]: [Mp<17>; 4]) -> Self {
        let a = x - limit;
        Self { limit, a, b: v + beta * a, beta }
    }

    fn at(&self, t: Mp<17>) -> [Mp<17>; 2] {
        let (decay, line) = (stickslip::Float::exp(-(self.beta * t)), self.a + self.b * t);
        [self.limit + line * decay, (self.b - self.beta * line) * decay]
    }
}

/// A critically damped body under a constant force and after it, with and without friction: it never stops while the force
/// lasts; after it friction stops it once, where the velocity `(v − βBt)e^{−βt}` is zero, and the spring may draw it back
/// towards the edge of its places of rest.
#[test]
fn critically_damped_bodies_contain_closed_forms() {
    let mut back = 0;
    for ([m, k, c], r, p, span) in [
        ([2.0, 50.0, 20.0], 3.0, 8.0, 0.25),
        ([2.0, 50.0, 20.0], 3.0, 20.0, 0.5),
        ([1.0, 4.0, 4.0], 0.0, 3.0, 7.0),
        ([0.5, 8.0, 4.0], 0.25, 6.0, 2.0),
        ([0.5, 8.0, 4.0], 0.25, 0.5, 0.125),
    ] {
        let number = |x: f64| Mp::<17>::from(x);
        let body = Body::new(number(m), number(r)).unwrap();
        let body = body.with_stiffness(number(k)).unwrap().with_damping(number(c)).unwrap();
        let record = Record::new(Excitation::Force, number(span), vec![number(p); 2]).unwrap();
        let found = enclosed::follow(&body, &record, Mp::ZERO, Mp::ZERO, 64).unwrap();
        let [stiffness, friction, force, time] = [k, r, p, span].map(number);
        let beta = number(c / (2.0 * m));
        let first = Critical::new([Mp::ZERO, Mp::ZERO, (force - friction) / stiffness, beta]);
        let [x, v] = first.at(time);
        let second = Critical::new([x, v, -friction / stiffness, beta]);
        let stop = v / (beta * second.b);
        // Without friction, too: the velocity has a zero where B > 0.
        let [most, _] = second.at(stop);
        let returns = stiffness * most > friction;
        back += u32::from(returns);
        let rest = if returns { friction / stiffness } else { most };
        let case = Value::String(format!("{m} {k} {c} {r} {p} {span}"));
        let text = |x: Mp<17>| Value::String(x.to_string());
        for (name, due) in [
            ("end_displacement", x),
            ("end_velocity", v),
            ("max_displacement", most),
            ("residual_displacement", rest),
            ("path", most + (most - rest)),
        ] {
            let entry = found.entries().into_iter().find(|(other, ..)| *other == name).unwrap().2;
            let Entry::Value(Some(ball)) = entry else { panic!("{name} of {case}") };
            hold_against(Origin::ByHand, "record", name, ball, &text(due), &case);
        }
    }
    assert_eq!(back, 3);
}

/// Damping ratios on both sides of 1: intervals of them hold the samples of those in them.
#[test]
fn intervals_about_critical_damping_hold_the_samples() {
    use crate::compared::{Origin::DenseSamples, agreed};
    use crate::sampled::{Harmonic, Limit, Load, Machine, Of};
    let text = |x: &str| x.parse::<Known>().unwrap();
    for (omega, alpha, is_free, off) in
        [("0.7", "9", true, 5e-3), ("1.5", "6", true, 5e-3), ("0.7", "2", false, 1e-4)]
    {
        let [low, high] = [1.0 - off, 1.0 + off].map(|zeta| text(&zeta.to_string()));
        let zeta = Known::between(&low, &high).unwrap();
        let of =
            enclosed::KnownRatios::new(&text(omega)).with_force_ratio(&text(alpha)).with_damping_ratio(&zeta);
        let [displacement, velocity] = if is_free {
            let found = of.response(64).unwrap();
            [Output::MaxDisplacement, Output::MaxVelocity].map(|output| found.get(output).unwrap().clone())
        } else {
            let found = of.steady(64).unwrap().unwrap();
            [found.max_displacement, found.max_velocity]
        };
        let mut seen = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for zeta in [-1.0, -0.4, 0.0, 0.2, 1.0].map(|part| 1.0 + part * off) {
            let (omega, alpha) = (omega.parse::<f64>().unwrap(), alpha.parse().unwrap());
            let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, 1.0], 0.0);
            let harmonic = Harmonic { machine, load: Load::Force, amplitude: alpha, frequency: omega };
            let Limit::Periodic(cycle) = harmonic.limit([0.0, 0.0], 0.0, 2000) else { panic!("{zeta}") };
            let found =
                [cycle.found.most(Of::Displacement).value, cycle.found.most(Of::Velocity).value / omega];
            for (seen, value) in seen.iter_mut().zip(found) {
                *seen = [seen[0].min(value), seen[1].max(value)];
            }
        }
        for (ball, [least, most]) in [displacement, velocity].into_iter().zip(seen) {
            let (middle, reach) = (ball.mid.to_f64(), ball.rad.to_f64());
            let of = if is_free { "response" } else { "steady" };
            let holds = middle - reach <= least + 1e-9 && most - 1e-9 <= middle + reach;
            agreed(&format!("--enclose {of}"), holds, true, DenseSamples);
            // A wider one would not even know the sign.
            assert!(reach < middle, "{omega} {alpha}: {reach} for {least} to {most}");
        }
    }
}

fn known(value: &Value) -> Known {
    Known::exactly(number::<2>(value)).unwrap()
}

#[test]
fn steady_states_contain_their_references() {
    let (mut proved, mut sticking) = (0, 0);
    for case in cases("steady") {
        let [omega, alpha, zeta] = ["omega", "alpha", "damping_ratio"].map(|name| known(&case[name]));
        let answer = &case["answer"];
        let Ok(steady) = enclosed::KnownRatios::new(&omega)
            .with_force_ratio(&alpha)
            .with_damping_ratio(&zeta)
            .steady(64)
            .unwrap()
        else {
            continue;
        };
        proved += 1;
        sticking += u32::from(steady.sticks_per_cycle > 0);
        hold("steady", "max_displacement", &steady.max_displacement, &answer["max_displacement"], &case);
        hold("steady", "max_velocity", &steady.max_velocity, &answer["max_velocity"], &case);
        hold("steady", "stick_fraction", &steady.stick_fraction, &answer["stick_fraction"], &case);
        for (ball, name) in
            [(&steady.min_displacement, "max_displacement"), (&steady.min_velocity, "max_velocity")]
        {
            let mut mirror = ball.clone();
            mirror.mid = -mirror.mid;
            hold("steady", name, &mirror, &answer[name], &case);
        }
        assert_eq!(answer["sticks_per_cycle"].as_u64(), Some(steady.sticks_per_cycle.into()), "{case}");
        let zeros = steady.velocity_zeros_per_cycle;
        assert_eq!(answer["velocity_zeros_per_cycle"].as_u64(), Some(zeros.into()), "{case}");
    }
    assert!(proved > 30 && sticking > 8, "{proved} {sticking}");
}

#[test]
fn responses_contain_their_references() {
    let mut compared = 0;
    for case in cases("steady") {
        let [omega, alpha, zeta] = ["omega", "alpha", "damping_ratio"].map(|name| known(&case[name]));
        let answer = &case["answer"];
        let is_free = answer["sticks_per_cycle"] == 0 && answer["velocity_zeros_per_cycle"] == 2;
        let found = enclosed::KnownRatios::new(&omega)
            .with_force_ratio(&alpha)
            .with_damping_ratio(&zeta)
            .response(64)
            .unwrap();
        assert_eq!(found.get(Output::MaxDisplacement).is_some(), is_free, "{case}");
        // The border is above the force ratio where the motion stops, and below it elsewhere.
        let border = &found.get(Output::MinForceRatio).unwrap().mid;
        assert_eq!(*border <= case["alpha"].as_f64().unwrap(), is_free, "{case}");
        if !is_free {
            continue;
        }
        compared += 1;
        for (output, name) in [
            (Output::MaxDisplacement, "max_displacement"),
            (Output::MaxVelocity, "max_velocity"),
            (Output::MaxAcceleration, "max_acceleration"),
            (Output::TransmittedForce, "transmitted_force"),
        ] {
            hold(
                "response",
                name,
                found.get(output).unwrap_or_else(|| panic!("{name} of {case}")),
                &answer[name],
                &case,
            );
        }
        let digits = |name: &str| answer[name].as_str().unwrap().parse::<Mp<4>>().unwrap();
        let (alpha, omega) = (number::<4>(&case["alpha"]), number::<4>(&case["omega"]));
        for (output, value) in [
            (Output::LoopSizeStiffness, digits("energy") * Mp::from(2.0) / (alpha * alpha)),
            (Output::LoopSizeInertia, digits("energy") * Mp::from(2.0) * omega * omega / (alpha * alpha)),
            (Output::DynamicAmplification, digits("max_displacement") / alpha),
            (Output::Transmissibility, digits("transmitted_force") / alpha),
        ] {
            let name = output.definition().name;
            let text = Value::String(value.to_string());
            hold(
                "response",
                name,
                found.get(output).unwrap_or_else(|| panic!("{name} of {case}")),
                &text,
                &case,
            );
        }
    }
    assert!(compared > 10, "{compared}");
}
