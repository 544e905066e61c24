//! The arguments of systems of several bodies.

use super::{Format, LookArgs, TableArgs, UnitArgs};
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
    /// The minimum load that keeps the only contact from sticking
    Border,
    /// The motion under each record, a row for each system of a grid
    Spectrum,
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
(or peak), stiffness, which makes it elastic, and moves, the velocity of its other side, such as a belt. Its law may be a curve,
{ kinetic, static, speed, exponent, viscous } or { formula = \"5 + v + 10*exp(-2*v)\" }. A spring may have law = [[displacement,
force], …] or { formula = \"40*x + 300*x^3\" } in place of stiffness. [[stops]] have between, gap, and stiffness and damping, or
restitution from 0 to 1. [base] has acceleration, a file or { amplitude, frequency }. A load may have shape
(square, triangle, sawtooth, pulse), sweep, or record with repeats = true. A body may have moves, its prescribed motion. [[levels]]
are values whose passage is an event. A file may have matrices instead: mass, damping, stiffness, elements, harmonics.

Examples:
  stickslip system machine.toml
  stickslip system machine.toml steady
  stickslip system machine.toml simulate --until 5s --format json
  stickslip system machine.toml simulate --until 5s --enclose
  stickslip system machine.toml record quake.at2
  stickslip system machine.toml curve --frequency 1Hz:10Hz:100 --set bearing.friction=600N
  stickslip system machine.toml spectrum quake1.at2 quake2.at2 --set bearing.friction=300N:600N:7 --out grid.csv
  stickslip system machine.toml --picture machine.svg
  stickslip system tower.toml steady --coordinates roof
  stickslip system machine.toml border")]
pub(crate) struct SystemArgs {
    /// The file of the system, TOML or JSON, - for standard input. At most 8 MiB and 2,000 coordinates, 200 with --bits,
    /// because the matrices are dense and in memory
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// describe, steady, simulate, record, spectrum, curve or border [default: describe]
    #[arg(
        value_enum,
        value_name = "QUESTION",
        default_value = "describe",
        hide_possible_values = true,
        hide_default_value = true
    )]
    pub(crate) question: SystemQuestion,
    /// The records, with the questions record and spectrum: a row for each if there are several
    #[arg(value_name = "RECORD")]
    pub(crate) records: Vec<PathBuf>,
    /// Time at which the motion ends, with simulate, or a value that is passed first: "box = 2 m", "box.velocity = 1 m/s"
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) until: Option<String>,
    /// The coordinates that the answer and the picture show, such as roof,q17, or all [default: all in JSON and in rows, the first 24
    /// in text, the first 40 in a picture]
    #[arg(long, value_name = "NAMES", allow_hyphen_values = true)]
    pub(crate) coordinates: Option<String>,
    /// Greatest natural frequency that is shown, such as "50 Hz", with describe, where a bare number is in rad/s
    #[arg(long, value_name = "FREQUENCY", allow_hyphen_values = true)]
    pub(crate) frequencies_below: Option<String>,
    /// Evenly spaced states of the motion, with simulate, steady and record: displacements, velocities, forces, and absolute
    /// accelerations on a base that moves
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(crate) samples: Option<String>,
    /// Frequencies of the load with the lowest frequency, such as 1Hz:10Hz:100, with curve, where bare numbers are in rad/s
    #[arg(long, value_name = "GRID", allow_hyphen_values = true)]
    pub(crate) frequency: Option<String>,
    /// Rows between those of the grid, beside each peak of a coordinate, with curve and steady: the column source tells
    /// which are added
    #[arg(long, conflicts_with_all = ["resume", "shard"])]
    pub(crate) resolve: bool,
    /// Another value of the file: NAME.FIELD=VALUE, such as bearing.friction=600N, or a grid of them, such as
    /// bearing.friction=100N:900N:17. May be given several times
    #[arg(long, value_name = "PATH=VALUE")]
    pub(crate) set: Vec<String>,
    /// Force within which the tables of all laws that are curves are, such as "1 mN" [default: 2·10⁻⁴ of each law's own size, or its
    /// tolerance in the file]
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    pub(crate) law_tolerance: Option<String>,
    /// Output file of rows: .csv, .jsonl or .parquet [default: standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Continue a grid after the last complete row of --out FILE
    #[arg(long)]
    pub(crate) resume: bool,
    /// Part I of N parts of the rows of a grid
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(crate) shard: Option<String>,
    /// Omit the line of column names of a grid
    #[arg(long)]
    pub(crate) no_header: bool,
    /// Picture of the system, of its motion with the loop of each element, or of a curve, in place of its
    /// rows on standard output: FILE.svg, FILE.png or FILE.pdf
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Replace the picture, and the rows of --samples, if they exist
    #[arg(long)]
    pub(crate) overwrite: bool,
    /// text or json, csv or json for --samples, csv, jsonl or json for a grid [default: text, and csv for rows]
    #[arg(long, value_enum, hide_possible_values = true)]
    pub(crate) format: Option<Format>,
    /// Guaranteed digits of the motion, with simulate: each event proved, and each number with a bound of its error, for the
    /// numbers of the file as typed (needs a build with the feature mp)
    #[arg(long)]
    pub(crate) enclose: bool,
    /// Bits of precision, with steady, simulate, record, curve and border (needs a build with the feature mp) [default: 53 (f64), with
    /// --enclose 64]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

impl SystemArgs {
    /// How the rows of a grid are written.
    pub(crate) fn table(&self) -> TableArgs {
        TableArgs::of_names(self.out.clone(), self.resume, self.shard.clone(), self.no_header)
    }
}
