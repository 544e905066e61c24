//! Den Hartog's estimate (1931) of the same cycle (eq. 50–56).
//!
//! He puts the origin of time at the peak displacement and drives with `p₀ cos(ω_d t + φ)`, so that one
//! falling half cycle, 0 ≤ t ≤ π/ω_d, has only Δ₀ and φ to match: x(0) = Δ₀, x′(0) = 0, x(π/ω_d) = −Δ₀,
//! x′(π/ω_d) = 0 (eq. 50–53).

use crate::float::Real;

/// Phase lag `φ = ω_d t₂ − π/2` of Den Hartog's drive, with ω_d t₂ from eq. 43.
#[inline]
pub fn phase_lag<R: Real>(displacement_phase: R) -> R {
    displacement_phase - R::pi() / R::int(2)
}

/// `C₁ = Ω A sin φ = −B sin π₁/(1 + cos π₁)` (eq. 55), from B and T = sin π₁/(1 + cos π₁).
#[inline]
pub fn sine_coefficient<R: Real>(b: R, tangent: R) -> R {
    -(b * tangent)
}

/// `C₂ = Δ₀ − B − A cos φ = −B` (eq. 56).
#[inline]
pub fn cosine_coefficient<R: Real>(b: R) -> R {
    -b
}

/// One falling half cycle (eq. 54): amplitude A, friction displacement B, Ω, φ, C₁ and C₂.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FallingHalf<R> {
    /// A (eq. 5).
    pub amplitude: R,
    /// B (eq. 6).
    pub friction_displacement: R,
    /// Ω (eq. 9).
    pub omega: R,
    /// φ ([`phase_lag`]).
    pub phase_lag: R,
    /// C₁ ([`sine_coefficient`]).
    pub c1: R,
    /// C₂ ([`cosine_coefficient`]).
    pub c2: R,
}

impl<R: Real> FallingHalf<R> {
    /// Displacement at the phase ω_d t, in `[0, π]` (eq. 54):
    /// `x = A cos(ω_d t + φ) + B + C₁ sin ω_n t + C₂ cos ω_n t`.
    ///
    /// It is 0/0 at Ω = 1 and loses digits near it; [`crate::cycle::Cycle::displacement_at`] is the
    /// same motion without.
    pub fn displacement(&self, phase: R) -> R {
        let (s, c) = (phase / self.omega).sin_cos();
        self.amplitude * (phase + self.phase_lag).cos()
            + self.friction_displacement
            + self.c1 * s
            + self.c2 * c
    }

    /// Velocity over ω_n at the phase ω_d t, in `[0, π]`: the derivative of eq. 54. Nowhere positive is Den
    /// Hartog's condition for a cycle without stops ([`crate::Border`]).
    pub fn velocity(&self, phase: R) -> R {
        let (s, c) = (phase / self.omega).sin_cos();
        self.c1 * c - self.c2 * s - self.amplitude * self.omega * (phase + self.phase_lag).sin()
    }
}
