//! The half period by a hyperbolic tangent, without exponentials, circular functions or branches, so that
//! loops over it can be vectorised.
//!
//! With λ = −ζ + id, d = √(1 − ζ²), the matching conditions of the cycle are solved by `t = tanh(λT/2)`: `ΩH =
//! Im t/d`, `G = −Re t − (ζ/d) Im t`. From λT/2 the nearest multiple of iπ/2 is subtracted:
//!
//! ```text
//! v = λT/2 − qiπ/2 = (T/2)(−ζ + iγ),   γ = d − qΩ,   q = 0, 1 or 2,
//! t = v/P for even q,   t = P/v for q = 1,   P = v coth v = p + ir = 1 + v²/(3 + v²/(5 + v²/(7 + …))).
//! ```
//!
//! With `M = |P|² d/(T/2)` for even q and `M = (T/2)(ζ² + γ²) d` for q = 1,
//!
//! ```text
//! ΩH = ±(pγ + rζ)/M,   G = (ζ p A − r B)/M,   A = d ∓ γ,   B = dγ ± ζ²,
//! ```
//!
//! with the lower sign for q = 1. Nothing cancels as ζ → 0 or far above Ω = 1, where q = 0, A = 0, B = 1 and G is
//! of the order ζT³/12.
//!
//! Only the outer level of the fraction is computed in pairs: an error of the others reaches P with the factor
//! |v|⁴/45. It vanishes towards the pole at Ω = 1 just as Δ₀ = a − G requires, in which a and G are of the order
//! of 1/|v|.
//!
//! **The middle of the half cycle** follows from the same P. There free vibration is sech(λT/2) from (1, 0), and with
//! `R = v/sinh v = √(P² − v²)`, `N = 1/(P + R)`, x(z) = Re z + (ζ/d) Im z and v(z) = −Im z/d the velocity less ΩΔ₀ is
//! x(w), the acceleration v(w), and for q = 1, with P − R = v²N, nothing large is left:
//!
//! ```text
//! w = λ sech(λT/2) − Ωt = −ΩvN − (2iΩ/π) R,     x/B + 1 = x(ivN + 2P/π)                        (q = 1)
//! w = (±λR − Ωv)/P,     x/B + 1 = x([±R + 2v²/π + iqv]/P),     with q = 0 1 + v²(2/π − N)/P    (q = 0, 2)
//! ```

use super::middle::Middle;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// G and H, computed in three parts, which are loops of their own in a batch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tangent<F> {
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
    pub(crate) inverse: Pair<F>,
}

/// A complex number (real, imaginary).
type Complex<R> = (R, R);

impl<F: Float> Tangent<F> {
    /// At a frequency ratio and a damping ratio ζ > 0 that are in their domains, up to the precision of f64.
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let angle = Angle::at(omega, zeta);
        let (fraction, is_accurate) = angle.fraction(omega, zeta);
        let (shift, h) = angle.tangent(omega, zeta, fraction);
        let middle = angle.middle(omega, zeta, (fraction.0.hi, fraction.1.hi), shift.hi);
        Self { shift, h, middle, is_accurate }
    }
}

impl<F: Float> Angle<F> {
    #[inline(always)]
    pub(crate) fn at(omega: F, zeta: F) -> Self {
        let one = F::int(1);
        let square = Pair::two_prod(zeta, zeta);
        let rest = Pair::fast_two_sum(one, -square.hi);
        let d = Pair::new(rest.hi, rest.lo - square.lo).sqrt();
        let inverse = Pair::int(1) / omega;
        let near = Pair::two_sum(d.hi, -Self { d, gamma: d, inverse }.turns(omega).1);
        Self { d, gamma: Pair::fast_two_sum(near.hi, near.lo + d.lo), inverse }
    }

    /// Whether q is odd, and qΩ.
    #[inline(always)]
    fn turns(&self, omega: F) -> (bool, F) {
        let (zero, two) = (F::int(0), F::int(2));
        let twice = two * self.d.hi;
        let (is_above, is_beyond) = (omega >= twice, F::int(3) * omega >= twice);
        let turns = if is_beyond { omega } else { two * omega };
        (is_beyond & !is_above, if is_above { zero } else { turns })
    }

    /// `P = (p, r)`, and whether G and H are accurate.
    #[inline(always)]
    pub(crate) fn fraction(&self, omega: F, zeta: F) -> (Complex<Pair<F>>, bool) {
        let Self { gamma, inverse, .. } = *self;
        let middle = inverse * (Pair::pi() * F::ratio(1, 2));
        let (scale, square, other) = (middle.square(), Pair::two_prod(zeta, zeta), gamma.square());
        let size = scale.hi * (square.hi + other.hi);
        let v2 = (scale * (square - other), -(scale * (gamma * zeta)).times(2));
        let (p, r) = quotient(v2, tail((v2.0.hi, v2.1.hi)));
        let (is_odd, _) = self.turns(omega);
        // The digits of a pair suffice for α² − K² down to about |v|³ = ε.
        let nearest = F::exp2i(-((2 * F::PRECISION / 3) as i32));
        let is_accurate = (omega >= F::ratio(1, 2))
            & (omega <= F::exp2i(20))
            & (zeta <= F::ratio(7, 8))
            & (size <= F::ratio(3, 2))
            & (!is_odd | (size >= nearest));
        ((Pair::int(1) + p, r), is_accurate)
    }

    /// G and H.
    #[inline(always)]
    pub(crate) fn tangent(&self, omega: F, zeta: F, (p, r): Complex<Pair<F>>) -> (Pair<F>, Pair<F>) {
        let Self { d, gamma, inverse } = *self;
        let square = Pair::two_prod(zeta, zeta);
        let (is_odd, _) = self.turns(omega);
        let (a, b) = if is_odd { (gamma, -square) } else { (-gamma, square) };
        let (a, b) = (d + a, d * gamma + b);
        let height = gamma * p + r * zeta;
        let height = if is_odd { -height } else { height };
        let half_pi = Pair::pi() * F::ratio(1, 2);
        let over = if is_odd { Pair::int(1) / half_pi * omega } else { inverse * half_pi };
        let under = if is_odd { square + gamma.square() } else { p.square() + r.square() };
        let factor = over / (under * d);
        (((p * zeta) * a - r * b) * factor, height * factor * inverse)
    }

    /// The middle of the half cycle, by G and P.
    #[inline(always)]
    pub(crate) fn middle(&self, omega: F, zeta: F, (p, r): Complex<F>, shift: F) -> Middle<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let (d, gamma, half_pi) = (self.d.hi, self.gamma.hi, F::pi() * F::ratio(1, 2));
        let (is_odd, turn) = self.turns(omega);
        let is_above = turn == zero;
        // v, v² and N = 1/(P + R), R = √(P² − v²)
        let half = half_pi * self.inverse.hi;
        let v = (-(half * zeta), half * gamma);
        let square = ((v.0 - v.1) * (v.0 + v.1), two * v.0 * v.1);
        let (re, im) = ((p - r).mul_add(p + r, -square.0), (two * p).mul_add(r, -square.1));
        let size = re.mul_add(re, im * im).sqrt();
        let a = ((size + re) * F::ratio(1, 2)).sqrt();
        let b = im / (two * a);
        let inverse = |(a, b): Complex<F>| {
            let size = one / a.mul_add(a, b * b);
            (a * size, -(b * size))
        };
        let (n, m) = (inverse((p + a, r + b)), inverse((p, r)));
        let over_d = one / d;
        // x and x′ of a complex number.
        let place = |(re, im): Complex<F>| (zeta * over_d).mul_add(im, re);
        let speed = |(_, im): Complex<F>| -(im * over_d);
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
        let at = place(if is_odd { by_odd } else { by_even });
        Middle {
            velocity: if is_odd { place(w) } else { omega.mul_add(shift, speed(s)) },
            slope: speed(w),
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
    let inverse = n(1) / denominator.0.mul_add(denominator.0, denominator.1 * denominator.1);
    (
        numerator.0.mul_add(denominator.0, numerator.1 * denominator.1) * inverse,
        numerator.1.mul_add(denominator.0, -(numerator.0 * denominator.1)) * inverse,
    )
}

/// `z/(3 + tail)`, to twice the digits of the type.
#[inline(always)]
fn quotient<F: Float>(z: Complex<Pair<F>>, tail: Complex<F>) -> Complex<Pair<F>> {
    let real = Pair::fast_two_sum(F::int(3), tail.0);
    let (c, d) = (real.hi, tail.1);
    let inverse = F::int(1) / c.mul_add(c, d * d);
    let times_conjugate = |a: F, b: F| (a.mul_add(c, b * d) * inverse, b.mul_add(c, -(a * d)) * inverse);
    let (x, y) = times_conjugate(z.0.hi, z.1.hi);
    let rest = |whole: Pair<F>, first: Pair<F>, second: Pair<F>, small: F| {
        let sum = Pair::two_sum(whole.hi, -first.hi);
        (sum.hi - second.hi) + ((sum.lo - first.lo) - (second.lo - small) + whole.lo)
    };
    let re = rest(z.0, Pair::two_prod(x, c), -Pair::two_prod(y, d), -(x * real.lo));
    let im = rest(z.1, Pair::two_prod(x, d), Pair::two_prod(y, c), -(y * real.lo));
    let (u, v) = times_conjugate(re, im);
    (Pair::new(x, u), Pair::new(y, v))
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
                // Some six roundings of the inner levels, |v|²/15 of which reach r, and |v|⁴/45 P.
                let d = (1.0 - zeta * zeta).sqrt();
                let is_odd = 3.0 * omega >= 2.0 * d && omega < 2.0 * d;
                let gamma = (0..3).map(|q| (d - f64::from(q) * omega).abs()).fold(9.0, f64::min);
                let size = (std::f64::consts::FRAC_PI_2 / omega).powi(2) * (gamma * gamma + zeta * zeta);
                let unit = 0.4 * f64::EPSILON * if is_odd { size * size } else { size };
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
