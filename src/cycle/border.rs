//! The minimum force ratio that keeps the body from sticking (eq. 57–62, and the exact condition).
//!
//! The cycle of eq. 40–56 is a motion of the oscillator only while it slides between its reversals. The paper
//! requires that only at the turning point (eq. 58, 59), which gives eq. 61. Den Hartog's condition requires
//! it throughout the half cycle, x′ < 0 for 0 < τ = ω_d(t − t₂) < π:
//!
//! ```text
//! Δ₀/B ≥ S(Ω) = sup f(τ),   f(τ) = [sin(τ/Ω) + T (cos τ − cos(τ/Ω))]/(Ω sin τ),   f(0⁺) = 1/Ω²,
//! ```
//!
//! so that the exact border is `α_min = hypot(K, (1 − Ω²) S)`, and eq. 61 is its value where the
//! supremum is the limit at the turning point, S = 1/Ω².
//!
//! # Where the supremum is, and why it is the global one
//!
//! With β = π/2Ω, γ = β mod π ∈ [0, π) and σ = τ/Ω, `f = [T cos τ + sin(σ − β)/cos β]/(Ω sin τ)`, and f(π −
//! τ) = −f(τ), so that it suffices to find the largest |f| on (0, π/2]. Let `f′ sin²τ = G/Ω`. Then `G′ =
//! −(Ω⁻² − 1) sin τ sin(σ − β)/cos β`, whose sign is known between known points.
//!
//! * **Ω ≥ 1/2.** On (0, π/2], σ − β runs from −β to 0 within one sign of the sine, and G′ ≤ 0 throughout
//!   (for Ω > 1 the factor Ω⁻² − 1 changes sign with sin(σ − β)/cos β). So f falls from 1/Ω² to
//!   f(π/2) = 0, and S = 1/Ω²: **eq. 61 is exact for Ω ≥ 1/2.**
//! * **Ω < 1/2.** sin(σ − β)/cos β = sin(σ − γ)/cos γ opposes T = tan γ for 0 < σ < γ, helps it for
//!   γ < σ < γ + π, and so on in turn. Up to γ, G′ has one sign and G(0) = 0, so that f is monotonic: its
//!   values there lie between the limit 1/Ω² and f at γ. Beyond γ + π, cos τ and 1/sin τ were larger one half
//!   period earlier: a value of |f| where the sine opposes T is exceeded where it was as large and helped,
//!   and any value one period earlier. So the largest |f| has γ ≤ σ ≤ γ + π and the sign of T, or is the
//!   limit 1/Ω² at σ = 0. There G is monotonic on (γ, γ + π) and nonzero of opposite signs at its ends, and
//!   has no zero elsewhere in the lobe: f has there **one** stationary point σ* = γ + ξ, the only zero on (0,
//!   π) of `g(ξ) = cos Ωσ sin ξ − sin Ωσ cos ξ/Ω + sin γ`, g′ = (1/Ω − Ω) sin Ωσ sin ξ > 0.
//!   `S = max(1/Ω², |f(σ*)|)`.
//!
//! For T > 0, Ω in (1/(2n+1), 1/(2n)), f increases from 1/Ω² (G(0) = 0, G′ > 0 on (0, γ)), so that eq. 61 is
//! too low on the whole band; for T < 0 it is too low only next to the pole. There is a single root at any Ω,
//! and no scanning or sampling.

mod band_end;
mod larger;
mod lobe;
mod near;
mod range;
mod shortfall;
mod slope;
mod stationary;
mod turning_point;

use crate::cycle::phase_function::PhaseFunction;
use crate::float::pair::Pair;
use crate::float::{Float, fused};
use crate::machine::error::Error;
use larger::is_stationary_value_larger;
pub(crate) use lobe::Lobe;
pub use lobe::Minimum;
#[cfg(feature = "batch")]
pub(crate) use near::border_near;
pub(crate) use range::ordered_lobes;
pub(crate) use range::{BorderRange, border_range};
pub use shortfall::Shortfall;
use stationary::{Inner, inner_maximum};
#[cfg(feature = "mp")]
pub(crate) use stationary::{condition, condition_slope, stationary_point, stationary_value};
pub(crate) use turning_point::border_force_ratio;
#[cfg(test)]
pub(crate) use turning_point::turning_point_criterion;
pub use turning_point::{slip_excess, turning_point_border, turning_point_residual};

/// The minimum force ratio at a frequency ratio: exact, and by eq. 61.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Border<F> {
    /// The exact border α_min(Ω): at and above it the steady motion does not stick. With a static friction
    /// above the kinetic one, other motions that stick may coexist.
    ///
    /// Source: Den Hartog's condition, in closed form except for one bracketed root. Accuracy at f64: 2 ulp.
    pub min_force_ratio: F,
    /// Eq. 61, `hypot(K, 1/Ω² − 1)`: equal to the exact border for Ω ≥ 1/2, not above it below.
    pub min_force_ratio_turning_point: F,
    /// The phase `τ* = ω_d(t − t₂)`, in `[0, π)` up to rounding, where the velocity first touches zero on the
    /// border; 0 if that is the turning point itself. Eq. 61 is exact where it is 0.
    pub border_phase: F,
    /// `S(Ω)`: the minimum Δ₀/B of a cycle that does not stick.
    pub least_displacement: F,
}

impl<F: Float> Border<F> {
    /// The border at the frequency ratio Ω, without a damper; [`Border::of`] has one.
    ///
    /// # Errors
    /// Where Ω is not finite, not > 0 or outside the domain of [`crate::Ratios`].
    pub fn new(omega: F) -> Result<Self, Error> {
        let (omega, eta) = (crate::machine::ratios::frequency_ratio(omega)?, F::int(1));
        Ok(without_damping(omega, eta))
    }

    /// The border at the Ω, ζ and η of `ratios`, whatever their α.
    ///
    /// With a damper it is exact, too: every maximum of Den Hartog's condition is known
    /// (`src/cycle/damped/border.rs`). The analogue of eq. 61 suffices for `Ω ≥ √(1 − ζ²)/2` and for ζ ≥ 1. With a static
    /// friction of η times the kinetic one the condition at the turning point is `Δ₀/B ≥ (η + G + 2ζΩH)/Ω² − G`, G = H = 0
    /// without damping; inside the half cycle nothing changes.
    pub fn of(ratios: &crate::Ratios<F>) -> Self {
        if ratios.is_damped() {
            super::damped::border(&super::damped::half_period(ratios))
        } else {
            without_damping(ratios.omega(), ratios.static_friction_ratio())
        }
    }

    /// The border at the frequency ratio of `p`, ζ = 0, with a static friction of η times the kinetic one: at the
    /// turning point the force has to exceed η, so that `Δ₀/B ≥ η/Ω²` there; inside the half cycle nothing changes,
    /// because the body slides there.
    #[inline(always)]
    pub(crate) fn with_static_friction(p: &PhaseFunction<F>, eta: F) -> Self {
        let (turning_point, inner) = parts(p, eta);
        let limit = eta / p.omega().square();
        match inner {
            Some(inner) => Self {
                min_force_ratio: turning_point.or_larger(inner.force_ratio(p)),
                min_force_ratio_turning_point: turning_point,
                border_phase: inner.phase(),
                least_displacement: limit.or_larger((inner.width / p.one_minus_square()).value()),
            },
            None => Self::of_parts(turning_point, turning_point, F::int(0), limit),
        }
    }

    /// The border with its parts as found.
    pub(super) const fn of_parts(
        min_force_ratio: F,
        turning_point: F,
        border_phase: F,
        least_displacement: F,
    ) -> Self {
        Self {
            min_force_ratio,
            min_force_ratio_turning_point: turning_point,
            border_phase,
            least_displacement,
        }
    }

    /// Converts each part of the border to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Border<G> {
        Border {
            min_force_ratio: to(self.min_force_ratio),
            min_force_ratio_turning_point: to(self.min_force_ratio_turning_point),
            border_phase: to(self.border_phase),
            least_displacement: to(self.least_displacement),
        }
    }

    /// The border at the frequency ratio of `p`.
    #[inline(always)]
    pub(crate) fn at(p: &PhaseFunction<F>) -> Self {
        Self::with_static_friction(p, F::int(1))
    }

    #[doc(hidden)]
    /// The border at the turning point (eq. 61), `α = hypot(K, 1/Ω² − 1)`, at the frequency ratio of `p`.
    ///
    /// Dimensionless; in compensated pairs. Accuracy at f64: 2 ulp.
    #[inline(always)]
    pub fn turning_point_at(p: &PhaseFunction<F>) -> F {
        turning_point_border(p.wide(), p.one_minus_square(), p.omega().wide()).value()
    }
}

/// The border at the turning point, and the inner maximum where that is the border.
#[inline(always)]
fn parts<F: Float>(p: &PhaseFunction<F>, eta: F) -> (F, Option<Inner<F>>) {
    let held = held(p, eta);
    let turning_point = turning_point_border(p.wide(), held, p.omega().wide()).value();
    if p.omega() >= F::ratio(1, 2) {
        return (turning_point, None);
    }
    match inner_maximum(*p) {
        Some(inner) if inner.is_border(held, eta) => (turning_point, Some(inner)),
        _ => (turning_point, None),
    }
}

/// [`Border::min_force_ratio`] with a static friction of η times the kinetic one, without the rest.
#[inline(always)]
pub(crate) fn least_with_static_friction<F: Float>(p: &PhaseFunction<F>, eta: F) -> F {
    match parts(p, eta) {
        (turning_point, Some(inner)) => turning_point.or_larger(inner.force_ratio(p)),
        (turning_point, None) => turning_point,
    }
}

/// `η (1 − Ω²)`.
#[inline(always)]
fn held<F: Float>(p: &PhaseFunction<F>, eta: F) -> Pair<F> {
    if eta > F::int(1) { p.one_minus_square() * eta } else { p.one_minus_square() }
}

/// The border without damping at Ω and η.
#[inline]
fn without_damping<F: Float>(omega: F, eta: F) -> Border<F> {
    fused!(<F>(omega: F, eta: F) -> Border<F> {
        let p = PhaseFunction::of_valid(omega);
        Border::with_static_friction(&p, eta)
    })
}

#[cfg(test)]
mod tests;
