//! The matching equations 21–25 for any damping ratio, by the equation of motion and no closed form.
//!
//! In natural time and lengths of the drive's static displacement, with `F(θ) = P sin θ − Q cos θ` the linear
//! oscillator's answer (`P = (1 − Ω²)/q²`, `Q = 2ζΩ/q²`), friction b and the free vibrations s, c from (x,
//! x′) = (0, 1) and (1, 0), the rising half cycle is
//!
//! ```text
//! x₁ = F − b + X c(τ) + ρ s(τ),   X = Δ₁ + b − F(θ₁),   ρ = V₀ − F′(θ₁),   τ = (θ − θ₁)/Ω
//! ```
//!
//! from t₁ on, and the falling one from t₂ on `x₂ = F + b + (Δ₀ − b − F(θ₂)) c − F′(θ₂) s`. Eq. 21–25 are
//! then
//!
//! ```text
//! x₁′(t₂) = 0,   x₂′(t₃) = −V₀,   x₁(t₂) = Δ₀,   x₂(t₃) = −Δ₁,   x₁″(t₁) = 0,
//! ```
//!
//! the second and the fourth being the paper's, followed forward from t₂ to t₃ = t₁ + π/ω_d and not backward,
//! where a free vibration would grow.

use super::{Unknowns, pi_1};
use crate::cycle::damped::free::{self, Free};
#[cfg(feature = "matching")]
use crate::float::Float;
use crate::float::{Field, Real, Signed};

/// The parameters of the equations; lengths are in units of p₀/k.
#[derive(Debug, Clone, Copy)]
pub struct System<F> {
    pub(super) omega: F,
    pub(super) free: Free<F>,
    /// P and Q.
    pub(super) forced: (F, F),
    /// b = r_y/p₀.
    pub(super) friction: F,
}

/// The free vibrations (s, c) from (0, 1) and (1, 0) at one time, and the slope of s.
#[derive(Clone, Copy)]
pub(super) struct SlopeWaves<F> {
    pub(super) s: F,
    pub(super) c: F,
    pub(super) slope: F,
}

impl<F: Field> SlopeWaves<F> {
    /// From `e^{−ζt} cos dt` and `e^{−ζt} sin(dt)/d`.
    fn of(at: free::Waves<F>, zeta: F) -> Self {
        let turned = zeta * at.sine;
        Self { s: at.sine, c: at.cosine + turned, slope: at.cosine - turned }
    }

    /// Displacement, velocity and acceleration from (x, w).
    pub(super) fn from(&self, (x, w): (F, F), damping: F) -> [F; 3] {
        let (to, rate) = (x * self.c + w * self.s, w * self.slope - x * self.s);
        [to, rate, -(to + damping * rate)]
    }
}

impl<F: Real> System<F> {
    /// The equations at Ω and ζ, with the friction r_y/p₀.
    pub fn new(omega: F, zeta: F, friction: F) -> Self {
        let (spring, damper) = ((F::int(1) - omega) * (F::int(1) + omega), F::int(2) * zeta * omega);
        let square = spring.square() + damper.square();
        Self { omega, free: Free::new(zeta), forced: (spring / square, damper / square), friction }
    }

    pub(super) fn damping(&self) -> F {
        F::int(2) * self.free.zeta
    }

    /// F and F′ at θ.
    pub(super) fn forced_at(&self, theta: F) -> (F, F) {
        let ((sine, cosine), (p, q)) = (theta.sin_cos(), self.forced);
        (p * sine - q * cosine, self.omega * (p * cosine + q * sine))
    }

    /// The free vibrations after a time.
    pub(super) fn after(&self, time: F, waves: impl Fn(&Free<F>, F) -> free::Waves<F>) -> SlopeWaves<F> {
        SlopeWaves::of(waves(&self.free, time), self.free.zeta)
    }
}

impl<N: Signed> System<N> {
    /// Eq. 21–25: left less right.
    pub fn residuals(&self, u: &Unknowns<N>) -> [N; 5] {
        let (f1, g1) = self.forced_at(u.velocity_phase);
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let tau = (u.displacement_phase - u.velocity_phase) / self.omega;
        let (near, far) = (self.after(tau, Free::waves), self.after(pi_1(self.omega) - tau, Free::waves));
        let [x, w, _] = near.from((u.deviation + self.friction - f1, u.max_velocity - g1), self.damping());
        let [y, v, _] = far.from((u.max_displacement - self.friction - f2, -g2), self.damping());
        [
            g2 + w,
            v - g1 + u.max_velocity,
            f2 - self.friction + x - u.max_displacement,
            self.friction - f1 + y + u.deviation,
            u.velocity_phase.sin() - u.deviation - self.friction - self.damping() * u.max_velocity,
        ]
    }

    /// Displacement and velocity of the falling half at the phase since t₂.
    pub fn falling(&self, u: &Unknowns<N>, turn: N) -> (N, N) {
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let start = (u.max_displacement - self.friction - f2, -g2);
        let (f, g) = self.forced_at(u.displacement_phase + turn);
        let [x, w, _] = self.after(turn / self.omega, Free::waves).from(start, self.damping());
        (f + self.friction + x, g + w)
    }
}

#[cfg(feature = "matching")]
impl<F: Float> System<F> {
    /// The largest of the lengths in the equations.
    pub(super) fn largest_term(&self, u: &Unknowns<F>) -> F {
        let amplitude = self.forced.0.hypot(self.forced.1);
        let parts = [F::int(1), amplitude, u.max_displacement, u.max_velocity, self.omega * amplitude];
        parts.into_iter().fold(self.friction, F::or_larger)
    }
}
