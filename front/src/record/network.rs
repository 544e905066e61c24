//! Three channels in columns below lines of keys and values: UNAM of Mexico (Archivo Estándar de Aceleración) and AFAD of
//! Turkey (NSMN, until 2018).

use super::sheet::{Found, Sheet, Stated, Times};
use super::{Head, text};
use crate::inputs::units::{Kind, split};

pub(super) fn is_unam(head: &Head) -> bool {
    head.has("ARCHIVO ESTANDAR DE ACELERACION") || head.has("DATOS DE ACELERACION")
}

pub(super) fn is_afad(head: &Head) -> bool {
    head.first().contains("strong ground motion records of turk")
}

/// A value with its line.
type Value = Option<(u64, String)>;

/// What a layout says of its columns.
struct Columns {
    kind: &'static str,
    /// The names of a channel, the first of which is shown.
    names: Vec<Vec<String>>,
    /// The step of each channel.
    steps: Vec<String>,
    /// The number of samples of each channel, where it is stated.
    counts: Vec<String>,
    /// The peak of each channel.
    peaks: Vec<String>,
    /// The lines of these.
    lines: [u64; 3],
    unit: Value,
}

impl Columns {
    /// Reads the column of the channel that is wanted.
    fn read(self, sheet: &mut Sheet<'_>) -> Result<Found, String> {
        let asked = sheet.asked;
        asked.without_step()?;
        let mut wanted = Vec::new();
        for (place, names) in self.names.iter().enumerate() {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            wanted.extend(sheet.is_wanted(&names).then_some(place));
        }
        let place = sheet.one(wanted)?;
        let of = |all: &[String]| all.get(place).cloned().filter(|text| text::number::<f64>(text).is_some());
        let [step_line, count_line, peak_line] = self.lines;
        let step = of(&self.steps).filter(|step| text::number(step) > Some(0.0f64));
        let step =
            step.ok_or_else(|| asked.at(step_line.max(1), "must state the step of the channel, > 0"))?;
        let unit = self.unit.as_ref().map(|(line, unit)| (*line, unit.as_str()));
        let unit = asked.unit(unit, Some(Kind::Acceleration))?;
        let excitation = unit.excitation();
        sheet.sink.begin(unit);
        let columns = self.names.len();
        let mut has_ended = false;
        while let Some((number, line)) = sheet.lines.next()? {
            let mut cells = line.split_whitespace();
            let Some(first) = cells.clone().next() else { continue };
            if !text::begins_with_number(first) {
                has_ended = true;
                continue;
            }
            if has_ended {
                return Err(sheet.at(number, "must be words, because the samples end above it"));
            }
            if cells.clone().count() != columns {
                let many = cells.count();
                return Err(
                    sheet.at(number, &format!("{many} fields, must be {columns}, one of each channel"))
                );
            }
            let cell = cells.nth(place).unwrap_or_default();
            if !sheet.sink.sample(cell).map_err(|what| asked.at(number, &what))? {
                return Err(sheet.at(number, &format!("{cell}: must be a number")));
            }
        }
        let read = sheet.sink.len();
        if let Some(count) = of(&self.counts)
            && text::count(&count) != Some(read)
        {
            return Err(
                asked.at(count_line, &format!("{count} samples of the channel, but the file has {read}"))
            );
        }
        let stated = of(&self.peaks);
        Ok(Found {
            channel: self.names.get(place).and_then(|names| names.first().cloned()),
            stated: stated.map(|text| Stated { line: peak_line, text, unit: None, of_mean: false }),
            ..Found::new(self.kind, excitation, Times::step(&step, "1"))
        })
    }
}

/// The values of a key for each channel: `/0.02/0.02/0.02`.
fn each(value: &Value) -> (u64, Vec<String>) {
    value.as_ref().map_or((0, Vec::new()), |(line, text)| {
        let values = text.split('/').map(str::trim).filter(|text| !text.is_empty());
        (*line, values.map(str::to_owned).collect())
    })
}

/// UNAM: the step, the number of samples and the peak of each channel in the header, then a line of names above the samples.
pub(super) fn unam(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    const KEYS: [&str; 4] =
        ["INTERVALO DE MUESTREO, C1", "NUM. TOTAL DE MUESTRAS, C1", "ACEL. MAX.(Gal), C1", "UNIDADES"];
    let mut found: [Value; 4] = [const { None }; 4];
    let mut above: Vec<String> = Vec::new();
    let mut is_data = false;
    while let Some((number, line)) = sheet.lines.next()? {
        is_data |= line.starts_with("DATOS DE ACELERACION");
        if text::begins_with_number(&line) {
            if !is_data && text::numbers(&line, None).is_ok() {
                return Err(sheet.at(number, "numbers must be below DATOS DE ACELERACION"));
            }
            if is_data {
                sheet.lines.put_back((number, line));
                break;
            }
        }
        if is_data && !line.contains("---") && !line.contains(':') && !line.trim().is_empty() {
            above.push(line);
            continue;
        }
        for (key, value) in KEYS.iter().zip(&mut found) {
            if value.is_none()
                && line.starts_with(key)
                && let Some((_, rest)) = line.split_once(':')
            {
                *value = Some((number, rest.trim().to_owned()));
            }
        }
    }
    // CANAL-1 above V, N00E or N90E.
    let mut rows = above.iter().map(|line| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
    let channels = rows.next().unwrap_or_default();
    let own = rows.next().unwrap_or_default();
    let names = channels.iter().enumerate().map(|(place, channel)| {
        own.get(place).filter(|_| own.len() == channels.len()).into_iter().chain([channel]).cloned().collect()
    });
    let [step, count, peak, unit] = &found;
    let ((step_line, steps), (count_line, counts), (peak_line, peaks)) =
        (each(step), each(count), each(peak));
    let unit = unit.as_ref().map(|(line, unit)| (*line, text::word(unit).to_owned()));
    let lines = [step_line, count_line, peak_line];
    let names = names.collect();
    Columns { kind: "UNAM", names, steps, counts, peaks, lines, unit }.read(sheet)
}

/// AFAD: three columns N-S, E-W and U-D in gal.
pub(super) fn afad(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    let [mut step, mut count, mut peaks]: [Value; 3] = [const { None }; 3];
    let mut names = Vec::new();
    while let Some((number, line)) = sheet.lines.next()? {
        if text::begins_with_number(&line) {
            sheet.lines.put_back((number, line));
            break;
        }
        let small = line.to_lowercase();
        for (key, value) in
            [("sampling interval", &mut step), ("number of data", &mut count), ("raw pga values", &mut peaks)]
        {
            if small.starts_with(key)
                && let Some((_, rest)) = line.split_once(':')
            {
                *value = Some((number, rest.trim().to_owned()));
            }
        }
        if !line.trim().is_empty() && !line.contains(':') {
            // The last line without a colon has the names.
            names = line.split_whitespace().map(|name| vec![name.to_owned()]).collect();
        }
    }
    let columns = names.len();
    let all = |value: &Value| vec![value.as_ref().map_or("", |(_, text)| split(text).0).to_owned(); columns];
    // (N-S) 13.2 (E-W) 12.2 (U-D) 9.8
    let peak = |name: &Vec<String>| {
        let (_, text) = peaks.as_ref()?;
        let (_, rest) = text.split_once(&format!("({})", name.first()?))?;
        Some(split(rest).0.to_owned())
    };
    let line = |value: &Value| value.as_ref().map_or(0, |(line, _)| *line);
    let peak_texts = names.iter().map(|name| peak(name).unwrap_or_default()).collect();
    let lines = [line(&step), line(&count), line(&peaks)];
    let unit = Some((line(&peaks).max(1), "gal".to_owned()));
    let (steps, counts) = (all(&step), all(&count));
    Columns { kind: "AFAD", names, steps, counts, peaks: peak_texts, lines, unit }.read(sheet)
}
