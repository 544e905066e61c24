//! The answers of the closed forms about a motion, for comparison with proved motions.

use crate::float::ball::Ball;

/// The answers of the closed forms about a motion.
pub(super) struct Answered<const W: usize> {
    /// The amplitude of the whole motion.
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
