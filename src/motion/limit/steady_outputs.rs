//! The outputs of a steady state as one table, and those of a limit.

use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::excitation::Excitation;
use crate::machine::ratios::Ratios;
use crate::motion::limit::observed::{Observed, observed};
use crate::motion::slide::equation::Equation;
use crate::motion::{ErrorMeasures, LongRun, Peaks, SteadyState};
use crate::output::Value::{self, Count, Flag, Number, Pairs, Text};
use crate::output::definitions::{
    DAMPER_WORK, ERROR_1, ERROR_2, ERROR_3, ERROR_4, LIMIT, LYAPUNOV_EXPONENT, LYAPUNOV_EXPONENT_ERROR,
    MULTIPLIERS, PERIODS, REGIME, REST_POSITION, REVERSALS_PER_CYCLE, STICKS_PER_CYCLE, SYMMETRIC,
    TURNS_OBSERVED, TURNS_PER_CYCLE, VELOCITY_ZEROS_PER_CYCLE,
};
use crate::output::{Column, Definition, Measure, Output, When, columns};
use core::ops::ControlFlow;

/// Defines the outputs from one row each: the name in Rust, the definition, and the value.
macro_rules! steady_outputs {
    ($($output:ident: $definition:expr, $steady:ident => $value:expr;)*) => {
        /// One output of a [`SteadyState`] that is a number of its type.
        ///
        /// ```
        /// use stickslip::{Ratios, motion::{LongRun, State, SteadyOutput}};
        /// let limit = LongRun::from_start(Ratios::new(0.4, 6.0)?, State::default())?;
        /// let steady = limit.steady_state().ok_or("none")?;
        /// let output = SteadyOutput::ALL[0];
        /// assert_eq!(output.definition().name, "max_displacement");
        /// assert_eq!(output.of(steady), steady.max_displacement.value);
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        #[allow(missing_docs, reason = "each is the field or the method of that name")]
        pub enum SteadyOutput {
            $($output,)*
        }

        impl SteadyOutput {
            /// All outputs, in order.
            pub const ALL: [Self; [$(stringify!($output)),*].len()] = [$(Self::$output),*];

            /// The output's name, unit and meaning; its accuracy is that of the field of this name.
            #[must_use]
            pub const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$output => const { &$definition },)*
                }
            }

            /// The value of this output.
            pub fn of<F: Float>(self, steady: &SteadyState<F>) -> F {
                match self {
                    $(Self::$output => {
                        let $steady = steady;
                        $value
                    })*
                }
            }
        }
    };
}

/// The definition of the phase of an extreme.
const fn phase(name: &'static str, meaning: &'static str, physical: &'static str) -> Definition {
    Definition::new(name, Measure::Angle, meaning).physical(physical)
}

steady_outputs! {
    MaxDisplacement: *Output::MaxDisplacement.definition(), steady => steady.max_displacement.value;
    MaxDisplacementPhase: phase(
        "max_displacement_phase", "phase ω_d t of the maximum displacement", "max_displacement_time",
    ), steady => steady.max_displacement.phase.reduced();
    MinDisplacement: Definition::new("min_displacement", Measure::Length, "minimum displacement"),
        steady => steady.min_displacement.value;
    MinDisplacementPhase: phase("min_displacement_phase", "phase of the minimum displacement", "min_displacement_time"),
        steady => steady.min_displacement.phase.reduced();
    MaxVelocity: *Output::MaxVelocity.definition(), steady => steady.max_velocity.value;
    MaxVelocityPhase: phase("max_velocity_phase", "phase of the maximum velocity", "max_velocity_time"),
        steady => steady.max_velocity.phase.reduced();
    MinVelocity: Definition::new("min_velocity", Measure::Velocity, "minimum velocity"),
        steady => steady.min_velocity.value;
    MinVelocityPhase: phase("min_velocity_phase", "phase of the minimum velocity", "min_velocity_time"),
        steady => steady.min_velocity.phase.reduced();
    StickFraction: Definition::new("stick_fraction", Measure::One, "fraction of time at rest")
        .title("fraction of time at rest"), steady => steady.stick_fraction;
    EnergyIn: Definition::new("energy_in", Measure::Work, "work of the drive in a cycle")
        .title("work of the drive in a cycle"), steady => steady.energy_in;
    EnergyOut: Definition::new(
        "energy_out",
        Measure::Work,
        "work against friction in a cycle, without damper_work where damping was given",
    ).title("work against friction in a cycle"), steady => steady.energy_out;
    DamperWork: *DAMPER_WORK, steady => steady.damper_work;
    EquivalentDamping: *Output::EquivalentDamping.definition(), steady => steady.equivalent().damping();
    EquivalentDampingRatio: *Output::EquivalentDampingRatio.definition(),
        steady => steady.equivalent().damping_ratio();
    EquivalentStiffness: *Output::EquivalentStiffness.definition(), steady => steady.equivalent().stiffness();
    EffectiveDampingRatio: *Output::EffectiveDampingRatio.definition(),
        steady => steady.equivalent().effective_damping_ratio();
    Contraction: Definition::new("contraction", Measure::One, "fraction of a disturbance that remains after a cycle"),
        steady => steady.contraction();
    Distance: Definition::new("distance", Measure::Length, "estimated distance of the motion found from the limit")
        .title("distance from the limit"), steady => steady.distance.0;
}

impl SteadyOutput {
    /// The value of a body that rests at x for good; `None` for what a motion alone has.
    fn at_rest<F: Float>(self, ratios: Ratios<F>, x: F) -> Option<F> {
        match self {
            Self::MaxDisplacement | Self::MinDisplacement => Some(x),
            Self::MaxVelocity | Self::MinVelocity | Self::EnergyOut => Some(F::int(0)),
            Self::StickFraction => Some(F::int(1)),
            Self::EnergyIn | Self::DamperWork => {
                let turn = F::int(2) * F::pi();
                Some(Equation::new(ratios).damper_work_at_rest(F::int(0), turn))
            }
            Self::MaxDisplacementPhase
            | Self::MinDisplacementPhase
            | Self::MaxVelocityPhase
            | Self::MinVelocityPhase
            | Self::EquivalentDamping
            | Self::EquivalentDampingRatio
            | Self::EquivalentStiffness
            | Self::EffectiveDampingRatio
            | Self::Contraction
            | Self::Distance => None,
        }
    }
}

/// A limit with all its outputs.
#[derive(Debug)]
pub struct SteadyAnswer<'a, F> {
    /// The ratios.
    pub ratios: Ratios<F>,
    /// The limit.
    pub limit: &'a LongRun<F>,
    /// The regime and the counts of the limit.
    pub seen: Observed,
    /// The error measures of a periodic motion.
    pub errors: Option<ErrorMeasures<F>>,
    /// The peaks, if requested.
    pub peaks: Option<Peaks<F>>,
}

impl<'a, F: Float> SteadyAnswer<'a, F> {
    columns! {
        answer;
        (REGIME) => Text(answer.seen.regime.name());
        (LIMIT) => Text(answer.limit.name());
        (SteadyOutput::MaxDisplacement.definition()) => Number(answer.max_displacement());
        [SteadyOutput::MaxDisplacementPhase];
        (SteadyOutput::MinDisplacement.definition()) => Number(
            answer.limit.extrema().map(|(least, _)| least).or_else(|| answer.number(SteadyOutput::MinDisplacement)));
        [SteadyOutput::MinDisplacementPhase];
        [SteadyOutput::MaxVelocity];
        [SteadyOutput::MaxVelocityPhase];
        [SteadyOutput::MinVelocity];
        [SteadyOutput::MinVelocityPhase];
        (STICKS_PER_CYCLE) => Count(answer.seen.sticks.map(u64::from));
        (VELOCITY_ZEROS_PER_CYCLE) => answer.count(|steady| steady.velocity_zeros_per_cycle);
        [SteadyOutput::StickFraction];
        (ERROR_1) => Number(answer.errors.map(|errors| errors.error_1));
        (ERROR_2) => Number(answer.errors.map(|errors| errors.error_2));
        (ERROR_3) => Number(answer.errors.map(|errors| errors.error_3));
        (ERROR_4) => Number(answer.errors.map(|errors| errors.error_4));
        [SteadyOutput::EnergyIn];
        [SteadyOutput::EnergyOut];
        (MULTIPLIERS) => Pairs(answer.limit.steady_state().map(|steady| steady.multipliers));
        [SteadyOutput::Distance];
        (REST_POSITION) => Number(answer.limit.rest_position());
        (PERIODS) => Number(answer.limit.periods());
        (REVERSALS_PER_CYCLE) => Count(answer.seen.reversals.map(u64::from));
        (Output::DynamicAmplification.definition()) =>
            Number(answer.max_displacement().map(|most| most / answer.ratios.alpha()));
        (Output::MaxAcceleration.definition()) => Number(answer.peaks.map(|peaks| peaks.acceleration));
        (Output::TransmittedForce.definition()) => Number(answer.peaks.map(|peaks| peaks.transmitted_force));
        (Output::Transmissibility.definition()) => Number(answer.peaks.map(|peaks| peaks.transmissibility));
        (Output::MaxAbsoluteDisplacement.definition()) => Number(answer.peaks.and_then(|peaks| {
            let moves = answer.ratios.excitation().is_none_or(Excitation::moves_base);
            moves.then_some(peaks.absolute_displacement)
        }));
        (Output::MaxSpringForce.definition()) => Number(answer.peaks.map(|peaks| peaks.spring_force));
        [SteadyOutput::EquivalentDamping];
        [SteadyOutput::EquivalentDampingRatio];
        [SteadyOutput::EquivalentStiffness];
        [SteadyOutput::EffectiveDampingRatio];
        (DAMPER_WORK) if Damping => Number(answer.number(SteadyOutput::DamperWork));
        (TURNS_PER_CYCLE) if StaticFriction => answer.count(|steady| steady.turns_per_cycle);
        (SYMMETRIC) if StaticFriction => Flag(answer.limit.steady_state().map(|steady| steady.is_symmetric));
        (LYAPUNOV_EXPONENT) if StaticFriction =>
            Number(answer.limit.irregular().map(|motion| motion.lyapunov_exponent));
        (LYAPUNOV_EXPONENT_ERROR) if StaticFriction =>
            Number(answer.limit.irregular().map(|motion| motion.lyapunov_exponent_error));
        (TURNS_OBSERVED) if StaticFriction => Count(answer.limit.irregular().map(|motion| motion.turns));
    }

    /// The answer at these ratios; the peaks are searched for only on request.
    ///
    /// # Errors
    /// As for [`SteadyState::errors`] and [`SteadyState::peaks`].
    pub fn new(ratios: Ratios<F>, limit: &'a LongRun<F>, with_peaks: bool) -> Result<Self, Error> {
        let errors = limit.steady_state().map(SteadyState::errors).transpose()?;
        let peaks =
            if with_peaks { limit.peaks_while(&ratios, &mut || ControlFlow::Continue(()))? } else { None };
        Ok(Self { ratios, limit, seen: observed(ratios, limit), errors, peaks })
    }

    fn number(&self, output: SteadyOutput) -> Option<F> {
        let at_rest = || self.limit.rest_position().and_then(|x| output.at_rest(self.ratios, x));
        self.limit.steady_state().map(|steady| output.of(steady)).or_else(at_rest)
    }

    /// Over a cycle, over the observed turns of an irregular motion, or at rest.
    fn max_displacement(&self) -> Option<F> {
        let of_motion = self.limit.extrema().map(|(_, most)| most);
        of_motion.or_else(|| self.number(SteadyOutput::MaxDisplacement))
    }

    fn count(&self, of: fn(&SteadyState<F>) -> u32) -> Value<F> {
        Count(self.limit.steady_state().map(|steady| u64::from(of(steady))))
    }
}
