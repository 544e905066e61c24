use super::VelocityZero;
use crate::cycle::equations::{displacement_phase, max_displacement};
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::next_zero;
use crate::motion::event::search::{FoundZero, Verdict};
use crate::motion::slide::equation::Equation;
use crate::motion::slide::{Direction, Slide};
use crate::motion::{Kind, State, Trajectory};
use crate::{Border, Ratios};
use std::cell::Cell;
use std::f64::consts::PI;

/// The end of the rising half of the closed-form cycle at (Ω, α), which need not be a possible motion.
fn end_of_rise(omega: f64, alpha: f64) -> VelocityZero<f64> {
    let k = PhaseFunction::new(omega).unwrap().value();
    let delta = max_displacement(k, alpha, one_minus_square(omega));
    let start = DrivePhase::of(displacement_phase(k, alpha, omega) - PI).unwrap();
    let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
    let slide = Slide::new(equation, start, -delta, 0.0, Direction::Forward);
    slide.velocity_zero(PI / omega).unwrap()
}

#[test]
fn on_the_border_the_velocity_touches_zero_where_the_border_says() {
    for omega in [0.35, 0.4, 0.45, 0.3, 0.22] {
        let border = Border::new(omega).unwrap();
        let least = border.min_force_ratio;
        // τ* is counted from t₂ in the falling half; the same place in the rising half is half a period away.
        let touch = border.border_phase / omega;
        let above = end_of_rise(omega, least * (1.0 + 1e-9));
        assert!(!above.grazes && (above.phi - PI / omega).abs() < 1e-9, "Ω = {omega}: {above:?}");
        let below = end_of_rise(omega, least * (1.0 - 1e-9));
        assert!(!below.grazes && (below.phi - touch).abs() < 1e-3, "Ω = {omega}: {touch} {below:?}");
        // The velocity grazes zero, to within rounding.
        let close = (-40..=40).map(|i| end_of_rise(omega, least * (1.0 + f64::from(i) * 2e-16)));
        let grazing: Vec<_> = close.filter(|end| end.grazes).collect();
        assert!(!grazing.is_empty(), "Ω = {omega}");
        for end in grazing {
            assert!((end.phi - touch).abs() < 1e-6, "Ω = {omega}: {touch} {end:?}");
        }
    }
}

/// The motion a short step later agrees with Taylor's series up to the order of the omitted terms.
#[test]
fn a_short_step_on_is_the_motion() {
    let equation = Equation::new(Ratios::new(0.7, 2.5).unwrap());
    let slide = Slide::new(equation, DrivePhase::of(0.3).unwrap(), -0.4, 1.1, Direction::Forward);
    for (at, step) in [(0.4, 2e-3), (1.3, -2e-3), (2.1, 1e-3)] {
        let found = FoundZero { at, step, motion: slide.motion(at), grazes: false };
        let (zero, exact) = (slide.arrival(&found), slide.motion(at + step));
        let is = |a: f64, b: f64| assert!((a - b).abs() < 4e-11, "{at}: {a} {b}");
        is(zero.phi, at + step);
        is(zero.phase.since(slide.start), 0.7 * (at + step));
        is(zero.x, exact.x);
        is(zero.acceleration, exact.acceleration);
        assert!((zero.jerk - exact.jerk).abs() < 1e-5);
        is(zero.rotation.0, exact.rotation.0);
        is(zero.rotation.1, exact.rotation.1);
    }
    let noise = 4.0 * f64::EPSILON;
    let search = slide.velocity_search(1.0, None);
    assert_eq!(search.noise, noise * slide.velocity_scale());
    assert!(!search.from_zero);
    for (w, direction) in [(0.0, Direction::Forward), (0.0, Direction::Backward), (-1e-9, Direction::Forward)]
    {
        let slide = Slide::new(equation, slide.start, -0.4, w, direction);
        assert!(slide.velocity_search(1.0, None).from_zero, "{w} {direction:?}");
    }
    assert_eq!(search.short_noise, Some(slide.short_velocity_scale().map(|term| noise * term)));
}

#[test]
fn the_work_is_bounded() {
    // A pseudo-random number in [0, 1) from two counters.
    let spread = |i: u32, j: u32| {
        (f64::from(i) * 0.618_033_988_749_895 + f64::from(j) * 0.414_213_562_373_095).fract()
    };
    let slides = 40_000;
    // The greatest and the total number of evaluations: with half a period of the drive as the hint, and with
    // a hint that is accurate to one percent.
    let (mut most, mut sum, mut sum_hinted) = (0, 0, 0);
    for i in 0..slides {
        let omega = 10f64.powf(6.0 * spread(i, 0) - 3.0);
        let alpha = 1.0 + 10f64.powf(4.0 * spread(i, i / 7) - 2.0);
        let theta = 7.0 * spread(i / 3, i);
        let reach = 2.0 * (1.0 + alpha) / (1.0 + omega);
        let (x, w) = (reach * (spread(i / 5, i) - 0.5), reach * spread(i, i / 11));
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let start = DrivePhase::of(theta).unwrap();
        let slide = Slide::new(equation, start, x, w, Direction::Forward);
        let found = |hint: f64| {
            let evaluations = Cell::new(0);
            let verdict = next_zero(
                &slide.velocity_search(hint, None),
                slide.motion_at_start().velocity_jet(&equation, 1.0),
                |phi| {
                    evaluations.set(evaluations.get() + 1);
                    let m = slide.motion(phi);
                    (m.velocity_jet(&equation, 1.0), m)
                },
            );
            let Verdict::Zero(zero) = verdict else { panic!("Ω = {omega}: {slide:?}") };
            (zero.at + zero.step, evaluations.get())
        };
        let (zero, evaluations) = found(PI / omega);
        let hinted = found(zero * 1.01).1;
        most = most.max(evaluations).max(hinted);
        (sum, sum_hinted) = (sum + evaluations, sum_hinted + hinted);
    }
    // The means are 3.74 and 2.35 per slide; a useless guess, hint or jump increases them.
    assert!(most <= 14, "{most}");
    assert!(sum <= 150_300 && sum_hinted <= 94_400, "{sum} {sum_hinted}");
}

/// Over the whole range of Ω, with a free wave of any size in addition to the forced one: windows without
/// zeros are skipped.
#[test]
fn the_work_is_bounded_at_any_frequency() {
    let spread = |i: u32, step: f64| (f64::from(i) * step).fract();
    let (mut most, mut sum, slides) = (0, 0, 20_000);
    for i in 0..slides {
        let omega = 2f64.powf(40.0 * spread(i, 0.618_034) - 20.0);
        let alpha = 1.0 + 10f64.powf(3.0 * spread(i, 0.754_878) - 2.0);
        let theta = 2.0 * PI * spread(i, 0.569_841);
        let forced = alpha / ((1.0 - omega) * (1.0 + omega));
        let free = forced.abs() * omega * 10f64.powf(6.0 * spread(i, 0.437_016) - 3.0);
        let (sine, cosine) = (2.0 * PI * spread(i, 0.324_718)).sin_cos();
        let w = forced * omega * theta.cos() + free * cosine;
        let (direction, x) = (Direction::of(w), forced * theta.sin() + free * sine);
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let x = x - direction.sign::<f64>();
        let slide = Slide::new(equation, DrivePhase::of(theta).unwrap(), x, w, direction);
        let evaluations = Cell::new(0);
        let f = slide.velocity();
        let verdict = next_zero(&slide.velocity_search(PI / omega, None), slide.velocity_at_start(), |phi| {
            evaluations.set(evaluations.get() + 1);
            f(phi)
        });
        assert!(matches!(verdict, Verdict::Zero(_)), "Ω = {omega}: {slide:?}");
        (most, sum) = (most.max(evaluations.get()), sum + evaluations.get());
    }
    assert!(most <= 24 && sum <= 7 * slides, "{most} {sum}");
}

/// The drive is so weak that its share of the velocity rounds to zero; the windows are then half periods of
/// the free wave.
#[test]
fn a_drive_that_cannot_be_seen_costs_nothing() {
    for (omega, alpha, x) in [(2f64.powi(20), 1e-150, 1e290), (1e5, 1e-140, 1e200), (3e3, 1e-150, 7e290)] {
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let start = DrivePhase::of(0.3).unwrap();
        let slide = Slide::new(equation, start, -x, 0.0, Direction::Forward);
        let evaluations = Cell::new(0);
        let f = slide.velocity();
        let search = slide.velocity_search(PI / omega, None);
        let verdict = next_zero(&search, slide.velocity_at_start(), |phi| {
            evaluations.set(evaluations.get() + 1);
            f(phi)
        });
        let Verdict::Zero(zero) = verdict else { panic!("Ω = {omega}: {slide:?}") };
        assert!((zero.at + zero.step - PI).abs() < 1e-9, "Ω = {omega}: {} {}", zero.at, zero.step);
        assert!(evaluations.get() < 64, "Ω = {omega}: {}", evaluations.get());
    }
}

/// A force of subnormal size is none beside the friction: the body turns and rests where it does under another that is none.
#[test]
fn a_subnormal_drive_moves_no_turn() {
    for (zeta, phase) in
        [(0.999_999_992_549_419_4, 1.888_937_940_739_511), (0.9, 3.0), (0.3, 5.0), (1.5, 2.0)]
    {
        let of = |alpha: f64| {
            let ratios = Ratios::new(2.543_105_640_608_311e-5, alpha).unwrap();
            let ratios = ratios.with_damping_ratio(zeta).unwrap();
            let start = State::new(phase, -14.702_321_287_408_08, -17.870_169_125_467_115).unwrap();
            let slides = Trajectory::new(ratios, start).unwrap().take(3);
            slides
                .map(|slide| slide.map(|slide| (slide.kind, slide.start().x)))
                .collect::<Result<Vec<_>, _>>()
        };
        let due = of(1e-280).unwrap();
        for alpha in [5e-324, 2.1059e-319, 1e-310, 1e-300] {
            assert_eq!(of(alpha).unwrap(), due, "{zeta} {phase} {alpha:e}");
        }
    }
}

#[test]
fn the_error_names_the_slide() {
    let equation = Equation::new(Ratios::new(0.7, 2.5).unwrap());
    let slide = Slide::new(equation, DrivePhase::of(7.5).unwrap(), -0.4, 1.1, Direction::Forward);
    let message = crate::Error::from(slide.lost("the velocity zero")).to_string();
    let start =
        "the velocity zero from phase ω_d t = 7.5 on at Ω = 0.7, α = 2.5 must be found within π(1 + 2/Ω)";
    assert!(message.starts_with(start), "{message}");
}

#[test]
fn a_wrong_hint_changes_nothing() {
    for (omega, alpha, theta, x, w) in [
        (0.3, 5.0, 0.2, -1.0, 3.0),
        (0.8, 2.0, 1.0, 0.5, 4.0),
        (1.4, 3.0, -0.5, 0.1, 2.0),
        (20.0, 9.0, 0.3, 0.0, 0.7),
    ] {
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let start = DrivePhase::of(theta).unwrap();
        let slide = Slide::new(equation, start, x, w, Direction::Forward);
        let right = slide.velocity_zero(0.0).unwrap();
        for i in 1..100 {
            let end = slide.velocity_zero(f64::from(i) * 0.11).unwrap();
            assert!((end.phi - right.phi).abs() < 1e-13 * (1.0 + omega), "Ω = {omega}: {end:?} {right:?}");
            assert!((end.x - right.x).abs() < 1e-13);
        }
    }
}

/// Close to critical damping a creep from rest under a weak force lasts for hundreds of radians; the search
/// follows it to its end.
#[test]
fn a_creep_from_rest_ends() {
    let mut slides = 0;
    for zeta in [0.5, 0.7, 0.9, 0.93, 0.9375, 0.95, 0.99, 1.0 - 1e-6, 1.0 - 1e-14, 1.0, 1.1] {
        for omega in [0.25, 0.4, 1.0, 1.5, 2.0] {
            for alpha in [1e-300, 1e-30, 1e-9, 0.1, 0.9] {
                for excess in [1e-14, 1e-9, 1e-3, 1.0, 10.0] {
                    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
                    let start = State::new(0.0, -1.0 - alpha - excess, 0.0).unwrap();
                    for segment in Trajectory::new(ratios, start).unwrap().take(9) {
                        let segment = segment.unwrap();
                        slides += usize::from(segment.kind != Kind::Stick);
                    }
                }
            }
        }
    }
    assert!(slides > 1000, "{slides}");
}
