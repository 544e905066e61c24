//! Records of the PEER database, in every form of its header since 1999.

use super::lines::Line;
use super::sheet::{Found, Sheet, Times};
use super::text;
use super::unit::Ratio;
use crate::inputs::units::{Kind, split};

/// The lines among which the one with the number of samples is.
const LINES: usize = 12;

/// The places of the lines of a header: the one with the unit, and the one with the number of samples.
pub(super) struct Header {
    unit: Option<Line>,
    count: Option<Line>,
    /// The number of the line that should state the number of samples.
    due: u64,
}

/// The header, where the lines are those of a record of the PEER database.
pub(super) fn header(head: &[Line]) -> Option<Header> {
    let find = |wanted: &dyn Fn(&str) -> bool| {
        let mut lines = head.iter().take(LINES);
        lines.find(|(_, text)| wanted(&text.to_ascii_uppercase())).cloned()
    };
    let unit = find(&|text| {
        text.contains("UNITS OF")
            || ((text.contains("TIME SERIES") || text.contains("TIME HISTORY"))
                && QUANTITIES.iter().any(|name| text.contains(name)))
    });
    let count = find(&|text| text.contains("NPTS"));
    if count.is_none() && unit.is_none() {
        return None;
    }
    let due = unit.as_ref().map_or(1, |(number, _)| number.saturating_add(1));
    Some(Header { unit, count, due })
}

/// What a file may hold.
const QUANTITIES: [&str; 3] = ["ACCELERATION", "VELOCITY", "DISPLACEMENT"];

/// The number of samples, and the step with its unit.
fn count_and_step(line: &str) -> Option<(usize, &str, &str)> {
    let count = |text: &str| text.parse::<usize>().ok().filter(|count| *count > 0);
    // Older files state the numbers first: 4000 0.005 NPTS, DT.
    let mut words = line.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
    let (first, second) = (words.next()?, words.next()?);
    if let Some(count) = count(first) {
        return Some((count, second, ""));
    }
    let points = text::after(line, "NPTS")?;
    let end = points.find(|c: char| !c.is_ascii_digit()).unwrap_or(points.len());
    let points = count(points.get(..end)?)?;
    let rest = after_dt(line)?;
    // The unit may stand before the number, as in DT (SEC)= .01.
    let (before, rest) = match rest.strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        Some((unit, rest)) => {
            (unit, rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '=' | ':')))
        }
        None => ("", rest),
    };
    let (digits, rest) = split(rest);
    let end = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
    let after = rest.get(..end).unwrap_or_default();
    Some((points, digits, if before.is_empty() { after } else { before }))
}

/// The text after the word DT.
fn after_dt(line: &str) -> Option<&str> {
    let upper = line.to_ascii_uppercase();
    let bytes = upper.as_bytes();
    let is_letter =
        |place: Option<usize>| place.and_then(|place| bytes.get(place)).is_some_and(u8::is_ascii_alphabetic);
    let (place, _) = upper
        .match_indices("DT")
        .find(|(place, _)| !is_letter(place.checked_sub(1)) && !is_letter(place.checked_add(2)))?;
    let rest = line.get(place.checked_add(2)?..)?;
    Some(rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '=' | ':')))
}

pub(super) fn read(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let asked = sheet.asked;
    asked.without_step()?;
    let head = sheet.lines.head(LINES)?;
    let header = header(&head).unwrap_or(Header { unit: None, count: None, due: 1 });
    let due = "must state the number of samples and the step: NPTS= 4000, DT= .005 SEC";
    let (at, line) = header.count.as_ref().ok_or_else(|| asked.at(header.due, due))?;
    let (count, step, unit) = count_and_step(line).ok_or_else(|| asked.at(*at, due))?;
    text::number::<f64>(step)
        .filter(|step| *step > 0.0)
        .ok_or_else(|| asked.at(*at, &format!("DT = {step}: must be a number > 0, of seconds: {due}")))?;
    let factor = match unit.to_ascii_lowercase().as_str() {
        "" | "s" | "sec" | "secs" | "second" | "seconds" => None,
        other => {
            let unit = if other == "msec" { "ms" } else { other };
            let named = format!("{} line {at}: DT", asked.name);
            Some(asked.reader.factor_of_column(&named, unit, Kind::Time)?)
        }
    };
    let stated = header.unit.as_ref().and_then(|(line, text)| {
        let unit = text::after(text, "UNITS OF")?;
        let end = unit.find(|c: char| c.is_whitespace() || c == ',').unwrap_or(unit.len());
        Some((*line, unit.get(..end)?)).filter(|(_, unit)| !unit.is_empty())
    });
    if let Some((line, text)) = &header.unit {
        let upper = text.to_ascii_uppercase();
        // The first of the names is what the file holds.
        let quantity = QUANTITIES.iter().filter_map(|name| Some((upper.find(name)?, *name))).min();
        if let Some((_, name)) = quantity.filter(|(_, name)| *name != "ACCELERATION") {
            return Err(asked.at(*line, &format!("{name}: must be an acceleration")));
        }
    }
    let unit = asked.unit(stated, Some(Kind::Acceleration))?;
    while let Some((number, _)) = sheet.lines.next()? {
        if number == *at {
            break;
        }
    }
    let stated = format!("NPTS = {count}");
    let excitation = unit.excitation();
    sheet.sink.begin(unit);
    sheet.fill((count, &stated), None)?;
    sheet.ended(&stated)?;
    let times = Times::Step(Ratio::new(step, "1"), factor, "0".to_owned());
    Ok(Found::new("PEER", excitation, times))
}

#[cfg(test)]
mod tests {
    use super::count_and_step;

    #[test]
    fn every_form_of_the_number_of_samples_and_the_step() {
        for (line, found) in [
            ("NPTS=  4000, DT=   .0050 SEC", Some((4000, ".0050", "SEC"))),
            ("NPTS=  1215, dt=  .02000", Some((1215, ".02000", ""))),
            ("37500    0.0040    NPTS, DT", Some((37500, "0.0040", ""))),
            ("  400  0.0200   NPTS, DT", Some((400, "0.0200", ""))),
            ("NPTS= 8, DT= .01SEC", Some((8, ".01", "SEC"))),
            ("NPTS= 8, DT=10MSEC", Some((8, "10", "MSEC"))),
            ("NPTS= 8, DT= 10 MSEC", Some((8, "10", "MSEC"))),
            ("NPTS= 8, DT (SEC)= .01", Some((8, ".01", "SEC"))),
            ("NPTS=4000,DT=.005SEC,", Some((4000, ".005", "SEC"))),
            ("NPTS= 8, DT= ,01 SEC", Some((8, "", ""))),
            ("NPTS= 8", None),
            ("NPTS= x, DT= .01", None),
            ("NPTS= 0, DT= .01", None),
        ] {
            let found_here = count_and_step(line);
            let found_here =
                found_here.map(|(n, step, unit)| (n, step, if step.is_empty() { "" } else { unit }));
            assert_eq!(found_here, found, "{line}");
        }
    }
}
