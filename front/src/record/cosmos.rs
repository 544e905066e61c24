//! COSMOS V1 and V2: channels one after the other, each with lines of text, integers, real numbers and comments.

use super::lines::Lines;
use super::samples::{Samples, Times};
use super::{Options, Reading, text};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::Float;

/// Whether a line in small letters begins a channel.
pub(super) fn is_first(line: &str) -> bool {
    line.contains("(format v") && line.contains("text lines")
}

/// The number at the beginning of a line such as ` 100 Real-header values follow on  20 lines`.
fn leading(line: &str) -> Option<usize> {
    line.split_whitespace().next()?.parse().ok()
}

/// The width of the fields of a Fortran format, such as 10 in `(8F10.4)`.
fn width(format: &str) -> Option<usize> {
    let after = format.trim_start_matches(|c: char| !c.is_ascii_digit());
    let after = after.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = after.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    digits.get(..end)?.parse().ok().filter(|width| (1..=64).contains(width))
}

/// The step of `count` samples: number 62 of the real header in ms. Where that is missing it is number 34, the step of the
/// recorder, in ms or in s, whichever agrees with the duration that the line of the samples states in whole seconds;
/// where both do, it is in s below 1/2.
fn step<F: Float>([own, recorder]: [Option<F>; 2], count: usize, seconds: Option<f64>) -> Option<F> {
    let is_given = |step: &F| *step > F::int(0);
    let agrees = |step: &F| {
        let off = seconds.map_or(0.0, |seconds| (step.to_f64() * count as f64 - seconds).abs());
        *step > F::int(0) && off <= 1.5 + 0.02 * seconds.unwrap_or(0.0)
    };
    if let Some(own) = own.filter(is_given) {
        return Some(own / F::int(1000)).filter(agrees);
    }
    let s = recorder.filter(is_given)?;
    let ms = s / F::int(1000);
    let likely = if s < F::ratio(1, 2) { [s, ms] } else { [ms, s] };
    likely.into_iter().find(agrees)
}

pub(super) fn read<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    options.without_step()?;
    let mut found: Option<(String, Reading<F>)> = None;
    let mut place: usize = 0;
    while let Some((number, line)) = lines.next()? {
        if !is_first(&line.to_ascii_lowercase()) {
            continue;
        }
        let header = Header::read(lines, options, number)?;
        if !header.is_acceleration {
            if !header.skip(lines)? && found.is_none() && place == 0 {
                return Err(options.at(header.line, &format!("{}: must be an acceleration", header.quantity)));
            }
            continue;
        }
        place = place.saturating_add(1);
        let name = format!("chan {}", header.channel);
        let is_wanted = options.is_channel(place, &header.channel).unwrap_or(true)
            || options.is_channel(place, &name) == Some(true);
        if !is_wanted {
            header.skip(lines)?;
            continue;
        }
        if let Some((first, _)) = &found {
            return Err(format!(
                "{}: has {first} and {name}, and perhaps more. Choose one by {}, such as 1",
                options.name, options.words.column
            ));
        }
        found = Some((name.clone(), header.samples(lines, options, name)?));
    }
    found.map(|(_, reading)| reading).ok_or_else(|| match options.column {
        Some(column) if place > 0 => {
            format!(
                "{} {column}: must be a channel of {}, one of {place}",
                options.words.column, options.name
            )
        }
        _ => format!("{}: has no acceleration", options.name),
    })
}

/// The header of a channel.
struct Header<F> {
    channel: String,
    /// Numbers 62 and 34 of the real header: the steps of the samples and of the recorder.
    steps: [Option<F>; 2],
    count: usize,
    seconds: Option<f64>,
    unit: String,
    width: Option<usize>,
    quantity: String,
    is_acceleration: bool,
    /// The line that states the number of samples.
    line: u64,
}

impl<F: Float + FromStr> Header<F> {
    /// Reads the lines from the second to the one that states the number of samples.
    fn read(
        lines: &mut Lines<'_, impl BufRead>,
        options: &Options<'_, F>,
        first: u64,
    ) -> Result<Self, String> {
        let mut channel = String::new();
        let mut steps = [None; 2];
        let mut all = Vec::new();
        while let Some((number, line)) = lines.next()? {
            let small = line.to_ascii_lowercase();
            if let Some(rest) = text::after(&line, "Sta Chan")
                && let Some(number) = rest.split(|c: char| c.is_whitespace() || c == ':').next()
            {
                number.clone_into(&mut channel);
            }
            if small.contains("real-header values follow") {
                let count = leading(&line).unwrap_or(0);
                let width = text::after(&line, "format").and_then(width);
                let mut values: Vec<F> = Vec::new();
                while values.len() < count
                    && let Some((number, line)) = lines.next()?
                {
                    text::numbers(&line, width, &mut all).map_err(|wrong| {
                        options.at(number, &format!("{wrong}: must be a number of the header"))
                    })?;
                    if values.len().saturating_add(all.len()) > count {
                        return Err(
                            options.at(number, &format!("has more than the {count} numbers of the header"))
                        );
                    }
                    values.append(&mut all);
                }
                steps = [61, 33].map(|place| values.get(place).copied());
            }
            if let Some((before, after)) = small.split_once(" pts") {
                let count = leading(before).filter(|count| *count > 0);
                let count =
                    count.ok_or_else(|| options.at(number, "must begin with the number of samples"))?;
                let quantity = before.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace());
                let unit = text::after(&line, "units=").unwrap_or_default();
                let end = unit.find([',', '(']).unwrap_or(unit.len());
                return Ok(Self {
                    channel,
                    steps,
                    count,
                    seconds: text::after(after, "approx")
                        .and_then(|text| text.split_whitespace().next()?.trim_end_matches(',').parse().ok()),
                    unit: unit.get(..end).unwrap_or_default().trim().to_owned(),
                    width: text::after(&line, "format").and_then(width),
                    quantity: quantity.to_owned(),
                    is_acceleration: quantity.contains("accel"),
                    line: number,
                });
            }
        }
        Err(options.at(first, "no line states the number of samples, such as 4000 acceleration pts"))
    }

    /// Passes over the samples, and returns whether another channel follows.
    fn skip(&self, lines: &mut Lines<'_, impl BufRead>) -> Result<bool, String> {
        while let Some(line) = lines.next()? {
            if is_first(&line.1.to_ascii_lowercase()) {
                lines.put_back(line);
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn samples(
        self,
        lines: &mut Lines<'_, impl BufRead>,
        options: &Options<'_, F>,
        channel: String,
    ) -> Result<Reading<F>, String> {
        let stated = format!("the number of samples = {}", self.count);
        let step = step(self.steps, self.count, self.seconds).ok_or_else(|| {
            let [own, recorder] =
                self.steps.map(|step| step.map_or("missing".to_owned(), |step| step.to_string()));
            options.at(
                self.line,
                &format!(
                    "the step, number 62 of the real header, is {own}, and that of the recorder, number 34, is \
                     {recorder}, which does not agree with this line"
                ),
            )
        })?;
        let unit = (!self.unit.is_empty()).then_some((self.line, self.unit.as_str()));
        let unit = options.unit(unit)?;
        let excitation = unit.excitation();
        let mut samples = Samples::new(unit);
        samples.fill(lines, (self.count, &stated), self.width, None, options)?;
        samples.ended(lines, &stated, options)?;
        samples.finish("COSMOS", Some(channel), excitation, Times::Step(step), F::int(0), options)
    }
}

#[cfg(test)]
mod tests {
    use super::{step, width};

    #[test]
    fn a_step_is_in_ms_or_in_s_as_the_duration_says() {
        let of = |own: f64, recorder: f64, count, seconds| step([Some(own), Some(recorder)], count, seconds);
        assert_eq!(of(-999.0, 20.0, 400, Some(8.0)), Some(0.02));
        assert_eq!(of(-999.0, 0.005, 12725, Some(63.0)), Some(0.005));
        assert_eq!(of(-999.0, 20.0, 400, Some(80.0)), None);
        assert_eq!(of(-999.0, -999.0, 400, Some(8.0)), None);
        assert_eq!(step([None, Some(10.0)], 100, None), Some(0.01));
        // The recorder sampled four times as often as the samples of the file.
        assert_eq!(of(20.0, 0.005, 40, Some(0.8)), Some(0.02));
        assert_eq!(of(0.5, 0.005, 40, None), Some(0.0005));
        assert_eq!(of(20.0, 0.005, 4000, Some(20.0)), None);
    }

    #[test]
    fn the_width_of_a_format() {
        for (format, found) in
            [("(8F10.4)", Some(10)), ("(1E15.6)", Some(15)), ("(10I8)", Some(8)), ("()", None)]
        {
            assert_eq!(width(format), found, "{format}");
        }
    }
}
