//! The outputs of a [`Response`] by name, for batches, sensitivities and the analysis of uncertain
//! parameters.

use crate::float::{Field, Float};
#[cfg(feature = "serde")]
use crate::nonsticking::Cycle;
use crate::nonsticking::dynamic_amplification;
use crate::oscillator::Scales;
use crate::response::Response;

/// Defines the outputs from one row each: the description, the names in Rust and in the command, the
/// dimensionless value, and the physical size of one unit of it.
///
/// The value is computed from the `cycle` and exists where the cycle does, from the `border`, or from the
/// whole `response` as an `Option`.
macro_rules! outputs {
    ($(
        $(#[$doc:meta])*
        $output:ident $name:literal: $from:ident => $value:expr, in $scales:ident => $unit:expr;
    )*) => {
        /// One output of a [`Response`].
        ///
        /// [`Output::of`] gives the dimensionless value, in the units of the table. Multiply it by
        /// [`Output::unit`] for physical units.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Output {
            $($(#[$doc])* $output,)*
        }

        impl Output {
            /// All outputs, in order.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$output),*];

            /// The output's name, as [`Display`](core::fmt::Display) prints it.
            #[doc(hidden)]
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$output => $name,)*
                }
            }

            /// Whether the output belongs to the non-sticking cycle and exists only where the cycle does.
            #[must_use]
            pub(crate) const fn is_of_cycle(self) -> bool {
                match self {
                    $(Self::$output => outputs!(@is_of_cycle $from),)*
                }
            }

            /// The dimensionless value; `None` where it does not exist.
            pub fn of<F: Float>(self, response: &Response<F>) -> Option<F> {
                match self {
                    $(Self::$output => outputs!(@of response, $from $from, $value),)*
                }
            }

            /// The value, if the output belongs to the cycle.
            #[cfg(feature = "serde")]
            pub(crate) fn of_cycle<F: Float>(self, cycle: &Cycle<F>) -> Option<F> {
                match self {
                    $(Self::$output => outputs!(@of_cycle cycle, $from $from, $value),)*
                }
            }

            /// The physical size of one unit of the output.
            pub fn unit<F: Field>(self, scales: &Scales<F>) -> F {
                match self {
                    $(Self::$output => {
                        let $scales = scales;
                        $unit
                    })*
                }
            }
        }
    };
    (@is_of_cycle cycle) => { true };
    (@is_of_cycle $other:ident) => { false };
    (@of $response:ident, cycle $cycle:ident, $value:expr) => {
        $response.cycle.as_ref().map(|$cycle| $value)
    };
    (@of $response:ident, border $border:ident, $value:expr) => {{
        let $border = $response.border;
        Some($value)
    }};
    (@of $response:ident, response $given:ident, $value:expr) => {{
        let $given = $response;
        $value
    }};
    (@of_cycle $given:ident, cycle $cycle:ident, $value:expr) => {{
        let $cycle = $given;
        Some($value)
    }};
    (@of_cycle $given:ident, $other:ident $same:ident, $value:expr) => { None };
}

outputs! {
    /// Maximum displacement Δ₀ (B; length).
    MaxDisplacement "max_displacement": cycle => cycle.max_displacement, in scales => scales.length;
    /// Phase ω_d t₂ of the maximum displacement (rad; time).
    DisplacementPhase "displacement_phase": cycle => cycle.displacement_phase, in scales => scales.time;
    /// Maximum velocity V₀ (Bω_d; velocity).
    MaxVelocity "max_velocity": cycle => cycle.max_velocity, in scales => scales.velocity;
    /// Phase ω_d t₁ of the maximum velocity (rad; time).
    VelocityPhase "velocity_phase": cycle => cycle.velocity_phase, in scales => scales.time;
    /// Deviation Δ₁ (B; length).
    Deviation "deviation": cycle => cycle.deviation(), in scales => scales.length;
    /// Loop size A₁ (p₀²/2k; the energy dissipated in a cycle).
    LoopSizeStiffness "loop_size_stiffness": cycle => cycle.loop_size_stiffness(),
        in scales => scales.energy_stiffness;
    /// Loop size A₂ (p₀²/(2mω_d²); the energy dissipated in a cycle).
    LoopSizeInertia "loop_size_inertia": cycle => cycle.loop_size_inertia(),
        in scales => scales.energy_inertia;
    /// Contraction per half cycle (1; 1).
    Contraction "contraction": cycle => cycle.contraction(), in _scales => F::int(1);
    /// Margin α/α_min (1; 1).
    Margin "margin": response => Some(response.ratios.alpha() / response.border.min_force_ratio),
        in _scales => F::int(1);
    /// Minimum force ratio without sticking, α_min (1; the minimum force p₀).
    MinForceRatio "min_force_ratio": border => border.min_force_ratio, in scales => scales.force;
    /// Minimum force ratio without sticking by eq. 61 (1; force).
    TurningPointForceRatio "min_force_ratio_turning_point": border => border.turning_point,
        in scales => scales.force;
    /// Minimum Δ₀, S, of a cycle that does not stick (B; length).
    LeastDisplacement "least_displacement": border => border.min_displacement, in scales => scales.length;
    /// Phase τ* where the velocity first touches zero on the border (rad; time).
    TouchingPhase "border_phase": border => border.touching_phase, in scales => scales.time;
    /// Force ratio α* of the largest loop (1; force).
    BestForceRatio "best_force_ratio": response => Some(response.best_force_ratio),
        in scales => scales.force;
    /// Loop size A₁max at that force ratio (p₀²/2k; energy).
    BestLoopSize "best_loop_size": response => response.best_loop_size,
        in scales => scales.energy_stiffness;
    /// Dynamic amplification k Δ₀/p₀ (1; 1).
    DynamicAmplification "dynamic_amplification": cycle => dynamic_amplification(cycle.max_displacement, cycle.ratios.alpha()),
        in _scales => F::int(1);
    /// Maximum acceleration |x″| (B ω_d²; acceleration).
    MaxAcceleration "max_acceleration": cycle => cycle.max_acceleration(),
        in scales => scales.velocity / scales.time;
    /// Maximum force of spring and friction on their support (r_y; force).
    TransmittedForce "transmitted_force": cycle => cycle.transmitted_force(), in scales => scales.force;
    /// Maximum transmitted force over p₀ (1; 1).
    Transmissibility "transmissibility": cycle => cycle.transmitted_force() / cycle.ratios.alpha(), in _scales => F::int(1);
    /// Maximum absolute displacement under a base that carries the surface (B; length).
    MaxAbsoluteDisplacement "max_absolute_displacement": cycle => cycle.max_absolute_displacement(),
        in scales => scales.length;
}

/// The error for a name that no output has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("output `{name}` must be one of Output::ALL by its name, such as max_displacement")]
#[non_exhaustive]
pub struct UnknownOutput {
    /// The unknown name.
    pub name: String,
}

/// Parses an output by its name.
impl core::str::FromStr for Output {
    type Err = UnknownOutput;

    fn from_str(name: &str) -> Result<Self, UnknownOutput> {
        let found = Self::ALL.into_iter().find(|output| output.name() == name);
        found.ok_or_else(|| UnknownOutput { name: name.to_owned() })
    }
}

/// Displays the output's name.
impl core::fmt::Display for Output {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests;
