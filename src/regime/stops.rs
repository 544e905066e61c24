//! How often the body stops in a cycle, by the exact motion.

use crate::error::Error;
use crate::exact::{LongRun, State};
use crate::float::Float;
use crate::ratios::Ratios;

/// What happens to the velocity in one cycle of the steady motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Stops {
    /// Stops that last: intervals at rest.
    pub sticks: u32,
    /// Instants at which the velocity comes to zero: the beginnings of stops, and reversals without one. 2 where it does not
    /// stick.
    pub velocity_zeros: u32,
}

/// The stops per cycle of the motion at (Ω, α) in the long run; `None` where there is no cycle: at rest (α ≤ 1), and at Ω = 1
/// above the border.
///
/// Of a family (Ω = 1/(2n)), those of the member that a start from rest leads to; they are the same for all members but for those at its
/// edge. The exact motion finds every stop, however short: beside the border [`crate::Place`] says whether the arithmetic can
/// tell at all.
///
/// There may be no stop although α is below the border, beside a pole 1/(2n+1): more than two velocity zeros tell
/// ([`crate::Verdict::Sticking`]).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::regime::stops_per_cycle;
/// let stops = |omega, alpha| Ok::<_, stickslip::Error>(stops_per_cycle(Ratios::new(omega, alpha)?)?.map(|s| (s.sticks, s.velocity_zeros)));
/// assert_eq!(stops(0.1, 3.0)?, Some((4, 4)));
/// assert_eq!(stops(0.4, 6.0)?, Some((2, 4))); // two of the zeros are reversals without a stop
/// assert_eq!(stops(0.4, 7.0)?, Some((0, 2)));
/// assert_eq!(stops(0.4, 0.9)?, None);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::NotSettled`] where the motion creeps for longer than [`crate::exact::DEFAULT_BUDGET`] periods, and as for
/// [`crate::exact::Trajectory::new`].
pub fn stops_per_cycle<F: Float>(ratios: Ratios<F>) -> Result<Option<Stops>, Error> {
    match LongRun::from_start(ratios, State::rest())? {
        LongRun::Periodic(steady) | LongRun::Family(steady) => Ok(Some(Stops {
            sticks: steady.sticks_per_cycle(),
            velocity_zeros: steady.velocity_zeros_per_cycle(),
        })),
        LongRun::Rest(_) | LongRun::Unbounded { .. } => Ok(None),
        LongRun::NotConverged { .. } => {
            Err(Error::NotSettled { omega: ratios.omega().to_string(), alpha: ratios.alpha().to_string() })
        }
    }
}
