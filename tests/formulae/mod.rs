//! The transcriptions of the paper's equations and its errata, by the names of the formula functions.

mod errata;
#[cfg(feature = "matching")]
mod identities;
#[cfg(feature = "generators")]
mod ordinary_inputs;
#[cfg(feature = "mp")]
mod ranges;
