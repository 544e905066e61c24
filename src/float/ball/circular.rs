//! π, the circular functions and the exponential function.

use super::{Ball, Radius, bound, half_unit};
use crate::float::mp::Mp;
use crate::float::{Field, Float, Real};

impl<const LIMBS: usize> Real for Ball<LIMBS> {
    fn pi() -> Self {
        let mid = Mp::pi();
        Self { mid, rad: bound([half_unit(mid)]) }
    }

    /// `|sin x − sin a| ≤ |x − a|`, by the mean value theorem, and `≤ |cos a| r + r²/2`, by Taylor's. No
    /// value is beyond ±1.
    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        if self.rad >= Radius::ONE.scaled(1) {
            let all = Self { mid: Mp::ZERO, rad: Radius::ONE };
            return (all, all);
        }
        let (sine, cosine) = self.mid.sin_cos();
        let of = |mid: Mp<LIMBS>, other: Mp<LIMBS>| {
            let slope = Radius::above(other).plus(half_unit(other));
            let (r, bend) = (self.rad, self.rad.times(self.rad).scaled(-1));
            let moved = bound([slope.times(r), bend]);
            let moved = if moved < r { moved } else { bound([r]) };
            Self::new(mid, bound([moved, self.odd_rounding(mid)]))
        };
        (of(sine, cosine), of(cosine, sine))
    }

    #[inline(never)]
    fn sin(self) -> Self {
        if self.rad >= Radius::ONE.scaled(1) {
            return Self { mid: Mp::ZERO, rad: Radius::ONE };
        }
        let mid = self.mid.sin();
        Self::new(mid, bound([self.rad, self.odd_rounding(mid)]))
    }

    #[inline(never)]
    fn cos(self) -> Self {
        if self.rad >= Radius::ONE.scaled(1) {
            return Self { mid: Mp::ZERO, rad: Radius::ONE };
        }
        let mid = self.mid.cos();
        Self::new(mid, bound([self.rad, half_unit(mid)]))
    }

    /// With δ = x − a and t = tan a: `tan x − t = (1 + t²) tan δ/(1 − t tan δ)`, the addition theorem. For
    /// |δ| ≤ r < √2, `tan δ ≤ δ/(1 − δ²/2)` since sin δ ≤ δ and cos δ ≥ 1 − δ²/2 > 0. There is no pole
    /// between a and x where |t| tan r < 1.
    ///
    /// The result is the whole line where the ball may contain a pole.
    #[inline(never)]
    fn tan(self) -> Self {
        let r = self.rad;
        let mid = self.mid.tan();
        let rounding = self.odd_rounding(mid);
        let t = Radius::above(mid).plus(rounding);
        let turn = r.over(Radius::ONE.minus_down(r.times(r).scaled(-1)));
        let clear = Radius::ONE.minus_down(t.times(turn));
        let moved =
            if r.is_zero() { Radius::ZERO } else { bound([turn, t.times(t).times(turn)]).over(clear) };
        Self::new(mid, bound([moved, rounding]))
    }

    /// Seen from the origin, a point moves by δ with `tan δ = n/(d + p)`: n and p are its displacements
    /// across and along the direction to it, and d is its distance. For an ordinate within r of a and an
    /// abscissa within s of b, `|n| ≤ (|a| s + |b| r)/d` and `|p| ≤ r + s`.
    ///
    /// The result is all angles, 0 ± π, where the box may meet the origin or the cut along the negative
    /// abscissae.
    #[inline(never)]
    fn atan2(self, x: Self) -> Self {
        let all = || {
            let pi = Self::pi();
            Self::new(Mp::ZERO, Radius::above(pi.mid).plus(pi.rad))
        };
        if self.is_entire() || x.is_entire() {
            return all();
        }
        let is_exact_zero = self.mid.is_zero() && self.rad.is_zero();
        if self.contains_zero() && !is_exact_zero && !x.is_positive() || is_exact_zero && x.contains_zero() {
            return all();
        }
        // The midpoint must not be −0, whose angle to the negative abscissae is −π.
        let mid = if self.mid.is_zero() { Mp::ZERO } else { self.mid }.atan2(x.mid);
        let rounding = if mid.is_zero() && self.mid.is_zero() { Radius::ZERO } else { half_unit(mid) };
        if is_exact_zero || self.rad.is_zero() && x.rad.is_zero() {
            return Self::new(mid, bound([rounding]));
        }
        let distance = self.mid.hypot(x.mid);
        let distance = Radius::below(distance).minus_down(half_unit(distance));
        let across = bound([Radius::above(self.mid).times(x.rad), Radius::above(x.mid).times(self.rad)])
            .over(distance);
        let moved = across.over(distance.minus_down(bound([self.rad, x.rad])));
        if moved.is_infinite() { all() } else { Self::new(mid, bound([moved, rounding])) }
    }

    /// `self · a + b`, its midpoint rounded once.
    #[inline(never)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        if self.is_entire() || a.is_entire() || b.is_entire() {
            return Self::entire();
        }
        let mid = self.mid.mul_add(a.mid, b.mid);
        let (r, s) = (self.rad, a.rad);
        let moved = bound([Radius::above(self.mid).times(s), Radius::above(a.mid).times(r), r.times(s)]);
        Self::new(mid, bound([moved, b.rad, half_unit(mid)]))
    }
}

impl<const LIMBS: usize> Ball<LIMBS> {
    /// The rounding error of a function that is zero only at zero, and exact there.
    #[inline(never)]
    fn odd_rounding(self, value: Mp<LIMBS>) -> Radius {
        if self.mid.is_zero() && value.is_zero() { Radius::ZERO } else { half_unit(value) }
    }

    /// `cosh √x` and `sinh √x/√x` by their series `Σ xⁿ/(2n)!` and `Σ xⁿ/(2n + 1)!`. From a term on that is twice the next one at
    /// least, those left out are together no larger than it.
    #[must_use]
    pub(crate) fn hyperbolic(self) -> [Self; 2] {
        let (mut terms, size) = ([Self::int(1); 2], self.abs().upper());
        let (mut sums, mut even) = (terms, 0i32);
        // Beyond, sums of numbers of this size are of no use.
        while size <= Mp::of_int(1 << 16) && even < 1 << 12 {
            let [one, two, three] = [1, 2, 3].map(|more| Self::int(even.saturating_add(more)));
            terms = [terms[0] * self / (one * two), terms[1] * self / (two * three)];
            even = even.saturating_add(2);
            let [cosine, sine] = terms.map(|term| term.abs().upper());
            let is_falling = size + size <= (one * two).lower();
            if is_falling && cosine <= <Mp<LIMBS> as Float>::epsilon() {
                let left = [cosine, sine].map(|most| Self::new(Mp::ZERO, Radius::above(most)));
                let [first, second] = sums;
                return [first + terms[0] + left[0], second + terms[1] + left[1]];
            }
            sums = [sums[0] + terms[0], sums[1] + terms[1]];
        }
        [Self::entire(); 2]
    }

    /// `eˣ`: `|eˣ − eᵃ| = eᵃ |e^(x−a) − 1| ≤ eᵃ r/(1 − r)` for r < 1, since e^r ≤ 1/(1 − r) and so
    /// e^r − 1 ≤ r/(1 − r). For a greater r the values at both ends.
    #[must_use]
    pub(crate) fn exp(self) -> Self {
        if !self.is_entire() && self.rad >= Radius::ONE.scaled(-1) {
            let at = |x: Mp<LIMBS>| Self::exact(x).exp();
            return at(self.lower()).hull(&at(self.upper()));
        }
        let mid = self.mid.exp();
        let moved =
            Radius::above(mid).plus(half_unit(mid)).times(self.rad.over(Radius::ONE.minus_down(self.rad)));
        let moved = if self.rad.is_zero() { Radius::ZERO } else { moved };
        // e⁰ is exact.
        let rounding = if self.mid.is_zero() { Radius::ZERO } else { half_unit(mid) };
        Self::new(mid, bound([moved, rounding]))
    }
}
