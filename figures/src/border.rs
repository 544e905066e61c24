//! The minimum force ratio without sticking: figure 8, and the neighbourhood of the poles 1/3 and 1/5, where the body never
//! stops.

use crate::shared::{evenly, of_frequency_ratio, settled};
use stickslip::{Border, NoStop, Ratios};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

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
        Series::new("eq. 61", Style::Line, 0, curve(|b| b.min_force_ratio_turning_point)),
    ];
    Figure::single(
        "8",
        "Least force ratio without sticking",
        "Minimum force ratio without sticking: eq. 61 (thin), and exact below Ω = 1/2 (thick). \
            Dots: points without a stop in the exact motion.",
        of_frequency_ratio(0.15, 2.0),
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

/// The border, the region of six reversals below it, and the points where the exact motion has no stop.
pub(super) fn beside_poles() -> Figure {
    Figure::new(
        "poles",
        "Beside the poles 1/3 and 1/5",
        "Force ratios without a stop: above the sticking threshold (thick) and within the \
            six-reversal edges (lines). Dots: no stop in the exact motion.",
        vec![panel(3.0, (0.3284, 0.3368), (40.0, 2000.0)), panel(5.0, (0.1981, 0.2013), (110.0, 5500.0))],
    )
}

fn panel(pole: f64, (from, to): (f64, f64), (low, high): (f64, f64)) -> Panel {
    // The steps never meet the pole.
    let omegas = || evenly(from, to, 1201);
    let border = omegas().filter_map(|omega| Border::new(omega).ok().map(|b| (omega, b.min_force_ratio)));
    let edges: Vec<(f64, (f64, f64))> = omegas()
        .filter_map(|omega| Some((omega, NoStop::of(&Ratios::new(omega, 1.0).ok()?).six_reversals?)))
        .collect();
    let least = edges.iter().map(|&(omega, (low, _))| (omega, low));
    let greatest = edges.iter().map(|&(omega, (_, high))| (omega, high));
    // The path leads once around the region, from the left of the pole to its right; points above the axis
    // break the line.
    let around = greatest.rev().chain(least).chain(edges.last().map(|&(omega, (_, high))| (omega, high)));
    let shown = |(omega, alpha): (f64, f64)| (omega, if alpha < high { alpha } else { f64::NAN });
    let lattice = evenly(from, to, 43).flat_map(|omega| {
        evenly(low.ln(), high.ln(), 27).map(move |alpha| (omega, alpha.exp(), reversals(omega, alpha.exp())))
    });
    let lattice: Vec<(f64, f64, Option<u32>)> = lattice.collect();
    let dots = |count: u32| {
        lattice.iter().filter(move |point| point.2 == Some(count)).map(|&(omega, alpha, _)| (omega, alpha))
    };
    Panel::new(
        format!("beside Ω = 1/{pole}"),
        of_frequency_ratio(from, to),
        Axis::logarithmic("force ratio α = p₀/r_y", low, high),
        vec![
            Series::new("two reversals", Style::Dots, 5, dots(2)),
            Series::new("six reversals", Style::Dots, 2, dots(6)),
            Series::new("border α_min", Style::Thick, 1, border.map(shown)),
            Series::new("edges of six", Style::Line, 0, around.map(shown)),
        ],
    )
}

/// The number of velocity zeros per cycle of the exact motion from rest, if it has no stop.
fn reversals(omega: f64, alpha: f64) -> Option<u32> {
    let steady = settled(omega, alpha)?;
    (steady.sticks_per_cycle == 0).then_some(steady.velocity_zeros_per_cycle)
}
