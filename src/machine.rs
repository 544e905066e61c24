//! The machine: the oscillator and its drive, the ratios Ω, α, ζ and η, the scales of the answers, and errors.
//!
//! It uses numbers (`float`) alone, and all rooms use it.

pub(crate) mod drive;
pub(crate) mod error;
pub(crate) mod excitation;
pub(crate) mod oscillator;
pub(crate) mod ratios;
pub(crate) mod scales;
pub(crate) mod support;
