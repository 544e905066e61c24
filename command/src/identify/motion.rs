//! `stickslip identify --motion`: friction and damping from a measured load and the motion under it.

use super::{EstimateRecord, columns, each_row, estimate_line, in_line, opened};
use crate::args::IdentifyArgs;
use crate::bits::digits;
use crate::failure::{Failure, Outcome};
use crate::output;
use crate::rows::Ahead;
use serde::Serialize;
use std::f64::consts::TAU;
use std::io::Write;
use std::path::Path;
use stickslip::Excitation;
use stickslip::design::{MotionIdentified, identify_motion};
use stickslip::motion::record::Record;
use stickslip_front::inputs::Given;
use stickslip_front::inputs::units::{Kind, Reader};

/// The greatest number of rows: a fit follows the motion some thousand times.
const MOST_ROWS: usize = 20_000;

#[derive(Serialize)]
struct MotionAnswer {
    friction: EstimateRecord,
    friction_coefficient: EstimateRecord,
    friction_displacement: EstimateRecord,
    damping_ratio: EstimateRecord,
    damping: EstimateRecord,
    offset: EstimateRecord,
    start_displacement: EstimateRecord,
    start_velocity: Option<EstimateRecord>,
    stiffness: Option<EstimateRecord>,
    natural_frequency: Option<EstimateRecord>,
    load: &'static str,
    noise: f64,
    noise_unit: String,
    measurements: usize,
    residuals: Vec<f64>,
    ignored_columns: Vec<String>,
}

pub(super) fn run(
    args: &IdentifyArgs,
    given: &Given<f64>,
    reader: &Reader,
    is_json: bool,
    out: &mut impl Write,
) -> Outcome {
    let name = args.file.display().to_string();
    let file = MotionFile::read(&args.file, &name, reader)?;
    super::note_mass_beside_columns(args, reader);
    let (mass, stiffness, lines) = (given.mass()?, given.stiffness()?, &file.lines);
    let of_sample = |e: stickslip::Error| {
        let stickslip::Error::InSample { index, error } = e else { return format!("{name}: {e}") };
        let line = lines.get(index).copied().unwrap_or_default();
        format!("{name} line {line}: {error}")
    };
    let load = Record::at_times(file.excitation, file.times, file.samples).map_err(of_sample)?;
    let found =
        identify_motion(mass, stiffness, &load, &file.displacements).map_err(|e| match e.quantity() {
            Some(_) if !matches!(e, stickslip::Error::InMeasurement { .. }) => {
                Failure::from(given.at_fault(&e))
            }
            _ => in_line(e, &name, lines).into(),
        })?;
    // ω_n = √(k/m), and the error of it is half that of k.
    let natural = found.stiffness.map(|stiffness| {
        let mut natural = stiffness;
        natural.value = (stiffness.value / mass).sqrt();
        natural.standard_error = stiffness.standard_error * natural.value / (2.0 * stiffness.value);
        natural
    });
    let unit = |kind: Kind| given.system.name(kind);
    let of = |estimate, scale: f64, kind| EstimateRecord::of(estimate, scale, unit(kind));
    let MotionIdentified { friction, friction_displacement, damping_ratio, damping, .. } = &found;
    let MotionIdentified { offset, start_displacement, start_velocity, .. } = &found;
    let answer = MotionAnswer {
        friction: of(friction, 1.0, Kind::Force),
        friction_coefficient: of(friction, 1.0 / (mass * given.gravity()?), Kind::Ratio),
        friction_displacement: of(friction_displacement, 1.0, Kind::Length),
        damping_ratio: of(damping_ratio, 1.0, Kind::Ratio),
        damping: of(damping, 1.0, Kind::Damping),
        offset: of(offset, 1.0, Kind::Length),
        start_displacement: of(start_displacement, 1.0, Kind::Length),
        start_velocity: start_velocity.as_ref().map(|estimate| of(estimate, 1.0, Kind::Velocity)),
        stiffness: found.stiffness.as_ref().map(|estimate| of(estimate, 1.0, Kind::Stiffness)),
        natural_frequency: natural.as_ref().map(|estimate| of(estimate, 1.0 / TAU, Kind::Hertz)),
        load: file.load,
        noise: found.noise,
        noise_unit: unit(Kind::Length),
        measurements: found.residuals.len(),
        residuals: found.residuals,
        ignored_columns: file.others,
    };
    if is_json { output::json(&answer, out) } else { answer.text(&given.system, out) }
}

/// The columns of a load and a motion.
struct MotionFile {
    times: Vec<f64>,
    displacements: Vec<f64>,
    samples: Vec<f64>,
    load: &'static str,
    excitation: Excitation,
    lines: Vec<u64>,
    others: Vec<String>,
}

impl MotionFile {
    fn read(file: &Path, name: &str, reader: &Reader) -> Result<Self, Failure> {
        let ahead = Ahead::default();
        let (mut table, header) = opened(file, name, &ahead)?;
        let known = [
            ("time", Kind::Time),
            ("displacement", Kind::Length),
            ("force", Kind::Force),
            ("acceleration", Kind::Acceleration),
            ("foot-displacement", Kind::Length),
        ];
        let ([time, displacement, force, acceleration, foot], others) =
            columns(&header, name, reader, known)?;
        let [_, _, of_force, of_surface, of_foot] = known.map(|(name, _)| name);
        let loads = [
            (force, of_force, Excitation::Force),
            (acceleration, of_surface, Excitation::SurfaceAcceleration),
            (foot, of_foot, Excitation::FootMotion),
        ];
        let mut loads = loads.into_iter().filter_map(|(column, name, kind)| Some((column?, name, kind)));
        let missing = |what: &str| {
            let found = header.iter().collect::<Vec<_>>().join(",");
            Failure::Input(format!("{name}: {what} must be in the header “{found}”"))
        };
        let time = time.ok_or_else(|| missing("the column time"))?;
        let displacement = displacement.ok_or_else(|| missing("the column displacement"))?;
        let one = "one of the columns force, acceleration and foot-displacement";
        let (load, load_name, excitation) = loads.next().ok_or_else(|| missing(one))?;
        if loads.next().is_some() {
            return Err(missing(&format!("only {one}")));
        }
        let (mut times, mut displacements, mut samples) = (Vec::new(), Vec::new(), Vec::new());
        let lines = each_row(&mut table, name, &ahead, (MOST_ROWS, "rows"), |row, at| {
            times.push(time.value(row, at, reader)?);
            displacements.push(displacement.value(row, at, reader)?);
            samples.push(load.value(row, at, reader)?);
            Ok(())
        })?;
        Ok(Self { times, displacements, samples, load: load_name, excitation, lines, others })
    }
}

impl MotionAnswer {
    fn text(&self, system: &stickslip_front::inputs::units::System, out: &mut impl Write) -> Outcome {
        writeln!(
            out,
            "Friction and damping that explain the motion of {} samples best:\n",
            self.measurements
        )?;
        let lines = [
            ("stiffness k", self.stiffness.as_ref()),
            ("natural frequency", self.natural_frequency.as_ref()),
            ("friction force r_y", Some(&self.friction)),
            ("coefficient µ", Some(&self.friction_coefficient)),
            ("friction r_y/k", Some(&self.friction_displacement)),
            ("damping ratio ζ", Some(&self.damping_ratio)),
            ("damping constant c", Some(&self.damping)),
            ("offset", Some(&self.offset)),
            ("at the start x", Some(&self.start_displacement)),
            ("at the start v", self.start_velocity.as_ref()),
        ];
        for (name, found) in lines {
            found.map_or(Ok(()), |found| estimate_line(name, found, out))?;
        }
        let length = system.length();
        writeln!(out, "  noise               {} {length}, error of one displacement", digits(self.noise))?;
        writeln!(out, "\nThe offset is the displacement, as measured, at which the spring is relaxed.")?;
        if self.start_velocity.is_none() {
            writeln!(out, "The body starts at rest.")?;
        }
        if !self.ignored_columns.is_empty() {
            writeln!(out, "\nColumns not used: {}.", self.ignored_columns.join(", "))?;
        }
        Ok(())
    }
}
