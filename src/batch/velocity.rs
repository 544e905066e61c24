//! The greatest velocity of a half cycle, for Ω ≥ 1/2: the same waves and the same steps as
//! `nonsticking::velocity`, always two evaluations, without branches.
//!
//! In the module `nonsticking::half_cycle` the velocity and the displacement are written with the centred time ψ. The first step, from
//! ψ = 0, needs no circular function; the steps after it start from where the one before arrived. A step h leaves an error of the order h⁴,
//! so that the last is final where it is below [`FINAL_STEP`] in the angle of the faster wave.

use super::block::select;
use super::circular::sin_cos;
use super::frequency::Frequency;
use core::f64::consts::{FRAC_PI_2, TAU};

/// The largest final step: 64 h⁴ = ε.
const FINAL_STEP: f64 = 4.315_837_287_515_549e-5;

/// One half cycle.
#[derive(Clone, Copy)]
pub(crate) struct Waves {
    pub(crate) omega: f64,
    pub(crate) max_displacement: f64,
    pub(crate) at: Frequency,
}

/// v/(Bω_n) and its derivatives by ψ, and x/B.
#[derive(Clone, Copy)]
struct Jet {
    value: f64,
    first: f64,
    second: f64,
    third: f64,
    fourth: f64,
}

/// `(sin, cos)` of ψ and of Ωψ, and `sin((1+Ω)ψ/2) sin((1−Ω)ψ/2)`.
#[derive(Clone, Copy)]
struct Angles {
    psi: (f64, f64),
    omega_psi: (f64, f64),
    half_sum: (f64, f64),
    sin_half_difference: f64,
}

/// Where the velocity is greatest.
#[derive(Clone, Copy)]
pub(crate) struct Fastest {
    /// ψ.
    pub(crate) psi: f64,
    /// V₀/(Bω_n).
    pub(crate) velocity: f64,
    /// Δ₁/B.
    pub(crate) displacement: f64,
    /// Whether the steps settled inside the proven bracket.
    pub(crate) is_found: bool,
}

impl Waves {
    /// Whether half sum and half difference of the angles are used: below Ω = 2, where neither outgrows the other.
    #[inline(always)]
    fn is_beside_one(&self) -> bool {
        self.omega < 2.0
    }

    /// The first step, from ψ = 0.
    #[inline(always)]
    pub(crate) fn first_step(&self) -> f64 {
        let origin =
            Angles { psi: (0.0, 1.0), omega_psi: (0.0, 1.0), half_sum: (0.0, 1.0), sin_half_difference: 0.0 };
        householder(&self.velocity(&origin))
    }

    /// Where a step from ψ leads.
    #[inline(always)]
    pub(crate) fn next(&self, psi: f64) -> f64 {
        psi + householder(&self.velocity(&self.angles(psi)))
    }

    /// The last step, from ψ, with what is found there by Taylor's formula.
    #[inline(always)]
    pub(crate) fn arrive(&self, first: f64, psi: f64) -> Fastest {
        let angles = self.angles(psi);
        let jet = self.velocity(&angles);
        let step = householder(&jet);
        let found = psi + step;
        let fastest_angle = select(self.omega > 1.0, self.omega, 1.0);
        let bound = FRAC_PI_2 / fastest_angle;
        let velocity = (jet.third * step).mul_add(1.0 / 3.0, jet.second);
        let velocity = (step * 0.5).mul_add(velocity, jet.first).mul_add(step, jet.value);
        let fall = (jet.third * step).mul_add(0.25, jet.second);
        let fall = (fall * step).mul_add(1.0 / 3.0, jet.first);
        let fall = (fall * step).mul_add(0.5, jet.value);
        Fastest {
            psi: found,
            velocity,
            displacement: (-step).mul_add(fall, self.displacement(&angles)),
            is_found: ((step * fastest_angle).abs() <= FINAL_STEP)
                & (first.abs() <= bound)
                & (psi.abs() <= bound)
                & (found.abs() <= bound)
                & (jet.second < 0.0),
        }
    }

    #[inline(always)]
    fn angles(&self, psi: f64) -> Angles {
        let beside = self.is_beside_one();
        let half = 0.5 * psi;
        let (s1, c1) = sin_cos(select(beside, (1.0 + self.omega) * half, psi));
        let (s2, c2) = sin_cos(select(beside, (1.0 - self.omega) * half, self.omega * psi));
        let (ss, sc, cs, cc) = (s1 * s2, s1 * c2, c1 * s2, c1 * c2);
        Angles {
            psi: (select(beside, sc + cs, s1), select(beside, cc - ss, c1)),
            omega_psi: (select(beside, sc - cs, s2), select(beside, cc + ss, c2)),
            half_sum: (s1, c1),
            sin_half_difference: s2,
        }
    }

    #[inline(always)]
    fn velocity(&self, angles: &Angles) -> Jet {
        let &Angles { psi: (s, c), omega_psi: (so, co), half_sum: (sp, cp), sin_half_difference: sm } =
            angles;
        let (omega, delta, at) = (self.omega, self.max_displacement, self.at);
        let less = 1.0 - omega;
        let double = 2.0 * sm * at.secant;
        let slope = less.mul_add(at.secant, omega * at.tan_half_offset);
        let h = select(
            self.is_beside_one(),
            double.mul_add(cp, at.tan_half_offset * so),
            (-at.sin_beta).mul_add(so, s) * at.secant,
        );
        let h1 = select(
            self.is_beside_one(),
            slope.mul_add(co, -(double * sp)),
            (-omega * at.sin_beta).mul_add(co, c) * at.secant,
        );
        let omega2 = omega * omega;
        let value = (omega * delta).mul_add(co, h);
        let first = (-omega2 * delta).mul_add(so, h1);
        let forcing = -(less * (1.0 + omega) * at.secant);
        let second = forcing.mul_add(s, -(omega2 * value));
        let third = forcing.mul_add(c, -(omega2 * first));
        let fourth = -forcing.mul_add(s, omega2 * second);
        Jet { value, first, second, third, fourth }
    }

    #[inline(always)]
    fn displacement(&self, angles: &Angles) -> f64 {
        let &Angles { psi: (s, c), omega_psi: (so, co), half_sum: (sp, _), sin_half_difference: sm } = angles;
        let (omega, at) = (self.omega, self.at);
        let slope = (omega - 1.0).mul_add(at.secant, at.tan_half_offset) * at.inverse;
        let beside = co.mul_add(slope, -(2.0 * sp * sm * at.secant)) - 1.0;
        let quotient = (at.sin_beta - s) * (at.sin_beta + s) / (c + at.cos_beta);
        let above = (-at.sin_beta * at.inverse).mul_add(co, quotient) * at.secant;
        (-self.max_displacement).mul_add(so, select(self.is_beside_one(), beside, above))
    }
}

/// The step of Householder's third-order method on v′ = 0, as one quotient.
#[inline(always)]
fn householder(jet: &Jet) -> f64 {
    let (a, b, c, d) = (jet.first, jet.second, jet.third, jet.fourth);
    let (square, ac) = (b * b, a * c);
    let numerator = a * (-0.5f64).mul_add(ac, square);
    let denominator = b.mul_add(square - ac, d * a * a * (1.0 / 6.0));
    -numerator / denominator
}

/// ω_d t₁ in [0, 2π) from ω_d t₂ and ψ: `ω_d t₂ − π/2 − Ωψ`.
#[inline(always)]
pub(crate) fn velocity_phase(displacement_phase: f64, omega: f64, psi: f64) -> f64 {
    let phase = (-omega).mul_add(psi, displacement_phase - FRAC_PI_2);
    let turned = phase + TAU;
    select(phase < 0.0, turned, phase)
}
