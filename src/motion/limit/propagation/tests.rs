use super::{HalfTurns, MOST_KEPT, MotionPart, follow};
use crate::Error;
use crate::Ratios;
use crate::motion::DrivePhase;
use crate::motion::broken::Budget;
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;
use core::ops::ControlFlow;

#[test]
fn the_monodromy_is_the_derivative_of_the_walk() {
    for (omega, alpha, eta, theta, x, w) in [
        (0.7, 2.0, 1.0, 0.1, -0.4, 1.0),
        (0.4, 6.0, 1.0, 0.3, -0.5, 2.0),
        (1.5, 2.5, 1.0, -1.0, 0.2, -1.0),
        (0.13, 3.0, 1.0, 0.2, 0.1, 0.4),
        (0.7, 2.0, 1.5, 0.1, -0.4, 1.0),
        (0.4, 6.0, 2.0, 0.3, -0.5, 2.0),
        (0.13, 3.0, 1.3, 0.2, 0.1, 0.4),
    ] {
        let ratios = Ratios::new(omega, alpha).unwrap().with_static_friction_ratio(eta).unwrap();
        let equation = Equation::new(ratios);
        let phase = DrivePhase::of(theta).unwrap();
        let at =
            |x, w| HalfTurns::new(equation, PhasePoint { phase, x, w }, 2, 1.0, &mut Budget::of(0)).unwrap();
        let m = at(x, w).derivative;
        let h = 1e-6;
        let (right, left) = (at(x + h, w).end, at(x - h, w).end);
        let (up, down) = (at(x, w + h).end, at(x, w - h).end);
        let difference =
            |p: PhasePoint<f64>, q: PhasePoint<f64>| ((p.x - q.x) / (2.0 * h), (p.w - q.w) / (2.0 * h));
        let ((a, c), (b, d)) = (difference(right, left), difference(up, down));
        for (got, expected) in [(m.a, a), (m.b, b), (m.c, c), (m.d, d)] {
            assert!((got - expected).abs() < 1e-6, "Ω = {omega}: {m:?} {a} {b} {c} {d}");
        }
    }
}

/// Where friction is of the order of the force's rounding, a disturbance keeps its size. (A quotient of the
/// accelerations once made it grow by 7e-5.)
#[test]
fn no_part_drives_two_motions_apart() {
    let equation =
        Equation::new(Ratios::new(1.319_799_361_868_836_2e-6f64, 8.987_385_541_686_157e62).unwrap());
    let phase = DrivePhase::of_half_turn(1, 2.606_010_784_944_601e-7);
    let from = PhasePoint { phase, x: -2.342_122_367_685_313_4e56, w: -1.186_154_571_116_979_4e57 };
    let half_turn = HalfTurns::new(equation, from, 1, 1.0, &mut Budget::of(0)).unwrap();
    assert!((half_turn.derivative.determinant() - 1.0).abs() < 1e-15, "{:?}", half_turn.derivative);
}

/// Only the first of many parts are kept; the others are recomputed on demand.
#[test]
fn parts_that_are_not_kept_are_met_again() {
    let equation = Equation::new(Ratios::new(1e-4, 3.0).unwrap());
    let from = PhasePoint { phase: DrivePhase::of(0.1).unwrap(), x: 0.2, w: 0.3 };
    let mut budget = Budget::of(0);
    let half_turn = HalfTurns::new(equation, from, 1, 1.0, &mut budget).unwrap();
    let mut starts = Vec::new();
    let visit = |part: &MotionPart<f64>| {
        starts.push(match part {
            MotionPart::Slide(slide, _) | MotionPart::Onward(slide, ..) => slide.start,
            MotionPart::Stick(stick, _) => stick.start,
        });
        Ok(())
    };
    half_turn.each_part(&mut budget, visit).unwrap();
    assert!(
        half_turn.parts.len() == MOST_KEPT && half_turn.count > 1100 && half_turn.sticks,
        "{}",
        half_turn.count
    );
    assert_eq!(starts.len() as u64, half_turn.count);
    assert!(starts.windows(2).all(|pair| pair[1].since(pair[0]) > 0.0));
}

#[test]
fn a_walk_is_broken_off() {
    let equation = Equation::new(Ratios::new(1e-3, 3.0).unwrap());
    let from = PhasePoint { phase: DrivePhase::of(0.1).unwrap(), x: 0.2, w: 0.3 };
    let mut asked = 0;
    let mut keep_going = || {
        asked += 1;
        if asked < 7 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let mut parts = 0;
    let mut budget = Budget::of(0).while_allowed(&mut keep_going);
    let count = |_| {
        parts += 1;
        Ok(())
    };
    let broken = follow(equation, from, 1, 1.0, &mut budget, count);
    assert_eq!((broken.err().map(Error::from), parts, asked), (Some(Error::Interrupted), 6, 7));
}

/// A velocity zero exactly at the end of the time ends the propagation. (The body, at rest with no time left,
/// was once found at rest again and again.)
#[test]
fn a_turn_at_the_end_ends_it() {
    // Cases from random starts, next to a member of a family, and at quarter turns of the body with rest on
    // arrival.
    let found = (
        Ratios::new(2.0, 1.677_050_983_124_842_1).unwrap(),
        DrivePhase::of_half_turn(9, 1.570_796_326_794_887_7),
        3.022_314_549_036_573e23,
        1.437_112_669_326_197_2e39,
    );
    let family = (
        Ratios::new(0.5, 12.0).unwrap(),
        DrivePhase::of_half_turn(1, -std::f64::consts::FRAC_PI_2),
        14.624_326_256_136_987,
        -1e-15,
    );
    for (ratios, phase, x, w) in [found, family] {
        for by in -40..=40 {
            let w = w * (1.0 + f64::from(by) * f64::EPSILON);
            for half_turns in 1..=4 {
                let (from, free) = (PhasePoint { phase, x, w }, &mut Budget::of(0));
                let motion = HalfTurns::new(Equation::new(ratios), from, half_turns, 1.0, free).unwrap();
                assert!(
                    motion.end.x.is_finite() && motion.end.w.is_finite(),
                    "{ratios:?} {x:e} {w:e}: {motion:?}"
                );
                assert!(motion.parts.len() < 16, "{motion:?}");
                assert!(matches!(motion.parts.last(), Some(MotionPart::Onward(..) | MotionPart::Stick(..))));
            }
        }
    }
}
