//! The arguments that several commands have.

use crate::failure::Failure;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use stickslip_front::inputs::units::{Reader, System};

/// The help of `--header`, a text because rustdoc would take the unit for a link.
pub(super) const HEADER: &str =
    "Header of CSV: names, or names with their units in brackets, such as max_displacement[B]";

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    // Rustdoc would take the unit for a link.
    #[arg(
        long,
        value_name = "FILE",
        help = "CSV with a header, answered row by row: columns omega and alpha, or of a machine, such as \
                frequency[Hz] (values that all rows share may be arguments). - is standard input"
    )]
    pub(crate) points: Option<PathBuf>,
    /// text or json for one answer [default: text], jsonl or csv for --points [default: jsonl]
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    #[arg(long, value_enum, default_value = "names", value_name = "HEADER", help = HEADER)]
    pub(crate) header: Header,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

/// How a single answer is written.
#[derive(Debug, Args)]
pub(crate) struct AnswerArgs {
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

/// The system of units.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct UnitArgs {
    /// Units of the answers, such as kN,mm, and the system of bare numbers (values with units are converted)
    /// [default: N,m]. Under a record, accelerations may be in g: kN,mm,g
    #[arg(long, value_name = "FORCE,LENGTH", value_parser = System::perhaps_in_g)]
    pub(crate) units: Option<System>,
}

impl UnitArgs {
    pub(crate) fn reader(&self) -> Reader {
        Reader::new(self.units.as_ref(), "--units kN,m")
    }
}

impl OutputArgs {
    /// Whether a single answer is JSON, and not text.
    pub(crate) fn is_json(&self) -> Result<bool, Failure> {
        self.format.unwrap_or(Format::Text).of_single().ok_or_else(|| {
            let text = "--format: must be text or json for a single answer, jsonl or csv with --points";
            Failure::Input(text.to_owned())
        })
    }
}

/// What stands in the first line of CSV.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Header {
    Names,
    Units,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
    Jsonl,
    Csv,
}

impl Format {
    /// Whether a single answer is JSON, and not text; `None` for the formats of rows.
    fn of_single(self) -> Option<bool> {
        match self {
            Self::Text => Some(false),
            Self::Json => Some(true),
            Self::Jsonl | Self::Csv => None,
        }
    }

    /// Whether the answer is JSON, of a command that has no rows.
    pub(crate) fn is_json(self, command: &str) -> Result<bool, Failure> {
        let rows = || Failure::Input(format!("--format: the answer to {command} is text or json"));
        self.of_single().ok_or_else(rows)
    }
}
