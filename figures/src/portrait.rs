//! Motions in the phase plane: two with their transients, and figure 2, a cycle without stops.

use crate::shared::settled;
use stickslip::motion::{Instant, Kind, State, Trajectory};
use stickslip::{Cycle, Ratios};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

/// A motion without stops, with the points of figure 2, and one that sticks, each with its transient from
/// rest.
pub(super) fn two_motions() -> Figure {
    let mut smooth = portrait("without stops: Ω = 0.7, α = 2", 0.7, 2.0, 6, (5.0, 5.0));
    if let Ok(cycle) = Ratios::new(0.7, 2.0).and_then(Cycle::new) {
        let (d0, v0, d1) = (cycle.max_displacement, cycle.max_velocity, cycle.deviation());
        let mut mark =
            |name: &str, index, x, v| smooth.series.push(Series::new(name, Style::Marks, index, [(x, v)]));
        mark("t₁: (Δ₁, V₀)", 0, d1, v0);
        mark("t₂: (Δ₀, 0)", 1, d0, 0.0);
        mark("t₃: (−Δ₁, −V₀)", 2, -d1, -v0);
        mark("t₄: (−Δ₀, 0)", 3, -d0, 0.0);
    }
    Figure::new(
        "portrait",
        "Steady motions in the phase plane",
        "Steady motions (thick) and the way there from rest (thin): without stops (left), and \
            with four stops a cycle (right).",
        vec![smooth, portrait("with four stops in a cycle: Ω = 0.15, α = 3", 0.15, 3.0, 2, (3.0, 8.0))],
    )
}

fn portrait(title: &str, omega: f64, alpha: f64, cycles: usize, (x, v): (f64, f64)) -> Panel {
    let steady = settled(omega, alpha);
    let path = |start, cycles| motion(omega, alpha, start, cycles);
    let mut series = vec![
        Series::new("from rest", Style::Line, 4, path(State::default(), cycles)),
        Series::new("steady", Style::Thick, 0, steady.map_or(Vec::new(), |steady| path(steady.state, 1))),
    ];
    if let Some(steady) = steady.filter(|steady| steady.sticks_per_cycle > 0) {
        let segments = Ratios::new(omega, alpha).and_then(|ratios| Trajectory::new(ratios, steady.state));
        let segments = segments.into_iter().flatten().map_while(Result::ok);
        let stops = segments.filter(|segment| segment.kind == Kind::Stick).map(|stop| (stop.start().x, 0.0));
        let stops = stops.take(steady.sticks_per_cycle as usize);
        series.push(Series::new("stop", Style::Marks, 5, stops));
    }
    let (x, v) = (Axis::linear("displacement x/B", -x, x), Axis::linear("velocity x′/(Bω_d)", -v, v));
    Panel::new(title, x, v, series)
}

/// Some cycles of the motion from a start.
pub(super) fn samples(omega: f64, alpha: f64, start: State<f64>, cycles: usize) -> Vec<Instant<f64>> {
    let samples = Ratios::new(omega, alpha).and_then(|r| Trajectory::new(r, start)?.samples(PER_CYCLE));
    let samples = samples.and_then(|s| s.take(cycles * PER_CYCLE as usize + 1).collect());
    samples.unwrap_or_default()
}

/// Some cycles of the motion from a start, as (x/B, x′/(Bω_d)).
pub(super) fn motion(omega: f64, alpha: f64, start: State<f64>, cycles: usize) -> Vec<(f64, f64)> {
    samples(omega, alpha, start, cycles).iter().map(|i| (i.state.x, i.state.v)).collect()
}

/// Samples in a cycle.
const PER_CYCLE: u32 = 240;

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
        "The steady motion at Ω = 0.7, α = 2, clockwise. Marks: peak velocity V₀ (t₁, Δ₁) and \
            peak displacement Δ₀ (t₂) in closed form.",
        Axis::linear("displacement x/B", -5.0, 5.0),
        Axis::linear("velocity x′/(Bω_d)", -5.0, 5.0),
        series,
    )
}
