//! Size of the dissipation loop, and the force ratio that makes it largest (eq. 63–67).

use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Field, Float};

/// Energy dissipated in a cycle, `s = 4 r_y Δ₀` (eq. 63): the area of the friction loop.
///
/// `friction_bound` is r_y and `max_displacement` is Δ₀, in consistent units.
#[inline]
pub fn loop_size<R: Field>(friction_bound: R, max_displacement: R) -> R {
    // s = 4 r_y Δ₀
    R::int(4) * friction_bound * max_displacement
}

/// Loop size per lossless static elastic energy (eq. 64): `A₁ = 2ks/p₀² = 8(Δ₀/B)/α²`.
///
/// `max_displacement` is Δ₀/B. It compares frictions at given k, p₀ and Ω. Source: Hong & Liu 2001, eq. 64.
#[inline(always)]
pub fn loop_size_stiffness<R: Field>(max_displacement: R, alpha: R) -> R {
    loop_size_stiffness_by(max_displacement, alpha, |a, b| a / b)
}

/// [`loop_size_stiffness`] with a quotient `over` that may know a reciprocal.
#[inline(always)]
pub(crate) fn loop_size_stiffness_by<R: Field>(max_displacement: R, alpha: R, over: impl Fn(R, R) -> R) -> R {
    // A₁ = 8(Δ₀/B)/α²
    over(over(max_displacement, alpha), alpha).times(8)
}

/// Loop size per lossless static pseudo-elastic energy (eq. 67): `A₂ = 2 m ω_d² s/p₀² = Ω² A₁`.
///
/// It compares stiffnesses at given m, p₀, ω_d and α. Source: Hong & Liu 2001, eq. 67.
#[inline(always)]
pub fn loop_size_inertia<R: Field>(loop_size_stiffness: R, omega: R) -> R {
    // A₂ = Ω² A₁
    omega.square() * loop_size_stiffness
}

/// The force ratio of the largest A₁ at a given Ω (eq. 65): `α* = √2 |K|`, from dA₁/dα = 0.
///
/// **Condition.** The paper does not say that the optimum is reached only if the body does not stick there,
/// α* ≥ α_min(Ω): for Ω ≥ 1/2 that is `Ω|T| ≥ 1`. Elsewhere the best non-sticking force ratio is the border
/// itself. At Ω = 1/(2n) K = 0, and this formula gives 0. Source: Hong & Liu 2001, eq. 65.
#[inline]
pub fn best_force_ratio<R: Field>(phase_function: R) -> R {
    // α* = √2 |K|
    R::int(2).sqrt() * phase_function.abs()
}

/// The largest A₁ at a given Ω (eq. 66): `A₁max = 4/(|K| |1 − Ω²|)`, reached at [`best_force_ratio`].
///
/// It holds under the same condition. Infinite at Ω = 1 and at Ω = 1/(2n). Source: Hong & Liu 2001, eq. 66.
#[inline]
pub fn best_loop_size<R: Field>(phase_function: R, one_minus_square: R) -> R {
    // A₁max = 4/(|K| |1 − Ω²|)
    R::int(4) / (phase_function.abs() * one_minus_square.abs())
}

/// [`best_force_ratio`] at the frequency ratio of `p`; accuracy at f64: 1 ulp.
#[inline(always)]
pub(crate) fn best_force_ratio_at<F: Float>(p: &PhaseFunction<F>) -> F {
    best_force_ratio(p.wide()).value()
}

/// [`best_loop_size`] at the frequency ratio of `p`; accuracy at f64: 1 ulp.
#[inline(always)]
pub(crate) fn best_loop_size_at<F: Float>(p: &PhaseFunction<F>) -> F {
    let (k, q, zero) = (p.wide(), p.one_minus_square(), F::int(0));
    // A pair has no infinity.
    if k.hi == zero || q.hi == zero { F::int(1) / zero } else { best_loop_size(k, q).value() }
}
