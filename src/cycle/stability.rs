//! How fast neighbouring motions settle on the non-sticking cycle.
//!
//! Half a cycle from one reversal to the next maps a small disturbance of the reversal (its position
//! and its phase) to the next one. On the symmetric cycle the map has the multipliers
//!
//! ```text
//! λ² + (1 + s) cos(π/Ω) λ + s = 0,   s = (g − 1)/(g + 1),   g = Ω² Δ₀/B,
//! ```
//!
//! and a whole cycle has λ² ([`Multipliers`]). Since g ≥ 1 for a cycle that does not stick, 0 ≤ s < 1, and
//! the cycle is stable unless cos(π/Ω) = ±1, that is Ω = 1/n, where one multiplier has modulus 1.

use crate::float::{Field, Float, Signed};
use alloc::vec::Vec;

/// The map's determinant `s = (g − 1)/(g + 1)` with `g = Ω² Δ₀/B`.
#[inline]
pub fn multiplier_product<R: Field>(omega: R, max_displacement: R) -> R {
    let g = omega.square() * max_displacement;
    (g - R::int(1)) / (g + R::int(1))
}

/// `λ² + (1 + s) cos(π/Ω) λ + s`: zero for a multiplier λ of the half-cycle map.
#[inline]
pub fn characteristic_polynomial<R: Field>(lambda: R, product: R, cos_pi_1: R) -> R {
    lambda.square() + (R::int(1) + product) * cos_pi_1 * lambda + product
}

/// Contraction per half cycle, `max |λ|`: the fraction of a small disturbance that remains after half a
/// cycle.
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
#[inline(always)]
pub(crate) fn contraction<F: Float>(omega: F, max_displacement: F, sin_cos_beta: (F, F)) -> F {
    let (one, two) = (F::int(1), F::int(2));
    let (s, c) = sin_cos_beta;
    let g = omega.square() * max_displacement;
    let g_sine = g * (two * s * c).abs();
    // Written with 1/g, so that an infinite g gives the limit 1. Both are computed, so that loops do not
    // branch.
    let inverse = one / g;
    // On the border g may round to less than 1, where the modulus is 0.
    let complex = ((one - inverse).or_larger(F::int(0)) / (one + inverse)).sqrt();
    let g_cosine = g * ((c - s) * (c + s)).abs();
    let real = real_contraction(g, g_cosine, ((one - g_sine) * (one + g_sine)).sqrt());
    if g_sine > one { complex } else { real }
}

/// `max |λ|` of two real multipliers from g, g|cos(π/Ω)| and √((1 − gσ)(1 + gσ)).
#[inline(always)]
pub(crate) fn real_contraction<R: Field>(g: R, g_cosine: R, spread: R) -> R {
    // [g |cos(π/Ω)| + √((1 − gσ)(1 + gσ))]/(g + 1)
    (g_cosine + spread) / (g + R::int(1))
}

/// A pair of multipliers, complex conjugate or real.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub(crate) enum MultiplierPair<F> {
    /// `re ± i im`, im > 0.
    Complex {
        /// Real part.
        re: F,
        /// Imaginary part of the first.
        im: F,
    },
    /// Two real multipliers, the one of larger modulus first.
    Real(F, F),
}

impl<N: Signed> MultiplierPair<N> {
    /// The product of the two without the damper's part, `(R − 1)/(R + 1)`, from 1/R. On the border R may round to less
    /// than 1.
    pub(crate) fn product(inverse: N) -> N {
        (N::int(1) - inverse).larger(N::int(0)) / (N::int(1) + inverse)
    }
}

impl<F: Float> MultiplierPair<F> {
    /// From the mean, the square of the deviation from it times (1 + 1/R)², 1/R and e^{−ζT}: with the product
    /// `e^{−2ζT} (R − 1)/(R + 1)`.
    pub(crate) fn new((mean, discriminant): (F, F), inverse: F, decay: F) -> Self {
        let (zero, one) = (F::int(0), F::int(1));
        let spread = discriminant.abs().sqrt() / (one + inverse);
        if discriminant < zero {
            return Self::Complex { re: mean, im: spread };
        }
        let larger = mean + spread.with_sign_of(mean);
        // At the double root the product may round to more than λ².
        let product = Self::product(inverse) * decay.square();
        let smaller = if product < larger.square() { product / larger } else { larger };
        Self::Real(larger, smaller)
    }

    /// The two as (real, imaginary) parts.
    pub(crate) fn parts(self) -> [(F, F); 2] {
        let zero = F::int(0);
        match self {
            Self::Complex { re, im } => [(re, im), (re, -im)],
            Self::Real(a, b) => [(a, zero), (b, zero)],
        }
    }

    /// The pair of the map applied twice: the squares.
    pub(crate) fn squared(self) -> Self {
        match self {
            Self::Complex { re, im } => {
                let (square, twice) = ((re - im) * (re + im), F::int(2) * re * im);
                Self::Complex { re: square, im: twice.abs() }
            }
            Self::Real(a, b) => Self::Real(a.square(), b.square()),
        }
    }

    /// The larger modulus.
    pub(crate) fn modulus(self) -> F {
        match self {
            Self::Complex { re, im } => re.hypot(im),
            Self::Real(a, _) => a.abs(),
        }
    }
}

/// The multipliers of a non-sticking cycle, in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Multipliers<F> {
    /// Of half a cycle, from one reversal to the next: λ, each (re, im). Two complex ones are conjugate, the
    /// one with im > 0 first; of two real ones the one of larger modulus is first.
    pub half_cycle: [(F, F); 2],
    /// Of a whole cycle: λ², in the same form.
    pub cycle: [(F, F); 2],
    /// The asymptotic contraction of a small disturbance per cycle: `max |λ|²`.
    ///
    /// The first few cycles may do better or worse, the map being not normal.
    pub contraction: F,
}

impl<F: Float> Multipliers<F> {
    /// The multipliers at Ω and Δ₀/B; `sin_cos_beta` is (sin, cos) of β = π/2Ω.
    ///
    /// With C = cos(π/Ω), `g = Ω²Δ₀/B`, `σ = |sin(π/Ω)|`:
    ///
    /// ```text
    /// λ = [−gC ± √((1 − gσ)(1 + gσ))]/(g + 1)
    /// ```
    ///
    /// Complex where gσ > 1. The smaller of two real ones is `s/λ`, s the product, so that it keeps its
    /// digits as g → 1. Accuracy at f64: 8 ulp of the modulus, away from the double root gσ = 1.
    pub(crate) fn new(omega: F, max_displacement: F, sin_cos_beta: (F, F)) -> Self {
        let (one, two) = (F::int(1), F::int(2));
        let (s, c) = sin_cos_beta;
        // Written with 1/g, so that an infinite g gives the limit.
        let inverse = one / (omega.square() * max_displacement);
        let (sine, cosine) = ((two * s * c).abs(), (c - s) * (c + s));
        let discriminant = (inverse - sine) * (inverse + sine);
        let mean = -(cosine / (one + inverse));
        Self::of_half_cycle(MultiplierPair::new((mean, discriminant), inverse, one))
    }

    /// The multipliers of a known pair.
    pub(super) fn of_half_cycle(pair: MultiplierPair<F>) -> Self {
        Self { half_cycle: pair.parts(), cycle: pair.squared().parts(), contraction: pair.modulus().square() }
    }

    /// The least number of cycles after which a small disturbance is down to `tolerance` of itself, at the
    /// rate of the contraction; `None` where it never is (Ω = 1/n), or not in 2⁶³ cycles.
    ///
    /// By repeated squaring, without logarithms: exact for the contraction as rounded, whose distance from 1
    /// it inherits.
    pub fn cycles_to_settle(&self, tolerance: F) -> Option<u64> {
        let one = F::int(1);
        if tolerance >= one {
            return Some(0);
        }
        let rate = self.contraction;
        if rate >= one || tolerance <= F::int(0) {
            return None;
        }
        // powers[i] is the contraction in 2ⁱ cycles, as long as that does not suffice.
        let mut powers = Vec::new();
        let mut power = rate;
        while power > tolerance {
            if powers.len() == 63 {
                return None;
            }
            powers.push(power);
            power = power.square();
        }
        let mut left = one;
        let mut cycles = 0;
        for (i, &power) in powers.iter().enumerate().rev() {
            if left * power > tolerance {
                left = left * power;
                cycles |= 1 << i;
            }
        }
        Some(u64::saturating_add(cycles, 1))
    }
}

#[cfg(test)]
mod tests;
