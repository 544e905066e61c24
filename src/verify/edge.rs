//! The references for the border at one Ω: the cycle there by Newton's method, and the exact motion on either
//! side.

use super::Solvable;
use super::followed::third_of_digits;
use super::formulae::{Edge, Formulae};
use crate::exact::{LongRun, State, SteadyState};
use crate::float::Float;
use crate::nonsticking::matching::newton::Solution;
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// The results on the border at one Ω.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnBorder<F> {
    pub(super) edge: Edge<F>,
    /// Eq. 21–25 solved at α_min.
    pub(super) solved: Option<Solution<F>>,
    /// Eq. 21–25, 58 and 59 solved for α.
    pub(super) turning_point: Option<F>,
    /// The numbers of stops in a cycle slightly below α_min and slightly above.
    pub(super) stops: Option<(u32, u32)>,
    /// A₁ at α* from the work against friction, and its relative slope there.
    pub(super) optimum: Option<(F, F)>,
}

impl<F: Solvable> OnBorder<F> {
    /// The border at the frequency ratio of `p` by these formulae.
    pub(super) fn at(formulae: &dyn Formulae<F>, p: &PhaseFunction<F>) -> Self {
        let (omega, edge) = (p.omega(), formulae.edge(p));
        let at = |alpha: F| Ratios::new(omega, alpha).ok();
        let solved = at(edge.min_force_ratio).and_then(|ratios| F::solve(ratios).ok());
        Self {
            edge,
            solved: solved.filter(|s| s.lost_bits.saturating_mul(2) < F::PRECISION),
            turning_point: F::solve_border(omega).ok().map(|found| found.force_ratio),
            stops: None,
            optimum: None,
        }
    }

    /// Adds the stops on either side.
    pub(super) fn with_stops(self, omega: F) -> Self {
        let at = |alpha: F| Ratios::new(omega, alpha).ok();
        Self { stops: stops_beside(omega, self.edge.min_force_ratio, at), ..self }
    }

    /// Adds the dissipation at the best force ratio.
    pub(super) fn with_optimum(self, omega: F, best: F) -> Self {
        Self { optimum: optimum(omega, best), ..self }
    }
}

/// The steady motion from rest.
fn steady<F: Float>(ratios: Ratios<F>) -> Option<SteadyState<F>> {
    LongRun::from_start(ratios, State::default()).ok()?.steady_state().copied()
}

/// A₁ of the exact motion from its work against friction; `None` unless the motion has two reversals and no
/// stop.
pub(super) fn loop_size<F: Float>(ratios: Ratios<F>) -> Option<F> {
    let (steady, alpha) = (steady(ratios)?, ratios.alpha());
    let slides = steady.sticks_per_cycle == 0 && steady.velocity_zeros_per_cycle == 2;
    slides.then(|| F::int(2) * (steady.energy_out / alpha) / alpha)
}

/// Stops of the exact motion at α (1 − 2⁻¹⁶) and at α (1 + 2⁻¹⁶). Next to a pole the body need not stop below
/// the border ([errata](crate::nonsticking::printed) 4), and the stops are not checked.
pub(super) fn stops_beside<F: Float>(
    omega: F,
    alpha: F,
    at: impl Fn(F) -> Option<Ratios<F>>,
) -> Option<(u32, u32)> {
    let turns = F::int(1) / omega;
    let nearest = F::int(2) * ((turns - F::int(1)) / F::int(2)).round() + F::int(1);
    let far = (turns - nearest).abs() * F::int(128) > F::int(1);
    let little = F::exp2i((F::PRECISION as i32 / 3).min(16).saturating_neg());
    let one = F::int(1);
    let stops = |alpha: F| steady(at(alpha)?).map(|s| s.sticks_per_cycle);
    far.then(|| Some((stops(alpha * (one - little))?, stops(alpha * (one + little))?)))?
}

/// A₁ at α and `(α/A₁) dA₁/dα` there, by central differences; `None` where the body stops at α or slightly
/// below.
fn optimum<F: Float>(omega: F, alpha: F) -> Option<(F, F)> {
    let (one, h) = (F::int(1), third_of_digits::<F>());
    let at = |alpha: F| loop_size(Ratios::new(omega, alpha).ok()?);
    let _ = at(alpha * F::ratio(99, 100))?;
    let (here, ahead, back) = (at(alpha)?, at(alpha * (one + h))?, at(alpha * (one - h))?);
    Some((here, (ahead - back) / (F::int(2) * h * here)))
}
