//! What can be typed.

mod pictures;

use clap::{Args, Parser, Subcommand, ValueEnum};
use pictures::{FIGURE_EXAMPLES, FIGURES_EXAMPLES, MAP_EXAMPLES, SWEEP_EXAMPLES};
pub(crate) use pictures::{FigureArgs, FiguresArgs, MapArgs, SweepArgs, Swept};
use std::path::PathBuf;

/// The harmonically forced Coulomb-friction oscillator m x″ + k x + r_y sgn(x′) = p₀ sin ω_d t.
#[derive(Debug, Parser)]
#[command(name = "stickslip", version, arg_required_else_help = true)]
pub(crate) struct CommandLine {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Does it stick, how far and how fast does it move, how much force keeps it from sticking?
    #[command(after_help = RESPONSE_EXAMPLES)]
    Response(ResponseArgs),
    /// The least force that keeps it from sticking at a frequency.
    #[command(after_help = BORDER_EXAMPLES)]
    Border(BorderArgs),
    /// The exact motion in the long run, stops included.
    #[command(after_help = STEADY_EXAMPLES)]
    Steady(SteadyArgs),
    /// The exact motion from a start, phase by phase or sampled.
    #[command(after_help = SIMULATE_EXAMPLES)]
    Simulate(SimulateArgs),
    /// The questions asked backwards: from what the machine is to do, to what it takes.
    #[command(subcommand, after_help = DESIGN_EXAMPLES)]
    Design(Question),
    /// Free vibration from a start: how many half cycles, and where it comes to rest.
    #[command(after_help = DECAY_EXAMPLES)]
    Decay(DecayArgs),
    /// Hold every equation of the paper against computed cycles, at any precision; exit status 1 if one fails.
    #[command(after_help = VERIFY_EXAMPLES)]
    Verify(VerifyArgs),
    /// A figure of the paper, or one of ours, from this library's results.
    #[command(after_help = FIGURE_EXAMPLES)]
    Figure(FigureArgs),
    /// All figures at once.
    #[command(after_help = FIGURES_EXAMPLES)]
    Figures(FiguresArgs),
    /// Answers over a grid of Ω and α, in parallel, in order, resumable.
    #[command(after_help = SWEEP_EXAMPLES)]
    Sweep(SweepArgs),
    /// The plane of Ω and α by regime, margin, stops or any output, as CSV or a picture.
    #[command(after_help = MAP_EXAMPLES)]
    Map(MapArgs),
}

const STEADY_EXAMPLES: &str = "\
Examples:
  stickslip steady --omega 0.4 --alpha 6
  stickslip steady --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --force 6 --format json
  stickslip steady --omega 0.5 --alpha 4 --x0 3 --v0 0.2
  stickslip steady --points points.csv --format csv";

const SIMULATE_EXAMPLES: &str = "\
Examples:
  stickslip simulate --omega 0.4 --alpha 6 --cycles 2
  stickslip simulate --omega 0.4 --alpha 6 --cycles 2 --samples 200 --format csv > motion.csv
  stickslip simulate --omega 1.5 --alpha 2.5 --cycles 100 --x0 4 --v0 -1 --format jsonl";

const DESIGN_EXAMPLES: &str = "\
Examples:
  stickslip design force --mass 50 --stiffness 1000 --friction 5 --frequency 6
  stickslip design friction --mass 50 --stiffness 1000 --frequency 6 --force 12
  stickslip design bands --alpha 12 --from 0.1 --to 2
  stickslip design displacement --omega 1.5 --target 2
  stickslip design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12 --units kN,m
  stickslip design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500";

/// What is asked, in ratios or in physical units.
#[derive(Debug, Subcommand)]
pub(crate) enum Question {
    /// The least force, or base motion, that keeps it from sticking
    Force(QuestionArgs),
    /// The greatest friction with which a force keeps it from sticking
    Friction(QuestionArgs),
    /// The frequencies, between --from and --to, at which it never sticks
    Bands(QuestionArgs),
    /// The force for the maximum displacement --target
    Displacement(QuestionArgs),
    /// The force for the maximum velocity --target
    Velocity(QuestionArgs),
    /// The friction that dissipates most, without sticking or, with --sticking, of all
    Dissipation(QuestionArgs),
    /// The stiffness, between --from and --to, that dissipates most without sticking
    Stiffness(QuestionArgs),
}

#[derive(Debug, Args)]
pub(crate) struct QuestionArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    /// Lower end of a range: of Ω or, in physical units, of what is asked for
    #[arg(long, value_name = "LOW", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Upper end of a range
    #[arg(long, value_name = "HIGH", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
    /// Of dissipation: sticking allowed, to a proven tolerance of 1e-6
    #[arg(long)]
    pub(crate) sticking: bool,
    /// What is to be reached: in units of B or B ω_d, or of length or length per time
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) target: Option<String>,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
    /// Names of the units of force and length in the text answer
    #[arg(long, value_name = "FORCE,LENGTH", default_value = "N,m", value_parser = UnitNames::parse)]
    pub(crate) units: UnitNames,
}

const DECAY_EXAMPLES: &str = "\
Examples:
  stickslip decay --x0 12 --v0 6
  stickslip decay --mass 2 --stiffness 800 --friction 4 --x0 0.3 --v0 0 --format json";

const VERIFY_EXAMPLES: &str = "\
Examples:
  stickslip verify
  stickslip verify --bits 1024
  stickslip verify --bits 256 --format json";

const RESPONSE_EXAMPLES: &str = "\
Examples:
  stickslip response --omega 1.5 --alpha 2.5
  stickslip response --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --force 12.5 --units kN,m
  stickslip response --mass 50 --friction 5 --frequency 6.2832 --omega 1.5 --alpha 2.5 --format json
  stickslip response --points points.csv --format csv";

const BORDER_EXAMPLES: &str = "\
Examples:
  stickslip border --omega 0.4
  stickslip border --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --format json
  stickslip border --points - --format csv < frequencies.csv";

#[derive(Debug, Args)]
pub(crate) struct ResponseArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(crate) struct BorderArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(crate) struct SteadyArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    #[command(flatten)]
    pub(crate) start: StartArgs,
    /// Periods of the drive to follow the motion for before giving up on a limit
    #[arg(long, value_name = "N", default_value_t = stickslip::exact::DEFAULT_BUDGET)]
    pub(crate) max_periods: u32,
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    #[command(flatten)]
    pub(crate) force: ForceArgs,
    #[command(flatten)]
    pub(crate) start: StartArgs,
    /// Cycles of the drive to follow
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(crate) cycles: String,
    /// Samples in a cycle, evenly spaced, in place of the phases
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(crate) samples: Option<String>,
    /// text, jsonl or csv
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
}

#[derive(Debug, Args)]
pub(crate) struct DecayArgs {
    /// Mass m
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,
    /// Stiffness k
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub(crate) stiffness: Option<String>,
    /// Friction bound r_y
    #[arg(long, value_name = "RY", allow_hyphen_values = true)]
    pub(crate) friction: Option<String>,
    /// Displacement at the start: in units of B = r_y/k, or of length where there is a machine
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) x0: String,
    /// Velocity at the start: in units of B ω_n, or of length per time
    #[arg(long, value_name = "V", allow_hyphen_values = true, default_value = "0")]
    pub(crate) v0: String,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
    /// Names of the units of force and length in the text answer
    #[arg(long, value_name = "FORCE,LENGTH", default_value = "N,m", value_parser = UnitNames::parse)]
    pub(crate) units: UnitNames,
}

/// Where the motion starts, at ω_d t = 0.
#[derive(Debug, Args)]
pub(crate) struct StartArgs {
    /// Displacement at the start: in units of B = r_y/k, or of length where there is a machine [default: 0]
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub(crate) x0: Option<String>,
    /// Velocity at the start: in units of B ω_d, or of length per time [default: 0]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) v0: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct VerifyArgs {
    /// Bits of precision (needs a build with the feature mp) [default: 53, f64]
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
    /// text or json
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    pub(crate) format: Format,
}

/// The oscillator and its frequency. In physical units, any consistent system.
#[derive(Debug, Args)]
pub(crate) struct MachineArgs {
    /// Frequency ratio Ω = ω_d/ω_n
    #[arg(long, value_name = "Ω", allow_hyphen_values = true)]
    pub(crate) omega: Option<String>,
    /// Mass m
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,
    /// Stiffness k; or give --omega, and k = m (ω_d/Ω)²
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub(crate) stiffness: Option<String>,
    /// Friction bound r_y
    #[arg(long, value_name = "RY", allow_hyphen_values = true)]
    pub(crate) friction: Option<String>,
    /// Angular frequency ω_d of the drive, in rad per unit of time
    #[arg(long, value_name = "WD", allow_hyphen_values = true)]
    pub(crate) frequency: Option<String>,
}

/// How hard it is shaken.
#[derive(Debug, Args)]
pub(crate) struct ForceArgs {
    /// Force ratio α = p₀/r_y
    #[arg(long, value_name = "α", allow_hyphen_values = true)]
    pub(crate) alpha: Option<String>,
    /// Force amplitude p₀
    #[arg(long, value_name = "P0", allow_hyphen_values = true)]
    pub(crate) force: Option<String>,
    /// Amplitude u_g0 of the base motion; p₀ = k u_g0
    #[arg(long, value_name = "UG", allow_hyphen_values = true)]
    pub(crate) base_motion: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct OutputArgs {
    /// CSV of ratios with a header (columns omega, and alpha for a response), answered row by row; - is
    /// standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<PathBuf>,
    /// text or json for one answer [default: text]; jsonl or csv for --points [default: jsonl]
    #[arg(long, value_enum)]
    pub(crate) format: Option<Format>,
    /// Bits of precision (needs a build with the feature mp)
    #[arg(long, value_name = "N")]
    pub(crate) bits: Option<u32>,
    /// Names of the units of force and length in the text answer
    #[arg(long, value_name = "FORCE,LENGTH", default_value = "N,m", value_parser = UnitNames::parse)]
    pub(crate) units: UnitNames,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
    Jsonl,
    Csv,
}

/// Names of the units of force and length, for the text answer.
#[derive(Debug, Clone)]
pub(crate) struct UnitNames {
    pub(crate) force: String,
    pub(crate) length: String,
}

impl UnitNames {
    fn parse(text: &str) -> Result<Self, String> {
        match text.split_once(',') {
            Some((force, length)) if !force.is_empty() && !length.is_empty() => {
                Ok(Self { force: force.to_owned(), length: length.to_owned() })
            }
            Some(_) | None => Err("two names with a comma between are due, such as kN,m".to_owned()),
        }
    }
}
