//! Figures 9 and 10: the size of the dissipation loop.

use crate::shared::{evenly, inverse_force_ratios, of_cycle, of_frequency_ratio};
use stickslip::{Cycle, Ratios, Response};
use stickslip_draw::{Axis, Figure, Series, Style};
use stickslip_front::curve::resonant;

/// The response at Ω; only answers that depend on Ω alone are used.
fn response_at(omega: f64) -> Option<Response<f64>> {
    Ratios::new(omega, 1.0).map(Response::new).ok()
}

/// A value where the optimum of eq. 65 and 66 does not stick, or where it would, so that the border is the best
/// choice; NaN elsewhere.
fn at_best(is_reached: bool, value: fn(&Response<f64>) -> Option<f64>) -> impl Iterator<Item = (f64, f64)> {
    frequency_ratios().map(move |omega| {
        let answer = response_at(omega).filter(|answer| answer.best_is_reached() == is_reached);
        (omega, answer.as_ref().and_then(value).unwrap_or(f64::NAN))
    })
}

fn frequency_ratios() -> impl Iterator<Item = f64> {
    evenly(0.2005, 1.9995, 1800)
}

/// A₁ on the border itself.
fn loop_on_border(answer: &Response<f64>) -> Option<f64> {
    // The rounded border may lie below the exact one.
    let alpha = answer.border.min_force_ratio * (1.0 + 4.0 * f64::EPSILON);
    let cycle = Ratios::new(answer.ratios.omega(), alpha).and_then(Cycle::new);
    cycle.ok().map(|c| c.loop_size_stiffness())
}

/// Figure 9(a): the best force ratio.
pub(super) fn best_force() -> Figure {
    let series = vec![
        Series::new("eq. 65, where it holds", Style::Thick, 0, at_best(true, |a| Some(a.best_force_ratio))),
        Series::new(
            "the border, elsewhere",
            Style::Dashed,
            5,
            at_best(false, |a| Some(a.border.min_force_ratio)),
        ),
    ];
    Figure::single(
        "9a",
        "Best force ratio for dissipation",
        "Force ratio α of the largest loop size A₁: eq. 65 where that motion does not stick; elsewhere the \
         border (dashed).",
        of_frequency_ratio(0.2, 2.0),
        Axis::linear("best force ratio α", 0.0, 16.0),
        series,
    )
}

/// Figure 9(b): the largest loop.
pub(super) fn largest_loop() -> Figure {
    let series = vec![
        Series::new("eq. 66, where it holds", Style::Thick, 0, at_best(true, |it| it.best_loop_size)),
        Series::new("on the border, elsewhere", Style::Dashed, 5, at_best(false, loop_on_border)),
        Series::unbounded([1.0]),
    ];
    Figure::single(
        "9b",
        "Largest dissipation loop",
        "The largest loop size A₁ without sticking: eq. 66, or where its motion would stick A₁ on the border \
         (dashed). At Ω = 1 it has no bound (arrowhead).",
        of_frequency_ratio(0.2, 2.0),
        Axis::logarithmic("largest loop size A₁", 0.1, 1000.0),
        series,
    )
}

/// Figure 10(a): A₁ against 1/α.
pub(super) fn loop_by_friction() -> Figure {
    let curve = |(index, tenth): (usize, u32)| {
        let omega = f64::from(tenth) / 10.0;
        let points = evenly(0.002, 0.8, 400)
            .map(|inverse| (inverse, of_cycle(omega, 1.0 / inverse, |c| c.loop_size_stiffness())));
        Series::new(format!("Ω = {omega}"), Style::Marked(30 + index), index, points)
    };
    Figure::single(
        "10a",
        "Dissipation against friction",
        "Loop size A₁ against 1/α = r_y/p₀ for Ω = 1.2 … 1.8, up to where the motion begins to stick. The \
         maxima are eq. 65 and 66.",
        Axis::linear("1/α = r_y/p₀", 0.0, 0.8),
        Axis::linear("loop size A₁", 0.0, 7.0),
        (12..=18).enumerate().map(curve).collect(),
    )
}

/// Figure 10(b): A₂ against Ω.
pub(super) fn loop_by_frequency() -> Figure {
    let curve = |(index, alpha, name): (usize, f64, String)| {
        // The loop grows with the displacement.
        let at = |omega| {
            if omega == 1.0 { f64::INFINITY } else { of_cycle(omega, alpha, |c| c.loop_size_inertia()) }
        };
        let points = resonant(frequency_ratios(), &[1.0], at);
        Series::new(name, Style::Marked(130 + index), index, points)
    };
    Figure::single(
        "10b",
        "Dissipation against stiffness",
        "Loop size A₂ for 1/α = 0.1 … 0.5 without sticking, at a given mass, force and frequency. \
            Arrowhead: unbounded at Ω = 1.",
        of_frequency_ratio(0.2, 2.0),
        Axis::logarithmic("loop size A₂", 0.01, 1000.0),
        inverse_force_ratios(5).map(curve).chain([Series::unbounded([1.0])]).collect(),
    )
}
