//! The exact steady state at many points.

use crate::error::Error;
use crate::exact::{LongRun, State, SteadyState};
use crate::nonsticking::Cycle;
use crate::ratios::Ratios;

/// What the motion from rest at (Ω, α) tends to.
///
/// Where there is one periodic motion for all starts, and it does not stick, from the closed form, which is
/// closer than rest.
pub(crate) fn steady(omega: f64, alpha: f64) -> Result<LongRun<f64>, Error> {
    let ratios = Ratios::new(omega, alpha)?;
    if let Some(cycle) = Cycle::find(ratios)
        && let Ok(found @ LongRun::Periodic(_)) = SteadyState::from_cycle(&cycle)
    {
        return Ok(found);
    }
    LongRun::from_start(ratios, State::default())
}
