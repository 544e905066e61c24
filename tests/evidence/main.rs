//! Every number that the library gives, beside one that its own reading did not make: the table of docs/development/evidence.md.

#[path = "../compared/mod.rs"]
mod compared;
#[path = "../random/mod.rs"]
mod random;

mod borders;
mod closed_forms;
mod coverage;
mod designs;
#[cfg(feature = "mp")]
mod enclosed;
mod floors;
mod machines;
mod motions;
mod records;
mod relations;
mod sampled;
mod steady;
mod table;
