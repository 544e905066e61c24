//! A precision chosen at run time: the least of several widths that has enough bits.

use super::Mp;
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

macro_rules! ladder {
    ($($limbs:literal)*) => {
        /// The available widths in bits, ascending.
        pub const WIDTHS: &[u32] = &[$(Mp::<$limbs>::BITS),*];

        /// Runs a computation at the least available width of at least `bits`.
        ///
        /// # Errors
        /// [`PrecisionError`] where `bits` is 0 or more than the last of [`WIDTHS`].
        pub fn with_precision<W: WithPrecision>(bits: u32, computation: W) -> Result<W::Output, PrecisionError> {
            match bits {
                0 => {}
                $(..=Mp::<$limbs>::BITS => return Ok(computation.run::<Mp<$limbs>>()),)*
                _ => {}
            }
            Err(PrecisionError { bits, greatest: WIDTHS.last().copied().unwrap_or(0) })
        }
    };
}

// The list is short because each width is a copy of every computation run at it, and costs half a minute of
// compiling the command.
ladder!(2 4 16 64 128);
