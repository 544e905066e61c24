//! One non-sticking cycle: the steady motion with two reversals and no stop in a period.
//!
//! [`Cycle`] has all its outputs for one (Ω, α). Lengths are in units of B = r_y/k, velocities in B ω_d, phases
//! ω_d t in `[0, 2π)`.
//!
//! | file | equations | content |
//! |---|---|---|
//! | `undamped`, `waveform` | | the functions of a cycle without damping; the motion between its reversals |
//! | `phase_function` | 9, 41 | K(Ω), which carries every closed form |
//! | `matching` | 2–39, 45 | the five unknowns and the equations between them |
//! | `den_hartog` | 50–56 | Den Hartog's own half cycle |
//! | `displacement`, `reversal`, `amplitude` | 40–44 | Δ₀ and ω_d t₂; the force for a given Δ₀ |
//! | `velocity`, `deviation`, `half_cycle` | 25, 37, 45–49 | V₀, ω_d t₁ and Δ₁: `velocity/waves` from Ω = 1/2, `velocity/low` below |
//! | `border` | 57–62 | the minimum force ratio without sticking |
//! | `dissipation` | 63–67 | dissipation |
//! | `peaks` | beyond the paper | acceleration, transmitted force, absolute motion |
//! | `equivalent` | beyond the paper | the equivalent linear oscillator, the force in the spring |
//! | `stability` | beyond the paper | multipliers, contraction |
//! | `six_reversals` | beyond the paper | the cycle of six reversals near a pole |
//! | `damped` | beyond the paper | all of it with viscous damping |
//! | `regime`, `response` | | the kind of motion at a point; the complete answer there |
//! | `printed` | 43, 49 | the formulae that are wrong as printed |
//!
//! The files use numbers (`float`) and the machine (`machine`). `regime` and `response` are above the others, and use the exact
//! motion, too.

mod amplitude;
pub(crate) mod border;
pub(crate) mod damped;
pub(crate) mod den_hartog;
mod deviation;
pub(crate) mod displacement;
mod dissipation;
pub(crate) mod equivalent;
mod half_cycle;
pub(crate) mod matching;
mod peaks;
#[cfg_attr(
    not(test),
    allow(clippy::arithmetic_side_effects, reason = "the counters of series, bounded by the precision")
)]
pub(crate) mod phase_function;
// For the figure and the checks that show the errors.
#[doc(hidden)]
pub mod printed;
pub(crate) mod regime;
pub(crate) mod response;
mod reversal;
pub(crate) mod six_reversals;
pub(crate) mod stability;
mod undamped;
mod velocity;
mod waveform;

pub use border::{Border, Minimum, Shortfall};
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
    pub use super::matching::system::System;
    pub use super::matching::{Given, half_period_later, pi_1};
    pub use super::stability::{characteristic_polynomial, multiplier_product};
    pub use super::velocity::{deviation, max_velocity_from_phase, velocity_phase_residual};
    pub use crate::cycle::phase_function::phase_function_of_tangent;
}

pub(crate) use amplitude::force_ratio_from_displacement;
#[cfg(feature = "batch")]
pub(crate) use border::border_near;
#[cfg(any(test, feature = "mp"))]
pub(crate) use displacement::max_displacement;
pub(crate) use displacement::velocity_phase;
#[cfg(feature = "mp")]
pub(crate) use dissipation::{best_force_ratio, best_loop_size, loop_size_inertia};
pub(crate) use dissipation::{best_force_ratio_at, best_loop_size_at, loop_size_stiffness};
#[cfg(feature = "mp")]
pub(crate) use half_cycle::{HalfCycle, free_swing};
pub(crate) use peaks::dynamic_amplification;
#[cfg(feature = "mp")]
pub(crate) use peaks::{arrival_acceleration, near_ends_or_crest, transmitted_force};
#[cfg(feature = "mp")]
pub(crate) use reversal::deviation_by;
#[cfg(feature = "mp")]
pub(crate) use velocity::fastest;
#[cfg(feature = "batch")]
pub(crate) use velocity::low::{LowCircular, LowWaves};
#[cfg(feature = "batch")]
pub(crate) use velocity::waves::{Circular, Waves};

use crate::cycle::border::least_with_static_friction;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Float, fused};
use crate::machine::error::{Error, written};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::Ratios;
use core::fmt;
use damped::DampedCycle;
use undamped::Undamped;
use waveform::Basis;

/// The steady non-sticking motion at one (Ω, α), and ζ if there is a damper, with all its outputs.
///
/// The accuracies hold from the true border up. An α between the rounded border and a true border above it
/// counts as on the border: its Δ₀/B is 1/Ω² for Ω ≥ 1/2, where eq. 44 at that number would give a smaller
/// value or none (`docs/development/accuracy.md`).
///
/// ```
/// use stickslip::{Cycle, Ratios};
/// let cycle = Cycle::new(Ratios::new(1.5f64, 2.5)?)?;
/// assert!((cycle.max_displacement - 1.632993161855452).abs() < 1e-15);
/// assert!((cycle.max_velocity - 1.654152276482076).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::CycleFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[non_exhaustive]
#[must_use]
pub struct Cycle<F> {
    /// The ratios (Ω, α).
    pub ratios: Ratios<F>,
    /// Peak displacement `Δ₀/B` ([`Reversal`], eq. 44). Accuracy at f64: 2 ulp.
    pub max_displacement: F,
    /// Phase `ω_d t₂` of the peak displacement (eq. 43 corrected). Accuracy at f64: 2 ulp of
    /// max(phase, 1).
    pub displacement_phase: F,
    /// Peak velocity `V₀/(Bω_d)` (eq. 49 corrected): the maximum over the half cycle, whatever the number
    /// of its stationary points. Accuracy at f64: 4 ulp.
    pub max_velocity: F,
    /// Phase `ω_d t₁` of the peak velocity (the root of eq. 46 that is the global maximum). Accuracy at
    /// f64: 4 ulp of max(phase, 1).
    pub velocity_phase: F,
    motion: Basis<F>,
}

/// The public fields: the others are split numbers.
impl<F: fmt::Debug> fmt::Debug for Cycle<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Cycle")
            .field("ratios", &self.ratios)
            .field("max_displacement", &self.max_displacement)
            .field("displacement_phase", &self.displacement_phase)
            .field("max_velocity", &self.max_velocity)
            .field("velocity_phase", &self.velocity_phase)
            .finish_non_exhaustive()
    }
}

impl<F: Float> Cycle<F> {
    /// The cycle at (Ω, α).
    ///
    /// # Errors
    /// [`Error::Sticks`] where α is below the exact border, [`Error::Unbounded`] where Ω = 1 and α is above
    /// it.
    #[inline]
    pub fn new(ratios: Ratios<F>) -> Result<Self, Error> {
        if ratios.is_damped() {
            return Self::damped(ratios);
        }
        fused!(<F>(ratios: Ratios<F>) -> Result<Cycle<F>, Error> {
            cycle_or_least(ratios).map_err(|least| no_cycle(ratios, least))
        })
    }

    /// The cycle at these ratios; `None` where [`Cycle::new`] has an error.
    #[inline]
    pub(crate) fn find(ratios: Ratios<F>) -> Option<Self> {
        if ratios.is_damped() {
            return Self::damped(ratios).ok();
        }
        fused!(<F>(ratios: Ratios<F>) -> Option<Cycle<F>> { cycle_or_least(ratios).ok() })
    }

    /// The cycle with damping.
    #[cold]
    fn damped(ratios: Ratios<F>) -> Result<Self, Error> {
        let half = damped::half_period(&ratios);
        let least = damped::border(&half).min_force_ratio;
        if ratios.alpha() < least {
            return Err(no_cycle(ratios, least));
        }
        Ok(Self::of_damped(DampedCycle::at(half, ratios.alpha()), ratios))
    }

    /// The cycle with damping that was found at these ratios.
    pub(crate) fn of_damped(found: DampedCycle<F>, ratios: Ratios<F>) -> Self {
        Self {
            ratios,
            motion: Basis::Damped(found),
            max_displacement: found.max_displacement,
            displacement_phase: found.displacement_phase,
            max_velocity: found.max_velocity,
            velocity_phase: found.velocity_phase,
        }
    }

    /// The cycle at (Ω, α) known to be on or above the border, Ω ≠ 1, ζ = 0; `p` is the phase function at Ω.
    #[inline(always)]
    pub(crate) fn at(p: &PhaseFunction<F>, ratios: Ratios<F>) -> Self {
        let (omega, alpha) = (ratios.omega(), ratios.alpha());
        let reversal = Reversal::new(p, alpha).of_sliding(omega);
        let displacement = reversal.max_displacement_pair();
        let displacement_phase = reversal.displacement_phase();
        let given = velocity::GivenCycle { reversal, displacement, alpha, displacement_phase };
        let (fastest, deviation) = velocity::fastest_of_cycle(p, &given);
        let velocity_phase = velocity_phase(displacement_phase, omega, fastest.psi);
        let psi = fastest.psi;
        Self {
            ratios,
            motion: Basis::Undamped(Undamped { reversal, displacement, psi, deviation, rounded: None }),
            max_displacement: displacement.hi,
            displacement_phase,
            max_velocity: fastest.velocity,
            velocity_phase,
        }
    }

    /// Converts each part of the cycle to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Cycle<G> {
        Cycle {
            ratios: self.ratios.map(&to),
            motion: self.motion.map(self.ratios.omega(), &to),
            max_displacement: to(self.max_displacement),
            displacement_phase: to(self.displacement_phase),
            max_velocity: to(self.max_velocity),
            velocity_phase: to(self.velocity_phase),
        }
    }

    /// `(sin β, cos β)`, β = π/2Ω.
    #[inline]
    pub(crate) fn sin_cos_beta(&self) -> (F, F) {
        match &self.motion {
            Basis::Undamped(cycle) => cycle.half(self.ratios.omega()).sin_cos_beta(),
            Basis::Damped(_) => PhaseFunction::of_valid(self.ratios.omega()).sin_cos(),
        }
    }

    /// Deviation `Δ₁/B`: the displacement at the peak velocity (eq. 47). Accuracy at f64: 4 ulp of
    /// max(|Δ₁/B|, V₀/(Bω_d)).
    pub fn deviation(&self) -> F {
        match &self.motion {
            Basis::Undamped(cycle) => cycle.deviation(self.ratios.omega()),
            Basis::Damped(cycle) => cycle.deviation,
        }
    }

    /// Contraction per half cycle, max |λ|: the factor by which a small disturbance shrinks.
    pub fn contraction(&self) -> F {
        match &self.motion {
            Basis::Undamped(cycle) => cycle.contraction(self.ratios.omega()),
            Basis::Damped(cycle) => cycle.contraction(),
        }
    }

    /// The multipliers of this cycle.
    pub fn multipliers(&self) -> Multipliers<F> {
        self.motion.multipliers(self.ratios.omega())
    }

    /// Loop size `A₁ = 8(Δ₀/B)/α²` (eq. 64). Accuracy at f64: 2 ulp.
    pub fn loop_size_stiffness(&self) -> F {
        self.fused_loop_sizes().0
    }

    /// Loop size `A₂ = Ω² A₁` (eq. 67). Accuracy at f64: 2 ulp.
    pub fn loop_size_inertia(&self) -> F {
        self.fused_loop_sizes().1
    }

    #[inline(always)]
    pub(crate) fn fused_loop_sizes(&self) -> (F, F) {
        let cycle = self;
        fused!(<'a, F>(cycle: &'a Cycle<F>) -> (F, F) { cycle.loop_sizes() })
    }

    /// (A₁, A₂).
    #[inline(always)]
    pub(crate) fn loop_sizes(&self) -> (F, F) {
        self.motion.loop_sizes(&self.ratios)
    }

    /// The energy that the damper dissipates in a cycle, in units of r_y B; 0 without a damper. Friction
    /// dissipates 4Δ₀/B. A damper on the moving support ([`Ratios::excitation`]) dissipates by the velocity between body
    /// and support, `∮ 2ζ (x′ − u′)² dφ`.
    ///
    /// `∮ 2ζ x′² dφ = 2ζT Ω²(α/q)² + 4G + 8ζI`, `I = 2[ΩH (1 − Ω²) − 2ζΩ² a]/q²`, in the symbols of
    /// `docs/development/theory/damping.md`; the integral itself where these cancel, near Ω = 1 with little damping.
    /// On the border at Ω = 1 it is right to 1e-7 at f64 down to ζ = 1e-18, where it tends to 7.10434086 ζ.
    pub fn damper_work(&self) -> F {
        match &self.motion {
            Basis::Undamped(_) => F::int(0),
            Basis::Damped(cycle) => {
                cycle.damper_work(self.ratios.excitation() == Some(Excitation::DampedFootMotion))
            }
        }
    }

    /// Displacement `x/B` at any phase ω_d t (eq. 15, 16, continued periodically).
    ///
    /// This is accurate near Ω = 1, where eq. 15 and 16 as written are not. The result is NaN for a phase
    /// that is not finite. A large phase is reduced exactly.
    pub fn displacement_at(&self, phase: F) -> F {
        self.motion.at(self.ratios.omega(), phase - self.displacement_phase).0
    }

    /// Velocity `x′/(Bω_d)` at any phase ω_d t: the derivative of [`Cycle::displacement_at`].
    pub fn velocity_at(&self, phase: F) -> F {
        self.motion.at(self.ratios.omega(), phase - self.displacement_phase).1
    }
}

/// The cycle, or the minimum force ratio without sticking.
#[inline(always)]
fn cycle_or_least<F: Float>(ratios: Ratios<F>) -> Result<Cycle<F>, F> {
    let p = PhaseFunction::of_valid(ratios.omega());
    let least = least_with_static_friction(&p, ratios.static_friction_ratio());
    if ratios.alpha() < least || ratios.omega() == F::int(1) { Err(least) } else { Ok(Cycle::at(&p, ratios)) }
}

/// Why there is no cycle where the minimum force ratio without sticking is `least`.
#[cold]
fn no_cycle<F: Float>(ratios: Ratios<F>, least: F) -> Error {
    let alpha = written(ratios.alpha());
    if ratios.alpha() < least {
        Error::Sticks { omega: written(ratios.omega()), alpha, least: written(least) }
    } else {
        Error::Unbounded { alpha }
    }
}

#[cfg(test)]
mod tests;
