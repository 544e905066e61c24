//! Maximum displacement Δ₀ and its phase ω_d t₂ (eq. 40–44).

use crate::float::{AtPrecision, Float, Real};

/// Maximum displacement `Δ₀/B` of the non-sticking cycle (eq. 42, 44).
///
/// ```text
/// Δ₀/B = √[(α/(1−Ω²))² − (T/Ω)²] = √[(α − K)(α + K)] / |1 − Ω²|
/// ```
///
/// The second form is the one computed: one square root of a product of two differences, with no
/// cancellation but that of α against |K|, which is the problem's own.
///
/// `phase_function` is K(Ω), `one_minus_square` is 1 − Ω². Units of B = r_y/k. NaN where α < |K|,
/// infinite at Ω = 1. Source: Hong & Liu 2001, eq. 44; Den Hartog 1931 has the same. Accuracy at f64: a
/// relative error of `α²/(α² − K²)` times that of K.
#[inline]
pub fn max_displacement<R: Real>(phase_function: R, alpha: R, one_minus_square: R) -> R {
    squared_sine(phase_function, alpha).sqrt() / one_minus_square.abs()
}

/// `α² − K² = (α − K)(α + K)`, the square of `α sin ω_d t₂` (eq. 40, 41).
#[inline]
pub(crate) fn squared_sine<R: Real>(phase_function: R, alpha: R) -> R {
    (alpha - phase_function) * (alpha + phase_function)
}

/// Maximum displacement Δ₀ from the paper's own quantities (eq. 42): `√[A² − (B T/Ω)²]`.
///
/// `a` is A, `b` is B, `tangent` is T = sin π₁/(1 + cos π₁); any consistent unit of length. The
/// difference of squares cancels near Ω = 1: [`max_displacement`] is the form to compute with.
#[inline]
pub fn max_displacement_from_amplitude<R: Real>(a: R, b: R, tangent: R, omega: R) -> R {
    (a.square() - (b * tangent / omega).square()).sqrt()
}

/// Sine of the phase of the maximum displacement (eq. 40): `sin ω_d t₂ = Δ₀/A = (1 − Ω²)(Δ₀/B)/α`.
#[inline]
pub fn sin_displacement_phase<R: Real>(max_displacement: R, alpha: R, one_minus_square: R) -> R {
    one_minus_square * max_displacement / alpha
}

/// Cosine of the phase of the maximum displacement (eq. 41): `cos ω_d t₂ = B T/(A Ω) = K/α`.
#[inline]
pub fn cos_displacement_phase<R: Real>(phase_function: R, alpha: R) -> R {
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
    phase_of_sine(squared_sine(phase_function, alpha).sqrt(), phase_function, alpha, omega)
}

/// [`displacement_phase`] where `sine = α |sin ω_d t₂| = √(α² − K²)` is known.
#[inline]
pub(crate) fn phase_of_sine<F: Float>(sine: F, phase_function: F, alpha: F, omega: F) -> F {
    if F::PRECISION > f64::MANTISSA_DIGITS {
        return corrected_phase(sine, phase_function, alpha, omega);
    }
    if omega < F::int(1) {
        sine.atan2(phase_function)
    } else {
        F::pi() + (sine.atan2(-phase_function) + F::pi_rest().0)
    }
}

/// [`displacement_phase`] from its value θ at a lower precision: `t₂ − θ = d + d³/6 + O(d⁵)`,
/// `d = sin t₂ cos θ − cos t₂ sin θ`. One pair of sine and cosine, where the inverse function costs twice that.
#[cold]
fn corrected_phase<F: Float>(sine: F, phase_function: F, alpha: F, omega: F) -> F {
    let start = F::narrowed(PhaseStart { sine, phase_function, alpha, below_one: omega < F::int(1) });
    let sine = (sine / alpha).with_sign_of(F::int(1) - omega);
    let cosine = cos_displacement_phase(phase_function, alpha);
    let (s, c) = start.sin_cos();
    let d = sine * c - cosine * s;
    start + (d + d.square() * d / F::int(6))
}

/// The phase of the maximum displacement at a lower precision.
struct PhaseStart<F> {
    sine: F,
    phase_function: F,
    alpha: F,
    below_one: bool,
}

impl<F: Float> AtPrecision<F> for PhaseStart<F> {
    type Output = F;

    fn run<G: Float>(self, there: impl Fn(F) -> G, back: impl Fn(G) -> F) -> F {
        // Ω matters by its side of 1 alone, which rounding must not change.
        let side = if self.below_one { G::ratio(1, 2) } else { G::int(2) };
        back(phase_of_sine(there(self.sine), there(self.phase_function), there(self.alpha), side))
    }
}
