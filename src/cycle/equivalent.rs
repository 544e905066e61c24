//! The linear oscillator that moves and dissipates as much as a steady motion, and the force in the spring. Beyond the
//! paper.
//!
//! W being the energy that friction and damper dissipate in a turn of the drive, and X half the range of the displacement:
//!
//! ```text
//! c_eq = W/(π ω_d X²),        ζ_eq = c_eq/(2√(k m)),
//! k_eff = (F⁺ − F⁻)/(x⁺ − x⁻) = k + r_y/X,        ξ_eff = W/(2π k_eff X²),
//! ```
//!
//! F⁺ and F⁻ being the force of spring and friction on arrival at the greatest and at the least displacement. Friction that
//! differs by direction has r₊ − (−r₋) = 2r_y between them, so that the mean of both stands in each formula.

use super::Cycle;
use super::waveform::Basis;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Float, Real};
use crate::greatest::{Bound, Jet, greatest};
use crate::machine::excitation::Excitation;
use crate::machine::support::Support;

/// A motion as its equivalent sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Equivalent<R> {
    pub(crate) omega: R,
    /// X, in B.
    pub(crate) amplitude: R,
    /// W, in r_y B.
    pub(crate) work: R,
}

impl<R: Real> Equivalent<R> {
    /// c_eq, in k/ω_d.
    pub(crate) fn damping(&self) -> R {
        self.work / self.amplitude / (R::pi() * self.amplitude)
    }

    /// ζ_eq.
    pub(crate) fn damping_ratio(&self) -> R {
        self.damping() / (R::int(2) * self.omega)
    }

    /// k_eff, in k.
    pub(crate) fn stiffness(&self) -> R {
        R::int(1) + R::int(1) / self.amplitude
    }

    /// ξ_eff.
    pub(crate) fn effective_damping_ratio(&self) -> R {
        self.work / self.amplitude / (R::int(2) * R::pi() * (self.amplitude + R::int(1)))
    }
}

impl<F: Float> Cycle<F> {
    /// The equivalent oscillator: friction dissipates 4Δ₀/B in a cycle, and the damper its work.
    pub(crate) fn equivalent(&self) -> Equivalent<F> {
        let amplitude = self.max_displacement;
        let work = F::int(4) * amplitude + self.damper_work();
        Equivalent { omega: self.ratios.omega(), amplitude, work }
    }

    /// Greatest force in the spring, in r_y: Δ₀/B, or the greatest |x − u|/B where the support of the spring moves by u.
    ///
    /// Accuracy at f64: 1e-13 of Δ₀/B + α.
    pub(crate) fn max_spring_force(&self) -> F {
        if !Support::from(&self.ratios).is_foot() {
            return self.max_displacement;
        }
        match &self.motion {
            Basis::Damped(cycle) => {
                cycle.max_spring_force(self.ratios.excitation() == Some(Excitation::DampedFootMotion))
            }
            // x − α sin θ = −(x″ + 1)
            Basis::Undamped(_) if F::int(2) * self.ratios.omega() < F::int(1) => {
                self.greatest_below(F::int(0), F::int(1))
            }
            Basis::Undamped(cycle) => {
                let omega = self.ratios.omega();
                let half = cycle.half(omega);
                let square = omega.square();
                let k = PhaseFunction::of_valid(omega).value();
                let beta = F::pi() / (F::int(2) * omega);
                // ψ goes against the time.
                let seen = |psi: F| {
                    let (foot, rate) = self.drive(psi, k);
                    let value = half.displacement(psi) - foot;
                    Jet {
                        value,
                        slope: omega * (rate - half.velocity(psi).value),
                        second: square * foot - value - F::int(1),
                    }
                };
                let curvature =
                    self.max_displacement + self.ratios.alpha() * (F::int(1) + square) + F::int(1);
                let bound = |_, _| Bound { curvature, value: F::int(1) / F::int(0) };
                greatest(-beta, beta, F::int(0), bound, seen)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Cycle, Excitation, Ratios};

    /// No dense sample of the force in the spring exceeds its maximum, and some come close, where the support of the spring
    /// moves without the damper or with it, at slow and at fast drives.
    #[test]
    fn the_force_in_the_spring_is_the_greatest_of_samples() {
        for (omega, alpha, zeta) in [
            (0.05, 500.0, 0.0),
            (0.17, 60.0, 0.0),
            (0.34, 400.0, 0.0),
            (0.499, 4.5, 0.0),
            (0.55, 3.0, 0.0),
            (0.999_999, 1.5, 0.0),
            (1.0 + 1e-9, 1.5, 0.0),
            (1.5, 2.5, 0.0),
            (4.4, 3.0, 0.0),
            (0.05, 700.0, 0.01),
            (0.17, 60.0, 0.1),
            (0.7, 4.0, 0.3),
            (1.0, 5.0, 1e-9),
            (1.0, 5.0, 0.05),
            (1.5, 4.0, 0.7),
            (0.8, 20.0, 3.0),
            (4.4, 90.0, 30.0),
        ] {
            for excitation in [Excitation::FootMotion, Excitation::DampedFootMotion] {
                let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)).unwrap();
                let cycle = Cycle::new(ratios.with_excitation(excitation)).unwrap();
                let found: f64 = cycle.max_spring_force();
                let damper = if excitation == Excitation::FootMotion { 0.0 } else { 2.0 * zeta * omega };
                let (size, lag) = (alpha / 1f64.hypot(damper), damper.atan());
                let count = 400_000;
                let sampled = (0..count)
                    .map(|i| {
                        let theta = (f64::from(i) + 0.5) * std::f64::consts::TAU / f64::from(count);
                        (cycle.displacement_at(theta) - size * (theta - lag).sin()).abs()
                    })
                    .fold(0.0, f64::max);
                assert!(
                    found > sampled - 1e-12 * (alpha + sampled) && found < sampled * (1.0 + 1e-4),
                    "{omega} {alpha} {zeta} {excitation}: {found} {sampled}"
                );
            }
        }
    }

    /// Extreme ratios take no longer than others.
    #[test]
    fn many_waves_and_much_damping_take_no_time() {
        for (omega, alpha, zeta) in [
            (1e-7, 1e15, 0.0),
            (1e-7, 1e15, 1e-9),
            (1e-5, 3e10, 0.3),
            (2.0, 1e10, 1e9),
            (1e-3, 1e10, 1e6),
            (1e6, 10.0, 0.0),
        ] {
            for excitation in [Excitation::FootMotion, Excitation::DampedFootMotion] {
                let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)).unwrap();
                let cycle: Cycle<f64> = Cycle::new(ratios.with_excitation(excitation)).unwrap();
                let found = cycle.max_spring_force();
                assert!(found.is_finite() && found > 0.0, "{omega} {alpha} {zeta}: {found}");
            }
        }
    }
}
