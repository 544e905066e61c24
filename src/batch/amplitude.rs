//! Δ₀ and the outputs that follow from it, by the same functions as a single point; and the domain of the
//! loops.

use super::block::{AtPoint, select};
use crate::cycle::Reversal;
use crate::cycle::border::turning_point_border;
use crate::cycle::phase_function::{Quotient, is_close_to_one, one_minus_moderate_square};
use crate::float::Float;
use crate::float::circular::held;
use crate::float::pair::Pair;

/// The range of Ω within which nothing overflows or underflows.
const LEAST_OMEGA: f64 = 0.5;
const GREATEST_OMEGA: f64 = 1_048_576.0;
/// The greatest α of [`crate::Ratios`], 2²⁵⁰.
const GREATEST_ALPHA: f64 = f64::from_bits((1023 + 250) << 52);

/// Whether Ω is within the range of the loops: not too close to 1.
#[inline(always)]
pub(crate) fn has_loops(omega: f64) -> bool {
    Between::new(LEAST_OMEGA, GREATEST_OMEGA).has(omega) & !is_close_to_one(omega)
}

/// A range of positive numbers, compared by their bits as integers, shifted so that the least is the first
/// integer.
#[derive(Debug, Clone, Copy)]
struct Between {
    offset: i64,
    greatest: i64,
}

impl Between {
    #[inline(always)]
    const fn new(least: f64, greatest: f64) -> Self {
        let offset = i64::MIN.wrapping_sub_unsigned(least.to_bits());
        Self { offset, greatest: offset.wrapping_add_unsigned(greatest.to_bits()) }
    }

    /// Whether least ≤ x ≤ greatest.
    #[inline(always)]
    const fn has(self, x: f64) -> bool {
        x.to_bits().cast_signed().wrapping_add(self.offset) <= self.greatest
    }
}

/// The limits for Ω and α.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Domain {
    omega: Between,
    alpha: Between,
    nan: f64,
}

impl Domain {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        held(Self {
            omega: Between::new(LEAST_OMEGA, GREATEST_OMEGA),
            alpha: Between::new(f64::MIN_POSITIVE, GREATEST_ALPHA),
            nan: f64::NAN,
        })
    }
}

/// The results at one point.
pub(crate) struct Amplitude {
    reversal: Reversal<f64>,
    /// α_min; NaN where the point must be recomputed.
    pub(crate) border: f64,
}

impl Amplitude {
    /// One point with Ω ≥ 1/2.
    #[inline(always)]
    pub(crate) fn high(domain: &Domain, omega: f64, alpha: f64, phase_function: Pair<f64>) -> Self {
        let one_minus_square = one_minus_moderate_square(omega);
        let border = turning_point_border(phase_function, one_minus_square, omega.wide()).value();
        let is_answered = domain.omega.has(omega) & !is_close_to_one(omega);
        Self::at(
            domain,
            omega,
            alpha,
            phase_function,
            one_minus_square,
            select(is_answered, border, domain.nan),
        )
    }

    /// One point whose border is known; NaN means that the point must be recomputed.
    #[inline(always)]
    pub(crate) fn at(
        domain: &Domain,
        omega: f64,
        alpha: f64,
        phase_function: Pair<f64>,
        one_minus_square: Pair<f64>,
        border: f64,
    ) -> Self {
        // Without a cycle, all results that depend on α are NaN. Δ₀ does not wait for the border.
        let reversal = Reversal::by_formula(phase_function, one_minus_square, alpha);
        let reversal = reversal.or_nan(alpha >= border, domain.nan);
        let is_answered = domain.alpha.has(alpha) & !reversal.falls_short(omega);
        Self { reversal, border: select(is_answered, border, domain.nan) }
    }

    /// Δ₀; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn displacement(&self) -> f64 {
        self.reversal.max_displacement()
    }

    /// The low part of the pair Δ₀; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn rest(&self) -> f64 {
        self.reversal.max_displacement_pair().lo
    }

    /// A₁; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn size(&self) -> f64 {
        self.reversal.loop_size_stiffness()
    }

    /// A₂; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn inertia(&self, omega: f64) -> f64 {
        self.reversal.loop_size_inertia(omega)
    }

    /// ω_d t₂; NaN where there is no cycle.
    #[inline(always)]
    pub(crate) fn phase(&self) -> f64 {
        self.reversal.displacement_phase()
    }
}

/// `[Δ₀, α_min, A₁]`; a NaN in α_min means that the point must be recomputed.
#[derive(Clone, Copy)]
pub(crate) struct Point(Quotient<f64>, Domain);

impl Point {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(Quotient::new()), Domain::new())
    }
}

impl AtPoint<2, 3> for Point {
    #[inline(always)]
    fn at(&self, [omega, alpha]: [f64; 2]) -> [f64; 3] {
        let found = Amplitude::high(&self.1, omega, alpha, self.0.at(omega));
        [found.displacement(), found.border, found.size()]
    }
}

/// `[Δ₀, α_min, A₁, ω_d t₂, the low part of Δ₀]` from `[Ω, α, K, the low part of K]`; a NaN in α_min means
/// that the point must be recomputed.
#[derive(Clone, Copy)]
pub(crate) struct Sizes(pub(crate) Domain);

impl AtPoint<4, 5> for Sizes {
    #[inline(always)]
    fn at(&self, [omega, alpha, k, rest]: [f64; 4]) -> [f64; 5] {
        let found = Amplitude::high(&self.0, omega, alpha, Pair::new(k, rest));
        [found.displacement(), found.border, found.size(), found.phase(), found.rest()]
    }
}

impl AtPoint<4, 6> for Sizes {
    /// The outputs of the smaller loop, and A₂.
    #[inline(always)]
    fn at(&self, [omega, alpha, k, rest]: [f64; 4]) -> [f64; 6] {
        let found = Amplitude::high(&self.0, omega, alpha, Pair::new(k, rest));
        let (displacement, border) = (found.displacement(), found.border);
        [displacement, border, found.size(), found.phase(), found.rest(), found.inertia(omega)]
    }
}

#[cfg(test)]
mod tests {
    use super::{Domain, has_loops};

    #[test]
    fn the_loops_reach_their_bounds_and_no_further() {
        let near = 2f64.powi(-24);
        let reached = [0.5, 0.7, 1.0 - near, 1.0 + near, 1_048_576.0];
        let beyond = [
            0.5f64.next_down(),
            0.0,
            -0.0,
            -0.7,
            (1.0 - near).next_up(),
            1.0,
            (1.0 + near).next_down(),
            1_048_576f64.next_up(),
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
            -f64::NAN,
        ];
        assert!(reached.into_iter().all(has_loops));
        for omega in beyond {
            assert!(!has_loops(omega), "{omega:e}");
        }
        let domain = Domain::new();
        let most = 2f64.powi(250);
        assert!([f64::MIN_POSITIVE, 1.0, most].into_iter().all(|alpha| domain.alpha.has(alpha)));
        for alpha in [f64::MIN_POSITIVE.next_down(), 0.0, -1.0, most.next_up(), f64::INFINITY, f64::NAN] {
            assert!(!domain.alpha.has(alpha), "{alpha:e}");
        }
    }
}
