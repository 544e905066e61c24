//! Random numbers, and the motion by dense sampling, for tests of the exact motion.

mod generator;
pub(crate) mod sampled;

pub(crate) use generator::Random;
