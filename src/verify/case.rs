//! A cycle with all that the identities ask of it.

use super::Solvable;
#[cfg(test)]
use super::formulae::Library;
use super::formulae::{Answers, Formulae};
use super::motion::Motion;
use super::on_border::OnBorder;
use crate::float::Float;
use crate::nonsticking::Cycle;
use crate::nonsticking::den_hartog::{FallingHalf, phase_lag};
use crate::nonsticking::matching::newton::Solution;
use crate::nonsticking::matching::{Given, Unknowns};
use crate::phase_function::{PhaseFunction, one_minus_square};

/// A cycle with all that the identities ask of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case<'a, F> {
    pub(super) formulae: &'a dyn Formulae<F>,
    pub(super) cycle: Cycle<F>,
    pub(super) phase_function: PhaseFunction<F>,
    pub(super) answers: Answers<F>,
    pub(super) given: Given<F>,
    pub(super) unknowns: Unknowns<F>,
    pub(super) half: FallingHalf<F>,
    pub(super) one_minus_square: F,
    pub(super) scale: F,
    /// The exact motion at the same (Ω, α).
    pub(super) motion: Option<Motion<F>>,
    /// Eq. 21–25 solved at the same (Ω, α).
    pub(super) solved: Option<Solution<F>>,
    /// What is found on the border at Ω, in one case of each Ω.
    pub(super) on_border: Option<OnBorder<F>>,
}

#[cfg(test)]
impl<F: Float> Case<'static, F> {
    /// The case of a cycle, for the identities that ask for nothing beyond the closed forms.
    pub(crate) fn new(cycle: Cycle<F>) -> Self {
        Case::by(&Library, cycle)
    }
}

impl<'a, F: Float> Case<'a, F> {
    /// The case of a cycle, by these formulae.
    pub(super) fn by(formulae: &'a dyn Formulae<F>, cycle: Cycle<F>) -> Self {
        let omega = cycle.ratios().omega();
        let phase_function = PhaseFunction::of_valid(omega);
        let answers = formulae.answers(&cycle);
        let given = cycle.given();
        // The amplitudes: of the drive, of friction, of the motion, and of what swings freely, |T| being that of ρ and X.
        let scale =
            F::int(1) + given.amplitude.abs() + cycle.max_displacement() + phase_function.tangent().abs();
        let half = FallingHalf {
            phase_lag: phase_lag(answers.displacement_phase),
            c1: formulae.sine_coefficient(phase_function.tangent()),
            c2: formulae.cosine_coefficient(),
            ..cycle.den_hartog()
        };
        Self {
            formulae,
            cycle,
            phase_function,
            answers,
            given,
            unknowns: unknowns(&answers, omega),
            half,
            one_minus_square: one_minus_square(omega),
            scale,
            motion: None,
            solved: None,
            on_border: None,
        }
    }

    /// Ω.
    pub(super) fn omega(&self) -> F {
        self.given.omega
    }

    /// α.
    pub(super) fn alpha(&self) -> F {
        self.cycle.ratios().alpha()
    }

    /// sgn(1 − Ω).
    pub(super) fn sign(&self) -> F {
        F::int(1).with_sign_of(F::int(1) - self.omega())
    }

    /// K(Ω).
    pub(super) fn k(&self) -> F {
        self.formulae.phase_function(&self.phase_function)
    }

    /// The residual of an identity that holds 1 + cos π₁ as the paper writes it: beside Ω = 1/(2n+1) the sum keeps
    /// no more than the digits of 1/T², so that its terms count as larger by |T|.
    pub(super) fn near_pole(&self, residual: F) -> F {
        residual / self.scale
    }

    /// `1 + cos π₁ = 2 cos² β`, without cancellation.
    pub(super) fn one_plus_cos(&self) -> F {
        F::int(2) * self.phase_function.sin_cos().1.square()
    }

    /// The residual of `found = expected`, of which `doubt` is what they may differ by for other reasons than rounding: a
    /// difference as large as that counts one unit in the last place.
    pub(super) fn within(&self, residual: F, size: F, doubt: F) -> F {
        let unit = F::epsilon() * size + doubt;
        residual / unit * F::epsilon() * self.scale
    }
}

impl<F: Solvable> Case<'_, F> {
    /// What the exact motion and Newton's method add at (Ω, α), one after the other.
    pub(super) const MOTION: [fn(Self) -> Self; 2] = [Self::with_motion, Self::with_solution];
    /// What they add on the border at Ω.
    pub(super) const BORDER: [fn(Self) -> Self; 3] =
        [Self::with_border, Self::with_stops_beside_it, Self::with_optimum];

    fn with_motion(self) -> Self {
        Self { motion: Motion::at(self.cycle.ratios()), ..self }
    }

    fn with_solution(self) -> Self {
        Self { solved: F::solve(self.cycle.ratios()).ok(), ..self }
    }

    fn with_border(self) -> Self {
        Self { on_border: Some(OnBorder::at(self.formulae, &self.phase_function)), ..self }
    }

    fn with_stops_beside_it(self) -> Self {
        Self { on_border: self.on_border.map(|b| b.with_stops(self.omega())), ..self }
    }

    fn with_optimum(self) -> Self {
        let best = self.formulae.best_force_ratio_at(&self.phase_function);
        Self { on_border: self.on_border.map(|b| b.with_optimum(self.omega(), best)), ..self }
    }
}

/// The unknowns of eq. 21–25 by the answers, lengths in units of B, with t₂ − π/ω_d < t₁ < t₂.
fn unknowns<F: Float>(answers: &Answers<F>, omega: F) -> Unknowns<F> {
    let early = answers.velocity_phase > answers.displacement_phase;
    let turn = if early { F::int(2) * F::pi() } else { F::int(0) };
    Unknowns {
        velocity_phase: answers.velocity_phase - turn,
        displacement_phase: answers.displacement_phase,
        max_velocity: answers.max_velocity * omega,
        max_displacement: answers.max_displacement,
        deviation: answers.deviation,
    }
}
