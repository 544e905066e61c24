//! The greatest rate at which a system changes, which bounds the steps of its motions.

use super::System;
use super::assembly::Rule;
use super::equation::{Equation, Mode, fastest};
use super::follow::most_steps;
use crate::float::Float;
use alloc::vec::Vec;

impl<F: Float> System<F> {
    /// The number of steps after which a motion ends with [`Error::TooLong`](super::Error::TooLong), beside those at samples of
    /// records: some seconds of work, and the fewer the larger the state.
    #[must_use]
    pub fn most_steps(&self) -> u64 {
        most_steps(&self.assembly)
    }

    /// The number of steps of a motion in a unit of time, without events: the greatest over sliding in each piece of the
    /// laws and over rest, with elastic contacts that hold and stops in touch, of the spectral radius of |A|, and at most 1 % above it. Frequencies of
    /// springs, rates of dampers and of steep laws, and frequencies of the loads are below it.
    ///
    /// Infinite or NaN where the numbers of the system overflow.
    #[must_use]
    pub fn steps_per_time(&self) -> F {
        let system = &self.assembly;
        let count = system.parts.iter().map(|part| match &part.rule {
            Rule::Contact { pieces, .. } => pieces.len(),
            Rule::Elastic { .. } | Rule::Stop { .. } | Rule::Hard { .. } => 1,
        });
        // Each piece of the laws, and rest.
        let branches = (0..count.fold(1, usize::max)).map(Some).chain([None]);
        let rate = |piece: Option<usize>| {
            let mode = |rule: &Rule<F>| match (rule, piece) {
                (Rule::Contact { pieces, .. }, Some(piece)) => {
                    Mode::Slides { forward: true, piece: piece.min(pieces.len().saturating_sub(1)) }
                }
                (Rule::Contact { .. }, None) => Mode::Stuck,
                (Rule::Elastic { .. }, _) => Mode::Holds,
                (Rule::Stop { .. }, _) => Mode::Pressed,
                (Rule::Hard { .. }, _) => Mode::Away,
            };
            let modes: Vec<Mode> = system.parts.iter().map(|part| mode(&part.rule)).collect();
            fastest(system, &Equation::new(system, &modes).a)
        };
        branches.map(rate).fold(F::int(0), |most, rate| if rate <= most { most } else { rate })
    }
}
