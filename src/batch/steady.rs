//! The exact steady state at many points.

use crate::cycle::Cycle;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::{LongRun, State};

/// The steady state that is reached from rest at (Ω, α).
///
/// Where a single periodic motion attracts all starts and does not stick, it is taken from the closed form,
/// which is more accurate than the motion from rest.
pub(crate) fn steady(omega: f64, alpha: f64) -> Result<LongRun<f64>, Error> {
    let ratios = Ratios::new(omega, alpha)?;
    if let Some(cycle) = Cycle::find(ratios)
        && let Ok(found @ LongRun::Periodic(_)) = LongRun::try_from(&cycle)
    {
        return Ok(found);
    }
    LongRun::from_start(ratios, State::default())
}
