//! The arguments that several commands have.

use clap::{Args, ValueEnum};
use std::path::PathBuf;
use stickslip::inputs::units::{Reader, System};

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// CSV with a header, answered row by row: columns omega and alpha, or of a machine, such as
    /// frequency[Hz] (values that all rows share may be arguments). - is standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<PathBuf>,
    /// text or json for one answer [default: text], jsonl or csv for --points [default: jsonl]
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    /// Header of CSV: names, or names with their units in brackets, such as max_displacement[B]
    #[arg(long, value_enum, default_value = "names", value_name = "HEADER")]
    pub(crate) header: Header,
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
    /// [default: N,m]
    #[arg(long, value_name = "FORCE,LENGTH")]
    pub(crate) units: Option<System>,
}

impl UnitArgs {
    pub(crate) fn reader(&self) -> Reader {
        Reader::new(self.units.as_ref(), "--units kN,m")
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
