//! The arguments of sweeps.

use super::{Header, MachineArgs, UnitArgs};
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// What is swept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Swept {
    Response,
    Steady,
    Border,
}

impl Swept {
    /// The command with these answers.
    pub(crate) const fn command(self) -> &'static str {
        match self {
            Self::Response => "response",
            Self::Steady => "steady",
            Self::Border => "border",
        }
    }
}

/// How the rows are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SweepFormat {
    Csv,
    Jsonl,
    Parquet,
}

impl SweepFormat {
    /// The format named by the end of a file's name.
    pub(super) fn of(file: &Path) -> Result<Self, Failure> {
        match file.extension().and_then(|end| end.to_str()) {
            Some("csv") => Ok(Self::Csv),
            Some("jsonl") => Ok(Self::Jsonl),
            Some("parquet") => Ok(Self::Parquet),
            _ => {
                let name = file.display();
                let ends = "the name must end in .csv, .jsonl or .parquet, or --format be given";
                Err(format!("--out {name}: {ends}").into())
            }
        }
    }
}

#[derive(Debug, Args)]
#[command(after_help = "\
Ω and α, and every quantity of a machine, may be a grid: FROM:TO:COUNT, both ends included, FROM:TO:COUNT:log for
equal ratios, or a list A,B,C. The first of them, in the order of the options below, varies slowest.

Examples:
  stickslip sweep response --omega 0.5:2:301 --alpha 2,4,8 > sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv --resume
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.parquet
  stickslip sweep border --omega 0.01:3:3000 --outputs omega,min_force_ratio --format jsonl
  stickslip sweep steady --mass 800kg --period 2.2s --friction-coefficient 0.03:0.1:8 --frequency 0.3Hz:5Hz:200 \
    --base-acceleration 0.15g --units N,mm --outputs frequency,friction,physical.max_displacement --out stroke.csv
  stickslip sweep response --omega 0.5:2:301 --alpha 2:8:61 --shard 2/4 --no-header --out part2.csv

The parts 1/n … n/n together are the whole sweep. Parts as rows are joined by cat, if all but the first are made with
--no-header. Parquet files are read together by any query engine.

--resume continues a sweep that was interrupted, by Ctrl-C, kill -9 or a full disk. It must be the same sweep: Ω and
α of every existing row are compared, and as many whole rows, evenly spaced, as a second allows. FILE.check has a
checksum of the rows. Rows without one, and all rows without the columns omega and alpha, are computed again to compare
them. Rows of CSV and JSON lines are written to FILE as they are computed. Rows of Parquet are kept in FILE.parts, which are Parquet files themselves, until the sweep is complete. A kill
loses at most the last second of rows.

Lengths are in units of B = r_y/k, velocities of B ω_d, energies of r_y B, and phases are ω_d t in rad. For a machine there
are columns in its own units as well, such as max_displacement[mm], which --outputs calls physical.max_displacement.")]
pub(crate) struct SweepArgs {
    /// response, steady (from rest) or border
    #[arg(value_enum, value_name = "WHAT", hide_possible_values = true)]
    pub(crate) question: Swept,
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    /// The columns to write, among those of the command WHAT [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) outputs: Option<Vec<String>>,
    #[command(flatten)]
    pub(crate) table: TableArgs,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
}

/// How a table of many rows is written.
#[derive(Debug, Args)]
pub(crate) struct TableArgs {
    /// csv, jsonl or parquet (needs a build with the feature parquet) [default: by the end of FILE's name, or
    /// csv]
    #[arg(long, value_enum, hide_possible_values = true)]
    format: Option<SweepFormat>,
    /// Output file [default: standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Continue after the last complete row of --out FILE (a complete file is left as it is)
    #[arg(long)]
    pub(crate) resume: bool,
    /// Part I of N parts of the rows, each a run of them
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(crate) shard: Option<String>,
    #[arg(long, value_enum, default_value = "names", value_name = "HEADER", help = super::shared::HEADER)]
    pub(crate) header: Header,
    /// Omit the line of column names
    #[arg(long)]
    pub(crate) no_header: bool,
}

impl TableArgs {
    /// A table with a header of names, whose format is that of the file's name.
    pub(super) fn of_names(
        out: Option<PathBuf>,
        resume: bool,
        shard: Option<String>,
        no_header: bool,
    ) -> Self {
        Self { format: None, out, resume, shard, header: Header::Names, no_header }
    }

    /// The format of `--format`, or that of the end of the file's name; CSV for a name without an end.
    pub(crate) fn format(&self) -> Result<SweepFormat, Failure> {
        match (self.format, self.out.as_deref()) {
            (Some(format), _) => Ok(format),
            (None, Some(file)) if file.extension().is_some() => SweepFormat::of(file),
            (None, _) => Ok(SweepFormat::Csv),
        }
    }
}
