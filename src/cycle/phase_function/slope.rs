//! The derivative dK/dΩ of the phase function.

use super::value::y_cot_y;
use super::{PhaseFunction, one_minus_square};
use crate::float::Float;

impl<F: Float> PhaseFunction<F> {
    /// The derivative dK/dΩ, finite for every float Ω.
    ///
    /// ```text
    /// K′ = −(1 + 1/Ω²) T − (π/2)(1 − Ω²)(1 + T²)/Ω³,
    /// K′ = −(2/π) E(w) + (1 + Ω) E′(w)/Ω²,   E(w) = w cot w,   beside Ω = 1,
    /// K′ = −(π/Ω³) T/β + (1 − 1/Ω²)(2β − sin 2β)/(2 cos²β)   for Ω ≥ 2,
    /// ```
    ///
    /// with `T′ = −(π/2Ω²)(1 + T²)`; with `w = (π/2)(1 − Ω)/Ω`, for which K = −(2/π)(1 + Ω) E(w) and K′(1) =
    /// −2/π; and with `β = π/2Ω`, for which K = −(π/2)(1 − 1/Ω²) T/β. For Ω ≥ 2 the first form loses all
    /// digits, since K′ is of the order 1/Ω³. Accuracy at f64: 8 ulp of the larger term.
    #[must_use]
    pub(crate) fn slope(&self) -> F {
        let (omega, w, one) = (self.omega(), self.remainder(), F::int(1));
        let inverse_square = one / omega.square();
        if self.is_beside_one() {
            F::int(-2) / F::pi() * y_cot_y(w) + (one + omega) * y_cot_y_slope(w) * inverse_square
        } else if omega >= F::int(2) {
            let shrinking = F::pi() * inverse_square / omega * (w.tan() / w);
            let bending = arc_less_sine(w + w) / (F::int(2) * w.cos().square());
            (one - inverse_square) * bending - shrinking
        } else {
            let t = self.tangent();
            let turning = F::pi() / F::int(2) * one_minus_square(omega) * (one + t.square());
            -(one + inverse_square) * t - turning * inverse_square / omega
        }
    }
}

/// Derivative of `y cot y`: `cot y − y/sin²y = −(2y − sin 2y)/(2 sin²y)`, smooth through y = 0.
fn y_cot_y_slope<F: Float>(y: F) -> F {
    if y.square() < F::epsilon() {
        return F::int(-2) * y / F::int(3);
    }
    -(arc_less_sine(y + y) / (F::int(2) * y.sin().square()))
}

/// `x − sin x` for |x| ≤ π/2 to full relative accuracy, by its series where the difference would cancel.
pub(crate) fn arc_less_sine<F: Float>(x: F) -> F {
    let square = x.square();
    if square > F::int(1) {
        return x - x.sin();
    }
    let mut term = x * square / F::int(6);
    let mut sum = term;
    // Each term is less than a twentieth of the one before, a gain of at least four bits.
    let mut n = 4;
    while n < 4 + F::precision() as i32 && term.abs() > F::epsilon() * sum.abs() {
        term = -(term * square / F::int(n * (n + 1)));
        sum = sum + term;
        n += 2;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{PhaseFunction, arc_less_sine, y_cot_y_slope};

    #[test]
    fn values_at_forty_digits() {
        // The reference is d/dΩ of (1 − Ω²) tan(π/2Ω)/Ω, computed by mpmath.
        for (omega, exact) in [
            (0.07, -5_712.768_646_022_978),
            (0.21, -1_275.048_676_400_093_7),
            (0.3, -190.789_556_128_088_8),
            (0.4, -48.483_403_578_366_01),
            (0.55, -5.888_776_557_345_163),
            (0.7, -2.195_037_927_345_003_6),
            (0.95, -0.754_363_799_824_873_7),
            (1.000_000_000_931_322_6, -0.636_619_770_417_023_9),
            (1.4, -0.216_795_257_423_123_83),
            (1.9, -0.084_150_865_384_063_62),
            (2.5, -0.036_401_687_297_391_114),
            (40.0, -8.715287232157176e-06),
        ] {
            let (found, exact): (f64, f64) = (PhaseFunction::new(omega).unwrap().slope(), exact);
            assert!((found - exact).abs() < 2e-15 * (0.5 + exact.abs()), "{omega}: {found} against {exact}");
        }
    }

    #[test]
    fn the_slope_at_the_natural_frequency_and_beside_it() {
        let at = |omega: f64| PhaseFunction::new(omega).unwrap().slope();
        let two_over_pi = 2.0 / std::f64::consts::PI;
        for omega in [1.0, 1f64.next_up(), 1f64.next_down()] {
            assert!((at(omega) + two_over_pi).abs() < 1e-15, "{omega}");
        }
    }

    #[test]
    fn series_and_quotient_meet() {
        let (a, b) = (arc_less_sine(1f64.next_down()), arc_less_sine(1f64.next_up()));
        assert!((a / b - 1.0).abs() < 2e-15);
        let edge = f64::EPSILON.sqrt();
        let (a, b) = (y_cot_y_slope(edge * 1.001) / 1.001, y_cot_y_slope(edge * 0.999) / 0.999);
        assert!((a / b - 1.0).abs() < 1e-14);
    }
}
