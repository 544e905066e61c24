//! The exact motion: independent values, laws, brute force, arbitrary input, and comparison with the closed
//! forms.

#[path = "../drawn/mod.rs"]
mod drawn;
#[cfg(feature = "generators")]
#[path = "../invariants/mod.rs"]
mod invariants;
#[path = "../random/mod.rs"]
mod random;

#[cfg(feature = "generators")]
mod any_bits;
mod attractors;
#[cfg(feature = "mp")]
mod damped;
mod design_motion;
mod drives;
mod exact_motion;
#[cfg(feature = "mp")]
mod exact_precision;
mod no_event_missed;
mod over_band;
#[cfg(all(feature = "generators", feature = "mp"))]
mod properties;
mod regime;
#[cfg(feature = "mp")]
mod regime_exact;
#[cfg(feature = "mp")]
mod six_reversals;
#[cfg(feature = "mp")]
mod symmetry;
#[cfg(feature = "mp")]
mod unstable;
