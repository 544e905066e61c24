//! α − |K| so close to Ω = 1 that K as a pair does not have enough digits.
//!
//! On the border `α² − K² = (1/Ω² − 1)²` for Ω ≥ 1/2, with |1/Ω² − 1| = (2/π)|w|(1 + Ω)/Ω, and
//! |K| = (2/π)(1 + Ω)(1 − g), g = w²/3 + … ≥ 0. From α + |K| ≤ 2|K| + |1/Ω² − 1| it follows that
//!
//! ```text
//! α − |K| ≥ (w²/π) [(1 + Ω)/Ω²] / [1 + |w|/(2Ω)],
//! ```
//!
//! which is (2/π) w² at Ω = 1, of the order of g. In the expression
//!
//! ```text
//! (π/2)(α − |K|) = (π/2) α − (1 + Ω) + (1 + Ω) g,
//! ```
//!
//! π is taken in three parts, (1 + Ω) is exact, and g has its full relative accuracy.

use super::cotangent_defect;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// Whether Ω is so close to 1 that K as a pair may not have enough digits.
#[inline(always)]
pub(crate) fn is_close_to_one<F: Float>(omega: F) -> bool {
    let bits = if F::PRECISION < f64::MANTISSA_DIGITS { F::PRECISION as i32 / 2 - 2 } else { 24 };
    (omega - F::int(1)).abs() < F::exp2i(-bits)
}

/// `α − |K|` near Ω = 1.
pub(crate) fn excess_close_to_one<F: Float>(omega: F, alpha: F) -> Pair<F> {
    let (half, (second, third)) = (F::ratio(1, 2), F::pi_rest());
    let w = Pair::exact(F::int(1) - omega) / omega * (Pair::pi() * half);
    let one_plus = Pair::two_sum(F::int(1), omega);
    let bend = one_plus * cotangent_defect(w.square());
    let (first, second) = (Pair::two_prod(alpha, F::pi() * half), Pair::two_prod(alpha, second * half));
    let third = alpha * (third * half);
    let terms =
        [first.hi, -one_plus.hi, first.lo, -one_plus.lo, second.hi, bend.hi, bend.lo, second.lo, third];
    sum(terms) * (Pair::exact(F::int(2)) / Pair::pi())
}

/// The sum to three times the digits of its largest term, rounded to a pair.
#[inline(always)]
pub(crate) fn sum<F: Float, const N: usize>(terms: [F; N]) -> Pair<F> {
    let zero = F::int(0);
    let (mut high, mut middle, mut low) = (zero, zero, zero);
    for term in terms {
        let first = Pair::two_sum(high, term);
        let second = Pair::two_sum(middle, first.lo);
        (high, middle, low) = (first.hi, second.hi, low + second.lo);
    }
    let top = Pair::two_sum(high, middle);
    let rest = Pair::two_sum(top.lo, low);
    let all = Pair::two_sum(top.hi, rest.hi);
    Pair::new(all.hi, all.lo + rest.lo)
}
