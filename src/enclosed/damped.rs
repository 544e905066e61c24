//! The linear oscillator over half a period of the drive in balls: from its definition, with as many bits as its
//! cancellations cost, and without a damper from K(Ω). What floats compute in other forms ([`HalfPeriod::new`]), each
//! for digits at one precision.

pub(super) mod border;

use super::Known;
use super::angle::Angle;
use crate::cycle::damped::free::{Free, FreeState, Waves};
use crate::cycle::damped::half_period::{Form, HalfPeriod};
use crate::cycle::damped::rising::Moment;
use crate::float::ball::{Ball, Radius};
use crate::float::{Field, Real};
use core::cmp::Ordering;

/// Free vibration with damping ratio ζ; without damping by exact numbers.
pub(super) fn free<const W: usize>(zeta: Ball<W>) -> Free<Ball<W>> {
    let one = Ball::int(1);
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    if is_undamped { Free { zeta, square: one, frequency: one } } else { Free::new(zeta) }
}

/// The free vibration from (x₀, v₀) at all times of a ball.
///
/// Over many waves by their energy: (x² + x′²)/2 decreases, and so for every derivative. Far above ζ = 1 as two exponentials,
/// whose derivatives the equation of motion would give as differences of numbers that are nearly equal.
pub(super) fn after<const W: usize>(
    free: &Free<Ball<W>>,
    time: Ball<W>,
    x0: Ball<W>,
    v0: Ball<W>,
) -> FreeState<Ball<W>> {
    let d = free.frequency;
    if free.square.is_negative() && Ball::ratio(1, 2).is_below(&d) {
        let (slow, fast) = (free.slow_rate(), free.zeta + d);
        let share = |rate: Ball<W>| (v0 + rate * x0) / (d * Ball::int(2));
        let wave = |rate: Ball<W>| (-(rate * time)).exp();
        let (mut a, mut b) = (share(fast) * wave(slow), -(share(slow) * wave(fast)));
        let mut next = || {
            let sum = a + b;
            (a, b) = (-(slow * a), -(fast * b));
            sum
        };
        return FreeState { x: next(), v: next(), a: next(), jerk: next(), snap: next() };
    }
    if time.rad() < Radius::ONE {
        return free.after(free.waves(time), x0, v0);
    }
    let first = Ball::exact(time.lower());
    let FreeState { x, v, a, jerk, snap } = free.after(free.waves(first), x0, v0);
    let within = |size: Ball<W>| Ball::between(-size.upper(), size.upper());
    let next = jerk + snap * free.zeta * Ball::int(2);
    FreeState {
        x: within(x.hypot(v)),
        v: within(v.hypot(a)),
        a: within(a.hypot(jerk)),
        jerk: within(jerk.hypot(snap)),
        snap: within(snap.hypot(next)),
    }
}

/// The half cycle at all times of a ball, but for its waves.
pub(super) fn moment<const W: usize>(half: &HalfPeriod<Ball<W>>, tau: Ball<W>) -> Moment<Ball<W>> {
    let free = after(&half.free, tau, Ball::int(1) + half.shift, half.omega * half.h);
    let waves = Waves { cosine: Ball::entire(), sine: Ball::entire() };
    Moment { tau, drive: (half.omega * tau).sin_cos(), waves, free }
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
