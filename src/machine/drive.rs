//! The excitation of a machine, with its amplitude and its frequency.

use super::oscillator::Oscillator;
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::{Ratios, finite, positive};

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

/// Displays the excitation with its numbers: `force on the body: 12 at ω_d = 6`.
impl<F: Float> core::fmt::Display for Drive<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}: {} at ω_d = {}", self.excitation, self.amplitude, self.angular_frequency)?;
        if self.mean_force == F::int(0) { Ok(()) } else { write!(f, ", p̄ = {}", self.mean_force) }
    }
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
    pub const fn mean_force(&self) -> F {
        self.mean_force
    }

    /// This drive at another angular frequency.
    ///
    /// # Errors
    /// Where ω_d is not finite or not > 0.
    pub fn at(&self, angular_frequency: F) -> Result<Self, Error> {
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
        let body = [oscillator.mass(), oscillator.stiffness(), oscillator.damping()];
        self.excitation.force_amplitude(self.amplitude, self.angular_frequency, body)
    }

    /// The phase by which the force on the body is ahead of the motion of the base: `atan(c ω_d/k)` of a support
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
