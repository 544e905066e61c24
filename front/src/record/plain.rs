//! Files of programs whose first line has the number of samples and the step: of DEEPSOIL, with rows of a time and an
//! acceleration in g, and those in one column that OpenSees and FLAC read.

use super::sheet::{Found, Sheet, Times};
use super::{Head, text};
use crate::inputs::units::Kind;

/// The lines above the one with the number of samples: FLAC has a title.
const TITLES: usize = 2;

/// The line with the number of samples and the step, and these two.
fn first(head: &Head) -> Option<(usize, usize, String)> {
    let place = head.lines.iter().take(TITLES).position(|(_, line)| text::begins_with_number(line))?;
    let (_, line) = head.lines.get(place)?;
    let all = text::numbers(line, None).ok()?;
    let [count, step] = all.as_slice() else { return None };
    // A count is a whole number, and a step has decimals.
    let count = count.parse::<usize>().ok().filter(|count| *count >= 2)?;
    let is_step = step.contains(['.', 'e', 'E'])
        && text::number::<f64>(step).is_some_and(|step| (0.0..1.0).contains(&step));
    is_step.then(|| (place, count, step.clone()))
}

/// Whether the rows below have two numbers, the first of which is the time at this step.
fn has_times(head: &Head, place: usize, step: f64) -> Option<bool> {
    let rows: Vec<Vec<f64>> = head
        .lines
        .iter()
        .skip(place.checked_add(1)?)
        .filter(|(_, line)| !line.trim().is_empty())
        .take(3)
        .map(|(_, line)| {
            text::numbers(line, None).ok().map(|all| all.iter().filter_map(|n| text::number(n)).collect())
        })
        .collect::<Option<_>>()?;
    let pairs: Option<Vec<[f64; 2]>> = rows.iter().map(|row| row.as_slice().try_into().ok()).collect();
    match pairs.as_deref() {
        Some([[first, _], rest @ ..]) => {
            let near = |(place, [time, _]): (usize, &[f64; 2])| {
                (time - first - (place as f64 + 1.0) * step).abs() <= 0.01 * step
            };
            let is_first = first.abs() <= 0.01 * step || (first - step).abs() <= 0.01 * step;
            (is_first && rest.iter().enumerate().all(near)).then_some(true)
        }
        // Not a table of two columns without names, whose first row this would be.
        _ if rows.first().is_some_and(|row| row.len() != 2) => Some(false),
        _ => None,
    }
}

pub(super) fn is(head: &Head) -> bool {
    first(head)
        .is_some_and(|(place, _, step)| has_times(head, place, text::number(&step).unwrap_or(1.0)).is_some())
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    let head = Head { bytes: Vec::new(), lines: sheet.lines.head(TITLES + 4)? };
    let (place, count, step) = first(&head).ok_or_else(|| format!("{}: states no step", asked.name))?;
    asked.without_step()?;
    let seconds = text::number::<f64>(&step).unwrap_or(1.0);
    let has_times = has_times(&head, place, seconds) == Some(true);
    let mut line = 1;
    for _ in 0..=place {
        line = sheet.lines.next()?.map_or(line, |(number, _)| number);
    }
    let stated = format!("{count} samples of line {line}");
    let times = Times::step(&step, "1");
    if !has_times {
        let unit = asked.unit(None, None)?;
        let excitation = unit.excitation();
        sheet.sink.begin(unit);
        sheet.fill((count, &stated), None)?;
        sheet.ended(&stated)?;
        return Ok(Found::new("count and step", excitation, times));
    }
    // The format has no unit: its accelerations are in g.
    let unit = if asked.units.is_some() || asked.scale.is_some() {
        asked.unit(None, None)?
    } else {
        asked.named_unit("DEEPSOIL", Some("g"), Some(Kind::Acceleration))?
    };
    let excitation = unit.excitation();
    sheet.sink.begin(unit);
    let mut first = None;
    while let Some((number, row)) = sheet.lines.next()? {
        if row.trim().is_empty() {
            continue;
        }
        let all = text::numbers(&row, None)
            .map_err(|wrong| asked.at(number, &format!("{wrong}: must be a number")))?;
        let [time, sample] = all.as_slice() else {
            return Err(asked.at(number, "must be a time and an acceleration"));
        };
        let own = text::number::<f64>(time).unwrap_or(0.0);
        let first = *first.get_or_insert(own);
        if (own - first - sheet.sink.len() as f64 * seconds).abs() > 0.5 * seconds {
            return Err(asked
                .at(number, &format!("time {time}: must be a multiple of the step {step} of line {line}")));
        }
        if sheet.sink.len() == count {
            return Err(asked.at(number, &format!("{stated}, but more samples follow")));
        }
        sheet.sink.sample(sample).map_err(|what| asked.at(number, &what))?;
    }
    if sheet.sink.len() != count {
        return Err(format!("{}: {stated}, but the file has {} samples", asked.name, sheet.sink.len()));
    }
    let notes = if asked.units.is_some() {
        Vec::new()
    } else {
        vec!["Accelerations of DEEPSOIL are in g.".to_owned()]
    };
    Ok(Found { notes, ..Found::new("DEEPSOIL", excitation, times) })
}
