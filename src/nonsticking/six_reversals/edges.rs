//! The force ratios of the six-reversal cycle at one Ω: its two edges.

use super::equations::Frequency;
use super::newton::polished;
use super::search::{Edge, Sample};
use crate::float::Float;
use crate::phase_function::PhaseFunction;

/// The least and the greatest α of the six-reversal cycle at the frequency ratio of `p`, on its edges; `None`
/// where there is no such cycle.
///
/// | side of the pole | least α | greatest α |
/// |---|---|---|
/// | Ω > 1/(2n+1), cot β > 0 | third reversal | third reversal |
/// | Ω < 1/(2n+1), cot β < 0 | third reversal; further away the second | second reversal |
pub(super) fn edges<F: Float>(p: &PhaseFunction<F>) -> Option<Edges<F>> {
    if !may_exist(p) {
        return None;
    }
    let frequency = Frequency::of(p);
    let (omega, cotangent) = (frequency.omega.to_f64(), frequency.cotangent().to_f64());
    // Closer to the pole both edges are those at this distance, the upper one with α, the short arc and cot β
    // in proportion.
    let near = cotangent.abs() < NEAREST;
    let there = if near { NEAREST.copysign(cotangent) } else { cotangent };
    let upper = if cotangent >= 0.0 { Edge::Third } else { Edge::Second };
    let tip = upper.tip(omega);
    let greatest = upper.with_cotangent(omega, there, SHORTEST, tip)?;
    let third = match upper {
        Edge::Third => Edge::Third.with_cotangent(omega, there, tip, LONGEST_THIRD),
        Edge::Second => Edge::Third.with_cotangent(omega, there, FIRST_QUARTER, LONGEST_THIRD),
    };
    // Beyond the corner of the two edges the third reversal's has the second within the friction bound.
    let slides = |sample: &Sample| upper == Edge::Third || sample.unknowns.forces(omega)[1] >= 1.0;
    let (edge, least) = match third.filter(slides) {
        Some(sample) => (Edge::Third, sample),
        None => (Edge::Second, Edge::Second.with_cotangent(omega, there, tip, LONGEST_SECOND)?),
    };
    let solved = |edge: Edge, sample: &Sample, scale: F| {
        let mut start = sample.unknowns.map(F::from_f64);
        if scale != F::int(1) {
            match edge {
                Edge::Second => start.before = start.before / scale,
                Edge::Third => start.after = start.after / scale,
            }
            (start.sine, start.cosine, start.swing) =
                (start.sine * scale, start.cosine * scale, start.swing * scale);
        }
        let start_ratio = start.force_ratio(frequency.omega);
        polished(frequency.omega, start, |y| y.residuals(&frequency, edge.closing()))
            .map(|found| found.force_ratio(frequency.omega))
            // Where the two edges meet neither is sharp: within rounding of that the start is as good.
            .unwrap_or(start_ratio)
    };
    let scale = if near { F::from_f64(NEAREST) / frequency.cotangent().abs() } else { F::int(1) };
    let (low, high) = (solved(edge, &least, F::int(1)), solved(upper, &greatest, scale));
    (low <= high).then_some(Edges { low, high, least: edge, side: upper })
}

/// The edges at one Ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edges<F> {
    pub(super) low: F,
    pub(super) high: F,
    /// The kind of the edge with the least α.
    pub(super) least: Edge,
    /// The kind of the edge with the greatest α, which depends on the side of the pole.
    pub(super) side: Edge,
}

/// Distance from the pole, as cot β, from which on f64 finds the start.
const NEAREST: f64 = 1e-7;
/// Shorter than any short arc from there on.
const SHORTEST: f64 = 1e-9;
/// Beyond the corner of the two edges, which is at 1.41 and 0.84.
const LONGEST_THIRD: f64 = 1.55;
const LONGEST_SECOND: f64 = 1.0;
/// On the third reversal's edge beyond its tip, where cot β > 0.
const FIRST_QUARTER: f64 = 0.7;

/// A cheap necessary condition on Ω: |cot β| is nowhere as large on the edges.
fn may_exist<F: Float>(p: &PhaseFunction<F>) -> bool {
    if p.omega() * F::int(2) >= F::int(1) {
        return false;
    }
    let tangent = p.tangent();
    if tangent > F::int(0) { tangent > F::int(30) } else { tangent < F::int(-17) }
}

/// A cheap necessary condition on (Ω, α) below the border: on the edges `AΩ² = αΩ²/(1 − Ω²)` is nowhere below
/// 5.
pub(super) fn is_strong_enough<F: Float>(omega: F, alpha: F) -> bool {
    let one = F::int(1);
    alpha * omega.square() > F::int(5) * (one - omega) * (one + omega)
}
