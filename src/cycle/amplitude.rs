//! The cycle by its amplitude: the force that belongs to a peak displacement Δ₀.

use super::border::border_force_ratio;
use crate::float::Field;

/// Eq. 44 solved for the force ratio: `α = √[K² + ((1 − Ω²) Δ₀/B)²]`.
///
/// `phase_function` is K(Ω), `one_minus_square` is 1 − Ω². Two squares are added, so that nothing cancels.
#[inline]
pub(crate) fn force_ratio_from_displacement<R: Field>(
    phase_function: R,
    max_displacement: R,
    one_minus_square: R,
) -> R {
    // α = hypot(K, (1 − Ω²) Δ₀/B)
    border_force_ratio(phase_function, one_minus_square * max_displacement)
}
