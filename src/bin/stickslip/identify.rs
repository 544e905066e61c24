//! `stickslip identify`: friction and damping from a measured response curve.

use crate::args::{Format, IdentifyArgs};
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter as P};
use crate::note::digits;
use csv::{ReaderBuilder, StringRecord, Trim};
use serde::Serialize;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;
use stickslip::Oscillator;
use stickslip::design::{self, Identified, Measurement};
use stickslip::uncertainty::Estimate;
use stickslip::units::{Factor, Kind, Reader};

pub(crate) fn run(args: &IdentifyArgs, out: &mut impl Write) -> Outcome {
    let reader = args.units.reader();
    let given = Given::<f64>::of(&args.machine, &args.force, &reader)?;
    let body = body(&given)?;
    let force = force(&given, &body)?;
    let name = args.file.display().to_string();
    let curve = measurements(&args.file, &name, &reader)?;
    let found = design::identify(&body, force, &curve).map_err(|e| {
        // The message names the arguments if they are wrong, and otherwise the file.
        match e.quantity() {
            Some(_) => given.at_fault(e).about(&name),
            None => Failure::Input(format!("{name}: {e}")),
        }
    })?;
    let answer = Answer::new(&given, &body, &found)?;
    match args.format {
        Format::Text => text(&given, &answer, &curve, out),
        Format::Json => {
            serde_json::to_writer_pretty(&mut *out, &answer)?;
            Ok(out.write_all(b"\n")?)
        }
        Format::Jsonl | Format::Csv => {
            Err(Failure::Input("--format: the answer to identify is text or json".to_owned()))
        }
    }
}

/// Mass and spring; friction is unknown.
fn body(given: &Given<f64>) -> Result<Oscillator<f64>, Failure> {
    let missing = || Failure::Input("--stiffness (or --period) is missing".to_owned());
    let stiffness = given.stiffness()?.ok_or_else(missing)?;
    Oscillator::new(given.mass()?, stiffness, 1.0).map_err(|e| given.at_fault(e))
}

/// The amplitude of the force, which must be the same at every frequency.
fn force(given: &Given<f64>, body: &Oscillator<f64>) -> Result<f64, Failure> {
    match given.one_of(&P::DRIVES)? {
        Some((P::BaseVelocity | P::BaseDisplacement, _)) => Err(Failure::Input(
            "--base-velocity and --base-displacement: their force changes with the frequency; measure at one \
             --base-acceleration"
                .to_owned(),
        )),
        // For the other excitations, the force does not depend on the frequency.
        _ => Ok(given.drive(body, 1.0)?.force_amplitude(body)),
    }
}

/// A column of measurements: its index, and its unit if the header has one.
struct Column {
    place: usize,
    name: &'static str,
    kind: Kind,
    factor: Option<Factor>,
}

impl Column {
    fn find(
        header: &StringRecord,
        (name, kind): (&'static str, Kind),
        file: &str,
        reader: &Reader,
    ) -> Result<Option<Self>, Failure> {
        for (place, text) in header.iter().enumerate() {
            let text = text.trim_start_matches('\u{feff}').trim();
            let (own, unit) = match text.strip_suffix(']').and_then(|text| text.split_once('[')) {
                Some((own, unit)) => (own.trim(), Some(unit.trim())),
                None => (text, None),
            };
            if own == name {
                let of = |unit| reader.factor_of_column(&format!("{file}: column {name}"), unit, kind);
                return Ok(Some(Self { place, name, kind, factor: unit.map(of).transpose()? }));
            }
        }
        Ok(None)
    }

    fn value(&self, row: &StringRecord, at: &str, reader: &Reader) -> Result<f64, Failure> {
        let (text, name) = (row.get(self.place).unwrap_or_default(), format!("{at}: {}", self.name));
        match self.factor {
            Some(factor) => Ok(factor.times(crate::input::number(&name, text)?)),
            None => Ok(reader.value(&name, text, self.kind)?),
        }
    }
}

/// The measurements of a CSV file: `frequency` and `amplitude`, and `phase` if it was measured.
fn measurements(file: &Path, name: &str, reader: &Reader) -> Result<Vec<Measurement>, Failure> {
    let source: Box<dyn Read> = if file == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(file).map_err(|e| Failure::Input(format!("{name}: {e}")))?)
    };
    let bad = |e: csv::Error| Failure::Input(format!("{name}: {e}"));
    let mut rows = ReaderBuilder::new().trim(Trim::All).from_reader(source);
    let header = rows.headers().map_err(bad)?.clone();
    let find = |column| Column::find(&header, column, name, reader);
    let due = |column: (&'static str, Kind)| {
        find(column)?.ok_or_else(|| {
            let found = header.iter().collect::<Vec<_>>().join(",");
            let column = column.0;
            Failure::Input(format!("{name}: column {column} is missing; the header is “{found}”"))
        })
    };
    let (frequency, amplitude) = (due(("frequency", Kind::Frequency))?, due(("amplitude", Kind::Length))?);
    let phase = find(("phase", Kind::Angle))?;
    let mut curve = Vec::new();
    for row in rows.records() {
        let row = row.map_err(bad)?;
        let at = format!("{name} line {}", row.position().map_or(0, csv::Position::line));
        curve.push(Measurement {
            angular_frequency: frequency.value(&row, &at, reader)?,
            amplitude: amplitude.value(&row, &at, reader)?,
            phase: phase.as_ref().map(|phase| phase.value(&row, &at, reader)).transpose()?,
        });
    }
    Ok(curve)
}

/// An estimate in JSON.
#[derive(Serialize)]
struct Found {
    value: f64,
    standard_error: f64,
    interval_95: (f64, f64),
    unit: String,
}

impl Found {
    fn of(estimate: &Estimate, scale: f64, unit: String) -> Self {
        let (low, high) = estimate.interval();
        Self {
            value: estimate.value * scale,
            standard_error: estimate.standard_error * scale,
            interval_95: (low * scale, high * scale),
            unit,
        }
    }
}

#[derive(Serialize)]
struct Answer {
    friction: Found,
    friction_coefficient: Found,
    damping_ratio: Found,
    damping: Found,
    noise: f64,
    measurements: usize,
    used: usize,
    residuals: Vec<Option<f64>>,
}

impl Answer {
    fn new(given: &Given<f64>, body: &Oscillator<f64>, found: &Identified) -> Result<Self, Failure> {
        let unit = |kind: Kind| given.system.name(kind);
        let weight = body.mass() * given.gravity()?;
        let critical = 2.0 * (body.stiffness() * body.mass()).sqrt();
        Ok(Self {
            friction: Found::of(&found.friction_bound, 1.0, unit(Kind::Force)),
            friction_coefficient: Found::of(&found.friction_bound, 1.0 / weight, unit(Kind::Ratio)),
            damping_ratio: Found::of(&found.damping_ratio, 1.0, unit(Kind::Ratio)),
            damping: Found::of(&found.damping_ratio, critical, unit(Kind::Damping)),
            noise: found.noise,
            measurements: found.residuals.len(),
            used: found.residuals.iter().flatten().count(),
            residuals: found.residuals.clone(),
        })
    }
}

fn text(given: &Given<f64>, answer: &Answer, curve: &[Measurement], out: &mut impl Write) -> Outcome {
    let Answer { used, measurements, .. } = answer;
    writeln!(out, "Friction and damping that explain {used} of {measurements} measurements best:\n")?;
    for (name, found) in [
        ("friction bound r_y", &answer.friction),
        ("coefficient µ", &answer.friction_coefficient),
        ("damping ratio ζ", &answer.damping_ratio),
        ("damping constant c", &answer.damping),
    ] {
        let unit = if found.unit == "1" { String::new() } else { format!(" {}", found.unit) };
        let (low, high) = found.interval_95;
        let (value, low, high) = (digits(found.value), digits(low), digits(high));
        writeln!(out, "  {name:<19} {value}{unit}  (95 %: {low} to {high}{unit})")?;
    }
    writeln!(
        out,
        "  noise               {} %, relative error of one amplitude\n",
        digits(100.0 * answer.noise)
    )?;
    writeln!(out, "  {:>12}  {:>14}  measured less computed", "frequency", "amplitude")?;
    for (measured, residual) in curve.iter().zip(&answer.residuals) {
        let hertz = digits(measured.angular_frequency / std::f64::consts::TAU);
        let residual =
            residual.map_or_else(|| "left out: it sticks".to_owned(), |r| format!("{:+.3} %", 100.0 * r));
        let length = given.system.length();
        writeln!(out, "  {hertz:>9} Hz  {:>11} {length}  {residual}", digits(measured.amplitude))?;
    }
    Ok(())
}
