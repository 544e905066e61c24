//! The amplitude at one frequency, of the cycle that does not stick or of the exact motion.

use super::AskedCurve;
use crate::args::CurveQuantity;
use crate::failure::Failure;
use stickslip::Regime;
use stickslip::inputs::Point;
use stickslip::inputs::units::Kind;
use stickslip::motion::Amplitude;

/// What is shown of a quantity.
pub(super) struct Shown {
    amplitude: Amplitude,
    kind: Kind,
    pub(super) words: &'static str,
    /// The name with the unit in ratios, in which the quantity is one over α.
    in_ratios: &'static str,
    /// The power of Ω in this unit.
    power: i32,
}

pub(super) const fn shown(what: CurveQuantity) -> Shown {
    let (amplitude, kind, words, in_ratios, power) = match what {
        CurveQuantity::Displacement => (
            Amplitude::Displacement,
            Kind::Length,
            "maximum displacement",
            "dynamic amplification k Δ₀/p₀",
            0,
        ),
        CurveQuantity::Velocity => {
            (Amplitude::Velocity, Kind::Velocity, "maximum velocity", "maximum velocity, in p₀/√(k m)", 1)
        }
        CurveQuantity::Acceleration => (
            Amplitude::Acceleration,
            Kind::Acceleration,
            "maximum acceleration",
            "maximum acceleration, in p₀/m",
            2,
        ),
        CurveQuantity::Force => {
            (Amplitude::TransmittedForce, Kind::Force, "transmitted force", "transmitted force, in p₀", 0)
        }
        CurveQuantity::Transmissibility => {
            (Amplitude::Transmissibility, Kind::Ratio, "transmissibility", "transmissibility (1)", 0)
        }
        CurveQuantity::Absolute => {
            let words = "maximum absolute displacement";
            (Amplitude::AbsoluteDisplacement, Kind::Length, words, "maximum absolute displacement, in p₀", 0)
        }
    };
    Shown { amplitude, kind, words, in_ratios, power }
}

impl AskedCurve {
    /// The value at a point, in the machine's units or in those of p₀; `None` where it grows without bound. Beside it
    /// the regime by name, and whether the body sticks.
    pub(super) fn value(&self, point: &Point<f64>) -> Result<(Option<f64>, &'static str, bool), Failure> {
        let Shown { amplitude, kind, power, .. } = shown(self.what);
        let found = amplitude
            .of(point.ratios, point.excitation())
            .map_err(|e| format!("{}: {e}", self.axis.option()))?;
        let in_units = |x: f64| match &point.machine {
            _ if kind == Kind::Ratio => x,
            Some(machine) => x * amplitude.unit(&machine.scales),
            // 1/α overflows for the least α.
            None => x / point.ratios.alpha() * point.ratios.omega().powi(power),
        };
        let regime = found.regime.map_or("undecided", Regime::name);
        let sticks = matches!(found.regime, Some(Regime::Sticking | Regime::Stuck));
        Ok((found.value.map(in_units), regime, sticks))
    }

    /// The name of the quantity with its unit, for an axis.
    pub(super) fn label(&self) -> String {
        let Shown { kind, words, in_ratios, .. } = shown(self.what);
        if self.is_machine() { format!("{words} ({})", self.system.name(kind)) } else { in_ratios.to_owned() }
    }
}

/// The regime of a motion that grows without bound.
pub(super) const UNBOUNDED: &str = Regime::Unbounded.name();
