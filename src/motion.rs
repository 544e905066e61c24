//! The exact motion, stops included: slides, stops, and the events between them.
//!
//! In units of B = r_y/k and B ω_d, with θ = ω_d t, the equation of motion (eq. 1) is
//!
//! ```text
//! Ω² x¨ + x + r = α sin θ,     r = sgn x˙ while it slides,  |r| ≤ η while it sticks.
//! ```
//!
//! η = 1 unless a static friction r_s = η r_y above the kinetic one is given.
//!
//! Between changes of kind or direction the motion is a closed form, and the changes are found with a proof
//! that none was missed: no step size, and no tolerance but rounding (`event` says where that enters).
//!
//! | folder | content | uses |
//! |---|---|---|
//! | `slide` | sliding in closed form, a stop and its release, the work of a slide | |
//! | `event` | the next zero of a vibration with its proof: the end of a slide, its maximum speed | `slide` |
//! | `limit` | what the motion of one start tends to, and what a cycle of it amounts to | `slide`, `event` |
//! | `many` | all limits of a machine, periodic motions that no start leads to, the loss of symmetry | `limit` |
//! | [`record`] | the motion under a measured load | |
//!
//! Types that several folders use are files beside them: [`DrivePhase`], the phase of the drive, reduced;
//! [`State`]; [`Trajectory`] and [`Samples`], the motion segment by segment and at evenly spaced phases;
//! [`FreeDecay`], the half cycles and the place of rest of a free vibration.
//!
//! `Ω` must be within [2⁻²⁰, 2²⁰] here, and a phase within 2⁵² half turns.

mod broken;
pub(crate) mod drive_phase;
pub(crate) mod event;
mod free;
pub(crate) mod limit;
#[cfg(test)]
mod machines;
pub(crate) mod many;
mod pull;
pub mod record;
mod samples;
pub(crate) mod slide;
pub(crate) mod state;
pub(crate) mod trajectory;

pub use drive_phase::DrivePhase;
pub use free::FreeDecay;
pub(crate) use limit::amplitude::Trust;
pub use limit::irregular::Irregular;
pub use limit::long_run::{DEFAULT_BUDGET, LongRun, Rest};
pub use limit::measures::{ErrorMeasures, Extreme};
pub use limit::peaks::Peaks;
pub use limit::steady::{SteadyState, errors_after};
pub use many::attractors::{Attractor, Attractors, attractors};
pub use many::periodic::{PeriodicMotion, periodic_motions};
pub use many::starts::Starts;
pub use many::symmetry::{Loss, SymmetryBreak, symmetry_breaks};
pub use pull::Pull;
pub use samples::Samples;
pub use state::{Instant, State};
pub use trajectory::{End, Kind, Segment, Trajectory};

// The command and the Python package use these: they follow many starts on several threads and continue
// interrupted runs.
#[doc(hidden)]
pub use {
    limit::amplitude::{Amplitude, Reached},
    limit::steady_outputs::{SteadyAnswer, SteadyOutput},
    many::attractors::Signature,
    many::periodic::{PeriodicMotions, periodic_motions_from},
};
