//! A record from a file: of the PEER database, or CSV with units in its header.

mod text;

use crate::args::LoadArgs;
use crate::bits::Value;
use crate::failure::Failure;
use crate::progress;
use crate::rows;
use std::io::Read;
use std::path::Path;
use stickslip::inputs::units::{Kind, Reader};
use stickslip::motion::record::Record;

/// The greatest length of a file in bytes.
const LONGEST: u64 = 1 << 32;

/// Reads a record in the units of the reader, and scales and cuts it.
pub(crate) fn read<F: Value>(file: &Path, args: &LoadArgs, reader: &Reader) -> Result<Record<F>, Failure> {
    let name = file.display().to_string();
    let mut text = String::new();
    rows::open(file, &name)?.take(LONGEST).read_to_string(&mut text).map_err(|e| format!("{name}: {e}"))?;
    let time = |option: &str, text: &Option<String>| {
        text.as_ref().map(|text| reader.value::<F>(option, text, Kind::Time)).transpose()
    };
    let step = args.time_step.as_ref().map(|text| format!("--time-step {text}"));
    let step = time("--time-step", &args.time_step)?.zip(step.as_deref());
    let (mut record, unused) = text::read(&text, &name, reader, step, "by --time-step")?;
    if !unused.is_empty() {
        progress::note(&format!("{name}: columns not used: {}", unused.join(", ")));
    }
    if let Some(text) = &args.scale {
        let factor = crate::input::number::<F>("--scale", text)?;
        record = record.scaled(factor).map_err(|e| format!("--scale {text}: {e}"))?;
    }
    let (from, to) = (time("--from", &args.from)?, time("--to", &args.to)?);
    if from.is_some() || to.is_some() {
        let (first, last) = (record.time(0), record.end());
        let typed: Vec<String> = [("--from", &args.from), ("--to", &args.to)]
            .into_iter()
            .filter_map(|(option, text)| text.as_ref().map(|text| format!("{option} {text}")))
            .collect();
        record = record
            .between(from.unwrap_or(first), to.unwrap_or(last))
            .map_err(|e| format!("{}: {e}", typed.join(" ")))?;
    }
    Ok(record)
}
