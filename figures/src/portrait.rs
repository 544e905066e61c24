//! Motions in the phase plane.

use super::{Axis, Figure, Panel, Series, Style, settled};
use stickslip::motion::{Instant, Kind, State, Trajectory};
use stickslip::{Cycle, Ratios};

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
        "The steady motion (thick) and the way there from rest (thin): without stops at Ω = 0.7, α = 2 \
            with the instants t₁ … t₄ of figure 2, and with four stops a cycle at Ω = 0.15, α = 3.",
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
