//! The digits lost near Ω = 1 by the formulae as written.

use crate::shared::evenly;
use stickslip::{Border, Cycle, Error, Field, Float, PhaseFunction, Ratios};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

const ALPHA: f64 = 2.0;

/// Relative errors at 1 + δ, δ from 1e-15 to 0.3.
pub(super) fn beside_one() -> Figure {
    let panel =
        |title: &str, naive: fn(f64) -> f64, ours: fn(f64) -> f64, exact: fn(Wide) -> Result<Wide, Error>| {
            let errors = |value: fn(f64) -> f64| {
                distances().map(move |delta| {
                    let omega = 1.0 + delta;
                    (omega - 1.0, error(omega, value(omega), exact))
                })
            };
            let mut series = vec![Series::new("formula as written, f64", Style::Dots, 5, errors(naive))];
            if cfg!(feature = "mp") {
                series.push(Series::new("this library, f64", Style::Marks, 4, errors(ours)));
            } else {
                series.push(Series::new("measured by this library, f64", Style::Note, 0, []));
            }
            Panel::new(
                title,
                Axis::logarithmic("distance from resonance, Ω − 1", 1e-16, 1.0),
                Axis::logarithmic("relative error", 1e-18, 10.0),
                series,
            )
        };
    Figure::new(
        "accuracy",
        "Digits lost beside Ω = 1",
        "Relative error of eq. 44 (α = 2) and eq. 61 at f64: as written, and in this library. \
            Zero is drawn at 1e-17, infinity and NaN at 1.",
        vec![
            panel(
                "peak displacement Δ₀/B, eq. 44",
                naive_displacement,
                |x| or_nan(displacement(x)),
                displacement,
            ),
            panel("border α, eq. 61", naive_border, |x| or_nan(border(x)), border),
        ],
    )
}

/// Distances from 1 in geometric progression.
fn distances() -> impl Iterator<Item = f64> + Clone {
    evenly(-15.4, -0.5, 120).map(|exponent| 10f64.powf(exponent)).filter(|delta| 1.0 + delta > 1.0)
}

#[cfg(feature = "mp")]
type Wide = stickslip::float::Mp<4>;
/// Without multiple precision the library itself is the measure.
#[cfg(not(feature = "mp"))]
type Wide = f64;

/// The error to draw, relative to the exact value.
fn error(omega: f64, value: f64, exact: fn(Wide) -> Result<Wide, Error>) -> f64 {
    let off = |exact: Wide| (Wide::from_f64(value) / exact - Wide::int(1)).to_f64().abs();
    let error = exact(Wide::from_f64(omega)).map_or(f64::NAN, off);
    if error.is_nan() { 1.0 } else { error.clamp(1e-17, 1.0) }
}

/// Eq. 44 as written in the paper.
fn naive_displacement(omega: f64) -> f64 {
    let pi_1 = std::f64::consts::PI / omega;
    let amplitude = ALPHA / (1.0 - omega * omega);
    let lag = pi_1.sin() / (omega * (1.0 + pi_1.cos()));
    (amplitude * amplitude - lag * lag).sqrt()
}

/// Eq. 61 as written in the paper.
fn naive_border(omega: f64) -> f64 {
    let pi_1 = std::f64::consts::PI / omega;
    let (factor, lag) = (1.0 / (omega * omega) - 1.0, omega * pi_1.sin() / (1.0 + pi_1.cos()));
    (factor * factor * (1.0 + lag * lag)).sqrt()
}

fn displacement<F: Float>(omega: F) -> Result<F, Error> {
    Ratios::new(omega, F::from_f64(ALPHA)).and_then(Cycle::new).map(|cycle| cycle.max_displacement)
}

fn border<F: Float>(omega: F) -> Result<F, Error> {
    PhaseFunction::new(omega).map(|p| Border::turning_point_at(&p))
}

fn or_nan(found: Result<f64, Error>) -> f64 {
    found.unwrap_or(f64::NAN)
}
