//! A cycle as the matching problem and as Den Hartog's half cycle: both are equations without damping.

use super::Cycle;
use crate::float::Float;
use crate::nonsticking::den_hartog;
use crate::nonsticking::matching;
use crate::phase_function::PhaseFunction;

impl<F: Float> Cycle<F> {
    /// The given quantities of the paper's matching problem: A/B, B/B = 1 and Ω. Its equations have no
    /// damping: with damping A is NaN.
    pub(crate) fn given(&self) -> matching::Given<F> {
        matching::Given {
            amplitude: self.undamped_amplitude(),
            friction_displacement: F::int(1),
            omega: self.ratios.omega(),
        }
    }

    /// The solution of the matching problem (eq. 21–25), lengths in units of B, with ω_d t₁ taken so that
    /// t₂ − π/ω_d < t₁ < t₂.
    pub(crate) fn unknowns(&self) -> matching::Unknowns<F> {
        let early = self.velocity_phase > self.displacement_phase;
        let turn = if early { F::int(2) * F::pi() } else { F::int(0) };
        matching::Unknowns {
            velocity_phase: self.velocity_phase - turn,
            displacement_phase: self.displacement_phase,
            max_velocity: self.max_velocity * self.ratios.omega(),
            max_displacement: self.max_displacement,
            deviation: self.deviation(),
        }
    }

    /// Den Hartog's half cycle of the same motion (eq. 54), in units of B. NaN with damping.
    pub(crate) fn den_hartog(&self) -> den_hartog::FallingHalf<F> {
        let one = F::int(1);
        den_hartog::FallingHalf {
            amplitude: self.undamped_amplitude(),
            friction_displacement: one,
            omega: self.ratios.omega(),
            phase_lag: den_hartog::phase_lag(self.displacement_phase),
            c1: den_hartog::sine_coefficient(one, PhaseFunction::of_valid(self.ratios.omega()).tangent()),
            c2: den_hartog::cosine_coefficient(one),
        }
    }

    /// The forced amplitude A/B of the equations without damping; NaN with damping.
    fn undamped_amplitude(&self) -> F {
        if self.ratios.is_damped() { F::int(0) / F::int(0) } else { self.ratios.forced_amplitude() }
    }
}
