//! Certificates that no event was missed: signs over whole intervals, by bisection until a ball proves them.
//!
//! Floats, which know a sign only at one time, conclude the same from the signs of the drive's power
//! (`crate::motion::event`).

use super::slide::{DrivenBody, SlideBall};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};

/// The greatest number of intervals before a sign is given up.
const MOST: usize = 4000;

/// Whether `holds` is true for every part of [low, high]; the intervals are tried in order.
fn throughout<const W: usize>(low: Mp<W>, high: Mp<W>, holds: impl Fn(Ball<W>) -> bool) -> bool {
    let mut left = vec![(low, high)];
    for _ in 0..MOST {
        let Some((low, high)) = left.pop() else { return true };
        if low >= high || holds(Ball::between(low, high)) {
            continue;
        }
        let middle = (low + high).scale2(-1);
        if middle <= low || middle >= high {
            return false;
        }
        left.push((middle, high));
        left.push((low, middle));
    }
    left.is_empty()
}

/// The other end of the longest interval [edge, edge + reach · 2⁻ⁿ] on which `holds` is true.
fn stretch<const W: usize>(edge: Mp<W>, reach: Mp<W>, holds: impl Fn(Ball<W>) -> bool) -> Option<Mp<W>> {
    (2..40).map(|n| edge + reach.scale2(-n)).find(|&other| {
        holds(if other > edge { Ball::between(edge, other) } else { Ball::between(other, edge) })
    })
}

/// Whether the velocity has the slide's sign from start to end, and no zero in between.
///
/// At the start the acceleration has the sign of the slide; where the acceleration is zero, at a release with
/// η = 1, its rate has that sign. At the end the acceleration has the opposite sign. Between these, the
/// velocity itself has the sign.
pub(super) fn is_one_slide<const W: usize>(slide: &SlideBall<W>, duration: &Ball<W>) -> bool {
    let (zero, low, high) = (Mp::ZERO, duration.lower(), duration.upper());
    let is_released = slide.start.sign() == Some(core::cmp::Ordering::Equal);
    let starts = |phi| {
        let at = slide.at(phi);
        (slide.sign * if is_released { at.jerk } else { at.acceleration }).is_positive()
    };
    let ends = |phi: Ball<W>| {
        (slide.sign * slide.at(phi.hull(&Ball::between(low, high))).acceleration).is_negative()
    };
    let (Some(first), Some(last)) = (stretch(zero, low, starts), stretch(low, -low, ends)) else {
        return false;
    };
    throughout(first, last, |phi| slide.keeps_moving(phi))
}

/// Whether a body at rest at `place` stays there from one phase until the release in the direction `sign` at
/// another.
///
/// The force α sin θ − x is monotone between the crests of the drive. So it is within the static friction throughout where
/// it is so at the start and at each crest, and where it rises to the static friction at the release.
pub(super) fn is_one_stop<const W: usize>(
    machine: &DrivenBody<W>,
    place: Ball<W>,
    from: Ball<W>,
    release: Ball<W>,
    sign: i32,
) -> bool {
    let holds = |force: Ball<W>| force.abs().is_below(&machine.eta);
    let rises = Ball::int(sign) * machine.alpha * release.cos();
    let mut crest = Ball::pi() / Ball::int(-2);
    let mut drive = -machine.alpha;
    if !(crest.is_below(&from) && rises.is_positive() && holds(machine.force(from, place))) {
        return false;
    }
    for _ in 0..MOST {
        if release.is_below(&crest) {
            return true;
        }
        if !(crest.is_below(&from) || holds(drive - place)) {
            return false;
        }
        (crest, drive) = (crest + Ball::pi(), -drive);
    }
    false
}

/// Whether the body slides back immediately in the direction `sign`: the force exceeds the static friction in
/// that direction.
pub(super) fn reverses<const W: usize>(
    machine: &DrivenBody<W>,
    place: Ball<W>,
    phase: Ball<W>,
    sign: i32,
) -> bool {
    machine.eta.is_below(&(Ball::int(sign) * machine.force(phase, place)))
}
