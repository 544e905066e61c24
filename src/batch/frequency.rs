//! What depends on the frequency ratio alone, for the points of a block.

use super::block::select;
use super::circular::{sinc_cos, tan_quotient};
use crate::phase_function::one_minus_square;
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// The angle β = π/2Ω reduced as in [`crate::phase_function`], for Ω ≥ 1/2: β = q π/2 + w, q = 0, 1 or 2.
#[derive(Clone, Copy)]
pub(crate) struct Reduced {
    /// 1/Ω.
    pub(crate) inverse: f64,
    /// w, |w| ≤ π/4.
    pub(crate) remainder: f64,
    /// q = 1: 2/3 ≤ Ω < 2.
    pub(crate) is_beside_one: bool,
    /// q = 2: Ω < 2/3.
    pub(crate) is_low: bool,
}

#[inline(always)]
pub(crate) fn reduced(omega: f64) -> Reduced {
    let inverse = 1.0 / omega;
    let q = inverse.round_ties_even();
    let rest = (-q).mul_add(omega, 1.0);
    Reduced { inverse, remainder: FRAC_PI_2 * rest * inverse, is_beside_one: q == 1.0, is_low: q == 2.0 }
}

/// K(Ω) from its quotient, given numerator and denominator of `tan w/w` (or sine and cosine, which serve as well).
///
/// `(1 − Ω²) w (P/Q)/Ω` in general; `−(2/π)(1 + Ω) Q/P` where q = 1, where w and 1 − Ω vanish together.
#[inline(always)]
fn phase_function(omega: f64, r: &Reduced, p: f64, q: f64) -> f64 {
    let beside = -FRAC_2_PI * (1.0 + omega);
    let elsewhere = one_minus_square(omega) * r.inverse * r.remainder;
    let numerator = select(r.is_beside_one, beside, elsewhere) * select(r.is_beside_one, q, p);
    numerator / select(r.is_beside_one, p, q)
}

/// `(K, 1/Ω)` with the tangent alone.
#[inline(always)]
pub(crate) fn phase_function_alone(omega: f64) -> (f64, f64) {
    let r = reduced(omega);
    let (p, q) = tan_quotient(r.remainder);
    (phase_function(omega, &r, p, q), r.inverse)
}

/// What the full bundle needs of Ω.
#[derive(Clone, Copy)]
pub(crate) struct Frequency {
    pub(crate) inverse: f64,
    pub(crate) phase_function: f64,
    pub(crate) sin_beta: f64,
    pub(crate) cos_beta: f64,
    /// 1/cos β.
    pub(crate) secant: f64,
    /// `(1 − sin β)/cos β`.
    pub(crate) tan_half_offset: f64,
}

#[inline(always)]
pub(crate) fn frequency(omega: f64) -> Frequency {
    let r = reduced(omega);
    let (sinc, cosine) = sinc_cos(r.remainder);
    let sine = r.remainder * sinc;
    let turned = select(r.is_beside_one, cosine, sine);
    let sin_beta = select(r.is_low, -turned, turned);
    let upright = select(r.is_beside_one, -sine, cosine);
    let cos_beta = select(r.is_low, -upright, upright);
    // One quotient for both: the product of the two denominators.
    let one_plus = 1.0 + sin_beta;
    let shared = 1.0 / (cos_beta * one_plus);
    Frequency {
        inverse: r.inverse,
        phase_function: phase_function(omega, &r, sinc, cosine),
        sin_beta,
        cos_beta,
        secant: one_plus * shared,
        tan_half_offset: cos_beta * cos_beta * shared,
    }
}
