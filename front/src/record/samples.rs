//! The samples of a file in the number type of the answer, and the record that they make.

use super::sheet::{Found, Sink, Stated, Times};
use super::unit::Ratio;
use super::{Options, Reading, Summary, Unit, process, text};
use crate::inputs::units::{Factor, Kind, Reader};
use std::str::FromStr;
use stickslip::motion::record::Record;
use stickslip::{Error, Excitation, Float};

/// The memory of the samples in bytes: 33 million of f64.
const MOST: usize = 1 << 28;

/// Samples in the unit of a file, and their times in s.
pub(super) struct Samples<'a, F> {
    values: Vec<F>,
    times: Vec<F>,
    unit: Option<Unit>,
    /// The factor and the divisor of the samples, where they are not 1.
    scale: [Option<F>; 2],
    reader: &'a Reader,
}

/// The quotient of a file.
fn quotient<F: Float + FromStr>(ratio: &Ratio) -> [Option<F>; 2] {
    let part = |text: &str| text::number::<F>(text).filter(|number| *number != F::int(1));
    [part(&ratio.above), part(&ratio.below)]
}

fn scaled<F: Float>([above, below]: [Option<F>; 2], value: F) -> F {
    let value = above.map_or(value, |above| value * above);
    below.map_or(value, |below| value / below)
}

impl<F: Float + FromStr> Sink for Samples<'_, F> {
    fn begin(&mut self, unit: Unit) {
        self.scale = quotient(&unit.scale);
        self.unit = Some(unit);
    }

    fn len(&self) -> usize {
        self.values.len()
    }

    fn truncate(&mut self, len: usize) {
        self.values.truncate(len);
    }

    fn sample(&mut self, text: &str) -> Result<bool, String> {
        text::number(text).map_or(Ok(false), |value| self.push(scaled(self.scale, value)).map(|()| true))
    }

    fn exact(&mut self, value: f64) -> Result<(), String> {
        self.push(scaled(self.scale, F::from_f64(value)))
    }

    fn valued(&mut self, named: &str, text: &str, kind: Kind) -> Result<(), String> {
        let value = self.reader.value(named, text, kind)?;
        self.push(value)
    }

    fn time(&mut self, named: &str, text: &str, second: Option<Factor>) -> Result<bool, String> {
        let time = match text::number::<F>(text) {
            Some(time) => second.map_or(time, |second| second.times(time)),
            None if second.is_none() && Reader::has_unit(text) => {
                self.reader.value(named, text, Kind::Time)?
            }
            None => return Ok(false),
        };
        let step = self.times.last().map(|before| time - *before).filter(|step| *step < F::int(0));
        if let Some(step) = step {
            return Err(format!("time step = {step} s: must be ≥ 0 s"));
        }
        if self.times.iter().rev().take_while(|before| **before == time).count() > 1 {
            return Err("time step = 0 s: must be > 0 s after two values at one time".to_owned());
        }
        self.times.push(time);
        Ok(true)
    }
}

impl<'a, F: Float + FromStr> Samples<'a, F> {
    pub(super) const fn new(reader: &'a Reader) -> Self {
        Self { values: Vec::new(), times: Vec::new(), unit: None, scale: [None; 2], reader }
    }

    /// Adds a sample in the unit of the file.
    fn push(&mut self, value: F) -> Result<(), String> {
        if !self.unit.as_ref().map_or(value, |unit| unit.times(value)).is_finite() {
            return Err(format!("{value}: must be finite in the units of the answer"));
        }
        if self.values.len().saturating_mul(size_of::<F>()) >= MOST {
            return Err(format!("must have at most {} samples", self.values.len()));
        }
        self.values.push(value);
        Ok(())
    }

    /// The record of these samples, as the options want it, and its summary.
    pub(super) fn finish(self, found: Found, options: &Options<'_>) -> Result<Reading<F>, String> {
        let Self { values, times, unit, reader, .. } = self;
        let unit = unit.ok_or_else(|| format!("{}: has no samples", options.name))?;
        if let Some(due) = options.quantity.filter(|due| *due != unit.kind) {
            return Err(format!("{}: must be a record of {}", options.name, due.expected()));
        }
        let Found { kind, channel, excitation, stated, mut notes, unused, .. } = found;
        let named = |error| match error {
            Error::InSample { index, error } => {
                format!("{}: sample {}: {error}", options.name, index.saturating_add(1))
            }
            error => format!("{}: {error}", options.name),
        };
        let (step, start) = match &found.times {
            Times::Each => even(&times).map_or((None, F::int(0)), |(start, step)| (Some(step), start)),
            Times::Asked => (options.time::<F>(options.words.time_step, options.time_step)?, F::int(0)),
            Times::Step(ratio, factor, start) => {
                let step = scaled(quotient::<F>(ratio), F::int(1));
                let start = text::number(start).unwrap_or(F::int(0));
                (Some(factor.map_or(step, |factor| factor.times(step))), start)
            }
        };
        let record = match step {
            Some(step) => Record::new(excitation, step, values).and_then(|record| record.beginning_at(start)),
            None => Record::at_times(excitation, times, values),
        };
        let record = record.map_err(named)?;
        if let Some(stated) = &stated {
            notes.extend(told(stated, &record, &unit, options));
        }
        let record = process::as_asked(record, &unit, options, &mut notes)?;
        // A cut may leave equal steps, as of a file that was cut by hand.
        let is_cut = options.from.is_some() || options.to.is_some();
        let record = if is_cut { evened(record).map_err(named)? } else { record };
        // Values with units of their own are those of the system.
        let told = |value: F| match unit.factor {
            Some(_) => value,
            None => reader.system().shown(unit.kind, value),
        };
        let (place, peak) = peak(&record);
        let summary = Summary {
            kind,
            channel,
            quantity: match excitation {
                Excitation::Force => "force",
                Excitation::FootMotion => "foot displacement",
                Excitation::DampedFootMotion => "damped foot displacement",
                _ => "acceleration",
            },
            samples: record.samples().len(),
            time_step: record.step().map(F::to_f64),
            steps: steps(&record),
            duration: (record.end() - record.time(0)).to_f64(),
            peak: told(peak).to_f64(),
            peak_at: record.time(place).to_f64(),
            mean: told(process::mean(&record)).to_f64(),
            unit: unit.name.clone(),
            notes,
        };
        let record = record.mapped(|sample| unit.times(sample)).map_err(named)?;
        Ok(Reading { record, summary, unused })
    }
}

/// The record with one step, where its times are equally spaced.
fn evened<F: Float>(record: Record<F>) -> Result<Record<F>, Error> {
    let times = || -> Vec<F> { (0..record.samples().len()).map(|index| record.time(index)).collect() };
    let found = if record.step().is_none() { even(&times()) } else { None };
    let Some((start, step)) = found else { return Ok(record) };
    let new = Record::new(record.excitation(), step, record.samples().to_vec())?;
    Ok(new.beginning_at(start)?.followed_by(record.after()))
}

/// The sample of greatest magnitude, with its place.
fn peak<F: Float>(record: &Record<F>) -> (usize, F) {
    let first = record.samples().first().copied().unwrap_or(F::int(0));
    let most = |most: (usize, F), (place, sample): (usize, &F)| {
        if sample.abs() > most.1.abs() { (place, *sample) } else { most }
    };
    record.samples().iter().enumerate().fold((0, first), most)
}

/// The least and the greatest step in s.
fn steps<F: Float>(record: &Record<F>) -> [f64; 2] {
    if let Some(step) = record.step() {
        return [step.to_f64(); 2];
    }
    let times = (0..record.samples().len()).map(|index| record.time(index).to_f64());
    let mut before = None;
    times.fold([f64::INFINITY, 0.0], |[least, most], time| {
        let step = before.replace(time).map_or(0.0, |before| time - before);
        // Two values at one time are no step.
        if step > 0.0 { [least.min(step), most.max(step)] } else { [least, most] }
    })
}

/// What is to be told where the samples have another peak than their header states, by more than its last digit and a
/// thousandth.
fn told<F: Float + FromStr>(
    stated: &Stated,
    record: &Record<F>,
    unit: &Unit,
    options: &Options<'_>,
) -> Option<String> {
    let mean = if stated.of_mean { process::mean(record) } else { F::int(0) };
    let peak = record.samples().iter().fold(F::int(0), |peak, sample| peak.or_larger((*sample - mean).abs()));
    let due = text::number::<f64>(&stated.text)?.abs();
    // The peak in the unit that the header states, which may differ from that of the samples.
    let one = |factor: Factor| factor.times(1.0f64);
    let peak = match (stated.unit, unit.factor) {
        (Some(own), Some(samples)) => peak.to_f64() * one(samples) / one(own),
        _ => peak.to_f64(),
    };
    let digits = stated.text.split(['e', 'E']).next()?.split_once('.').map_or(0, |(_, digits)| digits.len());
    let exponent = stated.text.split_once(['e', 'E']).and_then(|(_, text)| text.parse::<i32>().ok());
    let last = 10f64.powi(exponent.unwrap_or(0).saturating_sub(digits.try_into().ok()?));
    let off = (peak - due).abs();
    (off > last && off > 1e-3 * due).then(|| {
        let own = crate::words::digits(peak);
        let of_mean = if stated.of_mean { " from the mean" } else { "" };
        format!(
            "Line {} of {} states the peak {}, but the samples have {own}{of_mean} in that unit.",
            stated.line,
            options.name,
            stated.text.trim_start_matches('+')
        )
    })
}

/// The first time and the step, if the times are equally spaced but for the rounding of the numbers that they are read
/// into.
fn even<F: Float>(times: &[F]) -> Option<(F, F)> {
    let (&first, &last) = (times.first()?, times.last()?);
    let count = times.len().checked_sub(1).filter(|count| *count > 0)?;
    let step = (last - first) / F::from_f64(count as f64);
    // A time has a rounding of its own and perhaps one of its unit; a place has those of the step, its product and its sum.
    let rounding = (first.abs() + last.abs()) * F::epsilon() * F::int(4);
    let near = |(index, time): (usize, &F)| {
        let place = first + step * F::from_f64(index as f64);
        (*time - place).abs() <= rounding
    };
    (step > F::int(0) && times.iter().enumerate().all(near)).then_some((first, step))
}
