//! The linear oscillator over half a period of the drive in balls: from its definition, with as many bits as its
//! cancellations cost, and without a damper from K(Ω). What floats compute in other forms ([`HalfPeriod::new`]), each
//! for digits at one precision.

pub(super) mod border;

use super::Known;
use super::angle::Angle;
use crate::cycle::damped::free::{Free, Waves};
use crate::cycle::damped::half_period::{Form, HalfPeriod};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use core::cmp::Ordering;

/// Free vibration with damping ratio ζ; without damping by exact numbers.
pub(super) fn free<const W: usize>(zeta: Ball<W>) -> Free<Ball<W>> {
    let one = Ball::int(1);
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    if is_undamped { Free { zeta, square: one, frequency: one } } else { Free::new(zeta) }
}

/// The half period; without a damper K may have the opposite sign.
pub(crate) fn half_period<const W: usize>(
    angle: &Angle<W>,
    zeta: &Known,
    eta: &Known,
) -> HalfPeriod<Ball<W>> {
    let (one, two, omega, zeta) = (Ball::int(1), Ball::int(2), angle.omega, zeta.ball::<W>());
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    let free = free(zeta);
    let period = Ball::pi() / omega;
    let decay = if is_undamped { one } else { (-(zeta * period)).exp() };
    let Waves { cosine, sine } = free.waves(period);
    let one_minus_square = angle.one_minus_square;
    let stiffness =
        if is_undamped { one_minus_square.abs() } else { (two * zeta * omega).hypot(one_minus_square) };
    let (shift, h, k) = if is_undamped {
        (Ball::int(0), angle.sin_cos.0 / (omega * angle.sin_cos.1), angle.phase_function)
    } else {
        // e^{−ζT} times N, and times sinh ζT
        let (n, hyperbolic) = ((one + decay.square()) / two + cosine, (one - decay.square()) / two);
        let h = sine / (omega * n);
        ((hyperbolic - zeta * sine) / n, h, stiffness * h)
    };
    let half = HalfPeriod {
        omega,
        inverse: one / omega,
        free,
        period,
        one_minus_square,
        stiffness,
        shift,
        h,
        k,
        rest: [Ball::int(0); 3],
        form: Form::Definition,
        parts: [Ball::int(0); 3],
        decay,
        cosine,
        sine,
        static_friction: Ball::int(1),
        // The ball itself shows the cancellation in both parts.
        is_resonant: false,
    };
    half.with_static_friction(eta.ball())
}
