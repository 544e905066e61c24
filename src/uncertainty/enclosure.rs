//! Guaranteed ranges where the body does not stick, by pieces of Ω on which K² and |1 − Ω²| are monotone.

use super::{Evidence, Interval, Range};
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::float::Float;
use alloc::vec::Vec;

/// A piece of Ω: the bounds of K² and of 1/|1 − Ω²| on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct OmegaPiece<F> {
    pub(super) omega: Interval<F>,
    pub(super) k_squared: Interval<F>,
    pub(super) resonance: Interval<F>,
}

/// The interval of two values in either order.
fn ordered<F: Float>(a: F, b: F) -> Interval<F> {
    if a <= b { Interval { low: a, high: b } } else { Interval { low: b, high: a } }
}

/// The pieces of an interval of Ω that contains neither 1 nor a pole 1/(2n+1): `count` of them, and one more
/// if K = 0 at an Ω inside.
pub(super) fn pieces<F: Float>(omega: Interval<F>, count: u32) -> Vec<OmegaPiece<F>> {
    let one = F::int(1);
    let count = if omega.is_exact() { 1 } else { i32::try_from(count.max(1)).unwrap_or(i32::MAX) };
    let mut ends: Vec<F> = (0..=count).map(|i| omega.at(F::ratio(i, count))).collect();
    // The only zero 1/(2n) that can lie inside, since there is a pole between any two zeros.
    let turns = F::int(2) * (one / (F::int(2) * omega.low)).floor();
    let zero = one / turns;
    if turns > F::int(0) && zero > omega.low && zero < omega.high {
        ends.push(zero);
        ends.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
    }
    // K² is zero at 1/(2n), which the type may not represent.
    let at = |omega: F| {
        let k = if omega == zero { F::int(0) } else { PhaseFunction::of_valid(omega).value() };
        (k.square(), one / one_minus_square(omega).abs())
    };
    let pairs = ends.windows(2).filter_map(|pair| pair.first().copied().zip(pair.last().copied()));
    pairs
        .map(|(low, high)| {
            let ((k_low, q_low), (k_high, q_high)) = (at(low), at(high));
            OmegaPiece {
                omega: Interval { low, high },
                k_squared: ordered(k_low, k_high).outward(10),
                resonance: ordered(q_low, q_high).outward(4),
            }
        })
        .collect()
}

/// The range that covers all of `ranges`.
pub(super) fn hull<F: Float>(ranges: impl Iterator<Item = Interval<F>>, sharp: bool) -> Option<Range<F>> {
    let all = ranges.reduce(|a, b| Interval {
        low: if b.low < a.low { b.low } else { a.low },
        high: a.high.or_larger(b.high),
    })?;
    let all = all.outward(8);
    Some(Range { low: all.low, high: all.high, evidence: Evidence::Guaranteed { sharp } })
}

impl<F: Float> OmegaPiece<F> {
    /// Bounds of `√(p² − K² r²)`: p the force, r the friction, in one unit.
    pub(super) fn root(&self, force: Interval<F>, friction: Interval<F>) -> Interval<F> {
        let root = |p: F, k_squared: F, r: F| {
            let kr = k_squared.sqrt() * r;
            // The radicand is not negative for a cycle that exists; where the bounds are negative, zero is a
            // bound as well.
            F::int(0).or_larger((p - kr) * (p + kr)).sqrt()
        };
        Interval {
            low: root(force.low, self.k_squared.high, friction.high),
            high: root(force.high, self.k_squared.low, friction.low),
        }
    }

    /// Bounds of `r √(p² − K² r²)`. Its square is a parabola in r², with its maximum at r² = p²/(2K²).
    pub(super) fn work(&self, force: Interval<F>, friction: Interval<F>) -> Interval<F> {
        let work = |p: F, k_squared: F, r: F| r * self.root_at(p, k_squared, r);
        let (a, b) = (
            work(force.low, self.k_squared.high, friction.low),
            work(force.low, self.k_squared.high, friction.high),
        );
        let (p, k_squared) = (force.high, self.k_squared.low);
        let best = p / (F::int(2) * k_squared).sqrt();
        let best = if best < friction.low {
            friction.low
        } else if best < friction.high {
            best
        } else {
            friction.high
        };
        Interval { low: if a < b { a } else { b }, high: work(p, k_squared, best) }
    }

    fn root_at(&self, force: F, k_squared: F, friction: F) -> F {
        let exact = |x| Interval { low: x, high: x };
        Self { k_squared: exact(k_squared), ..*self }.root(exact(force), exact(friction)).low
    }
}

impl<F: Float> Interval<F> {
    /// Widens the interval by `n` times the type's ε at each end, which exceeds the accumulated rounding.
    ///
    /// K is accurate to 2 units in the last place, so that the 10 units of K² leave 3 for the products with
    /// it. 1/|1 − Ω²| is accurate to 3, the border to 8, and products, quotients and roots to half a unit
    /// each.
    pub(super) fn outward(self, n: i32) -> Self {
        let share = F::int(n) * F::epsilon();
        Self { low: self.low - share * self.low.abs(), high: self.high + share * self.high.abs() }
    }

    /// The product of two intervals of nonnegative numbers.
    pub(super) fn times(self, other: Self) -> Self {
        Self { low: self.low * other.low, high: self.high * other.high }
    }

    /// The quotient of two intervals of positive numbers.
    pub(super) fn over(self, other: Self) -> Self {
        Self { low: self.low / other.high, high: self.high / other.low }
    }
}
