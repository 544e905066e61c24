//! `stickslip identify --decay`: friction and damping from a free decay.

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
use stickslip::Error;
use stickslip::design::{DecayIdentified, TurningPoints, identify_decay, identify_turning_points};
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::inputs::{Given, Input, Role, critical_damping};

/// The greatest number of rows.
const MOST_ROWS: usize = 100_000;

#[derive(Serialize)]
struct DecayAnswer {
    friction_displacement: EstimateRecord,
    damping_ratio: EstimateRecord,
    amplitude: EstimateRecord,
    natural_frequency: Option<EstimateRecord>,
    friction: Option<EstimateRecord>,
    friction_coefficient: Option<EstimateRecord>,
    damping: Option<EstimateRecord>,
    noise: f64,
    noise_unit: String,
    measurements: usize,
    read_as: Option<TurningPoints>,
    half_cycles: Option<usize>,
    static_friction_displacement: Option<(f64, f64)>,
    turning_points: Vec<(Option<f64>, f64)>,
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
    let file = DecayFile::read(&args.file, &name, reader)?;
    super::note_mass_beside_columns(args, reader);
    let found = file.identified(args.half_cycles).map_err(|e| in_line(e, &name, &file.lines))?;
    let answer = DecayAnswer::new(given, found, &file)?;
    if is_json { output::json(&answer, out) } else { answer.text(&file, given, out) }
}

/// The columns of a decay.
struct DecayFile {
    times: Option<Vec<f64>>,
    /// Turning points, or samples.
    values: Vec<f64>,
    is_sampled: bool,
    lines: Vec<u64>,
    others: Vec<String>,
}

impl DecayFile {
    /// The columns `time` and `displacement`, or `peak` and optionally `time`.
    fn read(file: &Path, name: &str, reader: &Reader) -> Result<Self, Failure> {
        let ahead = Ahead::default();
        let (mut table, header) = opened(file, name, &ahead)?;
        let known = [("time", Kind::Time), ("displacement", Kind::Length), ("peak", Kind::Length)];
        let ([time, displacement, peak], others) = columns(&header, name, reader, known)?;
        let (is_sampled, column) = match (displacement, peak) {
            (Some(column), None) => (true, column),
            (None, Some(column)) => (false, column),
            (both, _) => {
                let found = header.iter().collect::<Vec<_>>().join(",");
                let what = if both.is_some() { "one of the columns" } else { "the column" };
                return Err(format!(
                    "{name}: {what} peak or displacement must be in the header “{found}”, such as peak[mm]"
                )
                .into());
            }
        };
        if is_sampled && time.is_none() {
            return Err(format!("{name}: the column time is missing beside displacement").into());
        }
        let (mut values, mut times) = (Vec::new(), Vec::new());
        let lines = each_row(&mut table, name, &ahead, (MOST_ROWS, "rows"), |row, at| {
            values.push(column.value(row, at, reader)?);
            if let Some(time) = &time {
                times.push(time.value(row, at, reader)?);
            }
            Ok(())
        })?;
        Ok(Self { times: time.map(|_| times), values, is_sampled, lines, others })
    }

    fn identified(&self, half_cycles: bool) -> Result<DecayIdentified, Error> {
        if self.is_sampled {
            return identify_decay(self.times.as_deref().unwrap_or_default(), &self.values);
        }
        let alternates = self.values.windows(2).all(|pair| matches!(pair, [a, b] if a * b < 0.0));
        let kind =
            if half_cycles || alternates { TurningPoints::EveryHalfCycle } else { TurningPoints::EveryCycle };
        identify_turning_points(&self.values, self.times.as_deref(), kind)
    }
}

impl DecayAnswer {
    fn new(given: &Given<f64>, found: DecayIdentified, file: &DecayFile) -> Result<Self, Failure> {
        let unit = |kind: Kind| given.system.name(kind);
        let mass = given.has_role(Role::Mass).then(|| given.mass()).transpose()?;
        // The spring: as given, or by the frequency found and the mass.
        let natural = match given.one_of(Role::Spring)? {
            Some((Input::Period, period)) => Some(TAU / period),
            Some((Input::NaturalFrequency, natural)) => Some(natural),
            _ => found.natural_frequency.map(|estimate| estimate.value),
        };
        let stiffness = match (given.one_of(Role::Spring)?, mass, natural) {
            (Some((Input::Stiffness, stiffness)), ..) => Some(stiffness),
            (Some((Input::PendulumRadius, _)), Some(_), _) => given.stiffness()?,
            (_, Some(mass), Some(natural)) => Some(mass * natural * natural),
            _ => None,
        };
        let square = match (stiffness, mass) {
            (Some(stiffness), Some(mass)) => Some(stiffness / mass),
            _ => natural.map(|natural| natural * natural),
        };
        let gravity = given.gravity()?;
        let critical = stiffness.zip(mass).map(|(k, m)| critical_damping(m, k));
        let of = |scale: f64, kind| EstimateRecord::of(&found.friction_displacement, scale, unit(kind));
        Ok(Self {
            friction: stiffness.map(|k| of(k, Kind::Force)),
            friction_coefficient: square.map(|square| of(square / gravity, Kind::Ratio)),
            damping: critical.map(|c| EstimateRecord::of(&found.damping_ratio, c, unit(Kind::Damping))),
            friction_displacement: of(1.0, Kind::Length),
            damping_ratio: EstimateRecord::of(&found.damping_ratio, 1.0, unit(Kind::Ratio)),
            amplitude: EstimateRecord::of(&found.amplitude, 1.0, unit(Kind::Length)),
            natural_frequency: found
                .natural_frequency
                .map(|estimate| EstimateRecord::of(&estimate, 1.0 / TAU, "Hz".to_owned())),
            noise: found.noise,
            noise_unit: unit(Kind::Length),
            measurements: found.residuals.len(),
            read_as: found.read_as,
            half_cycles: found.half_cycles,
            static_friction_displacement: found.static_friction_displacement,
            turning_points: found.turning_points,
            residuals: found.residuals,
            ignored_columns: file.others.clone(),
        })
    }

    fn text(&self, file: &DecayFile, given: &Given<f64>, out: &mut impl Write) -> Outcome {
        let length = given.system.length();
        let what = if file.is_sampled { "samples" } else { "turning points" };
        writeln!(out, "Friction and damping that explain the decay of {} {what} best:\n", self.measurements)?;
        let lines = [
            ("friction r_y/k", Some(&self.friction_displacement)),
            ("damping ratio ζ", Some(&self.damping_ratio)),
            ("natural frequency", self.natural_frequency.as_ref()),
            ("friction force r_y", self.friction.as_ref()),
            ("coefficient µ", self.friction_coefficient.as_ref()),
            ("damping constant c", self.damping.as_ref()),
        ];
        for (name, found) in lines {
            found.map_or(Ok(()), |found| estimate_line(name, found, out))?;
        }
        writeln!(out, "  noise               {} {length}, error of one measurement", digits(self.noise))?;
        match self.read_as {
            Some(TurningPoints::EveryHalfCycle) => {
                writeln!(out, "\nThe peaks are read as those of both sides, one in every half cycle.")?;
            }
            Some(_) => writeln!(
                out,
                "\nThe peaks are read as those of one side, one in every cycle. Peaks of both sides without signs need \
                 --half-cycles."
            )?,
            None => {}
        }
        if let Some((least, most)) = self.static_friction_displacement {
            writeln!(
                out,
                "\nThe body comes to rest: static friction r_s/k is between {} and {} {length}.",
                digits(least),
                digits(most)
            )?;
        }
        if self.friction.is_none() {
            writeln!(out, "\nWith --stiffness, or --mass and the frequency, the friction is a force, too.")?;
        }
        if !self.ignored_columns.is_empty() {
            writeln!(out, "\nColumns not used: {}.", self.ignored_columns.join(", "))?;
        }
        writeln!(out, "\n  turning point{}", if file.is_sampled { "" } else { "  measured less computed" })?;
        for (i, (time, x)) in self.turning_points.iter().enumerate() {
            let time = time.map_or(String::new(), |t| format!("  at {} s", digits(t)));
            let rest = match self.residuals.get(i) {
                Some(rest) if !file.is_sampled => format!("  {rest:+.3e} {length}"),
                _ => String::new(),
            };
            writeln!(out, "  {:>11} {length}{time}{rest}", digits(*x))?;
        }
        Ok(())
    }
}
