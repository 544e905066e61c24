//! The deviation Δ₁/B from the condition at the peak velocity, for Ω ≥ 1/2.
//!
//! There the acceleration is zero, so that `cos Ωψ` and `sin Ωψ` drop out of the displacement:
//!
//! ```text
//! Δ₁/B = R cos ψ − 1 = (R − 1) − R (1 − cos ψ),   R = (1 − 1/Ω²)/cos β = −K/(Ω sin β) > 0.
//! ```
//!
//! Its derivative by ψ is R sin ψ, a small part of the velocity that the displacement itself changes with.
//! The second form has its rounding errors in R − 1 alone, which depends on Ω only: near Ω = 1 it is the
//! difference of a pair; from Ω = 2 on, where all of it is of the order v = 1/Ω²,
//!
//! ```text
//! R − 1 = v [(π²/8) C − 1]/cos β,   C = (1 − cos β)/(β²/2) = 1 − 2β²/4! + 2β⁴/6! − ….
//! ```

use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// Δ₁/B of a half cycle with Ω ≥ 1/2; `phase_function` is K(Ω), (sin β, cos β) and (sin ψ, cos ψ) are given.
///
/// All forms are computed, so that loops do not branch.
#[inline(always)]
pub(crate) fn of_fastest<F: Float>(
    omega: F,
    (sin_beta, cos_beta): (Pair<F>, F),
    phase_function: Pair<F>,
    (s, c): (F, F),
) -> F {
    let one = F::int(1);
    let fall = s * s / (one + c);
    let r = -(phase_function / (sin_beta * omega));
    let beside_one = (r.hi - one) + (r.lo - r.value() * fall);
    let v = one / (omega * omega);
    let r = (one - v) / cos_beta;
    let half_pi = F::pi() * F::ratio(1, 2);
    let Pair { hi, lo } = (Pair::pi() * F::ratio(1, 2)).square() * F::ratio(1, 2);
    let bend = cosine_bend(half_pi * half_pi * v);
    let above = v * ((hi * bend - one) + lo * bend) / cos_beta - r * fall;
    let below = r * c - one;
    let is_beside_one = (omega < F::int(2)) & (F::int(3) * omega >= F::int(2));
    let away = if omega < one { below } else { above };
    if is_beside_one { beside_one } else { away }
}

/// `(1 − cos β)/(β²/2)` from β² ≤ (π/4)²: seven terms of its series after the first.
#[inline]
fn cosine_bend<F: Float>(square: F) -> F {
    let one = F::int(1);
    (1..=7).rev().fold(one, |sum, k| one - square * F::ratio(1, (2 * k + 1) * (2 * k + 2)) * sum)
}

#[cfg(test)]
mod tests {
    use super::cosine_bend;

    #[test]
    fn the_series_is_the_cosine() {
        for i in 1..=785 {
            let beta = f64::from(i) / 1000.0;
            let sine = (beta / 2.0).sin();
            let exact = (sine / (beta / 2.0)).powi(2);
            assert!((cosine_bend(beta * beta) - exact).abs() <= 2.0 * f64::EPSILON, "{beta}");
        }
    }
}
