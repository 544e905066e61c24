//! All limits that a set of starts leads to.
//!
//! With a static friction above the kinetic one a machine can have several limits, and the start determines
//! which one its motion tends to. Nothing here proves that the list is complete: the answer holds for the
//! starts that were followed.

mod signature;

use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::limit::fixed_point::Located;
use crate::motion::limit::long_run::LongRun;
use crate::motion::limit::orbit::{Likeness, Orbit};
use crate::motion::state::{PhasePoint, State};
use alloc::vec::Vec;
use core::ops::ControlFlow;
pub use signature::Signature;
pub(crate) use signature::at_zero;

/// A limit, and the number of starts that lead to it.
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
pub struct Attractor<F> {
    /// The limit, computed from the first of its starts.
    pub limit: LongRun<F>,
    /// The index of the first of its starts.
    pub first_start: usize,
    /// The number of starts that lead to this limit.
    pub starts: u64,
    /// The index of the mirror image of this limit; `None` if the limit is symmetric, or if no start led to
    /// its mirror image.
    pub mirror: Option<usize>,
    /// The lowest and the highest position of rest x/B, or middle of a member of a family, that was found;
    /// `None` for all other limits.
    pub range: Option<(F, F)>,
    /// The states of a periodic motion, which identify it.
    orbit: Option<Orbit<F>>,
}

/// The limits of a set of starts, each once, in the order of their first starts.
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
pub struct Attractors<F> {
    /// The limits.
    pub limits: Vec<Attractor<F>>,
    /// The index of the limit of each start; `None` where the start had not settled.
    pub of_start: Vec<Option<usize>>,
}

/// The limits to which the motion at (Ω, α, ζ, η) tends from the starts, each followed for at most `periods`
/// periods of the drive.
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::{State, attractors};
/// let ratios = Ratios::new(0.5f64, 4.0)?.with_damping_ratio(0.02)?.with_static_friction_ratio(1.3)?;
/// let starts = [(0.0, 0.0), (3.0, 0.0), (-3.0, 1.0)].map(|(x, v)| State::new(0.0, x, v));
/// let starts: Vec<_> = starts.into_iter().collect::<Result<_, _>>()?;
/// let found = attractors(ratios, &starts, 1000)?;
/// // A motion and its mirror image, one stop in each cycle.
/// assert_eq!(found.limits.len(), 2);
/// assert_eq!((found.limits[0].mirror, found.limits[1].mirror), (Some(1), Some(0)));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// As for [`crate::motion::Trajectory::new`].
pub fn attractors<F: Float>(
    ratios: Ratios<F>,
    starts: &[State<F>],
    periods: u32,
) -> Result<Attractors<F>, Error> {
    let limits: Result<Vec<_>, _> = starts
        .iter()
        .map(|start| LongRun::within(ratios, *start, periods, &mut || ControlFlow::Continue(())))
        .collect();
    Attractors::of_limits(limits?)
}

#[doc(hidden)]
impl<F: Float> Attractors<F> {
    /// Collects the limits of several starts that were followed elsewhere, for example on several threads.
    /// The limits are given in the order of the starts, and the answer does not depend on the threads.
    ///
    /// * Two periodic motions are the same limit if their states at one phase of the drive agree to within
    ///   their distances from the limit ([`crate::motion::SteadyState::distance`]).
    /// * All positions of rest are one limit, with the range that was found, and so are the members of a
    ///   family.
    /// * Two irregular motions are the same limit if their extrema agree to 1/32 of their range.
    ///
    /// # Errors
    /// As for [`crate::motion::Trajectory::new`].
    pub fn of_limits(limits: impl IntoIterator<Item = LongRun<F>>) -> Result<Self, Error> {
        let mut all = Self::new();
        limits.into_iter().try_for_each(|limit| all.add(limit))?;
        Ok(all)
    }

    /// The number of starts that had not settled.
    #[must_use]
    pub fn unsettled(&self) -> usize {
        self.of_start.iter().filter(|place| place.is_none()).count()
    }

    /// An empty list; [`Attractors::add`] fills it.
    pub const fn new() -> Self {
        Self { limits: Vec::new(), of_start: Vec::new() }
    }

    /// Counts the limit of the next start.
    ///
    /// # Errors
    /// As for [`Signature::of`].
    pub fn add(&mut self, limit: LongRun<F>) -> Result<(), Error> {
        let signature = Signature::of(&limit)?;
        if self.count(&signature) {
            return Ok(());
        }
        let place = self.limits.len();
        let mirror = self.limits.iter().rposition(|known| known.compare(&signature) == Likeness::Mirrored);
        let orbit = match (&limit, signature) {
            (LongRun::Periodic(steady), Signature::Periodic { half_turns, x, v, .. }) => {
                Some(Orbit::of(steady.equation, half_turns, (x, v * steady.equation.omega))?)
            }
            _ => None,
        };
        if let Some(other) = mirror.and_then(|other| self.limits.get_mut(other)) {
            other.mirror = Some(place);
        }
        let range = signature.middle().map(|x| (x, x));
        let first_start = self.of_start.len();
        self.limits.push(Attractor { limit, first_start, starts: 1, mirror, range, orbit });
        self.of_start.push(Some(place));
        Ok(())
    }

    /// The index of the limit with this signature, if it is among those found.
    pub fn place_of(&self, signature: &Signature<F>) -> Option<usize> {
        self.limits.iter().position(|known| known.compare(signature) == Likeness::Same)
    }

    /// Counts the next start by the signature of its limit, and returns whether it was counted: the limit
    /// must be among those found, or the start must not have settled. The signature represents a limit that
    /// was found earlier, for example by an interrupted run.
    pub fn count(&mut self, signature: &Signature<F>) -> bool {
        if matches!(signature, Signature::NotConverged) {
            self.of_start.push(None);
            return true;
        }
        let Some(place) = self.place_of(signature) else { return false };
        if let Some(known) = self.limits.get_mut(place) {
            known.starts = known.starts.saturating_add(1);
            known.widen(signature);
        }
        self.of_start.push(Some(place));
        true
    }
}

impl<F: Float> Default for Attractors<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F: Float> Attractor<F> {
    /// Compares the limit with a signature.
    fn compare(&self, signature: &Signature<F>) -> Likeness {
        match (&self.limit, signature) {
            (LongRun::Periodic(steady), &Signature::Periodic { half_turns, x, v, distance }) => {
                let omega = steady.equation.omega;
                let phase = DrivePhase::of_half_turn(0, F::int(0));
                let at = PhasePoint { phase, x, w: v * omega };
                let state = Located { at, off: (distance.0, distance.1 * omega) };
                self.orbit.as_ref().map_or(Likeness::Other, |orbit| orbit.compare(half_turns, &state))
            }
            (LongRun::Irregular(own), &Signature::Irregular { max_displacement, min_displacement }) => {
                alike((own.max_displacement, own.min_displacement), (max_displacement, min_displacement))
            }
            (LongRun::Family(_), Signature::Family { .. })
            | (LongRun::Rest(_), Signature::Rest { .. })
            | (LongRun::Unbounded { .. }, Signature::Unbounded) => Likeness::Same,
            _ => Likeness::Other,
        }
    }

    /// Extends the range to the position or middle of a limit.
    fn widen(&mut self, signature: &Signature<F>) {
        if let (Some((low, high)), Some(x)) = (self.range, signature.middle()) {
            self.range = Some((if x < low { x } else { low }, high.or_larger(x)));
        }
    }
}

/// Compares two irregular motions by their maximum and minimum displacements.
fn alike<F: Float>(own: (F, F), other: (F, F)) -> Likeness {
    let (most, least) = own;
    let room = (most - least) / F::int(32);
    let is_near = |a: F, b: F| (a - b).abs() <= room;
    if is_near(most, other.0) && is_near(least, other.1) {
        Likeness::Same
    } else if is_near(most, -other.1) && is_near(least, -other.0) {
        Likeness::Mirrored
    } else {
        Likeness::Other
    }
}

#[cfg(test)]
mod tests;
