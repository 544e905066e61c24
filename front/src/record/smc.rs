//! SMC of the U.S. Geological Survey: 11 lines of text, 48 integers, 50 real numbers, comments that begin with `|`, and
//! accelerations in cm/s². Integer 1 and real number 1 stand for what is not known; integer 16 is the number of comments,
//! integer 17 that of samples; real number 2 is the samples a second, 30 and 32 are the greatest and the least sample.

use super::sheet::{Found, Sheet, Stated, Times};
use super::{Head, text};
use crate::inputs::units::Kind;
use stickslip::Excitation;

/// The lines of text, of integers and of real numbers.
const TEXT: usize = 11;
const INTEGERS: usize = 6;
const REALS: usize = 10;

pub(super) fn is(head: &Head) -> bool {
    let line = |place: usize| head.lines.get(place).map(|(_, text)| text.as_str()).unwrap_or_default();
    let is_row = |place: usize, count: usize, width: usize| {
        text::numbers(line(place), Some(width)).is_ok_and(|all| all.len() == count)
    };
    let first = line(0);
    (first.starts_with('*') || first.starts_with(|c: char| c.is_ascii_digit()))
        && line(1).starts_with('*')
        && (TEXT..TEXT + INTEGERS).all(|place| is_row(place, 8, 10) && !line(place).contains('.'))
        && is_row(TEXT + INTEGERS, 5, 15)
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    asked.without_step()?;
    let mut text = Vec::new();
    let (mut integers, mut reals) = (Vec::new(), Vec::new());
    for place in 0..TEXT + INTEGERS + REALS {
        let due = || format!("{}: must have {} lines of a header", asked.name, TEXT + INTEGERS + REALS);
        let (number, line) = sheet.lines.next()?.ok_or_else(due)?;
        if place < TEXT {
            text.push((number, line));
            continue;
        }
        let (width, all) = if place < TEXT + INTEGERS { (10, &mut integers) } else { (15, &mut reals) };
        let values = text::numbers(&line, Some(width))
            .map_err(|wrong| asked.at(number, &format!("{wrong}: must be a number of the header")))?;
        all.extend(values.into_iter().map(|value| (number, value)));
    }
    if let Some((line, first)) = text.first() {
        let upper = first.to_uppercase();
        if let Some(name) =
            ["VELOCITY", "DISPLACEMENT", "SPECTR"].into_iter().find(|name| upper.contains(name))
        {
            return Err(asked.at(*line, &format!("{name}: must be an acceleration")));
        }
    }
    // A number of the header, counted from 1, unless it is the one for what is not known.
    let known = |all: &[(u64, String)], place: usize| {
        let value = |place: usize| all.get(place.checked_sub(1)?).cloned();
        let unknown = value(1).and_then(|(_, text)| text::number::<f64>(&text));
        value(place).filter(|(_, text)| text::number::<f64>(text) != unknown)
    };
    let due = |what: &str| format!("{} line {}: {what}", asked.name, TEXT + INTEGERS);
    let comments = known(&integers, 16).and_then(|(_, text)| text::number::<f64>(&text)).unwrap_or(0.0);
    let (line, count) = known(&integers, 17)
        .and_then(|(line, text)| Some((line, text::count(&text)?)))
        .ok_or_else(|| due("must state the number of samples, integer 17"))?;
    let rate = known(&reals, 2).map(|(_, text)| text).filter(|text| text::number(text) > Some(0.0f64));
    let rate = rate.ok_or_else(|| due("must state the samples a second, real number 2, > 0"))?;
    let mut notes = Vec::new();
    if known(&integers, 18).is_some_and(|(_, flag)| text::number(&flag) == Some(1.0f64)) {
        notes.push("Its header flags a problem of the record.".to_owned());
    }
    let mut seen = 0.0;
    while seen < comments
        && let Some((number, comment)) = sheet.lines.next()?
    {
        if !comment.trim_start().starts_with('|') {
            return Err(asked
                .at(number, &format!("must be comment {} of {comments}, which begin with |", seen + 1.0)));
        }
        seen += 1.0;
    }
    let unit = asked.unit(Some((line, "cm/s^2")), Some(Kind::Acceleration))?;
    sheet.sink.begin(unit);
    let stated = format!("the number of samples = {count} of line {line}");
    sheet.fill((count, &stated), Some(10))?;
    sheet.ended(&stated)?;
    let magnitude = |(_, text): &(u64, String)| text::number::<f64>(text).map_or(0.0, f64::abs);
    let peaks = [known(&reals, 30), known(&reals, 32)].into_iter().flatten();
    let peak = peaks.max_by(|a, b| magnitude(a).total_cmp(&magnitude(b)));
    let component = text.iter().find_map(|(_, line)| text::after(line, "component"));
    Ok(Found {
        channel: component.map(|name| text::word(name).to_owned()).filter(|name| !name.is_empty()),
        stated: peak.map(|(line, text)| Stated { line, text, unit: None, of_mean: false }),
        notes,
        ..Found::new("SMC", Excitation::SurfaceAcceleration, Times::step("1", &rate))
    })
}
