//! The peak velocity of a half cycle, for Ω ≥ 1/2, without branches: a start by algebra, the circular
//! functions once, and Taylor's formula from there.
//!
//! With the centred time ψ ([`super::half_cycle`]), `m = (1−Ω)ψ/2`, `p = ψ − m`, `e = κψ sin m/m`, `u` and
//! `κ` of [`Frequency`], the velocity and its derivative have a form without poles or cancellation for every
//! Ω ≥ 1/2:
//!
//! ```text
//! v/(Bω_n) = Ω(Δ₀/B) cos Ωψ + e cos p + u sin ψ,   v′ = κ cos Ωψ − e sin p + u cos ψ − Ω²(Δ₀/B) sin Ωψ,
//! ```
//!
//! and [`ArrivalMoment`] has the rest of the way.
//!
//! **Start.** Divided by cos Ωψ, v′ = 0 is an equation for `T = tan Ωψ`:
//! `Ω²(Δ₀/B) T = κ + u + (Ft²/2) T² [1 − (3 + t²) T²/12 + …]`, t = 1/Ω. Two of Newton's steps with one
//! quotient: off by 2e-8 in the angle of the faster wave for most points, by 0.03 for the worst (Ω just above
//! 1/2, near the border).

use super::arrival::{ArrivalMoment, Arrived, Reciprocals};
use crate::cycle::deviation::of_fastest;
use crate::cycle::phase_function::Frequency;
use crate::float::Float;
use crate::float::circular::{SinCos, TO_ONE, TO_QUARTER};
use crate::float::pair::Pair;

/// The circular functions of ψ and of m.
#[derive(Clone, Copy)]
pub(crate) struct Circular<F> {
    psi: SinCos<F, 7, 6>,
    half_difference: SinCos<F, 5, 4>,
    reciprocals: Reciprocals<F>,
}

impl<F: Float> Circular<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { psi: TO_ONE.of(), half_difference: TO_QUARTER.of(), reciprocals: Reciprocals::new() }
    }
}

impl<F: Float> Circular<F> {
    /// Δ₁/B at the ψ of the peak velocity, from (sin β, cos β) and K.
    #[inline(always)]
    pub(crate) fn deviation(&self, omega: F, beta: (F, F), phase_function: Pair<F>, psi: F) -> F {
        // sin β = cos w, w = (π/2)(1 − Ω)/Ω, where |w| ≤ π/4: its error counts most there.
        let w = Pair::exact(F::int(1) - omega) / omega * (Pair::pi() * F::ratio(1, 2));
        let (_, cosine) = self.psi.wide(w);
        let is_beside_one = (omega < F::int(2)) & (F::int(3) * omega >= F::int(2));
        let sin_beta = if is_beside_one { cosine } else { Pair::exact(beta.0) };
        of_fastest(omega, (sin_beta, beta.1), phase_function, self.psi.sin_cos(psi))
    }
}

/// One half cycle.
#[derive(Clone, Copy)]
pub(crate) struct Waves<F> {
    pub(crate) max_displacement: F,
    /// The rounding error of Δ₀/B.
    pub(crate) rest: F,
    pub(crate) at: Frequency<F>,
}

impl<F: Float> Waves<F> {
    /// A ψ near that of the peak velocity.
    #[inline(always)]
    pub(crate) fn start(&self) -> F {
        let Frequency { omega, inverse, kappa, .. } = self.at;
        let (one, half) = (F::int(1), F::ratio(1, 2));
        let g = omega * omega * self.max_displacement;
        let origin = kappa + self.at.offset();
        let inverse_square = inverse * inverse;
        let bend = half * inverse_square * self.at.forcing();
        let product = bend * origin;
        let square = g * g;
        // 1/(g(g² − 2bf)): the quotient of the first step, and with g² that of the second.
        let quotient = one / (g * F::int(-2).mul_add(product, square));
        let tangent = origin * (square - product) * quotient;
        let z = tangent * tangent;
        let quartic = inverse_square.mul_add(F::ratio(-1, 12), F::ratio(-1, 4));
        let rest = (bend * z).mul_add(quartic.mul_add(z, one), (-g).mul_add(tangent, origin));
        let tangent = (rest * square).mul_add(quotient, tangent);
        // An arctangent good to 1e-4.
        let z = tangent * tangent;
        let tail = F::ratio(-13, 100).mul_add(z, F::ratio(1, 5)).mul_add(z, F::ratio(-1, 3));
        tangent * z.mul_add(tail, one) * inverse
    }

    /// The peak velocity, from a ψ near it; and V₀/(Bω_d), whose largest term is Δ₀/B, without the
    /// roundings of Ω and of cos Ωψ.
    #[inline(always)]
    pub(crate) fn arrive(&self, circular: &Circular<F>, psi: F) -> (Arrived<F>, F) {
        let Frequency { omega, inverse, kappa, .. } = self.at;
        let (one, half) = (F::int(1), F::ratio(1, 2));
        let (delta, offset) = (self.max_displacement, self.at.offset());
        let half_difference = half * (one - omega) * psi;
        let (s, fall) = circular.psi.sin_fall(psi);
        let c = one + fall;
        let (sinc, cm) = circular.half_difference.sinc_cos(half_difference);
        let sm = half_difference * sinc;
        let e = kappa * psi * sinc;
        let (sp, cp) = (s.mul_add(cm, -(c * sm)), c.mul_add(cm, s * sm));
        // Ωψ = p − m = ψ − 2m: sin Ωψ = sin ψ − 2 sin m cos p, cos Ωψ − 1 = cos ψ − 1 + 2 sin m sin p.
        let twice = sm + sm;
        let (so, fall) = ((-twice).mul_add(cp, s), twice.mul_add(sp, fall));
        let co = one + fall;
        let g = omega * delta;
        let (offset_c, e_sp, forcing) = (offset * c, e * sp, self.at.forcing());
        let swing = e.mul_add(cp, offset * s);
        let found = ArrivalMoment {
            psi,
            // v/(Bω_n) = Ω(Δ₀/B) cos Ωψ + e cos p + u sin ψ
            velocity: g.mul_add(co, swing),
            slope: (offset_c - e_sp) + (-omega * g).mul_add(so, kappa * co),
            // Δ₁ has a form of its own from Ω = 1/2 on ([`Circular::deviation`]).
            displacement: F::int(0),
            forcing: (forcing * s, forcing * c),
            square: omega * omega,
            slower: if omega > one { inverse } else { one },
        }
        .fastest(&circular.reciprocals);
        // The bounds of the polynomials for sine and cosine: of ψ and of m.
        let (greatest_psi, greatest_half_difference) = (F::ratio(17, 16), F::ratio(9, 32));
        let in_range = (psi.abs() <= greatest_psi) & (half_difference.abs() <= greatest_half_difference);
        let smaller = self.rest.mul_add(co, inverse * swing);
        let less = inverse.mul_add(found.gain, delta.mul_add(fall, smaller));
        (Arrived { is_found: found.is_found & in_range, ..found }, delta + less)
    }
}
