//! `stickslip design force --no-stop` and `bands --no-stop`, for any number of reversals.

use super::{AskedDesign, DesignAnswer, force_and_equals, some};
use crate::bits::Value;
use crate::failure::Failure;
use crate::note::no_stop;
use crate::record::{Cell, Record};
use stickslip::design::{self, NoStopBand};
use stickslip::inputs::units::Kind;
use stickslip::no_stop_force_ratios;

impl<F: Value> AskedDesign<'_, F> {
    pub(super) fn forces_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let (found, unit, mut fields, name, kind) = if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            let forces = design::forces_without_stop(&body, frequency).map_err(|e| self.fail(e))?;
            let fields = force_and_equals(&body, frequency, forces.min());
            (forces, self.system().force(), fields, "no_stop_forces", Kind::Force)
        } else {
            self.one_friction()?;
            let omega = self.omega()?;
            let ratios = no_stop_force_ratios(omega, self.damping_ratio()).map_err(|e| self.fail(e))?;
            let least = ("force_ratio", Kind::Ratio, some(ratios.min()));
            let fields = vec![("omega", Kind::Ratio, some(omega)), least];
            (ratios, "r_y", fields, "no_stop_force_ratios", Kind::Ratio)
        };
        fields.push((name, kind, Record::intervals(&found)));
        Ok(DesignAnswer::one(format!("The body does not stop {}.", no_stop(&found, unit)), fields))
    }

    pub(super) fn bands_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Frequency)?;
        let found = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is unknown: only its amplitude counts.
            let drive = self.drive(&body, self.one)?;
            design::frequency_bands_without_stop(&body, &drive, low, high)
        } else {
            self.one_friction()?;
            design::bands_without_stop(self.alpha()?, self.damping_ratio(), low, high)
        };
        let row = |band: NoStopBand<F>| {
            let mut row = self.band([band.low, band.high], [band.low_edge, band.high_edge]);
            let reversals = Cell::Count(Some(band.reversals_per_cycle.into()));
            row.push(("reversals_per_cycle", Kind::Ratio, reversals));
            row
        };
        let rows: Vec<_> = found.map_err(|e| self.fail(e))?.into_iter().map(row).collect();
        let sentence = match rows.len() {
            0 => "The body stops or rests throughout that range.".to_owned(),
            1 => "The body does not stop in one band of that range:".to_owned(),
            n => format!("The body does not stop in {n} bands of that range:"),
        };
        Ok(DesignAnswer { sentence, rows })
    }
}
