//! Laws that are curves, beside small steps on the curve itself: the same events, and no digit too many.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::generator::Random;
use crate::named;
use crate::stepper::{Law, Machine};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use stickslip_front::system::{Answer, NamedSystem, parsed};

/// The unit of the last digit of a number as it is printed.
fn last(x: f64) -> f64 {
    let text = format!("{x:e}");
    let (digits, power) = text.split_once('e').unwrap();
    let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
    10.0_f64.powi(power.parse::<i32>().unwrap() - i32::try_from(decimals).unwrap())
}

/// A friction law as a file has it, and its curve.
fn friction(random: &mut Random) -> (String, Law) {
    let (kinetic, more) = (random.between(1.0, 6.0), random.between(0.0, 4.0));
    let (speed, viscous) = (random.between(0.1, 0.8), random.between(0.0, 1.5));
    match random.below(5) {
        0 | 1 => {
            let text = format!("{{ kinetic = {kinetic}, static = {}, speed = {speed} }}", kinetic + more);
            // The exponent of a law that gives none is 2.
            (text, Box::new(move |v: f64| kinetic + more * (-(v / speed).powi(2)).exp()))
        }
        2 => {
            let exponent = random.one_of(&[1.0, 1.5, 2.0, 3.0]);
            let text = format!(
                "{{ static = {}, kinetic = {kinetic}, speed = {speed}, exponent = {exponent}, viscous = {viscous} }}",
                kinetic + more
            );
            (
                text,
                Box::new(move |v: f64| {
                    kinetic + more * (-(v.abs() / speed).powf(exponent)).exp() + viscous * v
                }),
            )
        }
        3 => {
            let text = format!("{{ formula = \"{kinetic} + {viscous}*v + {more}*exp(-v/{speed})\" }}");
            (text, Box::new(move |v: f64| kinetic + viscous * v + more * (-v / speed).exp()))
        }
        _ => {
            let text = format!("{{ formula = \"{kinetic} + {more}/(1 + (v/{speed})^2)\" }}");
            (text, Box::new(move |v: f64| kinetic + more / (1.0 + (v / speed).powi(2))))
        }
    }
}

/// A spring as a file has it, and its curve.
fn spring(random: &mut Random) -> (String, Law) {
    let k = random.between(20.0, 150.0);
    match random.below(5) {
        0 => {
            let cubic = random.between(100.0, 3000.0);
            (
                format!("law = {{ formula = \"{k}*x + {cubic}*x^3\" }}"),
                Box::new(move |x: f64| k * x + cubic * x.powi(3)),
            )
        }
        1 => (format!("law = {{ formula = \"{k}*sin(x)\" }}"), Box::new(move |x: f64| k * x.sin())),
        2 => {
            let text = format!("law = {{ formula = \"{k}*x*sqrt(1 + x)\" }}\nodd = true");
            (text, Box::new(move |x: f64| k * x * (1.0 + x.abs()).sqrt()))
        }
        _ => (format!("stiffness = {k}"), Box::new(move |x: f64| k * x)),
    }
}

/// A random machine of one or two bodies, as a file and for small steps.
fn machine(random: &mut Random) -> (String, Machine) {
    let n = 1 + random.below(2) as usize;
    let mut file = String::from("units = \"N,m\"\n[masses]\n");
    let (mut mass, mut start, mut velocity, mut springs) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        let (m, x, v) = (random.between(0.5, 2.5), random.between(-0.1, 0.1), random.between(-0.3, 0.3));
        let v = if random.below(2) == 0 { 0.0 } else { v };
        writeln!(file, "m{i} = {{ mass = {m}, start = {x}, velocity = {v} }}").unwrap();
        mass.push(m);
        start.push(x);
        velocity.push(v);
    }
    for i in 0..n {
        let (text, law) = spring(random);
        let damping = random.between(0.1, 2.0);
        let below = if i == 0 { "ground".to_owned() } else { format!("m{}", i - 1) };
        writeln!(
            file,
            "[[springs]]\nname = \"s{i}\"\nbetween = [\"{below}\", \"m{i}\"]\n{text}\ndamping = {damping}"
        )
        .unwrap();
        springs.push((law, Vec::new(), damping));
    }
    let (text, law) = friction(random);
    writeln!(file, "[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m{}\"]\nlaw = {text}", n - 1)
        .unwrap();
    let belt = if random.below(3) == 0 { random.between(0.1, 0.6) } else { 0.0 };
    if belt > 0.0 {
        writeln!(file, "moves = {belt}").unwrap();
    }
    let load = [random.between(5.0, 30.0), random.between(2.0, 9.0), random.between(0.0, 6.0), 0.0];
    let [amplitude, frequency, phase, _] = load;
    write!(
        file,
        "[[forces]]\non = \"m0\"\namplitude = {amplitude}\nfrequency = {frequency}\nphase = {phase}\n"
    )
    .unwrap();
    let start = [start, velocity].concat();
    (file, Machine { mass, spring: springs, friction: Some(law), belt, load, start, step: 1.0 / 4096.0 })
}

#[test]
fn digits_are_those_of_small_steps_on_the_curve() {
    let mut random = Random(760);
    let (mut numbers, mut closest, mut known, mut differ) = (0_u32, 0.0_f64, 0.0, 0);
    for number in 0..crate::count(36, 500) {
        let (file, machine) = machine(&mut random);
        let until = 4.0;
        let (due, seen) = machine.follow(until);
        let found = named(&file);
        let (motion, digits) = found.simulate(&found.described.start, until).unwrap();
        let digits = digits.unwrap();
        let mut check = |what: &str, own: f64, due: f64| {
            let part = ((own - due).abs() - 1e-9).max(0.0) / last(own);
            closest = closest.max(part);
            // To a unit of the last digit that is printed.
            assert!(part <= 1.0, "{number}: {what} is {own} for {due}\n{file}");
            known += (due.abs() / last(own)).max(1.0).log10();
            numbers += 1;
        };
        let state = motion.end.displacement.iter().chain(&motion.end.velocity);
        for (i, (own, due)) in state.zip(&due).enumerate() {
            check(&format!("state {i}"), *own, *due);
        }
        if !digits.events_agree {
            differ += 1;
            continue;
        }
        let kinds: Vec<_> = motion.events.iter().map(|event| event.kind.name()).collect();
        assert_eq!(kinds, seen.iter().map(|event| event.1).collect::<Vec<_>>(), "{number}:\n{file}");
        for (event, (time, _)) in motion.events.iter().zip(&seen) {
            check(event.kind.name(), event.time, *time);
        }
        let works: f64 = motion.elements.iter().map(|e| e.work).sum();
        let left = motion.load_work - motion.damper_work - works - motion.stored;
        let total = motion.load_work.abs() + motion.damper_work + works.abs();
        let all = [motion.load_work, motion.damper_work, motion.stored]
            .into_iter()
            .chain(motion.elements.iter().map(|e| e.work));
        let units: f64 = all.map(last).sum();
        assert!(left.abs() <= units + 1e-9 * total, "{number}: energy by {left:e} of {total:e}\n{file}");
    }
    let mean = known / f64::from(numbers);
    println!(
        "{numbers} numbers, {closest:.3} of a unit at most, {mean:.2} digits in the mean, events differ in {differ}"
    );
    // Three digits at the default, of all numbers, some of which are small beside their kind.
    assert!(mean > 3.0 && differ <= 2, "{mean} {differ}");
}

/// A law that rises: the bound of displacements and velocities holds the motion of small steps on the curve, at its end and on the way, and says four digits.
#[test]
fn the_bound_under_a_law_that_rises_is_kept() {
    let mut random = Random(764);
    let (mut closest, mut widest, mut seen) = (0.0_f64, 0.0_f64, 0);
    for number in 0..crate::count(12, 100) {
        let (rest, more, speed) =
            (random.between(1.0, 4.0), random.between(0.5, 3.0), random.between(0.1, 0.8));
        let [m, k, c] = [random.between(0.5, 2.5), random.between(20.0, 90.0), random.between(0.1, 1.0)];
        let load = [random.between(6.0, 20.0), random.between(2.0, 9.0), random.between(0.0, 6.0), 0.0];
        let [amplitude, frequency, phase, _] = load;
        // A law that falls less than the damper takes is as good as one that rises.
        let viscous = if number % 3 == 0 { -0.9 * c } else { random.between(0.0, 0.5) };
        let start = random.between(-0.1, 0.1);
        let file = format!(
            "units = \"N,m\"\n[masses]\nm = {{ mass = {m}, start = {start} }}\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nstiffness = {k}\ndamping = {c}\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = {{ formula = \"max({rest} + {viscous}*v + {more}*tanh(v/{speed})^2, 0)\" }}\n[[forces]]\non = \"m\"\namplitude = {amplitude}\nfrequency = {frequency}\nphase = {phase}\n"
        );
        let found = named(&file);
        for until in [1.0, 2.5, 4.0] {
            let machine = Machine {
                mass: vec![m],
                spring: vec![(Box::new(move |x: f64| k * x), Vec::new(), c)],
                friction: Some(Box::new(move |v: f64| {
                    (rest + viscous * v + more * (v / speed).tanh().powi(2)).max(0.0)
                })),
                belt: 0.0,
                load,
                start: vec![start, 0.0],
                step: 1.0 / 4096.0,
            };
            let (due, _) = machine.follow(until);
            let (motion, digits) = found.simulate(&found.described.start, until).unwrap();
            let digits = digits.unwrap();
            assert!(digits.tables[0].proved, "{file}");
            let bound = digits.bound.unwrap_or_else(|| panic!("{number}: {file}"));
            for (own, due, bound) in [
                (motion.end.displacement[0], due[0], bound.displacement[0]),
                (motion.end.velocity[0], due[1], bound.velocity[0]),
            ] {
                // The small steps are within 10⁻⁹.
                assert!((own - due).abs() <= bound + 1e-9, "{number}: {own} {due} {bound}\n{file}");
                closest = closest.max((own - due).abs() / bound);
            }
            widest = widest.max(bound.velocity[0] / motion.max_velocity[0].max(-motion.min_velocity[0]));
            seen += 1;
        }
    }
    println!(
        "{seen} motions, {closest:.4} of the bound at most, which is {widest:.1e} of the velocity at most"
    );
    assert!(widest < 1e-2, "{widest}");
    // A law that falls faster has no bound that says anything, and a formula with a corner is measured where it has none.
    let falling = "units = \"N,m\"\n[masses]\nm = 1\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = { formula = \"5 + v + 10*exp(-2*v)\" }\n[[forces]]\non = \"m\"\namplitude = 25\nfrequency = 1.5707963267948966\n";
    let found = named(falling);
    let digits = found.simulate(&found.described.start, 5.0).unwrap().1.unwrap();
    assert!(digits.bound.is_none() && digits.tables[0].proved);
}

/// A steady motion under a law that rises, or falls by less than the damper takes: the bound holds the motion that small steps on the curve come to.
#[test]
fn the_bound_of_a_steady_motion_is_kept() {
    let mut random = Random(765);
    let (mut closest, mut widest, mut told, mut stops) = (0.0_f64, 0.0_f64, 0, 0);
    for number in 0..crate::count(8, 80) {
        let (rest, more, speed) =
            (random.between(0.5, 3.0), random.between(0.5, 3.0), random.between(0.1, 0.8));
        let [m, k, c] = [random.between(0.5, 2.5), random.between(20.0, 90.0), random.between(0.5, 2.0)];
        // The greatest fall of the second law is at 0.
        let falls = number % 2 == 0;
        let fall = 0.8 * c * speed;
        let friction = if falls { rest + fall } else { rest };
        let load =
            [friction * random.between(1.6, 5.0), random.between(3.0, 9.0), random.between(0.0, 6.0), 0.0];
        let [amplitude, frequency, phase, _] = load;
        let curve = move |v: f64| {
            if falls { rest + fall * (-v / speed).exp() } else { rest + more * (v / speed).tanh().powi(2) }
        };
        let formula = if falls {
            format!("{rest} + {fall}*exp(-v/{speed})")
        } else {
            format!("{rest} + {more}*tanh(v/{speed})^2")
        };
        let file = format!(
            "units = \"N,m\"\n[masses]\nm = {m}\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nstiffness = {k}\ndamping = {c}\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = {{ formula = \"{formula}\" }}\n[[forces]]\non = \"m\"\namplitude = {amplitude}\nfrequency = {frequency}\nphase = {phase}\n"
        );
        let found = named(&file);
        let (steady, digits) = found.steady(&found.described.start).unwrap();
        let digits = digits.unwrap();
        if steady.kind.name() != "periodic" {
            continue;
        }
        let Some(bound) = digits.steady_bound else {
            panic!("{number}: {digits:?}\n{file}");
        };
        assert!(digits.bound.is_none() && digits.tables[0].proved);
        let machine = |start: Vec<f64>| Machine {
            mass: vec![m],
            spring: vec![(Box::new(move |x: f64| k * x), Vec::new(), c)],
            friction: Some(Box::new(curve)),
            belt: 0.0,
            load,
            start,
            step: 1.0 / 512.0,
        };
        let (period, of_loads) = (steady.period, std::f64::consts::TAU / frequency);
        assert!((period / of_loads - 1.0).abs() < 1e-12, "{number}\n{file}");
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // A machine with little damping takes more periods.
        let mut settled = vec![0.0, 0.0];
        let (mut again, mut events) = machine(settled.clone()).follow(of_loads);
        for _ in 0..12 {
            settled = machine(settled).follow(300.0 * of_loads).0;
            (again, events) = machine(settled.clone()).follow(of_loads);
            if apart(&settled, &again) < 1e-9 {
                break;
            }
        }
        let apart = apart(&settled, &again);
        assert!(apart < 1e-9, "{number}: {apart:e}\n{file}");
        // The velocity is zero at the extremes.
        let turns = events.iter().filter(|event| event.1 != "slip");
        let places: Vec<f64> = turns.map(|event| machine(settled.clone()).follow(event.0).0[0]).collect();
        let [low, high] = [
            places.iter().copied().fold(f64::MAX, f64::min),
            places.iter().copied().fold(f64::MIN, f64::max),
        ];
        let own = (steady.motion.max_displacement[0] - steady.motion.min_displacement[0]) / 2.0;
        let off = (own - (high - low) / 2.0).abs();
        assert!(off <= bound.half_range[0] + 1e-9, "{number}: {off:e} {bound:?}\n{file}");
        let times: Vec<f64> = (1..=24).map(|i| of_loads * f64::from(i) / 24.0).collect();
        let states = found.states(&steady.start, &times).unwrap();
        let square: f64 = states
            .iter()
            .zip(&times)
            .map(|(state, &time)| {
                let due = machine(settled.clone()).follow(time).0[1];
                // States are rounded to their digits.
                ((state.velocity[0] - due).abs() - last(state.velocity[0]) / 2.0).max(0.0).powi(2)
            })
            .sum();
        let mean = (square / 24.0).sqrt();
        assert!(mean <= bound.velocity_rms[0] + 1e-9, "{number}: {mean:e} {bound:?}\n{file}");
        closest = closest.max(off / bound.half_range[0]).max(mean / bound.velocity_rms[0]);
        widest = widest.max(bound.half_range[0] / own);
        stops += events.iter().filter(|event| event.1 == "stick").count();
        told += 1;
    }
    println!(
        "{told} steady motions, {stops} stops, {closest:.4} of the bound at most, {widest:.1e} of the range at most"
    );
    assert!(told * 2 > crate::count(8, 80) && stops > 0 && widest < 1e-2, "{told} {stops} {widest}");
    // A law that falls by more than the damper takes has none.
    let text = "units = \"N,m\"\n[masses]\nm = 1\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nstiffness = 40\ndamping = 0.5\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = { kinetic = 2, static = 3, speed = 0.4 }\n[[forces]]\non = \"m\"\namplitude = 12\nfrequency = 4\n";
    let found = named(text);
    assert!(found.steady(&found.described.start).unwrap().1.unwrap().steady_bound.is_none());
}

/// Modelica's example `Friction`: 1.768518 m.
#[test]
fn the_end_of_modelicas_example() {
    let text = "units = \"N,m\"\n[masses]\nm = 1\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = { formula = \"5 + v + 10*exp(-2*v)\", tolerance = 1e-5 }\n[[forces]]\non = \"m\"\namplitude = 25\nfrequency = 1.5707963267948966\n";
    let found = named(text);
    let (motion, digits) = found.simulate(&found.described.start, 5.0).unwrap();
    // To half of the last digit that is printed.
    assert!((motion.end.displacement[0] - 1.768_517_81).abs() <= 5e-7, "{motion:?}");
    assert!(last(motion.end.displacement[0]) <= 1e-6);
    let digits = digits.unwrap();
    assert!(
        digits.events_agree && digits.tables[0].within < 1e-5 && digits.tables[0].pieces > 500,
        "{digits:?}"
    );
    // The force of the file, or of --law-tolerance.
    let mut value = parsed(text, "x").unwrap();
    NamedSystem::set_tolerance(&mut value, "10 mN").unwrap();
    let coarse = NamedSystem::new(&value, [], Path::new(""), None).unwrap();
    let (_, digits) = coarse.simulate(&coarse.described.start, 5.0).unwrap();
    assert!(digits.unwrap().tables[0].pieces < 100);
    let mut straight = json!({"masses": {"m": 1}});
    assert!(NamedSystem::set_tolerance(&mut straight, "1 N").unwrap_err().contains("no law"));
}

/// NLvib's chain of cubic springs beside harmonic balance with 31 harmonics (`tests/data/cubic_chain.py`).
#[test]
fn a_chain_of_cubic_springs_is_that_of_harmonic_balance() {
    let cases: Value = serde_json::from_str(include_str!("../../../tests/data/cubic_chain.json")).unwrap();
    for case in cases.as_array().unwrap().iter().step_by(3) {
        let value = json!({
            "mass": [[1, 0], [0, 0.05]], "damping": [[0.015, -0.013], [-0.013, 0.013]],
            "stiffness": [[1.0453, -0.0453], [-0.0453, 0.0453]],
            "elements": [
                {"type": "spring", "direction": [1, 0], "law": {"formula": "x^3"}},
                {"type": "spring", "direction": [1, -1], "law": {"formula": "0.0042*x^3"}},
            ],
            "harmonics": [{"frequency": case["frequency"], "cos": [0.11, 0]}],
        });
        let found = NamedSystem::new(&value, [], Path::new(""), None).unwrap();
        let (steady, digits) = found.steady(&found.described.start).unwrap();
        assert_eq!(steady.kind.name(), "periodic");
        let answer =
            serde_json::to_value(Answer::steady(&found.described, &steady).with_digits(digits.as_ref()))
                .unwrap();
        assert_eq!(answer["laws"]["digits"], "estimated");
        for name in ["max_displacement", "max_velocity"] {
            for (own, due) in answer[name].as_array().unwrap().iter().zip(case[name].as_array().unwrap()) {
                let (own, due) = (own.as_f64().unwrap(), due.as_f64().unwrap());
                assert!((own - due).abs() <= last(own) && last(own) <= 5e-3 * due, "{name}: {own} {due}");
            }
        }
    }
}

/// A body on a belt with a falling law: its own motion, at which small steps from its state on the curve come back.
#[test]
fn a_self_excited_motion_has_the_period_of_small_steps() {
    let text = "units = \"N,m\"\n[masses]\nm = 1\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nstiffness = 40\ndamping = 0.1\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = { kinetic = 4, static = 6, speed = 0.3 }\nmoves = 0.2\n";
    let found = named(text);
    let (steady, digits) = found.steady(&found.described.start).unwrap();
    let events: Vec<_> = steady.motion.events.iter().map(|e| e.kind.name()).collect();
    assert!(
        digits.unwrap().events_agree && events.len() == 2 && steady.kind.name() == "periodic",
        "{steady:?}"
    );
    let law = |v: f64| 4.0 + 2.0 * (-(v / 0.3).powi(2)).exp();
    let machine = Machine {
        mass: vec![1.0],
        spring: vec![(Box::new(|x: f64| 40.0 * x), Vec::new(), 0.1)],
        friction: Some(Box::new(law)),
        belt: 0.2,
        load: [0.0, 1.0, 0.0, 0.0],
        start: vec![0.0, 0.0],
        step: 1.0 / 4096.0,
    };
    let (_, seen) = machine.follow(30.0);
    let slips: Vec<f64> = seen.iter().filter(|e| e.1 == "slip").map(|e| e.0).collect();
    let due = slips[slips.len() - 1] - slips[slips.len() - 2];
    assert!((steady.period - due).abs() <= last(steady.period), "{} {due}", steady.period);
    assert!(last(steady.period) <= 1e-3);
    // The growth of steady sliding by the slope of the curve: λ² + λ (c + F′(V)) + k = 0.
    let slope = -2.0 * 2.0 * 0.2 / 0.09 * (-(0.2_f64 / 0.3).powi(2)).exp();
    let sliding = found.system.sliding().unwrap();
    assert!((sliding.growth + (0.1 + slope) / 2.0).abs() < 1e-6, "{sliding:?} {slope}");
}

#[test]
fn wrong_curves_are_refused_in_one_line() {
    let refused = |fields: &str, of_spring: bool| {
        let (list, other) = if of_spring { ("springs", "") } else { ("contacts", "name = \"c\"\n") };
        let text = format!(
            "units = \"N,m\"\n[masses]\nm = 2\n[[{list}]]\n{other}between = [\"ground\", \"m\"]\n{fields}\n"
        );
        NamedSystem::new(&parsed(&text, "x").unwrap(), [], Path::new(""), None).map(drop)
    };
    for (fields, why) in [
        (
            "law = { formula = \"5 - 10*v\" }",
            "contacts[1].law: is -0.0390625 at v = 0.50390625, must be ≥ 0 as far as the motion may go",
        ),
        ("law = { formula = \"5 + w\" }", "contacts[1].law.formula 5 + w: w is unknown. Did you mean v?"),
        ("law = { formula = \"5 + foo(v)\" }", "foo is unknown. "),
        ("law = { formula = \"1 + sqrt(v - 0.5)\" }", "is NaN at v = 0, must be finite"),
        ("law = { formula = \"1 + sign(v - 0.3)\" }", "contacts[1].law: must not jump"),
        (
            "law = { formula = \"5\", kinetic = 3 }",
            "contacts[1].law.kinetic 3: must be left out beside formula",
        ),
        ("law = { formula = 5 }", "contacts[1].law.formula 5: must be a text"),
        ("law = { kinetic = 3, static = 4, speed = 0 }", "contacts[1].law.speed 0: must be > 0"),
        ("law = { kinetic = 3, static = 4, speed = -1 }", "contacts[1].law.speed -1: must be > 0"),
        ("law = { kinetic = -3, static = 4, speed = 1 }", "contacts[1].law.kinetic -3: must be ≥ 0"),
        ("law = { kinetic = 3, static = 4 }", "contacts[1].law.speed is missing"),
        ("law = { kinetic = 3, speed = 4 }", "contacts[1].law.static is missing"),
        (
            "law = { kinetic = 3, static = 4, speed = 1, exponent = 0 }",
            "contacts[1].law.exponent 0: must be > 0",
        ),
        (
            "law = { kinetic = 3, static = 4, speed = 1, viscous = -1 }",
            "contacts[1].law.viscous -1: must be ≥ 0",
        ),
        ("law = { kinetic = 3, static = 4, speed = 1, stribek = 1 }", "contacts[1].law.stribek is unknown"),
        (
            "law = { kinetic = 3, static = 4, speed = 1, tolerance = 0 }",
            "contacts[1].law.tolerance 0: must be > 0",
        ),
        (
            "law = { kinetic = 3, static = 4, speed = 1, tolerance = 1e-12 }",
            "allow more by tolerance or --law-tolerance",
        ),
        (
            "law = { kinetic = 3, static = 4, speed = 1 }\npeak = 1.2",
            "contacts[1].peak 1.2: must be left out beside a curve",
        ),
        ("law = { kinetic = 3, static = 4, speed = 1 }\nstiffness = 9", "without a law"),
        (
            "law = { kinetic = 3, static = 4, speed = 1 }\nfriction = 9",
            "one of friction, coefficient with normal_load, and law",
        ),
    ] {
        let found = refused(fields, false).unwrap_err();
        assert!(found.contains(why) && !found.contains('\n'), "{fields}: {found}");
    }
    for (fields, why) in [
        ("law = { formula = \"sqrt(x)\" }", "is NaN at x = -1, must be finite"),
        ("law = { formula = \"1 + x\" }\nodd = true", "must be 0 where odd mirrors it"),
        ("law = { formula = \"3*v\" }", "v is unknown. "),
        ("law = { tolerance = 3 }", "springs[1].law.formula is missing"),
        (
            "law = { formula = \"3*x\" }\nstiffness = 3",
            "springs[1].stiffness 3: must be left out beside a law",
        ),
    ] {
        let found = refused(fields, true).unwrap_err();
        assert!(found.contains(why) && !found.contains('\n'), "{fields}: {found}");
    }
    // A law that the motion alone leads to where it is none.
    let text = "units = \"N,m\"\n[masses]\nm = { mass = 1, velocity = 0.1 }\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = { formula = \"2 - v\" }\n[[forces]]\non = \"m\"\nconstant = 9\n";
    let found = named(text);
    let why = found.simulate(&found.described.start, 3.0).unwrap_err().to_string();
    assert!(why.contains("contacts[1].law: is -") && why.contains("write max(…, 0)"), "{why}");
}

/// A law that grows without measure beyond the motion has tables that end where the motion does: the law cut off there by hand has the
/// same answer.
#[test]
fn a_steep_law_is_as_fine_as_where_the_motion_goes() {
    let machine = |formula: &str| {
        format!(
            "units = \"N,m\"\nmasses = {{ b = \"1 kg\" }}\n[[springs]]\nbetween = [\"ground\", \"b\"]\nstiffness = 100\n[[forces]]\n\
             on = \"b\"\namplitude = 10\nfrequency = 5\n[[contacts]]\nbetween = [\"ground\", \"b\"]\nlaw = {{ formula = \"{formula}\" }}\n"
        )
    };
    for (steep, cut) in [
        ("exp(v^9)", "exp(min(v, 1.2)^9)"),
        ("exp(v^4)", "exp(min(v, 1.2)^4)"),
        ("1 + v^30", "1 + min(v, 1.2)^30"),
    ] {
        let least = |formula: &str| {
            let system = named(&machine(formula));
            let (motion, digits) = system.simulate(&system.described.start, 2.0).unwrap();
            (motion.min_velocity[0], digits.unwrap())
        };
        let ((found, digits), (due, _)) = (least(steep), least(cut));
        assert!((found / due - 1.0).abs() < 2e-3, "{steep}: {found} {due}");
        assert!(digits.error < 0.01 && digits.tables[0].within < 0.01, "{steep}: {digits:?}");
    }
}
