//! Thresholds that follow the precision of the number.

use crate::float::Float;

/// 2⁻ᵏ at 53 bits, and 2 to the same part of the digits of any other type: what is found to so many bits of a double is found to as
/// large a part of more bits.
pub(crate) fn small<F: Float>(k: u32) -> F {
    let bits = u64::from(k) * u64::from(F::precision()) / u64::from(f64::MANTISSA_DIGITS);
    F::exp2i(-i32::try_from(bits).unwrap_or(i32::MAX))
}
