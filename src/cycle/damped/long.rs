//! The half period below Ω = 1/2, without branches, so that loops over it can be vectorised.
//!
//! With `c = e^{−ζT/2} cos(dT/2)` and `s = e^{−ζT/2} sin(dT/2)` the definitions of G and H, times `2de^{−ζT}`, are
//!
//! ```text
//! M = d [(1 − e^{−ζT})²/4 + c²],   G = [d (1 − e^{−2ζT})/4 − ζ s c]/M,   H = s c/(ΩM).
//! ```
//!
//! dT/2 is `π/2Ω − (1 − d) T/2`, and π/2Ω = qπ/2 + w, where 1 − qΩ is exact: the signs of s and c, which follow from q, are
//! those of s c alone.

use crate::float::circular::by_quarters;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// G and H below Ω = 1/2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Long<F> {
    /// 1/Ω.
    pub(crate) inverse: F,
    /// G.
    pub(crate) shift: Pair<F>,
    /// H.
    pub(crate) h: Pair<F>,
    /// `e^{−ζT}`, `e^{−ζT} cos dT` and `e^{−ζT} sin(dT)/d`.
    pub(crate) waves: [F; 3],
    /// Whether they are accurate at this Ω and ζ: otherwise they are meaningless.
    pub(crate) is_accurate: bool,
}

/// d, 1/Ω, and dT/2 as a number of quarter turns and what is left: the first of the parts of [`Long`], which are loops of
/// their own in a batch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turn<F> {
    pub(crate) d: Pair<F>,
    pub(crate) inverse: F,
    pub(crate) over_d: F,
    pub(crate) quarters: F,
    pub(crate) acute: Pair<F>,
}

impl<F: Float> Turn<F> {
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let (one, half) = (F::int(1), F::ratio(1, 2));
        // d, and 1/Ω and 1/d by one division.
        let square = Pair::two_prod(zeta, zeta);
        let rest = Pair::fast_two_sum(one, -square.hi);
        let root = rest.hi.sqrt();
        let both = one / (root * omega);
        let (near, over_d) = (both * root, both * omega);
        let low = ((-root).mul_add(root, rest.hi) + (rest.lo - square.lo)) * (half * over_d);
        let (d, inverse) = (Pair::fast_two_sum(root, low), Pair::reciprocal(omega, near));
        // The error of 1 − d is small compared with ζ, that of the exponent.
        let less = Pair::fast_two_sum(one - root, -low);
        let (q, left) = nearest(omega, near);
        let w = Pair::pi() * half * (inverse * left);
        let (turns, acute) = to_acute(w.normalised().plus(-(less * middle(inverse))));
        Self { d, inverse: near, over_d, quarters: turns + q, acute }
    }

    /// (sin, cos) of dT/2.
    #[inline(always)]
    pub(crate) fn sin_cos(&self) -> (Pair<F>, Pair<F>) {
        by_quarters(self.quarters, F::sin_cos_acute(self.acute))
    }
}

/// q of the nearest Ω = 1/q, and 1 − qΩ.
#[inline(always)]
fn nearest<F: Float>(omega: F, inverse: F) -> (F, F) {
    let q = inverse.round();
    (q, (-q).mul_add(omega, F::int(1)))
}

/// T/2.
#[inline(always)]
fn middle<F: Float>(inverse: Pair<F>) -> Pair<F> {
    Pair::pi() * F::ratio(1, 2) * inverse
}

/// `(e^{−ζT/2} − 1, e^{−ζT/2})`, given 1/Ω.
#[inline(always)]
pub(crate) fn falling<F: Float>(omega: F, zeta: F, inverse: F) -> (Pair<F>, Pair<F>) {
    (-(middle(Pair::reciprocal(omega, inverse)) * zeta)).exp_moderate()
}

impl<F: Float> Long<F> {
    /// At a frequency ratio and a damping ratio ζ > 0 that are in their domains, up to the precision of f64.
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let turn = Turn::at(omega, zeta);
        Self::of(omega, zeta, &turn, turn.sin_cos(), falling(omega, zeta, turn.inverse))
    }

    /// By the sine and cosine of dT/2, and `(e^{−ζT/2} − 1, e^{−ζT/2})`.
    #[inline(always)]
    pub(crate) fn of(
        omega: F,
        zeta: F,
        turn: &Turn<F>,
        (sine, cosine): (Pair<F>, Pair<F>),
        (fall, decay): (Pair<F>, Pair<F>),
    ) -> Self {
        let (zero, half) = (F::int(0), F::ratio(1, 2));
        let Turn { d, inverse: near, over_d, .. } = *turn;
        let inverse = Pair::reciprocal(omega, near);
        let (s, c) = (decay * sine, decay * cosine);
        // e^{−ζT} − 1
        let fall = fall * fall.plus(Pair::int(2));
        let product = s * c;
        let under = d * (fall * half).square().plus(c.square());
        // One quotient serves both.
        let over = Pair::int(1) / under;
        let rise = -(fall * fall.plus(Pair::int(2))) * F::ratio(1, 4);
        let shift = ((d * rise) - product * zeta) * over;
        let h = product * over * inverse;
        let (s, c) = (s.hi, c.hi);
        let waves = [decay.square().hi, (c - s) * (c + s), F::int(2) * over_d * (s * c)];
        let is_accurate = (zeta > zero)
            & (omega < half)
            & (omega >= F::ratio(1, 1024))
            & (zeta <= half)
            & (nearest(omega, near).1.abs() * F::int(2) <= omega)
            & (middle(inverse).hi * zeta * F::int(2) <= F::int(F::RATIO_EXPONENT));
        Self { inverse: near, shift: shift.normalised(), h: h.normalised(), waves, is_accurate }
    }
}

/// The nearest multiple of π/2, and what is left of an angle.
#[inline(always)]
pub(super) fn to_acute<F: Float>(angle: Pair<F>) -> (F, Pair<F>) {
    let turns = (angle.hi * (F::int(2) / F::pi())).round();
    (turns, angle - Pair::pi() * F::ratio(1, 2) * turns)
}
