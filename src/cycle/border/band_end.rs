//! Where the bands below the poles end, on which the border is not at the turning point.

use crate::float::Float;
use crate::root;

/// The point u_e where the two values of S cross, by its angle: β = π/2Ω = nπ + γ.
pub(super) struct BandEnd<F> {
    gamma: F,
    /// u = 1/Ω
    inverse: F,
}

impl<F: Float> BandEnd<F> {
    /// The end of the band below the pole 1/(2n+1), n ≥ 1.
    ///
    /// `−tan γ = u tan(π/2u)`, u = 2n + 2γ/π: where the two values of S cross, the velocity of the inner one
    /// touches zero at σ = π ([`super::lobe`]). Multiplied by cos γ it is smooth through the pole, and as
    /// well conditioned for n = 10⁵ as for n = 1.
    pub(super) fn of(index: u16) -> Self {
        let half_pi = F::pi() / F::int(2);
        let inverse = |gamma: F| F::int(2) * F::int(i32::from(index)) + gamma / half_pi;
        let excess = |gamma: F| {
            let (u, (s, c)) = (inverse(gamma), gamma.sin_cos());
            -(s + u * (half_pi / u).tan() * c)
        };
        let (_, gamma) = root::enclosed(half_pi, half_pi * F::ratio(15, 8), excess);
        Self { gamma, inverse: inverse(gamma) }
    }

    pub(super) fn omega(&self) -> F {
        F::int(1) / self.inverse
    }

    /// The border there, eq. 61: `(u² − 1) √(1 + T²/u²)`.
    pub(super) fn border(&self) -> F {
        let one = F::int(1);
        (self.inverse.square() - one) * one.hypot(self.gamma.tan() / self.inverse)
    }
}
