//! A motion that does not become periodic.

use super::state::State;
use crate::float::Float;

/// A motion that was followed for many turns of the drive without becoming periodic, and whose neighbours do not approach it.
///
/// All of it is observed over the turns followed, after a quarter of them: no proof that the motion stays irregular for ever. Displacements in
/// units of B = r_y/k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Irregular<F> {
    pub(crate) state: State<F>,
    pub(crate) exponent: F,
    pub(crate) exponent_error: F,
    pub(crate) max_displacement: F,
    pub(crate) min_displacement: F,
    pub(crate) stops: u64,
    pub(crate) turns: u64,
    pub(crate) periods: F,
}

impl<F: Float> Irregular<F> {
    /// The greater Lyapunov exponent by turn of the drive: a small distance grows by `e^λ` in a turn, on average. From the exact linearised
    /// motion, by a disturbance that is carried along.
    pub const fn lyapunov_exponent(&self) -> F {
        self.exponent
    }

    /// Whether neighbours leave it exponentially: the exponent is above four times its standard error. Otherwise they neither leave nor approach
    /// it, as in a quasi-periodic motion.
    pub fn is_chaotic(&self) -> bool {
        self.exponent > F::int(4) * self.exponent_error
    }

    /// The standard error of that average, from the means of 32 parts of the time.
    pub const fn lyapunov_exponent_error(&self) -> F {
        self.exponent_error
    }

    /// The greatest displacement x/B that was met.
    pub const fn max_displacement(&self) -> F {
        self.max_displacement
    }

    /// The least displacement x/B that was met.
    pub const fn min_displacement(&self) -> F {
        self.min_displacement
    }

    /// Stops that were met.
    pub const fn stops(&self) -> u64 {
        self.stops
    }

    /// Turns of the drive over which exponent, extrema and stops were observed.
    pub const fn turns(&self) -> u64 {
        self.turns
    }

    /// Periods of the drive that were followed in all.
    pub const fn periods(&self) -> F {
        self.periods
    }

    /// The state reached in the end.
    pub const fn state(&self) -> State<F> {
        self.state
    }
}
