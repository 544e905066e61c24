//! Peak displacement Δ₀ and its phase ω_d t₂ (eq. 40–44), and phases reduced to one period.

use crate::float::{Field, Float};

/// Peak displacement `Δ₀/B` of the non-sticking cycle (eq. 42, 44).
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
    max_displacement_by(phase_function, alpha, one_minus_square, |a, b| a / b)
}

/// [`max_displacement`] with a quotient `over` that may know a reciprocal.
#[inline(always)]
pub(crate) fn max_displacement_by<R: Field>(
    phase_function: R,
    alpha: R,
    one_minus_square: R,
    over: impl Fn(R, R) -> R,
) -> R {
    // Δ₀/B = √(α² − K²) / |1 − Ω²|
    displacement_of_leg(alpha.leg(phase_function), one_minus_square, over)
}

/// [`max_displacement`] for a known `√(α² − K²) = α |sin ω_d t₂|`.
#[inline(always)]
pub(crate) fn displacement_of_leg<R: Field>(leg: R, one_minus_square: R, over: impl Fn(R, R) -> R) -> R {
    // Δ₀/B = √(α² − K²) / |1 − Ω²|
    over(leg, one_minus_square.abs())
}

/// `α² − K² = (α − K)(α + K)`, the square of `α sin ω_d t₂` (eq. 40, 41).
#[inline(always)]
pub(crate) fn squared_sine<R: Field>(phase_function: R, alpha: R) -> R {
    // α² − K² = (α − K)(α + K)
    (alpha - phase_function) * (alpha + phase_function)
}

/// Peak displacement Δ₀ from the paper's own quantities (eq. 42): `√[A² − (B T/Ω)²]`.
///
/// `a` is A, `b` is B, `tangent` is T = sin π₁/(1 + cos π₁); any consistent unit of length. The
/// difference of squares cancels near Ω = 1: [`max_displacement`] is the form to compute with.
#[inline]
pub fn max_displacement_from_amplitude<R: Field>(a: R, b: R, tangent: R, omega: R) -> R {
    // Δ₀ = √[A² − (B T/Ω)²]
    (a.square() - (b * tangent / omega).square()).sqrt()
}

/// Sine of the phase of the peak displacement (eq. 40): `sin ω_d t₂ = Δ₀/A = (1 − Ω²)(Δ₀/B)/α`.
#[inline(always)]
pub fn sin_displacement_phase<R: Field>(max_displacement: R, alpha: R, one_minus_square: R) -> R {
    // sin ω_d t₂ = (1 − Ω²)(Δ₀/B)/α
    one_minus_square * max_displacement / alpha
}

/// Cosine of the phase of the peak displacement (eq. 41): `cos ω_d t₂ = B T/(A Ω) = K/α`.
#[inline(always)]
pub fn cos_displacement_phase<R: Field>(phase_function: R, alpha: R) -> R {
    // cos ω_d t₂ = K/α
    phase_function / alpha
}

/// Phase `ω_d t₂` of the peak displacement, in `[0, 2π)` (eq. 43, corrected).
///
/// The angle whose cosine is K/α and whose sine has the sign of 1 − Ω: in (0, π) below the natural
/// frequency, in (π, 2π) above. The paper takes it in (π/2, 3π/2) always, which holds only where K < 0;
/// on (1/3, 1/2), (1/5, 1/4), … K is positive and the phase lies in the other half. At Ω = 0.4, α = 9
/// it is 1.33529…, where eq. 43 as printed gives 1.80630… ([`crate::cycle::printed`]).
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

/// `phase` modulo 2π, in `[0, 2π)`.
///
/// More than one period away, by the sine and cosine, whose own reduction is exact however large the phase.
#[inline]
pub(crate) fn reduce<F: Float>(phase: F) -> F {
    let (zero, period) = (F::int(0), F::int(2) * F::pi());
    if phase >= zero && phase < period {
        return phase;
    }
    let reduced = if phase >= -period && phase < zero { phase + period } else { principal(phase) };
    // Rounding can carry a tiny negative phase to the period itself.
    if reduced >= period { zero } else { reduced }
}

/// Phase ω_d t₁ of the peak velocity, in `[0, 2π)`, from that of the peak displacement and the centred
/// time ψ = ω_n(t₂ − t₁) − β.
///
/// `ω_d t₁ = ω_d t₂ − π/2 − Ωψ`
#[inline(always)]
pub(crate) fn velocity_phase<F: Float>(displacement_phase: F, omega: F, psi: F) -> F {
    let period = F::int(2) * F::pi();
    let phase = (-omega).mul_add(psi, displacement_phase - F::pi() * F::ratio(1, 2));
    let phase = if phase < F::int(0) { phase + period } else { phase };
    // Rounding can carry a tiny negative phase to the period itself.
    if phase >= period { F::int(0) } else { phase }
}

/// The angle of `phase` in `[0, 2π]`.
#[cold]
fn principal<F: Float>(phase: F) -> F {
    let (s, c) = phase.sin_cos();
    let angle = s.atan2(c);
    if angle < F::int(0) { angle + F::int(2) * F::pi() } else { angle }
}

#[cfg(test)]
mod phase_tests {
    use super::reduce;
    use std::f64::consts::TAU;

    #[test]
    fn phases_are_reduced_to_one_period() {
        assert_eq!(reduce(1.0), 1.0);
        assert_eq!(reduce(-1e-300), 0.0);
        assert!((reduce(-1.0) - (TAU - 1.0)).abs() < 1e-15);
        assert!((reduce(1.0 + 3.0 * TAU) - 1.0).abs() < 1e-14);
        assert!(reduce(f64::NAN).is_nan());
        // 1e300 modulo 2π, from 2π at 330 digits.
        assert!((reduce(1e300_f64) - 4.099_312_823_027_354).abs() < 1e-15);
    }
}
