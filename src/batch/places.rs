//! Places of points that are set aside until a block of them is there.

use super::block::POINTS;

/// Points set aside.
#[derive(Default)]
pub(crate) struct Places(Vec<usize>);

impl Places {
    pub(crate) fn push(&mut self, place: usize) {
        self.0.push(place);
    }

    /// Whether a whole block of them is there.
    pub(crate) const fn is_full(&self) -> bool {
        self.0.len() >= POINTS
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The last block of them, or what there is of it.
    pub(crate) fn pop(&mut self) -> Vec<usize> {
        self.0.split_off(self.0.len().saturating_sub(POINTS))
    }
}
