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
use super::waveform::Motion;
use crate::cycle::damped::half_period;
use crate::cycle::damped::rising::Rising;
use crate::float::{Float, Real};
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

impl<F: Float> Cycle<F> {
    /// Maximum transmitted force, in r_y: without damping `Δ₀/B + 1`; with damping the maximum of
    /// `|x + 2ζx′ + sgn x′|`, which includes the damper's force.
    pub fn transmitted_force(&self) -> F {
        match &self.motion {
            Motion::Undamped(_) => transmitted_force(self.max_displacement),
            Motion::Damped(cycle) => cycle.rising.transmitted_force(),
        }
    }

    /// Maximum |x″|, in B ω_d². Without damping it occurs on arrival for Ω ≥ 1/2, where it is `Δ₀/B + 1/Ω²`;
    /// otherwise it is the maximum over the half cycle.
    ///
    /// Accuracy at f64: 4 ulp without damping for Ω ≥ 1/2; otherwise 1e-13 of Δ₀/B + α/Ω².
    pub fn max_acceleration(&self) -> F {
        let omega = self.ratios.omega();
        if !self.ratios.is_damped() && F::int(2) * omega >= F::int(1) {
            return arrival_acceleration(self.max_displacement, omega);
        }
        self.rising().max_acceleration() / omega.square()
    }

    /// Maximum absolute displacement, with a base that carries the surface, in B: the maximum of |x + u|,
    /// where u = (α/Ω²) sin θ is the displacement of the base.
    ///
    /// Without damping `y = x + u` has `y″ = −(x + 1)` on the half cycle with x′ > 0, where x increases.
    /// Hence y′ increases and then decreases, from −K/Ω² to K/Ω²; it has one zero, and y one extremum.
    /// Accuracy at f64: 1e-14 of Δ₀/B + α/Ω²; with damping 1e-13 of it.
    pub fn max_absolute_displacement(&self) -> F {
        let rising = self.rising();
        if self.ratios.is_damped() {
            return rising.max_absolute_displacement();
        }
        // The only extremum takes a tenth of the time of a search.
        let y = |tau: F| {
            let at = rising.at(tau);
            rising.absolute(&at, rising.displacement(&at))
        };
        let (low, high) = enclosed(F::int(0), rising.half.period, |tau| y(tau).slope);
        y(low).value.abs().or_larger(y(high).value.abs())
    }

    /// The half cycle with x′ > 0.
    fn rising(&self) -> Rising<F> {
        match &self.motion {
            Motion::Undamped(_) => Rising::new(half_period(&self.ratios), self.max_displacement),
            Motion::Damped(cycle) => cycle.rising,
        }
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
