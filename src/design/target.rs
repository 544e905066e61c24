//! The force for a target displacement or velocity.

use super::force::ratios_of;
use crate::cycle::damped::fastest::fastest_time;
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::rising::Rising;
use crate::cycle::{Border, damped, force_ratio_from_displacement};
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::Oscillator;
use crate::machine::ratios::{Ratios, positive};

/// [`force_for_displacement`] with m = k = r_y = 1; its errors name ratios.
pub fn force_ratio_for_displacement<F: Float>(
    omega: F,
    damping_ratio: F,
    max_displacement: F,
) -> Result<F, Error> {
    let (ratios, quantity) = (Ratios::of_machine(omega, damping_ratio)?, Quantity::MaxDisplacementRatio);
    displacement_target(&ratios, max_displacement, F::int(1), quantity)
}

/// The force amplitude p₀ with which `body` at ω_d has the peak displacement Δ₀ (unit of length) in its non-sticking
/// cycle: eq. 44 solved for α = p₀/r_y; u_g0 of a base motion is p₀/k.
///
/// `α = hypot(K, (1 − Ω²) Δ₀/B)`, and with a damping ratio ζ > 0 `α = hypot(K, q (Δ₀/B + G))`. These closed
/// forms are the only solutions, because Δ₀ increases with α. Accuracy at f64 for ζ = 0: 8 ulp of α.
///
/// # Errors
/// [`Error::TargetSticks`] where Δ₀ is below that of the cycle on the border, [`Error::AtResonance`] at
/// Ω = 1 for ζ = 0, and where an argument is outside its domain.
pub fn force_for_displacement<F: Float>(
    body: &Oscillator<F>,
    angular_frequency: F,
    max_displacement: F,
) -> Result<F, Error> {
    let ratios = ratios_of(body, angular_frequency)?;
    let length = positive(Quantity::FrictionDisplacement, body.friction_displacement())?;
    let alpha = displacement_target(&ratios, max_displacement, length, Quantity::MaxDisplacement)?;
    positive(Quantity::ForceAmplitude, alpha * body.friction_bound())
}

/// [`force_for_velocity`] with m = k = r_y = 1; its errors name ratios.
pub fn force_ratio_for_velocity<F: Float>(omega: F, damping_ratio: F, max_velocity: F) -> Result<F, Error> {
    let (ratios, quantity) = (Ratios::of_machine(omega, damping_ratio)?, Quantity::MaxVelocityRatio);
    velocity_target(&ratios, max_velocity, F::int(1), quantity)
}

/// The force amplitude p₀ with which `body` at ω_d has the peak velocity V₀ (unit of velocity) in its non-sticking cycle;
/// u_g0 of a base motion is p₀/k.
///
/// For ζ = 0, V₀ is the maximum over the half cycle of functions of Δ₀ that are affine with a slope ≥ 0
/// (`src/cycle/velocity.rs`), so that it increases with Δ₀ and is convex in it. Moreover, `V₀/(Bω_d) ≥ Δ₀/B`,
/// its value at ψ = 0. The target, taken as Δ₀, is therefore at or above the only solution, and Newton's
/// method descends to the solution without a bracket. With damping, V₀ increases with the amplitude of the
/// driven part in the same way. Accuracy at f64 for ζ = 0: 16 ulp of α.
///
/// In ratios, take m = k = r_y = 1:
///
/// ```
/// use stickslip::{Cycle, Oscillator, Ratios};
/// let body = Oscillator::new(1.0, 1.0, 1.0)?.with_damping_ratio(0.05)?;
/// let alpha: f64 = stickslip::design::force_for_velocity(&body, 1.0, 8.0)?;
/// let cycle = Cycle::new(Ratios::new(1.0, alpha)?.with_damping_ratio(0.05)?)?;
/// assert!((cycle.max_velocity - 8.0).abs() < 1e-13);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::TargetSticks`] where V₀ is below that of the cycle on the border, and otherwise those of
/// [`force_for_displacement`].
pub fn force_for_velocity<F: Float>(
    body: &Oscillator<F>,
    angular_frequency: F,
    max_velocity: F,
) -> Result<F, Error> {
    let ratios = ratios_of(body, angular_frequency)?;
    let scale = positive(Quantity::VelocityScale, body.friction_displacement() * angular_frequency)?;
    let alpha = velocity_target(&ratios, max_velocity, scale, Quantity::MaxVelocity)?;
    positive(Quantity::ForceAmplitude, alpha * body.friction_bound())
}

/// α for the displacement `target`, given in units of `scale`: `α = hypot(K, q (Δ₀/B + G))`.
///
/// This is the only solution, because Δ₀ increases with α.
fn displacement_target<F: Float>(
    ratios: &Ratios<F>,
    target: F,
    scale: F,
    quantity: Quantity,
) -> Result<F, Error> {
    let half = steady(ratios, quantity)?;
    let displacement = positive(quantity, target)? / scale;
    let least = Border::of(ratios).least_displacement;
    if displacement < least {
        return Err(sticks(quantity, target, least * scale, half.omega));
    }
    force_ratio_of_amplitude(&half, displacement + half.shift)
}

/// α for the velocity `target`, given in units of `scale`.
///
/// V₀ is the maximum over 0 < τ < T of `aΩ sin Ωτ − b cos Ωτ + h′(τ)`, which is affine in a with a slope > 0.
/// V₀ therefore increases with a and is convex in it, and is at least its value at T/2, aΩ + h′(T/2). From
/// there, Newton's method converges monotonically to the only solution.
fn velocity_target<F: Float>(
    ratios: &Ratios<F>,
    target: F,
    scale: F,
    quantity: Quantity,
) -> Result<F, Error> {
    let half = steady(ratios, quantity)?;
    let velocity = positive(quantity, target)? / scale;
    // V₀/(Bω_d) and its derivative with respect to a.
    let reached = |amplitude: F| {
        let rising = Rising::new(half, amplitude);
        let moment = rising.at(fastest_time(&rising.vibration()));
        let [speed, ..] = rising.velocity(&moment);
        (speed / half.omega, moment.drive.0)
    };
    let least = Border::of(ratios).least_displacement + half.shift;
    let (least_velocity, _) = reached(least);
    if velocity < least_velocity {
        return Err(sticks(quantity, target, least_velocity * scale, half.omega));
    }
    let rising = Rising::new(half, least);
    let [middle, ..] = rising.velocity(&rising.at(half.period / F::int(2)));
    let mut amplitude = least + (velocity - middle / half.omega).or_larger(F::int(0));
    for _ in 0..F::precision() {
        let (speed, slope) = reached(amplitude);
        let step = (speed - velocity) / slope;
        // A smaller step, or one back, is rounding; a force that no number holds is refused below.
        if !(step > F::epsilon() * amplitude && amplitude > least && step.is_finite()) {
            break;
        }
        amplitude = (amplitude - step).or_larger(least);
    }
    force_ratio_of_amplitude(&half, amplitude)
}

/// `α = hypot(K, qa)`, within the domain of the closed forms.
fn force_ratio_of_amplitude<F: Float>(half: &HalfPeriod<F>, amplitude: F) -> Result<F, Error> {
    let alpha = force_ratio_from_displacement(half.k, amplitude, half.stiffness);
    Ok(Ratios::new(half.omega, alpha)?.alpha())
}

/// The half period at Ω and ζ; at resonance without a damper no steady motion has the target size.
fn steady<F: Float>(ratios: &Ratios<F>, quantity: Quantity) -> Result<HalfPeriod<F>, Error> {
    if ratios.is_at_resonance() {
        Err(Error::AtResonance { quantity })
    } else {
        Ok(damped::half_period(ratios))
    }
}

/// The error for a target that is too small.
fn sticks<F: Float>(quantity: Quantity, value: F, least: F, omega: F) -> Error {
    Error::TargetSticks { quantity, value: written(value), least: written(least), omega: written(omega) }
}

#[cfg(test)]
mod tests {
    use super::{
        force_for_displacement, force_for_velocity, force_ratio_for_displacement, force_ratio_for_velocity,
    };
    use crate::{Cycle, Error, Oscillator, Ratios};

    #[test]
    fn at_the_reference_point() {
        // The ratios (1.5, 2.5), with Δ₀/B and V₀/(Bω_d) to 16 digits.
        let alpha: f64 = force_ratio_for_displacement(1.5, 0.0, 1.632_993_161_855_452).unwrap();
        assert!((alpha - 2.5).abs() < 1e-15);
        let alpha: f64 = force_ratio_for_velocity(1.5, 0.0, 1.654_152_276_482_076).unwrap();
        assert!((alpha - 2.5).abs() < 1e-15, "{alpha}");
    }

    #[test]
    fn a_displacement_with_damping() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping_ratio(0.05).unwrap();
        for (omega, target) in [(0.4, 12.0), (0.7, 2.6), (1.0, 4.0), (3.0, 0.2)] {
            let (scale, frequency) = (body.friction_displacement(), 2.0 * omega);
            let force: f64 = force_for_displacement(&body, frequency, target * scale).unwrap();
            let drive = crate::Drive::force(force, frequency).unwrap();
            let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
            assert!((cycle.max_displacement / target - 1.0).abs() < 1e-13, "{omega}");
        }
        let error = force_for_displacement(&body, 1.4, 0.1).unwrap_err();
        assert!(matches!(error, Error::TargetSticks { .. }));
    }

    #[test]
    fn a_target_that_would_stick() {
        // S(0.4) (1 − Ω²) is √(α_min² − K²).
        let error = force_ratio_for_displacement(0.7, 0.0, 2.0).unwrap_err();
        assert!(error.to_string().starts_with("peak displacement Δ₀/B = 2 must be ≥ 2.04"), "{error}");
        assert!(matches!(force_ratio_for_velocity(0.7, 0.0, 2.0), Err(Error::TargetSticks { .. })));
        assert!(matches!(force_ratio_for_velocity(1.0, 0.0, 9.0), Err(Error::AtResonance { .. })));
        assert!(force_ratio_for_displacement(0.7, 0.0, f64::NAN).is_err());
        assert!(force_ratio_for_displacement(0.7, 0.0, 1e300).is_err());
    }

    /// Newton's method begins far above the border where the body is fastest far from the middle of its way.
    #[test]
    fn the_velocity_of_the_border_itself() {
        for (omega, zeta) in
            [(4.943886883868135e-5, 0.0), (1048575.9999999884, 0.0), (0.2, 0.02), (0.34, 1e-9)]
        {
            let border = crate::Border::of(&crate::Ratios::of_machine(omega, zeta).unwrap()).min_force_ratio;
            let at = |force: f64| {
                Ratios::new(omega, force).and_then(|r| r.with_damping_ratio(zeta)).and_then(Cycle::new)
            };
            let target = at(border).unwrap().max_velocity * (1.0 + 1e-15);
            let force = force_ratio_for_velocity(omega, zeta, target).unwrap();
            assert!((force / border - 1.0).abs() < 1e-12, "{omega} {zeta}: {force} {border}");
        }
    }

    #[test]
    fn in_physical_units() {
        // ω_n = 2, B = 3/8, ω_d = 1.4: Ω = 0.7.
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        let cycle = Cycle::new(Ratios::new(0.7f64, 2.0).unwrap()).unwrap();
        let force = force_for_displacement(&body, 1.4, cycle.max_displacement * 0.375).unwrap();
        assert!((force - 6.0).abs() < 1e-14);
        let force = force_for_velocity(&body, 1.4, cycle.max_velocity * 0.375 * 1.4).unwrap();
        assert!((force - 6.0).abs() < 1e-14);
        let error = force_for_displacement(&body, 1.4, 0.5).unwrap_err().to_string();
        assert!(error.starts_with("peak displacement Δ₀ = 0.5 must be ≥ 0.76"), "{error}");
        let error = force_for_velocity(&body, 1.4, 0.5).unwrap_err().to_string();
        assert!(error.starts_with("peak velocity V₀ = 0.5 must be ≥ 1.2777"), "{error}");
    }
}
