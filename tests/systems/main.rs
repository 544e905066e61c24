//! Systems of several bodies, by the public interface.

mod cases;
mod closed_form;
mod one_body;
#[cfg(feature = "mp")]
mod precise;
mod random;
mod references;
