//! The maximum friction that lets the body slide under a given drive.

use super::force::border_of;
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::positive;

/// The maximum friction force r_y with which the cycle without a stop exists under `drive`: `r_y = p₀/α_min(Ω)`.
///
/// Unit of force. Mass, stiffness and the static friction ratio η are those of `body`; its own friction force
/// plays no part. With η = 1 the body never sticks with this bound or a smaller one, and sticks with a greater
/// one, because Ω does not depend on friction. With η > 1 the cycle attracts its neighbourhood, and a body at rest
/// is released with a bound below p₀/η. Accuracy as for [`super::min_amplitude`].
///
/// # Errors
/// Where Ω leaves the domain of [`crate::Ratios`], or r_y overflows or underflows.
pub fn max_friction<F: Float>(body: &Oscillator<F>, drive: &Drive<F>) -> Result<F, Error> {
    let border = border_of(body, drive.angular_frequency())?;
    positive(Quantity::FrictionBound, drive.force_amplitude(body) / border.min_force_ratio)
}

#[cfg(test)]
mod tests {
    use super::max_friction;
    use crate::{Drive, Oscillator, Regime, Response};

    #[test]
    fn slides_below_and_sticks_above() {
        for omega in [0.22, 0.4, 0.7, 1.0, 3.0] {
            let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
            for drive in
                [Drive::force(12.0, 2.0 * omega), Drive::new(crate::Excitation::FootMotion, 1.5, 2.0 * omega)]
            {
                let drive = drive.unwrap();
                let friction: f64 = max_friction(&body, &drive).unwrap();
                let regime = |share: f64| {
                    let body = Oscillator::new(2.0, 8.0, friction * share).unwrap();
                    Response::new(drive.ratios(&body).unwrap()).regime
                };
                let slides = if omega == 1.0 { Regime::Unbounded } else { Regime::NonSticking };
                assert_eq!(regime(1.0 - 1e-12), slides, "{omega}");
                assert_eq!(regime(1.0 + 1e-12), Regime::Sticking, "{omega}");
            }
        }
    }
}
