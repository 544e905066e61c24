//! The loops over blocks below Ω = 1/2, by the same functions as a single point.

use super::amplitude::{Amplitude, Domain};
use super::block::{AtPoint, select};
use crate::cycle::phase_function::{LowAngle, one_minus_square_wide};
use crate::cycle::stability::contraction;
use crate::cycle::{LowCircular, LowWaves, border_near, velocity_phase};
use crate::float::circular::held;
use crate::float::pair::Pair;

/// The least Ω of these loops; below, the angle needs more than one reduction.
const LEAST_OMEGA: f64 = 1.0 / 1024.0;

/// Whether Ω is within the range of these loops.
#[expect(clippy::manual_range_contains, reason = "one condition, where `contains` is two branches")]
#[inline(always)]
pub(crate) fn has_low_loops(omega: f64) -> bool {
    (omega >= LEAST_OMEGA) & (omega < 0.5)
}

/// The quantities that depend on Ω alone.
#[derive(Clone, Copy)]
pub(crate) struct LowOmega;

impl AtPoint<1, 6> for LowOmega {
    /// `[K, the low part of K, 1/Ω, sin β, cos β, α_min]`; a NaN in α_min means that the point must be
    /// recomputed.
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 6] {
        let (angle, is_nearest) = LowAngle::of_moderate(omega);
        let k = angle.phase_function(omega);
        let (sine, cosine) = angle.sin_cos();
        let (border, is_found) = border_near(omega, &angle, k);
        let border = select(is_found & is_nearest & has_low_loops(omega), border, f64::NAN);
        [k.hi, k.lo, 1.0 / omega, sine.value(), cosine.value(), border]
    }
}

/// `[Δ₀, α_min, A₁]` from `[Ω, α, K, the low part of K, α_min]`; a NaN in α_min means that the point must be
/// recomputed.
#[derive(Clone, Copy)]
pub(crate) struct LowSizes(Domain);

impl LowSizes {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(Domain::new())
    }

    #[inline(always)]
    fn amplitude(&self, [omega, alpha, k, rest, border]: [f64; 5]) -> Amplitude {
        Amplitude::at(&self.0, omega, alpha, Pair::new(k, rest), one_minus_square_wide(omega), border)
    }
}

impl AtPoint<5, 3> for LowSizes {
    #[inline(always)]
    fn at(&self, given: [f64; 5]) -> [f64; 3] {
        let found = self.amplitude(given);
        [found.displacement(), found.border, found.size()]
    }
}

impl AtPoint<5, 6> for LowSizes {
    /// The outputs of the smaller loop, and `[ω_d t₂, A₂, the low part of Δ₀]`.
    #[inline(always)]
    fn at(&self, given: [f64; 5]) -> [f64; 6] {
        let found = self.amplitude(given);
        let (displacement, border) = (found.displacement(), found.border);
        [displacement, border, found.size(), found.phase(), found.inertia(given[0]), found.rest()]
    }
}

#[inline(always)]
fn waves([omega, max_displacement, rest, inverse, sin_beta, cos_beta]: [f64; 6]) -> LowWaves<f64> {
    LowWaves { omega, inverse, max_displacement, rest, beta: (sin_beta, cos_beta) }
}

/// A phase θ near the peak velocity.
#[derive(Clone, Copy)]
pub(crate) struct LowStart(LowCircular<f64>);

impl LowStart {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(LowCircular::new()))
    }
}

impl AtPoint<8, 1> for LowStart {
    /// `[θ]` from `[Ω, Δ₀, the low part of Δ₀, 1/Ω, sin β, cos β, α, ω_d t₂]`.
    #[inline(always)]
    fn at(&self, [a, b, c, d, e, f, alpha, phase2]: [f64; 8]) -> [f64; 1] {
        [waves([a, b, c, d, e, f]).start(&self.0, alpha, phase2)]
    }
}

/// The peak velocity.
#[derive(Clone, Copy)]
pub(crate) struct LowArrival(LowCircular<f64>);

impl LowArrival {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(LowCircular::new()))
    }
}

impl AtPoint<9, 4> for LowArrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]` from the same with θ in place of α, and α_min; a NaN in α_min means that the
    /// velocity must be recomputed.
    #[inline(always)]
    fn at(&self, [omega, delta, rest, inverse, sine, cosine, theta, phase2, border]: [f64; 9]) -> [f64; 4] {
        let waves = waves([omega, delta, rest, inverse, sine, cosine]);
        let (fastest, velocity) = waves.arrive(&self.0, phase2, theta);
        [
            velocity,
            velocity_phase(phase2, omega, fastest.psi),
            // Without a cycle there is nothing to find.
            select(fastest.is_found | delta.is_nan(), border, f64::NAN),
            fastest.displacement,
        ]
    }
}

/// The loop of [`LowArrival`] without the deviation Δ₁.
#[derive(Clone, Copy)]
pub(crate) struct LowPeak(LowArrival);

impl LowPeak {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(LowArrival::new())
    }
}

impl AtPoint<9, 3> for LowPeak {
    #[inline(always)]
    fn at(&self, given: [f64; 9]) -> [f64; 3] {
        let [velocity, phase, border, _] = self.0.at(given);
        [velocity, phase, border]
    }
}

/// The contraction λ from `[Ω, Δ₀, sin β, cos β]`.
pub(crate) struct LowContraction;

impl AtPoint<4, 1> for LowContraction {
    #[inline(always)]
    fn at(&self, [omega, displacement, sine, cosine]: [f64; 4]) -> [f64; 1] {
        [contraction(omega, displacement, (sine, cosine))]
    }
}
