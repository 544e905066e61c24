//! The outputs of a [`Response`] as one table, for batches, sensitivities, the analysis of uncertain
//! parameters, the command and the Python package.

mod answer;
mod definition;
#[allow(missing_docs, reason = "each has its meaning")]
pub mod definitions;
mod kind;

#[cfg(feature = "serde")]
use crate::cycle::Cycle;
use crate::cycle::dynamic_amplification;
use crate::cycle::response::{Response, amplitude};
use crate::float::{Float, Real};
use crate::machine::oscillator::Scales;
use crate::machine::ratios::Ratios;
use crate::named::UnknownName;

pub(crate) use answer::columns;
pub use answer::{Column, ResponseAnswer, Value, When};
pub use definition::{Definition, Measure};
pub use kind::{Dimension, Kind};

/// Defines the outputs from one row each: the names in Rust and in the command, the measure, the meaning, the
/// other columns of a [`Definition`], and the dimensionless value.
///
/// The value is computed from the `cycle` and exists where the cycle does, from its `motion` as an `Option`, from the
/// `border`, or from the whole `response` as an `Option`.
macro_rules! outputs {
    ($(
        $output:ident($name:literal, $measure:ident, $meaning:literal) $(.$column:ident($($fact:expr)?))*:
            $from:ident => $value:expr;
    )*) => {
        /// One output of a [`Response`].
        ///
        /// [`Output::of`] gives the dimensionless value. Multiply it by [`Output::unit`] for physical units.
        /// [`Output::definition`] has its symbol, its equation, its unit and its accuracy.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(try_from = "alloc::string::String"))]
        #[non_exhaustive]
        pub enum Output {
            $(
                #[doc = concat!("`", $name, "`: ", $meaning, " ([`Measure::", stringify!($measure), "`]).")]
                $output,
            )*
        }

        impl Output {
            /// All outputs, in order.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$output),*];

            /// Their names.
            const NAMES: &'static [&'static str] = &[$($name),*];

            /// The output's name, symbol, equation, unit, accuracy and meaning.
            #[must_use]
            pub const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$output => const {
                        &Definition::new($name, Measure::$measure, $meaning)$(.$column($($fact)?))*
                    },)*
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
        }
    };
    (@is_of_cycle cycle) => { true };
    (@is_of_cycle motion) => { true };
    (@is_of_cycle $other:ident) => { false };
    (@of $response:ident, cycle $cycle:ident, $value:expr) => {
        $response.cycle.as_ref().map(|$cycle| $value)
    };
    (@of $response:ident, motion $cycle:ident, $value:expr) => {
        $response.cycle.as_ref().and_then(|$cycle| $value)
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
    (@of_cycle $given:ident, motion $cycle:ident, $value:expr) => {{
        let $cycle = $given;
        $value
    }};
    (@of_cycle $given:ident, $other:ident $same:ident, $value:expr) => { None };
}

outputs! {
    MaxDisplacement("max_displacement", Length, "peak displacement Δ₀")
        .symbol("Δ₀").equation(44).ulps(2):
        cycle => cycle.max_displacement;
    DisplacementPhase("displacement_phase", Angle, "phase ω_d t₂ of the peak displacement")
        .symbol("ω_d t₂").equation(43).ulps(2)
        .title("phase of the peak displacement").physical("displacement_time"):
        cycle => cycle.displacement_phase;
    MaxVelocity("max_velocity", Velocity, "peak velocity V₀")
        .symbol("V₀").equation(49).ulps(4):
        cycle => cycle.max_velocity;
    VelocityPhase("velocity_phase", Angle, "phase ω_d t₁ of the peak velocity")
        .symbol("ω_d t₁").equation(46).ulps(4)
        .title("phase of the peak velocity").physical("velocity_time"):
        cycle => cycle.velocity_phase;
    Deviation("deviation", Length, "displacement Δ₁ at the peak velocity")
        .symbol("Δ₁").equation(47).ulps(4).title("displacement at the peak velocity"):
        cycle => cycle.deviation();
    LoopSizeStiffness("loop_size_stiffness", EnergyStiffness, "friction's energy in a cycle per p₀²/(2k), A₁")
        .symbol("A₁").equation(64).ulps(2).title("loop size A₁").physical("energy_per_cycle"):
        cycle => cycle.loop_size_stiffness();
    LoopSizeInertia("loop_size_inertia", EnergyInertia, "friction's energy in a cycle per p₀²/(2 m ω_d²), A₂")
        .symbol("A₂").equation(67).ulps(2).title("loop size A₂").without_physical():
        cycle => cycle.loop_size_inertia();
    Contraction("contraction", One, "fraction of a disturbance that remains after half a cycle")
        .symbol("λ").title("fraction of a disturbance that remains after half a cycle"):
        cycle => cycle.contraction();
    Margin("margin", One, "force over the minimum force without sticking, α/α_min")
        .symbol("α/α_min"):
        response => Some(response.ratios.alpha() / response.border.min_force_ratio);
    MinForceRatio("min_force_ratio", ForceRatio, "minimum force ratio α_min without sticking")
        .symbol("α_min").ulps(2).title("minimum force ratio without sticking").physical("min_force"):
        border => border.min_force_ratio;
    MinForceRatioTurningPoint("min_force_ratio_turning_point", ForceRatio,
            "minimum force ratio by eq. 61, which falls short below Ω = 1/2")
        .symbol("eq. 61").equation(61).ulps(2).title("minimum force ratio by eq. 61")
        .physical("min_force_turning_point"):
        border => border.min_force_ratio_turning_point;
    LeastDisplacement("least_displacement", Length, "peak displacement on the border")
        .symbol("S").title("peak displacement on the border"):
        border => border.least_displacement;
    BorderPhase("border_phase", Angle,
            "phase after the peak displacement at which the velocity first touches zero, on the border")
        .symbol("τ*").title("phase of the first stop on the border").physical("border_time"):
        border => border.border_phase;
    BestForceRatio("best_force_ratio", ForceRatio, "force ratio α* of the largest A₁")
        .symbol("α*").equation(65).ulps(2).title("force ratio of the largest loop").physical("best_force"):
        response => Some(response.best_force_ratio);
    BestLoopSize("best_loop_size", EnergyOfLargestLoop, "largest A₁ at this Ω")
        .symbol("A₁max").equation(66).ulps(2).title("size of the largest loop").physical("best_force_energy"):
        response => response.best_loop_size;
    DynamicAmplification("dynamic_amplification", One,
            "peak displacement over p₀/k: compares machines of different friction"):
        cycle => dynamic_amplification(cycle.max_displacement, cycle.ratios.alpha());
    MaxAcceleration("max_acceleration", Acceleration, "peak acceleration |x″|")
        .symbol("|x″|").searched():
        cycle => cycle.max_acceleration();
    TransmittedForce("transmitted_force", Force,
            "maximum force of spring, damper and friction on their support, or m x″ with a moving support")
        .searched():
        cycle => cycle.transmitted_force();
    Transmissibility("transmissibility", One,
            "force on the support over p₀, or with a moving support or base the body's absolute acceleration over that of the support or base")
        .searched():
        cycle => cycle.transmissibility();
    MaxAbsoluteDisplacement("max_absolute_displacement", Length,
            "maximum absolute displacement of the body, where its support or a base that carries the surface moves")
        .searched().over_base("max_absolute_displacement"):
        motion => motion.absolute_displacement();
    MaxSpringForce("max_spring_force", Force,
            "maximum force in the spring k |x − u|, u the motion of its support, without that of the mean displacement")
        .title("maximum force in the spring").searched():
        cycle => cycle.max_spring_force();
    EquivalentDamping("equivalent_damping", Damping,
            "equivalent viscous damping W/(π ω_d X²) of friction and damper together, X the amplitude")
        .symbol("c_eq").title("equivalent damping"):
        cycle => cycle.equivalent().damping();
    EquivalentDampingRatio("equivalent_damping_ratio", One, "equivalent damping ratio c_eq/(2√(k m))")
        .symbol("ζ_eq").title("equivalent damping ratio"):
        cycle => cycle.equivalent().damping_ratio();
    EquivalentStiffness("equivalent_stiffness", Stiffness,
            "stiffness of the loop of spring and friction from end to end, k + r_y/X")
        .symbol("k_eff").title("equivalent stiffness"):
        cycle => cycle.equivalent().stiffness();
    EffectiveDampingRatio("effective_damping_ratio", One,
            "damping ratio as isolation codes state it, W/(2π k_eff X²)")
        .symbol("ξ_eff").title("effective damping ratio"):
        cycle => cycle.equivalent().effective_damping_ratio();
}

impl Output {
    /// The dimensionless values of the outputs chosen, NaN where they do not exist: the numbers of
    /// [`Output::of`], without the time of the others. {Δ₀, α_min, A₁} alone take a third of the time of a
    /// [`Response`] or less, and with damping those that do not need V₀ take two thirds of it.
    ///
    /// ```
    /// use stickslip::{Output, Ratios};
    /// let ratios = Ratios::new(0.7_f64, 2.0)?.with_damping_ratio(0.05)?;
    /// let [far, least] = Output::values([Output::MaxDisplacement, Output::MinForceRatio], ratios);
    /// assert!((far - 3.125_364).abs() < 1e-6 && (least - 1.567_980).abs() < 1e-6);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    pub fn values<F: Float, const N: usize>(chosen: [Self; N], ratios: Ratios<F>) -> [F; N] {
        let nan = F::int(0) / F::int(0);
        if chosen.iter().all(|output| output.is_of_amplitude()) {
            let [displacement, border, size] = amplitude(ratios);
            let of = |output| if output == Self::MaxDisplacement { displacement } else { size };
            return chosen.map(|output| if output == Self::MinForceRatio { border } else { of(output) });
        }
        let answer = Self::answer(chosen.iter().any(|output| output.needs_velocity()), ratios);
        chosen.map(|output| output.of(&answer).unwrap_or(nan))
    }

    /// The answer from which outputs are taken, those of the peak velocity among them or not.
    pub(crate) fn answer<F: Float>(has_velocity: bool, ratios: Ratios<F>) -> Response<F> {
        if has_velocity { Response::new(ratios) } else { Response::without_velocity(ratios) }
    }

    /// Whether the output is one of {Δ₀, α_min, A₁}, which need little else.
    pub(crate) const fn is_of_amplitude(self) -> bool {
        matches!(self, Self::MaxDisplacement | Self::MinForceRatio | Self::LoopSizeStiffness)
    }

    /// Whether the output needs the peak velocity: a search may begin with it.
    pub(crate) const fn needs_velocity(self) -> bool {
        matches!(self, Self::MaxVelocity | Self::VelocityPhase | Self::Deviation)
            || self.definition().is_searched
    }

    /// The output's name, as [`Display`](core::fmt::Display) prints it.
    #[doc(hidden)]
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// The physical size of one unit of the output.
    pub fn unit<F: Real>(self, scales: &Scales<F>) -> F {
        self.definition().measure.size(scales)
    }
}

/// Parses an output by its name.
impl core::str::FromStr for Output {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let place = UnknownName::place(name, Self::NAMES)?;
        let found = Self::ALL.get(place).copied();
        found.ok_or_else(|| UnknownName { name: name.into(), choices: Self::NAMES })
    }
}

/// Displays the output's name.
impl core::fmt::Display for Output {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

impl<F: Float> Response<F> {
    /// An output of this answer; `None` where it does not exist, such as the displacement of a body that sticks.
    ///
    /// ```
    /// use stickslip::{Output, Ratios, Response};
    /// let response = Response::new(Ratios::new(1.5, 2.5)?);
    /// assert!((response.get(Output::MaxDisplacement).unwrap() - 1.632_993_f64).abs() < 1e-6);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[must_use]
    pub fn get(&self, output: Output) -> Option<F> {
        output.of(self)
    }
}

#[cfg(test)]
mod tests;
