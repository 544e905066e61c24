use crate::cycle::Cycle;
use crate::cycle::phase_function::PhaseFunction;
use crate::motion::broken::Budget;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::limit::fixed_point::Trial;
use crate::motion::limit::long_run::LongRun;
use crate::motion::limit::propagation::HalfTurns;
use crate::motion::limit::section::fastest_point;
use crate::motion::limit::shooting::shoot;
use crate::motion::limit::steady::SteadyState;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::{Direction, Slide};
use crate::random::Random;
use crate::{Border, Ratios};

/// The steady state of a cycle, if it is validated.
fn validated(equation: Equation<f64>, cycle: &Cycle<f64>) -> Option<SteadyState<f64>> {
    super::validated(equation, (cycle.max_displacement, cycle.displacement_phase), Some(cycle)).ok()
}

/// The cycle at a multiple of the border, which need not be a possible motion.
fn cycle(omega: f64, times: f64) -> (Equation<f64>, Cycle<f64>) {
    let alpha = Border::new(omega).unwrap().min_force_ratio * times;
    let ratios = Ratios::new(omega, alpha).unwrap();
    (Equation::new(ratios), Cycle::at(&PhaseFunction::new(omega).unwrap(), ratios))
}

#[test]
fn it_is_what_newtons_method_finds() {
    let (mut found, mut all) = (0, 0);
    for i in 0..3000 {
        let omega = 0.13 * 1.0013f64.powi(i);
        let (equation, cycle) = cycle(omega, 1.0 + 0.003 * f64::from(1 + i % 97));
        all += 1;
        let Some(here) = validated(equation, &cycle) else { continue };
        found += 1;
        let (section, hint) = fastest_point(equation, &cycle);
        let there = shoot(equation, section, hint, || Ok(None), &mut Budget::of(100)).unwrap();
        let LongRun::Periodic(there) = there else { panic!("Ω = {omega}") };
        let size = 1.0 + cycle.max_displacement;
        let close = |a: f64, b: f64, units: f64| {
            assert!((a - b).abs() <= units * f64::EPSILON, "Ω = {omega}: {a} {b} {here:?} {there:?}");
        };
        let apart = |d: (f64, f64), e: (f64, f64)| (d.0 + d.1 + e.0 + e.1) / f64::EPSILON;
        let units = apart(here.distance, there.distance) + 8.0 * size;
        close(here.max_displacement.value, there.max_displacement.value, units);
        close(here.min_displacement.value, there.min_displacement.value, units);
        close(here.max_velocity.value, there.max_velocity.value, units);
        close(here.min_velocity.value, there.min_velocity.value, units);
        close(here.energy_out, there.energy_out, 4.0 * units);
        close(here.energy_in, there.energy_in, 4.0 * units * (1.0 + equation.alpha));
        for (a, b) in [
            (here.max_displacement.phase.reduced(), there.max_displacement.phase.reduced()),
            (here.min_displacement.phase.reduced(), there.min_displacement.phase.reduced()),
            (here.max_velocity.phase.reduced(), there.max_velocity.phase.reduced()),
            (here.min_velocity.phase.reduced(), there.min_velocity.phase.reduced()),
        ] {
            close((a - b).sin(), 0.0, 8.0 + omega * units);
        }
        assert_eq!((here.sticks_per_cycle, here.velocity_zeros_per_cycle), (0, 2));
        assert_eq!((there.sticks_per_cycle, there.velocity_zeros_per_cycle), (0, 2));
        for ((a, b), (c, d)) in here.multipliers.into_iter().zip(there.multipliers) {
            assert!((a - c).abs() < 1e-9 && (b - d).abs() < 1e-6, "Ω = {omega}: {here:?} {there:?}");
        }
    }
    assert!(found * 10 > all * 9, "{found} of {all}");
}

/// If the cycle of a slightly different force and phase is validated, the motion returns to its beginning.
#[test]
fn what_is_confirmed_comes_back() {
    let (mut found, mut all) = (0, 0);
    let mut generator = Random(7);
    let mut random = || generator.next();
    for i in 0..20_000 {
        let omega = 0.13 * 1.0002f64.powi(i);
        let (equation, cycle) = cycle(omega, 1.0 + 0.003 * f64::from(1 + i % 97));
        let mut off = || (2.0 * random() - 1.0) * 2f64.powf(-52.0 + 14.0 * random());
        let (a, b) = (off(), off());
        let ratios = Ratios::new(omega, equation.alpha * (1.0 + a)).unwrap();
        let other = Cycle::at(&PhaseFunction::new(omega).unwrap(), ratios);
        let phase = other.displacement_phase;
        let other = other.map(|x| if x == phase { x + b } else { x });
        all += 1;
        let Some(here) = validated(equation, &other) else { continue };
        found += 1;
        let (_, hint) = fastest_point(equation, &cycle);
        let left = Trial::of(HalfTurns::new(equation, here.start, 1, hint, &mut Budget::of(0)).unwrap()).left;
        assert!(left.is_rounding(4), "Ω = {omega}, {a:e}, {b:e}: {left:?}");
    }
    assert!(found > all / 20 && found < all / 2, "{found} of {all}");
}

/// A cycle whose stated fastest point is not the fastest is rejected.
#[test]
fn the_fastest_point_has_to_be_one() {
    for i in 0..300 {
        let omega = 0.13 * 1.013f64.powi(i);
        let (equation, cycle) = cycle(omega, 1.3);
        let moved = |by: f64| {
            let other = |x| if x == cycle.velocity_phase { x + by } else { x };
            validated(equation, &cycle.map(other)).is_some()
        };
        assert!(!moved(1e-2) && !moved(-1e-2) && !moved(1e-4) && !moved(3.1), "Ω = {omega}");
    }
}

#[test]
fn a_great_force_is_confirmed_too() {
    let mut found = 0;
    for i in 0..200 {
        let (equation, cycle) = cycle(0.51 * 1.01f64.powi(i), 2f64.powi(i % 20));
        found += i32::from(validated(equation, &cycle).is_some());
    }
    assert!(found > 160, "{found}");
}

/// Most cycles need no search for velocity zeros.
#[test]
fn the_signs_alone_mostly_do() {
    let (mut found, mut all) = (0, 0);
    for i in 0..4000 {
        let omega = 0.51 * 1.001f64.powi(i);
        let (equation, cycle) = cycle(omega, 1.0 + 0.003 * f64::from(1 + i % 97));
        let least =
            DrivePhase::of_half_turn(0, 0.0).advanced(cycle.displacement_phase).later_by_half_turns(-1);
        let slide = Slide::new(equation, least, -cycle.max_displacement, 0.0, Direction::Forward);
        all += 1;
        found += i32::from(slide.does_not_turn_before(std::f64::consts::PI / omega));
    }
    assert!(found * 100 > all * 95, "{found} of {all}");
}

/// For slides of any phase that end at rest after half a turn, the signs never hide a velocity zero.
#[test]
fn the_signs_hide_no_velocity_zero() {
    let (mut shown, mut turning) = (0, 0);
    for i in 0..40_000 {
        let part = |step: f64| (f64::from(i) * step).fract();
        let (omega, alpha) = (2f64.powf(-4.0 + 5.0 * part(0.618_034)), 1.0 + 20.0 * part(0.754_878));
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let start = DrivePhase::of(std::f64::consts::TAU * part(0.569_841)).unwrap();
        let end = std::f64::consts::PI / omega;
        // The velocity is linear in the starting place of the slide.
        let from = |x| Slide::new(equation, start, x, 0.0, Direction::Forward);
        let (zero, one) = (from(0.0).motion(end).w, from(1.0).motion(end).w);
        let slide = from(zero / (zero - one));
        if !(slide.acceleration > 1e-6 && slide.x.abs() < 1e3) {
            continue;
        }
        let least =
            (1..200).map(|n| slide.motion(end * f64::from(n) / 200.0).w).fold(f64::INFINITY, f64::min);
        let shows = slide.does_not_turn_before(end);
        assert!(!shows || least > -1e-9, "Ω = {omega}, α = {alpha}: {least} of {slide:?}");
        shown += i32::from(shows);
        turning += i32::from(least < -1e-9);
    }
    assert!(shown > 2000 && turning > 4000, "{shown} {turning}");
}

#[test]
fn below_the_border_nothing_is_confirmed() {
    for i in 0..6000 {
        let omega = 0.021 * 1.0013f64.powi(i);
        let border = Border::new(omega).unwrap().min_force_ratio;
        // From the border down to the least force with a cycle, or nearly so.
        let below = [1e-6, 1e-3, 0.3, 0.9][i as usize % 4] * f64::from(1 + i % 97) / 97.0;
        let least = PhaseFunction::new(omega).unwrap().value().abs() * (1.0 + 1e-9);
        let alpha = border * (1.0 - below);
        if alpha < least {
            continue;
        }
        let (equation, cycle) = cycle(omega, 1.0 - below);
        assert_eq!(validated(equation, &cycle), None, "Ω = {omega}, 1 − {below} times the border");
    }
}
