//! Periodic motions by Newton's method on the period map, stable or not.

use super::attractors::at_zero;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::broken::Budget;
use crate::motion::limit::fixed_point::{Located, Trial, distance};
use crate::motion::limit::orbit::{Likeness, Orbit};
use crate::motion::limit::propagation::HalfTurns;
use crate::motion::limit::steady::SteadyState;
use crate::motion::slide::equation::Equation;
use crate::motion::state::{PhasePoint, State};
use crate::motion::trajectory::resolved;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::ControlFlow;

/// A periodic motion, found by a search.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "F: Float + serde::Serialize",
        deserialize = "F: Float + serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
#[must_use]
pub struct PeriodicMotion<F> {
    /// The motion; [`SteadyState::is_stable`] says whether its neighbours approach it.
    pub steady_state: SteadyState<F>,
    /// The index of the mirror image among the motions found; `None` if the motion is symmetric, or if the
    /// search did not find its image.
    pub mirror: Option<usize>,
    orbit: Orbit<F>,
}

/// The periodic motions that a search found, each once, in the order it met them.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicMotions<F> {
    found: Vec<PeriodicMotion<F>>,
}

impl<F: Float> PeriodicMotions<F> {
    /// An empty list; [`PeriodicMotions::add`] fills it.
    #[must_use]
    pub const fn new() -> Self {
        Self { found: Vec::new() }
    }

    /// The motions.
    pub fn found(&self) -> &[PeriodicMotion<F>] {
        &self.found
    }

    /// Adds a motion unless it is already present: two motions are the same if their states agree to within
    /// their distances from the limit.
    ///
    /// # Errors
    /// As for [`crate::motion::Trajectory::new`].
    pub fn add(&mut self, steady: SteadyState<F>) -> Result<(), Error> {
        let state = at_zero(&steady)?;
        let mut mirror = None;
        for (place, known) in self.found.iter().enumerate() {
            match known.orbit.compare(steady.half_turns(), &state) {
                Likeness::Same => return Ok(()),
                Likeness::Mirrored => mirror = Some(place),
                Likeness::Other => {}
            }
        }
        let place = self.found.len();
        if let Some(other) = mirror.and_then(|other| self.found.get_mut(other)) {
            other.mirror = Some(place);
        }
        let orbit = Orbit::of(steady.equation, steady.half_turns(), (state.at.x, state.at.w))?;
        self.found.push(PeriodicMotion { steady_state: steady, mirror, orbit });
        Ok(())
    }
}

impl<F: Float> Default for PeriodicMotions<F> {
    fn default() -> Self {
        Self::new()
    }
}

/// The periodic motions of up to `turns` turns of the drive that Newton's method finds from the starts:
/// **found by search, not proved complete**. Unlike [`crate::motion::attractors()`] the search also finds
/// unstable motions, to which no start tends.
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::{State, periodic_motions};
/// let ratios = Ratios::new(0.573f64, 3.92)?.with_damping_ratio(0.005)?.with_static_friction_ratio(1.87)?;
/// let starts = [(0.0, 0.0), (3.0, 0.0), (-5.0, 2.0)].map(|(x, v)| State::new(0.0, x, v));
/// let starts: Vec<_> = starts.into_iter().collect::<Result<_, _>>()?;
/// let all = periodic_motions(ratios, &starts, 1)?;
/// assert!(all.iter().any(|motion| motion.steady_state.is_stable()));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// As for [`crate::motion::Trajectory::new`].
pub fn periodic_motions<F: Float>(
    ratios: Ratios<F>,
    starts: &[State<F>],
    turns: u32,
) -> Result<Vec<PeriodicMotion<F>>, Error> {
    let mut all = PeriodicMotions::new();
    for start in starts {
        let found = periodic_motions_from(ratios, *start, turns, &mut || ControlFlow::Continue(()))?;
        found.into_iter().try_for_each(|steady| all.add(steady))?;
    }
    Ok(all.found)
}

/// The periodic motions of up to `turns` turns of the drive that Newton's method finds from one start, as
/// long as `keep_going` returns [`ControlFlow::Continue`]. A motion of several half turns can be returned
/// more than once.
///
/// Let H be half a turn of the drive with a change of sign. For each number m of half turns up to `2 turns`,
/// Newton's method on the map Hᵐ starts from the given state, from the states of its motion after each of the
/// first half turns, and from the state that repeats best after m half turns. The mirror image of an
/// asymmetric motion is returned with it. Steps that do not help are shortened, down to a sixteenth. A
/// returned motion repeats itself to within rounding, by the exact motion over its period, and has the
/// multipliers of the exact linearised motion.
///
/// # Errors
/// [`Error::Interrupted`] where `keep_going` ends the search, and as for [`crate::motion::Trajectory::new`].
pub fn periodic_motions_from<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    turns: u32,
    keep_going: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Vec<SteadyState<F>>, Error> {
    let equation = Equation::new(resolved(ratios)?);
    let mut found = Vec::new();
    // At α ≤ 1 the body comes to rest from every start.
    if ratios.alpha() <= F::int(1) {
        return Ok(found);
    }
    let budget = &mut Budget::of(0).while_allowed(keep_going);
    let most = turns.saturating_mul(2);
    let usual = F::pi() / equation.omega;
    let mut y = PhasePoint::of(&start, equation.omega);
    let mut path = vec![y];
    for _ in 0..most.saturating_mul(4).saturating_add(FOLLOWED) {
        let step = HalfTurns::new(equation, y, 1, usual, budget)?;
        if step.rest.is_some() {
            break;
        }
        y = step.end;
        path.push(y);
    }
    let mut states: Vec<Located<F>> = Vec::new();
    for m in 1..=most {
        for seed in path.iter().take(FIRST).chain(closest_return(&path, m)) {
            let trial = Trial::at(equation, *seed, m, budget)?.newton_from_far(budget)?;
            if trial.motion.rest.is_some() || !trial.is_periodic(64) {
                continue;
            }
            let motion = trial.earliest(64, budget)?;
            let state = motion.located();
            if states.iter().any(|known| known.agrees(&state)) {
                continue;
            }
            states.push(state);
            // H maps an asymmetric motion to its mirror image.
            let later = HalfTurns::new(equation, state.at, 1, usual, budget)?.end;
            let mirror = Trial::at(equation, later, motion.motion.m, budget)?.newton(budget)?;
            if motion.motion.m.is_multiple_of(2) && mirror.is_periodic(64) {
                states.push(mirror.located());
                found.push(mirror.steady(budget)?);
            }
            found.push(motion.steady(budget)?);
        }
    }
    Ok(found)
}

/// The number of half turns computed from a start, in addition to those of the longest period.
const FOLLOWED: u32 = 32;

/// The number of states at the beginning of the motion from which Newton's method starts.
const FIRST: usize = 8;

/// The state that returns closest to itself after m half turns.
fn closest_return<F: Float>(path: &[PhasePoint<F>], m: u32) -> Option<&PhasePoint<F>> {
    let later = path.iter().skip(usize::try_from(m).ok()?);
    let missed = path.iter().zip(later).map(|(y, back)| (y, distance(y, back)));
    missed.reduce(|best, next| if next.1 < best.1 { next } else { best }).map(|(y, _)| y)
}

#[cfg(test)]
mod tests;
