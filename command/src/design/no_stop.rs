//! `stickslip design force --no-stop` and `bands --no-stop`, for any number of reversals.

use super::{AskedDesign, DesignAnswer, force_and_equals, some};
use crate::bits::Value;
use crate::failure::Failure;
use crate::note::no_stop;
use crate::record::{Cell, Record};
use stickslip::design::{self, Edge};
use stickslip::inputs::units::Kind;
use stickslip::no_stop_force_ratios;

impl<F: Value> AskedDesign<'_, F> {
    pub(super) fn forces_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let (found, unit, fields) = if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            let forces = design::forces_without_stop(&body, frequency).map_err(|e| self.fail(e))?;
            let fields = force_and_equals(&body, frequency, forces.min());
            (forces, self.system().force(), fields)
        } else {
            self.one_friction()?;
            let omega = self.omega()?;
            let found = no_stop_force_ratios(omega, self.damping_ratio());
            let ratios = found.map_err(|e| self.fail(e))?;
            let fields =
                vec![("omega", Kind::Ratio, some(omega)), ("force_ratio", Kind::Ratio, some(ratios.min()))];
            (ratios, "r_y", fields)
        };
        let (name, kind) = if self.physical {
            ("no_stop_forces", Kind::Force)
        } else {
            ("no_stop_force_ratios", Kind::Ratio)
        };
        let mut fields = fields;
        fields.push((name, kind, Record::intervals(&found)));
        Ok(DesignAnswer::one(format!("The body does not stop {}.", no_stop(&found, unit)), fields))
    }

    pub(super) fn bands_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let kind = if self.physical { Kind::Frequency } else { Kind::Ratio };
        let (low, high) = self.range(kind)?;
        let (found, names) = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is unknown: only its amplitude counts.
            let drive = self.drive(&body, self.one)?;
            let found = design::frequency_bands_without_stop(&body, &drive, low, high);
            (found, ["frequency_from", "frequency_to"])
        } else {
            self.one_friction()?;
            let (alpha, zeta) = (self.alpha()?, self.damping_ratio());
            let found = design::bands_without_stop(alpha, zeta, low, high);
            (found, ["omega_from", "omega_to"])
        };
        let edge = |edge: Edge| if edge == Edge::Range { "end-of-range" } else { "border" };
        let rows: Vec<_> = found
            .map_err(|e| self.fail(e))?
            .into_iter()
            .map(|band| {
                vec![
                    (names[0], kind, some(band.low)),
                    (names[1], kind, some(band.high)),
                    ("low_edge", Kind::Ratio, Cell::Text(edge(band.low_edge))),
                    ("high_edge", Kind::Ratio, Cell::Text(edge(band.high_edge))),
                    ("reversals_per_cycle", Kind::Ratio, Cell::Count(Some(band.reversals_per_cycle.into()))),
                ]
            })
            .collect();
        let sentence = match rows.len() {
            0 => "The body stops or rests throughout that range.".to_owned(),
            1 => "The body does not stop in one band of that range:".to_owned(),
            n => format!("The body does not stop in {n} bands of that range:"),
        };
        Ok(DesignAnswer { sentence, rows })
    }
}
