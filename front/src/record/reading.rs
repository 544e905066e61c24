//! What is read of a file, and its first lines.

use super::lines::Line;
use stickslip::motion::record::{After, Record, RecordAnswer};
use stickslip::{Excitation, Float};

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
        let unequal = || {
            let [shortest, longest] = [number(*least), number(*most)];
            // Steps that are nearly equal differ in their last digits.
            match shortest == longest {
                true => format!("at unequal steps of {least} s to {most} s"),
                false => format!("at unequal steps of {shortest} s to {longest} s"),
            }
        };
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
pub(super) struct Head {
    /// The first bytes, of which there are as many as a header of SAC has.
    pub(super) bytes: Vec<u8>,
    /// The first lines of a text; none of a binary file.
    pub(super) lines: Vec<Line>,
}

impl Head {
    /// Whether a line begins with this text.
    pub(super) fn has(&self, part: &str) -> bool {
        self.lines.iter().any(|(_, text)| text.starts_with(part))
    }

    /// The first line, in small letters.
    pub(super) fn first(&self) -> String {
        self.lines.first().map(|(_, text)| text.to_lowercase()).unwrap_or_default()
    }
}
