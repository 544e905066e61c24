//! The force ratios of the six-reversal cycle at one Ω: its two edges.

use super::equations::{Frequency, Unknowns};
use super::newton::polished;
use super::search::{Edge, Sample};
use crate::cycle::phase_function::PhaseFunction;
use crate::float::Float;

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
    // Closer to the pole the least α is that at this distance.
    let there = if cotangent.abs() < NEAREST { NEAREST.copysign(cotangent) } else { cotangent };
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
    let low = polished_from(&frequency, edge, least.unknowns.map(F::from_f64));
    let high = greatest_at(&frequency, upper, &greatest);
    (low <= high).then_some(Edges { low, high, least: edge, side: upper })
}

/// α on an edge, from a start close to it.
fn polished_from<F: Float>(frequency: &Frequency<F>, edge: Edge, start: Unknowns<F>) -> F {
    polished(frequency.omega, start, |y| y.residuals(frequency, edge.closing()))
        // Where the two edges meet neither is sharp: within rounding of that the start is as good.
        .unwrap_or(start)
        .force_ratio(frequency.omega)
}

/// The greatest α, from its sample at this cot β or at [`NEAREST`].
///
/// At the pole the short arc vanishes as cot β, and the other unknowns increase as 1/cot β, so that the equations
/// lose the short arc in rounding. There α cot β, which is smooth, is extrapolated: the error of the parabola
/// through its values at t, 2t and 4t is about (20t)³, below a unit in the last place of p bits for the t taken.
fn greatest_at<F: Float>(frequency: &Frequency<F>, edge: Edge, sample: &Sample) -> F {
    let distance = frequency.cotangent().abs();
    let found = sample.unknowns.map(F::from_f64);
    let start = |distance: F| {
        let scale = F::from_f64(sample.cotangent.abs()) / distance;
        let mut start = found;
        match edge {
            Edge::Second => start.before = start.before / scale,
            Edge::Third => start.after = start.after / scale,
        }
        (start.sine, start.cosine, start.swing) =
            (start.sine * scale, start.cosine * scale, start.swing * scale);
        start
    };
    let bits = i32::try_from(F::PRECISION).unwrap_or(i32::MAX);
    let t = F::exp2i(-(bits / 3 + 5));
    if distance >= t {
        let near = distance < F::from_f64(NEAREST);
        return polished_from(frequency, edge, if near { start(distance) } else { found });
    }
    let sin_beta = if frequency.cotangent() < F::int(0) { F::int(-1) } else { F::int(1) };
    let product = |times: i32| {
        let cos_beta = t * F::int(times);
        let there = Frequency { sin_beta, cos_beta, ..*frequency };
        polished_from(&there, edge, start(cos_beta)) * cos_beta
    };
    let (one, two, four) = (product(1), product(2), product(4));
    let x = distance / t;
    let (by_one, by_two, by_four) = (x - F::int(1), x - F::int(2), x - F::int(4));
    let sum = by_two * by_four / F::int(3) * one - by_one * by_four / F::int(2) * two
        + by_one * by_two / F::int(6) * four;
    sum / distance
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
