//! {Δ₀, α_min, A₁} from K, for Ω ≥ 1/2, and which points the loops may answer.

use super::block::select;
use crate::phase_function::one_minus_square;

/// The bounds of Ω within which nothing over- or underflows.
const LEAST_OMEGA: f64 = 0.5;
const GREATEST_OMEGA: f64 = 1_048_576.0;
/// The greatest α of [`crate::Ratios`], 2²⁵⁰.
const GREATEST_ALPHA: f64 = f64::from_bits((1023 + 250) << 52);
/// Where α² − K² is a smaller part of α² (α < 1.033 |K|), it amplifies the rounding of K.
const CLEAR_OF_PHASE_FUNCTION: f64 = 1.0 / 16.0;
/// Where α² and the square of the border differ by a smaller part of α², the careful path decides which is larger.
const CLEAR_OF_BORDER: f64 = 1.0 / (1u64 << 46) as f64;

/// Whether Ω is within the range of the loops; at Ω = 1 there is no Δ₀.
#[expect(clippy::manual_range_contains, reason = "one condition, where `contains` is two branches")]
#[inline(always)]
pub(crate) fn has_loops(omega: f64) -> bool {
    (omega >= LEAST_OMEGA) & (omega <= GREATEST_OMEGA) & (omega != 1.0)
}

/// Δ₀ and what goes with it.
pub(crate) struct Amplitude {
    /// Δ₀; NaN where there is no cycle.
    pub(crate) displacement: f64,
    /// α_min; NaN where the point is to be redone.
    pub(crate) border: f64,
    /// A₁; NaN where there is no cycle.
    pub(crate) size: f64,
    /// `α |sin ω_d t₂| = √(α² − K²)`.
    pub(crate) sine: f64,
}

/// What the border consists of: `α_min² = force² + K²`.
#[inline(always)]
pub(crate) fn border_force(omega: f64, inverse: f64) -> f64 {
    one_minus_square(omega) * (inverse * inverse)
}

/// At K, `distance` = |1 − Ω²|, `force` = (1 − Ω²) S with S the least Δ₀, the border, and whether Ω is one for loops.
#[inline(always)]
pub(crate) fn amplitude(
    alpha: f64,
    k: f64,
    distance: f64,
    force: f64,
    border: f64,
    in_range: bool,
) -> Amplitude {
    let nan = f64::NAN;
    let alpha_square = alpha * alpha;
    let sine_square = (alpha - k) * (alpha + k);
    let sine = sine_square.sqrt();
    // α² − α_min²
    let excess = (-force).mul_add(force, sine_square);
    let slides = excess >= 0.0;
    let displacement = sine / distance;
    let size = 8.0 * displacement / alpha_square;
    // Comparisons written so that NaN is redone, too.
    let clear = sine_square > CLEAR_OF_PHASE_FUNCTION * alpha_square;
    let ordinary = in_range
        & (alpha > 0.0)
        & (alpha <= GREATEST_ALPHA)
        & (excess.abs() > CLEAR_OF_BORDER * alpha_square)
        & (clear | !slides);
    Amplitude {
        displacement: select(slides, displacement, nan),
        border: select(ordinary, border, nan),
        size: select(slides, size, nan),
        sine,
    }
}
