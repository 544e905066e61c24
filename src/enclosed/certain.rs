//! What is known of a number besides its ball.

use crate::float::Field;
use crate::float::Real;
use crate::float::ball::Ball;
use crate::float::mp::Mp;

/// A phase in (−2π, 2π) reduced to [0, 2π), as far as it is certain.
pub(super) fn reduced<const W: usize>(phase: Ball<W>) -> Ball<W> {
    if phase.is_negative() { phase + Ball::pi() * Ball::int(2) } else { phase }
}

/// The part of a ball that is not negative, where it is known that the number is not.
pub(super) fn not_negative<const W: usize>(x: Ball<W>) -> Ball<W> {
    if x.is_entire() || !x.contains_zero() { x } else { Ball::between(Mp::ZERO, x.upper()) }
}
