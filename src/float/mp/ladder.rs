//! A precision chosen at run time: the least of several widths that has enough bits.

use super::Mp;
use super::words::{self, GREATEST, at_words};
use crate::float::Float;
use core::fmt::{Debug, Display, LowerExp};
use core::str::FromStr;
use num_traits::Pow;

/// A computation generic over the number type, to be run at a width known only at run time.
pub trait WithPrecision {
    /// The result.
    type Output;
    /// Runs the computation over `F`.
    fn run<F>(self) -> Self::Output
    where
        F: Float
            + FromStr<Err = super::ParseError>
            + Pow<F, Output = F>
            + Display
            + LowerExp
            + Debug
            + Send
            + Sync
            + 'static;
}

/// The error for a number of bits that no width has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("precision = {bits} bits must be ≥ 1 and ≤ {greatest}")]
#[non_exhaustive]
pub struct PrecisionError {
    /// The requested number of bits.
    pub bits: u32,
    /// The greatest available number of bits.
    pub greatest: u32,
}

/// The precision that [`with_precision`] has set on a thread, for other threads that compute for it.
#[derive(Debug, Clone, Copy)]
pub struct ThreadPrecision(u32);

impl ThreadPrecision {
    /// That of this thread.
    #[must_use]
    pub fn here() -> Self {
        Self(words::here())
    }

    /// Runs a computation with this precision on the thread that calls.
    pub fn run<T>(self, computation: impl FnOnce() -> T) -> T {
        words::with_words(self.0, computation)
    }
}

/// The available widths in bits, ascending.
pub const WIDTHS: &[u32] = &[128, 256, 1024, 4096, 8192];

/// Runs a computation at the least available width of at least `bits`: every result inside it, on this thread, has
/// so many bits, which [`Float::precision`] says. Other threads that compute for it take them from [`ThreadPrecision`].
///
/// # Errors
/// [`PrecisionError`] where `bits` is 0 or more than the last of [`WIDTHS`].
pub fn with_precision<W: WithPrecision>(bits: u32, computation: W) -> Result<W::Output, PrecisionError> {
    Ok(at_words!(words_of(bits)?, |CAPACITY| computation.run::<Mp<CAPACITY>>()))
}

/// The type of one copy of a computation for all widths. Its numbers take a kilobyte each, so that it is slower at few bits.
#[doc(hidden)]
pub type Widest = Mp<GREATEST>;

/// Runs a computation over [`Widest`] at the width of [`with_precision`].
///
/// # Errors
/// As [`with_precision`].
#[doc(hidden)]
pub fn with_bits<T>(bits: u32, computation: impl FnOnce() -> T) -> Result<T, PrecisionError> {
    Ok(words::with_words(words_of(bits)?, computation))
}

/// The number of limbs of the least width with so many bits.
fn words_of(bits: u32) -> Result<u32, PrecisionError> {
    let width = WIDTHS.iter().find(|width| bits > 0 && bits <= **width);
    let greatest = WIDTHS.last().copied().unwrap_or(0);
    width.map(|width| width / 64).ok_or(PrecisionError { bits, greatest })
}
