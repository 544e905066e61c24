//! From dimensionless answers to physical units.

use super::oscillator::{Drive, Oscillator};
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::{finite, positive};

/// The physical size of the dimensionless answers of one oscillator under one drive.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[must_use]
#[non_exhaustive]
pub struct Scales<F> {
    /// Length: `B = r_y/k` (eq. 6).
    pub length: F,
    /// Velocity: `B ω_d` (as in eq. 49).
    pub velocity: F,
    /// Time for one radian of phase: `1/ω_d`.
    pub time: F,
    /// Force: r_y.
    pub force: F,
    /// Energy for one unit of A₁: `p₀²/(2k)`, the lossless static elastic energy (eq. 64).
    pub energy_stiffness: F,
    /// Energy for one unit of A₂: `p₀²/(2 m ω_d²)` (eq. 67).
    pub energy_inertia: F,
    /// The displacement about which the motion is symmetric, `(p̄ − (r₊ − r₋)/2)/k`; it is 0 without a mean
    /// force if friction is the same in both directions.
    ///
    /// Displacements in this crate are measured from this mean displacement. A constant force shifts the
    /// motion, stops included, and changes nothing else.
    pub mean_displacement: F,
    /// The mean of friction in both directions, `(r₊ − r₋)/2`; it is 0 where they are the same.
    ///
    /// The friction in this crate's answers is symmetric: the friction of the machine is r times
    /// [`Scales::force`] plus this force.
    pub mean_friction: F,
}

impl<F: Float> Scales<F> {
    /// The scales of `oscillator` under `drive`.
    ///
    /// # Errors
    /// Where a scale overflows or underflows, so that answers could not be stated in these units.
    pub fn new(oscillator: &Oscillator<F>, drive: &Drive<F>) -> Result<Self, Error> {
        let length = positive(Quantity::FrictionDisplacement, oscillator.friction_displacement())?;
        let frequency = drive.angular_frequency();
        let p0 = positive(Quantity::ForceAmplitude, drive.force_amplitude(oscillator))?;
        let inertia = positive(Quantity::PseudoStiffness, oscillator.mass() * frequency.square())?;
        let half = F::ratio(1, 2);
        Ok(Self {
            length,
            velocity: positive(Quantity::VelocityScale, length * frequency)?,
            time: positive(Quantity::TimeScale, F::int(1) / frequency)?,
            force: oscillator.friction_bound(),
            energy_stiffness: positive(Quantity::StaticEnergy, half * p0 * (p0 / oscillator.stiffness()))?,
            energy_inertia: positive(Quantity::PseudoStaticEnergy, half * p0 * (p0 / inertia))?,
            mean_displacement: finite(
                Quantity::MeanDisplacement,
                (drive.mean_force() - oscillator.friction_offset()) / oscillator.stiffness(),
            )?,
            mean_friction: oscillator.friction_offset(),
        })
    }
}
