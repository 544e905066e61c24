//! The stationary point of the border's condition from γ and Ω alone, without branches, and the width that it
//! has.
//!
//! With γ = β mod π, the stationary point ξ lies between 0.43 γ and 0.502 γ, all but a polynomial in γ² and
//! Ω² (to 1.1e-3 γ). One of Householder's steps brings it to 2e-9 γ, and the width, stationary there, to
//! rounding.

#[cfg(feature = "batch")]
use super::{border_force_ratio, is_stationary_value_larger, turning_point_border};
use crate::cycle::phase_function::LowAngle;
#[cfg(feature = "batch")]
use crate::cycle::phase_function::one_minus_square_wide;
use crate::float::circular::TO_HALF_PI;
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// The quantities of an Ω below 1/2 that are known before ξ.
pub(super) struct LowOmega<F> {
    omega: F,
    /// K(Ω).
    phase_function: Pair<F>,
    /// γ = β mod π.
    pub(super) gamma: Pair<F>,
    sin_gamma: Pair<F>,
}

impl<F: Float> LowOmega<F> {
    #[inline(always)]
    pub(super) fn new(omega: F, angle: &LowAngle<F>, phase_function: Pair<F>) -> Self {
        Self { omega, phase_function, gamma: angle.lobe_phase(), sin_gamma: angle.sin_cos().0.abs() }
    }

    /// `(1 − Ω²) S = |K| [sin γ cos τ + sin ξ]/(sin γ sin τ)` at the stationary point ξ, all terms positive.
    ///
    /// S is stationary in ξ but not in τ and γ: τ = Ω(γ + ξ), in (0, π/2], is a pair.
    #[inline(always)]
    pub(super) fn width(&self, xi: F) -> Pair<F> {
        let xi = Pair::exact(xi);
        let (sin_tau, cos_tau) = F::sin_cos_acute((self.gamma + xi) * self.omega);
        let (sin_xi, _) = F::sin_cos_acute(xi);
        self.phase_function.abs() * (self.sin_gamma * cos_tau + sin_xi) / (self.sin_gamma * sin_tau)
    }

    /// ξ, and whether it is good enough.
    ///
    /// With σ = γ + ξ and τ = Ωσ, of `g(ξ) = cos τ sin ξ − sin τ cos ξ/Ω + sin γ = 0`.
    #[inline(always)]
    fn stationary_point(&self) -> (F, bool) {
        let (omega, gamma, one) = (self.omega, self.gamma.value(), F::int(1));
        let (pi, inverse, circular) = (F::pi(), one / omega, TO_HALF_PI.of::<F>());
        let (x, y) = ((gamma / pi).square(), F::int(4) * omega.square());
        // ξ/γ = 1/2 − (0.0618 − 0.143 (2Ω)²) (γ/π)² − 0.00906 (γ/π)⁴
        let bend = y.mul_add(F::ratio(143_258, 1_000_000), F::ratio(-61_765, 1_000_000));
        let start = gamma * x.mul_add(F::ratio(-9_058, 1_000_000).mul_add(x, bend), F::ratio(1, 2));
        let (sin_tau, cos_tau) = circular.sin_cos(omega * (gamma + start));
        let (s, c) = circular.sin_cos(start);
        let condition = cos_tau.mul_add(s, (-inverse * sin_tau).mul_add(c, self.sin_gamma.value()));
        let factor = inverse - omega;
        let first = factor * sin_tau * s;
        let second = factor * (omega * cos_tau).mul_add(s, sin_tau * c);
        let step = -(condition * first) / first.mul_add(first, -(condition * second) * F::ratio(1, 2));
        // The largest known step is 1.1e-3 γ. Near Ω = 1/(2n) all terms of the condition are small.
        let clear = F::ratio(1, 512);
        let is_found = (step.abs() <= clear * gamma) & (gamma > clear) & (gamma < pi - clear);
        (start + step, is_found & (omega >= F::ratio(1, 1024)))
    }
}

/// ξ where Ω and γ say enough of it, at the digits of f64 or fewer.
#[inline(always)]
pub(super) fn near<F: Float>(known: &LowOmega<F>) -> Option<F> {
    if const { F::PRECISION > f64::MANTISSA_DIGITS } {
        return None;
    }
    let (xi, is_found) = known.stationary_point();
    is_found.then_some(xi)
}

/// The exact border α_min of 2⁻¹⁰ ≤ Ω < 1/2, and whether it is found this way: as [`super::Border`] has it,
/// without branches.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn border_near<F: Float>(omega: F, angle: &LowAngle<F>, phase_function: Pair<F>) -> (F, bool) {
    let (known, one_minus_square) =
        (LowOmega::new(omega, angle, phase_function), one_minus_square_wide(omega));
    let (xi, is_found) = known.stationary_point();
    let width = known.width(xi);
    let turning_point = turning_point_border(phase_function, one_minus_square, omega.wide()).value();
    let inner = turning_point.or_larger(border_force_ratio(phase_function, width).value());
    let is_inner = is_stationary_value_larger(one_minus_square, omega, width, angle.is_tangent_positive());
    (if is_inner { inner } else { turning_point }, is_found)
}
