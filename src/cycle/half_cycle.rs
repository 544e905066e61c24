//! The half cycle with x′ > 0 as a function of its centred time, smooth through Ω = 1.
//!
//! `ψ = ω_n(t₂ − t) − β` runs from β at the start (the minimum of x) to −β at t₂, β = π/2Ω. There
//!
//! ```text
//! v/(Bω_d)  = (Δ₀/B) cos Ωψ + H/Ω,        H = [sin ψ − sin β sin Ωψ]/cos β
//! x/B       = −1 − (Δ₀/B) sin Ωψ + J,     J = [cos ψ − (sin β/Ω) cos Ωψ]/cos β
//! ```
//!
//! H and J are 0/0 at Ω = 1. Near it they are computed from the half sum and half difference `p = (1+Ω)ψ/2`,
//! `m = (1−Ω)ψ/2` of the two angles, which leaves only quotients of small quantities that are known to full
//! relative accuracy. Far above it ψ is tiny and J − 1 is of the order 1/Ω²: there `cos ψ − cos β = (sin β −
//! sin ψ)(sin β + sin ψ)/(cos ψ + cos β)`.

use crate::cycle::phase_function::PhaseFunction;
use crate::float::circular::sinc_cos_small;
use crate::float::{Field, Float};

/// One half cycle: Ω, Δ₀/B and the circular functions of β.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfCycle<F> {
    omega: F,
    one_minus_omega: F,
    max_displacement: F,
    /// The rounding error of Δ₀/B, if known.
    displacement_rest: F,
    sin_beta: F,
    cos_beta: F,
    /// `(1 − Ω)/(Ω cos β)`, which is −2/π at Ω = 1.
    offset: F,
    beside_one: bool,
}

/// Velocity `v/(Bω_d)` and its first three derivatives by ψ at one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VelocityJet<F> {
    pub(crate) value: F,
    pub(crate) first: F,
    pub(crate) second: F,
    pub(crate) third: F,
    pub(crate) fourth: F,
}

/// `H/Ω` and its derivative by ψ away from Ω = 1: of ψ and Ωψ by their (sine, cosine), and of β.
#[inline(always)]
pub(crate) fn free_swing<R: Field>(
    omega: R,
    (sin_beta, cos_beta): (R, R),
    (s, c): (R, R),
    (so, co): (R, R),
) -> (R, R) {
    let scale = omega * cos_beta;
    ((s - sin_beta * so) / scale, (c - omega * sin_beta * co) / scale)
}

impl<F: Float> HalfCycle<F> {
    /// The half cycle at the frequency ratio of `p` with peak displacement Δ₀/B.
    #[inline]
    pub(crate) fn new(p: &PhaseFunction<F>, max_displacement: F) -> Self {
        let (sin_beta, cos_beta) = p.sin_cos();
        let (omega, beside_one) = (p.omega(), p.is_beside_one());
        let one_minus_omega = F::int(1) - omega;
        // (1 − Ω)/Ω = 2w/π, and w/sin w hardly feels an error of w.
        let offset = if beside_one {
            p.remainder() / (F::pi() * F::ratio(1, 2) * cos_beta)
        } else {
            one_minus_omega / (omega * cos_beta)
        };
        let displacement_rest = F::int(0);
        Self {
            omega,
            one_minus_omega,
            max_displacement,
            displacement_rest,
            sin_beta,
            cos_beta,
            offset,
            beside_one,
        }
    }

    /// This half cycle with the rounding error of Δ₀/B.
    #[inline]
    pub(crate) fn with_rest(self, displacement_rest: F) -> Self {
        Self { displacement_rest, ..self }
    }

    /// The rounding error of Δ₀/B.
    pub(crate) const fn displacement_rest(&self) -> F {
        self.displacement_rest
    }

    /// `(sin β, cos β)`, β = π/2Ω.
    #[inline]
    pub(crate) fn sin_cos_beta(&self) -> (F, F) {
        (self.sin_beta, self.cos_beta)
    }

    /// This half cycle at another precision: each field is converted on its own, 1 − Ω and cos β too, so
    /// that an Ω closer to 1 than the other type can resolve keeps its distance.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> HalfCycle<G> {
        HalfCycle {
            omega: to(self.omega),
            one_minus_omega: to(self.one_minus_omega),
            max_displacement: to(self.max_displacement),
            displacement_rest: to(self.displacement_rest),
            sin_beta: to(self.sin_beta),
            cos_beta: to(self.cos_beta),
            offset: to(self.offset),
            beside_one: self.beside_one,
        }
    }

    /// A half cycle within the range of f64 for the start of an iteration: below 2⁻²⁵⁰ only the ratio of
    /// 1 − Ω and cos β matters, and above 2²⁵⁰ only that Δ₀ is large.
    pub(crate) fn in_range(self) -> Self {
        let (least, greatest) = (F::exp2i(-F::RATIO_EXPONENT), F::exp2i(F::RATIO_EXPONENT));
        if !self.beside_one || self.one_minus_omega.abs() >= least {
            return self;
        }
        let scale = least / self.one_minus_omega.abs();
        Self {
            one_minus_omega: self.one_minus_omega * scale,
            cos_beta: self.cos_beta * scale,
            max_displacement: if self.max_displacement < greatest { self.max_displacement } else { greatest },
            ..self
        }
    }

    #[inline]
    pub(crate) fn omega(&self) -> F {
        self.omega
    }

    /// Peak displacement Δ₀/B.
    #[inline]
    pub(crate) fn max_displacement(&self) -> F {
        self.max_displacement
    }

    /// Ω < 1, decided by 1 − Ω itself.
    #[inline]
    pub(crate) fn is_below_one(&self) -> bool {
        self.one_minus_omega > F::int(0)
    }

    #[inline]
    pub(crate) fn cos_beta(&self) -> F {
        self.cos_beta
    }

    /// `(1 − sin β)/cos β = tan(π/4 − β/2)`, without cancellation where sin β > 0.
    #[inline]
    fn tan_half_offset(&self) -> F {
        self.cos_beta / (F::int(1) + self.sin_beta)
    }

    /// Velocity and its derivatives by ψ.
    #[inline]
    pub(crate) fn velocity(&self, psi: F) -> VelocityJet<F> {
        self.velocity_of(&self.angles(psi))
    }

    /// [`HalfCycle::velocity`] for known angles.
    #[inline]
    pub(crate) fn velocity_of(&self, angles: &Angles<F>) -> VelocityJet<F> {
        let &Angles { psi: (s, c), omega_psi: (so, co), half_sum: (sp, cp), half_difference_slope } = angles;
        let (omega, delta, cb) = (self.omega, self.max_displacement, self.cos_beta);
        // H/Ω and its derivative
        let (h, h1) = if self.beside_one {
            let tangent = self.tan_half_offset();
            let double = F::int(2) * half_difference_slope * self.offset;
            (double * cp + tangent * so / omega, (self.offset + tangent) * co - double * sp)
        } else {
            free_swing(omega, (self.sin_beta, cb), (s, c), (so, co))
        };
        let omega2 = omega.square();
        // Three terms of either sign: the product is the largest.
        let swing = delta * co;
        let value = swing + (h + self.displacement_rest.mul_add(co, delta.mul_add(co, -swing)));
        let first = h1 - omega * delta * so;
        // v″ + Ω²v = (Ω − 1/Ω) sin ψ/cos β
        let forcing = -(self.offset * (F::int(1) + omega));
        let second = forcing * s - omega2 * value;
        let third = forcing * c - omega2 * first;
        let fourth = -(forcing * s) - omega2 * second;
        VelocityJet { value, first, second, third, fourth }
    }

    /// The velocity `v/(Bω_d)` and its first eight derivatives by ψ at ψ = 0.
    #[inline]
    pub(crate) fn derivatives_at_centre(&self) -> [F; 9] {
        let (omega, one) = (self.omega, F::int(1));
        let first = if self.beside_one {
            self.offset + self.tan_half_offset()
        } else {
            (one - omega * self.sin_beta) / (omega * self.cos_beta)
        };
        // v″ + Ω²v = (Ω − 1/Ω) sin ψ/cos β
        let forcing = -(self.offset * (one + omega));
        let omega2 = omega.square();
        let swing = |v: F| -(omega2 * v);
        let (value, second) = (self.max_displacement, swing(self.max_displacement));
        let (third, fourth) = (swing(first) + forcing, swing(second));
        let (fifth, sixth) = (swing(third) - forcing, swing(fourth));
        let (seventh, eighth) = (swing(fifth) + forcing, swing(sixth));
        [value, first, second, third, fourth, fifth, sixth, seventh, eighth]
    }

    /// Displacement x/B at ψ.
    pub(crate) fn displacement(&self, psi: F) -> F {
        self.displacement_of(&self.angles(psi))
    }

    /// [`HalfCycle::displacement`] for known angles.
    #[inline]
    pub(crate) fn displacement_of(&self, angles: &Angles<F>) -> F {
        let &Angles { psi: (s, c), omega_psi: (so, co), half_sum: (sp, _), half_difference_slope } = angles;
        let (one, sb, cb) = (F::int(1), self.sin_beta, self.cos_beta);
        let j_less_one = if self.beside_one {
            let slope = self.tan_half_offset() / self.omega - self.offset;
            co * slope - F::int(2) * sp * (half_difference_slope * self.offset * self.omega) - one
        } else if self.omega > one {
            ((sb - s) * (sb + s) / (c + cb) - sb / self.omega * co) / cb
        } else {
            (c - sb / self.omega * co) / cb - one
        };
        j_less_one - self.max_displacement * so
    }
}

/// Sine and cosine of the two angles ψ and Ωψ, and of their half sum and half difference.
pub(crate) struct Angles<F> {
    pub(crate) psi: (F, F),
    pub(crate) omega_psi: (F, F),
    pub(crate) half_sum: (F, F),
    /// `sin m/(1 − Ω)`.
    pub(crate) half_difference_slope: F,
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

#[cfg(test)]
mod tests;
