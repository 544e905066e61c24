//! The samples of a file while it is read.

use super::lines::Lines;
use super::{Cut, Options, Reading, Summary, Unit, text};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::motion::record::Record;
use stickslip::{Error, Excitation, Float};

/// The memory of the samples in bytes: 33 million of f64.
const MOST: usize = 1 << 28;

/// Samples in the unit of a file.
pub(super) struct Samples<F> {
    values: Vec<F>,
    unit: Unit,
}

/// The times of samples.
pub(super) enum Times<F> {
    Step(F),
    Each(Vec<F>),
}

impl<F: Float + FromStr> Samples<F> {
    pub(super) fn new(unit: Unit) -> Self {
        Self { values: Vec::new(), unit }
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Adds a sample in the unit of the file.
    pub(super) fn push(&mut self, value: F) -> Result<(), String> {
        if !self.unit.times(value).is_finite() {
            return Err(format!("{value}: must be finite in the units of the answer"));
        }
        if self.values.len().saturating_mul(size_of::<F>()) >= MOST {
            return Err(format!("must have at most {} samples", self.values.len()));
        }
        self.values.push(value);
        Ok(())
    }

    /// Reads as many samples as the header states: `stated` says so, such as “NPTS = 400”. Text that is no number may
    /// follow them, more numbers may not.
    pub(super) fn fill(
        &mut self,
        lines: &mut Lines<'_, impl BufRead>,
        (count, stated): (usize, &str),
        width: Option<usize>,
        scale: Option<F>,
        options: &Options<'_, F>,
    ) -> Result<(), String> {
        let mut all = Vec::new();
        while self.len() < count {
            let Some((number, line)) = lines.next()? else {
                return Err(format!("{}: {stated}, but the file has {} samples", options.name, self.len()));
            };
            text::numbers(&line, width, &mut all).map_err(|wrong| {
                let read = self.len();
                options
                    .at(number, &format!("{wrong}: must be a number: {stated}, and {read} samples were read"))
            })?;
            for &value in &all {
                if self.len() == count {
                    return Err(options.at(number, &format!("{stated}, but more samples follow")));
                }
                let value = scale.map_or(value, |scale| value * scale);
                self.push(value).map_err(|what| options.at(number, &what))?;
            }
        }
        Ok(())
    }

    /// Fails where another number follows.
    pub(super) fn ended(
        &self,
        lines: &mut Lines<'_, impl BufRead>,
        stated: &str,
        options: &Options<'_, F>,
    ) -> Result<(), String> {
        while let Some((number, line)) = lines.next()? {
            if line.trim().is_empty() {
                continue;
            }
            if text::begins_with_number(&line) {
                return Err(options.at(number, &format!("{stated}, but more samples follow")));
            }
            break;
        }
        Ok(())
    }

    /// The record of these samples, cut as the options say, and its summary.
    pub(super) fn finish(
        self,
        kind: &'static str,
        channel: Option<String>,
        excitation: Excitation,
        times: Times<F>,
        start: F,
        options: &Options<'_, F>,
    ) -> Result<Reading<F>, String> {
        let Self { values, unit } = self;
        let record = match times {
            Times::Step(step) => {
                Record::new(excitation, step, values).and_then(|record| record.beginning_at(start))
            }
            Times::Each(times) => Record::at_times(excitation, times, values),
        };
        let named = |error| match error {
            Error::InSample { index, error } => {
                format!("{}: sample {}: {error}", options.name, index.saturating_add(1))
            }
            error => format!("{}: {error}", options.name),
        };
        let mut record = record.map_err(named)?;
        if let Some(Cut { from, to, typed }) = options.cut {
            let (first, last) = (record.time(0), record.end());
            record = record
                .between(from.unwrap_or(first), to.unwrap_or(last))
                .map_err(|error| format!("{typed}: {error}"))?;
        }
        let quantity = match excitation {
            Excitation::Force => "force",
            Excitation::FootMotion => "foot displacement",
            Excitation::DampedFootMotion => "damped foot displacement",
            _ => "acceleration",
        };
        // Values with units of their own are those of the system.
        let told = |value: F| match unit.factor {
            Some(_) => value,
            None => options.reader.system().shown(unit.kind, value),
        };
        let peak = |most: (usize, F), (place, sample): (usize, &F)| {
            if sample.abs() > most.1.abs() { (place, *sample) } else { most }
        };
        let first = record.samples().first().copied().unwrap_or(F::int(0));
        let (peak_index, peak) = record.samples().iter().enumerate().fold((0, first), peak);
        let summary = Summary {
            kind,
            channel,
            quantity,
            samples: record.samples().len(),
            time_step: record.step().map(F::to_f64),
            duration: (record.end() - record.time(0)).to_f64(),
            peak: told(peak).to_f64(),
            peak_at: record.time(peak_index).to_f64(),
            mean: mean(&record, told),
            unit: unit.name.clone(),
        };
        let record = record.mapped(|sample| unit.times(sample)).map_err(named)?;
        Ok(Reading { record, summary, unused: Vec::new() })
    }
}

/// The mean over time of the straight lines between the samples, each of which is told in a unit. One that the rounding of
/// times and samples may have made is 0.
fn mean<F: Float>(record: &Record<F>, told: impl Fn(F) -> F) -> f64 {
    let (first, last) = (record.time(0).to_f64(), record.end().to_f64());
    let samples = record.samples().iter().map(|sample| told(*sample).to_f64());
    let (mut area, mut size, mut before) = (0.0, 0.0, None);
    for (index, sample) in samples.enumerate() {
        let time = record.time(index).to_f64();
        if let Some((from, other)) = before.replace((time, sample)) {
            area += (time - from) * 0.5 * (sample + other);
            // Each time has a rounding, whatever the length of its step.
            size += (sample.abs() + other.abs()) * (first.abs() + last.abs());
        }
    }
    if area.abs() <= size * f64::EPSILON { 0.0 } else { area / (last - first) }
}
