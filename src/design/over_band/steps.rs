//! What is sought over a band, and in how many steps.

use crate::float::Float;
use crate::named::named;
use alloc::vec::Vec;
use core::cmp::Ordering;

named! {
    /// The amplitude that is to be small.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum Aim [name] {
        /// The displacement x; on a base that carries the surface in relation to the base.
        Displacement = "displacement",
        /// The displacement in space, on a base that carries the surface.
        AbsoluteDisplacement = "absolute-displacement",
        /// The force on the support.
        TransmittedForce = "transmitted-force",
        /// The acceleration in space.
        Acceleration = "acceleration",
    }
}

impl Aim {
    /// Every aim.
    pub const ALL: [Self; 4] =
        [Self::Displacement, Self::AbsoluteDisplacement, Self::TransmittedForce, Self::Acceleration];
}

pub(super) fn infinite<F: Float>() -> F {
    F::int(1) / F::int(0)
}

/// The order of frictions, or of frequencies, with their values.
pub(super) fn by_place<F: Float>(a: &(F, F), b: &(F, F)) -> Ordering {
    a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal)
}

/// The binary logarithm of the number of steps of a mesh.
pub(super) const LOG_STEPS: u32 = 6;

/// The steps of all searches together, each of up to about a microsecond at f64.
pub(super) const SEARCH_STEPS: u64 = 6_000_000;

/// 2ⁿ steps of one ratio from `low` to `high`.
pub(super) fn geometric<F: Float>(low: F, high: F, log_steps: u32) -> Vec<F> {
    let mut ratio = high / low;
    for _ in 0..log_steps {
        ratio = ratio.sqrt();
    }
    let mut place = low;
    let mut places = Vec::new();
    for _ in 0..1u32 << log_steps {
        places.push(place);
        place = place * ratio;
    }
    places.push(high);
    places
}
