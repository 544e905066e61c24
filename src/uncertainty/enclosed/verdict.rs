//! What a proved range of the margin says of all motions of a box.

use super::parts::Ends;
use crate::error::Error;
use crate::float::Float;
use crate::regime::{Regime, Verdict};
use crate::uncertainty::Range;
use rug::Rational;

/// The verdict that holds for all ratios [Ω, α, ζ] of these intervals, by the range of the margin over the
/// box that they belong to.
///
/// # Errors
/// As for that range.
pub(super) fn by_margin<F: Float>(
    [omega, alpha, zeta]: [&Ends; 3],
    margin: impl FnOnce() -> Result<Option<Range<F>>, Error>,
) -> Result<Verdict<F>, Error> {
    let one = F::int(1);
    if alpha.1 <= 1 {
        return Ok(Verdict::AtRest);
    }
    let may_rest = alpha.0 <= 1;
    let below = if may_rest { Regime::Stuck } else { Regime::Sticking };
    let undecided = Ok(Verdict::Undecided(below, Regime::NonSticking));
    let Some(margin) = margin()? else { return undecided };
    if margin.low > one && !may_rest {
        let may_grow = zeta.0 == 0 && omega.0 <= 1 && omega.1 >= 1;
        let grows = Verdict::Undecided(Regime::NonSticking, Regime::Unbounded);
        return Ok(if may_grow { grows } else { Verdict::NonSticking });
    }
    if margin.high < one && !may_reverse_six_times(omega, zeta) {
        let sticks = Verdict::Undecided(Regime::Stuck, Regime::Sticking);
        return Ok(if may_rest { sticks } else { Verdict::Sticking });
    }
    undecided
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
