//! A motion reported as lost is lost: checked by the limits of starts on either side, and by the multipliers.

use super::{Loss, SymmetryBreak, VariedForce, symmetry_breaks};
use crate::motion::attractors;
use crate::motion::machines::ratios;
use crate::motion::{Attractors, LongRun, State};
use crate::{Border, Ratios};

fn breaks(omega: f64, eta: f64, low: f64, high: f64) -> Vec<SymmetryBreak<f64>> {
    symmetry_breaks(ratios(omega, 0.02, eta, 2.0), low..=high, 40).unwrap()
}

/// The limits of some starts, including that of the given motion.
fn limits(ratios: Ratios<f64>, near: State<f64>) -> Attractors<f64> {
    let part = |i: u32, step: f64| 12.0 * (2.0 * (f64::from(i) * step).fract() - 1.0);
    let spread = (0..30).map(|i| State::new(0.0, part(i, 0.754_878), part(i, 0.569_841)).unwrap());
    let starts: Vec<_> = [near].into_iter().chain(spread).collect();
    attractors(ratios, &starts, 2000).unwrap()
}

/// The number of asymmetric limits, and whether there is a symmetric limit of one turn like the given motion.
fn seen(all: &Attractors<f64>, like: &SymmetryBreak<f64>) -> (bool, usize) {
    let (mut symmetric, mut others) = (false, 0);
    for limit in &all.limits {
        let LongRun::Periodic(s) = limit.limit else { continue };
        let near = (s.max_displacement.value - like.motion.max_displacement.value).abs() < 0.5;
        let shape = s.sticks_per_cycle == like.motion.sticks_per_cycle;
        symmetric |= s.is_symmetric && s.turns_per_cycle == 1 && near && shape;
        others += usize::from(!s.is_symmetric);
    }
    (symmetric, others)
}

/// At each break by a multiplier, λ = −1 is a multiplier of J: det(1 + J) vanishes and det(1 − J) does not.
/// On the stable side, starts lead to the symmetric motion; on the other, to a mirror pair.
#[test]
fn symmetry_breaks_at_a_multiplier_of_minus_one() {
    let mut count = 0;
    for (omega, eta, low, high, expected) in [
        (0.5, 1.3, 3.0, 5.0, [Some(3.514_173_764_104_8), Some(4.081_548_519_014)]),
        (0.55, 1.3, 2.5, 3.1, [Some(2.879_909_995_193_9), None]),
        (0.45, 2.0, 3.0, 8.0, [Some(4.077_035_601_203_7), Some(7.801_992_296_972)]),
        (0.3, 3.0, 5.5, 7.0, [Some(6.394_118_495_641_7), None]),
        (0.4, 3.0, 4.0, 5.0, [Some(4.550_569_999_589_8), None]),
    ] {
        let found = breaks(omega, eta, low, high);
        let expected: Vec<f64> = expected.into_iter().flatten().collect();
        assert_eq!(found.len(), expected.len(), "{omega} {eta}: {found:?}");
        for (one, expected) in found.iter().zip(expected) {
            assert!((one.alpha - expected).abs() < 1e-12 * 10.0 && one.loss == Loss::Multiplier, "{one:?}");
            let machine = VariedForce(ratios(omega, 0.02, eta, 2.0));
            let state = one.motion.state;
            let y = crate::motion::state::PhasePoint { phase: state.phase, x: state.x, w: state.v * omega };
            let there = machine.symmetric(one.alpha, y).unwrap().unwrap();
            let (trace, determinant) = (there.derivative.trace(), there.derivative.determinant());
            assert!(there.f().abs() < 1e-11 && 1.0 - trace + determinant > 1.9, "{one:?}");
            let to = if one.is_stable_above { 1.01 } else { 0.99 };
            let stable = limits(ratios(omega, 0.02, eta, one.alpha * to), state);
            let unstable = limits(ratios(omega, 0.02, eta, one.alpha * (2.0 - to)), state);
            // At its second break, (0.5, 1.3) has a stable interval narrower than this step.
            if omega != 0.5 || !one.is_stable_above {
                assert!(seen(&stable, one).0, "{one:?}: {stable:?}");
            }
            let (symmetric, pair) = seen(&unstable, one);
            assert!(!symmetric && pair >= 2, "{one:?}: {unstable:?}");
            count += 1;
        }
    }
    assert_eq!(count, 7);
}

/// Where the cycle without a stop ends, the loss agrees with the border of the closed forms.
#[test]
fn a_jump_is_the_border() {
    for (omega, eta, low, high) in [(0.55, 1.3, 2.9, 4.0), (0.55, 2.0, 4.0, 6.0), (0.6, 3.0, 5.0, 6.0)] {
        let border = Border::of(&ratios(omega, 0.02, eta, 2.0)).min_force_ratio;
        let found = breaks(omega, eta, low, high);
        let jump = found.iter().find(|one| one.loss == Loss::Jump && one.motion.sticks_per_cycle == 0);
        let jump = jump.unwrap_or_else(|| panic!("{found:?}"));
        assert!(jump.is_stable_above && (jump.alpha / border - 1.0).abs() < 1e-13, "{jump:?} {border}");
    }
}

/// Two symmetric motions meet at a multiplier of +1.
#[test]
fn a_fold_is_told_from_a_break() {
    let found = breaks(0.2, 3.0, 4.5, 5.0);
    let fold = found.iter().find(|one| one.loss == Loss::Fold).unwrap_or_else(|| panic!("{found:?}"));
    let [(largest, _), _] = fold.motion.multipliers;
    assert!((largest - 1.0).abs() < 1e-4 && (fold.alpha - 4.768_950_352_678).abs() < 1e-11, "{fold:?}");
}

/// With η = 1 no symmetric motion is lost, although stops appear and disappear.
#[test]
fn nothing_is_lost_with_equal_frictions() {
    for omega in [0.15, 0.3, 0.45, 0.7, 1.2] {
        let found = breaks(omega, 1.0, 1.1, 9.0);
        assert!(found.is_empty(), "{omega}: {found:?}");
    }
}

/// At ω_d t = 0 the body rests or begins to slide. (A speed of 5e-324 was once computed as a slide with other
/// multipliers, and the search never ended.)
#[test]
fn a_speed_next_to_nothing_is_rest() {
    let found = symmetry_breaks(ratios(0.164_705_882_352_941_17, 0.02, 2.0, 9.1), 3.1..=9.1, 32).unwrap();
    assert!(found.iter().all(|one| one.loss == Loss::Jump) && !found.is_empty(), "{found:?}");
}
