//! The reduction of π/2Ω to the nearest multiple of π/2.

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
fn reduce_small<F: Float>(omega: F) -> (u8, F) {
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

#[cfg(test)]
mod tests {
    use super::{modulo_four, nearest_quarter};

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
