//! The friction that dissipates most under a given force.
//!
//! At fixed p₀, k and Ω the energy `4 r_y Δ₀` is A₁ p₀²/(2k), and with z = 1/α²
//!
//! ```text
//! A₁ = 8 √(z − K² z²)/|1 − Ω²|
//! ```
//!
//! without a damper, the square root of a parabola in z: A₁ increases with α up to α* = √2 |K| (eq. 65) and decreases beyond.
//! The cycles that do not stick are those with α ≥ α_min(Ω). The best of them is therefore α* if α* ≥ α_min.
//! Otherwise A₁ decreases for all α ≥ α_min, and the best is the border itself. In both cases it is the
//! larger of the two.

use super::force::ratios_of;
use super::optimum::{Optimum, OptimumKind};
use crate::cycle::{Border, damped, loop_size_stiffness};
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::{Ratios, positive};

/// α = p₀/r_y of [`most_dissipating_friction`] with m = k = p₀ = 1, and A₁; its errors name ratios.
pub fn most_dissipating_force_ratio<F: Float>(omega: F, damping_ratio: F) -> Result<Optimum<F>, Error> {
    optimum_at(&Ratios::of_machine(omega, damping_ratio)?)
}

/// The force ratio without sticking that makes A₁ largest, at Ω and ζ.
///
/// With y = √(α² − K²), `A₁ = 8(y − qG)/(q(y² + K²))`. Its derivative has the sign of `K² + 2qGy − y²`, which
/// changes once for y > 0, at `y = qG + Q`, Q = hypot(K, qG). A₁ therefore increases up to this y and
/// decreases beyond.
fn optimum_at<F: Float>(ratios: &Ratios<F>) -> Result<Optimum<F>, Error> {
    if ratios.is_at_resonance() {
        return Err(Error::AtResonance { quantity: Quantity::LoopSizeStiffness });
    }
    let (border, (at, value)) = (Border::of(ratios), damped::best(&damped::half_period(ratios)));
    let least = border.min_force_ratio;
    Ok(if at >= least {
        Optimum { at, value, kind: OptimumKind::Interior }
    } else {
        let value = loop_size_stiffness(border.least_displacement, least);
        Optimum { at: least, value, kind: OptimumKind::Border }
    })
}

/// The friction force with which `drive` dissipates most in a cycle without sticking, and the energy.
///
/// Mass, stiffness and damping are those of `body`; its own friction force plays no part.
/// r_y = p₀/α with `α = max(√2 |K|, α_min)`, with damping `max(√(2Q(Q + qG)), α_min)`, Q = hypot(K, qG). Only the energy
/// dissipated by friction counts, not the work of the damper ([`crate::Cycle::damper_work`]).
/// [`crate::Response::best_force_ratio`] is this α.
///
/// For Ω ≥ 1/2 and ζ = 0 the optimum is in the interior where `Ω|T| ≥ 1`. It is continuous in Ω: where the
/// two candidates meet, rounding may select either. Accuracy at f64 for ζ = 0: 8 ulp of α.
///
/// # Errors
/// [`Error::AtResonance`] at Ω = 1 for ζ = 0, where the loop grows without bound, where Ω or ζ is outside
/// the domain of [`crate::Ratios`], and where r_y or the energy overflows or underflows.
pub fn most_dissipating_friction<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
) -> Result<Optimum<F>, Error> {
    let ratios = ratios_of(body, drive.angular_frequency())?;
    let best = optimum_at(&ratios)?;
    let p0 = positive(Quantity::ForceAmplitude, drive.force_amplitude(body))?;
    let energy = best.value * (p0 / F::int(2) * (p0 / body.stiffness()));
    Ok(Optimum {
        at: positive(Quantity::FrictionBound, p0 / best.at)?,
        value: positive(Quantity::StaticEnergy, energy)?,
        kind: best.kind,
    })
}

#[cfg(test)]
mod tests {
    use super::{most_dissipating_force_ratio, most_dissipating_friction};
    use crate::design::OptimumKind;
    use crate::{Cycle, Drive, Error, Oscillator, Ratios, Scales};

    fn loop_size(omega: f64, alpha: f64) -> f64 {
        Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().loop_size_stiffness()
    }

    #[test]
    fn none_that_does_not_stick_is_better() {
        for i in 1..400 {
            let omega = 0.01 * f64::from(i) + 0.003;
            let best = most_dissipating_force_ratio(omega, 0.0).unwrap();
            let found = loop_size(omega, best.at * (1.0 + 1e-15));
            assert!((found / best.value - 1.0).abs() < 1e-12, "{omega}");
            let least = crate::Border::new(omega).unwrap().min_force_ratio;
            for j in 0..300 {
                let alpha = least * (1.0 + 0.01 * f64::from(j).powi(2));
                assert!(loop_size(omega, alpha) <= best.value * (1.0 + 1e-13), "{omega} {alpha}");
            }
        }
    }

    #[test]
    fn which_one_it_is() {
        let optimum = |omega| most_dissipating_force_ratio::<f64>(omega, 0.0).unwrap().kind;
        // Ω|T| ≥ 1 at Ω = 1.5 and not at 0.6; K = 0 at 0.5.
        assert_eq!(optimum(1.5), OptimumKind::Interior);
        assert_eq!(optimum(0.6), OptimumKind::Border);
        assert_eq!(optimum(0.5), OptimumKind::Border);
        let at_half = most_dissipating_force_ratio(0.5f64, 0.0).unwrap();
        assert_eq!((at_half.at, at_half.value), (3.0, 8.0 * 4.0 / 9.0));
        assert!(matches!(most_dissipating_force_ratio(1.0, 0.0), Err(Error::AtResonance { .. })));
    }

    #[test]
    fn with_damping_none_is_better() {
        for (omega, zeta) in [(0.4, 0.05), (0.7, 0.1), (1.0, 0.02), (1.5, 0.05), (2.5, 1.2)] {
            let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping_ratio(zeta).unwrap();
            let drive = Drive::force(12.0, 2.0 * omega).unwrap();
            let best = most_dissipating_friction(&body, &drive).unwrap();
            let energy = |friction: f64| {
                let body = Oscillator::new(2.0, 8.0, friction).unwrap().with_damping_ratio(zeta).unwrap();
                let cycle = Cycle::new(drive.ratios(&body).unwrap()).ok()?;
                Some(4.0 * friction * cycle.max_displacement * friction / 8.0)
            };
            let at_best: f64 = energy(best.at * (1.0 - 1e-13)).unwrap();
            assert!((at_best / best.value - 1.0).abs() < 1e-11, "{omega} {zeta}");
            for i in 1..300 {
                let other = energy(best.at * 0.01 * f64::from(i));
                assert!(other.is_none_or(|e| e <= best.value * (1.0 + 1e-13)), "{omega} {zeta} {i}");
            }
        }
    }

    #[test]
    fn in_physical_units() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        for frequency in [0.9, 1.2, 3.0] {
            let drive = Drive::force(12.0, frequency).unwrap();
            let best = most_dissipating_friction(&body, &drive).unwrap();
            let body = Oscillator::new(2.0, 8.0, best.at * (1.0 - 1e-15)).unwrap();
            let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
            let length = Scales::new(&body, &drive).unwrap().length;
            let energy: f64 = 4.0 * body.friction_bound() * cycle.max_displacement * length;
            assert!((best.value / energy - 1.0).abs() < 1e-12, "{frequency}");
        }
    }
}
