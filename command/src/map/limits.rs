//! The limits of a machine from several starts.

use crate::attractors::{reach, start};
use crate::failure::Failure;
use crate::starts::follow;
use stickslip::Ratios;
use stickslip::motion::{Attractors, LongRun};
use stickslip_front::limits::PERIODS;

/// The number of starts for each point, which are those of `stickslip attractors`.
pub(super) const STARTS: u64 = 16;

const ONE: &str = "one, symmetric";
const PAIR: &str = "a mirror pair";
const SEVERAL: &str = "several";
const IRREGULAR: &str = "irregular among them";

/// The kinds of limits, from the lightest colour to the darkest; others are appended.
pub(super) const NAMES: [&str; 4] = [ONE, PAIR, SEVERAL, IRREGULAR];

/// A description of the limits of the [`STARTS`] starts; a motion and its mirror image count once.
pub(super) fn described(ratios: Ratios<f64>) -> Result<&'static str, Failure> {
    let reach = reach(None, &ratios)?;
    let limits = (0..STARTS)
        .map(|number| follow(ratios, start(number, reach)?, PERIODS))
        .collect::<Result<Vec<_>, _>>()?;
    let all = Attractors::of_limits(limits).map_err(|e| e.to_string())?;
    if all.limits.iter().any(|found| matches!(found.limit, LongRun::Irregular(_))) {
        return Ok(IRREGULAR);
    }
    let is_first = |place: usize, mirror: Option<usize>| mirror.is_none_or(|mirror| place < mirror);
    let mut single = all.limits.iter().enumerate().filter(|(place, found)| is_first(*place, found.mirror));
    Ok(match (single.next(), single.next()) {
        (Some(_), Some(_)) => SEVERAL,
        (Some((_, found)), None) => {
            let limit = found.limit;
            let is_periodic = matches!(limit, LongRun::Periodic(_));
            match limit.steady_state().filter(|_| is_periodic).map(|s| s.is_symmetric) {
                Some(true) => ONE,
                Some(false) => PAIR,
                None => limit.name(),
            }
        }
        (None, _) => "not settled",
    })
}
