//! The formulae that are checked: those of the library, or a set of wrong ones in tests.
//!
//! The default methods are the library's own. A test replaces them by wrong ones, one at a time, and each of
//! these must be detected: a check that never fails proves nothing. Methods that compare numbers require an
//! ordered type; the others accept any.

use crate::float::{Float, Real};
use crate::nonsticking::matching::{Given, Unknowns};
use crate::nonsticking::stability::{self, MultiplierPair};
use crate::nonsticking::{self, Border, Cycle, border, den_hartog};
use crate::phase_function::PhaseFunction;

/// The answers at one (Ω, α): lengths in B, velocities in B ω_d, phases in `[0, 2π)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answers<F> {
    pub(crate) max_displacement: F,
    pub(crate) displacement_phase: F,
    pub(crate) max_velocity: F,
    pub(crate) velocity_phase: F,
    pub(crate) deviation: F,
    pub(crate) loop_size_stiffness: F,
    pub(crate) loop_size_inertia: F,
    pub(crate) contraction: F,
    /// The multipliers of half a cycle.
    pub(crate) multipliers: MultiplierPair<F>,
}

/// The answers at one Ω.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge<F> {
    /// α_min.
    pub(crate) min_force_ratio: F,
    /// Eq. 61.
    pub(crate) turning_point: F,
    /// τ*.
    pub(crate) phase: F,
    /// S, the least Δ₀/B.
    pub(crate) least_displacement: F,
}

/// All formulae that are checked, each by its place in the library.
pub(crate) trait Formulae<F: Real>: core::fmt::Debug {
    /// K(Ω).
    fn phase_function(&self, p: &PhaseFunction<F>) -> F
    where
        F: Float,
    {
        p.value()
    }
    /// The answers at Ω.
    fn edge(&self, p: &PhaseFunction<F>) -> Edge<F>
    where
        F: Float,
    {
        let border = Border::at(p);
        Edge {
            min_force_ratio: border.min_force_ratio,
            turning_point: border.turning_point,
            phase: border.touching_phase,
            least_displacement: border.min_displacement,
        }
    }
    /// The answers at (Ω, α).
    fn answers(&self, cycle: &Cycle<F>) -> Answers<F>
    where
        F: Float,
    {
        Answers {
            max_displacement: cycle.max_displacement,
            displacement_phase: cycle.displacement_phase,
            max_velocity: cycle.max_velocity,
            velocity_phase: cycle.velocity_phase,
            deviation: cycle.deviation(),
            loop_size_stiffness: cycle.loop_size_stiffness(),
            loop_size_inertia: cycle.loop_size_inertia(),
            contraction: cycle.contraction(),
            multipliers: cycle.multipliers().pair(),
        }
    }
    /// x/B at a phase.
    fn displacement_at(&self, cycle: &Cycle<F>, phase: F) -> F
    where
        F: Float,
    {
        cycle.displacement_at(phase)
    }
    /// x′/(Bω_d) at a phase.
    fn velocity_at(&self, cycle: &Cycle<F>, phase: F) -> F
    where
        F: Float,
    {
        cycle.velocity_at(phase)
    }
    /// α* among the answers.
    fn best_force_ratio_at(&self, p: &PhaseFunction<F>) -> F
    where
        F: Float,
    {
        nonsticking::best_force_ratio_at(p)
    }
    /// A₁max among the answers.
    fn best_loop_size_at(&self, p: &PhaseFunction<F>) -> F
    where
        F: Float,
    {
        nonsticking::best_loop_size_at(p)
    }

    /// Eq. 15.
    fn rising_displacement(&self, g: &Given<F>, u: &Unknowns<F>, phase: F) -> F {
        g.rising_displacement(u, phase)
    }
    /// The derivative of eq. 15.
    fn rising_velocity(&self, g: &Given<F>, u: &Unknowns<F>, phase: F) -> F {
        g.rising_velocity(u, phase)
    }
    /// Eq. 16.
    fn falling_displacement(&self, g: &Given<F>, u: &Unknowns<F>, phase: F) -> F {
        g.falling_displacement(u, phase)
    }
    /// The derivative of eq. 16.
    fn falling_velocity(&self, g: &Given<F>, u: &Unknowns<F>, phase: F) -> F {
        g.falling_velocity(u, phase)
    }
    /// Eq. 21–25.
    fn residuals(&self, g: &Given<F>, u: &Unknowns<F>) -> [F; 5] {
        g.residuals(u)
    }
    /// Eq. 27.
    fn rho(&self, g: &Given<F>, u: &Unknowns<F>) -> F {
        g.rho(u)
    }
    /// Eq. 30.
    fn coefficient_a(&self, g: &Given<F>, u: &Unknowns<F>) -> F {
        g.coefficient_a(u)
    }
    /// Eq. 31.
    fn coefficient_b(&self, g: &Given<F>, u: &Unknowns<F>) -> F {
        g.coefficient_b(u)
    }
    /// Eq. 36.
    fn squared_rho(&self, g: &Given<F>, u: &Unknowns<F>) -> F {
        g.squared_rho(u)
    }
    /// Eq. 37.
    fn max_velocity(&self, g: &Given<F>, u: &Unknowns<F>, sign: F) -> F {
        g.max_velocity(u, sign)
    }
    /// Eq. 42.
    fn max_displacement_from_amplitude(&self, a: F, tangent: F, omega: F) -> F {
        nonsticking::max_displacement_from_amplitude(a, F::int(1), tangent, omega)
    }
    /// Eq. 44.
    fn max_displacement(&self, k: F, alpha: F, one_minus_square: F) -> F {
        nonsticking::max_displacement(k, alpha, one_minus_square)
    }
    /// Eq. 40.
    fn sin_displacement_phase(&self, max_displacement: F, alpha: F, one_minus_square: F) -> F {
        nonsticking::sin_displacement_phase(max_displacement, alpha, one_minus_square)
    }
    /// Eq. 41.
    fn cos_displacement_phase(&self, k: F, alpha: F) -> F {
        nonsticking::cos_displacement_phase(k, alpha)
    }
    /// Eq. 43.
    fn displacement_phase(&self, k: F, alpha: F, omega: F) -> F
    where
        F: Float,
    {
        nonsticking::displacement_phase(k, alpha, omega)
    }
    /// Eq. 46.
    fn velocity_phase_residual(&self, amplitude: F, omega: F, pi_1: (F, F), lag: F, sine: F) -> F {
        nonsticking::velocity_phase_residual(amplitude, omega, pi_1, lag, sine)
    }
    /// Eq. 47.
    fn deviation(&self, alpha: F, sine: F) -> F {
        nonsticking::deviation(alpha, sine)
    }
    /// Eq. 49.
    fn max_velocity_from_phase(&self, a: F, omega: F, cos_pi_1: F, at: (F, F), deviation: F, sign: F) -> F {
        nonsticking::max_velocity_from_phase(a, omega, cos_pi_1, at, deviation, sign)
    }
    /// Eq. 55.
    fn sine_coefficient(&self, tangent: F) -> F {
        den_hartog::sine_coefficient(F::int(1), tangent)
    }
    /// Eq. 56.
    fn cosine_coefficient(&self) -> F {
        den_hartog::cosine_coefficient(F::int(1))
    }
    /// Eq. 57.
    fn slip_excess(&self, alpha: F, sine: F, x: F) -> F {
        border::slip_excess(alpha, sine, F::int(1), x, F::int(1))
    }
    /// Eq. 60.
    fn turning_point_residual(&self, alpha: F, omega: F, tangent: F) -> F {
        border::turning_point_residual(F::int(1), alpha, omega, tangent)
    }
    /// Eq. 61.
    fn turning_point_border(&self, k: F, one_minus_square: F, omega: F) -> F {
        border::turning_point_border(k, one_minus_square, omega)
    }
    /// Eq. 63.
    fn loop_size(&self, max_displacement: F) -> F {
        nonsticking::loop_size(F::int(1), max_displacement)
    }
    /// Eq. 64.
    fn loop_size_stiffness(&self, max_displacement: F, alpha: F) -> F {
        nonsticking::loop_size_stiffness(max_displacement, alpha)
    }
    /// Eq. 65.
    fn best_force_ratio(&self, k: F) -> F {
        nonsticking::best_force_ratio(k)
    }
    /// Eq. 66.
    fn best_loop_size(&self, k: F, one_minus_square: F) -> F {
        nonsticking::best_loop_size(k, one_minus_square)
    }
    /// Eq. 67.
    fn loop_size_inertia(&self, loop_size_stiffness: F, omega: F) -> F {
        nonsticking::loop_size_inertia(loop_size_stiffness, omega)
    }
    /// The determinant of the half-cycle map.
    fn multiplier_product(&self, omega: F, max_displacement: F) -> F {
        stability::multiplier_product(omega, max_displacement)
    }
}

/// The library's own formulae.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Library;

impl<F: Real> Formulae<F> for Library {}
