//! The kinds of excitation: a force, or a motion of the support or the base.

use crate::float::Field;
use crate::machine::error::Quantity;
use crate::named::named;

named! {
    /// The kind of a harmonic excitation, and the quantity that gives its amplitude.
    ///
    /// Two kinds of base motion must be distinguished. If only the **support** of the spring moves, the surface
    /// under the body is fixed, x is the displacement over the surface, and the force is that of the spring. If
    /// the base also carries the **surface**, as under an isolator or in an earthquake, x is the displacement
    /// relative to the base, and the force is that of inertia.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum Excitation [name] {
        /// A force `p₀ sin ω_d t` on the body.
        Force = "force on the body",
        /// The force of a mass m_e that rotates on the body at an eccentricity e with the speed ω_d, given by the
        /// unbalance m_e e: `p₀ = m_e e ω_d²`. The mass m is that of the whole body, with m_e.
        Unbalance = "rotating unbalance on the body",
        /// A motion `u₀ sin ω_d t` of the support of the spring over a fixed surface: `p₀ = k u₀`. This is the
        /// paper's base motion (`docs/errata.md`, 7).
        FootMotion = "motion of the spring's support over a fixed surface",
        /// A motion `u₀ sin ω_d t` of the support of the spring, on which the damper stands as well: `p₀ = √(k² +
        /// c²ω_d²) u₀`, ahead of the motion by [`Drive::phase_lead`](crate::Drive::phase_lead).
        DampedFootMotion = "motion of the support of spring and damper over a fixed surface",
        /// A motion `u₀ sin ω_d t` of a base that carries the surface along, given by its displacement amplitude:
        /// `p₀ = m ω_d² u₀`.
        SurfaceMotion = "motion of the base with its surface",
        /// A motion of a base that carries the surface along, given by its velocity amplitude `ω_d u₀`: `p₀ = m
        /// ω_d · (ω_d u₀)`.
        SurfaceVelocity = "motion of the base with its surface, by velocity",
        /// A motion of a base that carries the surface along, given by its acceleration amplitude `ω_d² u₀`: `p₀
        /// = m · (ω_d² u₀)`.
        SurfaceAcceleration = "motion of the base with its surface, by acceleration",
    }
}

impl Excitation {
    /// The quantity of the amplitude.
    pub(super) const fn quantity(self) -> Quantity {
        match self {
            Self::Force => Quantity::ForceAmplitude,
            Self::Unbalance => Quantity::Unbalance,
            Self::FootMotion | Self::DampedFootMotion | Self::SurfaceMotion => Quantity::BaseAmplitude,
            Self::SurfaceVelocity => Quantity::BaseVelocity,
            Self::SurfaceAcceleration => Quantity::BaseAcceleration,
        }
    }

    /// The amplitude p₀ of the force on a body of mass m on a spring k and a damper c. It does not decrease in any of
    /// the numbers.
    pub(crate) fn force_amplitude<F: Field>(
        self,
        amplitude: F,
        frequency: F,
        [mass, stiffness, damping]: [F; 3],
    ) -> F {
        match self {
            Self::Force => amplitude,
            Self::Unbalance => amplitude * frequency.square(),
            Self::FootMotion => stiffness * amplitude,
            Self::DampedFootMotion => stiffness.hypot(damping * frequency) * amplitude,
            Self::SurfaceMotion => mass * frequency.square() * amplitude,
            Self::SurfaceVelocity => mass * frequency * amplitude,
            Self::SurfaceAcceleration => mass * amplitude,
        }
    }

    /// Whether the support or the base moves, so that the body's absolute displacement and that of its support are two.
    pub(crate) const fn moves_base(self) -> bool {
        self.moves_foot() || self.carries_surface()
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl Excitation {
    /// All kinds.
    pub const ALL: [Self; 7] = [
        Self::Force,
        Self::Unbalance,
        Self::FootMotion,
        Self::DampedFootMotion,
        Self::SurfaceMotion,
        Self::SurfaceVelocity,
        Self::SurfaceAcceleration,
    ];

    /// Whether the support of the spring moves over a fixed surface, so that the force on the body depends on
    /// its stiffness.
    #[must_use]
    pub const fn moves_foot(self) -> bool {
        matches!(self, Self::FootMotion | Self::DampedFootMotion)
    }

    /// Whether the base carries the surface along, so that x is relative to the base.
    #[must_use]
    pub const fn carries_surface(self) -> bool {
        matches!(self, Self::SurfaceMotion | Self::SurfaceVelocity | Self::SurfaceAcceleration)
    }
}
