//! The places of points that are set aside until they fill a block.

use super::block::POINTS;

/// The points set aside.
#[derive(Default)]
pub(crate) struct Places(Vec<usize>);

impl Places {
    pub(crate) fn push(&mut self, place: usize) {
        self.0.push(place);
    }

    /// Whether they fill a block.
    pub(crate) const fn is_full(&self) -> bool {
        self.0.len() >= POINTS
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Removes the last block of them, or all if they do not fill a block.
    pub(crate) fn pop(&mut self) -> Vec<usize> {
        self.0.split_off(self.0.len().saturating_sub(POINTS))
    }
}
