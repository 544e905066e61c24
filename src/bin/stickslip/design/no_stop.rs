//! `stickslip design force --no-stop` and `bands --no-stop`: whatever the number of reversals.

use super::{Answer, Asked, some};
use crate::bits::Value;
use crate::failure::Failure;
use crate::note::no_stop;
use crate::record::{Cell, Record};
use stickslip::design::{self, Edge};
use stickslip::regime::no_stop_force_ratios;

impl<F: Value> Asked<'_, F> {
    pub(super) fn forces_without_stop(&self) -> Result<Answer<F>, Failure> {
        let (found, unit, fields) = if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            let forces = design::forces_without_stop(&body, frequency).map_err(|e| self.fail(e))?;
            let base = forces.least() / body.stiffness();
            let fields = vec![("force", some(forces.least())), ("base_motion", some(base))];
            (forces, self.units().force.as_str(), fields)
        } else {
            let omega = self.omega()?;
            let ratios = no_stop_force_ratios(omega).map_err(|e| self.fail(e))?;
            (ratios, "r_y", vec![("omega", some(omega)), ("force_ratio", some(ratios.least()))])
        };
        let name = if self.physical { "no_stop_forces" } else { "no_stop_force_ratios" };
        let mut fields = fields;
        fields.push((name, Record::intervals(&found)));
        Ok(Answer::one(format!("It does not stop {}.", no_stop(&found, unit)), fields))
    }

    pub(super) fn bands_without_stop(&self) -> Result<Answer<F>, Failure> {
        let (low, high) = self.range()?;
        let (found, names) = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is what is asked for: its amplitude alone counts.
            let drive = self.drive(self.one)?;
            let found = design::frequency_bands_without_stop(&body, &drive, low, high);
            (found, ["frequency_from", "frequency_to"])
        } else {
            (design::bands_without_stop(self.alpha()?, low, high), ["omega_from", "omega_to"])
        };
        let edge = |edge: Edge| if edge == Edge::Range { "end-of-range" } else { "border" };
        let rows: Vec<_> = found
            .map_err(|e| self.fail(e))?
            .into_iter()
            .map(|band| {
                vec![
                    (names[0], some(band.low)),
                    (names[1], some(band.high)),
                    ("low_edge", Cell::Text(edge(band.low_edge))),
                    ("high_edge", Cell::Text(edge(band.high_edge))),
                    ("reversals_per_cycle", Cell::Count(Some(band.reversals_per_cycle.into()))),
                ]
            })
            .collect();
        let sentence = match rows.len() {
            0 => "It stops, or rests, throughout that range.".to_owned(),
            1 => "It does not stop in one band of that range:".to_owned(),
            n => format!("It does not stop in {n} bands of that range:"),
        };
        Ok(Answer { sentence, rows })
    }
}
