//! The samples of a file while it is read.

use super::lines::Lines;
use super::{Options, Reading, Summary, Unit, text};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::motion::record::Record;
use stickslip::{Error, Excitation, Float};

/// The memory of the samples in bytes: 33 million of f64.
const MOST: usize = 1 << 28;

/// Samples in the unit of a file, with what the summary says of them.
pub(super) struct Samples<F> {
    values: Vec<F>,
    unit: Unit,
    peak: F,
    peak_index: usize,
    sum: f64,
}

/// The times of samples.
pub(super) enum Times<F> {
    Step(F),
    Each(Vec<F>),
}

impl<F: Float + FromStr> Samples<F> {
    pub(super) fn new(unit: Unit) -> Self {
        Self { values: Vec::new(), unit, peak: F::int(0), peak_index: 0, sum: 0.0 }
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Adds a sample in the unit of the file.
    pub(super) fn push(&mut self, value: F) -> Result<(), String> {
        let own = self.unit.times(value);
        self.push_both(value, own)
    }

    /// Adds a sample in the unit of the file, and in the system of the reader.
    pub(super) fn push_both(&mut self, value: F, own: F) -> Result<(), String> {
        if !own.is_finite() {
            return Err(format!("{value}: must be finite in the units of the answer"));
        }
        if self.values.len().saturating_mul(size_of::<F>()) >= MOST {
            return Err(format!("must have at most {} samples", self.values.len()));
        }
        if self.values.is_empty() || value.abs() > self.peak.abs() {
            (self.peak, self.peak_index) = (value, self.values.len());
        }
        self.sum += value.to_f64();
        self.values.push(own);
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

    /// The record of these samples, and its summary.
    pub(super) fn finish(
        self,
        kind: &'static str,
        channel: Option<String>,
        excitation: Excitation,
        times: Times<F>,
        start: F,
        options: &Options<'_, F>,
    ) -> Result<Reading<F>, String> {
        let (count, unit) = (self.values.len(), self.unit.name);
        let record = match times {
            Times::Step(step) => {
                Record::new(excitation, step, self.values).and_then(|record| record.beginning_at(start))
            }
            Times::Each(times) => Record::at_times(excitation, times, self.values),
        };
        let record = record.map_err(|error| match error {
            Error::InSample { index, error } => {
                format!("{}: sample {}: {error}", options.name, index.saturating_add(1))
            }
            error => format!("{}: {error}", options.name),
        })?;
        let quantity = match excitation {
            Excitation::Force => "force",
            Excitation::FootMotion => "foot displacement",
            Excitation::DampedFootMotion => "damped foot displacement",
            _ => "acceleration",
        };
        let summary = Summary {
            kind,
            channel,
            quantity,
            samples: count,
            time_step: record.step().map(F::to_f64),
            duration: (record.end() - record.time(0)).to_f64(),
            peak: self.peak.to_f64(),
            peak_at: record.time(self.peak_index).to_f64(),
            mean: self.sum / count as f64,
            unit,
        };
        Ok(Reading { record, summary, unused: Vec::new() })
    }
}
