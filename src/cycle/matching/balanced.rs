//! Eq. 21–25 in a form that is well conditioned where the problem is, with its Jacobian.
//!
//! Near Ω = 1 and Ω = 1/(2n+1) the paper's form is not balanced: A is large, eq. 22 tends to eq. 21 and eq.
//! 24 to eq. 23, and the motion is determined by their small differences, eq. 28 and 29, of the order of cos
//! β, β = π/2Ω. Lengths are therefore in units of A, and eq. 22 and 24 are replaced by those differences
//! divided by 2 cos β. With ψ = ω_n(t₂−t₁) − β, ρ = v − Ω cos ω_d t₁, X = b + e − sin ω_d t₁ and b = B/A = κ
//! cos β:
//!
//! ```text
//! 21                  Ω cos ω_d t₂ + ρ cos θ − X sin θ = 0,             θ = ω_n(t₂−t₁)
//! (21 − 22)/(2 cos β)                ρ cos ψ − X sin ψ = 0
//! 23                    sin ω_d t₂ + ρ sin θ + X cos θ = d + b
//! (23 − 24)/(2 cos β)                ρ sin ψ + X cos ψ = κ
//! 25                       −(1 − Ω²) sin ω_d t₁ + b + e = 0
//! 59                        (1 − Ω²) sin ω_d t₂ + b − d = 0
//! ```
//!
//! All coefficients are of order 1, and κ = (1 − Ω²)/(α cos β) has a limit at Ω = 1 and at the poles of K. No
//! closed form is in it: it is eq. 21–25 times a regular matrix, which a symbolic test checks.

use super::{Given, Unknowns};
#[cfg(feature = "matching")]
use crate::float::Float;
use crate::float::Real;

/// Eq. 21–25 and 59 at one frequency ratio; unknowns in units of A.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Balanced<R> {
    /// Frequency ratio Ω.
    pub(crate) omega: R,
    /// `1 − Ω²`.
    pub(crate) one_minus_square: R,
    /// (sin β, cos β), β = π/2Ω.
    pub(crate) sin_cos_beta: (R, R),
    /// `κ = B/(A cos β)`: the friction, 0 for none.
    pub(crate) friction: R,
}

/// `(ρ cos θ − X sin θ, X cos θ + ρ sin θ)`: the rate and the position of the free oscillation at ω_n.
fn swing<R: Real>(rho: R, offset: R, (s, c): (R, R)) -> (R, R) {
    (rho * c - offset * s, offset * c + rho * s)
}

impl<R: Real> Balanced<R> {
    /// `b = B/A`.
    fn b(&self) -> R {
        self.friction * self.sin_cos_beta.1
    }

    /// This problem in the paper's form, in units of A.
    pub(crate) fn given(&self) -> Given<R> {
        Given { amplitude: R::int(1), friction_displacement: self.b(), omega: self.omega }
    }

    /// (sin, cos) of θ and of ψ = θ − β.
    fn angles(&self, u: &Unknowns<R>) -> ((R, R), (R, R)) {
        let (s, c) = self.given().lag(u).sin_cos();
        let (sb, cb) = self.sin_cos_beta;
        ((s, c), (s * cb - c * sb, c * cb + s * sb))
    }

    /// Left less right sides of the five equations.
    pub(crate) fn residuals(&self, u: &Unknowns<R>) -> [R; 5] {
        let given = self.given();
        let (rho, x) = (given.rho(u), given.offset(u));
        let (theta, psi) = self.angles(u);
        let ((rate, position), (centred_rate, centred_position)) = (swing(rho, x, theta), swing(rho, x, psi));
        let (sin_t2, cos_t2) = u.displacement_phase.sin_cos();
        [
            self.omega * cos_t2 + rate,
            centred_rate,
            sin_t2 + position - (u.max_displacement + self.b()),
            centred_position - self.friction,
            self.b() + u.deviation - self.one_minus_square * u.velocity_phase.sin(),
        ]
    }

    /// Left less right side of eq. 59 over A: `(1 − Ω²) sin ω_d t₂ − Δ₀/A + B/A`.
    ///
    /// The force left over at t₂ is r_y, with the sign it has at a maximum of x.
    pub(crate) fn turning_point(&self, u: &Unknowns<R>) -> R {
        self.one_minus_square * u.displacement_phase.sin() - u.max_displacement + self.b()
    }

    /// Derivatives of the residuals (rows) by t₁, t₂, V₀, Δ₀, Δ₁ (columns), in closed form.
    pub(crate) fn jacobian(&self, u: &Unknowns<R>) -> [[R; 5]; 5] {
        let (zero, one) = (R::int(0), R::int(1));
        let given = self.given();
        let (rho, x) = (given.rho(u), given.offset(u));
        let ((s, c), (sp, cp)) = self.angles(u);
        let (rate, position) = swing(rho, x, (s, c));
        let (centred_rate, centred_position) = swing(rho, x, (sp, cp));
        let (sin_t1, cos_t1) = u.velocity_phase.sin_cos();
        let (sin_t2, cos_t2) = u.displacement_phase.sin_cos();
        let omega = self.omega;
        // ∂ρ/∂t₁ = Ω sin t₁, ∂X/∂t₁ = −cos t₁, ∂θ/∂t₂ = −∂θ/∂t₁ = 1/Ω.
        let (by_t1, centred_by_t1) =
            (swing(omega * sin_t1, -cos_t1, (s, c)), swing(omega * sin_t1, -cos_t1, (sp, cp)));
        [
            [by_t1.0 + position / omega, -(omega * sin_t2) - position / omega, c, zero, -s],
            [centred_by_t1.0 + centred_position / omega, -(centred_position / omega), cp, zero, -sp],
            [by_t1.1 - rate / omega, cos_t2 + rate / omega, s, -one, c],
            [centred_by_t1.1 - centred_rate / omega, centred_rate / omega, sp, zero, cp],
            [-(self.one_minus_square * cos_t1), zero, zero, zero, one],
        ]
    }

    /// Derivatives of the residuals by κ, in closed form.
    pub(crate) fn by_friction(&self, u: &Unknowns<R>) -> [R; 5] {
        let ((s, c), (sp, cp)) = self.angles(u);
        let cb = self.sin_cos_beta.1;
        [-(cb * s), -(cb * sp), cb * (c - R::int(1)), cb * cp - R::int(1), cb]
    }

    /// Derivatives of [`Balanced::turning_point`] by t₁, t₂, V₀, Δ₀, Δ₁ and κ, in closed form.
    pub(crate) fn turning_point_gradient(&self, u: &Unknowns<R>) -> [R; 6] {
        let zero = R::int(0);
        let cos_t2 = u.displacement_phase.cos();
        [zero, self.one_minus_square * cos_t2, zero, R::int(-1), zero, self.sin_cos_beta.1]
    }
}

#[cfg(feature = "matching")]
impl<F: Float> super::start::Equations<F> for Balanced<F> {
    fn omega(&self) -> F {
        self.omega
    }

    fn friction(&self) -> F {
        self.friction
    }

    fn with_friction(self, friction: F) -> Self {
        Self { friction, ..self }
    }

    /// `x = A sin ω_d t`: maximum velocity at t₁ = 0, maximum displacement at π/2; half a turn later where A < 0.
    fn without_friction(&self) -> Unknowns<F> {
        let (zero, one) = (F::int(0), F::int(1));
        let is_below = (self.friction > zero) == (self.sin_cos_beta.1 > zero);
        let (sign, turn) = if is_below { (one, zero) } else { (-one, F::pi()) };
        Unknowns {
            velocity_phase: turn,
            displacement_phase: turn + F::pi() / F::int(2),
            max_velocity: sign * self.omega,
            max_displacement: sign,
            deviation: zero,
        }
    }

    fn equations(&self, u: &Unknowns<F>) -> ([F; 5], [[F; 5]; 5]) {
        (self.residuals(u), self.jacobian(u))
    }

    fn rising(&self, u: &Unknowns<F>, phase: F) -> (F, F) {
        let given = self.given();
        (given.rising_displacement(u, phase), given.rising_velocity(u, phase))
    }
}
