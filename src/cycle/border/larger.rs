//! The larger of two candidates for the border.

use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// Whether S is the stationary value `width`/(1 − Ω²) and not the limit 1/Ω² at the turning point.
///
/// For T > 0 (`rises`) it is larger, even if the excess is below rounding.
#[inline(always)]
pub(super) fn is_stationary_value_larger<F: Float>(
    one_minus_square: Pair<F>,
    omega: F,
    width: Pair<F>,
    rises: bool,
) -> bool {
    rises | (width.value() > (one_minus_square / omega.wide().square()).value())
}
