//! The values of an answer as columns, each with its definition.

use super::definitions::{
    BEST_FORCE_RATIO_SLIDES, DAMPER_WORK, MOTION_WITHOUT_STOP, MOVES_FROM_REST, REGIME, REVERSALS_PER_CYCLE,
};
use super::{Definition, Output};
use crate::float::Float;
use crate::nonsticking::Cycle;
use crate::oscillator::Excitation;
use crate::response::Response;

/// A value of an answer; `None` where it does not exist.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value<F> {
    Number(Option<F>),
    Count(Option<u64>),
    Flag(Option<bool>),
    Text(&'static str),
    /// Two complex numbers, each as its real and imaginary part.
    Pairs(Option<[(F, F); 2]>),
}

/// The machines for which an answer has a column.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum When {
    Always,
    /// Where damping was given.
    Damping,
    /// Where static friction was given.
    StaticFriction,
}

/// A value of an answer of type `A`.
#[doc(hidden)]
#[derive(Debug)]
pub struct Column<A, F> {
    pub definition: &'static Definition,
    pub when: When,
    pub of: fn(&A) -> Value<F>,
}

impl<A, F> Column<A, F> {
    pub(crate) const fn new(definition: &'static Definition, of: fn(&A) -> Value<F>) -> Self {
        Self { definition, when: When::Always, of }
    }

    /// A column for some machines.
    pub(crate) const fn only(when: When, definition: &'static Definition, of: fn(&A) -> Value<F>) -> Self {
        Self { definition, when, of }
    }
}

/// The column of an output that is a number, by the `number` of the answer.
macro_rules! number {
    ($output:expr) => {
        Column::new($output.definition(), |answer| Value::Number(answer.number($output)))
    };
}
pub(crate) use number;

/// A response with the excitation of its machine.
#[doc(hidden)]
#[derive(Debug)]
pub struct ResponseAnswer<'a, F> {
    pub response: &'a Response<F>,
    pub excitation: Excitation,
    /// Whether the outputs that need a search are wanted.
    pub peaks: bool,
}

#[doc(hidden)]
impl<F: Float> ResponseAnswer<'_, F> {
    /// Every column, in the order of the command.
    pub const COLUMNS: [Column<Self, F>; 23] = [
        Column::new(REGIME, |answer| Value::Text(answer.response.regime.name())),
        Column::only(When::StaticFriction, MOTION_WITHOUT_STOP, |answer| {
            Value::Flag(Some(answer.response.has_motion_without_stop()))
        }),
        Column::only(When::StaticFriction, MOVES_FROM_REST, |answer| {
            Value::Flag(Some(answer.response.ratios.moves_from_rest()))
        }),
        number!(Output::MaxDisplacement),
        number!(Output::DisplacementPhase),
        number!(Output::MaxVelocity),
        number!(Output::VelocityPhase),
        number!(Output::Deviation),
        number!(Output::MinForceRatio),
        number!(Output::TurningPointForceRatio),
        number!(Output::LoopSizeStiffness),
        number!(Output::LoopSizeInertia),
        number!(Output::BestForceRatio),
        number!(Output::BestLoopSize),
        number!(Output::Contraction),
        Column::new(REVERSALS_PER_CYCLE, |answer| {
            Value::Count(answer.response.reversals_per_cycle().map(u64::from))
        }),
        Column::new(BEST_FORCE_RATIO_SLIDES, |answer| Value::Flag(Some(answer.response.best_is_reached()))),
        number!(Output::DynamicAmplification),
        number!(Output::MaxAcceleration),
        number!(Output::TransmittedForce),
        number!(Output::Transmissibility),
        number!(Output::MaxAbsoluteDisplacement),
        Column::only(When::Damping, DAMPER_WORK, |answer| {
            Value::Number(answer.response.cycle.as_ref().map(Cycle::damper_work))
        }),
    ];

    /// An output. Where the spring's foot moves, the loads on the support are those of [`Excitation`].
    fn number(&self, output: Output) -> Option<F> {
        let response = self.response;
        if output.definition().is_searched && !self.peaks {
            return None;
        }
        let felt = |cycle: &Cycle<F>| {
            self.excitation.transmitted(&response.ratios, F::int(0), cycle.max_acceleration())
        };
        let cycle = response.cycle.as_ref();
        match output {
            // With more digits than those of a cycle that was rounded.
            Output::LoopSizeStiffness => response.loop_size_stiffness,
            Output::LoopSizeInertia => response.loop_size_inertia,
            Output::TransmittedForce if self.excitation.moves_foot() => cycle.map(|cycle| felt(cycle).0),
            Output::Transmissibility if self.excitation.moves_foot() => cycle.map(|cycle| felt(cycle).1),
            // The surface is fixed.
            Output::MaxAbsoluteDisplacement if self.excitation.moves_foot() => {
                cycle.map(|cycle| cycle.max_displacement.abs())
            }
            _ => output.of(response),
        }
    }
}
