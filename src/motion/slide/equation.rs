//! The equation of motion at one (Ω, α, ζ, η).

mod damped;

use crate::float::Float;
use crate::machine::error::{Error, written};
use crate::machine::excitation::Excitation;
use crate::machine::support::Support;
use crate::motion::broken::Broken;
use crate::motion::drive_phase::DrivePhase;
// The functions of natural time in the formulas of a slide, with or without damping.
pub(crate) use crate::cycle::damped::resonance::Responses;
use crate::machine::ratios::Ratios;

/// The equation of motion, with the constants that depend only on (Ω, α, ζ, η). α = 0 is free vibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Equation<F> {
    pub(crate) omega: F,
    pub(crate) alpha: F,
    /// 2ζ: the viscous force is 2ζw, in units of r_y.
    pub(crate) damping: F,
    /// η: the force, in units of r_y, that releases a body at rest.
    pub(crate) static_friction: F,
    /// The kind of excitation, which no motion depends on: it decides forces on the support, and works.
    pub(crate) excitation: Option<Excitation>,
    per_one_plus: F,
    /// `2/(1 − Ω)`, not used at Ω = 1.
    double_per_one_minus: F,
}

impl<F: Float> Equation<F> {
    pub(crate) fn new(ratios: Ratios<F>) -> Self {
        let equation =
            Self::of(ratios.omega(), ratios.alpha(), ratios.damping_ratio(), ratios.static_friction_ratio());
        Self { excitation: ratios.excitation(), ..equation }
    }

    /// Free vibration with the damping ratio ζ and the static friction ratio η: no drive, and the unit of
    /// time 1/ω_n.
    pub(crate) fn free(zeta: F, eta: F) -> Self {
        Self::of(F::int(1), F::int(0), zeta, eta)
    }

    /// The equation of these ratios, without an excitation.
    pub(crate) fn of(omega: F, alpha: F, zeta: F, static_friction: F) -> Self {
        let (one, two) = (F::int(1), F::int(2));
        Self {
            omega,
            alpha,
            damping: two * zeta,
            static_friction,
            excitation: None,
            per_one_plus: one / (one + omega),
            double_per_one_minus: two / (one - omega),
        }
    }

    /// The force on the support.
    pub(crate) fn support(&self) -> Support<F> {
        let Self { excitation, omega, alpha, damping, .. } = *self;
        Support { excitation, omega, alpha, damping_ratio: damping / F::int(2) }
    }

    /// The ratios of this equation.
    #[cfg(feature = "serde")]
    pub(crate) fn ratios(&self) -> Ratios<F> {
        let zeta = self.damping / F::int(2);
        Ratios::of_valid(self.omega, self.alpha, zeta, self.static_friction).under(self.excitation)
    }

    /// Whether there is a damper, ζ > 0.
    #[inline]
    pub(crate) fn is_damped(&self) -> bool {
        self.damping > F::int(0)
    }

    /// Whether the static friction is above the kinetic one, η > 1.
    #[inline]
    pub(crate) fn has_higher_static_friction(&self) -> bool {
        self.static_friction > F::int(1)
    }

    /// `η − 1`: the acceleration of a body at its release.
    #[inline]
    pub(crate) fn static_excess(&self) -> F {
        self.static_friction - F::int(1)
    }

    /// The fastest rate at which any quantity of a slide changes, in natural time: `max(1, Ω, 2ζ)`.
    #[inline]
    pub(crate) fn pace(&self) -> F {
        F::int(1).or_larger(self.omega).or_larger(self.damping)
    }

    /// The error for a search from `phase` on that exceeded its bound.
    #[cold]
    pub(crate) fn lost(&self, search: &'static str, phase: DrivePhase<F>, bound: &'static str) -> Broken {
        let theta = F::from_f64(phase.half_turns() as f64) * F::pi() + phase.angle();
        Broken::from(Error::SearchBound {
            search,
            omega: written(self.omega),
            alpha: written(self.alpha),
            phase: written(theta),
            bound,
        })
    }

    /// The free vibrations and the quotients C, S, D of `slide` at φ.
    #[cfg(test)]
    pub(crate) fn waves(&self, phi: F) -> Responses<F> {
        if self.is_damped() { self.damped_waves(phi) } else { self.undamped_waves(phi) }
    }

    /// The free vibrations and the quotients without damping, where q serves all three quotients.
    #[inline]
    pub(crate) fn undamped_waves(&self, phi: F) -> Responses<F> {
        let one = F::int(1);
        let WaveAngles { p: (sp, cp), sin_m: sm, free, drive } = self.wave_angles(phi);
        let q = if self.omega == one { phi } else { sm * self.double_per_one_minus };
        let qc = q * cp;
        let s = if self.omega < one { drive.0 - self.omega * qc } else { free.0 - qc };
        Responses {
            free,
            versine: versine(free),
            drive,
            c: sp * q * self.per_one_plus,
            s: s * self.per_one_plus,
            d: (drive.0 + qc) * self.per_one_plus,
        }
    }

    /// (sin, cos) of p, φ and Ωφ, and sin m, from those of two angles.
    ///
    /// Near Ω = 1 the angle m must keep its relative accuracy, and the two angles are p and m. Elsewhere φ
    /// and Ωφ must, and the two angles are their halves.
    #[inline]
    fn wave_angles(&self, phi: F) -> WaveAngles<F> {
        let (one, two) = (F::int(1), F::int(2));
        let sum = |(s, c): (F, F), (t, d): (F, F)| (s * d + c * t, c * d - s * t);
        let opposite = |(s, c): (F, F)| (-s, c);
        if self.omega * two >= one && self.omega <= two {
            let (half_sum, half_difference) = ((one + self.omega) / two, (one - self.omega) / two);
            let (p, m) = ((half_sum * phi).sin_cos(), (half_difference * phi).sin_cos());
            return WaveAngles { p, sin_m: m.0, free: sum(p, m), drive: sum(p, opposite(m)) };
        }
        let half = phi / two;
        let (free, drive) = (half.sin_cos(), (self.omega * half).sin_cos());
        let p = sum(free, drive);
        let (sin_m, _) = sum(free, opposite(drive));
        WaveAngles { p, sin_m, free: sum(free, free), drive: sum(drive, drive) }
    }

    /// The waves of `undamped_waves` at φ = π/Ω, from (sin β, cos β) of β = π/2Ω, Ω ≠ 1, ζ = 0: there `m = β
    /// − π/2` and `p = m + π`.
    #[inline]
    pub(crate) fn half_turn(&self, (sin_beta, cos_beta): (F, F)) -> Responses<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let q = -(cos_beta * self.double_per_one_minus);
        let qc = -(q * sin_beta);
        let free = (two * sin_beta * cos_beta, (cos_beta - sin_beta) * (cos_beta + sin_beta));
        Responses {
            free,
            versine: versine(free),
            drive: (zero, -one),
            c: cos_beta * q * self.per_one_plus,
            s: -(self.omega * qc) * self.per_one_plus,
            d: qc * self.per_one_plus,
        }
    }
}

/// (sin, cos) of `p = (1 + Ω)φ/2`, φ and Ωφ, and the sine of `m = (1 − Ω)φ/2`.
struct WaveAngles<F> {
    p: (F, F),
    sin_m: F,
    free: (F, F),
    drive: (F, F),
}

/// `1 − cos φ` without cancellation, from (sin φ, cos φ).
#[inline]
fn versine<F: Float>((sine, cosine): (F, F)) -> F {
    let one = F::int(1);
    if cosine > F::int(0) { sine.square() / (one + cosine) } else { one - cosine }
}

#[cfg(test)]
mod tests {
    use super::Equation;
    use crate::Ratios;
    use std::f64::consts::PI;

    fn equation(omega: f64) -> Equation<f64> {
        Equation::new(Ratios::new(omega, 2.0).unwrap())
    }

    /// Each form keeps the small ones of sin Ωφ, sin φ and S accurate in the range where it is used.
    #[test]
    fn waves_are_those_of_the_textbook() {
        for omega in [1e-6, 1e-3, 0.3, 0.49, 0.6, 1.7, 2.1, 30.0, 1e3] {
            for i in 1..60 {
                let phi = f64::from(i) * 0.05;
                let waves = equation(omega).waves(phi);
                let ((s, c), (sd, cd)) = (phi.sin_cos(), (omega * phi).sin_cos());
                let bound = |of: f64| 8.0 * f64::EPSILON * (1.0 + phi * omega.max(1.0)) * of;
                let close = |a: f64, b: f64, of: f64| {
                    assert!((a - b).abs() <= bound(of), "Ω = {omega}, φ = {phi}: {a:e} for {b:e}");
                };
                close(waves.drive.0, sd, omega.min(1.0));
                close(waves.drive.1, cd, 1.0);
                assert!(
                    (waves.free.0 - s).abs() <= 1e-15 && (waves.free.1 - c).abs() <= 1e-15,
                    "Ω = {omega}"
                );
                let product = (1.0 - omega) * (1.0 + omega);
                close(waves.c, (cd - c) / product, 1.0 / product.abs());
                close(waves.s, (sd - omega * s) / product, omega.min(1.0) / product.abs());
                close(waves.d, (s - omega * sd) / product, omega.max(1.0) / product.abs());
            }
        }
    }

    #[test]
    fn half_a_turn_is_a_time_like_any_other() {
        for omega in [0.13, 0.4, 0.7, 1.3, 4.0] {
            let (there, waves) =
                (equation(omega).half_turn((PI / 2.0 / omega).sin_cos()), equation(omega).waves(PI / omega));
            for (a, b) in [
                (there.free.0, waves.free.0),
                (there.free.1, waves.free.1),
                (there.drive.0, waves.drive.0),
                (there.drive.1, waves.drive.1),
                (there.c, waves.c),
                (there.s, waves.s),
                (there.d, waves.d),
            ] {
                assert!((a - b).abs() < 1e-13, "Ω = {omega}: {a} for {b}");
            }
        }
    }
}
