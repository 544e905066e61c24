//! The greatest value of a smooth function on an interval, by branch and bound: parts that cannot contain the
//! maximum are discarded, until each remaining part has one stationary point, proved and enclosed.
//!
//! The search of floats (`crate::greatest`) has another text: it takes the bounds on a part from what is known of the
//! function, where balls evaluate the function on the part, and it ends at rounding, where balls prove a maximum.

use super::root::{by_mean_value, only_zero};
use crate::float::Field;
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::greatest::Jet;
use core::cmp::Ordering;

/// The greatest number of parts before the search gives up.
const MOST: usize = 1500;

/// A greatest value.
pub(super) struct Greatest<const W: usize> {
    pub(super) value: Ball<W>,
    /// Its place; `None` where several places may have it.
    pub(super) at: Option<Ball<W>>,
}

/// The greatest value of f on an interval at whose ends f is zero, and inside which f is positive somewhere.
pub(super) fn greatest<const W: usize>(
    range: (Mp<W>, Mp<W>),
    f: impl Fn(Ball<W>) -> Jet<Ball<W>>,
) -> Option<Greatest<W>> {
    search(&[(range, false)], &[], |t, _| f(t))
}

/// The greatest |f| over intervals. The gaps between them are skipped because the maximum is known to lie in
/// one of the intervals, at a stationary point, or at one of the `ends`.
pub(super) fn greatest_size<const W: usize>(
    ranges: &[(Mp<W>, Mp<W>)],
    ends: &[Ball<W>],
    f: impl Fn(Ball<W>) -> Jet<Ball<W>>,
) -> Option<Ball<W>> {
    let both: Vec<_> = ranges.iter().flat_map(|range| [(*range, false), (*range, true)]).collect();
    let signed = |t, is_negated| {
        let jet = f(t);
        let Jet { value, slope, second } = jet;
        if is_negated { Jet { value: -value, slope: -slope, second: -second } } else { jet }
    };
    search(&both, ends, signed).map(|found| found.value)
}

/// The greatest value over several parts, each with or without a change of sign.
fn search<const W: usize>(
    parts: &[((Mp<W>, Mp<W>), bool)],
    ends: &[Ball<W>],
    f: impl Fn(Ball<W>, bool) -> Jet<Ball<W>>,
) -> Option<Greatest<W>> {
    let mut found: Vec<_> = ends.iter().map(|end| (f(*end, false).value.abs(), *end)).collect();
    let mut best = Mp::<W>::ZERO;
    let reached = |best: Mp<W>, value: Mp<W>| if value > best { value } else { best };
    for (value, _) in &found {
        best = reached(best, value.lower());
    }
    // Attained values, to discard parts that are certainly smaller.
    for ((low, high), sign) in parts {
        for i in 1..48 {
            let t = Ball::exact(*low + (*high - *low) * Mp::of_int(i) / Mp::of_int(48));
            best = reached(best, f(t, *sign).value.lower());
        }
    }
    let mut left = parts.to_vec();
    let mut count = 0;
    while let Some(((low, high), sign)) = left.pop() {
        count += 1;
        if count > MOST {
            return None;
        }
        let part = Ball::between(low, high);
        let (middle, over) = (Ball::exact(part.mid()), f(part, sign));
        let (at_middle, step) = (f(middle, sign), part - middle);
        // Bounds by the mean value theorem and by Taylor's.
        let straight = (at_middle.value + over.slope * step).upper();
        let bent = at_middle.value + at_middle.slope * step + over.second * step.square() / Ball::int(2);
        if straight < best || bent.upper() < best {
            continue;
        }
        match over.second.sign() {
            // Convex: the value is greatest at an end.
            Some(Ordering::Greater) => continue,
            Some(Ordering::Less) => {
                let zero = only_zero(part.mid(), |t| f(t, sign).slope, |t| f(t, sign).second);
                if let Some(zero) = zero
                    && zero.upper() >= low
                    && zero.lower() <= high
                {
                    // Concave: the value is greatest at the zero of the slope, or at an end that lies in the
                    // same ball.
                    let zero = if zero.lower() < low { zero.hull(&Ball::exact(low)) } else { zero };
                    let zero = if zero.upper() > high { zero.hull(&Ball::exact(high)) } else { zero };
                    let value = by_mean_value(zero, |t| f(t, sign).value, |t| f(t, sign).slope);
                    best = reached(best, value.lower());
                    found.push((value, zero));
                    continue;
                }
            }
            _ => {}
        }
        if over.slope.sign().is_some_and(|sign| sign != Ordering::Equal) {
            // The value is greater at an end, which belongs to a neighbour or is an end of the whole
            // interval.
            continue;
        }
        let middle = (low + high).scale2(-1);
        if middle <= low || middle >= high {
            return None;
        }
        left.push(((middle, high), sign));
        left.push(((low, middle), sign));
    }
    found.retain(|(value, _)| value.upper() >= best);
    let (first, others) = found.split_first()?;
    let value = others.iter().fold(first.0, |value, other| value.larger(&other.0));
    // There is one place if all balls overlap.
    let is_one = others.iter().all(|other| other.1.intersection(&first.1).is_some());
    let at = is_one.then(|| others.iter().fold(first.1, |at, other| at.hull(&other.1)));
    Some(Greatest { value, at })
}
