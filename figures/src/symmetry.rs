//! Figure 3: the error measures of section 3.

use crate::shared::{evenly, of_frequency_ratio};
use stickslip::Ratios;
use stickslip::motion::{ErrorMeasures, LongRun, State, errors_after};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

/// The number of cycles from rest before the motion is measured; the paper does not state it.
const CYCLES: u32 = 20;

/// Errors 1–4 for 1/α = 0.3, 0.4 and 0.5, some cycles after rest and in the steady state.
pub(super) fn errors() -> Figure {
    let measures: [(&str, Measure); 4] = [
        ("error 1, of the extreme displacements", |e| e.error_1),
        ("error 2, of their instants", |e| e.error_2.abs()),
        ("error 3, of the extreme velocities", |e| e.error_3),
        ("error 4, of their instants", |e| e.error_4.abs()),
    ];
    let inverses = [0.3, 0.4, 0.5];
    let motions: Vec<_> =
        inverses.iter().enumerate().map(|(i, &inverse)| (i, inverse, along(1.0 / inverse))).collect();
    let panel = |(title, measure): (&str, Measure)| {
        let mut series = Vec::new();
        for (i, inverse, errors) in &motions {
            let points = |of: fn(&MeasuresAtFrequency) -> Option<ErrorMeasures<f64>>| {
                errors.iter().map(move |pair| (pair.omega, of(pair).map_or(f64::NAN, |e| measure(&e))))
            };
            let name = format!("1/α = {inverse}, 20 cycles from rest");
            series.push(Series::new(name, Style::Line, *i, points(|p| p.early)));
            series.push(Series::new(
                format!("1/α = {inverse}, settled"),
                Style::Dots,
                *i,
                points(|p| p.settled),
            ));
        }
        Panel::new(title, of_frequency_ratio(0.6, 2.0), Axis::logarithmic("error", 1e-17, 1.0), series)
    };
    Figure::new(
        "3",
        "Figure 3 again: how symmetric the motion is",
        "Error measures 1–4, 20 cycles after rest (lines) and settled (dots). The paper's peaks \
            at Ω = 1 are start-up transients.",
        measures.map(panel),
    )
}

/// One of the four measures.
type Measure = fn(&ErrorMeasures<f64>) -> f64;

/// The measures at one Ω.
struct MeasuresAtFrequency {
    omega: f64,
    early: Option<ErrorMeasures<f64>>,
    settled: Option<ErrorMeasures<f64>>,
}

/// The measures at one α for Ω from 0.6 to 2, without Ω = 1, where the amplitude grows without bound.
fn along(alpha: f64) -> Vec<MeasuresAtFrequency> {
    evenly(0.6025, 1.9975, 280)
        .map(|omega| {
            let ratios = Ratios::new(omega, alpha).ok();
            let early = ratios.and_then(|r| errors_after(r, State::default(), CYCLES).ok());
            let limit = ratios.and_then(|r| LongRun::from_start(r, State::default()).ok());
            MeasuresAtFrequency { omega, early, settled: limit.and_then(|l| l.steady_state()?.errors().ok()) }
        })
        .collect()
}
