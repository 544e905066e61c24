//! Limits of motions at Ω = 1/(2n), compared with the motions themselves.

use super::{is_near, is_one, member, nearest_edge};
use crate::motion::DrivePhase;
use crate::motion::broken::Budget;
use crate::motion::limit::long_run::LongRun;
use crate::motion::limit::propagation::HalfTurns;
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;
use crate::{Border, Ratios};

/// The equation at Ω = 2⁻ⁿ and a multiple of the border, with α/(1 − Ω²) and the greatest |c|.
fn family(n: u32, times: f64) -> (Equation<f64>, f64, f64) {
    let omega = 0.5f64.powi(i32::try_from(n).unwrap());
    let ratios = Ratios::new(omega, Border::new(omega).unwrap().min_force_ratio * times).unwrap();
    assert!(is_one(ratios));
    let equation = Equation::new(ratios);
    let amplitude = equation.alpha / (1.0 - omega * omega);
    (equation, amplitude, omega * omega * amplitude - 1.0)
}

/// A state at t₂, where the members have their maximum: ω_d t₂ = π/2.
fn at_maximum(x: f64, w: f64) -> PhasePoint<f64> {
    PhasePoint { phase: DrivePhase::of(std::f64::consts::FRAC_PI_2).unwrap(), x, w }
}

fn limit(equation: Equation<f64>, y: PhasePoint<f64>, most: u64) -> LongRun<f64> {
    member(equation, y, 1.0, &mut Budget::of(most)).unwrap()
}

/// Computes some cycles of the motion, and returns its state and whether it sticks in the last cycle.
fn followed(equation: Equation<f64>, mut y: PhasePoint<f64>, cycles: u32) -> (PhasePoint<f64>, bool) {
    let mut sticks = false;
    for _ in 0..cycles {
        let cycle = HalfTurns::new(equation, y, 2, 1.0, &mut Budget::of(0)).unwrap();
        sticks = cycle.sticks;
        y = cycle.end;
    }
    (y, sticks)
}

#[test]
fn a_family_is_at_the_even_parts_of_one_above_the_border() {
    let is = |omega: f64, times: f64| {
        let least = Border::new(omega).unwrap().min_force_ratio;
        is_one(Ratios::new(omega, least * times).unwrap())
    };
    assert!([0.5, 0.25, 2f64.powi(-10)].into_iter().all(|omega| is(omega, 1.001) && !is(omega, 0.999)));
    let others = [0.51, 1.0 / 3.0, 1.0, 2.0, 0.5f64.next_up(), 0.5f64.next_down(), 1.0 / 6.0, 1e-3];
    assert!(others.into_iter().all(|omega| !is(omega, 1.5)));
}

#[test]
fn near_is_within_eight_times_the_reach() {
    // 8 · 12 (1 + 1/4)/(1 − 1/4) = 160
    let equation = Equation::new(Ratios::new(0.5, 12.0).unwrap());
    let near = |x, w| is_near(&equation, &at_maximum(x, w));
    assert!(near(159.0, 0.0) && near(-80.0, 79.0) && near(0.0, -159.0));
    assert!(!near(161.0, 0.0) && !near(-80.0, 81.0) && !near(0.0, -161.0));
}

#[test]
fn a_start_tends_to_where_the_motion_itself_does() {
    for n in 1..5 {
        for times in [1.02, 1.3, 4.0] {
            let (equation, amplitude, room) = family(n, times);
            for i in 0..8 {
                let part = |step: f64| 2.0 * (f64::from(i) * step).fract() - 1.0;
                let start = at_maximum(amplitude + room * part(0.618_034), 0.3 * room * part(0.754_878));
                let (there, sticks) = followed(equation, start, 600);
                if sticks {
                    continue;
                }
                let LongRun::Family(found) = limit(equation, start, 40_000) else {
                    panic!("n = {n}, {start:?}")
                };
                let c = (found.max_displacement.value + found.min_displacement.value) / 2.0;
                let at = format!("n = {n}, {times} times, start {i}: {found:?}");
                let off = found.distance.0 + 1e-12 * amplitude;
                assert!((found.max_displacement.value - c - amplitude).abs() <= off, "{at}");
                assert!(c.abs() <= room + off && (c - (there.x - amplitude)).abs() <= off, "{there:?} {at}");
                assert!(found.distance.0 < 1e-7 * amplitude && found.sticks_per_cycle == 0, "{at}");
                assert!(found.periods < 200.0, "{at}");
            }
        }
    }
}

/// A member returns to its state to within the stated distance.
#[test]
fn a_member_is_its_own_limit() {
    for n in 1..5 {
        for times in [1.3, 4.0, 50.0] {
            let (equation, amplitude, room) = family(n, times);
            for i in -9..=9 {
                let c = room * f64::from(i) / 10.0;
                let start = at_maximum(amplitude + c, 0.0);
                let LongRun::Family(found) = limit(equation, start, 400) else { panic!("n = {n}, {i}") };
                let (max, min) = (found.max_displacement.value, found.min_displacement.value);
                let off = found.distance.0;
                assert!(
                    (max - amplitude - c).abs() <= off && (min + amplitude - c).abs() <= off,
                    "{found:?}"
                );
                let [(one, zero), (other, _)] = found.multipliers;
                assert!((one, zero) == (1.0, 0.0) && other.abs() < 0.999, "{found:?}");
                assert!(off > 0.0 && off < 1e-12 * amplitude && found.periods < 60.0, "{n} {i} {found:?}");
            }
        }
    }
}

/// Where friction is below the rounding of the motion, the distance from the limit is unknown.
#[test]
fn friction_that_cannot_be_seen_settles_nothing() {
    for times in [1e15, 1e16, 1e40] {
        for part in [1.1, 1.0, 0.3] {
            let (equation, amplitude, _) = family(1, times);
            let found = limit(equation, at_maximum(amplitude * part, 0.0), 100);
            assert!(matches!(found, LongRun::NotConverged { .. }), "{times} {part} {found:?}");
        }
    }
}

/// Where friction is barely resolved, a member is still found or ruled out, to within a distance that grows
/// as friction decreases.
#[test]
fn friction_that_can_hardly_be_seen() {
    for times in [1e6, 1e9, 1e12] {
        let (equation, amplitude, room) = family(1, times);
        for i in -9..=9 {
            let c = room * f64::from(i) / 10.0;
            let start = at_maximum(amplitude + c, 0.0);
            let LongRun::Family(found) = limit(equation, start, 400) else {
                assert!(times > 1e6, "{i}");
                continue;
            };
            let (max, min) = (found.max_displacement.value, found.min_displacement.value);
            let off = found.distance.0;
            assert!((max - amplitude - c).abs() <= off && (min + amplitude - c).abs() <= off, "{found:?}");
            assert!((1e-16 * times..1e-14 * times).contains(&(off / amplitude)), "{off} {found:?}");
        }
    }
}

/// A motion from outside the family creeps to its edge.
#[test]
fn outside_of_the_family_the_edge_is_the_limit() {
    for n in 1..5 {
        let (equation, amplitude, room) = family(n, 1.3);
        for side in [1.0, -1.0] {
            let start = at_maximum(amplitude + 1.5 * side * room, 0.0);
            let LongRun::Family(found) = limit(equation, start, 40_000) else { panic!("n = {n}") };
            let c = (found.max_displacement.value + found.min_displacement.value) / 2.0;
            assert!((c - side * room).abs() < 1e-9 * amplitude, "n = {n}: {c} for {room}");
            let off = found.distance.0;
            assert!(off < 0.1 * amplitude && found.periods < 400.0, "{off} {}", found.periods);
            // The motion has stuck in every cycle, and is as close as stated.
            let (there, _) = followed(equation, start, found.periods as u32);
            assert!((there.x - amplitude - side * room).abs() <= off, "n = {n}: {there:?} {off}");
        }
        let unfinished = limit(equation, at_maximum(amplitude + 1.5 * room, 0.0), 20);
        assert!(matches!(unfinished, LongRun::NotConverged { .. }), "{unfinished:?}");
    }
}

/// The edge itself is a motion that does not stick, at any phase.
#[test]
fn the_edge_is_a_member() {
    for n in 1..5 {
        let (equation, amplitude, room) = family(n, 1.7);
        for i in 0..60 {
            let phase = DrivePhase::of(0.1 + 0.1 * f64::from(i)).unwrap();
            for side in [1.0, -1.0] {
                // A start slightly outside, at the same phase.
                let (outside, _) = followed(equation, at_maximum(amplitude + side * room, 0.0), 1);
                let on = HalfTurns::new(equation, outside, 4, 1.0, &mut Budget::of(0)).unwrap().end;
                assert!((on.x - amplitude - side * room).abs() < 1e-9 * amplitude);
                let edge = nearest_edge(equation, &PhasePoint { phase, x: side * 1e6, w: 0.0 });
                let (back, _) = followed(equation, edge, 1);
                assert!((back.x - edge.x).hypot(back.w - edge.w) < 1e-9 * amplitude, "n = {n}, {i}");
            }
        }
    }
}
