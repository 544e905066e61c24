//! The file of a record: of an agency, or columns of numbers. Its layout is found by its content, not by its name.
//!
//! | layout | found by |
//! |---|---|
//! | COSMOS V1 and V2 | `(Format v01.20 with 13 text lines)` in the first line |
//! | GeoNet V1A and V2A | `corrected accelerogram` in the first line, and `Component` |
//! | K-NET and KiK-net | `Scale Factor` and `Sampling Freq(Hz)` |
//! | ESM and DYNA | `SAMPLING_INTERVAL_S:` |
//! | CWB | `#DataSequence:` |
//! | PEER, since 1999 | `NPTS`, or `TIME SERIES` and `TIME HISTORY` in `UNITS OF` |
//! | columns | any other text |
//!
//! The text is read line by line: memory holds the samples and one line.

mod cosmos;
mod geonet;
mod keyed;
mod lines;
mod peer;
mod samples;
mod table;
mod text;

use lines::Lines;
use std::io::BufRead;
use std::str::FromStr;
use stickslip::inputs::units::{Factor, Kind, Reader};
use stickslip::motion::record::{After, Record, RecordAnswer};
use stickslip::{Excitation, Float};

/// The names that a front has for the options of the reader, for its messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Words {
    /// The time between samples.
    pub time_step: &'static str,
    /// The column or the channel.
    pub column: &'static str,
    /// The unit of the samples.
    pub units: &'static str,
}

impl Words {
    /// The options of the command.
    pub const COMMAND: Self = Self { time_step: "--time-step", column: "--column", units: "--record-units" };
    /// The arguments of `Record.read` in Python.
    pub const PYTHON: Self = Self { time_step: "time_step", column: "column", units: "record_units" };
    /// The fields of the page.
    pub const PAGE: Self =
        Self { time_step: "the field Time step", column: "the field Column", units: "the field Unit" };
}

/// What is known of a file beside its text.
#[derive(Debug, Clone, Copy)]
pub struct Options<'a, F> {
    /// The name of the file in messages.
    pub name: &'a str,
    /// The reader of values, whose system of units is that of the record.
    pub reader: &'a Reader,
    /// The time between samples, where the file does not state it, in s.
    pub time_step: Option<F>,
    /// The column by its name or its number from 1, or the channel; `all` reads every number of a text without
    /// names, row by row.
    pub column: Option<&'a str>,
    /// The lines before the columns that are left out. The text is then one of columns.
    pub skip: u64,
    /// The unit of the samples, where the file does not state it.
    pub units: Option<&'a str>,
    /// The part of the record that is wanted, if it is not all of it.
    pub cut: Option<Cut<'a, F>>,
    /// The names of these options.
    pub words: Words,
}

/// A part of a record: the samples within two times, both included.
#[derive(Debug, Clone, Copy)]
pub struct Cut<'a, F> {
    /// The time at which it begins, in s; that of the first sample by default.
    pub from: Option<F>,
    /// The time at which it ends, in s; that of the last sample by default.
    pub to: Option<F>,
    /// Both as they were given, for messages.
    pub typed: &'a str,
}

impl<'a, F> Options<'a, F> {
    /// A file of this name, which states everything by itself.
    pub const fn new(name: &'a str, reader: &'a Reader, words: Words) -> Self {
        Self { name, reader, time_step: None, column: None, skip: 0, units: None, cut: None, words }
    }

    /// An error at a line.
    fn at(&self, line: u64, what: &str) -> String {
        format!("{} line {line}: {what}", self.name)
    }

    /// The kind and the factor of the samples, from the unit that the file states in a line or else from the option.
    fn unit(&self, stated: Option<(u64, &str)>) -> Result<Unit, String> {
        match (stated, self.units) {
            (Some((line, _)), Some(typed)) => Err(format!(
                "{} {typed}: must be left out, because {} states its own unit in line {line}",
                self.words.units, self.name
            )),
            (None, None) => {
                Err(format!("{}: states no unit. Give it by {}, such as g", self.name, self.words.units))
            }
            (Some((line, stated)), None) => Unit::new(
                &format!("{} line {line}: unit", self.name),
                stated,
                self.reader,
                Some(Kind::Acceleration),
            ),
            (None, Some(typed)) => Unit::new(self.words.units, typed, self.reader, Some(Kind::Acceleration)),
        }
    }

    /// Fails where the file states its step and the option does, too.
    fn without_step(&self) -> Result<(), String> {
        match self.time_step {
            None => Ok(()),
            Some(_) => Err(format!(
                "{}: must be left out, because {} states its own step",
                self.words.time_step, self.name
            )),
        }
    }

    /// Whether this channel of several is the one that was asked for.
    fn is_channel(&self, place: usize, name: &str) -> Option<bool> {
        self.column.map(|column| {
            column.trim().eq_ignore_ascii_case(name.trim()) || column.trim().parse::<usize>() == Ok(place)
        })
    }
}

/// The unit of samples.
#[derive(Debug, Clone)]
struct Unit {
    name: String,
    /// The factor to the consistent system of the reader; none where values have units of their own.
    factor: Option<Factor>,
    kind: Kind,
}

impl Unit {
    /// The unit of a text in a file: of this kind, or else of an acceleration, a force or a length.
    fn new(at: &str, stated: &str, reader: &Reader, kind: Option<Kind>) -> Result<Self, String> {
        let spelt = text::unit(stated);
        let kinds = [Kind::Acceleration, Kind::Force, Kind::Length];
        let factor = |kind: Kind| reader.factor_of_column(at, &spelt, kind);
        let found = match kind {
            Some(kind) => factor(kind).map(|factor| (factor, kind)),
            None => {
                let first = factor(Kind::Acceleration).map(|factor| (factor, Kind::Acceleration));
                kinds.into_iter().skip(1).fold(first, |found, kind| {
                    found.or_else(|error| factor(kind).map(|factor| (factor, kind)).map_err(|_| error))
                })
            }
        };
        let (factor, kind) = found.map_err(|error| error.to_string())?;
        Ok(Self { name: text::shown(&spelt), factor: Some(factor), kind })
    }

    /// The value in the system of the reader.
    fn times<F: Float + FromStr>(&self, value: F) -> F {
        self.factor.map_or(value, |factor| factor.times(value))
    }

    /// The load of a unit without a name: the acceleration of the surface, a force, or the displacement of the support.
    const fn excitation(&self) -> Excitation {
        match self.kind {
            Kind::Force => Excitation::Force,
            Kind::Length => Excitation::FootMotion,
            _ => Excitation::SurfaceAcceleration,
        }
    }
}

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
    /// The layout: `PEER`, `K-NET`, `ESM`, `CWB`, `COSMOS`, `GeoNet` or `columns`.
    pub kind: &'static str,
    /// The channel or the name of the column, where the file states it.
    pub channel: Option<String>,
    /// The quantity of the samples: `acceleration`, `force` or `foot displacement`.
    pub quantity: &'static str,
    /// The number of samples.
    pub samples: usize,
    /// The step in s, where all steps are equal.
    pub time_step: Option<f64>,
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
}

impl Summary {
    /// The summary in one sentence, with numbers written by `number`.
    pub fn sentence(&self, number: impl Fn(f64) -> String) -> String {
        let Self { kind, samples, unit, .. } = self;
        // The field has the name of the column, which sentences do not use.
        let quantity = self.quantity.replace("foot", "support");
        let channel = self.channel.as_ref().map_or(String::new(), |channel| format!(" “{channel}”"));
        let step =
            self.time_step.map_or("at unequal steps".to_owned(), |step| format!("{} s apart", number(step)));
        format!(
            "Record ({kind}{channel}): {samples} samples of {quantity} {step}, {} s; peak {} {unit} at {} s, mean {} {unit}.",
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

/// Reads a record.
///
/// # Errors
/// One line that names the file, the line and the value: where the text is in none of the layouts, a unit is unknown, a
/// value is no number, the number of samples differs from the one stated, a time is before that of the line above, or
/// the text is longer than memory shall hold.
pub fn read<F: Float + FromStr>(
    source: impl BufRead,
    options: &Options<'_, F>,
) -> Result<Reading<F>, String> {
    let mut lines = Lines::new(source, options.name);
    if options.skip > 0 {
        for _ in 0..options.skip {
            if lines.next()?.is_none() {
                break;
            }
        }
        return table::read(&mut lines, options, table::Known::default());
    }
    let head = lines.head(HEAD)?;
    let has = |part: &str| head.iter().any(|(_, text)| text.starts_with(part));
    let first = head.first().map(|(_, text)| text.to_ascii_lowercase()).unwrap_or_default();
    if cosmos::is_first(&first) {
        return cosmos::read(&mut lines, options);
    }
    if first.contains("corrected accelerogram") && head.iter().any(|(_, text)| text.starts_with("Component"))
    {
        return geonet::read(&mut lines, options);
    }
    if has("Scale Factor") && has("Sampling Freq") {
        return keyed::knet(&mut lines, options);
    }
    if has("SAMPLING_INTERVAL_S") {
        return keyed::esm(&mut lines, options);
    }
    if has("#DataSequence") {
        return keyed::cwb(&mut lines, options);
    }
    if let Some(header) = peer::header(&head) {
        return peer::read(&mut lines, options, &header);
    }
    table::read(&mut lines, options, table::Known::default())
}

/// The lines in which a layout is known.
const HEAD: usize = 64;
