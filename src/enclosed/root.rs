//! A zero of a function in a ball, with a proof of existence and uniqueness: the interval Newton method.
//!
//! Let f be differentiable on a ball X around m. If the ball `N = m − f(m)/f′(X)` lies inside X, then f has
//! exactly one zero in X, and it lies in N (Moore, Kearfott and Cloud, *Introduction to Interval Analysis*,
//! SIAM 2009, theorem 8.4; in one dimension by the mean value theorem). If f depends on parameters given by
//! balls, this holds for all their values.
//!
//! The searches of `crate::root` give numbers without a proof. Under a record a zero is proved by certain signs on both
//! sides of it (`crate::motion::record`), which need no slope over a ball and hold where the slope vanishes.

use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;

/// The only zero of `f` near `start`, enclosed, and the ball in which it is the only one; `None` where this
/// is not proved.
pub(crate) fn only_zero<const W: usize>(
    start: Mp<W>,
    f: impl Fn(Ball<W>) -> Ball<W>,
    slope: impl Fn(Ball<W>) -> Ball<W>,
) -> Option<Ball<W>> {
    let mut start = Ball::exact(start);
    let (mut at_start, mut step) = (f(start), Ball::entire());
    // Newton's method on midpoints, until the step is no longer than the uncertainty of f. From where the slope is steeper than
    // at the zero, each step leaves a part of the way.
    for _ in 0..64 {
        step = at_start / slope(start);
        if Radius::above(step.mid()) <= step.rad().scaled(2) {
            break;
        }
        start = Ball::exact(start.mid() - step.mid());
        at_start = f(start);
    }
    // A margin for the change of the slope.
    let mut reach = Radius::above(step.mid()).plus(step.rad());
    for _ in 0..6 {
        reach = reach.scaled(2);
        if reach.is_zero() || reach.is_infinite() {
            // The zero is hit exactly, and any ball around it will do.
            reach = Radius::power_of_two(-i64::from(Mp::<W>::bits_now()));
        }
        let around = Ball::new(start.mid(), reach);
        let found = start - at_start / slope(around);
        if found.is_inside(&around) {
            return Some(found);
        }
    }
    None
}

/// The values of a function on a ball around m, by the mean value theorem: `f(m) + f′(X) (X − m)`.
pub(super) fn by_mean_value<const W: usize>(
    at: Ball<W>,
    f: impl FnOnce(Ball<W>) -> Ball<W>,
    slope: impl FnOnce(Ball<W>) -> Ball<W>,
) -> Ball<W> {
    let middle = Ball::exact(at.mid());
    f(middle) + slope(at) * (at - middle)
}
