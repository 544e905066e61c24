//! Figure 1: the oscillator and its law of friction.

use super::portrait::samples;
use crate::shared::settled;
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

/// The oscillator of eq. 1, and the friction force over the velocity with points of a motion that sticks.
pub(super) fn with_friction() -> Figure {
    Figure::new(
        "1",
        "The oscillator and its friction",
        "Left: the oscillator of eq. 1. Right: Coulomb's law (line), and a steady motion with two \
            stops a cycle at Ω = 0.4, α = 6 (dots).",
        vec![sketch(), law()],
    )
}

/// A sketch of a mass on a spring, with the same scale on both axes.
fn sketch() -> Panel {
    let line = |style, points: Vec<(f64, f64)>| Series::new("", style, 0, points);
    let arrow = |from: (f64, f64), to: (f64, f64)| line(Style::Arrow, vec![from, to]);
    let word = |text: &str, x: f64, y: f64| Series::new(text, Style::Named, 0, [(x, y)]);
    let mut series = vec![
        line(Style::Thick, vec![(0.6, 7.0), (0.6, 3.0), (10.2, 3.0)]),
        line(Style::Line, spring(0.6, 4.6, 4.7)),
        line(Style::Thick, vec![(4.6, 3.05), (4.6, 6.3), (7.6, 6.3), (7.6, 3.05)]),
        arrow((7.6, 4.7), (10.2, 4.7)),
        line(Style::Dotted, vec![(6.1, 6.3), (6.1, 7.6)]),
        arrow((6.1, 7.3), (8.1, 7.3)),
        word("m", 6.1, 4.7),
        word("k", 2.6, 5.6),
        word("p₀ sin ω_d t", 9.15, 5.3),
        word("x", 8.4, 7.3),
        word("friction r_a, |r_a| ≤ r_y", 6.1, 2.0),
    ];
    let along_ground = (0..24).map(|i| 0.9 + 0.4 * f64::from(i));
    series.extend(along_ground.map(|x| line(Style::Line, vec![(x, 3.0), (x - 0.3, 2.65)])));
    let along_wall = (0..10).map(|i| 3.3 + 0.4 * f64::from(i));
    series.extend(along_wall.map(|y| line(Style::Line, vec![(0.6, y), (0.25, y - 0.3)])));
    Panel::new(
        "m x″ + r = p₀ sin ω_d t,  r = k x + r_a",
        Axis::linear("", 0.0, 10.75),
        Axis::linear("", -0.9, 9.1),
        series,
    )
}

/// A zigzag between two ends at a height.
fn spring(from: f64, to: f64, height: f64) -> Vec<(f64, f64)> {
    let (start, end, turns) = (from + 0.6, to - 0.6, 12);
    let tooth = |i: i32| {
        let side = if i % 2 == 0 { 0.4 } else { -0.4 };
        (start + (end - start) * (f64::from(i) + 0.5) / f64::from(turns), height + side)
    };
    let ends = |x: f64, y: f64| [(x, height), (y, height)];
    ends(from, start).into_iter().chain((0..turns).map(tooth)).chain(ends(end, to)).collect()
}

fn law() -> Panel {
    let greatest = 12.0;
    let motion = settled(0.4, 6.0).map_or(Vec::new(), |steady| samples(0.4, 6.0, steady.state, 1));
    let points = motion.iter().map(|instant| (instant.state.v, instant.friction));
    Panel::new(
        "friction against velocity",
        Axis::linear("velocity x′/(Bω_d)", -greatest, greatest),
        Axis::linear("friction force r_a/r_y", -1.5, 1.5),
        vec![
            Series::new(
                "Coulomb's law",
                Style::Line,
                0,
                [(-greatest, -1.0), (0.0, -1.0), (0.0, 1.0), (greatest, 1.0)],
            ),
            Series::new("exact motion, Ω = 0.4, α = 6", Style::Dots, 3, points),
        ],
    )
}
