//! Bounds of a number that are known in addition to its ball.

use crate::float::Field;
use crate::float::Real;
use crate::float::ball::Ball;
use crate::float::mp::Mp;

/// A phase in (−2π, 2π) reduced to [0, 2π), where the reduction is certain.
pub(super) fn reduced<const W: usize>(phase: Ball<W>) -> Ball<W> {
    if phase.is_negative() { phase + Ball::pi() * Ball::int(2) } else { phase }
}

/// The nonnegative part of a ball, for a number that is known to be nonnegative.
pub(super) fn not_negative<const W: usize>(x: Ball<W>) -> Ball<W> {
    if x.is_entire() || !x.contains_zero() { x } else { Ball::between(Mp::ZERO, x.upper()) }
}
