//! The border: the cycle there by Newton's method, the exact motion on either side, and the optimum of the dissipation.
//!
//! On the border of the two-reversal cycle the body just does not stop: either the force left over at the turning point is r_y, or
//! the velocity touches zero once on the way. Less force is a stop, and more is none.

use super::formulae::{Edge, Formulae};
use super::motion::third_of_digits;
use super::solved::points;
use super::{Case, Digits, Identity, Residual, Solvable, Standing};
use crate::exact::{LongRun, State, SteadyState};
use crate::float::Float;
use crate::nonsticking::matching::newton::Solution;
use crate::phase_function::PhaseFunction;
use crate::ratios::Ratios;

/// What is found on the border at one Ω.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnBorder<F> {
    edge: Edge<F>,
    /// Eq. 21–25 solved at α_min.
    solved: Option<Solution<F>>,
    /// Eq. 21–25, 58 and 59 solved for α.
    turning_point: Option<F>,
    /// Stops in a cycle a little below α_min, and a little above.
    stops: Option<(u32, u32)>,
    /// A₁ by the work against friction at α*, and its relative slope there.
    optimum: Option<(F, F)>,
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

    /// The same with the stops on either side.
    pub(super) fn with_stops(self, omega: F) -> Self {
        let at = |alpha: F| Ratios::new(omega, alpha).ok();
        Self { stops: stops_beside(omega, self.edge.min_force_ratio, at), ..self }
    }

    /// The same with what is dissipated at the best force ratio.
    pub(super) fn with_optimum(self, omega: F, best: F) -> Self {
        Self { optimum: optimum(omega, best), ..self }
    }
}

/// The steady motion from rest.
fn steady<F: Float>(ratios: Ratios<F>) -> Option<SteadyState<F>> {
    LongRun::from_start(ratios, State::rest()).ok()?.steady_state().copied()
}

/// A₁ of the exact motion, by its work against friction; `None` where it is not one of two reversals without a stop.
pub(super) fn loop_size<F: Float>(ratios: Ratios<F>) -> Option<F> {
    let (steady, alpha) = (steady(ratios)?, ratios.alpha());
    let slides = steady.sticks_per_cycle() == 0 && steady.velocity_zeros_per_cycle() == 2;
    slides.then(|| F::int(2) * (steady.energy_out() / alpha) / alpha)
}

/// Stops of the exact motion at α (1 − 2⁻¹⁶) and at α (1 + 2⁻¹⁶). Next to a pole the body need not stop below the border
/// ([errata](crate::nonsticking::printed) 4), and this is not asked there.
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
    let stops = |alpha: F| steady(at(alpha)?).map(|s| s.sticks_per_cycle());
    far.then(|| Some((stops(alpha * (one - little))?, stops(alpha * (one + little))?)))?
}

/// A₁ at α and `(α/A₁) dA₁/dα` there, by central differences; `None` where the body stops at α or a little below.
fn optimum<F: Float>(omega: F, alpha: F) -> Option<(F, F)> {
    let (one, h) = (F::int(1), third_of_digits::<F>());
    let at = |alpha: F| loop_size(Ratios::new(omega, alpha).ok()?);
    let _ = at(alpha * F::ratio(99, 100))?;
    let (here, ahead, back) = (at(alpha)?, at(alpha * (one + h))?, at(alpha * (one - h))?);
    Some((here, (ahead - back) / (F::int(2) * h * here)))
}

macro_rules! on_border {
    ($($equation:literal $digits:ident $statement:literal: |$c:ident, $b:ident| $residual:expr),+ $(,)?) => {
        vec![$(Identity {
            equation: $equation,
            statement: $statement,
            standing: Standing::Holds,
            digits: Digits::$digits,
            residual: Residual::OfCase(|$c: &Case<'_, F>| { let $b = $c.on_border.as_ref()?; $residual }),
        }),+]
    };
}

/// A residual in units of `size`, in the digits that the solution has.
fn relative<F: Float>(c: &Case<'_, F>, s: &Solution<F>, residual: F, size: F) -> Option<F> {
    let lost = F::exp2i((s.lost_bits as i32).min(F::RATIO_EXPONENT));
    Some(residual / (size * lost) * c.scale)
}

pub(super) fn identities<F: Float>() -> Vec<Identity<F>> {
    on_border![
        "58, 59" All "Newton's method with α free: the turning point's border": |c, b| {
            let per_turn = (F::int(1) + F::int(1) / c.given.omega).square();
            Some((b.turning_point? / b.edge.turning_point - F::int(1)) / per_turn * c.scale)
        },
        "62" All "Newton's method on the border: nowhere in the half cycle does the body go back": |c, b| {
            let s = b.solved.as_ref()?;
            let (g, u, n) = (given(c, b), &s.unknowns, points(c.given.omega));
            let most = (1..n).fold(F::int(0), |most, i| {
                most.or_larger(g.falling_velocity(u, u.displacement_phase + F::pi() * F::ratio(i, n)))
            });
            relative(c, s, most, u.max_velocity)
        },
        "62" All "Newton's method on the border: at τ* the velocity and the acceleration are zero": |c, b| {
            let s = b.solved.as_ref()?;
            let (g, u) = (given(c, b), &s.unknowns);
            let phase = u.displacement_phase + b.edge.phase;
            let x = g.falling_displacement(u, phase);
            let acceleration = b.edge.min_force_ratio * phase.sin() - x + F::int(1);
            let velocity = g.falling_velocity(u, phase);
            relative(c, s, acceleration.abs() + velocity.abs(), F::int(1) + u.max_displacement + u.max_velocity)
        },
        "62" All "Newton's method on the border: Δ₀/B is S": |c, b| {
            let s = b.solved.as_ref()?;
            relative(c, s, s.unknowns.max_displacement - b.edge.least_displacement, b.edge.least_displacement)
        },
        "62" All "the exact motion stops just below the border, and not above": |c, b| {
            let (below, above) = b.stops?;
            Some(if below > 0 && above == 0 { F::int(0) } else { c.scale })
        },
        "65" Half "A₁ of the exact motion is stationary at α*, by differences": |c, b| {
            Some(b.optimum?.1 * c.scale)
        },
        "66" All "A₁ of the exact motion at α* is A₁max": |c, b| {
            let most = c.formulae.best_loop_size_at(&c.phase_function);
            Some((b.optimum?.0 / most - F::int(1)) * c.scale)
        },
    ]
}

/// What the matching problem is given on the border.
fn given<F: Float>(c: &Case<'_, F>, b: &OnBorder<F>) -> crate::nonsticking::matching::Given<F> {
    let amplitude = b.edge.min_force_ratio / c.one_minus_square;
    crate::nonsticking::matching::Given { amplitude, ..c.given }
}
