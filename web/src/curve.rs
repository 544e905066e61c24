//! The response curve: the greatest displacement over the frequency, stops included, and that of the border.

use crate::asked::{Asked, length};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use stickslip::inputs::Input;
use stickslip::motion::Amplitude;
use stickslip::{Border, Regime};

/// The most frequencies of a curve.
const MOST: u64 = 5000;

/// The curve from `from` to `to` times the natural frequency, at equal ratios, and finer beside the natural frequency.
pub(crate) fn curve(asked: &Asked<'_>) -> Result<Value, String> {
    let given = asked.given(&asked.reader()?)?;
    let here = given.point()?;
    let (from, to) = (asked.number("from", 0.1), asked.number("to", 4.0));
    if !(from > 0.0 && from < to && to.is_finite()) {
        return Err(format!("from {from} to {to}: must be > 0, and the lower end < the upper end"));
    }
    let count = asked.count("count", 400, MOST).max(2);
    let step = (to / from).ln() / (count - 1) as f64;
    let mut omegas: Vec<f64> = (0..count).map(|i| from * (step * i as f64).exp()).collect();
    // The resonance is as wide as the damping ratio; without a damper its height has no end, and is cut.
    let width = here.ratios.damping_ratio().max(1e-3);
    let steps = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0].into_iter();
    let beside = steps.flat_map(|step| [1.0 - step * width, 1.0 + step * width]);
    omegas.extend(beside.chain([here.ratios.omega()]).filter(|omega| (from..to).contains(omega)));
    omegas.sort_by(f64::total_cmp);
    omegas.dedup();
    let mut kept = Vec::new();
    let (mut frequencies, mut values, mut regimes, mut borders) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for omega in omegas {
        let mut given = given.clone();
        match &here.machine {
            Some(machine) => {
                given.take(Input::Omega);
                given.set(Input::Frequency, omega * machine.oscillator.natural_frequency());
            }
            None => given.set(Input::Omega, omega),
        }
        // Outside the range of the arithmetic there is no point.
        let Ok(there) = given.point() else { continue };
        let found = Amplitude::Displacement.of(there.ratios, there.excitation());
        let (value, regime) = found.map_or((None, None), |found| (found.value, found.regime));
        kept.push(omega);
        frequencies.push(there.machine.map_or(omega, |machine| machine.drive.angular_frequency() / TAU));
        values.push(value.map(|x| x * length(&there)));
        regimes.push(regime.map_or("undecided", Regime::name));
        borders.push(Border::of(&there.ratios).min_displacement * length(&there));
    }
    let natural = here.machine.map_or(1.0, |machine| machine.oscillator.natural_frequency() / TAU);
    Ok(json!({
        "omega": kept, "frequency": frequencies, "displacement": values, "regime": regimes, "border": borders, "natural": natural,
        "unit": here.machine.map_or("B".to_owned(), |_| given.system.length().to_owned()),
    }))
}
