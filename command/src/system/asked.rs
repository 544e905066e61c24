//! What a question of doubles and one of more bits share: the system, the samples, and their rows.

use super::options::{folder, note_of_units, path_and_value};
use super::table::key;
use super::words::shown;
use crate::args::{Format, Header, LoadArgs, StreamFormat, SystemArgs, SystemQuestion};
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::output::{self, PendingFile};
use crate::row::{Cell, Number as Shown, Row};
use crate::sink::Sink;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use stickslip::motion::record::Record;
use stickslip::system::State;
use stickslip_front::record::Summary;
use stickslip_front::system::{Described, NamedSystem, Number, Samples, Why};

/// The memory of the samples of a motion in bytes.
const MEMORY: u64 = 200_000_000;

/// Whether the answer is a row for each place of a grid.
pub(super) fn is_table(args: &SystemArgs) -> bool {
    let is_grid = args.set.iter().any(|text| text.contains([':', ',']));
    matches!(args.question, SystemQuestion::Curve | SystemQuestion::Spectrum)
        || is_grid
        || args.records.len() > 1
}

/// A record, and what was read of its file.
pub(super) type Shaking = (Summary, Record<f64>);

/// The system of a value with the values of `--set`, and with a record, if there is one.
pub(super) fn named(
    value: &Value,
    records: &[PathBuf],
    args: &SystemArgs,
) -> Result<(NamedSystem, Option<Shaking>), Failure> {
    let set = args.set.iter().map(|text| path_and_value(text)).collect::<Result<Vec<_>, _>>()?;
    let about = |e: String| Failure::Input(format!("{}: {e}", args.file.display()));
    let found = NamedSystem::new(value, set, folder(args), args.units.units.as_ref()).map_err(about)?;
    let mut found = found;
    if let Some(names) = &args.coordinates {
        found.described.show("--coordinates", names)?;
    }
    let (found, read) = match records.first() {
        Some(file) => {
            let (record, summary) =
                crate::measured::read::<f64>(file, &LoadArgs::default(), &found.reader())?;
            note_of_units(found.described.units.as_ref(), &file.display().to_string());
            (found.with_record(&record, &file.display().to_string())?, Some((summary, record)))
        }
        None => (found, None),
    };
    Ok((found.while_allowed(interrupt::keep_going), read))
}

/// The times of the samples that are asked for, from 0 on.
pub(super) fn samples<F: Number>(
    described: &Described,
    args: &SystemArgs,
    until: F,
) -> Result<Option<Vec<F>>, Failure> {
    let Some(text) = &args.samples else { return Ok(None) };
    // Five lists of a state with what they take beside their numbers, which are four for each coordinate and one for each element.
    let numbers = 4 * described.coordinates.len() + described.model.elements.len();
    let each = size_of::<F>() as u64 * numbers as u64;
    let count = crate::input::count("--samples", text, MEMORY / (300 + each))?;
    let part = |i: u64| F::from_f64(i as f64) / F::from_f64(count as f64);
    Ok(Some((0..=count).map(|i| until * part(i)).collect()))
}

pub(super) fn until_in_words(described: &Described, until: &Shown, out: &mut impl Write) -> Outcome {
    let seconds = if described.units.is_some() { " s" } else { "" };
    Ok(writeln!(out, "The motion from the start to {}{seconds}.", until.digits())?)
}

/// States at times, as CSV or JSON.
pub(super) fn sampled<F: crate::bits::Value>(
    described: &Described,
    args: &SystemArgs,
    times: &[F],
    states: &[State<F>],
    out: &mut impl Write,
) -> Outcome {
    let format = match (args.format, args.out.as_deref().and_then(Path::extension)) {
        (Some(Format::Json), Some(end)) if end != "json" => {
            return Err("--format json: the name of --out must end in .json".into());
        }
        (Some(Format::Json), _) => None,
        (None, Some(end)) if end == "parquet" => Some(StreamFormat::Parquet),
        (Some(Format::Csv) | None, _) => Some(StreamFormat::Csv),
        (Some(Format::Text | Format::Jsonl), _) => {
            return Err("--format: must be csv or json with --samples".into());
        }
    };
    let times: Vec<_> = times.iter().map(shown).collect();
    let states: Vec<_> = states.iter().map(|state| state.map(&shown)).collect();
    let samples = Samples::new(described, &times, &states);
    let is_wide = F::PRECISION > f64::MANTISSA_DIGITS;
    let write = |mut out: &mut dyn Write| -> Outcome {
        let Some(format) = format else {
            return output::json(&samples, &mut out);
        };
        let keys: Vec<_> = samples.names().into_iter().map(key).collect();
        let mut sink = Sink::new(format, out, Header::Names)?;
        for row in samples.rows() {
            let cells = row.into_iter().map(|x| Cell::Number(Some(x)));
            let row = keys.iter().copied().zip(cells).collect();
            sink.write(&Row::of_numbers(row, is_wide))?;
        }
        sink.finish()
    };
    match &args.out {
        Some(file) => {
            let argument = format!("--out {}", file.display());
            PendingFile::create(file, &argument, args.overwrite)?.fill(|out| write(out))
        }
        None => write(out),
    }
}

/// An error of the engine, with the name of the file.
pub(super) fn of_file(args: &SystemArgs, error: Why) -> Failure {
    Failure::from(error).about(&args.file.display().to_string())
}
