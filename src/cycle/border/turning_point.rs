//! The border at the turning point (eq. 57–62): the force there has to exceed friction.

use crate::cycle::phase_function::one_minus_square;
use crate::float::Field;
#[cfg(test)]
use crate::float::Float;

/// Force left over at a reversal (eq. 57): `|p₀ sin ω_d t − k x| − r_y`.
///
/// The body slides on where it is ≥ 0; eq. 58 and 59 put it to 0 at t₂, where x = Δ₀ and x′ = 0.
#[inline]
pub fn slip_excess<R: Field>(p0: R, sin_phase: R, stiffness: R, x: R, friction_bound: R) -> R {
    // |p₀ sin ω_d t − k x| − r_y
    (p0 * sin_phase - stiffness * x).abs() - friction_bound
}

/// Left less right side of eq. 60, the conditions 58 and 59 with Δ₀ from eq. 42:
/// `B² [(αΩ/(1−Ω²))² − T²] (k/r_y − p₀/(r_y A))² − Ω²`.
///
/// `k/r_y = 1/B` and `p₀/(r_y A) = (1−Ω²)/B`. Zero on eq. 61.
#[inline]
pub fn turning_point_residual<R: Field>(b: R, alpha: R, omega: R, tangent: R) -> R {
    let q = one_minus_square(omega);
    let stiffness_to_friction = R::int(1) / b;
    let force_to_amplitude = q / b;
    b.square()
        * ((alpha * omega / q).square() - tangent.square())
        * (stiffness_to_friction - force_to_amplitude).square()
        - omega.square()
}

/// The border at the turning point (eq. 61): `α = √{(1/Ω² − 1)² [1 + (ΩT)²]} = hypot(K, 1/Ω² − 1)`.
///
/// `phase_function` is K(Ω), `one_minus_square` is 1 − Ω². Equivalent to `Δ₀/B ≥ 1/Ω²`. **Exact for Ω ≥ 1/2;
/// below, necessary but not sufficient**, which the paper does not say: at Ω = 0.4 it gives 5.654…, and the
/// body sticks up to 6.949… ([`super::Border`]). Tends to 4/π at Ω = 1, to √(1 + π²/4) as Ω → ∞. Source: Hong
/// & Liu 2001, eq. 61. Accuracy at f64: 5 ulp.
#[inline(always)]
pub fn turning_point_border<R: Field>(phase_function: R, one_minus_square: R, omega: R) -> R {
    // α = hypot(K, (1 − Ω²)/Ω²)
    border_force_ratio(phase_function, one_minus_square / omega.square())
}

/// The border from the minimum displacement S of a cycle without stops: `α_min = hypot(K, (1 − Ω²) S)`, eq.
/// 44 solved for α.
///
/// `phase_function` is K(Ω), `width` is (1 − Ω²) S.
#[inline(always)]
pub(crate) fn border_force_ratio<R: Field>(phase_function: R, width: R) -> R {
    // α_min = √{K² + [(1 − Ω²) S]²}
    phase_function.hypot(width)
}

/// The criterion of eq. 62: `α ≥` [`turning_point_border`]. Necessary for every Ω, sufficient for Ω ≥ 1/2.
#[cfg(test)]
pub(crate) fn turning_point_criterion<F: Float>(phase_function: F, omega: F, alpha: F) -> bool {
    alpha >= turning_point_border(phase_function, one_minus_square(omega), omega)
}
