//! What the closed forms say of a motion, for the proofs of motions to be held against.

use crate::float::ball::Ball;

/// What the closed forms say of a motion.
pub(super) struct Answered<const W: usize> {
    /// The amplitudes.
    pub(super) scale: Ball<W>,
    pub(super) max_displacement: Ball<W>,
    pub(super) displacement_phase: Ball<W>,
    pub(super) max_velocity: Ball<W>,
    /// Sum and product of the multipliers of half a cycle.
    pub(super) sum: Ball<W>,
    pub(super) product: Ball<W>,
    pub(super) contraction: Ball<W>,
    pub(super) min_force_ratio: Ball<W>,
}
