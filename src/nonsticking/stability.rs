//! How fast neighbouring motions settle on the non-sticking cycle.
//!
//! Half a cycle from one reversal to the next maps a small disturbance of the reversal (its position
//! and its phase) to the next one. On the symmetric cycle the map has the multipliers
//!
//! ```text
//! λ² + (1 + s) cos(π/Ω) λ + s = 0,   s = (g − 1)/(g + 1),   g = Ω² Δ₀/B,
//! ```
//!
//! and a whole cycle has λ². Since g ≥ 1 for a cycle that does not stick, 0 ≤ s < 1, and the cycle is
//! stable unless cos(π/Ω) = ±1, that is Ω = 1/n, where one multiplier has modulus 1.

use crate::float::{Float, Real};

/// The map's determinant `s = (g − 1)/(g + 1)` with `g = Ω² Δ₀/B`.
#[inline]
pub fn multiplier_product<R: Real>(omega: R, max_displacement: R) -> R {
    let g = omega.square() * max_displacement;
    (g - R::int(1)) / (g + R::int(1))
}

/// `λ² + (1 + s) cos(π/Ω) λ + s`: zero for a multiplier λ of the half-cycle map.
#[inline]
pub fn characteristic_polynomial<R: Real>(lambda: R, product: R, cos_pi_1: R) -> R {
    lambda.square() + (R::int(1) + product) * cos_pi_1 * lambda + product
}

/// Contraction per half cycle, `max |λ|`: what is left of a small disturbance after half a cycle.
///
/// With `g = Ω²Δ₀/B` and `σ = |sin(π/Ω)|` the multipliers are real where `gσ ≤ 1` and complex, of modulus
/// √s, where `gσ > 1`:
///
/// ```text
/// max |λ| = [g |cos(π/Ω)| + √((1 − gσ)(1 + gσ))]/(g + 1)   or   √((g − 1)/(g + 1))
/// ```
///
/// The first form has the discriminant as a product, so that a double root loses no digits. Exactly 1
/// at Ω = 1/n. `sin_cos_beta` is (sin, cos) of β = π/2Ω.
///
/// Source: linearisation of the exact half-cycle map. Accuracy at f64: 4 ulp, away from the double root
/// gσ = 1, where λ itself turns like a square root.
#[inline]
pub fn contraction<F: Float>(omega: F, max_displacement: F, sin_cos_beta: (F, F)) -> F {
    let (one, two) = (F::int(1), F::int(2));
    let (s, c) = sin_cos_beta;
    let g = omega.square() * max_displacement;
    let g_sine = g * (two * s * c).abs();
    if g_sine > one {
        // Written with 1/g, so that an infinite g gives the limit 1.
        ((one - one / g) / (one + one / g)).sqrt()
    } else {
        let g_cosine = g * ((c - s) * (c + s)).abs();
        (g_cosine + ((one - g_sine) * (one + g_sine)).sqrt()) / (g + one)
    }
}

#[cfg(test)]
mod tests {
    use super::{characteristic_polynomial, contraction, multiplier_product};

    #[test]
    fn the_contraction_is_a_root_of_the_characteristic_polynomial() {
        // Real multipliers: Ω = 0.95, Δ₀/B = 2; the largest is −contraction or +contraction.
        let (omega, delta) = (0.95f64, 1.2f64);
        let beta = std::f64::consts::FRAC_PI_2 / omega;
        let lambda = contraction(omega, delta, beta.sin_cos());
        let s = multiplier_product(omega, delta);
        let cos_pi_1 = (2.0 * beta).cos();
        let residual = |l: f64| characteristic_polynomial(l, s, cos_pi_1).abs();
        assert!(residual(lambda).min(residual(-lambda)) < 1e-15);
        assert!(residual(lambda).max(residual(-lambda)) > 1e-3);
    }

    #[test]
    fn the_modulus_of_a_complex_pair() {
        let (omega, delta) = (0.7f64, 3.488_507_872_497_762f64);
        let beta = std::f64::consts::FRAC_PI_2 / omega;
        let lambda = contraction(omega, delta, beta.sin_cos());
        assert!((lambda * lambda - multiplier_product(omega, delta)).abs() < 1e-15);
    }

    #[test]
    fn marginal_at_one_over_n() {
        assert_eq!(contraction(0.5, 5.333, (0.0, -1.0)), 1.0);
    }
}
