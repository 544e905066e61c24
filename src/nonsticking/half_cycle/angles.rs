//! The circular functions of ψ and Ωψ, near Ω = 1 from those of their half sum and half difference.

use super::HalfCycle;
use crate::float::Float;
use crate::float::circular::sinc_cos_small;

/// Sine and cosine of the two angles ψ and Ωψ, and of their half sum and half difference.
pub(crate) struct Angles<F> {
    pub(super) psi: (F, F),
    pub(super) omega_psi: (F, F),
    pub(super) half_sum: (F, F),
    /// `sin m/(1 − Ω)`.
    pub(super) half_difference_slope: F,
}

impl<F: Float> Angles<F> {
    /// (sin ψ, cos ψ).
    #[inline]
    pub(crate) fn psi(&self) -> (F, F) {
        self.psi
    }
}

impl<F: Float> HalfCycle<F> {
    /// The half sum and half difference give the angles themselves, but only where neither outgrows the
    /// other.
    #[inline]
    pub(crate) fn angles(&self, psi: F) -> Angles<F> {
        if !self.beside_one {
            return Angles {
                psi: psi.sin_cos(),
                omega_psi: (self.omega * psi).sin_cos(),
                half_sum: (F::int(0), F::int(1)),
                half_difference_slope: F::int(0),
            };
        }
        let half = psi / F::int(2);
        let (sp, cp) = ((F::int(1) + self.omega) * half).sin_cos();
        let (slope, cm) = self.half_difference(half);
        let sm = self.one_minus_omega * slope;
        Angles {
            psi: (sp * cm + cp * sm, cp * cm - sp * sm),
            omega_psi: (sp * cm - cp * sm, cp * cm + sp * sm),
            half_sum: (sp, cp),
            half_difference_slope: slope,
        }
    }

    /// `(sin m/(1 − Ω), cos m)` of `m = (1 − Ω)ψ/2`, given ψ/2.
    #[inline]
    fn half_difference(&self, half: F) -> (F, F) {
        let m = self.one_minus_omega * half;
        match sinc_cos_small(m) {
            Some((sinc, c)) => (half * sinc, c),
            None => {
                let (s, c) = m.sin_cos();
                (s / self.one_minus_omega, c)
            }
        }
    }
}
