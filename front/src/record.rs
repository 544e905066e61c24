//! The file of a record: of an agency, or columns of numbers. Its layout is found by its content, not by its name.
//!
//! `LAYOUTS` lists them.
//!
//! The text is read line by line: memory holds the samples and one line.

mod accelerogram;
mod as_table;
mod cosmos;
mod describe;
mod geonet;
mod hint;
mod keyed;
mod lines;
mod network;
mod options;
mod peer;
mod plain;
mod process;
mod reading;
mod sac;
mod samples;
mod series;
mod sheet;
mod smc;
mod table;
mod text;
mod unit;

use as_table::{as_table, read_as_table};
pub use describe::{Channel, describe, gaps, peak_frequency};
use lines::Lines;
pub use options::{Options, Words, is_sensitivity};
use reading::Head;
pub use reading::{Reading, Summary, comes_to, follows};
use samples::Samples;
use sheet::{Found, Sheet};
use std::io::{BufRead, Read};
use std::str::FromStr;
use stickslip::Float;
use unit::{Ratio, Unit};

/// A layout: how it is known, and how it is read.
struct Layout {
    is: fn(&Head) -> bool,
    read: fn(&mut Sheet<'_>) -> Result<Found, String>,
}

/// The layouts in the order in which they are tried. A text that is none of them is a table.
const LAYOUTS: [Layout; 15] = [
    Layout { is: sac::is_binary, read: sac::binary },
    Layout { is: series::is_mini_seed, read: series::mini_seed },
    Layout { is: cosmos::is, read: cosmos::read },
    Layout { is: geonet::is, read: geonet::read },
    Layout { is: smc::is, read: smc::read },
    Layout { is: accelerogram::is, read: accelerogram::read },
    Layout { is: |head| head.has("Scale Factor") && head.has("Sampling Freq"), read: keyed::knet },
    Layout { is: |head| head.has("SAMPLING_INTERVAL_S"), read: keyed::esm },
    Layout { is: |head| head.has("#DataSequence"), read: keyed::cwb },
    Layout { is: network::is_unam, read: network::unam },
    Layout { is: network::is_afad, read: network::afad },
    Layout { is: series::is, read: series::read },
    Layout { is: sac::is_text, read: sac::text },
    Layout { is: |head| peer::header(&head.lines).is_some(), read: peer::read },
    // Known by a few numbers only.
    Layout { is: plain::is, read: plain::read },
];

/// Reads a record.
///
/// # Errors
/// One line that names the file, the line and the value: where the text is in none of the layouts, a unit is unknown, a
/// value is no number, the number of samples differs from the one stated, a time is before that of the line above, or
/// the text is longer than memory shall hold.
pub fn read<F: Float + FromStr>(source: impl BufRead, options: &Options<'_>) -> Result<Reading<F>, String> {
    let mut samples = Samples::<F>::new(options.reader);
    let found = found(source, options, &mut samples, &mut Vec::new())?;
    samples.finish(found, options)
}

/// Reads the samples by the layout of the file, and lists its channels where it has several.
fn found(
    mut source: impl BufRead,
    options: &Options<'_>,
    sink: &mut dyn sheet::Sink,
    channels: &mut Vec<String>,
) -> Result<Found, String> {
    let mut bytes = Vec::new();
    let begin = Read::take(&mut source, sac::HEADER as u64).read_to_end(&mut bytes);
    begin.map_err(|error| format!("{}: {error}", options.name))?;
    let mut whole = bytes.as_slice().chain(source);
    let lines = Lines::new(&mut whole, options.name);
    let mut sheet = Sheet { lines, asked: options, sink, channels: Vec::new() };
    let has_text = options.skip == 0 && !bytes.contains(&0);
    let lines = if has_text { sheet.lines.head(HEAD)? } else { Vec::new() };
    let head = Head { bytes: bytes.clone(), lines };
    let layout = LAYOUTS.iter().find(|layout| options.skip == 0 && (layout.is)(&head));
    let found = match (layout, hint::binary(&bytes)) {
        (Some(layout), _) => (layout.read)(&mut sheet),
        (None, Some(what)) => Err(format!("{}: is {what}", options.name)),
        (None, None) => as_table(&mut sheet).map_err(|error| hint::led(error, &head, options)),
    };
    channels.append(&mut sheet.channels);
    found
}

/// The lines in which a layout is known.
const HEAD: usize = 128;
