//! Phases reduced to one period.

use crate::float::Float;

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

/// Phase ω_d t₁ of the maximum velocity, in `[0, 2π)`, from that of the maximum displacement and the centred
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
mod tests {
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
