//! The arguments of `stickslip attractors` and `basins`.

use super::{Format, LookArgs, MachineArgs, UnitArgs};
use clap::Args;
use std::path::PathBuf;

/// Where the limit of each start goes.
#[derive(Debug, Args)]
pub(crate) struct RowsArgs {
    /// Also write each start with its limit to FILE, as rows of CSV, as they are found
    #[arg(long, value_name = "FILE")]
    pub(crate) rows: Option<PathBuf>,
    /// Continue after the last complete row of --rows FILE. The answer is that of an uninterrupted run
    #[arg(long, requires = "rows")]
    pub(crate) resume: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip attractors --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3
  stickslip attractors --omega 0.1356 --alpha 4.4107 --damping-ratio 0.0388 --static-friction-ratio 2.7673 --starts 400
  stickslip attractors --omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87 --format json
  stickslip attractors --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3 --unstable 2
  stickslip attractors --omega 0.45 --alpha 7.5 --damping-ratio 0.02 --static-friction-ratio 2.5 --rows starts.csv --resume

The starts are at ω_d t = 0 and always the same: the first at rest at x = 0, the others spread evenly over
|x| ≤ R, |v| ≤ R. A limit that no start leads to is not found.

--resume continues a run that was interrupted, by Ctrl-C, kill -9 or a full disk. It must be the same run: machine
and start of every row are compared, and as many whole rows, evenly spaced, as a second allows. FILE.check has a
checksum of the rows: rows without one are computed again. A run with more --starts continues one with fewer.")]
pub(crate) struct AttractorsArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// Number of starts
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value = "1000")]
    pub(crate) starts: String,
    /// R, the largest displacement and velocity of the starts, in units of B and of B ω_d [default: 3 + 2
    /// η + 2 × the frictionless amplitude, at most 20 α]
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub(crate) reach: Option<String>,
    /// Periods of the drive to follow from each start
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = stickslip_front::limits::PERIODS)]
    pub(crate) max_periods: u32,
    /// Also search by Newton's method for periodic motions of up to N turns of the drive that no start
    /// leads to, such as unstable ones. There may be others
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) unstable: Option<u32>,
    #[command(flatten)]
    pub(crate) rows: RowsArgs,
    /// text, json, jsonl or csv
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip basins --omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87 --out basins.svg
  stickslip basins --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3 --x0 -8:8:81 --v0 -8:8:81
  stickslip basins --omega 0.45 --alpha 7.5 --damping-ratio 0.02 --static-friction-ratio 2.5 --rows starts.csv --resume --out basins.svg

The starts are at ω_d t = 0. Each row has the start, the number of its limit and the kind of the limit.
--rows FILE --resume continues an interrupted run. From complete rows another picture is drawn at once.")]
pub(crate) struct BasinsArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// Initial displacements, FROM:TO:COUNT [default: 101 values over the range of the starts of attractors]
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) x0: Option<String>,
    /// Initial velocities, FROM:TO:COUNT [default: likewise]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) v0: Option<String>,
    /// Periods of the drive to follow from each start
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = stickslip_front::limits::PERIODS)]
    pub(crate) max_periods: u32,
    #[command(flatten)]
    pub(crate) rows: RowsArgs,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    /// Output file: a picture in FILE.svg, FILE.png or FILE.pdf, rows in FILE.csv [default: rows to standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Replace FILE if it exists
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
}
