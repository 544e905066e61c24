//! The exact motion, stops included: slide, stick, and what happens in between.
//!
//! In units of B = r_y/k and B ω_d, with θ = ω_d t, the equation of motion (eq. 1) is
//!
//! ```text
//! Ω² x¨ + x + r = α sin θ,     r = sgn x˙ while it slides,  |r| ≤ 1 while it sticks.
//! ```
//!
//! Between changes of kind or direction the motion is a closed form, and the changes are found with a proof that none
//! was missed: no step size, no tolerance.
//!
//! | file | what |
//! |---|---|
//! | [`DrivePhase`] | the phase of the drive, reduced |
//! | [`Slide`] | sliding in closed form, smooth through Ω = 1 |
//! | [`Stick`] | sticking, and when friction gives way |
//! | `event`, `velocity_zero` | the next velocity zero, never missed |
//! | [`Trajectory`] | the motion phase by phase |
//! | [`Samples`] | the motion at evenly spaced phases |
//! | [`FreeDecay`] | no drive: half cycles and place of rest in closed form |

mod drive;
mod event;
mod family;
mod fastest;
mod free;
mod matrix;
mod measures;
mod rest;
mod samples;
mod shooting;
mod slide;
mod steady;
mod stick;
mod trajectory;
mod velocity_zero;
mod walk;

pub use drive::DrivePhase;
pub use free::FreeDecay;
pub use measures::{ErrorMeasures, Extreme};
pub use rest::Rest;
pub use samples::Samples;
pub use slide::{Direction, Slide};
pub use steady::{DEFAULT_BUDGET, LongRun, SteadyState, errors_after};
pub use stick::Stick;
pub use trajectory::{End, Instant, Kind, Phase, State, Trajectory};
