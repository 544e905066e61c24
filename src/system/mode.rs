//! What each element does in a branch.

use crate::float::Float;

/// What an element does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// A contact that sticks.
    Stuck,
    /// A contact that slides, in the piece of its law with this number.
    Slides { forward: bool, piece: usize },
    /// A contact without normal load.
    Apart,
    /// An elastic contact that holds.
    Holds,
    /// An elastic contact whose slider slides.
    Yields { forward: bool },
    /// A stop that does not touch.
    Away,
    /// A stop in touch.
    Pressed,
    /// A stop beyond its gap, which would have to pull.
    Lifted,
    /// A stop that gives no way, in touch.
    Resting,
    /// A spring, in the piece of its law with this number.
    Bends { piece: usize },
}

impl Mode {
    /// Whether the force is sought that keeps the velocity at 0.
    pub(crate) const fn is_held(self) -> bool {
        matches!(self, Self::Stuck | Self::Resting)
    }
}

/// 1 forward, −1 backward.
pub(crate) fn sign<F: Float>(forward: bool) -> F {
    if forward { F::int(1) } else { F::int(-1) }
}
