//! The stops in a cycle of the exact motion.

use super::{NoStop, observed};
use crate::error::{Error, written};
use crate::exact::{LongRun, State};
use crate::float::Float;
use crate::nonsticking::Border;
use crate::ratios::Ratios;

/// Stops and velocity zeros in one cycle of the steady motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Stops {
    /// The number of stops of finite duration.
    pub sticks: u32,
    /// The number of instants at which the velocity becomes zero: the beginnings of stops, and reversals
    /// without a stop. It is 2 where the body does not stick.
    pub velocity_zeros: u32,
}

/// The stops per cycle of the steady motion at (Ω, α); `None` where there is no cycle: at rest (α ≤ 1), and
/// at Ω = 1 above the border.
///
/// For a family (Ω = 1/(2n)), these are the stops of the member that a start from rest leads to. They are the
/// same for all members except those at its edge. Next to a border, a stop shorter than the accuracy of the
/// motion is an error, not a count ([`observed()`]).
///
/// With a static friction above the kinetic one, the motion can depend on the start; this is an error.
///
/// Near a pole 1/(2n+1) there may be no stop although α is below the border: then there are six velocity
/// zeros ([`crate::Verdict::SixReversals`]).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::stops_per_cycle;
/// let stops = |omega, alpha| Ok::<_, stickslip::Error>(stops_per_cycle(Ratios::new(omega, alpha)?)?.map(|s| (s.sticks, s.velocity_zeros)));
/// assert_eq!(stops(0.1, 3.0)?, Some((4, 4)));
/// assert_eq!(stops(0.4, 6.0)?, Some((2, 4))); // two of the zeros are reversals without a stop
/// assert_eq!(stops(0.4, 7.0)?, Some((0, 2)));
/// assert_eq!(stops(0.4, 0.9)?, None);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::Undecided`] where a stop, or the clearance without one, is below the accuracy of the motion;
/// [`Error::StaticFriction`] where η > 1; [`Error::NotSettled`] where the motion creeps for longer than
/// [`crate::exact::DEFAULT_BUDGET`] periods; and as for [`crate::exact::Trajectory::new`].
pub fn stops_per_cycle<F: Float>(ratios: Ratios<F>) -> Result<Option<Stops>, Error> {
    let limit = LongRun::from_start(ratios.with_one_friction()?, State::default())?;
    if limit.steady_state().is_some() && observed(ratios, &limit).by_border {
        let alpha = ratios.alpha();
        let away = |x: &F| (*x - alpha).abs();
        let border = Border::of(&ratios).min_force_ratio;
        let edges = NoStop::of(&ratios);
        let all = edges.intervals().flat_map(|(low, high)| [Some(low), high]).flatten();
        let nearest = all.fold(border, |best, x| if away(&x) < away(&best) { x } else { best });
        let (alpha, omega) = (written(alpha), written(ratios.omega()));
        return Err(Error::Undecided { alpha, least: written(nearest), omega });
    }
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => Ok(Some(Stops {
            sticks: steady.sticks_per_cycle,
            velocity_zeros: steady.velocity_zeros_per_cycle,
        })),
        LongRun::Rest(_) | LongRun::Unbounded { .. } => Ok(None),
        LongRun::Irregular(_) | LongRun::NotConverged { .. } => {
            Err(Error::NotSettled { omega: written(ratios.omega()), alpha: written(ratios.alpha()) })
        }
    }
}
