//! The response curve: the greatest displacement over the frequency, stops included, and that of the border.

use crate::asked::{Asked, Problem, length};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use stickslip::motion::Amplitude;
use stickslip::{Border, Regime};
use stickslip_front::curve::{Axis, Place, Source};
use stickslip_front::inputs::units::InputError;
use stickslip_front::inputs::{Given, Input, Point};

/// The most frequencies of a curve.
const MOST: u64 = 5000;

/// A frequency ratio of the curve.
#[derive(Clone, Copy)]
struct OfCurve {
    omega: f64,
    source: Source,
    point: Option<Point<f64>>,
    /// In B of its point.
    value: Option<f64>,
    regime: Option<Regime>,
}

impl Place for OfCurve {
    fn x(&self) -> f64 {
        self.omega
    }

    fn height(&self) -> f64 {
        let size = self.point.as_ref().map_or(1.0, length);
        let otherwise = if self.regime == Some(Regime::Unbounded) { f64::INFINITY } else { f64::NAN };
        self.value.map_or(otherwise, |x| x * size)
    }

    fn is_stuck(&self) -> bool {
        self.regime == Some(Regime::Stuck)
    }

    fn source(&self) -> Source {
        self.source
    }

    fn because(self, source: Source) -> Self {
        Self { source, ..self }
    }
}

/// The machine at another frequency ratio, to the natural frequency or to that of a body without a spring.
fn at_ratio(given: &Given<f64>, natural: Option<f64>, omega: f64) -> Result<Point<f64>, InputError> {
    let mut given = given.clone();
    match natural {
        Some(natural) => {
            given.take(Input::Omega);
            given.set(Input::Frequency, omega * natural);
        }
        None => given.set(Input::Omega, omega),
    }
    given.point()
}

/// The curve from `from` to `to` times the natural frequency, or without a spring times the frequency of the drive, at `count` equal ratios or at the frequency ratios
/// `omegas`; with `resolved` its peaks, the onset of sliding, and what a line beside them needs, as `stickslip
/// response-curve` resolves them.
pub(crate) fn curve(asked: &Asked<'_>) -> Result<Value, String> {
    let Problem { given, point: here, is_free, is_frictionless, is_without_spring, .. } = asked.problem()?;
    if is_free {
        return Err("a free vibration has no response curve".to_owned());
    }
    let (from, to) = (asked.number("from", 0.1), asked.number("to", 4.0));
    if !(from > 0.0 && from < to && to.is_finite()) {
        return Err(format!("from {from} to {to}: must be > 0, and the lower end < the upper end"));
    }
    let count = asked.count("count", 400, MOST).max(2);
    let at = |share: f64| from * (to / from).powf(share);
    let mut omegas: Vec<f64> = (0..count).map(|i| at(i as f64 / (count - 1) as f64)).collect();
    let listed = asked.numbers("omegas");
    let own = if is_without_spring { 1.0 } else { here.ratios.omega() };
    if !listed.is_empty() {
        omegas = listed;
    } else if (from..to).contains(&own) {
        omegas.push(own);
    }
    omegas.sort_by(f64::total_cmp);
    omegas.dedup();
    let natural = here.machine.map(|machine| match is_without_spring {
        true => machine.drive.angular_frequency(),
        false => machine.oscillator.natural_frequency(),
    });
    let place = |omega: f64, source: Source| -> Result<OfCurve, String> {
        // Outside the range of the arithmetic there is no point.
        let point = at_ratio(&given, natural, omega).ok();
        let found = point.and_then(|point| Amplitude::Displacement.of(point.ratios, point.excitation()).ok());
        let (value, regime) = found.map_or((None, None), |found| (found.value, found.regime));
        Ok(OfCurve { omega, source, point, value, regime })
    };
    let each =
        |all: Vec<(f64, Source)>| all.into_iter().map(|(omega, source)| place(omega, source)).collect();
    let places = if asked.0.get("resolved").and_then(Value::as_bool).unwrap_or(false) {
        Axis {
            values: &omegas,
            at,
            is_logarithmic: true,
            natural: if is_without_spring { f64::NAN } else { 1.0 },
        }
        .through(each, place)?
    } else {
        each(omegas.iter().map(|omega| (*omega, Source::Grid)).collect::<Vec<_>>())?
    };
    let mut columns: [Vec<Value>; 6] = Default::default();
    for OfCurve { omega, source, point, value, regime } in places {
        let Some(point) = point else { continue };
        let frequency = point.machine.map_or(omega, |machine| machine.drive.angular_frequency() / TAU);
        let border =
            (!is_frictionless).then(|| Border::of(&point.ratios).least_displacement * length(&point));
        let row = [
            json!(omega),
            json!(frequency),
            json!(value.map(|x| x * length(&point))),
            json!(regime.map_or("undecided", Regime::name)),
            json!(border),
            json!(source.name()),
        ];
        columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
    }
    let [omega, frequency, displacement, regime, border, source] = columns;
    Ok(json!({
        "omega": omega, "frequency": frequency, "displacement": displacement, "regime": regime, "border": border,
        "point": source, "natural": natural.map_or(1.0, |natural| natural / TAU),
        "unit": here.machine.map_or("B".to_owned(), |_| given.system.length().to_owned()),
    }))
}
