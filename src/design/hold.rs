//! The frequencies at which friction holds a body at rest.

use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::excitation::Excitation;
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::finite;

/// The frequencies at which friction holds a body at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Holding<F> {
    /// Up to this angular frequency.
    UpTo(F),
    /// At every frequency: the amplitude of the force does not depend on it, and is no more than r_s.
    Always,
    /// At no frequency: already under the slowest drive the force exceeds r_s.
    Never,
}

/// The angular frequency up to which friction holds `body` at rest, at the mean displacement, under a drive of the amplitude
/// of `drive`: the ω_d at which the force on the body, p₀(ω_d), is the static friction `r_s = η r_y`.
///
/// The force of an unbalance or of a base that carries the surface grows with ω_d from 0 on: m_e e ω_d² = r_s, m ω_d² u₀ =
/// r_s, m ω_d v₀ = r_s. A support with the damper has √(k² + c²ω_d²) u₀, from k u₀ on. The force of all others is the same at
/// every frequency. The frequency of `drive` plays no part. A body at rest elsewhere is released earlier. Accuracy at f64: 4
/// units in the last place.
///
/// ```
/// use stickslip::{Drive, Excitation, Oscillator, design::{Holding, holding_frequency}};
/// let body = Oscillator::new(20.0, 2e4, 80.0)?;
/// let base = Drive::new(Excitation::SurfaceMotion, 0.01, 1.0)?;
/// assert_eq!(holding_frequency(&body, &base)?, Holding::UpTo(20.0));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where the frequency overflows.
pub fn holding_frequency<F: Float>(body: &Oscillator<F>, drive: &Drive<F>) -> Result<Holding<F>, Error> {
    let held = body.static_friction_ratio() * body.friction_bound();
    let (amplitude, stiffness, damping) = (drive.amplitude(), body.stiffness(), body.damping());
    let frequency = match drive.excitation() {
        Excitation::Unbalance => (held / amplitude).sqrt(),
        Excitation::SurfaceMotion => (held / body.mass() / amplitude).sqrt(),
        Excitation::SurfaceVelocity => held / body.mass() / amplitude,
        Excitation::DampedFootMotion if damping > F::int(0) => {
            let whole = held / amplitude;
            if whole < stiffness {
                return Ok(Holding::Never);
            }
            ((whole - stiffness) * (whole + stiffness)).sqrt() / damping
        }
        Excitation::Force
        | Excitation::FootMotion
        | Excitation::DampedFootMotion
        | Excitation::SurfaceAcceleration => {
            let is_held = drive.force_amplitude(body) <= held;
            return Ok(if is_held { Holding::Always } else { Holding::Never });
        }
    };
    finite(crate::Quantity::AngularFrequency, frequency).map(Holding::UpTo)
}
