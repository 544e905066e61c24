//! Inverse problems: the force, friction, frequency or stiffness for a required motion.
//!
//! | question | function | file |
//! |---|---|---|
//! | minimum force that keeps the body sliding | [`min_amplitude`]; in ratios [`crate::Border::min_force_ratio`] | `force.rs` |
//! | maximum friction that lets the body slide | [`max_friction`] | `friction.rs` |
//! | frequencies at which the body never sticks | [`frequency_bands`] | `bands.rs` |
//! | frequency up to which friction holds a body at rest | [`holding_frequency`] | `hold.rs` |
//! | forces without any stop, two or six reversals | [`forces_without_stop`]; in ratios [`crate::NoStop::of`] | `no_stop.rs` |
//! | frequencies without any stop | [`frequency_bands_without_stop`] | `no_stop.rs` |
//! | force for a displacement or a velocity | [`force_for_displacement`], [`force_for_velocity`] | `target.rs` |
//! | friction for a displacement | [`frictions_for_displacement`] | `target_friction.rs` |
//! | friction that dissipates most | [`most_dissipating_friction`]; in ratios [`crate::Response::best_force_ratio`] | `dissipation.rs` |
//! | friction that dissipates most, with sticking allowed | [`most_dissipating_friction_of_all`] | `sticking.rs` |
//! | friction with the least amplitude over a band of frequencies | [`best_friction_over_band`] | `over_band.rs` |
//! | friction and damping from a measured response curve | [`identify()`] | `identify.rs` |
//! | friction and damping from a measured free decay | [`identify_turning_points`], [`identify_decay`] | `free_decay.rs` |
//! | friction, damping and stiffness from a measured load and the motion under it | [`identify_motion()`] | `identify_motion.rs` |
//! | stiffness that dissipates most | [`most_dissipating_stiffness`] | `tuning.rs` |
//!
//! A body with m = k = r_y = 1 has ratios for units: Ω = ω_d, α = p₀, displacements in B.
//!
//! All functions allow a damper. With
//! damping, the force, the friction, the displacement, the velocity and the friction that dissipates most
//! have their own proofs of uniqueness; the bands are **searched** (`damped`), and the stiffness that
//! dissipates most is proved to be the best of the bands found (`tuning`).
//!
//! Every other answer is proved, in the documentation of its function, to be the only one or the best of all;
//! none is found by sampling. With sticking allowed it is the best to within a tolerance, provided that each
//! exact motion is as close to its limit as estimated. If an answer is substituted into the forward functions
//! ([`crate::Cycle`], [`crate::Border`]), it reproduces the target to rounding. “Sliding” means the motion of
//! the closed forms, with two reversals a cycle and no stop. Below its border the body stops, or near a pole
//! reverses six times ([`crate::cycle::SixReversals`]): answers that include such motions are searched
//! there, not proved. On the sticking threshold there is no safety margin, which real friction needs: see
//! [`crate::Output::Margin`].

mod band;
mod bands;
mod damped;
mod dissipation;
mod force;
#[cfg(feature = "identify")]
#[allow(
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    reason = "matrices and parameters of one size"
)]
mod free_decay;
mod friction;
mod hold;
#[cfg(feature = "identify")]
mod identify;
#[cfg(feature = "identify")]
mod identify_motion;
#[cfg(feature = "identify")]
#[allow(
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    reason = "matrices and parameters of one size"
)]
mod least_squares;
mod no_stop;
mod optimum;
mod over_band;
mod sticking;
mod target;
mod target_friction;
mod tuning;

pub use band::{Band, Edge};
pub use bands::{Bands, frequency_bands};
pub use dissipation::most_dissipating_friction;
pub use force::min_amplitude;
#[cfg(feature = "identify")]
pub use free_decay::{DecayIdentified, TurningPoints, identify_decay, identify_turning_points};
pub use friction::max_friction;
pub use hold::{Holding, holding_frequency};
#[cfg(feature = "identify")]
pub use identify::{AmplitudeKind, Identified, Measurement, PhaseKind, Reading, Residual, identify};
#[cfg(feature = "identify")]
pub use identify_motion::{MotionIdentified, identify_motion};
pub use no_stop::{forces_without_stop, frequency_bands_without_stop};
pub use optimum::{BoundedOptimum, Optimum, OptimumKind};
pub use over_band::{Aim, BandFriction, BandFrictionKind, best_friction_over_band};
pub use sticking::most_dissipating_friction_of_all;
pub use target::{force_for_displacement, force_for_velocity};
pub use target_friction::{TargetFriction, frictions_for_displacement};
pub use tuning::most_dissipating_stiffness;

// The same questions in ratios, for m = k = r_y = 1.
#[doc(hidden)]
pub use {
    bands::bands,
    dissipation::most_dissipating_force_ratio,
    no_stop::bands_without_stop,
    sticking::most_dissipating_force_ratio_of_all,
    target::{force_ratio_for_displacement, force_ratio_for_velocity},
    tuning::most_dissipating_frequency_ratio,
};
