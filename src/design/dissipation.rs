//! The friction that dissipates most under a given force.
//!
//! At fixed p₀, k and Ω the energy `4 r_y Δ₀` is A₁ p₀²/(2k), and with z = 1/α²
//!
//! ```text
//! A₁ = 8 √(z − K² z²)/|1 − Ω²|,
//! ```
//!
//! the root of a parabola in z: A₁ rises with α up to α* = √2 |K| (eq. 65) and falls from there on. The cycles that do not
//! stick are those with α ≥ α_min(Ω). So the best of them is α* where α* ≥ α_min, and else the border itself, A₁ falling on
//! all of α ≥ α_min: the larger of the two, and nothing else can be better.

use super::force::ratios_of;
use crate::error::{Error, Quantity};
use crate::float::Float;
use crate::nonsticking::{Border, best_force_ratio, best_loop_size, damped, loop_size_stiffness};
use crate::oscillator::{Drive, Oscillator};
use crate::phase_function::{PhaseFunction, one_minus_square};
use crate::ratios::{Ratios, positive};

/// What makes a best value the best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Optimum {
    /// The derivative is zero there, inside the region where the body does not stick.
    Interior,
    /// The border: on the one side the body sticks, on the other it dissipates less.
    Border,
    /// An end of the range that was asked about.
    RangeEnd,
    /// Inside the region where the body sticks in every cycle, by the exact motion.
    Sticking,
}

/// The force ratio of the largest loop among the cycles that do not stick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestForceRatio<F> {
    /// The force ratio α.
    pub force_ratio: F,
    /// The loop size A₁ there.
    pub loop_size: F,
    /// [`Optimum::Interior`]: eq. 65 and 66 as they stand; [`Optimum::Border`]: they do not count, α is α_min.
    pub optimum: Optimum,
}

/// The force ratio that makes A₁ largest at the frequency ratio Ω, of those that do not stick: `max(√2 |K|, α_min)`.
///
/// For Ω ≥ 1/2 the optimum is inside where `Ω|T| ≥ 1`. Which of the two it is changes continuously: where they meet, rounding
/// may name either. Accuracy at f64: 8 ulp.
///
/// # Errors
/// [`Error::AtResonance`] at Ω = 1, where the loop grows without bound, and where Ω is outside the domain of
/// [`crate::Ratios`].
pub fn most_dissipating_force_ratio<F: Float>(omega: F) -> Result<BestForceRatio<F>, Error> {
    let p = PhaseFunction::new(omega)?;
    if omega == F::int(1) {
        return Err(Error::AtResonance { quantity: Quantity::LoopSizeStiffness });
    }
    let (k, border) = (p.value(), Border::at(&p));
    let (interior, least) = (best_force_ratio(k), border.min_force_ratio());
    Ok(if interior >= least {
        BestForceRatio {
            force_ratio: interior,
            loop_size: best_loop_size(k, one_minus_square(omega)),
            optimum: Optimum::Interior,
        }
    } else {
        BestForceRatio {
            force_ratio: least,
            loop_size: loop_size_stiffness(border.least_displacement(), least),
            optimum: Optimum::Border,
        }
    })
}

/// The same with a damping ratio ζ, where the loop of friction alone counts: `max(√(2Q(Q + qG)), α_min)`; at Ω = 1, too.
///
/// # Errors
/// Where Ω or ζ is outside the domain of [`crate::Ratios`]; at ζ = 0 as [`most_dissipating_force_ratio`].
pub fn most_dissipating_force_ratio_with_damping<F: Float>(
    omega: F,
    damping_ratio: F,
) -> Result<BestForceRatio<F>, Error> {
    let ratios = Ratios::new(omega, F::int(1))?.with_damping_ratio(damping_ratio)?;
    if ratios.is_damped() {
        Ok(most_dissipating_with_damping(&ratios))
    } else {
        most_dissipating_force_ratio(omega)
    }
}

/// The same at Ω and ζ > 0.
///
/// With y = √(α² − K²) `A₁ = 8(y − qG)/(q(y² + K²))`, whose derivative has the sign of `K² + 2qGy − y²`: one change of sign for
/// y > 0, at `y = qG + Q`, Q = hypot(K, qG). So A₁ rises up to there and falls from there on, as without damping.
fn most_dissipating_with_damping<F: Float>(ratios: &Ratios<F>) -> BestForceRatio<F> {
    let half = damped::half_period(ratios);
    let (border, (force_ratio, loop_size)) = (damped::border(&half), damped::best(&half));
    let least = border.min_force_ratio();
    if force_ratio >= least {
        return BestForceRatio { force_ratio, loop_size, optimum: Optimum::Interior };
    }
    BestForceRatio {
        force_ratio: least,
        loop_size: loop_size_stiffness(border.least_displacement(), least),
        optimum: Optimum::Border,
    }
}

/// The friction bound that dissipates most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestFriction<F> {
    /// The friction bound r_y (unit of force).
    pub friction_bound: F,
    /// The energy dissipated in a cycle, `4 r_y Δ₀`.
    pub energy: F,
    /// What makes it the best.
    pub optimum: Optimum,
}

/// The friction bound with which `drive` dissipates most in a cycle, of those with which the body does not stick.
///
/// Mass, stiffness and damping are those of `body`; its own friction bound plays no part. [`most_dissipating_force_ratio`] in
/// physical units: r_y = p₀/α. With a damper it is the energy that friction takes; what the damper takes besides
/// ([`crate::Cycle::damper_work`]) does not count.
///
/// # Errors
/// As there (but at Ω = 1 there is an answer with damping), and where r_y or the energy over- or underflows.
pub fn most_dissipating_friction<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
) -> Result<BestFriction<F>, Error> {
    let ratios = ratios_of(body, drive.angular_frequency())?;
    let best = if ratios.is_damped() {
        most_dissipating_with_damping(&ratios)
    } else {
        most_dissipating_force_ratio(ratios.omega())?
    };
    let p0 = positive(Quantity::ForceAmplitude, drive.force_amplitude(body))?;
    let energy = best.loop_size * (p0 / F::int(2) * (p0 / body.stiffness()));
    Ok(BestFriction {
        friction_bound: positive(Quantity::FrictionBound, p0 / best.force_ratio)?,
        energy: positive(Quantity::StaticEnergy, energy)?,
        optimum: best.optimum,
    })
}

#[cfg(test)]
mod tests {
    use super::{Optimum, most_dissipating_force_ratio, most_dissipating_friction};
    use crate::{Cycle, Drive, Error, Oscillator, Ratios, Scales};

    fn loop_size(omega: f64, alpha: f64) -> f64 {
        Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().loop_size_stiffness()
    }

    #[test]
    fn none_that_does_not_stick_is_better() {
        for i in 1..400 {
            let omega = 0.01 * f64::from(i) + 0.003;
            let best = most_dissipating_force_ratio(omega).unwrap();
            let found = loop_size(omega, best.force_ratio * (1.0 + 1e-15));
            assert!((found / best.loop_size - 1.0).abs() < 1e-12, "{omega}");
            let least = crate::Border::new(omega).unwrap().min_force_ratio();
            for j in 0..300 {
                let alpha = least * (1.0 + 0.01 * f64::from(j).powi(2));
                assert!(loop_size(omega, alpha) <= best.loop_size * (1.0 + 1e-13), "{omega} {alpha}");
            }
        }
    }

    #[test]
    fn which_one_it_is() {
        let optimum = |omega| most_dissipating_force_ratio::<f64>(omega).unwrap().optimum;
        // Ω|T| ≥ 1 at 1.5, not at 0.6, and K = 0 at 0.5.
        assert_eq!(optimum(1.5), Optimum::Interior);
        assert_eq!(optimum(0.6), Optimum::Border);
        assert_eq!(optimum(0.5), Optimum::Border);
        let at_half = most_dissipating_force_ratio(0.5f64).unwrap();
        assert_eq!((at_half.force_ratio, at_half.loop_size), (3.0, 8.0 * 4.0 / 9.0));
        assert!(matches!(most_dissipating_force_ratio(1.0), Err(Error::AtResonance { .. })));
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
                Some(4.0 * friction * cycle.max_displacement() * friction / 8.0)
            };
            let at_best: f64 = energy(best.friction_bound * (1.0 - 1e-13)).unwrap();
            assert!((at_best / best.energy - 1.0).abs() < 1e-11, "{omega} {zeta}");
            for i in 1..300 {
                let other = energy(best.friction_bound * 0.01 * f64::from(i));
                assert!(other.is_none_or(|e| e <= best.energy * (1.0 + 1e-13)), "{omega} {zeta} {i}");
            }
        }
    }

    #[test]
    fn in_physical_units() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        for frequency in [0.9, 1.2, 3.0] {
            let drive = Drive::force(12.0, frequency).unwrap();
            let best = most_dissipating_friction(&body, &drive).unwrap();
            let body = Oscillator::new(2.0, 8.0, best.friction_bound * (1.0 - 1e-15)).unwrap();
            let cycle = Cycle::new(drive.ratios(&body).unwrap()).unwrap();
            let length = Scales::new(&body, &drive).unwrap().length;
            let energy: f64 = 4.0 * body.friction_bound() * cycle.max_displacement() * length;
            assert!((best.energy / energy - 1.0).abs() < 1e-12, "{frequency}");
        }
    }
}
