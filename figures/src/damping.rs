//! The effect of viscous damping on the response curve, the border, and the time at rest.

use crate::shared::{evenly, of_frequency_ratio};
use stickslip::motion::{LongRun, State, SteadyState};
use stickslip::{Border, Ratios};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::curve::resonant;

/// The damping ratios.
const ZETA: [f64; 4] = [0.0, 0.01, 0.05, 0.2];

/// The force ratio of the first and last panels.
const ALPHA: f64 = 2.5;

/// Amplitude, border and time at rest over Ω, for four damping ratios.
pub(super) fn four_ratios() -> Figure {
    let amplitude = |steady: &SteadyState<f64>| steady.max_displacement.value / ALPHA;
    Figure::new(
        "damping",
        "What viscous damping changes",
        "Peak displacement over p₀/k at α = 2.5, minimum force without sticking, and fraction of \
            time at rest. Arrowheads: unbounded.",
        vec![
            Panel::new(
                "peak displacement at α = 2.5",
                of_frequency_ratio(0.2, 2.0),
                Axis::logarithmic("k Δ₀/p₀", 0.1, 30.0),
                with_arrowheads(each(|zeta| curve(zeta, (0.2, 2.0), amplitude)), &[1.0]),
            ),
            Panel::new(
                "least force without sticking",
                of_frequency_ratio(0.15, 2.0),
                Axis::logarithmic("force ratio α = p₀/r_y", 1.0, 300.0),
                with_arrowheads(each(border), &POLES),
            ),
            Panel::new(
                "rest at α = 2.5",
                of_frequency_ratio(0.1, 1.0),
                Axis::linear("part of the cycle at rest", 0.0, 0.8),
                each(|zeta| curve(zeta, (0.1, 1.0), |it| it.stick_fraction)),
            ),
        ],
    )
}

/// A line for each damping ratio.
fn each(points: impl Fn(f64) -> Vec<(f64, f64)>) -> Vec<Series> {
    let line = |(index, &zeta): (usize, &f64)| {
        Series::new(format!("ζ = {zeta}"), Style::Marked(60 + index), index, points(zeta))
    };
    ZETA.iter().enumerate().map(line).collect()
}

/// The lines, and arrowheads where the undamped line is unbounded.
fn with_arrowheads(mut lines: Vec<Series>, places: &[f64]) -> Vec<Series> {
    lines.push(Series::unbounded(places.iter().copied()));
    lines
}

/// The poles of the undamped border on its axis.
const POLES: [f64; 2] = [1.0 / 5.0, 1.0 / 3.0];

/// α_min over Ω.
fn border(zeta: f64) -> Vec<(f64, f64)> {
    let least = |omega: f64| {
        if zeta == 0.0 && POLES.contains(&omega) {
            return f64::INFINITY;
        }
        let ratios = Ratios::new(omega, 1.0).and_then(|at| at.with_damping_ratio(zeta));
        ratios.map_or(f64::NAN, |at| Border::of(&at).min_force_ratio)
    };
    resonant(evenly(0.150_1, 1.999_7, 1400), &POLES, least)
}

/// A property of the steady state from rest, over Ω; infinite where the motion is unbounded.
fn curve(zeta: f64, (from, to): (f64, f64), of: impl Fn(&SteadyState<f64>) -> f64) -> Vec<(f64, f64)> {
    let at = |omega: f64| {
        let ratios = Ratios::new(omega, ALPHA).and_then(|ratios| ratios.with_damping_ratio(zeta));
        match ratios.and_then(|ratios| LongRun::from_start(ratios, State::default())) {
            Ok(LongRun::Unbounded { .. }) => f64::INFINITY,
            limit => limit.ok().and_then(|limit| limit.steady_state().map(&of)).unwrap_or(f64::NAN),
        }
    };
    let resonance = if to > 1.0 { [1.0].as_slice() } else { &[] };
    resonant(evenly(from + 1e-4, to - 1e-4, 400), resonance, at)
}
