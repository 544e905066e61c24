//! The motion of a cycle between its reversals, without damping or with it.

use super::damped::DampedCycle;
use super::displacement::reduce;
use super::stability::Multipliers;
use super::undamped::Undamped;
use crate::float::Float;
use crate::machine::ratios::Ratios;

/// The basis of a cycle's waveform, loop sizes and multipliers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Basis<F> {
    Undamped(Undamped<F>),
    Damped(DampedCycle<F>),
}

impl<F: Float> Basis<F> {
    /// Converts each part of the motion to another number type.
    pub(super) fn map<G: Float>(self, omega: F, to: impl Fn(F) -> G) -> Basis<G> {
        match self {
            Self::Undamped(cycle) => Basis::Undamped(cycle.map(omega, to)),
            Self::Damped(cycle) => Basis::Damped(cycle.map(to)),
        }
    }

    /// Loop sizes A₁ (eq. 64) and A₂ (eq. 67).
    #[inline(always)]
    pub(super) fn loop_sizes(&self, ratios: &Ratios<F>) -> (F, F) {
        match self {
            Self::Undamped(Undamped { reversal, .. }) => {
                (reversal.loop_size_stiffness(), reversal.loop_size_inertia(ratios.omega()))
            }
            Self::Damped(cycle) => cycle.rising.loop_sizes(ratios.alpha()),
        }
    }

    /// Displacement x/B and velocity x′/(Bω_d) at the phase since the peak displacement.
    pub(super) fn at(&self, omega: F, since_maximum: F) -> (F, F) {
        let after_maximum = reduce(since_maximum);
        let rising = after_maximum >= F::pi();
        let (x, v) = match self {
            Self::Undamped(cycle) => {
                let half = cycle.half(omega);
                let turns = if rising { F::int(3) } else { F::int(1) };
                let psi = (turns * F::pi() / F::int(2) - after_maximum) / omega;
                (half.displacement(psi), half.velocity(psi).value)
            }
            Self::Damped(cycle) => {
                cycle.rising_at(if rising { after_maximum - F::pi() } else { after_maximum })
            }
        };
        if rising { (x, v) } else { (-x, -v) }
    }

    /// The multipliers per half cycle.
    pub(super) fn multipliers(&self, omega: F) -> Multipliers<F> {
        match self {
            Self::Undamped(cycle) => cycle.multipliers(omega),
            Self::Damped(cycle) => Multipliers::of_half_cycle(cycle.multipliers()),
        }
    }
}
