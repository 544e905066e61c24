//! Peak velocity V₀, its phase ω_d t₁ and the deviation Δ₁ (eq. 25, 37, 45–49).
//!
//! # Which root of eq. 46, and why it is the maximum
//!
//! Eq. 46 says that the acceleration is zero at t₁; below Ω = 1/2 it can have several roots, and V₀ is the
//! velocity at the best. In the variables of the half cycle the velocity is a slow and a fast wave,
//!
//! ```text
//! v/(Bω_n) = R cos Ω(ψ − ψ_c) + c cos(ψ − ψ_p),   R = Ωα/|1 − Ω²|,   c = 1/|cos β|,
//! ```
//!
//! where ψ_c is the phase 0 (Ω < 1) or π (Ω > 1) of the drive, `ψ_c = −sgn(1−Ω) asin(K/α)/Ω`, and ψ_p is the
//! crest nearest to it of the other wave, at distance e ≤ π.
//!
//! * **The crest.** For Ω < 1 that is `ψ_p = ±π/2`, with the sign of cos β, because |ψ_c| ≤ π/2: a cycle that
//!   does not stick has Δ₀/B ≥ S, S is at least the value |T| cot(πΩ/2)/Ω of the border's |f| at τ = πΩ, and
//!   therefore `tan Ω|ψ_c| = |T|/(ΩΔ₀/B) ≤ tan(πΩ/2)`.
//! * **Ω < 1.** Reflecting a point about ψ_c, or moving it one fast period towards ψ_c, only raises v, and
//!   beyond ψ_p both waves fall: the global maximum lies between ψ_c and ψ_p. At the distance d from ψ_c the
//!   root has `c sin(e − d) = RΩ sin Ωd`, and `sin(e − d)/sin Ωd` is strictly falling on (0, e), because
//!   cot(e − d) + Ω cot Ωd ≥ Ω cot Ωd − cot d > 0. So there is exactly one root in between, and it is V₀.
//!   It lies in the half cycle: were it beyond the end, v would rise from ψ_c to the end, where it is 0, and
//!   the cycle would not be one. (e = π puts two equal maxima at ±d: the first is taken.)
//! * **Ω > 1.** (v′/cos Ωψ)′ cos²Ωψ is increasing, and at the end ψ = β it is Ωv′ ≤ 0: so v′/cos Ωψ falls,
//!   and v has one stationary point in the half cycle. It lies between ψ_c and β, where v′ changes sign.
//! * **The sign of ρ.** What swings at ω_n is, at the maximum, `ρ/B = sin ψ/cos β` (eq. 27), and
//!   `v′(0) = (1 − Ω sin β)/cos β` up to a positive factor. For Ω < 1 that has the sign of cos β, that of
//!   ψ_p: v still rises towards ψ_p at ψ = 0, so that the maximum lies between 0 and ψ_p = ±π/2, and ρ > 0.
//!   For Ω > 1, cos β > 0 and Ω sin β = (π/2) sin β/β > 1: v falls at ψ = 0, the maximum is before it, and
//!   ρ < 0. So ρ has the sign of 1 − Ω.
//!
//! So one bracket serves every Ω, and whatever a fast iteration finds inside it is the answer.

pub(crate) mod arrival;
mod centre;
mod fastest;
mod iteration;
pub(crate) mod low;
mod step;
pub(crate) mod waves;

use super::Reversal;
use super::half_cycle::HalfCycle;
use super::undamped::half_cycle;
use crate::cycle::phase_function::{Frequency, Offset, PhaseFunction};
use crate::float::pair::Pair;
use crate::float::{Field, Real};
use crate::float::{Float, fused};
pub(crate) use fastest::Fastest;
use iteration::{fastest_and_displacement, from_centre_or_afar};
use low::{LowCircular, LowWaves};
use waves::{Circular, Waves};

/// Deviation `Δ₁/B` of the body from rest at its peak velocity (eq. 25, 47): `α sin ω_d t₁ − 1`.
///
/// The deviation increases with α at a given friction (0.3728, 0.4665, 0.6597 at Ω = 0.7 for α = 1.6, 2, 10);
/// at a given force p₀ the length Δ₁ decreases with α. The paper's remarks on Figure 6 and in its conclusion
/// refer to one case each. Source: Hong & Liu 2001, eq. 47.
#[inline]
pub fn deviation<R: Field>(alpha: R, sin_velocity_phase: R) -> R {
    // Δ₁/B = α sin ω_d t₁ − 1
    alpha * sin_velocity_phase - R::int(1)
}

/// Left side of eq. 46, divided by B: zero at the phase of the peak velocity.
///
/// `(1 + cos π₁) cos θ + sin π₁ sin θ + (A/B) Ω² (1 + cos π₁) sin ω_d t₁` with θ = ω_n(t₂ − t₁).
/// `amplitude` is A/B = α/(1 − Ω²).
#[inline]
pub fn velocity_phase_residual<R: Real>(
    amplitude: R,
    omega: R,
    sin_cos_pi_1: (R, R),
    lag: R,
    sin_velocity_phase: R,
) -> R {
    let (sin_pi_1, cos_pi_1) = sin_cos_pi_1;
    let (sin_lag, cos_lag) = lag.sin_cos();
    let one_plus = R::int(1) + cos_pi_1;
    one_plus * cos_lag + sin_pi_1 * sin_lag + amplitude * omega.square() * one_plus * sin_velocity_phase
}

/// Peak velocity `V₀/(Bω_d)` from its phase (eq. 37, 48, 49, corrected).
///
/// ```text
/// V₀/(Bω_d) = (A/B) cos ω_d t₁ + (ρ/B)/Ω,   ρ/B = sgn(1−Ω) √[2/(1 + cos π₁) − (1 + Δ₁/B − (A/B) sin ω_d t₁)²]
/// ```
///
/// Both roots of the printed eq. 49 lose a sign. The second represents ρ (eq. 27), which has the sign of 1 −
/// Ω: as printed, always positive, V₀ is wrong for every Ω > 1 (1.93392 for 1.65415… at Ω = 1.5, α = 2.5).
/// The first represents (A/B) cos ω_d t₁, which is negative near the border for some Ω in (1/2, 1), such as
/// (0.93924, 1.2491). Neither sign is free here.
///
/// `sign` is sgn(1 − Ω), `amplitude` is A/B = α/(1 − Ω²). Two large terms cancel near Ω = 1 near the
/// border; [`crate::cycle::Cycle`] takes another way there. Source: Hong & Liu 2001, eq. 49.
#[inline]
pub fn max_velocity_from_phase<R: Field>(
    amplitude: R,
    omega: R,
    cos_pi_1: R,
    sin_cos_velocity_phase: (R, R),
    deviation: R,
    sign: R,
) -> R {
    let (sine, cosine) = sin_cos_velocity_phase;
    let x = R::int(1) + deviation - amplitude * sine;
    let rho = sign * (R::int(2) / (R::int(1) + cos_pi_1) - x.square()).sqrt();
    amplitude * cosine + rho / omega
}

/// The peak velocity of the half cycle at (Ω, α); `k` is K(Ω).
///
/// From Ω = 1/2 on by one step of Taylor's formula ([`waves`]), as batches do it. Elsewhere
/// third-order Householder steps, each of which quadruples the good digits, from the centre ([`centre`]);
/// where they do not settle inside the proven bracket, from a bracketed root at f64.
#[inline]
pub(crate) fn fastest<F: Float>(half: &HalfCycle<F>, k: F, alpha: F) -> Fastest<F> {
    if const { F::PRECISION > f64::MANTISSA_DIGITS } {
        return fastest_and_displacement(half, k, alpha).0;
    }
    let displacement = Pair::new(half.max_displacement(), half.displacement_rest());
    let found = match by_waves(half.omega(), displacement, Pair::exact(k)) {
        Some(found) => found,
        None => from_centre_or_afar(half, k, alpha).0,
    };
    found.differentiated(|| *half)
}

/// What is known of a cycle at its frequency ratio.
#[derive(Clone, Copy)]
pub(crate) struct GivenCycle<F> {
    pub(crate) reversal: Reversal<F>,
    /// Δ₀/B as rounded, and what that lacks.
    pub(crate) displacement: Pair<F>,
    pub(crate) alpha: F,
    /// ω_d t₂.
    pub(crate) displacement_phase: F,
}

/// [`fastest()`] of a cycle, and the deviation Δ₁/B if the iteration computes it; otherwise
/// [`Circular::deviation`] does.
#[inline(always)]
pub(crate) fn fastest_of_cycle<F: Float>(
    p: &PhaseFunction<F>,
    given: &GivenCycle<F>,
) -> (Fastest<F>, Option<F>) {
    let &GivenCycle { ref reversal, alpha, displacement, .. } = given;
    let (omega, k) = (p.omega(), reversal.phase_function());
    if const { F::PRECISION > f64::MANTISSA_DIGITS } {
        let (found, deviation) = fastest_and_displacement(&half_cycle(p, displacement), k.value(), alpha);
        return (found, Some(deviation));
    }
    let is_low = omega < F::ratio(1, 2);
    if is_low && let Some((found, deviation)) = by_low_waves(*p, *given) {
        let found = found.differentiated(|| half_cycle(p, displacement));
        return (found, Some(deviation.differentiated_as(|| reversal.deviation(omega, found.psi))));
    }
    if let Some(found) = by_waves(omega, displacement, k) {
        return (found.differentiated(|| half_cycle(p, displacement)), None);
    }
    let (found, deviation) = fastest_afar(*p, *given);
    (found, Some(deviation))
}

/// The peak velocity and Δ₁/B where no loop of a batch has them.
#[cold]
#[inline(never)]
fn fastest_afar<F: Float>(p: PhaseFunction<F>, given: GivenCycle<F>) -> (Fastest<F>, F) {
    let (half, reversal, omega) = (half_cycle(&p, given.displacement), &given.reversal, p.omega());
    let k = reversal.phase_function();
    let (found, at) = from_centre_or_afar(&half, k.value(), given.alpha);
    let found = found.differentiated(|| half);
    if omega < F::ratio(1, 2) {
        return (found, reversal.deviation(omega, found.psi));
    }
    let (s, c) = at.unwrap_or_else(|| found.psi.sin_cos());
    let at = (s.differentiated_as(|| found.psi.sin()), c.differentiated_as(|| found.psi.cos()));
    let (sin_beta, cos_beta) = half.sin_cos_beta();
    (found, super::deviation::of_fastest(omega, (Pair::exact(sin_beta), cos_beta), k, at))
}

/// The peak velocity without circular functions of the type's own, where Ω ≥ 1/2 and the start is near
/// enough.
#[inline(always)]
fn by_waves<F: Float>(omega: F, displacement: Pair<F>, k: Pair<F>) -> Option<Fastest<F>> {
    if !PhaseFunction::is_rational_enough(omega) {
        return None;
    }
    let at = Frequency::new(&Offset::new(), omega, k);
    let waves = Waves { max_displacement: displacement.hi, rest: displacement.lo, at };
    let (found, velocity) = waves.arrive(&Circular::new(), waves.start());
    found.is_found.then_some(Fastest { psi: found.psi, velocity })
}

/// The peak velocity below Ω = 1/2 without circular functions of the type's own, where the start is near
/// enough; and Δ₁/B there.
///
/// Not inlined, so that the path above 1/2 keeps everything in registers.
#[inline(never)]
fn by_low_waves<F: Float>(p: PhaseFunction<F>, given: GivenCycle<F>) -> Option<(Fastest<F>, F)> {
    fused!(<F>(p: PhaseFunction<F>, given: GivenCycle<F>) -> Option<(Fastest<F>, F)> {
        let GivenCycle { alpha, displacement, displacement_phase, .. } = given;
        let (omega, circular) = (p.omega(), LowCircular::new());
        let waves = LowWaves {
            omega,
            inverse: F::int(1) / omega,
            max_displacement: displacement.hi,
            rest: displacement.lo,
            beta: p.sin_cos_of_cycle(),
        };
        let theta = waves.start(&circular, alpha, displacement_phase);
        let (found, velocity) = waves.arrive(&circular, displacement_phase, theta);
        found.is_found.then_some((Fastest { psi: found.psi, velocity }, found.displacement))
    })
}

#[cfg(test)]
mod tests;
