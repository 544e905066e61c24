//! The matching equations 21–25 with viscous damping, by the equation of motion and no closed form.
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

use super::Unknowns;
use crate::cycle::damped::free::{self, Free};
use crate::float::{Field, Float, Real};

/// The parameters of the equations; lengths are in units of p₀/k.
#[derive(Debug, Clone, Copy)]
pub struct System<F> {
    omega: F,
    free: Free<F>,
    /// P and Q.
    forced: (F, F),
    /// b = r_y/p₀.
    friction: F,
}

/// The free vibrations (s, c) from (0, 1) and (1, 0) at one time, and the slope of s.
#[derive(Clone, Copy)]
struct Waves<F> {
    s: F,
    c: F,
    slope: F,
}

impl<F: Field> Waves<F> {
    /// From `e^{−ζt} cos dt` and `e^{−ζt} sin(dt)/d`.
    fn of(at: free::Waves<F>, zeta: F) -> Self {
        let turned = zeta * at.sine;
        Self { s: at.sine, c: at.cosine + turned, slope: at.cosine - turned }
    }

    /// Displacement, velocity and acceleration from (x, w).
    fn from(&self, (x, w): (F, F), damping: F) -> [F; 3] {
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

    fn damping(&self) -> F {
        F::int(2) * self.free.zeta
    }

    /// F and F′ at θ.
    fn forced_at(&self, theta: F) -> (F, F) {
        let ((sine, cosine), (p, q)) = (theta.sin_cos(), self.forced);
        (p * sine - q * cosine, self.omega * (p * cosine + q * sine))
    }

    /// Eq. 21–25: left less right, and the derivatives by t₁, t₂, V₀, Δ₀, Δ₁; by free vibration after a time.
    pub(crate) fn equations_by(
        &self,
        u: &Unknowns<F>,
        waves: impl Fn(&Free<F>, F) -> free::Waves<F>,
    ) -> ([F; 5], [[F; 5]; 5]) {
        let (zero, one, omega, damping) = (F::int(0), F::int(1), self.omega, self.damping());
        let (f1, g1) = self.forced_at(u.velocity_phase);
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let tau = (u.displacement_phase - u.velocity_phase) / omega;
        let after = |t: F| Waves::of(waves(&self.free, t), self.free.zeta);
        let (near, far) = (after(tau), after(F::pi() / omega - tau));
        // From t₁ to t₂, with the influence of t₁ on the start: F′ = dF/dφ, dθ = Ω dφ.
        let [x, w, a] = near.from((u.deviation + self.friction - f1, u.max_velocity - g1), damping);
        let [dx1, dw1, _] = near.from((-(g1 / omega), omega * f1), damping);
        // From t₂ to t₃, with the influence of t₂.
        let [y, v, b] = far.from((u.max_displacement - self.friction - f2, -g2), damping);
        let [dy2, dv2, _] = far.from((-(g2 / omega), omega * f2), damping);
        let (sine, cosine) = u.velocity_phase.sin_cos();
        let residuals = [
            g2 + w,
            v - g1 + u.max_velocity,
            f2 - self.friction + x - u.max_displacement,
            self.friction - f1 + y + u.deviation,
            sine - u.deviation - self.friction - damping * u.max_velocity,
        ];
        let jacobian = [
            [dw1 - a / omega, a / omega - omega * f2, near.slope, zero, -near.s],
            [b / omega + omega * f1, dv2 - b / omega, one, -far.s, zero],
            [dx1 - w / omega, (g2 + w) / omega, near.s, -one, near.c],
            [(v - g1) / omega, dy2 - v / omega, zero, far.c, one],
            [cosine, zero, -damping, zero, -one],
        ];
        (residuals, jacobian)
    }

    /// Displacement and velocity of the falling half at the phase since t₂, by free vibration after a time.
    pub(crate) fn falling_by(
        &self,
        u: &Unknowns<F>,
        turn: F,
        waves: impl Fn(&Free<F>, F) -> free::Waves<F>,
    ) -> (F, F) {
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let start = (u.max_displacement - self.friction - f2, -g2);
        let (f, g) = self.forced_at(u.displacement_phase + turn);
        let after = Waves::of(waves(&self.free, turn / self.omega), self.free.zeta);
        let [x, w, _] = after.from(start, self.damping());
        (f + self.friction + x, g + w)
    }
}

impl<F: Float> System<F> {
    /// Eq. 21–25: left less right, and the derivatives by t₁, t₂, V₀, Δ₀, Δ₁.
    pub fn equations(&self, u: &Unknowns<F>) -> ([F; 5], [[F; 5]; 5]) {
        self.equations_by(u, Free::waves)
    }

    /// Displacement and velocity of the falling half at the phase since t₂.
    pub fn falling(&self, u: &Unknowns<F>, turn: F) -> (F, F) {
        self.falling_by(u, turn, Free::waves)
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

    /// This system at f64.
    pub(super) fn to_f64(self) -> System<f64> {
        System::new(self.omega.to_f64(), self.free.zeta.to_f64(), self.friction.to_f64())
    }
}

#[cfg(feature = "matching")]
impl<F: Float> super::start::Equations<F> for System<F> {
    fn omega(&self) -> F {
        self.omega
    }

    fn friction(&self) -> F {
        self.friction
    }

    fn with_friction(self, friction: F) -> Self {
        Self { friction, ..self }
    }

    /// `x = F`.
    fn without_friction(&self) -> Unknowns<F> {
        let (p, q) = self.forced;
        let (lag, amplitude) = (q.atan2(p), p.hypot(q));
        Unknowns {
            velocity_phase: lag,
            displacement_phase: lag + F::pi() / F::int(2),
            max_velocity: self.omega * amplitude,
            max_displacement: amplitude,
            deviation: F::int(0),
        }
    }

    fn equations(&self, u: &Unknowns<F>) -> ([F; 5], [[F; 5]; 5]) {
        self.equations_by(u, Free::waves)
    }

    /// The falling half is the rising one with the opposite sign, half a turn later.
    fn rising(&self, u: &Unknowns<F>, phase: F) -> (F, F) {
        let (x, w) = self.falling(u, phase - (u.displacement_phase - F::pi()));
        (-x, -w)
    }
}
