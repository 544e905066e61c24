//! What is done with a record before it is used: its mean is taken off, it is cut, and it gets another step. Each is told.

use super::{Options, Unit};
use crate::words::digits;
use std::ops::Range;
use std::str::FromStr;
use stickslip::Float;
use stickslip::motion::record::Record;

/// The mean over time of the straight lines between the samples. One that the rounding of times and samples may have made
/// is 0.
pub(super) fn mean<F: Float>(record: &Record<F>) -> F {
    mean_of(record, 0..record.samples().len())
}

fn mean_of<F: Float>(record: &Record<F>, places: Range<usize>) -> F {
    let samples = record.samples().iter().enumerate().take(places.end).skip(places.start);
    let (first, last) = (record.time(places.start), record.time(places.end.saturating_sub(1)));
    let mut before: Option<(F, F)> = None;
    let (mut area, mut size) = (F::int(0), F::int(0));
    for (place, sample) in samples {
        let time = record.time(place);
        if let Some((from, other)) = before.replace((time, *sample)) {
            area = area + (time - from) * (*sample + other) / F::int(2);
            // Each time has a rounding, whatever the length of its step.
            size = size + (sample.abs() + other.abs()) * (first.abs() + last.abs());
        }
    }
    if area.abs() <= size * F::epsilon() { F::int(0) } else { area / (last - first) }
}

/// The record as the options want it: without a mean, within two times, with another step.
pub(super) fn as_asked<F: Float + FromStr>(
    record: Record<F>,
    unit: &Unit,
    options: &Options<'_>,
    notes: &mut Vec<String>,
) -> Result<Record<F>, String> {
    let record = without_mean(record, unit, options, notes)?;
    let words = options.words;
    let from = options.time::<F>(words.from, options.from)?;
    let to = options.time::<F>(words.to, options.to)?;
    let record = if from.is_some() || to.is_some() {
        let typed: Vec<String> = [(words.from, options.from), (words.to, options.to)]
            .into_iter()
            .filter_map(|(word, text)| text.map(|text| format!("{word} {text}")))
            .collect();
        let (first, last) = (record.time(0), record.end());
        let cut = record.between(from.unwrap_or(first), to.unwrap_or(last));
        cut.map_err(|error| format!("{}: {error}", typed.join(" ")))?
    } else {
        record
    };
    resampled(record, options, notes)
}

/// The record without a mean: of `all` of it, of the part `before` the motion, or within `FROM:TO`.
fn without_mean<F: Float + FromStr>(
    record: Record<F>,
    unit: &Unit,
    options: &Options<'_>,
    notes: &mut Vec<String>,
) -> Result<Record<F>, String> {
    let Some(asked) = options.remove_mean.map(str::trim) else { return Ok(record) };
    let wrong = |what: &str| format!("{} {asked}: {what}", options.words.remove_mean);
    let count = record.samples().len();
    let (places, which) = if asked.eq_ignore_ascii_case("all") {
        (0..count, "all samples".to_owned())
    } else {
        let places = if asked.eq_ignore_ascii_case("before") {
            before_motion(&record)
        } else {
            let due = "must be all, before (the motion) or a window FROM:TO such as 0s:2s";
            let (from, to) = asked.split_once(':').ok_or_else(|| wrong(due))?;
            let time = |text| options.time::<F>(options.words.remove_mean, Some(text));
            let (from, to) = (time(from)?, time(to)?);
            let (from, to) = from.zip(to).ok_or_else(|| wrong(due))?;
            record.places_between(from, to).map_err(|error| wrong(&error.to_string()))?
        };
        let [from, to] =
            [places.start, places.end.saturating_sub(1)].map(|place| record.time(place).to_f64());
        let within = format!("the {} samples from {} s to {} s", places.len(), digits(from), digits(to));
        (places, within)
    };
    if places.len() < 2 {
        return Err(wrong("must hold two samples or more. Give another window FROM:TO"));
    }
    let mean = mean_of(&record, places);
    let told = match unit.factor {
        Some(_) => mean,
        None => options.reader.system().shown(unit.kind, mean),
    };
    notes.push(format!("The mean {} {} of {which} was removed.", digits(told.to_f64()), unit.name));
    record.mapped(|sample| sample - mean).map_err(|error| wrong(&error.to_string()))
}

/// The places before the first sample that is further from the mean than a twentieth of the greatest distance from it.
fn before_motion<F: Float>(record: &Record<F>) -> Range<usize> {
    let mean = mean(record);
    let off = |sample: &F| (*sample - mean).abs();
    let most = record.samples().iter().fold(F::int(0), |most, sample| most.or_larger(off(sample)));
    0..record.samples().iter().take_while(|sample| off(sample) * F::int(20) <= most).count()
}

/// The record on its straight lines at equal steps from its first sample on.
fn resampled<F: Float + FromStr>(
    record: Record<F>,
    options: &Options<'_>,
    notes: &mut Vec<String>,
) -> Result<Record<F>, String> {
    let words = options.words;
    let Some(step) = options.time::<F>(words.resample, options.resample)? else { return Ok(record) };
    let wrong = |what: &str| format!("{} {}: {what}", words.resample, options.resample.unwrap_or_default());
    let (start, end) = (record.time(0), record.end());
    let steps = ((end - start) / step).to_f64();
    if step <= F::int(0) || !(1.0..3.3e7).contains(&steps) {
        return Err(wrong("must be > 0 s, and between the length of the record and its 33-millionth part"));
    }
    // The last sample stays where the quotient is whole but for its rounding.
    let count = (steps * (1.0 + 4.0 * f64::EPSILON)).floor() as usize;
    let values = on_lines(&record, step, count.saturating_add(1));
    let was = match record.step() {
        Some(step) => format!("{} s", digits(step.to_f64())),
        None => "unequal steps".to_owned(),
    };
    let longest = record.longest_step().to_f64();
    let loss = if step.to_f64() > longest { ", so that samples between were left out" } else { "" };
    notes.push(format!("Resampled on straight lines from {was} to {} s{loss}.", digits(step.to_f64())));
    let new = Record::new(record.excitation(), step, values).and_then(|new| new.beginning_at(start));
    new.map(|new| new.followed_by(record.after())).map_err(|error| wrong(&error.to_string()))
}

/// As many values of the straight lines of a record, at equal steps from its first sample on.
pub(super) fn on_lines<F: Float>(record: &Record<F>, step: F, count: usize) -> Vec<F> {
    let (start, end) = (record.time(0), record.end());
    let samples = record.samples();
    let sample = |place: usize| samples.get(place).copied().unwrap_or(F::int(0));
    let last = samples.len().saturating_sub(1);
    let mut before = 0usize;
    let value = |index: usize| {
        let time = start + F::from_f64(index as f64) * step;
        let time = if time > end { end } else { time };
        while before.saturating_add(1) < last && record.time(before.saturating_add(1)) <= time {
            before = before.saturating_add(1);
        }
        let (from, to) = (record.time(before), record.time(before.saturating_add(1)));
        let (first, second) = (sample(before), sample(before.saturating_add(1)));
        if to > from { first + (second - first) * ((time - from) / (to - from)) } else { second }
    };
    (0..count).map(value).collect()
}
