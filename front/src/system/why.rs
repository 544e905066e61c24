//! Why a question has no answer.

use std::fmt;
use stickslip::system::Error;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Why {
    /// The engine says so.
    Engine(Error),
    /// A law has no table, in one line with its place.
    Law(String),
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Engine(error) => error.fmt(f),
            Self::Law(why) => why.fmt(f),
        }
    }
}

impl From<Error> for Why {
    fn from(error: Error) -> Self {
        Self::Engine(error)
    }
}
