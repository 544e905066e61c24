//! What a number type breaks, and how two numbers are compared.

use super::super::Float;
use alloc::string::{String, ToString};
use core::fmt::{self, Display, Formatter};

/// A promise that a number type breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Broken {
    /// The method, with its trait: `Float::floor`, `Add::add`.
    pub method: &'static str,
    /// The argument, or both, at which the promise is broken.
    pub argument: String,
    /// The promise: what the method has to give.
    pub promise: &'static str,
}

impl Display for Broken {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { method, argument, promise } = self;
        write!(f, "{method} at {argument} breaks its promise: {promise}")
    }
}

impl core::error::Error for Broken {}

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
pub(super) struct Both<F>(pub(super) F, pub(super) F);

impl<F: Float> Display for Both<F> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.0, self.1)
    }
}

/// Evenly spread fractions of 2³⁰, the same in each run.
pub(super) fn spread() -> impl Iterator<Item = i32> {
    // The golden section of 2³⁰, made odd.
    (1..=200).map(|n: i32| n.wrapping_mul(663_608_941) & ((1 << 30) - 1))
}
