//! Does a number type keep the promises of [`Field`](super::Field), [`Real`](super::Real) and [`Float`]?
//!
//! An own number type that breaks one of them gives wrong answers without a word: with negative numbers in
//! the wrong order a maximum is a minimum, with a digit missing in π an angle is off at a high frequency.
//! [`check`] finds out before. `docs/number-types.md` is the guide.
//!
//! ```
//! use stickslip::float::conformance;
//! conformance::check::<f64>()?;
//! conformance::check::<f32>()?;
//! # Ok::<(), stickslip::float::conformance::Broken>(())
//! ```
//!
//! Nothing is taken from another type. The operations are held against results that are known exactly: sums
//! and products of numbers such as 1 + i 2⁻ᵖ, and the rest of a quotient or of a root, which a fused
//! operation gives without rounding. π is held against integers of as many digits, and the functions against
//! their series in compensated pairs, which have twice the digits.

mod functions;
mod operations;

use super::Float;

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

/// Holds `F` to the promises of its traits: integers, order, rounding of the five operations and of the fused
/// one, range, rounding to integers, conversions, π, circular and exponential functions, text.
///
/// It takes some milliseconds for f64 and does not sample at random: a type that passes once passes always.
/// What it cannot see is an error at arguments that it does not try.
///
/// # Errors
/// [`Broken`]: the first method that breaks a promise, with its argument. The methods come in the order in which they build on each
/// other, so that the first one is the one to mend.
pub fn check<F: Float>() -> Result<(), Broken> {
    operations::check::<F>()?;
    functions::check::<F>()
}

/// Of a method whether it keeps a promise.
fn hold(
    is_kept: bool,
    method: &'static str,
    argument: impl FnOnce() -> String,
    promise: &'static str,
) -> Result<(), Broken> {
    if is_kept { Ok(()) } else { Err(Broken { method, argument: argument(), promise }) }
}

/// Two arguments in one text.
fn both<F: Float>(a: F, b: F) -> String {
    format!("({a}, {b})")
}

/// Evenly spread fractions of 2³⁰, the same in each run.
fn spread() -> impl Iterator<Item = i32> {
    // The golden section of 2³⁰, odd.
    (1..=200).map(|n: i32| n.wrapping_mul(663_608_941) & ((1 << 30) - 1))
}
