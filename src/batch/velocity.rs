//! The peak velocity and the contraction, for Ω ≥ 1/2.

use super::block::{AtPoint, select};
use crate::cycle::phase_function::{Frequency, Offset, Quotient};
use crate::cycle::stability::contraction;
use crate::cycle::{Circular, Waves, velocity_phase};
use crate::float::circular::held;
use crate::float::pair::Pair;

/// The quantities that depend on Ω alone.
#[derive(Clone, Copy)]
pub(crate) struct Parts(Quotient<f64>, Offset<f64>);

impl Parts {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(Quotient::new()), held(Offset::new()))
    }
}

impl AtPoint<1, 5> for Parts {
    /// `[K, the low part of K, 1/Ω, κ, u/(Ω − 1)]`.
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 5] {
        let k = self.0.at(omega);
        let Frequency { inverse, kappa, offset_slope, .. } = Frequency::new(&self.1, omega, k);
        [k.hi, k.lo, inverse, kappa, offset_slope]
    }
}

#[inline(always)]
fn waves([omega, max_displacement, inverse, kappa, offset_slope]: [f64; 5]) -> Waves<f64> {
    Waves { max_displacement, rest: 0.0, at: Frequency { omega, inverse, kappa, offset_slope } }
}

/// A phase ψ near the peak velocity.
pub(crate) struct Start;

impl AtPoint<5, 1> for Start {
    #[inline(always)]
    fn at(&self, given: [f64; 5]) -> [f64; 1] {
        [waves(given).start()]
    }
}

/// The peak velocity.
#[derive(Clone, Copy)]
pub(crate) struct Arrival(Circular<f64>);

impl Arrival {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(Circular::new()))
    }

    #[inline(always)]
    fn find(
        &self,
        [omega, delta, inverse, kappa, slope, psi, phase2, border, rest]: [f64; 9],
    ) -> ([f64; 3], f64) {
        let waves = Waves { rest, ..waves([omega, delta, inverse, kappa, slope]) };
        let (fastest, velocity) = waves.arrive(&self.0, psi);
        // Without a cycle there is nothing to find.
        let border = select(fastest.is_found | delta.is_nan(), border, f64::NAN);
        ([velocity, velocity_phase(phase2, omega, fastest.psi), border], fastest.psi)
    }
}

impl AtPoint<9, 3> for Arrival {
    /// `[V₀, ω_d t₁, α_min]`; a NaN in α_min means that the velocity must be recomputed.
    #[inline(always)]
    fn at(&self, given: [f64; 9]) -> [f64; 3] {
        self.find(given).0
    }
}

impl AtPoint<11, 4> for Arrival {
    /// V₀, its phase and Δ₁, for which K and its low part are also given.
    #[inline(always)]
    fn at(
        &self,
        [omega, delta, inverse, kappa, slope, psi, phase2, border, less, k, rest]: [f64; 11],
    ) -> [f64; 4] {
        let ([velocity, phase1, border], psi) =
            self.find([omega, delta, inverse, kappa, slope, psi, phase2, border, less]);
        let beta = Frequency { omega, inverse, kappa, offset_slope: slope }.sin_cos_beta();
        [velocity, phase1, border, self.0.deviation(omega, beta, Pair::new(k, rest), psi)]
    }
}

/// The contraction λ.
pub(crate) struct Contraction;

impl AtPoint<5, 1> for Contraction {
    #[inline(always)]
    fn at(&self, [omega, displacement, inverse, kappa, offset_slope]: [f64; 5]) -> [f64; 1] {
        let at = Frequency { omega, inverse, kappa, offset_slope };
        [contraction(omega, displacement, at.sin_cos_beta())]
    }
}
