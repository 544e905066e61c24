//! The amplitude at one frequency, of the cycle that does not stick or of the exact motion.

use super::AskedCurve;
use crate::args::CurveQuantity;
use crate::failure::Failure;
use crate::input::Point;
use crate::machine::excitation;
use stickslip::Regime;
use stickslip::inputs::units::Kind;
use stickslip::motion::Amplitude;

impl AskedCurve {
    /// The value at a point, in the machine's units or in those of p₀; `None` where it grows without bound. Beside it
    /// the regime by name, and whether the body sticks.
    pub(super) fn value(&self, point: &Point<f64>) -> Result<(Option<f64>, &'static str, bool), Failure> {
        let (omega, alpha) = (point.ratios.omega(), point.ratios.alpha());
        let amplitude = match self.what {
            CurveQuantity::Displacement => Amplitude::Displacement,
            CurveQuantity::Velocity => Amplitude::Velocity,
            CurveQuantity::Acceleration => Amplitude::Acceleration,
            CurveQuantity::Force => Amplitude::TransmittedForce,
            CurveQuantity::Transmissibility => Amplitude::Transmissibility,
            CurveQuantity::Absolute => Amplitude::AbsoluteDisplacement,
        };
        let excitation = excitation(point.machine.as_ref());
        let found = amplitude
            .of(point.ratios, excitation)
            .map_err(|e| Failure::Input(format!("{}: {e}", self.axis.option())))?;
        let in_units = |x: f64| match (&point.machine, self.what) {
            (_, CurveQuantity::Transmissibility) => x,
            (Some(machine), _) => x * amplitude.unit(&machine.scales),
            // 1/α overflows for the least α.
            (None, CurveQuantity::Displacement | CurveQuantity::Absolute | CurveQuantity::Force) => x / alpha,
            (None, CurveQuantity::Velocity) => x / alpha * omega,
            (None, CurveQuantity::Acceleration) => x / alpha * omega.powi(2),
        };
        let regime = found.regime.map_or("undecided", Regime::name);
        let sticks = matches!(found.regime, Some(Regime::Sticking | Regime::Stuck));
        Ok((found.value.map(in_units), regime, sticks))
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
