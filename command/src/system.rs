//! `stickslip system`: several bodies with contacts, elastic contacts and stops.

mod answer;
mod described;
mod file;
mod named;
mod node;
mod table;
mod words;

use crate::args::{Format, SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::output;
use answer::{Answer, Samples};
use described::Described;
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use stickslip::inputs::units::{Kind as Of, Reader};
use stickslip::system::System;

/// The longest motion, in radians of its fastest vibration.
const MOST_RADIANS: f64 = 1e6;
/// The most samples of a motion.
const MOST_SAMPLES: u64 = 10_000_000;

pub(crate) fn run(args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let question = args.question;
    check_options(args)?;
    if question == SystemQuestion::Curve || args.set.iter().any(|text| text.contains(':')) {
        return table::run(args, out);
    }
    let asked = Asked::new(args, &args.set)?;
    match question {
        SystemQuestion::Describe => words::describe(&asked, args, out),
        SystemQuestion::Steady => steady(&asked, args, out),
        SystemQuestion::Simulate => simulate(&asked, args, &asked.time(args)?, out),
        SystemQuestion::Record => simulate(&asked, args, &asked.end_of_record(args)?, out),
        SystemQuestion::Border => border(&asked, args, out),
        SystemQuestion::Curve => Ok(()),
    }
}

/// Refuses an option that the question does not use.
fn check_options(args: &SystemArgs) -> Outcome {
    use SystemQuestion as Q;
    let uses = |name: &str, is_given: bool, by: &[Q]| {
        if is_given && !by.contains(&args.question) {
            return Err(Failure::Input(format!("{name}: this question does not use it")));
        }
        Ok(())
    };
    uses("--until", args.until.is_some(), &[Q::Simulate, Q::Record])?;
    uses("--samples", args.samples.is_some(), &[Q::Steady, Q::Simulate, Q::Record])?;
    uses("--frequency", args.frequency.is_some(), &[Q::Curve])?;
    uses("RECORD", args.record.is_some(), &[Q::Record])?;
    let is_missing = |name: &str| Err(Failure::Input(format!("{name} is missing")));
    match args.question {
        Q::Simulate if args.until.is_none() => is_missing("--until"),
        Q::Curve if args.frequency.is_none() => is_missing("--frequency"),
        Q::Record if args.record.is_none() => is_missing("RECORD"),
        Q::Describe | Q::Steady | Q::Simulate | Q::Record | Q::Curve | Q::Border => Ok(()),
    }
}

/// A system that is asked about.
pub(crate) struct Asked {
    pub(crate) described: Described,
    pub(crate) system: System<f64>,
}

impl Asked {
    /// The system of the file with other values.
    fn new(args: &SystemArgs, set: &[String]) -> Result<Self, Failure> {
        Self::of(&file::parsed(&args.file)?, args, set)
    }

    /// The system of a file that is read, with other values.
    fn of(value: &Value, args: &SystemArgs, set: &[String]) -> Result<Self, Failure> {
        let mut value = value.clone();
        for text in set {
            let (path, new) =
                text.split_once('=').ok_or_else(|| format!("--set {text}: must be PATH=VALUE"))?;
            named::set(&mut value, path.trim(), new.trim())?;
        }
        let folder = args.file.parent().unwrap_or(Path::new(""));
        let name = args.file.display().to_string();
        let about = |failure: Failure| failure.about(&name);
        let mut described = file::described(&value, folder, args.units.units.as_ref()).map_err(about)?;
        if let Some(record) = &args.record {
            // The record is read in the units of the file.
            let reader = Reader::new(described.units.as_ref(), "units in the file");
            named::add_record(&mut described, record, &reader)?;
        }
        let system = System::new(&described.model).map_err(|e| about(named_by_body(&described, e)))?;
        Ok(Self { described, system })
    }

    /// The loads at another frequency: all frequencies by the factor that takes the lowest one there.
    pub(crate) fn at_frequency(&mut self, frequency: f64) -> Outcome {
        let model = &mut self.described.model;
        let lowest = model.harmonics.iter().map(|h| h.frequency).fold(f64::INFINITY, f64::min);
        if !lowest.is_finite() {
            return Err("--frequency: the file has no harmonic load".into());
        }
        for harmonic in &mut model.harmonics {
            let is_lowest = harmonic.frequency == lowest;
            harmonic.frequency = if is_lowest { frequency } else { harmonic.frequency / lowest * frequency };
        }
        self.system = System::new(&self.described.model)?;
        Ok(())
    }

    pub(crate) fn reader(&self) -> Reader {
        Reader::new(self.described.units.as_ref(), "units in the file")
    }

    fn time(&self, args: &SystemArgs) -> Result<f64, Failure> {
        let text = args.until.as_deref().unwrap_or_default();
        let value: f64 = self.reader().value("--until", text, Of::Time)?;
        if !(value > 0.0 && value.is_finite()) {
            return Err(format!("--until {text}: must be > 0").into());
        }
        // The steps of the motion are a part of the shortest period.
        let held: Vec<usize> = (0..self.described.model.elements.len()).collect();
        let own = [self.system.natural_frequencies(&held), self.system.natural_frequencies(&[])].concat();
        let loads = self.described.model.harmonics.iter().map(|harmonic| harmonic.frequency);
        let fastest = own.into_iter().chain(loads).fold(0.0, |most: f64, omega| most.max(omega.abs()));
        if value * fastest > MOST_RADIANS {
            let unit = if self.described.units.is_some() { " s" } else { "" };
            let most = crate::bits::digits(MOST_RADIANS / fastest);
            return Err(format!(
                "--until {text}: must be ≤ {most}{unit}, 10⁶ radians of the fastest vibration"
            )
            .into());
        }
        Ok(value)
    }

    /// The end of the record, or a later time.
    fn end_of_record(&self, args: &SystemArgs) -> Result<f64, Failure> {
        let ends = self.described.model.records.iter().filter_map(|record| record.times.last());
        let end = ends.fold(0.0, |last: f64, &end| last.max(end));
        if args.until.is_some() { self.time(args) } else { Ok(end) }
    }

    /// The samples that are asked for, over a time.
    fn samples(&self, args: &SystemArgs, until: f64) -> Result<Option<Vec<f64>>, Failure> {
        let Some(text) = &args.samples else { return Ok(None) };
        let count = crate::input::count(&format!("--samples {text}"), text, MOST_SAMPLES)?;
        Ok(Some((0..=count).map(|i| until * (i as f64 / count as f64)).collect()))
    }
}

/// The error of the engine, whose coordinates and elements have the names of the file.
fn named_by_body(described: &Described, error: stickslip::system::Error) -> Failure {
    use stickslip::system::Error as E;
    if let E::NotDefinite { row, .. } = &error
        && let Some(name) = described.coordinates.get(row.saturating_sub(1))
    {
        return Failure::Input(format!("{name}: {error}"));
    }
    error.into()
}

fn is_json(args: &SystemArgs) -> Result<bool, Failure> {
    args.format.unwrap_or(Format::Text).is_json("system")
}

fn simulate(asked: &Asked, args: &SystemArgs, &until: &f64, out: &mut impl Write) -> Outcome {
    let start = &asked.described.start;
    if let Some(times) = asked.samples(args, until)? {
        return sampled(asked, args, start, &times, out);
    }
    let motion = asked.system.simulate(start, until)?;
    if is_json(args)? {
        return output::json(&Answer::transient(&asked.described, &motion), out);
    }
    let seconds = if asked.described.units.is_some() { " s" } else { "" };
    writeln!(out, "The motion from the start to {}{seconds}.\n", crate::bits::digits(until))?;
    answer::text(&asked.described, &motion, out)
}

fn steady(asked: &Asked, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let found = asked.system.steady(&asked.described.start)?;
    if let Some(times) = asked.samples(args, found.period)? {
        return sampled(asked, args, &found.start, &times, out);
    }
    if is_json(args)? {
        return output::json(&Answer::steady(&asked.described, &found), out);
    }
    words::steady(&asked.described, &found, out)?;
    answer::text(&asked.described, &found.motion, out)
}

/// States at times, as CSV or JSON.
fn sampled(
    asked: &Asked,
    args: &SystemArgs,
    start: &stickslip::system::State<f64>,
    times: &[f64],
    out: &mut impl Write,
) -> Outcome {
    let states = asked.system.states(start, times)?;
    let samples = Samples::new(&asked.described, times, &states);
    match args.format {
        Some(Format::Json) => output::json(&samples, out),
        Some(Format::Csv) | None => samples.csv(out),
        Some(Format::Text | Format::Jsonl) => Err("--format: must be csv or json with --samples".into()),
    }
}

fn border(asked: &Asked, args: &SystemArgs, out: &mut impl Write) -> Outcome {
    let found = asked.system.border()?;
    // Below the border the cycle is no motion.
    let cycle = asked.system.cycle()?.filter(|cycle| cycle.margin >= 1.0);
    if is_json(args)? {
        return output::json(&answer::OfBorder::new(&found, cycle.as_ref()), out);
    }
    words::border(&asked.described, &found, cycle.as_ref(), out)
}

impl From<stickslip::system::Error> for Failure {
    fn from(error: stickslip::system::Error) -> Self {
        Self::Input(error.to_string())
    }
}
