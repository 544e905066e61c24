//! Figure 2: a cycle without stops in the phase plane.

use super::portrait::motion;
use super::{Axis, Figure, Series, Style, settled};
use stickslip::{Cycle, Ratios};

const OMEGA: f64 = 0.7;
const ALPHA: f64 = 2.0;

/// The steady cycle with the four instants and the three lengths that the paper determines.
pub(super) fn in_phase_plane() -> Figure {
    let cycle = Ratios::new(OMEGA, ALPHA).and_then(Cycle::new);
    let (d0, v0, d1) = cycle
        .as_ref()
        .map_or((f64::NAN, f64::NAN, f64::NAN), |c| (c.max_displacement, c.max_velocity, c.deviation()));
    let path = settled(OMEGA, ALPHA).map_or(Vec::new(), |steady| motion(OMEGA, ALPHA, steady.state, 1));
    let line = |style, points: [(f64, f64); 2]| Series::new("", style, 0, points);
    let word = |text: &str, x: f64, y: f64| Series::new(text, Style::Named, 0, [(x, y)]);
    let length =
        |from: (f64, f64), to: (f64, f64)| [line(Style::Arrow, [from, to]), line(Style::Arrow, [to, from])];
    let mut series = vec![
        line(Style::Line, [(-5.0, 0.0), (5.0, 0.0)]),
        line(Style::Line, [(0.0, -5.0), (0.0, 5.0)]),
        line(Style::Dotted, [(-4.6, v0), (d1, v0)]),
        line(Style::Dotted, [(d1, v0), (d1, v0 + 0.6)]),
        line(Style::Dotted, [(d0, 0.0), (d0, -4.7)]),
    ];
    series.extend(length((0.0, v0 + 0.5), (d1, v0 + 0.5)));
    series.extend(length((-4.4, 0.0), (-4.4, v0)));
    series.extend(length((0.0, -4.5), (d0, -4.5)));
    series.extend([
        word("Δ₁", d1 / 2.0, v0 + 0.85),
        word("V₀", -4.65, v0 / 2.0),
        word("Δ₀", d0 / 2.0, -4.2),
        word("t₁", d1 + 0.35, v0 + 0.3),
        word("t₂", d0 + 0.4, 0.3),
        word("t₃", -d1 - 0.35, -v0 - 0.3),
        word("t₄", -d0 - 0.4, -0.3),
    ]);
    // Arrows between the four instants show the direction.
    let quarter = path.len() / 4;
    let way = |i: usize| path.get(i..i + 4).map(|piece| Series::new("", Style::Arrow, 2, piece.to_vec()));
    let ways: Vec<_> = (0..4).filter_map(|i| way(i * quarter + quarter / 3)).collect();
    series.push(Series::new("steady motion, Ω = 0.7, α = 2", Style::Thick, 2, path));
    series.extend(ways);
    let extremes = [(d1, v0), (d0, 0.0), (-d1, -v0), (-d0, 0.0)];
    series.push(Series::new("closed forms", Style::Marks, 0, extremes));
    Figure::single(
        "2",
        "A steady cycle without stops in the phase plane",
        "The exact steady motion at Ω = 0.7, α = 2 (line), clockwise, and by the closed forms (marks) its \
            maximum velocity V₀ at t₁ and Δ₁, its maximum displacement Δ₀ at t₂, and the same half a cycle \
            later at t₃ and t₄.",
        Axis::linear("displacement x/B", -5.0, 5.0),
        Axis::linear("velocity x′/(Bω_d)", -5.0, 5.0),
        series,
    )
}
