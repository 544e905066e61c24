//! The multiple of π/2 that is nearest to the reduced angle.

use crate::float::Float;

/// `(q mod 4, 1 − qΩ)` with `q = round(1/Ω)`.
///
/// The first branches are exact by Sterbenz's lemma. In the last, a quotient too large for the significand is
/// reduced again: one fused operation gives the remainder `1 − qΩ` of `q = fl(1/Ω)` exactly. Each pass
/// therefore takes [`Float::PRECISION`] bits off the quotient, and the bound on Ω bounds the passes by
/// `RATIO_EXPONENT / PRECISION + 2`.
#[inline(always)]
pub(super) fn nearest_quarter<F: Float>(omega: F) -> (u8, F) {
    if F::int(5) * omega >= F::int(2) { nearest_of_three(omega) } else { reduce_small(omega) }
}

/// [`nearest_quarter`] for Ω ≥ 2/5.
// Always inline: most callers of K do not use the angle, and then it is not computed.
#[inline(always)]
pub(super) fn nearest_of_three<F: Float>(omega: F) -> (u8, F) {
    let one = F::int(1);
    if omega >= F::int(2) {
        (0, one)
    } else if F::int(3) * omega >= F::int(2) {
        (1, one - omega)
    } else {
        (2, one - F::int(2) * omega)
    }
}

#[inline(always)]
pub(super) fn reduce_small<F: Float>(omega: F) -> (u8, F) {
    let mut quarter = 0;
    let mut rest = F::int(1);
    loop {
        let q = (rest / omega).round();
        quarter = (quarter + modulo_four(q)) & 3;
        rest = (-q).mul_add(omega, rest);
        if rest.abs() * F::int(2) <= omega {
            return (quarter, rest);
        }
    }
}

/// `q mod 4` of an integer q of either sign.
#[inline(always)]
pub(crate) fn modulo_four<F: Float>(q: F) -> u8 {
    let residue = q - F::int(4) * (q / F::int(4)).floor();
    (1..4).filter(|&n| residue >= F::int(n)).count() as u8
}
