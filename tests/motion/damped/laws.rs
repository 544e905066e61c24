//! Laws of the motion with viscous damping: works, multipliers, digits, and one limit from every start.

use super::{from_rest, plane, ratios};
use crate::random::Random;
use std::f64::consts::TAU;
use stickslip::Border;
use stickslip::float::{Field, Float, Mp};
use stickslip::motion::{LongRun, State, Trajectory};

/// The works of random steady states: the greatest difference between the energy supplied and that taken by
/// friction and damper, in total and relative to the possible rounding.
fn works_are_off(points: u64, seed: u64) -> (f64, f64) {
    let mut random = Random(seed);
    let (mut of_all, mut of_rounding) = (0.0f64, 0.0f64);
    for _ in 0..points {
        let [omega, zeta, alpha] = plane(&mut random);
        let omega = omega.clamp(1e-2, 1e3);
        let steady = from_rest(ratios(omega, zeta, alpha));
        let out = steady.energy_out + steady.damper_work;
        let off = (steady.energy_in - out).abs();
        let rounding = 1e-13 * (1.0 + steady.max_displacement.value) * (1.0 + 1.0 / omega) * (1.0 + out);
        assert!(off <= rounding, "{omega} {zeta} {alpha}: {steady:?}");
        assert!(steady.damper_work > 0.0 && steady.energy_out > 0.0, "{omega} {zeta} {alpha}: {steady:?}");
        (of_all, of_rounding) = (of_all.max(off / out), of_rounding.max(off / rounding));
    }
    (of_all, of_rounding)
}
#[test]
fn works_balance() {
    let (of_all, of_rounding) = works_are_off(100_000, 7);
    assert!(of_all < 2e-11 && of_rounding < 0.125, "{of_all:e} {of_rounding}");
}
/// Multipliers from four motions close to the limit over a cycle: the greater error of the sum and of the
/// product.
fn multipliers_are_off((omega, zeta, alpha): (f64, f64, f64)) -> f64 {
    type Wide = Mp<4>;
    let h = Wide::exp2i(-80);
    let ratios = ratios(Wide::from(omega), Wide::from(zeta), Wide::from(alpha));
    let limit = LongRun::from_start(ratios, State::default()).unwrap();
    let steady = limit.steady_state().unwrap();
    let state = steady.state;
    let after = |dx: Wide, dv: Wide| {
        let start = State { x: state.x + dx, v: state.v + dv, ..state };
        let from = start.phase.half_turns() + 2;
        let end = stickslip::motion::DrivePhase::new(
            (from - state.phase.half_turns()) / 2,
            Wide::from(state.phase.half_turns() as f64) * Wide::pi() + state.phase.angle(),
        )
        .unwrap();
        let mut phases = Trajectory::new(ratios, start).unwrap().map(Result::unwrap);
        let last = phases.find(|p| p.end().is_none_or(|e| e.phase - end > Wide::int(0))).unwrap();
        let there = last.at(end).state;
        (there.x, there.v)
    };
    let zero = Wide::int(0);
    let column = |(a, b): (Wide, Wide), (c, d): (Wide, Wide)| ((a - c) / (h + h), (b - d) / (h + h));
    let (a, c) = column(after(h, zero), after(-h, zero));
    let (b, d) = column(after(zero, h), after(zero, -h));
    let [(r1, i1), (r2, i2)] = steady.multipliers;
    let (trace, product) = (r1 + r2, r1 * r2 - i1 * i2);
    let off = |found: Wide, exact: Wide| (found - exact).to_f64().abs();
    off(trace, a + d).max(off(product, a * d - b * c))
}
#[test]
fn multipliers_are_those_of_the_differenced_motion() {
    for at in [
        (0.7, 0.05, 2.4),
        (0.4, 0.05, 9.0),
        (1.0, 0.01, 3.0),
        (1.5, 1.0, 9.0),
        (0.8, 1.3, 14.0),
        (0.3, 0.1, 4.0),
    ] {
        let error = multipliers_are_off(at);
        assert!(error < 1e-22, "{at:?}: {error:e}");
    }
}
/// The same motion at 53 and at 256 bits, with sticking, below, at and above ζ = 1.
#[test]
fn digits_agree_at_any_precision() {
    let mut random = Random(71);
    for _ in 0..40 {
        let omega = random.between(0.1, 2.5);
        let zeta = [random.scale(1e-6, 0.9), 1.0, random.between(1.0, 5.0)][(random.next() * 3.0) as usize];
        let alpha = random.scale(1.1, 30.0);
        let narrow = from_rest(ratios(omega, zeta, alpha));
        let wide = from_rest(ratios(Mp::<4>::from(omega), Mp::from(zeta), Mp::from(alpha)));
        let size = narrow.max_displacement.value + narrow.max_velocity.value + 1.0;
        for (a, b) in [
            (narrow.max_displacement.value, wide.max_displacement.value),
            (narrow.max_velocity.value, wide.max_velocity.value),
            (narrow.energy_in, wide.energy_in),
            (narrow.damper_work, wide.damper_work),
            (narrow.stick_fraction, wide.stick_fraction),
        ] {
            let error = (Mp::<4>::from(a) - b).to_f64().abs();
            assert!(error < 1e-11 * size * size, "{omega} {zeta} {alpha}: {a} {b} {error:e}");
        }
        let balance = wide.energy_in - wide.energy_out - wide.damper_work;
        assert!(balance.to_f64().abs() < 1e-66 * size * size, "{omega} {zeta} {alpha}: {balance:e}");
        assert_eq!(narrow.sticks_per_cycle, wide.sticks_per_cycle);
    }
}
/// All starts have one limit, and a force no larger than friction leads to rest.
#[test]
fn every_start_has_the_same_limit() {
    let mut random = Random(81);
    for _ in 0..300 {
        let [omega, zeta, alpha] = plane(&mut random);
        let omega = omega.clamp(1e-3, 1e3);
        let far = State::new(
            random.between(0.0, TAU),
            random.between(-9.0, 9.0),
            random.between(-9.0, 9.0) / omega,
        )
        .unwrap();
        let found = LongRun::from_start(ratios(omega, zeta, alpha), far).unwrap();
        let (a, b) = (from_rest(ratios(omega, zeta, alpha)), found.steady_state().unwrap().to_owned());
        let off = a.distance.0 + b.distance.0 + (a.distance.1 + b.distance.1) * omega;
        let bound = 4.0 * off + 1e-13 * (1.0 + a.max_displacement.value);
        assert!(
            (a.max_displacement.value - b.max_displacement.value).abs() <= bound,
            "{omega} {zeta} {alpha}: {a:?} {b:?}"
        );
        // A fast drive hardly moves the body in a cycle, so that it need not settle within the budget.
        let ratios = ratios(omega.min(1.0), zeta, 0.7 + 0.25 * random.next());
        let small = LongRun::from_start(ratios, far).unwrap();
        assert!(matches!(small, LongRun::Rest(_)), "{omega} {zeta}: {small:?}");
    }
}
#[test]
fn multipliers_are_those_of_random_motions() {
    let mut random = Random(8);
    let mut worst = (0.0, (0.0, 0.0, 0.0));
    for _ in 0..2_000 {
        let (omega, zeta) = (random.scale(0.1, 10.0), random.scale(1e-3, 3.0));
        let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio.max(1.0);
        let at = (omega, zeta, least * random.scale(1.01, 10.0));
        let error = multipliers_are_off(at);
        worst = if error > worst.0 { (error, at) } else { worst };
    }
    assert!(worst.0 < 1e-44, "{worst:?}");
}
