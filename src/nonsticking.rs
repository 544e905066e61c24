//! One non-sticking cycle: the steady motion with two reversals and no stop in a period.
//!
//! | file | equations | content |
//! |---|---|---|
//! | `cycle`, `undamped` | | all outputs of one cycle |
//! | `matching` | 2–39, 45 | the five unknowns and the equations between them |
//! | `den_hartog` | 50–56 | Den Hartog's own half cycle |
//! | `displacement`, `reversal` | 40–44 | Δ₀ and ω_d t₂ |
//! | `amplitude` | 44 | the force for a given Δ₀ |
//! | `velocity` | 25, 37, 45–49 | V₀, ω_d t₁ and Δ₁ |
//! | `border` | 57–62 | the minimum force ratio without sticking |
//! | `dissipation` | 63–67 | dissipation |
//! | `peaks` | beyond the paper | acceleration, transmitted force, absolute motion |
//! | `stability` | beyond the paper | multipliers, contraction |
//! | `six_reversals` | beyond the paper | the cycle of six reversals near a pole |
//! | `damped` | beyond the paper | all of it with viscous damping |
//! | `printed` | 43, 49 | the formulae that are wrong as printed |
//!
//! [`Cycle`] has them all for one (Ω, α). Lengths are in units of B = r_y/k, velocities in B ω_d, phases
//! ω_d t in `[0, 2π)`.

mod amplitude;
mod arrival;
pub(crate) mod border;
mod cycle;
pub(crate) mod damped;
pub(crate) mod den_hartog;
mod deviation;
pub(crate) mod displacement;
mod dissipation;
mod half_cycle;
mod low;
pub(crate) mod matching;
mod motion;
mod peaks;
mod phase;
// For the figure and the checks that show the errors.
#[doc(hidden)]
pub mod printed;
mod reversal;
pub(crate) mod six_reversals;
pub(crate) mod stability;
mod undamped;
mod velocity;
mod waves;

pub use border::{Border, Minimum, Shortfall};
pub use cycle::Cycle;
pub use matching::Unknowns;
#[cfg(feature = "matching")]
pub use matching::newton::{BorderSolution, MatchingError, Solution, Solvable};
// For the benchmark of a kernel.
#[doc(hidden)]
pub use reversal::Reversal;
pub use six_reversals::SixReversals;
pub use stability::Multipliers;

/// The paper's equations by their numbers, and its forms that lose digits: for the checks of the answers.
#[doc(hidden)]
pub mod equations {
    pub use super::border::{slip_excess, turning_point_border, turning_point_residual};
    pub use super::den_hartog::{FallingHalf, cosine_coefficient, phase_lag, sine_coefficient};
    pub use super::displacement::{
        cos_displacement_phase, displacement_phase, max_displacement, max_displacement_from_amplitude,
        sin_displacement_phase,
    };
    pub use super::dissipation::{
        best_force_ratio, best_loop_size, loop_size, loop_size_inertia, loop_size_stiffness,
    };
    pub use super::matching::damped::System;
    pub use super::matching::{Given, half_period_later, pi_1};
    pub use super::stability::{characteristic_polynomial, multiplier_product};
    pub use super::velocity::{deviation, max_velocity_from_phase, velocity_phase_residual};
    pub use crate::phase_function::phase_function_of_tangent;
}

pub(crate) use amplitude::{force_ratio_from_displacement, max_velocity_from_displacement};
#[cfg(feature = "batch")]
pub(crate) use border::border_near;
#[cfg(any(test, feature = "mp"))]
pub(crate) use displacement::max_displacement;
pub(crate) use dissipation::{
    best_force_ratio, best_force_ratio_at, best_loop_size, best_loop_size_at, loop_size_inertia,
    loop_size_stiffness,
};
#[cfg(feature = "mp")]
pub(crate) use half_cycle::{HalfCycle, free_swing};
#[cfg(feature = "batch")]
pub(crate) use low::{LowCircular, LowWaves};
pub(crate) use peaks::dynamic_amplification;
pub(crate) use phase::velocity_phase;
#[cfg(feature = "mp")]
pub(crate) use velocity::fastest;
#[cfg(feature = "batch")]
pub(crate) use waves::{Circular, Waves};
#[cfg(feature = "mp")]
pub(crate) use {
    displacement::{cos_displacement_phase, sin_displacement_phase},
    peaks::{arrival_acceleration, transmitted_force},
};
