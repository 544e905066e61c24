//! `Mp<LIMBS>`: binary floating point of `64 · LIMBS` bits, correctly rounded by MPFR.
//!
//! | file | content |
//! |---|---|
//! | `raw` | the number and MPFR's functions of it: the crate's only calls of foreign code |
//! | `ops` | operators, comparison, sums |
//! | `real` | [`Real`](super::Real) and [`Float`](super::Float), the traits of the formulae |
//! | `convert`, `text` | to and from `rug`, primitive numbers, decimal text |
//! | `traits`, `functions` | the traits of num-traits; all functions are those of its `Real` |
//! | `serde`, `nalgebra` | with those features: decimal strings, `RealField` |
//! | `ladder`, `words` | a precision chosen at run time |

/// Methods of a trait that are the type's own of the same name.
macro_rules! same_name {
    ($($name:ident($($argument:ident $(: $type:ty)?),*) $(-> $result:ty)?;)*) => {$(
        #[inline]
        fn $name(self $(, $argument: same_name!(@type $($type)?))*) -> same_name!(@type $($result)?) {
            self.$name($($argument),*)
        }
    )*};
    (@type) => { Self };
    (@type $type:ty) => { $type };
}

mod convert;
mod functions;
mod ladder;
#[cfg(feature = "matching")]
mod nalgebra;
mod ops;
mod raw;
mod real;
#[cfg(feature = "serde")]
mod serde;
mod text;
mod traits;
pub(crate) mod words;

pub use ladder::{PrecisionError, ThreadPrecision, WIDTHS, Widest, WithPrecision, with_bits, with_precision};
pub use raw::Mp;
pub use text::ParseError;
