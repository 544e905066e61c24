//! The greatest velocity of a half cycle, for Ω ≥ 1/2, without branches: a start by algebra, the circular functions once, and
//! Taylor's formula from there.
//!
//! With the centred time ψ (`nonsticking::half_cycle`), `m = (1−Ω)ψ/2`, `p = ψ − m`, `e = κψ sin m/m`, `u` and `κ` of
//! [`Frequency`], the velocity and its derivative have a form without poles or cancellation for every Ω ≥ 1/2:
//!
//! ```text
//! v/(Bω_n) = Ω(Δ₀/B) cos Ωψ + e cos p + u sin ψ,   v′ = κ cos Ωψ − e sin p + u cos ψ − Ω²(Δ₀/B) sin Ωψ,
//! ```
//!
//! and [`Moment`] has the rest of the way.
//!
//! **Start.** Divided by cos Ωψ, v′ = 0 is an equation for `T = tan Ωψ`:
//! `Ω²(Δ₀/B) T = κ + u + (Ft²/2) T² [1 − (3 + t²) T²/12 + …]`, t = 1/Ω. Two of Newton's steps with one quotient: off by 2e-8 in the angle of
//! the faster wave for most points, by 0.03 for the worst (Ω just above 1/2, beside the border).

use super::arrival::{Fastest, Moment, Reciprocals};
use super::block::select;
use super::circular::{SinCos, TO_ONE, TO_QUARTER, held};
use super::frequency::Frequency;
use core::f64::consts::TAU;

/// The bounds of the polynomials for sine and cosine: of ψ and of m.
const GREATEST_PSI: f64 = 1.0625;
const GREATEST_HALF_DIFFERENCE: f64 = 0.28125;

/// The circular functions of ψ and of m.
#[derive(Clone, Copy)]
pub(crate) struct Circular {
    psi: SinCos<7, 6>,
    half_difference: SinCos<5, 4>,
    reciprocals: Reciprocals,
}

impl Circular {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { psi: held(TO_ONE), half_difference: held(TO_QUARTER), reciprocals: Reciprocals::new() }
    }
}

/// One half cycle.
#[derive(Clone, Copy)]
pub(crate) struct Waves {
    pub(crate) max_displacement: f64,
    pub(crate) at: Frequency,
}

impl Waves {
    /// A ψ near that of the greatest velocity.
    #[inline(always)]
    pub(crate) fn start(&self) -> f64 {
        let Frequency { omega, inverse, kappa, .. } = self.at;
        let g = omega * omega * self.max_displacement;
        let origin = kappa + self.at.offset();
        let inverse_square = inverse * inverse;
        let bend = 0.5 * inverse_square * self.at.forcing();
        let product = bend * origin;
        let square = g * g;
        // 1/(g(g² − 2bf)): the quotient of the first step, and with g² that of the second.
        let quotient = 1.0 / (g * (-2.0f64).mul_add(product, square));
        let tangent = origin * (square - product) * quotient;
        let z = tangent * tangent;
        let quartic = inverse_square.mul_add(-1.0 / 12.0, -0.25);
        let rest = (bend * z).mul_add(quartic.mul_add(z, 1.0), (-g).mul_add(tangent, origin));
        let tangent = (rest * square).mul_add(quotient, tangent);
        // An arctangent good to 1e-4.
        let z = tangent * tangent;
        let tail = (-0.13f64).mul_add(z, 0.2).mul_add(z, -1.0 / 3.0);
        tangent * z.mul_add(tail, 1.0) * inverse
    }

    /// The greatest velocity, from a ψ near it.
    #[inline(always)]
    pub(crate) fn arrive(&self, circular: &Circular, psi: f64) -> Fastest {
        let Frequency { omega, inverse, kappa, .. } = self.at;
        let (delta, offset) = (self.max_displacement, self.at.offset());
        let half_difference = 0.5 * (1.0 - omega) * psi;
        let (s, c) = circular.psi.sin_cos(psi);
        let (sinc, cm) = circular.half_difference.sinc_cos(half_difference);
        let sm = half_difference * sinc;
        let e = kappa * psi * sinc;
        let (sp, cp) = (s.mul_add(cm, -(c * sm)), c.mul_add(cm, s * sm));
        let (so, co) = (sp.mul_add(cm, -(cp * sm)), cp.mul_add(cm, sp * sm));
        let g = omega * delta;
        let (offset_c, e_sp, forcing) = (offset * c, e * sp, self.at.forcing());

        let beside = (-inverse * kappa).mul_add(co, offset_c - e_sp) - 1.0;
        let (sb, cb) = self.at.sin_cos_beta();
        let quotient = (sb - s) * (sb + s) / (c + cb);
        let above = (-sb * inverse).mul_add(co, quotient) * self.at.secant();
        let is_beside_one = omega < 2.0;

        let found = Moment {
            psi,
            velocity: g.mul_add(co, e.mul_add(cp, offset * s)),
            slope: (offset_c - e_sp) + (-omega * g).mul_add(so, kappa * co),
            displacement: (-delta).mul_add(so, select(is_beside_one, beside, above)),
            forcing: (forcing * s, forcing * c),
            square: omega * omega,
            slower: select(omega > 1.0, inverse, 1.0),
        }
        .fastest(&circular.reciprocals);
        let in_range = (psi.abs() <= GREATEST_PSI) & (half_difference.abs() <= GREATEST_HALF_DIFFERENCE);
        Fastest { is_found: found.is_found & in_range, ..found }
    }
}

/// A phase in [0, 2π) from one in [−2π, 2π).
#[inline(always)]
pub(crate) fn turned(phase: f64) -> f64 {
    /// The last number below 2π: a tiny negative phase is that, not 2π itself.
    const LAST: f64 = TAU.next_down();
    let phase = phase + select(phase < 0.0, TAU, 0.0);
    select(phase > LAST, LAST, phase)
}
