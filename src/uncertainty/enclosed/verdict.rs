//! What the side of 1 on which the margin is over a box says of all motions there.

use super::parts::Ends;
use crate::error::Error;
use crate::float::Float;
use crate::regime::{Regime, Verdict};
use rug::Rational;

/// The verdict that holds for all ratios [Ω, α, ζ] of these intervals; `is_above_one` tells whether the margin is above 1
/// over the whole box that they belong to, or below.
///
/// # Errors
/// Those of `is_above_one`.
pub(super) fn by_margin<F: Float>(
    [omega, alpha, zeta]: [&Ends; 3],
    is_above_one: impl FnOnce() -> Result<Option<bool>, Error>,
) -> Result<Verdict<F>, Error> {
    if alpha.1 <= 1 {
        return Ok(Verdict::AtRest);
    }
    let may_rest = alpha.0 <= 1;
    let below = if may_rest { Regime::Stuck } else { Regime::Sticking };
    Ok(match is_above_one()? {
        Some(true) if !may_rest => {
            let may_grow = zeta.0 == 0 && omega.0 <= 1 && omega.1 >= 1;
            let grows = Verdict::Undecided(Regime::NonSticking, Regime::Unbounded);
            if may_grow { grows } else { Verdict::NonSticking }
        }
        Some(false) if !may_reverse_six_times(omega, zeta) => {
            let sticks = Verdict::Undecided(Regime::Stuck, Regime::Sticking);
            if may_rest { sticks } else { Verdict::Sticking }
        }
        _ => Verdict::Undecided(below, Regime::NonSticking),
    })
}

/// Whether the frequency and damping ratios come within reach of a cycle of six reversals: 1/Ω less than 1/16
/// from an odd number, 3 or more, and ζ below 1/128 (`regime::no_stop`).
fn may_reverse_six_times(omega: &Ends, zeta: &Ends) -> bool {
    let reach = Rational::from((1, 16));
    let (from, to) =
        (Rational::from(omega.1.recip_ref()) - &reach, Rational::from(omega.0.recip_ref()) + reach);
    // The last odd number that is not above.
    let half: Rational = (to - 1u32) / 2u32;
    let last = half.floor() * 2u32 + 1u32;
    zeta.0 < Rational::from((1, 128)) && last >= 3 && last >= from
}
