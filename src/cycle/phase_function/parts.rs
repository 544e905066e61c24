//! The parts of the phase function: K, its angle, and 1 − Ω².

use super::nearest::nearest_quarter;
use crate::float::pair::Pair;
use crate::float::{Field, Float, Real};

/// `K = (1 − Ω²) T/Ω` from the frequency ratio Ω and the tangent `T = tan(π/2Ω)`.
///
/// This is the definition, for any number that has the field operations. [`PhaseFunction::value`] is the form
/// that is smooth through Ω = 1.
#[inline(always)]
pub fn phase_function_of_tangent<R: Field>(omega: R, tangent: R) -> R {
    // K = (1 − Ω²) T/Ω
    one_minus_square(omega) * tangent / omega
}

/// `1 − Ω²` as the product `(1 − Ω)(1 + Ω)`, which keeps its relative accuracy at Ω = 1.
#[inline(always)]
pub(crate) fn one_minus_square<R: Field>(omega: R) -> R {
    // 1 − Ω² = (1 − Ω)(1 + Ω)
    (R::int(1) - omega) * (R::int(1) + omega)
}

/// A validated frequency ratio Ω with its reduced angle `β = π/2Ω` and K(Ω): the quantities that depend on Ω
/// alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct PhaseFunction<F> {
    pub(super) omega: F,
    pub(super) quarter: u8,
    pub(super) remainder: Pair<F>,
    pub(super) value: Pair<F>,
}

/// `(q mod 4, w)` of the angle `β = q π/2 + w`, `w = (π/2) (1 − qΩ)/Ω`, where 1 − qΩ is exact.
#[inline(always)]
pub(crate) fn reduced<F: Float>(omega: F) -> (u8, Pair<F>) {
    let (quarter, rest) = nearest_quarter(omega);
    (quarter, remainder(omega, rest))
}

/// `w = (π/2) (1 − qΩ)/Ω` from 1 − qΩ.
#[inline(always)]
pub(super) fn remainder<F: Float>(omega: F, rest: F) -> Pair<F> {
    (Pair::exact(rest) / omega * (Pair::pi() * F::ratio(1, 2))).normalised()
}

/// `1 − Ω²`, exact except for the rounding of the low part.
#[inline(always)]
pub(crate) fn one_minus_square_wide<F: Float>(omega: F) -> Pair<F> {
    let square = Pair::two_prod(omega, omega);
    let Pair { hi, lo } = Pair::two_sum(F::int(1), -square.hi);
    Pair::new(hi, lo - square.lo)
}

/// `1 − Ω²` for Ω ≤ 2²⁰, in fewer operations: 1 is a multiple of the last place of Ω², so that the sum is
/// exact.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn one_minus_moderate_square(omega: f64) -> Pair<f64> {
    let square = Pair::two_prod(omega, omega);
    // The fast sum of 1 and −Ω², written as a difference, which saves a negation.
    let hi = 1.0 - square.hi;
    Pair::new(hi, ((1.0 - hi) - square.hi) - square.lo)
}

/// (sin, cos) of `q π/2 + w` from those of w.
#[inline]
pub(crate) fn turned<R: Field>(quarter: u8, (s, c): (R, R)) -> (R, R) {
    match quarter {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// `tan(q π/2 + w)`.
#[inline]
pub(crate) fn tangent<R: Real>(quarter: u8, w: R) -> R {
    let t = w.tan();
    if quarter & 1 == 0 { t } else { -(R::int(1) / t) }
}

/// Whether π/2 itself is the multiple of π/2 nearest to π/2Ω: 2/3 ≤ Ω < 2, the neighbourhood of Ω = 1.
#[inline]
pub(super) fn is_beside_one<F: Float>(omega: F) -> bool {
    omega < F::int(2) && F::int(3) * omega >= F::int(2)
}
