//! Statements in addition to the identities of plain arithmetic: on the border, and as printed.

use super::super::Standing;
use super::super::terms::Terms;
use super::point::Edge;
use super::{Residual, Row};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use crate::nonsticking::den_hartog::{FallingHalf, phase_lag};
use crate::nonsticking::{cos_displacement_phase, matching::pi_1, printed, sin_displacement_phase};

/// The terms at a point, and the border there.
pub(super) struct Here<'a, const W: usize> {
    pub(super) terms: &'a Terms<'a, Ball<W>>,
    pub(super) edge: &'a Edge<W>,
}

impl<const W: usize> Here<'_, W> {
    /// Den Hartog's half cycle on the border, and ω_d t₂ there.
    fn touching(&self) -> (FallingHalf<Ball<W>>, Ball<W>) {
        let (c, alpha, s) = (self.terms, self.edge.min_force_ratio, self.edge.least_displacement);
        let (sine, cosine) =
            (sin_displacement_phase(s, alpha, c.one_minus_square), cos_displacement_phase(c.k, alpha));
        let phase = sine.atan2(cosine);
        let amplitude = alpha / c.one_minus_square;
        (FallingHalf { amplitude, phase_lag: phase_lag(phase), ..c.half }, phase)
    }

    fn is_above_zero(&self) -> bool {
        self.terms.k.is_positive()
    }
}

fn row<const W: usize>(
    equation: &'static str,
    statement: &'static str,
    standing: Standing,
    residual: fn(&Here<'_, W>) -> Option<Ball<W>>,
) -> Row<W> {
    Row { equation, statement, standing, residual: Residual::OfPoint(residual) }
}

pub(super) fn rows<const W: usize>() -> Vec<Row<W>> {
    let (holds, refuted) = (Standing::Holds, Standing::Refuted);
    vec![
        row("62", "on the border Den Hartog's velocity is zero at τ*", holds, |h| {
            let (half, _) = h.touching();
            Some(half.velocity(h.edge.phase))
        }),
        row("62", "and so is the acceleration there", holds, |h| {
            // x″ = α sin θ − x + 1
            let (half, phase) = h.touching();
            let drive = h.edge.min_force_ratio * (phase + h.edge.phase).sin();
            Some(drive - half.displacement(h.edge.phase) + Ball::int(1))
        }),
        row("62", "on the border Δ₀/B is S", holds, |h| {
            let (half, _) = h.touching();
            Some(half.displacement(Ball::int(0)) - h.edge.least_displacement)
        }),
        row("43", "as printed, π/2 < ω_d t₂ < 3π/2, fails where K > 0", refuted, |h| {
            let c = h.terms;
            h.is_above_zero().then(|| {
                let sine = c.unknowns.max_displacement / c.given.amplitude;
                (printed::displacement_phase(sine) - c.unknowns.displacement_phase) * c.scale
            })
        }),
        row("49", "as printed, both roots positive, fails for Ω > 1", refuted, |h| {
            let c = h.terms;
            c.sign.is_negative().then(|| {
                let cos_pi_1 = pi_1(c.given.omega).cos();
                let wrong = printed::max_velocity(c.given.omega, c.alpha, cos_pi_1, c.unknowns.deviation);
                (wrong / c.answers.max_velocity - Ball::int(1)) * c.scale
            })
        }),
        row("61", "as printed, sufficient, fails between 1/(2n+1) and 1/(2n)", refuted, |h| {
            let (edge, c) = (h.edge, h.terms);
            h.is_above_zero().then(|| (edge.min_force_ratio / edge.turning_point - Ball::int(1)) * c.scale)
        }),
    ]
}
