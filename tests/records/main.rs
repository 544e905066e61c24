//! The motion under records, held against independent values, laws and closed forms.

#[cfg(feature = "generators")]
#[path = "../drawn/mod.rs"]
mod drawn;
#[cfg(feature = "generators")]
#[path = "../invariants/records.rs"]
mod invariants;

#[cfg(feature = "generators")]
mod any;
#[path = "../compared/mod.rs"]
mod compared;
mod creep;
mod ends;
#[path = "../random/generator.rs"]
mod generator;
mod laws;
mod long_steps;
mod quiet;
mod references;
mod sampled;
#[cfg(all(feature = "dual", feature = "mp"))]
mod sensitivities;
