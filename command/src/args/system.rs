//! The arguments of systems of several bodies.

use super::{Format, UnitArgs};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The question about a system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SystemQuestion {
    /// The system in words, with its natural frequencies
    Describe,
    /// The steady motion
    Steady,
    /// The motion from the start of the file to --until
    Simulate,
    /// The motion under a record of the base's acceleration
    Record,
    /// The steady motion over --frequency
    Curve,
    /// The least load that keeps the one contact from sticking
    Border,
}

#[derive(Debug, Args)]
#[command(after_help = "\
FILE describes bodies by name, in TOML or JSON:

  units = \"N,mm\"
  [masses]
  block = \"1 t\"
  roof = { mass = \"500 kg\", start = \"3 mm\" }
  [[springs]]
  between = [\"ground\", \"block\"]
  stiffness = \"200 N/mm\"
  damping = \"0.3 N*s/mm\"
  [[springs]]
  between = [\"block\", \"roof\"]
  stiffness = \"300 N/mm\"
  [[contacts]]
  name = \"bearing\"
  between = [\"ground\", \"block\"]
  friction = \"450 N\"
  [[forces]]
  on = \"roof\"
  amplitude = \"1.5 kN\"
  frequency = \"3 Hz\"

A contact has friction, or coefficient and normal_load, or law = [[speed, force], …] or a CSV file. It may have static_ratio
(or peak), stiffness, which makes it elastic, and moves, the velocity of its other side, such as a belt. [[stops]] have
between, gap, stiffness and damping. [base] has acceleration, a file or { amplitude, frequency }. A file may have matrices instead: mass,
damping, stiffness, elements, harmonics.

Examples:
  stickslip system machine.toml
  stickslip system machine.toml steady
  stickslip system machine.toml simulate --until 5s --format json
  stickslip system machine.toml record quake.at2
  stickslip system machine.toml curve --frequency 1Hz:10Hz:100 --set bearing.friction=600N
  stickslip system machine.toml border")]
pub(crate) struct SystemArgs {
    /// The file of the system, TOML or JSON, - for standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// describe, steady, simulate, record, curve or border [default: describe]
    #[arg(
        value_enum,
        value_name = "QUESTION",
        default_value = "describe",
        hide_possible_values = true,
        hide_default_value = true
    )]
    pub(crate) question: SystemQuestion,
    /// The record, with the question record
    #[arg(value_name = "RECORD")]
    pub(crate) record: Option<PathBuf>,
    /// Time at which the motion ends, with simulate
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) until: Option<String>,
    /// Evenly spaced states of the motion, with simulate, steady and record
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(crate) samples: Option<String>,
    /// Frequencies of the load with the lowest frequency, such as 1Hz:10Hz:100, with curve
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub(crate) frequency: Option<String>,
    /// Another value of the file: NAME.FIELD=VALUE, such as bearing.friction=600N. May be given several times
    #[arg(long, value_name = "PATH=VALUE")]
    pub(crate) set: Vec<String>,
    /// text, json or csv [default: text, and csv for a curve]
    #[arg(long, value_enum, hide_possible_values = true)]
    pub(crate) format: Option<Format>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}
