//! Layouts whose header is lines of keys and values: K-NET and KiK-net, ESM and DYNA, CWB.

use super::lines::Lines;
use super::samples::{Samples, Times};
use super::table::{self, Known};
use super::{Options, Reading, text};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::Float;
use stickslip::inputs::units::split;

/// The value of a key in a header, with its line.
type Found = Option<(u64, String)>;

/// The number at the beginning of a value that must be > 0.
fn positive<F: Float + FromStr, N: Float + FromStr>(
    options: &Options<'_, F>,
    key: &str,
    found: &Found,
) -> Result<N, String> {
    let (line, value) = found.as_ref().ok_or_else(|| format!("{}: {key} is missing", options.name))?;
    let number = text::number::<N>(split(value).0).filter(|number| *number > N::int(0));
    number.ok_or_else(|| options.at(*line, &format!("{key} = {value}: must be a number > 0")))
}

/// A positive number of samples.
fn count(value: f64) -> Option<usize> {
    (1.0..1e9).contains(&value).then_some(value.round() as usize)
}

/// K-NET and KiK-net: integers times the scale factor `3920(gal)/6182761`, with their offset.
pub(super) fn knet<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    options.without_step()?;
    let [mut rate, mut duration, mut factor, mut channel]: [Found; 4] = [const { None }; 4];
    while let Some((number, line)) = lines.next()? {
        for (key, place) in [
            ("Sampling Freq(Hz)", &mut rate),
            ("Duration Time(s)", &mut duration),
            ("Scale Factor", &mut factor),
            ("Dir.", &mut channel),
        ] {
            if let Some(value) = text::value(&line, key) {
                *place = Some((number, value.to_owned()));
            }
        }
        if text::begins_with_number(&line) {
            lines.put_back((number, line));
            break;
        }
    }
    let frequency: F = positive(options, "Sampling Freq(Hz)", &rate)?;
    let seconds: f64 = positive(options, "Duration Time(s)", &duration)?;
    let due = "must be such as 3920(gal)/6182761";
    let (line, value) = factor.ok_or_else(|| format!("{}: Scale Factor is missing", options.name))?;
    let wrong = || options.at(line, &format!("Scale Factor {value}: {due}"));
    let (above, below) = value.split_once('/').ok_or_else(wrong)?;
    let (above, unit) = above.split_once('(').ok_or_else(wrong)?;
    let number = |text: &str| text::number::<F>(text.trim()).filter(|number| *number > F::int(0));
    let (above, below) = number(above).zip(number(below)).ok_or_else(wrong)?;
    let unit = options.unit(Some((line, unit.trim_end().trim_end_matches(')'))))?;
    let counted = count(seconds * frequency.to_f64()).ok_or_else(|| {
        format!("{}: Duration Time(s) × Sampling Freq(Hz) must be a number of samples", options.name)
    })?;
    let stated = format!("Duration Time(s) × Sampling Freq(Hz) = {counted}");
    let excitation = unit.excitation();
    let mut samples = Samples::new(unit);
    samples.fill(lines, (counted, &stated), None, Some(above / below), options)?;
    samples.ended(lines, &stated, options)?;
    let channel = channel.map(|(_, channel)| channel).filter(|channel| !channel.is_empty());
    samples.finish("K-NET", channel, excitation, Times::Step(F::int(1) / frequency), F::int(0), options)
}

/// ESM and DYNA: a key and a colon in each line of the header, then one sample a line.
pub(super) fn esm<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    options.without_step()?;
    let [mut step, mut counted, mut unit, mut quantity, mut channel]: [Found; 5] = [const { None }; 5];
    while let Some((number, line)) = lines.next()? {
        for (key, place) in [
            ("SAMPLING_INTERVAL_S", &mut step),
            ("NDATA", &mut counted),
            ("UNITS", &mut unit),
            ("DATA_TYPE", &mut quantity),
            ("STREAM", &mut channel),
        ] {
            if let Some(value) = text::value(&line, key) {
                *place = Some((number, value.to_owned()));
            }
        }
        if text::begins_with_number(&line) {
            lines.put_back((number, line));
            break;
        }
    }
    if let Some((line, value)) = quantity
        && !value.eq_ignore_ascii_case("ACCELERATION")
    {
        return Err(options.at(line, &format!("DATA_TYPE {value}: must be ACCELERATION")));
    }
    let step: F = positive(options, "SAMPLING_INTERVAL_S", &step)?;
    let counted = count(positive(options, "NDATA", &counted)?)
        .ok_or_else(|| format!("{}: NDATA must be a number of samples", options.name))?;
    let unit = unit.as_ref().filter(|(_, unit)| !unit.is_empty());
    let unit = options.unit(unit.map(|(line, unit)| (*line, unit.as_str())))?;
    let stated = format!("NDATA = {counted}");
    let excitation = unit.excitation();
    let mut samples = Samples::new(unit);
    samples.fill(lines, (counted, &stated), None, None, options)?;
    samples.ended(lines, &stated, options)?;
    let channel = channel.map(|(_, channel)| channel).filter(|channel| !channel.is_empty());
    samples.finish("ESM", channel, excitation, Times::Step(step), F::int(0), options)
}

/// CWB: columns of the time and of three directions, one of which is chosen.
pub(super) fn cwb<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    let [mut rate, mut duration, mut unit, mut sequence]: [Found; 4] = [const { None }; 4];
    while let Some((number, line)) = lines.next()? {
        for (key, place) in [
            ("#SampleRate(Hz)", &mut rate),
            ("#RecordLength(sec)", &mut duration),
            ("#AmplitudeUnit", &mut unit),
            ("#DataSequence", &mut sequence),
        ] {
            if let Some(value) = text::value(&line, key) {
                *place = Some((number, value.to_owned()));
            }
        }
        if text::begins_with_number(&line) {
            lines.put_back((number, line));
            break;
        }
    }
    let (_, sequence) = sequence.ok_or_else(|| format!("{}: #DataSequence is missing", options.name))?;
    let names = sequence.split(|c: char| c.is_whitespace() || c == ';').filter(|name| !name.is_empty());
    let names = names.map(|name| name.split('(').next().unwrap_or_default().to_owned()).collect();
    let unit = unit.and_then(|(line, unit)| Some((line, unit.split_whitespace().next()?.to_owned())));
    let unit = options.unit(unit.as_ref().map(|(line, unit)| (*line, unit.as_str())))?;
    let rate: f64 = positive(options, "#SampleRate(Hz)", &rate)?;
    let length: f64 = positive(options, "#RecordLength(sec)", &duration)?;
    let reading = table::read(lines, options, Known { kind: "CWB", names, unit: Some(unit) })?;
    let read = reading.summary.samples as f64;
    // The last sample may be at the end of the length, and a product that is not whole is one of rounded numbers.
    let due = rate * length;
    let off = due.abs() * f64::EPSILON * 4.0;
    if read < (due + off).floor() || read > (due - off).ceil() + 1.0 {
        return Err(format!(
            "{}: #RecordLength(sec) × #SampleRate(Hz) = {}, but the file has {read} samples",
            options.name,
            rate * length
        ));
    }
    Ok(reading)
}
