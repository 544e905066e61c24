//! Springs with laws, beside small steps.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::generator::Random;
use crate::named;
use crate::stepper::{Law, Machine};
use std::fmt::Write;

/// A table from 0 up as a file has it, with the force over the stretch: mirrored, or going on straight on both sides.
fn table(random: &mut Random) -> (String, Law, Vec<f64>) {
    let odd = random.below(2) == 0;
    let mut points = vec![(0.0, 0.0)];
    if !odd {
        points.insert(0, (-random.between(0.02, 0.3), -random.between(0.0, 6.0)));
        // Slack: no force over a stretch.
        if random.below(2) == 0 {
            points[0].1 = 0.0;
        }
    }
    for _ in 0..1 + random.below(3) {
        let (x, force) = points[points.len() - 1];
        let slope = if random.below(5) == 0 { 0.0 } else { random.between(15.0, 300.0) };
        let by = random.between(0.03, 0.3);
        points.push((x + by, force + slope * by));
    }
    // The last line holds the body.
    let (x, force) = points[points.len() - 1];
    points.push((x + 1.0, force + random.between(50.0, 300.0)));
    if !odd {
        let (x, force) = points[0];
        points.insert(0, (x - 1.0, force - random.between(30.0, 200.0)));
    }
    let mut text = String::new();
    for (x, force) in &points {
        write!(text, "{}[\"{} mm\", \"{} N\"]", if text.is_empty() { "" } else { ", " }, 1e3 * x, force)
            .unwrap();
    }
    let text = format!("law = [{text}]{}", ["", "\nodd = true"][usize::from(odd && random.below(2) == 0)]);
    let straight = move |points: &[(f64, f64)], x: f64| {
        let last = points.len() - 2;
        let place = (0..last).find(|&i| x < points[i + 1].0).unwrap_or(last);
        let ((a, f), (b, g)) = (points[place], points[place + 1]);
        f + (g - f) * (x - a) / (b - a)
    };
    let mut corners: Vec<f64> = points[1..points.len() - 1].iter().map(|p| p.0).collect();
    if odd {
        corners.extend(corners.clone().iter().map(|c| -c));
    }
    let law: Law = if odd {
        Box::new(move |x: f64| straight(&points, x.abs()) * x.signum())
    } else {
        Box::new(move |x: f64| straight(&points, x))
    };
    (text, law, corners)
}

/// Machines of one or two bodies whose springs are tables, with a contact or without: the same events, and states within 10⁻⁹ of their size.
#[test]
fn tables_are_those_of_small_steps() {
    let mut random = Random(76);
    let (mut events, mut worst) = (0, 0.0_f64);
    for number in 0..crate::count(40, 500) {
        let n = 1 + (random.below(2) as usize);
        let mut file = String::from("units = \"N,m\"\n[masses]\n");
        let (mut machine, mut start, mut velocity) = (
            Machine {
                mass: Vec::new(),
                spring: Vec::new(),
                friction: None,
                belt: 0.0,
                load: [random.between(4.0, 30.0), random.between(2.0, 9.0), random.between(0.0, 6.0), 0.0],
                start: Vec::new(),
                step: 1.0 / 4096.0,
            },
            Vec::new(),
            Vec::new(),
        );
        for i in 0..n {
            let (m, x, v) = (random.between(0.5, 3.0), random.between(-0.1, 0.1), random.between(-0.5, 0.5));
            writeln!(file, "m{i} = {{ mass = {m}, start = {x}, velocity = {v} }}").unwrap();
            machine.mass.push(m);
            start.push(x);
            velocity.push(v);
        }
        for i in 0..n {
            let (text, law, corners) = table(&mut random);
            let damping = random.between(0.2, 1.5);
            let below = if i == 0 { "ground".to_owned() } else { format!("m{}", i - 1) };
            writeln!(
                file,
                "[[springs]]\nname = \"s{i}\"\nbetween = [\"{below}\", \"m{i}\"]\n{text}\ndamping = {damping}"
            )
            .unwrap();
            machine.spring.push((law, corners, damping));
        }
        if random.below(4) > 0 {
            let friction = random.between(0.5, 6.0);
            let last = n - 1;
            writeln!(
                file,
                "[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m{last}\"]\nfriction = {friction}"
            )
            .unwrap();
            if random.below(3) == 0 {
                machine.belt = random.between(0.1, 0.6);
                writeln!(file, "moves = {}", machine.belt).unwrap();
            }
            machine.friction = Some(Box::new(move |_| friction));
        }
        let [amplitude, frequency, phase, _] = machine.load;
        write!(
            file,
            "[[forces]]\non = \"m0\"\namplitude = {amplitude}\nfrequency = {frequency}\nphase = {phase}\n"
        )
        .unwrap();
        machine.start = [start, velocity].concat();
        let (due, seen) = machine.follow(5.0);
        let found = named(&file);
        let motion = found.system.simulate(&found.described.start, 5.0).unwrap();
        let kinds: Vec<_> = motion.events.iter().map(|event| event.kind.name()).collect();
        assert_eq!(kinds, seen.iter().map(|event| event.1).collect::<Vec<_>>(), "{number}:\n{file}");
        for (event, (time, _)) in motion.events.iter().zip(&seen) {
            assert!((event.time - time).abs() < 1e-9 * 5.0, "{number}: {event:?} {time}\n{file}");
        }
        let size =
            |most: &[f64], least: &[f64]| most.iter().chain(least).fold(0.0, |m: f64, x| m.max(x.abs()));
        let sizes = [
            size(&motion.max_displacement, &motion.min_displacement),
            size(&motion.max_velocity, &motion.min_velocity),
        ];
        let state = motion.end.displacement.iter().chain(&motion.end.velocity);
        for (i, (own, due)) in state.zip(&due).enumerate() {
            let by = (own - due).abs() / sizes[usize::from(i >= n)];
            worst = worst.max(by);
            assert!(by < 1e-9, "{number}: state {i} is {own} for {due}\n{file}");
        }
        // What the springs store is their work.
        let works: f64 = motion.elements.iter().map(|e| e.work).sum();
        let left = motion.load_work - motion.damper_work - works - motion.stored;
        let total = motion.load_work.abs() + motion.damper_work + works.abs() + motion.stored.abs();
        assert!(left.abs() <= 1e-11 * total, "{number}: energy by {left:e} of {total:e}\n{file}");
        events += motion.events.len();
    }
    println!("{events} events, states within {worst:.1e} of their size");
    assert!(events > 100);
}

/// A bilinear spring without damping: its steady motion under a load comes back, with the multipliers of a symplectic map.
#[test]
fn a_period_of_a_spring_without_damping_keeps_areas() {
    let text = "units = \"N,m\"\n[masses]\nm = { mass = 1, start = 0.05, velocity = 0.3 }\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nlaw = [[0, 0], [0.1, 10], [0.4, 25]]\ndamping = 0.3\n[[forces]]\non = \"m\"\namplitude = 15\nfrequency = 5\n";
    let found = named(text);
    let steady = found.system.steady(&found.described.start).unwrap();
    assert_eq!(steady.kind.name(), "periodic");
    // The product of the multipliers is e^(−c T/m), however often the slope changes.
    let product: f64 = steady.multipliers.iter().map(|(re, im)| re.hypot(*im)).product();
    let due = (-0.3 * std::f64::consts::TAU / 5.0).exp();
    assert!((product / due - 1.0).abs() < 1e-9, "{product} {due}");
    assert!(steady.motion.max_displacement[0] > 0.11, "{:?}", steady.motion);
    // Small steps from its start come back to it.
    let straight =
        |x: f64| if x.abs() < 0.1 { 100.0 * x } else { x.signum() * (10.0 + 50.0 * (x.abs() - 0.1)) };
    let machine = Machine {
        mass: vec![1.0],
        spring: vec![(Box::new(straight), vec![-0.1, 0.1], 0.3)],
        friction: None,
        belt: 0.0,
        load: [15.0, 5.0, 0.0, 0.0],
        start: [steady.start.displacement.clone(), steady.start.velocity.clone()].concat(),
        step: 1.0 / 4096.0,
    };
    let (end, _) = machine.follow(steady.period);
    for (a, b) in end.iter().zip(&machine.start) {
        assert!((a - b).abs() < 1e-10, "{end:?} {:?}", machine.start);
    }
}

/// The natural frequency is that of the slope at the stretch 0, and steady sliding that of the slope in its equilibrium.
#[test]
fn the_description_takes_the_slope_where_the_spring_is() {
    let text = |belt: &str| {
        format!(
            "units = \"N,m\"\n[masses]\nm = 2\n[[springs]]\nname = \"s\"\nbetween = [\"ground\", \"m\"]\nlaw = [[0, 0], [0.1, 5], [1, 140]]\n[[contacts]]\nname = \"c\"\nbetween = [\"ground\", \"m\"]\nlaw = [[0, 30], [1, 20], [2, 20]]\n{belt}"
        )
    };
    let free = named(&text(""));
    let found = free.system.natural_frequencies(&[]);
    assert!((found[0] - 25.0_f64.sqrt()).abs() < 1e-12, "{found:?}");
    // On the belt the friction of 25 N holds the spring where its slope is 150: λ² + λ (−10)/2 + 75 = 0.
    let sliding = named(&text("moves = 0.5\n")).system.sliding().unwrap();
    assert!((sliding.growth - 2.5).abs() < 1e-9, "{sliding:?}");
    assert!((sliding.frequency - (75.0_f64 - 6.25).sqrt()).abs() < 1e-9, "{sliding:?}");
}

/// Each wrong law is one line with its place and what to write instead.
#[test]
fn wrong_laws_of_springs_are_refused() {
    for (fields, why) in [
        ("law = [[0, 0], [1, 5]]\nstiffness = 3", "springs[1].stiffness 3: must be left out beside a law"),
        ("law = [[0, 0], [1, 5], [1, 9]]", "springs[1].law: displacement 3 is 1, must be > 1 before it"),
        ("law = [[0, 0], [-1, 5]]", "springs[1].law: displacement 2 is -1, must be > 0 before it"),
        ("law = [[0, 0]]", "springs[1].law: must have two points or more"),
        ("law = [[0.1, 0], [1, 5]]", "begins at the displacement 0.1, must begin at 0"),
        (
            "law = [[0, 2], [1, 5]]",
            "has the force 2 at 0, must have 0 where it is mirrored: write odd = false",
        ),
        ("law = [[-1, 2], [1, 5]]\nodd = true", "must begin at the displacement 0 where odd mirrors it"),
        ("law = [[0, 0], [1, 5]]\nodd = 1", "springs[1].odd 1: must be true or false"),
        ("law = [[0, 0], [1, 5, 6]]", "springs[1].law[2]: must be a pair"),
        ("law = [[0, 0], [\"1 N\", 5]]", "springs[1].law[2][1] 1 N"),
        ("law = \"none.csv\"", "none.csv"),
        ("stiffness = 3\nodd = true", "springs[1].odd is unknown"),
    ] {
        let text = format!(
            "units = \"N,m\"\n[masses]\nm = 2\n[[springs]]\nbetween = [\"ground\", \"m\"]\n{fields}\n"
        );
        let value = stickslip_front::system::parsed(&text, "x").unwrap();
        let found = stickslip_front::system::NamedSystem::new(&value, [], std::path::Path::new(""), None)
            .unwrap_err();
        assert!(found.contains(why) && !found.contains('\n'), "{fields}: {found}");
    }
    // As it is, from 0 up and straight below.
    let text = "units = \"N,m\"\n[masses]\nm = 2\n[[springs]]\nbetween = [\"ground\", \"m\"]\nlaw = [[0, 2], [1, 5]]\nodd = false\n";
    assert!(
        format!("{:?}", named(text).described.model.elements[0].kind).contains("[(0.0, 2.0), (1.0, 5.0)]")
    );
}
