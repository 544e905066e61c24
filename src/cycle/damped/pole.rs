//! The half period beside the pole at Ω = 1, ζ = 0, where G, H → ∞ and q → 0: its divisions are carried out
//! beforehand, so that no digit is lost however near the pole is.
//!
//! With λ = −ζ + id, d = √(1 − ζ²), the matching conditions of the cycle are solved by `t = tanh(λT/2)`:
//! `ΩH = Im t/d`, `G = −Re t − (ζ/d) Im t`. Because `tanh(u + iπ/2) = coth u`,
//!
//! ```text
//! t = coth v = P/v,   v = (λ − iΩ) T/2 = −(T/2)(ζ + ig),   g = Ω − d = (Ω − 1) + ζ²/(1 + d),
//! P = v coth v = p + ir = 1 + v²/(3 + v²/(5 + v²/(7 + …))).
//! ```
//!
//! With `m = ζ² + g²`, h = pg − rζ, k = pζ + rg, and because the stiffness vanishes at iΩ = λ as 1/v grows:
//!
//! ```text
//! q² = m (1 + Ω² + 2Ωd),   H = 2h/(πdm),   G = 2Ω (k − ζh/d)/(πm),
//! (πQ/2)² = Ω² (1 + Ω² + 2Ωd) (|P|² + E),   Q = q √(G² + H²),
//! E = {h² [(1 − Ωd)(1 + Ωd)/(Ωd)² + (ζ/d)²] − 2 (ζ/d) hk}/m.
//! ```
//!
//! Q² is 16/π² but for a part of the order of q, and `α² − Q²`, of which Δ₀ is made ([`Pole::excess`]), is of
//! the order of q or of q² on the border: each is the difference of two pairs of the order of q, with π in
//! three parts.

use super::free::Free;
use crate::cycle::phase_function::sum;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// The half period beside the pole.
pub(super) struct Pole<F> {
    /// q.
    pub(super) stiffness: Pair<F>,
    /// G.
    pub(super) shift: Pair<F>,
    /// H.
    pub(super) h: Pair<F>,
    /// `(πQ/2)² − 4`.
    pub(super) beyond: Pair<F>,
}

/// A complex number (real, imaginary).
type Complex<R> = (R, R);

#[inline(always)]
fn product<R: Field>((a, b): Complex<R>, (c, d): Complex<R>) -> Complex<R> {
    (a * c - b * d, a * d + b * c)
}

#[inline(always)]
fn quotient<R: Field>((a, b): Complex<R>, (c, d): Complex<R>) -> Complex<R> {
    let size = c.square() + d.square();
    ((a * c + b * d) / size, (b * c - a * d) / size)
}

/// `P − 1` from v², for |v|² ≤ 2/3.
///
/// Only the two outer levels of the fraction are computed in pairs: an error of the others is reduced more
/// than twenty times, and vanishes as v⁴.
#[inline(always)]
fn defect<F: Float>(square: Complex<Pair<F>>) -> Complex<Pair<F>> {
    let tail = tail((square.0.hi, square.1.hi));
    quotient(square, (Pair::fast_two_sum(F::int(3), tail.0), Pair::exact(tail.1)))
}

/// `z/(5 + z/(7 + …))`: up to the precision of f64 the convergent of level 17, as one quotient.
#[inline(always)]
fn tail<F: Float>(z: Complex<F>) -> Complex<F> {
    let n = F::int;
    if const { F::PRECISION <= f64::MANTISSA_DIGITS } {
        let next = |sum: Complex<F>, coefficient: i32| {
            let (re, im) = product(sum, z);
            (re + n(coefficient), im)
        };
        let numerator = [96_525, 2_297_295].into_iter().fold((z.0 + n(858), z.1), next);
        let denominator = [12_870, 810_810, 11_486_475].into_iter().fold((n(44), n(0)), next);
        return quotient(product(z, numerator), denominator);
    }
    // Each level removes at least five bits of the error.
    let last = i32::try_from(F::precision() / 5).unwrap_or(i32::MAX).saturating_add(3);
    (2..=last).rev().fold((n(0), n(0)), |(re, im), level| {
        quotient(z, (n(level.saturating_mul(2).saturating_add(1)) + re, im))
    })
}

impl<F: Float> Pole<F> {
    /// At an Ω in [1/2, 2] and a ζ > 0, where |v|² ≤ 2/3.
    #[inline(always)]
    pub(super) fn beside(omega: F, zeta: F) -> Option<Self> {
        let (one, two) = (F::int(1), F::int(2));
        if omega < F::ratio(1, 2) || omega > two || zeta * two > one {
            return None;
        }
        let half = F::pi() / (two * omega);
        let near = half.square() * (zeta.square() + (omega - one).square());
        // ζ²/(1 + d) adds less than a quarter of ζ to |Ω − 1|.
        if near > F::ratio(1, 2) { None } else { Some(Self::at(omega, zeta)) }
    }

    #[inline(always)]
    fn at(omega: F, zeta: F) -> Self {
        let (one, two) = (Pair::int(1), Pair::int(2));
        let (narrow, omega, zeta) = (omega, omega.wide(), zeta.wide());
        let d = Free::new(zeta).frequency;
        let less = zeta.square() / (one + d);
        let g = Pair::exact(narrow - F::int(1)) + less;
        let half = Pair::pi() / (omega * two);
        let m = zeta.square() + g.square();
        let scale = half.square();
        let (c, r) = defect((scale * (zeta.square() - g.square()), scale * (zeta * g).times(2)));
        let p = one + c;
        let (h, k) = (p * g - r * zeta, p * zeta + r * g);
        let (ratio, turn) = (zeta / d, omega * d);
        let factor = one + omega.square() + turn.times(2);
        // 1 − Ωd, d² = 1 − ζ²
        let slower = zeta.square() - g * d;
        let bend = h.square() * (slower * (one + turn) / turn.square() + ratio.square());
        let e = (bend - (ratio * h * k).times(2)) / m;
        // Ω²(1 + Ω² + 2Ωd) = [Ω(1 + Ω)]² − 2Ω³(1 − d), and Ω(1 + Ω) = 2 + y.
        let off = Pair::exact(narrow - F::int(1));
        let y = off * (off + Pair::int(3));
        let more = y * (y + Pair::int(4)) - (omega * omega.square() * less).times(2);
        // |P|² − 1
        let size = c.times(2) + c.square() + r.square();
        Self {
            stiffness: (m * factor).sqrt(),
            shift: (k - ratio * h) / (half * m),
            h: h.times(2) / (Pair::pi() * d * m),
            beyond: more + (more + Pair::int(4)) * (size + e),
        }
    }

    /// `α² − Q²` from `(πQ/2)² − 4`: negative where α is below Q.
    #[inline(always)]
    pub(super) fn excess(beyond: Pair<F>, alpha: F) -> Pair<F> {
        let (half, (second, third)) = (F::ratio(1, 2), F::pi_rest());
        let (first, second) = (Pair::two_prod(alpha, F::pi() * half), Pair::two_prod(alpha, second * half));
        // (π/2) α − 2
        let over = sum([first.hi, -F::int(2), first.lo, second.hi, second.lo, alpha * (third * half)]);
        let all = over * (over + Pair::int(4)) - beyond;
        all * (Pair::int(2) / Pair::pi()).square()
    }
}

#[cfg(test)]
mod tests {
    use super::Pole;

    #[test]
    fn it_reaches_as_far_as_the_fraction_converges() {
        assert!(Pole::<f64>::beside(1.0, 1e-9).is_some() && Pole::beside(1.1f64, 0.3).is_some());
        for (omega, zeta) in [(0.4f64, 1e-3), (2.5, 1e-3), (1.0, 0.6), (0.65, 1e-3)] {
            assert!(Pole::beside(omega, zeta).is_none(), "{omega} {zeta}");
        }
    }

    /// All of it agrees with the definitions at twelve times the digits.
    #[cfg(feature = "mp")]
    #[test]
    fn its_quantities_are_those_of_the_definition() {
        use crate::cycle::damped::half_period::definition::{Wide, is_near, responses, wide};
        use crate::float::Field;
        for off in [-0.24, -1e-3, -1e-9, -1.2e-16, 0.0, 2.3e-16, 1e-12, 1e-5, 0.3, 0.6] {
            for zeta in [1e-30, 1e-20, 1e-12, 1e-6, 1e-3, 0.1, 0.3] {
                let omega: f64 = 1.0 + off;
                let Some(found) = Pole::beside(omega, zeta) else { continue };
                let (g, h) = responses(omega, zeta);
                let (o, z, one) = (Wide::from(omega), Wide::from(zeta), Wide::int(1));
                let q = (z * o).times(2).hypot(one - o * o);
                // The tail has a few roundings, and less than 1/25 of their effect is left.
                let unit = 0.1 * f64::EPSILON;
                is_near(found.stiffness, q, 1e-30, (omega, zeta));
                is_near(found.shift, g, unit, (omega, zeta));
                is_near(found.h, h, unit, (omega, zeta));
                // As accurate as q² asks for, though the terms are of the order of q.
                let (q, square) = (q.to_f64(), q * q * (g * g + h * h));
                let all = Wide::pi().square() / Wide::int(4) * square - Wide::int(4);
                let error = (wide(found.beyond) - all).abs().to_f64();
                assert!(error <= unit * q * q + 1e-29 * q, "{omega} {zeta}: {error:e}");
                let alpha = 1.273_239_544_735_162_8_f64.next_up() * (1.0 + off.abs());
                let due = Wide::from(alpha).square() - square;
                let error = (wide(Pole::excess(found.beyond, alpha)) - due).abs().to_f64();
                let most = unit * q * q + 1e-29 * (q + due.abs().to_f64());
                assert!(error <= most, "{omega} {zeta}: {error:e} of {due}");
            }
        }
    }
}
