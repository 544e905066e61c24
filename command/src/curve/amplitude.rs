//! The amplitude at one frequency, of the cycle that does not stick or of the exact motion.

use super::AskedCurve;
use crate::args::CurveQuantity;
use crate::failure::Failure;
use crate::input::Point;
use crate::machine::transmitted;
use stickslip::inputs::units::Kind;
use stickslip::motion::{LongRun, State};
use stickslip::{Error, Regime, Response, observed};

impl AskedCurve {
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
            if self.what == CurveQuantity::Force { force } else { ratio }
        };
        // Displacement, velocity, acceleration, transmitted force and absolute displacement, in B, B ω_d, B
        // ω_d², r_y and B.
        let (peaks, regime, sticks) = match response.cycle.as_ref() {
            Some(c) => {
                let of_cycle = match self.what {
                    CurveQuantity::Displacement => c.max_displacement,
                    CurveQuantity::Velocity => c.max_velocity,
                    CurveQuantity::Acceleration => c.max_acceleration(),
                    CurveQuantity::Force | CurveQuantity::Transmissibility => {
                        felt(c.transmitted_force(), c.max_acceleration())
                    }
                    CurveQuantity::Absolute => c.max_absolute_displacement(),
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
                            CurveQuantity::Displacement => {
                                s.max_displacement.value.abs().max(s.min_displacement.value.abs())
                            }
                            CurveQuantity::Velocity => {
                                s.max_velocity.value.abs().max(s.min_velocity.value.abs())
                            }
                            CurveQuantity::Acceleration => peaks.acceleration,
                            CurveQuantity::Force | CurveQuantity::Transmissibility => {
                                felt(peaks.transmitted_force, peaks.acceleration)
                            }
                            CurveQuantity::Absolute => peaks.absolute_displacement,
                        };
                        (Some(of_motion), regime.name(), regime == Regime::Sticking)
                    }
                    // At rest friction carries the whole force, and the body moves with its base.
                    (None, LongRun::Rest(_)) => {
                        let at_rest = match self.what {
                            CurveQuantity::Displacement
                            | CurveQuantity::Velocity
                            | CurveQuantity::Acceleration => 0.0,
                            CurveQuantity::Force | CurveQuantity::Transmissibility => felt(alpha, 0.0),
                            CurveQuantity::Absolute => alpha / omega.powi(2),
                        };
                        (Some(at_rest), "stuck", true)
                    }
                    (None, _) => (None, "undecided", false),
                }
            }
        };
        let in_units = |x: f64| match (&point.machine, self.what) {
            (_, CurveQuantity::Transmissibility) => x,
            (Some(m), CurveQuantity::Displacement | CurveQuantity::Absolute) => x * m.scales.length,
            (Some(m), CurveQuantity::Velocity) => x * m.scales.velocity,
            (Some(m), CurveQuantity::Acceleration) => x * (m.scales.velocity / m.scales.time),
            (Some(m), CurveQuantity::Force) => x * m.scales.force,
            // 1/α overflows for the least α.
            (None, CurveQuantity::Displacement | CurveQuantity::Absolute | CurveQuantity::Force) => x / alpha,
            (None, CurveQuantity::Velocity) => x / alpha * omega,
            (None, CurveQuantity::Acceleration) => x / alpha * omega.powi(2),
        };
        Ok((peaks.map(in_units), regime, sticks))
    }

    /// The name of the quantity with its unit, for an axis.
    pub(super) fn label(&self) -> String {
        let kind = match self.what {
            CurveQuantity::Displacement | CurveQuantity::Absolute => Kind::Length,
            CurveQuantity::Velocity => Kind::Velocity,
            CurveQuantity::Acceleration => Kind::Acceleration,
            CurveQuantity::Force => Kind::Force,
            CurveQuantity::Transmissibility => Kind::Ratio,
        };
        let name = words(self.what);
        if self.what == CurveQuantity::Transmissibility {
            return format!("{name} (1)");
        }
        if self.is_machine() {
            return format!("{name} ({})", self.system.name(kind));
        }
        match self.what {
            CurveQuantity::Displacement => "dynamic amplification k Δ₀/p₀".to_owned(),
            CurveQuantity::Velocity => format!("{name}, in p₀/√(k m)"),
            CurveQuantity::Acceleration => format!("{name}, in p₀/m"),
            CurveQuantity::Force | CurveQuantity::Transmissibility | CurveQuantity::Absolute => {
                format!("{name}, in p₀")
            }
        }
    }
}

/// The regime of a motion that grows without bound.
pub(super) const UNBOUNDED: &str = Regime::Unbounded.name();

pub(super) const fn words(what: CurveQuantity) -> &'static str {
    match what {
        CurveQuantity::Displacement => "maximum displacement",
        CurveQuantity::Velocity => "maximum velocity",
        CurveQuantity::Acceleration => "maximum acceleration",
        CurveQuantity::Force => "transmitted force",
        CurveQuantity::Transmissibility => "transmissibility",
        CurveQuantity::Absolute => "maximum absolute displacement",
    }
}
