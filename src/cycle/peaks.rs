//! Loads on a machine and its support: acceleration, transmitted force, absolute motion. Beyond the paper.
//!
//! On the half cycle with x′ > 0, in centred time ψ from β (the minimum) to −β, β = π/2Ω, the drive is
//!
//! ```text
//! α sin θ = −(1−Ω²) Δ₀ sin Ωψ − K cos Ωψ        α cos θ = (1−Ω²) Δ₀ cos Ωψ − K sin Ωψ
//! ```
//!
//! with Δ₀ in units of B, and the equation of motion gives `x″ = α sin θ − x − 1` (in B ω_n²). On arrival at
//! the turning point this is −(1 + Ω²Δ₀). With `T = tan β`,
//!
//! ```text
//! −x″ = −Ω²Δ₀ sin Ωψ + g(ψ),        g = cos ψ/cos β − Ω T cos Ωψ,        g(β) = 1.
//! ```
//!
//! For Ω ≥ 1/2, g increases from ψ = 0 to β, because sin Ωψ/sin ψ is monotone there, and −g(0) ≤ 1: so |x″|
//! is greatest on arrival. For Ω < 1/2 the fast wave cos ψ/cos β may exceed it, within a fast period of the
//! crest of the slow wave, or of an end.

use super::Cycle;
use super::waveform::Basis;
use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Float, Real};
use crate::greatest::{Bound, Jet, greatest};
use crate::machine::excitation::Excitation;
use crate::machine::support::Support;
use crate::root::enclosed;

/// Dynamic amplification `k Δ₀/p₀ = (Δ₀/B)/α`.
#[inline]
pub(crate) fn dynamic_amplification<R: Real>(max_displacement: R, alpha: R) -> R {
    max_displacement / alpha
}

/// Acceleration on arrival at the turning point `Δ₀/B + 1/Ω²`, in B ω_d²: the maximum for Ω ≥ 1/2.
///
/// In physical units `ω_d² Δ₀ + r_y/m`: just before it stops, the body is braked by the friction, too.
#[inline]
pub(crate) fn arrival_acceleration<R: Real>(max_displacement: R, omega: R) -> R {
    max_displacement + R::int(1) / omega.square()
}

/// Maximum force on the support of spring and surface, `Δ₀/B + 1` in r_y: that of the spring and of friction
/// together, `k x + r_y sgn x′`.
#[inline]
pub(crate) fn transmitted_force<R: Real>(max_displacement: R) -> R {
    max_displacement + R::int(1)
}

/// The times between two ends that are within a `turn` of an end or of a crest.
pub(crate) fn near_ends_or_crest<F: Float>([start, end]: [F; 2], crest: F, turn: F) -> [(F, F); 3] {
    [(start, start + turn), (crest - turn, crest + turn), (end - turn, end)].map(|(low, high)| {
        let low = low.or_larger(start);
        (low, if high < end { high } else { end })
    })
}

impl<F: Float> Cycle<F> {
    /// Maximum force on the support, in r_y: without damping `Δ₀/B + 1`; with damping the maximum of
    /// `|x + 2ζx′ + sgn x′|`, which includes the damper's force.
    ///
    /// Where the support moves ([`crate::Ratios::excitation`]), support and surface together carry m x″: the maximum of `|x″|`.
    pub(crate) fn transmitted_force(&self) -> F {
        let support = Support::from(&self.ratios);
        support.force(self.carried(&support))
    }

    /// The transmissibility: [`Cycle::transmitted_force`] over p₀. Where the support moves, the peak acceleration of the
    /// body over that of the support.
    pub(crate) fn transmissibility(&self) -> F {
        let support = Support::from(&self.ratios);
        support.transmissibility(self.carried(&support))
    }

    /// The maximum that decides the force on the support: an acceleration in B ω_d², or a force in r_y.
    fn carried(&self, support: &Support<F>) -> F {
        match &self.motion {
            _ if support.is_foot() => self.max_acceleration(),
            Basis::Undamped(_) => transmitted_force(self.max_displacement),
            Basis::Damped(cycle) => cycle.transmitted_force(),
        }
    }

    /// Maximum |x″|, in B ω_d². Without damping it occurs on arrival for Ω ≥ 1/2, where it is `Δ₀/B + 1/Ω²`;
    /// otherwise it is the maximum over the half cycle.
    ///
    /// Accuracy at f64: 4 ulp without damping for Ω ≥ 1/2; otherwise 1e-13 of Δ₀/B + α/Ω².
    pub(crate) fn max_acceleration(&self) -> F {
        let omega = self.ratios.omega();
        match &self.motion {
            Basis::Damped(cycle) => cycle.max_acceleration() / omega.square(),
            Basis::Undamped(_) if F::int(2) * omega >= F::int(1) => {
                arrival_acceleration(self.max_displacement, omega)
            }
            Basis::Undamped(_) => {
                let square = omega.square();
                let arrival = arrival_acceleration(self.max_displacement, omega);
                self.greatest_below(arrival * square, F::int(0)) / square
            }
        }
    }

    /// The greater of `best` and the greatest |x″ + `offset`| without damping below Ω = 1/2, in B ω_n², `x″ = Ω²Δ₀ sin Ωψ −
    /// g`: as a difference of force and spring it would lose as many digits as they exceed it by.
    pub(super) fn greatest_below(&self, best: F, offset: F) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let (omega, delta) = (self.ratios.omega(), self.max_displacement);
        let tangent = PhaseFunction::of_valid(omega).tangent();
        let (_, cos_beta) = self.sin_cos_beta();
        let square = omega.square();
        let (slow, bent) = (square * delta, omega * tangent);
        // |x⁗| of the slow wave and the fast one.
        let curvature = square * (slow + bent.abs()) + one / cos_beta.abs();
        let motion = |psi: F| {
            let ((s, c), (sine, cosine)) = ((omega * psi).sin_cos(), psi.sin_cos());
            let (wave, rate) = (slow * s + bent * c, omega * (slow * c - bent * s));
            Jet {
                value: wave - cosine / cos_beta + offset,
                slope: rate + sine / cos_beta,
                second: cosine / cos_beta - square * wave,
            }
        };
        let beta = F::pi() / (two * omega);
        let turn = two * F::pi();
        // The crest of the slow wave: tan Ωψ = Ω Δ₀/T.
        let crest = (omega * delta).atan2(tangent.abs()).with_sign_of(-tangent) / omega;
        let windows = near_ends_or_crest([-beta, beta], crest, turn);
        let windows = windows.into_iter().filter(|(low, high)| low < high);
        let bound = |_, _| Bound { curvature, value: one / F::int(0) };
        windows.fold(best, |best, (low, high)| greatest(low, high, best, bound, motion))
    }

    /// Maximum absolute displacement, with a base that carries the surface, in B: the maximum of |x + u|,
    /// where u = (α/Ω²) sin θ is the displacement of the base.
    ///
    /// Without damping `y = x + u` has `y″ = −(x + 1)` on the half cycle with x′ > 0, where x increases.
    /// Hence y′ increases and then decreases, from −K/Ω² to K/Ω²; it has one zero, and y one extremum.
    /// Accuracy at f64: 1e-14 of Δ₀/B + α/Ω²; with damping 1e-13 of it.
    ///
    /// Where the support moves, the surface is fixed, and this is Δ₀/B.
    pub(crate) fn max_absolute_displacement(&self) -> F {
        if self.ratios.excitation().is_some_and(Excitation::moves_foot) {
            return self.max_displacement.abs();
        }
        let omega = self.ratios.omega();
        let half = match &self.motion {
            Basis::Damped(cycle) => return cycle.max_absolute_displacement(),
            Basis::Undamped(cycle) => cycle.half(omega),
        };
        let square = omega.square();
        let k = PhaseFunction::of_valid(omega).value();
        let beta = F::pi() / (F::int(2) * omega);
        let speed = |psi: F| half.velocity(psi).value + self.drive(psi, k).1 / square;
        let (low, high) = enclosed(-beta, beta, speed);
        let at = |psi: F| (half.displacement(psi) + self.drive(psi, k).0 / square).abs();
        at(low).or_larger(at(high))
    }

    /// The maximum absolute displacement where the support or the base moves, and of ratios without an excitation.
    pub(crate) fn absolute_displacement(&self) -> Option<F> {
        let moves = self.ratios.excitation().is_none_or(Excitation::moves_base);
        moves.then(|| self.max_absolute_displacement())
    }

    /// (α sin θ, α cos θ) at the centred time ψ of the half cycle with x′ > 0.
    pub(super) fn drive(&self, psi: F, k: F) -> (F, F) {
        let omega = self.ratios.omega();
        let sine = (F::int(1) - omega) * (F::int(1) + omega) * self.max_displacement;
        let (s, c) = (omega * psi).sin_cos();
        (-(sine * s) - k * c, sine * c - k * s)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Cycle, Ratios};

    const POINTS: [(f64, f64); 12] = [
        (0.05, 500.0),
        (0.17, 60.0),
        (0.26, 20.0),
        (0.3, 14.0),
        (0.34, 400.0),
        (0.4, 9.0),
        (0.499, 4.5),
        (0.55, 3.0),
        (0.7, 2.0),
        (0.999_999, 1.5),
        (1.5, 2.5),
        (4.4, 3.0),
    ];

    /// No dense sample of the cycle, by its displacement and the equation of motion, exceeds a peak, and some
    /// come close.
    #[test]
    fn peaks_are_the_greatest_of_samples() {
        for (omega, alpha) in POINTS {
            let cycle = Ratios::new(omega, alpha).and_then(Cycle::new).unwrap();
            let (mut acceleration, mut force, mut absolute) = (0.0f64, 0.0f64, 0.0f64);
            let count = 400_000;
            for i in 0..count {
                let theta = (f64::from(i) + 0.5) * std::f64::consts::TAU / f64::from(count);
                let (x, v) = (cycle.displacement_at(theta), cycle.velocity_at(theta));
                let (drive, friction) = (alpha * theta.sin(), v.signum());
                acceleration = acceleration.max((drive - x - friction).abs() / omega.powi(2));
                force = force.max((x + friction).abs());
                absolute = absolute.max((x + drive / omega.powi(2)).abs());
            }
            for (found, sampled) in [
                (cycle.max_acceleration(), acceleration),
                (cycle.transmitted_force(), force),
                (cycle.max_absolute_displacement(), absolute),
            ] {
                let tolerance = if omega > 0.99 && omega < 1.0 { 1e-4 } else { 2e-5 };
                assert!(
                    found > sampled * (1.0 - 1e-11) && found < sampled * (1.0 + tolerance),
                    "{omega} {alpha}: {found} {sampled}"
                );
            }
        }
    }

    /// For Ω < 1/2 the fast wave can exceed the acceleration on arrival, so that the search is necessary.
    #[test]
    fn below_one_half_the_greatest_is_not_always_on_arrival() {
        let cycle = Ratios::new(0.34, 400.0).and_then(Cycle::new).unwrap();
        let arrival = super::arrival_acceleration(cycle.max_displacement, 0.34);
        assert!(cycle.max_acceleration() > 1.05 * arrival, "{} {arrival}", cycle.max_acceleration());
    }
}
