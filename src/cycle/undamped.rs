//! The cycle without damping, with some quantities computed immediately and others on demand.
//!
//! The peak velocity requires neither the deviation Δ₁ nor the circular functions of the half cycle, and
//! nothing else requires the contraction: each is computed on demand.

use super::half_cycle::HalfCycle;
use super::reversal::Reversal;
use super::stability::{Multipliers, contraction};
use super::velocity::waves::Circular;
use crate::cycle::phase_function::{Frequency, Offset, PhaseFunction};
use crate::float::pair::Pair;
use crate::float::{Float, fused};

/// A cycle without damping with known Δ₀, ω_d t₂, V₀ and ω_d t₁.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Undamped<F> {
    pub(super) reversal: Reversal<F>,
    /// Δ₀/B rounded, and its rounding remainder.
    pub(super) displacement: Pair<F>,
    /// The centred time ψ of the peak velocity.
    pub(super) psi: F,
    /// Δ₁/B, if the search for the peak velocity computed it.
    pub(super) deviation: Option<F>,
    /// The results of the wide arithmetic.
    pub(super) rounded: Option<Rounded<F>>,
}

/// A half cycle and the contraction, each rounded from more digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rounded<F> {
    half: HalfCycle<F>,
    contraction: F,
}

impl<F: Float> Undamped<F> {
    /// Converts each part of the cycle to another number type.
    pub(super) fn map<G: Float>(&self, omega: F, to: impl Fn(F) -> G) -> Undamped<G> {
        Undamped {
            reversal: self.reversal.map(&to),
            displacement: self.displacement.map(&to),
            psi: to(self.psi),
            deviation: Some(to(self.deviation(omega))),
            rounded: Some(Rounded {
                half: self.half(omega).map(&to),
                contraction: to(self.contraction(omega)),
            }),
        }
    }

    fn phase_function(&self, omega: F) -> PhaseFunction<F> {
        PhaseFunction::of_known(omega, self.reversal.phase_function())
    }

    /// The half cycle at its frequency ratio Ω.
    pub(super) fn half(&self, omega: F) -> HalfCycle<F> {
        match self.rounded {
            Some(rounded) => rounded.half,
            None => half_cycle(&self.phase_function(omega), self.displacement),
        }
    }

    /// Δ₁/B.
    #[inline]
    pub(super) fn deviation(&self, omega: F) -> F {
        match self.deviation {
            Some(known) => known,
            None => {
                let (k, psi) = (self.reversal.phase_function(), self.psi);
                fused!(<F>(omega: F, k: Pair<F>, psi: F) -> F {
                    let beta = Frequency::new(&Offset::new(), omega, k).sin_cos_beta();
                    Circular::new().deviation(omega, beta, k, psi)
                })
            }
        }
    }

    /// `max |λ|`.
    #[inline]
    pub(super) fn contraction(&self, omega: F) -> F {
        match self.rounded {
            Some(rounded) => rounded.contraction,
            None => {
                let (k, max_displacement) = (self.reversal.phase_function(), self.displacement.hi);
                fused!(<F>(omega: F, k: Pair<F>, max_displacement: F) -> F {
                    let p = PhaseFunction::of_known(omega, k);
                    contraction(omega, max_displacement, p.sin_cos_of_cycle())
                })
            }
        }
    }

    pub(super) fn multipliers(&self, omega: F) -> Multipliers<F> {
        Multipliers::new(omega, self.displacement.hi, self.half(omega).sin_cos_beta())
    }
}

/// The half cycle at the frequency ratio of `p` with the peak displacement Δ₀/B, rounded, and its
/// remainder.
pub(super) fn half_cycle<F: Float>(p: &PhaseFunction<F>, displacement: Pair<F>) -> HalfCycle<F> {
    HalfCycle::new(p, displacement.hi).with_rest(displacement.lo)
}
