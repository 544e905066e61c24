//! The equation of motion at one (Ω, α).

use crate::float::Float;
use crate::ratios::Ratios;

/// The equation of motion with what of it depends on (Ω, α) alone. α = 0 is free vibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Equation<F> {
    pub(crate) omega: F,
    pub(crate) alpha: F,
    half_sum: F,
    half_difference: F,
    per_one_plus: F,
    /// `2/(1 − Ω)`, not used at Ω = 1.
    double_per_one_minus: F,
}

impl<F: Float> Equation<F> {
    pub(crate) fn new(ratios: Ratios<F>) -> Self {
        Self::of(ratios.omega(), ratios.alpha())
    }

    /// Free vibration: no drive, and the unit of time 1/ω_n.
    pub(crate) fn free() -> Self {
        Self::of(F::int(1), F::int(0))
    }

    fn of(omega: F, alpha: F) -> Self {
        let (one, two) = (F::int(1), F::int(2));
        Self {
            omega,
            alpha,
            half_sum: (one + omega) / two,
            half_difference: (one - omega) / two,
            per_one_plus: one / (one + omega),
            double_per_one_minus: two / (one - omega),
        }
    }

    /// The circular functions and the quotients C, S, D of `slide` at φ.
    #[inline]
    pub(crate) fn waves(&self, phi: F) -> Waves<F> {
        let (sp, cp) = (self.half_sum * phi).sin_cos();
        let (sm, cm) = (self.half_difference * phi).sin_cos();
        let one = F::int(1);
        let q = if self.omega == one { phi } else { sm * self.double_per_one_minus };
        let free = (sp * cm + cp * sm, cp * cm - sp * sm);
        let drive = (sp * cm - cp * sm, cp * cm + sp * sm);
        let qc = q * cp;
        let s = if self.omega < one { drive.0 - self.omega * qc } else { free.0 - qc };
        Waves {
            free,
            drive,
            c: sp * q * self.per_one_plus,
            s: s * self.per_one_plus,
            d: (drive.0 + qc) * self.per_one_plus,
        }
    }

    /// The same at φ = π/Ω, by (sin β, cos β) of β = π/2Ω, Ω ≠ 1: there `m = β − π/2` and `p = m + π`.
    #[inline]
    pub(crate) fn half_turn(&self, (sin_beta, cos_beta): (F, F)) -> Waves<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let q = -(cos_beta * self.double_per_one_minus);
        let qc = -(q * sin_beta);
        Waves {
            free: (two * sin_beta * cos_beta, (cos_beta - sin_beta) * (cos_beta + sin_beta)),
            drive: (zero, -one),
            c: cos_beta * q * self.per_one_plus,
            s: -(self.omega * qc) * self.per_one_plus,
            d: qc * self.per_one_plus,
        }
    }
}

/// The circular functions and quotients of `slide` at one time.
pub(crate) struct Waves<F> {
    /// (sin φ, cos φ)
    pub(crate) free: (F, F),
    /// (sin Ωφ, cos Ωφ)
    pub(crate) drive: (F, F),
    pub(crate) c: F,
    pub(crate) s: F,
    pub(crate) d: F,
}
