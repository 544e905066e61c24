//! Steady motions over a frequency and over grids of values in the file, a row each.

use super::Asked;
use super::file::parsed;
use crate::args::{Format, SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output;
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::inputs::units::{Kind as Of, split};

/// The most rows.
const MOST: u64 = 1_000_000;
/// Rows that are computed before they are written.
const BATCH: u64 = 256;

/// One value that changes from row to row.
struct Axis {
    /// The path in the file; `None` for the frequency of the loads.
    path: Option<String>,
    values: Vec<String>,
}

/// `FROM:TO:COUNT` or `FROM:TO:COUNT:log` with one unit, as the text of each value.
fn values(name: &str, text: &str) -> Result<Vec<String>, Failure> {
    let bad = |what: &str| Failure::Input(format!("{name} {text}: {what}"));
    let parts: Vec<&str> = text.split(':').collect();
    let (from, to, count, is_logarithmic) = match parts.as_slice() {
        [one] => return Ok(vec![(*one).to_owned()]),
        [from, to, count] => (*from, *to, *count, false),
        [from, to, count, "log"] => (*from, *to, *count, true),
        _ => return Err(bad("must be one value, FROM:TO:COUNT or FROM:TO:COUNT:log")),
    };
    let count = crate::input::count(&format!("{name} {text}: count"), count, MOST)?;
    let ((first, unit), (last, other)) = (split(from), split(to));
    if unit != other {
        return Err(bad("both ends must have the same unit"));
    }
    let number = |text: &str| text.parse::<f64>().ok().filter(|x| x.is_finite());
    let (Some(first), Some(last)) = (number(first), number(last)) else {
        return Err(bad("both ends must be finite numbers"));
    };
    if is_logarithmic && !(first > 0.0 && last > 0.0) {
        return Err(bad("both ends must be > 0 for equal ratios"));
    }
    if count == 1 && first != last {
        return Err(bad("the count must be ≥ 2 where the ends differ"));
    }
    let value = |i: u64| {
        let share = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.0 };
        match i {
            0 => first,
            _ if i + 1 == count => last,
            _ if is_logarithmic => first * (last / first).powf(share),
            // A decimal step gives decimal values.
            _ => decimal(first + (last - first) * share, last.abs().max(first.abs())),
        }
    };
    Ok((0..count).map(|i| format!("{}{unit}", value(i))).collect())
}

/// The number without the digits that rounding has left, at the size of the ends.
fn decimal(x: f64, size: f64) -> f64 {
    let short: f64 = format!("{x:.*e}", 13).parse().unwrap_or(x);
    if (short - x).abs() <= 4.0 * f64::EPSILON * size { short } else { x }
}

/// The rows of a table: one steady motion for each place of the grid, the first axis slowest.
pub(super) fn run(args: &SystemArgs, out: &mut impl Write) -> Outcome {
    if !matches!(args.question, SystemQuestion::Curve | SystemQuestion::Steady) {
        let text = "a grid of values belongs to the questions steady and curve";
        return Err(format!("--set: {text}").into());
    }
    let file = parsed(&args.file)?;
    let mut axes = Vec::new();
    for text in &args.set {
        let (path, new) = text.split_once('=').ok_or_else(|| format!("--set {text}: must be PATH=VALUE"))?;
        axes.push(Axis { path: Some(path.to_owned()), values: values(&format!("--set {path}="), new)? });
    }
    if let Some(text) = &args.frequency {
        axes.push(Axis { path: None, values: values("--frequency", text)? });
    }
    let count = axes.iter().try_fold(1u64, |n, axis| n.checked_mul(axis.values.len() as u64));
    let count = count.filter(|n| *n <= MOST).ok_or_else(|| format!("the grid must have ≤ {MOST} rows"))?;
    let row = |i: u64| row(&file, args, &axes, i);
    // The first row says what the columns are, and what is wrong with the file.
    let first = row(0)?;
    let is_json = match args.format {
        None | Some(Format::Csv) => false,
        Some(Format::Json | Format::Jsonl) => true,
        Some(Format::Text) => return Err("--format text: a table is csv, json or jsonl".into()),
    };
    let mut csv = csv::Writer::from_writer(Vec::new());
    if !is_json {
        csv.write_record(first.keys())?;
    }
    let mut all = Vec::new();
    let mut begin = 0;
    while begin < count {
        let end = (begin + BATCH).min(count);
        let rows: Vec<_> = (begin..end).into_par_iter().map(row).collect();
        interrupt::check()?;
        for (i, row) in (begin..end).zip(rows) {
            let row = row.map_err(|e| e.about(&format!("row {}", i + 1)))?;
            if !is_json {
                csv.write_record(row.values().map(plain))?;
            } else if args.format == Some(Format::Jsonl) {
                writeln!(out, "{}", Value::Object(row))?;
            } else {
                all.push(Value::Object(row));
            }
        }
        begin = end;
    }
    if args.format == Some(Format::Json) {
        return output::json(&all, out);
    }
    Ok(out.write_all(&csv.into_inner().map_err(|e| Failure::Input(e.to_string()))?)?)
}

/// A value as a cell of CSV.
fn plain(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Bool(_) | Value::Number(_) | Value::Array(_) | Value::Object(_) => value.to_string(),
    }
}

fn row(file: &Value, args: &SystemArgs, axes: &[Axis], place: u64) -> Result<Map<String, Value>, Failure> {
    let mut left = place as usize;
    let mut chosen: Vec<(&Axis, &str)> = Vec::new();
    for axis in axes.iter().rev() {
        let at = left % axis.values.len().max(1);
        left /= axis.values.len().max(1);
        chosen.push((axis, axis.values.get(at).map_or("", String::as_str)));
    }
    chosen.reverse();
    let set: Vec<String> =
        chosen.iter().filter_map(|(axis, text)| Some(format!("{}={text}", axis.path.as_ref()?))).collect();
    let mut asked = Asked::of(file, args, &set)?;
    let mut row = Map::new();
    for (axis, text) in &chosen {
        match &axis.path {
            Some(path) => {
                row.insert(path.clone(), text.parse::<f64>().map_or_else(|_| json!(text), |x| json!(x)));
            }
            None => {
                let reader = asked.reader();
                let frequency: f64 = reader.value("--frequency", text, Of::Frequency)?;
                asked.at_frequency(frequency)?;
                let (name, value) = match asked.described.units {
                    Some(_) => ("frequency[Hz]", frequency / TAU),
                    None => ("frequency", frequency),
                };
                row.insert(name.to_owned(), json!(value));
            }
        }
    }
    let found = asked.system.steady(&asked.described.start)?;
    row.insert("kind".to_owned(), json!(found.kind.name()));
    row.insert("periods".to_owned(), json!(found.periods));
    let unit = |kind: Of| {
        asked.described.units.map_or_else(String::new, |system| format!("[{}]", system.name(kind)))
    };
    let motion = &found.motion;
    for (i, name) in asked.described.coordinates.iter().enumerate() {
        for (quantity, list, kind) in [
            ("max_displacement", &motion.max_displacement, Of::Length),
            ("min_displacement", &motion.min_displacement, Of::Length),
            ("max_velocity", &motion.max_velocity, Of::Velocity),
            ("min_velocity", &motion.min_velocity, Of::Velocity),
        ] {
            row.insert(format!("{name}.{quantity}{}", unit(kind)), json!(list.get(i)));
        }
    }
    for element in &motion.elements {
        let name = &element.name;
        row.insert(format!("{name}.rest_fraction"), json!(element.time_at_rest / motion.duration));
        row.insert(format!("{name}.stops"), json!(element.stops));
        row.insert(format!("{name}.work{}", unit(Of::Energy)), json!(element.work));
    }
    Ok(row)
}
