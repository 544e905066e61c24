//! A check of the promises that a number type makes by [`Field`](super::Field), [`Real`](super::Real) and
//! [`Float`].
//!
//! A user's number type that breaks one of them gives wrong answers silently. If negative numbers compare in
//! the wrong order, a maximum becomes a minimum; if π lacks a digit, angles are off at high frequencies.
//! [`conformance`] finds such errors beforehand. `docs/development/number-types.md` is the guide.
//!
//! No other type serves as a reference. The operations are compared with results that are known exactly: sums
//! and products of numbers such as 1 + i 2⁻ᵖ, and the remainder of a quotient or a root, which a fused
//! operation gives without rounding. π is compared with integers of as many digits. The functions are
//! compared with their series in compensated pairs, which have twice the digits.

mod broken;
mod functions;
mod operations;

use super::Float;
pub use broken::Broken;
use broken::{Both, hold, spread};

/// Checks that `F` keeps the promises of its traits: integers, order, rounding of the five operations and of
/// the fused one, range, rounding to integers, conversions, π, circular and exponential functions, text.
///
/// ```
/// use stickslip::float::conformance;
/// conformance::<f64>()?;
/// conformance::<f32>()?;
/// # Ok::<(), stickslip::float::Broken>(())
/// ```
///
/// The check takes some milliseconds for f64. It is deterministic, so that a type that passes once always
/// passes. It cannot detect an error at arguments that it does not try.
///
/// # Errors
/// [`Broken`]: the first method that breaks a promise, with its argument. The methods are checked in the
/// order in which they build on each other, so that the first failure is the one to fix.
pub fn conformance<F: Float>() -> Result<(), Broken> {
    operations::check::<F>()?;
    functions::check::<F>()
}
