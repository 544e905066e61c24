//! GeoNet V1A and V2A: three components one after the other, each with 16 lines of text, 4 of integers and 6 of real
//! numbers, then the accelerations, velocities and displacements in fields of eight characters.

use super::lines::Line;
use super::sheet::{Found, Sheet, Stated, Times};
use super::{Head, text};
use crate::inputs::units::Kind;

/// The width of a field.
const WIDTH: Option<usize> = Some(8);

pub(super) fn is(head: &Head) -> bool {
    head.first().contains("corrected accelerogram") && head.has("Component")
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    sheet.asked.without_step()?;
    let mut wanted = Vec::new();
    while let Some(first) = sheet.lines.next()? {
        if first.1.trim().is_empty() {
            continue;
        }
        let component = Component::read(sheet, first)?;
        // Such as S16W of “S16W  Longitudinal Accelerometer Axis”.
        let is_wanted = sheet.is_wanted(&[text::word(&component.name), &component.name]);
        let is_first = is_wanted && wanted.is_empty();
        if is_wanted {
            wanted.push(component.found(sheet)?);
        }
        let [accelerations, velocities, displacements] = component.counts;
        if is_first {
            let stated = component.stated(accelerations);
            sheet.fill((accelerations, &stated), WIDTH)?;
        } else {
            component.pass(sheet, accelerations)?;
        }
        component.pass(sheet, velocities)?;
        component.pass(sheet, displacements)?;
    }
    sheet.one(wanted)
}

struct Component {
    name: String,
    /// The peak and the unit, with their line.
    peak: Option<(u64, String, String)>,
    step: String,
    /// The numbers of accelerations, velocities and displacements.
    counts: [usize; 3],
    /// The line that states them.
    line: u64,
}

impl Component {
    fn read(sheet: &mut Sheet<'_>, first: Line) -> Result<Self, String> {
        let start = first.0;
        if !first.1.to_ascii_lowercase().contains("accelerogram") {
            return Err(
                sheet.at(start, &format!("{}: must be the first line of a component", first.1.trim()))
            );
        }
        let mut header = vec![first];
        while header.len() < 26 {
            let line = sheet.lines.next()?;
            header.push(line.ok_or_else(|| sheet.at(start, "must begin 26 lines of a component"))?);
        }
        let value = |key: &str| {
            let mut found = header.iter().take(16);
            found.find_map(|(line, text)| Some((*line, text::value(text, key)?.to_owned())))
        };
        let (_, name) = value("Component").ok_or_else(|| sheet.at(start, "must name its Component"))?;
        // Acceleration:  Peak  -2080.5 mm/s/s at  23.28 s
        let peak = value("Acceleration").and_then(|(line, text)| {
            let mut words = text.split_whitespace();
            words.next().filter(|word| word.eq_ignore_ascii_case("peak"))?;
            Some((line, words.next()?.to_owned(), words.next()?.to_owned()))
        });
        let row = |place: usize| -> Result<(u64, Vec<String>), String> {
            let (line, text) = header.get(place).ok_or_else(|| sheet.at(start, "must begin 26 lines"))?;
            let all = text::numbers(text, WIDTH)
                .map_err(|wrong| sheet.at(*line, &format!("{wrong}: must be a number of the header")))?;
            Ok((*line, all))
        };
        let (line, counted) = row(19)?;
        let count = |place: usize| {
            let count = counted.get(place).and_then(|count| text::number::<f64>(count));
            count.filter(|count| (0.0..1e9).contains(count)).map(|count| count as usize).ok_or_else(|| {
                sheet.at(line, "must state the numbers of accelerations, velocities and displacements")
            })
        };
        let counts = [count(3)?, count(4)?, count(5)?];
        let (at, factors) = row(20)?;
        let factor = factors.get(7).and_then(|factor| text::number::<f64>(factor)).unwrap_or(1.0);
        if factor != 1.0 && factor != 0.0 {
            return Err(sheet.at(at, &format!("the factor of the unit = {factor}: must be 1")));
        }
        let (at, steps) = row(22)?;
        let step = steps.get(5).filter(|step| text::number::<f64>(step).is_some_and(|step| step > 0.0));
        let step = step.ok_or_else(|| sheet.at(at, "must state the step, number 6 of this line, > 0"))?;
        Ok(Self { name, peak, step: step.clone(), counts, line })
    }

    fn stated(&self, count: usize) -> String {
        format!("the number of samples = {count} of line {}", self.line)
    }

    /// What is found of the component, whose samples follow.
    fn found(&self, sheet: &mut Sheet<'_>) -> Result<Found, String> {
        let unit = self.peak.as_ref().map(|(line, _, unit)| (*line, unit.as_str()));
        let unit = sheet.asked.unit(unit, Some(Kind::Acceleration))?;
        let excitation = unit.excitation();
        if sheet.sink.len() == 0 {
            sheet.sink.begin(unit);
        }
        let stated = self.peak.clone();
        Ok(Found {
            channel: Some(self.name.clone()),
            stated: stated.map(|(line, text, _)| Stated { line, text, unit: None, of_mean: false }),
            ..Found::new("GeoNet", excitation, Times::step(&self.step, "1"))
        })
    }

    /// Passes over numbers.
    fn pass(&self, sheet: &mut Sheet<'_>, count: usize) -> Result<(), String> {
        let mut passed: usize = 0;
        while passed < count {
            let (number, line) = sheet.lines.next()?.ok_or_else(|| {
                format!("{}: {}, but the file has {passed}", sheet.asked.name, self.stated(count))
            })?;
            let all = text::numbers(&line, WIDTH)
                .map_err(|wrong| sheet.at(number, &format!("{wrong}: must be a number")))?;
            passed = passed.saturating_add(all.len());
        }
        Ok(())
    }
}
