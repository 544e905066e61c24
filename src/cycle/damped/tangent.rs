//! The half period without exponentials, circular functions or branches, so that loops over it can be vectorised.
//!
//! With λ = −ζ + id, d = √(1 − ζ²), the matching conditions of the cycle are solved by `t = tanh(λT/2)`: `ΩH =
//! Im t/d`, `G = −Re t − (ζ/d) Im t`. From λT/2 the nearest multiple of iπ/2 is subtracted:
//!
//! ```text
//! v = λT/2 − qiπ/2 = (T/2)(−ζ + iγ),   γ = d − qΩ,   q = 0, 1 or 2,
//! t = tanh v for even q,   t = coth v for q = 1.
//! ```
//!
//! Of `X = ζT` and `Y = γT`, |Y| ≤ π/2, four real functions are needed, which are two of `z = X²` and `z = −Y²`:
//!
//! ```text
//! S(z) = 6 (sinh √z)/√z − 6 = z + z²(…),   C(z) = 2 cosh √z − 2 = z + z²(…).
//! ```
//!
//! With σ = γ for q = 1 and −γ for even q,
//!
//! ```text
//! M = 3d [C(X²) − C(−Y²)] for q = 1,   M = 3d [4 + C(X²) + C(−Y²)] for even q,
//! G = ζT [6 (d + σ) + d S(X²) + σ S(−Y²)]/M,   ΩH = −σT [6 + S(−Y²)]/M.
//! ```
//!
//! d + σ is 2d − Ω for q = 1, 2Ω for q = 2 and 0 for q = 0: nothing cancels as ζ → 0 or far above Ω = 1. Only
//! the leading term z of S and C is computed in pairs: the error of the rest vanishes as z towards the pole at Ω = 1
//! just as Δ₀ = a − G requires, in which a and G are of the order of 1/|v|, and α²/q² − H² of the order of 1.
//!
//! **The middle of the half cycle** follows from `P = v coth v = p + ir = 1 + v²/(3 + v²/(5 + v²/(7 + …)))`. There free
//! vibration is sech(λT/2) from (1, 0), and with `R = v/sinh v = √(P² − v²)`, `N = 1/(P + R)`, x(z) = Re z + (ζ/d) Im z
//! and v(z) = −Im z/d the velocity less ΩΔ₀ is x(w), the acceleration v(w), and for q = 1, with P − R = v²N, nothing
//! large is left:
//!
//! ```text
//! w = λ sech(λT/2) − Ωt = −ΩvN − (2iΩ/π) R,     x/B + 1 = x(ivN + 2P/π)                        (q = 1)
//! w = (±λR − Ωv)/P,     x/B + 1 = x([±R + 2v²/π + iqv]/P),     with q = 0 1 + v²(2/π − N)/P    (q = 0, 2)
//! ```

use super::middle::Middle;
use crate::float::circular::Swell;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// G and H, computed in two parts, which are loops of their own in a batch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tangent<F> {
    /// 1/Ω.
    pub(crate) inverse: F,
    /// G.
    pub(crate) shift: Pair<F>,
    /// H.
    pub(crate) h: Pair<F>,
    /// The middle of the half cycle.
    pub(crate) middle: Middle<F>,
    /// Whether they are accurate at this Ω and ζ: otherwise they are meaningless.
    pub(crate) is_accurate: bool,
}

/// `λT/2 − qiπ/2` by d, γ and 1/Ω.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Angle<F> {
    pub(crate) d: Pair<F>,
    pub(crate) gamma: Pair<F>,
    pub(crate) inverse: F,
}

/// A complex number (real, imaginary).
type Complex<R> = (R, R);

impl<F: Float> Tangent<F> {
    /// At a frequency ratio and a damping ratio ζ > 0 that are in their domains, up to the precision of f64.
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let angle = Angle::at(omega, zeta);
        let (shift, h, is_accurate) = angle.responses(omega, zeta, &Swell::new());
        let middle = angle.middle(omega, zeta, shift.hi);
        Self { inverse: angle.inverse, shift, h, middle, is_accurate }
    }
}

impl<F: Float> Angle<F> {
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let square = Pair::two_prod(zeta, zeta);
        let rest = Pair::fast_two_sum(F::int(1), -square.hi);
        let d = rest.hi.sqrt();
        let twice = F::int(2) * d;
        // One division for 1/Ω and 1/2d.
        let both = F::int(1) / (twice * omega);
        let d = Pair::new(d, ((-d).mul_add(d, rest.hi) + (rest.lo - square.lo)) * (omega * both));
        // Exact: the two differ by a factor of two at most.
        let near = d.hi - Self::turns(d.hi, omega).1;
        Self { d, gamma: Pair::fast_two_sum(near, d.lo), inverse: twice * both }
    }

    /// Whether q is odd, and qΩ.
    #[inline(always)]
    fn turns(d: F, omega: F) -> (bool, F) {
        let (zero, two) = (F::int(0), F::int(2));
        let twice = two * d;
        let (is_above, is_beyond) = (omega >= twice, F::int(3) * omega >= twice);
        let turns = if is_beyond { omega } else { two * omega };
        (is_beyond & !is_above, if is_above { zero } else { turns })
    }

    /// G and H, and whether they are accurate.
    #[inline(always)]
    pub(crate) fn responses(&self, omega: F, zeta: F, swell: &Swell<F>) -> (Pair<F>, Pair<F>, bool) {
        let Self { d, gamma, .. } = *self;
        let inverse = Pair::reciprocal(omega, self.inverse);
        let (zero, two) = (F::int(0), F::int(2));
        let (is_odd, turns) = Self::turns(d.hi, omega);
        let period = inverse * Pair::pi();
        let (x, y) = (period * zeta, period * gamma);
        let (x2, y2) = (x.square(), y.square());
        let ((s, c), (s_of_y, c_of_y)) = (swell.at(x2), swell.at(-y2));
        let (sigma, c_of_y) = if is_odd { (gamma, -c_of_y) } else { (-gamma, c_of_y) };
        // d + σ
        let odd = Pair::fast_two_sum(two * d.hi, -omega);
        let odd = Pair::new(odd.hi, two.mul_add(d.lo, odd.lo));
        let near = if is_odd { odd } else { Pair::exact(turns) };
        let whole = total([Pair::exact(if is_odd { zero } else { F::int(4) }), c, c_of_y]);
        let under = d * whole * F::int(3);
        let shift = x * total([near * F::int(6), d * s, sigma * s_of_y]) / under;
        let six = Pair::fast_two_sum(F::int(6), s_of_y.hi);
        let h = y * Pair::new(six.hi, six.lo + s_of_y.lo) * inverse / under;
        let h = if is_odd { -h } else { h };
        // |2v|², within the reach of the fraction. A pair has the digits of α² − K² down to about |v|³ = ε.
        let size = x2.hi + y2.hi;
        let nearest = F::exp2i(2 - ((2 * F::precision() / 3) as i32));
        let is_accurate = (omega >= F::ratio(1, 2))
            & (omega <= F::exp2i(20))
            & (zeta <= F::ratio(7, 8))
            & (size <= F::int(6))
            & (!is_odd | (size >= nearest));
        (shift.normalised(), h.normalised(), is_accurate)
    }

    /// The middle of the half cycle, by G.
    #[inline(always)]
    pub(crate) fn middle(&self, omega: F, zeta: F, shift: F) -> Middle<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let (d, gamma, half_pi) = (self.d.hi, self.gamma.hi, F::pi() * F::ratio(1, 2));
        let (is_odd, turn) = Self::turns(d, omega);
        let is_above = turn == zero;
        // v, v², P and N = 1/(P + R), R = √(P² − v²)
        let half = half_pi * self.inverse;
        let v = (-(half * zeta), half * gamma);
        let square = ((v.0 - v.1) * (v.0 + v.1), two * v.0 * v.1);
        let (re, im) = tail(square);
        let (p, r) = over(square, (F::int(3) + re, im));
        let p = one + p;
        let (re, im) = ((p - r).mul_add(p + r, -square.0), (two * p).mul_add(r, -square.1));
        let size = re.mul_add(re, im * im).sqrt();
        let a = ((size + re) * F::ratio(1, 2)).sqrt();
        let b = im / (two * a);
        let (n, m) = (reciprocal((p + a, r + b)), reciprocal((p, r)));
        let over_d = one / d;
        // x is Re z + factor Im z, x′ is −Im z/d.
        let factor = zeta * over_d;
        // w, and ±R/P for an even q.
        let odd = times((half_pi * zeta, -(half_pi * gamma)), n);
        let odd = ((omega / half_pi).mul_add(b, odd.0), (omega / half_pi).mul_add(-a, odd.1));
        let root = if is_above { (a, b) } else { (-a, -b) };
        let s = times(root, m);
        let free = times((-zeta, d), root);
        let even = times((half_pi.mul_add(zeta, free.0), half_pi.mul_add(-gamma, free.1)), m);
        let w = if is_odd { odd } else { even };
        // x/B + 1, or x/B for q = 0.
        let scale = one / half_pi;
        let by_odd = {
            let turned = times((-v.1, v.0), n);
            (scale.mul_add(p, turned.0), scale.mul_add(r, turned.1))
        };
        let part = times(square, n);
        let rest = if is_above { (-part.0, -part.1) } else { (-a - two * v.1, two.mul_add(v.0, -b)) };
        let by_even = times((scale.mul_add(square.0, rest.0), scale.mul_add(square.1, rest.1)), m);
        let (re, im) = if is_odd { by_odd } else { by_even };
        let at = factor.mul_add(im, re);
        Middle {
            velocity: if is_odd { factor.mul_add(w.1, w.0) } else { omega.mul_add(shift, -(s.1 * over_d)) },
            slope: -(w.1 * over_d),
            displacement: if is_above { at } else { at - one },
        }
    }
}

#[inline(always)]
fn times<F: Float>((a, b): Complex<F>, (c, d): Complex<F>) -> Complex<F> {
    (a.mul_add(c, -(b * d)), a.mul_add(d, b * c))
}

/// `z/(5 + z/(7 + …))`: the convergent of level 19.
#[inline(always)]
fn tail<F: Float>(z: Complex<F>) -> Complex<F> {
    let n = F::int;
    // A polynomial with real coefficients is divided by (x − z)(x − z̄): x² = 2 Re z x − |z|².
    let (twice, size) = (z.0 + z.0, z.0.mul_add(z.0, z.1 * z.1));
    // 52 z³ + 21450 z² + 1969110 z + 43648605
    let n3 = n(52);
    let n2 = n3.mul_add(twice, n(21_450));
    let n1 = n2.mul_add(twice, n3.mul_add(-size, n(1_969_110)));
    let n0 = n2.mul_add(-size, n(43_648_605));
    let numerator = (n1.mul_add(z.0, n0), n1 * z.1);
    // z⁴ + 1430 z³ + 289575 z² + 16081065 z + 218243025
    let d3 = twice + n(1430);
    let d2 = d3.mul_add(twice, n(289_575) - size);
    let d1 = d2.mul_add(twice, d3.mul_add(-size, n(16_081_065)));
    let d0 = d2.mul_add(-size, n(218_243_025));
    let denominator = (d1.mul_add(z.0, d0), d1 * z.1);
    let numerator =
        (numerator.0.mul_add(z.0, -(numerator.1 * z.1)), numerator.0.mul_add(z.1, numerator.1 * z.0));
    over(numerator, denominator)
}

#[inline(always)]
fn reciprocal<F: Float>((a, b): Complex<F>) -> Complex<F> {
    let size = F::int(1) / a.mul_add(a, b * b);
    (a * size, -(b * size))
}

/// The quotient of two complex numbers.
#[inline(always)]
fn over<F: Float>((a, b): Complex<F>, (c, d): Complex<F>) -> Complex<F> {
    let inverse = F::int(1) / c.mul_add(c, d * d);
    (a.mul_add(c, b * d) * inverse, b.mul_add(c, -(a * d)) * inverse)
}

/// The sum of three pairs of which no leading part is much smaller than the sum, without the last step of a sum of two.
#[inline(always)]
fn total<F: Float>([a, b, c]: [Pair<F>; 3]) -> Pair<F> {
    let first = Pair::two_sum(a.hi, b.hi);
    let second = Pair::two_sum(first.hi, c.hi);
    Pair::new(second.hi, (first.lo + second.lo) + ((a.lo + b.lo) + c.lo))
}

#[cfg(all(test, feature = "mp"))]
mod tests {
    use super::Tangent;
    use crate::cycle::damped::middle::Middle;
    use crate::float::Field;

    /// They agree with the definitions at twelve times the digits, the better the nearer to the pole.
    #[test]
    fn its_quantities_are_those_of_the_definition() {
        use crate::cycle::damped::half_period::definition::{Wide, is_near, responses};
        for i in 0..400 {
            let off = f64::from(i % 20 - 10) * 0.77f64.powi(i / 4);
            let omega = if i % 4 == 0 { 0.5 * 1.1f64.powi(i / 4) } else { 1.0 + 0.15 * off };
            for zeta in [1e-60, 1e-12, 1e-6, 1e-3, 0.1, 0.3, 0.6, 0.85] {
                let found = Tangent::at(omega, zeta);
                if !found.is_accurate {
                    continue;
                }
                let (g, h) = responses(omega, zeta);
                // Some roundings of all but the leading terms of S and C, which are a tenth of them times z.
                let d = (1.0 - zeta * zeta).sqrt();
                let gamma = (0..3).map(|q| (d - f64::from(q) * omega).abs()).fold(9.0, f64::min);
                let size = (std::f64::consts::PI / omega).powi(2) * (gamma * gamma + zeta * zeta);
                let unit = 0.1 * f64::EPSILON * size;
                // γ has the absolute error of the pair d.
                let unit = unit + f64::EPSILON.powi(2) / gamma;
                is_near(found.shift, g, unit, (omega, zeta));
                is_near(found.h, h, unit, (omega, zeta));
                // The middle, by free vibration from (1 + G, ΩH).
                let (o, z, one, half) =
                    (Wide::from(omega), Wide::from(zeta), Wide::int(1), Wide::ratio(1, 2));
                let (d, time) = ((one - z * z).sqrt(), Wide::pi() / o * half);
                let (e, (s, c)) = ((-(z * time)).exp(), (d * time).sin_cos());
                let (x0, v0) = (one + g, o * h);
                let x = e * (c * x0 + (v0 + z * x0) * s / d);
                let v = e * (c * v0 - (z * v0 + x0) * s / d);
                let Middle { velocity, slope, displacement } = found.middle;
                let most = 16.0 * f64::EPSILON * f64::min(1.0, 4.0 / (omega * omega));
                for (found, due) in [
                    (velocity, o * g + v),
                    (slope, o * o * h - x - z.times(2) * v),
                    (displacement, x - h - one),
                ] {
                    let off = (Wide::from(found) - due).abs().to_f64();
                    assert!(
                        off <= most.max(16.0 * f64::EPSILON * found.abs()),
                        "{omega} {zeta}: {off:e} of {due}"
                    );
                }
            }
        }
    }
}
