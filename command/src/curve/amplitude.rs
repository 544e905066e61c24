//! The amplitude at one frequency, of the cycle that does not stick or of the exact motion.

use super::Asked;
use crate::args::Curve;
use crate::failure::Failure;
use crate::input::Point;
use crate::machine::transmitted;
use stickslip::inputs::units::Kind;
use stickslip::motion::{LongRun, State};
use stickslip::{Error, Regime, Response, observed};

impl Asked {
    /// The value at a point, in the machine's units or in those of p₀; `None` where it grows without bound.
    pub(super) fn value(
        &self,
        point: &Point<f64>,
        response: &Response<f64>,
    ) -> Result<(Option<f64>, &'static str, bool), Failure> {
        let (omega, alpha) = (point.ratios.omega(), point.ratios.alpha());
        let machine = point.machine.as_ref();
        let felt = |force: f64, acceleration: f64| {
            let (force, ratio) = transmitted(machine, &point.ratios, force, acceleration);
            if self.what == Curve::Force { force } else { ratio }
        };
        // Displacement, velocity, acceleration, transmitted force and absolute displacement, in B, B ω_d, B
        // ω_d², r_y and B.
        let (peaks, regime, sticks) = match response.cycle.as_ref() {
            Some(c) => {
                let of_cycle = match self.what {
                    Curve::Displacement => c.max_displacement,
                    Curve::Velocity => c.max_velocity,
                    Curve::Acceleration => c.max_acceleration(),
                    Curve::Force | Curve::Transmissibility => {
                        felt(c.transmitted_force(), c.max_acceleration())
                    }
                    Curve::Absolute => c.max_absolute_displacement(),
                };
                (Some(of_cycle), "non-sticking", false)
            }
            None if response.regime == Regime::Unbounded => (None, UNBOUNDED, false),
            None => {
                let fail = |e: Error| Failure::Input(format!("{}: {e}", self.axis.option()));
                let limit = LongRun::from_start(point.ratios, State::default()).map_err(fail)?;
                match (limit.steady_state(), &limit) {
                    (Some(s), _) => {
                        let regime = observed(point.ratios, &limit).regime;
                        let peaks = s.peaks().map_err(fail)?;
                        let of_motion = match self.what {
                            Curve::Displacement => {
                                s.max_displacement.value.abs().max(s.min_displacement.value.abs())
                            }
                            Curve::Velocity => s.max_velocity.value.abs().max(s.min_velocity.value.abs()),
                            Curve::Acceleration => peaks.acceleration,
                            Curve::Force | Curve::Transmissibility => {
                                felt(peaks.transmitted_force, peaks.acceleration)
                            }
                            Curve::Absolute => peaks.absolute_displacement,
                        };
                        (Some(of_motion), regime.name(), regime == Regime::Sticking)
                    }
                    // At rest friction carries the whole force, and the body moves with its base.
                    (None, LongRun::Rest(_)) => {
                        let at_rest = match self.what {
                            Curve::Displacement | Curve::Velocity | Curve::Acceleration => 0.0,
                            Curve::Force | Curve::Transmissibility => felt(alpha, 0.0),
                            Curve::Absolute => alpha / omega.powi(2),
                        };
                        (Some(at_rest), "stuck", true)
                    }
                    (None, _) => (None, "undecided", false),
                }
            }
        };
        let in_units = |x: f64| match (&point.machine, self.what) {
            (_, Curve::Transmissibility) => x,
            (Some(m), Curve::Displacement | Curve::Absolute) => x * m.scales.length,
            (Some(m), Curve::Velocity) => x * m.scales.velocity,
            (Some(m), Curve::Acceleration) => x * (m.scales.velocity / m.scales.time),
            (Some(m), Curve::Force) => x * m.scales.force,
            // 1/α overflows for the least α.
            (None, Curve::Displacement | Curve::Absolute | Curve::Force) => x / alpha,
            (None, Curve::Velocity) => x / alpha * omega,
            (None, Curve::Acceleration) => x / alpha * omega.powi(2),
        };
        Ok((peaks.map(in_units), regime, sticks))
    }

    /// The name of the quantity with its unit, for an axis.
    pub(super) fn label(&self) -> String {
        let kind = match self.what {
            Curve::Displacement | Curve::Absolute => Kind::Length,
            Curve::Velocity => Kind::Velocity,
            Curve::Acceleration => Kind::Acceleration,
            Curve::Force => Kind::Force,
            Curve::Transmissibility => Kind::Ratio,
        };
        let name = words(self.what);
        if self.what == Curve::Transmissibility {
            return format!("{name} (1)");
        }
        if self.is_machine() {
            return format!("{name} ({})", self.system.name(kind));
        }
        match self.what {
            Curve::Displacement => "dynamic amplification k Δ₀/p₀".to_owned(),
            Curve::Velocity => format!("{name}, in p₀/√(k m)"),
            Curve::Acceleration => format!("{name}, in p₀/m"),
            Curve::Force | Curve::Transmissibility | Curve::Absolute => format!("{name}, in p₀"),
        }
    }
}

/// The regime of a motion that grows without bound.
pub(super) const UNBOUNDED: &str = Regime::Unbounded.name();

pub(super) const fn words(what: Curve) -> &'static str {
    match what {
        Curve::Displacement => "maximum displacement",
        Curve::Velocity => "maximum velocity",
        Curve::Acceleration => "maximum acceleration",
        Curve::Force => "transmitted force",
        Curve::Transmissibility => "transmissibility",
        Curve::Absolute => "maximum absolute displacement",
    }
}
