//! The arguments of sweeps.

use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

pub(crate) const SWEEP_EXAMPLES: &str = "\
A grid is FROM:TO:COUNT, both ends included, FROM:TO:COUNT:log for equal ratios, or a list A,B,C. Ω is the slow index.

Examples:
  stickslip sweep response --omega 0.5:2:301 --alpha 2,4,8 > sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv --resume
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.parquet
  stickslip sweep border --omega 0.01:3:3000 --outputs omega,min_force_ratio --format jsonl
  stickslip sweep response --omega 0.5:2:301 --alpha 2:8:61 --shard 2/4 --no-header --out part2.csv

The parts 1/n … n/n are the whole: as rows joined by cat, all but the first made with --no-header; as Parquet files
read together, as any query engine does.

A sweep that was broken off, by Ctrl-C, kill -9 or a full disk, goes on with --resume. It goes on with itself alone:
Ω and α of every row that is kept are compared, and as many whole rows, spread evenly, as a second allows; without
the columns omega and alpha all rows are computed anew to compare them. Rows of CSV and JSON lines are in FILE as they
come; those of Parquet are in FILE.parts, Parquet files themselves, until the sweep is whole. A kill loses the last
second of rows at most.

Lengths are in units of B = r_y/k, velocities of B ω_d, energies of r_y B, phases are ω_d t in rad.";

/// What is swept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Swept {
    Response,
    Steady,
    Border,
}

/// How the rows are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SweepFormat {
    Csv,
    Jsonl,
    Parquet,
}

impl SweepFormat {
    /// By the end of a file's name.
    fn of(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()? {
            "jsonl" => Some(Self::Jsonl),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// response, steady or border
    #[arg(value_enum, value_name = "WHAT", hide_possible_values = true)]
    pub(crate) question: Swept,
    /// Frequency ratios Ω: a grid or a list
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub(crate) omega: String,
    /// Force ratios α: a grid or a list; not for border
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub(crate) alpha: Option<String>,
    /// The columns wanted, of those the command WHAT gives [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) outputs: Option<Vec<String>>,
    /// csv, jsonl or parquet (needs a build with the feature parquet) [default: by the end of FILE's name, or csv]
    #[arg(long, value_enum, hide_possible_values = true)]
    format: Option<SweepFormat>,
    /// Where the rows go [default: standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Go on after the last complete row of --out FILE; nothing is left to do where it is whole
    #[arg(long)]
    pub(crate) resume: bool,
    /// Part I of N parts of the sweep, each a run of its rows
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(crate) shard: Option<String>,
    /// No line of column names
    #[arg(long)]
    pub(crate) no_header: bool,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
}

impl SweepArgs {
    /// As asked for, or as the file's name ends.
    pub(crate) fn format(&self) -> SweepFormat {
        let named = || self.out.as_deref().and_then(SweepFormat::of);
        self.format.or_else(named).unwrap_or(SweepFormat::Csv)
    }
}
