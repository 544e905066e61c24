//! What every layout works with: the lines of its file, what was asked, and where its samples go. Layouts do not depend on
//! the number type: samples, times and steps stay text until they are stored.

use super::lines::Lines;
use super::unit::Ratio;
use super::{Options, Unit, text};
use crate::inputs::units::{Factor, Kind};
use stickslip::Excitation;

/// Where the samples and the times of a file go, in the number type of the answer.
pub(super) trait Sink {
    /// The samples that follow are in this unit.
    fn begin(&mut self, unit: Unit);

    fn len(&self) -> usize;

    /// Leaves out the samples from this number on.
    fn truncate(&mut self, len: usize);

    /// Adds a sample; false where the text is no number.
    fn sample(&mut self, text: &str) -> Result<bool, String>;

    /// Adds a sample of a binary file.
    fn exact(&mut self, value: f64) -> Result<(), String>;

    /// Adds a sample that has a unit of its own or is in the system of the reader.
    fn valued(&mut self, named: &str, text: &str, kind: Kind) -> Result<(), String>;

    /// Adds a time in the unit of this factor; false where the text is neither a number nor one with a unit.
    fn time(&mut self, named: &str, text: &str, second: Option<Factor>) -> Result<bool, String>;
}

/// The times of samples.
#[derive(Debug, Clone)]
pub(super) enum Times {
    /// Each sample has its own.
    Each,
    /// The step that was asked for.
    Asked,
    /// A step in the unit of this factor, and the time of the first sample.
    Step(Ratio, Option<Factor>, String),
}

impl Times {
    pub(super) fn step(above: &str, below: &str) -> Self {
        Self::Step(Ratio::new(above, below), None, "0".to_owned())
    }
}

/// A peak that a header states.
#[derive(Debug, Clone)]
pub(super) struct Stated {
    /// The line of the header.
    pub(super) line: u64,
    /// As it is written.
    pub(super) text: String,
    /// Its unit, if that is not the one of the samples.
    pub(super) unit: Option<Factor>,
    /// It is the greatest distance from the mean.
    pub(super) of_mean: bool,
}

/// What a layout found, beside the samples.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) kind: &'static str,
    pub(super) channel: Option<String>,
    pub(super) excitation: Excitation,
    pub(super) times: Times,
    pub(super) stated: Option<Stated>,
    /// What else is to be told of the file, in sentences.
    pub(super) notes: Vec<String>,
    pub(super) unused: Vec<String>,
}

impl Found {
    pub(super) const fn new(kind: &'static str, excitation: Excitation, times: Times) -> Self {
        Self { kind, channel: None, excitation, times, stated: None, notes: Vec::new(), unused: Vec::new() }
    }
}

/// The file that a layout reads.
pub(super) struct Sheet<'a> {
    pub(super) lines: Lines<'a>,
    pub(super) asked: &'a Options<'a>,
    pub(super) sink: &'a mut dyn Sink,
    /// The names of the channels that have been seen, of which one is chosen.
    pub(super) channels: Vec<String>,
}

impl Sheet<'_> {
    pub(super) fn at(&self, line: u64, what: &str) -> String {
        self.asked.at(line, what)
    }

    /// Reads as many samples as the header states: `stated` says so, such as “NPTS = 400”. Text that is no number may
    /// follow them, more numbers may not.
    pub(super) fn fill(
        &mut self,
        (count, stated): (usize, &str),
        width: Option<usize>,
    ) -> Result<(), String> {
        while self.sink.len() < count {
            let Some((number, line)) = self.lines.next()? else {
                let read = self.sink.len();
                return Err(format!("{}: {stated}, but the file has {read} samples", self.asked.name));
            };
            let before = self.sink.len();
            let sink = &mut self.sink;
            let wrong = text::each(&line, width, &mut |step| match step {
                text::Step::Number(part) => sink.sample(part),
                text::Step::Again => {
                    sink.truncate(before);
                    Ok(true)
                }
            });
            let wrong = wrong.map_err(|what| self.at(number, &what))?;
            if let Some(wrong) = wrong {
                let what = format!("{wrong}: must be a number: {stated}, and {before} samples were read");
                return Err(self.at(number, &what));
            }
            if self.sink.len() > count {
                return Err(self.at(number, &format!("{stated}, but more samples follow")));
            }
        }
        Ok(())
    }

    /// Fails where another number follows.
    pub(super) fn ended(&mut self, stated: &str) -> Result<(), String> {
        while let Some((number, line)) = self.lines.next()? {
            if line.trim().is_empty() {
                continue;
            }
            if text::begins_with_number(&line) {
                return Err(self.at(number, &format!("{stated}, but more samples follow")));
            }
            break;
        }
        Ok(())
    }

    /// Whether the channel of these names is the one that was asked for. Each has its place, and where none was asked
    /// for, every one is.
    pub(super) fn is_wanted(&mut self, names: &[&str]) -> bool {
        self.channels.push(names.first().copied().unwrap_or_default().to_owned());
        let place = self.channels.len();
        self.asked.column.is_none_or(|column| {
            let column = column.trim();
            column.parse::<usize>() == Ok(place)
                || names.iter().any(|name| column.eq_ignore_ascii_case(name.trim()))
        })
    }

    /// The one channel that was wanted, of those that were seen.
    pub(super) fn one<T>(&self, wanted: Vec<T>) -> Result<T, String> {
        let Options { name, words, column, .. } = self.asked;
        let all = || self.channels.join(", ");
        let mut wanted = wanted.into_iter();
        match (wanted.next(), wanted.next(), column) {
            (Some(one), None, _) => Ok(one),
            (Some(_), Some(_), _) => {
                Err(format!("{name}: has the channels {}. Choose one by {}, such as 1", all(), words.column))
            }
            (None, _, Some(column)) => {
                Err(format!("{} {column}: must be a channel of {name}: {}", words.column, all()))
            }
            (None, ..) => Err(format!("{name}: has no acceleration")),
        }
    }
}
