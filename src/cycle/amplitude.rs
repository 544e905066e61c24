//! The cycle by its amplitude: the force and the maximum velocity that belong to a maximum displacement Δ₀.

use super::border::border_force_ratio;
use super::half_cycle::HalfCycle;
use super::velocity;
use crate::cycle::phase_function::{PhaseFunction, one_minus_square};
use crate::float::{Field, Float};

/// Eq. 44 solved for the force ratio: `α = √[K² + ((1 − Ω²) Δ₀/B)²]`.
///
/// `phase_function` is K(Ω), `one_minus_square` is 1 − Ω². Two squares are added, so that nothing cancels.
#[inline]
pub(crate) fn force_ratio_from_displacement<R: Field>(
    phase_function: R,
    max_displacement: R,
    one_minus_square: R,
) -> R {
    // α = hypot(K, (1 − Ω²) Δ₀/B)
    border_force_ratio(phase_function, one_minus_square * max_displacement)
}

/// Maximum velocity `V₀/(Bω_d)` at a maximum displacement Δ₀/B, and its derivative by it, `cos Ωψ` at the
/// maximum.
///
/// Only the explicit dependence on Δ₀ matters, since v is stationary in ψ. It requires Δ₀/B of a cycle that
/// does not stick, and Ω ≠ 1.
pub(crate) fn max_velocity_from_displacement<F: Float>(p: &PhaseFunction<F>, max_displacement: F) -> (F, F) {
    let (omega, k) = (p.omega(), p.value());
    let alpha = force_ratio_from_displacement(k, max_displacement, one_minus_square(omega));
    let fastest = velocity::fastest(&HalfCycle::new(p, max_displacement), k, alpha);
    (fastest.velocity, (omega * fastest.psi).cos())
}

#[cfg(test)]
mod tests {
    use super::max_velocity_from_displacement;
    use crate::PhaseFunction;

    #[test]
    fn the_slope_is_that_of_differences_and_grows() {
        for (omega, least) in [(0.3, 12.0), (0.4, 9.0), (0.7, 2.1), (1.3, 0.7), (5.0, 0.05)] {
            let p = PhaseFunction::new(omega).unwrap();
            let at = |delta: f64| max_velocity_from_displacement(&p, delta);
            let mut last = 0.0;
            for i in 0..40 {
                let delta = least * (1.0 + 0.1 * f64::from(i));
                let h = 1e-5 * delta;
                let difference = (at(delta + h).0 - at(delta - h).0) / (2.0 * h);
                let (value, slope) = at(delta);
                assert!((difference - slope).abs() < 1e-8, "{omega} {delta}: {difference} {slope}");
                assert!(slope >= last && slope <= 1.0 && value >= delta);
                last = slope;
            }
        }
    }
}
