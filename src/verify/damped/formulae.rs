//! The formulae with damping that are checked: those of the library, or a set of wrong ones in tests.

use crate::float::Float;
use crate::nonsticking::stability::MultiplierPair;
use crate::nonsticking::{Border, Cycle, damped};
use crate::ratios::Ratios;

/// The answers at one (Ω, α, ζ): lengths in B, velocities in B ω_d, phases in `[0, 2π)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answers<F> {
    pub(crate) max_displacement: F,
    pub(crate) displacement_phase: F,
    pub(crate) max_velocity: F,
    pub(crate) velocity_phase: F,
    pub(crate) deviation: F,
    pub(crate) loop_size_stiffness: F,
    pub(crate) loop_size_inertia: F,
    pub(crate) damper_work: F,
    pub(crate) contraction: F,
    /// The multipliers of half a cycle.
    pub(crate) multipliers: MultiplierPair<F>,
}

/// The answers at one (Ω, ζ).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge<F> {
    /// α_min.
    pub(crate) min_force_ratio: F,
    /// τ*.
    pub(crate) phase: F,
    /// S − G, the least Δ₀/B.
    pub(crate) least_displacement: F,
}

/// All formulae that are checked.
pub(crate) trait Formulae<F: Float>: core::fmt::Debug {
    /// The answers at (Ω, α, ζ).
    fn answers(&self, cycle: &Cycle<F>) -> Answers<F> {
        Answers {
            max_displacement: cycle.max_displacement,
            displacement_phase: cycle.displacement_phase,
            max_velocity: cycle.max_velocity,
            velocity_phase: cycle.velocity_phase,
            deviation: cycle.deviation(),
            loop_size_stiffness: cycle.loop_size_stiffness(),
            loop_size_inertia: cycle.loop_size_inertia(),
            damper_work: cycle.damper_work(),
            contraction: cycle.contraction(),
            multipliers: cycle.multipliers().pair(),
        }
    }
    /// The border at (Ω, ζ).
    fn edge(&self, ratios: &Ratios<F>) -> Edge<F> {
        let border = Border::of(ratios);
        Edge {
            min_force_ratio: border.min_force_ratio,
            phase: border.touching_phase,
            least_displacement: border.min_displacement,
        }
    }
    /// α* and A₁max at (Ω, ζ).
    fn best(&self, ratios: &Ratios<F>) -> (F, F) {
        damped::best(&damped::half_period(ratios))
    }
    /// x/B and x′/(Bω_d) at a phase.
    fn motion_at(&self, cycle: &Cycle<F>, phase: F) -> (F, F) {
        (cycle.displacement_at(phase), cycle.velocity_at(phase))
    }
}

/// The library's own formulae.
#[derive(Debug)]
pub(crate) struct Library;

impl<F: Float> Formulae<F> for Library {}
