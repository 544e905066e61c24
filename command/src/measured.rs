//! A record from a file, of an agency or of columns, scaled and cut.

use crate::args::LoadArgs;
use crate::bits::{Value, digits};
use crate::failure::Failure;
use crate::progress;
use crate::rows;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::BufReader;
use std::path::Path;
use stickslip::motion::record::Record;
use stickslip_front::inputs::units::Reader;
use stickslip_front::record::{self, Options, Summary, Words};
use stickslip_front::text::printable;

/// The options of the reader.
pub(crate) fn options<'a>(args: &'a LoadArgs, name: &'a str, reader: &'a Reader) -> Options<'a> {
    // A scale with a unit is a sensitivity, which the reader uses.
    let scale = args.scale.as_deref().filter(|text| record::is_sensitivity(text));
    Options {
        time_step: args.time_step.as_deref(),
        time_column: args.time_column.as_deref(),
        column: args.column.as_deref(),
        skip: args.skip,
        units: args.record_units.as_deref(),
        scale,
        from: args.from.as_deref(),
        to: args.to.as_deref(),
        remove_mean: args.remove_mean.as_deref(),
        resample: args.resample.as_deref(),
        ..Options::new(name, reader, Words::COMMAND)
    }
}

/// Reads a record in the units of the reader, cuts it and scales it. The summary is of the cut, before it is scaled.
pub(crate) fn read<F: Value>(
    file: &Path,
    args: &LoadArgs,
    reader: &Reader,
) -> Result<(Record<F>, Summary), Failure> {
    let name = file.display().to_string();
    let options = options(args, &name, reader);
    let scale = options.scale;
    let found = record::read::<F>(BufReader::new(rows::open(file, &name)?), &options)?;
    let (mut record, summary) = (found.record, found.summary);
    if !found.unused.is_empty() {
        progress::note(&format!("{name}: columns not used: {}", found.unused.join(", ")));
    }
    if let Some(text) = args.scale.as_ref().filter(|_| scale.is_none()) {
        let factor = crate::input::number::<F>("--scale", text)?;
        record = record.scaled(factor).map_err(|e| format!("--scale {text}: {e}"))?;
    }
    if let Some(after) = args.after {
        record = record.followed_by(after.into());
    }
    Ok((record, summary))
}

/// What was read of a file, in a line.
pub(crate) fn line(summary: &Summary) -> String {
    // The name of a channel is the file's.
    printable(&summary.sentence(digits)).into_owned()
}

/// What was read of a file and what follows it, in two lines.
pub(crate) fn lines<F: Value>(summary: &Summary, record: &Record<F>) -> String {
    format!("{}\n{}", line(summary), record::follows(record))
}

/// An answer in JSON, and what was read of its file under the key `record`.
#[derive(Debug, serde::Serialize)]
pub(crate) struct Described<'a, A: Serialize> {
    #[serde(flatten)]
    answer: &'a A,
    record: Fields<'a>,
}

impl<'a, A: Serialize> Described<'a, A> {
    pub(crate) fn new<F: Value>(answer: &'a A, summary: &'a Summary, record: &Record<F>) -> Self {
        Self { answer, record: Fields(summary, record.after().name()) }
    }

    /// Of a record that repeats itself.
    pub(crate) const fn repeated(answer: &'a A, summary: &'a Summary) -> Self {
        Self { answer, record: Fields(summary, "repeats") }
    }
}

/// The fields of a summary, and what follows the record.
#[derive(Debug)]
pub(crate) struct Fields<'a>(pub(crate) &'a Summary, pub(crate) &'static str);

impl Serialize for Fields<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Summary {
            kind,
            channel,
            quantity,
            samples,
            time_step,
            steps: _,
            duration,
            peak,
            peak_at,
            mean,
            unit,
            notes,
        } = self.0;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("kind", kind)?;
        map.serialize_entry("channel", channel)?;
        map.serialize_entry("quantity", quantity)?;
        map.serialize_entry("samples", samples)?;
        map.serialize_entry("time_step", time_step)?;
        map.serialize_entry("duration", duration)?;
        map.serialize_entry("peak", peak)?;
        map.serialize_entry("peak_at", peak_at)?;
        map.serialize_entry("mean", mean)?;
        map.serialize_entry("unit", unit)?;
        map.serialize_entry("notes", notes)?;
        map.serialize_entry("after", self.1)?;
        map.end()
    }
}
