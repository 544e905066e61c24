//! `stickslip identify`: friction and damping from a measured response curve.

mod decay;
mod motion;
mod read;

use crate::args::IdentifyArgs;
use crate::bits::digits;
use crate::columns::Column;
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::output;
use crate::rows::Ahead;
use csv::StringRecord;
use read::{EstimateRecord, columns, each_row, estimate_line, in_line, note_mass_beside_columns, opened};
use serde::Serialize;
use std::f64::consts::TAU;
use std::io::Write;
use std::iter::zip;
use std::path::Path;
use stickslip::design::{self, AmplitudeKind, Identified, Measurement, PhaseKind, Reading};
use stickslip::uncertainty::Estimate;
use stickslip::{Error, Oscillator};
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::inputs::{Given, Input, Role};
use stickslip_front::names::name_and_unit;

/// The greatest number of measurements.
const MOST_ROWS: usize = 10_000;
/// The noise from which on a model does not explain a curve.
const MUCH_NOISE: f64 = 0.1;

pub(crate) fn run(args: &IdentifyArgs, out: &mut impl Write) -> Outcome {
    let is_json = args.format.is_json("identify")?;
    let reader = args.units.reader();
    let given = input::read::<f64>(&args.machine, &reader)?;
    if (args.decay || args.motion) && given.is_without_spring() {
        let (option, why) = if args.decay {
            (
                "--decay",
                "a body without a spring does not swing. `stickslip decay` has the path of one that slides",
            )
        } else {
            (
                "--motion",
                "leave it out, and the stiffness is fitted. The response curve of a body without a spring is answered",
            )
        };
        return Err(
            format!("{}: must be left out with {option}: {why}", given.label(Input::Stiffness)).into()
        );
    }
    if args.decay {
        return decay::run(args, &given, &reader, is_json, out);
    }
    if args.motion {
        return motion::run(args, &given, &reader, is_json, out);
    }
    let question = Asked::of(&given)?;
    let name = args.file.display().to_string();
    let file = Measured::read(&args.file, &name, &reader)?;
    note_mass_beside_columns(args, &reader);
    let reading = Reading { amplitude: args.amplitude, phase: args.phase };
    let (found, fitted) = question.answered(&file.curve, reading).map_err(|e| {
        // The message names the arguments if they are wrong, and otherwise the file.
        match e.quantity() {
            Some(_) if !matches!(e, Error::InMeasurement { .. }) => {
                Failure::from(given.at_fault(&e)).about(&name)
            }
            _ => in_line(e, &name, &file.lines).into(),
        }
    })?;
    let mut answer = IdentifyAnswer::new(&given, question.mass, &found, &file, reading.amplitude)?;
    match fitted {
        Some(Fitted::NaturalFrequency(estimate)) => {
            let hertz = given.system.name(Kind::Hertz);
            answer.natural_frequency = Some(EstimateRecord::of(&estimate, 1.0 / TAU, hertz));
        }
        Some(Fitted::Force(estimate)) => {
            answer.force = Some(EstimateRecord::of(&estimate, 1.0, given.system.name(Kind::Force)));
        }
        None => {}
    }
    if is_json {
        return output::json(&answer, out);
    }
    text(&given, &answer, &found, &file, out)
}

/// What is known of the machine: a stiffness of 0 is a body without a spring.
struct Asked {
    mass: f64,
    stiffness: Option<f64>,
    force: Option<f64>,
}

/// A reading of the amplitudes that fits better.
#[derive(Clone, Copy, Serialize)]
struct BetterReading {
    amplitude: AmplitudeKind,
    noise: f64,
}

/// What was fitted besides friction and damping.
enum Fitted {
    NaturalFrequency(Estimate),
    Force(Estimate),
}

impl Asked {
    fn of(given: &Given<f64>) -> Result<Self, Failure> {
        let (stiffness, has_drive) = (given.stiffness()?, given.has_role(Role::Drive));
        if stiffness.is_none() && (!has_drive || given.has(Input::FootDisplacement)) {
            return Err(given.missing(&Input::of_role(Role::Spring)).into());
        }
        if given.is_without_spring() {
            let label = given.label(Input::Stiffness);
            if given.has(Input::FootDisplacement) {
                let label = given.label(Input::FootDisplacement);
                return Err(format!("{label}: must be left out without a spring").into());
            }
            if !has_drive {
                let text =
                    "needs the drive, because the amplitude of a body without a spring is a multiple of it";
                return Err(format!("{label}: {text}").into());
            }
        }
        let mass = given.mass()?;
        // The force of the other drives does not depend on the spring.
        let spring = stiffness.filter(|_| !given.is_without_spring()).unwrap_or(1.0);
        let body = Oscillator::new(mass, spring, 1.0).map_err(|e| given.at_fault(&e))?;
        let force = if has_drive { Some(force(given, &body)?) } else { None };
        Ok(Self { mass, stiffness, force })
    }

    /// The fit.
    fn answered(
        &self,
        curve: &[Measurement],
        reading: Reading,
    ) -> Result<(Identified, Option<Fitted>), Error> {
        let found = design::identify(self.mass, self.stiffness, self.force, curve, reading)?;
        let natural = found.natural_frequency.map(Fitted::NaturalFrequency);
        let fitted = natural.or(found.force.map(Fitted::Force));
        Ok((found, fitted))
    }
}

/// The amplitude of the force, which must be the same at every frequency.
fn force(given: &Given<f64>, body: &Oscillator<f64>) -> Result<f64, Failure> {
    match given.one_of(Role::Drive)? {
        Some((
            input @ (Input::BaseVelocity | Input::BaseDisplacement | Input::Unbalance | Input::Eccentricity),
            _,
        )) => Err(format!(
            "{}: its force changes with the frequency. Measure at one --force or --base-acceleration",
            input.option()
        )
        .into()),
        // For the other excitations, the force does not depend on the frequency.
        _ => Ok(given.drive(body, 1.0)?.force_amplitude(body)),
    }
}

/// A phase within a turn. Without a unit it is in radians, and more than a turn is a sign of degrees.
fn phase(column: &Column, row: &StringRecord, at: &str, reader: &Reader) -> Result<f64, Failure> {
    let (phase, text) = (column.value::<f64>(row, at, reader)?, column.text(row));
    if column.factor.is_some() || Reader::has_unit(text) {
        return Ok(phase % TAU);
    }
    // 2π with three decimals.
    if phase.abs() > 6.284 {
        return Err(format!(
            "{at}: phase {text}: must be ≥ -2π and ≤ 2π because it has no unit and is in radians. For \
             degrees the column is phase[deg]"
        )
        .into());
    }
    Ok(phase.clamp(-TAU, TAU))
}

/// The measurements of a file.
struct Measured {
    curve: Vec<Measurement>,
    /// The line of each measurement.
    lines: Vec<u64>,
    /// The columns that are not read.
    others: Vec<String>,
    /// The units of the columns frequency and amplitude, with their sizes, where the header states them.
    units: [Option<(String, f64)>; 2],
}

/// The unit of a column, and its size.
fn unit_of(header: &StringRecord, column: &str, read: &Column) -> Option<(String, f64)> {
    let mut units = header.iter().map(name_and_unit);
    let (_, unit) = units.find(|(own, _)| own.eq_ignore_ascii_case(column))?;
    Some((unit?.to_owned(), read.factor?.times(1.0)))
}

impl Measured {
    /// The columns `frequency` and `amplitude`, and `phase` if it was measured.
    fn read(file: &Path, name: &str, reader: &Reader) -> Result<Self, Failure> {
        let ahead = Ahead::default();
        let (mut table, header) = opened(file, name, &ahead)?;
        let known = [("frequency", Kind::Frequency), ("amplitude", Kind::Length), ("phase", Kind::Angle)];
        let ([frequency, amplitude, angle], others) = columns(&header, name, reader, known)?;
        let due = |column: Option<Column>, which: &str| {
            column.ok_or_else(|| {
                let found = header.iter().collect::<Vec<_>>().join(",");
                Failure::Input(format!("{name}: column {which} is missing in the header “{found}”"))
            })
        };
        let (frequency, amplitude) = (due(frequency, "frequency")?, due(amplitude, "amplitude")?);
        let units = [unit_of(&header, "frequency", &frequency), unit_of(&header, "amplitude", &amplitude)];
        let mut curve = Vec::new();
        let lines = each_row(&mut table, name, &ahead, (MOST_ROWS, "measurements"), |row, at| {
            curve.push(Measurement {
                angular_frequency: frequency.value(row, at, reader)?,
                amplitude: amplitude.value(row, at, reader)?,
                phase: angle.as_ref().map(|column| phase(column, row, at, reader)).transpose()?,
            });
            Ok(())
        })?;
        Ok(Self { curve, lines, others, units })
    }
}

/// A row that was left out.
#[derive(Serialize)]
struct Suspect {
    line: u64,
    amplitude: bool,
    phase: bool,
}

#[derive(Serialize)]
struct IdentifyAnswer {
    friction: EstimateRecord,
    friction_coefficient: EstimateRecord,
    damping_ratio: Option<EstimateRecord>,
    damping: EstimateRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    natural_frequency: Option<EstimateRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<EstimateRecord>,
    noise: f64,
    phase_noise: Option<f64>,
    measurements: usize,
    used: usize,
    amplitude_kind: AmplitudeKind,
    phase_kind: Option<PhaseKind>,
    better_phase: Option<PhaseKind>,
    better_reading: Option<BetterReading>,
    search_is_complete: bool,
    suspects: Vec<Suspect>,
    residuals: Vec<f64>,
    phase_residuals: Vec<Option<f64>>,
    stops: Vec<bool>,
    ignored_columns: Vec<String>,
}

impl IdentifyAnswer {
    fn new(
        given: &Given<f64>,
        mass: f64,
        found: &Identified,
        file: &Measured,
        amplitude_kind: AmplitudeKind,
    ) -> Result<Self, Failure> {
        let unit = |kind: Kind| given.system.name(kind);
        let weight = mass * given.gravity()?;
        let suspects: Vec<Suspect> = zip(&file.lines, &found.residuals)
            .filter(|(_, residual)| residual.is_suspect())
            .map(|(&line, r)| Suspect { line, amplitude: r.amplitude_is_suspect, phase: r.phase_is_suspect })
            .collect();
        Ok(Self {
            friction: EstimateRecord::of(&found.friction_bound, 1.0, unit(Kind::Force)),
            friction_coefficient: EstimateRecord::of(&found.friction_bound, 1.0 / weight, unit(Kind::Ratio)),
            damping_ratio: (!given.is_without_spring())
                .then(|| EstimateRecord::of(&found.damping_ratio, 1.0, unit(Kind::Ratio))),
            damping: EstimateRecord::of(&found.damping_ratio, found.critical_damping, unit(Kind::Damping)),
            natural_frequency: None,
            force: None,
            noise: found.noise,
            phase_noise: found.phase_noise,
            measurements: found.residuals.len(),
            used: found.residuals.len() - suspects.len(),
            amplitude_kind,
            phase_kind: found.phase,
            better_phase: found.better_phase,
            better_reading: found.better.map(|(amplitude, noise)| BetterReading { amplitude, noise }),
            search_is_complete: found.search_is_complete,
            suspects,
            residuals: found.residuals.iter().map(|r| r.amplitude).collect(),
            phase_residuals: found.residuals.iter().map(|r| r.phase).collect(),
            stops: found.residuals.iter().map(|r| r.stops).collect(),
            ignored_columns: file.others.clone(),
        })
    }

    /// Remarks on the reliability of the numbers.
    fn remarks(&self) -> Vec<String> {
        let percent = |x: f64| format!("{} %", digits((1e4 * x).round() / 100.0));
        let mut remarks = Vec::new();
        if self.noise > MUCH_NOISE {
            remarks.push(format!(
                "The model does not explain this curve: amplitudes differ from it by {}.",
                percent(self.noise)
            ));
        }
        if let Some(better) = self.better_reading {
            let (kind, noise) = (better.amplitude.name(), percent(better.noise));
            remarks.push(format!(
                "The amplitudes look like {kind} values: with --amplitude {kind} the noise is {noise}."
            ));
        }
        if let Some(noise) = self.phase_noise.filter(|noise| *noise > MUCH_NOISE) {
            remarks.push(format!(
                "The model does not explain the phases: they differ from it by {}°.",
                digits(noise.to_degrees().round())
            ));
        }
        if let Some(kind) = self.phase_kind {
            remarks.push(format!("Phases are read as --phase {}: {}.", kind.name(), of_phase(kind)));
        }
        if let Some(kind) = self.better_phase {
            remarks.push(format!(
                "The phases look like {0} values: --phase {0} fits significantly better.",
                kind.name()
            ));
        }
        if !self.search_is_complete {
            let text = "The search for other minima was cut short by the bound on its work: the answer is the best one it found.";
            remarks.push(text.to_owned());
        }
        if !self.suspects.is_empty() {
            let part = |s: &Suspect| match (s.amplitude, s.phase) {
                (true, true) => format!("line {} (amplitude and phase)", s.line),
                (true, false) => format!("line {} (amplitude)", s.line),
                _ => format!("line {} (phase)", s.line),
            };
            let suspects: Vec<String> = self.suspects.iter().map(part).collect();
            remarks.push(format!("Left out because the others contradict them: {}.", suspects.join(", ")));
        }
        if !self.ignored_columns.is_empty() {
            remarks.push(format!("Columns not used: {}.", self.ignored_columns.join(", ")));
        }
        remarks
    }
}

fn of_phase(kind: PhaseKind) -> &'static str {
    match kind {
        PhaseKind::Peak => "ω_d t of the peak displacement under p₀ sin ω_d t",
        PhaseKind::Lag => "the lag of the displacement behind the force",
        PhaseKind::TransferFunction => "the lag of the displacement behind the force, negative",
    }
}

fn text(
    given: &Given<f64>,
    answer: &IdentifyAnswer,
    found: &Identified,
    file: &Measured,
    out: &mut impl Write,
) -> Outcome {
    let IdentifyAnswer { used, measurements, .. } = answer;
    writeln!(out, "Friction and damping that explain {used} of {measurements} measurements best:\n")?;
    for (name, found) in [
        ("friction force r_y", Some(&answer.friction)),
        ("coefficient µ", Some(&answer.friction_coefficient)),
        ("damping ratio ζ", answer.damping_ratio.as_ref()),
        ("damping constant c", Some(&answer.damping)),
        ("natural frequency", answer.natural_frequency.as_ref()),
        ("force amplitude p₀", answer.force.as_ref()),
    ] {
        found.map_or(Ok(()), |found| estimate_line(name, found, out))?;
    }
    let noise = digits(100.0 * answer.noise);
    writeln!(out, "  noise               {noise} %, relative error of one amplitude")?;
    if let Some(noise) = answer.phase_noise {
        writeln!(out, "                      {}°, error of one phase", digits(noise.to_degrees()))?;
    }
    for (i, remark) in answer.remarks().iter().enumerate() {
        writeln!(out, "{}{remark}", if i == 0 { "\n" } else { "" })?;
    }
    let phases = if answer.phase_kind.is_some() { "      phase  measured less computed" } else { "" };
    writeln!(out, "\n  {:>12}  {:>14}  measured less computed{phases}", "frequency", "amplitude")?;
    // In the units of the file.
    let [own_frequency, own_length] = file.units.clone();
    let (hertz, cycle) = own_frequency.unwrap_or_else(|| ("Hz".to_owned(), TAU));
    let (length, unit) = own_length.unwrap_or_else(|| (given.system.length().to_owned(), 1.0));
    for (measured, residual) in zip(&file.curve, &found.residuals) {
        let frequency = format!("{} {hertz}", digits(measured.angular_frequency / cycle));
        let amplitude = format!("{} {length}", digits(measured.amplitude / unit));
        let of_amplitude = format!("{:+.3} %", 100.0 * residual.amplitude);
        write!(out, "  {frequency:>12}  {amplitude:>14}  {of_amplitude:>22}")?;
        if let (Some(phase), Some(r)) = (measured.phase, residual.phase) {
            write!(out, "  {:>8.3}°  {:>21.3}°", phase.to_degrees(), r.to_degrees())?;
        }
        let marks = [(residual.is_suspect(), "left out"), (residual.stops, "stops")];
        let marks: Vec<&str> = marks.into_iter().filter(|(is, _)| *is).map(|(_, mark)| mark).collect();
        writeln!(out, "{}{}", if marks.is_empty() { "" } else { "  " }, marks.join(", "))?;
    }
    Ok(())
}
