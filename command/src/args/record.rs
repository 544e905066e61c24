//! The arguments of the motion under a record, and of spectra.

use super::{AnswerArgs, BodyArgs, LookArgs, TableArgs, UnitArgs};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use stickslip::motion::record::After;

/// How the file of a record is read.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct LoadArgs {
    /// Time between samples in a file that does not state it, such as 0.005s
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    pub(crate) time_step: Option<String>,
    /// Column of the time by its name or its number from 1, where its name does not say so
    #[arg(long, value_name = "NAME|N")]
    pub(crate) time_column: Option<String>,
    /// Column by its name or its number from 1, or the channel of an agency's file. The word all reads columns without names row
    /// by row
    #[arg(long, value_name = "NAME|N")]
    pub(crate) column: Option<String>,
    /// Number of lines to skip before the columns
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub(crate) skip: u64,
    /// Unit of the samples in a file that does not state it, such as g, cm/s^2 or kN
    #[arg(long, value_name = "UNIT")]
    pub(crate) record_units: Option<String>,
    /// Factor by which the record is multiplied, or what a signal is, such as "2.5 N/V"
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    pub(crate) scale: Option<String>,
    /// Time at which the record begins: samples before it are left out
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Time at which the record ends
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
    /// Take off the mean of all samples (all), of those before the motion (before), or of a window FROM:TO such as 0s:2s
    #[arg(long, value_name = "PART", allow_hyphen_values = true)]
    pub(crate) remove_mean: Option<String>,
    /// Step at which the record is read off its straight lines. The answer says so
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    pub(crate) resample: Option<String>,
    /// The load after the record: zero, hold (it stays at its last sample) or free (a support lets go of the spring) [default: hold
    /// for a support, zero for a force or an acceleration]
    #[arg(long, value_enum, value_name = "LOAD", hide_possible_values = true)]
    pub(crate) after: Option<AfterArg>,
}

/// The load after a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum AfterArg {
    Zero,
    Hold,
    Free,
}

impl From<AfterArg> for After {
    fn from(after: AfterArg) -> Self {
        match after {
            AfterArg::Zero => Self::Zero,
            AfterArg::Hold => Self::Hold,
            AfterArg::Free => Self::Free,
        }
    }
}

/// The surface that the body slides on.
#[derive(Debug, Clone, Args)]
pub(crate) struct SurfaceArgs {
    /// Angle by which the surface falls in the direction of x, such as 10deg
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) slope: Option<String>,
    /// The body never slides backwards
    #[arg(long)]
    pub(crate) one_way: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "\
FILE is a record of an agency (PEER, COSMOS, CSMIP, SMC, K-NET, ESM, GeoNet, SAC, ...) whose layout is known by its
content and whose units are read from it, or columns of text separated by commas, semicolons, tabs or blanks, such as
time[s],acceleration[g]. The load is the column acceleration (acc, of the surface that the body slides on), force, or
foot-displacement (of the spring's support). A support with the damper on it, too, is damped-foot-displacement. Columns
without names need --record-units, and --column if there are several. Samples without times need --time-step. The answer
states the content of the file. Between samples the load is a straight line. After the last one a force or an
acceleration is zero, a support stays (or --after says otherwise), and the body slides to its rest. No stop is missed.

Examples:
  stickslip record quake.at2 --describe --picture quake.svg
  stickslip record quake.at2 --mass 800kg --period 2.5s --friction-coefficient 0.06 --damping-ratio 5%
  stickslip record quake.csv --mass 800kg --period 2.5s --friction-coefficient 0.06 --scale 1.5 --units kN,mm \\
    --out motion.csv --picture motion.svg
  stickslip record quake.at2 --mass 800kg --period 2.5s --friction-coefficient 0.06 --enclose
  stickslip record samples.txt --time-step 0.02s --record-units g --mass 800kg --period 2.5s --friction-coefficient 0.06
  stickslip record quake.at2 --yield-acceleration 0.1g --both-polarities
  stickslip record quake.at2 --mass 800kg --period 2.5s --friction-coefficient 0.06 --floor-spectrum 0.05s:2s:60:log
  stickslip record quake.at2 --mass 1t --no-spring --friction-coefficient 0.25 --slope 10deg --one-way --format json
  stickslip record cycle.csv --no-spring --friction-coefficient 0.2 --repeats")]
pub(crate) struct RecordArgs {
    /// The record: of an agency, or columns, - for standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) machine: BodyArgs,
    #[command(flatten)]
    pub(crate) surface: SurfaceArgs,
    #[command(flatten)]
    pub(crate) load: LoadArgs,
    /// What the file holds, without a machine: channels, units, steps, peaks, gaps, and the frequency of the greatest Fourier
    /// amplitude
    #[arg(long)]
    pub(crate) describe: bool,
    /// Displacement at the start, from the relaxed spring
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) x0: Option<String>,
    /// Velocity at the start
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) v0: Option<String>,
    /// The record repeats itself: its last sample is at the time of the first one of the next cycle. The answer is the motion that the start
    /// leads to, and --out and --picture have its cycle
    #[arg(long, conflicts_with_all = ["after", "both_polarities", "floor_spectrum", "one_way"])]
    pub(crate) repeats: bool,
    /// The record and its mirror image, each with its answers, and those of the greater peak displacement first
    #[arg(long)]
    pub(crate) both_polarities: bool,
    /// Natural periods of linear oscillators that stand on the body, such as 0.05s:2s:60:log or 0.1s,0.2s: their greatest
    /// responses
    #[arg(long, value_name = "T")]
    pub(crate) floor_spectrum: Option<String>,
    /// Damping ratio of these oscillators, such as 5% [default: 5%]
    #[arg(long, value_name = "ZETA", requires = "floor_spectrum", allow_hyphen_values = true)]
    pub(crate) floor_damping: Option<String>,
    /// The motion as CSV, or as Parquet by the name FILE.parquet: displacement, velocity, acceleration, absolute acceleration,
    /// the friction force on the body (against its motion, the opposite of that of simulate), the force on the support and the
    /// load
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) out: Option<PathBuf>,
    /// Longest time between the states of --out [default: the longest step of the record]
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    pub(crate) interval: Option<String>,
    /// The motion as a picture, FILE.svg, FILE.png or FILE.pdf
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Replace files that exist
    #[arg(long)]
    pub(crate) overwrite: bool,
    /// Guaranteed digits, and a proof of every stop: for the inputs as typed (needs a build with the feature mp)
    #[arg(long, conflicts_with_all = ["out", "picture", "interval", "both_polarities", "floor_spectrum"])]
    pub(crate) enclose: bool,
    #[command(flatten)]
    pub(crate) answer: AnswerArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Every quantity of the body may be a grid: FROM:TO:COUNT, FROM:TO:COUNT:log, or a list A,B,C. Each row is one body
under one record. The records vary slowest, and the first grid, in the order of the options, next. Without --mass
the body has one unit of mass. A picture shows the greatest displacement, the residual displacement and the greatest absolute
acceleration over the period (or over the only other grid), for each record and, from two records on, their mean. Up to five
records have their names in it.

Examples:
  stickslip spectrum quake.at2 --period 0.1s:4s:100:log --friction-coefficient 0.02,0.05,0.1 --damping-ratio 5% --out s.csv
  stickslip spectrum a.at2 b.at2 c.at2 --period 0.1s:4s:100:log --friction-coefficient 0.05 --picture spectra.svg
  stickslip spectrum *.at2 --no-spring --friction-coefficient 0.05:0.5:50 --slope 10deg --one-way --out newmark.parquet
  stickslip spectrum *.at2 --period 0.1s:4s:500:log --friction-coefficient 0.05 --out part2.csv --shard 2/8 --resume")]
pub(crate) struct SpectrumArgs {
    /// The records: of agencies, or columns
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) machine: BodyArgs,
    #[command(flatten)]
    pub(crate) surface: SurfaceArgs,
    #[command(flatten)]
    pub(crate) load: LoadArgs,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
    #[command(flatten)]
    pub(crate) table: TableArgs,
    /// The spectra as a picture, FILE.svg, FILE.png or FILE.pdf, in place of rows
    #[arg(long, value_name = "FILE", conflicts_with_all = ["out", "format", "resume", "shard", "no_header"])]
    pub(crate) picture: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Replace a picture that exists
    #[arg(long, requires = "picture")]
    pub(crate) overwrite: bool,
}
