//! Why a calculation along the motion broke off, in one word of memory.

use crate::error::Error;

/// Why a motion broke off: an [`Error`], boxed, so that what every slide returns stays small.
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
