//! The values of an answer as columns, each with its definition.

use super::definitions::{
    BEST_FORCE_RATIO_SLIDES, DAMPER_WORK, MOTION_WITHOUT_STOP, MOVES_FROM_REST, REGIME, REVERSALS_PER_CYCLE,
};
use super::{Definition, Output};
use crate::cycle::Cycle;
use crate::cycle::response::Response;
use crate::float::Float;
use Value::{Count, Flag, Number, Text};

/// A value of an answer; `None` where it does not exist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value<F> {
    /// A number.
    Number(Option<F>),
    /// A count.
    Count(Option<u64>),
    /// A flag.
    Flag(Option<bool>),
    /// A text.
    Text(&'static str),
    /// Two complex numbers, each as its real and imaginary part.
    Pairs(Option<[(F, F); 2]>),
}

/// The machines for which an answer has a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum When {
    /// All.
    Always,
    /// Where damping was given.
    Damping,
    /// Where static friction was given.
    StaticFriction,
}

/// A value of an answer of type `A`.
#[derive(Debug)]
pub struct Column<A, F> {
    /// Its definition.
    pub definition: &'static Definition,
    /// The machines that have it.
    pub when: When,
    /// Its value.
    pub of: fn(&A) -> Value<F>,
}

/// Defines the columns of an answer from one row each: an output in brackets, which the answer's `number`
/// computes, or a definition with the machines that have it and its value.
macro_rules! columns {
    ($answer:ident; $($([$output:expr])? $(($definition:expr) $(if $when:ident)? => $value:expr)?;)*) => {
        /// Every column, in the order of the command.
        pub const COLUMNS: [Column<Self, F>; [$(columns!(@one $($output)? $($definition)?)),*].len()] = [$(
            Column {
                definition: $($output.definition())? $($definition)?,
                when: $(columns!(@when, $output))? $(columns!(@when $($when)?))?,
                of: |$answer| $(Number($answer.number($output)))? $($value)?,
            },
        )*];
    };
    (@one $of:expr) => { () };
    (@when $(, $output:expr)?) => { When::Always };
    (@when $when:ident) => { When::$when };
}
pub(crate) use columns;

/// A response as the columns of the command.
#[derive(Debug)]
pub struct ResponseAnswer<'a, F> {
    /// The response.
    pub response: &'a Response<F>,
    /// Whether outputs that need a search are requested.
    pub peaks: bool,
}

impl<F: Float> ResponseAnswer<'_, F> {
    columns! {
        answer;
        (REGIME) => Text(answer.response.regime.name());
        (MOTION_WITHOUT_STOP) if StaticFriction => Flag(Some(answer.response.has_motion_without_stop()));
        (MOVES_FROM_REST) if StaticFriction => Flag(Some(answer.response.ratios.moves_from_rest()));
        [Output::MaxDisplacement];
        [Output::DisplacementPhase];
        [Output::MaxVelocity];
        [Output::VelocityPhase];
        [Output::Deviation];
        [Output::MinForceRatio];
        [Output::MinForceRatioTurningPoint];
        // This value has more digits than the rounded cycle.
        (Output::LoopSizeStiffness.definition()) => Number(answer.response.loop_size_stiffness);
        (Output::LoopSizeInertia.definition()) => Number(answer.response.loop_size_inertia);
        [Output::BestForceRatio];
        [Output::BestLoopSize];
        [Output::Contraction];
        (REVERSALS_PER_CYCLE) => Count(answer.response.reversals_per_cycle().map(u64::from));
        (BEST_FORCE_RATIO_SLIDES) => Flag(Some(answer.response.best_is_reached()));
        [Output::DynamicAmplification];
        [Output::MaxAcceleration];
        [Output::TransmittedForce];
        [Output::Transmissibility];
        [Output::MaxAbsoluteDisplacement];
        [Output::MaxSpringForce];
        [Output::EquivalentDamping];
        [Output::EquivalentDampingRatio];
        [Output::EquivalentStiffness];
        [Output::EffectiveDampingRatio];
        (DAMPER_WORK) if Damping => Number(answer.response.cycle.as_ref().map(Cycle::damper_work));
    }

    fn number(&self, output: Output) -> Option<F> {
        let is_left_out = output.definition().is_searched && !self.peaks;
        if is_left_out { None } else { output.of(self.response) }
    }
}
