//! The greatest rate at which a system changes, which bounds the steps of its motions.

use super::System;
use super::assembly::Rule;
use super::branch::Branch;
use super::equation::{Equation, fastest};
use super::follow::most_steps;
use super::mode::Mode;
use super::pieces::Piece;
use crate::float::Float;
use alloc::vec::Vec;

impl<F: Float> System<F> {
    /// The number of steps after which a motion ends with [`Error::TooLong`](super::Error::TooLong), beside those at samples of
    /// records: some seconds of work, and the fewer the larger the state.
    #[must_use]
    pub fn most_steps(&self) -> u64 {
        most_steps(&self.assembly)
    }

    /// The number of steps of a motion in a unit of time, without events: the greatest over sliding in the steepest pieces of all
    /// laws, rising or falling, and over rest, with elastic contacts that hold and stops in touch, of the spectral radius of |A|, and at most 1 % above it. Frequencies of
    /// springs, rates of dampers and of steep laws, and frequencies of the loads are below it.
    ///
    /// Infinite or NaN where the numbers of the system overflow.
    #[must_use]
    pub fn steps_per_time(&self) -> F {
        let rate = |modes: &Vec<Mode>| fastest(&self.assembly, &Equation::new(&self.assembly, modes).a);
        let branches = self.extreme_branches();
        branches.iter().map(rate).fold(F::int(0), |most, rate| if rate <= most { most } else { rate })
    }

    /// Whether a motion of this length may have long steps, which its fast modes do not shorten: [`steps_per_time`](Self::steps_per_time) then does
    /// not tell how many there are.
    #[doc(hidden)]
    #[must_use]
    pub fn has_long_steps(&self, length: F) -> bool {
        let branch = |modes: &Vec<Mode>| Branch::new(&self.assembly, modes, [length; 2], [].iter());
        self.extreme_branches().iter().any(|modes| !branch(modes).splits.is_empty())
    }

    /// The modes in which entries of |A| are greatest.
    fn extreme_branches(&self) -> [Vec<Mode>; 4] {
        let system = &self.assembly;
        // The entries of |A| are greatest where a slope is greatest or least.
        let place = |pieces: &[Piece<F>], rises: bool| {
            let better =
                |a: &Piece<F>, b: &Piece<F>| if rises { a.slope > b.slope } else { a.slope < b.slope };
            let best = pieces.iter().enumerate().reduce(|a, b| if better(b.1, a.1) { b } else { a });
            best.map_or(0, |(place, _)| place)
        };
        let branches = [(true, true), (false, true), (true, false), (false, false)];
        let modes_of = |(slides, rises): (bool, bool)| {
            let mode = |rule: &Rule<F>| match rule {
                Rule::Contact { pieces, .. } if slides => {
                    Mode::Slides { forward: true, piece: place(pieces, rises) }
                }
                Rule::Contact { .. } => Mode::Stuck,
                Rule::Elastic { .. } => Mode::Holds,
                Rule::Stop { .. } => Mode::Pressed,
                Rule::Hard { .. } => Mode::Away,
                Rule::Spring { pieces } => Mode::Bends { piece: place(pieces, rises) },
            };
            system.parts.iter().map(|part| mode(&part.rule)).collect()
        };
        branches.map(modes_of)
    }
}
