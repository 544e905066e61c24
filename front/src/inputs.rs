//! The inputs of a machine, the rules by which they determine it, and numbers with units.
//!
//! The table of [`Input`] has a row for each input: its name, the kind of its values, its role and its description. The
//! command makes its options, its columns of points and its grids from it, and the Python package its keywords.
//! [`Given`] holds the values that are given, and has the rules: period or stiffness, µ or bound, Ω or frequency,
//! damping or ratio, one excitation. Its errors name inputs as the asker writes them ([`Naming`]), in the same words.
//!
//! ```
//! use stickslip_front::inputs::{Given, Input, Naming};
//! use stickslip_front::inputs::units::Reader;
//! let reader = Reader::new(None, "units");
//! let mut given = Given::<f64>::empty(&reader, Naming::Keyword);
//! for (input, text) in [(Input::Mass, "800 kg"), (Input::Period, "2.2 s"), (Input::FrictionCoefficient, "5 %")] {
//!     given.read(input, text, &reader)?;
//! }
//! let body = given.oscillator()?;
//! assert!((body.friction_bound() - 0.05 * 800.0 * 9.80665).abs() < 1e-12);
//! given.read(Input::Stiffness, "6.5 kN/m", &reader)?;
//! let words = "stiffness and period: give one of the two, because it determines the other";
//! assert_eq!(given.oscillator().unwrap_err().to_string(), words);
//! # Ok::<(), stickslip_front::inputs::units::InputError>(())
//! ```

mod given;
mod input;
#[cfg(test)]
mod tests;
#[cfg_attr(
    not(test),
    allow(clippy::arithmetic_side_effects, reason = "places within a text, which its length bounds")
)]
pub mod units;

pub use given::{Driven, Given, Point, in_place_of_zeros, in_typed_unit};
pub use input::{Input, Naming, Role};
pub use stickslip::internal::critical_damping;
