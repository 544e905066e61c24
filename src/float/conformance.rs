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

mod functions;
mod operations;

use super::Float;
use alloc::string::{String, ToString};
use core::fmt::Display;

/// A promise that a number type breaks.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[error("{method} at {argument} breaks its promise: {promise}")]
pub struct Broken {
    /// The method, with its trait: `Float::floor`, `Add::add`.
    pub method: &'static str,
    /// The argument, or both, at which the promise is broken.
    pub argument: String,
    /// The promise: what the method has to give.
    pub promise: &'static str,
}

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

/// An error unless the method keeps the promise.
fn hold(
    is_kept: bool,
    method: &'static str,
    argument: impl Display,
    promise: &'static str,
) -> Result<(), Broken> {
    if is_kept { Ok(()) } else { Err(Broken { method, argument: argument.to_string(), promise }) }
}

/// Two arguments in one text.
#[derive(thiserror::Error, Debug)]
#[error("({0}, {1})")]
struct Both<F: Float>(F, F);

/// Evenly spread fractions of 2³⁰, the same in each run.
fn spread() -> impl Iterator<Item = i32> {
    // The golden section of 2³⁰, made odd.
    (1..=200).map(|n: i32| n.wrapping_mul(663_608_941) & ((1 << 30) - 1))
}
