//! The peak velocity for Ω ≥ 1/2, from the centre of the half cycle.
//!
//! The derivatives of v at ψ = 0 take no circular functions: v(0) = Δ₀/B, v′(0) is a quotient, and the others
//! follow from `v″ + Ω²v = (Ω − 1/Ω) sin ψ/cos β`. One of Householder's third-order steps from there, and
//! another on Taylor's polynomial of v′ with eight derivatives, come within 4e-5 of the root (in the angle of
//! the faster wave, which is below 1.05), so that one evaluation and one more step are enough.

use super::Fastest;
use super::step::{arrive, householder, is_final};
use crate::cycle::half_cycle::{HalfCycle, VelocityJet};
use crate::float::Float;

/// The peak velocity, and (sin, cos) of its ψ; `None` where four steps do not settle in |ψ| ≤ π/2.
///
/// There a stationary point is the maximum: for Ω > 1 it is the only one. For 1/2 ≤ Ω < 1 the nearest crest
/// of the fast wave is ψ_p = −π/2 (the module's head, with cos β < 0). Towards it the fast wave rises
/// throughout |ψ| < π/2, so that the slow one falls: ψ_p ≤ ψ ≤ ψ_c, where there is one stationary point.
#[inline]
pub(super) fn from_centre<F: Float>(half: &HalfCycle<F>) -> Option<(Fastest<F>, (F, F))> {
    let mut psi = start(half);
    for _ in 0..4 {
        let angles = half.angles(psi);
        let jet = half.velocity_of(&angles);
        let step = householder(&jet);
        psi = psi + step;
        // Said so that NaN is outside, too.
        let inside = psi.abs() * F::int(2) <= F::pi();
        if !inside {
            return None;
        }
        if is_final(half, step) {
            let found = (arrive(&jet, psi, step), turned(angles.psi(), step));
            return (jet.second < F::int(0)).then_some(found);
        }
    }
    None
}

/// The root of v′ to about 1e-5.
#[inline]
fn start<F: Float>(half: &HalfCycle<F>) -> F {
    let derivatives = half.derivatives_at_centre();
    let [_, first, second, third, fourth, ..] = derivatives;
    let psi = householder(&VelocityJet { value: half.max_displacement(), first, second, third, fourth });
    // Far above Ω = 1 the derivatives grow like powers of Ω, without bound, and the first step is good
    // enough.
    if half.omega() > F::int(1024) { psi } else { psi + householder(&expanded(&derivatives, psi)) }
}

/// v′ … v⁗ at ψ by Taylor's polynomials; the velocity itself is left out.
#[inline]
fn expanded<F: Float>(derivatives: &[F; 9], psi: F) -> VelocityJet<F> {
    // Horner's scheme over the derivatives from the n-th on.
    let polynomial = |n: usize| {
        let terms = derivatives.iter().skip(n).enumerate().rev();
        let sum = terms.fold(None, |sum: Option<F>, (k, &term)| {
            Some(sum.map_or(term, |sum| term + psi * F::ratio(1, (k + 1) as i32) * sum))
        });
        sum.unwrap_or(psi)
    };
    VelocityJet {
        value: derivatives[0],
        first: polynomial(1),
        second: polynomial(2),
        third: polynomial(3),
        fourth: polynomial(4),
    }
}

/// (sin, cos) a final step on.
#[inline]
fn turned<F: Float>((s, c): (F, F), step: F) -> (F, F) {
    let (half, third) = (step * F::ratio(1, 2), step * F::ratio(1, 3));
    (s + step * (c - half * (s + third * c)), c - step * (s + half * (c - third * s)))
}

#[cfg(test)]
mod tests {
    use super::{expanded, start, turned};
    use crate::cycle::half_cycle::HalfCycle;
    use crate::cycle::phase_function::PhaseFunction;

    /// Near the centre, the polynomials agree with the motion, and the start is as close to the root as the
    /// module's documentation states.
    #[test]
    fn taylors_polynomials_are_the_motion() {
        for omega in [0.6f64, 0.9, 1.3, 1.9] {
            let half = HalfCycle::new(&PhaseFunction::new(omega).unwrap(), 2.5 / omega);
            let (psi, derivatives) = (0.06, half.derivatives_at_centre());
            let (found, exact) = (expanded(&derivatives, psi), half.velocity(psi));
            for (found, exact, left_out) in [
                (found.first, exact.first, 1e-11),
                (found.second, exact.second, 1e-9),
                (found.third, exact.third, 1e-7),
                (found.fourth, exact.fourth, 2e-5),
            ] {
                assert!(
                    (found - exact).abs() < left_out * (1.0 + 1.0 / omega).powi(8),
                    "{omega}: {found} {exact}"
                );
            }
            let psi = start(&half);
            let at = half.velocity(psi);
            assert!((at.first / at.second).abs() * omega.max(1.0) < 4e-5, "{omega}: {psi} {at:?}");
        }
    }

    #[test]
    fn a_short_turn() {
        for x in [-1.4f64, -0.3, 0.0, 0.7, 1.5] {
            for step in [1e-4f64, -6e-5] {
                let (s, c) = turned(x.sin_cos(), step);
                let (sine, cosine) = (x + step).sin_cos();
                assert!((s - sine).abs() < 4e-16 && (c - cosine).abs() < 4e-16, "{x} {step}");
            }
        }
    }
}
