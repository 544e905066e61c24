//! Tests of `work.rs`.

use super::{CycleAt, FrictionWork, Span};
use crate::random::Random;
use crate::{Cycle, Ratios};

/// Y of the cycle at v, where the body slides.
fn amplitude(alpha: f64, gamma: f64, v: f64) -> Option<f64> {
    let omega = 1.0 / v.sqrt();
    let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(gamma * omega)).unwrap();
    Cycle::new(ratios).ok().map(|cycle| cycle.max_displacement / v)
}

#[test]
fn work_and_growth_are_those_of_the_cycle() {
    let mut random = Random(1);
    let mut compared = 0;
    for _ in 0..4000 {
        let (alpha, gamma, v) =
            (random.scale(1.2, 400.0), random.scale(1e-5, 4.0), random.scale(0.05, 200.0));
        let work = FrictionWork::new(alpha, gamma);
        // The scale of Y: v itself, and the distances from the resonance and from the poles.
        let distance = |n: i32| (v - f64::from(n * n)).hypot(2.0 * gamma * f64::from(n));
        let scale = (0..8).map(|i| distance(2 * i + 1)).fold(v, f64::min);
        let step = 1e-5 * scale;
        let near = [v - step, v, v + step].map(|v| amplitude(alpha, gamma, v));
        let [Some(below), Some(here), Some(above)] = near else { continue };
        let at = work.cycle_at(v);
        let (found, growth) = work.work_and_growth(&at);
        // a and G, of which Y is the difference, are rounded.
        let size = here + 16.0 / std::f64::consts::PI * gamma / at.d;
        let rounding = 1e-13 * (1.0 + 1.0 / at.d.sqrt());
        assert!((found - here).abs() < rounding * size, "{alpha} {gamma} {v}: {found} {here}");
        let slope = growth / work.root(at.d, work.constant(&at));
        // The error of the difference quotient: its third derivative, 1e-10 times the number of scales in it,
        // and the rounding of two values divided by the step.
        let error = (1e-5 + rounding / 1e-5) * (size / scale + slope.abs());
        assert!(((above - below) / (2.0 * step) - slope).abs() < error, "{alpha} {gamma} {v}: {slope}");
        compared += 1;
    }
    assert!(compared > 1000, "{compared}");
}

fn inside(span: Span<f64>, x: f64, slack: f64) -> bool {
    span.low - slack <= x && x <= span.high + slack
}

/// The bounds of an interval hold at its points, and shrink with the interval.
#[test]
fn the_bounds_of_an_interval_hold_inside() {
    let mut random = Random(2);
    let mut useful = 0;
    for _ in 0..4000 {
        let (alpha, gamma, low) =
            (random.scale(1.2, 400.0), random.scale(1e-4, 4.0), random.scale(0.5, 200.0));
        let high = low * (1.0 + random.scale(1e-6, 0.3));
        let work = FrictionWork::new(alpha, gamma);
        let Some(rates) = work.rates(low, high) else { continue };
        let (middle, radius) = ((low + high) / 2.0, (high - low) / 2.0);
        let at = work.cycle_at(middle);
        let (growth, s) = work.growth_within(&at, &rates, Span::new(low - 1.0, high - 1.0), radius);
        useful += u32::from(growth.low > 0.0 || growth.high < 0.0);
        for share in [0.0, 0.13, 0.4, 0.77, 1.0] {
            let v = low + (high - low) * share;
            let here = work.cycle_at(v);
            let off = (v - middle).abs() * (1.0 + 1e-9);
            // h and g near the resonance are differences.
            let rounding = 1e-14 * (1.0 + 1.0 / at.d).powi(2);
            let is_within = |f: fn(&CycleAt<f64>) -> f64, rate: f64| {
                (f(&here) - f(&at)).abs() <= off * rate + rounding * (1.0 + f(&at).abs())
            };
            assert!(is_within(|at| at.h, rates.h_slope), "{gamma} {low} {high}");
            assert!(is_within(|at| at.h_slope, rates.h_second), "{gamma} {low} {high}");
            assert!(is_within(|at| at.g_slope, rates.g_second), "{gamma} {low} {high}");
            if amplitude(alpha, gamma, v).is_some() {
                let (_, found) = work.work_and_growth(&here);
                let size = growth.size() + alpha * alpha;
                assert!(inside(growth, found, rounding * size), "{alpha} {gamma} {low} {high} {v}");
                assert!(inside(s, work.root(here.d, work.constant(&here)), rounding * size));
            }
        }
    }
    assert!(useful > 1000, "{useful}");
}

/// Above Ω = √2 the work of friction rises with the stiffness wherever the body slides.
#[test]
fn the_work_rises_up_to_one_half() {
    let mut random = Random(3);
    let mut slides = 0;
    for _ in 0..4000 {
        let (alpha, gamma, v) = (random.scale(1.2, 1e4), random.scale(1e-6, 30.0), random.scale(0.02, 0.5));
        if amplitude(alpha, gamma, v).is_some() {
            let work = FrictionWork::new(alpha, gamma);
            assert!(work.work_and_growth(&work.cycle_at(v)).1 > 0.0, "{alpha} {gamma} {v}");
            slides += 1;
        }
    }
    assert!(slides > 1000, "{slides}");
}
