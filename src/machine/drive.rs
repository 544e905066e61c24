//! The excitation: a force, or a motion of the foot or the base.

use super::oscillator::Oscillator;
use crate::float::{Field, Float};
use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::{Ratios, finite, positive};
use crate::named::named;

named! {
    /// The kind of a harmonic excitation, and the quantity that gives its amplitude.
    ///
    /// Two kinds of base motion must be distinguished. If only the **foot** of the spring moves, the surface
    /// under the body is fixed, x is the displacement over the surface, and the force is that of the spring. If
    /// the base also carries the **surface**, as under an isolator or in an earthquake, x is the displacement
    /// relative to the base, and the force is that of inertia.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum Excitation displayed [
        /// The text that [`Display`](core::fmt::Display) prints.
        #[doc(hidden)]
    ] {
        /// A force `p₀ sin ω_d t` on the body.
        Force = "force on the body",
        /// The force of a mass m_e that rotates on the body at an eccentricity e with the speed ω_d, given by the
        /// unbalance m_e e: `p₀ = m_e e ω_d²`. The mass m is that of the whole body, with m_e.
        Unbalance = "rotating unbalance on the body",
        /// A motion `u₀ sin ω_d t` of the foot of the spring over a fixed surface: `p₀ = k u₀`. This is the
        /// paper's base motion (`docs/errata.md`, 7).
        FootMotion = "motion of the spring's foot over a fixed surface",
        /// A motion `u₀ sin ω_d t` of the foot of the spring, on which the damper stands as well: `p₀ = √(k² +
        /// c²ω_d²) u₀`, ahead of the motion by [`Drive::phase_lead`].
        DampedFootMotion = "motion of the foot of spring and damper over a fixed surface",
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
    const fn quantity(self) -> Quantity {
        match self {
            Self::Force => Quantity::ForceAmplitude,
            Self::Unbalance => Quantity::Unbalance,
            Self::FootMotion | Self::DampedFootMotion | Self::SurfaceMotion => Quantity::BaseAmplitude,
            Self::SurfaceVelocity => Quantity::BaseVelocity,
            Self::SurfaceAcceleration => Quantity::BaseAcceleration,
        }
    }

    /// Whether the foot of the spring moves over a fixed surface, so that the force on the body depends on
    /// its stiffness.
    #[doc(hidden)]
    #[must_use]
    pub const fn moves_foot(self) -> bool {
        matches!(self, Self::FootMotion | Self::DampedFootMotion)
    }

    /// Whether the base carries the surface along, so that x is relative to the base.
    #[doc(hidden)]
    #[must_use]
    pub const fn carries_surface(self) -> bool {
        matches!(self, Self::SurfaceMotion | Self::SurfaceVelocity | Self::SurfaceAcceleration)
    }

    /// Whether the foot or the base moves, so that the body's absolute displacement and that of its support are two.
    pub(crate) const fn moves_base(self) -> bool {
        self.moves_foot() || self.carries_surface()
    }
}

/// The force on the support under an excitation, if there is one.
///
/// If the foot moves, foot and surface together carry the force m x″, which is `Ω²` times the acceleration, because
/// nothing else acts on the body. The transmissibility is then the ratio of the accelerations of body and foot, where a
/// damper on the foot leaves `√(1 + (2ζΩ)²) u₀ = p₀/k`. Otherwise the two values are the force of spring, damper and
/// friction, and that force over p₀.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Support<F> {
    pub(crate) excitation: Option<Excitation>,
    pub(crate) omega: F,
    pub(crate) alpha: F,
    pub(crate) damping_ratio: F,
}

impl<F: Float> From<&Ratios<F>> for Support<F> {
    fn from(ratios: &Ratios<F>) -> Self {
        Self {
            excitation: ratios.excitation(),
            omega: ratios.omega(),
            alpha: ratios.alpha(),
            damping_ratio: ratios.damping_ratio(),
        }
    }
}

impl<F: Field> Support<F> {
    /// Whether the support carries m x″, so that its force is that of the maximum acceleration.
    pub(crate) fn is_foot(&self) -> bool {
        self.excitation.is_some_and(Excitation::moves_foot)
    }

    /// The transmitted force in r_y: of the maximum acceleration in B ω_d² where the foot moves, otherwise the maximum
    /// force of spring, damper and friction.
    pub(crate) fn force(&self, carried: F) -> F {
        if self.is_foot() { carried * self.omega.square() } else { carried }
    }

    /// The transmissibility, from the same maximum.
    pub(crate) fn transmissibility(&self, carried: F) -> F {
        if self.excitation == Some(Excitation::DampedFootMotion) {
            let damper = F::int(2) * self.damping_ratio * self.omega;
            return carried * F::int(1).hypot(damper) / self.alpha;
        }
        carried / self.alpha
    }
}

/// A harmonic drive: a force `p₀ sin ω_d t` on the body, or a motion of its base ([`Excitation`]), and a
/// constant force p̄ if there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::DriveFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct Drive<F> {
    excitation: Excitation,
    amplitude: F,
    angular_frequency: F,
    mean_force: F,
}

impl<F: Float> Drive<F> {
    /// A drive of the given kind and amplitude at the angular frequency ω_d.
    ///
    /// # Errors
    /// Where the amplitude or ω_d is not finite or not > 0.
    pub fn new(excitation: Excitation, amplitude: F, angular_frequency: F) -> Result<Self, Error> {
        Ok(Self {
            excitation,
            amplitude: positive(excitation.quantity(), amplitude)?,
            angular_frequency: positive(Quantity::AngularFrequency, angular_frequency)?,
            mean_force: F::int(0),
        })
    }

    /// A force `p₀ sin ω_d t`.
    ///
    /// # Errors
    /// Where p₀ or ω_d is not finite or not > 0.
    pub fn force(amplitude: F, angular_frequency: F) -> Result<Self, Error> {
        Self::new(Excitation::Force, amplitude, angular_frequency)
    }

    /// The force `p₀ = α r_y` at the angular frequency ω_d.
    ///
    /// # Errors
    /// Where α or ω_d is not finite or not > 0, or p₀ overflows or underflows.
    pub fn with_force_ratio(
        oscillator: &Oscillator<F>,
        alpha: F,
        angular_frequency: F,
    ) -> Result<Self, Error> {
        let alpha = positive(Quantity::ForceRatio, alpha)?;
        Self::force(alpha * oscillator.friction_bound(), angular_frequency)
    }

    /// This drive with a constant force p̄ on the body, such as its weight along an inclined surface or a
    /// preload.
    ///
    /// The constant force shifts the motion by p̄/k ([`super::oscillator::Scales::mean_displacement`]) and the force on
    /// the support by p̄. Answers to a harmonic drive are about this mean: displacements are from the mean displacement,
    /// and the transmitted force is without p̄, so that neither changes. Under a record every displacement and force is
    /// the whole one ([`crate::motion::record::Body::with_mean_force`]).
    ///
    /// # Errors
    /// Where p̄ is not finite.
    pub fn with_mean_force(self, mean_force: F) -> Result<Self, Error> {
        Ok(Self { mean_force: finite(Quantity::MeanForce, mean_force)?, ..self })
    }

    /// Angular frequency ω_d.
    pub const fn angular_frequency(&self) -> F {
        self.angular_frequency
    }

    /// The amplitude as given: p₀ of a force, the unbalance m_e e, or the amplitude of the base motion.
    pub const fn amplitude(&self) -> F {
        self.amplitude
    }

    /// The kind of excitation.
    pub const fn excitation(&self) -> Excitation {
        self.excitation
    }

    /// The constant force p̄; 0 by default.
    pub(crate) const fn mean_force(&self) -> F {
        self.mean_force
    }

    /// The same excitation at another angular frequency.
    ///
    /// # Errors
    /// Where ω_d is not finite or not > 0.
    pub(crate) fn at_frequency(&self, angular_frequency: F) -> Result<Self, Error> {
        Ok(Self { angular_frequency: positive(Quantity::AngularFrequency, angular_frequency)?, ..*self })
    }

    /// Whether the force on the body is the same at every ω_d.
    pub(crate) const fn is_same_at_any_frequency(&self) -> bool {
        matches!(
            self.excitation,
            Excitation::Force | Excitation::FootMotion | Excitation::SurfaceAcceleration
        )
    }

    /// The amplitude p₀ of the force on the body of `oscillator`, according to the [`Excitation`].
    pub fn force_amplitude(&self, oscillator: &Oscillator<F>) -> F {
        let (amplitude, frequency) = (self.amplitude, self.angular_frequency);
        match self.excitation {
            Excitation::Force => amplitude,
            Excitation::Unbalance => amplitude * frequency.square(),
            Excitation::FootMotion => oscillator.stiffness() * amplitude,
            Excitation::DampedFootMotion => {
                oscillator.stiffness().hypot(oscillator.damping() * frequency) * amplitude
            }
            Excitation::SurfaceMotion => oscillator.mass() * frequency.square() * amplitude,
            Excitation::SurfaceVelocity => oscillator.mass() * frequency * amplitude,
            Excitation::SurfaceAcceleration => oscillator.mass() * amplitude,
        }
    }

    /// The phase by which the force on the body is ahead of the motion of the base: `atan(c ω_d/k)` of a foot
    /// with a damper, otherwise 0.
    ///
    /// Phases of this crate are those of the force, ω_d t. The displacement of the base is
    /// `u₀ sin(ω_d t − lead)`, however its amplitude was given.
    pub fn phase_lead(&self, oscillator: &Oscillator<F>) -> F {
        if self.excitation == Excitation::DampedFootMotion {
            (oscillator.damping() * self.angular_frequency).atan2(oscillator.stiffness())
        } else {
            F::int(0)
        }
    }

    /// The ratios of `oscillator` under this drive: `Ω = ω_d/ω_n` (eq. 9), `α = p₀/r_y` (eq. 8), ζ, η and the excitation.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`Ratios`].
    pub fn ratios(&self, oscillator: &Oscillator<F>) -> Result<Ratios<F>, Error> {
        Ratios::new(
            self.angular_frequency / oscillator.natural_frequency(),
            self.force_amplitude(oscillator) / oscillator.friction_bound(),
        )?
        .with_damping_ratio(oscillator.damping_ratio())?
        .with_static_friction_ratio(oscillator.static_friction_ratio())
        .map(|ratios| ratios.with_excitation(self.excitation))
    }
}
