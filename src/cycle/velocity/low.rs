//! The peak velocity below Ω = 1/2, without branches: a start by algebra and one step, the circular
//! functions once, and Taylor's formula from there.
//!
//! On its bracket (`cycle::velocity`) the root solves `sin(e − d) = (ρ/Ω) sin Ωd`, ρ = Ω³α |cos β|/(1 −
//! Ω²), where e ≤ π is the distance between the crests of the two waves. If Ωd replaces sin Ωd, the solution
//! is `θ = e − d = arg(1 + ρ exp(ie))`, with an error of at most 0.34. One of Householder's steps reduces it
//! to 2e-4, and [`ArrivalMoment`] completes the iteration.

use super::arrival::{ArrivalMoment, Arrived, Reciprocals};
use crate::cycle::phase_function::one_minus_square;
use crate::float::Float;
use crate::float::circular::{ARCTANGENT, Arctangent, SinCos, TO_HALF_PI};

/// The circular functions and their inverse.
#[derive(Clone, Copy)]
pub(crate) struct LowCircular<F> {
    circular: SinCos<F, 8, 8>,
    arctangent: Arctangent<F>,
    reciprocals: Reciprocals<F>,
}

impl<F: Float> LowCircular<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { circular: TO_HALF_PI.of(), arctangent: ARCTANGENT.of(), reciprocals: Reciprocals::new() }
    }
}

/// One half cycle below Ω = 1/2.
#[derive(Clone, Copy)]
pub(crate) struct LowWaves<F> {
    pub(crate) omega: F,
    /// 1/Ω.
    pub(crate) inverse: F,
    pub(crate) max_displacement: F,
    /// The rounding error of Δ₀/B.
    pub(crate) rest: F,
    /// `(sin β, cos β)`.
    pub(crate) beta: (F, F),
}

/// Where the bracket lies: the crest of the faster wave and the distance e to that of the slower one, which
/// is at −e if `side` is −1.
#[derive(Clone, Copy)]
struct Bracket<F> {
    /// The crest in units of π/2: odd.
    crest: F,
    side: F,
    width: F,
}

/// 1 with the sign of x.
#[inline(always)]
fn sign_of<F: Float>(x: F) -> F {
    if x < F::int(0) { F::int(-1) } else { F::int(1) }
}

impl<F: Float> LowWaves<F> {
    /// From ω_d t₂.
    #[inline(always)]
    fn bracket(&self, displacement_phase: F) -> Bracket<F> {
        let (half_pi, four) = (F::pi() * F::ratio(1, 2), F::int(4));
        // The crest of the slower wave, asin(K/α) = π/2 − ω_d t₂, in units of π/2.
        let centre = (displacement_phase - half_pi) * self.inverse * (F::int(1) / half_pi);
        let sign = sign_of(self.beta.1);
        let crest = four.mul_add(((centre - sign) * F::ratio(1, 4)).round(), sign);
        let away = crest - centre;
        Bracket { crest, side: sign_of(away), width: half_pi * away.abs() }
    }

    /// θ, the distance from the crest of the faster wave, near that of the peak velocity.
    #[inline(always)]
    pub(crate) fn start(&self, given: &LowCircular<F>, alpha: F, displacement_phase: F) -> F {
        let (one, half) = (F::int(1), F::ratio(1, 2));
        let &LowCircular { circular, arctangent, .. } = given;
        let width = self.bracket(displacement_phase).width;
        let (negative_cosine, sine) = circular.sin_cos(width - F::pi() * half);
        let square = self.omega * self.omega;
        let ratio = square * self.omega * alpha * self.beta.1.abs() / one_minus_square(self.omega);
        let (y, x) = (ratio * sine, (-ratio).mul_add(negative_cosine, one));
        let theta = arctangent.first_quadrant_angle(y, x, x.mul_add(x, y * y).sqrt());
        let (s, c) = circular.sin_cos(theta);
        let (so, co) = circular.sin_cos(self.omega * (width - theta));
        let (f0, f1) = (s - ratio * self.inverse * so, -ratio.mul_add(co, c));
        let (f2, f3) = ((ratio * self.omega).mul_add(so, -s), (ratio * square).mul_add(co, c));
        let numerator = f0 * f1.mul_add(f1, -(half * f0 * f2));
        theta + numerator / f1.mul_add(f1.mul_add(f1, -(f0 * f2)), f3 * f0 * f0 * F::ratio(1, 6))
    }

    /// The peak velocity, from a θ near it, with its ψ; and V₀/(Bω_d), whose largest term is Δ₀/B times a
    /// cosine, without the roundings of Ω.
    #[inline(always)]
    pub(crate) fn arrive(&self, given: &LowCircular<F>, displacement_phase: F, theta: F) -> (Arrived<F>, F) {
        let &Self { omega, inverse, max_displacement: delta, rest, beta: (sin_beta, cos_beta) } = self;
        let &LowCircular { circular, reciprocals, .. } = given;
        let (zero, one, half_pi) = (F::int(0), F::int(1), F::pi() * F::ratio(1, 2));
        let Bracket { crest, side, width } = self.bracket(displacement_phase);
        // ψ = crest π/2 − side θ
        let (st, ct) = circular.sin_cos(theta);
        let sign = sign_of(cos_beta);
        let (s, c) = (sign * ct, sign * side * st);
        let (so, co) = circular.sin_cos((-side * omega).mul_add(theta, half_pi * (crest * omega)));
        let (g, secant) = (omega * delta, one / cos_beta);
        let forcing = -one_minus_square(omega) * secant;
        // (sin ψ − sin β sin Ωψ)/cos β
        let swing = (-sin_beta).mul_add(so, s) * secant;
        let found = ArrivalMoment {
            psi: zero,
            // v/(Bω_n) = Ω(Δ₀/B) cos Ωψ + (sin ψ − sin β sin Ωψ)/cos β
            velocity: g.mul_add(co, swing),
            slope: (-omega * g).mul_add(so, (-omega * sin_beta).mul_add(co, c) * secant),
            // x/B = −1 − (Δ₀/B) sin Ωψ + [cos ψ − (sin β/Ω) cos Ωψ]/cos β
            displacement: (-delta).mul_add(so, (-sin_beta * inverse).mul_add(co, c) * secant) - one,
            forcing: (forcing * s, forcing * c),
            square: omega * omega,
            slower: one,
        }
        .fastest(&reciprocals);
        let there = (-side).mul_add(found.psi, theta);
        let is_inside = (there >= zero) & (there <= width) & (theta.abs() <= half_pi);
        let is_found = found.is_found & is_inside & (omega >= F::ratio(1, 1024)) & (omega < F::ratio(1, 2));
        let smaller = rest.mul_add(co, inverse * swing);
        let velocity = inverse.mul_add(found.gain, delta.mul_add(co, smaller));
        // The step is the smallest part.
        let psi = half_pi.mul_add(crest, (-side).mul_add(theta, found.psi));
        (Arrived { psi, is_found, ..found }, velocity)
    }
}
