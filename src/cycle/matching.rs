//! The matching problem (eq. 2–39): five unknowns, five equations, and their consequences.
//!
//! In the paper's own symbols, for any number that has the field operations. Time enters as the phases ω_d t
//! of the drive; the angle ω_n(t₂ − t₁) is their difference over Ω. Lengths (A, B, Δ₀, Δ₁, V₀/ω_n) share one
//! unit.
//!
//! [`system`] has the same conditions for a body with or without a damper, and [`balanced`] a well-conditioned form of
//! them, with the Jacobian, which `newton` (feature `matching`) solves.

#[cfg(feature = "matching")]
mod accuracy;
#[cfg(any(test, feature = "matching"))]
pub(crate) mod balanced;
#[cfg(feature = "matching")]
pub(crate) mod newton;
#[cfg(feature = "matching")]
mod start;
#[cfg(feature = "matching")]
mod step;
pub(crate) mod system;

use crate::float::Real;

/// The given quantities: A (eq. 5), B (eq. 6) and Ω (eq. 9).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Given<R> {
    /// Amplitude of the frictionless response `A = p₀/(k(1 − Ω²))` (eq. 5).
    pub amplitude: R,
    /// Friction displacement `B = r_y/k` (eq. 6).
    pub friction_displacement: R,
    /// Frequency ratio Ω (eq. 9).
    pub omega: R,
}

/// The unknowns: t₁, t₂, V₀, Δ₀, Δ₁.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Unknowns<R> {
    /// Phase `ω_d t₁` of the peak velocity.
    pub velocity_phase: R,
    /// Phase `ω_d t₂` of the peak displacement.
    pub displacement_phase: R,
    /// Peak velocity as a length, `V₀/ω_n`.
    pub max_velocity: R,
    /// Peak displacement Δ₀.
    pub max_displacement: R,
    /// Displacement Δ₁ at the peak velocity.
    pub deviation: R,
}

/// Phase half a period later, `ω_d t + π`: of the minimum velocity, `t₃ = t₁ + π/ω_d` (eq. 2), and of the
/// minimum displacement, `t₄ = t₂ + π/ω_d` (eq. 3).
#[inline]
pub fn half_period_later<R: Real>(phase: R) -> R {
    phase + R::pi()
}

/// `π₁ = π/Ω` (eq. 26).
#[inline]
pub fn pi_1<R: Real>(omega: R) -> R {
    R::pi() / omega
}

impl<R: Real> Given<R> {
    /// `ρ = V₀/ω_n − A Ω cos ω_d t₁` (eq. 27). Also a₁ of eq. 4, which eq. 13 fixes.
    #[inline]
    pub fn rho(&self, u: &Unknowns<R>) -> R {
        u.max_velocity - self.amplitude * self.omega * u.velocity_phase.cos()
    }

    /// `X = B + Δ₁ − A sin ω_d t₁`, which occurs in eq. 21–39. It is also b₁ of eq. 4, determined by eq. 11.
    #[inline]
    pub fn offset(&self, u: &Unknowns<R>) -> R {
        self.friction_displacement + u.deviation - self.amplitude * u.velocity_phase.sin()
    }

    /// The angle `ω_n(t₂ − t₁)`.
    #[inline]
    pub fn lag(&self, u: &Unknowns<R>) -> R {
        (u.displacement_phase - u.velocity_phase) / self.omega
    }

    /// Displacement on the branch with x′ > 0, at the phase ω_d t (eq. 4, 15).
    ///
    /// `x₁ = A sin ω_d t − B + ρ sin ω_n(t−t₁) + X cos ω_n(t−t₁)`. Holds from t₂ − π/ω_d to t₂.
    pub fn rising_displacement(&self, u: &Unknowns<R>, phase: R) -> R {
        let (s, c) = ((phase - u.velocity_phase) / self.omega).sin_cos();
        self.amplitude * phase.sin() - self.friction_displacement + self.rho(u) * s + self.offset(u) * c
    }

    /// Velocity over ω_n on the branch with x′ > 0: the derivative of eq. 15.
    pub fn rising_velocity(&self, u: &Unknowns<R>, phase: R) -> R {
        let (s, c) = ((phase - u.velocity_phase) / self.omega).sin_cos();
        self.amplitude * self.omega * phase.cos() + self.rho(u) * c - self.offset(u) * s
    }

    /// Displacement on the branch with x′ < 0, at the phase ω_d t (eq. 10, 16).
    ///
    /// `x₂ = A sin ω_d t + B − ρ sin ω_n(t−t₃) − X cos ω_n(t−t₃)`. Holds from t₂ to t₂ + π/ω_d.
    pub fn falling_displacement(&self, u: &Unknowns<R>, phase: R) -> R {
        let (s, c) = self.falling_angle(u, phase).sin_cos();
        self.amplitude * phase.sin() + self.friction_displacement - self.rho(u) * s - self.offset(u) * c
    }

    /// Velocity over ω_n on the branch with x′ < 0: the derivative of eq. 16.
    pub fn falling_velocity(&self, u: &Unknowns<R>, phase: R) -> R {
        let (s, c) = self.falling_angle(u, phase).sin_cos();
        self.amplitude * self.omega * phase.cos() - self.rho(u) * c + self.offset(u) * s
    }

    fn falling_angle(&self, u: &Unknowns<R>, phase: R) -> R {
        (phase - half_period_later(u.velocity_phase)) / self.omega
    }

    /// Left less right sides of eq. 21–25: all zero on the matched cycle.
    ///
    /// Eq. 21 and 22 say that both branches stop at t₂, eq. 23 and 24 that they are at Δ₀ there, eq. 25 that
    /// the velocity is extreme at t₁.
    pub fn residuals(&self, u: &Unknowns<R>) -> [R; 5] {
        let (a, b) = (self.amplitude, self.friction_displacement);
        let (rho, x) = (self.rho(u), self.offset(u));
        let (s, c) = self.lag(u).sin_cos();
        let (s1, c1) = pi_1(self.omega).sin_cos();
        let (sin_t2, cos_t2) = u.displacement_phase.sin_cos();
        let rate = a * self.omega * cos_t2;
        [
            rate - x * s + rho * c,
            rate + x * (c1 * s - s1 * c) - rho * (c1 * c + s1 * s),
            a * sin_t2 + x * c + rho * s - (u.max_displacement + b),
            a * sin_t2 - x * (c1 * c + s1 * s) - rho * (c1 * s - s1 * c) - (u.max_displacement - b),
            a * (self.omega.square() - R::int(1)) * u.velocity_phase.sin() + b + u.deviation,
        ]
    }

    /// `a = ρ(1 + cos π₁) + X sin π₁` (eq. 30).
    #[inline]
    pub fn coefficient_a(&self, u: &Unknowns<R>) -> R {
        let (s1, c1) = pi_1(self.omega).sin_cos();
        self.rho(u) * (R::int(1) + c1) + self.offset(u) * s1
    }

    /// `b = ρ sin π₁ − X(1 + cos π₁)` (eq. 31).
    #[inline]
    pub fn coefficient_b(&self, u: &Unknowns<R>) -> R {
        let (s1, c1) = pi_1(self.omega).sin_cos();
        self.rho(u) * s1 - self.offset(u) * (R::int(1) + c1)
    }

    /// Left less right side of eq. 28: `a cos ω_n(t₂−t₁) + b sin ω_n(t₂−t₁)`.
    pub fn elimination_of_rate(&self, u: &Unknowns<R>) -> R {
        let (s, c) = self.lag(u).sin_cos();
        self.coefficient_a(u) * c + self.coefficient_b(u) * s
    }

    /// Left less right side of eq. 29: `−b cos ω_n(t₂−t₁) + a sin ω_n(t₂−t₁) − 2B`.
    pub fn elimination_of_position(&self, u: &Unknowns<R>) -> R {
        let (s, c) = self.lag(u).sin_cos();
        self.coefficient_a(u) * s - self.coefficient_b(u) * c - R::int(2) * self.friction_displacement
    }

    /// Right side of eq. 32: `2(1 + cos π₁)(ρ² + X²)`, which equals a² + b² identically and 4B² on the cycle
    /// (eq. 35).
    pub fn squared_coefficients(&self, u: &Unknowns<R>) -> R {
        R::int(2) * (R::int(1) + pi_1(self.omega).cos()) * (self.rho(u).square() + self.offset(u).square())
    }

    /// `ρ²` by eq. 36: `2B²/(1 + cos π₁) − X²`.
    pub fn squared_rho(&self, u: &Unknowns<R>) -> R {
        R::int(2) * self.friction_displacement.square() / (R::int(1) + pi_1(self.omega).cos())
            - self.offset(u).square()
    }

    /// `V₀/ω_n` by eq. 37, corrected: `A Ω cos ω_d t₁ + sgn(1−Ω) √(ρ²)`; `sign` is sgn(1 − Ω). With eq. 25
    /// put in for Δ₁ it is eq. 48.
    ///
    /// The paper prints the root with a plus sign, which is wrong for every Ω > 1.
    pub fn max_velocity(&self, u: &Unknowns<R>, sign: R) -> R {
        self.amplitude * self.omega * u.velocity_phase.cos() + sign * self.squared_rho(u).sqrt()
    }

    /// `cos ω_n(t₂−t₁)` by eq. 33: `−2Bb/(a² + b²)`.
    pub fn cos_lag_from_coefficients(&self, u: &Unknowns<R>) -> R {
        let (a, b) = (self.coefficient_a(u), self.coefficient_b(u));
        R::int(-2) * self.friction_displacement * b / (a.square() + b.square())
    }

    /// `sin ω_n(t₂−t₁)` by eq. 34: `2Ba/(a² + b²)`.
    pub fn sin_lag_from_coefficients(&self, u: &Unknowns<R>) -> R {
        let (a, b) = (self.coefficient_a(u), self.coefficient_b(u));
        R::int(2) * self.friction_displacement * a / (a.square() + b.square())
    }

    /// `cos ω_n(t₂−t₁)` by eq. 38: `[(1 + cos π₁) X − ρ sin π₁]/(2B)`.
    pub fn cos_lag(&self, u: &Unknowns<R>) -> R {
        -self.coefficient_b(u) / (R::int(2) * self.friction_displacement)
    }

    /// `sin ω_n(t₂−t₁)` by eq. 39: `[ρ(1 + cos π₁) + X sin π₁]/(2B)`.
    pub fn sin_lag(&self, u: &Unknowns<R>) -> R {
        self.coefficient_a(u) / (R::int(2) * self.friction_displacement)
    }

    /// Left less right side of eq. 45, eq. 38 and 39 combined:
    /// `B(1 + cos π₁) cos θ + B sin π₁ sin θ − (1 + cos π₁) X`, θ = ω_n(t₂−t₁).
    pub fn combined_lag(&self, u: &Unknowns<R>) -> R {
        let (s, c) = self.lag(u).sin_cos();
        let (s1, c1) = pi_1(self.omega).sin_cos();
        let one_plus = R::int(1) + c1;
        self.friction_displacement * (one_plus * c + s1 * s) - one_plus * self.offset(u)
    }
}
