//! The states of a periodic motion at the phases nπ of the drive, which identify it.

use super::drive::DrivePhase;
use super::propagation::follow;
use super::shooting::Budget;
use super::state::Point;
use super::steady::SteadyState;
use crate::error::Error;
use crate::float::Float;

/// How one motion is like another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Likeness {
    Same,
    /// The mirror image: the opposite sign, half a turn of the drive later.
    Mirrored,
    Other,
}

/// The states of a cycle at the phases nπ, with the opposite sign at odd ones.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Orbit<F> {
    omega: F,
    states: Vec<Point<F>>,
}

impl<F: Float> Orbit<F> {
    /// From one of them on, x/B and x′/(Bω_d).
    ///
    /// # Errors
    /// As for [`follow`].
    pub(crate) fn of(steady: &SteadyState<F>, (x, v): (F, F)) -> Result<Self, Error> {
        let (equation, omega) = (steady.equation, steady.equation.omega);
        let mut y = Point { phase: DrivePhase::of_half_turn(0, F::int(0)), x, w: v * omega };
        let usual = F::pi() / omega;
        let mut states = Vec::new();
        for _ in 0..steady.half_turns() {
            states.push(y);
            let (end, _) = follow(equation, y, 1, usual, &mut Budget::of(0), |_| Ok(()))?;
            y = Point { phase: y.phase, x: -end.x, w: -end.w };
        }
        Ok(Self { omega, states })
    }

    /// Compares the motion with one that has this state and repeats after this number of half turns: they are
    /// the same if their states agree to 2⁻²⁰ of their size.
    pub(crate) fn compare(&self, half_turns: u32, (x, v): (F, F)) -> Likeness {
        if self.states.len() as u64 != u64::from(half_turns) {
            return Likeness::Other;
        }
        let w = v * self.omega;
        let size = F::int(1) + x.abs() + w.abs();
        let is_here = |p: &Point<F>| (p.x - x).hypot(p.w - w) <= F::exp2i(-20) * size;
        match self.states.iter().position(is_here) {
            // Every second state of a motion that is not symmetric is on its mirror image.
            Some(place) if half_turns % 2 == 1 || place % 2 == 0 => Likeness::Same,
            Some(_) => Likeness::Mirrored,
            None => Likeness::Other,
        }
    }
}
