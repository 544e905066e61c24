//! The linear oscillator over half a period of the drive, and its free vibration, in balls.
//!
//! The half period ([`HalfPeriod`]) is computed from its definition, with as many bits as its cancellations
//! cost, and without a damper from K(Ω).

pub(super) mod border;

use super::Known;
use super::angle::Angle;
use crate::cycle::Unknowns;
use crate::cycle::damped::free::{Free, Waves};
use crate::cycle::damped::half_period::{Form, HalfPeriod};
use crate::cycle::damped::rising::Moment;
use crate::cycle::equations::System;
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use core::cmp::Ordering;

/// e^{−ζt} cos dt and e^{−ζt} sin(dt)/d, below, at and above ζ = 1; the whole line where the sign of 1 − ζ is
/// undecided.
pub(crate) fn waves<const W: usize>(free: &Free<Ball<W>>, t: Ball<W>) -> Waves<Ball<W>> {
    let half = Ball::ratio(1, 2);
    match free.square.sign() {
        Some(Ordering::Greater) => {
            let (s, c) = (free.frequency * t).sin_cos();
            if free.zeta.sign() == Some(Ordering::Equal) {
                return Waves { cosine: c, sine: s / free.frequency };
            }
            let decay = (-(free.zeta * t)).exp();
            Waves { cosine: decay * c, sine: decay * (s / free.frequency) }
        }
        Some(Ordering::Equal) => {
            let decay = (-t).exp();
            Waves { cosine: decay, sine: decay * t }
        }
        Some(Ordering::Less) => {
            let (slow, gap) = ((-(free.slow_rate() * t)).exp(), (-(free.frequency * t * Ball::int(2))).exp());
            let one = Ball::int(1);
            Waves { cosine: slow * (one + gap) * half, sine: slow * (one - gap) * half / free.frequency }
        }
        None => Waves { cosine: Ball::entire(), sine: Ball::entire() },
    }
}

impl<const W: usize> System<Ball<W>> {
    /// Eq. 21–25 in balls: left less right.
    #[must_use]
    pub fn residuals_of_balls(&self, u: &Unknowns<Ball<W>>) -> [Ball<W>; 5] {
        self.residuals_by(u, waves)
    }

    /// [`System::falling`] in balls.
    #[must_use]
    pub fn falling_of_balls(&self, u: &Unknowns<Ball<W>>, turn: Ball<W>) -> (Ball<W>, Ball<W>) {
        self.falling_by(u, turn, waves)
    }
}

/// Free vibration with damping ratio ζ; without damping by exact numbers.
pub(super) fn free<const W: usize>(zeta: Ball<W>) -> Free<Ball<W>> {
    let one = Ball::int(1);
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    if is_undamped { Free { zeta, square: one, frequency: one } } else { Free::new(zeta) }
}

/// The state of the half cycle at a time.
pub(crate) fn moment<const W: usize>(half: &HalfPeriod<Ball<W>>, tau: Ball<W>) -> Moment<Ball<W>> {
    let waves = waves(&half.free, tau);
    let free = half.free.after(waves, Ball::int(1) + half.shift, half.omega * half.h);
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
    let Waves { cosine, sine } = waves(&free, period);
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
