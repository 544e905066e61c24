//! One slide from rest, in closed form.
//!
//! In natural time, units of B, with σ the sign of the velocity and θ = θ₀ + Ωφ:
//!
//! ```text
//! x″ + 2ζx′ + x + σ = α sin θ,   x = P sin θ + Q cos θ − σ + f(φ),   f″ + 2ζf′ + f = 0,
//! (P, Q) = α (1 − Ω², −2ζΩ)/q²,   q² = (1 − Ω²)² + (2ζΩ)².
//! ```
//!
//! The free vibration f is that of the closed forms ([`Free`]), below, at and above ζ = 1. Floats write the same motion
//! in forms that keep their digits where forced and free vibration nearly cancel (`crate::motion::slide`), in place of
//! which balls take more bits.

use crate::cycle::damped::free::{Free, Waves};
use crate::enclosed::damped::{after, free};
use crate::enclosed::root::only_zero;
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};

/// The oscillator and its drive.
#[derive(Clone, Copy)]
pub(super) struct DrivenBody<const W: usize> {
    pub(super) omega: Ball<W>,
    pub(super) alpha: Ball<W>,
    pub(super) zeta: Ball<W>,
    /// The ratio η of static to kinetic friction.
    pub(super) eta: Ball<W>,
    free: Free<Ball<W>>,
    /// (P, Q).
    forced: (Ball<W>, Ball<W>),
}

impl<const W: usize> DrivenBody<W> {
    pub(super) fn new(omega: Ball<W>, alpha: Ball<W>, zeta: Ball<W>, eta: Ball<W>) -> Self {
        let one = Ball::int(1);
        let (detuning, damper) = ((one - omega) * (one + omega), zeta * omega * Ball::int(2));
        let scale = alpha / (detuning.square() + damper.square());
        Self { omega, alpha, zeta, eta, free: free(zeta), forced: (scale * detuning, -(scale * damper)) }
    }

    /// The force that friction must balance, α sin θ − x.
    pub(super) fn force(&self, phase: Ball<W>, place: Ball<W>) -> Ball<W> {
        self.alpha * phase.sin() - place
    }

    /// The phase near `guess` at which a body at rest is released in the direction σ: α sin θ = x + ση, with
    /// increasing force. The arcsine of floats, from a product of two sums (`crate::motion::slide::stick`), would be
    /// wider over intervals.
    pub(super) fn release(&self, guess: Mp<W>, place: Ball<W>, sign: Ball<W>) -> Option<Ball<W>> {
        let bound = sign * self.eta;
        only_zero(guess, |phase| self.force(phase, place) - bound, |phase| self.alpha * phase.cos())
    }
}

/// Displacement, velocity, acceleration and rate of acceleration, in natural time.
#[derive(Clone, Copy)]
pub(super) struct MotionBall<const W: usize> {
    pub(super) x: Ball<W>,
    pub(super) w: Ball<W>,
    pub(super) acceleration: Ball<W>,
    pub(super) jerk: Ball<W>,
}

/// A slide from rest.
#[derive(Clone, Copy)]
pub(super) struct SlideBall<const W: usize> {
    machine: DrivenBody<W>,
    pub(super) sign: Ball<W>,
    pub(super) phase: Ball<W>,
    /// The acceleration at the start: σ(η − 1) at a release.
    pub(super) start: Ball<W>,
    /// (f, f′) at the start.
    free: (Ball<W>, Ball<W>),
}

/// The end of a slide, and its derivatives with respect to phase and place of the start.
#[derive(Clone, Copy)]
pub(super) struct SlideEnd<const W: usize> {
    /// Duration in natural time.
    pub(super) duration: Ball<W>,
    pub(super) phase: Ball<W>,
    pub(super) place: Ball<W>,
    /// [[∂θ₁/∂θ₀, ∂θ₁/∂x₀], [∂x₁/∂θ₀, ∂x₁/∂x₀]].
    pub(super) derivatives: [[Ball<W>; 2]; 2],
}

impl<const W: usize> SlideBall<W> {
    /// The slide in the direction σ = ±1 from a phase and a place; `released` means that the force equals the
    /// static friction.
    pub(super) fn new(
        machine: DrivenBody<W>,
        sign: i32,
        phase: Ball<W>,
        place: Ball<W>,
        released: bool,
    ) -> Self {
        let sign = Ball::int(sign);
        let (s, c) = phase.sin_cos();
        let (p, q) = machine.forced;
        let free = (place + sign - (p * s + q * c), -(machine.omega * (p * c - q * s)));
        let start =
            if released { sign * (machine.eta - Ball::int(1)) } else { machine.alpha * s - place - sign };
        Self { machine, sign, phase, start, free }
    }

    /// Each derivative is that of the driven part and that of the free one: by the equation of motion it would be a
    /// difference of forces that are nearly equal, over an interval of time of a slow drive.
    pub(super) fn at(&self, phi: Ball<W>) -> MotionBall<W> {
        let DrivenBody { omega, free, forced: (p, q), .. } = self.machine;
        let (s, c) = (self.phase + omega * phi).sin_cos();
        let f = after(&free, phi, self.free.0, self.free.1);
        let (along, across, square) = (p * s + q * c, omega * (p * c - q * s), omega.square());
        MotionBall {
            x: along - self.sign + f.x,
            w: across + f.v,
            acceleration: f.a - square * along,
            jerk: f.jerk - square * across,
        }
    }

    /// Whether the velocity has the direction of the slide over an interval of time: by the mean value theorem about its
    /// middle, or where many free vibrations are shorter than the driven one by their sizes alone.
    pub(super) fn keeps_moving(&self, phi: Ball<W>) -> bool {
        let (over, middle) = (self.at(phi), Ball::exact(phi.mid()));
        let near = || self.at(middle).w + over.acceleration * (phi - middle);
        (self.sign * over.w).is_positive() || (self.sign * near()).is_positive()
    }

    /// The velocity zero near `guess`, with its derivatives.
    pub(super) fn end(&self, guess: Mp<W>) -> Option<SlideEnd<W>> {
        let duration = only_zero(guess, |phi| self.at(phi).w, |phi| self.at(phi).acceleration)?;
        let DrivenBody { omega, zeta, free, .. } = self.machine;
        let (at, Waves { cosine, sine: s }) = (self.at(duration), free.waves(duration));
        // The responses after the time φ: to a unit of velocity, place s and velocity s′; to a unit of place,
        // c.
        let (change, c) = (cosine - zeta * s, cosine + zeta * s);
        // ∂w/∂θ₀ and ∂w/∂x₀ at a fixed time. A start at a later phase gives the same motion later, minus the
        // contribution of its own start.
        let (by_phase, by_place) = ((at.acceleration - self.start * change) / omega, -s);
        let (later_by_phase, later_by_place) = (-(by_phase / at.acceleration), -(by_place / at.acceleration));
        let derivatives =
            [[Ball::int(1) + omega * later_by_phase, omega * later_by_place], [-(self.start * s / omega), c]];
        Some(SlideEnd { duration, phase: self.phase + omega * duration, place: at.x, derivatives })
    }
}
