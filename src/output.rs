//! The outputs of a [`Response`] by name: what the questions about uncertain parameters are asked of.

use crate::float::{Field, Float};
use crate::nonsticking::Cycle;
use crate::oscillator::Scales;
use crate::response::Response;

/// One output of a [`Response`].
///
/// Dimensionless, [`Output::of`] gives it in the units of the table; [`Output::unit`] is what to multiply it by for physical units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Output {
    /// Maximum displacement Δ₀ (B; length).
    MaxDisplacement,
    /// Phase ω_d t₂ of the maximum displacement (rad; time).
    DisplacementPhase,
    /// Maximum velocity V₀ (Bω_d; velocity).
    MaxVelocity,
    /// Phase ω_d t₁ of the maximum velocity (rad; time).
    VelocityPhase,
    /// Deviation Δ₁ (B; length).
    Deviation,
    /// Loop size A₁ (p₀²/2k; the energy dissipated in a cycle).
    LoopSizeStiffness,
    /// Loop size A₂ (p₀²/(2mω_d²); the energy dissipated in a cycle).
    LoopSizeInertia,
    /// Contraction per half cycle (1; 1).
    Contraction,
    /// Margin α/α_min (1; 1).
    Margin,
    /// Least force ratio without sticking, α_min (1; the minimum force p₀).
    MinForceRatio,
    /// The same by eq. 61 (1; force).
    TurningPointForceRatio,
    /// Least displacement S of a cycle that does not stick (B; length).
    LeastDisplacement,
    /// Phase τ* where the velocity first touches zero on the border (rad; time).
    TouchingPhase,
    /// Force ratio α* of the largest loop (1; force).
    BestForceRatio,
    /// Loop size A₁max there (p₀²/2k; energy).
    BestLoopSize,
    /// Dynamic amplification k Δ₀/p₀ (1; 1).
    DynamicAmplification,
    /// Maximum acceleration |x″| (B ω_d²; acceleration).
    MaxAcceleration,
    /// Greatest force of spring and friction on what carries them (r_y; force).
    TransmittedForce,
    /// That force over p₀ (1; 1).
    Transmissibility,
    /// Greatest absolute displacement under a base that carries the surface (B; length).
    MaxAbsoluteDisplacement,
}

/// No output has this name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("output `{name}` must be one of Output::ALL by its name, such as max_displacement")]
#[non_exhaustive]
pub struct UnknownOutput {
    /// The name.
    pub name: String,
}

/// By its name.
impl core::str::FromStr for Output {
    type Err = UnknownOutput;

    fn from_str(name: &str) -> Result<Self, UnknownOutput> {
        let found = Self::ALL.into_iter().find(|output| output.name() == name);
        found.ok_or_else(|| UnknownOutput { name: name.to_owned() })
    }
}

/// Its name.
impl core::fmt::Display for Output {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

impl Output {
    /// All of them, in order.
    pub const ALL: [Self; 20] = [
        Self::MaxDisplacement,
        Self::DisplacementPhase,
        Self::MaxVelocity,
        Self::VelocityPhase,
        Self::Deviation,
        Self::LoopSizeStiffness,
        Self::LoopSizeInertia,
        Self::Contraction,
        Self::Margin,
        Self::MinForceRatio,
        Self::TurningPointForceRatio,
        Self::LeastDisplacement,
        Self::TouchingPhase,
        Self::BestForceRatio,
        Self::BestLoopSize,
        Self::DynamicAmplification,
        Self::MaxAcceleration,
        Self::TransmittedForce,
        Self::Transmissibility,
        Self::MaxAbsoluteDisplacement,
    ];

    /// Its name, as the command prints it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MaxDisplacement => "max_displacement",
            Self::DisplacementPhase => "displacement_phase",
            Self::MaxVelocity => "max_velocity",
            Self::VelocityPhase => "velocity_phase",
            Self::Deviation => "deviation",
            Self::LoopSizeStiffness => "loop_size_stiffness",
            Self::LoopSizeInertia => "loop_size_inertia",
            Self::Contraction => "contraction",
            Self::Margin => "margin",
            Self::MinForceRatio => "min_force_ratio",
            Self::TurningPointForceRatio => "min_force_ratio_turning_point",
            Self::LeastDisplacement => "least_displacement",
            Self::TouchingPhase => "border_phase",
            Self::BestForceRatio => "best_force_ratio",
            Self::BestLoopSize => "best_loop_size",
            Self::DynamicAmplification => "dynamic_amplification",
            Self::MaxAcceleration => "max_acceleration",
            Self::TransmittedForce => "transmitted_force",
            Self::Transmissibility => "transmissibility",
            Self::MaxAbsoluteDisplacement => "max_absolute_displacement",
        }
    }

    /// Whether it belongs to the non-sticking cycle, and exists where that does.
    #[must_use]
    pub(crate) const fn is_of_cycle(self) -> bool {
        matches!(
            self,
            Self::MaxDisplacement
                | Self::DisplacementPhase
                | Self::MaxVelocity
                | Self::VelocityPhase
                | Self::Deviation
                | Self::LoopSizeStiffness
                | Self::LoopSizeInertia
                | Self::Contraction
                | Self::DynamicAmplification
                | Self::MaxAcceleration
                | Self::TransmittedForce
                | Self::Transmissibility
                | Self::MaxAbsoluteDisplacement
        )
    }

    /// Its value, dimensionless; `None` where it does not exist.
    pub fn of<F: Float>(self, response: &Response<F>) -> Option<F> {
        let border = response.border();
        match self {
            Self::Margin => Some(response.ratios().alpha() / border.min_force_ratio()),
            Self::MinForceRatio => Some(border.min_force_ratio()),
            Self::TurningPointForceRatio => Some(border.turning_point()),
            Self::LeastDisplacement => Some(border.least_displacement()),
            Self::TouchingPhase => Some(border.phase()),
            Self::BestForceRatio => Some(response.best_force_ratio()),
            Self::BestLoopSize => response.best_loop_size(),
            Self::MaxDisplacement
            | Self::DisplacementPhase
            | Self::MaxVelocity
            | Self::VelocityPhase
            | Self::Deviation
            | Self::LoopSizeStiffness
            | Self::LoopSizeInertia
            | Self::Contraction
            | Self::DynamicAmplification
            | Self::MaxAcceleration
            | Self::TransmittedForce
            | Self::Transmissibility
            | Self::MaxAbsoluteDisplacement => response.cycle().and_then(|cycle| self.of_cycle(cycle)),
        }
    }

    /// Its value, where it belongs to the cycle.
    pub(crate) fn of_cycle<F: Float>(self, cycle: &Cycle<F>) -> Option<F> {
        Some(match self {
            Self::MaxDisplacement => cycle.max_displacement(),
            Self::DisplacementPhase => cycle.displacement_phase(),
            Self::MaxVelocity => cycle.max_velocity(),
            Self::VelocityPhase => cycle.velocity_phase(),
            Self::Deviation => cycle.deviation(),
            Self::LoopSizeStiffness => cycle.loop_size_stiffness(),
            Self::LoopSizeInertia => cycle.loop_size_inertia(),
            Self::Contraction => cycle.contraction(),
            Self::DynamicAmplification => cycle.dynamic_amplification(),
            Self::MaxAcceleration => cycle.max_acceleration(),
            Self::TransmittedForce => cycle.transmitted_force(),
            Self::Transmissibility => cycle.transmissibility(),
            Self::MaxAbsoluteDisplacement => cycle.max_absolute_displacement(),
            Self::Margin
            | Self::MinForceRatio
            | Self::TurningPointForceRatio
            | Self::LeastDisplacement
            | Self::TouchingPhase
            | Self::BestForceRatio
            | Self::BestLoopSize => return None,
        })
    }

    /// The physical size of one unit of it.
    pub fn unit<F: Field>(self, scales: &Scales<F>) -> F {
        match self {
            Self::MaxDisplacement
            | Self::Deviation
            | Self::LeastDisplacement
            | Self::MaxAbsoluteDisplacement => scales.length,
            Self::MaxAcceleration => scales.velocity / scales.time,
            Self::MaxVelocity => scales.velocity,
            Self::DisplacementPhase | Self::VelocityPhase | Self::TouchingPhase => scales.time,
            Self::LoopSizeStiffness | Self::BestLoopSize => scales.energy_stiffness,
            Self::LoopSizeInertia => scales.energy_inertia,
            Self::MinForceRatio
            | Self::TurningPointForceRatio
            | Self::BestForceRatio
            | Self::TransmittedForce => scales.force,
            Self::Contraction | Self::Margin | Self::DynamicAmplification | Self::Transmissibility => {
                F::int(1)
            }
        }
    }
}

#[cfg(test)]
mod tests;
