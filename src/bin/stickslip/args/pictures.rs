//! The arguments of figures, sweeps and maps.

use super::Format;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

pub(crate) const FIGURE_EXAMPLES: &str = "\
Figures: 3, 4, 5, 6, 7, 8, 9a, 9b, 10a, 10b of the paper; stops, portrait, accuracy, multipliers.

Examples:
  stickslip figure 8 --out border.svg
  stickslip figure stops > stops.svg
  stickslip figure 4 --out displacement.csv";

pub(crate) const FIGURES_EXAMPLES: &str = "\
Examples:
  stickslip figures
  stickslip figures --all --dir docs/figures";

pub(crate) const SWEEP_EXAMPLES: &str = "\
A grid is FROM:TO:COUNT, both ends included, FROM:TO:COUNT:log for equal ratios, or a list A,B,C. Ω is the slow index.

Examples:
  stickslip sweep response --omega 0.5:2:301 --alpha 2,4,8 > sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv
  stickslip sweep steady --omega 0.1:10:1000:log --alpha 1.1:20:500 --out sweep.csv --resume
  stickslip sweep border --omega 0.01:3:3000 --outputs omega,min_force_ratio --format jsonl
  stickslip sweep response --omega 0.5:2:301 --alpha 2:8:61 --shard 2/4 --no-header --out part2.csv

The parts 1/n … n/n, all but the first made with --no-header, joined by cat are the whole.";

pub(crate) const MAP_EXAMPLES: &str = "\
Quantities: regime, margin (α/α_min), stops (per cycle, from rest); an output of `response`, such as
loop_size_stiffness; or steady:NAME for one of `steady`, such as steady:max_displacement.

Examples:
  stickslip map --out regime.svg
  stickslip map margin --omega 0.2:2:181 --alpha 0.5:8:76 > margin.csv
  stickslip map steady:stick_fraction --omega 0.05:1.5:300 --alpha 1.05:8:140 --out sticking.svg";

#[derive(Debug, Args)]
pub(crate) struct FigureArgs {
    /// Which figure
    #[arg(value_name = "FIGURE")]
    pub(crate) name: String,
    /// Where it goes: a drawing in FILE.svg, its data in FILE.csv [default: the drawing, to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct FiguresArgs {
    /// Draw them all; without it their names are listed
    #[arg(long)]
    pub(crate) all: bool,
    /// The folder they go to
    #[arg(long, value_name = "DIR", default_value = "docs/figures")]
    pub(crate) dir: PathBuf,
}

/// What is swept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Swept {
    Response,
    Steady,
    Border,
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
    /// csv or jsonl
    #[arg(long, value_enum, default_value = "csv", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Where the rows go [default: standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Go on after the last whole row of --out FILE
    #[arg(long)]
    pub(crate) resume: bool,
    /// Part I of N parts of the sweep, each a run of its rows
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(crate) shard: Option<String>,
    /// No line of column names
    #[arg(long)]
    pub(crate) no_header: bool,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
}

#[derive(Debug, Args)]
pub(crate) struct MapArgs {
    /// What is mapped
    #[arg(value_name = "QUANTITY", default_value = "regime")]
    pub(crate) quantity: String,
    /// Frequency ratios Ω: a grid or a list
    #[arg(long, value_name = "GRID", default_value = "0.0525:1.9975:390", allow_hyphen_values = true)]
    pub(crate) omega: String,
    /// Force ratios α: a grid or a list
    #[arg(long, value_name = "GRID", default_value = "0.025:7.975:160", allow_hyphen_values = true)]
    pub(crate) alpha: String,
    /// Where it goes: a picture in FILE.svg, rows in FILE.csv [default: rows, to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
}
