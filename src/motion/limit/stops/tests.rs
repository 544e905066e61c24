use super::{Sticking, fixed_point};
use crate::Ratios;
use crate::motion::broken::Budget;
use crate::motion::limit::propagation::MotionPart;
use crate::motion::limit::shooting::shoot;
use crate::motion::slide::equation::Equation;
use crate::motion::state::State;
use crate::motion::trajectory::{Body, Trajectory};
use crate::motion::{LongRun, SteadyState};

/// The i-th (Ω, α, ζ) of a sequence that fills the space evenly: Ω from 0.04 to 3, α up to twice the minimum
/// for cycles without stops, with damping in every second one.
fn ratios(i: u32) -> Ratios<f64> {
    let spread = |step: f64| (f64::from(i) * step).fract();
    let omega = 0.04 * 75f64.powf(spread(0.618_034));
    let zeta = if i.is_multiple_of(2) { 0.0 } else { 10f64.powf(-4.0 + 4.5 * spread(0.437_016)) };
    let most = (2.0 / (omega * omega)).clamp(1.5, 40.0);
    Ratios::new(omega, 1.0 + most * spread(0.754_878).powi(2) + 1e-3)
        .unwrap()
        .with_damping_ratio(zeta)
        .unwrap()
}

/// The limit by shooting, which does not use the map from stop to stop.
fn by_shooting(ratios: Ratios<f64>) -> Option<SteadyState<f64>> {
    let equation = Equation::new(ratios);
    let mut slides =
        Trajectory::new(ratios, State::default()).unwrap().filter_map(|phase| match phase.unwrap().body {
            Body::Slide(slide, end) => Some((slide, end.phi)),
            Body::Stick(_) => None,
        });
    let (slide, length) = slides.nth(2)?;
    let start = slide.point(length / 2.0);
    let found = shoot(equation, start, length / 2.0, || Ok(None), &mut Budget::of(40_000)).unwrap();
    found.steady_state().copied()
}

#[test]
fn it_is_what_shooting_finds() {
    let (mut below, mut found, mut half_turns) = (0u32, 0u32, 0);
    for i in 1..COMPARED {
        let ratios = ratios(i);
        let sticking = Sticking::new(Equation::new(ratios));
        if !sticking.is_below {
            continue;
        }
        below += 1;
        let mut budget = Budget::of(1000);
        let Some(limit) = sticking.limit(&mut budget).unwrap() else { continue };
        found += 1;
        half_turns += budget.half_turns;
        let here = *limit.steady_state().unwrap();
        let there = by_shooting(ratios).unwrap();
        let size = 1.0 + ratios.alpha();
        let units = |s: &SteadyState<f64>| s.distance.0 + s.distance.1 * ratios.omega();
        let room = units(&here) + units(&there) + 16.0 * f64::EPSILON * size;
        let close = |what: &str, a: f64, b: f64, times: f64| {
            assert!((a - b).abs() <= times * room, "{what} {a} {b} at {ratios:?}\n{here:?}\n{there:?}");
        };
        close("max", here.max_displacement.value, there.max_displacement.value, 1.0);
        close("min", here.min_displacement.value, there.min_displacement.value, 1.0);
        close("fastest", here.max_velocity.value, there.max_velocity.value, 2.0 / ratios.omega());
        close("slowest", here.min_velocity.value, there.min_velocity.value, 2.0 / ratios.omega());
        close("out", here.energy_out, there.energy_out, 8.0 * f64::from(here.velocity_zeros_per_cycle));
        close(
            "in",
            here.energy_in,
            here.energy_out + here.damper_work,
            40.0 * size * (1.0 + 1.0 / ratios.omega()),
        );
        assert_eq!(
            (here.sticks_per_cycle, here.velocity_zeros_per_cycle),
            (there.sticks_per_cycle, there.velocity_zeros_per_cycle),
            "{ratios:?}\n{here:?}\n{there:?}"
        );
        assert!((here.stick_fraction - there.stick_fraction).abs() < 1e-6, "{ratios:?}\n{here:?}\n{there:?}");
        assert!((here.contraction() - there.contraction()).abs() < 1e-6, "{ratios:?}\n{here:?}\n{there:?}");
    }
    // The share is 0.955, at 4.3 half turns each.
    assert!(
        found * 100 > below * 94 && half_turns * 2 < u64::from(found) * 9,
        "{found} of {below}: {half_turns}"
    );
}

/// During the search, passages may end at their predicted times without proof, but the last one is proved
/// slide by slide.
#[test]
fn what_is_found_is_proved() {
    let (mut found, mut unproved) = (0, 0);
    for i in 1..COMPARED / 4 {
        let equation = Equation::new(ratios(i));
        let sticking = Sticking::new(equation);
        let mut budget = Budget::of(1000);
        let others = sticking.other_guesses();
        let Some(passage) = fixed_point(equation, sticking.guess(), others, &mut budget).unwrap() else {
            continue;
        };
        found += 1;
        unproved += u32::from(!passage.is_proved);
        // The zeros are found again without a prediction.
        for part in &passage.parts {
            let MotionPart::Slide(slide, zero) = part else { continue };
            let again = slide
                .velocity_zero(std::f64::consts::PI / equation.omega)
                .unwrap_or_else(|_| panic!("{slide:?}"));
            assert!((again.phi - zero.phi).abs() <= 1e-7 * zero.phi, "{equation:?}: {zero:?} {again:?}");
        }
    }
    assert!(found > 300 && unproved == 0, "{unproved} of {found}");
}

/// The maximum displacement from an independent solution: one slide per half turn, with two equations for its
/// length and end, at 40 digits.
#[test]
fn the_extremum_is_right_to_the_last_places() {
    for (omega, alpha, zeta, extremum) in [
        (0.7, 1.2, 0.0, 1.417_437_097_687_595),
        (0.9, 1.1, 0.0, 0.038_266_189_033_931_33),
        (0.7, 1.2, 0.05, 0.815_561_839_381_345_5),
        (0.4, 6.0, 0.05, 6.641_909_108_352_287),
        (0.15, 3.0, 0.05, 2.187_011_901_488_627_3),
        (0.9, 1.1, 0.05, 0.034_491_489_450_711_545),
    ] {
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let found = limit.steady_state().unwrap().max_displacement.value;
        assert!(
            (found / extremum - 1.0f64).abs() < 12.0 * f64::EPSILON,
            "({omega}, {alpha}, {zeta}): {found}"
        );
    }
}

/// The motion is the same to the last bit from any start, because the search does not use the start.
#[test]
fn the_start_does_not_count() {
    for (omega, alpha, zeta) in [(0.7, 1.2, 0.0), (0.4, 6.0, 0.0), (0.15, 3.0, 0.05), (0.9, 1.1, 0.05)] {
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let from = |theta: f64, x, v| LongRun::from_start(ratios, State::new(theta, x, v).unwrap()).unwrap();
        let rest = from(0.0, 0.0, 0.0);
        assert!(rest == from(0.3, 2.0, -1.0) && rest == from(5.0, -1e6, 3.0), "({omega}, {alpha}, {zeta})");
    }
}

const COMPARED: u32 = 4000;
