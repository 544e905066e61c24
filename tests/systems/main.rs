//! Systems of several bodies, by the public interface.

#[cfg(feature = "generators")]
#[path = "../drawn/mod.rs"]
mod drawn;

mod base;
mod cases;
mod closed_form;
mod clutches;
#[cfg(feature = "rayon")]
mod grid;
mod one_body;
#[cfg(feature = "mp")]
mod precise;
mod random;
mod references;
mod self_excited;
mod verdicts;
