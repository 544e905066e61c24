//! SAC, alphanumeric and binary in both orders of bytes: 70 real numbers, 40 integers, 192 characters of names, and evenly
//! spaced samples. Real number 1 is the step, 2 and 3 are the least and the greatest sample, 6 is the time of the first
//! one; integer 7 is the version, 10 the number of samples, 16 and 36 say that the samples are a series of equal steps.

use super::sheet::{Found, Sheet, Stated, Times};
use super::{Head, text};
use std::io::Read;

/// The bytes of a binary header.
pub(super) const HEADER: usize = 632;
const REALS: usize = 70;
const INTEGERS: usize = 40;
/// The number for what is not known.
const UNKNOWN: f64 = -12345.0;

/// The order of the bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    Little,
    Big,
}

impl Order {
    /// The bytes of number `place` of the header.
    fn bytes(self, bytes: &[u8], place: usize) -> Option<[u8; 4]> {
        let at = place.checked_mul(4)?;
        let mut four: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        if self == Self::Big {
            four.reverse();
        }
        Some(four)
    }

    fn real(self, bytes: &[u8], place: usize) -> f32 {
        self.bytes(bytes, place).map_or(0.0, f32::from_le_bytes)
    }

    fn integer(self, bytes: &[u8], place: usize) -> i32 {
        self.bytes(bytes, place.saturating_add(REALS)).map_or(0, i32::from_le_bytes)
    }
}

/// The order of the bytes of a binary file: the one in which the version and the kind of the file are possible.
fn order(bytes: &[u8]) -> Option<Order> {
    let is = |order: &Order| {
        (6..=7).contains(&order.integer(bytes, 6)) && matches!(order.integer(bytes, 35), 0 | 1)
    };
    if bytes.len() < HEADER { None } else { [Order::Little, Order::Big].into_iter().find(is) }
}

pub(super) fn is_binary(head: &Head) -> bool {
    order(&head.bytes).is_some()
}

pub(super) fn is_text(head: &Head) -> bool {
    let is_row = |place: usize| {
        let all = head.lines.get(place).and_then(|(_, line)| text::numbers(line, Some(15)).ok());
        all.is_some_and(|all| all.len() == 5)
    };
    let has_unknown = head.lines.iter().take(REALS / 5).any(|(_, line)| line.contains("-12345"));
    has_unknown && (0..(REALS + INTEGERS) / 5).all(is_row)
}

/// What both forms of a header have.
struct Header {
    real: Vec<String>,
    integer: Vec<i32>,
    channel: String,
}

impl Header {
    fn real(&self, place: usize) -> Option<&str> {
        let text = self.real.get(place)?;
        text::number::<f64>(text).filter(|value| *value != UNKNOWN).map(|_| text.as_str())
    }

    fn integer(&self, place: usize) -> i32 {
        self.integer.get(place).copied().unwrap_or(0)
    }

    /// Begins the samples, and returns their number.
    fn begin(&self, sheet: &mut Sheet<'_>) -> Result<(usize, Found), String> {
        let asked = sheet.asked;
        asked.without_step()?;
        let wrong = |what: &str| format!("{}: {what}", asked.name);
        if self.integer(15) != 1 || self.integer(35) != 1 {
            return Err(wrong("must be a time series of equal steps (IFTYPE and LEVEN = 1)"));
        }
        if self.integer(16) == 7 {
            return Err(wrong("its header says velocities (IDEP = 7): must be an acceleration"));
        }
        let count = text::count(&self.integer(9).to_string())
            .ok_or_else(|| wrong(&format!("NPTS = {}: must be a number of samples", self.integer(9))))?;
        let step = self.real(0).filter(|step| text::number(step) > Some(0.0f64));
        let step = step.ok_or_else(|| wrong("DELTA must be the step, > 0"))?;
        let unit = asked.unit(None, None)?;
        let excitation = unit.excitation();
        sheet.sink.begin(unit);
        let start = self.real(5).unwrap_or("0").to_owned();
        let times = Times::Step(super::Ratio::new(step, "1"), None, start);
        let channel =
            Some(self.channel.clone()).filter(|name| !name.is_empty() && !name.starts_with("-12345"));
        let peak = [self.real(1), self.real(2)].into_iter().flatten();
        let magnitude = |text: &&str| text::number::<f64>(text).map_or(0.0, f64::abs);
        let peak = peak.max_by(|a, b| magnitude(a).total_cmp(&magnitude(b)));
        let stated = peak.map(|text| Stated { line: 1, text: text.to_owned(), unit: None, of_mean: false });
        Ok((count, Found { channel, stated, ..Found::new("SAC", excitation, times) }))
    }
}

pub(super) fn binary(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let mut bytes = vec![0; HEADER];
    let name = sheet.asked.name;
    sheet.lines.source.read_exact(&mut bytes).map_err(|error| format!("{name}: {error}"))?;
    let order = order(&bytes).ok_or_else(|| format!("{name}: must be SAC of version 6 or 7"))?;
    // The third word of the eight last names is the component.
    let channel = bytes.get(REALS.saturating_add(INTEGERS).saturating_mul(4).saturating_add(160)..);
    let channel = channel.and_then(|bytes| bytes.get(..8)).unwrap_or_default();
    let header = Header {
        // The shortest decimal of a single-precision number is the one that was meant.
        real: (0..REALS).map(|place| order.real(&bytes, place).to_string()).collect(),
        integer: (0..INTEGERS).map(|place| order.integer(&bytes, place)).collect(),
        channel: String::from_utf8_lossy(channel).trim_end_matches(['\0', ' ']).trim().to_owned(),
    };
    let (count, found) = header.begin(sheet)?;
    let mut four = [0; 4];
    for read in 0..count {
        sheet
            .lines
            .source
            .read_exact(&mut four)
            .map_err(|_| format!("{name}: NPTS = {count}, but the file has {read} samples"))?;
        let value = f64::from(order.real(&four, 0));
        if !value.is_finite() {
            return Err(format!("{name}: sample {} = {value}: must be finite", read.saturating_add(1)));
        }
        sheet.sink.exact(value).map_err(|what| format!("{name}: {what}"))?;
    }
    // Version 7 ends with 22 numbers of double precision.
    let footer = if header.integer(6) == 7 { 176 } else { 0 };
    let mut rest = Vec::new();
    let end = Read::take(&mut sheet.lines.source, 177).read_to_end(&mut rest);
    end.map_err(|error| format!("{name}: {error}"))?;
    if rest.len() != footer && !rest.is_empty() {
        return Err(format!("{name}: NPTS = {count}, but more samples follow"));
    }
    Ok(found)
}

pub(super) fn text(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let (mut real, mut integer, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for place in 0..30usize {
        let due = || format!("{}: must have 30 lines of a header", sheet.asked.name);
        let (number, line) = sheet.lines.next()?.ok_or_else(due)?;
        let wrong =
            |wrong| format!("{} line {number}: {wrong}: must be a number of the header", sheet.asked.name);
        if place < REALS / 5 {
            real.extend(text::numbers(&line, Some(15)).map_err(wrong)?);
        } else if place < (REALS + INTEGERS) / 5 {
            let all = text::numbers(&line, Some(10)).map_err(wrong)?;
            integer.extend(all.iter().filter_map(|text| text.parse::<i32>().ok()));
        } else {
            names.push(line);
        }
    }
    // Three names of eight characters a line: the component is name 21, counted from 1.
    let channel = names.get(6).and_then(|line| line.get(16..24)).unwrap_or_default().trim().to_owned();
    let (count, found) = Header { real, integer, channel }.begin(sheet)?;
    let stated = format!("NPTS = {count}");
    sheet.fill((count, &stated), Some(15))?;
    sheet.ended(&stated)?;
    Ok(found)
}
