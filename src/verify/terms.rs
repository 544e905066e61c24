//! The quantities used by identities among closed forms at one point, in any arithmetic: plain numbers, or
//! balls.

use super::formulae::{Answers, Formulae};
use crate::float::Real;
use crate::nonsticking::den_hartog::{FallingHalf, phase_lag};
use crate::nonsticking::matching::{Given, Unknowns};

/// An identity among closed forms: the left side minus the right side is zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Claim<F> {
    pub(super) equation: &'static str,
    pub(super) statement: &'static str,
    /// `None` where it does not apply.
    pub(super) residual: fn(&Terms<'_, F>) -> Option<F>,
}

/// The data of a point other than the answers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point<F> {
    pub(super) given: Given<F>,
    /// α.
    pub(super) alpha: F,
    /// K(Ω).
    pub(super) k: F,
    /// T.
    pub(super) tangent: F,
    /// cos β, β = π/2Ω.
    pub(super) cos_beta: F,
    /// 1 − Ω².
    pub(super) one_minus_square: F,
    /// sgn(1 − Ω).
    pub(super) sign: F,
    /// α* and A₁max among the answers.
    pub(super) best: (F, F),
    /// Whether the multipliers are complex; `None` where that is undecided.
    pub(super) is_complex: Option<bool>,
    /// Whether ω_d t₁ is above ω_d t₂ in [0, 2π).
    pub(super) is_late: bool,
}

/// A point with its answers by certain formulae.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Terms<'a, F> {
    pub(super) formulae: &'a dyn Formulae<F>,
    point: Point<F>,
    pub(super) answers: Answers<F>,
    pub(super) unknowns: Unknowns<F>,
    pub(super) half: FallingHalf<F>,
    /// The sum of the amplitudes: of the drive, of friction, of the motion, and of the free oscillation.
    pub(super) scale: F,
}

impl<F> core::ops::Deref for Terms<'_, F> {
    type Target = Point<F>;

    fn deref(&self) -> &Point<F> {
        &self.point
    }
}

impl<'a, F: Real> Terms<'a, F> {
    pub(super) fn new(formulae: &'a dyn Formulae<F>, point: Point<F>, answers: Answers<F>) -> Self {
        let given = point.given;
        // |T| is the amplitude of ρ and X.
        let scale = F::int(1) + given.amplitude.abs() + answers.max_displacement + point.tangent.abs();
        let half = FallingHalf {
            amplitude: given.amplitude,
            friction_displacement: F::int(1),
            omega: given.omega,
            phase_lag: phase_lag(answers.displacement_phase),
            c1: formulae.sine_coefficient(point.tangent),
            c2: formulae.cosine_coefficient(),
        };
        let unknowns = unknowns(&answers, given.omega, point.is_late);
        Self { formulae, point, answers, unknowns, half, scale }
    }

    /// The residual of an identity that contains 1 + cos π₁ as the paper writes it. Near Ω = 1/(2n+1) that
    /// sum is accurate only to 1/T² of itself, so that |T| counts among the terms.
    pub(super) fn near_pole(&self, residual: F) -> F {
        residual / self.scale
    }

    /// `1 + cos π₁ = 2 cos² β`, without cancellation.
    pub(super) fn one_plus_cos(&self) -> F {
        F::int(2) * self.cos_beta.square()
    }
}

/// The unknowns of eq. 21–25 from the answers, lengths in units of B, with t₂ − π/ω_d < t₁ < t₂.
fn unknowns<F: Real>(answers: &Answers<F>, omega: F, is_late: bool) -> Unknowns<F> {
    let turn = if is_late { F::int(2) * F::pi() } else { F::int(0) };
    Unknowns {
        velocity_phase: answers.velocity_phase - turn,
        displacement_phase: answers.displacement_phase,
        max_velocity: answers.max_velocity * omega,
        max_displacement: answers.max_displacement,
        deviation: answers.deviation,
    }
}
