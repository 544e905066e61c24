//! The closed forms: independent values, any precision, batches, sensitivities, ranges, inverse problems.

#[path = "../drawn/mod.rs"]
mod drawn;
#[path = "../random/mod.rs"]
mod random;
#[cfg(feature = "mp")]
#[path = "../ulps/mod.rs"]
mod ulps;

#[cfg(feature = "mp")]
mod accuracy;
#[cfg(feature = "batch")]
mod batch;
#[cfg(all(feature = "batch", feature = "generators"))]
#[path = "../invariants/batches.rs"]
mod batches;
#[cfg(feature = "mp")]
mod damped;
mod design;
mod design_damped;
mod design_optimum;
#[cfg(feature = "mp")]
mod design_wide;
mod free_decay;
mod identify;
mod independent;
#[cfg(feature = "mp")]
mod precision;
mod reference;
#[cfg(all(feature = "dual", feature = "mp"))]
mod sensitivity;
mod tasks;
mod uncertainty;
