//! A cycle with all quantities that the identities use.

use super::Solvable;
use super::edge::OnBorder;
use super::followed::Motion;
use super::formulae::Formulae;
#[cfg(test)]
use super::formulae::Library;
use super::terms::{Point, Terms};
use crate::float::Float;
use crate::nonsticking::Cycle;
use crate::nonsticking::matching::newton::Solution;
use crate::nonsticking::matching::pi_1;
use crate::phase_function::{PhaseFunction, one_minus_square};
use core::ops::Deref;

/// A cycle with all quantities that the identities use: the terms of the closed forms, and more.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case<'a, F> {
    terms: Terms<'a, F>,
    pub(super) cycle: Cycle<F>,
    pub(super) phase_function: PhaseFunction<F>,
    /// The exact motion at the same (Ω, α).
    pub(super) motion: Option<Motion<F>>,
    /// Eq. 21–25 solved at the same (Ω, α).
    pub(super) solved: Option<Solution<F>>,
    /// The results on the border at Ω, in one case of each Ω.
    pub(super) on_border: Option<OnBorder<F>>,
}

impl<'a, F> Deref for Case<'a, F> {
    type Target = Terms<'a, F>;

    fn deref(&self) -> &Terms<'a, F> {
        &self.terms
    }
}

#[cfg(test)]
impl<F: Float> Case<'static, F> {
    /// The case of a cycle for the identities that use only the closed forms.
    pub(crate) fn new(cycle: Cycle<F>) -> Self {
        Case::by(&Library, cycle)
    }
}

impl<'a, F: Float> Case<'a, F> {
    /// The case of a cycle by these formulae.
    pub(super) fn by(formulae: &'a dyn Formulae<F>, cycle: Cycle<F>) -> Self {
        let (omega, alpha) = (cycle.ratios.omega(), cycle.ratios.alpha());
        let phase_function = PhaseFunction::of_valid(omega);
        let answers = formulae.answers(&cycle);
        let cos_pi_1 = pi_1(omega).cos();
        let s = formulae.multiplier_product(omega, answers.max_displacement);
        let point = Point {
            given: cycle.given(),
            alpha,
            k: formulae.phase_function(&phase_function),
            tangent: phase_function.tangent(),
            cos_beta: phase_function.sin_cos().1,
            one_minus_square: one_minus_square(omega),
            sign: F::int(1).with_sign_of(F::int(1) - omega),
            best: (
                formulae.best_force_ratio_at(&phase_function),
                formulae.best_loop_size_at(&phase_function),
            ),
            is_complex: Some(((F::int(1) + s) * cos_pi_1).square() < F::int(4) * s),
            is_late: answers.velocity_phase > answers.displacement_phase,
        };
        let terms = Terms::new(formulae, point, answers);
        Self { terms, cycle, phase_function, motion: None, solved: None, on_border: None }
    }

    /// The residual of `found = expected`, where `doubt` is the difference that causes other than rounding
    /// may produce. A difference of that size counts as one unit in the last place.
    pub(super) fn within(&self, residual: F, size: F, doubt: F) -> F {
        let unit = F::epsilon() * size + doubt;
        residual / unit * F::epsilon() * self.scale
    }
}

impl<F: Solvable> Case<'_, F> {
    /// The steps that add the exact motion and the solution by Newton's method at (Ω, α).
    pub(super) const MOTION: [fn(Self) -> Self; 2] = [Self::with_motion, Self::with_solution];
    /// The steps that add the same on the border at Ω.
    pub(super) const BORDER: [fn(Self) -> Self; 3] =
        [Self::with_border, Self::with_stops_beside_it, Self::with_optimum];

    fn with_motion(self) -> Self {
        Self { motion: Motion::at(self.cycle.ratios), ..self }
    }

    fn with_solution(self) -> Self {
        Self { solved: F::solve(self.cycle.ratios).ok(), ..self }
    }

    fn with_border(self) -> Self {
        Self { on_border: Some(OnBorder::at(self.formulae, &self.phase_function)), ..self }
    }

    fn with_stops_beside_it(self) -> Self {
        Self { on_border: self.on_border.map(|b| b.with_stops(self.given.omega)), ..self }
    }

    fn with_optimum(self) -> Self {
        let best = self.formulae.best_force_ratio_at(&self.phase_function);
        Self { on_border: self.on_border.map(|b| b.with_optimum(self.given.omega, best)), ..self }
    }
}
