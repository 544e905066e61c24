//! Below Ω = 1/2: the exact border and the global maximum of the velocity, without branches.
//!
//! Both are roots in proven brackets (`nonsticking::border`, `nonsticking::velocity`), and both have a start from which a fixed
//! number of steps is enough, which is checked.
//!
//! **Border.** With γ = β mod π, the stationary point `η` of Den Hartog's condition lies between 0.43 γ and 0.502 γ, all but a
//! polynomial in γ² and Ω² (to 1.1e-3 γ). One Householder step brings it to 2e-9 γ, and the condition's value, stationary there, to rounding.
//!
//! **Velocity.** On its bracket the root solves `sin(e − d) = (ρ/Ω) sin Ωd`, ρ = Ω³α |cos β|/(1 − Ω²), e ≤ π the distance of the crests of
//! the two waves. With Ωd for sin Ωd that is `θ = e − d = arg(1 + ρ exp(ie))`, off by 0.34 at most; one Householder step leaves 2e-4, and
//! [`Moment`] has the rest of the way.

use super::amplitude::{Amplifier, one_minus_square};
use super::block::{AtPoint, select};
use crate::float::circular::{ARCTANGENT, Arctangent, SinCos, TO_HALF_PI, held};
use crate::nonsticking::{Arrived, Moment, Reciprocals, velocity_phase};
use core::f64::consts::{FRAC_PI_2, PI};

/// The bounds of Ω: below, nothing was tried.
const LEAST_OMEGA: f64 = 1.0 / 1024.0;
/// Beside Ω = 1/(2n), where γ is this near to 0 or π, all terms of the border's condition are small.
const CLEAR_OF_ZERO: f64 = 1.0 / 512.0;

/// Whether Ω is within the range of these loops.
#[expect(clippy::manual_range_contains, reason = "one condition, where `contains` is two branches")]
#[inline(always)]
pub(crate) fn has_low_loops(omega: f64) -> bool {
    (omega >= LEAST_OMEGA) & (omega < 0.5)
}

/// What depends on Ω alone.
#[derive(Clone, Copy)]
pub(crate) struct LowParts(SinCos<f64, 8, 8>);

impl AtPoint<1, 5> for LowParts {
    /// `[K, 1/Ω, sin β, cos β, (1 − Ω²) S]`; NaN for the last where it is to be redone.
    #[inline(always)]
    fn at(&self, [omega]: [f64; 1]) -> [f64; 5] {
        let inverse = 1.0 / omega;
        // β = qπ/2 + w
        let q = inverse.round_ties_even();
        let w = FRAC_PI_2 * (-q).mul_add(omega, 1.0) * inverse;
        let (sine, cosine) = self.0.sin_cos(w);
        // q mod 4 in {−2, −1, 0, 1, 2}
        let quarter = (-4.0f64).mul_add((0.25 * q).round_ties_even(), q);
        let is_odd = quarter.abs() == 1.0;
        let sign = select((quarter.abs() == 2.0) | (quarter == -1.0), -1.0, 1.0);
        let sin_beta = sign * select(is_odd, cosine, sine);
        let cos_beta = sign * select(is_odd, -sine, cosine);
        let q = one_minus_square(omega);
        let tangent = sin_beta / cos_beta;
        let k = q * tangent * inverse;
        let gamma = w + select(is_odd, FRAC_PI_2, select(w < 0.0, PI, 0.0));
        let (supremum, is_found) = self.inner_maximum(omega, inverse, gamma, sin_beta.abs(), cos_beta.abs());
        let limit = inverse * inverse;
        let least = select(supremum > limit, supremum, limit);
        let clear = (gamma > CLEAR_OF_ZERO) & (gamma < PI - CLEAR_OF_ZERO);
        [k, inverse, sin_beta, cos_beta, select(is_found & clear, q * least, f64::NAN)]
    }
}

impl LowParts {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(TO_HALF_PI))
    }

    /// S at the stationary point, and whether the step to it was as small as it should be.
    #[inline(always)]
    fn inner_maximum(
        &self,
        omega: f64,
        inverse: f64,
        gamma: f64,
        sin_gamma: f64,
        cos_gamma: f64,
    ) -> (f64, bool) {
        // The largest step known is 1.1e-3 γ.
        const GREATEST_STEP: f64 = 1.0 / 512.0;
        let (x, y) = (gamma * gamma * (1.0 / (PI * PI)), omega * omega * 4.0);
        let bend = y.mul_add(0.143_258, -0.061_765);
        let start = gamma * x.mul_add((-0.009_058f64).mul_add(x, bend), 0.5);
        let (st, ct) = self.0.sin_cos(omega * (gamma + start));
        let (s, c) = self.0.sin_cos(start);
        let condition = ct.mul_add(s, (-inverse * st).mul_add(c, sin_gamma));
        let factor = inverse - omega;
        let first = factor * st * s;
        let second = factor * (omega * ct).mul_add(s, st * c);
        let step = -(condition * first) / first.mul_add(first, -0.5 * condition * second);
        let eta = start + step;
        let (st, ct) = self.0.sin_cos(omega * (gamma + eta));
        let (s, _) = self.0.sin_cos(eta);
        let value = sin_gamma.mul_add(ct, s) * inverse / (cos_gamma * st);
        (value, step.abs() <= GREATEST_STEP * gamma)
    }
}

/// Displacement `[Δ₀, α_min, A₁, ω_d t₂]` from `[Ω, α, K, (1 − Ω²) S]`; NaN for α_min says that the point is to be redone.
#[derive(Clone, Copy)]
pub(crate) struct LowDisplacement(Arctangent<f64>, Amplifier);

impl LowDisplacement {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(held(ARCTANGENT), Amplifier::new())
    }
}

impl AtPoint<4, 4> for LowDisplacement {
    #[inline(always)]
    fn at(&self, [omega, alpha, k, force]: [f64; 4]) -> [f64; 4] {
        let border = force.mul_add(force, k * k).sqrt();
        let in_range = has_low_loops(omega) & (border > 0.0);
        let found = self.1.at(alpha, k, one_minus_square(omega), force, border, in_range);
        let angle = self.0.first_quadrant_angle(found.sine, k.abs(), alpha);
        [found.displacement, found.border, found.size, select(k > 0.0, angle, PI - angle)]
    }
}

/// One half cycle below Ω = 1/2.
#[derive(Clone, Copy)]
pub(crate) struct LowWaves {
    pub(crate) omega: f64,
    pub(crate) inverse: f64,
    pub(crate) max_displacement: f64,
    pub(crate) sin_beta: f64,
    pub(crate) cos_beta: f64,
}

/// Where the bracket lies: the crest of the faster wave and the distance e to that of the slower one, which is at −e if `side` is −1.
#[derive(Clone, Copy)]
struct Bracket {
    /// The crest in units of π/2: odd.
    crest: f64,
    side: f64,
    width: f64,
}

impl LowWaves {
    /// From ω_d t₂.
    #[inline(always)]
    fn bracket(&self, displacement_phase: f64) -> Bracket {
        // The crest of the slower wave, asin(K/α) = π/2 − ω_d t₂, in units of π/2.
        let centre = (displacement_phase - FRAC_PI_2) * self.inverse * (1.0 / FRAC_PI_2);
        let sign = select(self.cos_beta < 0.0, -1.0, 1.0);
        let crest = 4.0f64.mul_add((0.25 * (centre - sign)).round_ties_even(), sign);
        let away = crest - centre;
        Bracket { crest, side: select(away < 0.0, -1.0, 1.0), width: FRAC_PI_2 * away.abs() }
    }

    /// θ, the distance from the crest of the faster wave, near that of the greatest velocity.
    #[inline(always)]
    pub(crate) fn start(&self, circular: &LowCircular, alpha: f64, displacement_phase: f64) -> f64 {
        let width = self.bracket(displacement_phase).width;
        let (negative_cosine, sine) = circular.0.sin_cos(width - FRAC_PI_2);
        let square = self.omega * self.omega;
        let ratio = square * self.omega * alpha * self.cos_beta.abs() / one_minus_square(self.omega);
        let (y, x) = (ratio * sine, (-ratio).mul_add(negative_cosine, 1.0));
        let theta = circular.1.first_quadrant_angle(y, x, x.mul_add(x, y * y).sqrt());
        let (s, c) = circular.0.sin_cos(theta);
        let (so, co) = circular.0.sin_cos(self.omega * (width - theta));
        let (f0, f1) = (s - ratio * self.inverse * so, -ratio.mul_add(co, c));
        let (f2, f3) = ((ratio * self.omega).mul_add(so, -s), (ratio * square).mul_add(co, c));
        let numerator = f0 * f1.mul_add(f1, -0.5 * f0 * f2);
        theta + numerator / f1.mul_add(f1.mul_add(f1, -(f0 * f2)), f3 * f0 * f0 * (1.0 / 6.0))
    }

    /// The greatest velocity, from a θ near it, and Ωψ there.
    #[inline(always)]
    pub(crate) fn arrive(
        &self,
        circular: &LowCircular,
        displacement_phase: f64,
        theta: f64,
    ) -> (Arrived<f64>, f64) {
        let &Self { omega, inverse, max_displacement: delta, sin_beta, cos_beta } = self;
        let Bracket { crest, side, width } = self.bracket(displacement_phase);
        // ψ = crest π/2 − side θ
        let (st, ct) = circular.0.sin_cos(theta);
        let sign = select(cos_beta < 0.0, -1.0, 1.0);
        let (s, c) = (sign * ct, sign * side * st);
        let angle = (-side * omega).mul_add(theta, FRAC_PI_2 * (crest * omega));
        let (so, co) = circular.0.sin_cos(angle);
        let (g, secant) = (omega * delta, 1.0 / cos_beta);
        let forcing = -one_minus_square(omega) * secant;
        let found = Moment {
            psi: 0.0,
            velocity: g.mul_add(co, (-sin_beta).mul_add(so, s) * secant),
            slope: (-omega * g).mul_add(so, (-omega * sin_beta).mul_add(co, c) * secant),
            displacement: (-delta).mul_add(so, (-sin_beta * inverse).mul_add(co, c) * secant) - 1.0,
            forcing: (forcing * s, forcing * c),
            square: omega * omega,
            slower: 1.0,
        }
        .fastest(&circular.2);
        let there = (-side).mul_add(found.psi, theta);
        let is_inside = (there >= 0.0) & (there <= width) & (theta.abs() <= FRAC_PI_2);
        (Arrived { is_found: found.is_found & is_inside, ..found }, omega.mul_add(found.psi, angle))
    }
}

/// The circular functions and their inverse.
#[derive(Clone, Copy)]
pub(crate) struct LowCircular(SinCos<f64, 8, 8>, Arctangent<f64>, Reciprocals<f64>);

/// θ near the greatest velocity.
#[derive(Clone, Copy)]
pub(crate) struct LowStart(LowCircular);

impl LowStart {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(LowCircular(held(TO_HALF_PI), held(ARCTANGENT), Reciprocals::new()))
    }
}

impl AtPoint<7, 1> for LowStart {
    /// `[θ]` from `[Ω, α, Δ₀, 1/Ω, sin β, cos β, ω_d t₂]`.
    #[inline(always)]
    fn at(
        &self,
        [omega, alpha, max_displacement, inverse, sin_beta, cos_beta, phase2]: [f64; 7],
    ) -> [f64; 1] {
        [LowWaves { omega, inverse, max_displacement, sin_beta, cos_beta }.start(&self.0, alpha, phase2)]
    }
}

/// The greatest velocity.
#[derive(Clone, Copy)]
pub(crate) struct LowArrival(LowCircular);

impl LowArrival {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(LowCircular(held(TO_HALF_PI), ARCTANGENT, Reciprocals::new()))
    }
}

impl AtPoint<8, 4> for LowArrival {
    /// `[V₀, ω_d t₁, α_min, Δ₁]`, α_min NaN where the velocity is to be redone.
    #[inline(always)]
    fn at(
        &self,
        [omega, max_displacement, inverse, sin_beta, cos_beta, theta, phase2, border]: [f64; 8],
    ) -> [f64; 4] {
        let waves = LowWaves { omega, inverse, max_displacement, sin_beta, cos_beta };
        let (fastest, omega_psi) = waves.arrive(&self.0, phase2, theta);
        [
            fastest.velocity * inverse,
            velocity_phase(phase2, 1.0, omega_psi),
            // Where there is no cycle, nothing could be found.
            select(fastest.is_found | max_displacement.is_nan(), border, f64::NAN),
            fastest.displacement,
        ]
    }
}

/// The same without the deviation Δ₁.
#[derive(Clone, Copy)]
pub(crate) struct LowPeak(LowArrival);

impl LowPeak {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(LowArrival::new())
    }
}

impl AtPoint<8, 3> for LowPeak {
    #[inline(always)]
    fn at(&self, given: [f64; 8]) -> [f64; 3] {
        let [velocity, phase, border, _] = self.0.at(given);
        [velocity, phase, border]
    }
}
