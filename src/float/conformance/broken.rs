//! What a number type breaks, and how two numbers are compared.

use super::super::Float;
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

/// An error unless the method keeps the promise.
pub(super) fn hold(
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
pub(super) struct Both<F: Float>(pub(super) F, pub(super) F);

/// Evenly spread fractions of 2³⁰, the same in each run.
pub(super) fn spread() -> impl Iterator<Item = i32> {
    // The golden section of 2³⁰, made odd.
    (1..=200).map(|n: i32| n.wrapping_mul(663_608_941) & ((1 << 30) - 1))
}
