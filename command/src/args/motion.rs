//! The arguments of what the exact motion answers.

use super::{
    AnswerArgs, BodyArgs, LookArgs, MachineArgs, OutputArgs, StartArgs, SurfaceArgs, SweepFormat, UnitArgs,
};
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip steady --omega 0.4 --alpha 6
  stickslip steady --omega 0.4 --alpha 6 --enclose
  stickslip steady --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --force 6 --format json
  stickslip steady --omega 0.5 --alpha 4 --x0 3 --v0 0.2
  stickslip steady --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3
  stickslip steady --points points.csv --format csv")]
pub(crate) struct SteadyArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) start: StartArgs,
    /// Maximum number of periods to follow the motion in search of a limit
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value_t = stickslip::motion::DEFAULT_BUDGET)]
    pub(crate) max_periods: u32,
    /// Guaranteed digits, and a proof that the motion exists: for --omega, --alpha and --damping-ratio
    /// exactly as typed, from rest (needs a build with the feature mp)
    #[arg(long, conflicts_with_all = ["x0", "v0", "max_periods"])]
    pub(crate) enclose: bool,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// How a motion is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum StreamFormat {
    Text,
    Jsonl,
    Csv,
    Parquet,
}

/// The drive over the time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ShapeArg {
    Sine,
    Step,
    Ramp,
    Pull,
    Free,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Under a step, a ramp, a pull or no drive the motion needs no frequency, and the body no spring. Its displacements are from
the unstretched spring.

Examples:
  stickslip simulate --omega 0.4 --alpha 6 --cycles 2
  stickslip simulate --omega 0.4 --alpha 6 --cycles 2 --samples 200 --format csv > motion.csv
  stickslip simulate --omega 1.5 --alpha 2.5 --cycles 100 --x0 4 --v0 -1 --format jsonl
  stickslip simulate --mass 2kg --stiffness 800N/m --friction 4N --force 12N --frequency 2Hz --phase 90deg --duration 1s
  stickslip simulate --mass 2kg --stiffness 800N/m --friction 4N --static-friction 5N --force 12N --shape step --duration 2s
  stickslip simulate --mass 2kg --no-spring --friction 4N --force 12N --shape ramp --rise 0.5s --duration 2s
  stickslip simulate --mass 2kg --stiffness 450N/m --friction 3N --static-friction 4N --shape pull --speed 20mm/s --duration 2s
  stickslip simulate --no-spring --friction-coefficient 0.3 --v0 2m/s --shape free --duration 1s")]
pub(crate) struct SimulateArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) start: StartArgs,
    /// The drive over the time: sine, step (its amplitude from the start on), ramp (it grows to its amplitude in the time
    /// --rise, and stays), pull (the spring's end moves at --speed) or free (none) [default: sine]
    #[arg(long, value_enum, value_name = "SHAPE", hide_possible_values = true)]
    pub(crate) shape: Option<ShapeArg>,
    /// Time in which a ramp grows to its amplitude
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub(crate) rise: Option<String>,
    /// Speed of the spring's end in a pull
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) speed: Option<String>,
    #[command(flatten)]
    pub(crate) surface: SurfaceArgs,
    /// Phase of the drive at the start, such as 90deg for a drive with the cosine of the time [default: 0]
    #[arg(long, value_name = "θ", allow_hyphen_values = true)]
    pub(crate) phase: Option<String>,
    /// Cycles of the drive to follow
    #[arg(long, value_name = "N", allow_hyphen_values = true, required_unless_present_any = ["duration", "shape"])]
    pub(crate) cycles: Option<String>,
    /// Time to follow, such as 2s, in place of the cycles
    #[arg(long, value_name = "T", allow_hyphen_values = true, conflicts_with = "cycles")]
    pub(crate) duration: Option<String>,
    /// Evenly spaced samples per cycle, instead of segments
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(crate) samples: Option<String>,
    /// Sampling rate, such as 1kHz, in place of the samples per cycle
    #[arg(long, value_name = "F", allow_hyphen_values = true, conflicts_with = "samples")]
    pub(crate) rate: Option<String>,
    /// Output file, FILE.csv, FILE.jsonl or FILE.parquet [default: standard output]
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Replace FILE if it exists
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
    /// text, jsonl, csv or parquet (needs a build with the feature parquet) [default: by the end of FILE's
    /// name, or text]
    #[arg(long, value_enum, hide_possible_values = true)]
    pub(crate) format: Option<StreamFormat>,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = super::bits)]
    pub(crate) bits: Option<u32>,
    #[command(flatten)]
    pub(crate) units: UnitArgs,
}

impl SimulateArgs {
    /// The format of `--format`, or that of the end of the file's name; text without a file.
    pub(crate) fn format(&self) -> Result<StreamFormat, Failure> {
        match (self.format, &self.out) {
            (Some(format), _) => Ok(format),
            (None, None) => Ok(StreamFormat::Text),
            (None, Some(file)) => Ok(match SweepFormat::of(file)? {
                SweepFormat::Jsonl => StreamFormat::Jsonl,
                SweepFormat::Csv => StreamFormat::Csv,
                SweepFormat::Parquet => StreamFormat::Parquet,
            }),
        }
    }
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip decay --x0 12 --v0 6
  stickslip decay --mass 2 --stiffness 800 --friction 4 --x0 0.3 --v0 0 --format json
  stickslip decay --mass 800kg --period 2.2s --friction-coefficient 0.06 --static-friction 600N --x0 200mm
  stickslip decay --no-spring --friction-coefficient 0.3 --v0 2m/s
  stickslip decay --no-spring --friction-coefficient 0.3 --slope 5deg --v0 2m/s")]
pub(crate) struct DecayArgs {
    #[command(flatten)]
    pub(crate) machine: BodyArgs,
    #[command(flatten)]
    pub(crate) surface: SurfaceArgs,
    /// Displacement at the start: in units of B = r_y/k, or of length where there is a machine. It counts from the mean
    /// displacement, and on a slope, one way and without friction from the relaxed spring [default: 0]
    #[arg(long, value_name = "X", allow_hyphen_values = true, required_unless_present_any = ["v0", "no_spring"])]
    pub(crate) x0: Option<String>,
    /// Velocity at the start: in units of B ω_n, or of length per time [default: 0]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) v0: Option<String>,
    /// The motion as a picture in FILE.svg, FILE.png or FILE.pdf, its turning points in FILE.csv
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: LookArgs,
    /// Replace a file that exists
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
    #[command(flatten)]
    pub(crate) answer: AnswerArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "\
A spring pulls the body over the surface, its end at a constant speed, or the body stands on a belt of that speed. The
body sticks until the spring overcomes static friction, slips, and sticks again, or it slides smoothly.

Examples:
  stickslip pull --mass 2kg --stiffness 450N/m --friction 3N --static-friction-ratio 1.3 --speed 20mm/s
  stickslip pull --mass 2kg --stiffness 450N/m --damping-ratio 2% --friction 3N --static-friction 4N --speed 20mm/s --format json")]
pub(crate) struct PullArgs {
    #[command(flatten)]
    pub(crate) machine: BodyArgs,
    /// Speed of the spring's end, or of the belt
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) speed: String,
    #[command(flatten)]
    pub(crate) answer: AnswerArgs,
}
