//! The limits of many starts: all limits of a machine, periodic motions that no start leads to, and the loss of symmetry.
//!
//! This folder uses the limit of one start and its maps (`limit`); no other folder of `motion` uses this one.

pub(crate) mod attractors;
pub(crate) mod periodic;
pub(crate) mod starts;
pub(crate) mod symmetry;
