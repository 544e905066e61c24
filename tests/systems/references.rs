//! Independent values of transient motions and of steady ones.

use crate::cases::{Case, cases, cases_of, list, number, start};
use crate::compared::{Origin::AnotherProgram, compared};
use stickslip::system::{Kind, Motion, State, System};

/// The largest difference of two lists, relative to the largest value.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let size = b.iter().fold(0.0, |m: f64, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// Compares the events with those of the case: the largest difference of the times.
fn events(case: &Case, motion: &Motion<f64>, shift: f64) -> f64 {
    let expected = case.answer["events"].as_array().expect("events");
    let seen: Vec<_> = motion.events.iter().map(|e| (e.time - shift, e.element, e.kind.name())).collect();
    let wanted: Vec<_> = expected
        .iter()
        .map(|e| {
            let element = usize::try_from(e[1].as_u64().expect("an element")).expect("small");
            (number(&e[0]), element, e[2].as_str().expect("a kind"))
        })
        .collect();
    assert_eq!(
        seen.iter().map(|e| (e.1, e.2)).collect::<Vec<_>>(),
        wanted.iter().map(|e| (e.1, e.2)).collect::<Vec<_>>(),
        "{}: {seen:?} for {wanted:?}",
        case.name
    );
    seen.iter().zip(&wanted).map(|(a, b)| (a.0 - b.0).abs() / motion.duration).fold(0.0, f64::max)
}

#[test]
fn transient_motions() {
    let mut count = 0;
    for case in cases().into_iter().filter(|c| c.run["kind"] == "transient") {
        let system = System::new(&case.model).expect("the case is valid");
        let until = number(&case.run["until"]);
        let motion = system.simulate(&start(&case), until).expect(&case.name);
        let times = events(&case, &motion, 0.0);
        // The falling law of the table lets rounding grow by some 10⁵ after the release.
        assert!(times < 1e-10, "{}: event times by {times:e}", case.name);
        let instants = system.states(&start(&case), &[until]).expect(&case.name);
        for (name, ours, at) in [
            ("displacement", &motion.end.displacement, &instants[0].displacement),
            ("velocity", &motion.end.velocity, &instants[0].velocity),
        ] {
            let due = list(&case.answer[name]);
            let size = due.iter().fold(1e-20, |most: f64, x| most.max(x.abs()));
            for (function, found) in [("simulate", ours), ("states", at)] {
                for (found, due) in found.iter().zip(&due) {
                    let output = format!("fn system::System::{function}");
                    compared(&output, *found, *due, AnotherProgram, 1e-10 * size);
                }
            }
        }
        for (name, seen) in [("displacement", &motion.end.displacement), ("velocity", &motion.end.velocity)] {
            let by = difference(seen, &list(&case.answer[name]));
            let still = list(&case.answer[name]).iter().all(|x| x.abs() < 1e-30);
            assert!(by < 1e-10 || still, "{}: {name} by {by:e}", case.name);
        }
        let greatest = [motion.max_displacement.clone(), motion.max_velocity.clone()].concat();
        let least = [motion.min_displacement.clone(), motion.min_velocity.clone()].concat();
        for (name, seen) in [("max", greatest), ("min", least)] {
            let by = difference(&seen, &list(&case.answer[name]));
            assert!(by < 1e-10, "{}: {name} by {by:e}", case.name);
        }
        let works: f64 = motion.elements.iter().map(|e| e.work).sum();
        let left = motion.load_work - motion.damper_work - works - motion.stored;
        let size = motion.load_work.abs() + motion.damper_work + works.abs() + motion.stored.abs();
        assert!(left.abs() <= 1e-12 * size, "{}: energy by {left:e} of {size:e}", case.name);
        count += 1;
    }
    assert_eq!(count, 6);
}

/// Random machines with a joint without mass beside a program that finds its velocity by a scalar equation: those that are kept, or those of
/// the file `STICKSLIP_JOINTS`, as `.ci/slow joints` has it.
#[test]
fn machines_with_a_joint() {
    let kept = || include_str!("../data/joints.json").to_owned();
    // Tests begin in the folder of their package.
    let text = std::env::var("STICKSLIP_JOINTS")
        .map_or_else(|_| kept(), |file| std::fs::read_to_string(file).unwrap());
    let all = cases_of(&text);
    let mut count = [0; 2];
    for case in &all {
        let system = System::new(&case.model).expect("the case is valid");
        let motion = system.simulate(&start(case), number(&case.run["until"])).expect(&case.name);
        let times = events(case, &motion, 0.0);
        compared("fn system::System::simulate", times, 0.0, AnotherProgram, 1e-9);
        for (name, ours) in [("displacement", &motion.end.displacement), ("velocity", &motion.end.velocity)] {
            for (ours, due) in ours.iter().zip(list(&case.answer[name])) {
                compared("fn system::System::simulate", *ours, due, AnotherProgram, 1e-9 * (1.0 + due.abs()));
            }
        }
        let has_elastic = case.model.elements.iter().any(|e| matches!(e.kind, Kind::Elastic { .. }));
        count[usize::from(has_elastic)] += motion.events.len();
    }
    assert!(all.len() >= 24 && count.iter().all(|events| *events > 50), "{} {count:?}", all.len());
}

/// Steady motions from rest, found by Newton's method; the references were followed to the end.
#[test]
fn steady_motions() {
    let mut count = 0;
    for case in cases().into_iter().filter(|c| c.run["kind"] == "steady") {
        let system = System::new(&case.model).expect("the case is valid");
        let rest = State::rest(system.coordinates());
        let steady = system.steady(&rest).expect(&case.name);
        let motion = &steady.motion;
        let times = events(&case, motion, 0.0);
        let start = [steady.start.displacement.clone(), steady.start.velocity.clone()].concat();
        let by = difference(&start, &list(&case.answer["start"]));
        let at_rest: Vec<f64> = motion.elements.iter().map(|e| e.time_at_rest).collect();
        let rests = difference(&at_rest, &list(&case.answer["at_rest"]));
        let allowed = if case.answer["periods_from_rest"].as_u64() > Some(250) { 1e-8 } else { 1e-10 };
        compared("fn system::System::steady", by, 0.0, AnotherProgram, allowed);
        assert!(
            by < allowed && times < allowed && rests < allowed,
            "{}: {by:e} {times:e} {rests:e}",
            case.name
        );
        let greatest = [motion.max_displacement.clone(), motion.max_velocity.clone()].concat();
        let least = [motion.min_displacement.clone(), motion.min_velocity.clone()].concat();
        for (name, seen) in [("max", greatest), ("min", least)] {
            let by = difference(&seen, &list(&case.answer[name]));
            assert!(by < allowed, "{}: {name} by {by:e}", case.name);
        }
        count += 1;
    }
    assert_eq!(count, 33);
}
