//! Accelerograms in volumes: CSMIP, CDMG, CGS and USC V1 and V2, RENADIC of Chile, BHRC of Iran. Each channel has lines of
//! text, integers and real numbers, then its samples:
//!
//! - of a line such as `13200 Accelerogram points at 200 pts/sec in units of g` that comes before them,
//! - or pairs of a time and a sample, in the unit of `UNITS ARE SEC AND G/10`,
//! - or, of BHRC, samples at the rate that begins the second line of real numbers.

use super::lines::Line;
use super::sheet::{Found, Sheet, Stated, Times};
use super::unit::Ratio;
use super::{Head, Unit, text};
use crate::inputs::units::{Kind, split};
use stickslip::Excitation;

/// The most lines of text of a header.
const MOST: usize = 40;
/// The lines of real numbers of a V1.
const REALS: usize = 7;

pub(super) fn is(head: &Head) -> bool {
    is_first(&head.first())
}

/// Whether a line in small letters begins a channel.
fn is_first(line: &str) -> bool {
    line.contains("corrected accelerogram") || line.starts_with("* vol") || is_spectra(line)
}

fn is_spectra(line: &str) -> bool {
    line.starts_with("response and fourier")
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    sheet.asked.without_step()?;
    let mut wanted = Vec::new();
    while let Some((number, line)) = sheet.lines.next()? {
        let small = line.to_lowercase();
        if !is_first(&small) {
            continue;
        }
        if is_spectra(&small) {
            return Err(sheet.at(number, "response and Fourier spectra: must be an accelerogram"));
        }
        let channel = Channel::read(sheet, (number, line))?;
        let (name, own) = channel.names();
        let place = format!("chan {own}");
        match sheet.is_wanted(&[&name, text::word(&name), &own, &place]) {
            true if wanted.is_empty() => wanted.push(channel.samples(sheet, name)?),
            // A second one is refused when all of them are known.
            is_wanted => wanted.extend(
                is_wanted.then(|| Found::new(channel.kind(), Excitation::SurfaceAcceleration, Times::Each)),
            ),
        }
    }
    sheet.one(wanted)
}

/// The header of a channel.
struct Channel {
    text: Vec<Line>,
    /// The number that begins the second line of real numbers: the samples a second of BHRC.
    rate: Option<String>,
    /// The line before the samples, where there is one.
    block: Option<Line>,
}

/// Whether a line has integers only, as a header has them.
fn is_integers(line: &str) -> bool {
    line.split_whitespace().count() >= 8
        && line.chars().all(|c| c.is_ascii_digit() || c.is_whitespace() || c == '-')
}

fn has_letters(line: &str) -> bool {
    line.chars().any(|c| c.is_alphabetic() && !matches!(c, 'e' | 'E' | 'd' | 'D'))
}

impl Channel {
    fn read(sheet: &mut Sheet<'_>, first: Line) -> Result<Self, String> {
        let start = first.0;
        let small = first.1.to_lowercase();
        // A second volume has 100 real numbers, and always a line before its samples.
        let has_block = small.contains("corrected") && !small.contains("uncorrected");
        let mut text = vec![first];
        let mut next = |what: &str| {
            let line = sheet.lines.next()?;
            line.ok_or_else(|| format!("{} line {start}: {what}", sheet.asked.name))
        };
        let mut line = next("must begin a header with integers")?;
        while !is_integers(&line.1) {
            if text.len() >= MOST {
                return Err(sheet.at(start, "must begin a header with integers after its text"));
            }
            text.push(line);
            line = next("must begin a header with integers")?;
        }
        while is_integers(&line.1) || line.1.trim().chars().all(|c| c.is_ascii_digit() || " -".contains(c)) {
            line = next("must have real numbers after the integers of its header")?;
        }
        let mut rate = None;
        let mut count = 0usize;
        while !has_letters(&line.1) && (has_block || count < REALS) {
            count = count.saturating_add(1);
            if count == 2 {
                rate = Some(text::word(&line.1).to_owned());
            }
            line = next("must have samples after its header")?;
        }
        let block = if has_letters(&line.1) {
            Some(line)
        } else {
            sheet.lines.put_back(line);
            None
        };
        Ok(Self { text, rate, block })
    }

    fn first(&self) -> String {
        self.text.first().map(|(_, line)| line.to_lowercase()).unwrap_or_default()
    }

    fn is_bhrc(&self) -> bool {
        self.first().starts_with("* vol")
    }

    fn kind(&self) -> &'static str {
        if self.is_bhrc() {
            "BHRC"
        } else if self.first().contains("data of volume") {
            "USC"
        } else if self.text.iter().any(|(_, line)| line.contains("RENADIC")) {
            "RENADIC"
        } else {
            "CSMIP"
        }
    }

    /// The line of the text with this word, and what follows it.
    fn after(&self, word: &str) -> Option<(u64, &str)> {
        self.text.iter().find_map(|(line, text)| Some((*line, text::after(text, word)?)))
    }

    /// The name of the channel, such as `360 Deg` or `N90E`, and its number.
    fn names(&self) -> (String, String) {
        let begins = |word: &str| {
            let small = |line: &str| line.trim_start().to_lowercase().starts_with(word);
            let line = self.text.iter().find(|(_, line)| small(line));
            line.and_then(|(_, line)| text::after(line, word))
        };
        if let Some(name) = begins("comp") {
            return (name.trim().split("  ").next().unwrap_or_default().to_owned(), String::new());
        }
        let found = begins("chan").or_else(|| self.after("chan").map(|(_, rest)| rest)).unwrap_or_default();
        let (number, name) = found.split_once(':').unwrap_or((found, ""));
        let name = name.trim().split("  ").next().unwrap_or_default();
        let number = number.trim().to_owned();
        (if name.is_empty() { number.clone() } else { name.to_owned() }, number)
    }

    /// The number of samples that the text states, with its line.
    fn count(&self) -> Option<(u64, usize)> {
        let of_text = self.after("no. of points").map(|(line, rest)| (line, text::word(rest)));
        let of_second = || {
            let mut lines = self.text.iter();
            lines.find_map(|(line, text)| text.contains("points of").then_some((*line, text::word(text))))
        };
        let (line, count) = of_text.or_else(of_second)?;
        Some((line, text::count(count)?))
    }

    /// The peak of the samples that the text states.
    fn peak(&self, sheet: &Sheet<'_>) -> Option<Stated> {
        let found = match self.first().contains("uncorrected") {
            true => self.after("max "),
            false => self.after("peak acceleration"),
        };
        let (line, rest) = found?;
        let (digits, unit) = split(rest);
        let unit = text::unit(unit.split([' ', ',']).next().unwrap_or_default());
        let unit = sheet.asked.reader.factor_of_column("peak", &unit, Kind::Acceleration).ok()?;
        Some(Stated { line, text: digits.to_owned(), unit: Some(unit), of_mean: false })
    }

    fn samples(&self, sheet: &mut Sheet<'_>, name: String) -> Result<Found, String> {
        let counted = self.count();
        let start = self.text.first().map_or(1, |(line, _)| *line);
        let times = match &self.block {
            Some(block) => self.block(sheet, block, counted)?,
            None => {
                let (line, count) = counted.ok_or_else(|| {
                    sheet.at(start, "must state the number of samples, such as NO. OF POINTS = 400")
                })?;
                self.begin(sheet, start)?;
                let stated = format!("NO. OF POINTS = {count} of line {line}");
                if self.is_bhrc() {
                    sheet.fill((count, &stated), None)?;
                    let rate = self.rate.as_ref().filter(|rate| text::number(rate) > Some(0.0f64));
                    let due =
                        "must state the samples a second, which begin the second line of real numbers, > 0";
                    Times::step("1", rate.ok_or_else(|| sheet.at(start, due))?)
                } else {
                    pairs(sheet, (count, &stated))?;
                    Times::Each
                }
            }
        };
        // A number of samples that is too small is found by the numbers that follow: “40 points of veloc” has words.
        if let Some((number, line)) = sheet.lines.next()? {
            if text::numbers(&line, None).is_ok_and(|all| !all.is_empty()) {
                return Err(
                    sheet.at(number, &format!("{} samples are stated, but more follow", sheet.sink.len()))
                );
            }
            sheet.lines.put_back((number, line));
        }
        let stated = self.peak(sheet);
        let found = Found::new(self.kind(), Excitation::SurfaceAcceleration, times);
        Ok(Found { channel: Some(name).filter(|name| !name.is_empty()), stated, ..found })
    }

    /// Begins samples in the unit of a line of the text, such as `UNITS ARE SEC AND G/10`.
    fn begin(&self, sheet: &mut Sheet<'_>, start: u64) -> Result<(), String> {
        let find =
            |line: &Line| Some((line.0, text::after(text::after(&line.1, "units")?, "and ")?.to_owned()));
        let due = "must state its unit, such as UNITS ARE SEC AND G/10";
        let (line, stated) = self.text.iter().find_map(find).ok_or_else(|| sheet.at(start, due))?;
        begin(sheet, line, text::word(&stated))
    }

    /// The samples after a line that states their number, step and unit.
    fn block(
        &self,
        sheet: &mut Sheet<'_>,
        (number, line): &Line,
        counted: Option<(u64, usize)>,
    ) -> Result<Times, String> {
        let small = line.to_lowercase();
        let wrong = |what: &str| format!("{} line {number}: {what}", sheet.asked.name);
        if !small.contains("accel") {
            return Err(wrong(&format!("{}: must be accelerations", line.trim())));
        }
        let count =
            text::count(text::word(line)).ok_or_else(|| wrong("must begin with the number of samples"))?;
        if let Some((other, _)) = counted.filter(|(_, other)| *other != count) {
            return Err(wrong(&format!("{count} samples, but line {other} states another number of them")));
        }
        let due = "must state the step, such as equally spaced at .020 sec, or at 200 pts/sec";
        let at = text::after(&small, " at ").ok_or_else(|| wrong(due))?;
        let (digits, unit) = split(at);
        if text::number::<f64>(digits).is_none_or(|number| number <= 0.0) {
            return Err(wrong(due));
        }
        let times = if unit.starts_with("pts/sec") || unit.starts_with("samples/sec") {
            Times::step("1", digits)
        } else if unit.starts_with("sec") {
            Times::step(digits, "1")
        } else {
            return Err(wrong(due));
        };
        if let Some((other, rest)) = self.after("equally-spaced intervals of")
            && let (Times::Step(step, ..), Some(stated)) = (&times, text::number::<f64>(split(rest).0))
            && stated != step.to_f64()
        {
            return Err(wrong(&format!("the step {digits} s is not {stated} s, as line {other} states")));
        }
        let unit = ["units of", "units", ", in "].into_iter().find_map(|word| text::after(&small, word));
        let unit = text::word(unit.ok_or_else(|| wrong("must state the unit, such as in cm/sec2"))?);
        let format = small.rsplit_once('(').and_then(|(_, format)| text::width(format));
        begin(sheet, *number, unit.trim_end_matches(')'))?;
        let stated = format!("the number of samples = {count} of line {number}");
        sheet.fill((count, &stated), format)?;
        Ok(times)
    }
}

/// Begins samples in the unit of a line: `g/10` is a tenth of g.
fn begin(sheet: &mut Sheet<'_>, line: u64, stated: &str) -> Result<(), String> {
    let stated = stated.trim_end_matches(['.', ',']);
    let tenth = stated.strip_suffix("/10");
    let unit = sheet.asked.unit(Some((line, tenth.unwrap_or(stated))), Some(Kind::Acceleration))?;
    let scale = if tenth.is_some() { Ratio::new("1", "10") } else { unit.scale };
    sheet.sink.begin(Unit { scale, ..unit });
    Ok(())
}

/// Reads pairs of a time and a sample, in fields of seven characters.
fn pairs(sheet: &mut Sheet<'_>, (count, stated): (usize, &str)) -> Result<(), String> {
    while sheet.sink.len() < count {
        let Some((number, line)) = sheet.lines.next()? else {
            let read = sheet.sink.len();
            return Err(format!("{}: {stated}, but the file has {read} samples", sheet.asked.name));
        };
        let all = text::numbers(&line, Some(7));
        let all = all.map_err(|wrong| sheet.at(number, &format!("{wrong}: must be a number")))?;
        for pair in all.chunks(2) {
            let [time, sample] = pair else {
                return Err(sheet.at(number, "must be pairs of a time and a sample"));
            };
            if sheet.sink.len() == count {
                return Err(sheet.at(number, &format!("{stated}, but more samples follow")));
            }
            let (time, sample) = (sheet.sink.time("time", time, None), sheet.sink.sample(sample));
            time.and(sample).map_err(|what| sheet.at(number, &what))?;
        }
    }
    Ok(())
}
