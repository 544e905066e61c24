//! The states of a periodic motion at the phases nπ of the drive, which identify it.

use super::fixed_point::{Located, Trial};
use super::propagation::HalfTurns;
use crate::float::Float;
use crate::machine::error::Error;
use crate::motion::broken::Budget;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;
use alloc::vec::Vec;

/// The relation between two motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Likeness {
    Same,
    /// The mirror image: the opposite sign, half a turn of the drive later.
    Mirrored,
    Other,
}

/// The states of a cycle at the phases nπ, with the opposite sign at odd n.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "F: Float + serde::Deserialize<'de>")))]
pub(crate) struct Orbit<F> {
    states: Vec<Located<F>>,
}

impl<F: Float> Orbit<F> {
    /// The states of a motion that repeats after `count` half turns, from one of them: x/B and x′ in B ω_n.
    ///
    /// # Errors
    /// As for [`HalfTurns::new`].
    pub(crate) fn of(equation: Equation<F>, count: u32, (x, w): (F, F)) -> Result<Self, Error> {
        let budget = &mut Budget::of(0);
        let mut y = PhasePoint { phase: DrivePhase::of_half_turn(0, F::int(0)), x, w };
        let usual = F::pi() / equation.omega;
        let mut states = Vec::new();
        for _ in 0..count {
            states.push(Trial::at(equation, y, count, budget)?.located());
            y = HalfTurns::new(equation, y, 1, usual, budget)?.end;
        }
        Ok(Self { states })
    }

    /// Compares the motion with a motion that has the state `state` and repeats after `half_turns` half
    /// turns.
    pub(crate) fn compare(&self, half_turns: u32, state: &Located<F>) -> Likeness {
        if self.states.len() as u64 != u64::from(half_turns) {
            return Likeness::Other;
        }
        match self.states.iter().position(|known| known.agrees(state)) {
            // Every second state of a motion that is not symmetric is on its mirror image.
            Some(place) if half_turns % 2 == 1 || place % 2 == 0 => Likeness::Same,
            Some(_) => Likeness::Mirrored,
            None => Likeness::Other,
        }
    }
}
