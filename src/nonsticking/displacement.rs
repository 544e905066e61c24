//! Maximum displacement Δ₀ and its phase ω_d t₂ (eq. 40–44).

use crate::float::{Field, Float};

/// Maximum displacement `Δ₀/B` of the non-sticking cycle (eq. 42, 44).
///
/// ```text
/// Δ₀/B = √[(α/(1−Ω²))² − (T/Ω)²] = √(α² − K²) / |1 − Ω²|
/// ```
///
/// The second form is the one computed ([`Field::leg`]), with no cancellation but that of α against |K|,
/// which is the problem's own.
///
/// `phase_function` is K(Ω), `one_minus_square` is 1 − Ω². Units of B = r_y/k. NaN where α < |K|,
/// infinite at Ω = 1. Source: Hong & Liu 2001, eq. 44; Den Hartog 1931 has the same. Accuracy at f64: a
/// relative error of `α²/(α² − K²)` times that of K.
#[inline(always)]
pub fn max_displacement<R: Field>(phase_function: R, alpha: R, one_minus_square: R) -> R {
    // Δ₀/B = √(α² − K²) / |1 − Ω²|
    displacement_of_leg(alpha.leg(phase_function), one_minus_square)
}

/// [`max_displacement`] for a known `√(α² − K²) = α |sin ω_d t₂|`.
#[inline(always)]
pub(crate) fn displacement_of_leg<R: Field>(leg: R, one_minus_square: R) -> R {
    // Δ₀/B = √(α² − K²) / |1 − Ω²|
    leg / one_minus_square.abs()
}

/// `α² − K² = (α − K)(α + K)`, the square of `α sin ω_d t₂` (eq. 40, 41).
#[inline(always)]
pub(crate) fn squared_sine<R: Field>(phase_function: R, alpha: R) -> R {
    // α² − K² = (α − K)(α + K)
    (alpha - phase_function) * (alpha + phase_function)
}

/// Maximum displacement Δ₀ from the paper's own quantities (eq. 42): `√[A² − (B T/Ω)²]`.
///
/// `a` is A, `b` is B, `tangent` is T = sin π₁/(1 + cos π₁); any consistent unit of length. The
/// difference of squares cancels near Ω = 1: [`max_displacement`] is the form to compute with.
#[inline]
pub fn max_displacement_from_amplitude<R: Field>(a: R, b: R, tangent: R, omega: R) -> R {
    // Δ₀ = √[A² − (B T/Ω)²]
    (a.square() - (b * tangent / omega).square()).sqrt()
}

/// Sine of the phase of the maximum displacement (eq. 40): `sin ω_d t₂ = Δ₀/A = (1 − Ω²)(Δ₀/B)/α`.
#[inline(always)]
pub fn sin_displacement_phase<R: Field>(max_displacement: R, alpha: R, one_minus_square: R) -> R {
    // sin ω_d t₂ = (1 − Ω²)(Δ₀/B)/α
    one_minus_square * max_displacement / alpha
}

/// Cosine of the phase of the maximum displacement (eq. 41): `cos ω_d t₂ = B T/(A Ω) = K/α`.
#[inline(always)]
pub fn cos_displacement_phase<R: Field>(phase_function: R, alpha: R) -> R {
    // cos ω_d t₂ = K/α
    phase_function / alpha
}

/// Phase `ω_d t₂` of the maximum displacement, in `[0, 2π)` (eq. 43, corrected).
///
/// The angle whose cosine is K/α and whose sine has the sign of 1 − Ω: in (0, π) below the natural
/// frequency, in (π, 2π) above. The paper takes it in (π/2, 3π/2) always, which holds only where K < 0;
/// on (1/3, 1/2), (1/5, 1/4), … K is positive and the phase lies in the other half. At Ω = 0.4, α = 9
/// it is 1.33529…, where eq. 43 as printed gives 1.80630… ([`crate::nonsticking::printed`]).
///
/// NaN where α < |K|. Source: Hong & Liu 2001, eq. 40, 41, 43. Accuracy at f64: 4 ulp away from α = |K|.
#[inline]
pub fn displacement_phase<F: Float>(phase_function: F, alpha: F, omega: F) -> F {
    let sine = squared_sine(phase_function, alpha).sqrt() / alpha;
    let cosine = cos_displacement_phase(phase_function, alpha);
    phase(if omega < F::int(1) { sine } else { -sine }, cosine)
}

/// The angle in `[0, 2π)` with this sine and cosine.
#[inline(always)]
pub(crate) fn phase<F: Float>(sine: F, cosine: F) -> F {
    // From half a turn on, 2π − |angle| would round the angle twice.
    let is_below = sine < F::int(0);
    let angle = F::angle_of(sine.abs(), if is_below { -cosine } else { cosine });
    if is_below { F::pi() + (angle + F::pi_rest().0) } else { angle }
}
