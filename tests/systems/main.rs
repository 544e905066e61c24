//! Systems of several bodies, by the public interface.

mod cases;
mod references;
