//! SLIST and TSPAIR, as ObsPy and the tools of miniSEED write them: a line such as
//! `TIMESERIES XX_TEST__HNZ_R, 12 samples, 40 sps, 2008-01-15T00:00:00.000000, SLIST, FLOAT, M/S**2`, then the samples, or
//! rows of a time and a sample.

use super::sheet::{Found, Sheet, Times};
use super::table::clock;
use super::unit::Ratio;
use super::{Head, text};
use stickslip::Excitation;

pub(super) fn is(head: &Head) -> bool {
    head.lines.first().is_some_and(|(_, line)| line.starts_with("TIMESERIES "))
}

/// Records of miniSEED 2 begin with a number of six digits and the quality, those of miniSEED 3 with `MS` and 3.
pub(super) fn is_mini_seed(head: &Head) -> bool {
    let bytes = &head.bytes;
    let digits = bytes.get(..6).is_some_and(|digits| digits.iter().all(u8::is_ascii_digit));
    let quality = bytes.get(6).is_some_and(|quality| b"DRQMVAST".contains(quality));
    head.lines.is_empty() && (digits && quality || bytes.starts_with(&[b'M', b'S', 3]))
}

pub(super) fn mini_seed(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    Err(format!(
        "{}: is miniSEED or SEED, whose samples are counts without a unit. Remove the instrument's response, and \
         write SLIST, as by stream.write(\"record.slist\", format=\"SLIST\") of ObsPy",
        sheet.asked.name
    ))
}

/// The line before the samples of a segment.
struct Segment {
    line: u64,
    name: String,
    count: usize,
    rate: String,
    start: i128,
    is_pairs: bool,
    unit: String,
}

impl Segment {
    fn new(number: u64, line: &str) -> Option<Self> {
        let mut fields = line.strip_prefix("TIMESERIES ")?.split(',').map(str::trim);
        let name = fields.next()?.to_owned();
        let count = text::count(fields.next()?.strip_suffix("samples")?.trim())?;
        let rate = fields.next()?.strip_suffix("sps")?.trim().to_owned();
        text::number::<f64>(&rate).filter(|rate| *rate > 0.0)?;
        let start = clock::instant(fields.next()?)?;
        let is_pairs = match fields.next()? {
            "SLIST" => false,
            "TSPAIR" => true,
            _ => return None,
        };
        fields.next().filter(|kind| ["INTEGER", "FLOAT", "FLOAT32", "FLOAT64"].contains(kind))?;
        let unit = fields.next().unwrap_or_default().to_owned();
        Some(Self { line: number, name, count, rate, start, is_pairs, unit })
    }

    /// The channel of `XX_TEST__HNZ_R`.
    fn channel(&self) -> &str {
        self.name.split('_').nth(3).unwrap_or_default()
    }

    fn samples(&self, sheet: &mut Sheet<'_>) -> Result<Found, String> {
        let asked = sheet.asked;
        // Counts are no unit.
        let unit =
            Some(self.unit.as_str()).filter(|unit| !unit.is_empty() && !unit.eq_ignore_ascii_case("counts"));
        let unit = asked.unit(unit.map(|unit| (self.line, unit)), None)?;
        let excitation = unit.excitation();
        sheet.sink.begin(unit);
        let stated = format!("{} samples of line {}", self.count, self.line);
        if self.is_pairs {
            self.pairs(sheet, &stated)?
        } else {
            sheet.fill((self.count, &stated), None)?
        }
        let next = sheet.lines.next()?;
        if let Some((number, line)) = next {
            if text::begins_with_number(&line) {
                return Err(sheet.at(number, &format!("{stated}, but more samples follow")));
            }
            sheet.lines.put_back((number, line));
        }
        let kind = if self.is_pairs { "TSPAIR" } else { "SLIST" };
        let times = Times::Step(Ratio::new("1", &self.rate), None, "0".to_owned());
        Ok(Found { channel: Some(self.name.clone()), ..Found::new(kind, excitation, times) })
    }

    fn pairs(&self, sheet: &mut Sheet<'_>, stated: &str) -> Result<(), String> {
        let rate: f64 = text::number(&self.rate).unwrap_or(1.0);
        for place in 0..self.count {
            let name = sheet.asked.name;
            let (number, line) = sheet
                .lines
                .next()?
                .ok_or_else(|| format!("{name}: {stated}, but the file has {place} samples"))?;
            let mut words = line.split_whitespace();
            let (time, sample) =
                words.next().zip(words.next()).filter(|_| words.next().is_none()).unwrap_or_default();
            let instant = clock::instant(time)
                .ok_or_else(|| sheet.at(number, &format!("{}: must be a time and a sample", line.trim())))?;
            // Times are rounded to microseconds.
            let off = instant.saturating_sub(self.start) as f64 / 1e9 - place as f64 / rate;
            if off.abs() > 2e-6 + 0.01 / rate {
                return Err(
                    sheet.at(number, &format!("{time}: is not sample {place} at {} a second", self.rate))
                );
            }
            if !sheet.sink.sample(sample).map_err(|what| sheet.asked.at(number, &what))? {
                return Err(sheet.at(number, &format!("{sample}: must be a number")));
            }
        }
        Ok(())
    }
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    sheet.asked.without_step()?;
    let mut wanted = Vec::new();
    while let Some((number, line)) = sheet.lines.next()? {
        if !line.starts_with("TIMESERIES ") {
            continue;
        }
        let due = "must be such as TIMESERIES XX_TEST__HNZ_R, 12 samples, 40 sps, \
                   2008-01-15T00:00:00.000000, SLIST, FLOAT, M/S**2";
        let segment = Segment::new(number, &line).ok_or_else(|| sheet.at(number, due))?;
        if sheet.is_wanted(&[&segment.name, segment.channel()]) {
            if wanted.is_empty() {
                wanted.push(segment.samples(sheet)?);
            } else {
                // A second one is refused when all of them are known.
                wanted.push(Found::new("SLIST", Excitation::SurfaceAcceleration, Times::Each));
            }
        }
    }
    sheet.one(wanted)
}
