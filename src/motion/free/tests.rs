use super::FreeDecay;
use crate::motion::Trajectory;
use crate::motion::{End, Kind};

#[test]
fn the_closed_form_and_the_machinery_agree() {
    let starts: [(f64, f64); 11] = [
        (12.0, 6.0),
        (0.3, 0.0),
        (-0.3, 0.2),
        (5.5, -2.0),
        (-40.0, 17.0),
        (1.0, 0.0),
        (3.0, 0.0),
        (-2.5, 0.0),
        (1.5, 0.0),
        (-1.01, 0.0),
        (2.0, 0.0),
    ];
    for (x, v) in starts {
        let decay = FreeDecay::new(x, v, 0.0, 1.0).unwrap();
        let phases: Vec<_> = Trajectory::from(decay).map(Result::unwrap).collect();
        let slides = phases.iter().filter(|p| p.kind != Kind::Stick).count() as u64;
        let last = phases.last().unwrap();
        assert_eq!(slides, decay.half_cycles, "({x}, {v})");
        assert_eq!(last.ends_by, End::Never);
        let size = 1.0f64 + x.abs() + v.abs();
        assert!((last.start().x - decay.rest_position).abs() < 4e-16 * size * (1 + slides) as f64);
        let time = last.start().phase.since(phases[0].start().phase);
        assert!((time - decay.rest_time).abs() < 1e-15 * (4.0 + 4.0 * slides as f64), "({x}, {v})");
    }
}

/// With a damper: turns, place and time of rest agree with the motion computed slide by slide.
#[test]
fn closed_form_and_machinery_agree_with_damping() {
    for zeta in [1e-12f64, 1e-5, 0.01, 0.2, 0.7, 0.95, 1.0, 1.3, 5.0] {
        for (x, v) in [
            (12.0f64, 6.0f64),
            (0.3, 0.0),
            (-0.3, 0.2),
            (5.5, -2.0),
            (-40.0, 17.0),
            (3.0, 0.0),
            (-2.5, 0.0),
            (900.0, 1.0),
        ] {
            let decay = FreeDecay::new(x, v, zeta, 1.0).unwrap();
            let phases: Vec<_> = Trajectory::from(decay).map(Result::unwrap).collect();
            let slides = phases.iter().filter(|p| p.kind != Kind::Stick).count() as u64;
            let last = phases.last().unwrap();
            assert_eq!(slides, decay.half_cycles, "({x}, {v}) ζ = {zeta}: {phases:?}");
            assert_eq!(last.ends_by, End::Never);
            let error = (last.start().x - decay.rest_position).abs();
            let size = (1.0 + x.abs() + v.abs()) * (2 + slides) as f64;
            assert!(error < 4e-15 * size, "({x}, {v}) ζ = {zeta}: {error:e} {decay:?}");
            let time = last.start().phase.since(phases[0].start().phase);
            let rest = decay.rest_time;
            let late = (time - rest).abs() < 1e-14 * size * (1.0 + rest);
            assert!(if rest.is_finite() { late } else { time > 3.0 }, "({x}, {v}) ζ = {zeta}: {time} {rest}");
        }
    }
}

/// Closed form and machinery also agree with a static friction above the kinetic one, where
/// the body rests farther out.
#[test]
fn closed_form_and_machinery_agree_with_static_friction() {
    for (x, v) in [(12.0f64, 6.0f64), (0.3, 0.0), (5.5, -2.0), (-40.0, 17.0), (1.2, 0.0), (2.4, 0.0)] {
        for zeta in [0.0f64, 0.01, 0.2] {
            for eta in [1.0f64, 1.3, 2.5, 7.0] {
                let decay = FreeDecay::new(x, v, zeta, eta).unwrap();
                let phases: Vec<_> = Trajectory::from(decay).map(Result::unwrap).collect();
                let slides = phases.iter().filter(|p| p.kind != Kind::Stick).count() as u64;
                let last = phases.last().unwrap();
                assert_eq!(slides, decay.half_cycles, "({x}, {v}) ζ = {zeta}, η = {eta}");
                assert_eq!(last.ends_by, End::Never);
                let error = (last.start().x - decay.rest_position).abs();
                assert!(error < 1e-13 * (1.0 + x.abs() + v.abs()), "({x}, {v}) {zeta} {eta}: {error:e}");
                assert!(decay.rest_position.abs() <= eta);
            }
        }
    }
    let message = |eta| FreeDecay::new(1.0, 0.0, 0.0, eta).unwrap_err().to_string();
    assert!(message(0.9).starts_with("static friction ratio η = 0.9 must be ≥ 1"));
}

/// With viscous damping and negligible friction (far out), the logarithmic decrement is the textbook's.
#[test]
fn far_out_the_decrement_is_the_viscous_one() {
    let (zeta, x) = (0.1f64, 1e9);
    let ratio = (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
    let decay = FreeDecay::new(x, 0.0, zeta, 1.0).unwrap();
    let turns = decay.half_cycles as f64;
    // At rest κⁿx is coth(ζπ/2d) + 1 or slightly less.
    let last = x * ratio.powf(turns);
    assert!(last < 1.0 + (1.0 + ratio) / (1.0 - ratio) && last * 1.0 > ratio, "{last} {turns}");
}

#[test]
fn the_textbook_case() {
    // m = k = r_y = 1, x₀ = 12, v₀ = 6
    let decay = FreeDecay::new(12.0f64, 6.0, 0.0, 1.0).unwrap();
    assert_eq!(decay.half_cycles, 8);
    assert!((decay.rest_position - 0.682_178_936_723_647).abs() < 1e-14);
}

/// From a place between B and 2B, the spring overcomes friction once, and the body stops on the other side.
#[test]
fn a_start_just_beyond_the_friction_bound_slides_once() {
    for (x, rest) in
        [(1.5, 0.5), (-1.5, -0.5), (1.01, 0.99), (2.0, 0.0), (-2.0, 0.0), (2.5, -0.5), (-3.0, 1.0)]
    {
        let decay = FreeDecay::new(x, 0.0f64, 0.0, 1.0).unwrap();
        assert_eq!((decay.half_cycles, decay.rest_time), (1, std::f64::consts::PI), "{x}");
        let found = decay.rest_position;
        assert!((found - rest).abs() < 1e-15 && found.signum() == rest.signum(), "{x}: {found}");
    }
    for x in [1.0, -1.0, 0.999, 0.0] {
        let decay = FreeDecay::new(x, 0.0f64, 0.0, 1.0).unwrap();
        assert_eq!((decay.half_cycles, decay.rest_position, decay.rest_time), (0, x, 0.0));
    }
}

#[test]
fn bad_starts_are_named() {
    let message = |x: f64, v: f64| FreeDecay::new(x, v, 0.0, 1.0).unwrap_err().to_string();
    let damped = FreeDecay::new(1.0, 0.0, -0.5, 1.0).unwrap_err().to_string();
    assert_eq!(damped, "damping ratio ζ = -0.5 must be ≥ 0");
    assert_eq!(message(f64::NAN, 0.0), "displacement x/B = NaN must be finite");
    assert_eq!(message(0.0, f64::INFINITY), "velocity v = inf must be finite");
}

/// A logarithm that is rounded to one half cycle too few or too many is corrected.
#[test]
fn a_count_beside_a_whole_number_is_corrected() {
    for zeta in [1e-6, 0.01, 0.3] {
        for x in [3.7, 12.4, 55.0] {
            let decay = FreeDecay::new(x, 0.0, zeta, 1.0).unwrap();
            for n in 1..=decay.half_cycles {
                // From the displacement that n half cycles bring exactly to the bound.
                let edge = x - (decay.left_after(n as f64) - 1.0) / (-(n as f64) * decay.decrement()).exp();
                if edge <= 1.0 {
                    continue;
                }
                for (start, turns) in [(edge * (1.0 - 1e-9), n), (edge * (1.0 + 1e-9), n + 1)] {
                    let decay = FreeDecay::new(start, 0.0, zeta, 1.0).unwrap();
                    assert_eq!(decay.half_cycles, turns, "{start} {zeta}");
                    for part in [1.0 - 1e-6, 1.0 + 1e-6] {
                        assert_eq!(decay.damped_turns((start - 1.0) * part), turns as f64, "{start} {zeta}");
                    }
                }
            }
        }
    }
}

/// A count that no float holds, and a rest that is rounding, are errors; a damper makes the count small.
#[test]
fn half_cycles_beyond_counting_are_an_error() {
    let message = |x: f64, v: f64, zeta: f64| FreeDecay::new(x, v, zeta, 1.0).unwrap_err().to_string();
    assert_eq!(
        message(1e70, 0.0, 0.0),
        "displacement x/B = 1e70 must be ≥ -4503599627370496 and ≤ 4503599627370496"
    );
    assert!(message(0.0, -1e60, 0.0).contains("-1e60"), "{}", message(0.0, -1e60, 0.0));
    assert!(message(1e70, 0.0, 1e-40).contains("1e70"));
    let (most, damped) = (2f64.powi(53), FreeDecay::new(1e70f64, 0.0, 0.05, 1.0).unwrap());
    assert_eq!(FreeDecay::new(most, 0.0, 0.0, 1.0).unwrap().half_cycles, 1 << 52);
    assert!(damped.half_cycles > 900 && damped.half_cycles < 1100, "{damped:?}");
    assert_eq!(FreeDecay::new(1e4f32, 0.0, 0.0, 1.0).unwrap().half_cycles, 5000);
    assert!(FreeDecay::new(1e9f32, 0.0, 0.0, 1.0).is_err());
}

/// The turning points are those of the motion segment by segment.
#[test]
fn turning_points_are_those_of_the_motion() {
    for (x, v, zeta, eta) in
        [(12.3, 0.0, 0.0, 1.0), (12.3, -4.0, 0.03, 1.0), (-7.7, 2.0, 0.1, 1.4), (30.0, 9.0, 0.0, 2.0)]
    {
        let decay = FreeDecay::new(x, v, zeta, eta).unwrap();
        let slides = Trajectory::from(decay).map(Result::unwrap).take_while(|s| s.duration().is_some());
        let mut time = 0.0;
        let mut ends: Vec<(f64, f64)> = slides
            .map(|s| {
                time += s.duration().unwrap();
                (time, s.end().unwrap().x)
            })
            .collect();
        if v == 0.0 {
            ends.insert(0, (0.0, x));
        }
        let found: Vec<_> = (0..).map_while(|n| decay.turning_point(n)).collect();
        assert_eq!(found.len(), ends.len(), "{x} {v} {zeta}");
        for (a, b) in found.iter().zip(&ends) {
            assert!((a.0 - b.0).abs() < 1e-12 * (1.0 + b.0) && (a.1 - b.1).abs() < 1e-12, "{a:?} {b:?}");
        }
        assert_eq!(found.last().unwrap().1, decay.rest_position);
    }
    assert_eq!(FreeDecay::new(3.0, 1.0, 2.0, 1.0).unwrap().turning_point(1), None);
}

/// The path of many half cycles by its closed form, beside the sum of their lengths, and beside the balance of works
/// without a damper: friction takes all energy but that of the spring at rest.
#[test]
fn the_path_is_the_sum_of_its_parts() {
    for (x, zeta) in [
        (30_000.0f64, 1e-9f64),
        (30_000.0, 1e-12),
        (30_000.0, 3e-8),
        (1e6, 1e-7),
        (-1e6, 1e-5),
        (1e9, 1e-4),
        (40.0, 1e-3),
    ] {
        let decay = FreeDecay::new(x, 0.0, zeta, 1.0).unwrap();
        let turns: Vec<f64> = (0..).map_while(|n| decay.turning_point(n)).map(|(_, x)| x).collect();
        let sum: f64 = turns.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        assert!((decay.path() / sum - 1.0).abs() < 1e-9, "{x} {zeta}: {} {sum}", decay.path());
    }
    for (x, v) in [(12.0f64, 6.0f64), (-40.0, 17.0), (5e3, 0.0), (3.0, -1e4), (0.5, 0.0)] {
        let decay = FreeDecay::new(x, v, 0.0, 1.0).unwrap();
        let energy = (x * x + v * v - decay.rest_position.powi(2)) / 2.0;
        assert!((decay.path() - energy).abs() <= 1e-11 * energy, "{x} {v}: {} {energy}", decay.path());
    }
}
