//! Works, distances and growth of a motion, compared with the equation of motion.

use super::measures::CycleStatistics;
use super::propagation::follow;
use super::steady::SteadyParts;
use crate::motion::broken::Budget;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::work::Works;
use crate::motion::state::PhasePoint;
use crate::motion::{LongRun, State, SteadyState, Trajectory, errors_after};
use crate::{Cycle, Ratios};
use core::f64::consts::{PI, TAU};
use core::ops::ControlFlow;

fn ratios(omega: f64, alpha: f64) -> Ratios<f64> {
    Ratios::new(omega, alpha).unwrap()
}

/// Before a motion has settled, the work of the drive and the work against friction differ by the change of
/// the energy `(x² + w²)/2`.
#[test]
fn the_works_balance_the_energy() {
    for i in 0..200 {
        let part = |step: f64| (f64::from(i) * step).fract();
        let (omega, alpha) = (0.1 + 3.0 * part(0.618_034), 1.1 + 4.0 * part(0.754_878));
        let start = PhasePoint {
            phase: DrivePhase::of(TAU * part(0.569_841)).unwrap(),
            x: 6.0 * part(0.437_016) - 3.0,
            w: 4.0 * part(0.324_718) - 2.0,
        };
        let equation = Equation::new(ratios(omega, alpha));
        let mut statistics = CycleStatistics::at(&start, omega);
        let mut free = Budget::of(0);
        let (end, _) =
            follow(equation, start, 2, PI / omega, &mut free, |part| statistics.add(&part)).unwrap();
        let energy = |x: f64, w: f64| (x * x + w * w) / 2.0;
        let change = energy(end.x, end.w) - energy(start.x, start.w);
        let left = statistics.work_in - statistics.work_out - change;
        assert!(left.abs() < 1e-11 * (1.0 + statistics.work_out), "{omega} {alpha}: {left:e} {statistics:?}");
        assert!(change.abs() > 1e-9, "{omega} {alpha}: {change:e}");
    }
}

/// The distance has components in x/B and in x′/(Bω_d), each in its own unit.
#[test]
fn the_distance_is_in_the_units_of_a_state() {
    for omega in [0.25f64, 0.7, 4.0] {
        let limit = LongRun::from_start(ratios(omega, 1.4), State::default()).unwrap();
        let steady = limit.steady_state().unwrap();
        let none = Works { drive: 0.0, damper: 0.0 };
        let found = SteadyState::of(SteadyParts {
            equation: steady.equation,
            start: steady.start,
            half_turns: 3,
            statistics: CycleStatistics::of_reversals(
                steady.max_displacement,
                steady.max_velocity,
                none,
                0.0,
            ),
            multipliers: steady.multipliers,
            distance: (0.25, 0.5),
            periods: 0.0,
        });
        assert_eq!(found.distance, (0.25, 0.5 / omega), "{omega}");
        assert_eq!((found.state.x, found.state.v), (steady.start.x, steady.start.w / omega), "{omega}");
        assert_eq!((found.turns_per_cycle, found.is_symmetric, found.half_turns()), (3, true, 3));
    }
}

/// At Ω = 1 the motion is a free swing of amplitude E in phase with the drive. In a turn the drive's work is
/// παE, and friction takes 4E: `d(E²/2) = (πα − 4) E`, so that E grows by πα − 4 a turn.
#[test]
fn the_growth_at_resonance_is_that_of_the_motion() {
    for alpha in [1.4, 2.0, 5.0] {
        let limit = LongRun::from_start(ratios(1.0, alpha), State::default()).unwrap();
        let LongRun::Unbounded { growth } = limit else { panic!("{limit:?}") };
        let motion = Trajectory::new(ratios(1.0, alpha), State::default()).unwrap();
        let greatest = |from: f64, to: f64| {
            let ends = motion.map(|phase| phase.unwrap().end().unwrap());
            let ends = ends.skip_while(|end| end.phase.since(State::default().phase) < from * TAU);
            ends.take_while(|end| end.phase.since(State::default().phase) < to * TAU)
                .map(|end| end.x)
                .fold(0.0, f64::max)
        };
        let (early, late) = (greatest(999.0, 1000.0), greatest(1999.0, 2000.0));
        let found = (late - early) / 1000.0;
        assert!((found / growth - 1.0).abs() < 1e-3, "{alpha}: {found} {growth}");
    }
}

/// A motion that does not settle is followed for the allowed periods and a few half turns more.
#[test]
fn a_budget_is_one_of_periods() {
    for most in [100, 400] {
        let limit =
            LongRun::within(ratios(0.5, 1e12), State::default(), most, &mut || ControlFlow::Continue(()))
                .unwrap();
        let LongRun::NotConverged { periods, .. } = limit else { panic!("{limit:?}") };
        let most = f64::from(most);
        assert!(periods > most && periods < most + 40.0, "{periods} of {most}");
    }
}

/// The errors after some cycles are those of the state reached by then, from a start in motion.
#[test]
fn errors_after_some_cycles_are_those_from_there() {
    let start = State::new(0.0, 0.4, 0.9).unwrap();
    let motion = Trajectory::new(ratios(0.7, 2.0), start).unwrap();
    let there = motion.samples(1).unwrap().nth(3).unwrap().unwrap().state;
    let (found, due) = (
        errors_after(ratios(0.7, 2.0), start, 3).unwrap(),
        errors_after(ratios(0.7, 2.0), there, 0).unwrap(),
    );
    for (a, b) in [(found.error_1, due.error_1), (found.error_2, due.error_2), (found.error_3, due.error_3)] {
        assert!((a - b).abs() < 1e-12 && b.abs() > 1e-6, "{found:?} {due:?}");
    }
}

/// Without a damper the damper's work is zero, however the motion was found.
#[test]
fn no_damper_takes_no_work() {
    let cycle = Cycle::new(ratios(0.7, 2.0)).unwrap();
    for limit in
        [LongRun::try_from(&cycle).unwrap(), LongRun::from_start(ratios(0.7, 2.0), State::default()).unwrap()]
    {
        assert_eq!(limit.steady_state().map(|it| it.damper_work), Some(0.0));
    }
}
