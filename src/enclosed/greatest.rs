//! The greatest value of a smooth function on an interval, by branch and bound: parts that cannot contain the
//! maximum are discarded, until each remaining part has one stationary point, proved and enclosed. Over intervals of its
//! parameters the function itself is known to a width only; the search ends where the parts are as sharp as that.
//!
//! The search of floats (`crate::greatest`) has another text: it takes the bounds on a part from what is known of the
//! function, where balls evaluate the function on the part, and it ends at rounding, where balls prove a maximum.

use super::root::{by_mean_value, only_zero};
use crate::float::Field;
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::greatest::Jet;
use core::cmp::Ordering;

/// The number of parts after which the search is content with the bounds that it has.
const MOST: usize = 1500;

/// A greatest value.
pub(super) struct Greatest<const W: usize> {
    pub(super) value: Ball<W>,
    /// Its place, or between the places that may have it; `None` where that is unknown.
    pub(super) at: Option<Ball<W>>,
}

/// The greatest value of f on an interval at whose ends f is zero, and inside which f is positive somewhere.
pub(super) fn greatest<const W: usize>(
    range: (Mp<W>, Mp<W>),
    f: impl Fn(Ball<W>) -> Jet<Ball<W>>,
) -> Option<Greatest<W>> {
    search(&[range], &[false], &[], |t, _| f(t))
}

/// The greatest |f| over intervals. The gaps between them are skipped because the maximum is known to lie in
/// one of the intervals, at a stationary point, or at one of the `ends`.
pub(super) fn greatest_size<const W: usize>(
    ranges: &[(Mp<W>, Mp<W>)],
    ends: &[Ball<W>],
    f: impl Fn(Ball<W>) -> Jet<Ball<W>>,
) -> Option<Ball<W>> {
    let signed = |t, is_negated| {
        let jet = f(t);
        let Jet { value, slope, second } = jet;
        if is_negated { Jet { value: -value, slope: -slope, second: -second } } else { jet }
    };
    search(ranges, &[false, true], ends, signed).map(|found| found.value)
}

/// A part of an interval.
struct Part<const W: usize> {
    ends: (Mp<W>, Mp<W>),
    sign: bool,
    /// The function over the part.
    over: Jet<Ball<W>>,
    /// No value of the part is greater.
    upper: Mp<W>,
    /// One value of the part is not smaller.
    attained: Mp<W>,
    /// How far the function is uncertain at one place.
    blur: Radius,
}

impl<const W: usize> Part<W> {
    fn new(ends: (Mp<W>, Mp<W>), sign: bool, f: &impl Fn(Ball<W>, bool) -> Jet<Ball<W>>) -> Self {
        let part = Ball::between(ends.0, ends.1);
        let middle = Ball::exact(part.mid());
        let (over, at_middle, step) = (f(part, sign), f(middle, sign), part - middle);
        // By the sizes of the terms, where the part has many of their waves, by the mean value theorem and by Taylor's.
        let straight = at_middle.value + over.slope * step;
        let bent = at_middle.value + at_middle.slope * step + over.second * step.square() / Ball::int(2);
        let upper = [straight, bent].into_iter().map(|bound| bound.upper());
        let upper = upper.fold(over.value.upper(), |least, upper| if upper < least { upper } else { least });
        Self { ends, sign, over, upper, attained: at_middle.value.lower(), blur: at_middle.value.rad() }
    }
}

/// Takes out the part that may have the greatest value.
fn most_promising<const W: usize>(parts: &mut Vec<Part<W>>) -> Option<Part<W>> {
    let greater = |a: &Part<W>, b: &Part<W>| a.upper.partial_cmp(&b.upper).unwrap_or(Ordering::Equal);
    let (first, _) = parts.iter().enumerate().max_by(|(_, a), (_, b)| greater(a, b))?;
    Some(parts.swap_remove(first))
}

/// The greatest value over several ranges, without and with a change of sign.
fn search<const W: usize>(
    ranges: &[(Mp<W>, Mp<W>)],
    signs: &[bool],
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
    for (low, high) in ranges {
        for i in 1..48 {
            let t = Ball::exact(*low + (*high - *low) * Mp::of_int(i) / Mp::of_int(48));
            let value = f(t, false).value;
            best = reached(best, if signs.len() > 1 { value.abs() } else { value }.lower());
        }
    }
    let (mut left, mut count) = (Vec::new(), 0);
    let examine = |ends: (Mp<W>, Mp<W>), sign: bool, best: &mut Mp<W>, left: &mut Vec<Part<W>>| {
        let part = Part::new(ends, sign, &f);
        *best = reached(*best, part.attained);
        if part.upper >= *best {
            left.push(part);
        }
    };
    for ends in ranges {
        for sign in signs {
            examine(*ends, *sign, &mut best, &mut left);
        }
    }
    // The most promising part first.
    while let Some(Part { ends: (low, high), sign, over, upper, blur, .. }) = most_promising(&mut left) {
        count += 1;
        if upper < best {
            break;
        }
        let middle = (low + high).scale2(-1);
        match over.second.sign() {
            // Convex: the value is greatest at an end.
            Some(Ordering::Greater) => continue,
            Some(Ordering::Less) => {
                let zero = only_zero(middle, |t| f(t, sign).slope, |t| f(t, sign).second);
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
        // No part left has a greater value.
        if count > MOST || middle <= low || middle >= high || upper - best <= blur.scaled(1).value() {
            let places = left.iter().filter(|part| part.upper >= best).map(|part| part.ends);
            let place =
                places.fold(Ball::between(low, high), |all, (low, high)| all.hull(&Ball::between(low, high)));
            found.push((Ball::between(best, upper), place));
            break;
        }
        examine((low, middle), sign, &mut best, &mut left);
        examine((middle, high), sign, &mut best, &mut left);
    }
    found.retain(|(value, _)| value.upper() >= best);
    let (first, others) = found.split_first()?;
    let value = others.iter().fold(first.0, |value, other| value.larger(&other.0));
    let at = others.iter().fold(first.1, |at, other| at.hull(&other.1));
    Some(Greatest { value, at: (!at.is_entire()).then_some(at) })
}
