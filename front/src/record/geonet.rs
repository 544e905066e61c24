//! GeoNet V1A and V2A: three components one after the other, each with 16 lines of text, 4 of integers and 6 of real
//! numbers, then the accelerations, velocities and displacements in fields of eight characters.

use super::lines::{Line, Lines};
use super::samples::{Samples, Times};
use super::{Options, Reading, text};
use std::io::BufRead;
use std::str::FromStr;
use stickslip::Float;

/// The width of a field.
const WIDTH: Option<usize> = Some(8);

pub(super) fn read<F: Float + FromStr>(
    lines: &mut Lines<'_, impl BufRead>,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    options.without_step()?;
    let mut found: Option<(String, Reading<F>)> = None;
    let mut names = Vec::new();
    while let Some(first) = lines.next()? {
        if first.1.trim().is_empty() {
            continue;
        }
        let component = Component::read(lines, options, first)?;
        names.push(component.name.clone());
        // Such as S16W of “S16W  Longitudinal Accelerometer Axis”.
        let short = component.name.split_whitespace().next().unwrap_or_default();
        let is_wanted = options.is_channel(names.len(), &component.name).unwrap_or(true)
            || options.is_channel(names.len(), short) == Some(true);
        let mut reading = None;
        if is_wanted {
            reading = Some(component.samples(lines, options)?);
        }
        let [accelerations, velocities, displacements] = component.counts;
        let passed = if is_wanted { None } else { Some(accelerations) };
        for count in passed.into_iter().chain([velocities, displacements]) {
            component.pass(lines, options, count)?;
        }
        if let Some(reading) = reading {
            if let Some((first, _)) = &found {
                return Err(format!(
                    "{}: has the components {first}, {} and perhaps more. Choose one by {}",
                    options.name, component.name, options.words.column
                ));
            }
            found = Some((component.name, reading));
        }
    }
    found.map(|(_, reading)| reading).ok_or_else(|| {
        let column = options.column.unwrap_or_default();
        format!(
            "{} {column}: must be a component of {}: {}",
            options.words.column,
            options.name,
            names.join(", ")
        )
    })
}

struct Component<F> {
    name: String,
    unit: Option<(u64, String)>,
    step: F,
    /// The numbers of accelerations, velocities and displacements.
    counts: [usize; 3],
    /// The line that states them.
    line: u64,
}

impl<F: Float + FromStr> Component<F> {
    fn read(
        lines: &mut Lines<'_, impl BufRead>,
        options: &Options<'_, F>,
        first: Line,
    ) -> Result<Self, String> {
        let start = first.0;
        if !first.1.to_ascii_lowercase().contains("accelerogram") {
            return Err(
                options.at(start, &format!("{}: must be the first line of a component", first.1.trim()))
            );
        }
        let mut header = vec![first];
        while header.len() < 26 {
            header
                .push(lines.next()?.ok_or_else(|| options.at(start, "must begin 26 lines of a component"))?);
        }
        let value = |key: &str| {
            let mut found = header.iter().take(16);
            found.find_map(|(line, text)| Some((*line, text::value(text, key)?.to_owned())))
        };
        let (_, name) = value("Component").ok_or_else(|| options.at(start, "must name its Component"))?;
        // Acceleration:  Peak  -2080.5 mm/s/s at  23.28 s
        let unit = value("Acceleration").and_then(|(line, text)| {
            let mut words = text.split_whitespace();
            let unit = words.next().filter(|word| word.eq_ignore_ascii_case("peak")).and(words.nth(1));
            let unit = unit?.to_owned();
            Some((line, unit))
        });
        let row = |place: usize| -> Result<(u64, Vec<F>), String> {
            let (line, text) = header.get(place).ok_or_else(|| options.at(start, "must begin 26 lines"))?;
            let mut all = Vec::new();
            text::numbers(text, WIDTH, &mut all)
                .map_err(|wrong| options.at(*line, &format!("{wrong}: must be a number of the header")))?;
            Ok((*line, all))
        };
        let (line, counted) = row(19)?;
        let count = |place: usize| {
            let count = counted.get(place).copied().map(F::to_f64).filter(|count| (0.0..1e9).contains(count));
            count.map(|count| count as usize).ok_or_else(|| {
                options.at(line, "must state the numbers of accelerations, velocities and displacements")
            })
        };
        let counts = [count(3)?, count(4)?, count(5)?];
        let (at, factors) = row(20)?;
        let factor = factors.get(7).copied().unwrap_or_else(|| F::int(1));
        if factor != F::int(1) && factor != F::int(0) {
            return Err(options.at(at, &format!("the factor of the unit = {factor}: must be 1")));
        }
        let (at, steps) = row(22)?;
        let step = steps.get(5).copied().filter(|step| *step > F::int(0));
        let step = step.ok_or_else(|| options.at(at, "must state the step, number 6 of this line, > 0"))?;
        Ok(Self { name, unit, step, counts, line })
    }

    fn stated(&self, count: usize) -> String {
        format!("the number of samples = {count} of line {}", self.line)
    }

    fn samples(
        &self,
        lines: &mut Lines<'_, impl BufRead>,
        options: &Options<'_, F>,
    ) -> Result<Reading<F>, String> {
        let [count, ..] = self.counts;
        let unit = options.unit(self.unit.as_ref().map(|(line, unit)| (*line, unit.as_str())))?;
        let excitation = unit.excitation();
        let mut samples = Samples::new(unit);
        samples.fill(lines, (count, &self.stated(count)), WIDTH, None, options)?;
        samples.finish(
            "GeoNet",
            Some(self.name.clone()),
            excitation,
            Times::Step(self.step),
            F::int(0),
            options,
        )
    }

    /// Passes over numbers.
    fn pass(
        &self,
        lines: &mut Lines<'_, impl BufRead>,
        options: &Options<'_, F>,
        count: usize,
    ) -> Result<(), String> {
        let mut all = Vec::<F>::new();
        let mut passed: usize = 0;
        while passed < count {
            let (number, line) = lines.next()?.ok_or_else(|| {
                format!("{}: {}, but the file has {passed}", options.name, self.stated(count))
            })?;
            text::numbers(&line, WIDTH, &mut all)
                .map_err(|wrong| options.at(number, &format!("{wrong}: must be a number")))?;
            passed = passed.saturating_add(all.len());
        }
        Ok(())
    }
}
