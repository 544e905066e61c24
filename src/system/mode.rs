//! What each element does in a branch.

use super::assembly::{Part, Rule};
use super::matrix::{dot, set};
use crate::float::Float;
use alloc::vec::Vec;

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

/// The places of the elements whose mode is one of those.
pub(crate) fn places(modes: &[Mode], is_one: impl Fn(Mode) -> bool) -> Vec<usize> {
    modes.iter().enumerate().filter(|(_, mode)| is_one(**mode)).map(|(place, _)| place).collect()
}

/// The mode of a contact that slides with the velocity v.
pub(crate) fn slides<F: Float>(rule: &Rule<F>, v: F) -> Mode {
    let piece = match rule {
        Rule::Contact { pieces, .. } => pieces.partition_point(|p| p.from <= v.abs()).saturating_sub(1),
        Rule::Elastic { .. } | Rule::Stop { .. } | Rule::Hard { .. } | Rule::Spring { .. } => 0,
    };
    Mode::Slides { forward: v > F::int(0), piece }
}

/// An elastic contact whose slider slides has its friction in a state, `s R`.
pub(crate) fn yields<F: Float>(part: &Part<F>, forward: bool, z: &mut [F]) {
    if let Rule::Elastic { place, bound, .. } = &part.rule {
        let force = sign::<F>(forward) * dot(bound, z);
        set(z, *place, force);
    }
}

/// An elastic contact whose slider stops holds with the friction that it has.
pub(crate) fn lock<F: Float>(part: &Part<F>, mode: &mut Mode, z: &mut [F]) {
    if let Mode::Yields { forward } = *mode {
        yields(part, forward, z);
    }
    *mode = Mode::Holds;
}
