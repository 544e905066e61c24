//! The transcriptions of the paper's equations and their errata, by the names of the functions.

mod errata;
#[cfg(feature = "matching")]
mod identities;
#[cfg(feature = "generators")]
mod ordinary_inputs;
#[cfg(feature = "mp")]
mod ranges;
