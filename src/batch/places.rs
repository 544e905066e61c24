//! Places of points that are set aside until a block of them is there.

use super::block::POINTS;

/// Points set aside, at most two blocks of them.
pub(crate) struct Places {
    places: [usize; 2 * POINTS],
    count: usize,
}

impl Default for Places {
    fn default() -> Self {
        Self { places: [0; 2 * POINTS], count: 0 }
    }
}

impl Places {
    pub(crate) fn push(&mut self, place: usize) {
        if let Some(slot) = self.places.get_mut(self.count) {
            *slot = place;
            self.count += 1;
        }
    }

    /// Whether a whole block of them is there, so that another may not find room.
    pub(crate) const fn is_full(&self) -> bool {
        self.count >= POINTS
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The last block of them, or what there is of it.
    pub(crate) fn pop(&mut self) -> ([usize; POINTS], usize) {
        let left = self.count.saturating_sub(POINTS);
        let mut taken = [0; POINTS];
        for (slot, &place) in taken.iter_mut().zip(self.places.iter().skip(left)) {
            *slot = place;
        }
        let count = self.count - left;
        self.count = left;
        (taken, count)
    }
}
