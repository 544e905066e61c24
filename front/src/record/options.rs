//! What is asked of a file: its options, with the names that a front has for them, and the unit of its samples.

use super::text;
use super::unit::Ratio;
use super::unit::{Unit, volts};
use crate::inputs::units::{Kind, Reader, split};
use std::str::FromStr;
use stickslip::Float;

/// The names that a front has for the options of the reader, for its messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Words {
    /// The time between samples.
    pub time_step: &'static str,
    /// The column of the time.
    pub time_column: &'static str,
    /// The column or the channel.
    pub column: &'static str,
    /// The lines that are left out; empty where the front has no such option.
    pub skip: &'static str,
    /// The unit of the samples.
    pub units: &'static str,
    /// What the samples are multiplied by.
    pub scale: &'static str,
    /// The time at which the record begins.
    pub from: &'static str,
    /// The time at which it ends.
    pub to: &'static str,
    /// The mean that is taken off.
    pub remove_mean: &'static str,
    /// The new step.
    pub resample: &'static str,
}

impl Words {
    /// The options of the command.
    pub const COMMAND: Self = Self {
        time_step: "--time-step",
        time_column: "--time-column",
        column: "--column",
        skip: "--skip",
        units: "--record-units",
        scale: "--scale",
        from: "--from",
        to: "--to",
        remove_mean: "--remove-mean",
        resample: "--resample",
    };
    /// The arguments of `Record.read` in Python.
    pub const PYTHON: Self = Self {
        time_step: "time_step",
        time_column: "time_column",
        column: "column",
        skip: "skip",
        units: "record_units",
        scale: "scale",
        from: "from",
        to: "to",
        remove_mean: "remove_mean",
        resample: "resample",
    };
    /// The fields of the page.
    pub const PAGE: Self = Self {
        time_step: "the field Time step",
        time_column: "--time-column of the command",
        column: "the field Column",
        skip: "",
        remove_mean: "--remove-mean of the command",
        units: "the field Unit",
        ..Self::COMMAND
    };
}

/// Whether a scale is what a unit of the signal is, such as `2.5 N/V`, and not a number with a unit, such as `2 m/s^2`.
#[must_use]
pub fn is_sensitivity(scale: &str) -> bool {
    let (_, unit) = split(scale);
    unit.contains('/') && !Reader::is_unit(unit)
}

/// What is known of a file beside its text, and what is wanted of it, as it was typed.
#[derive(Debug, Clone, Copy)]
pub struct Options<'a> {
    /// The name of the file in messages.
    pub name: &'a str,
    /// The reader of values, whose system of units is that of the record.
    pub reader: &'a Reader,
    /// The time between samples, where the file does not state it.
    pub time_step: Option<&'a str>,
    /// The column of the time by its name or its number from 1.
    pub time_column: Option<&'a str>,
    /// The column by its name or its number from 1, or the channel; `all` reads every number of a text without
    /// names, row by row.
    pub column: Option<&'a str>,
    /// The lines before the columns that are left out. The text is then one of columns.
    pub skip: u64,
    /// The unit of the samples, where the file does not state it.
    pub units: Option<&'a str>,
    /// What the signal of the file is, such as `2.5 N/V`: the record is then in newtons.
    pub scale: Option<&'a str>,
    /// The time at which the record begins; that of the first sample by default.
    pub from: Option<&'a str>,
    /// The time at which it ends; that of the last sample by default. Samples at both times are kept.
    pub to: Option<&'a str>,
    /// The mean that is taken off: `all`, `before` the motion, or of the window `FROM:TO`.
    pub remove_mean: Option<&'a str>,
    /// The step at which the record is wanted.
    pub resample: Option<&'a str>,
    /// What the samples are, where they are no load of one body: a displacement or a velocity.
    pub quantity: Option<Kind>,
    /// The names of these options.
    pub words: Words,
}

impl<'a> Options<'a> {
    /// A file of this name, which states everything by itself.
    pub const fn new(name: &'a str, reader: &'a Reader, words: Words) -> Self {
        Self {
            name,
            reader,
            time_step: None,
            time_column: None,
            column: None,
            skip: 0,
            units: None,
            scale: None,
            from: None,
            to: None,
            remove_mean: None,
            resample: None,
            quantity: None,
            words,
        }
    }

    /// An error at a line.
    pub(super) fn at(&self, line: u64, what: &str) -> String {
        format!("{} line {line}: {what}", self.name)
    }

    /// The time of an option.
    pub(super) fn time<F: Float + FromStr>(
        &self,
        word: &str,
        text: Option<&str>,
    ) -> Result<Option<F>, String> {
        Ok(text.map(|text| self.reader.value::<F>(word, text, Kind::Time)).transpose()?)
    }

    /// The unit of samples, from the one that the file states in a line or else from the option: an acceleration, or of
    /// this kind.
    pub(super) fn unit(&self, stated: Option<(u64, &str)>, kind: Option<Kind>) -> Result<Unit, String> {
        let kind = kind.or(self.quantity);
        let at = stated.map(|(line, _)| format!("{} line {line}: unit", self.name));
        match (stated, self.units) {
            (Some((line, _)), Some(typed)) => Err(format!(
                "{} {typed}: must be left out, because {} states its own unit in line {line}",
                self.words.units, self.name
            )),
            (None, None) if self.sensitivity().is_none() => {
                Err(format!("{}: states no unit. Give it by {}, such as g", self.name, self.words.units))
            }
            (stated, typed) => {
                let text = stated.map(|(_, stated)| stated).or(typed);
                self.named_unit(at.as_deref().unwrap_or(self.words.units), text, kind)
            }
        }
    }

    /// The unit of this text, or the one to which the sensitivity leads from it.
    pub(super) fn named_unit(
        &self,
        at: &str,
        stated: Option<&str>,
        kind: Option<Kind>,
    ) -> Result<Unit, String> {
        let Some((factor, unit, per)) = self.sensitivity() else {
            let unit = Unit::new(at, stated.unwrap_or_default(), self.reader, kind);
            let volts = stated.and_then(|stated| volts(&text::unit(stated)));
            return unit.map_err(|error| match volts {
                Some(_) => format!("{error}. Give what a volt is by {} \"2.5 N/V\"", self.words.scale),
                None => error,
            });
        };
        let word = format!("{} {}", self.words.scale, self.scale.unwrap_or_default());
        let found = Unit::new(&word, unit, self.reader, None)?;
        let own = stated.map_or(per.to_owned(), text::unit);
        // “2.5 N/V” of a signal in mV is 2.5e-3 N for each of its numbers.
        let shift = match (volts(&own), volts(per)) {
            (Some(own), Some(per)) => own.saturating_sub(per),
            _ if own == per => 0,
            _ => {
                return Err(format!(
                    "{word}: must be a unit for each {own}, which is the unit of the samples"
                ));
            }
        };
        let (digits, exponent) = factor.split_once(['e', 'E']).unwrap_or((factor, "0"));
        let exponent = exponent.parse::<i32>().unwrap_or(0).saturating_add(shift);
        let scale = Ratio::new(&format!("{digits}e{exponent}"), "1");
        Ok(Unit { scale, ..found })
    }

    /// The factor, the unit and the unit for each of which it is, of `2.5 N/V`.
    pub(super) fn sensitivity(&self) -> Option<(&'a str, &'a str, &'a str)> {
        let (factor, unit) = split(self.scale.filter(|text| is_sensitivity(text))?);
        let (unit, per) = unit.rsplit_once('/')?;
        Some((if factor.is_empty() { "1" } else { factor }, unit.trim(), per.trim()))
    }

    /// Fails where the file states its step and the option does, too.
    pub(super) fn without_step(&self) -> Result<(), String> {
        match self.time_step {
            None => Ok(()),
            Some(_) => Err(format!(
                "{}: must be left out, because {} states its own step",
                self.words.time_step, self.name
            )),
        }
    }
}
