//! Figures 4 to 7: peak displacement, phases and peak velocity.

use crate::shared::{evenly, from_rest, inverse_force_ratios, of_cycle, of_frequency_ratio};
use stickslip::Cycle;
use stickslip::cycle::printed;
use stickslip::motion::{LongRun, SteadyState};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::curve::resonant;

/// Ω from 0.1025 to 2, 0.005 apart: between the frequencies 1/n, where the motion depends on its start.
fn frequency_ratios() -> impl Iterator<Item = f64> + Clone {
    evenly(0.1025, 1.9975, 380)
}

/// Ω of the marks.
fn marked_frequency_ratios() -> impl Iterator<Item = f64> + Clone {
    evenly(0.1325, 1.9825, 38)
}

/// A value of the exact steady state from rest; NaN where there is none, infinite where the motion is
/// unbounded.
fn exact(omega: f64, alpha: f64, value: fn(&SteadyState<f64>) -> f64) -> f64 {
    match from_rest(omega, alpha) {
        Ok(LongRun::Unbounded { .. }) => f64::INFINITY,
        limit => limit.ok().as_ref().and_then(LongRun::steady_state).map_or(f64::NAN, value),
    }
}

/// The curve of a value of the closed-form cycle for each 1/α.
fn closed_curves(value: fn(&Cycle<f64>) -> f64) -> Vec<Series> {
    let curve = |(index, alpha, name): (usize, f64, String)| {
        let mut points: Vec<_> =
            frequency_ratios().map(|omega| (omega, of_cycle(omega, alpha, value))).collect();
        // The phases jump at Ω = 1.
        let below = points.iter().take_while(|(omega, _)| *omega < 1.0).count();
        points.insert(below, (1.0, f64::NAN));
        // Offset so that the marks of coinciding curves do not coincide.
        Series::new(name, Style::Marked(26 + index), index, points)
    };
    inverse_force_ratios(6).map(curve).collect()
}

/// For each 1/α, a line of the exact motion, resolved at its peaks, and marks of the closed form. The legend
/// has each line, and the marks once.
fn lines_and_marks(
    of_motion: fn(&SteadyState<f64>) -> f64,
    closed: fn(&Cycle<f64>) -> f64,
    closed_form: &str,
) -> Vec<Series> {
    let lines = inverse_force_ratios(6).map(|(index, alpha, name)| {
        let points = resonant(frequency_ratios(), &[1.0], |omega| exact(omega, alpha, of_motion));
        Series::new(format!("{name}, exact"), Style::Line, index, points).with_key(name)
    });
    let marks = inverse_force_ratios(6).map(|(index, alpha, name)| {
        let points = marked_frequency_ratios().map(|omega| (omega, of_cycle(omega, alpha, closed)));
        let series = Series::new(format!("{name}, {closed_form}"), Style::Marks, index, points);
        series.with_key(format!("marks: {closed_form}"))
    });
    lines.chain(marks).collect()
}

/// Figure 4: Δ₀/B, exact and by eq. 44.
pub(super) fn max_displacement() -> Figure {
    let mut series = lines_and_marks(|s| s.max_displacement.value, |c| c.max_displacement, "eq. 44");
    series.push(Series::unbounded([1.0]));
    Figure::single(
        "4",
        "Peak displacement",
        "Peak displacement Δ₀/B: exact (lines) and eq. 44 (marks). Left of its first mark, a line \
            has stops. Arrowhead: unbounded at Ω = 1.",
        of_frequency_ratio(0.0, 2.0),
        Axis::logarithmic("peak displacement Δ₀/B", 0.1, 1000.0),
        series,
    )
}

/// Figure 5: the phases of the maxima.
pub(super) fn phases() -> Figure {
    let panel = |title: &str, value| {
        Panel::new(
            title,
            of_frequency_ratio(0.3, 2.0),
            Axis::linear("phase (rad)", 0.0, 5.0),
            closed_curves(value),
        )
    };
    Figure::new(
        "5",
        "Phases of the peak velocity and the peak displacement",
        "Phases ω_d t₁ of the peak velocity (eq. 46) and ω_d t₂ of the peak displacement (eq. \
            43), for 1/α = 0.1 … 0.6 without sticking.",
        vec![
            panel("peak velocity, ω_d t₁", |c| signed(c.velocity_phase)),
            panel("peak displacement, ω_d t₂", |c| c.displacement_phase),
        ],
    )
}

/// A phase near 2π as the negative phase that it continues.
fn signed(phase: f64) -> f64 {
    if phase > 1.5 * std::f64::consts::PI { phase - std::f64::consts::TAU } else { phase }
}

/// Figure 6: Δ₁/B.
pub(super) fn deviation() -> Figure {
    Figure::single(
        "6",
        "Displacement at the peak velocity",
        "Displacement Δ₁/B at the peak velocity, without sticking. It grows with α for 1/2 < Ω < \
            1, and tends to zero above 1.",
        of_frequency_ratio(0.0, 2.0),
        Axis::linear("deviation Δ₁/B", 0.0, 2.5),
        closed_curves(|c| c.deviation()),
    )
}

/// Figure 7: V₀/(Bω_d), exact, by the corrected eq. 49, and as printed.
pub(super) fn max_velocity() -> Figure {
    let mut series = lines_and_marks(|s| s.max_velocity.value, |c| c.max_velocity, "closed form");
    for (index, alpha, _) in inverse_force_ratios(6) {
        let at = |omega| if omega == 1.0 { f64::INFINITY } else { as_printed(omega, alpha) };
        let dashed = resonant(frequency_ratios().filter(|&omega| omega > 0.5), &[1.0], at);
        series.push(Series::new("eq. 49 as printed", Style::Dashed, index, dashed));
    }
    series.push(Series::unbounded([1.0]));
    Figure::single(
        "7",
        "Peak velocity",
        "Peak velocity V₀/(Bω_d): exact (lines), eq. 49 corrected (marks) and as printed \
            (dashed), which is too large above Ω = 1.",
        of_frequency_ratio(0.0, 2.0),
        Axis::logarithmic("peak velocity V₀/(Bω_d)", 0.1, 1000.0),
        series,
    )
}

fn as_printed(omega: f64, alpha: f64) -> f64 {
    let deviation = of_cycle(omega, alpha, |c| c.deviation());
    printed::max_velocity(omega, alpha, (std::f64::consts::PI / omega).cos(), deviation)
}

#[cfg(test)]
mod tests {
    use super::{phases, signed};
    use std::f64::consts::TAU;

    #[test]
    fn a_phase_before_the_crest_of_the_drive_is_negative() {
        for phase in [0.0, 1.0, 4.7] {
            assert_eq!(signed(phase).to_bits(), phase.to_bits());
        }
        assert!((signed(TAU - 0.08) + 0.08).abs() < 1e-15);
        for series in &phases().panels[0].series {
            assert!(!series.points.iter().any(|(_, phase)| *phase >= 4.72), "{}", series.name);
        }
    }
}
