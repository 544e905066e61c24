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
//! The files form three layers, each of which uses only those above it.
//!
//! | motion | |
//! |---|---|
//! | [`DrivePhase`], [`State`] | the phase of the drive, reduced; a state |
//! | `equation`, `jet`, `motion`, `slide`, `short` | sliding in closed form, smooth through Ω = 1, and for a short time |
//! | `stick`, `work` | sticking, and the release; the work of a slide |
//!
//! | event | |
//! |---|---|
//! | `event`, `search`, `stretch`, `cover`, `window` | the next zero of a vibration, with its proof |
//! | `velocity_zero`, `fastest`, `expect` | the end of a slide, its maximum speed, and where both are looked for first |
//! | [`Trajectory`], [`Samples`] | the motion segment by segment, and at evenly spaced phases |
//! | [`FreeDecay`] | no drive: half cycles and place of rest in closed form |
//!
//! | limit | |
//! |---|---|
//! | [`LongRun`], [`SteadyState`], [`Irregular`], [`ErrorMeasures`] | the results: what the motion tends to, and what a cycle of it amounts to |
//! | `limit` | which of the searches below finds it |
//! | `propagation`, `matrix`, `section`, `shooting` | half a turn with its derivative, and its fixed point |
//! | `stop_map`, `stops` | from stop to stop, one number on: the limit where it sticks |
//! | `validate` | the closed-form cycle shown to be that fixed point |
//! | `family`, `rest` | limits that are not unique: Ω = 1/(2n), α ≤ 1 |
//! | `followed` | the limit of one start, where η > 1 |
//! | `period_map` | m half turns with their derivative, and Newton's method for what they bring back |
//! | [`attractors()`], [`Starts`] | all limits that a set of starts leads to, and starts for it |
//! | [`periodic_motions()`] | periodic motions that Newton's method finds, unstable ones among them |
//!
//! `Ω` must be within [2⁻²⁰, 2²⁰] here, and a phase within 2⁵² half turns.

#[cfg(test)]
mod accounts;
mod attractors;
mod broken;
mod budget;
mod cover;
mod drive;
mod equation;
mod event;
mod expect;
mod family;
mod fastest;
mod followed;
mod free;
mod irregular;
mod jet;
mod limit;
mod long_run;
#[cfg(test)]
mod machines;
mod matrix;
mod measures;
mod motion;
mod orbit;
mod peaks;
mod period_map;
mod periodic;
mod propagation;
mod rest;
mod samples;
mod search;
mod section;
mod shooting;
mod short;
mod slide;
mod starts;
mod state;
mod steady;
mod steady_outputs;
mod stick;
mod stop_map;
mod stops;
mod stretch;
mod symmetry;
mod trajectory;
mod validate;
mod velocity_zero;
mod window;
mod work;

pub use attractors::{Attractor, Attractors, attractors};
pub use drive::DrivePhase;
pub use free::FreeDecay;
pub use irregular::Irregular;
pub use long_run::{DEFAULT_BUDGET, LongRun, Rest};
pub use measures::{ErrorMeasures, Extreme};
pub use peaks::Peaks;
pub use periodic::{PeriodicMotion, periodic_motions};
pub use samples::Samples;
pub use starts::Starts;
pub use state::{Instant, State};
pub use steady::{SteadyState, errors_after};
pub use steady_outputs::SteadyOutput;
pub use symmetry::{Loss, SymmetryBreak, symmetry_breaks};
pub use trajectory::{End, Kind, Segment, Trajectory};

// For the command and the Python package, which follow many starts on several threads and go on with runs
// that were broken off.
#[doc(hidden)]
pub use {
    attractors::Signature,
    periodic::{PeriodicMotions, periodic_motions_from},
    steady_outputs::SteadyAnswer,
};
