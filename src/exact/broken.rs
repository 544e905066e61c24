//! Why a calculation along the motion ended early, in one word of memory.

use crate::error::Error;

/// Why the calculation of a motion ended early: a boxed [`Error`], so that the result of every slide stays
/// small.
#[derive(Debug)]
pub(crate) struct Broken(Box<Error>);

impl From<Error> for Broken {
    #[cold]
    fn from(error: Error) -> Self {
        Self(Box::new(error))
    }
}

impl From<Broken> for Error {
    #[cold]
    fn from(Broken(error): Broken) -> Self {
        *error
    }
}
