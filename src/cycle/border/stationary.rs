//! The stationary point of the border's function f: where the velocity first touches zero inside the half
//! cycle.

use super::near::{LowOmega, near};
use super::{border_force_ratio, is_stationary_value_larger};
use crate::cycle::phase_function::{LowAngle, PhaseFunction, arc_less_sine, one_minus_square};
use crate::float::pair::Pair;
use crate::float::{Field, Float, Real, at_precision, fused};
use crate::root;

/// The stationary value as a width of the cycle, and where it is.
pub(super) struct Inner<F> {
    /// `(1 − Ω²) S`.
    pub(super) width: Pair<F>,
    omega: F,
    gamma: Pair<F>,
    xi: F,
    /// Whether T > 0, so that τ* lies in the first quarter.
    rises: bool,
}

impl<F: Float> Inner<F> {
    /// The phase τ* in (0, π); the width may require it to lower accuracy than is known.
    pub(super) fn phase(&self) -> F {
        let condition = |xi| stationarity(self.omega, self.gamma.value(), xi);
        let xi = root::newton(self.xi, F::int(0), F::pi(), condition).implicit_root(condition);
        let tau = ((self.gamma + Pair::exact(xi)) * self.omega).value();
        if self.rises { tau } else { F::pi() - tau }
    }

    /// Whether the border is here, and not at the turning point; `held` is η (1 − Ω²).
    #[inline(always)]
    pub(super) fn is_border(&self, held: Pair<F>, eta: F) -> bool {
        is_stationary_value_larger(held, self.omega, self.width, self.rises && eta == F::int(1))
    }

    /// `hypot(K, (1 − Ω²) S)`, whose squares can be out of range where Ω is very small.
    #[inline(always)]
    pub(super) fn force_ratio(&self, p: &PhaseFunction<F>) -> F {
        let (k, width) = (p.wide(), self.width);
        if p.omega() > F::exp2i(-F::RATIO_EXPONENT / 2) {
            return border_force_ratio(k, width).value();
        }
        let down = F::exp2i(-F::RATIO_EXPONENT);
        border_force_ratio(k * down, width * down).value() / down
    }
}

/// The stationary value below Ω = 1/2; `None` where T = 0.
///
/// Takes a copy, so that the path above 1/2 keeps everything in registers.
#[inline(never)]
pub(super) fn inner_maximum<F: Float>(p: PhaseFunction<F>) -> Option<Inner<F>> {
    fused!(<F>(p: PhaseFunction<F>) -> Option<Inner<F>> {
        let omega = p.omega();
        if p.is_even_subharmonic() {
            return None;
        }
        let angle = LowAngle::of(&p);
        let known = LowOmega::new(omega, &angle, p.wide());
        let xi = match near(&known) {
            Some(xi) => xi,
            None => stationary_point(omega, known.gamma.value()),
        };
        let width = known.width(xi);
        // The value is stationary at ξ only to the accuracy of ξ; its derivative has a form that requires
        // less.
        let hi = width.hi.differentiated_as(|| change_of_width(&p, width.hi.constant()) * omega);
        let width = Pair::new(hi, width.lo.constant());
        Some(Inner { width, omega, gamma: known.gamma, xi, rises: angle.is_tangent_positive() })
    })
}

/// The derivative of `(1 − Ω²) S` by Ω.
fn change_of_width<F: Float>(p: &PhaseFunction<F>, width: F) -> F {
    let (omega, q) = (p.omega().constant(), one_minus_square(p.omega()).constant());
    q * inner_change(p).constant() / omega - F::int(2) * omega * width / q
}

/// `Ω S` of the stationary point ξ: `[sin γ cos τ + sin ξ]/(|cos β| sin τ)`, all terms positive.
#[inline]
pub(crate) fn stationary_value<R: Real>(lobe_phase: R, cos_beta: R, tau: R, xi: R) -> R {
    let (sin_tau, cos_tau) = tau.sin_cos();
    (lobe_phase.sin() * cos_tau + xi.sin()) / (cos_beta.abs() * sin_tau)
}

/// `(g, g′)` at ξ: the stationarity condition of the border's head and its derivative.
///
/// For small σ = γ + ξ all of g's terms are small and their sum is of the third order. With γ = σ − ξ,
/// `g = sin ξ (cos τ − cos σ) − cos ξ [(σ − sin σ) − (τ − sin τ)/Ω]`, whose parts are known to full relative
/// accuracy.
#[inline]
fn stationarity<F: Float>(omega: F, lobe_phase: F, xi: F) -> (F, F) {
    let sigma = lobe_phase + xi;
    let tau = omega * sigma;
    let (sin_tau, cos_tau) = tau.sin_cos();
    let (sin_xi, cos_xi) = xi.sin_cos();
    let inverse = F::int(1) / omega;
    let g = if sigma < F::int(1) {
        let defect = arc_less_sine(sigma) - arc_less_sine(tau) * inverse;
        sin_xi * fall_of_cosine(tau, sigma) - cos_xi * defect
    } else {
        condition(inverse, (sin_tau, cos_tau), (sin_xi, cos_xi), lobe_phase.sin())
    };
    (g, condition_slope(omega, inverse, sin_tau, sin_xi))
}

/// `g = cos τ sin ξ − sin τ cos ξ/Ω + sin γ`, zero at the stationary point; `inverse` is 1/Ω.
#[inline]
pub(crate) fn condition<R: Field>(
    inverse: R,
    (sin_tau, cos_tau): (R, R),
    (sin_xi, cos_xi): (R, R),
    sin_gamma: R,
) -> R {
    cos_tau * sin_xi - inverse * sin_tau * cos_xi + sin_gamma
}

/// `g′ = (1/Ω − Ω) sin τ sin ξ`, positive for ξ in (0, π).
#[inline]
pub(crate) fn condition_slope<R: Field>(omega: R, inverse: R, sin_tau: R, sin_xi: R) -> R {
    (inverse - omega) * sin_tau * sin_xi
}

/// `cos τ − cos σ` as a product: both angles are small near Ω = 1/(2n).
pub(super) fn fall_of_cosine<F: Float>(tau: F, sigma: F) -> F {
    let half = F::ratio(1, 2);
    F::int(2) * (half * (sigma + tau)).sin() * (half * (sigma - tau)).sin()
}

/// The zero ξ of `g` on (0, π): Brent's method at f64 on the bracket, then Newton at ever higher precision.
///
/// g is increasing, so every zero in the bracket is the one; Newton only polishes.
pub(crate) fn stationary_point<F: Float>(omega: F, gamma: F) -> F {
    let start = if gamma * gamma * gamma * gamma < F::from_f64(f64::EPSILON) {
        // g is lost in rounding at f64; ξ/γ = 1/2 + O(γ²).
        gamma / F::int(2)
    } else if const { F::PRECISION <= f64::MANTISSA_DIGITS } {
        let (omega, gamma) = (omega.to_f64(), gamma.to_f64());
        let g = |xi| stationarity(omega, gamma, xi).0;
        F::from_f64(root::bracketed(0.0, core::f64::consts::PI, g))
    } else {
        at_precision!(narrowed, <F>(omega: F, gamma: F) -> F, |there, back: G| {
            back(stationary_point(there(omega), there(gamma)))
        })
    };
    let condition = |xi| stationarity(omega, gamma, xi);
    root::newton(start, F::int(0), F::pi(), condition).implicit_root(condition)
}

/// Ω S′ on the bands below Ω = 1/2 where S is the inner stationary value.
pub(super) fn inner_change<F: Float>(p: &PhaseFunction<F>) -> F {
    let (omega, gamma, tangent) = (p.omega(), p.lobe_phase().value(), p.tangent());
    let (_, cos_beta) = p.sin_cos();
    let cosine = cos_beta.abs();
    let xi = stationary_point(omega, gamma);
    let sigma = gamma + xi;
    let tau = omega * sigma;
    let value = stationary_value(gamma, cos_beta, tau, xi) / omega;
    let half = F::ratio(1, 2);
    let fall = fall_of_cosine(tau, sigma);
    let turning = (F::pi() * half * fall / cosine).with_sign_of(tangent * fall);
    -(value + (tau * xi.cos() + turning) / (omega.square() * tau.sin() * cosine))
}
