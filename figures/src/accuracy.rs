//! The digits lost near Ω = 1 by the formulae as written.

use super::{Axis, Figure, Panel, Series, Style, evenly};
use stickslip::Border;
use stickslip::{Cycle, Ratios};

const ALPHA: f64 = 2.0;

/// Relative errors at 1 + δ, δ from 1e-15 to 0.3.
pub(super) fn beside_one() -> Figure {
    let panel = |title: &str, naive: fn(f64) -> f64, ours: fn(f64) -> f64, exact: fn(f64, f64) -> f64| {
        let errors = |value: fn(f64) -> f64, reference: fn(f64) -> f64, exact: fn(f64, f64) -> f64| {
            distances().map(move |delta| {
                let omega = 1.0 + delta;
                (omega - 1.0, error(exact(omega, value(omega)), reference(omega), value(omega)))
            })
        };
        let mut series =
            vec![Series::new("formula as written, f64", Style::Dots, 5, errors(naive, ours, exact))];
        if cfg!(feature = "mp") {
            series.push(Series::new("this library, f64", Style::Marks, 4, errors(ours, ours, exact)));
        }
        Panel {
            title: title.to_owned(),
            x: Axis::logarithmic("distance from resonance, Ω − 1", 1e-16, 1.0),
            y: Axis::logarithmic("relative error", 1e-18, 10.0),
            plane: None,
            series,
        }
    };
    Figure {
        name: "accuracy".to_owned(),
        title: "Digits lost beside Ω = 1".to_owned(),
        caption: "Relative error of eq. 44 (Δ₀/B at α = 2) and eq. 61 (the border) as written, and of this \
            library's forms, at f64 against 256 bits. As written they lose a digit for each digit that Ω is \
            nearer to 1, or end in infinity or NaN (drawn at 1). An error of zero is drawn at 1e-17. (A build \
            without the feature mp draws the formulae as written, against this library.)"
            .to_owned(),
        panels: vec![
            panel("maximum displacement Δ₀/B, eq. 44", naive_displacement, displacement, exact_displacement),
            panel("border α, eq. 61", naive_border, border, exact_border),
        ],
    }
}

/// Distances from 1 in geometric progression.
fn distances() -> impl Iterator<Item = f64> + Clone {
    evenly(-15.4, -0.5, 120).map(|exponent| 10f64.powf(exponent)).filter(|delta| 1.0 + delta > 1.0)
}

/// The error to draw: relative to the exact value where it is known, otherwise relative to the library's.
fn error(against_exact: f64, ours: f64, value: f64) -> f64 {
    let error =
        if against_exact.is_nan() && !value.is_nan() { (value / ours - 1.0).abs() } else { against_exact };
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

fn displacement(omega: f64) -> f64 {
    Ratios::new(omega, ALPHA).and_then(Cycle::new).map_or(f64::NAN, |c| c.max_displacement)
}

fn border(omega: f64) -> f64 {
    stickslip::PhaseFunction::new(omega).map_or(f64::NAN, |p| Border::turning_point_at(&p))
}

/// The relative error of a value, from 256 bits.
#[cfg(feature = "mp")]
fn exact_displacement(omega: f64, value: f64) -> f64 {
    use stickslip::Float;
    use stickslip::float::Mp;
    let wide = |x: f64| Mp::<4>::from_f64(x);
    let cycle = Ratios::new(wide(omega), wide(ALPHA)).and_then(Cycle::new);
    cycle.map_or(f64::NAN, |c| (wide(value) / c.max_displacement - wide(1.0)).to_f64().abs())
}

/// The relative error of a value, from 256 bits.
#[cfg(feature = "mp")]
fn exact_border(omega: f64, value: f64) -> f64 {
    use stickslip::Float;
    use stickslip::float::Mp;
    let wide = |x: f64| Mp::<4>::from_f64(x);
    let p = stickslip::PhaseFunction::new(wide(omega));
    p.map_or(f64::NAN, |p| (wide(value) / Border::turning_point_at(&p) - wide(1.0)).to_f64().abs())
}

/// Unknown without multiple precision.
#[cfg(not(feature = "mp"))]
fn exact_displacement(_: f64, _: f64) -> f64 {
    f64::NAN
}

/// Unknown without multiple precision.
#[cfg(not(feature = "mp"))]
fn exact_border(_: f64, _: f64) -> f64 {
    f64::NAN
}
