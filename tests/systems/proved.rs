//! Motions in balls: published values, other derivations and the motion at more bits lie inside.

#![allow(clippy::print_stdout, reason = "the counts of a campaign are shown with --nocapture")]

use crate::cases::{cases, start, text};
use crate::compared::Origin::AnotherProgram;
use crate::compared::recorded;
use crate::generator::Random;
use crate::precise::{model, state};
use std::collections::BTreeMap;
use stickslip::Float as _;
use stickslip::dependencies::rug::Float;
use stickslip::enclosed::Enclosure;
use stickslip::float::{Mp, Widest, with_bits};
use stickslip::system::{
    Element, Error, EventKind, Harmonic, Kind, Law, Model, Motion, Normal, Signal, State, System,
};

type Wide = Mp<8>;

/// Whether a motion at 512 bits lies in an enclosure: the reason, where it does not.
fn outside(found: &Motion<Enclosure>, wide: &Motion<Wide>) -> Option<String> {
    let own: Vec<_> = found.events.iter().map(|e| (e.element, e.kind)).collect();
    let due: Vec<_> = wide.events.iter().map(|e| (e.element, e.kind)).collect();
    if own != due {
        return Some(format!("events {own:?} {due:?}"));
    }
    let lists: [(&str, &[Enclosure], &[Wide]); 7] = [
        ("displacement", &found.end.displacement, &wide.end.displacement),
        ("velocity", &found.end.velocity, &wide.end.velocity),
        ("force", &found.end.force, &wide.end.force),
        ("max displacement", &found.max_displacement, &wide.max_displacement),
        ("min displacement", &found.min_displacement, &wide.min_displacement),
        ("max velocity", &found.max_velocity, &wide.max_velocity),
        ("min velocity", &found.min_velocity, &wide.min_velocity),
    ];
    let mut all: Vec<(String, Enclosure, Wide)> = Vec::new();
    for (name, a, b) in lists {
        assert_eq!(a.len(), b.len(), "{name}");
        all.extend(a.iter().zip(b).enumerate().map(|(i, (x, y))| (format!("{name} {i}"), x.clone(), *y)));
    }
    for (i, (a, b)) in found.events.iter().zip(&wide.events).enumerate() {
        all.push((format!("event {i}"), a.time.clone(), b.time));
    }
    for (i, (a, b)) in found.elements.iter().zip(&wide.elements).enumerate() {
        all.push((format!("time at rest {i}"), a.time_at_rest.clone(), b.time_at_rest));
        all.push((format!("work {i}"), a.work.clone(), b.work));
        if a.stops != b.stops {
            return Some(format!("stops {} {}", a.stops, b.stops));
        }
    }
    all.push(("load work".into(), found.load_work.clone(), wide.load_work));
    all.push(("damper work".into(), found.damper_work.clone(), wide.damper_work));
    all.push(("stored".into(), found.stored.clone(), wide.stored));
    // The motion at 512 bits has its own rounding, and enclosures of what is exactly 0 have no width.
    let is_outside = |(_, x, y): &&(String, Enclosure, Wide)| {
        let distance = Float::from(*y) - &x.mid;
        distance.abs() > x.rad.clone() + 1e-120
    };
    all.iter().find(is_outside).map(|(name, x, y)| format!("{name}: {x} {y}"))
}

/// The transient cases of the file, whose values have 25 digits by another program.
#[test]
fn published_cases_lie_inside() {
    let mut count = 0;
    for case in cases().into_iter().filter(|case| case.run["kind"] == "transient") {
        // Two have a record, and a table of one is in doubles.
        if case.model.records.is_empty() {
            let until: Wide = text(&case.run["until"]).parse().expect("a number");
            let (system, begin) = (system(&case.model), state::<Wide>(&start(&case)));
            let found = system.enclosed(&begin, until, 80).expect(&case.name);
            let wide = system.simulate(&begin, until).expect("a motion");
            assert_eq!(outside(&found, &wide), None, "{}", case.name);
            if case.name == "modelica-friction-table" {
                continue;
            }
            for (name, found) in
                [("displacement", &found.end.displacement), ("velocity", &found.end.velocity)]
            {
                for (x, due) in found.iter().zip(case.answer[name].as_array().expect("a list")) {
                    let due = text(due).parse::<Wide>().expect("digits");
                    let distance = (Float::from(due) - &x.mid).abs();
                    // What is left out behind the last digit of 25.
                    assert!(
                        distance < x.rad.clone() + 1e-24 && x.rad < 1e-23,
                        "{}: {name} {x} {due}",
                        case.name
                    );
                    recorded("fn system::System::enclosed", x, &due, AnotherProgram, 1e-24);
                }
            }
            count += 1;
        }
    }
    assert_eq!(count, 3);
}

fn system(given: &Model<f64>) -> System<Wide> {
    System::new(&model::<Wide>(given)).expect("valid")
}

/// A start of which one velocity is known to 122 bits, in a system that is known to 4,000: the motions from both ends of this line lie inside what is
/// found, and fill 9/10 of it. So events move the set as they move each of its motions.
#[test]
fn the_ends_of_a_line_fill_what_is_found() {
    use EventKind::{Close, Lock, Open, Reverse, Slip, Stick, Yield};
    let contact = |points: &[(f64, f64)], peak| Kind::Contact {
        law: Law { points: points.to_vec() },
        peak,
        normal: None,
    };
    let (first, between) = (vec![1.0, 0.0], vec![-1.0, 1.0]);
    let start = [0.0, 0.0, 0.6, 0.0];
    let mut seen = Vec::new();
    for (kinds, until) in [
        (vec![(&first, contact(&[(0.0, 1.0)], 1.2))], 6.0),
        (vec![(&first, contact(&[(0.0, 0.4)], 1.4)), (&between, contact(&[(0.0, 0.1)], 1.0))], 3.0),
        (vec![(&first, Kind::Elastic { stiffness: 9.0, friction: 0.4, normal: None })], 3.5),
        (vec![(&first, Kind::Stop { gap: 0.5, stiffness: 9.0, damping: 0.3 })], 3.5),
    ] {
        let element = |(i, (direction, kind)): (usize, (&Vec<f64>, Kind<f64>))| Element {
            name: format!("{i}"),
            direction: direction.clone(),
            moves: Signal::constant(0.0),
            kind,
        };
        let given = Model {
            mass: vec![vec![1.0, 0.0], vec![0.0, 0.75]],
            damping: vec![vec![0.1, -0.03], vec![-0.03, 0.06]],
            stiffness: vec![vec![3.0, -1.0], vec![-1.0, 1.5]],
            elements: kinds.into_iter().enumerate().map(element).collect(),
            harmonics: vec![Harmonic { frequency: 0.9, sin: vec![1.3, 0.8], cos: vec![0.0, 0.4] }],
            ..Model::default()
        };
        let of = |list: &[f64]| State {
            displacement: list[..2].to_vec(),
            velocity: list[2..].to_vec(),
            ..State::rest(2)
        };
        let exact =
            with_bits(4096, || System::new(&model::<Widest>(&given)).expect("valid")).expect("a precision");
        let rough = with_bits(128, || state::<Widest>(&of(&start))).expect("a precision");
        let found = with_bits(4096, || exact.enclosed(&rough, Widest::from_f64(until), 1500));
        let found = found.expect("a precision").expect("a motion");
        seen.extend(found.events.iter().map(|event| event.kind));
        // 64 units in the last of 128 places.
        let far = Wide::exp2i(-122) * Wide::from_f64(0.99);
        let ends: Vec<Vec<Wide>> = [far, -far]
            .into_iter()
            .map(|by| {
                let mut begin = state::<Wide>(&of(&start));
                begin.velocity.iter_mut().for_each(|v| *v = *v + *v * by);
                let end = system(&given).simulate(&begin, Wide::from_f64(until)).expect("a motion").end;
                end.displacement.into_iter().chain(end.velocity).collect()
            })
            .collect();
        for (i, x) in found.end.displacement.iter().chain(&found.end.velocity).enumerate() {
            let offs = || ends.iter().map(|end| Float::from(end[i]) - &x.mid);
            let most = offs().map(|off| off.abs().to_f64()).fold(0.0, f64::max);
            let rad = x.rad.to_f64();
            println!("{i}: {most:e} of {rad:e}");
            // What sticks has no width.
            assert!(most <= rad + 1e-120, "{i}: {most:e} beyond {rad:e}");
            assert!(rad * 0.9 <= most + 1e-120, "{i}: {most:e} in {rad:e}");
        }
    }
    for kind in [Close, Lock, Open, Reverse, Slip, Stick, Yield] {
        assert!(seen.contains(&kind), "{kind:?}: {seen:?}");
    }
}

/// What a motion is found to be.
enum Found {
    Inside { events: usize },
    Declined(String),
}

/// Fails where the motion at 512 bits is not inside.
fn found(given: &Model<f64>, start: &State<f64>, until: f64) -> Found {
    let (system, begin, until) = (system(given), state::<Wide>(start), Wide::from_f64(until));
    match system.enclosed(&begin, until, 64) {
        Ok(found) => {
            let wide = system.simulate(&begin, until).expect("it moves");
            let fault = outside(&found, &wide);
            assert!(fault.is_none(), "{fault:?}\n{given:?}\n{start:?} {until}");
            Found::Inside { events: found.events.len() }
        }
        Err(Error::Unsupported { condition, .. }) => Found::Declined(condition.into()),
        Err(Error::Unproved { reason, .. }) => Found::Declined(reason.into()),
        Err(other) => panic!("{other}"),
    }
}

/// Counts what was found.
#[derive(Default)]
struct Counts {
    inside: usize,
    events: usize,
    declined: BTreeMap<String, usize>,
}

impl Counts {
    fn count(&mut self, found: Found) {
        match found {
            Found::Inside { events } => {
                self.inside += 1;
                self.events += events;
            }
            Found::Declined(reason) => *self.declined.entry(reason).or_default() += 1,
        }
    }

    fn tell(&self, what: &str) {
        println!("{what}: {} inside with {} events, declined {:#?}", self.inside, self.events, self.declined);
    }
}

/// A chain of one to four bodies with contacts of all kinds that are enclosed.
fn chain(random: &mut Random) -> (Model<f64>, State<f64>) {
    let n = 1 + (random.next() * 4.0) as usize;
    let mut model = Model { mass: vec![vec![0.0; n]; n], ..Model::default() };
    (model.damping, model.stiffness) = (model.mass.clone(), model.mass.clone());
    for i in 0..n {
        model.mass[i][i] = random.between(0.5, 2.0);
        for (matrix, by) in
            [(&mut model.stiffness, random.between(1.0, 8.0)), (&mut model.damping, random.between(0.0, 0.3))]
        {
            matrix[i][i] += by;
            if i > 0 {
                matrix[i - 1][i - 1] += by;
                matrix[i - 1][i] -= by;
                matrix[i][i - 1] -= by;
            }
        }
    }
    for i in 0..n {
        let mut direction = vec![0.0; n];
        direction[i] = 1.0;
        if i > 0 && random.next() < 0.5 {
            direction[i - 1] = -1.0;
        }
        let friction = random.between(0.1, 0.6);
        let peak = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 1.8) };
        let mut moves = Signal::constant(if random.next() < 0.3 { random.between(-0.5, 0.5) } else { 0.0 });
        let kind = match (random.next() * 8.0) as usize {
            0 => Kind::Elastic { stiffness: random.between(2.0, 20.0), friction, normal: None },
            1 => {
                moves.constant = 0.0;
                let damping = if random.next() < 0.5 { 0.0 } else { random.between(0.0, 0.5) };
                Kind::Stop { gap: random.between(0.05, 0.6), stiffness: random.between(4.0, 40.0), damping }
            }
            2 => {
                let points =
                    vec![(0.0, friction), (0.2, random.between(0.05, 0.5)), (0.7, random.between(0.05, 0.5))];
                Kind::Contact { law: Law { points }, peak, normal: None }
            }
            3 => {
                let signal = Signal { sin: vec![random.between(-1.2, 1.2)], ..Signal::constant(1.0) };
                let displacement = (0..n).map(|_| random.between(-0.3, 0.3)).collect();
                let normal = Some(Normal { signal, displacement, velocity: vec![] });
                Kind::Contact { law: Law::constant(friction), peak, normal }
            }
            4 => continue,
            _ => Kind::Contact { law: Law::constant(friction), peak, normal: None },
        };
        model.elements.push(Element { name: format!("at {i}"), direction, moves, kind });
    }
    model.harmonics = vec![Harmonic {
        frequency: random.between(0.3, 3.0),
        sin: (0..n).map(|_| random.between(-2.0, 2.0)).collect(),
        cos: vec![],
    }];
    let mut start = State::rest(n);
    if random.next() < 0.5 {
        start.displacement = (0..n).map(|_| random.between(-0.3, 0.3)).collect();
        start.velocity = (0..n).map(|_| random.between(-0.3, 0.3)).collect();
        // A stop is open at first.
        start.displacement.iter_mut().for_each(|x| *x *= 0.1);
    }
    (model, start)
}

/// Random chains: the motion at 512 bits is inside, and few are declined.
#[test]
fn random_chains_lie_inside() {
    let (mut counts, mut random) = (Counts::default(), Random(11));
    let all = crate::count(4, 500);
    for _ in 0..all {
        let (model, start) = chain(&mut random);
        counts.count(found(&model, &start, 15.0));
    }
    counts.tell("chains");
    assert!(counts.inside * 10 >= 9 * all && counts.events > 5 * all, "{} {}", counts.inside, counts.events);
}

/// Random systems of all kinds, half of them with round numbers: each is enclosed with the motion at 512 bits inside, or declined by name.
#[cfg(feature = "generators")]
#[test]
fn random_systems_lie_inside_or_are_declined() {
    use arbitrary::{Arbitrary, Unstructured};
    use stickslip::dependencies::arbitrary;
    use stickslip::generators::Structure;
    let (mut counts, mut random) = (Counts::default(), Random(7));
    for _ in 0..crate::count(12, 2_000) {
        let bytes: Vec<u8> = (0..900).map(|_| random.byte()).collect();
        let Structure { model, start, until } =
            Structure::arbitrary(&mut Unstructured::new(&bytes)).expect("bytes");
        counts.count(found(&model, &start, until));
    }
    counts.tell("all kinds");
    assert!(counts.inside > 0, "{}", counts.inside);
}
