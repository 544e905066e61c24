//! Sliding in one direction, in closed form (Hong & Liu 2001, section 3).
//!
//! In natural time `φ = ω_n(t − t_i)`, with `w = dx/dφ = Ω v` and the direction s = sgn v, the equation of
//! motion is `x″ + x + s = α sin(θ_i + Ωφ)`, and its solution from `(θ_i, x_i, w_i)`
//!
//! ```text
//! x − x_i = −(x_i + s)(1 − cos φ) + w_i sin φ + α [cos θ_i · S + sin θ_i · C]
//! w       = a_i sin φ + w_i cos φ + αΩ [cos θ_i · C − sin θ_i · S],      a_i = α sin θ_i − x_i − s
//! w′      = a_i cos φ − w_i sin φ + αΩ [cos θ_i · D − Ω sin θ_i · C]
//! C = (cos Ωφ − cos φ)/(1−Ω²),   S = (sin Ωφ − Ω sin φ)/(1−Ω²),   D = C′ = (sin φ − Ω sin Ωφ)/(1−Ω²)
//! ```
//!
//! The three quotients are 0/0 at Ω = 1. With `p = (1+Ω)φ/2`, `m = (1−Ω)φ/2` and `q = 2 sin m/(1−Ω)` they are
//!
//! ```text
//! C = sin p · q/(1+Ω),   D = [sin Ωφ + q cos p]/(1+Ω),
//! S = [sin Ωφ − Ω q cos p]/(1+Ω) = [sin φ − q cos p]/(1+Ω),
//! ```
//!
//! of which only q is a quotient of small numbers, both known to full relative accuracy; q(Ω = 1) = φ. The
//! first form of S is used below Ω = 1 and the second above, where each has no cancellation. The terms are
//! those that vanish with φ. A short slide is written as a power series (`short`), and a long one at a low
//! frequency as a slow and a fast wave.

pub(crate) mod equation;
mod foot;
pub(crate) mod motion;
pub(crate) mod short;
pub(crate) mod stick;
pub(crate) mod work;

use super::drive_phase::DrivePhase;
use super::state::PhasePoint;
use crate::float::Float;
use alloc::vec::Vec;
use equation::{Equation, Responses};
use motion::Motion;

/// The direction of sliding: the sign of the velocity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Direction {
    /// Towards larger x: friction is +r_y.
    Forward,
    /// Towards smaller x: friction is −r_y.
    Backward,
}

impl Direction {
    /// +1 or −1.
    #[inline]
    pub(crate) fn sign<F: Float>(self) -> F {
        F::int(match self {
            Self::Forward => 1,
            Self::Backward => -1,
        })
    }

    /// The direction of a number's sign; a zero counts as forward.
    #[inline]
    pub(crate) fn of<F: Float>(x: F) -> Self {
        if x < F::int(0) { Self::Backward } else { Self::Forward }
    }
}

/// One slide from `(θ_i, x_i, v_i)` in a given direction: a closed form in time.
///
/// The form holds as long as the velocity keeps its sign; [`crate::motion::Trajectory`] finds where it ends.
/// Displacements in units of B = r_y/k, velocities in B ω_d. Accuracy at f64: a few units in the last place
/// of the largest term, `|x_i| + |w_i| + α/|1 − Ω²|` (near Ω = 1, αφ for the last), times 1 + φ + Ωφ for the
/// rounding of the angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide<F> {
    pub(crate) equation: Equation<F>,
    pub(crate) start: DrivePhase<F>,
    pub(crate) direction: Direction,
    pub(crate) x: F,
    pub(crate) w: F,
    pub(crate) acceleration: F,
    sin_start: F,
    cos_start: F,
}

impl<F: Float> Equation<F> {
    /// `s(η − 1)`; +0 and not −0 where η = 1.
    #[inline]
    fn acceleration_at_release(&self, direction: Direction) -> F {
        F::int(0) + direction.sign::<F>() * self.static_excess()
    }
}

impl<F: Float> Slide<F> {
    /// The slide with a velocity `w = Ωv` that is not zero, or zero with the force above friction.
    #[inline]
    pub(crate) fn new(equation: Equation<F>, start: DrivePhase<F>, x: F, w: F, direction: Direction) -> Self {
        Self::with_sin_cos(equation, start, start.sin_cos(), x, w, direction)
    }

    /// The slide of [`Slide::new`] from known (sin θ_i, cos θ_i).
    #[inline]
    pub(crate) fn with_sin_cos(
        equation: Equation<F>,
        start: DrivePhase<F>,
        (sin_start, cos_start): (F, F),
        x: F,
        w: F,
        direction: Direction,
    ) -> Self {
        let acceleration = equation.alpha * sin_start - x - direction.sign::<F>() - equation.damping * w;
        Self { equation, start, direction, x, w, acceleration, sin_start, cos_start }
    }

    /// The slide that begins at rest with the force above friction, from known (sin θ_i, cos θ_i).
    #[inline]
    pub(crate) fn from_rest(
        equation: Equation<F>,
        start: DrivePhase<F>,
        (sin_start, cos_start): (F, F),
        x: F,
        direction: Direction,
    ) -> Self {
        let acceleration = equation.alpha * sin_start - x - direction.sign::<F>();
        Self { equation, start, direction, x, w: F::int(0), acceleration, sin_start, cos_start }
    }

    /// The slide that begins at rest with the force exactly at the static friction and rising: zero velocity
    /// and the acceleration `s(η − 1)`, whatever rounding makes of the difference.
    #[inline]
    pub(crate) fn released(equation: Equation<F>, start: DrivePhase<F>, x: F, direction: Direction) -> Self {
        let acceleration = equation.acceleration_at_release(direction);
        Self { acceleration, ..Self::new(equation, start, x, F::int(0), direction) }
    }

    /// A slide that continues after its velocity touches zero, with the force at the kinetic friction: it
    /// starts without acceleration.
    pub(crate) fn grazing(equation: Equation<F>, start: DrivePhase<F>, x: F, direction: Direction) -> Self {
        let zero = F::int(0);
        Self { acceleration: zero, ..Self::new(equation, start, x, zero, direction) }
    }

    /// Whether the slide begins at rest with the force at the static friction.
    pub(crate) fn begins_at_bound(&self) -> bool {
        self.w == F::int(0) && self.acceleration == self.equation.acceleration_at_release(self.direction)
    }

    /// (sin θ_i, cos θ_i).
    #[inline]
    pub(crate) const fn sin_cos_start(&self) -> (F, F) {
        (self.sin_start, self.cos_start)
    }

    /// The motion at natural time φ after the start.
    #[inline]
    pub(crate) fn motion(&self, phi: F) -> Motion<F> {
        if self.is_short(phi) {
            return self.short(phi);
        }
        if self.equation.is_damped() {
            return self.damped_motion(phi);
        }
        if self.is_long(phi) {
            return self.slow_and_fast(phi);
        }
        self.motion_of(&self.equation.undamped_waves(phi))
    }

    /// Apart from the undamped motion, whose waves then stay in registers.
    #[cold]
    #[inline(never)]
    fn damped_motion(&self, phi: F) -> Motion<F> {
        if self.is_long(phi) || self.has_forgotten(phi) {
            return self.forced_and_free(phi);
        }
        self.motion_of(&self.equation.damped_waves(phi))
    }

    /// Whether the motion is that of a slow wave and a fast one, which are best computed apart.
    #[inline]
    fn is_long(&self, phi: F) -> bool {
        self.equation.omega < F::ratio(1, 2) && phi > F::int(1)
    }

    /// The point of the motion at natural time φ.
    pub(crate) fn point(&self, phi: F) -> PhasePoint<F> {
        let motion = self.motion(phi);
        PhasePoint { phase: self.start.advanced(self.equation.omega * phi), x: motion.x, w: motion.w }
    }

    /// The motion from the functions of its natural time.
    #[inline]
    pub(crate) fn motion_of(&self, waves: &Responses<F>) -> Motion<F> {
        let Equation { omega, alpha, damping, .. } = self.equation;
        let Responses { free: (sine, cosine), versine, drive, c, s, d } = *waves;
        let (si, ci) = (self.sin_start, self.cos_start);
        let sign = self.direction.sign::<F>();
        let rate = alpha * omega;
        let travelled = self.w * sine - (self.x + sign) * versine + alpha * (ci * s + si * c);
        let w = self.acceleration * sine + self.w * cosine + rate * (ci * c - si * s);
        // The slope of the first free vibration is the second less 2ζ times itself.
        let falling = cosine - damping * sine;
        let acceleration = self.acceleration * falling - self.w * sine + rate * (ci * d - omega * si * c);
        Motion {
            x: self.x + travelled,
            w,
            acceleration,
            jerk: rate * (ci * drive.1 - si * drive.0) - w - damping * acceleration,
            force: alpha * (si * drive.1 + ci * drive.0),
            rotation: (sine, cosine),
        }
    }

    /// The motion as the sum of a slow forced wave and a fast free one, for Ω < 1/2 and φ > 1: the two waves of
    /// `forced_and_free` without a damper, which costs 6 % of a steady state less.
    ///
    /// ```text
    /// x = A sin θ − s + a cos φ + b sin φ,   a = −(a_i + Ω²A sin θ_i),   b = w_i − ΩA cos θ_i,   A = α/(1 − Ω²)
    /// ```
    ///
    /// The rounding of the fast angle, φ up to π/Ω, is then multiplied only by the amplitude of the fast
    /// wave.
    fn slow_and_fast(&self, phi: F) -> Motion<F> {
        let Equation { omega, alpha, .. } = self.equation;
        let (si, ci) = (self.sin_start, self.cos_start);
        let (sd, cd) = (omega * phi).sin_cos();
        let (sine, cosine) = phi.sin_cos();
        let (sin_theta, cos_theta) = (si * cd + ci * sd, ci * cd - si * sd);
        let amplitude = alpha / ((F::int(1) - omega) * (F::int(1) + omega));
        let a = -(self.acceleration + omega.square() * amplitude * si);
        let b = self.w - omega * amplitude * ci;
        let fast = a * cosine + b * sine;
        let w = omega * amplitude * cos_theta + b * cosine - a * sine;
        Motion {
            x: amplitude * sin_theta - self.direction.sign::<F>() + fast,
            w,
            acceleration: -(omega.square() * amplitude * sin_theta) - fast,
            jerk: alpha * omega * cos_theta - w,
            force: alpha * sin_theta,
            rotation: (sine, cosine),
        }
    }

    /// Whether a damped free vibration has decayed by a factor e since the start: x is then no longer
    /// computed as a change of the initial x.
    fn has_forgotten(&self, phi: F) -> bool {
        let free = self.equation.vibration();
        let rate = if free.swings() { free.zeta } else { free.slow_rate() };
        rate * phi > F::int(1)
    }

    /// The damped motion as the sum of the forced wave and a decaying free wave, for Ω < 1/2 and φ > 1, or
    /// once the free wave has decayed by a factor e.
    ///
    /// The sums give w and w′. The free waves also give x: `x_f + 2ζw_f + w_f′ = 0`.
    fn forced_and_free(&self, phi: F) -> Motion<F> {
        let Equation { omega, alpha, damping, .. } = self.equation;
        let (si, ci) = (self.sin_start, self.cos_start);
        let (sd, cd) = (omega * phi).sin_cos();
        let theta = (si * cd + ci * sd, ci * cd - si * sd);
        let (from, to) = (self.equation.forced((si, ci)), self.equation.forced(theta));
        let square = omega.square();
        let rotation = self.equation.free_waves(phi);
        let (w_free, a_free) =
            self.equation.freely(phi, rotation, (self.w - from.1, self.acceleration + square * from.0));
        let (w, acceleration) = (to.1 + w_free, a_free - square * to.0);
        Motion {
            x: to.0 - self.direction.sign::<F>() - (a_free + damping * w_free),
            w,
            acceleration,
            jerk: alpha * omega * theta.1 - w - damping * acceleration,
            force: alpha * theta.0,
            rotation,
        }
    }

    /// (w, w′) of the free vibration at natural time φ: the motion without the forced wave.
    pub(crate) fn free_motion(&self, phi: F) -> (F, F) {
        let (si, ci) = (self.sin_start, self.cos_start);
        let (sd, cd) = (self.equation.omega * phi).sin_cos();
        let (x, w) = self.equation.forced((si * cd + ci * sd, ci * cd - si * sd));
        let motion = self.motion(phi);
        (motion.w - w, motion.acceleration + self.equation.omega.square() * x)
    }

    /// Parts of [0, end] of which one has the greatest value, and one the least, of any sum of a constant, a multiple of
    /// `sin θ` and a free vibration, without damping: within 2π of a crest or a trough of sin θ, or of an end.
    ///
    /// Moved by 2π towards the crest, the free vibration is the same, and the multiple of sin θ not less.
    pub(crate) fn windows(&self, end: F) -> Vec<(F, F)> {
        let (turn, half) = (F::int(2) * F::pi(), F::pi() / F::int(2));
        let within = |(low, high): (F, F)| {
            let low = low.or_larger(F::int(0));
            (low, if high < end { high } else { end })
        };
        // A slide is shorter than two turns of the drive.
        let crests = [1, 3, 5, 7, 9, 11].map(|quarter| {
            let crest = (half * F::int(quarter) - self.start.reduced()) / self.equation.omega;
            (crest - turn, crest + turn)
        });
        let ends = [(F::int(0), turn), (end - turn, end)];
        crests.into_iter().chain(ends).map(within).filter(|(low, high)| low < high).collect()
    }

    /// `w″ = αΩ cos θ − w − 2ζw′` at the start.
    #[inline]
    pub(crate) fn jerk_at_start(&self) -> F {
        let Equation { omega, alpha, damping, .. } = self.equation;
        alpha * omega * self.cos_start - self.w - damping * self.acceleration
    }

    /// The greatest size of the terms of w, per unit of rounding.
    #[inline]
    pub(crate) fn velocity_scale(&self) -> F {
        let Equation { omega, alpha, damping, .. } = self.equation;
        // |C|, |S| ≤ 2/|1 − Ω²|; near Ω = 1, where φ ≤ 3π, they are ≤ φ.
        let gain = omega * alpha / (F::int(1) + omega.square());
        // The free vibration from (0, 1) is at most 1, and at most 1/2ζ.
        let acceleration = self.acceleration.abs() / F::int(1).or_larger(damping);
        acceleration + self.w.abs() + F::int(4) * gain
    }
}

#[cfg(test)]
mod tests;
