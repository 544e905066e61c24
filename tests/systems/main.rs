//! Systems of several bodies, by the public interface.

#[cfg(feature = "generators")]
#[path = "../drawn/mod.rs"]
mod drawn;

#[path = "../compared/mod.rs"]
mod compared;

mod base;
mod cases;
mod chains;
mod closed_form;
mod clutches;
mod damping;
#[path = "../random/generator.rs"]
mod generator;
#[cfg(feature = "rayon")]
mod grid;
mod impacts;
mod joints;
mod law_ends;
mod long_run;
#[cfg(feature = "mp")]
mod long_steps;
mod massless;
mod one_body;
#[cfg(feature = "mp")]
mod precise;
#[cfg(feature = "mp")]
mod proved;
mod random;
mod rate;
mod references;
mod self_excited;
mod sliding;
mod verdicts;

/// How many are compared: the second number under `.ci/slow systems`.
fn count(usual: usize, all: usize) -> usize {
    if std::env::var_os("STICKSLIP_ALL_SYSTEMS").is_some() { all } else { usual }
}
