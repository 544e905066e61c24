//! Tests of `sticking.rs`.

use super::{
    LoopSize, bound_between, doubt_of_way, loop_size_of_motion, most_dissipating_force_ratio_of_all,
    most_dissipating_friction_of_all,
};
use crate::design::OptimumKind;
use crate::motion::{LongRun, State, Trajectory};
use crate::{Drive, Error, Oscillator, Ratios, Response};

#[test]
fn more_friction_less_way() {
    for omega in [0.13, 0.22, 0.3, 0.4, 0.7, 0.95, 1.3, 4.0] {
        let mut last = f64::INFINITY;
        for i in 1..200 {
            let share = 0.005 * f64::from(i);
            let way = loop_size_of_motion::<f64>(omega, 1.0 / share, 0.0).unwrap().found / share;
            assert!(way <= last * (1.0 + 1e-12), "{omega} {share}: {way} after {last}");
            last = way;
        }
    }
}

/// The path lengths of two nearby motions with stops differ by no more than the bound.
#[test]
fn the_way_of_a_motion_known_within_d() {
    let mut worst = 0.0f64;
    for (omega, alpha) in
        [(0.01, 2.0), (0.03, 5.0), (0.13, 2.0), (0.3, 3.0), (0.4, 2.0), (0.7, 1.2), (0.7, 3.0), (1.3, 1.5)]
    {
        let ratios = Ratios::new(omega, alpha).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let steady = limit.steady_state().unwrap();
        let from = steady.state;
        let way = |x: f64, w: f64| {
            let start = State { x: from.x + x, v: from.v + w / omega, ..from };
            let samples = Trajectory::new(ratios, start).unwrap().samples(20_000).unwrap();
            let x: Vec<f64> = samples.take(20_001).map(|sample| sample.unwrap().state.x).collect();
            x.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>()
        };
        let usual = way(0.0, 0.0);
        assert!((usual / steady.energy_out - 1.0).abs() < 1e-6, "{omega}");
        for i in 0..8 {
            let (s, c) = f64::from(i).sin_cos();
            let d = 1e-3;
            let change = (way(d * c, d * s) - usual).abs();
            assert!(change <= doubt_of_way(d, omega, alpha, usual), "{omega} {alpha}: {change}");
            worst = worst.max(change / d);
        }
        let size = LoopSize::of_motion(steady, omega, alpha);
        let (x, v) = steady.distance;
        let doubt = 2.0 / alpha / alpha * doubt_of_way(x.hypot(v * omega), omega, alpha, steady.energy_out);
        assert!(size.most - size.found >= doubt && doubt > 0.0 && size.most < size.found * (1.0 + 1e-11));
    }
    assert!(worst > 1.0, "{worst}");
    // The answer includes its own uncertainty, at the tolerance that leaves the least room for it.
    let best = most_dissipating_force_ratio_of_all(0.3, 0.0, 2e-8).unwrap();
    let again = loop_size_of_motion(0.3, best.at, 0.0).unwrap();
    assert!(best.bound >= again.most && again.most > again.found);
}

/// The bound by changes of direction does not grow with the length of a cycle, while the bound by length
/// does.
#[test]
fn a_long_cycle_is_known_as_well() {
    let doubt = |omega: f64| doubt_of_way(1e-10, omega, 2.0, 4.0);
    assert!((doubt(1e-4) / 1.6e-9 - 1.0).abs() < 1e-8, "{}", doubt(1e-4));
    assert_eq!(doubt(1e-4), doubt(1e-6));
    assert!((doubt(10.0) / (std::f64::consts::TAU * 1e-11) - 1.0).abs() < 1e-12);
    assert!((doubt_of_way(0.5, 0.1, 2.0, 4.0) / (std::f64::consts::TAU * 5.0) - 1.0).abs() < 1e-12);
}

/// A cycle with thousands of stops is accurate enough for the coarsest tolerance and for a fine one.
#[test]
fn far_below_one_a_motion_is_known() {
    for alpha in [1.7, 2.0, 32.0] {
        let size = loop_size_of_motion::<f64>(2e-4, alpha, 0.0).unwrap();
        assert!(size.most <= size.found * (1.0 + 1e-8), "{alpha}: {size:?}");
    }
}

/// The bound holds, and is nearly attained where friction hardly shortens the path.
#[test]
fn no_loop_between_two_frictions_exceeds_the_bound() {
    let loop_size = |omega: f64, share: f64| loop_size_of_motion(omega, 1.0 / share, 0.0).unwrap();
    let mut nearest = 0.0f64;
    for omega in [0.13, 0.22, 0.3, 0.4, 0.7, 1.3, 4.0] {
        for i in 1..25 {
            let low = 0.04 * f64::from(i);
            let at_low = loop_size(omega, low).most;
            for j in 1..=4 {
                let high = low * (1.0 + 0.2 * f64::from(j));
                let bound = bound_between(at_low, low, high);
                for k in 1..=4 {
                    let found = loop_size(omega, low + (high - low) * f64::from(k) / 4.0).found;
                    assert!(found <= bound * (1.0 + 1e-12), "{omega} {low} {high}: {found} > {bound}");
                    nearest = nearest.max(found / bound);
                }
            }
        }
    }
    assert!(nearest > 0.98, "{nearest}");
}

#[test]
fn none_of_all_is_better() {
    for omega in [0.05, 0.13, 0.22, 0.3, 0.4, 0.6, 0.7, 0.9, 1.3, 4.0] {
        let best = most_dissipating_force_ratio_of_all::<f64>(omega, 0.0, 1e-4).unwrap();
        assert!(best.bound >= best.value && best.bound <= best.value * 1.0001, "{best:?}");
        assert!(best.value >= best.non_sticking.value && best.motions < 3000, "{omega} {best:?}");
        let again = loop_size_of_motion(omega, best.at * (1.0 + 1e-14), 0.0).unwrap().found;
        assert!((again / best.value - 1.0).abs() < 1e-10, "{omega} {again} {best:?}");
        for i in 1..300 {
            let other = loop_size_of_motion(omega, 300.0 / f64::from(i), 0.0).unwrap().found;
            assert!(other <= best.bound, "{omega} {i} {other} {best:?}");
        }
        let answer = Response::new(Ratios::new(omega, best.at * (1.0 + 1e-14)).unwrap());
        assert_eq!(answer.cycle.as_ref().is_none(), best.kind == OptimumKind::Sticking, "{omega} {best:?}");
    }
}

/// With a damper, also at Ω = 1 and above critical damping, no other friction dissipates more.
#[test]
fn with_a_damper_none_of_all_is_better() {
    let mut optima = Vec::new();
    for (omega, zeta) in [(0.13, 0.02), (0.3, 0.05), (0.4, 0.3), (0.7, 0.02), (1.0, 0.05), (0.6, 1.2)] {
        let best = most_dissipating_force_ratio_of_all::<f64>(omega, zeta, 1e-4).unwrap();
        assert!(best.bound >= best.value && best.bound <= best.value * 1.0001, "{best:?}");
        let mut last = 0.0;
        for i in 1..300 {
            let share = f64::from(i) / 300.0;
            let other = loop_size_of_motion(omega, 1.0 / share, zeta).unwrap().found;
            assert!(other <= best.bound, "{omega} {zeta} {i} {other} {best:?}");
            // More friction, shorter path.
            assert!(i == 1 || other / share <= last * (1.0 + 1e-12), "{omega} {zeta} {i}");
            last = other / share;
        }
        let ratios = Ratios::new(omega, best.at * (1.0 + 1e-14)).unwrap();
        let answer = Response::new(ratios.with_damping_ratio(zeta).unwrap());
        assert_eq!(
            answer.cycle.as_ref().is_none(),
            best.kind == OptimumKind::Sticking,
            "{omega} {zeta} {best:?}"
        );
        optima.push(best.kind);
    }
    assert!(optima.contains(&OptimumKind::Sticking) && optima.contains(&OptimumKind::Interior), "{optima:?}");
}

/// The tolerance limits the bound only: the place is refined further.
#[test]
fn a_coarse_search_ends_at_the_same_place() {
    for omega in [0.13, 0.22, 0.3] {
        let at = |tolerance: f64| most_dissipating_force_ratio_of_all(omega, 0.0, tolerance).unwrap();
        let (coarse, fine) = (at(1e-2), at(1e-5));
        assert_eq!(fine.kind, OptimumKind::Sticking);
        assert!((coarse.at / fine.at - 1.0).abs() < 1e-6, "{coarse:?} {fine:?}");
    }
}

#[test]
fn the_slow_limit_and_which_one_it_is() {
    let slow = most_dissipating_force_ratio_of_all::<f64>(0.002, 0.0, 1e-3).unwrap();
    assert!((slow.at - 2.0).abs() < 0.05 && (slow.value - 2.0).abs() < 0.01, "{slow:?}");
    let optimum = |omega: f64| most_dissipating_force_ratio_of_all(omega, 0.0, 1e-3).unwrap().kind;
    assert_eq!(optimum(0.3), OptimumKind::Sticking);
    assert_eq!(optimum(1.5), OptimumKind::Interior);
    assert!(matches!(most_dissipating_force_ratio_of_all(1.0, 0.0, 1e-3), Err(Error::AtResonance { .. })));
    assert!(matches!(most_dissipating_force_ratio_of_all(0.7, 0.0, 1e-30), Err(Error::OutOfRange { .. })));
}

#[test]
fn in_physical_units() {
    let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
    let drive = Drive::force(12.0, 0.6).unwrap();
    let best = most_dissipating_friction_of_all::<f64>(&body, &drive, 1e-3).unwrap();
    let ratios = most_dissipating_force_ratio_of_all(0.3, 0.0, 1e-3).unwrap();
    let damped = body.with_damping_ratio(0.05).unwrap();
    let with_damper = most_dissipating_friction_of_all::<f64>(&damped, &drive, 1e-3).unwrap();
    let loop_size = most_dissipating_force_ratio_of_all(0.3, 0.05, 1e-3).unwrap().value;
    assert!((with_damper.value / (loop_size * 9.0) - 1.0).abs() < 1e-9 && with_damper.value < best.value);
    assert!((best.at * ratios.at / 12.0 - 1.0).abs() < 1e-6);
    assert!((best.value / (ratios.value * 9.0) - 1.0).abs() < 1e-9 && best.kind == OptimumKind::Sticking);
    assert!((best.bound / (ratios.bound * 9.0) - 1.0).abs() < 1e-3 && best.bound >= best.value);
}
