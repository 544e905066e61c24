//! The minimum drive that keeps the body sliding at a given frequency.

use crate::cycle::Border;
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Excitation, Oscillator};
use crate::machine::ratios::{Ratios, positive};

/// The minimum amplitude of an excitation that keeps `body` sliding at the angular frequency ω_d, for which
/// `p₀ = r_y α_min(Ω)`.
///
/// The result is in the unit of the amplitude, such as that of a force or of an acceleration. α_min is the
/// exact border: the body slides at this amplitude and above, and sticks just below it. With a static
/// friction above the kinetic one, the cycle without a stop exists at this amplitude and above and attracts its
/// neighbourhood. A body at rest is released only above the static friction r_s, and other starts may lead to
/// other motions ([`crate::NoStop::every_start`]). At Ω = 1 without damping, the motion grows without bound at this amplitude and
/// above.
///
/// Relative accuracy at f64: that of the border, 8 ulp, plus the rounding of ω_d/ω_n times the elasticity
/// `(Ω/α_min) dα_min/dΩ`.
///
/// # Errors
/// Where ω_d is not finite or not > 0, Ω leaves the domain of [`crate::Ratios`], or the force or the
/// amplitude overflows or underflows.
pub fn min_amplitude<F: Float>(
    body: &Oscillator<F>,
    excitation: Excitation,
    angular_frequency: F,
) -> Result<F, Error> {
    let unit = Drive::new(excitation, F::int(1), angular_frequency)?.force_amplitude(body);
    let border = border_of(body, angular_frequency)?;
    let force = positive(Quantity::ForceAmplitude, body.friction_bound() * border.min_force_ratio)?;
    Ok(Drive::new(excitation, force / unit, angular_frequency)?.amplitude())
}

/// The border of `body`, with its damping and its static friction, at ω_d.
pub(super) fn border_of<F: Float>(body: &Oscillator<F>, angular_frequency: F) -> Result<Border<F>, Error> {
    Ok(Border::of(&Drive::force(body.friction_bound(), angular_frequency)?.ratios(body)?))
}

/// The ratios of `body` at ω_d with a force ratio of 1, if its static friction equals the kinetic one.
pub(super) fn ratios_of<F: Float>(body: &Oscillator<F>, angular_frequency: F) -> Result<Ratios<F>, Error> {
    Drive::force(body.friction_bound(), angular_frequency)?.ratios(body)?.with_one_friction()
}

#[cfg(test)]
mod tests {
    use super::min_amplitude;
    use crate::{Border, Drive, Error, Excitation, Oscillator, Quantity};

    #[test]
    fn with_damping_and_whatever_shakes_it() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping_ratio(0.05).unwrap();
        for omega in [0.4, 0.7, 1.0, 3.0] {
            let least = Border::of(&crate::Ratios::of_machine(omega, 0.05).unwrap()).min_force_ratio;
            let force: f64 = min_amplitude(&body, Excitation::Force, 2.0 * omega).unwrap();
            assert!((force / (3.0 * least) - 1.0).abs() < 1e-13, "{omega}: {force}");
            for excitation in [
                Excitation::Force,
                Excitation::DampedFootMotion,
                Excitation::SurfaceMotion,
                Excitation::SurfaceAcceleration,
            ] {
                let amplitude = min_amplitude(&body, excitation, 2.0 * omega).unwrap();
                let drive = Drive::new(excitation, amplitude, 2.0 * omega).unwrap();
                assert!((drive.force_amplitude(&body) / force - 1.0).abs() < 1e-14, "{omega}");
            }
        }
    }

    /// A motion with a higher static friction can depend on its start: only the border itself is answered.
    #[test]
    fn a_higher_static_friction_is_refused_where_the_start_decides() {
        use crate::design::*;
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_static_friction_ratio(1.3).unwrap();
        let drive = Drive::force(12.0, 1.4).unwrap();
        let is_refused = |error: Option<crate::Error>| {
            assert!(matches!(error, Some(crate::Error::StaticFriction { .. })), "{error:?}");
        };
        assert!(min_amplitude(&body, Excitation::Force, 1.4).is_ok());
        is_refused(forces_without_stop(&body, 1.4).err());
        is_refused(frequency_bands(&body, &drive, 0.5..=3.0).err());
        is_refused(frequency_bands_without_stop(&body, &drive, 0.5..=3.0).err());
        is_refused(force_for_displacement(&body, 1.4, 1.0).err());
        is_refused(force_for_velocity(&body, 1.4, 1.0).err());
        is_refused(most_dissipating_friction(&body, &drive).err());
        is_refused(most_dissipating_friction_of_all(&body, &drive, 1e-3).err());
    }

    #[test]
    fn at_the_values_of_the_border() {
        // ω_n = 2, r_y = 3, k = 8: B = 3/8.
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        for (omega, border) in [
            (0.4, 6.949_737_755_908_733),
            (0.3, 11.573_099_220_763_208),
            (0.5, 3.0),
            (1.0, 4.0 / std::f64::consts::PI),
        ] {
            let force: f64 = min_amplitude(&body, Excitation::Force, 2.0 * omega).unwrap();
            assert!((force / (3.0 * border) - 1.0).abs() < 1e-14, "{omega}: {force}");
            let base: f64 = min_amplitude(&body, Excitation::FootMotion, 2.0 * omega).unwrap();
            assert!((base * 8.0 / force - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        let quantity = |e: Error| e.quantity();
        assert_eq!(
            quantity(min_amplitude(&body, Excitation::Force, -1.0).unwrap_err()),
            Some(Quantity::AngularFrequency)
        );
        assert_eq!(
            quantity(min_amplitude(&body, Excitation::Force, 1e300).unwrap_err()),
            Some(Quantity::FrequencyRatio)
        );
        let stiff = Oscillator::new(1e200, 1e200, 1e-200).unwrap();
        let error = min_amplitude(&stiff, Excitation::FootMotion, 1.0).unwrap_err();
        assert_eq!(quantity(error), Some(Quantity::BaseAmplitude));
    }
}
