//! A time within the half cycle, counted from one of its ends.

use crate::float::Float;

/// A time within the half cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touch<F> {
    pub(super) from: NearerEnd,
    pub(super) time: F,
}

/// The end of the half cycle that a time is counted from: from the nearer one it keeps its digits, however
/// long the half cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NearerEnd {
    First,
    Last,
}

impl<F: Float> Touch<F> {
    pub(super) const fn new(from: NearerEnd, time: F) -> Self {
        Self { from, time }
    }

    /// `Ωτ`.
    pub(crate) fn phase(&self, omega: F) -> F {
        match self.from {
            NearerEnd::First => omega * self.time,
            NearerEnd::Last => F::pi() - omega * self.time,
        }
    }
}
