//! Limits of the exact motion: one from every start, or a family, or none.

use super::{ratios, start, steady};
use crate::random::Random;
use std::ops::ControlFlow;
use stickslip::motion::{Kind, LongRun, State, SteadyState, Trajectory};
use stickslip::{Border, Cycle, Ratios, Regime};

#[test]
fn one_limit_from_every_start_and_it_is_symmetric() {
    let mut random = Random(8);
    for _ in 0..2000 {
        let (omega, alpha) = (random.scale(0.02, 20.0), random.scale(1.01, 30.0));
        let regime = stickslip::Response::new(Ratios::new(omega, alpha).unwrap()).regime;
        assert!(regime == Regime::Sticking || regime == Regime::NonSticking);
        let rest = steady(omega, alpha);
        let from = start(&mut random, omega, alpha);
        let LongRun::Periodic(other) = LongRun::from_start(ratios(omega, alpha), from).unwrap() else {
            panic!("({omega}, {alpha}) from {from:?}");
        };
        let close = |a: f64, b: f64, scale: f64| {
            let settling = 1.0 / (1.0 - rest.contraction());
            assert!(
                (a - b).abs() < 1e-13 * scale * settling * (1.0 + 1.0 / omega),
                "({omega}, {alpha}): {a} {b}"
            );
        };
        close(rest.max_displacement.value, other.max_displacement.value, rest.max_displacement.value);
        close(rest.max_velocity.value, other.max_velocity.value, rest.max_velocity.value);
        assert_eq!(rest.sticks_per_cycle == 0, regime == Regime::NonSticking, "({omega}, {alpha})");
        let errors = rest.errors().unwrap();
        close(errors.error_1, 0.0, 1.0);
        close(errors.error_3, 0.0, 1.0);
        close(errors.error_2, 0.0, 1.0);
        close(errors.error_4, 0.0, 100.0);
        close(rest.energy_in, rest.energy_out, 10.0 * rest.energy_out + alpha);
        assert!((0.0..1.0).contains(&rest.stick_fraction));
        assert!(rest.contraction() < 1.0);
    }
}
#[test]
fn what_has_no_unique_limit_is_named() {
    let run = |omega, alpha| LongRun::from_start(ratios(omega, alpha), State::default()).unwrap();
    assert!(matches!(run(1.0, 1.3), LongRun::Unbounded { growth } if growth > 0.0));
    assert!(matches!(run(1.0, 1.27), LongRun::Periodic(_)));
    let LongRun::Rest(rest) = run(0.7, 0.9) else { panic!() };
    assert_eq!((rest.position, rest.slides), (0.0, Some(0)));
    // Released at x = 3 under a weak force, the body comes to rest where it can stay.
    let thrown = State::new(0.0, 3.0, 1.0).unwrap();
    let LongRun::Rest(rest) = LongRun::from_start(ratios(0.7, 0.6), thrown).unwrap() else { panic!() };
    assert!(rest.position.abs() <= 0.4 && rest.slides.is_some_and(|n| n >= 1), "{rest:?}");
    // Just outside the places of rest it creeps to the edge for ever, and does not count as settled there.
    let outside = State::new(0.0, -0.1001, 0.0).unwrap();
    let LongRun::Rest(rest) = LongRun::from_start(ratios(0.7, 0.9), outside).unwrap() else { panic!() };
    assert!((rest.position + 0.1).abs() < 1e-15 && rest.slides.is_none(), "{rest:?}");
    // If the budget is too small for a slow motion, the result is not converged.
    let far = State::new(0.0, 1e5, 0.0).unwrap();
    let short = LongRun::within(ratios(0.7, 0.6), far, 100, &mut || ControlFlow::Continue(())).unwrap();
    assert!(matches!(short, LongRun::NotConverged { .. }), "{short:?}");
}
#[test]
fn a_family_keeps_what_the_start_gave_it() {
    for (omega, alpha) in [(0.5, 6.0), (0.25, 40.0), (0.5, 3.5)] {
        let amplitude: f64 = alpha / (1.0 - omega * omega);
        let room = omega * omega * amplitude - 1.0;
        let mut offsets = Vec::new();
        for x in [-4.0, 0.0, 3.0] {
            let from = State::new(0.4, x, 0.0).unwrap();
            let LongRun::Family(s) = LongRun::from_start(ratios(omega, alpha), from).unwrap() else {
                panic!("({omega}, {alpha})");
            };
            let (max, min) = (s.max_displacement.value, s.min_displacement.value);
            assert!(((max - min) / 2.0 / amplitude - 1.0).abs() < 1e-12, "({omega}, {alpha}): {max} {min}");
            let offset = (max + min) / 2.0;
            assert!(offset.abs() <= room + 1e-9, "({omega}, {alpha}): {offset} of {room}");
            // A thousand cycles from the same start end on the same member; near the edge the motion only
            // creeps towards it.
            let late = Trajectory::new(ratios(omega, alpha), from)
                .unwrap()
                .map(Result::unwrap)
                .filter(|p| p.kind != Kind::Stick)
                .skip(4000)
                .take(2);
            let ends: Vec<f64> = late.map(|p| p.end().unwrap().x).collect();
            let reach = 4.0 * s.distance.0.max(1e-10 * amplitude);
            assert!((ends[0] + ends[1] - max - min).abs() < reach, "({omega}, {alpha}): {ends:?} {s:?}");
            offsets.push(offset);
        }
        assert!(offsets[0] != offsets[2], "({omega}, {alpha}): {offsets:?}");
    }
}
#[test]
fn starts_far_away_lead_to_the_same_limit() {
    for (omega, alpha) in [(0.7, 1.2), (0.7, 3.0), (0.4, 6.0), (0.01, 3.0), (1.0, 1.2), (100.0, 1.5)] {
        let near = steady(omega, alpha);
        for x in [1e3, 1e6, -1e70] {
            let far = LongRun::from_start(ratios(omega, alpha), State::new(0.0, x, 0.0).unwrap()).unwrap();
            let LongRun::Periodic(s) = far else { panic!("({omega}, {alpha}) from {x}: {far:?}") };
            let error = s.max_displacement.value / near.max_displacement.value - 1.0;
            assert!(
                error.abs() < 1e-12 / (1.0 - near.contraction()),
                "({omega}, {alpha}) from {x}: {error:e}"
            );
        }
    }
}
/// Found by fuzzing: for a start so far out that the loss per cycle is below rounding, a repeating cycle is
/// no member of a family.
#[test]
fn a_far_start_of_a_family_has_not_converged() {
    let start = State::new(0.0, 6.6e36, 1e12).unwrap();
    let motion =
        LongRun::within(Ratios::new(0.5f64, 4.0).unwrap(), start, 100, &mut || ControlFlow::Continue(()))
            .unwrap();
    assert!(matches!(motion, LongRun::NotConverged { .. }), "{motion:?}");
    // The force is so large that friction is below the rounding of the motion.
    let start = State::new(0.5, 64.0, 0.0).unwrap();
    let motion =
        LongRun::within(Ratios::new(0.5f64, 8.9e43).unwrap(), start, 100, &mut || ControlFlow::Continue(()))
            .unwrap();
    assert!(matches!(motion, LongRun::NotConverged { .. }), "{motion:?}");
}
/// One float away from 1/(2n) there is no family: the closed-form cycle is the limit, however slow the
/// convergence.
#[test]
fn beside_a_family_the_limit_is_symmetric() {
    for omega in [0.5f64.next_down(), 0.5f64.next_up(), 1.0 / 6.0, 0.25 * (1.0 + 1e-14), 0.1] {
        let alpha = 2.5 * Border::new(omega).unwrap().min_force_ratio;
        let cycle = Cycle::new(ratios(omega, alpha)).unwrap();
        for x in [0.0, 1.0, -30.0] {
            let from = State::new(0.4, x, 0.0).unwrap();
            for limit in
                [LongRun::from_start(ratios(omega, alpha), from).unwrap(), LongRun::try_from(&cycle).unwrap()]
            {
                let LongRun::Periodic(s) = limit else { panic!("{omega} {alpha} {x}: {limit:?}") };
                let size = cycle.max_displacement;
                assert!((s.max_displacement.value / size - 1.0).abs() < 1e-13, "{omega}: {s:?}");
                assert!((s.min_displacement.value / size + 1.0).abs() < 1e-13, "{omega}: {s:?}");
                assert!(s.distance.0 < 1e-12 * size && s.periods < 100.0, "{omega}: {s:?}");
                assert!((s.contraction() - 1.0).abs() < 1e-9, "{omega}: {s:?}");
            }
        }
    }
}
/// The outermost member of a family touches the bound of sticking: a stop of zero length is due to rounding.
#[test]
fn a_member_of_a_family_does_not_stop() {
    let from = State::new(0.0, 22.80238925562624, 29.1982727281998).unwrap();
    let limit = LongRun::from_start(ratios(0.25, 24.19078093433229), from).unwrap();
    let LongRun::Family(s) = limit else { panic!("{limit:?}") };
    assert_eq!((s.sticks_per_cycle, s.velocity_zeros_per_cycle, s.stick_fraction), (0, 2, 0.0), "{s:?}");
}
/// Starts all over the plane lead to the same motion as rest; the exceptions are returned.
fn starts_lead_elsewhere(starts: u64, seed: u64) -> Vec<String> {
    let mut random = Random(seed);
    let (mut compared, mut differ) = (0, Vec::new());
    while compared < starts {
        let (omega, alpha) = (random.scale(0.02, 50.0), 1.0 + random.scale(1e-3, 30.0));
        let from_rest = LongRun::from_start(ratios(omega, alpha), State::default()).unwrap();
        let LongRun::Periodic(from_rest) = from_rest else { continue };
        let counts = |s: &SteadyState<f64>| (s.sticks_per_cycle, s.velocity_zeros_per_cycle);
        for _ in 0..10 {
            let from = start(&mut random, omega, alpha);
            let limit = LongRun::from_start(ratios(omega, alpha), from).unwrap();
            let LongRun::Periodic(other) = limit else {
                panic!("({omega}, {alpha}) from {from:?}: {limit:?}")
            };
            let (sticks, zeros) = counts(&other);
            assert!(sticks <= zeros && f64::from(zeros) <= 16.0 + 4.0 / omega, "{other:?}");
            let known = from_rest.distance.0 + other.distance.0 + from_rest.distance.1 + other.distance.1;
            let bound = 16.0 * known + 1e-13 * (1.0 + alpha) * from_rest.max_displacement.value;
            let far = (other.max_displacement.value - from_rest.max_displacement.value).abs();
            let fast = (other.max_velocity.value - from_rest.max_velocity.value).abs() * omega.min(1.0);
            compared += 1;
            if counts(&other) != counts(&from_rest) || far > bound || fast > bound {
                differ.push(format!(
                    "Ω = {omega:?}, α = {alpha:?}, from {from:?}: {far:e} {fast:e} of {bound:e}: {other:?} \
                     {from_rest:?}"
                ));
            }
        }
    }
    differ
}
#[test]
fn every_start_leads_to_the_limit_from_rest() {
    assert_eq!(starts_lead_elsewhere(3_000, 5), Vec::<String>::new());
}
/// The campaign of docs/development/robustness.md.
#[test]
#[ignore = "minutes: the whole campaign"]
fn campaign() {
    assert_eq!(starts_lead_elsewhere(100_000, 3), Vec::<String>::new());
}
