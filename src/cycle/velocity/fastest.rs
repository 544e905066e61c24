//! The greatest velocity, and where it is.

use super::super::half_cycle::HalfCycle;
use crate::float::Float;

/// The point of peak velocity of a half cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fastest<F> {
    /// Its centred time ψ.
    pub(crate) psi: F,
    /// `V₀/(Bω_d)`.
    pub(crate) velocity: F,
}

impl<F: Float> Fastest<F> {
    /// This maximum of the velocity with its derivatives: ψ as the root of v′ = 0, the velocity at the constant ψ, where it is
    /// stationary.
    #[inline]
    pub(super) fn differentiated(self, half: impl Fn() -> HalfCycle<F>) -> Self {
        let psi = self.psi.implicit_root(|psi| {
            let jet = half().velocity(psi);
            (jet.first, jet.second)
        });
        let velocity = self.velocity.differentiated_as(|| half().velocity(psi.constant()).value);
        Self { psi, velocity }
    }
}
