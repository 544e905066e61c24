//! The reduction of π/2Ω to the nearest multiple of π/2; for Ω < 1/2 without branches ([`LowAngle`]).

use super::PhaseFunction;
#[cfg(feature = "batch")]
use super::parts::remainder;
#[cfg(feature = "batch")]
use super::value::of_remainder;
use crate::float::Float;
use crate::float::pair::Pair;

/// `β = q π/2 + w`, |w| ≤ π/4.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LowAngle<F> {
    /// Whether q is even.
    is_even: bool,
    /// Whether sin β has the opposite sign of cos w (for an odd q) or of sin w (for an even q).
    is_turned: bool,
    w: Pair<F>,
}

impl<F: Float> LowAngle<F> {
    /// The angle for 2⁻¹⁰ ≤ Ω < 1/2, where 1/Ω has a fraction. The flag says whether q is the nearest
    /// integer, which rounding of 1/Ω can miss.
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn of_moderate(omega: F) -> (Self, bool) {
        let (one, four) = (F::int(1), F::int(4));
        let q = (one / omega).round();
        let rest = (-q).mul_add(omega, one);
        // q mod 4, in {−2, −1, 0, 1, 2}
        let quarter = (-four).mul_add((q * F::ratio(1, 4)).round(), q);
        let is_even = quarter.abs() != one;
        let is_turned = (quarter.abs() == F::int(2)) | (quarter == -one);
        (Self { is_even, is_turned, w: remainder(omega, rest) }, rest.abs() * F::int(2) <= omega)
    }

    /// The angle of a phase function for Ω < 1/2.
    #[inline(always)]
    pub(crate) fn of(p: &PhaseFunction<F>) -> Self {
        Self { is_even: p.quarter & 1 == 0, is_turned: p.quarter & 2 != 0, w: p.remainder }
    }

    /// K(Ω).
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn phase_function(&self, omega: F) -> Pair<F> {
        of_remainder(omega, self.is_even, self.w)
    }

    /// `(sin β, cos β)`.
    #[inline(always)]
    pub(crate) fn sin_cos(&self) -> (Pair<F>, Pair<F>) {
        let (s, c) = F::sin_cos_acute(self.w);
        let (sine, cosine) = if self.is_even { (s, c) } else { (c, -s) };
        if self.is_turned { (-sine, -cosine) } else { (sine, cosine) }
    }

    /// `γ = β mod π`, in [0, π).
    #[inline(always)]
    pub(crate) fn lobe_phase(&self) -> Pair<F> {
        let (pi, zero) = (Pair::pi(), F::int(0));
        let half = if self.is_even { Pair::exact(zero) } else { pi * F::ratio(1, 2) };
        let start = if self.is_even & (self.w.hi < zero) { pi } else { half };
        start + self.w
    }

    /// Whether T = tan β > 0.
    #[inline(always)]
    pub(crate) fn is_tangent_positive(&self) -> bool {
        self.is_even == (self.w.hi > F::int(0))
    }
}

#[cfg(test)]
mod tests {
    use crate::cycle::phase_function::nearest::{modulo_four, nearest_quarter};

    #[test]
    fn reduction_is_exact_for_huge_quotients() {
        // 1/Ω = 2²⁰⁰ is a multiple of 4. For 3·2⁻²⁰⁰, 1/Ω = 2²⁰⁰/3, whose fraction is 1/3.
        assert_eq!(nearest_quarter(2f64.powi(-200)), (0, 0.0));
        let omega = 3.0 * 2f64.powi(-200);
        let (quarter, rest) = nearest_quarter(omega);
        // 2²⁰⁰ ≡ 4 (mod 12): 1/Ω = 4j + 4/3, so q ≡ 1 and the fraction is +1/3.
        assert_eq!(quarter, 1);
        assert_eq!(rest * 3.0, omega);
    }

    /// For 2⁵³ < 1/Ω < 2⁵⁴ the first quotient is even, and the second adds to its residue.
    #[test]
    fn a_quotient_reduced_twice_keeps_both_residues() {
        let top = 1u128 << 106;
        for step in 0..200u64 {
            let m = (1u64 << 52) + step * 22_517_998_136_851 + 1;
            let q = (top + u128::from(m) / 2) / u128::from(m);
            let left = i128::try_from(top).unwrap() - i128::try_from(q * u128::from(m)).unwrap();
            let (quarter, rest) = nearest_quarter(m as f64 * 2f64.powi(-106));
            assert_eq!((u128::from(quarter), rest * 2f64.powi(106)), (q & 3, left as f64), "{m}");
        }
    }

    #[test]
    fn residues() {
        for (q, r) in [(0.0, 0), (1.0, 1), (6.0, 2), (-1.0, 3), (-4.0, 0), (7.0, 3), (2f64.powi(80), 0)] {
            assert_eq!(modulo_four(q), r, "{q}");
        }
    }
}
