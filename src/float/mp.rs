//! `Mp<LIMBS>`: binary floating point of `64 · LIMBS` bits, correctly rounded by MPFR.
//!
//! | file | what |
//! |---|---|
//! | `raw` | the number and MPFR's functions of it: the crate's only calls of foreign code |
//! | `ops` | operators, comparison, sums |
//! | `real` | [`Real`](super::Real) and [`Float`](super::Float): what the formulae run on |
//! | `convert`, `text` | to and from `rug`, primitive numbers, decimal text |
//! | `traits`, `functions` | the traits of num-traits; all functions are those of its `Real` |
//! | `serde`, `nalgebra` | with those features: decimal strings, `RealField` |
//! | `ladder` | a precision chosen at run time |
//!
//! The limbs are inline, so that the type is `Copy` and the generic code reads the same as for `f64`. Every
//! result is the exact one rounded to nearest, ties to even. Exponents reach ±2³⁰, beyond which a
//! result is an infinity or a zero of the right sign; there are no subnormal numbers. Zeros have signs and
//! NaN is unordered, as in IEEE 754.
//!
//! A formula over this type rounds as it goes, and loses some of the last digits as any does at f64.
//! [`Float::guarded`](super::Float::guarded) runs it with a limb more and rounds once: then every output
//! of the closed forms is right to one unit in the last place (`tests/closed_forms/precision.rs`).
//!
//! ```
//! use stickslip::float::mp::Mp;
//! use stickslip::{Cycle, Ratios};
//! let cycle = Cycle::new(Ratios::new(Mp::<4>::from(1.5), "2.5".parse()?)?)?;
//! assert_eq!(format!("{:.39}", cycle.max_velocity), "1.654152276482076417806358492889845786447");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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

pub use convert::Inexact;
pub use ladder::{PrecisionError, WIDTHS, WithPrecision, with_precision};
pub use raw::Mp;
pub use text::ParseError;
