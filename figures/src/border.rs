//! Figure 8: the minimum force ratio without sticking.

use super::{Axis, Figure, Series, Style, evenly, settled};
use stickslip::Border;

/// The exact border, eq. 61, and the points where the exact motion has no stop.
pub(super) fn least_force() -> Figure {
    let borders: Vec<Border<f64>> = frequency_ratios().filter_map(|omega| Border::new(omega).ok()).collect();
    let curve = |value: fn(&Border<f64>) -> f64| {
        frequency_ratios().zip(borders.iter().map(value)).collect::<Vec<_>>()
    };
    let below_half = |points: Vec<(f64, f64)>| points.into_iter().filter(|(omega, _)| *omega <= 0.5);
    let lattice =
        evenly(0.1725, 1.9725, 61).flat_map(|omega| evenly(0.5, 15.5, 51).map(move |alpha| (omega, alpha)));
    let series = vec![
        Series::new("no stop in the exact motion", Style::Dots, 5, lattice.filter(|p| never_stops(*p))),
        Series::new("exact border, Ω < 1/2", Style::Thick, 1, below_half(curve(|b| b.min_force_ratio))),
        Series::new("eq. 61", Style::Line, 0, curve(|b| b.turning_point)),
    ];
    Figure::single(
        "8",
        "Least force ratio without sticking",
        "Minimum force ratio α without sticking: eq. 61 (thin line), the exact border where it differs, \
            below Ω = 1/2 (thick), and points where the exact motion from rest has no stop (dots). No dot lies \
            between the two lines.",
        Axis::frequency_ratio(0.15, 2.0),
        Axis::linear("force ratio α = p₀/r_y", 0.0, 16.0),
        series,
    )
}

fn frequency_ratios() -> impl Iterator<Item = f64> + Clone {
    evenly(0.15, 2.0, 926)
}

fn never_stops((omega, alpha): (f64, f64)) -> bool {
    settled(omega, alpha).is_some_and(|steady| steady.sticks_per_cycle == 0)
}
