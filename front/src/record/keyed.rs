//! Layouts whose header is lines of keys and values: K-NET and KiK-net, ESM and DYNA, CWB.

use super::sheet::{Found, Sheet, Stated, Times};
use super::table::{self, Known};
use super::unit::Ratio;
use super::{Options, text};
use crate::inputs::units::{Kind, split};

/// The value of a key in a header, with its line.
type Value = Option<(u64, String)>;

/// The values of keys in the lines before the numbers.
fn header<const N: usize>(sheet: &mut Sheet<'_>, keys: [&str; N]) -> Result<[Value; N], String> {
    let mut found = [const { None }; N];
    while let Some((number, line)) = sheet.lines.next()? {
        for (key, place) in keys.iter().zip(&mut found) {
            if let Some(value) = text::value(&line, key) {
                *place = Some((number, value.to_owned()));
            }
        }
        if text::begins_with_number(&line) {
            sheet.lines.put_back((number, line));
            break;
        }
    }
    Ok(found)
}

/// The text of the number at the beginning of a value that must be > 0.
fn positive(options: &Options<'_>, key: &str, found: &Value) -> Result<String, String> {
    let (line, value) = found.as_ref().ok_or_else(|| format!("{}: {key} is missing", options.name))?;
    let digits = split(value).0;
    if text::number::<f64>(digits).is_some_and(|number| number > 0.0) {
        return Ok(digits.to_owned());
    }
    Err(options.at(*line, &format!("{key} = {value}: must be a number > 0")))
}

/// A value that is stated, and not empty.
fn given(value: Value) -> Option<String> {
    value.map(|(_, value)| value).filter(|value| !value.is_empty())
}

/// The peak of a header, as it is written.
fn stated(value: Value, of_mean: bool) -> Option<Stated> {
    let (line, text) = value?;
    Some(Stated { line, text: split(&text).0.to_owned(), unit: None, of_mean })
}

/// K-NET and KiK-net: integers times the scale factor `3920(gal)/6182761`, with their offset.
pub(super) fn knet(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    asked.without_step()?;
    let [rate, duration, factor, channel, peak] =
        header(sheet, ["Sampling Freq(Hz)", "Duration Time(s)", "Scale Factor", "Dir.", "Max. Acc. (gal)"])?;
    let frequency = positive(asked, "Sampling Freq(Hz)", &rate)?;
    let seconds = positive(asked, "Duration Time(s)", &duration)?;
    let due = "must be such as 3920(gal)/6182761";
    let (line, value) = factor.ok_or_else(|| format!("{}: Scale Factor is missing", asked.name))?;
    let wrong = || asked.at(line, &format!("Scale Factor {value}: {due}"));
    let (above, below) = value.split_once('/').ok_or_else(wrong)?;
    let (above, unit) = above.split_once('(').ok_or_else(wrong)?;
    let (above, below) = (above.trim(), below.trim());
    if [above, below].into_iter().any(|text| text::number::<f64>(text).is_none_or(|number| number <= 0.0)) {
        return Err(wrong());
    }
    let unit = asked.unit(Some((line, unit.trim_end().trim_end_matches(')'))), Some(Kind::Acceleration))?;
    let product = |number: &str| text::number::<f64>(number).unwrap_or(0.0);
    let counted = text::count(&(product(&seconds) * product(&frequency)).to_string()).ok_or_else(|| {
        format!("{}: Duration Time(s) × Sampling Freq(Hz) must be a number of samples", asked.name)
    })?;
    let said = format!("Duration Time(s) × Sampling Freq(Hz) = {counted}");
    let excitation = unit.excitation();
    sheet.sink.begin(super::Unit { scale: Ratio::new(above, below), ..unit });
    sheet.fill((counted, &said), None)?;
    sheet.ended(&said)?;
    let word = asked.words.remove_mean;
    let kept = asked.remove_mean.is_none().then(|| format!("Its offset is kept: {word} all takes it off."));
    Ok(Found {
        channel: given(channel),
        stated: stated(peak, true),
        notes: kept.into_iter().collect(),
        ..Found::new("K-NET", excitation, Times::step("1", &frequency))
    })
}

/// ESM and DYNA: a key and a colon in each line of the header, then one sample a line.
pub(super) fn esm(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    asked.without_step()?;
    let [step, counted, unit, quantity, channel, peak] =
        header(sheet, ["SAMPLING_INTERVAL_S", "NDATA", "UNITS", "DATA_TYPE", "STREAM", "PGA_CM/S^2"])?;
    if let Some((line, value)) = quantity
        && !value.eq_ignore_ascii_case("ACCELERATION")
    {
        return Err(asked.at(line, &format!("DATA_TYPE {value}: must be ACCELERATION")));
    }
    let step = positive(asked, "SAMPLING_INTERVAL_S", &step)?;
    let counted = text::count(&positive(asked, "NDATA", &counted)?)
        .ok_or_else(|| format!("{}: NDATA must be a number of samples", asked.name))?;
    let unit = unit.as_ref().filter(|(_, unit)| !unit.is_empty());
    let unit = asked.unit(unit.map(|(line, unit)| (*line, unit.as_str())), Some(Kind::Acceleration))?;
    let said = format!("NDATA = {counted}");
    let excitation = unit.excitation();
    sheet.sink.begin(unit);
    sheet.fill((counted, &said), None)?;
    sheet.ended(&said)?;
    let gal = asked.reader.factor_of_column("PGA", "cm/s^2", Kind::Acceleration)?;
    let stated = stated(peak, false).map(|stated| Stated { unit: Some(gal), ..stated });
    let found = Found::new("ESM", excitation, Times::step(&step, "1"));
    Ok(Found { channel: given(channel), stated, ..found })
}

/// CWB: columns of the time and of three directions, one of which is chosen.
pub(super) fn cwb(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    let [rate, duration, unit, sequence] =
        header(sheet, ["#SampleRate(Hz)", "#RecordLength(sec)", "#AmplitudeUnit", "#DataSequence"])?;
    let (_, sequence) = sequence.ok_or_else(|| format!("{}: #DataSequence is missing", asked.name))?;
    let names = sequence.split(|c: char| c.is_whitespace() || c == ';').filter(|name| !name.is_empty());
    let names = names.map(|name| name.split('(').next().unwrap_or_default().to_owned()).collect();
    let unit = unit.as_ref().map(|(line, unit)| (*line, text::word(unit)));
    let unit = asked.unit(unit.filter(|(_, unit)| !unit.is_empty()), Some(Kind::Acceleration))?;
    let number = |key, value| positive(asked, key, value).map(|text| text::number(&text).unwrap_or(0.0f64));
    let rate = number("#SampleRate(Hz)", &rate)?;
    let length = number("#RecordLength(sec)", &duration)?;
    let found = table::read(sheet, Known { kind: "CWB", names, unit: Some(unit) })?;
    let read = sheet.sink.len() as f64;
    // The last sample may be at the end of the length, and a product that is not whole is one of rounded numbers.
    let due = rate * length;
    let off = due.abs() * f64::EPSILON * 4.0;
    if read < (due + off).floor() || read > (due - off).ceil() + 1.0 {
        return Err(format!(
            "{}: #RecordLength(sec) × #SampleRate(Hz) = {due}, but the file has {read} samples",
            asked.name
        ));
    }
    Ok(found)
}
