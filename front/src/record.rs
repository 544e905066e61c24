//! The file of a record: of an agency, or columns of numbers. Its layout is found by its content, not by its name.
//!
//! `LAYOUTS` lists them.
//!
//! The text is read line by line: memory holds the samples and one line.

mod accelerogram;
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
mod sac;
mod samples;
mod series;
mod sheet;
mod smc;
mod table;
mod text;
mod unit;

pub use describe::{Channel, describe, gaps, peak_frequency};
use lines::{Line, Lines};
pub use options::{Options, Words, is_sensitivity};
use samples::Samples;
use sheet::{Found, Sheet};
use std::io::{BufRead, Read};
use std::str::FromStr;
use stickslip::motion::record::{After, Record, RecordAnswer};
use stickslip::{Excitation, Float};
use unit::{Ratio, Unit};

/// A record, and the description of its file.
#[derive(Debug, Clone)]
pub struct Reading<F> {
    /// The record, in the system of the reader.
    pub record: Record<F>,
    /// What was read.
    pub summary: Summary,
    /// The names of the columns that are not used.
    pub unused: Vec<String>,
}

/// What was read of a file, of the part that was wanted: before it is scaled, in the unit of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The layout, such as `PEER`, `K-NET`, `SMC` or `columns`.
    pub kind: &'static str,
    /// The channel or the name of the column, where the file states it.
    pub channel: Option<String>,
    /// The quantity of the samples: `acceleration`, `force` or `foot displacement`.
    pub quantity: &'static str,
    /// The number of samples.
    pub samples: usize,
    /// The step in s, where all steps are equal.
    pub time_step: Option<f64>,
    /// The shortest and the longest step in s.
    pub steps: [f64; 2],
    /// The time from the first sample to the last one, in s.
    pub duration: f64,
    /// The sample of greatest magnitude.
    pub peak: f64,
    /// Its time in s.
    pub peak_at: f64,
    /// The mean over time of the straight lines between the samples.
    pub mean: f64,
    /// The unit of the peak and of the mean.
    pub unit: String,
    /// What else is to be known, in sentences: what was done with the samples, and where the header disagrees with them.
    pub notes: Vec<String>,
}

impl Summary {
    /// The summary in one sentence, with numbers written by `number`.
    pub fn sentence(&self, number: impl Fn(f64) -> String) -> String {
        let Self { kind, samples, unit, steps: [least, most], .. } = self;
        // The field has the name of the column, which sentences do not use.
        let quantity = self.quantity.replace("foot", "support");
        let channel = self.channel.as_ref().map_or(String::new(), |channel| format!(" “{channel}”"));
        let unequal = || format!("at unequal steps of {} s to {} s", number(*least), number(*most));
        let step = self.time_step.map_or_else(unequal, |step| format!("{} s apart", number(step)));
        let notes: String = self.notes.iter().map(|note| format!(" {note}")).collect();
        format!(
            "Record ({kind}{channel}): {samples} samples of {quantity} {step}, {} s; peak {} {unit} at {} s, mean {} {unit}.{notes}",
            number(self.duration),
            number(self.peak),
            number(self.peak_at),
            number(self.mean)
        )
    }
}

/// How a motion that has a residual displacement ends there.
#[must_use]
pub const fn comes_to<F>(answer: &RecordAnswer<F>) -> &'static str {
    if answer.tends_to_rest { "only tends to" } else { "comes to" }
}

/// What follows a record, in one sentence.
#[must_use]
pub fn follows<F: Float>(record: &Record<F>) -> &'static str {
    match (record.after(), record.excitation()) {
        (After::Hold, excitation) if excitation.moves_foot() => {
            "After the record the support stays where it is."
        }
        (After::Zero, excitation) if excitation.moves_foot() => "After the record the support is at 0.",
        (After::Free, excitation) if excitation.moves_foot() => "After the record the support lets go.",
        (After::Hold, Excitation::Force) => "After the record the force stays at its last sample.",
        (After::Hold, _) => "After the record the acceleration stays at its last sample.",
        (_, Excitation::Force) => "After the record the force is zero.",
        _ => "After the record the acceleration is zero.",
    }
}

/// What is seen of a file before its layout is known.
struct Head {
    /// The first bytes, of which there are as many as a header of SAC has.
    bytes: Vec<u8>,
    /// The first lines of a text; none of a binary file.
    lines: Vec<Line>,
}

impl Head {
    /// Whether a line begins with this text.
    fn has(&self, part: &str) -> bool {
        self.lines.iter().any(|(_, text)| text.starts_with(part))
    }

    /// The first line, in small letters.
    fn first(&self) -> String {
        self.lines.first().map(|(_, text)| text.to_lowercase()).unwrap_or_default()
    }
}

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

/// Reads a table below the lines that are left out.
fn as_table(sheet: &mut Sheet<'_>) -> Result<Found, String> {
    for _ in 0..sheet.asked.skip {
        if sheet.lines.next()?.is_none() {
            break;
        }
    }
    table::read(sheet, table::Known::default())
}

/// Reads a text as a table.
fn read_as_table(
    text: &mut dyn BufRead,
    options: &Options<'_>,
    sink: &mut dyn sheet::Sink,
) -> Result<Found, String> {
    as_table(&mut Sheet { lines: Lines::new(text, options.name), asked: options, sink, channels: Vec::new() })
}

/// The lines in which a layout is known.
const HEAD: usize = 128;
