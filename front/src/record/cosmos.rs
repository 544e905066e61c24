//! COSMOS V1 and V2: channels one after the other, each with lines of text, integers, real numbers and comments.

use super::sheet::{Found, Sheet, Stated, Times};
use super::unit::Ratio;
use super::{Head, text};
use crate::inputs::units::Kind;
use stickslip::Excitation;

pub(super) fn is(head: &Head) -> bool {
    is_first(&head.first())
}

/// Whether a line in small letters begins a channel.
fn is_first(line: &str) -> bool {
    line.contains("(format v") && line.contains("text lines")
}

/// The step of `count` samples: number 62 of the real header in ms. Where that is missing it is number 34, the step of the
/// recorder, in ms or in s, whichever agrees with the duration that the line of the samples states in whole seconds;
/// where both do, it is in s below 1/2.
fn step(own: &str, recorder: &str, count: usize, seconds: Option<f64>) -> Option<Ratio> {
    let is_given = |text: &&str| text::number::<f64>(text).is_some_and(|step| step > 0.0);
    let agrees = |step: &Ratio| {
        let off = seconds.map_or(0.0, |seconds| (step.to_f64() * count as f64 - seconds).abs());
        off <= 1.5 + 0.02 * seconds.unwrap_or(0.0)
    };
    if let Some(own) = Some(own).filter(is_given) {
        return Some(Ratio::new(own, "1000")).filter(agrees);
    }
    let recorder = Some(recorder).filter(is_given)?;
    let (s, ms) = (Ratio::new(recorder, "1"), Ratio::new(recorder, "1000"));
    let likely = if s.to_f64() < 0.5 { [s, ms] } else { [ms, s] };
    likely.into_iter().find(agrees)
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    sheet.asked.without_step()?;
    let mut wanted = Vec::new();
    while let Some((number, line)) = sheet.lines.next()? {
        if !is_first(&line.to_ascii_lowercase()) {
            continue;
        }
        let header = Header::read(sheet, number)?;
        if !header.quantity.contains("accel") {
            if !pass(sheet)? && sheet.channels.is_empty() {
                return Err(sheet.at(header.line, &format!("{}: must be an acceleration", header.quantity)));
            }
            continue;
        }
        let place = sheet.channels.len().saturating_add(1).to_string();
        let name = format!("chan {}", if header.channel.is_empty() { &place } else { &header.channel });
        match sheet.is_wanted(&[&name, &header.channel]) {
            true if wanted.is_empty() => wanted.push(header.samples(sheet, name)?),
            is_wanted => {
                // A second one is refused when all of them are known.
                wanted.extend(is_wanted.then(|| Found::new("COSMOS", Excitation::Force, Times::Asked)));
                pass(sheet)?;
            }
        }
    }
    sheet.one(wanted)
}

/// Passes over the samples, and returns whether another channel follows.
fn pass(sheet: &mut Sheet<'_>) -> Result<bool, String> {
    while let Some(line) = sheet.lines.next()? {
        if is_first(&line.1.to_ascii_lowercase()) {
            sheet.lines.put_back(line);
            return Ok(true);
        }
    }
    Ok(false)
}

/// The header of a channel.
#[derive(Default)]
struct Header {
    channel: String,
    /// Numbers 62 and 34 of the real header: the steps of the samples and of the recorder.
    steps: [String; 2],
    /// Number 64, the peak, and its line.
    peak: Option<(u64, String)>,
    count: usize,
    seconds: Option<f64>,
    unit: String,
    width: Option<usize>,
    quantity: String,
    /// The line that states the number of samples.
    line: u64,
}

impl Header {
    /// Reads the lines from the second to the one that states the number of samples.
    fn read(sheet: &mut Sheet<'_>, first: u64) -> Result<Self, String> {
        let mut found = Self::default();
        while let Some((number, line)) = sheet.lines.next()? {
            let small = line.to_ascii_lowercase();
            if let Some(rest) = text::after(&line, "Sta Chan")
                && let Some(number) = rest.split(|c: char| c.is_whitespace() || c == ':').next()
            {
                number.clone_into(&mut found.channel);
            }
            if small.contains("real-header values follow") {
                found.real(sheet, &line)?;
            }
            if let Some((before, after)) = small.split_once(" pts") {
                let count = text::word(before).parse().ok().filter(|count| *count > 0);
                let count = count.ok_or_else(|| sheet.at(number, "must begin with the number of samples"))?;
                let quantity = before.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace());
                // “units=cm/sec2(04),Format=”: the number in parentheses is the code of the unit.
                let unit = text::after(&line, "units=").unwrap_or_default();
                let end = unit.find([',', '(']).unwrap_or(unit.len());
                let seconds = text::after(after, "approx");
                return Ok(Self {
                    count,
                    seconds: seconds.and_then(|text| text::word(text).trim_end_matches(',').parse().ok()),
                    unit: unit.get(..end).unwrap_or_default().trim().to_owned(),
                    width: text::after(&line, "format").and_then(text::width),
                    quantity: quantity.to_owned(),
                    line: number,
                    ..found
                });
            }
        }
        Err(sheet.at(first, "no line states the number of samples, such as 4000 acceleration pts"))
    }

    /// The numbers of the real header that the line before them announces.
    fn real(&mut self, sheet: &mut Sheet<'_>, line: &str) -> Result<(), String> {
        let count = text::word(line).parse().unwrap_or(0usize);
        let width = text::after(line, "format").and_then(text::width);
        let mut seen: usize = 0;
        while seen < count
            && let Some((number, line)) = sheet.lines.next()?
        {
            let values = text::numbers(&line, width)
                .map_err(|wrong| sheet.at(number, &format!("{wrong}: must be a number of the header")))?;
            for value in values {
                seen = seen.saturating_add(1);
                let [own, recorder] = &mut self.steps;
                match seen {
                    62 => *own = value,
                    34 => *recorder = value,
                    // −999 is unknown.
                    64 if text::number(&value) != Some(-999.0f64) => self.peak = Some((number, value)),
                    _ => {}
                }
            }
            if seen > count {
                return Err(sheet.at(number, &format!("has more than the {count} numbers of the header")));
            }
        }
        Ok(())
    }

    fn samples(&self, sheet: &mut Sheet<'_>, channel: String) -> Result<Found, String> {
        let stated = format!("the number of samples = {}", self.count);
        let [own, recorder] = &self.steps;
        let step = step(own, recorder, self.count, self.seconds).ok_or_else(|| {
            let [own, recorder] =
                [own, recorder].map(|step| if step.is_empty() { "missing" } else { step.as_str() });
            sheet.at(
                self.line,
                &format!(
                    "the step, number 62 of the real header, is {own}, and that of the recorder, number 34, is \
                     {recorder}, which does not agree with this line"
                ),
            )
        })?;
        let unit = (!self.unit.is_empty()).then_some((self.line, self.unit.as_str()));
        let unit = sheet.asked.unit(unit, Some(Kind::Acceleration))?;
        let excitation = unit.excitation();
        sheet.sink.begin(unit);
        sheet.fill((self.count, &stated), self.width)?;
        sheet.ended(&stated)?;
        let times = Times::Step(step, None, "0".to_owned());
        let stated = self.peak.clone();
        Ok(Found {
            channel: Some(channel),
            stated: stated.map(|(line, text)| Stated { line, text, unit: None, of_mean: false }),
            ..Found::new("COSMOS", excitation, times)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::step;

    #[test]
    fn a_step_is_in_ms_or_in_s_as_the_duration_says() {
        let of =
            |own, recorder, count, seconds| step(own, recorder, count, seconds).map(|step| step.to_f64());
        assert_eq!(of("-999.0", "20.0", 400, Some(8.0)), Some(0.02));
        assert_eq!(of("-999.0", "0.005", 12725, Some(63.0)), Some(0.005));
        assert_eq!(of("-999.0", "20.0", 400, Some(80.0)), None);
        assert_eq!(of("-999.0", "-999.0", 400, Some(8.0)), None);
        assert_eq!(of("", "10.0", 100, None), Some(0.01));
        // The recorder sampled four times as often as the samples of the file.
        assert_eq!(of("20.0", "0.005", 40, Some(0.8)), Some(0.02));
        assert_eq!(of("0.5", "0.005", 40, None), Some(0.0005));
        assert_eq!(of("20.0", "0.005", 4000, Some(20.0)), None);
    }
}
